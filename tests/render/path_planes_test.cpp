// What path tracing tells filters: the same surfaces whatever chance decides, and of a pixel's edge the share it shows.
#include "path_studio.h"
#include "targets.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace gh {
namespace {

using test::Studio;

constexpr int kSide = 32;

render::Film film_of(const Studio& studio, const render::PathSettings& settings,
                     const render::Camera& camera = test::narrow({0, 0, 3})) {
    render::Film film(kSide, kSide);
    render::render_path({studio.level, studio.snapshot, studio.prepared}, camera, settings, 0, Jobs(1), film);
    return film;
}

render::PathSettings for_filters(int samples_per_pixel) {
    render::PathSettings settings = test::reference(samples_per_pixel);
    settings.fills_planes = settings.splits_glass = true;
    return settings;
}

world::Lamp sun_along(const glm::vec3& direction) {
    world::Lamp sun;
    sun.shape = world::LampShape::Sun;
    sun.direction = direction;
    sun.intensity = glm::vec3(3.0f);
    return sun;
}

// Three panes, six borders: each takes 4 % of the weight that roulette goes by. One pixel in seven had no surface.
TEST(PathPlanes, ASurfaceBehindPanesIsToldOfInEveryPixel) {
    Studio studio;
    for (const float z : {0.0f, 0.5f, 1.0f})
        studio.add_box({-2, -2, z}, {2, 2, z + 0.1f}, test::clear_glass(1.5f));
    studio.add_sheet({0, 0, -2}, {4, 0, 0}, {0, 4, 0}, test::matte(glm::vec3(0.5f)));
    studio.open();
    const render::Film film = film_of(studio, for_filters(1));
    EXPECT_EQ(std::ranges::count(film.planes.part, render::FilmPlanes::kSky), 0);
    for (const glm::vec3& albedo : film.planes.albedo) EXPECT_EQ(albedo, glm::vec3(0.5f));
}

// What two panes mirror of a bright wall behind the eye, before a black one: by every border once, in every pixel. With
// chance for the deeper ones a pixel in twenty had their light, twenty-five times too much of it.
TEST(PathPlanes, WhatPanesMirrorIsNoMatterOfChance) {
    Studio studio;
    for (const float z : {0.0f, 1.0f}) studio.add_box({-2, -2, z}, {2, 2, z + 0.1f}, test::clear_glass(1.5f));
    studio.add_sheet({0, 0, -2}, {4, 0, 0}, {0, 4, 0}, test::matte(glm::vec3(0.0f)));
    studio.add_sheet({0, 0, 5}, {4, 0, 0}, {0, -4, 0}, test::glowing(1.0f));
    studio.open();
    const render::Film film = film_of(studio, for_filters(1));
    const double r = 0.04, t2 = (1.0 - r) * (1.0 - r);
    const double once = r * (1.0 + t2 + t2 * t2 + t2 * t2 * t2);
    for (const glm::vec3& light : film.radiance.pixels) {
        // Three times mirrored brings less than 10 r^3, and comes by chance: up to 1 / .03 of it at a time.
        EXPECT_GT(static_cast<double>(light.y), once - 1e-4);
        EXPECT_LT(static_cast<double>(light.y), once + 10.0 * r * r * r + 0.06);
    }
}

// Two walls in one plane under one sun, one of them twice as bright; their border lies within a row of pixels. What falls
// on them is the same everywhere, so light by albedo is; the rest of the pixel is `clean`.
TEST(PathPlanes, AnEdgesColourIsThatOfItsShare) {
    Studio studio;
    const glm::vec3 dark(0.2f), bright(0.4f);
    const float edge = 3.3e-4f;  // the picture shows 3 mm: three and a half pixels right of its middle
    studio.add_sheet({-4.0f + edge, 0, 0}, {4, 0, 0}, {0, 4, 0}, test::matte(dark));
    studio.add_sheet({4.0f + edge, 0, 0}, {4, 0, 0}, {0, 4, 0}, test::matte(bright));
    studio.add_lamp(sun_along({0, 0, -1}));
    studio.open();
    const int samples = 64;
    const render::Environment night = test::even_light(0.0f);
    render::PathSettings settings = for_filters(samples);
    settings.environment = &night;
    const render::Film film = film_of(studio, settings);
    const render::FilmPlanes& planes = film.planes;
    int edges = 0;
    for (std::size_t i = 0; i < planes.part.size(); ++i) {
        const glm::vec3& whole = planes.part[i] == planes.part[0] ? dark : bright;
        const float share = planes.albedo[i].y / whole.y;
        EXPECT_NEAR(planes.direct.pixels[i].y / planes.albedo[i].y, 3.0f / test::kPiF, 1e-5f);
        EXPECT_NEAR(share * samples, std::round(share * samples), 1e-3f) << "so many samples";
        const glm::vec3& sum = film.radiance.pixels[i];
        const glm::vec3 told = planes.direct.pixels[i] + planes.clean.pixels[i];
        EXPECT_NEAR(sum.y, told.y, 1e-6f);
        if (share > 0.999f) {
            EXPECT_EQ(planes.clean.pixels[i], glm::vec3(0.0f));
            continue;
        }
        ++edges;
        const glm::vec3& other = planes.part[i] == planes.part[0] ? bright : dark;
        EXPECT_NEAR(planes.clean.pixels[i].y, (1.0f - share) * other.y * 3.0f / test::kPiF, 1e-5f);
    }
    EXPECT_EQ(edges, kSide) << "one column of pixels shows both";
}

// The corner of a box, one of whose faces has the sun: none of it falls on the other face.
TEST(PathPlanes, AnotherFaceOfTheSameThingIsAnother) {
    Studio studio;
    studio.add_box(glm::vec3(-1.0f), glm::vec3(1.0f), test::matte(glm::vec3(0.5f)));
    studio.add_lamp(sun_along({-1, 0, 0}));
    studio.open();
    const render::Environment night = test::even_light(0.0f);
    render::PathSettings settings = for_filters(64);
    settings.environment = &night;
    const float aside = 3.3e-4f;  // of a picture of 2.8 mm
    const render::Film film =
        film_of(studio, settings, test::narrow({3.0f + aside, 0, 3.0f}, test::kPiF / 4.0f));
    const render::FilmPlanes& planes = film.planes;
    int edges = 0;
    for (std::size_t i = 0; i < planes.part.size(); ++i) {
        const float share = planes.albedo[i].y / 0.5f;
        const bool has_sun = planes.normal[i].x > 0.5f;
        EXPECT_NEAR(planes.direct.pixels[i].y / planes.albedo[i].y, has_sun ? 3.0f / test::kPiF : 0.0f,
                    1e-5f);
        EXPECT_NEAR(planes.clean.pixels[i].y, has_sun ? 0.0f : (1.0f - share) * 1.5f / test::kPiF, 1e-5f);
        edges += share < 0.999f ? 1 : 0;
    }
    EXPECT_EQ(edges, kSide) << "one column of pixels shows both";
}

}  // namespace
}  // namespace gh
