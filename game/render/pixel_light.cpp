#include "render/pixel_light.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace gh::render {

namespace {

constexpr float kSameFacing = 0.75f;  // least cosine between normals
constexpr float kSamePlane = 2.5f;    // most distance from each other's planes, in pixels' sizes
constexpr std::array<float, 5> kWindow = {0.5f, 1.0f, 1.0f, 1.0f,
                                          0.5f};  // both ends are the same place of the pattern

bool is_uniform(const PixelLight& p) {
    return p.size == 0.0f || arrives_whole(p.shared);
}

float ratio(float part, float whole) {
    return whole > 0.0f ? std::max(0.0f, part) / whole : 0.0f;
}

// The share of light that gets through to this pixel's surface, from its neighbours as much as from itself.
glm::vec3 shared_light(const std::vector<PixelLight>& pixels, int width, int height, int x, int y) {
    const auto at = [&](int i, int j) -> const PixelLight& {
        return pixels[static_cast<std::size_t>(j) * static_cast<std::size_t>(width) +
                      static_cast<std::size_t>(i)];
    };
    const PixelLight& centre = at(x, y);
    glm::vec3 unshadowed(0.0f), arrived(0.0f);
    for (int j = std::max(0, y - 2); j <= std::min(height - 1, y + 2); ++j) {
        for (int i = std::max(0, x - 2); i <= std::min(width - 1, x + 2); ++i) {
            const PixelLight& other = at(i, j);
            // A pixel on an edge is lit as all around it are, on whichever side.
            if (centre.is_mixed ? !(other.size > 0.0f) : other.is_mixed || !are_together(centre, other))
                continue;
            const float weight =
                kWindow[static_cast<std::size_t>(i - x + 2)] * kWindow[static_cast<std::size_t>(j - y + 2)];
            unshadowed += other.shared.unshadowed * weight;
            arrived += other.shared.arrived * weight;
        }
    }
    return centre.shared.unshadowed * glm::vec3(ratio(arrived.x, unshadowed.x),
                                                ratio(arrived.y, unshadowed.y),
                                                ratio(arrived.z, unshadowed.z));
}

}  // namespace

bool arrives_whole(const SharedLight& light) {
    const glm::vec3 missing = glm::abs(light.unshadowed - light.arrived), counts = light.unshadowed / 256.0f;
    return missing.x <= counts.x && missing.y <= counts.y && missing.z <= counts.z;
}

bool are_together(const PixelLight& a, const PixelLight& b) {
    if (!(b.size > 0.0f) || glm::dot(a.normal, b.normal) < kSameFacing) return false;
    const glm::vec3 offset = b.position - a.position;
    const float reach = kSamePlane * std::max(a.size, b.size);
    return std::abs(glm::dot(offset, a.normal)) < reach && std::abs(glm::dot(offset, b.normal)) < reach;
}

void develop(const std::vector<PixelLight>& pixels, bool shares, const Jobs& jobs, Image& out) {
    const int width = out.width, height = out.height;
    // Most rows lie wholly in the light or wholly in the dark; only around those that do not is there anything to share.
    std::vector<std::uint8_t> is_plain(pixels.size());
    jobs.run(static_cast<std::size_t>(height), [&](std::size_t y, int) {
        for (std::size_t i = y * static_cast<std::size_t>(width);
             i < (y + 1) * static_cast<std::size_t>(width); ++i) {
            is_plain[i] = is_uniform(pixels[i]) ? 1 : 0;
        }
    });
    jobs.run(static_cast<std::size_t>(height), [&](std::size_t row, int) {
        const int y = static_cast<int>(row);
        std::vector<std::uint8_t> is_plain_column(static_cast<std::size_t>(width), 1);
        for (int j = std::max(0, y - 2); j <= std::min(height - 1, y + 2); ++j) {
            const std::uint8_t* line =
                is_plain.data() + static_cast<std::size_t>(j) * static_cast<std::size_t>(width);
            for (std::size_t i = 0; i < static_cast<std::size_t>(width); ++i) is_plain_column[i] &= line[i];
        }
        for (int x = 0; x < width; ++x) {
            bool is_plain_here = true;
            for (int i = std::max(0, x - 2); i <= std::min(width - 1, x + 2); ++i) {
                is_plain_here &= is_plain_column[static_cast<std::size_t>(i)] != 0;
            }
            const std::size_t index = out.index(x, y);
            const PixelLight& p = pixels[index];
            const bool averages = shares && !is_plain_here && p.size > 0.0f;
            out.pixels[index] = p.clean + (averages ? shared_light(pixels, width, height, x, y)
                                                    : glm::max(p.shared.arrived, 0.0f));
        }
    });
}

}  // namespace gh::render
