// What a polished floor mirrors is shown in every pixel as the last picture had it: found where it was, weighed as a
// picture weighs it, and left out where nobody knows.
#include "render/guide.h"
#include "render/last_picture.h"
#include "render/polish.h"
#include "studio.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>

namespace gh {
namespace {

using test::Studio;

constexpr glm::ivec2 kSize(96, 64);
constexpr float kWallAt = -3.0f, kRoughness = 0.1f;
const render::Camera kAbove{.position = {0.0f, 1.4f, 2.5f}, .pitch = -0.25f, .fov_y = 1.1f};

// A black floor as polished as the museum's, a wall behind it, and a lamp before the wall.
Studio polished_room() {
    world::Material floor = test::matte(glm::vec3(0.0f));
    floor.ior = 1.5f;
    floor.roughness = kRoughness;
    Studio studio;
    studio.add_sheet({0, 0, 0}, {4, 0, 0}, {0, 0, -4}, floor);
    studio.add_sheet({0, 1.0f, kWallAt}, {4, 0, 0}, {0, 1.0f, 0}, test::matte({0.7f, 0.6f, 0.5f}));
    studio.add_lamp({.name = {},
                     .shape = world::LampShape::Sphere,
                     .position = {0.3f, 1.2f, -1.5f},
                     .intensity = glm::vec3(3000.0f),
                     .radius = 0.05f});
    studio.open();
    return studio;
}

render::GuidePlanes guide_of(const Studio& studio, const render::LastPicture* last, int threads = 1,
                             const render::WhittedSettings& settings = {}) {
    render::GuidePlanes planes;
    render::render_guide({studio.level, studio.snapshot, studio.prepared, nullptr, last}, kAbove, settings,
                         kSize, Jobs(threads), planes);
    return planes;
}

Image filled(const glm::vec3& colour) {
    Image image(kSize.x, kSize.y);
    for (glm::vec3& pixel : image.pixels) pixel = colour;
    return image;
}

// The middle of a pixel is where it was, to the rounding of a projection; another part, another plane, what lies behind the
// eye and no number at all were not in sight. A picture of twice the sides has that place between its pixels.
TEST(LastPicture, FindsWhatItShowedAndNothingElse) {
    const Studio studio = polished_room();
    const render::GuidePlanes guide = guide_of(studio, nullptr);
    for (const int scale : {1, 2}) {
        Image ramp(kSize.x * scale, kSize.y * scale);
        for (int y = 0; y < ramp.height; ++y) {
            for (int x = 0; x < ramp.width; ++x) ramp.at(x, y) = glm::vec3(x, y, 1.0f);
        }
        const render::LastPicture last(ramp, guide, kSize);
        int found = 0;
        for (std::size_t i = 0; i < guide.part.size(); ++i) {
            if (guide.part[i] == render::GuidePlanes::kSky) continue;
            const glm::vec3& at = guide.position[i];
            const auto seen = last.seen(at, guide.part[i]);
            ASSERT_TRUE(seen.has_value()) << i;
            ++found;
            const auto index = static_cast<int>(i);
            const float half = 0.5f * static_cast<float>(scale - 1);
            EXPECT_NEAR(seen->x, static_cast<float>(scale * (index % kSize.x)) + half, 2e-3f);
            EXPECT_NEAR(seen->y, static_cast<float>(scale * (index / kSize.x)) + half, 2e-3f);
            EXPECT_FALSE(last.seen(at, guide.part[i] + 1));
            EXPECT_FALSE(last.seen(at - guide.geometric[i], guide.part[i]));
            EXPECT_FALSE(last.seen(2.0f * guide.eye - at, guide.part[i]));
            EXPECT_FALSE(last.seen(glm::vec3(std::numeric_limits<float>::quiet_NaN()), guide.part[i]));
        }
        EXPECT_GT(found, 3000);
    }
}

// A column that nobody knows the reflections of is seen in a floor all the same.
TEST(LastPicture, FindsWhatIsPolishedItself) {
    const Studio studio = polished_room();
    render::GuidePlanes guide = guide_of(studio, nullptr);
    const std::size_t middle = guide.part.size() / 2 + static_cast<std::size_t>(kSize.x) / 2;
    const std::uint32_t part = guide.part[middle];
    guide.part[middle] |= render::GuidePlanes::kUnmirrored;
    const Image picture = filled(glm::vec3(0.3f));
    EXPECT_TRUE(render::LastPicture(picture, guide, kSize).seen(guide.position[middle], part));
}

// By hand: the mirrored ray meets the wall at a height, and brings what the last picture, all of one colour, showed there.
TEST(GuideGleams, AFloorMirrorsWhatTheLastPictureShowed) {
    Studio studio = polished_room();
    studio.level.lamps[0].intensity = glm::vec3(0.0f);
    const render::GuidePlanes before = guide_of(studio, nullptr);
    const glm::vec3 colour(2.0f, 1.0f, 0.5f);
    const Image picture = filled(colour);
    const render::LastPicture last(picture, before, kSize);
    const render::GuidePlanes guide = guide_of(studio, &last);
    int mirrored = 0, unknown = 0;
    for (std::size_t i = 0; i < guide.part.size(); ++i) {
        if (before.part[i] != 0) {
            EXPECT_EQ(guide.clean.pixels[i], before.clean.pixels[i]) << "not of the floor: " << i;
            continue;
        }
        const glm::vec3 way = glm::normalize(guide.position[i] - guide.eye);
        const float height =
            -way.y / way.z * (kWallAt - guide.position[i].z);  // where the mirrored ray meets the wall
        const auto polish =
            render::polish_of(studio.prepared.gloss, glm::vec3(0.04f), 0.0f, kRoughness, -way.y);
        const glm::vec3 weight = polish.glossy * polish.ray_share;
        if (guide.part[i] !=
            before
                .part[i]) {  // too little to be followed, or over the wall, where the sky is, or out of sight
            ++unknown;
            EXPECT_EQ(guide.clean.pixels[i], glm::vec3(0.0f));
        } else if (height < 1.9f &&
                   std::abs(guide.position[i].x + way.x / way.z * (kWallAt - guide.position[i].z)) < 3.9f) {
            ++mirrored;
            // The guide's own position is a few roundings off the ray's.
            EXPECT_NEAR(guide.clean.pixels[i].x, weight.x * colour.x, 1e-4f * weight.x) << i;
            EXPECT_NEAR(guide.clean.pixels[i].z, weight.z * colour.z, 1e-4f * weight.z) << i;
        }
    }
    EXPECT_GT(mirrored, 200);
    EXPECT_GT(unknown, 200);
}

// Of a black floor a picture shows nothing but what it mirrors, and that is what the guide must say: the bulb's highlight,
// the wall's light. The picture's shadows are of one random ray, and textures of another sharpness.
TEST(GuideGleams, WhatIsLeftToLightIsLittle) {
    const Studio studio = polished_room();
    render::WhittedSettings settings;
    settings.shares_samples = false;
    const Image picture = studio.picture(kAbove, kSize.x, kSize.y, settings);
    const render::GuidePlanes before = guide_of(studio, nullptr);
    const render::LastPicture last(picture, before, kSize);
    const render::GuidePlanes guide = guide_of(studio, &last);
    double all = 0.0, left = 0.0, brightest = 0.0;
    for (std::size_t i = 0; i < guide.part.size(); ++i) {
        if (guide.part[i] != 0) continue;  // the floor, where it is known what it mirrors
        all += static_cast<double>(picture.pixels[i].y);
        left += static_cast<double>(std::abs(picture.pixels[i].y - guide.clean.pixels[i].y));
        brightest = std::max(brightest, static_cast<double>(guide.clean.pixels[i].y));
    }
    EXPECT_GT(all, 10.0);
    EXPECT_GT(brightest, 1.0) << "the lamp's highlight";
    EXPECT_LT(left, 0.05 * all);
}

// A ceiling that no picture showed: its pixels of the floor say that they do not know, the wall's say that they do.
TEST(GuideGleams, WhatWasOutOfSightIsMarked) {
    constexpr float kCeilingAt = 4.0f;
    Studio studio = polished_room();
    studio.level.lamps.clear();
    const std::uint32_t ceiling =
        studio.add_sheet({0, kCeilingAt, -1}, {6, 0, 0}, {0, 0, 3}, test::matte(glm::vec3(0.5f)));
    studio.open();
    const render::GuidePlanes before = guide_of(studio, nullptr);
    for (const std::uint32_t part : before.part) ASSERT_NE(part, ceiling);
    const Image picture = filled(glm::vec3(1.0f));
    const render::LastPicture last(picture, before, kSize);
    const render::GuidePlanes guide = guide_of(studio, &last);
    int marked = 0;
    for (std::size_t i = 0; i < guide.part.size(); ++i) {
        if (before.part[i] != 0) continue;
        const glm::vec3 way = glm::normalize(guide.position[i] - guide.eye);
        const float up = -way.y / kCeilingAt, at_wall = -way.y / way.z * (kWallAt - guide.position[i].z);
        const glm::vec2 above(guide.position[i].x + way.x / up, guide.position[i].z + way.z / up);
        if (at_wall < 2.05f || std::abs(above.x) > 5.9f || std::abs(above.y + 1.0f) > 2.9f) continue;
        ++marked;
        EXPECT_EQ(guide.part[i], render::GuidePlanes::kUnmirrored) << i;
        EXPECT_EQ(guide.clean.pixels[i], glm::vec3(0.0f)) << i;
    }
    EXPECT_GT(marked, 200);
}

// A board under the lamp takes its highlight from the floor.
TEST(GuideGleams, HighlightsHaveShadows) {
    for (const bool is_hidden : {false, true}) {
        Studio studio = polished_room();
        if (is_hidden)
            studio.add_sheet({0.3f, 1.0f, -1.5f}, {1, 0, 0}, {0, 0, 1}, test::matte(glm::vec3(0.5f)));
        studio.open();
        const render::GuidePlanes before = guide_of(studio, nullptr);
        const Image picture = filled(glm::vec3(0.0f));
        const render::LastPicture last(picture, before, kSize);
        const render::GuidePlanes guide = guide_of(studio, &last);
        // Near the mirror image of the lamp, which the board covers from there.
        const glm::vec3 lamp = studio.level.lamps[0].position;
        const glm::vec3 image(lamp.x, -lamp.y, lamp.z);
        float brightest = 0.0f;
        for (std::size_t i = 0; i < guide.part.size(); ++i) {
            const glm::vec3 way = glm::normalize(guide.position[i] - guide.eye);
            if (before.part[i] == 0 && glm::dot(way, glm::normalize(image - guide.eye)) > 0.99f)
                brightest = std::max(brightest, guide.clean.pixels[i].y);
        }
        if (is_hidden) {
            EXPECT_EQ(brightest, 0.0f);
        } else {
            EXPECT_GT(brightest, 1.0f);
        }
    }
}

// Pixels under a bright highlight are marked, and no others; without lamps a guide shows the rest and marks none.
TEST(GuideGleams, WhatHighlightsOutshineIsMarked) {
    const Studio studio = polished_room();
    const render::GuidePlanes before = guide_of(studio, nullptr);
    const Image picture = filled(glm::vec3(0.0f));
    const render::LastPicture last(picture, before, kSize);
    const render::GuidePlanes with = guide_of(studio, &last);
    const render::GuidePlanes without = guide_of(studio, &last, 1, {.guides_lamps = false});
    int marked = 0;
    for (std::size_t i = 0; i < with.part.size(); ++i) {
        // Nothing but the lamp is bright here, and nothing stands before it.
        const float highlight = with.clean.pixels[i].y - without.clean.pixels[i].y;
        if (before.part[i] != 0) {
            EXPECT_EQ(with.outshone[i], 0) << "not of the floor: " << i;
            EXPECT_EQ(highlight, 0.0f) << i;
            continue;
        }
        EXPECT_EQ(without.clean.pixels[i], glm::vec3(0.0f)) << i;
        EXPECT_EQ(without.outshone[i], 0) << i;
        if (highlight > 0.6f || highlight < 0.4f) {
            EXPECT_EQ(with.outshone[i], highlight > 0.5f ? 1 : 0) << i;
        }
        marked += with.outshone[i];
    }
    EXPECT_GT(marked, 5);
}

TEST(GuideGleams, ThreadsDoNotMatter) {
    const Studio studio = polished_room();
    const render::GuidePlanes before = guide_of(studio, nullptr);
    const Image picture = filled(glm::vec3(0.3f));
    const render::LastPicture last(picture, before, kSize);
    const render::GuidePlanes one = guide_of(studio, &last), three = guide_of(studio, &last, 3);
    EXPECT_EQ(one.part, three.part);
    EXPECT_EQ(one.clean.pixels, three.clean.pixels);
}

}  // namespace
}  // namespace gh
