// One of everything, read from a file whose every number is known (support/tiny_level.h).
#include "support/tiny_level.h"

#include "level_bytes.h"
#include "load/level_check.h"
#include "load/open_edges.h"
#include "world/layers.h"

#include <glm/geometric.hpp>
#include <gmock/gmock.h>

namespace gh {
namespace {

using test::expect_near;
using test::named;

class TinyLevel : public ::testing::Test {
  protected:
    void SetUp() override {
        Result<world::Level> loaded =
            load::load_level_from_memory(test::tiny_level_glb(), "tiny.glb", {}, {.fuses_parts = false});
        ASSERT_TRUE(loaded) << loaded.error().sentence;
        level = std::move(*loaded);
    }
    world::Level level;
};

TEST_F(TinyLevel, IsNamedAfterItsFileAndHashedFromItsBytes) {
    EXPECT_EQ(level.name, "tiny");
    const Result<world::Level> again = test::load_quickly(test::tiny_level_glb());
    ASSERT_TRUE(again);
    EXPECT_EQ(level.file_hash, again->file_hash);
    const Result<world::Level> other =
        test::load_quickly(test::with(test::tiny_level_glb(), "\"p1, p2\"", "\"p2, p1\""));
    ASSERT_TRUE(other);
    EXPECT_NE(level.file_hash, other->file_hash) << "a replay of the one must not run in the other";
}

TEST_F(TinyLevel, HasTheBoundsOfItsShellThoughTheGuardsBodyLiesFarOutside) {
    expect_near(level.bounds.min, {-4.0f, 0.0f, -3.0f});
    expect_near(level.bounds.max, {4.0f, 3.0f, 3.0f});
}

TEST_F(TinyLevel, ScalesAndPlacesItsPartsAsTheNodesSay) {
    const world::Part* wall = named(level.parts, "wall_left");
    ASSERT_NE(wall, nullptr);
    EXPECT_EQ(wall->mover, world::Mover::None);
    EXPECT_EQ(wall->layers & world::kEverything, world::kEverything);
    expect_near(wall->mover_from_part * glm::vec4(0.5f, -0.5f, 0.5f, 1.0f), {-0.6f, 0.0f, 0.1f});
}

TEST_F(TinyLevel, LetsSightButNotStonesThroughItsPane) {
    const world::Part* pane = named(level.parts, "pane");
    ASSERT_NE(pane, nullptr);
    EXPECT_EQ(pane->layers & world::kEverything, world::kEverything & ~world::Sight);
}

TEST_F(TinyLevel, TurnsTheDoorsLeafWithItsDoor) {
    ASSERT_EQ(level.doors.size(), 1u);
    const world::Door& door = level.doors[0];
    EXPECT_EQ(door.title, "Inner door");
    expect_near(door.hinge, {-0.6f, 0.0f, 0.0f});
    EXPECT_FLOAT_EQ(door.open_angle, 1.5707964f);
    EXPECT_FLOAT_EQ(door.open_ticks, 48.0f);
    expect_near(door.handle,
                {-0.6f + 0.9f * 1.2f, 1.05f, 0.0f});  // nine tenths of the leaf's width from the hinge
    const world::Part* leaf = named(level.parts, "leaf");
    ASSERT_NE(leaf, nullptr);
    EXPECT_EQ(leaf->mover, world::Mover::Door);
    EXPECT_EQ(leaf->mover_index, 0u);
    expect_near(leaf->mover_from_part[3], {0.6f, 1.05f, 0.0f});
}

TEST_F(TinyLevel, FitsABallToItsBulbAndAPaneToItsMirror) {
    const world::Lamp* bulb = named(level.lamps, "bulb");
    ASSERT_NE(bulb, nullptr);
    EXPECT_EQ(bulb->shape, world::LampShape::Sphere);
    EXPECT_NEAR(bulb->radius, 0.1f, 1e-6f);
    expect_near(bulb->position, {0.0f, 2.6f, 1.5f});
    expect_near(bulb->intensity, {100.0f, 50.0f, 25.0f});
    EXPECT_EQ(level.lamp_groups.at(bulb->group), "main");
    // It sends pi r^2 L = pi W/sr; at its range that is a thousandth of a watt a square metre.
    EXPECT_NEAR(3.14159265f / (bulb->range * bulb->range), 1e-3f, 1e-6f);

    ASSERT_EQ(level.mirrors.size(), 1u);
    const world::Mirror& mirror = level.mirrors[0];
    EXPECT_NEAR(mirror.turn_step, 0.39269908f, 1e-6f);
    EXPECT_NEAR(4.0f * glm::length(mirror.pane_half_u) * glm::length(mirror.pane_half_v), 1.6f, 1e-5f);
    expect_near(glm::normalize(glm::cross(mirror.pane_half_u, mirror.pane_half_v)), {0.0f, 0.0f, 1.0f});
    expect_near(mirror.world_from_rest * glm::vec3(0.0f, 0.0f, 1.0f), {-1.0f, 0.0f, 0.0f});
    EXPECT_EQ(level.parts.at(mirror.pane_part).name, "mirror");
}

TEST_F(TinyLevel, TakesLumensFromPunctualLightsAsBlenderPutThemIn) {
    const world::Lamp* lamp = named(level.lamps, "ceiling_light");
    ASSERT_NE(lamp, nullptr);
    EXPECT_EQ(lamp->shape, world::LampShape::Point);
    expect_near(lamp->intensity, {10.0f, 10.0f, 5.0f});  // 6830 cd are 10 W/sr
    EXPECT_EQ(lamp->group, world::kNoIndex);
}

TEST_F(TinyLevel, DressesItsGuardAndGivesHimHisWay) {
    ASSERT_EQ(level.guards.size(), 1u);
    const world::Guard& guard = level.guards[0];
    ASSERT_EQ(guard.patrol.size(), 2u);
    EXPECT_FLOAT_EQ(guard.patrol[0].wait_ticks, 60.0f);
    EXPECT_TRUE(guard.patrol[1].looks_round);
    ASSERT_EQ(level.models.size(), 1u);
    const world::Model& model = level.models[0];
    ASSERT_EQ(model.joints.size(), 2u);
    EXPECT_EQ(model.joints[0].name, "hips");
    EXPECT_EQ(model.joints[1].parent, 0u);
    EXPECT_EQ(model.head_joint, 1u);
    expect_near(model.joints[1].joint_from_mesh[3], {0.0f, -1.6f, 0.0f});
    EXPECT_EQ(model.clip[static_cast<std::size_t>(world::ClipId::Run)], world::kNoIndex);
    const world::Part* body = named(level.parts, "watchman");
    ASSERT_NE(body, nullptr);
    EXPECT_EQ(body->mover, world::Mover::Guard);
    EXPECT_EQ(body->mesh, model.mesh);
    EXPECT_EQ(body->layers & world::kEverything, world::Light)
        << "a body must not stop its own owner's look or step";
    EXPECT_EQ(named(level.parts, "body"), nullptr) << "a guard_model is never drawn where it stands";
}

TEST_F(TinyLevel, KeepsStonesForThrowing) {
    for (std::uint32_t i = 0; i < world::kMaxStones; ++i) {
        const world::Part& stone = level.parts.at(level.stone_part_begin + i);
        EXPECT_EQ(stone.mover, world::Mover::Stone);
        EXPECT_EQ(stone.mover_index, i);
    }
    EXPECT_EQ(load::find_open_edges(level.meshes[level.parts[level.stone_part_begin].mesh]).count, 0u);
}

TEST_F(TinyLevel, DecodesItsPicture) {
    ASSERT_EQ(level.textures.size(), 1u);
    EXPECT_EQ(level.textures[0].width, 4);
    ASSERT_EQ(level.textures[0].rgba.size(), 64u);
    EXPECT_EQ(level.textures[0].rgba[0], 200);
    EXPECT_EQ(level.textures[0].rgba[61], 180);
    EXPECT_EQ(level.textures[0].rgba[63], 255);
}

TEST_F(TinyLevel, IsFoundInOrder) {
    const load::LevelReport report = load::check_level(level);
    EXPECT_TRUE(report.errors.empty()) << report.errors.front();
    EXPECT_TRUE(report.warnings.empty()) << report.warnings.front();
}

// Misspelt, it would leave its default standing and say nothing.
TEST_F(TinyLevel, IsWarnedOfAPropertyThatNobodyReads) {
    const Result<world::Level> mistyped =
        test::load_quickly(test::with(test::tiny_level_glb(), "\"wait_s\"", "\"wait_z\""));
    ASSERT_TRUE(mistyped) << mistyped.error().sentence;
    EXPECT_THAT(
        load::check_level(*mistyped).warnings,
        ::testing::ElementsAre("node 'p1': the property 'wait_z' is none of a patrol, and nobody reads it"));
}

}  // namespace
}  // namespace gh
