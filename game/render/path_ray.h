// render/path_ray.h - a ray on its way through mirrors and glass, and what it has gone through.
#pragma once

#include "world/level.h"

#include "raycore/ray.h"

#include <glm/vec3.hpp>

#include <array>
#include <cstdint>

namespace gh::render {

// The glass bodies a ray is inside of, the last one entered on top. Bodies may overlap or lie one in the other; the one
// entered last counts, and leaving one that was never entered (the eye began inside) changes nothing.
class MediumStack {
  public:
    void enter(std::uint32_t part, const world::Material& glass) {
        if (count_ < kMost) bodies_[count_++] = {&glass, part};
    }
    void leave(std::uint32_t part) {
        for (std::size_t i = count_; i-- > 0;) {
            if (bodies_[i].part != part) continue;
            for (std::size_t k = i + 1; k < count_; ++k) bodies_[k - 1] = bodies_[k];
            --count_;
            return;
        }
    }
    // Null in air.
    [[nodiscard]] const world::Material* top() const {
        return count_ > 0 ? bodies_[count_ - 1].glass : nullptr;
    }
    [[nodiscard]] float ior() const { return count_ > 0 ? top()->ior : 1.0f; }

  private:
    static constexpr std::size_t kMost = 4;
    struct Body {
        const world::Material* glass;
        std::uint32_t part;
    };
    std::array<Body, kMost> bodies_{};
    std::uint32_t count_ = 0;
};

struct PathRay {
    // What it does at a mirror.
    void note_mirror(const glm::vec3& normal) {
        if (mirrors < mirror_normals.size()) mirror_normals[mirrors++] = normal;
    }
    glm::vec3 from{0.0f};    // where the ray starts, exactly: its origin is a little off the surface
    rc::Ray ray;             // direction unit
    glm::vec3 weight{1.0f};  // what its light counts in the pixel
    MediumStack media;
    std::uint32_t chain =
        0;  // of mirrors and glass it came by: pixels with the same chain see the same image
    float cone_width = 0.0f;  // of the pixel's cone at the origin, metres
    float cone_angle = 0.0f;
    float length = 0.0f;  // of the way so far, metres
    // Of the first two mirrors on its way, which unfold what is seen in them.
    std::array<glm::vec3, 2> mirror_normals{};
    float bulb_share = 1.0f;  // of a lamp's bulb it sees; the rest is in the highlight already
    std::uint16_t pixel = 0;  // of the tile
    std::uint8_t depth = 0;   // mirrors and borders of glass so far
    std::uint8_t mirrors = 0;
    std::uint8_t passes = 0;  // holes in leaves so far
    bool is_leading = true;   // carries the pixel's main surface: its samples are shared with neighbours
    bool is_glimmer = false;  // mirrored by the main surface, whose own light counts more
};

}  // namespace gh::render
