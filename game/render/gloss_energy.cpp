#include "render/gloss_energy.h"

#include "base/det_math.h"
#include "render/microfacets.h"
#include "render/table_place.h"

#include <algorithm>
#include <cmath>

namespace gh::render {

namespace {

constexpr float kLeastAlpha = 1e-6f;
// What the table is off by at most, downwards, is added everywhere (tests/render/gloss_energy_test.cpp); the second where
// narrow lobes graze.
constexpr float kWhiteMargin = 6e-4f, kGrazingMargin = 1e-3f, kMostGrazingMargin = 3.2e-3f;

// Gauss and Legendre's rule of twelve places on [-1, 1]: the upper half of it.
constexpr std::array<float, 6> kPlaces{0.1252334085f, 0.3678314990f, 0.5873179543f,
                                       0.7699026742f, 0.9041172564f, 0.9815606342f};
constexpr std::array<float, 6> kWeights{0.2491470458f, 0.2334925365f, 0.2031674267f,
                                        0.1600783285f, 0.1069393260f, 0.0471753364f};

// Facets that one direction sees, by the numbers pick_facet() takes: a turn, and how much is left to the tail of the lobe,
// cubed so that places are closer together there.
class SeenFacets {
  public:
    SeenFacets(float cosine, float alpha)
        : eye_(std::sqrt(std::max(0.0f, 1.0f - cosine * cosine)), 0.0f, cosine),
          alpha_(alpha),
          lambda_eye_(smith_lambda(eye_, alpha)) {}

    // Where light still leaves above the surface: from there on to 1 it does. `near`: a guess, or below 0.
    [[nodiscard]] float horizon(float turn, float near) const {
        float low = 0.0f, high = 1.0f;
        int steps = 14;
        if (near >= 0.0f) {
            constexpr float kReach = 0.02f;
            const float below = std::max(near - kReach, 0.0f), above = std::min(near + kReach, 1.0f);
            if (below > 0.0f && leaves(turn, below)) {
                high = below;
            } else if (above < 1.0f && !leaves(turn, above)) {
                low = above;
            } else {
                low = below;
                high = above;
                steps = 6;
            }
        }
        for (int i = 0; i < steps; ++i) {
            const float middle = 0.5f * (low + high);
            (leaves(turn, middle) ? high : low) = middle;
        }
        return high;
    }

    // What facets at this place give back, times how many there are.
    void add(float turn, float left, float weight, double& white, double& grazing) const {
        const glm::vec3 half = facet(turn, left);
        const float facing = glm::dot(eye_, half);
        const glm::vec3 light = half * (2.0f * facing) - eye_;
        if (!(light.z > 0.0f)) return;
        const float share =
            3.0f * left * left * weight * unshadowed_share(lambda_eye_, smith_lambda(light, alpha_));
        const float m = 1.0f - std::min(facing, 1.0f);
        white += static_cast<double>(share);
        grazing += static_cast<double>(share * (m * m * m * m * m));
    }

  private:
    [[nodiscard]] glm::vec3 facet(float turn, float left) const {
        return pick_facet(eye_, alpha_, {turn, 1.0f - left * left * left});
    }
    [[nodiscard]] bool leaves(float turn, float left) const {
        const glm::vec3 half = facet(turn, left);
        return 2.0f * glm::dot(eye_, half) * half.z > eye_.z;
    }

