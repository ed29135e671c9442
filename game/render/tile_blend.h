// render/tile_blend.h - what the two adaptive parts of a tile have in common: which pixels they visit in which pass, and
// when those around one may stand in for it.
#pragma once

#include "render/colour.h"
#include "render/tile.h"

#include <glm/vec3.hpp>

#include <algorithm>
#include <span>

namespace gh::render {

[[nodiscard]] inline glm::vec3 ratio(const glm::vec3& part, const glm::vec3& whole, float of_nothing) {
    return {whole.x > 0.0f ? part.x / whole.x : of_nothing, whole.y > 0.0f ? part.y / whole.y : of_nothing,
            whole.z > 0.0f ? part.z / whole.z : of_nothing};
}

// Whether a difference is small beside the mean of both and what else is there, W/m2/sr in the picture.
[[nodiscard]] inline bool is_alike(float least, float most, float beside, float contrast) {
    constexpr float kUnseen = 2e-3f;
    return most - least <= std::max(contrast * (0.5f * (least + most) + beside), kUnseen);
}

template <class Visit>
void TileTracer::visit_lit(Visit visit) {
    for (std::size_t first = 0; first < lit_.size(); first += kLitTogether) {
        const std::span some = std::span(lit_).subspan(first, std::min(kLitTogether, lit_.size() - first));
        lamps_.ask(frame_.view, frame_.light, some);
        for (std::size_t i = 0; i < some.size(); ++i) visit(first + i, i);
    }
}

template <class Blend>
void TileTracer::visit_pass(int pass, Blend blend) {
    not_blended_.clear();
    const bool is_adaptive = frame_.settings.is_adaptive;
    Corners corners;
    for (int y = 0; y < rows_; ++y) {
        for (int x = 0; x < columns_; ++x) {
            const int own =
                std::max(across_.pass[static_cast<std::size_t>(x)], down_.pass[static_cast<std::size_t>(y)]);
            const std::uint16_t surface = main_.at_pixel[static_cast<std::size_t>(y * columns_ + x)];
            if (own != pass || surface == MainSurfaces::kNone) continue;
            if (is_adaptive && pass > 0 && finds_corners(x, y, pass, corners) && blend(corners)) continue;
            not_blended_.push_back(surface);
        }
    }
}

}  // namespace gh::render
