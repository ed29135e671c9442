// A wall, its colours and the light on it, as the upscaler sees them through a lens: everything is known in closed form.
#pragma once

#include "filter/jitter.h"
#include "filter/temporal_upscale.h"

#include <functional>
#include <vector>

namespace gh::test {

inline constexpr int kWidth = 40, kHeight = 30, kStep = 4;

// A wall at z = -1 seen through a lens that looks along -z; its colour is a function of the place on it.
using Wall = std::function<float(const glm::vec2&)>;

inline filter::Pinhole lens_at(const glm::vec2& eye, int width, int height) {
    return {.eye = glm::vec3(eye, 0.0f),
            .corner = {-1.0f, 0.75f, -1.0f},
            .right = {2.0f / static_cast<float>(width), 0, 0},
            .down = {0, -1.5f / static_cast<float>(height), 0}};
}

inline glm::vec3 on_wall(const filter::Pinhole& lens, const glm::vec2& at) {
    return lens.eye + lens.corner + lens.right * at.x + lens.down * at.y;
}

// What is seen of a wall of this colour, and the light on it in every sixteenth pixel.
struct Shot {
    Image radiance{kWidth, kHeight};
    filter::Guide seen;
    glm::ivec2 offset{0};
    std::vector<std::uint32_t> part;
    std::vector<glm::vec3> position, normal, albedo, clean;
    std::vector<glm::vec3> previous;  // empty: nothing moves by itself

    [[nodiscard]] filter::GuidedFrame frame() const {
        filter::Guide guide = seen;
        guide.part = part;
        guide.position = position;
        guide.previous = previous.empty() ? position : previous;
        guide.geometric = normal;
        guide.albedo = albedo;
        guide.clean = clean;
        return {radiance, kStep, offset, guide};
    }
    // The pixel of the guide that a lit pixel is.
    [[nodiscard]] std::size_t place(int u, int v) const {
        return static_cast<std::size_t>((v * kStep + offset.y) * seen.width + u * kStep + offset.x);
    }
    // After the guide has changed.
    void light(const Wall& on_wall) {
        for (int v = 0; v < kHeight; ++v) {
            for (int u = 0; u < kWidth; ++u) {
                const std::size_t i = place(u, v);
                radiance.at(u, v) = albedo[i] * on_wall(glm::vec2(position[i])) + clean[i];
            }
        }
    }
};

inline Shot shoot(const Wall& color, const Wall& light, const glm::vec2& eye, std::uint32_t number) {
    Shot shot;
    shot.seen.width = kWidth * kStep;
    shot.seen.height = kHeight * kStep;
    shot.seen.lens = lens_at(eye, shot.seen.width, shot.seen.height);
    shot.seen.jitter = filter::halton_jitter(number);
    shot.offset = filter::lit_offset(number, kStep);
    for (int y = 0; y < shot.seen.height; ++y) {
        for (int x = 0; x < shot.seen.width; ++x) {
            const glm::vec3 p = on_wall(shot.seen.lens, glm::vec2(x, y) + 0.5f + shot.seen.jitter);
            shot.part.push_back(7);
            shot.position.push_back(p);
            shot.normal.emplace_back(0.0f, 0.0f, 1.0f);
            shot.albedo.emplace_back(color(glm::vec2(p)));
            shot.clean.emplace_back(0.0f);
        }
    }
    shot.light(light);
    return shot;
}

}  // namespace gh::test
