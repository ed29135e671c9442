// Furniture fused into one part must be met where it stood, by whoever asks, with its own materials.
#include "load/fuse_parts.h"

#include "level_bytes.h"
#include "support/rest_scene.h"
#include "world/layers.h"

#include "raycore/query.h"

#include <glm/geometric.hpp>

#include <cmath>

namespace gh {
namespace {

world::Level tiny(bool fuses) {
    Result<world::Level> level = load::load_level_from_memory(test::tiny_level_glb(), "tiny.glb", {},
                                                              {.finds_ways = false, .fuses_parts = fuses});
    EXPECT_TRUE(level);
    return *std::move(level);
}

TEST(FuseParts, ARayMeetsTheSameMaterialAtTheSameDistance) {
    const world::Level apart = tiny(false), fused = tiny(true);
    EXPECT_LT(fused.parts.size(), apart.parts.size());
    const auto before = test::rest_scene(apart), after = test::rest_scene(fused);
    int hits = 0;
    for (int i = 0; i < 4000; ++i) {
        // Golden-angle directions from four places in both rooms.
        const float z = 1.0f - (static_cast<float>(i) + 0.5f) / 2000.0f,
                    angle = 2.3999632f * static_cast<float>(i);
        const float flat = std::sqrt(std::max(0.0f, 1.0f - z * z));
        const glm::vec3 from((i & 1) != 0 ? 2.1f : -2.3f, 1.4f, (i & 2) != 0 ? 1.7f : -1.6f);
        const rc::Ray ray{.origin = from, .direction = {flat * std::cos(angle), z, flat * std::sin(angle)}};
        for (const rc::LayerMask layers : {world::Light, world::Sight, world::Sound, world::Solid}) {
            const auto a = rc::closest_hit(*before, ray, layers), b = rc::closest_hit(*after, ray, layers);
            ASSERT_EQ(a.has_value(), b.has_value()) << i;
            if (!a) continue;
            ++hits;
            // Corners are rounded into the world frame: 2^-24 of four metres, seen at grazing angles too.
            ASSERT_NEAR(a->t, b->t, 1e-4f) << i;
            const auto material = [](const world::Level& level, const rc::Hit& hit) {
                const world::Mesh& mesh = level.meshes[level.parts[hit.instance].mesh];
                return level.materials[mesh.materials[hit.primitive]].name;
            };
            EXPECT_EQ(material(apart, *a), material(fused, *b)) << i;
        }
    }
    EXPECT_GT(hits, 8000);
}

TEST(FuseParts, WhatMovesShinesOrIsAskedForKeepsItsOwnPart) {
    const world::Level level = tiny(true);
    for (const world::Lamp& lamp : level.lamps) {
        if (lamp.part == world::kNoIndex) continue;
        EXPECT_NE(level.parts[lamp.part].name, "still");
    }
    for (const world::Mirror& mirror : level.mirrors) {
        if (mirror.pane_part == world::kNoIndex) continue;
        EXPECT_NE(level.parts[mirror.pane_part].name, "still");
    }
    ASSERT_LE(level.stone_part_begin + world::kMaxStones, level.parts.size());
    for (std::uint32_t i = 0; i < world::kMaxStones; ++i) {
        EXPECT_EQ(level.parts[level.stone_part_begin + i].mover, world::Mover::Stone);
        EXPECT_EQ(level.parts[level.stone_part_begin + i].mover_index, i);
    }
    for (const world::Model& model : level.models) {
        ASSERT_LT(model.mesh, level.meshes.size());
        EXPECT_FALSE(level.meshes[model.mesh].joints.empty());
    }
}

// At a hundred kilometres a float counts in centimetres: there every part keeps its own frame.
TEST(FuseParts, ALevelFarAwayIsLeftAsItIs) {
    world::Level level = tiny(false);
    const std::size_t parts = level.parts.size();
    level.bounds.max.x += 1e5f;
    load::fuse_still_parts(level);
    EXPECT_EQ(level.parts.size(), parts);
}

// A mirrored chair is a chair: its normals still look outwards, and so do its triangles.
TEST(FuseParts, MirroredPartsKeepTheirOutside) {
    world::Level level = tiny(false);
    for (world::Part& part : level.parts) {
        if (part.name == "wall_left") part.mover_from_part[0] = -part.mover_from_part[0];
    }
    load::fuse_still_parts(level);
    for (const world::Part& part : level.parts) {
        if (part.name != "still") continue;
        const world::Mesh& mesh = level.meshes[part.mesh];
        for (const glm::uvec3& t : mesh.triangles) {
            const glm::vec3 face = glm::cross(mesh.positions[t.y] - mesh.positions[t.x],
                                              mesh.positions[t.z] - mesh.positions[t.x]);
            EXPECT_GT(glm::dot(face, mesh.normals[t.x]), 0.0f);
        }
    }
}

}  // namespace
}  // namespace gh
