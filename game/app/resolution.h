// app/resolution.h - trades pixels for time, so that the frame rate a player chose is held.
//
// What is seen is traced in every pixel of the picture, light in one of every `step` x `step` (filter/temporal_upscale.h).
// A slow machine lights every sixteenth and shows a smaller picture; one that shows all of the window's pixels lights more
// of them, as far as it can. A picture much smaller than the window is added up over the frames in one of twice its sides.
//
// Same bits a pure function of the frame times it is given; the simulation never sees any of it.
#pragma once

#include <glm/vec2.hpp>

namespace gh::app {

inline constexpr int kMostStep = 4;

struct PictureShape {
    glm::ivec2 lit{0};  // size of what light is worked out in
    int step = 1;          // 1 to kMostStep
    bool doubles = false;  // pictures are added up in one of twice their sides (filter/temporal_upscale.h)
    [[nodiscard]] glm::ivec2 shown() const { return lit * step; }
    [[nodiscard]] glm::ivec2 made() const { return doubles ? 2 * shown() : shown(); }
    [[nodiscard]] bool operator==(const PictureShape&) const = default;
};

class Resolution {
  public:
    // At least so many pixels are shown, where the window has them; light is worked out in at most so many, and in one of
    // most_step x most_step or more.
    void bound(float fewest_shown, float most_lit, int most_step = kMostStep);

    // Tells how long the last picture for a framebuffer of this size took; the number of lit pixels moves by at most a
    // quarter at a time, and only when the time is off by more than a tenth, so that the picture does not breathe. From
    // every sixteenth to every ninth, fourth, and to all it goes once there is time for that.
    void note_frame(float render_ms, float wanted_ms, glm::ivec2 framebuffer);

    // What to render for a framebuffer of this size: its shape, and nowhere more than a pixel larger. Less than the whole
    // is a multiple of 8 lit pixels wide, and as high as the window's proportions make it. {0, 0} for one without area.
    [[nodiscard]] PictureShape shape_for(glm::ivec2 framebuffer) const;

    [[nodiscard]] float pixels() const { return pixels_; }

  private:
    int most_step_ = kMostStep;
    float fewest_pixels_ = 120.0f * 67.5f;  // lit, as are all of these
    float most_pixels_ = 3840.0f * 2160.0f;
    float pixels_ =
        fewest_pixels_;  // to begin with: a slow machine answers at once, a fast one grows within a second
    float smoothed_ms_ = 0.0f;
};

}  // namespace gh::app
