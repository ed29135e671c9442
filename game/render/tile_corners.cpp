// The part of a tile that finds, around a pixel, those on the same surface.
#include "render/tile.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace gh::render {

namespace {

constexpr float kCornersFacing = 0.9f;  // least cosine between normals
constexpr float kCornersPlane = 2.5f;   // most distance from each other's planes, in pixels' sizes
constexpr float kLeastWeight = 0.3f;    // of the four corners around a pixel, on its own surface

float size_of(const SeenSurface& surface) {
    const float cosine = std::max(0.05f, -glm::dot(surface.path.ray.direction, surface.at.geometric));
    return surface.path.cone_width / cosine;
}

bool are_one_surface(const SeenSurface& a, const SeenSurface& b) {
    if (a.at.material != b.at.material || a.path.chain != b.path.chain) return false;
    if (glm::dot(a.at.geometric, b.at.geometric) < kCornersFacing) return false;
    const glm::vec3 offset = b.at.surface.position - a.at.surface.position;
    const float reach = kCornersPlane * std::max(size_of(a), size_of(b));
    return std::abs(glm::dot(offset, a.at.geometric)) < reach &&
           std::abs(glm::dot(offset, b.at.geometric)) < reach;
}

}  // namespace

bool TileTracer::finds_corners(int x, int y, int pass, Corners& corners) const {
    const auto p = static_cast<std::size_t>(pass);
    const auto column = static_cast<std::size_t>(x), row = static_cast<std::size_t>(y);
    const int left = across_.before[p][column], right = across_.after[p][column];
    const int top = down_.before[p][row], bottom = down_.after[p][row];
    const float fx = right > left ? static_cast<float>(x - left) / static_cast<float>(right - left) : 0.0f;
    const float fy = bottom > top ? static_cast<float>(y - top) / static_cast<float>(bottom - top) : 0.0f;
    const std::array<int, 4> pixel = {top * columns_ + left, top * columns_ + right, bottom * columns_ + left,
                                      bottom * columns_ + right};
    const std::array<float, 4> weight = {(1.0f - fx) * (1.0f - fy), fx * (1.0f - fy), (1.0f - fx) * fy,
                                         fx * fy};
    corners.centre = main_.at_pixel[static_cast<std::size_t>(y * columns_ + x)];
    corners.count = 0;
    float total = 0.0f;
    for (std::size_t i = 0; i < 4; ++i) {
        const std::uint16_t surface = main_.at_pixel[static_cast<std::size_t>(pixel[i])];
        if (!(weight[i] > 0.0f) || surface == MainSurfaces::kNone) continue;
        if (!are_one_surface(main_.surfaces[corners.centre], main_.surfaces[surface])) continue;
        corners.surface[corners.count] = surface;
        corners.weight[corners.count++] = weight[i];
        total += weight[i];
    }
    for (std::size_t i = 0; i < corners.count; ++i) corners.weight[i] /= total;
    return total >= kLeastWeight;
}

}  // namespace gh::render
