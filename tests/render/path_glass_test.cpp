// Glass in closed form: slabs, balls, panes, what lies beyond the critical angle, glass in glass.
#include "path_studio.h"
#include "render/bsdf.h"
#include "shaded.h"

#include <gtest/gtest.h>

namespace gh {
namespace {

using render::Bsdf;
using test::energy;
using test::expect_mean;
using test::facing_z;
using test::means;
using test::Studio;
using test::tilted;

// Bent light goes both ways alike, but for the squeeze by eta^2.
TEST(PathGlass, RoughGlassIsReciprocal) {
    world::Material material = test::clear_glass(1.5f);
    material.roughness = 0.5f;
    const render::ShadingPoint at = facing_z(material);
    const glm::vec3 above = tilted(0.8f), below = glm::vec3(1, 1, -1) * tilted(0.7f, 3.3f);
    const Bsdf from_above(at, above, {.eta = 1.5f}, energy());
    render::ShadingPoint other = at;
    other.geometric = other.normal = other.smooth = {0, 0, -1};
    const Bsdf from_below(other, below, {.eta = 1.0f / 1.5f}, energy());
    const auto glass = static_cast<std::size_t>(render::Lobe::Glass);
    const float down = from_above.value(below)[glass].value.y / std::abs(below.z);
    const float up = from_below.value(above)[glass].value.y / above.z;
    EXPECT_GT(down, 1e-3f);
    EXPECT_NEAR(down * 1.5f * 1.5f / up, 1.0f, 1e-4f);
}

TEST(PathGlass, AGlassBallInAnEvenLightIsInvisibleAndBrightWithin) {
    const render::Environment light = test::even_light();
    Studio studio;
    studio.add_ball(glm::vec3(0.0f), 1.0f, 48, test::clear_glass(1.5f));
    studio.open();
    render::PathSettings settings = test::reference(64);
    settings.environment = &light;
    settings.uses_roulette = false;
    settings.max_depth = 120;
    for (const float x : {0.0f, 0.5f, 0.8f}) {
        for (const double mean : means(studio, test::narrow({x, 0.03f, 3.0f}), settings, 2))
            EXPECT_NEAR(mean, 1.0, 1e-4) << x;
    }
    for (const double mean : means(studio, test::narrow({0.1f, 0.05f, 0.2f}, 0.4f), settings, 2))
        EXPECT_NEAR(mean / 2.25, 1.0, 1e-4);
}

TEST(PathGlass, APaneSharesLightByFresnel) {
    for (const bool is_solid : {false, true}) {
        for (const bool is_split : {false, true}) {
            Studio studio;
            if (is_solid) {
                studio.add_box({-1, -1, -0.1f}, {1, 1, 0.1f}, test::clear_glass(1.5f));
            } else {
                studio.add_sheet(glm::vec3(0.0f), {1, 0, 0}, {0, 1, 0}, test::clear_glass(1.5f));
            }
            studio.add_sheet({0, 0, -2}, {4, 0, 0}, {0, 4, 0}, test::glowing(1.0f));
            studio.open();
            render::PathSettings settings = test::reference(256);
            settings.splits_glass = is_split;
            settings.max_depth = 24;
            settings.uses_roulette = false;
            // Chance alone decides where light goes unless the path is split: then it is exact.
            expect_mean(means(studio, test::narrow({0, 0, 2}), settings, 16), 12.0 / 13.0,
                        is_split ? 1e-5 : 4e-3, is_solid ? "solid" : "thin");
        }
    }
}

TEST(PathGlass, ADarkSlabTakesItsShareByBeersLaw) {
    Studio studio;
    world::Material glass = test::clear_glass(1.5f);
    glass.attenuation_color = glm::vec3(0.5f);
    glass.attenuation_distance = 0.2f;
    studio.add_box({-1, -1, -0.1f}, {1, 1, 0.1f}, glass);
    studio.add_sheet({0, 0, -2}, {4, 0, 0}, {0, 4, 0}, test::glowing(1.0f));
    studio.open();
    render::PathSettings settings = test::reference(256);
    settings.splits_glass = true;
    settings.uses_roulette = false;
    const double a = 0.5, r = 0.04;
    expect_mean(means(studio, test::narrow({0, 0, 2}), settings, 16),
                (1 - r) * (1 - r) * a / (1 - r * r * a * a), 1e-5);
}

TEST(PathGlass, BeyondTheCriticalAngleEverythingIsMirrored) {
    const world::Material glass = test::clear_glass(1.5f);
    const render::ShadingPoint at = facing_z(glass);
    const double critical = std::asin(1.0 / 1.5);
    for (const double off : {1e-6, 1e-4, 0.1, 0.7}) {
        const auto cosine = static_cast<float>(std::cos(critical + off));
        const Bsdf bsdf(at, tilted(cosine), {.eta = 1.0f / 1.5f}, energy());
        for (const float u : {0.0f, 0.5f, 0.99999994f}) {
            const render::BsdfSample s = bsdf.sample(u, glm::vec2(0.5f));
            EXPECT_FALSE(s.passes) << off;
            EXPECT_EQ(s.weight, glm::vec3(1.0f)) << off;
        }
    }
    const Bsdf below(at, tilted(static_cast<float>(std::cos(critical - 1e-3))), {.eta = 1.0f / 1.5f},
                     energy());
    EXPECT_TRUE(below.sample(0.99999994f, glm::vec2(0.5f)).passes);
}

// Glass in glass of the same index, and two bodies that share a wall, leave the background as it is.
TEST(PathGlass, NestedAndMatchedGlassCannotBeSeen) {
    Studio studio;
    studio.add_sheet({0, 0, -3}, {4, 0, 0}, {0, 4, 0}, test::glowing(1.0f));
    studio.add_box({-1, -1, -1}, {1, 1, 1}, test::clear_glass(1.0f));
    studio.add_box({-0.5f, -0.5f, -0.5f}, {0.5f, 0.5f, 0.5f}, test::clear_glass(1.0f));
    studio.add_box({-1, -1, -2}, {1, 1, -1}, test::clear_glass(1.0f));
    studio.open();
    for (const double mean : means(studio, test::narrow({0.1f, 0.1f, 2}), test::reference(16), 2))
        EXPECT_NEAR(mean, 1.0, 1e-6);
}

TEST(PathGlass, ASheetOfGlassBeforeALampLetsItsShareThroughHoweverItIsFound) {
    for (const auto finding :
         {render::LampFinding::Both, render::LampFinding::AskOnly, render::LampFinding::MeetOnly}) {
        Studio studio;
        studio.add_sheet(glm::vec3(0.0f), {0, 0, 10}, {10, 0, 0}, test::matte(glm::vec3(1.0f)));
        studio.add_sheet({0, 2, 0}, {0.02f, 0, 0}, {0, 0, 0.02f}, test::glowing(1000.0f));
        studio.open();
        render::PathSettings settings = test::reference(finding == render::LampFinding::MeetOnly ? 1024 : 64);
        settings.lamps = finding;
        settings.max_depth = 2;
        const test::Moments bare = test::moments(means(studio, test::looking_down(), settings, 8));
        studio.add_sheet({0, 1, 0}, {3, 0, 0}, {0, 0, 3}, test::clear_glass(1.5f));
        studio.open();
        const test::Moments behind = test::moments(means(studio, test::looking_down(), settings, 8));
        const double error = 5.0 * (bare.error + behind.error) / bare.mean;
        EXPECT_NEAR(behind.mean / bare.mean, 0.923077, error + 1e-3);
    }
}

}  // namespace
}  // namespace gh
