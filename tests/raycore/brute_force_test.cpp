// Every query of every ISA, single and in batches, against the specification applied to every triangle.
#include "support/brute_force.h"

#include "support/isas.h"

#include "raycore/query.h"

#include <gtest/gtest.h>

namespace {

using test::Mesh;
using test::Random;
using test::TestScene;

// A room's worth of everything: soup, closed balls, sheets seen edge-on, mirrored, squeezed and sheared instances.
TestScene make_museum(Random& random) {
    TestScene scene;
    scene.add(test::make_soup(random, 300, 4.0f, 1.2f));
    scene.add(test::make_ball(glm::vec3(0.0f), 1.0f, 4), glm::mat4x3(1, 0, 0, 0, 1, 0, 0, 0, 1, 2, 0, -1), 1);
    scene.add_instance_of_last(glm::mat4x3(-1, 0, 0, 0, 1, 0, 0, 0, 1, -2, 0.5f, 0), 2);
    scene.add_instance_of_last(glm::mat4x3(0.1f, 0, 0, 0, 3, 0.5f, 0.2f, 0, 1, 0, 1, 2), 4);
    scene.add(test::make_sheet(5.0f, -2.0f, 6));
    scene.add(test::make_box(glm::vec3(-6.0f), glm::vec3(6.0f)), glm::mat4x3(1.0f), 8);
    scene.add_instance_of_last(glm::mat4x3(0.0f));  // singular: never met
    scene.commit();
    return scene;
}

// Some rays anywhere, some along axes, some exactly from vertex to vertex, some short, some at a layer of their own.
rc::Ray make_ray(Random& random, const Mesh& targets) {
    rc::Ray ray{.origin = random.in_cube(5.0f), .direction = random.direction()};
    const auto target = [&] {
        return targets.positions[random.below(static_cast<std::uint32_t>(targets.positions.size()))];
    };
    switch (random.below(6)) {
        case 0:
            ray.direction = {random.below(2) ? 0.0f : -0.0f, -1.0f, random.below(2) ? 0.0f : -0.0f};
            break;
        case 1:
            ray.direction = target() - ray.origin;
            break;
        case 2:
            ray.origin = target();
            ray.direction = target() - ray.origin;
            if (ray.direction == glm::vec3(0.0f)) ray.direction.x = 1.0f;
            break;
        case 3:
            ray.t_max = random.between(0.0f, 6.0f);
            break;
        case 4:
            ray.t_min = random.between(-3.0f, 3.0f);
            break;
        default:
            break;
    }
    return ray;
}

class BruteForce : public ::testing::TestWithParam<rc::Isa> {
  protected:
    test::IsaScope isa_{GetParam()};
};

TEST_P(BruteForce, ClosestAnyAndCrossingsAgreeInEveryBit) {
    Random random(7);
    const TestScene scene = make_museum(random);
    Mesh targets = test::make_sheet(5.0f, -2.0f, 6);
    test::append(targets, test::make_ball({2, 0, -1}, 1.0f, 4));
    test::append(targets, test::make_box(glm::vec3(-6.0f), glm::vec3(6.0f)));
    int hit_count = 0;
    for (int i = 0; i < 3000; ++i) {
        rc::Ray ray = make_ray(random, targets);
        const rc::LayerMask layers = i % 5 == 0 ? 1u << random.below(4) : rc::kAllLayers;
        const std::vector<rc::Hit> expected = scene.all_hits(ray, layers);
        const std::optional<rc::Hit> closest = rc::closest_hit(scene.scene(), ray, layers);
        ASSERT_EQ(closest.has_value(), !expected.empty()) << "ray " << i;
        if (closest) {
            ASSERT_TRUE(test::same_bits(*closest, expected.front())) << "ray " << i;
        }
        ASSERT_EQ(rc::any_hit(scene.scene(), ray, layers), !expected.empty()) << "ray " << i;
        hit_count += !expected.empty();

        if (!expected.empty()) {  // the surface a ray starts on is as if it were not there
            ray.skip_instance = expected.front().instance;
            ray.skip_primitive = expected.front().primitive;
            const std::optional<rc::Hit> next = rc::closest_hit(scene.scene(), ray, layers);
            ASSERT_EQ(next.has_value(), expected.size() > 1) << "ray " << i;
            if (next) {
                ASSERT_TRUE(test::same_bits(*next, expected[1])) << "ray " << i;
            }
        }
    }
    EXPECT_GT(hit_count, 2000);
}

TEST_P(BruteForce, CrossingsAreTheFirstSoManyOfAllHits) {
    Random random(8);
    const TestScene scene = make_museum(random);
    std::size_t most = 0;
    for (int i = 0; i < 600; ++i) {
        const glm::vec3 from = random.in_cube(7.0f), to = random.in_cube(7.0f);
        const rc::Ray ray{.origin = from, .direction = to - from, .t_min = 0.0f, .t_max = 1.0f};
        const std::vector<rc::Hit> expected = scene.all_hits(ray);
        most = std::max(most, expected.size());
        for (const std::size_t capacity : {0u, 1u, 3u, 64u}) {
            std::vector<rc::Hit> out(capacity);
            const std::size_t n = rc::crossings(scene.scene(), from, to, rc::kAllLayers, out);
            ASSERT_EQ(n, std::min(capacity, expected.size()));
            for (std::size_t k = 0; k < n; ++k)
                ASSERT_TRUE(test::same_bits(out[k], expected[k])) << i << " " << k;
        }
    }
    EXPECT_GT(most, 8u);
}

TEST_P(BruteForce, ABatchAnswersAsItsRaysAlone) {
    Random random(9);
    const TestScene scene = make_museum(random);
    const Mesh targets = test::make_sheet(5.0f, -2.0f, 6);
    for (const std::size_t size : {1u, 2u, 7u, 8u, 64u, 1000u}) {
        std::vector<rc::Ray> rays;
        std::vector<rc::Segment> segments;
        for (std::size_t i = 0; i < size; ++i) {
            rays.push_back(make_ray(random, targets));
            segments.push_back({random.in_cube(7.0f), random.in_cube(7.0f)});
        }
        std::vector<rc::Hit> hits(size), all(size * 4);
        std::vector<std::uint8_t> is_hit(size);
        std::vector<std::uint32_t> counts(size);
        rc::Counters counters;
        rc::closest_hits(scene.scene(), rays, rc::kAllLayers, hits, &counters);
        EXPECT_EQ(counters.rays, size);
        EXPECT_GE(counters.nodes, size);
        rc::any_hits(scene.scene(), rays, rc::kAllLayers, is_hit);
        rc::crossings(scene.scene(), segments, rc::kAllLayers, 4, all, counts);
        for (std::size_t i = 0; i < size; ++i) {
            const auto single = rc::closest_hit(scene.scene(), rays[i], rc::kAllLayers);
            ASSERT_TRUE(test::same_bits(hits[i], single.value_or(rc::Hit{}))) << size << " " << i;
            ASSERT_EQ(is_hit[i] != 0, single.has_value()) << size << " " << i;
            rc::Hit alone[4];
            ASSERT_EQ(counts[i],
                      rc::crossings(scene.scene(), segments[i].from, segments[i].to, rc::kAllLayers, alone));
            for (std::uint32_t k = 0; k < counts[i]; ++k)
                ASSERT_TRUE(test::same_bits(all[i * 4 + k], alone[k]));
        }
    }
}

INSTANTIATE_TEST_SUITE_P(EveryIsa, BruteForce, ::testing::ValuesIn(test::supported_isas()),
                         test::isa_test_name);

}  // namespace
