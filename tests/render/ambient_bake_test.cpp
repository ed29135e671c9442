// The light that comes off walls, baked on a grid: it is what paths find it to be, where lamps hide in shades, where walls
// have two sides by their glTF, in passages narrower than the grid, and in rooms that only a doorway lights.
#include "path_studio.h"
#include "render/ambient.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace gh::test {
namespace {

constexpr float kAlbedo = 0.4f;

// Blender writes two sides into every material; a shell is a wall all the same.
void add_room(Studio& studio, const glm::vec3& min, const glm::vec3& max) {
    world::Material plaster = matte(glm::vec3(kAlbedo));
    plaster.is_double_sided = true;
    studio.level.parts[studio.add_box(min, max, plaster, true)].is_shell = true;
}

// A small bulb under a white shade, open below: it lights the ceiling by way of the floor only.
void hang_lamp(Studio& studio, const glm::vec3& at) {
    world::Material enamel = matte(glm::vec3(0.8f));
    enamel.is_double_sided = true;
    constexpr float kHalf = 0.15f, kTop = 0.12f;
    studio.add_sheet(at + glm::vec3(0, kTop, 0), {kHalf, 0, 0}, {0, 0, kHalf}, enamel);
    for (const float side : {-1.0f, 1.0f}) {
        studio.add_sheet(at + glm::vec3(side * kHalf, 0, 0), {0, kTop, 0}, {0, 0, kHalf}, enamel);
        studio.add_sheet(at + glm::vec3(0, 0, side * kHalf), {kHalf, 0, 0}, {0, kTop, 0}, enamel);
    }
    world::Lamp bulb;
    bulb.shape = world::LampShape::Sphere;
    bulb.position = at;
    bulb.radius = 0.03f;
    bulb.intensity = glm::vec3(600.0f);
    studio.add_lamp(bulb);
}

// Median of |log(baked / path-traced)| over a grid of places on a ceiling: paths find the insides of shades by chance, and
// one place in ten is off by more than the bake.
double ceiling_error(const Studio& studio, const glm::vec3& min, const glm::vec3& max) {
    const render::AmbientLight light(studio.prepared.ambient, {});
    const float up = 1.5707963f;
    std::vector<double> off;
    constexpr int kSide = 4;
    for (int i = 0; i < kSide * kSide; ++i) {
        const glm::vec2 share((0.5f + static_cast<float>(i % kSide)) / kSide,
                              (0.5f + static_cast<float>(i / kSide)) / kSide);
        const glm::vec3 place(min.x + (max.x - min.x) * share.x, max.y, min.z + (max.z - min.z) * share.y);
        const Image picture =
            path_picture(studio, narrow(place - glm::vec3(0, 0.05f, 0), 0.0f, up), 4, 4, reference(128));
        double radiance = 0.0;
        for (const glm::vec3& pixel : picture.pixels) radiance += static_cast<double>(pixel.y) / 16.0;
        const double truth = radiance * static_cast<double>(kPiF / kAlbedo);
        const double baked = static_cast<double>(light.irradiance(place, {0, -1, 0}).y);
        off.push_back(std::abs(std::log(std::max(baked, 1e-6) / std::max(truth, 1e-6))));
    }
    std::nth_element(off.begin(), off.begin() + kSide * kSide / 2, off.end());
    return off[kSide * kSide / 2];
}

constexpr render::PrepareSettings kBaked{.bakes_ambient = true};

// A ceiling that stands in for what paths find shows no blotches of the size of the grid.
TEST(AmbientBake, IsWhatPathsFindOnTheCeilingOfARoomLitByLampsInShades) {
    Studio studio;
    const glm::vec3 min(-3.2f, 0.0f, -2.3f), max(3.1f, 3.2f, 2.4f);
    add_room(studio, min, max);
    hang_lamp(studio, {-1.4f, 2.2f, -0.6f});
    hang_lamp(studio, {1.7f, 1.9f, 0.9f});
    studio.open(kBaked);
    EXPECT_LT(ceiling_error(studio, min, max), 0.25);
}

// A duct of 1.1 m that lies between the points of a grid of 1.4 m, wherever those fall. What is far from its lamp is judged,
// by the factor of two that such a grid may be trusted with.
TEST(AmbientBake, ReachesPassagesNarrowerThanItsGrid) {
    for (const float offset : {0.0f, 0.5f, 1.0f}) {
        Studio studio;
        const glm::vec3 min(-3.0f, offset, offset), max(3.0f, 1.1f + offset, 1.1f + offset);
        add_room(studio, min, max);
        add_room(studio, {-3.0f, -4.0f, -6.0f},
                 {3.0f, -2.0f, -4.0f});  // for the grid to go on beyond the duct
        hang_lamp(studio, {-2.2f, 0.7f + offset, 0.55f + offset});
        studio.open(kBaked);
        EXPECT_LT(ceiling_error(studio, {-0.5f, min.y, min.z + 0.2f}, {1.5f, max.y, max.z - 0.2f}),
                  std::log(2.0))
            << "offset " << offset;
    }
}

// Lamps beyond the wall are in the dark room's lists and give it nothing; what little comes through the door is all there
// is, and no pixel goes without it.
TEST(AmbientBake, LeavesNoPixelBlackInARoomLitThroughItsDoorway) {
    Studio studio;
    add_room(studio, {-4.0f, 0.0f, -3.0f}, {4.0f, 3.0f, 3.0f});
    world::Material plaster = matte(glm::vec3(kAlbedo));
    plaster.is_double_sided = true;
    studio.add_box({-0.1f, 0.0f, -3.0f}, {0.1f, 3.0f, 2.2f}, plaster);
    for (int i = 0; i < 6; ++i) {
        world::Lamp bulb;
        bulb.shape = world::LampShape::Sphere;
        bulb.position = {1.0f + 0.4f * static_cast<float>(i), 2.0f, -2.4f};
        bulb.radius = 0.05f;
        bulb.intensity = glm::vec3(100.0f);
        studio.add_lamp(bulb);
    }
    studio.open(kBaked);
    const render::Camera eye{.position = {-0.6f, 1.5f, 0.0f}, .yaw = 1.5707963f, .fov_y = 1.0f};
    const Image picture = studio.picture(eye, 96, 64, {});
    double mean = 0.0;
    for (const glm::vec3& pixel : picture.pixels)
        mean += static_cast<double>(pixel.y) / static_cast<double>(picture.pixels.size());
    ASSERT_GT(mean, 1e-4);
    const auto black = std::count_if(picture.pixels.begin(), picture.pixels.end(), [&](const glm::vec3& p) {
        return static_cast<double>(p.y) < 0.02 * mean;
    });
    EXPECT_EQ(black, 0) << "of " << picture.pixels.size();
}

}  // namespace
}  // namespace gh::test
