// speed_error/shown.h - a picture as a screen shows it, for the measures that ask what a viewer sees.
#pragma once

#include "base/image.h"
#include "base/jobs.h"
#include "filter/tone_map.h"

#include <glm/vec3.hpp>

#include <cstddef>

namespace speed_error {

[[nodiscard]] inline gh::Image8 shown8(const gh::Image& picture, float exposure, const gh::Jobs& jobs) {
    gh::Image8 bytes;
    gh::filter::tone_map(picture, exposure, 0, jobs, bytes);
    return bytes;
}

// sRGB-encoded, in [0, 1].
[[nodiscard]] inline gh::Image shown(const gh::Image& picture, float exposure, const gh::Jobs& jobs) {
    const gh::Image8 bytes = shown8(picture, exposure, jobs);
    gh::Image image(picture.width, picture.height);
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        for (glm::length_t c = 0; c < 3; ++c)
            image.pixels[i][c] = static_cast<float>(bytes.bytes[3 * i + c]) / 255.0f;
    }
    return image;
}

// Mean of the three colours.
[[nodiscard]] inline double brightness(const glm::vec3& c) {
    return static_cast<double>(c.x + c.y + c.z) / 3.0;
}

[[nodiscard]] inline double mean_brightness(const gh::Image& image) {
    double sum = 0.0;
    for (const glm::vec3& pixel : image.pixels) sum += brightness(pixel);
    return sum / static_cast<double>(image.pixels.size());
}

}  // namespace speed_error
