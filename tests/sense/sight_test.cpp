// A guard that sees you in a mirror sees you as it would at the end of that long way round, a little dimmer.
#include "sense/sight.h"

#include "sense/exposure.h"
#include "support/rest_scene.h"
#include "support/small_level.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <cmath>

namespace gh::sense {
namespace {

//            mirror along z = 0, facing +z
//      ===============|===============
//                     |
//       eye o         |          o body        the wall at x = 0 stands from z = 1 on
//                     |
struct Corner {
    test::SmallLevel small;
    std::uint32_t plaster = 0;
    std::uint32_t mirror_part = 0;
    world::MirrorPane pane;
    Eye eye;
    Body body;

    Corner() {
        plaster = small.add_material(world::Surface::Plaster);
        small.add_box({-0.05f, 0.0f, 1.0f}, {0.05f, 3.0f, 9.0f}, plaster);
        pane = {.centre = {0.0f, 1.5f, 0.0f},
                .half_u = {4.0f, 0.0f, 0.0f},
                .half_v = {0.0f, 1.5f, 0.0f},
                .normal = {0.0f, 0.0f, 1.0f},
                .reflectance = glm::vec3(0.8f),
                .part = 0};
        mirror_part = small.add_sheet(pane.centre, pane.half_u, pane.half_v, plaster);
        pane.part = mirror_part;
        eye = {.position = {-2.0f, 1.65f, 3.0f},
               .forward = glm::normalize(glm::vec3(2.0f, -0.2f, -3.0f)),
               .cos_half_fov = 0.5f,
               .range = 20.0f};
        world::PlayerState player;
        player.position = {2.0f, 0.0f, 3.3f};
        body.point = body_points(player);
        for (std::size_t p = 0; p < kBodyPoints; ++p) body.lit[p] = 0.1f * static_cast<float>(p + 1);
    }

