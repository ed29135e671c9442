// Distributed ray tracing (Cook, Porter and Carpenter 1984): lenses, shutters, soft shadows and gloss against closed forms.
#include "path_studio.h"
#include "render/lamp.h"
#include "render/pixel_filter.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace gh {
namespace {

using test::Studio;

render::PathSettings cook(int samples_per_pixel) {
    render::PathSettings settings = render::cook_path();
    settings.samples_per_pixel = samples_per_pixel;
    settings.filter = render::PixelFilter::Box;
    return settings;
}

// Where a picture's light lies, in pixels.
struct Spot {
    glm::dvec2 mean{0.0}, variance{0.0};
};
Spot spot_of(const Image& picture) {
    Spot spot;
    double total = 0.0;
    for (int y = 0; y < picture.height; ++y) {
        for (int x = 0; x < picture.width; ++x) {
            const double light = static_cast<double>(picture.at(x, y).y);
            const glm::dvec2 at(x + 0.5, y + 0.5);
            total += light;
            spot.mean += at * light;
            spot.variance += at * at * light;
        }
    }
    spot.mean /= total;
    spot.variance = spot.variance / total - spot.mean * spot.mean;
    return spot;
}

constexpr int kAcross = 32;       // pixels
constexpr float kNarrow = 0.15f;  // their fov

// A small bright square straight ahead at a depth.
Image dot_at(float depth, const render::Camera& camera, const render::PathSettings& settings) {
    Studio studio;
    studio.add_sheet({0, 0, -depth}, {0.01f * depth, 0, 0}, {0, 0.01f * depth, 0}, test::glowing(1.0f));
    studio.open();
    const render::Environment night = test::even_light(0.0f);
    render::PathSettings dark = settings;
    dark.environment = &night;
    return test::path_picture(studio, camera, kAcross, kAcross, dark);
}

// A disc of radius r has a variance of r^2 / 4 along each axis; the square itself adds its own.
TEST(Cook, WhatIsOutOfFocusIsADiscOfTheThinLensRadius) {
    constexpr float kAperture = 0.06f, kFocus = 3.0f;
    const render::Camera camera{
        .position = {0, 0, 0}, .fov_y = kNarrow, .aperture = kAperture, .focus = kFocus};
    render::Camera pinhole = camera;
    pinhole.aperture = 0.0f;
    const double pixel = static_cast<double>(render::Lens(camera, kAcross, kAcross).pixel_angle());
    for (const float depth : {1.5f, 2.0f, 3.0f, 6.0f, 20.0f}) {
        const Spot sharp = spot_of(dot_at(depth, pinhole, cook(1024)));
        const Spot blurred = spot_of(dot_at(depth, camera, cook(1024)));
        const double z = static_cast<double>(depth), f = static_cast<double>(kFocus);
        const double radius = static_cast<double>(kAperture) * std::abs(1.0 / z - 1.0 / f) / pixel;
        for (glm::length_t axis = 0; axis < 2; ++axis) {
            const double grown = blurred.variance[axis] - sharp.variance[axis];
            EXPECT_NEAR(grown, radius * radius / 4.0, 0.03 * radius * radius / 4.0 + 0.03) << depth;
            EXPECT_NEAR(blurred.mean[axis], 0.5 * kAcross, 0.05) << depth;
        }
    }
}

// An eye that goes aside by d while the shutter is open draws what stands at depth z out by d / z: even over its length.
TEST(Cook, AnOpenShutterDrawsOutWhatTheEyePasses) {
    constexpr float kWay = 0.08f, kDepth = 2.0f;
    const render::Camera closes{.position = {0.5f * kWay, 0, 0}, .fov_y = kNarrow};
    render::Camera opens = closes;
    opens.position.x = -0.5f * kWay;
    render::PathSettings settings = cook(1024);
    const Spot still = spot_of(dot_at(kDepth, {.position = {0, 0, 0}, .fov_y = kNarrow}, settings));
    settings.shutter_from = &opens;
    const Spot moved = spot_of(dot_at(kDepth, closes, settings));
    const double pixel = static_cast<double>(render::Lens(closes, kAcross, kAcross).pixel_angle());
    const double length = static_cast<double>(kWay / kDepth) / pixel;
    EXPECT_NEAR(moved.variance.x - still.variance.x, length * length / 12.0,
                0.02 * length * length / 12.0 + 0.03);
    EXPECT_NEAR(moved.variance.y, still.variance.y, 0.03);
    EXPECT_NEAR(moved.mean.x, still.mean.x, 0.05);
}

// A sheet's edge above a floor hides part of a panel: what is left is a smaller panel, whose light is known.
TEST(Cook, APenumbraIsTheLightOfWhatIsLeftOfTheLamp) {
    world::Lamp lamp;
    lamp.shape = world::LampShape::Rect;
    lamp.position = {0, 2, 0};
    lamp.half_u = {0.5f, 0, 0};
    lamp.half_v = {0, 0, 0.5f};
    lamp.intensity = glm::vec3(1.0f);
    Studio studio;
    studio.add_sheet(glm::vec3(0.0f), {0, 0, 10}, {10, 0, 0}, test::matte(glm::vec3(0.8f)));
    // From x = 0 on to the right at height 1: a floor point x sees the lamp left of x_lamp = -x.
    studio.add_sheet({4, 1, 0}, {4, 0, 0}, {0, 0, 4}, test::matte(glm::vec3(0.0f)));
    studio.add_lamp(lamp);
    studio.open();
    for (const float x : {-0.6f, -0.3f, 0.0f, 0.2f, 0.45f, 0.6f}) {
        world::Lamp left = lamp;
        const float edge = std::clamp(-x, -0.5f, 0.5f);
        left.half_u.x = 0.5f * (edge + 0.5f);
        left.position.x = -0.5f + left.half_u.x;
        const double truth =
            left.half_u.x > 0.0f
                ? static_cast<double>(render::lamp_irradiance(left, {x, 0, 0}, {0, 1, 0}).y) * 0.8 /
                      3.14159265358979
                : 0.0;
        // From below the sheet, slantwise: a camera straight above would see the sheet.
        const auto seen = test::means(studio, test::narrow({x, 0.5f, 0.0f}, 0.0f, test::kDown), cook(64), 16);
        if (truth == 0.0) {
            EXPECT_EQ(test::moments(seen).mean, 0.0) << x;
        } else {
            test::expect_mean(seen, truth, 3e-4 * truth + 1e-4, "at " + std::to_string(x));
        }
    }
}

// Narrower and narrower gloss becomes the mirror, without a jump.
TEST(Cook, GlossGoesOverIntoAMirror) {
    const auto seen = [](float roughness) {
        world::Material metal = test::mirror(0.8f);
        metal.roughness = roughness;
        Studio studio;
        studio.add_sheet({0, 0, -1}, {1, 0, 0}, {0, 1, 0}, metal);
        studio.add_sheet({0, 0.3f, 3}, {0, 0.2f, 0}, {0.2f, 0, 0}, test::glowing(1.0f));
        studio.open();
        // The lower edge of the lamp's image runs through the picture.
        const render::Camera camera = test::narrow({0.05f, 0.0f, 0.0f}, 0.0f, 0.0f);
        const render::Environment night = test::even_light(0.0f);
        render::PathSettings settings = cook(256);
        settings.environment = &night;
        render::Camera wide = camera;
        wide.pitch = 0.06f;
        wide.fov_y = 0.1f;
        return test::moments(test::means(studio, wide, settings, 16));
    };
    const test::Moments mirror = seen(0.0f), nearly = seen(0.0101f);
    ASSERT_GT(mirror.mean, 0.1);
    ASSERT_LT(mirror.mean, 0.7) << "an edge is in the picture";
    EXPECT_NEAR(nearly.mean, mirror.mean, 1e-3 + 4.0 * std::hypot(mirror.error, nearly.error));
}

// Where light is scattered once only, there is nothing that Cook leaves out.
TEST(Cook, IsPathTracingWhereLightIsScatteredOnce) {
    for (const float metallic : {0.0f, 1.0f}) {
        world::Material floor;
        floor.base_color = glm::vec4(0.7f, 0.6f, 0.5f, 1.0f);
        floor.metallic = metallic;
        floor.roughness = 0.35f;
        Studio studio;
        studio.add_sheet(glm::vec3(0.0f), {0, 0, 10}, {10, 0, 0}, floor);
        studio.add_lamp({.name = {},
                         .shape = world::LampShape::Sphere,
                         .position = {0.4f, 1.2f, -0.6f},
                         .intensity = glm::vec3(3.0f),
                         .radius = 0.2f});
        studio.add_lamp({.name = {}, .position = {-1, 1, 0}, .intensity = glm::vec3(0.5f)});
        studio.open();
        const render::Environment night = test::even_light(0.0f);
        render::PathSettings one = cook(128), all = test::reference(128);
        one.environment = all.environment = &night;
        const render::Camera camera = test::narrow({0.0f, 0.8f, 0.6f}, 0.0f, -0.8f);
        test::expect_same_mean(test::means(studio, camera, one), test::means(studio, camera, all),
                               "metallic " + std::to_string(metallic));
    }
}

// In a baked room: Cook's dull surfaces give back lamps' light and the bake's, each once.
TEST(Cook, AddsTheBakedLightOnce) {
    Studio studio;
    studio.add_box({-3, 0, -3}, {3, 3, 3}, test::matte(glm::vec3(0.5f)), true);
    studio.add_sheet({0, 2.9f, 0}, {1, 0, 0}, {0, 0, 1}, test::glowing(5.0f));
    studio.open({.bakes_ambient = true});
    const render::Camera floor = test::narrow({1.5f, 1.0f, 1.0f}, 0.0f, test::kDown);
    const double truth = test::moments(test::means(studio, floor, test::reference(), 8)).mean;
    const double seen = test::moments(test::means(studio, floor, cook(64), 8)).mean;
    EXPECT_NEAR(seen / truth, 1.0,
                0.3);  // what the bake is off by (path_real_time_test.cpp); twice the panel would be 2
}

TEST(Cook, FiltersKeepTheirMiddleAndTheirWidth) {
    // Variances: box 1/12, tent 1/6, Gaussian 1/4 less what is cut off at a pixel and a half.
    const double cut = std::exp(-4.5), gaussian = 0.25 * (1.0 - 4.5 * cut / (1.0 - cut));
    for (const auto& [filter, expected] :
         {std::pair(render::PixelFilter::Box, 1.0 / 12.0), std::pair(render::PixelFilter::Tent, 1.0 / 6.0),
          std::pair(render::PixelFilter::Gaussian, gaussian)}) {
        constexpr int kSide = 256;
        glm::dvec2 mean(0.0), square(0.0);
        for (int i = 0; i < kSide * kSide; ++i) {
            const glm::vec2 u((static_cast<float>(i % kSide) + 0.5f) / kSide,
                              (static_cast<float>(i / kSide) + 0.5f) / kSide);
            const glm::dvec2 p(render::filter_point(filter, u) - glm::vec2(0.5f));
            mean += p;
            square += p * p;
        }
        const double count = kSide * kSide;
        for (glm::length_t axis = 0; axis < 2; ++axis) {
            EXPECT_NEAR(mean[axis] / count, 0.0, 1e-4);
            EXPECT_NEAR(square[axis] / count, expected, 2e-3 * expected);
        }
    }
}

}  // namespace
}  // namespace gh
