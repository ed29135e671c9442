// present/window.h - the one window: shows a finished picture, lets the menus draw over it, hands out the device.
//
// Threads   everything here belongs to the thread that called open().
// Bad input no display, no OpenGL 3.3: one sentence. A 0x0 (minimised) window shows nothing and is not an error.
#pragma once

#include "base/image.h"
#include "base/result.h"

#include <glm/vec2.hpp>

#include <memory>
#include <string>

struct GLFWwindow;

namespace gh::present {

struct WindowOptions {
    std::string title = "Glasshouse";
    int width = 1280;  // of the window, in screen units
    int height = 720;
    bool is_fullscreen = false;
};

class Window {
  public:
    [[nodiscard]] static Result<Window> open(const WindowOptions& options);
    Window(Window&&) noexcept;
    Window& operator=(Window&&) = delete;
    ~Window();

    void poll_events();  // also frees the cursor when the window has lost the focus
    [[nodiscard]] bool wants_to_close() const;
    void keep_open();          // takes back a request to close
    void toggle_fullscreen();  // back to the size and place it had
    [[nodiscard]] bool has_focus() const;
    [[nodiscard]] glm::ivec2 framebuffer_size() const;  // pixels, not the window's size; may be 0x0

    // While captured the pointer is hidden and turns the head; poll_events frees it on loss of focus.
    void capture_cursor(bool is_captured);
    [[nodiscard]] bool is_cursor_captured() const;

    // One frame: picture stretched over the framebuffer (aspect kept, black bars), then the UI, then swap.
    void begin_frame(const Image8& picture);  // ImGui may draw from here ...
    void end_frame();                         // ... to here

    // Where the picture lies in the framebuffer, pixels: offset and size. For HUD marks on things in the world.
    [[nodiscard]] glm::vec2 picture_offset() const;
    [[nodiscard]] glm::vec2 picture_size() const;

    [[nodiscard]] GLFWwindow* device() const;

  private:
    void fit_letters();
    struct Data;
    explicit Window(std::unique_ptr<Data> data);
    std::unique_ptr<Data> data_;
};

}  // namespace gh::present
