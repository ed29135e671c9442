// Shades: the brightest thing in a room after its lamp, and small. Paths are sent there on purpose; nobody may see that
// in the light, only in the noise.
#include "path_studio.h"
#include "render/gleams.h"
#include "world/layers.h"

#include <gtest/gtest.h>

namespace gh {
namespace {

using test::Studio;

// A room of eight metres; under its ceiling a bulb in a white shade that is open below.
Studio shaded_room(bool has_bare_bulb = false) {
    Studio studio;
    studio.add_box({-4, 0, -4}, {4, 3, 4}, test::matte(glm::vec3(0.5f)), true);
    studio.add_ball({0.0f, 2.05f, 0.0f}, 0.04f, 8, test::glowing(500.0f));
    world::Material white = test::matte(glm::vec3(0.8f));
    white.is_double_sided = true;
    for (const float side : {-0.2f, 0.2f}) {
        studio.add_sheet({side, 2.1f, 0.0f}, {0, 0.1f, 0}, {0, 0, 0.2f}, white);
        studio.add_sheet({0.0f, 2.1f, side}, {0, 0.1f, 0}, {0.2f, 0, 0}, white);
    }
    studio.add_sheet({0.0f, 2.2f, 0.0f}, {0.2f, 0, 0}, {0, 0, 0.2f}, white);
    if (has_bare_bulb) studio.add_ball({2.0f, 1.4f, 0.0f}, 0.1f, 8, test::glowing(5.0f));
    studio.open();
    return studio;
}

TEST(PathGleams, AShadeIsFoundAndABareBulbHasNone) {
    const Studio studio = shaded_room(true);
    ASSERT_EQ(studio.prepared.gleams.gleams.size(), 1u);
    const render::Gleam& gleam = studio.prepared.gleams.gleams[0];
    EXPECT_EQ(gleam.part, 1u) << "the shaded bulb's light";
    EXPECT_LT(glm::distance(gleam.ball.centre, glm::vec3(0.0f, 2.1f, 0.0f)), 0.1f);
    EXPECT_LT(gleam.ball.radius, 0.4f);
    EXPECT_FALSE(studio.prepared.gleams.at({0.0f, 0.3f, 0.0f}).empty())
        << "the floor below sees into the shade";
}

// One over a density, averaged over what has it, is what there is of the sphere to be picked: the cones' solid angle.
TEST(PathGleams, DirectionsArePickedAsOftenAsTheirDensitySays) {
    render::Gleams gleams;
    gleams.grid = {.origin = glm::vec3(-1.0f), .spacing = glm::vec3(2.0f), .cells = glm::ivec3(1)};
    gleams.gleams = {{.ball = {{3, 0, 0}, 1.0f}}, {.ball = {{0, 0, 4}, 0.01f}}, {.ball = {{0, 5, 0}, 1.0f}}};
    gleams.begin = {0, 3};
    gleams.seen = {{0, 2.0f}, {1, 1.0f}, {2, 7.0f}};
    const std::vector<std::uint8_t> is_on = {1, 1, 0};
    const render::GleamGuide guide(gleams, is_on, glm::vec3(0.0f), glm::vec3(0.0f));
    const double wide = 2.0 * M_PI * (1.0 - std::sqrt(1.0 - 1.0 / 9.0));
    const double narrow = 2.0 * M_PI * (1.0 - std::sqrt(1.0 - 1e-4 / 16.0));
    EXPECT_NEAR(static_cast<double>(guide.density({1, 0, 0})), 2.0 / 3.0 / wide, 1e-5);
    EXPECT_NEAR(static_cast<double>(guide.density({0, 0, 1})) * narrow, 1.0 / 3.0, 1e-4);
    EXPECT_EQ(guide.density({0, 1, 0}), 0.0f) << "a lamp that is off";
    constexpr int kPicks = 4096;
    int first = 0;
    double whole = 0.0;
    for (int i = 0; i < kPicks; ++i) {
        const float u = (static_cast<float>(i) + 0.5f) / kPicks;
        const glm::vec3 way =
            guide.pick(u, {static_cast<float>((i * 37) % 64) / 64.0f, static_cast<float>(i % 61) / 61.0f});
        ASSERT_GT(guide.density(way), 0.0f);
        whole += 1.0 / static_cast<double>(guide.density(way)) / kPicks;
        first += way.x > 0.5f ? 1 : 0;
    }
    EXPECT_NEAR(first, 2.0 / 3.0 * kPicks, 2.0);
    EXPECT_NEAR(whole, wide + narrow, 1e-3 * wide);
}

// The floor sees the shade and the wall does not see its inside: both are lit alike with and without seeking.
TEST(PathGleams, SeekingChangesNothingButNoise) {
    const Studio studio = shaded_room();
    render::PathSettings settings = test::reference(64);
    settings.max_depth = 4;
    for (const render::Camera& camera :
         {test::narrow({2.0f, 1.5f, 0.0f}, 0.0f, test::kDown), test::narrow({0.0f, 2.6f, 0.0f})}) {
        settings.seeks_gleams = true;
        const std::vector<double> with = test::means(studio, camera, settings);
        settings.seeks_gleams = false;
        const std::vector<double> without = test::means(studio, camera, settings);
        test::expect_same_mean(with, without, "sought and found by chance");
        EXPECT_LT(test::moments(with).error, 0.6 * test::moments(without).error);
    }
}

// Both leave fireflies out and must not take more than they say.
TEST(PathGleams, ClampingDimsAndRougheningKeepsEnergy) {
    const Studio studio = shaded_room();
    const render::Camera camera = test::narrow({2.0f, 1.5f, 0.0f}, 0.0f, test::kDown);
    render::PathSettings settings = test::reference(64);
    settings.max_depth = 4;
    const std::vector<double> by_itself = test::means(studio, camera, settings);
    const test::Moments truth = test::moments(by_itself);
    settings.least_indirect_roughness = 0.5f;
    test::expect_same_mean(test::means(studio, camera, settings), by_itself,
                           "nothing glossy, nothing to roughen");
    settings.most_indirect = 0.01f * static_cast<float>(truth.mean);
    const test::Moments clamped = test::moments(test::means(studio, camera, settings));
    EXPECT_LT(clamped.mean, truth.mean - 4.0 * truth.error);
    settings.max_depth = 1;
    settings.most_indirect = rc::kInfinity;
    const test::Moments direct = test::moments(test::means(studio, camera, settings));
    EXPECT_GT(clamped.mean, direct.mean - 4.0 * direct.error) << "the first light is never clamped";
}

// A bulb's shadow rays ask what is opaque up to twice its radius, then what is clear, then what they meet beyond: things
// stand in each of these ways, and nobody who merely runs into the bulb knows of any of them.
TEST(PathGleams, ABulbBehindGlassInATightShadeIsAskedAsItIsMet) {
    Studio studio;
    studio.add_sheet(glm::vec3(0.0f), {0, 0, 3}, {3, 0, 0}, test::matte(glm::vec3(0.5f)));
    constexpr float kRadius = 0.2f;
    const glm::vec3 centre(0.5f, 1.0f, 0.0f);
    studio.add_ball(centre, kRadius, 8, test::glowing(4.0f));
    world::Material tinted = test::clear_glass(1.5f);
    tinted.base_color = {0.5f, 0.6f, 0.7f, 1.0f};
    const glm::vec3 down(0.0f, -kRadius, 0.0f);
    studio.add_sheet(centre + down * 1.2f, {0.1f, 0, 0}, {0, 0, 0.1f}, test::matte(glm::vec3(0.0f)));
    studio.add_sheet(centre + down * 1.4f, {0, 0, 0.4f}, {0.4f, 0, 0}, tinted);
    studio.add_sheet(centre + down * 3.0f, {0, 0, 0.3f}, {0.12f, 0, 0}, test::matte(glm::vec3(0.0f)));
    studio.open();
    ASSERT_EQ(studio.prepared.emitters[0].kind, render::EmitterKind::Bulb);
    ASSERT_EQ(studio.prepared.blocking_layers, world::Blocker);
    const render::Camera camera = test::narrow({0.0f, 0.3f, 0.0f}, 0.0f, -1.2f);
    std::vector<std::vector<double>> results;
    using render::LampFinding;
    for (const LampFinding finding : {LampFinding::Both, LampFinding::AskOnly, LampFinding::MeetOnly}) {
        render::PathSettings settings = test::reference(128);
        settings.lamps = finding;
        settings.max_depth = 8;  // panes end paths that are as long
        settings.caustics = render::Caustics::Unbent;
        results.push_back(test::means(studio, camera, settings));
    }
    test::expect_same_mean(results[0], results[1], "both, asked");
    test::expect_same_mean(results[0], results[2], "both, met");
    // A level that does not say which of its parts are opaque has the same light.
    const Image split = test::path_picture(studio, camera, 16, 16, test::reference(4));
    studio.prepared.blocking_layers = world::Light;
    EXPECT_TRUE(split.pixels == test::path_picture(studio, camera, 16, 16, test::reference(4)).pixels);
}

}  // namespace
}  // namespace gh
