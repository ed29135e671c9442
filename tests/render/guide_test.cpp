// A guide says of every pixel what a picture shows there: the same surfaces the path tracer notes by code of its own, and
// of what shines by itself as much as a Whitted picture has.
#include "render/guide.h"

#include "path_studio.h"

#include <glm/common.hpp>
#include <gtest/gtest.h>

namespace gh {
namespace {

using test::Studio;

constexpr glm::ivec2 kSize(96, 64);

// A room with a mirror, a pane, a box and a ball, a panel that glows, and a window to the sky.
Studio room() {
    Studio studio;
    studio.add_sheet({0, 0, 0}, {3, 0, 0}, {0, 0, -3}, test::matte({0.7f, 0.6f, 0.5f}));
    studio.add_sheet({0, 1.5f, -3}, {3, 0, 0}, {0, 1.5f, 0}, test::matte({0.2f, 0.6f, 0.5f}));
    studio.add_sheet({-3, 1.5f, 0}, {0, 1.5f, 0}, {0, 0, 3}, test::matte({0.3f, 0.3f, 0.9f}));
    studio.add_sheet({1.2f, 1.5f, -2.9f}, {1, 0, 0}, {0, 1, 0}, test::mirror(0.9f));
    studio.add_sheet({-1.2f, 1.2f, -1}, {0.6f, 0, 0}, {0, 0.6f, 0}, test::clear_glass(1.5f));
    studio.add_box({-0.4f, 0.01f, -1.5f}, {0.2f, 0.8f, -0.7f}, test::matte({0.9f, 0.1f, 0.1f}));
    studio.add_ball({1, 0.6f, -1}, 0.5f, 16, test::matte({0.1f, 0.8f, 0.1f}));
    studio.add_sheet({0, 2.5f, -2}, {0.5f, 0, 0}, {0, 0, 0.5f}, test::glowing(5.0f));
    studio.add_lamp({.name = {},
                     .shape = world::LampShape::Sun,
                     .direction = {0.3f, -0.8f, -0.5f},
                     .intensity = glm::vec3(2.0f)});
    studio.open();
    return studio;
}

const render::Camera kCamera{.position = {0.2f, 1.4f, 2.5f}, .yaw = 0.1f, .pitch = -0.1f, .fov_y = 1.1f};

render::GuidePlanes guide_of(const Studio& studio, const glm::vec2& jitter, int threads = 1) {
    render::GuidePlanes planes;
    const Jobs jobs(threads);
    render::WhittedSettings settings;
    settings.jitter = jitter;
    render::render_guide({studio.level, studio.snapshot, studio.prepared}, kCamera, settings, kSize, jobs,
                         planes);
    return planes;
}

// Nothing here is on an edge by less than rounding but a few pixels: the path tracer's rays differ in their last bits.
TEST(Guide, ShowsTheSurfacesThatPathsNote) {
    const Studio studio = room();
    const render::GuidePlanes guide = guide_of(studio, glm::vec2(0.0f));
    render::Film film(kSize.x, kSize.y);
    render::PathSettings settings;
    settings.fills_planes = settings.splits_glass = true;
    settings.jitters = false;
    render::render_path({studio.level, studio.snapshot, studio.prepared}, kCamera, settings, 0, Jobs(1),
                        film);
    int others = 0, sky = 0, seen_in_mirror = 0;
    for (std::size_t i = 0; i < guide.part.size(); ++i) {
        const int x = static_cast<int>(i) % kSize.x, y = static_cast<int>(i) / kSize.x;
        const bool is_sky = guide.part[i] == render::GuidePlanes::kSky;
        sky += is_sky ? 1 : 0;
        if (is_sky != (film.planes.part.at(x, y) == render::FilmPlanes::kSky)) {
            ++others;
            continue;
        }
        if (is_sky) continue;
        const float distance = glm::distance(guide.eye, guide.position[i]);
        seen_in_mirror += guide.position[i].z < -3.1f ? 1 : 0;
        const bool is_same =
            glm::distance(guide.position[i], film.planes.position.get(x, y)) < 2e-3f * distance &&
            glm::dot(guide.geometric[i], film.planes.geometric.get(x, y)) > 0.999f;
        others += is_same ? 0 : 1;
    }
    EXPECT_GT(sky, 50);
    EXPECT_GT(seen_in_mirror, 30);
    EXPECT_LT(others, static_cast<int>(guide.part.size() / 100));
}

// In the dark a picture is what shines by itself, in mirrors and behind glass too.
TEST(Guide, WhatShinesByItselfIsThePictureInTheDark) {
    Studio studio = room();
    const render::GuidePlanes guide = guide_of(studio, glm::vec2(0.2f, -0.3f));
    studio.level.lamps[0].direction = {0.0f, 1.0f,
                                       0.0f};  // from below: it lights the sky and nothing else here
    render::WhittedSettings settings;
    settings.jitter = {0.2f, -0.3f};
    settings.uses_ambient = false;
    const Image dark = studio.picture(kCamera, kSize.x, kSize.y, settings);
    double most = 0.0, sum = 0.0;
    for (std::size_t i = 0; i < dark.pixels.size(); ++i) {
        // What a pane or a dielectric mirrors besides is in the picture and not in the guide.
        EXPECT_LE(guide.clean.pixels[i].x, dark.pixels[i].x * 1.0001f + 1e-6f) << i;
        most = std::max(most, static_cast<double>(guide.clean.pixels[i].x));
        sum +=
            static_cast<double>(guide.clean.pixels[i].x / std::max(dark.pixels[i].x, 1e-9f) > 0.95f ? 1 : 0);
    }
    EXPECT_NEAR(most, 5.0, 1e-5);
    EXPECT_GT(sum, 200.0);
}

TEST(Guide, ThreadsDoNotMatter) {
    const Studio studio = room();
    const render::GuidePlanes one = guide_of(studio, glm::vec2(0.1f)),
                              three = guide_of(studio, glm::vec2(0.1f), 3);
    EXPECT_EQ(one.part, three.part);
    EXPECT_EQ(one.position, three.position);
    EXPECT_EQ(one.albedo, three.albedo);
    EXPECT_EQ(one.clean.pixels, three.clean.pixels);
}

// What moved by itself was elsewhere a frame ago, and says where.
TEST(Guide, KnowsWhereThingsWere) {
    Studio studio = room();
    studio.level.parts[5].mover = world::Mover::Door;
    world::Snapshot before = studio.snapshot;
    Studio moved = room();
    moved.level.parts[5].mover = world::Mover::Door;
    moved.level.parts[5].mover_from_part[3] += glm::vec3(0.3f, 0.0f, 0.0f);
    moved.open();
    render::GuidePlanes planes;
    render::render_guide({moved.level, moved.snapshot, moved.prepared, &before}, kCamera, {}, kSize, Jobs(1),
                         planes);
    int of_box = 0;
    for (std::size_t i = 0; i < planes.part.size(); ++i) {
        const glm::vec3 by = planes.position[i] - planes.previous[i];
        if (planes.part[i] == 5) {
            ++of_box;
            EXPECT_LT(glm::distance(by, glm::vec3(0.3f, 0.0f, 0.0f)), 1e-4f);
        } else if (planes.part[i] < 8) {
            EXPECT_EQ(by, glm::vec3(0.0f));
        }
    }
    EXPECT_GT(of_box, 50);
}

}  // namespace
}  // namespace gh