    glm::vec3 eye_;
    float alpha_;
    float lambda_eye_;
};

GlossEnergy::Share integrated(float cosine, float alpha) {
    constexpr int kTurns = 32;  // over half a circle; the other half is the same
    const SeenFacets facets(cosine, alpha);
    double white = 0.0, grazing = 0.0;
    float horizon = -1.0f;
    for (int i = 0; i < kTurns; ++i) {
        const float turn = (static_cast<float>(i) + 0.5f) * 0.5f / kTurns;
        horizon = facets.horizon(turn, horizon);
        // By halves: one rule for the whole is off by 5e-4 where narrow lobes graze.
        const float half = 0.25f * (1.0f - horizon);
        for (const float middle : {horizon + half, 1.0f - half}) {
            for (std::size_t k = 0; k < kPlaces.size(); ++k) {
                for (const float side : {-1.0f, 1.0f})
                    facets.add(turn, middle + side * half * kPlaces[k], half * kWeights[k] / kTurns, white,
                               grazing);
            }
        }
    }
    return {static_cast<float>(white), static_cast<float>(grazing)};
}

float alpha_of(float roughness) {
    return std::max(roughness * roughness, kLeastAlpha);
}

}  // namespace

// White's columns are even in the root of cosine (1 + alpha) / (cosine + alpha), the tail's in that of the cosine.
GlossEnergy::GlossEnergy(bool has_cloth) : sheen_(has_cloth ? Sheen() : Sheen::none()) {
    constexpr float kFirst = 0.02f;  // for column 0, where nothing is to be seen any more
    for (std::size_t r = 0; r < kRoughnesses; ++r) {
        const float alpha = alpha_of(static_cast<float>(r) / (kRoughnesses - 1));
        for (std::size_t c = 0; c < kCosines; ++c) {
            const float root = std::max(static_cast<float>(c), kFirst) / (kCosines - 1), x = root * root;
            const float cosine = x < 1.0f ? std::min(alpha * x / (1.0f + alpha - x), 1.0f) : 1.0f;
            white_[r * kCosines + c] = integrated(cosine, alpha).white;
        }
        for (std::size_t c = 0; c < kTailCosines; ++c) {
            const float root = std::max(static_cast<float>(c), kFirst) / (kTailCosines - 1);
            const float cosine = root * root;
            const Share share = integrated(cosine, alpha);
            tail_[r * kTailCosines + c] = det::pow(share.grazing / share.white, 0.2f) - (1.0f - cosine);
        }
    }
    for (std::size_t r = 0; r < kMeans; ++r) {
        // 2 E(mu) mu dmu with mu = x^2: 4 E(x^2) x^3 dx.
        constexpr int kSteps = 256;
        const float roughness = static_cast<float>(r) / (kMeans - 1);
        double white = 0.0, grazing = 0.0, whole = 0.0;
        for (int i = 0; i < kSteps; ++i) {
            const float x = (static_cast<float>(i) + 0.5f) / kSteps;
            const Share share = towards(x * x, roughness);
            const auto weight = static_cast<double>(x * x * x);
            white += static_cast<double>(share.white) * weight;
            grazing += static_cast<double>(share.grazing) * weight;
            whole += weight;
        }
        means_[r] = {static_cast<float>(white / whole), static_cast<float>(grazing / whole)};
    }
}

GlossEnergy::Share GlossEnergy::towards(float cosine, float roughness) const {
    const float mu = std::clamp(cosine, 0.0f, 1.0f), alpha = alpha_of(std::clamp(roughness, 0.0f, 1.0f));
    const TablePlace y = place_in_table(roughness, kRoughnesses);
    const TablePlace x = place_in_table(std::sqrt(mu * (1.0f + alpha) / (mu + alpha)), kCosines);
    const TablePlace z = place_in_table(std::sqrt(mu), kTailCosines);
    const float white = between(white_.data(), kCosines, y, x);
    // The tail grows with alpha, as the square of roughness does from row to row.
    const auto row = static_cast<float>(y.cell);
    const TablePlace y_tail{y.cell, y.t * (2.0f * row + y.t) / (2.0f * row + 1.0f)};
    const float tail = between(tail_.data(), kTailCosines, y_tail, z);
    const float m = std::clamp(tail + (1.0f - mu), 0.0f, 1.0f);
    const float sure = std::min(white + kWhiteMargin, 1.0f);
    float steep = 1.0f - mu;  // to the 16th power
    for (int i = 0; i < 4; ++i) steep *= steep;
    const float margin = kGrazingMargin + kMostGrazingMargin * steep;
    return {sure, std::min(white * (m * m * m * m * m) + margin, sure)};
}

GlossEnergy::Share GlossEnergy::mean(float roughness) const {
    const TablePlace y = place_in_table(roughness, kMeans);
    const Share &a = means_[y.cell], &b = means_[y.cell + 1];
    return {blend(a.white, b.white, y.t), blend(a.grazing, b.grazing, y.t)};
}

}  // namespace gh::render
