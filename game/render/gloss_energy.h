// render/gloss_energy.h - how much light a glossy surface gives back after one bounce among its facets, and so how much
// is still on its way: what an energy-preserving surface has to add (Kulla and Conty 2017), and what a diffuse base
// below it gets.
//
// Memory    29 kB, integrated numerically when made (about 35 ms).
// Same bits midpoint sums in index order.
#pragma once

#include "render/sheen.h"

#include <glm/vec3.hpp>

#include <array>
#include <cstddef>

namespace gh::render {

class GlossEnergy {
  public:
    // Of facets that mirror everything, and the part of that which Schlick's fifth power picks out.
    struct Share {
        float white = 1.0f;
        float grazing = 0.0f;
        // For Fresnel f0 head on and f90 at grazing angles.
        [[nodiscard]] glm::vec3 of(const glm::vec3& f0, float f90) const {
            return f0 * (white - grazing) + glm::vec3(f90 * grazing);
        }
    };

    GlossEnergy();

    [[nodiscard]] Share towards(float cosine, float roughness) const;
    // Averaged over directions, weighted by the cosine.
    [[nodiscard]] Share mean(float roughness) const;

    // The same for cloth.
    [[nodiscard]] const Sheen& sheen() const { return sheen_; }

  private:
    static constexpr int kCosines = 64, kRoughnesses = 48;
    std::array<Share, static_cast<std::size_t>(kRoughnesses) * kCosines>
        shares_{};  // [roughness][root of cosine]
    std::array<Share, kRoughnesses> means_{};
    Sheen sheen_;
};

}  // namespace gh::render
