// Lamps, looked at by path tracing where the answer is known in closed form.
#include "base/det_math.h"
#include "path_studio.h"
#include "render/lamp.h"

#include <gtest/gtest.h>

namespace gh {
namespace {

using render::LampFinding;
using test::expect_mean;
using test::means;
using test::Studio;

constexpr LampFinding kFindings[] = {LampFinding::Both, LampFinding::AskOnly, LampFinding::MeetOnly};

world::Lamp panel(const glm::vec3& position, float half_side) {
    world::Lamp lamp;
    lamp.shape = world::LampShape::Rect;
    lamp.position = position;
    lamp.half_u = {half_side, 0.0f, 0.0f};
    lamp.half_v = {0.0f, 0.0f, half_side};
    lamp.intensity = glm::vec3(1.0f);
    return lamp;
}

void add_floor(Studio& studio, float albedo) {
    studio.add_sheet(glm::vec3(0.0f), {0, 0, 10}, {10, 0, 0}, test::matte(glm::vec3(albedo)));
}

// Who asks the panel is off by its cosines only; who does not is lucky 24 times in 100, and worth all or nothing: by chance
// alone .5 sqrt(.239 (1 - .239) / n) = 6.8e-4 for these n = 98,304 paths. Sobol's points leave 2.3e-4, of which four are
// allowed; the table's 1e-4 would take a hundred times as many.
double tolerance(LampFinding finding) {
    return finding == LampFinding::MeetOnly ? 1e-3 : 1e-4;
}

TEST(PathLight, ASquarePanelOverAFloorGivesLambertsFormFactor) {
    Studio studio;
    add_floor(studio, 0.5f);
    studio.add_lamp(panel({0, 1, 0}, 0.5f));
    studio.open();
    for (const LampFinding finding : kFindings) {
        render::PathSettings settings = test::reference(256);
        settings.lamps = finding;
        expect_mean(means(studio, test::looking_down(), settings), 0.11972824, tolerance(finding));
    }
}

TEST(PathLight, APanelMadeOfTrianglesGivesTheSame) {
    Studio studio;
    add_floor(studio, 0.5f);
    studio.add_sheet({0, 1, 0}, {0.5f, 0, 0}, {0, 0, 0.5f}, test::glowing(1.0f));  // shines down
    studio.open();
    ASSERT_EQ(studio.prepared.emitters.size(), 1u);
    EXPECT_EQ(studio.prepared.emitters[0].kind, render::EmitterKind::Rect);
    for (const LampFinding finding : kFindings) {
        render::PathSettings settings = test::reference(256);
        settings.lamps = finding;
        expect_mean(means(studio, test::looking_down(), settings), 0.11972824, tolerance(finding));
    }
}

// The same square as four triangles around its middle is no longer a rectangle to the renderer.
TEST(PathLight, SingleTrianglesAreAskedWithoutBias) {
    Studio studio;
    add_floor(studio, 0.5f);
    world::Mesh mesh;
    mesh.positions = {
        {-0.5f, 1, -0.5f}, {0.5f, 1, -0.5f}, {0.5f, 1, 0.5f}, {-0.5f, 1, 0.5f}, {0.1f, 1, 0.2f}};
    mesh.normals.assign(5, {0, -1, 0});
    mesh.triangles = {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}};
    studio.add_part(std::move(mesh), test::glowing(1.0f));
    studio.open();
    EXPECT_EQ(studio.prepared.emitters[0].kind, render::EmitterKind::Triangles);
    for (const LampFinding finding : {LampFinding::Both, LampFinding::AskOnly}) {
        render::PathSettings settings = test::reference(256);
        settings.lamps = finding;
        expect_mean(means(studio, test::looking_down(), settings), 0.11972824, 1e-4);
    }
}

TEST(PathLight, ASmallPanelGivesItsSolidAngleDownToAMicrometre) {
    for (const float side : {1e-2f, 1e-4f, 1e-6f}) {
        Studio studio;
        add_floor(studio, 1.0f);
        studio.add_lamp(panel({0, 1, 0}, 0.5f * side));
        studio.open();
        const double truth = static_cast<double>(side) * static_cast<double>(side) / 3.14159265358979;
        std::vector<double> relative = means(studio, test::looking_down(), test::reference(16), 8);
        for (double& r : relative) r /= truth;
        expect_mean(relative, 1.0 - static_cast<double>(side) * static_cast<double>(side) / 3.0, 1e-5);
    }
}

TEST(PathLight, ABallGivesTheCosineOfItsMiddle) {
    for (const bool is_mesh : {false, true}) {
        Studio studio;
        add_floor(studio, 0.8f);
        const glm::vec3 centre(0.9f, 1.2f, 0.0f);
        constexpr float kRadius = 0.3f;
        if (is_mesh) {
            studio.add_ball(centre, kRadius, 96, test::glowing(2.0f));
        } else {
            studio.add_lamp({.name = {},
                             .shape = world::LampShape::Sphere,
                             .position = centre,
                             .intensity = glm::vec3(2.0f),
                             .radius = kRadius});
        }
        studio.open();
        if (is_mesh) {
            EXPECT_EQ(studio.prepared.emitters[0].kind, render::EmitterKind::Bulb);
        }
        const double d2 = 0.9 * 0.9 + 1.2 * 1.2;
        const double truth = 0.8 * 2.0 * 0.3 * 0.3 / d2 * 1.2 / std::sqrt(d2);
        expect_mean(means(studio, test::looking_down(), test::reference(256)),
                    is_mesh ? truth * 0.9996 : truth, 1e-4);
    }
}

TEST(PathLight, WhatOfALampIsBelowTheHorizonGivesNothing) {
    Studio studio;
    add_floor(studio, 1.0f);
    world::Lamp ball{.name = {},
                     .shape = world::LampShape::Sphere,
                     .position = {1.5f, 0.1f, 0},
                     .intensity = glm::vec3(1.0f),
                     .radius = 0.5f};
    world::Lamp wall = panel({-1.0f, 0.0f, 0.0f}, 1.0f);
    wall.direction = {1, 0, 0};
    wall.half_u = {0, 0.6f, 0};
    wall.half_v = {0, 0, 0.6f};
    studio.add_lamp(ball);
    studio.add_lamp(wall);
    studio.open();
    const glm::vec3 up(0, 1, 0);
    const double truth =
        static_cast<double>(
            (render::lamp_irradiance(ball, {}, up) + render::lamp_irradiance(wall, {}, up)).y) /
        3.14159265358979;
    // Half of what is asked of these lamps lies below: 256 samples would leave a standard error of 1.2e-4.
    expect_mean(means(studio, test::looking_down(), test::reference(1024)), truth, 1e-4);
}

TEST(PathLight, PointSpotAndSunAreTheLampsThatWhittedKnows) {
    Studio studio;
    add_floor(studio, 1.0f);
    world::Lamp point{
        .name = {}, .shape = world::LampShape::Point, .position = {1, 1, 0}, .intensity = glm::vec3(2.0f)};
    world::Lamp spot = point;
    spot.shape = world::LampShape::Spot;
    spot.position = {-1, 2, 0.5f};
    spot.direction = glm::normalize(glm::vec3(1, -2, 0));
    spot.cos_inner = 0.99f;
    spot.cos_outer = 0.8f;
    world::Lamp sun = point;
    sun.shape = world::LampShape::Sun;
    sun.direction = glm::normalize(glm::vec3(0.2f, -1, 0.3f));
    sun.intensity = glm::vec3(0.7f);
    double truth = 0.0;
    for (const world::Lamp& lamp : {point, spot, sun}) {
        studio.add_lamp(lamp);
        truth += static_cast<double>(render::lamp_irradiance(lamp, {}, {0, 1, 0}).y) / 3.14159265358979;
    }
    studio.open();
    const render::Environment night = test::even_light(0.0f);
    render::PathSettings settings = test::reference(256);
    settings.environment = &night;
    expect_mean(means(studio, test::looking_down(), settings), truth, 2e-4);
}

TEST(PathLight, AClosedRoomSumsItsBounces) {
    for (const int depth : {0, 1, 2, 5}) {
        Studio studio;
        world::Material wall = test::matte(glm::vec3(0.6f));
        wall.emission = glm::vec3(1.0f);
        studio.add_box({-1, -1, -1}, {1, 1, 1}, wall, true);
        studio.open();
        render::PathSettings settings = test::reference(64);
        settings.max_depth = depth;
        const double truth = (1.0 - std::pow(0.6, depth + 1)) / 0.4;
        // Lamps that are asked add noise to what no chance decides: the row's 2e-4 is held, and more, further below.
        expect_mean(means(studio, test::narrow({0.2f, -0.3f, 0.1f}, 0.3f), settings), truth,
                    depth < 2 ? 1e-3 : 5e-3);
        settings.lamps = LampFinding::MeetOnly;
        settings.uses_roulette = false;
        for (const double mean : means(studio, test::narrow({0.2f, -0.3f, 0.1f}, 0.3f), settings, 3))
            EXPECT_NEAR(mean, truth, 1e-5);  // every path gives the same: no variance
    }
}

TEST(PathLight, TwoFacingMirrorsThatGlowSumTheirReflectionsWithoutVariance) {
    Studio studio;
    world::Material mirror = test::mirror(0.9f);
    mirror.emission = glm::vec3(1.0f);
    studio.add_sheet({0, 0, -1}, {2, 0, 0}, {0, 2, 0}, mirror);
    studio.add_sheet({0, 0, 1}, {0, 2, 0}, {2, 0, 0}, mirror);
    studio.open();
    for (const int depth : {1, 4, 12}) {
        render::PathSettings settings = test::reference(1);
        settings.max_depth = depth;
        settings.uses_roulette = false;
        settings.jitters = false;
        const double truth = (1.0 - std::pow(0.9, depth + 1)) / 0.1;
        for (const double mean : means(studio, test::narrow({0, 0, 0}), settings, 2))
            EXPECT_NEAR(mean / truth, 1.0, 1e-5);
    }
}

TEST(PathLight, AnEvenSkyIsTheSameAskedOrMet) {
    Image picture(8, 4);
    for (int y = 0; y < 4; ++y)
        for (int x = 0; x < 8; ++x) picture.at(x, y) = glm::vec3(static_cast<float>((x * 5 + y * 3) % 7));
    const render::Environment sky(std::move(picture));
    Studio studio;
    add_floor(studio, 0.7f);
    studio.open();
    std::vector<std::vector<double>> results;
    for (const LampFinding finding : kFindings) {
        render::PathSettings settings = test::reference(64);
        settings.environment = &sky;
        settings.lamps = finding;
        results.push_back(means(studio, test::looking_down(), settings));
    }
    test::expect_same_mean(results[0], results[1], "both, asked");
    test::expect_same_mean(results[0], results[2], "both, met");
}

// Many lamps of every kind, near and far, above and below, and something in between.
TEST(PathLight, AskedMetAndBothAgreeAmongManyLamps) {
    for (const float roughness : {1.0f, 0.3f}) {
        Studio studio;
        world::Material floor = test::mirror(0.8f);
        floor.roughness = roughness;
        floor.metallic = roughness < 1.0f ? 1.0f : 0.0f;
        studio.add_sheet(glm::vec3(0.0f), {0, 0, 10}, {10, 0, 0}, floor);
        for (int i = 0; i < 12; ++i) {
            const float a = 0.5f * static_cast<float>(i);
            const glm::vec3 centre(2.0f * std::cos(a), 0.7f + 0.1f * static_cast<float>(i),
                                   2.0f * std::sin(a));
            if (i % 2 == 0) {
                studio.add_ball(centre, 0.3f, 6, test::glowing(static_cast<float>(1 + i)));
            } else {
                studio.add_sheet(centre, {0.4f, 0, 0}, {0, 0.1f, 0.3f},
                                 test::glowing(static_cast<float>(1 + i)));
            }
        }
        studio.add_box({0.6f, 0.1f, -0.2f}, {0.8f, 0.9f, 0.4f}, test::matte(glm::vec3(0.3f)));
        studio.open();
        std::vector<std::vector<double>> results;
        for (const LampFinding finding : kFindings) {
            render::PathSettings settings = test::reference(128);
            settings.lamps = finding;
            settings.max_depth = 3;
            results.push_back(means(studio, test::narrow({0.0f, 0.8f, 1.0f}, 0.0f, -0.6747f), settings));
        }
        test::expect_same_mean(results[0], results[1], "both, asked");
        test::expect_same_mean(results[0], results[2], "both, met");
    }
}

TEST(PathLight, RouletteChangesNothingButNoise) {
    Studio studio;
    world::Material wall = test::matte({0.9f, 0.7f, 0.5f});
    studio.add_box({-1, -1, -1}, {1, 1, 1}, wall, true);
    studio.add_sheet({0, 0.99f, 0}, {0.3f, 0, 0}, {0, 0, 0.3f}, test::glowing(5.0f));
    studio.open();
    render::PathSettings settings = test::reference(64);
    const auto with = means(studio, test::narrow({0, 0, 0.5f}), settings);
    settings.uses_roulette = false;
    test::expect_same_mean(with, means(studio, test::narrow({0, 0, 0.5f}), settings));
}

}  // namespace
}  // namespace gh
