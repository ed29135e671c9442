// sense/faces.h - the surfaces on a straight way, each once, with what they are and which way they are crossed.
//
// A way that runs exactly through the edge two triangles share meets both (watertight: neither may miss it); here that
// is one surface, as it is to light and sound.
// Cost      one `crossings`. Threads: pure. Same bits: as raycore's.
#pragma once

#include "world/level.h"

#include "raycore/ray.h"
#include "raycore/scene.h"

#include <glm/vec3.hpp>

#include <cstddef>
#include <span>

namespace gh::sense {

inline constexpr std::size_t kMaxFaces = 48;

// The same part crossed in the same direction within this share of the way is the same surface.
inline constexpr float kSameFace = 1e-5f;

struct Face {
    const world::Material* material = nullptr;
    std::uint32_t part = world::kNoIndex;
    float t = 0.0f;       // share of the way
    float cosine = 0.0f;  // to the normal, >= 0
    bool enters = false;  // through the front
};

struct Faces {
    std::size_t count = 0;
    bool is_complete = true;  // false: there are more than kMaxFaces
};

// Nearest first, on parts that share a bit with `layers`. out.size() == kMaxFaces.
[[nodiscard]] Faces faces_between(const world::Level& level, const rc::Scene& scene, const glm::vec3& from,
                                  const glm::vec3& to, rc::LayerMask layers, std::span<Face, kMaxFaces> out);

}  // namespace gh::sense
