#include "present/blit.h"

#define GL_GLEXT_PROTOTYPES
#include <GL/glcorearb.h>

namespace gh::present {

namespace {

// Two triangles from nothing but the vertex number; rows run top to bottom, so v is turned over here.
constexpr const char* kVertexSource = R"(#version 330 core
out vec2 uv;
void main() {
    vec2 corner = vec2(float(gl_VertexID & 1), float(gl_VertexID >> 1));
    uv = vec2(corner.x, 1.0 - corner.y);
    gl_Position = vec4(corner * 2.0 - 1.0, 0.0, 1.0);
})";

// The bytes are already sRGB-encoded: they pass through as they are, stretched by Catmull and Rom's cubic, which keeps
// edges where bilinear blurs them. Of its 16 texels the four at the corners count least and are left out; the hardware
// mixes the two in the middle of each axis (Jimenez 2016, "Filmic SMAA").
constexpr const char* kFragmentSource = R"(#version 330 core
in vec2 uv;
out vec4 colour;
uniform sampler2D picture;
void main() {
    vec2 size = vec2(textureSize(picture, 0));
    vec2 at = uv * size - 0.5;
    vec2 t = fract(at);
    vec2 w0 = t * (t * (1.0 - 0.5 * t) - 0.5);
    vec2 w1 = 1.0 + t * t * (1.5 * t - 2.5);
    vec2 w2 = t * (t * (2.0 - 1.5 * t) + 0.5);
    vec2 w3 = t * t * (0.5 * t - 0.5);
    vec2 w12 = w1 + w2;
    vec2 first = (floor(at) + 0.5) / size;
    vec2 before = first - 1.0 / size, middle = first + w2 / (w12 * size), after = first + 2.0 / size;
    vec4 sum = vec4(texture(picture, middle).rgb, 1.0) * (w12.x * w12.y);
    sum += vec4(texture(picture, vec2(before.x, middle.y)).rgb, 1.0) * (w0.x * w12.y);
    sum += vec4(texture(picture, vec2(after.x, middle.y)).rgb, 1.0) * (w3.x * w12.y);
    sum += vec4(texture(picture, vec2(middle.x, before.y)).rgb, 1.0) * (w12.x * w0.y);
    sum += vec4(texture(picture, vec2(middle.x, after.y)).rgb, 1.0) * (w12.x * w3.y);
    colour = vec4(sum.rgb / sum.a, 1.0);
})";

GLuint compile(GLenum kind, const char* source) {
    const GLuint shader = glCreateShader(kind);
    glShaderSource(shader, 1, &source, nullptr);
    glCompileShader(shader);
    GLint is_compiled = 0;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &is_compiled);
    if (is_compiled != 0) return shader;
    glDeleteShader(shader);
    return 0;
}

}  // namespace

bool Blit::create() {
    const GLuint vertex = compile(GL_VERTEX_SHADER, kVertexSource);
    const GLuint fragment = compile(GL_FRAGMENT_SHADER, kFragmentSource);
    if (vertex == 0 || fragment == 0) return false;
    program_ = glCreateProgram();
    glAttachShader(program_, vertex);
    glAttachShader(program_, fragment);
    glLinkProgram(program_);
    glDeleteShader(vertex);
    glDeleteShader(fragment);
    GLint is_linked = 0;
    glGetProgramiv(program_, GL_LINK_STATUS, &is_linked);
    if (is_linked == 0) return false;

    glGenVertexArrays(1, &vertex_array_);
    glGenTextures(1, &texture_);
    glBindTexture(GL_TEXTURE_2D, texture_);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    return true;
}

void Blit::destroy() {
    if (texture_ != 0) glDeleteTextures(1, &texture_);
    if (vertex_array_ != 0) glDeleteVertexArrays(1, &vertex_array_);
    if (program_ != 0) glDeleteProgram(program_);
    texture_ = vertex_array_ = program_ = 0;
}

void Blit::upload(const Image8& picture) {
    if (picture.width <= 0 || picture.height <= 0) return;
    const auto format = static_cast<GLenum>(picture.channels == 4 ? GL_RGBA : GL_RGB);
    glBindTexture(GL_TEXTURE_2D, texture_);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    if (picture.width != width_ || picture.height != height_) {
        width_ = picture.width;
        height_ = picture.height;
        glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, width_, height_, 0, format, GL_UNSIGNED_BYTE,
                     picture.bytes.data());
    } else {
        glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, width_, height_, format, GL_UNSIGNED_BYTE,
                        picture.bytes.data());
    }
}

void Blit::draw(glm::ivec2 offset_px, glm::ivec2 size_px) const {
    if (width_ == 0) return;
    glViewport(offset_px.x, offset_px.y, size_px.x, size_px.y);
    glDisable(GL_BLEND);
    glDisable(GL_DEPTH_TEST);
    glUseProgram(program_);
    glBindVertexArray(vertex_array_);
    glBindTexture(GL_TEXTURE_2D, texture_);
    glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
}

}  // namespace gh::present
