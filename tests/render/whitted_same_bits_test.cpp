// A picture is a function of scene, camera, settings and frame number, and of nothing else.
#include "studio.h"
#include "support/isas.h"

#include <gtest/gtest.h>

namespace gh {
namespace {

using test::Studio;

// A bit of everything: soft and hard shadows, a mirror, glass, gloss, ambient light.
void furnish(Studio& studio, float scale, const glm::vec3& offset) {
    const auto at = [&](float x, float y, float z) { return glm::vec3(x, y, z) * scale; };
    studio.add_box(at(-3, 0, -3), at(3, 3, 3), test::matte({0.7f, 0.6f, 0.5f}), true);
    world::Material polished = test::matte({0.4f, 0.2f, 0.1f});
    polished.ior = 1.5f;
    polished.roughness = 0.15f;
    studio.add_box(at(-1.5f, 0.01f, -1.5f), at(-0.5f, 0.8f, -0.5f), polished);
    studio.add_ball(at(1, 0.6f, -1), 0.5f * scale, 16, test::clear_glass(1.5f));
    studio.add_sheet(at(0, 1.5f, -2.9f), at(1, 0, 0), at(0, 1, 0), test::mirror(0.9f));
    studio.add_lamp({.name = {},
                     .shape = world::LampShape::Sphere,
                     .position = at(0.5f, 2.5f, 0) + offset,
                     .intensity = {30, 25, 20},
                     .radius = 0.15f * scale});
    studio.add_lamp({.name = {},
                     .shape = world::LampShape::Point,
                     .position = at(-2, 2, 1) + offset,
                     .intensity = glm::vec3(1, 2, 3) * (scale * scale)});
    for (world::Part& part : studio.level.parts) part.mover_from_part[3] = offset;
}

render::Camera view(float scale, const glm::vec3& offset) {
    return {.position = glm::vec3(0.5f, 1.5f, 2.75f) * scale + offset,
            .yaw = 0.1f,
            .pitch = -0.15f,
            .fov_y = 1.0f};
}

TEST(WhittedSameBits, OneTwoAndEightThreadsMakeOnePicture) {
    std::vector<Image> pictures;
    for (const int threads : {1, 2, 8}) {
        const Jobs jobs(threads);
        Studio studio;
        furnish(studio, 1.0f, glm::vec3(0.0f));
        studio.open({.spacing = 1.5f, .rays = 24}, jobs);
        for (const bool is_adaptive : {false, true}) {
            render::WhittedSettings settings;
            settings.is_adaptive = is_adaptive;
            pictures.push_back(studio.picture(view(1.0f, glm::vec3(0.0f)), 96, 64, settings, 3, jobs));
        }
    }
    for (std::size_t i = 2; i < pictures.size(); ++i) EXPECT_EQ(pictures[i].pixels, pictures[i % 2].pixels) << i;
    EXPECT_NE(pictures[0].pixels, pictures[1].pixels);
}

TEST(WhittedSameBits, EveryIsaMakesOnePicture) {
    std::vector<Image> pictures;
    for (const rc::Isa isa : ::test::supported_isas()) {
        const ::test::IsaScope scope(isa);
        Studio studio;
        furnish(studio, 1.0f, glm::vec3(0.0f));
        studio.open({.spacing = 1.5f, .rays = 24});
        pictures.push_back(studio.picture(view(1.0f, glm::vec3(0.0f)), 96, 64, {}));
        EXPECT_EQ(pictures[0].pixels, pictures.back().pixels) << rc::isa_name(isa);
    }
}

// Nothing in the renderer is a length: a museum of a micrometre and one of a thousand kilometres look the same.
TEST(WhittedSameBits, AScaledSceneGivesTheSamePicture) {
    const auto picture = [](float scale) {
        Studio studio;
        furnish(studio, scale, glm::vec3(0.0f));
        studio.open({.bakes_ambient = false, .spacing = 1.5f * scale});
        return studio.picture(view(scale, glm::vec3(0.0f)), 64, 48, {});
    };
    const Image plain = picture(1.0f);
    EXPECT_EQ(plain.pixels, picture(0x1p20f).pixels);
    EXPECT_EQ(plain.pixels, picture(0x1p-20f).pixels);
}

// What is seen is found in each part's own frame, so distance from the world's origin moves no outline.
TEST(WhittedSameBits, GlowingThingsFarAwayLookAsTheyDoHere) {
    const auto picture = [](const glm::vec3& offset) {
        Studio studio;
        studio.add_ball({0.5f, 0, -4}, 1.0f, 24, test::glowing(2.0f));
        studio.add_box({-2, -1, -6}, {-0.5f, 1, -5}, test::glowing(3.0f));
        for (world::Part& part : studio.level.parts) part.mover_from_part[3] = offset;
        studio.open();
        return studio.picture({.position = offset, .fov_y = 0.8f}, 96, 64, test::exact());
    };
    const Image here = picture(glm::vec3(0.0f));
    for (const float metres : {1e3f, 1e5f, 1e6f}) {
        EXPECT_EQ(here.pixels, picture({metres, 0.0f, -metres}).pixels) << metres << " m away";
    }
}

TEST(WhittedSameBits, ALitRoomAKilometreAwayLooksAsItDoesHere) {
    const auto picture = [](const glm::vec3& offset) {
        Studio studio;
        furnish(studio, 1.0f, offset);
        studio.open();
        return studio.picture(view(1.0f, offset), 64, 48, test::exact());
    };
    const Image here = picture(glm::vec3(0.0f)), there = picture({1024.0f, 0.0f, -1024.0f});
    int different = 0;
    for (std::size_t i = 0; i < here.pixels.size(); ++i) {
        different +=
            glm::length(here.pixels[i] - there.pixels[i]) > 2e-3f * (1.0f + glm::length(here.pixels[i])) ? 1
                                                                                                         : 0;
    }
    EXPECT_LE(different, 64) << "only what a rounded ray may flip at an outline or in curved glass";
}

}  // namespace
}  // namespace gh
