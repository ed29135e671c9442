// Doors, mirrors and guards stand where trigonometry says: prompts, feet and rays all rely on it.
#include "spatial/transforms.h"

#include "base/det_math.h"
#include "spatial/stage.h"
#include "support/small_level.h"

#include "raycore/query.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

namespace gh::spatial {
namespace {

void expect_near(const glm::vec3& a, const glm::vec3& b, float tolerance) {
    EXPECT_NEAR(a.x, b.x, tolerance);
    EXPECT_NEAR(a.y, b.y, tolerance);
    EXPECT_NEAR(a.z, b.z, tolerance);
}

//        z=0 plane, seen from above          A ray down -z at x = d meets the leaf where it has turned to:
//   hinge +------------> x  (closed)         the leaf runs along (cos a, -sin a), so z = -d tan a there.
TEST(Transforms, ADoorAtAnAngleMeetsRaysWhereTrigonometrySays) {
    test::SmallLevel small;
    const std::uint32_t oak = small.add_material(world::Surface::Oak);
    const std::uint32_t leaf =
        small.add_sheet({0.5f, 1.0f, 0.0f}, {0.5f, 0.0f, 0.0f}, {0.0f, 1.0f, 0.0f}, oak);
    const glm::vec3 hinge(3.0f, 0.5f, -2.0f);
    small.hang_door(leaf, hinge);
    Stage stage(std::make_shared<world::Level>(small.level));

    world::State state;
    for (const float angle : {0.0f, 0.3f, 0.9f, -0.7f, 1.4f}) {
        state.doors[0].angle = angle;
        const world::Snapshot now = stage.commit(state);
        const double across =
            0.9 * std::cos(static_cast<double>(angle));  // a tenth of the leaf lies beyond this
        for (const double d : {0.1 * across, 0.5 * across, 0.99 * across, 1.2 * across}) {
            const rc::Ray ray{.origin = hinge + glm::vec3(static_cast<float>(d), 1.0f, 7.0f),
                              .direction = {0.0f, 0.0f, -1.0f}};
            const auto hit = rc::closest_hit(*now.scene, ray, world::Solid);
            if (d > std::cos(static_cast<double>(angle))) {
                EXPECT_FALSE(hit) << "past the leaf's edge, angle " << angle;
            } else {
                ASSERT_TRUE(hit) << "angle " << angle << ", d " << d;
                EXPECT_NEAR(hit->t, 7.0 + d * std::tan(static_cast<double>(angle)), 1e-5 * 7.0);
            }
        }
    }
}

TEST(Transforms, AHandleIsWhereTheLeafCarriesIt) {
    test::SmallLevel small;
    const std::uint32_t oak = small.add_material(world::Surface::Oak);
    const std::uint32_t leaf =
        small.add_sheet({0.5f, 1.0f, 0.0f}, {0.5f, 0.0f, 0.0f}, {0.0f, 1.0f, 0.0f}, oak);
    small.hang_door(leaf, {1.0f, 0.0f, 1.0f});
    world::Door& door = small.level.doors[0];
    door.world_from_rest = rotation_about({0.0f, 1.0f, 0.0f}, kPi);  // hung so that it runs along -x
    door.handle = {0.1f, 1.0f, 1.0f};                                // 0.9 m from the hinge
    world::State state;
    expect_near(door_handle(small.level, state, 0), door.handle, 1e-6f);
    state.doors[0].angle = kPi / 2.0f;  // -x turned left by a quarter is +z
    expect_near(door_handle(small.level, state, 0), {1.0f, 1.0f, 1.9f}, 1e-6f);
}

TEST(Transforms, AGlassLidOpensAboutItsOwnXAxis) {
    test::SmallLevel small;
    const std::uint32_t glass = small.add_material(world::Surface::Glass);
    const std::uint32_t lid =
        small.add_sheet({0.0f, 0.0f, -0.5f}, {0.5f, 0.0f, 0.0f}, {0.0f, 0.0f, 0.5f}, glass);
    small.hang_door(lid, {0.0f, 1.0f, 0.0f});
    small.level.doors[0].axis = {1.0f, 0.0f, 0.0f};
    world::State state;
    state.doors[0].angle = kPi / 2.0f;
    // About +x, -z turns up to +y.
    expect_near(point_through(world_from_part(small.level, state, lid), {0.0f, 0.0f, -1.0f}),
                {0.0f, 2.0f, 0.0f}, 1e-6f);
}

TEST(Transforms, AGuardFacesItsYaw) {
    world::State state;
    state.guards[2].position = {5.0f, 0.25f, -3.0f};
    state.guards[2].yaw = kPi / 2.0f;  // a quarter to the left of -z is -x
    const glm::mat4x3 world_from_body = world_from_guard(state, 2);
    expect_near(vector_through(world_from_body, {0.0f, 0.0f, -1.0f}), {-1.0f, 0.0f, 0.0f}, 1e-6f);
    expect_near(point_through(world_from_body, {0.0f, 1.0f, 0.0f}), {5.0f, 1.25f, -3.0f}, 1e-6f);
}

TEST(Transforms, AMirrorPaneTurnsWithItsMirror) {
    test::SmallLevel small;
    world::Mirror mirror;
    mirror.pivot = {2.0f, 1.0f, 0.0f};
    mirror.pane_centre = {0.0f, 0.0f, 0.05f};
    mirror.pane_half_u = {0.4f, 0.0f, 0.0f};
    mirror.pane_half_v = {0.0f, 0.8f, 0.0f};
    small.level.mirrors.push_back(mirror);
    world::State state;
    expect_near(mirror_pane(small.level, state, 0).normal, {0.0f, 0.0f, 1.0f}, 1e-6f);
    state.mirrors[0].angle = kPi / 4.0f;
    const world::MirrorPane pane = mirror_pane(small.level, state, 0);
    const float s = std::sqrt(0.5f);
    expect_near(pane.normal, {s, 0.0f, s}, 1e-6f);
    expect_near(pane.centre, {2.0f + 0.05f * s, 1.0f, 0.05f * s}, 1e-6f);
    expect_near(pane.half_u, {0.4f * s, 0.0f, -0.4f * s}, 1e-6f);
}

TEST(Transforms, AnInverseLeadsBackThroughUnevenScalesAndMirroring) {
    glm::mat4x3 m = rigid(rotation_about(glm::vec3(0.6f, 0.0f, 0.8f), 1.1f), {3.0f, -2.0f, 7.0f});
    m[0] *= 2.0f;
    m[1] *= -0.25f;
    const glm::mat4x3 there_and_back = chain(inverse_of(m), m);
    expect_near(point_through(there_and_back, {1.0f, 2.0f, 3.0f}), {1.0f, 2.0f, 3.0f}, 2e-6f);
    expect_near(vector_through(there_and_back, {-4.0f, 0.5f, 1.0f}), {-4.0f, 0.5f, 1.0f}, 2e-6f);
}

}  // namespace
}  // namespace gh::spatial
