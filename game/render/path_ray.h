// render/path_ray.h - a ray on its way through mirrors and glass, and what it has gone through.
#pragma once

#include "render/sane.h"
#include "world/level.h"

#include "raycore/ray.h"

#include <glm/vec3.hpp>

#include <array>
#include <cstdint>

namespace gh::render {

// The glass bodies a ray is inside of. Where several share a place the one of the highest priority is there (Schmidt and
// Budge 2002, "Simple nested dielectrics in ray traced images"), and among equals the one entered last: a bubble in a
// ball needs no priority, water that overlaps its glass does. Leaving one that was never entered (the eye began inside)
// changes nothing.
class MediumStack {
  public:
    void enter(std::uint32_t part, const world::Material& glass) {
        if (count_ == kMost) return;
        std::size_t i = count_++;
        for (; i > 0 && bodies_[i - 1].glass->priority > glass.priority; --i) bodies_[i] = bodies_[i - 1];
        bodies_[i] = {&glass, part};
    }
    void leave(std::uint32_t part, const world::Material& glass) {
        for (std::size_t i = count_; i-- > 0;) {
            if (bodies_[i].part != part || bodies_[i].glass != &glass) continue;
            for (std::size_t k = i + 1; k < count_; ++k) bodies_[k - 1] = bodies_[k];
            --count_;
            return;
        }
    }
    // What happens at the border of a body.
    void cross(std::uint32_t part, const world::Material& glass, bool enters) {
        if (enters) {
            enter(part, glass);
        } else {
            leave(part, glass);
        }
    }
    // What is there; null in air.
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
    std::array<Body, kMost> bodies_{};  // the one that is there last
    std::uint32_t count_ = 0;
};

// The same for a scene without any.
class NoMedia {
  public:
    void cross(std::uint32_t, const world::Material&, bool) {}
    [[nodiscard]] const world::Material* top() const { return nullptr; }
    [[nodiscard]] float ior() const { return 1.0f; }
};

// What is on either side of a place where a ray meets the skin of bodies of glass. Of an eye that began inside one and
// leaves it, that body is here; null is air. The same on both sides, and light notices nothing: a body of a higher
// priority goes on there.
struct Sides {
    const world::Material* here = nullptr;
    const world::Material* there = nullptr;

    [[nodiscard]] bool is_border() const { return here != there; }
    [[nodiscard]] float eta() const {
        return sane(there != nullptr ? there->ior : 1.0f, 1.0f, 5.0f) /
               sane(here != nullptr ? here->ior : 1.0f, 1.0f, 5.0f);
    }
};
template <class Media>
[[nodiscard]] Sides sides_of(const Media& before, const Media& beyond, const world::Material& glass,
                             bool enters) {
    Sides sides{before.top(), beyond.top()};
    if (!enters && sides.here == nullptr) sides.here = &glass;
    return sides;
}

inline constexpr std::uint8_t kMostPasses = 32;  // holes and sheets on one path

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
