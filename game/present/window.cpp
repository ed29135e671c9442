#include "present/window.h"

#include <algorithm>
#include <cmath>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#define GL_GLEXT_PROTOTYPES
#include "present/blit.h"
#include "present/fonts.h"
#include "present/theme.h"

#include <GL/glcorearb.h>
#include <imgui.h>
#include <imgui_impl_glfw.h>
#include <imgui_impl_opengl3.h>

namespace gh::present {

struct Window::Data {
    GLFWwindow* window = nullptr;
    Blit blit;
    bool has_ui = false;
    bool is_captured = false;
    glm::ivec2 windowed_place{80, 80};
    glm::ivec2 windowed_size{1280, 720};
    glm::ivec2 last_size{0};     // of the framebuffer, a frame ago
    float letters_scale = 0.0f;  // that the fonts were made for; 0: none are
    glm::vec2 picture_offset{0.0f};
    glm::vec2 picture_size{1.0f};

    Data() = default;
    Data(const Data&) = delete;
    Data& operator=(const Data&) = delete;
    ~Data() {
        if (window != nullptr) {
            if (has_ui) {
                ImGui_ImplOpenGL3_Shutdown();
                ImGui_ImplGlfw_Shutdown();
                ImGui::DestroyContext();
            }
            blit.destroy();
            glfwDestroyWindow(window);
        }
        glfwTerminate();
    }
};

namespace {

std::string last_glfw_reason() {
    const char* reason = nullptr;
    glfwGetError(&reason);
    return reason != nullptr ? reason : "no reason given";
}

GLFWwindow* create_window(const WindowOptions& options) {
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
    glfwWindowHint(GLFW_AUTO_ICONIFY, GLFW_FALSE);
    GLFWmonitor* monitor = options.is_fullscreen ? glfwGetPrimaryMonitor() : nullptr;
    int width = options.width;
    int height = options.height;
    if (monitor != nullptr) {
        const GLFWvidmode* mode = glfwGetVideoMode(monitor);
        width = mode->width;
        height = mode->height;
    }
    return glfwCreateWindow(width, height, options.title.c_str(), monitor, nullptr);
}

}  // namespace

Window::Window(std::unique_ptr<Data> data) : data_(std::move(data)) {}
Window::Window(Window&&) noexcept = default;
Window::~Window() = default;

Result<Window> Window::open(const WindowOptions& options) {
    if (glfwInit() == GLFW_FALSE) return Error{"window: cannot be opened: " + last_glfw_reason()};
    auto data = std::make_unique<Data>();
    data->window = create_window(options);
    if (data->window == nullptr)
        return Error{"window: OpenGL 3.3 is not to be had here: " + last_glfw_reason()};

    glfwMakeContextCurrent(data->window);
    glfwSwapInterval(1);
    glfwSetInputMode(data->window, GLFW_STICKY_KEYS, GLFW_TRUE);  // a tap between two ticks still counts
    glfwSetInputMode(data->window, GLFW_STICKY_MOUSE_BUTTONS, GLFW_TRUE);
    if (!data->blit.create()) return Error{"window: the OpenGL driver refused the blit shader"};

    ImGui::CreateContext();
    data->has_ui = true;
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;
    io.KeyRepeatDelay = 0.8f;  // a press that lasts a few slow frames is still one press
    io.ConfigFlags |= ImGuiConfigFlags_NavEnableKeyboard;
    ImGui_ImplGlfw_InitForOpenGL(data->window, true);
    ImGui_ImplOpenGL3_Init("#version 330 core");
    return Window(std::move(data));
}

void Window::poll_events() {
    glfwPollEvents();
    if (data_->is_captured && !has_focus()) capture_cursor(false);
}

bool Window::wants_to_close() const {
    return glfwWindowShouldClose(data_->window) != 0;
}
void Window::keep_open() {
    glfwSetWindowShouldClose(data_->window, GLFW_FALSE);
}
bool Window::has_focus() const {
    return glfwGetWindowAttrib(data_->window, GLFW_FOCUSED) != 0;
}
GLFWwindow* Window::device() const {
    return data_->window;
}
bool Window::is_cursor_captured() const {
    return data_->is_captured;
}
glm::vec2 Window::picture_offset() const {
    return data_->picture_offset;
}
glm::vec2 Window::picture_size() const {
    return data_->picture_size;
}

glm::ivec2 Window::framebuffer_size() const {
    int width = 0;
    int height = 0;
    glfwGetFramebufferSize(data_->window, &width, &height);
    return {width, height};
}

void Window::capture_cursor(bool is_captured) {
    data_->is_captured = is_captured;
    glfwSetInputMode(data_->window, GLFW_CURSOR, is_captured ? GLFW_CURSOR_DISABLED : GLFW_CURSOR_NORMAL);
    if (is_captured && glfwRawMouseMotionSupported() != 0) {
        glfwSetInputMode(data_->window, GLFW_RAW_MOUSE_MOTION, GLFW_TRUE);
    }
    ImGuiIO& io = ImGui::GetIO();
    if (is_captured) {
        io.ConfigFlags |= ImGuiConfigFlags_NoMouse;
    } else {
        io.ConfigFlags &= ~ImGuiConfigFlags_NoMouse;
    }
}

void Window::toggle_fullscreen() {
    Data& d = *data_;
    if (glfwGetWindowMonitor(d.window) != nullptr) {
        glfwSetWindowMonitor(d.window, nullptr, d.windowed_place.x, d.windowed_place.y, d.windowed_size.x,
                             d.windowed_size.y, GLFW_DONT_CARE);
        return;
    }
    GLFWmonitor* monitor = glfwGetPrimaryMonitor();
    const GLFWvidmode* mode = monitor != nullptr ? glfwGetVideoMode(monitor) : nullptr;
    if (mode == nullptr) return;
    glfwGetWindowPos(d.window, &d.windowed_place.x, &d.windowed_place.y);
    glfwGetWindowSize(d.window, &d.windowed_size.x, &d.windowed_size.y);
    glfwSetWindowMonitor(d.window, monitor, 0, 0, mode->width, mode->height, mode->refreshRate);
}

void Window::begin_frame(const Image8& picture) {
    const glm::ivec2 size = framebuffer_size();
    glViewport(0, 0, size.x, size.y);
    glClearColor(0.0f, 0.0f, 0.0f, 1.0f);
    glClear(GL_COLOR_BUFFER_BIT);
    if (size.x > 0 && size.y > 0 && picture.width > 0 && picture.height > 0) {
        const float scale = std::min(static_cast<float>(size.x) / static_cast<float>(picture.width),
                                     static_cast<float>(size.y) / static_cast<float>(picture.height));
        const glm::ivec2 shown(static_cast<int>(std::lround(static_cast<float>(picture.width) * scale)),
                               static_cast<int>(std::lround(static_cast<float>(picture.height) * scale)));
        const glm::ivec2 offset = (size - shown) / 2;
        data_->picture_offset = glm::vec2(offset);
        data_->picture_size = glm::vec2(shown);
        data_->blit.upload(picture);
        data_->blit.draw(offset, shown);
    }
    fit_letters();
    ImGui_ImplOpenGL3_NewFrame();
    ImGui_ImplGlfw_NewFrame();
    // Enter chooses like Space does; it is ImGui's key for typing numbers into sliders, which ours do not take.
    ImGuiIO& io = ImGui::GetIO();
    if (glfwGetKey(data_->window, GLFW_KEY_ENTER) == GLFW_PRESS ||
        glfwGetKey(data_->window, GLFW_KEY_KP_ENTER) == GLFW_PRESS)
        io.NavInputs[ImGuiNavInput_Activate] = 1.0f;
    ImGui::NewFrame();
}

// Letters are drawn for the size they have on the screen: stretched ones are blurred. Not while a window is being
// dragged larger, when every frame has another size.
void Window::fit_letters() {
    Data& d = *data_;
    const glm::ivec2 pixels = framebuffer_size();
    int width = 0;
    int height = 0;
    glfwGetWindowSize(d.window, &width, &height);
    const bool is_settled = pixels == d.last_size;
    d.last_size = pixels;
    if (pixels.x <= 0 || pixels.y <= 0 || width <= 0 || height <= 0) return;
    const float scale = ui_scale(static_cast<float>(pixels.x), static_cast<float>(pixels.y));
    const float pixels_a_unit = static_cast<float>(pixels.y) / static_cast<float>(height);
    if (d.letters_scale <= 0.0f || (is_settled && std::abs(scale - d.letters_scale) > 0.01f)) {
        apply_theme(load_fonts(scale), scale / pixels_a_unit);
        ImGui_ImplOpenGL3_DestroyFontsTexture();
        ImGui_ImplOpenGL3_CreateFontsTexture();
        d.letters_scale = scale;
    }
    ImGui::GetIO().FontGlobalScale = scale / d.letters_scale / pixels_a_unit;
}

void Window::end_frame() {
    ImGui::Render();
    const glm::ivec2 size = framebuffer_size();
    if (size.x > 0 && size.y > 0) ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
    glfwSwapBuffers(data_->window);
}

}  // namespace gh::present
