// render/pixel_filter.h - how a picture is put together from samples: the shape in which those around a pixel's middle
// count. Samples are picked by that shape, so that each counts the same and no pixel needs its neighbours' (Ernst, Stamminger
// and Greiner 2006, "Filter importance sampling").
//
//   Box       the pixel's own square: sharpest, and edges step
//   Tent      two pixels wide, falling evenly
//   Gaussian  of half a pixel's deviation, cut off at a pixel and a half: edges are smooth, as Cook 1984 has it
//
// Same bits pure; base/det_math.
#pragma once

#include "base/det_math.h"
#include "render/directions.h"

#include <glm/vec2.hpp>

#include <cmath>
#include <cstdint>

namespace gh::render {

enum class PixelFilter : std::uint8_t { Box, Tent, Gaussian };

// From the pixel's corner, in pixels; `u` in [0, 1)^2. The mean is the pixel's middle.
[[nodiscard]] inline glm::vec2 filter_point(PixelFilter filter, const glm::vec2& u) {
    if (filter == PixelFilter::Tent) {
        const auto tent = [](float x) {
            return x < 0.5f ? std::sqrt(2.0f * x) - 1.0f : 1.0f - std::sqrt(2.0f - 2.0f * x);
        };
        return glm::vec2(0.5f) + glm::vec2(tent(u.x), tent(u.y));
    }
    if (filter == PixelFilter::Gaussian) {
        constexpr float kVariance = 0.25f;
        constexpr float kKept = 0.988891f;  // within the cut: 1 - exp(-1.5^2 / (2 variance))
        const float radius = std::sqrt(-2.0f * kVariance * det::log(1.0f - kKept * u.x));
        return glm::vec2(0.5f) + circle_point(u.y) * radius;
    }
    return u;
}

}  // namespace gh::render
