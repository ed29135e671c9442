// A thing modelled far from its own origin and brought back by its instance: in its frame a ray is known to a centimetre,
// while the ray itself and the box that is asked for it in the world are known to a micrometre. The box has to forgive.
#include "support/brute_force.h"

#include <gtest/gtest.h>

#include <cmath>

namespace {

using test::Random;

// A sheet across x, modelled at x = `far` and stretched along x, which stands at `at` in the world.
void add_sheet(test::TestScene& scene, const glm::vec3& at, float far, float stretch) {
    test::Mesh sheet = test::make_sheet(1.0f, 0.0f, 3);
    for (glm::vec3& p : sheet.positions) p = {far, p.x, p.z};
    glm::mat4x3 place(1.0f);
    place[0].x = stretch;
    place[3] = at - glm::vec3(far * stretch, 0.0f, 0.0f);
    scene.add(sheet, place);
}

// Along the sheet, a hair beside it, and at its edges.
rc::Ray grazing_ray(Random& random, const glm::vec3& at) {
    const float off = random.between(-1.0f, 1.0f) * std::exp2(random.between(-24.0f, -4.0f));
    const glm::vec3 target = at + glm::vec3(off, random.between(-1.2f, 1.2f), random.between(-1.2f, 1.2f));
    const float slope = random.between(-1.0f, 1.0f) * std::exp2(random.between(-20.0f, -2.0f));
    const glm::vec3 way(slope, random.between(-1.0f, 1.0f), random.between(-1.0f, 1.0f));
    return {.origin = target - way * random.between(0.5f, 8.0f), .direction = way};
}

TEST(FarModel, IsNeverCulledWhereItsOwnFrameSaysHit) {
    for (const float far : {0.0f, 300.0f, 1e5f}) {
        for (const float stretch : {1.0f, 64.0f}) {
            Random random(99);
            test::TestScene scene;
            std::vector<glm::vec3> places;
            for (int i = 0; i < 8; ++i) {
                places.push_back(random.in_cube(4.0f));
                add_sheet(scene, places.back(), far, stretch);
            }
            scene.commit();
            int hits = 0, wrong = 0;
            for (int i = 0; i < 6000; ++i) {
                const rc::Ray ray = grazing_ray(random, places[random.below(8)]);
                const auto truth = scene.closest(ray);
                const auto found = rc::closest_hit(scene.scene(), ray, rc::kAllLayers);
                hits += truth.has_value();
                wrong +=
                    truth.has_value() != found.has_value() || (truth && !test::same_bits(*truth, *found));
            }
            EXPECT_GT(hits, 300);
            EXPECT_EQ(wrong, 0) << "of " << hits << ", modelled at " << far << ", stretched " << stretch
                                << " times";
        }
    }
}

}  // namespace
