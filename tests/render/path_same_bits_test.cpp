// A path-traced picture is a function of scene, camera, settings and frame number; and never holds a NaN.
#include "path_studio.h"
#include "support/isas.h"

#include <gtest/gtest.h>

#include <limits>

namespace gh {
namespace {

using test::Studio;

// A bit of everything.
void furnish(Studio& studio) {
    studio.add_box({-3, 0, -3}, {3, 3, 3}, test::matte({0.7f, 0.6f, 0.5f}), true);
    world::Material polished = test::matte({0.4f, 0.2f, 0.1f});
    polished.ior = 1.5f;
    polished.roughness = 0.15f;
    studio.add_box({-1.5f, 0.01f, -1.5f}, {-0.5f, 0.8f, -0.5f}, polished);
    studio.add_ball({1, 0.6f, -1}, 0.5f, 16, test::clear_glass(1.5f));
    studio.add_sheet({0, 1.5f, -2.9f}, {1, 0, 0}, {0, 1, 0}, test::mirror(0.9f));
    studio.add_ball({0.5f, 2.5f, 0}, 0.15f, 8, test::glowing(30.0f));
    studio.add_sheet({-1, 2.9f, 1}, {0.3f, 0, 0}, {0, 0, 0.3f}, test::glowing(5.0f));
    studio.add_lamp(
        {.name = {}, .shape = world::LampShape::Point, .position = {-2, 2, 1}, .intensity = {1, 2, 3}});
}

render::Camera view() {
    return {.position = {0.5f, 1.5f, 2.75f}, .yaw = 0.1f, .pitch = -0.15f, .fov_y = 1.0f};
}

TEST(PathSameBits, OneTwoAndEightThreadsMakeOnePicture) {
    Studio studio;
    furnish(studio);
    studio.open();
    for (const auto sampler : {render::SampleKind::Sobol, render::SampleKind::BlueNoise}) {
        render::PathSettings settings = test::reference(2);
        settings.sampler = sampler;
        const Image one = test::path_picture(studio, view(), 50, 34, settings, 3);
        for (const int threads : {2, 8})
            EXPECT_EQ(one.pixels,
                      test::path_picture(studio, view(), 50, 34, settings, 3, Jobs(threads)).pixels);
        EXPECT_NE(one.pixels, test::path_picture(studio, view(), 50, 34, settings, 4).pixels);
    }
}

// A film keeps what was found out about lamps for the next picture: that must never show, least of all when a lamp is
// switched.
TEST(PathSameBits, AFilmThatIsUsedAgainShowsWhatAFreshOneShowsThoughLampsAreSwitched) {
    Studio studio;
    furnish(studio);
    studio.level.lamp_groups = {"point"};
    studio.level.lamps[0].group = 0;
    studio.open();
    const auto shoot = [&](std::uint32_t frame, render::Film& film) {
        render::render_path({studio.level, studio.snapshot, studio.prepared}, view(), test::reference(2),
                            frame, Jobs(1), film);
    };
    render::Film kept(24, 16);
    std::vector<Image> pictures;
    for (const bool is_on : {true, true, false, true}) {
        studio.snapshot.state.group_on[0] = is_on ? 1 : 0;
        const auto tree = kept.light_tree;
        shoot(7, kept);
        const bool is_switched = pictures.empty() || pictures.size() >= 2;
        EXPECT_EQ(kept.light_tree != tree, is_switched) << "picture " << pictures.size();
        render::Film fresh(24, 16);
        shoot(7, fresh);
        EXPECT_EQ(kept.radiance.pixels, fresh.radiance.pixels) << "picture " << pictures.size();
        pictures.push_back(kept.radiance);
    }
    EXPECT_EQ(pictures[0].pixels, pictures[3].pixels);
    EXPECT_NE(pictures[0].pixels, pictures[2].pixels);
}

TEST(PathSameBits, EveryIsaMakesOnePicture) {
    std::vector<Image> pictures;
    for (const rc::Isa isa : ::test::supported_isas()) {
        const ::test::IsaScope scope(isa);
        Studio studio;
        furnish(studio);
        studio.open();
        pictures.push_back(test::path_picture(studio, view(), 50, 34, test::reference(2)));
        EXPECT_EQ(pictures[0].pixels, pictures.back().pixels) << rc::isa_name(isa);
    }
}

// What the planes say all light of a pixel is.
glm::vec3 light_at(const render::FilmPlanes& planes, int x, int y) {
    return planes.direct.get(x, y) + planes.indirect.get(x, y) + planes.specular.get(x, y) +
           planes.clean.get(x, y);
}

// A pixel does not know which other pixels are in the picture: only lens and place count.
TEST(PathSameBits, PlanesSumToThePictureAndChangeNothing) {
    Studio studio;
    furnish(studio);
    studio.open();
    render::PathSettings settings = test::reference(4);
    const Image plain = test::path_picture(studio, view(), 48, 32, settings);
    settings.fills_planes = true;
    render::Film film(48, 32);
    render::render_path({studio.level, studio.snapshot, studio.prepared}, view(), settings, 0, Jobs(2), film);
    EXPECT_EQ(plain.pixels, film.radiance.pixels);
    const render::FilmPlanes& planes = film.planes;
    std::size_t surfaces = 0, direct = 0, indirect = 0, specular = 0;
    const std::size_t pixels = film.radiance.pixels.size();
    for (std::size_t i = 0; i < pixels; ++i) {
        const int x = static_cast<int>(i % 48), y = static_cast<int>(i / 48);
        const float sum = light_at(planes, x, y).y;
        EXPECT_NEAR(sum, film.radiance.pixels[i].y, 1e-5f * (1.0f + sum));
        direct += planes.direct.y.at(x, y) > 0.0f;
        indirect += planes.indirect.y.at(x, y) > 0.0f;
        specular += planes.specular.y.at(x, y) > 0.0f;
        if (planes.part.at(x, y) == render::FilmPlanes::kSky) continue;
        ++surfaces;
        EXPECT_NEAR(glm::length(planes.normal.get(x, y)), 1.0f, 1e-4f);
        EXPECT_LT(glm::dot(planes.geometric.get(x, y), planes.position.get(x, y) - planes.eye), 1e-3f);
        EXPECT_EQ(planes.position.get(x, y), planes.previous.get(x, y));
    }
    EXPECT_GT(surfaces, pixels * 9 / 10);
    EXPECT_GT(direct, pixels / 2);
    EXPECT_GT(indirect, pixels / 2);
    EXPECT_GT(specular, pixels / 50);
}

// What a plane mirror shows lies straight ahead, behind it.
TEST(PathSameBits, PlanesUnfoldMirrors) {
    Studio studio;
    studio.add_sheet({0, 0, -2}, {3, 0, 0}, {0, 3, 0}, test::mirror(0.9f));
    studio.add_sheet({0, 0, 3}, {0, 3, 0}, {3, 0, 0}, test::matte(glm::vec3(0.5f)));
    studio.open();
    render::PathSettings settings = test::reference(1);
    settings.fills_planes = true;
    settings.jitters = false;
    render::Film film(9, 9);
    render::Camera camera{.position = {0, 0, 0}, .yaw = test::kPiF, .fov_y = 0.8f};
    render::render_path({studio.level, studio.snapshot, studio.prepared}, camera, settings, 0, Jobs(1), film);
    EXPECT_NEAR(film.planes.position.z.at(0, 0), 3.0f, 1e-4f);
    const std::uint32_t wall = film.planes.part.at(0, 0);  // who looks straight at it
    camera.yaw = 0.0f;
    render::render_path({studio.level, studio.snapshot, studio.prepared}, camera, settings, 0, Jobs(1), film);
    for (int i = 0; i < 81; ++i) {
        const int x = i % 9, y = i / 9;
        EXPECT_EQ(film.planes.part.at(x, y), wall);
        EXPECT_NEAR(film.planes.position.z.at(x, y), -7.0f, 1e-4f);  // 2 to the mirror, 5 back to the wall
        EXPECT_NEAR(film.planes.normal.z.at(x, y), 1.0f, 1e-5f);
    }
}

// A pixel of many samples may show the rim of a bright thing as well as the wall behind it. What is the rim's light must not
// count as the wall's: filters would spread it over all of the wall in sight.
TEST(PathSameBits, PlanesCountLightOnWhatIsBesideTheirSurfaceAsNoneOfIts) {
    Studio studio;
    studio.add_sheet({0, 0, -4}, {8, 0, 0}, {0, 8, 0}, test::matte(glm::vec3(0.01f)));
    studio.add_sheet({-1.02f, 0, -2}, {1, 0, 0}, {0, 1, 0},
                     test::matte(glm::vec3(0.9f)));  // ends within pixels
    studio.add_lamp(
        {.name = {}, .shape = world::LampShape::Point, .position = {0, 0, 1}, .intensity = {9, 9, 9}});
    studio.open();
    render::PathSettings settings = test::reference(16);
    settings.fills_planes = true;
    render::Film film(9, 9);
    const render::Camera camera{.position = {0, 0, 0}, .fov_y = 0.6f};
    render::render_path({studio.level, studio.snapshot, studio.prepared}, camera, settings, 0, Jobs(1), film);
    const render::FilmPlanes& planes = film.planes;
    const std::uint32_t sheet = planes.part.at(0, 0), wall = planes.part.at(8, 0);
    ASSERT_NE(sheet, wall);
    const float on_sheet = planes.direct.y.at(0, 0), on_wall = planes.direct.y.at(8, 0);
    ASSERT_GT(on_sheet, 50.0f * on_wall);
    int mixed = 0;
    for (int i = 0; i < 81; ++i) {
        const int x = i % 9, y = i / 9;
        const bool is_wall = planes.part.at(x, y) != sheet;
        EXPECT_LT(planes.direct.y.at(x, y), 1.3f * (is_wall ? on_wall : on_sheet)) << i;  // of all samples
        EXPECT_NEAR(light_at(planes, x, y).y, film.radiance.at(x, y).y, 1e-5f);
        mixed += is_wall && planes.clean.y.at(x, y) > 0.1f * on_sheet ? 1 : 0;
    }
    EXPECT_GT(mixed, 0) << "the test's edge is no challenge";
}

// What stands still is one part to the renderer. Brass beside plaster must be two things to the filters, or plaster shines
// with what brass mirrors.
TEST(PathSameBits, PlanesTellMaterialsApartAndSayHowMuchTheyMirror) {
    Studio studio;
    world::Material brass = test::matte(glm::vec3(0.9f, 0.6f, 0.3f));
    brass.metallic = 1.0f;
    world::Material plaster = test::matte(glm::vec3(0.5f));
    plaster.ior = 1.5f;
    brass.roughness = 0.3f;
    studio.add_sheet({-1.5f, 0, -2}, {1.5f, 0, 0}, {0, 3, 0}, brass);
    studio.add_sheet({1.5f, 0, -2}, {1.5f, 0, 0}, {0, 3, 0}, plaster);
    studio.open();
    render::PathSettings settings = test::reference(1);
    settings.fills_planes = true;
    render::Film film(8, 1);
    const render::Camera camera{.position = {0, 0, 0}, .fov_y = 0.1f};
    render::render_path({studio.level, studio.snapshot, studio.prepared}, camera, settings, 0, Jobs(1), film);
    const render::FilmPlanes& planes = film.planes;
    for (int i = 0; i < 8; ++i) EXPECT_EQ(planes.part.at(i, 0), planes.part.at(i < 4 ? 0 : 7, 0)) << i;
    EXPECT_NE(planes.part.at(0, 0), planes.part.at(7, 0));
    EXPECT_NEAR(planes.gloss.x.at(0, 0), 0.9f, 0.02f);
    EXPECT_NEAR(planes.gloss.z.at(0, 0), 0.3f, 0.05f);
    EXPECT_GT(planes.gloss.x.at(7, 0), 0.01f);
    EXPECT_LT(planes.gloss.x.at(7, 0), 0.06f);
    EXPECT_EQ(planes.albedo.get(0, 0), glm::vec3(0.0f));
}

TEST(PathSameBits, NoMaterialHoweverBrokenMakesAPixelThatIsNotANumber) {
    const float kNan = std::numeric_limits<float>::quiet_NaN(), kInf = std::numeric_limits<float>::infinity();
    for (const float bad : {kNan, kInf, -1.0f}) {
        for (int which = 0; which < 10; ++which) {
            Studio studio;
            furnish(studio);
            world::Material material = test::clear_glass(1.5f);
            material.transmission = which % 2 == 0 ? 0.5f : 0.0f;
            float* const numbers[] = {
                &material.base_color.x, &material.base_color.w,        &material.metallic,
                &material.roughness,    &material.transmission,        &material.ior,
                &material.specular,     &material.attenuation_color.y, &material.attenuation_distance,
                &material.emission.z};
            *numbers[which] = bad;
            material.alpha_mode = which == 1 ? world::AlphaMode::Blend : world::AlphaMode::Opaque;
            studio.add_box({-0.4f, 0.3f, 0.2f}, {0.7f, 1.4f, 0.9f}, material);
            studio.open();
            for (const bool is_realtime : {false, true}) {
                render::PathSettings settings = is_realtime ? render::realtime_path() : test::reference(2);
                for (const glm::vec3& pixel : test::path_picture(studio, view(), 12, 8, settings).pixels) {
                    EXPECT_TRUE(std::isfinite(pixel.x) && std::isfinite(pixel.y) && std::isfinite(pixel.z))
                        << "number " << which << " is " << bad;
                    EXPECT_GE(pixel.y, 0.0f);
                }
            }
        }
    }
}

TEST(PathSameBits, ABlackSceneIsBlackAndAnEmptyOneIsSky) {
    Studio black;
    black.add_box({-1, -1, -1}, {1, 1, 1}, test::matte(glm::vec3(0.0f)), true);
    black.open();
    for (const glm::vec3& pixel :
         test::path_picture(black, test::narrow({0, 0, 0}), 4, 4, test::reference(4)).pixels)
        EXPECT_EQ(pixel, glm::vec3(0.0f));
}

}  // namespace
}  // namespace gh
