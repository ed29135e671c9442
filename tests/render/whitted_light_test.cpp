// Lamps and shadows in whole pictures, by hand.
#include "studio.h"

#include <gtest/gtest.h>

#include <cmath>

namespace gh {
namespace {

using test::exact;
using test::kDown;
using test::narrow;
using test::Studio;

void add_floor(Studio& studio, float albedo) {
    studio.add_sheet(glm::vec3(0.0f), {0, 0, 10}, {10, 0, 0}, test::matte(glm::vec3(albedo)));
}

// One metre above the floor, one metre square.
void add_panel(Studio& studio) {
    studio.add_lamp({.name = {},
                     .shape = world::LampShape::Rect,
                     .position = {0, 1, 0},
                     .direction = {0, -1, 0},
                     .intensity = glm::vec3(1.0f),
                     .half_u = {0.5f, 0, 0},
                     .half_v = {0, 0, 0.5f}});
}

// Over a grey floor, a black board under that half of it where x is above 0.
void add_half_covered_panel(Studio& studio) {
    add_floor(studio, 0.5f);
    studio.add_sheet({5.0f, 0.5f, 0.0f}, {5.0f, 0, 0}, {0, 0, 5.0f}, test::matte(glm::vec3(0.0f)));
    add_panel(studio);
}

// Looks straight down at the origin from beside the lamp's axis.
render::Camera at_origin() {
    return narrow({0.0f, 3.0f, 0.0f}, 0.0f, kDown);
}

TEST(Whitted, APointLampLightsAGreyFloorByTheInverseSquare) {
    Studio studio;
    add_floor(studio, 0.5f);
    studio.add_lamp(
        {.name = {}, .shape = world::LampShape::Point, .position = {0, 2, 0}, .intensity = {8, 4, 2}});
    studio.open();
    const glm::vec3 seen = studio.picture(at_origin(), 1, 1, exact()).pixels[0];
    EXPECT_NEAR(seen.x, 0.5f / test::kPiF * 2.0f, 1e-5f);
    EXPECT_NEAR(seen.z, 0.5f / test::kPiF * 0.5f, 1e-5f);
}

TEST(Whitted, APanelOverAFloorGivesTheKnownRadianceWithoutNoise) {
    Studio studio;
    add_floor(studio, 0.5f);
    add_panel(studio);
    studio.open();
    for (std::uint32_t frame = 0; frame < 8; ++frame) {
        EXPECT_NEAR(studio.picture(at_origin(), 1, 1, exact(), frame).pixels[0].x, 0.11972824f, 2e-6f);
    }
}

// A board under one half of the panel: by symmetry half of the light is left, whatever the panel's shape.
TEST(Whitted, HalfAPanelLeavesHalfTheLight) {
    Studio studio;
    add_half_covered_panel(studio);
    studio.open();
    render::WhittedSettings settings = exact();
    settings.shadow_samples = 64;
    double sum = 0.0, squares = 0.0;
    constexpr int kSeeds = 24;
    // From the lit side, so that the board is not in the eye's way; the floor point is 1 mm beside the board's edge.
    const render::Camera camera = narrow({-0.001f, 0.3f, 0.0f}, 0.0f, kDown);
    for (std::uint32_t seed = 0; seed < kSeeds; ++seed) {
        const auto value = static_cast<double>(studio.picture(camera, 1, 1, settings, seed).pixels[0].x);
        sum += value;
        squares += value * value;
    }
    const double mean = sum / kSeeds, variance = (squares / kSeeds - mean * mean) / (kSeeds - 1);
    EXPECT_LT(std::abs(mean - 0.05986412), 4.0 * std::sqrt(variance) + 2e-4);
}

TEST(Whitted, NeighboursThatShareSamplesAgreeOnAPenumbraAsManySamplesDo) {
    Studio studio;
    add_half_covered_panel(studio);
    studio.open();
    const render::Camera camera{.position = {-0.2f, 0.4f, 0.0f}, .pitch = kDown, .fov_y = 0.6f};
    render::WhittedSettings one = exact(), shared = exact(), many = exact();
    shared.shares_samples = true;
    many.shadow_samples = 256;
    const Image truth = studio.picture(camera, 64, 64, many);
    const auto error = [&](const Image& image) {
        double sum = 0.0;
        for (std::size_t i = 0; i < image.pixels.size(); ++i) {
            const auto d = static_cast<double>(image.pixels[i].x - truth.pixels[i].x);
            sum += d * d;
        }
        return std::sqrt(sum / static_cast<double>(image.pixels.size()));
    };
    EXPECT_LT(error(studio.picture(camera, 64, 64, shared)),
              0.25 * error(studio.picture(camera, 64, 64, one)));
}

TEST(Whitted, ALampThatIsSwitchedOffTakesExactlyItsShareAlong) {
    Studio studio;
    add_floor(studio, 0.5f);
    studio.add_ball({0.3f, 0.4f, 0.0f}, 0.3f, 16, test::matte({0.7f, 0.5f, 0.3f}));
    studio.level.lamp_groups = {"left", "right"};
    studio.add_lamp({.name = {},
                     .shape = world::LampShape::Sphere,
                     .position = {-1.5f, 2, 0},
                     .intensity = glm::vec3(90.0f),
                     .radius = 0.1f,
                     .group = 0});
    studio.add_lamp({.name = {},
                     .shape = world::LampShape::Point,
                     .position = {1.5f, 2, 1},
                     .intensity = {3, 5, 8},
                     .group = 1});
    studio.open({.spacing = 2.0f, .rays = 32});
    render::WhittedSettings settings = exact();
    settings.uses_ambient = true;
    const render::Camera camera{.position = {0, 1.5f, 4}, .pitch = -0.25f, .fov_y = 0.6f};
    const auto with = [&](std::uint8_t left, std::uint8_t right) {
        studio.snapshot.state.group_on[0] = left;
        studio.snapshot.state.group_on[1] = right;
        return studio.picture(camera, 48, 32, settings);
    };
    const Image both = with(1, 1), left = with(1, 0), right = with(0, 1), none = with(0, 0);
    for (std::size_t i = 0; i < both.pixels.size(); ++i) {
        const glm::vec3 sum = left.pixels[i] + right.pixels[i];
        // A lamp too faint to be followed at a pixel is faint alone or in company.
        EXPECT_LE(glm::length(both.pixels[i] - sum), 1e-5f * (1.0f + glm::length(sum))) << "pixel " << i;
        EXPECT_EQ(none.pixels[i], glm::vec3(0.0f)) << "light from nowhere in pixel " << i;
    }
}

TEST(Whitted, NoLightLeaksIntoASealedRoom) {
    Studio studio;
    studio.add_box({-2, 0, -2}, {2, 3, 2}, test::matte(glm::vec3(0.8f)), true);
    for (const glm::vec3& at : {glm::vec3(5, 1, 0), glm::vec3(0, 4, 0.1f), glm::vec3(2.01f, 3.01f, 2.01f)}) {
        studio.add_lamp(
            {.name = {}, .shape = world::LampShape::Point, .position = at, .intensity = glm::vec3(1e4f)});
    }
    studio.open();
    const render::Camera camera{.position = {0.1f, 1.5f, 1.9f}, .yaw = 0.2f, .fov_y = 1.9f};
    for (const glm::vec3& pixel : studio.picture(camera, 160, 90, exact()).pixels)
        EXPECT_EQ(pixel, glm::vec3(0.0f));
}

// A coarse ball with smooth normals, lit from the side: brightness follows the smooth cosine without a black corner.
TEST(Whitted, ACoarseSmoothBallHasNoBlackCornersInTheLight) {
    Studio studio;
    studio.add_ball(glm::vec3(0.0f), 1.0f, 8, test::matte(glm::vec3(1.0f)));
    studio.add_lamp({.name = {},
                     .shape = world::LampShape::Sun,
                     .direction = {-1, 0, 0},
                     .intensity = glm::vec3(test::kPiF)});
    studio.open();
    const Image image = studio.picture({.position = {0, 0, 8}, .fov_y = 0.3f}, 96, 96, exact());
    int checked = 0;
    for (int y = 0; y < 96; ++y) {
        for (int x = 0; x < 96; ++x) {
            const float px = (static_cast<float>(x) + 0.5f - 48.0f) / 48.0f * 1.209f;
            const float py = (static_cast<float>(y) + 0.5f - 48.0f) / 48.0f * 1.209f;
            if (px < 0.45f || px * px + py * py > 0.8f) continue;
            EXPECT_GT(image.at(x, y).x, 0.55f * px) << x << ' ' << y;
            EXPECT_LT(image.at(x, y).x, 1.45f * px) << x << ' ' << y;
            ++checked;
        }
    }
    EXPECT_GT(checked, 300);
}

}  // namespace
}  // namespace gh