    [[nodiscard]] Sighting direct() const {
        Sighting out;
        sight(*test::rest_scene(small.level), {&eye, 1}, body, {&out, 1});
        return out;
    }
    [[nodiscard]] Sighting in_mirror() const {
        Sighting out;
        mirror_sight(*test::rest_scene(small.level), {&pane, 1}, {&eye, 1}, body, {&out, 1});
        return out;
    }
    // The body where its image appears to be, in a world without wall or mirror.
    [[nodiscard]] Sighting image_in_the_open() const {
        Body image = body;
        for (glm::vec3& point : image.point) point.z = -point.z;
        test::SmallLevel empty;
        Sighting out;
        sight(*test::rest_scene(empty.level), {&eye, 1}, image, {&out, 1});
        return out;
    }
};

TEST(Sight, InAMirrorItIsTheDirectSightOfTheImageTimesTheReflectance) {
    const Corner corner;
    EXPECT_EQ(corner.direct().clear, 0.0f) << "the wall hides the body";
    const Sighting mirrored = corner.in_mirror();
    const Sighting expected = corner.image_in_the_open();
    EXPECT_EQ(expected.clear, 1.0f);
    EXPECT_EQ(mirrored.clear, expected.clear);
    EXPECT_NEAR(mirrored.seen, 0.8f * expected.seen, 1e-6f);
    EXPECT_NEAR(mirrored.distance, expected.distance, 1e-5f) << "d1 + d2";
    EXPECT_EQ(mirrored.pane, 0u);
}

TEST(Sight, AMirrorsRangeIsBothStretchesTogether) {
    Corner corner;
    const float nearest = corner.in_mirror().distance;
    corner.eye.range = nearest * (1.0f - 1e-4f);
    EXPECT_EQ(corner.in_mirror().clear, 0.0f);
    EXPECT_EQ(corner.image_in_the_open().clear, 0.0f);
    corner.eye.range = nearest * (1.0f + 1e-4f);
    EXPECT_NEAR(corner.in_mirror().clear, 0.1f, 1e-6f) << "the nearest point alone";
    EXPECT_NEAR(corner.in_mirror().seen, 0.8f * corner.image_in_the_open().seen, 1e-6f);
}

TEST(Sight, AMirrorIsSeenOnlyWithinTheViewCone) {
    Corner corner;
    corner.eye.forward = {0.0f, 0.0f, 1.0f};  // looks away from the mirror, although the body is at its side
    EXPECT_EQ(corner.in_mirror().clear, 0.0f);
    corner.eye.forward = glm::normalize(glm::vec3(2.0f, -0.2f, -3.0f));
    corner.eye.cos_half_fov = 0.99f;  // 8 degrees: part of the body
    const Sighting narrow = corner.in_mirror();
    EXPECT_GT(narrow.clear, 0.0f);
    EXPECT_LT(narrow.clear, 1.0f);
    EXPECT_NEAR(narrow.seen, 0.8f * corner.image_in_the_open().seen, 1e-6f);
}

TEST(Sight, SomethingInEitherStretchHidesTheReflection) {
    for (const float side : {-1.0f, 1.0f}) {
        Corner corner;
        corner.small.add_sheet({side, 1.5f, 1.5f}, {0.9f, 0.0f, 0.0f}, {0.0f, 1.5f, 0.0f}, corner.plaster);
        EXPECT_EQ(corner.in_mirror().clear, 0.0f) << (side < 0.0f ? "before the mirror" : "after it");
    }
}

TEST(Sight, GlassInFrontOfAMirrorHidesNothing) {
    Corner corner;
    const std::uint32_t glass =
        corner.small.add_sheet({-1.0f, 1.5f, 1.5f}, {0.9f, 0.0f, 0.0f}, {0.0f, 1.5f, 0.0f}, corner.plaster);
    corner.small.part(glass).layers = world::Light | world::Sound | world::Solid;
    EXPECT_EQ(corner.in_mirror().clear, 1.0f);
}

TEST(Sight, TheBackOfAPaneShowsNothing) {
    Corner corner;
    corner.pane.normal = -corner.pane.normal;
    corner.pane.half_u = -corner.pane.half_u;
    EXPECT_EQ(corner.in_mirror().clear, 0.0f);
    // Nor does it show a body that stands behind it.
    Corner behind;
    for (glm::vec3& point : behind.body.point) point.z = -point.z;
    EXPECT_EQ(behind.in_mirror().clear, 0.0f);
}

TEST(Sight, ASmallPaneShowsThePointsWhoseImagesLieInIt) {
    Corner corner;
    // The look from 1.65 m to a point at height h meets the pane at 1.65 + (h - 1.65) * 3 / (3 + z): keep the upper part.
    corner.small.level.parts.pop_back();
    corner.pane.centre.y = 2.1f;
    corner.pane.half_v.y = 0.9f;  // from 1.2 m up
    corner.pane.part =
        corner.small.add_sheet(corner.pane.centre, corner.pane.half_u, corner.pane.half_v, corner.plaster);
    std::size_t expected = 0;
    for (const glm::vec3& point : corner.body.point)
        expected += 1.65f + (point.y - 1.65f) * 3.0f / (3.0f + point.z) >= 1.2f;
    EXPECT_GT(expected, 0u);
    EXPECT_LT(expected, kBodyPoints);
    EXPECT_NEAR(corner.in_mirror().clear, 0.1f * static_cast<float>(expected), 1e-6f);
}

TEST(Sight, AFrameThatCoversThePaneHidesWhatItCovers) {
    Corner corner;
    corner.small.add_box({-4.0f, 0.0f, 0.01f}, {4.0f, 3.0f, 0.05f}, corner.plaster);
    EXPECT_EQ(corner.in_mirror().clear, 0.0f);
}

TEST(Sight, TwoPanesShowABodyOnce) {
    const Corner corner;
    std::array<world::MirrorPane, 2> panes = {corner.pane, corner.pane};
    panes[1].reflectance = glm::vec3(0.5f);
    Sighting both;
    mirror_sight(*test::rest_scene(corner.small.level), panes, {&corner.eye, 1}, corner.body, {&both, 1});
    EXPECT_EQ(both.seen, corner.in_mirror().seen) << "the better pane counts, not the sum";
    EXPECT_EQ(both.pane, 0u);
}

TEST(Sight, DirectlyItIsTheLitShareInPlainView) {
    Corner corner;
    corner.eye.position = {4.0f, 1.65f, 6.0f};
    corner.eye.forward = glm::normalize(glm::vec3(-2.0f, -0.2f, -2.7f));
    float lit = 0.0f;
    for (const float l : corner.body.lit) lit += l;
    EXPECT_EQ(corner.direct().clear, 1.0f);
    EXPECT_NEAR(corner.direct().seen, lit / 10.0f, 1e-6f);

    // A parapet 1.3 m high, halfway. Points whose look passes above it stay in view.
    corner.small.add_box({2.5f, 0.0f, 4.6f}, {3.5f, 1.3f, 4.65f}, corner.plaster);
    const Sighting half = corner.direct();
    EXPECT_GT(half.clear, 0.0f);
    EXPECT_LT(half.clear, 1.0f);

    corner.eye.range = 1.0f;
    EXPECT_EQ(corner.direct().clear, 0.0f);
    corner.eye.range = 20.0f;
    corner.eye.forward = -corner.eye.forward;
    EXPECT_EQ(corner.direct().clear, 0.0f);
}

}  // namespace
}  // namespace gh::sense
