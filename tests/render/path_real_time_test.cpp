// Paths at thirty pictures a second: one scattering, then the light that was baked. Near the truth, and lit in mirrors.
#include "path_studio.h"

#include <gtest/gtest.h>

namespace gh {
namespace {

using test::Studio;

// A grey room with a panel under its ceiling and a mirror in one wall.
Studio baked_room() {
    Studio studio;
    studio.add_box({-3, 0, -3}, {3, 3, 3}, test::matte(glm::vec3(0.5f)), true);
    studio.add_sheet({0, 2.9f, 0}, {1, 0, 0}, {0, 0, 1}, test::glowing(5.0f));
    studio.add_sheet({0, 1.5f, -2.99f}, {1, 0, 0}, {0, 1, 0}, test::mirror(0.9f));
    studio.open({.bakes_ambient = true});
    return studio;
}

double mean_of(const Studio& studio, const render::Camera& camera, render::PathSettings settings) {
    settings.samples_per_pixel = 64;
    settings.most_indirect = rc::kInfinity;
    return test::moments(test::means(studio, camera, settings, 8)).mean;
}

// The bake samples this room every metre and a half and is 14 % too bright beside its walls; a panel that glows counted
// twice, in the bake and as a lamp, once made it 41 %.
TEST(PathRealTime, EndsInABakeThatIsNearTheTruth) {
    const Studio studio = baked_room();
    const render::Camera floor = test::narrow({1.5f, 1.0f, 1.0f}, 0.0f, test::kDown);
    const render::Camera wall = test::narrow({2.0f, 1.0f, 0.0f});
    for (const render::Camera& camera : {floor, wall}) {
        const double truth = mean_of(studio, camera, test::reference());
        EXPECT_NEAR(mean_of(studio, camera, render::realtime_path()) / truth, 1.0, 0.2);
    }
}

// A mirror is no scattering: what is seen in it has its own, and is as bright as its share of what is there.
TEST(PathRealTime, SeesInMirrorsWhatIsThere) {
    const Studio studio = baked_room();
    const render::Camera into_mirror = test::narrow({0.0f, 1.0f, 0.0f});
    const double truth = mean_of(studio, into_mirror, test::reference());
    EXPECT_NEAR(mean_of(studio, into_mirror, render::realtime_path()) / truth, 1.0, 0.1);
}

// Paths that end early leave their share of the light to those that go on: in a dim room most of them do.
TEST(PathRealTime, EndsPathsEarlyWithoutBias) {
    Studio studio;
    studio.add_box({-2, 0, -2}, {2, 3, 2}, test::matte(glm::vec3(0.3f)), true);
    studio.add_sheet({0, 2.9f, 0}, {0.5f, 0, 0}, {0, 0, 0.5f}, test::glowing(5.0f));
    studio.open({.bakes_ambient = true});
    render::PathSettings settings = render::realtime_path();
    settings.samples_per_pixel = 64;
    settings.most_indirect =
        rc::kInfinity;  // what is clamped is lost, and early ends make single paths brighter
    ASSERT_TRUE(settings.ends_early);
    const auto early = test::means(studio, test::looking_down(), settings);
    settings.ends_early = false;
    test::expect_same_mean(early, test::means(studio, test::looking_down(), settings));
    EXPECT_NE(early, test::means(studio, test::looking_down(), settings)) << "some paths end";
}

}  // namespace
}  // namespace gh
