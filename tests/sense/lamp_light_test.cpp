// The light on a body is physics, so that a player can reason about it: closed forms for every kind of lamp.
#include "sense/lamp_light.h"

#include "base/det_math.h"
#include "sense/glass.h"
#include "support/rest_scene.h"
#include "support/small_level.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <cmath>

namespace gh::sense {
namespace {

constexpr double kPiD = 3.14159265358979323846;
const glm::vec3 kUp(0.0f, 1.0f, 0.0f);

glm::vec3 light_on(const world::Level& level, const Probe& probe, std::size_t lamp = 0) {
    glm::vec3 light;
    irradiance_from_lamp(level, *test::rest_scene(level), lamp, {&probe, 1}, {&light, 1});
    return light;
}

world::Lamp point_lamp(const glm::vec3& position, const glm::vec3& intensity) {
    world::Lamp lamp;
    lamp.position = position;
    lamp.intensity = intensity;
    return lamp;
}

world::Lamp ball_lamp(const glm::vec3& position, float radius) {
    world::Lamp lamp;
    lamp.shape = world::LampShape::Sphere;
    lamp.position = position;
    lamp.radius = radius;
    lamp.intensity = glm::vec3(100.0f);
    return lamp;
}

// Shines down from y = 1.
world::Lamp panel_lamp(float half_side) {
    world::Lamp lamp;
    lamp.shape = world::LampShape::Rect;
    lamp.position = kUp;
    lamp.direction = -kUp;
    lamp.half_u = {half_side, 0.0f, 0.0f};
    lamp.half_v = {0.0f, 0.0f, half_side};
    lamp.intensity = glm::vec3(1.0f);
    return lamp;
}

world::Material tinted_glass(const glm::vec3& tint, float ior) {
    world::Material glass;
    glass.base_color = glm::vec4(tint, 1.0f);
    glass.transmission = 1.0f;
    glass.ior = ior;
    glass.surface = world::Surface::Glass;
    return glass;
}

TEST(LampLight, APointLampTwiceAsFarGivesAQuarter) {
    test::SmallLevel small;
    small.add_lamp(point_lamp({0.0f, 2.0f, 0.0f}, {8.0f, 4.0f, 2.0f}));
    const glm::vec3 near = light_on(small.level, {.position = {0.0f, 1.0f, 0.0f}, .normal = kUp});
    const glm::vec3 far = light_on(small.level, {.position = {0.0f, 0.0f, 0.0f}, .normal = kUp});
    EXPECT_EQ(near, glm::vec3(8.0f, 4.0f, 2.0f)) << "I / r^2 at one metre";
    EXPECT_EQ(far, near / 4.0f);
    // On a patch turned away by 60 degrees, half of that; a small ball always turns a side to the lamp.
    const glm::vec3 tilted(std::sqrt(0.75f), 0.5f, 0.0f);
    EXPECT_NEAR(light_on(small.level, {.position = glm::vec3(0.0f), .normal = tilted}).r, far.r / 2.0f,
                1e-6f);
    EXPECT_EQ(light_on(small.level, {.position = glm::vec3(0.0f)}), far);
    EXPECT_EQ(light_on(small.level, {.position = glm::vec3(0.0f), .normal = -kUp}), glm::vec3(0.0f));
}

TEST(LampLight, ASpotFadesBetweenItsConesAndEndsAtTheOuter) {
    test::SmallLevel small;
    world::Lamp spot = point_lamp({0.0f, 2.0f, 0.0f}, glm::vec3(4.0f));
    spot.shape = world::LampShape::Spot;
    spot.cos_inner = 0.9f;
    spot.cos_outer = 0.7f;
    small.add_lamp(spot);
    const auto share_at = [&](double cosine) {  // of the full light, on the floor two metres below
        const double aside = 2.0 * std::sqrt(1.0 / (cosine * cosine) - 1.0);
        const glm::vec3 light = light_on(small.level, {.position = {static_cast<float>(aside), 0.0f, 0.0f}});
        return static_cast<double>(light.r) * (4.0 + aside * aside) / 4.0;
    };
    EXPECT_NEAR(share_at(0.95), 1.0, 1e-5);
    EXPECT_NEAR(share_at(0.8), 0.25, 1e-5);  // ((.8 - .7) / .2)^2
    EXPECT_EQ(share_at(0.65), 0.0);
}

// Four rays, placed so that their sum is the closed form itself: 1e-5 is rounding, not sampling.
TEST(LampLight, ABallGivesPiLTimesItsApparentSizeTimesTheCosine) {
    for (const float radius : {0.01f, 0.06f, 0.5f}) {
        test::SmallLevel small;
        small.add_lamp(ball_lamp({0.3f, 2.0f, -0.4f}, radius));
        const glm::vec3 from(-0.5f, 0.1f, 0.7f);
        const glm::vec3 way = small.level.lamps[0].position - from;
        const double d = static_cast<double>(glm::length(way));
        for (const glm::vec3& normal : {glm::normalize(way), glm::vec3(0.0f, 1.0f, 0.0f)}) {
            const double cosine = static_cast<double>(glm::dot(glm::normalize(way), normal));
            const double exact = kPiD * 100.0 * std::pow(static_cast<double>(radius) / d, 2.0) * cosine;
            const glm::vec3 light = light_on(small.level, {.position = from, .normal = normal});
            EXPECT_NEAR(static_cast<double>(light.r) / exact, 1.0, 1e-5)
                << "radius " << radius << ", cosine " << cosine;
        }
        // Scalar irradiance: L times the solid angle.
        const double sine = static_cast<double>(radius) / d;
        const double solid_angle = 2.0 * kPiD * (1.0 - std::sqrt(1.0 - sine * sine));
        EXPECT_NEAR(static_cast<double>(light_on(small.level, {.position = from}).r) / (100.0 * solid_angle),
                    1.0, 1e-4);
    }
}

TEST(LampLight, AScreenAcrossHalfTheBallTakesHalfItsLight) {
    test::SmallLevel small;
    const std::uint32_t plaster = small.add_material(world::Surface::Plaster);
    small.add_lamp(ball_lamp({0.0f, 2.0f, 0.0f}, 0.2f));
    const Probe probe{.position = glm::vec3(0.0f), .normal = kUp};
    const float open = light_on(small.level, probe).r;
    // Covers x + z > 0: the edge passes between the four rays, two on either side.
    const float s = std::sqrt(0.5f);
    small.add_sheet(glm::vec3(s, 1.0f, s), {s, 0.0f, s}, {-2.0f, 0.0f, 2.0f}, plaster);
    EXPECT_NEAR(light_on(small.level, probe).r, open / 2.0f, open * 1e-5f);
}

// L = 1, one metre square, one metre above: E = 0.75227478 in closed form; the 4 x 4 Gauss points err by 3.6e-4 of it,
// and the error shrinks with the square of the lamp.
TEST(LampLight, APanelGivesItsFormFactor) {
    for (const auto& [half_side, tolerance] : {std::pair(0.5, 4e-4), std::pair(0.1, 4e-6)}) {
        test::SmallLevel small;
        small.add_lamp(panel_lamp(static_cast<float>(half_side)));
        // Form factor of a quarter of the panel seen from under its corner, four times (Howell C-11, parallel).
        const double x = half_side / std::sqrt(1.0 + half_side * half_side);
        const double exact = 4.0 * x * std::atan(x);
        const float light = light_on(small.level, {.position = glm::vec3(0.0f), .normal = kUp}).r;
        EXPECT_NEAR(static_cast<double>(light) / exact, 1.0, tolerance);
    }
    EXPECT_NEAR(0.5 / std::sqrt(1.25) * std::atan(0.5 / std::sqrt(1.25)) * 4.0, 0.75227478, 1e-7);
}

TEST(LampLight, APanelShinesToOneSideOnly) {
    test::SmallLevel small;
    small.add_lamp(panel_lamp(0.5f));
    EXPECT_EQ(light_on(small.level, {.position = {0.0f, 1.5f, 0.0f}}), glm::vec3(0.0f));
    EXPECT_GT(light_on(small.level, {.position = {0.0f, 0.5f, 0.0f}}).r, 0.0f);
}

TEST(LampLight, TheSunShinesWhereNothingIsOverhead) {
    test::SmallLevel small;
    const std::uint32_t plaster = small.add_material(world::Surface::Plaster);
    small.add_box({-1.0f, 3.0f, -1.0f}, {1.0f, 3.1f, 1.0f}, plaster);
    world::Lamp sun;
    sun.shape = world::LampShape::Sun;
    sun.direction = -kUp;
    sun.intensity = glm::vec3(0.2f);
    small.add_lamp(sun);
    EXPECT_EQ(light_on(small.level, {.position = glm::vec3(0.0f)}), glm::vec3(0.0f));
    EXPECT_EQ(light_on(small.level, {.position = {40.0f, 0.0f, 0.0f}, .normal = kUp}), glm::vec3(0.2f));
}

TEST(LampLight, ATintedPaneLetsItsTintThrough) {
    const glm::vec3 tint(0.5f, 0.7f, 0.9f);
    test::SmallLevel small;
    small.add_lamp(point_lamp({0.0f, 2.0f, 0.0f}, glm::vec3(4.0f)));
    const std::uint32_t gel = small.add_material(tinted_glass(tint, 1.0f));  // ior 1: nothing is reflected
    small.add_sheet({0.0f, 1.0f, 0.0f}, {1.0f, 0.0f, 0.0f}, {0.0f, 0.0f, -1.0f}, gel);
    const glm::vec3 light = light_on(small.level, {.position = glm::vec3(0.0f)});
    for (glm::length_t c = 0; c < 3; ++c) EXPECT_NEAR(light[c], tint[c], 1e-6f);

    // A second one: tau squared.
    small.add_sheet({0.0f, 0.5f, 0.0f}, {1.0f, 0.0f, 0.0f}, {0.0f, 0.0f, 1.0f}, gel);
    EXPECT_NEAR(light_on(small.level, {.position = glm::vec3(0.0f)}).g, tint.g * tint.g, 1e-6f);
}

TEST(LampLight, APaneReflectsByFresnelAtBothFacesAndAbsorbsBetween) {
    test::SmallLevel small;
    small.add_lamp(point_lamp({0.0f, 2.0f, 0.0f}, glm::vec3(4.0f)));
    world::Material glass = tinted_glass(glm::vec3(1.0f), 1.5f);
    glass.attenuation_color = {1.0f, 0.5f, 0.25f};
    glass.attenuation_distance = 0.1f;
    const std::uint32_t pane = small.add_material(glass);
    small.add_box({-1.0f, 1.0f, -1.0f}, {1.0f, 1.2f, 1.0f}, pane);
    const glm::vec3 light = light_on(small.level, {.position = glm::vec3(0.0f)});
    const float faces = 0.96f * 0.96f;  // ((n - 1) / (n + 1))^2 = 0.04 at each
    EXPECT_NEAR(light.r, faces, 1e-5f);
    EXPECT_NEAR(light.g, faces * 0.25f, 1e-5f);  // 0.2 m: the colour of 0.1 m, twice
    EXPECT_NEAR(light.b, faces * 0.0625f, 1e-5f);
}

TEST(LampLight, AThinSheetLetsThroughWhatASlabDoes) {
    test::SmallLevel small;
    small.add_lamp(point_lamp({0.0f, 2.0f, 0.0f}, glm::vec3(4.0f)));
    const std::uint32_t glass = small.add_material(tinted_glass(glm::vec3(1.0f), 1.5f));
    small.add_sheet({0.3f, 1.0f, 0.1f}, {1.0f, 0.0f, 0.0f}, {0.0f, 0.0f, -1.0f}, glass);
    // (1 - R) / (1 + R) with R = 0.04: all passes to and fro between its two borders.
    EXPECT_NEAR(light_on(small.level, {.position = glm::vec3(0.0f)}).r, 0.923077f, 1e-5f);
}

TEST(Glass, FresnelAtKnownAngles) {
    EXPECT_NEAR(fresnel_reflectance(1.0f, 1.5f), 0.04f, 1e-6f);
    EXPECT_NEAR(fresnel_reflectance(0.0f, 1.5f), 1.0f, 1e-6f);
    // At Brewster's angle one polarisation is not reflected at all: half of ((n^2 - 1) / (n^2 + 1))^2 is left.
    const float brewster = 1.0f / std::sqrt(1.0f + 1.5f * 1.5f);
    EXPECT_NEAR(fresnel_reflectance(brewster, 1.5f), 0.5f * std::pow(1.25f / 3.25f, 2.0f), 1e-6f);
}

TEST(LampLight, ABulbNeverShadowsItsOwnLampButAnotherBulbDoes) {
    test::SmallLevel small;
    const std::uint32_t brass = small.add_material(world::Surface::Metal);
    const std::uint32_t bulb = small.add_box({-0.1f, 1.9f, -0.1f}, {0.1f, 2.1f, 0.1f}, brass);
    world::Lamp lamp = point_lamp({0.0f, 2.0f, 0.0f}, glm::vec3(4.0f));
    small.add_lamp(lamp);
    EXPECT_EQ(light_on(small.level, {.position = glm::vec3(0.0f)}), glm::vec3(0.0f));
    small.level.lamps[0].part = bulb;
    EXPECT_EQ(light_on(small.level, {.position = glm::vec3(0.0f)}), glm::vec3(1.0f));
    // Through a pane in front of the bulb too.
    const std::uint32_t gel = small.add_material(tinted_glass(glm::vec3(0.5f), 1.0f));
    small.add_sheet({0.0f, 1.0f, 0.0f}, {1.0f, 0.0f, 0.0f}, {0.0f, 0.0f, -1.0f}, gel);
    EXPECT_EQ(light_on(small.level, {.position = glm::vec3(0.0f)}), glm::vec3(0.5f));
}

TEST(LampLight, NothingArrivesBeyondALampsRange) {
    test::SmallLevel small;
    world::Lamp lamp = point_lamp({0.0f, 2.0f, 0.0f}, glm::vec3(4.0f));
    lamp.range = 1.5f;
    small.add_lamp(lamp);
    EXPECT_EQ(light_on(small.level, {.position = glm::vec3(0.0f)}), glm::vec3(0.0f));
    EXPECT_GT(light_on(small.level, {.position = {0.0f, 1.0f, 0.0f}}).r, 0.0f);
}

}  // namespace
}  // namespace gh::sense
