#include "app/resolution.h"

#include "base/contracts.h"

#include <algorithm>
#include <cmath>

namespace gh::app {

namespace {

int multiple_of_8(float length) {
    return std::max(8, static_cast<int>(std::lround(length / 8.0f)) * 8);
}

}  // namespace

void Resolution::bound(float fewest_pixels, float most_pixels) {
    EXPECTS(0.0f < fewest_pixels && fewest_pixels <= most_pixels);
    fewest_pixels_ = fewest_pixels;
    most_pixels_ = most_pixels;
    pixels_ = std::clamp(pixels_, fewest_pixels_, most_pixels_);
}

void Resolution::note_frame(float render_ms, float wanted_ms) {
    if (!(render_ms > 0.0f) || !(wanted_ms > 0.0f)) return;
    smoothed_ms_ = smoothed_ms_ == 0.0f ? render_ms : smoothed_ms_ + 0.3f * (render_ms - smoothed_ms_);
    const float ratio = wanted_ms / smoothed_ms_;
    if (std::abs(ratio - 1.0f) < 0.1f) return;
    const float step = std::clamp(ratio, 0.75f, 1.25f);
    const float before = pixels_;
    pixels_ = std::clamp(pixels_ * step, fewest_pixels_, most_pixels_);
    smoothed_ms_ *= pixels_ / before;  // the next picture is expected to take that much
}

glm::ivec2 Resolution::size_for(glm::ivec2 framebuffer) const {
    if (framebuffer.x <= 0 || framebuffer.y <= 0) return {0, 0};
    const float width = static_cast<float>(framebuffer.x);
    const float height = static_cast<float>(framebuffer.y);
    const float wanted = std::sqrt(pixels_ / (width * height));
    const float scale = std::clamp(wanted, std::min(1.0f, 160.0f / width), 1.0f);
    if (scale == 1.0f) return framebuffer;
    return {multiple_of_8(width * scale), multiple_of_8(height * scale)};
}

glm::ivec2 Resolution::shown_size(glm::ivec2 rendered, glm::ivec2 framebuffer) {
    return {std::min(2 * rendered.x, framebuffer.x), std::min(2 * rendered.y, framebuffer.y)};
}

}  // namespace gh::app
