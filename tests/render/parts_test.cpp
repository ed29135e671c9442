// The renderer's pieces: camera, textures, gloss, sampler, ambient light.
#include "render/gloss.h"
#include "render/sampler.h"
#include "render/texture_lookups.h"
#include "studio.h"

#include <gtest/gtest.h>

#include <array>

namespace gh {
namespace {

using test::Studio;

TEST(Camera, YawTurnsLeftPitchLooksUpAndPixelsRunRightAndDown) {
    const render::Lens ahead({.fov_y = 1.0f}, 100, 50);
    EXPECT_LT(glm::length(ahead.ray({50, 25}).direction - glm::vec3(0, 0, -1)), 1e-6f);
    EXPECT_GT(ahead.ray({80, 25}).direction.x, 0.1f);
    EXPECT_LT(ahead.ray({50, 40}).direction.y, -0.1f);
    const render::Lens left({.yaw = test::kPiF / 2, .fov_y = 1.0f}, 100, 50);
    EXPECT_LT(glm::length(left.ray({50, 25}).direction - glm::vec3(-1, 0, 0)), 1e-6f);
    const render::Lens up({.pitch = 0.5f, .fov_y = 1.0f}, 100, 50);
    EXPECT_NEAR(up.ray({50, 25}).direction.y, std::sin(0.5f), 1e-6f);
    EXPECT_NEAR(ahead.ray({50, 0}).direction.y, std::sin(0.5f), 1e-6f)
        << "the top edge is half the opening away";
}

world::Texture checker(int side) {
    world::Texture texture{.name = "checker", .width = side, .height = side, .rgba = {}};
    for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side; ++x) {
            const std::uint8_t value = (x + y) % 2 == 0 ? 255 : 0;
            texture.rgba.insert(texture.rgba.end(), {value, value, value, 255});
        }
    }
    return texture;
}

// Seen head on, over so much of its sides.
glm::vec4 looked_up(const render::MipTexture& mips, const glm::vec2& uv, const glm::vec2& patch) {
    render::TextureLookUps looks;
    looks.add(mips, {uv, {{patch.x, 0, 0}, {0, patch.y, 0}}},
              {.direction = {0, 0, -1}, .normal = {0, 0, 1}, .width = 1.0f});
    looks.work_out(8.0f);
    return looks.value(0);
}

TEST(Texture, ACheckerFarAwayIsHalfAsBrightInLinearLight) {
    const world::Texture texture = checker(64);
    const render::MipTexture mips(texture, render::Encoding::Srgb);
    EXPECT_NEAR(looked_up(mips, {0.3f, 0.7f}, {0.5f, 0.5f}).x, 0.5f, 0.01f);
    EXPECT_EQ(looked_up(mips, {0.5f / 64, 0.5f / 64}, {0, 0}).x, 1.0f);
    EXPECT_EQ(mips.at({1.5f / 64, 0.5f / 64}).x, 0.0f);
}

TEST(Texture, AConstantStaysConstantHoweverItIsLookedAt) {
    world::Texture texture{.name = "grey", .width = 7, .height = 5, .rgba = {}};
    for (int i = 0; i < 35; ++i) texture.rgba.insert(texture.rgba.end(), {188, 100, 30, 200});
    const render::MipTexture mips(texture, render::Encoding::Srgb);
    const glm::vec4 plain = mips.at({0.5f, 0.5f});
    EXPECT_NEAR(plain.x, 0.50289f, 1e-4f);  // sRGB 188
    for (const float width : {0.01f, 0.3f, 1.0f, 50.0f}) {
        for (const glm::vec2 uv : {glm::vec2(0.1f, 0.9f), glm::vec2(-3.3f, 17.0f), glm::vec2(NAN, 1e30f)}) {
            const glm::vec4 seen = looked_up(mips, uv, {width, width / 9});
            EXPECT_LT(glm::length(seen - plain), 2e-3f) << width;
        }
    }
}

