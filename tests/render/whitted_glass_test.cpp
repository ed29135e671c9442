// Mirrors and glass in closed form.
#include "render/fresnel.h"
#include "studio.h"

#include <gtest/gtest.h>

#include <cmath>

namespace gh {
namespace {

using test::exact;
using test::narrow;
using test::Studio;

// Two mirrors face each other and glow: what one sees is a geometric series, one term a reflection.
TEST(Whitted, AMirrorBoxAddsUpAGeometricSeries) {
    for (const int depth : {0, 1, 5, 20}) {
        Studio studio;
        world::Material pane = test::mirror(0.9f);
        pane.emission = glm::vec3(1.0f);
        studio.add_sheet({0, 0, -1}, {10, 0, 0}, {0, 10, 0}, pane);
        studio.add_sheet({0, 0, 1}, {0, 10, 0}, {10, 0, 0}, pane);
        studio.open();
        render::WhittedSettings settings = exact();
        settings.max_depth = depth;
        const double expected = (1.0 - std::pow(0.9, depth + 1)) / 0.1;
        const float seen = studio.picture(narrow(glm::vec3(0.0f)), 1, 1, settings).pixels[0].x;
        EXPECT_NEAR(seen, expected, 1e-5 * expected) << "depth " << depth;
    }
}

// A guard round the corner must look in a mirror just as he would stand there.
TEST(Whitted, APerfectMirrorShowsTheMirroredScene) {
    const auto furnish = [](Studio& studio, float side) {  // side -1: everything mirrored at the plane z = 0
        studio.add_sheet({0, -1, 2 * side}, {3, 0, 0}, {0, 0, -2}, test::matte({0.6f, 0.5f, 0.4f}));
        studio.add_ball({0.4f, 0.1f, 1.8f * side}, 0.5f, 24, test::matte({0.2f, 0.6f, 0.9f}));
        studio.add_lamp({.name = {},
                         .shape = world::LampShape::Point,
                         .position = {-1, 2, 1.5f * side},
                         .intensity = glm::vec3(9.0f)});
    };
    Studio mirrored, direct;
    furnish(mirrored, 1.0f);
    furnish(direct, -1.0f);
    mirrored.add_sheet(glm::vec3(0.0f), {5, 0, 0}, {0, 5, 0}, test::mirror(1.0f));
    mirrored.open();
    direct.open();
    const render::Camera camera{.position = {0, 0, 0.8f}, .fov_y = 0.9f};
    const Image in_mirror = mirrored.picture(camera, 96, 64, exact()),
                as_is = direct.picture(camera, 96, 64, exact());
    int different = 0;
    for (std::size_t i = 0; i < as_is.pixels.size(); ++i) {
        different += glm::length(in_mirror.pixels[i] - as_is.pixels[i]) > 1e-4f ? 1 : 0;
    }
    // Rounding moves a ray across the ball's or a shadow's outline in a pixel here and there.
    EXPECT_LE(different, 20);
}

// The eye in front of a slab at z = 0..-0.1, a glowing wall behind it or behind the eye.
float through_slab(const world::Material& glass, float wall_z, float slab = 0.1f) {
    Studio studio;
    studio.add_box({-5, -5, -slab}, {5, 5, 0}, glass);
    if (wall_z < 0.0f) {
        studio.add_sheet({0, 0, wall_z}, {9, 0, 0}, {0, 9, 0}, test::glowing(1.0f));
    } else {
        studio.add_sheet({0, 0, wall_z}, {0, 9, 0}, {9, 0, 0}, test::glowing(1.0f));
    }
    studio.open();
    return studio.picture(narrow({0.013f, 0.007f, 1.0f}), 1, 1, exact()).pixels[0].x;
}

TEST(Whitted, ASlabOfGlassPassesAndMirrorsTheKnownShares) {
    EXPECT_NEAR(through_slab(test::clear_glass(1.5f), -3.0f), 0.923077f, 1e-5f);
    EXPECT_NEAR(through_slab(test::clear_glass(1.5f), 3.0f), 0.076923f, 1e-5f);
}

TEST(Whitted, AnIndexMatchedSlabIsInvisible) {
    EXPECT_NEAR(through_slab(test::clear_glass(1.0f), -3.0f), 1.0f, 1e-6f);
}

TEST(Whitted, AnAbsorbingSlabFollowsBeersLaw) {
    world::Material glass = test::clear_glass(1.5f);
    glass.attenuation_color = glm::vec3(0.5f);
    glass.attenuation_distance = 0.2f;
    const double a = std::pow(0.5, 0.1 / 0.2), r = 0.04;
    EXPECT_NEAR(through_slab(glass, -3.0f), (1 - r) * (1 - r) * a / (1 - r * r * a * a), 1e-5);
}

TEST(Whitted, ASheetWithoutThicknessMirrorsAsAThinPaneAndBendsNothing) {
    Studio studio;
    studio.add_sheet(glm::vec3(0.0f), {5, 0, 0}, {0, 5, 0}, test::clear_glass(1.5f));
    studio.add_sheet({0, 0, -3}, {9, 0, 0}, {0, 9, 0}, test::glowing(1.0f));
    studio.open();
    EXPECT_FALSE(studio.prepared.parts[0].is_solid_glass);
    EXPECT_NEAR(studio.picture(narrow({0, 0, 1}), 1, 1, exact()).pixels[0].x, 0.923077f, 1e-5f);
}

// One body of glass inside another of the same index is not there.
TEST(Whitted, GlassInsideEqualGlassIsInvisible) {
    const auto seen = [](bool has_inner) {
        Studio studio;
        studio.add_box({-5, -5, -1}, {5, 5, 0}, test::clear_glass(1.5f));
        if (has_inner) studio.add_ball({0, 0, -0.5f}, 0.3f, 24, test::clear_glass(1.5f));
        studio.add_sheet({0, 0, -3}, {9, 0, 0}, {0, 9, 0}, test::glowing(1.0f));
        studio.open();
        const render::Camera camera{.position = {0, 0, 1}, .fov_y = 0.3f};
        return studio.picture(camera, 24, 24, exact());
    };
    const Image with = seen(true), without = seen(false);
    for (std::size_t i = 0; i < with.pixels.size(); ++i)
        EXPECT_NEAR(with.pixels[i].x, without.pixels[i].x, 1e-6f);
}

TEST(Whitted, ALampBehindAPaneStillLightsTheFloor) {
    const auto floor_light = [](bool has_pane) {
        Studio studio;
        studio.add_sheet(glm::vec3(0.0f), {0, 0, 9}, {9, 0, 0}, test::matte(glm::vec3(0.5f)));
        if (has_pane) studio.add_box({-1, 1.0f, -1}, {1, 1.1f, 1}, test::clear_glass(1.5f));
        studio.add_lamp({.name = {},
                         .shape = world::LampShape::Point,
                         .position = {0, 2, 0},
                         .intensity = glm::vec3(4.0f)});
        studio.open();
        return studio.picture(narrow({0, 0.5f, 0}, 0.0f, test::kDown), 1, 1, exact()).pixels[0].x;
    };
    EXPECT_NEAR(floor_light(true) / floor_light(false), 0.96f * 0.96f, 1e-4f);
}

TEST(Fresnel, LightIsTotallyReflectedBeyondTheCriticalAngleAndNeverNaN) {
    const double critical = std::asin(1.0 / 1.5);
    const auto at = [](double angle) {
        return render::fresnel(static_cast<float>(std::cos(angle)), 1.0f / 1.5f);
    };
    EXPECT_EQ(at(critical + 1e-6).reflectance, 1.0f);
    EXPECT_LT(at(critical - 1e-3).reflectance, 0.9f);
    for (int i = 0; i <= 100'000; ++i) {
        for (const float eta : {1.5f, 1.0f / 1.5f, 1.0f, 2.4f}) {
            const render::Interface border = render::fresnel(static_cast<float>(i) * 1e-5f, eta);
            ASSERT_TRUE(border.reflectance >= 0.0f && border.reflectance <= 1.0f) << i << ' ' << eta;
        }
    }
}

}  // namespace
}  // namespace gh
