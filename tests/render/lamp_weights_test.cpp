// What lamps may give at a place, against the plain formula, and alike on every instruction set and in any company.
#include "render/lamp_weights.h"

#include "base/random.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <hwy/highway.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <vector>

namespace gh {
namespace {

using render::LampWeights;
using Shines = LampWeights::Shines;

glm::vec3 place(Random& random) {
    return glm::vec3(random.unit(), random.unit(), random.unit()) * 6.0f - 3.0f;
}

struct Room {
    std::vector<LampWeights::Lamp> lamps;
    LampWeights weights{0};
};

Room random_room(Random& random, std::size_t count) {
    Room room{.lamps = {}, .weights = LampWeights(count)};
    for (std::uint32_t i = 0; i < count; ++i) {
        const auto shines = static_cast<Shines>(i % 4);
        LampWeights::Lamp lamp{.centre = place(random),
                               .axis = glm::normalize(place(random)),
                               .extent = 0.3f * random.unit(),
                               .power = shines == Shines::Beam ? 1.0f : 50.0f * random.unit(),
                               .cos_outer = shines == Shines::Beam ? 2.0f * random.unit() - 1.0f : -2.0f,
                               .shines = shines};
        if (i % 11 == 10) lamp.power = 0.0f;
        room.weights.set(i, lamp);
        room.lamps.push_back(lamp);
    }
    return room;
}

// As the header describes it: power by the square of the distance, times both cosines, neither quite 0.
double expected(const LampWeights::Lamp& lamp, const render::LightQuery& query) {
    const glm::dvec3 offset = glm::dvec3(lamp.centre) - glm::dvec3(query.position);
    const double distance = glm::length(offset);
    const auto share = [&](double height) { return std::clamp(height / distance, 0.05, 1.0); };
    double weight = static_cast<double>(lamp.power);
    if (query.normal != glm::vec3(0.0f)) {
        const double height = glm::dot(glm::dvec3(query.normal), offset) + static_cast<double>(lamp.extent);
        if (height <= 0.0) return 0.0;
        weight *= share(height);
    }
    const double facing = -glm::dot(glm::dvec3(lamp.axis), offset);
    if (lamp.shines == Shines::Beam)
        return facing / distance > static_cast<double>(lamp.cos_outer) ? weight : 0.0;
    if (lamp.shines == Shines::Front && facing <= 0.0) return 0.0;
    if (lamp.shines != Shines::All) weight *= share(std::abs(facing));
    const double kept_off = std::max(distance, static_cast<double>(lamp.extent));
    return weight / (kept_off * kept_off);
}

// A lamp that is never weighed is never asked, and one that is weighed wrongly is asked in vain.
TEST(LampWeights, FollowTheFormula) {
    Random random(7);
    const Room room = random_room(random, 64);
    int lit = 0;
    for (int i = 0; i < 200; ++i) {
        const render::LightQuery query{place(random),
                                       i % 5 == 0 ? glm::vec3(0.0f) : glm::normalize(place(random))};
        for (std::uint32_t lamp = 0; lamp < room.lamps.size(); ++lamp) {
            LampWeights::Weights weights;
            room.weights.at(query, {&lamp, 1}, weights);
            const double truth = expected(room.lamps[lamp], query);
            // A dozen roundings; a height near 0 is a difference of numbers of up to ten metres.
            EXPECT_NEAR(static_cast<double>(weights[0]), truth, 1e-5 * truth + 1e-6)
                << static_cast<int>(room.lamps[lamp].shines);
            lit += truth > 0.0;
        }
    }
    EXPECT_GT(lit, 200 * 16) << "most of the lamps give something somewhere";
}

TEST(LampWeights, AreTheSameInAnyCompany) {
    Random random(8);
    const Room room = random_room(random, 64);
    for (std::size_t count = 0; count <= LampWeights::kTogether; ++count) {
        const render::LightQuery query{place(random), glm::normalize(place(random))};
        std::vector<std::uint32_t> ids(count);
        for (std::uint32_t& id : ids) id = random.below(64);
        LampWeights::Weights together;
        together.fill(-1.0f);
        room.weights.at(query, ids, together);
        for (std::size_t i = 0; i < together.size(); ++i) {
            LampWeights::Weights alone{};
            if (i < count) room.weights.at(query, {&ids[i], 1}, alone);
            EXPECT_EQ(together[i], alone[0]) << i << " of " << count;
        }
    }
}

TEST(LampWeights, HaveTheSameBitsOnEveryInstructionSet) {
    Random random(9);
    const Room room = random_room(random, 64);
    std::array<std::uint32_t, LampWeights::kTogether> ids{};
    std::iota(ids.begin(), ids.end(), 20u);
    for (int i = 0; i < 200; ++i) {
        const render::LightQuery query{place(random), glm::normalize(place(random))};
        LampWeights::Weights first{};
        bool has_first = false;
        for (std::int64_t left = hwy::SupportedTargets() & HWY_TARGETS; left != 0; left &= left - 1) {
            hwy::SetSupportedTargetsForTest(left & -left);
            hwy::GetChosenTarget().Update(hwy::SupportedTargets());
            LampWeights::Weights weights{};
            room.weights.at(query, ids, weights);
            hwy::SetSupportedTargetsForTest(0);
            hwy::GetChosenTarget().Update(hwy::SupportedTargets());
            if (!has_first) first = weights;
            has_first = true;
            EXPECT_EQ(weights, first);
        }
    }
}

}  // namespace
}  // namespace gh
