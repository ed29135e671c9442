// How much light facets give back at once: a table, against the integral; it may say too much, by a thousandth, but never
// too little, or white metal would shine by itself.
#include "render/gloss_energy.h"

#include "render/microfacets.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace gh {
namespace {

// By even steps of what facets are picked by, without any of the table's own rules.
render::GlossEnergy::Share integrated(float cosine, float roughness) {
    constexpr int kTurns = 64, kTails = 192;
    const float alpha = roughness * roughness;
    const glm::vec3 eye(std::sqrt(1.0f - cosine * cosine), 0.0f, cosine);
    const float lambda_eye = render::smith_lambda(eye, alpha);
    double white = 0.0, grazing = 0.0, whole = 0.0;
    for (int tail = 0; tail < kTails; ++tail) {
        const float left = (static_cast<float>(tail) + 0.5f) / kTails;
        for (int turn = 0; turn < kTurns; ++turn) {
            whole += static_cast<double>(left * left);
            const glm::vec2 u((static_cast<float>(turn) + 0.5f) * 0.5f / kTurns, 1.0f - left * left * left);
            const glm::vec3 half = render::pick_facet(eye, alpha, u);
            const float facing = glm::dot(eye, half);
            const glm::vec3 light = half * (2.0f * facing) - eye;
            if (!(light.z > 0.0f)) continue;
            const auto share = static_cast<double>(
                left * left * render::unshadowed_share(lambda_eye, render::smith_lambda(light, alpha)));
            white += share;
            grazing += share * std::pow(1.0 - std::min(1.0, static_cast<double>(facing)), 5.0);
        }
    }
    return {static_cast<float>(white / whole), static_cast<float>(grazing / whole)};
}

TEST(GlossEnergy, TheTableNeverSaysLessThanFacetsGiveBackAndLittleMore) {
    const render::GlossEnergy energy(false);
    for (const float roughness : {0.02f, 0.05f, 0.08f, 0.114f, 0.17f, 0.3f, 0.45f, 0.62f, 0.8f, 0.983f}) {
        for (const float cosine : {0.006f, 0.012f, 0.03f, 0.0447f, 0.07f, 0.15f, 0.33f, 0.6f, 0.9f, 1.0f}) {
            const auto truth = integrated(cosine, roughness), table = energy.towards(cosine, roughness);
            const float too_much = table.white - truth.white, grazing = table.grazing - truth.grazing;
            EXPECT_GT(too_much, -1e-5f) << roughness << " at " << cosine;
            EXPECT_LT(too_much, 1e-3f) << roughness << " at " << cosine;
            EXPECT_GT(grazing, -1e-5f) << roughness << " at " << cosine;
            EXPECT_LT(grazing, cosine < 0.15f ? 6e-3f : 1.6e-3f) << roughness << " at " << cosine;
        }
    }
}

// Averages are those of the table itself, weighted by the cosine, at any roughness: else what is added for later bounces
// would not be what is missing.
TEST(GlossEnergy, AveragesAreOfTheTableItself) {
    const render::GlossEnergy energy(false);
    for (const float roughness : {0.05f, 0.21f, 0.5f, 0.77f, 1.0f}) {
        double white = 0.0, grazing = 0.0;
        constexpr int kSteps = 4000;
        for (int i = 0; i < kSteps; ++i) {
            const float cosine = (static_cast<float>(i) + 0.5f) / kSteps;
            const auto share = energy.towards(cosine, roughness);
            white += 2.0 * static_cast<double>(cosine * share.white) / kSteps;
            grazing += 2.0 * static_cast<double>(cosine * share.grazing) / kSteps;
        }
        EXPECT_NEAR(static_cast<double>(energy.mean(roughness).white), white, 2e-5) << roughness;
        EXPECT_NEAR(static_cast<double>(energy.mean(roughness).grazing), grazing, 2e-5) << roughness;
    }
}

}  // namespace
}  // namespace gh
