#include "render/gloss_energy.h"

#include "render/microfacets.h"

#include <algorithm>
#include <cmath>

namespace gh::render {

namespace {

constexpr int kTurns = 12, kHeights = 32;  // of picked facets; the other half of the circle is the same

GlossEnergy::Share integrated(float cosine, float alpha) {
    const glm::vec3 eye(std::sqrt(std::max(0.0f, 1.0f - cosine * cosine)), 0.0f, cosine);
    const float lambda_eye = smith_lambda(eye, alpha);
    GlossEnergy::Share sum{0.0f, 0.0f};
    // What is lost lies in the lobe's tail: heights are picked closer together there.
    for (int i = 0; i < kTurns * kHeights; ++i) {
        const int turn = i % kTurns, height = i / kTurns;
        const float left = 1.0f - (static_cast<float>(height) + 0.5f) / kHeights;
        const float weight = 3.0f * left * left / (kTurns * kHeights);
        const glm::vec2 u((static_cast<float>(turn) + 0.5f) * 0.5f / kTurns, 1.0f - left * left * left);
        const glm::vec3 half = pick_facet(eye, alpha, u);
        const float facing = glm::dot(eye, half);
        const glm::vec3 light = half * (2.0f * facing) - eye;
        if (!(light.z > 0.0f)) continue;
        const float share = weight * unshadowed_share(lambda_eye, smith_lambda(light, alpha));
        const float m = 1.0f - std::min(facing, 1.0f);
        sum.white += share;
        sum.grazing += share * (m * m * m * m * m);
    }
    // The sum of all weights is not quite 1.
    constexpr float kWhole = 1.0f - 0.25f / (kHeights * kHeights);
    return {std::min(sum.white / kWhole, 1.0f), sum.grazing / kWhole};
}

GlossEnergy::Share blend(const GlossEnergy::Share& a, const GlossEnergy::Share& b, float t) {
    return {a.white + (b.white - a.white) * t, a.grazing + (b.grazing - a.grazing) * t};
}

// The cell and the place in it.
struct Place {
    std::size_t cell;
    float t;
};
Place place(float x, int side) {
    const float scaled = std::clamp(x, 0.0f, 1.0f) * static_cast<float>(side - 1);
    const int cell = std::min(static_cast<int>(scaled), side - 2);
    return {static_cast<std::size_t>(cell), scaled - static_cast<float>(cell)};
}

}  // namespace

GlossEnergy::GlossEnergy() {
    for (std::size_t r = 0; r < kRoughnesses; ++r) {
        const float roughness = static_cast<float>(r) / (kRoughnesses - 1);
        const float alpha = std::max(roughness * roughness, 1e-6f);
        for (std::size_t c = 0; c < kCosines; ++c) {
            const float x = std::max(static_cast<float>(c), 0.05f) / (kCosines - 1);
            shares_[r * kCosines + c] = integrated(x * x, alpha);
        }
        // 2 E(mu) mu dmu = 4 E(x^2) x^3 dx.
        constexpr int kSteps = 128;
        Share sum{0.0f, 0.0f};
        for (int i = 0; i < kSteps; ++i) {
            const float x = (static_cast<float>(i) + 0.5f) / kSteps;
            const Share share = towards(x * x, roughness);
            const float weight = 4.0f * x * x * x / kSteps;
            sum.white += share.white * weight;
            sum.grazing += share.grazing * weight;
        }
        means_[r] = sum;
    }
}

GlossEnergy::Share GlossEnergy::towards(float cosine, float roughness) const {
    const Place y = place(roughness, kRoughnesses);
    const Place x = place(std::sqrt(std::clamp(cosine, 0.0f, 1.0f)), kCosines);
    const Share* low = shares_.data() + y.cell * kCosines + x.cell;
    if (y.t == 0.0f) return blend(low[0], low[1], x.t);
    return blend(blend(low[0], low[1], x.t), blend(low[kCosines], low[kCosines + 1], x.t), y.t);
}

GlossEnergy::Share GlossEnergy::mean(float roughness) const {
    const Place y = place(roughness, kRoughnesses);
    return blend(means_[y.cell], means_[y.cell + 1], y.t);
}

}  // namespace gh::render
