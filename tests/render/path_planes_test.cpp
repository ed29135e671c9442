// What path tracing tells filters: the same surfaces whatever chance decides, and of a pixel's edge the share it shows.
#include "path_studio.h"
#include "targets.h"

#include <gtest/gtest.h>

#include <cmath>

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
    for (int y = 0; y < kSide; ++y) {
        for (int x = 0; x < kSide; ++x) {
            EXPECT_NE(film.planes.part.at(x, y), render::FilmPlanes::kSky);
            EXPECT_EQ(film.planes.albedo.get(x, y), glm::vec3(0.5f));
        }
    }
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
    for (int i = 0; i < kSide * kSide; ++i) {
        const int x = i % kSide, y = i / kSide;
        const bool is_dark = planes.part.at(x, y) == planes.part.at(0, 0);
        const float albedo = planes.albedo.y.at(x, y), share = albedo / (is_dark ? dark : bright).y;
        EXPECT_NEAR(planes.direct.y.at(x, y) / albedo, 3.0f / test::kPiF, 1e-5f);
        EXPECT_NEAR(share * samples, std::round(share * samples), 1e-3f) << "so many samples";
        const glm::vec3 clean = planes.clean.get(x, y);
        EXPECT_NEAR(film.radiance.at(x, y).y, planes.direct.y.at(x, y) + clean.y, 1e-6f);
        if (share > 0.999f) {
            EXPECT_EQ(clean, glm::vec3(0.0f));
            continue;
        }
        ++edges;
        const glm::vec3& other = is_dark ? bright : dark;
        EXPECT_NEAR(clean.y, (1.0f - share) * other.y * 3.0f / test::kPiF, 1e-5f);
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
    for (int i = 0; i < kSide * kSide; ++i) {
        const int x = i % kSide, y = i / kSide;
        const float albedo = planes.albedo.y.at(x, y), share = albedo / 0.5f;
        const bool has_sun = planes.normal.x.at(x, y) > 0.5f;
        EXPECT_NEAR(planes.direct.y.at(x, y) / albedo, has_sun ? 3.0f / test::kPiF : 0.0f, 1e-5f);
        EXPECT_NEAR(planes.clean.y.at(x, y), has_sun ? 0.0f : (1.0f - share) * 1.5f / test::kPiF, 1e-5f);
        edges += share < 0.999f ? 1 : 0;
    }
    EXPECT_EQ(edges, kSide) << "one column of pixels shows both";
}

}  // namespace
}  // namespace gh
