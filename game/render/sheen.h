// render/sheen.h - light off the fibres of a cloth, as KHR_materials_sheen asks: Charlie's distribution of fibres that
// stand up (Estevez and Kulla 2017) with Neubelt and Pettineo's shadowing (2013).
//
// As published it gives back up to three times the light it gets at grazing angles, where cloth is smooth; here each
// roughness is scaled so that it never gives back more than all, which leaves it reciprocal.
//
// Memory    4 kB, integrated numerically when made (130 ms: two million powers), for scenes that have cloth.
// Same bits midpoint sums in index order.
#pragma once

#include <glm/vec3.hpp>

#include <array>
#include <cstddef>

namespace gh::render {

class Sheen {
  public:
    Sheen();
    // One that gives nothing back.
    [[nodiscard]] static Sheen none() { return Sheen(Nothing{}); }

    // Of white fibres, times the light's cosine. Directions in the surface's frame, both above it; `roughness` is glTF's.
    [[nodiscard]] float value(const glm::vec3& eye, const glm::vec3& light, float roughness) const;
    // Share of the light from everywhere that comes back, in [0, 1].
    [[nodiscard]] float albedo(float cosine, float roughness) const;

  private:
    struct Nothing {};
    explicit Sheen(Nothing) {}

    static constexpr int kCosines = 32, kRoughnesses = 32;
    std::array<float, static_cast<std::size_t>(kCosines) * kRoughnesses> albedo_{};  // [roughness][cosine]
    std::array<float, kRoughnesses> scale_{};
};

}  // namespace gh::render
