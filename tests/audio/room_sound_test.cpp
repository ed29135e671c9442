#include "audio/room_sound.h"

#include <gtest/gtest.h>

#include <cmath>

namespace gh::audio {
namespace {

using world::Surface;

std::uint32_t material_of(world::Level& level, Surface surface) {
    world::Material material;
    material.surface = surface;
    level.materials.push_back(material);
    return static_cast<std::uint32_t>(level.materials.size() - 1);
}

// Six sides of a box of one material.
void add_box(world::Level& level, const glm::vec3& a, const glm::vec3& b, Surface surface) {
    world::Mesh mesh;
    for (int i = 0; i < 8; ++i) {
        mesh.positions.emplace_back((i & 1) != 0 ? b.x : a.x, (i & 2) != 0 ? b.y : a.y, (i & 4) != 0 ? b.z : a.z);
    }
    mesh.triangles = {{0, 4, 1}, {1, 4, 5}, {2, 3, 6}, {3, 7, 6}, {0, 1, 2}, {1, 3, 2},
                      {4, 6, 5}, {5, 6, 7}, {0, 2, 4}, {2, 6, 4}, {1, 5, 3}, {3, 5, 7}};
    mesh.materials.assign(12, material_of(level, surface));
    world::Part part;
    part.mesh = static_cast<std::uint32_t>(level.meshes.size());
    level.meshes.push_back(mesh);
    level.parts.push_back(part);
}

world::Level hall_of(Surface surface) {
    world::Level level;
    level.rooms.push_back({.name = "hall", .title = "Hall", .box = {{0, 0, 0}, {10, 5, 8}}});
    add_box(level, {0, 0, 0}, {10, 5, 8}, surface);
    return level;
}

// 10 x 5 x 8 m, all of one thing: V = 400, S = 340, by Eyring with each band's absorption.
TEST(RoomSound, RingsByEyring) {
    for (const Surface surface : {Surface::Parquet, Surface::Plaster, Surface::Curtain}) {
        const RoomSound sound = room_sounds(hall_of(surface)).at(0);
        EXPECT_NEAR(sound.mean_free_path, 4.0 * 400.0 / 340.0, 1e-4);
        for (std::size_t b = 0; b < world::kBands; ++b) {
            const double share = static_cast<double>(world::acoustics(surface).absorption[b]);
            const double seconds = 24.0 * std::log(10.0) * 400.0 / (343.0 * 340.0 * -std::log(1.0 - share));
            const double heard = std::clamp(seconds, 0.15, 4.0);
            EXPECT_NEAR(static_cast<double>(sound.decay[b]), heard, 1e-3 * heard) << "band " << b;
        }
    }
}

TEST(RoomSound, CurtainsMakeARoomShorterAndQuieter) {
    world::Level level = hall_of(Surface::Plaster);
    const RoomSound bare = room_sounds(level).at(0);
    add_box(level, {1, 0, 1}, {6, 4, 1.1f}, Surface::Curtain);
    const RoomSound draped = room_sounds(level).at(0);
    EXPECT_LT(draped.decay[1], 0.7f * bare.decay[1]);
    EXPECT_LT(draped.level, bare.level);
}

// What stands next door changes nothing, and a room of nothing is a plain small one.
TEST(RoomSound, EachRoomHasItsOwn) {
    world::Level level = hall_of(Surface::Plaster);
    const RoomSound alone = room_sounds(level).at(0);
    level.rooms.push_back({.name = "next", .title = "", .box = {{11, 0, 0}, {14, 3, 4}}});
    level.rooms.push_back({.name = "void", .title = "", .box = {{50, 0, 0}, {54, 3, 4}}});
    add_box(level, {11, 0, 0}, {14, 3, 4}, Surface::Curtain);
    const std::vector<RoomSound> sounds = room_sounds(level);
    ASSERT_EQ(sounds.size(), 3u);
    EXPECT_EQ(sounds[0], alone);
    EXPECT_LT(sounds[1].decay[1], 0.3f);
    EXPECT_EQ(sounds[2], RoomSound{});
}

TEST(RoomSound, ADoorwayIsInNoRoom) {
    world::Level level = hall_of(Surface::Plaster);
    level.rooms.push_back({.name = "next", .title = "", .box = {{10.4f, 0, 0}, {14, 3, 4}}});
    EXPECT_EQ(room_at(level, {9.9f, 1, 1}), 0u);
    EXPECT_EQ(room_at(level, {10.2f, 1, 1}), world::kNoIndex);
    EXPECT_EQ(room_at(level, {10.5f, 1, 1}), 1u);
}

}  // namespace
}  // namespace gh::audio
