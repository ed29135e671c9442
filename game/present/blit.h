// present/blit.h - one OpenGL texture drawn over a rectangle of the framebuffer.
#pragma once

#include "base/image.h"

#include <glm/vec2.hpp>

namespace gh::present {

class Blit {
  public:
    // The current thread's OpenGL 3.3 context must be current for all three.
    bool create();  // false when the shaders do not compile or link
    void destroy();
    void upload(const Image8& picture);
    void draw(glm::ivec2 offset_px, glm::ivec2 size_px) const;

  private:
    unsigned program_ = 0;
    unsigned vertex_array_ = 0;
    unsigned texture_ = 0;
    int width_ = 0;
    int height_ = 0;
};

}  // namespace gh::present
