// Pictures in a row, as the window shows them: what a lamp that is switched off leaves behind.
#include "app/view.h"

#include "render/studio.h"

#include <gtest/gtest.h>

namespace gh::app {
namespace {

// A grey room with one lamp that has a switch, and far weaker light that stays.
test::Studio room() {
    test::Studio studio;
    studio.add_box({-3, 0, -3}, {3, 3, 3}, test::matte(glm::vec3(0.5f)), true);
    studio.level.lamp_groups.resize(1);
    for (const bool has_switch : {true, false}) {
        world::Lamp lamp;
        lamp.shape = world::LampShape::Sphere;
        lamp.position = {has_switch ? -1.5f : 2.0f, 2.0f, -1.0f};
        lamp.radius = 0.1f;
        lamp.intensity = glm::vec3(has_switch ? 200.0f : 0.5f);
        lamp.group = has_switch ? 0u : world::kNoIndex;
        studio.add_lamp(lamp);
    }
    studio.open();
    return studio;
}

const render::Camera kCamera{.position = {0.0f, 1.5f, 2.8f}, .fov_y = 1.4f};

// Of the left wall, where neither lamp is in sight: radiance, summed over rows.
float light_of(View& view, const test::Studio& studio, const world::Snapshot& before, std::uint32_t frame,
               int step) {
    const render::SceneView scene{studio.level, studio.snapshot, studio.prepared, &before};
    view.expose_next(scene, kCamera, render::WhittedSettings{}, frame, {{24, 16}, step}, Jobs(2));
    const Image& shown = view.shown();
    float sum = 0.0f;
    for (int y = 0; y < shown.height; ++y) {
        for (int x = 0; x < shown.width / 6; ++x) sum += shown.at(x, y).y;
    }
    return sum;
}

TEST(View, ALampSwitchedOffIsDarkInTheNextPictureHoweverFewPixelsAreLit) {
    for (int step = 1; step <= kMostStep; ++step) {
        test::Studio studio = room();
        View view(24, 16);
        float lit = 0.0f;
        for (std::uint32_t frame = 0; frame < 20; ++frame)
            lit = light_of(view, studio, studio.snapshot, frame, step);
        const world::Snapshot before = studio.snapshot;
        studio.snapshot.state.group_on[0] = 0;
        const float next = light_of(view, studio, before, 20, step);
        View fresh(24, 16);
        const float dark = light_of(fresh, studio, studio.snapshot, 20, step);
        ASSERT_LT(dark, 0.05f * lit);
        EXPECT_EQ(next, dark) << "every " << step * step << "th pixel is lit: nothing of before is left";
    }
}

}  // namespace
}  // namespace gh::app
