// Boxes forgive what the triangle test may err by, and hardly more: so here are the rays that need all of it. They start a
// hair from planks ten metres long and run at their edges: a plank's far corners are rounded in shares of its length,
// which decides the hit, while origin and way are millimetres. Whatever would be met with no tree at all has to be met.
#include "support/brute_force.h"
#include "support/isas.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace {

using test::Mesh;
using test::Random;

struct Plank {
    std::size_t along, across, flat;  // axes
    glm::vec3 low, high;              // equal on axis `flat`
};

// One after another along an axis, near it, so that coordinates on the two others are small and forgive little.
std::vector<Plank> make_planks(Random& random, std::size_t along, float off, float width) {
    std::vector<Plank> planks;
    for (int i = 0; i < 24; ++i) {
        Plank plank{along, (along + 1) % 3, (along + 2) % 3, off * random.in_cube(1.0f), {}};
        if (i % 2 == 1) std::swap(plank.across, plank.flat);
        plank.low[along] = 12.0f * float(i) - 150.0f;
        plank.high = plank.low;
        plank.high[along] += 10.0f;
        plank.high[plank.across] += width;
        planks.push_back(plank);
    }
    return planks;
}

void add_to(Mesh& mesh, const Plank& plank) {
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    for (const auto& [far, wide] : {std::array{false, false}, {true, false}, {true, true}, {false, true}}) {
        glm::vec3 corner = plank.low;
        if (far) corner[plank.along] = plank.high[plank.along];
        if (wide) corner[plank.across] = plank.high[plank.across];
        mesh.positions.push_back(corner);
    }
    mesh.triangles.emplace_back(first, first + 1, first + 2);
    mesh.triangles.emplace_back(first, first + 2, first + 3);
}

// From within `reach` of a point of one of the plank's long edges, at it or past it by a hair.
rc::Ray ray_at_edge(Random& random, const Plank& plank, float reach) {
    glm::vec3 target = plank.low;
    target[plank.along] += random.unit() * 10.0f;
    if (random.below(2) == 0) target[plank.across] = plank.high[plank.across];
    glm::vec3 way = random.direction();
    if (random.below(2) == 0)
        way[plank.along] = random.below(2) == 0 ? 2.0f : -2.0f;  // mostly along the plank
    if (random.below(4) == 0) way[plank.flat] *= std::exp2(random.between(-12.0f, 0.0f));
    const glm::vec3 origin = target - reach * std::exp2(random.between(-8.0f, 0.0f)) * way;
    glm::vec3 direction = target - origin;
    direction[plank.across] *= 1.0f + random.between(-1.0f, 1.0f) * std::exp2(random.between(-24.0f, -8.0f));
    return {.origin = origin, .direction = direction};
}

// From next to the world's origin, where a box forgives nothing for coordinates, at an edge of a plank far away.
rc::Ray ray_from_zero(Random& random, const Plank& plank) {
    glm::vec3 target = plank.low;
    target[plank.along] += random.unit() * (plank.high[plank.along] - plank.low[plank.along]);
    if (random.below(2) == 0) target[plank.across] = plank.high[plank.across];
    const glm::vec3 origin = 1e-6f * random.in_cube(1.0f);
    return {.origin = origin, .direction = target - origin};
}

class SharpBoxes : public ::testing::TestWithParam<rc::Isa> {};

TEST_P(SharpBoxes, HoldWhatIsMetAtTheEdgesOfLongPlanks) {
    const test::IsaScope scope(GetParam());
    Random random(2026);
    for (const float reach : {1e-4f, 1e-2f, 1.0f}) {
        for (std::size_t along = 0; along < 3; ++along) {
            const std::vector<Plank> planks = make_planks(random, along, 0.1f * reach, 4.0f * reach);
            Mesh mesh;
            for (const Plank& plank : planks) add_to(mesh, plank);
            test::TestScene scene(along == 0 ? rc::BuildQuality::High : rc::BuildQuality::Default);
            scene.add(mesh);
            scene.commit();
            int hits = 0, wrong = 0;
            for (int i = 0; i < 8000; ++i) {
                const rc::Ray ray = ray_at_edge(random, planks[random.below(24)], reach);
                const auto truth = scene.closest(ray);
                const auto found = rc::closest_hit(scene.scene(), ray, rc::kAllLayers);
                hits += truth.has_value();
                wrong +=
                    truth.has_value() != found.has_value() || (truth && !test::same_bits(*truth, *found));
                wrong += rc::any_hit(scene.scene(), ray, rc::kAllLayers) != truth.has_value();
            }
            EXPECT_GT(hits, 2000);
            EXPECT_LT(hits, 7000);
            EXPECT_EQ(wrong, 0) << "of " << hits << ", from " << reach << " m, along axis " << along;
        }
    }
}

TEST_P(SharpBoxes, HoldWhatIsMetFarFromAnOriginNextToZero) {
    const test::IsaScope scope(GetParam());
    Random random(2027);
    Mesh mesh;
    std::vector<Plank> planks;
    for (std::size_t i = 0; i < 60; ++i) {
        const std::size_t along = random.below(3), across = (along + 1 + random.below(2)) % 3;
        Plank plank{along, across, 3 - along - across, 1000.0f * random.direction(), {}};
        plank.high = plank.low;
        plank.high[along] += 1.0f;
        plank.high[across] += 0.1f;
        planks.push_back(plank);
        add_to(mesh, plank);
    }
    test::TestScene scene;
    scene.add(mesh);
    scene.commit();
    int hits = 0, wrong = 0;
    std::vector<rc::Ray> rays(64);  // at one plank all: they walk as a packet
    std::vector<rc::Hit> together(rays.size());
    for (int i = 0; i < 300; ++i) {
        const Plank& plank = planks[random.below(60)];
        for (rc::Ray& ray : rays) ray = ray_from_zero(random, plank);
        rc::closest_hits(scene.scene(), rays, rc::kAllLayers, together);
        for (std::size_t k = 0; k < rays.size(); ++k) {
            const rc::Hit truth = scene.closest(rays[k]).value_or(rc::Hit{});
            const auto alone = rc::closest_hit(scene.scene(), rays[k], rc::kAllLayers);
            hits += !truth.is_miss();
            wrong += !test::same_bits(truth, alone.value_or(rc::Hit{}));
            wrong += !test::same_bits(truth, together[k]);
        }
    }
    EXPECT_GT(hits, 5000);
    EXPECT_LT(hits, 18000);
    EXPECT_EQ(wrong, 0) << "of " << hits;
}

INSTANTIATE_TEST_SUITE_P(EveryIsa, SharpBoxes, ::testing::ValuesIn(test::supported_isas()),
                         test::isa_test_name);

}  // namespace
