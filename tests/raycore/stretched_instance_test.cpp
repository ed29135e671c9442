// A sheet stretched a thousandfold across itself and turned: what its frame makes of a ray may be as far off as a
// thousand roundings of the ray's own coordinates, and boxes above it must forgive that.
#include "support/brute_force.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <cmath>

namespace {

using test::Random;

struct Turn {
    glm::dvec3 x, y, z;  // rows
};

Turn random_turn(Random& random) {
    const glm::dvec3 x = glm::normalize(glm::dvec3(random.direction()));
    const glm::dvec3 y = glm::normalize(glm::cross(x, glm::dvec3(random.direction())));
    return {x, y, glm::cross(x, y)};
}

// The world's x is a thousand times the frame's along turn.x; the sheet lies where that is 0.
void add_sheet(test::TestScene& scene, Random& random, const glm::vec3& at, float stretch) {
    const Turn turn = random_turn(random);
    test::Mesh sheet = test::make_sheet(1.0f, 0.0f, 3);
    for (glm::vec3& p : sheet.positions)
        p = glm::vec3(turn.y * static_cast<double>(p.x) + turn.z * static_cast<double>(p.z));
    glm::mat4x3 place(1.0f);
    for (glm::length_t c = 0; c < 3; ++c)
        place[c] = glm::vec3(glm::dvec3(static_cast<double>(stretch) * turn.x[c], turn.y[c], turn.z[c]));
    place[3] = at;
    scene.add(sheet, place);
}

// Along the sheets, a hair above and below them, and at their edges.
rc::Ray grazing_ray(Random& random, const glm::vec3& at, float far) {
    const float off = (random.below(2) != 0 ? 1.0f : -1.0f) * std::exp2(random.between(-24.0f, -4.0f));
    const glm::vec3 target = at + glm::vec3(random.below(2) != 0 ? off : 0.0f, random.between(-1.1f, 1.1f),
                                            random.between(-1.1f, 1.1f));
    const glm::vec3 way(random.between(-1.0f, 1.0f) * std::exp2(random.between(-24.0f, -2.0f)),
                        random.between(-1, 1), random.between(-1, 1));
    return {.origin = target - way * far, .direction = way};
}

TEST(StretchedInstance, IsNeverCulledWhereItsOwnFrameSaysHit) {
    for (const float stretch : {1.0f, 100.0f, 1000.0f}) {
        for (const float distance : {0.0f, 30.0f, 1000.0f}) {
            Random random(99);
            test::TestScene scene;
            std::vector<glm::vec3> places;
            for (int i = 0; i < 8; ++i) {
                places.push_back(glm::vec3(distance) + random.in_cube(4.0f));
                add_sheet(scene, random, places.back(), stretch);
            }
            scene.commit();
            int hits = 0, wrong = 0;
            for (int i = 0; i < 6000; ++i) {
                const rc::Ray ray = grazing_ray(random, places[random.below(8)], random.between(0.5f, 20.0f));
                const auto truth = scene.closest(ray);
                const auto found = rc::closest_hit(scene.scene(), ray, rc::kAllLayers);
                hits += truth.has_value();
                wrong +=
                    truth.has_value() != found.has_value() || (truth && !test::same_bits(*truth, *found));
            }
            EXPECT_GT(hits, 100);
            EXPECT_EQ(wrong, 0) << "of " << hits << ", stretched " << stretch << " times at " << distance
                                << " m";
        }
    }
}

}  // namespace
