// render/gloss_energy.h - how much light a glossy surface gives back after one bounce among its facets, and so how much
// is still on its way: what an energy-preserving surface has to add (Kulla and Conty 2017), and what a diffuse base
// below it gets.
//
// What is added is what the table says is missing: were it to say less than facets give back, white metal would give more
// than it gets. So it is kept above the truth, by less than a thousandth (Schlick's part by up to a two hundredth where narrow
// lobes graze): surfaces darken by that much at most, and none shines by itself. Between the table's rows, light at an angle comes back by the ratio of its cosine to the width of the lobe;
// a table over the cosine alone, which stood here, was off by 2 % where narrow lobes graze.
//
// Memory    13 kB, integrated numerically when made (Gauss's rule, each turn up to its own horizon): 92 ms; cloth 130 ms
//           more, where a scene has any.
// Cost      19 ns a look-up, 6 ns when it was a table over the cosine.
// Same bits sums in index order.
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

    explicit GlossEnergy(bool has_cloth = true);
    // One that knows nothing yet, to be replaced.
    [[nodiscard]] static GlossEnergy none() { return GlossEnergy(Nothing{}); }

    [[nodiscard]] Share towards(float cosine, float roughness) const;
    // Averaged over directions, weighted by the cosine.
    [[nodiscard]] Share mean(float roughness) const;

    // The same for cloth.
    [[nodiscard]] const Sheen& sheen() const { return sheen_; }

  private:
    struct Nothing {};
    explicit GlossEnergy(Nothing) : sheen_(Sheen::none()) {}

    static constexpr int kCosines = 64, kTailCosines = 32, kRoughnesses = 32, kMeans = 129;
    static constexpr std::size_t kRows = kRoughnesses;
    std::array<float, kRows * kCosines> white_{};  // [roughness][place]
    // (grazing / white)^(1/5) - (1 - cosine), nearly 0 for narrow lobes: [roughness][root of cosine].
    std::array<float, kRows * kTailCosines> tail_{};
    std::array<Share, kMeans> means_{};
    Sheen sheen_;
};

}  // namespace gh::render
