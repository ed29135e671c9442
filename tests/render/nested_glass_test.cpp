// Bodies of glass that lie in each other, share a wall or overlap: light sees one body at each place, and a border only
// where that body changes (Schmidt and Budge 2002). A lens glued together, a bubble, water in a tumbler.
#include "path_studio.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace gh {
namespace {

using test::Studio;

world::Material glass(float ior, int priority = 0) {
    world::Material material = test::clear_glass(ior);
    material.priority = static_cast<std::int16_t>(priority);
    return material;
}

// A wall that glows with 1, seen straight through whatever stands before it. Panes split the eye's path, so that chance
// decides only what has been mirrored to and fro several times: after four borders, so that two borders come out to 1e-7
// and more of them with the noise of that chance (the t-test knows it).
Studio before_a_wall() {
    Studio studio;
    studio.add_sheet({0, 0, -3}, {8, 0, 0}, {0, 8, 0}, test::glowing(1.0f));
    return studio;
}

std::vector<double> seen_through(Studio& studio, int seeds = 16) {
    studio.open();
    render::PathSettings settings = test::reference(64);
    settings.splits_glass = true;
    settings.uses_roulette = false;
    return test::means(studio, test::narrow({0.1f, 0.13f, 2}), settings, seeds);
}

double reflectance(double from, double to) {
    const double ratio = (from - to) / (from + to);
    return ratio * ratio;
}

// What flat parallel borders let through, everything that goes to and fro between them added up.
double let_through(const std::vector<double>& iors) {
    double through = 1.0, back = 0.0;  // of the stack so far, seen from behind
    for (std::size_t i = 0; i + 1 < iors.size(); ++i) {
        const double r = reflectance(iors[i], iors[i + 1]);
        const double echo = 1.0 / (1.0 - back * r);
        back = r + (1.0 - r) * (1.0 - r) * back * echo;
        through *= (1.0 - r) * echo;
    }
    return through;
}

TEST(NestedGlass, TheClosedFormIsThatOfASlab) {
    EXPECT_NEAR(let_through({1.0, 1.5, 1.0}), 12.0 / 13.0, 1e-12);
}

TEST(NestedGlass, ABodyInABodyOfTheSameIndexCannotBeSeen) {
    for (const int priority : {0, 1}) {
        Studio studio = before_a_wall();
        studio.add_box({-2, -2, -1}, {2, 2, 1}, glass(1.5f));
        studio.add_ball({0.2f, 0.1f, 0.0f}, 0.7f, 24, glass(1.5f, priority));
        test::expect_mean(seen_through(studio), 12.0 / 13.0, 1e-6, "priority " + std::to_string(priority));
    }
}

TEST(NestedGlass, TwoBodiesOfOneIndexThatShareAWallAreOne) {
    for (const bool is_far_first : {false, true}) {
        Studio studio = before_a_wall();
        for (const bool is_far : {is_far_first, !is_far_first}) {
            studio.add_box({-2, -2, is_far ? -1.0f : 0.0f}, {2, 2, is_far ? 0.0f : 1.0f}, glass(1.5f));
        }
        EXPECT_EQ(studio.level.parts.size(), 3u);
        test::expect_mean(seen_through(studio), 12.0 / 13.0, 1e-6);
        EXPECT_TRUE(studio.prepared.needs.has(render::Need::NestedGlass));
    }
}

TEST(NestedGlass, TwoGlassesThatShareAWallMirrorByWhatTheyDiffer) {
    for (const bool is_far_first : {false, true}) {
        Studio studio = before_a_wall();
        for (const bool is_far : {is_far_first, !is_far_first}) {
            studio.add_box({-2, -2, is_far ? -1.0f : 0.0f}, {2, 2, is_far ? 0.0f : 1.0f},
                           glass(is_far ? 1.9f : 1.4f));
        }
        const auto f = [](float x) { return static_cast<double>(x); };
        test::expect_mean(seen_through(studio), let_through({1.0, f(1.4f), f(1.9f), 1.0}), 4e-5);
    }
}

// Water drawn a little into the tumbler's side, as one has to draw it: the tumbler, of the higher priority, is there.
TEST(NestedGlass, WhereBodiesOverlapTheOneOfTheHigherPriorityIsThere) {
    for (const bool is_glass_first : {false, true}) {
        Studio studio = before_a_wall();
        const auto add_side = [&] { studio.add_box({-2, -2, 0}, {2, 2, 1}, glass(1.5f, 1)); };
        if (is_glass_first) add_side();
        studio.add_box({-2, -2, -1}, {2, 2, 0.3f}, glass(1.33f, 0));
        if (!is_glass_first) add_side();
        const double water = static_cast<double>(1.33f);
        test::expect_mean(seen_through(studio), let_through({1.0, 1.5, water, 1.0}), 1e-5);
    }
}

// What absorbs does so only where it is there: of 1.3 m of dark water .3 m lie in the clear tumbler's side.
TEST(NestedGlass, WhatIsNotThereAbsorbsNothing) {
    Studio studio = before_a_wall();
    world::Material water = glass(1.5f, 0);
    water.attenuation_color = glm::vec3(0.5f);
    water.attenuation_distance = 1.0f;
    studio.add_box({-2, -2, 0}, {2, 2, 1}, glass(1.5f, 1));
    studio.add_box({-2, -2, -1}, {2, 2, 0.3f}, water);
    const double r = 0.04, a = 0.5;
    test::expect_mean(seen_through(studio), (1 - r) * (1 - r) * a / (1 - r * r * a * a), 1e-5);
}

// The eye in the water, behind the tumbler's side, and a bubble that is no glass at all.
TEST(NestedGlass, AHoleInGlassIsAir) {
    Studio studio = before_a_wall();
    world::Mesh hollow;
    const auto add_box = [&](float half, bool is_inside_out) {
        Studio box;
        box.add_box(glm::vec3(-half), glm::vec3(half), glass(1.5f), is_inside_out);
        const world::Mesh& mesh = box.level.meshes[0];
        const auto first = static_cast<std::uint32_t>(hollow.positions.size());
        hollow.positions.insert(hollow.positions.end(), mesh.positions.begin(), mesh.positions.end());
        hollow.normals.insert(hollow.normals.end(), mesh.normals.begin(), mesh.normals.end());
        for (const glm::uvec3& t : mesh.triangles) hollow.triangles.push_back(t + glm::uvec3(first));
    };
    add_box(1.0f, false);
    add_box(0.5f, true);
    studio.add_part(std::move(hollow), glass(1.5f));
    test::expect_mean(seen_through(studio), let_through({1.0, 1.5, 1.0, 1.5, 1.0}), 6e-5);
}

world::Material tinted(float ior, float left_by_a_metre) {
    world::Material material = glass(ior);
    material.attenuation_color = glm::vec3(left_by_a_metre);
    material.attenuation_distance = 1.0f;
    return material;
}

// What a point lamp 3 m above a floor gives it straight through what stands between, over what it gives without.
void expect_straight_share(Studio& studio, double share, const char* what) {
    studio.add_sheet(glm::vec3(0.0f), {0, 0, 10}, {10, 0, 0}, test::matte(glm::vec3(1.0f)));
    studio.add_lamp(
        {.name = {}, .shape = world::LampShape::Point, .position = {0, 3, 0}, .intensity = glm::vec3(9.0f)});
    studio.open();
    render::PathSettings settings = test::reference(4);
    settings.caustics = render::Caustics::Unbent;
    settings.max_depth = 1;  // what glass mirrors back to the floor is another story
    const render::Environment night = test::even_light(0.0f);
    settings.environment = &night;
    // The picture is 1e-3 wide, so that its light is the middle's to 1e-6.
    for (const double mean : test::means(studio, test::looking_down(), settings, 3))
        EXPECT_NEAR(mean * 3.14159265358979, share, 2e-5) << what;
}

// With --unbent lamps shine straight through glass: past the same borders, and through as much of each body, as paths see.
TEST(NestedGlass, StraightShadowRaysKnowWhichBodyTheyAreIn) {
    {
        Studio studio;
        studio.add_box({-2, 1, -2}, {2, 2, 2}, tinted(1.5f, 0.7f));
        const double r = reflectance(1.0, 1.5);
        expect_straight_share(studio, (1 - r) * (1 - r) * 0.7, "one body");
    }
    {
        Studio studio;
        studio.add_box({-2, 1, -2}, {2, 2, 2}, tinted(1.5f, 0.7f));
        studio.add_box({-1, 1.3f, -1}, {1, 1.6f, 1}, tinted(1.2f, 0.5f));
        const double outer = 1 - reflectance(1.0, 1.5), inner = 1 - reflectance(1.5, 1.2);
        expect_straight_share(studio, outer * outer * inner * inner * std::pow(0.7, 0.7) * std::pow(0.5, 0.3),
                              "a body in a body");
    }
    for (const bool is_upper_first : {false, true}) {
        Studio studio;
        for (const bool is_upper : {is_upper_first, !is_upper_first})
            studio.add_box({-2, is_upper ? 1.5f : 1.0f, -2}, {2, is_upper ? 2.0f : 1.5f, 2},
                           tinted(1.5f, is_upper ? 0.5f : 0.7f));
        // Of one index: the wall they share is no border.
        const double r = reflectance(1.0, 1.5);
        expect_straight_share(studio, (1 - r) * (1 - r) * std::sqrt(0.5 * 0.7),
                              "two bodies that share a wall");
    }
}

}  // namespace
}  // namespace gh
