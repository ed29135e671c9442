// The eight grid points' weights, against the plain formula in double precision, and alike on every instruction set.
#include "render/probe_weights.h"

#include "base/random.h"
#include "render/octahedron.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <hwy/highway.h>

#include <array>
#include <cmath>
#include <vector>

namespace gh {
namespace {

struct Case {
    std::vector<float> moments;
    std::array<std::uint32_t, 8> point{};
    std::array<float, 8> plain{};
    glm::vec3 from{0.0f}, low{0.0f}, spacing{0.0f}, normal{0.0f};

    [[nodiscard]] render::ProbeQuery query() const {
        return {.moments = moments.data(),
                .point = point.data(),
                .plain = plain.data(),
                .from = {from.x, from.y, from.z},
                .low = {low.x, low.y, low.z},
                .spacing = {spacing.x, spacing.y, spacing.z},
                .normal = {normal.x, normal.y, normal.z}};
    }
};

Case random_case(Random& random) {
    Case c;
    constexpr std::size_t kPoints = 11;
    for (std::size_t i = 0; i < kPoints * render::kSightMoments / 2; ++i) {
        const float mean = 0.2f + 2.0f * random.unit();
        c.moments.push_back(mean);
        c.moments.push_back(mean * mean * (1.0f + 0.5f * random.unit()));
    }
    const auto place = [&] { return glm::vec3(random.unit(), random.unit(), random.unit()); };
    c.low = place() * 20.0f - 10.0f;
    c.spacing = place() + 0.7f;
    c.from = c.low + c.spacing * place();
    c.normal = glm::normalize(place() - 0.5f);
    for (std::size_t i = 0; i < 8; ++i) {
        c.point[i] = random.below(kPoints);
        c.plain[i] = random.unit();
    }
    return c;
}

// As the header describes it.
double expected(const Case& c, std::size_t i) {
    const glm::vec3 step(i & 1, i >> 1 & 1, i >> 2);
    const glm::vec3 offset = c.from - c.low - c.spacing * step;
    const double distance = static_cast<double>(glm::length(offset));
    const glm::vec3 way = glm::normalize(offset);
    const auto texels = render::octahedral_texels(way, render::kSightSide);
    double mean = 0.0, square = 0.0;
    for (std::size_t k = 0; k < 4; ++k) {
        const std::size_t at = c.point[i] * render::kSightMoments + 2 * texels.index[k];
        mean += static_cast<double>(c.moments[at] * texels.weight[k]);
        square += static_cast<double>(c.moments[at + 1] * texels.weight[k]);
    }
    double share = 1.0;
    if (distance > mean) {
        const double variance = std::max(square - mean * mean, 1e-4 * square);
        const double bound = variance / (variance + (distance - mean) * (distance - mean));
        share = std::pow(std::max(0.0, bound - 0.2) / 0.8, 3.0);
    }
    const double before = 0.5 - 0.5 * static_cast<double>(glm::dot(way, c.normal));
    return static_cast<double>(c.plain[i]) * (before * before + 0.05) * share;
}

TEST(ProbeWeights, AreTheFormulaOnEveryInstructionSetInEveryBit) {
    Random random(7);
    for (int round = 0; round < 300; ++round) {
        const Case c = random_case(random);
        std::array<float, 8> first{};
        bool has_first = false;
        for (std::int64_t left = hwy::SupportedTargets() & HWY_TARGETS; left != 0; left &= left - 1) {
            hwy::SetSupportedTargetsForTest(left & -left);
            hwy::GetChosenTarget().Update(hwy::SupportedTargets());
            std::array<float, 8> weight{};
            render::weigh_probes(c.query(), weight.data());
            hwy::SetSupportedTargetsForTest(0);
            hwy::GetChosenTarget().Update(hwy::SupportedTargets());
            if (!has_first) {
                first = weight;
                has_first = true;
                // The cube triples a few roundings of numbers near one, divided by .8.
                for (std::size_t i = 0; i < 8; ++i)
                    EXPECT_NEAR(static_cast<double>(weight[i]), expected(c, i), 3e-5);
            }
            EXPECT_EQ(weight, first);
        }
    }
}

}  // namespace
}  // namespace gh
