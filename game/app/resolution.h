// app/resolution.h - trades pixels for time, so that the frame rate a player chose is held.
//
// Same bits a pure function of the frame times it is given; the simulation never sees any of it.
#pragma once

#include <glm/vec2.hpp>

namespace gh::app {

class Resolution {
  public:
    // The picture has at least and at most so many pixels, where the window has them.
    void bound(float fewest_pixels, float most_pixels);

    // Tells how long the last picture took; the size moves by at most a quarter at a time, and only when the time is
    // off by more than a tenth, so that the picture does not breathe.
    void note_frame(float render_ms, float wanted_ms);

    // The size to render for a framebuffer of this size: its shape, at most its size, and at least as many pixels as
    // bound() says (240 x 135 unless it was called), or all of a smaller window. Both sides are multiples of 8 unless it is the whole framebuffer.
    // {0, 0} for one without area.
    [[nodiscard]] glm::ivec2 size_for(glm::ivec2 framebuffer) const;

    // The size to add such pictures up to: twice each side, at most the framebuffer.
    [[nodiscard]] static glm::ivec2 shown_size(glm::ivec2 rendered, glm::ivec2 framebuffer);

    [[nodiscard]] float pixels() const { return pixels_; }

  private:
    float pixels_ =
        320.0f * 180.0f;  // to begin with: a slow machine answers at once, a fast one grows within a second
    float smoothed_ms_ = 0.0f;
    float fewest_pixels_ = 240.0f * 135.0f;  // with fewer a room can not be read
    float most_pixels_ = 3840.0f * 2160.0f;
};

}  // namespace gh::app
