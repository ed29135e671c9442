// render/lamp_weights.h - about how much light lamps may give at a place, four of them side by side: what LightSet picks
// the lamps of a list by.
//
// Cost      about 5 ns a lamp, most of it roots and divisions.
// Same bits for every instruction set: one IEEE operation at a time, no fused ones.
// Threads   any number may ask at once.
#pragma once

#include "render/light_tree.h"

#include <glm/vec3.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace gh::render {

class LampWeights {
  public:
    static constexpr std::size_t kTogether = 16;
    using Weights = std::array<float, kTogether>;

    // Where it shines: everywhere, or as a panel from its front or from both sides. Beam: what arrives is for the caller to
    // say; here it counts as 1 at any distance within its cone.
    enum class Shines : std::uint8_t { All, Front, Both, Beam };
    struct Lamp {
        glm::vec3 centre{0.0f};
        glm::vec3 axis{0.0f};     // unit, of a panel or a beam
        float extent = 0.0f;      // around the centre, metres
        float power = 0.0f;       // irradiance times distance squared, face on; 0: gives nothing
        float cos_outer = -2.0f;  // of a beam
        Shines shines = Shines::All;
    };

    explicit LampWeights(std::size_t lamps) : lamps_(lamps) {}
    void set(std::uint32_t id, const Lamp& lamp);

    // weights[i]: of lamp ids[i], at most kTogether of them; the rest are 0.
    void at(const LightQuery& query, std::span<const std::uint32_t> ids, Weights& weights) const;

  private:
    // What a kernel loads, four numbers at a time.
    struct alignas(16) Row {
        float centre[3], extent;
        float axis[3], power;
        float shines, cos_outer, unused[2];
    };

    std::vector<Row> lamps_;
};

}  // namespace gh::render
