// Paths of the last frame asked again: the very same light where nothing changed, less of it where a lamp went out.
#include "app/reshading.h"

#include "render/studio.h"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>

namespace gh::app {
namespace {

constexpr int kWidth = 48, kHeight = 30;

// A room with one lamp that has a switch and one that has none, each at its end.
test::Studio room(std::optional<float> crate_at = {}) {
    test::Studio studio;
    studio.add_box({-6, 0, -3}, {6, 3, 3}, test::matte(glm::vec3(0.5f)), true);
    if (crate_at) {
        const glm::vec3 corner(*crate_at, 1.2f, 0.8f);
        studio.add_box(corner, corner + 0.6f, test::matte(glm::vec3(0.05f)));
    }
    studio.level.lamp_groups.resize(2);
    for (const float x : {-5.0f, 5.0f}) {
        world::Lamp lamp;
        lamp.shape = world::LampShape::Sphere;
        lamp.position = {x, 2.0f, 0.0f};
        lamp.radius = 0.1f;
        lamp.intensity = glm::vec3(200.0f);
        lamp.group = x < 0.0f ? 0u : 1u;
        studio.add_lamp(lamp);
    }
    studio.open();
    return studio;
}

const render::Camera kCamera{.position = {0.0f, 1.5f, 2.8f}, .fov_y = 1.8f};

render::Film traced(const test::Studio& studio, std::uint32_t frame, const Jobs& jobs, Reshading& reshading) {
    render::PathSettings settings = render::realtime_path();
    settings.ends_in_bake = false;
    render::Film film(kWidth, kHeight);
    render::render_path({studio.level, studio.snapshot, studio.prepared}, kCamera, settings, frame, jobs,
                        film);
    reshading.note(kCamera, settings, frame, film);
    return film;
}

TEST(Reshading, WhereNothingChangedNothingIsNoticedHoweverNoisyTheFrames) {
    const test::Studio studio = room();
    const Jobs jobs(2);
    Reshading reshading;
    filter::Plane change;
    reshading.ask_again({studio.level, studio.snapshot, studio.prepared}, jobs, change);
    EXPECT_TRUE(change.empty()) << "there was no frame before the first";
    for (std::uint32_t frame = 0; frame < 9; ++frame) {
        traced(studio, frame, jobs, reshading);
        reshading.ask_again({studio.level, studio.snapshot, studio.prepared}, jobs, change);
        ASSERT_EQ(change.width(), kWidth);
        for (int y = 0; y < kHeight; ++y) {
            for (int x = 0; x < kWidth; ++x) ASSERT_EQ(change.at(x, y), 0.0f) << x << ' ' << y;
        }
    }
}

TEST(Reshading, ALampThatWentOutIsNoticedWhereItShone) {
    test::Studio studio = room();
    const Jobs jobs(2);
    Reshading reshading;
    traced(studio, 3, jobs, reshading);
    studio.snapshot.state.group_on[0] = 0;
    filter::Plane change;
    reshading.ask_again({studio.level, studio.snapshot, studio.prepared}, jobs, change);
    double left = 0.0, all = 0.0;
    for (int y = 0; y < kHeight; ++y) {
        for (int x = 0; x < kWidth; ++x) {
            (x < kWidth / 4 ? left : all) += static_cast<double>(change.at(x, y));
            ASSERT_GE(change.at(x, y), 0.0f);
            ASSERT_LE(change.at(x, y), 1.0f);
        }
    }
    EXPECT_GT(left / (kWidth / 4 * kHeight), 0.5);
    reshading.forget();
    reshading.ask_again({studio.level, studio.snapshot, studio.prepared}, jobs, change);
    EXPECT_TRUE(change.empty());
}

// The light in the room stays what it is; the crate is far darker than the wall it now hides, and than what it uncovers.
TEST(Reshading, WhatMovesKeepsItsPastAndSoDoesTheWallBesideIt) {
    const test::Studio then = room(-0.7f), now = room(0.1f);
    const Jobs jobs(2);
    Reshading reshading;
    double on_crate = 0.0, all = 0.0;
    int crates = 0;
    for (std::uint32_t frame = 0; frame < 9; ++frame) {
        const render::Film film = traced(then, frame, jobs, reshading);
        filter::Plane change;
        reshading.ask_again({now.level, now.snapshot, now.prepared}, jobs, change);
        for (int y = 0; y < kHeight; ++y) {
            for (int x = 0; x < kWidth; ++x) {
                const glm::vec3 met = film.planes.position.get(x, y);
                const bool is_crate = met.x > -0.75f && met.x < -0.05f && met.y > 1.15f && met.z > 0.75f;
                crates += is_crate ? 1 : 0;
                on_crate += is_crate ? static_cast<double>(change.at(x, y)) : 0.0;
                all += static_cast<double>(change.at(x, y)) / (9.0 * kWidth * kHeight);
            }
        }
    }
    ASSERT_GT(crates, 100);
    EXPECT_LT(on_crate / crates, 0.05);
    EXPECT_LT(all, 0.04);
}

}  // namespace
}  // namespace gh::app
