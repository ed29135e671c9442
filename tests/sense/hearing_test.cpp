// Sound goes through walls by their mass, round columns by diffraction, and not through a shut door to speak of.
#include "sense/hearing.h"

#include "base/random.h"
#include "sense/walls.h"
#include "support/rest_scene.h"
#include "support/small_level.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace gh::sense {
namespace {

constexpr float kFootstep = 60.0f;  // dB at 1 m
const glm::vec3 kSource(0.3f, 0.4f, -3.0f);
const glm::vec3 kEar(-0.2f, 1.6f, 3.0f);

// Two rooms, 8 x 8 m each, with a wall between them at z = 0, and a doorway 1 m wide and 2.1 m high in it.
struct TwoRooms {
    test::SmallLevel small;
    std::uint32_t leaf = 0;

    TwoRooms() {
        const std::uint32_t plaster = small.add_material(world::Surface::Plaster);
        const std::uint32_t oak = small.add_material(world::Surface::Oak);
        const std::uint32_t shell = small.add_box({-4.0f, 0.0f, -8.0f}, {4.0f, 3.0f, 8.0f}, plaster, true);
        small.part(shell).is_shell = true;
        small.add_box({-4.2f, -0.2f, -0.1f}, {-0.5f, 3.2f, 0.1f}, plaster);
        small.add_box({0.5f, -0.2f, -0.1f}, {4.2f, 3.2f, 0.1f}, plaster);
        small.add_box({-0.5f, 2.1f, -0.1f}, {0.5f, 3.2f, 0.1f}, plaster);
        leaf = small.add_box({0.0f, 0.0f, -0.02f}, {1.0f, 2.1f, 0.02f}, oak);  // hinged at x = -0.5
    }
    // The leaf turned by `angle` about its hinge.
    [[nodiscard]] std::shared_ptr<const rc::Scene> scene(double angle) const {
        rc::SceneBuilder builder = test::rest_builder(small.level);
        const float c = static_cast<float>(std::cos(angle)), s = static_cast<float>(std::sin(angle));
        builder.set_transform(leaf, glm::mat4x3(glm::vec3(c, 0.0f, -s), glm::vec3(0.0f, 1.0f, 0.0f),
                                                glm::vec3(s, 0.0f, c), glm::vec3(-0.5f, 0.0f, 0.0f)));
        return builder.commit();
    }
    [[nodiscard]] float level_at(double angle, const glm::vec3& source, const glm::vec3& ear,
                                 std::span<const glm::vec3> detour = {}) const {
        return level_db(kFootstep, hear(small.level, *scene(angle), source, ear, detour));
    }
};

TEST(Hearing, InTheOpenItFallsBySixDecibelsADoubling) {
    test::SmallLevel empty;
    const auto scene = test::rest_scene(empty.level);
    for (const float r : {0.5f, 1.0f, 2.0f, 4.0f, 16.0f, 50.0f}) {
        const Transmission t = hear(empty.level, *scene, glm::vec3(0.0f), {r, 0.0f, 0.0f});
        const double expected = 60.0 - 20.0 * std::log10(static_cast<double>(r));
        EXPECT_NEAR(level_db(60.0f, t), expected, 0.05);
        for (std::size_t band = 0; band < world::kBands; ++band) {
            EXPECT_NEAR(t.band_gain[band], 1.0f / r, 0.005f / r);
            EXPECT_NEAR(t.band_db[band], expected - 60.0, 0.05);
        }
        EXPECT_EQ(t.metres, r);
        EXPECT_EQ(t.arrives_from, glm::vec3(0.0f));
    }
}

TEST(Hearing, AnEarAtTheSourceHearsItAsFromTheNearestThereIs) {
    const TwoRooms rooms;
    const Transmission t = hear(rooms.small.level, *rooms.scene(0.0), kEar, kEar);
    EXPECT_NEAR(t.band_gain[0], 10.0f, 1e-3f);
    EXPECT_EQ(t.metres, 0.0f);
}

TEST(Hearing, AShutDoorSilencesAndAnOpenOneDoesNot) {
    const TwoRooms rooms;
    const float shut = rooms.level_at(0.0, kSource, kEar);
    const float open = rooms.level_at(1.6, kSource, kEar);
    EXPECT_NEAR(open, kFootstep - 20.0f * std::log10(6.14f), 0.3f) << "the free way through the doorway";
    EXPECT_LT(shut, 20.0f) << "below what a guard can hear in a quiet room";
    EXPECT_LT(shut, open - 25.0f);
}

TEST(Hearing, OpeningADoorNeverLowersALevelInTheNextRoom) {
    const TwoRooms rooms;
    Random random(11);
    for (int i = 0; i < 60; ++i) {
        const glm::vec3 source(random.in_range(-3.5f, 3.5f), 0.3f, random.in_range(-7.0f, -1.2f));
        const glm::vec3 ear(random.in_range(-3.5f, 3.5f), 1.6f, random.in_range(1.2f, 7.0f));
        const std::array<glm::vec3, 1> doorway = {glm::vec3(0.2f, 1.0f, 0.0f)};
        const float shut = rooms.level_at(0.0, source, ear, doorway);
        for (const double angle : {0.05, 0.4, 0.9, 1.6}) {
            EXPECT_GE(rooms.level_at(angle, source, ear, doorway), shut - 1e-3f)
                << "pair " << i << ", angle " << angle;
        }
    }
}

TEST(Hearing, SwappingSourceAndEarChangesNothing) {
    TwoRooms rooms;
    const std::uint32_t marble = rooms.small.add_material(world::Surface::Marble);
    rooms.small.add_box({-2.0f, 0.0f, 2.0f}, {-1.6f, 2.5f, 2.4f}, marble);
    rooms.small.add_box({1.0f, 0.0f, -3.0f}, {2.0f, 1.2f, -2.0f}, marble);
    const auto scene = rooms.scene(0.5);
    Random random(3);
    for (int i = 0; i < 200; ++i) {
        const auto anywhere = [&] {
            return glm::vec3(random.in_range(-3.5f, 3.5f), random.in_range(0.1f, 2.5f),
                             random.in_range(-7.0f, 7.0f));
        };
        const glm::vec3 a = anywhere(), b = anywhere();
        const std::array<glm::vec3, 2> there = {glm::vec3(0.1f, 1.0f, -0.5f), glm::vec3(-0.1f, 1.2f, 0.5f)};
        const std::array<glm::vec3, 2> back = {there[1], there[0]};
        const Transmission ab = hear(rooms.small.level, *scene, a, b, there);
        const Transmission ba = hear(rooms.small.level, *scene, b, a, back);
        for (std::size_t band = 0; band < world::kBands; ++band) {
            EXPECT_NEAR(ab.band_db[band], ba.band_db[band], 1e-3f) << "pair " << i;
        }
    }
}

TEST(Walls, EachWallCountsOnceHoweverItIsModelled) {
    const auto loss = [](const test::SmallLevel& small) {
        return walls_between(small.level, *test::rest_scene(small.level), {0.1f, 0.2f, -3.0f},
                             {0.0f, 0.3f, 3.0f})
            .loss_db;
    };
    const auto box = [](test::SmallLevel& small, float z, std::uint32_t material) {
        return small.add_box({-2.0f, -2.0f, z}, {2.0f, 2.0f, z + 0.1f}, material);
    };
    test::SmallLevel one, two, sheet, panel, shells, mixed;
    for (test::SmallLevel* small : {&one, &two, &sheet, &panel, &shells, &mixed})
        (void)small->add_material(world::Surface::Oak);
    const BandDb oak = world::acoustics(world::Surface::Oak).transmission_loss_db;
    const BandDb twice = {2.0f * oak[0], 2.0f * oak[1], 2.0f * oak[2]};

    box(one, 0.0f, 0);
    EXPECT_EQ(loss(one), oak) << "entering and leaving are one wall";
    const glm::vec3 on_diagonal(0.0f, 0.0f, -3.0f);  // through the edge that two triangles of each face share
    EXPECT_EQ(walls_between(one.level, *test::rest_scene(one.level), on_diagonal, {0.0f, 0.0f, 3.0f}).loss_db,
              oak);
    box(two, 0.0f, 0);
    box(two, 1.0f, 0);
    EXPECT_EQ(loss(two), twice) << "two walls lose twice";
    sheet.add_sheet(glm::vec3(0.0f), {2.0f, 0.0f, 0.0f}, {0.0f, 2.0f, 0.0f}, 0);
    EXPECT_EQ(loss(sheet), oak) << "a sheet without thickness";

    // A panel of the same part let into the leaf: ( ( ) ) along the ray.
    const std::uint32_t leaf = box(panel, 0.0f, 0);
    const std::uint32_t inner = panel.add_box({-1.0f, -1.0f, 0.05f}, {1.0f, 1.0f, 0.15f}, 0);
    world::Mesh& mesh = panel.level.meshes[panel.part(leaf).mesh];
    const world::Mesh& extra = panel.level.meshes[panel.part(inner).mesh];
    for (const glm::uvec3& t : extra.triangles) mesh.triangles.push_back(t + glm::uvec3(8));
    mesh.positions.insert(mesh.positions.end(), extra.positions.begin(), extra.positions.end());
    mesh.materials.insert(mesh.materials.end(), extra.materials.begin(), extra.materials.end());
    panel.level.parts.pop_back();
    EXPECT_EQ(loss(panel), oak) << "a panel let into a door";

    // Two rooms' shells, seen from inside, 0.2 m apart: the wall between them.
    for (const float z : {-4.1f, 0.1f}) {
        shells.part(shells.add_box({-2.0f, -2.0f, z}, {2.0f, 2.0f, z + 4.0f}, 0, true)).is_shell = true;
    }
    EXPECT_EQ(loss(shells), oak) << "leaving one room and entering the next";

    // Two kinds of wall add up, in either direction.
    const std::uint32_t glass = mixed.add_material(world::Surface::Glass);
    box(mixed, 0.0f, 0);
    box(mixed, 1.0f, glass);
    const BandDb pane = world::acoustics(world::Surface::Glass).transmission_loss_db;
    EXPECT_EQ(loss(mixed), (BandDb{oak[0] + pane[0], oak[1] + pane[1], oak[2] + pane[2]}));
    const BandDb back =
        walls_between(mixed.level, *test::rest_scene(mixed.level), {0.0f, 0.3f, 3.0f}, {0.1f, 0.2f, -3.0f})
            .loss_db;
    EXPECT_EQ(loss(mixed), back);
}

TEST(Hearing, AGuardsOwnHeadIsNoWall) {
    test::SmallLevel small;
    const std::uint32_t plaster = small.add_material(world::Surface::Plaster);
    const std::uint32_t head = small.add_box(glm::vec3(-0.15f), glm::vec3(0.15f), plaster);
    small.part(head).mover = world::Mover::Guard;
    const Transmission t =
        hear(small.level, *test::rest_scene(small.level), {0.0f, 0.0f, -4.0f}, glm::vec3(0.0f));
    EXPECT_NEAR(t.band_gain[0], 0.25f, 1e-4f);
}

TEST(Hearing, AColumnIsHeardRoundNotThrough) {
    test::SmallLevel small;
    const std::uint32_t marble = small.add_material(world::Surface::Marble);
    small.add_box({-0.3f, -1.0f, -0.3f}, {0.3f, 4.0f, 0.3f}, marble);
    const Transmission t =
        hear(small.level, *test::rest_scene(small.level), {0.05f, 1.0f, -4.0f}, {0.0f, 1.5f, 4.0f});
    const float free = -20.0f * std::log10(8.0f);
    for (std::size_t band = 0; band < world::kBands; ++band) {
        EXPECT_LT(t.band_db[band], free - 5.0f);
        EXPECT_GT(t.band_db[band], free - 16.0f) << "55 to 79 dB through the marble";
    }
    EXPECT_GT(t.band_db[0], t.band_db[2]) << "low notes bend better";
    EXPECT_GT(std::abs(t.arrives_from.x), 0.3f) << "from the column's edge";
}

TEST(Hearing, ADetourIsHeardThroughAnOpenDoorAndNotThroughAShutOne) {
    const TwoRooms rooms;
    const glm::vec3 source(3.0f, 0.4f, -2.0f),
        ear(3.0f, 1.6f, 2.0f);  // the wall stands between; the doorway is 3 m off
    const std::array<glm::vec3, 1> doorway = {glm::vec3(0.2f, 1.0f, 0.0f)};
    const auto heard = [&](double angle) {
        return hear(rooms.small.level, *rooms.scene(angle), source, ear, doorway);
    };
    const Transmission open = heard(1.6), shut = heard(0.0);
    const float way = 2.0f * std::sqrt(2.8f * 2.8f + 2.0f * 2.0f + 0.36f);
    EXPECT_NEAR(open.metres, way, 0.01f);
    EXPECT_EQ(open.arrives_from, doorway[0]);
    const float extra = way - std::sqrt(16.0f + 1.44f);
    EXPECT_NEAR(open.band_db[1], -20.0f * std::log10(way) - barrier_loss_db(extra, 1000.0f), 0.05f);
    EXPECT_LT(level_db(kFootstep, shut), level_db(kFootstep, open) - 4.0f);
}

TEST(Hearing, ABarriersLossFollowsKurzeAndAnderson) {
    const auto at = [](float fresnel_number) {
        return barrier_loss_db(fresnel_number * 343.0f / (2.0f * 1000.0f), 1000.0f);
    };
    EXPECT_NEAR(at(0.0f), 5.0f, 0.05f);
    EXPECT_NEAR(at(0.58f), 11.0f, 0.05f);
    EXPECT_NEAR(at(2.92f), 17.6f, 0.05f);
    EXPECT_EQ(at(1000.0f), 24.0f);
    EXPECT_NEAR(at(1e-7f), 5.0f, 1e-3f);
}

}  // namespace
}  // namespace gh::sense
