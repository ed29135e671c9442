#include "app/resolution.h"

#include "base/contracts.h"

#include <algorithm>
#include <cmath>

namespace gh::app {

namespace {

constexpr float kNarrowest = 288.0f;  // pixels across
constexpr float kMuchSmaller = 1.4f;  // sides of the window to those of such a picture
constexpr float kSurely = 1.05f;      // so much time as for a little more than all of them

int multiple_of_8(float length) {
    return std::max(8, static_cast<int>(std::lround(length / 8.0f)) * 8);
}

float area(glm::ivec2 size) {
    return static_cast<float>(size.x) * static_cast<float>(size.y);
}

// Lit pixels when the whole framebuffer is shown and one in every step x step is lit.
float lit_of(float framebuffer, int step) {
    return framebuffer / static_cast<float>(step * step);
}

// The smallest step for which so many pixels are enough to show the whole framebuffer; 0: there is none.
int step_for(float pixels, float framebuffer, int most) {
    for (int step = 1; step <= most; ++step) {
        if (pixels >= lit_of(framebuffer, step) * 0.999f) return step;
    }
    return 0;
}

}  // namespace

void Resolution::bound(float fewest_shown, float most_lit, int most_step) {
    EXPECTS(1 <= most_step && most_step <= kMostStep && 0.0f < fewest_shown &&
            lit_of(fewest_shown, most_step) <= most_lit);
    most_step_ = most_step;
    fewest_pixels_ = lit_of(fewest_shown, most_step);
    most_pixels_ = most_lit;
    pixels_ = std::clamp(pixels_, fewest_pixels_, most_pixels_);
}

void Resolution::note_frame(float render_ms, float wanted_ms, glm::ivec2 framebuffer) {
    if (!(render_ms > 0.0f) || !(wanted_ms > 0.0f) || !(area(framebuffer) > 0.0f)) return;
    smoothed_ms_ = smoothed_ms_ == 0.0f ? render_ms : smoothed_ms_ + 0.3f * (render_ms - smoothed_ms_);
    const float ratio = wanted_ms / smoothed_ms_;
    if (std::abs(ratio - 1.0f) < 0.1f) return;
    const float all = area(framebuffer), before = pixels_;
    const int step = step_for(pixels_, all, most_step_);
    float wanted = pixels_ * std::clamp(ratio, 0.75f, 1.25f);
    if (step == 0) {
        wanted = std::min(wanted, lit_of(all, most_step_));
    } else {
        const float here = lit_of(all, step);
        wanted = here;
        if (ratio > 1.0f && step > 1) {
            const float next = lit_of(all, step - 1);
            if (ratio * here >= kSurely * next) wanted = next;
        } else if (ratio < 1.0f) {
            wanted = step < most_step_ ? lit_of(all, step + 1) : here * std::max(0.75f, ratio);
        }
    }
    pixels_ = std::clamp(wanted, fewest_pixels_, most_pixels_);
    smoothed_ms_ *= pixels_ / before;  // the next picture is expected to take that much
}

PictureShape Resolution::shape_for(glm::ivec2 framebuffer) const {
    if (framebuffer.x <= 0 || framebuffer.y <= 0) return {};
    const int step = step_for(pixels_, area(framebuffer), most_step_);
    if (step > 0) return {(framebuffer + step - 1) / step, step};
    const float width = static_cast<float>(framebuffer.x), height = static_cast<float>(framebuffer.y);
    const float most = 1.0f / static_cast<float>(most_step_);
    const float scale =
        std::clamp(std::sqrt(pixels_ / (width * height)), std::min(1.0f, kNarrowest / width) * most, most);
    const int across = multiple_of_8(width * scale);  // whole tiles
    const float down = static_cast<float>(across) * height / width;
    const glm::ivec2 lit(across, std::max(1, static_cast<int>(std::lround(down))));
    const bool doubles = static_cast<float>(across * most_step_) * kMuchSmaller <= width;
    return {lit, most_step_, doubles && most_step_ > 1};
}

}  // namespace gh::app
