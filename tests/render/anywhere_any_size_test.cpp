// A room is lit alike wherever it stands and however large it is; and by a hundred thousand lamps as by one.
#include "path_studio.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace gh {
namespace {

using test::Studio;

constexpr double kPanelOverFloor =
    0.11972824;  // radiance of a floor of albedo .5, 1 m below a panel of 1 m^2

// A floor below a panel that glows, as two meshes that stand `at` in the world: their own coordinates stay small.
void furnish(Studio& studio, const glm::vec3& at, float scale = 1.0f) {
    studio.add_sheet(glm::vec3(0.0f), {0, 0, 10 * scale}, {10 * scale, 0, 0}, test::matte(glm::vec3(0.5f)));
    studio.add_sheet({0, scale, 0}, {0.5f * scale, 0, 0}, {0, 0, 0.5f * scale}, test::glowing(1.0f));
    for (world::Part& part : studio.level.parts) part.mover_from_part[3] = at;
    studio.open();
}

// Down to the middle of the floor, from half way up.
render::Camera looking_down_at(const glm::vec3& at, float scale = 1.0f) {
    return test::narrow(at + glm::vec3(0, 0.5f * scale, 0), 0.0f, test::kDown);
}

// A point of the world is a float: at 1e3 m it is known to 6e-5 m. What that does to light from 1 m away is not noise
// but another place; twice the spacing is allowed. (Cycles errs by 1.3e-2 of it at 1e6 m.)
TEST(Anywhere, APanelOverAFloorFarAwayGivesWhatItGivesAtHome) {
    for (const float distance : {0.0f, 1e3f, 1e5f, 1e6f}) {
        const glm::vec3 at(distance, 0.0f, -distance);
        Studio studio;
        furnish(studio, at);
        const test::Moments m = test::moments(test::means(studio, looking_down_at(at), test::reference(256)));
        const double spacing = static_cast<double>(distance) * 0x1p-23;
        EXPECT_LT(std::abs(m.mean - kPanelOverFloor), 4.0 * m.error + 2.0 * spacing * kPanelOverFloor + 1e-5)
            << distance << " m: " << m.mean;
        ::testing::Test::RecordProperty(
            "relative_error_at_" + std::to_string(static_cast<int>(distance)) + "_m",
            std::to_string(m.mean / kPanelOverFloor - 1.0));
    }
}

// Nothing is measured in metres: a scene twice as large is the same picture, bit by bit, up to a millionfold.
TEST(AnySize, APictureScaledByAPowerOfTwoHasTheSameBits) {
    const auto pictures = [](float scale) {
        Studio studio;
        const glm::vec3 size(scale);
        studio.add_box(glm::vec3(-3, 0, -3) * size, glm::vec3(3, 3, 3) * size,
                       test::matte({0.7f, 0.6f, 0.5f}), true);
        world::Material polished = test::mirror(0.8f);
        polished.roughness = 0.3f;
        studio.add_box(glm::vec3(-1.5f, 0.01f, -1.5f) * size, glm::vec3(-0.5f, 0.8f, -0.5f) * size, polished);
        studio.add_ball(glm::vec3(1, 0.6f, -1) * size, 0.5f * scale, 12, test::clear_glass(1.5f));
        studio.add_sheet(glm::vec3(0, 2.9f, 0) * size, glm::vec3(0.4f, 0, 0) * size,
                         glm::vec3(0, 0, 0.4f) * size, test::glowing(5.0f));
        studio.open();
        const render::Camera camera{
            .position = glm::vec3(0.5f, 1.5f, 2.75f) * size, .yaw = 0.1f, .pitch = -0.15f, .fov_y = 1.0f};
        return std::pair(test::path_picture(studio, camera, 32, 20, test::reference(4)),
                         studio.picture(camera, 32, 20, test::exact()));
    };
    const auto [path, whitted] = pictures(1.0f);
    for (const int k : {-20, -7, 3, 20}) {
        const auto [scaled_path, scaled_whitted] = pictures(std::ldexp(1.0f, k));
        EXPECT_EQ(path.pixels, scaled_path.pixels) << "path, 2^" << k;
        EXPECT_EQ(whitted.pixels, scaled_whitted.pixels) << "whitted, 2^" << k;
    }
}

// Green of every pixel of one picture: as many independent estimates, and the lamps are gone through only once.
std::vector<double> pixels(const Studio& studio, const render::PathSettings& settings, int side = 16) {
    const Image picture = test::path_picture(studio, looking_down_at(glm::vec3(0.0f)), side, side, settings);
    std::vector<double> values;
    for (const glm::vec3& pixel : picture.pixels) values.push_back(static_cast<double>(pixel.y));
    return values;
}

// The panel cut into a hundred thousand lamps, joints anywhere: the same light.
TEST(ManyLamps, AHundredThousandTrianglesGiveWhatTheirPanelGives) {
    constexpr std::uint32_t kCells = 224;
    Studio studio;
    studio.add_sheet(glm::vec3(0.0f), {0, 0, 10}, {10, 0, 0}, test::matte(glm::vec3(0.5f)));
    world::Mesh mesh;
    std::uint32_t state = 1;
    const auto jitter = [&](std::uint32_t i) {
        if (i == 0 || i == kCells) return 0.0f;
        state = state * 1664525u + 1013904223u;
        return (static_cast<float>(state >> 8) * 0x1p-24f - 0.5f) * 0.8f;
    };
    for (std::uint32_t j = 0; j <= kCells; ++j) {
        for (std::uint32_t i = 0; i <= kCells; ++i) {
            const bool is_edge = i == 0 || j == 0 || i == kCells || j == kCells;
            const float x = static_cast<float>(i) + (is_edge ? 0.0f : jitter(i));
            const float z = static_cast<float>(j) + (is_edge ? 0.0f : jitter(j));
            mesh.positions.emplace_back(x / kCells - 0.5f, 1.0f, z / kCells - 0.5f);
            mesh.normals.emplace_back(0, -1, 0);
        }
    }
    for (std::uint32_t j = 0; j < kCells; ++j) {
        for (std::uint32_t i = 0; i < kCells; ++i) {
            const std::uint32_t a = j * (kCells + 1) + i, b = a + kCells + 1;
            mesh.triangles.emplace_back(a, a + 1, b);
            mesh.triangles.emplace_back(a + 1, b + 1, b);
        }
    }
    ASSERT_GT(mesh.triangles.size(), 100'000u);
    studio.add_part(std::move(mesh), test::glowing(1.0f));
    studio.open();
    test::expect_mean(pixels(studio, test::reference(256)), kPanelOverFloor, 2e-4);
}

// The same number of points of light, each its own lamp of the level: summed one by one.
TEST(ManyLamps, AHundredThousandPointsGiveTheSumOfEach) {
    constexpr int kSide = 320;
    Studio studio;
    studio.add_sheet(glm::vec3(0.0f), {0, 0, 10}, {10, 0, 0}, test::matte(glm::vec3(1.0f)));
    double truth = 0.0;
    for (int i = 0; i < kSide * kSide; ++i) {
        const glm::vec3 at(0.02f * static_cast<float>(i % kSide - kSide / 2),
                           2.0f + 0.001f * static_cast<float>(i % 97),
                           0.02f * static_cast<float>(i / kSide - kSide / 2));
        const float power = 1e-5f * static_cast<float>(1 + i % 5);
        studio.add_lamp(
            {.name = {}, .shape = world::LampShape::Point, .position = at, .intensity = glm::vec3(power)});
        const glm::dvec3 way(at);
        const double d2 = glm::dot(way, way);
        truth += static_cast<double>(power) * way.y / (d2 * std::sqrt(d2)) / 3.14159265358979;
    }
    studio.open({.bakes_ambient = false, .lamp_list_rays = 0});
    const render::Environment night = test::even_light(0.0f);
    render::PathSettings settings = test::reference(128);
    settings.environment = &night;
    test::expect_mean(pixels(studio, settings), truth, 5e-3 * truth);
}

}  // namespace
}  // namespace gh
