// What gloss gives, written down once more in double precision: any sum that balances by itself, as furnaces ask, is not
// enough to be the GGX that others mean.
#include "path_studio.h"
#include "render/bsdf.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <cmath>

namespace gh {
namespace {

// f cos of a perfect mirror's facets: D G2 / (4 cos_eye), G2 correlated by height (Heitz 2014, equation 99).
double ggx_times_cosine(const glm::dvec3& eye, const glm::dvec3& light, double alpha) {
    const glm::dvec3 half = glm::normalize(eye + light);
    const double d = half.z * half.z * (alpha * alpha - 1.0) + 1.0;
    const double facets = alpha * alpha / (3.14159265358979 * d * d);
    const auto lambda = [&](const glm::dvec3& w) {
        const double tan2 = (1.0 - w.z * w.z) / (w.z * w.z);
        return 0.5 * (std::sqrt(1.0 + alpha * alpha * tan2) - 1.0);
    };
    return facets / ((1.0 + lambda(eye) + lambda(light)) * 4.0 * eye.z);
}

TEST(GlossFormula, OnceReflectedLightIsHeightCorrelatedGgx) {
    const render::GlossEnergy energy;
    for (const float roughness : {0.2f, 0.5f, 0.9f}) {
        world::Material metal = test::mirror(1.0f);
        metal.roughness = roughness;
        render::ShadingPoint at;
        at.material = &metal;
        at.geometric = at.normal = at.smooth = {0, 0, 1};
        at.base_color = glm::vec3(1.0f);
        at.metallic = 1.0f;
        at.roughness = roughness;
        for (const float cos_eye : {0.15f, 0.5f, 0.95f}) {
            const glm::vec3 eye(std::sqrt(1.0f - cos_eye * cos_eye), 0.0f, cos_eye);
            const render::Bsdf bsdf(at, eye, {}, energy);
            for (const float cos_light : {0.1f, 0.4f, 0.9f}) {
                for (const float turn : {0.3f, 1.8f, 3.1f}) {
                    const float sine = std::sqrt(1.0f - cos_light * cos_light);
                    const glm::vec3 light(sine * std::cos(turn), sine * std::sin(turn), cos_light);
                    const float found =
                        bsdf.value(light)[static_cast<std::size_t>(render::Lobe::Gloss)].value.y;
                    const double truth = ggx_times_cosine(glm::dvec3(eye), glm::dvec3(light),
                                                          static_cast<double>(roughness * roughness));
                    EXPECT_NEAR(static_cast<double>(found) / truth, 1.0, 2e-4)
                        << roughness << " " << cos_eye << " " << cos_light << " " << turn;
                }
            }
        }
    }
}

}  // namespace
}  // namespace gh