TEST(Gloss, ReflectsNeverMoreThanComesInAndAMirrorAllOfIt) {
    const render::GlossTable table;
    for (float roughness = 0.0f; roughness <= 1.0f; roughness += 0.05f) {
        for (float cosine = 0.0f; cosine <= 1.0f; cosine += 0.05f) {
            const float white = table.albedo(glm::vec3(1.0f), 1.0f, cosine, roughness).x;
            EXPECT_LE(white, 1.00001f) << roughness << ' ' << cosine;
            EXPECT_GT(white, roughness < 0.27f ? 0.85f : 0.3f) << roughness << ' ' << cosine;
        }
    }
    EXPECT_NEAR(table.albedo(glm::vec3(0.9f), 1.0f, 1.0f, 0.0f).x, 0.9f, 1e-6f);
}

TEST(Sampler, EveryBlockOfSixteenPixelsLooksIntoEveryPartOfALamp) {
    for (std::uint32_t purpose = 0; purpose < 20; ++purpose) {
        std::array<int, 16> cells{};
        for (int y = 4; y < 8; ++y) {
            for (int x = 8; x < 12; ++x) {
                const glm::vec2 p = render::pixel_sampler(x, y, 7, true).point(0, purpose, 0);
                ++cells[static_cast<std::size_t>(p.y * 4.0f) * 4 + static_cast<std::size_t>(p.x * 4.0f)];
            }
        }
        for (const int count : cells) EXPECT_EQ(count, 1);
    }
}

// A closed room of albedo r that glows with 1 everywhere: after n bounces what is seen is 1 + r + ... + r^n.
TEST(Ambient, AGlowingRoomAddsUpItsBounces) {
    for (const int bounces : {1, 3}) {
        Studio studio;
        world::Material wall = test::matte(glm::vec3(0.5f));
        wall.emission = glm::vec3(1.0f);
        studio.add_box({-2, -2, -2}, {2, 2, 2}, wall, true);
        studio.open({.spacing = 1.0f, .rays = 64, .bounces = bounces});
        render::WhittedSettings settings = test::exact();
        settings.uses_ambient = true;
        const double expected = (1.0 - std::pow(0.5, bounces + 1)) / 0.5;
        const render::Camera camera{.position = {0.3f, 0.2f, 0.1f}, .yaw = 0.7f, .fov_y = 1.5f};
        for (const glm::vec3& pixel : studio.picture(camera, 16, 16, settings).pixels) {
            EXPECT_NEAR(pixel.x, expected, 1e-3) << "bounces " << bounces;
        }
    }
}

TEST(Ambient, AGreyBallInUniformLightShowsItsAlbedo) {
    Studio studio;
    studio.add_box({-3, -3, -3}, {3, 3, 3}, test::glowing(1.0f), true);
    studio.add_ball({0, 0, 0}, 0.2f, 16, test::matte(glm::vec3(0.5f)));
    studio.open({.spacing = 1.5f, .rays = 96, .bounces = 1});
    render::WhittedSettings settings = test::exact();
    settings.uses_ambient = true;
    const Image image = studio.picture({.position = {0, 0, 2}, .fov_y = 0.1f}, 16, 16, settings);
    for (const glm::vec3& pixel : image.pixels)
        EXPECT_NEAR(pixel.x, 0.5f, 0.02f);  // the ball hides a little of the room
}

// The lit room's light must not come through the wall into the dark one, though grid points lie on both sides.
TEST(Ambient, AWallKeepsTheLightOnItsSide) {
    Studio studio;
    studio.add_box({-4, 0, -2}, {-0.1f, 3, 2}, test::matte(glm::vec3(0.7f)), true);
    studio.add_box({0.1f, 0, -2}, {4, 3, 2}, test::matte(glm::vec3(0.7f)), true);
    studio.add_lamp(
        {.name = {}, .shape = world::LampShape::Point, .position = {-2, 2, 0}, .intensity = glm::vec3(5.0f)});
    studio.open({.spacing = 1.1f, .rays = 64});
    const render::AmbientLight light(studio.prepared.ambient, {});
    const float lit = light.irradiance({-0.11f, 1.3f, 0.2f}, {-1, 0, 0}).x;
    EXPECT_GT(lit, 0.05f);
    EXPECT_LT(light.irradiance({0.11f, 1.3f, 0.2f}, {1, 0, 0}).x, 0.01f * lit);
    EXPECT_LT(light.irradiance({2.0f, 0.01f, 0.2f}, {0, 1, 0}).x, 0.01f * lit);
}

}  // namespace
}  // namespace gh
