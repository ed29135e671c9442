// A brass ring is seen itself in every pixel, with what it mirrors: out of the last picture where that showed it, and
// guessed where not.
#include "render/ambient.h"
#include "render/guide.h"
#include "render/guide_point.h"
#include "render/last_picture.h"
#include "render/light_math.h"
#include "render/polish.h"
#include "studio.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>

namespace gh {
namespace {

using test::Studio;

constexpr glm::ivec2 kSize(96, 64);
constexpr float kCeilingAt = 3.0f;
constexpr glm::vec3 kBrass(0.9f, 0.65f, 0.3f), kCeiling(0.6f, 0.3f, 0.2f), kBall(0.0f, 0.7f, 0.5f);
const render::Camera kEye{.position = {0.0f, 1.4f, 2.5f}, .pitch = -0.6f, .fov_y = 1.1f};

world::Material brass(float roughness) {
    world::Material material;
    material.base_color = glm::vec4(kBrass, 1.0f);
    material.metallic = 1.0f;
    material.roughness = roughness;
    return material;
}

// Walls all round, a ceiling out of sight, and a lamp behind the eye.
Studio room() {
    Studio studio;
    studio.add_box({-3, -0.1f, -4}, {3, kCeilingAt + 0.1f, 4}, test::matte({0.7f, 0.6f, 0.5f}), true);
    studio.add_sheet({0, kCeilingAt, 0}, {3, 0, 0}, {0, 0, 4}, test::matte(kCeiling));
    studio.add_lamp({.name = {},
                     .shape = world::LampShape::Sphere,
                     .position = {0.3f, 1.2f, 3.5f},
                     .intensity = glm::vec3(3000.0f),
                     .radius = 0.05f});
    return studio;
}
Studio room_with_floor(float roughness) {
    Studio studio = room();
    studio.add_sheet({0, 0, 0}, {3, 0, 0}, {0, 0, -4}, brass(roughness));
    studio.open({.bakes_ambient = true});
    return studio;
}
constexpr std::uint32_t kMetal = 2;  // the part that comes after the room's two

struct Seen {
    render::GuidePlanes guide;
    Image picture;
};
// The guide of a picture that follows one of the same view.
Seen seen_twice(const Studio& studio) {
    render::WhittedSettings settings;
    settings.shares_samples = false;
    Seen seen{{}, studio.picture(kEye, kSize.x, kSize.y, settings)};
    const render::SceneView view{studio.level, studio.snapshot, studio.prepared};
    render::GuidePlanes before;
    render::render_guide(view, kEye, settings, kSize, Jobs(1), before);
    const render::LastPicture last(seen.picture, before, kSize);
    render::render_guide({studio.level, studio.snapshot, studio.prepared, nullptr, &last}, kEye, settings,
                         kSize, Jobs(1), seen.guide);
    return seen;
}

render::Polish polish_at(const Studio& studio, const glm::vec3& way, float roughness) {
    return render::polish_of(studio.prepared.gloss, kBrass, 1.0f, roughness, -way.y);
}

// By hand: a ray off the floor meets the ceiling, which no picture showed, and brings its colour under the baked light.
TEST(GuideMetals, WhatWasOutOfSightIsGuessed) {
    constexpr float kRoughness = 0.1f;  // all of it is followed
    const Studio studio = room_with_floor(kRoughness);
    const render::GuidePlanes guide = seen_twice(studio).guide;
    const render::AmbientLight baked(studio.prepared.ambient, {});
    int guessed = 0;
    for (std::size_t i = 0; i < guide.part.size(); ++i) {
        if (guide.part[i] != kMetal) continue;
        const glm::vec3 way = glm::normalize(guide.position[i] - guide.eye);
        const glm::vec3 up(way.x, -way.y, way.z);
        const glm::vec3 above = guide.position[i] + up * (kCeilingAt / up.y);
        if (glm::any(glm::greaterThan(glm::abs(above), glm::vec3(2.9f, kCeilingAt + 1e-3f, 3.9f)))) continue;
        ++guessed;
        const render::Polish polish = polish_at(studio, way, kRoughness);
        ASSERT_FLOAT_EQ(polish.ray_share, 1.0f);
        const glm::vec3 light = baked.irradiance(above, glm::vec3(0, -1, 0)) * render::kPerPi;
        ASSERT_GT(light.x, 1e-3f);
        const glm::vec3 expected = polish.glossy * light * (kCeiling + render::guide_albedo({}, 0.0f));
        // The place is a few roundings off, and baked light is steep where a grid point goes out of sight.
        for (std::size_t c = 0; c < 3; ++c)
            EXPECT_NEAR(guide.clean.pixels[i][c], expected[c], 1e-3f * expected[c]);
    }
    EXPECT_GT(guessed, 300);
}

// Gilt is too rough for a ray to be sent: it gives back the baked light.
TEST(GuideMetals, DullOnesGiveBackWhatIsBaked) {
    constexpr float kRoughness = 0.42f;
    const Studio studio = room_with_floor(kRoughness);
    const render::GuidePlanes guide = seen_twice(studio).guide;
    const render::AmbientLight baked(studio.prepared.ambient, {});
    int dull = 0;
    for (std::size_t i = 0; i < guide.part.size(); ++i) {
        if (guide.part[i] != kMetal) continue;
        ++dull;
        const glm::vec3 way = glm::normalize(guide.position[i] - guide.eye);
        glm::vec3 irradiance, reflected;
        baked.gather(guide.position[i], {0, 1, 0}, {way.x, -way.y, way.z}, irradiance, reflected);
        const glm::vec3 expected = polish_at(studio, way, kRoughness).glossy * reflected;
        ASSERT_GT(expected.x, 1e-3f);
        for (std::size_t c = 0; c < 3; ++c)
            EXPECT_NEAR(guide.clean.pixels[i][c], expected[c], 1e-3f * expected[c]);
    }
    EXPECT_GT(dull, 1000);
}

// Every pixel of a ball is the ball's, where the ball is, and lends its light to all of it; a clear mirror is looked into.
TEST(GuideMetals, AreSeenThemselvesUnlessTheyAreClearMirrors) {
    for (const float roughness : {0.0f, 0.28f}) {
        Studio studio = room();
        studio.add_ball(kBall, 0.6f, 32, brass(roughness));
        studio.open({.bakes_ambient = true});
        const render::GuidePlanes guide = seen_twice(studio).guide;
        int ball = 0;
        for (std::size_t i = 0; i < guide.part.size(); ++i) {
            if (guide.part[i] != kMetal) continue;
            ++ball;
            // A ring of 32 lies up to 1 - cos(pi / 64) within the ball.
            EXPECT_NEAR(glm::distance(guide.position[i], kBall), 0.6f, 0.6f * 2.5e-3f);
            EXPECT_EQ(guide.albedo[i], render::guide_albedo(kBrass, 1.0f));
        }
        if (roughness > 0.0f) {
            EXPECT_GT(ball, 300);
        } else {
            EXPECT_EQ(ball, 0);
        }
    }
}

// What lit pixels have left to say of a ball, most of which mirrors what lies behind the eye: the lamp's own light there,
// since the guess is of baked light alone. It is .28, and .61 where nothing is guessed.
TEST(GuideMetals, WhatIsLeftToLightIsLess) {
    Studio studio = room();
    studio.add_ball(kBall, 0.6f, 32, brass(0.2f));
    studio.open({.bakes_ambient = true});
    const Seen seen = seen_twice(studio);
    double all = 0.0, left = 0.0;
    for (std::size_t i = 0; i < seen.guide.part.size(); ++i) {
        if (seen.guide.part[i] != kMetal) continue;
        all += static_cast<double>(seen.picture.pixels[i].y);
        left += static_cast<double>(std::abs(seen.picture.pixels[i].y - seen.guide.clean.pixels[i].y));
    }
    EXPECT_GT(all, 10.0);
    EXPECT_LT(left, 0.4 * all);
}

}  // namespace
}  // namespace gh
