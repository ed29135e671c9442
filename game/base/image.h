// base/image.h - pictures in memory. Rows run top to bottom, pixels left to right, (0, 0) is the top left.
#pragma once

#include "base/contracts.h"

#include <glm/vec3.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace gh {

// Linear radiance, scene-referred, not clamped.
struct Image {
    int width = 0;
    int height = 0;
    std::vector<glm::vec3> pixels;  // width * height

    Image() = default;
    // Black. Both sides >= 0.
    Image(int width_px, int height_px)
        : width(width_px),
          height(height_px),
          pixels(static_cast<std::size_t>(width_px) * static_cast<std::size_t>(height_px), glm::vec3(0.0f)) {}

    [[nodiscard]] std::size_t index(int x, int y) const {
        EXPECTS(0 <= x && x < width && 0 <= y && y < height);
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
    }
    [[nodiscard]] glm::vec3& at(int x, int y) { return pixels[index(x, y)]; }
    [[nodiscard]] const glm::vec3& at(int x, int y) const { return pixels[index(x, y)]; }
};

// What a screen or a PNG takes: sRGB-encoded bytes, `channels` of them a pixel (3: RGB; 4: RGB and straight
// alpha).
struct Image8 {
    int width = 0;
    int height = 0;
    int channels = 3;
    std::vector<std::uint8_t> bytes;  // width * height * channels

    Image8() = default;
    Image8(int width_px, int height_px, int channel_count = 3)
        : width(width_px),
          height(height_px),
          channels(channel_count),
          bytes(static_cast<std::size_t>(width_px) * static_cast<std::size_t>(height_px) *
                static_cast<std::size_t>(channel_count)) {}

    // The first of the pixel's `channels` bytes.
    [[nodiscard]] std::uint8_t* at(int x, int y) { return bytes.data() + index(x, y); }
    [[nodiscard]] const std::uint8_t* at(int x, int y) const { return bytes.data() + index(x, y); }
    [[nodiscard]] std::size_t index(int x, int y) const {
        EXPECTS(0 <= x && x < width && 0 <= y && y < height);
        return (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)) *
               static_cast<std::size_t>(channels);
    }
};

}  // namespace gh
