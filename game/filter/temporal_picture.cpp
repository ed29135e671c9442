// The part of the upscaler that adds its pictures up.
#include "filter/temporal_upscale.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace gh::filter {

namespace {

constexpr float kStillPictures = 8.0f;   // that are added up where nothing moves ...
constexpr float kMovingPictures = 4.0f;  // ... and where each frame moves them

// Weights of the four numbers around a place `t` after the second.
std::array<float, 4> catmull_rom(float t) {
    const float t2 = t * t, t3 = t2 * t;
    return {0.5f * (2.0f * t2 - t3 - t), 0.5f * (3.0f * t3 - 5.0f * t2 + 2.0f),
            0.5f * (4.0f * t2 - 3.0f * t3 + t), 0.5f * (t3 - t2)};
}

}  // namespace

// The range of the nine numbers around each of a row of pixels, a channel at a time.
void TemporalUpscaler::find_picture_range(const Guide& guide, int y, std::vector<float>& low,
                                          std::vector<float>& high) const {
    const std::size_t count = 3 * static_cast<std::size_t>(guide.width);
    const float* middle = &lighted_[static_cast<std::size_t>(y) * static_cast<std::size_t>(guide.width)].x;
    const float* above = y > 0 ? middle - count : middle;
    const float* below = y + 1 < guide.height ? middle + count : middle;
    low.resize(count + 6);  // a pixel more on either side
    high.resize(count + 6);
    for (std::size_t i = 0; i < count; ++i) {
        low[i + 3] = std::min(above[i], std::min(middle[i], below[i]));
        high[i + 3] = std::max(above[i], std::max(middle[i], below[i]));
    }
    for (std::size_t i = 0; i < 3; ++i) {
        low[i] = low[i + 3];
        high[i] = high[i + 3];
        low[count + 3 + i] = low[count + i];
        high[count + 3 + i] = high[count + i];
    }
    for (std::size_t i = 0; i < count; ++i) {
        low[i] = std::min(low[i], std::min(low[i + 3], low[i + 6]));
        high[i] = std::max(high[i], std::max(high[i + 3], high[i + 6]));
    }
}

// The pictures before, at a place of theirs, by a sharp filter: a mean is moved in every frame, and a bilinear one would
// blur it each time.
glm::vec3 TemporalUpscaler::picture_at(const glm::vec2& at) const {
    const glm::vec2 floor = glm::floor(at);
    const glm::ivec2 low(floor);
    const glm::vec2 share = at - floor;
    const auto pixel = [&](int u, int v) -> const glm::vec3& {
        return picture_[static_cast<std::size_t>(std::clamp(v, 0, size_.y - 1)) *
                            static_cast<std::size_t>(size_.x) +
                        static_cast<std::size_t>(std::clamp(u, 0, size_.x - 1))];
    };
    if (share == glm::vec2(0.0f)) return pixel(low.x, low.y);
    const std::array<float, 4> across = catmull_rom(share.x), down = catmull_rom(share.y);
    glm::vec3 sum(0.0f);
    for (int v = 0; v < 4; ++v) {
        glm::vec3 row(0.0f);
        for (int u = 0; u < 4; ++u)
            row += pixel(low.x + u - 1, low.y + v - 1) * across[static_cast<std::size_t>(u)];
        sum += row * down[static_cast<std::size_t>(v)];
    }
    return sum;
}

// Adds the picture up with those before it, as far as they lie in the range of the nine pixels around.
void TemporalUpscaler::smooth_row(const Guide& guide, int y, Image& out) const {
    std::vector<float> low, high;
    find_picture_range(guide, y, low, high);
    for (int x = 0; x < guide.width; ++x) {
        const std::size_t i = out.index(x, y), k = 3 * static_cast<std::size_t>(x);
        const glm::vec2 at = glm::vec2(x, y) + motion_[i].by;
        out.pixels[i] = lighted_[i];
        if (!has_history_ || !(at.x >= 0.0f) || !(at.y >= 0.0f) || at.x > static_cast<float>(size_.x - 1) ||
            at.y > static_cast<float>(size_.y - 1))
            continue;
        const glm::vec3 before = glm::clamp(picture_at(at), glm::vec3(low[k], low[k + 1], low[k + 2]),
                                            glm::vec3(high[k], high[k + 1], high[k + 2]));
        const float moved = std::min(1.0f, 2.0f * glm::length(motion_[i].by));
        const float pictures = kStillPictures + (kMovingPictures - kStillPictures) * moved;
        out.pixels[i] = before + (lighted_[i] - before) / pictures;
    }
}

}  // namespace gh::filter
