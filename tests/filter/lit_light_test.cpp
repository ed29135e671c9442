// A highlight that lit pixels know by chance, and a guide exactly: it must neither glow beside itself nor leave a dark place
// where it was, and the light on its floor is that beside it.
#include "filter/lit_light.h"

#include "filter/wall.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace gh {
namespace {

using test::kHeight, test::kStep, test::kWidth, test::shoot, test::Shot;

constexpr float kReach = 0.05f;

float grey(const glm::vec2&) {
    return 0.5f;
}
float even(const glm::vec2&) {
    return 1.0f;
}

// Lays a highlight of 20 round the place into what the guide knows; lit pixels in it have two fifths or nine fifths of it.
std::vector<std::uint8_t> add_highlight(Shot& shot, const glm::vec2& middle, float radius) {
    std::vector<std::uint8_t> outshone(shot.part.size(), 0);
    for (std::size_t i = 0; i < outshone.size(); ++i) {
        if (glm::distance(glm::vec2(shot.position[i]), middle) > radius) continue;
        outshone[i] = 1;
        shot.clean[i] = glm::vec3(20.0f);
    }
    shot.light(even);
    for (int v = 0; v < kHeight; ++v) {
        for (int u = 0; u < kWidth; ++u)
            if (outshone[shot.place(u, v)] != 0)
                shot.radiance.at(u, v) += glm::vec3((u + v) % 2 == 0 ? -12.0f : 16.0f);
    }
    return outshone;
}

filter::GuidedFrame frame_of(const Shot& shot, const std::vector<std::uint8_t>& outshone) {
    filter::GuidedFrame frame = shot.frame();
    frame.guide.outshone = outshone;
    return frame;
}

// The eye goes by, the wall stays, the highlight goes with the eye. A lit pixel is .05 wide.
TEST(LitLight, HighlightsThatMoveLeaveNothingBehind) {
    for (const float radius : {0.06f, 0.2f}) {
        filter::TemporalUpscaler upscaler;
        Image out;
        for (std::uint32_t i = 0; i < 12; ++i) {
            const glm::vec2 eye(0.03f * static_cast<float>(i), 0.0f);
            Shot shot = shoot(grey, even, eye, i);
            const auto outshone = add_highlight(shot, eye + glm::vec2(0.1f, 0.05f), radius);
            upscaler.add(frame_of(shot, outshone), Jobs(1), out);
            // Pictures are smoothed over three pixels: only the highlight's rim is neither.
            for (int y = 0; y < out.height; ++y) {
                for (int x = 0; x < out.width; ++x) {
                    const glm::vec3& pixel = out.at(x, y);
                    ASSERT_GE(pixel.x, 0.5f - 1e-4f) << "picture " << i << ", " << x << " " << y;
                    const float off =
                        glm::distance(glm::vec2(test::on_wall(shot.seen.lens, glm::vec2(x, y) + 0.5f)),
                                      eye + glm::vec2(0.1f, 0.05f));
                    if (off > radius + 0.06f) {
                        ASSERT_NEAR(pixel.x, 0.5f, 1e-4f) << "picture " << i;
                    }
                    if (off < radius - 0.04f) {
                        ASSERT_NEAR(pixel.x, 20.5f, 1e-3f) << "picture " << i;
                    }
                }
            }
        }
    }
}

// Where there is nothing but highlight, what is left is its own, not less than none.
TEST(LitLight, WithoutAnyBesideItIsNotLessThanNone) {
    Shot shot = shoot(grey, even, glm::vec2(0.0f), 0);
    const auto outshone = add_highlight(shot, glm::vec2(0.0f), 10.0f);
    const filter::GuidedFrame frame = frame_of(shot, outshone);
    EXPECT_EQ(filter::light_of_lit(frame, {20, 14}, kReach), glm::vec3(0.0f));
    EXPECT_NEAR(filter::light_of_lit(frame, {20, 15}, kReach).x, 33.0f, 1e-4f);
}

// Neither another thing nor another plane lends it light.
TEST(LitLight, OnlyItsOwnSurfaceLendsLight) {
    const glm::ivec2 here(20, 15);
    Shot shot = shoot(grey, even, glm::vec2(0.0f), 0);
    std::vector<std::uint8_t> outshone(shot.part.size(), 0);
    outshone[shot.place(here.x, here.y)] = 1;
    shot.radiance.at(here.x, here.y) = glm::vec3(7.0f);
    for (int v = here.y - 1; v <= here.y + 1; ++v) {
        for (int u = here.x - 1; u <= here.x + 1; ++u) {
            if (glm::ivec2(u, v) == here) continue;
            shot.radiance.at(u, v) = glm::vec3(100.0f);
            if (v < here.y) shot.part[shot.place(u, v)] = 8;
            if (v >= here.y) shot.position[shot.place(u, v)].z -= 0.5f;
        }
    }
    EXPECT_NEAR(filter::light_of_lit(frame_of(shot, outshone), here, kReach).x, 1.0f, 1e-5f) << "two away";
    shot.position[shot.place(here.x + 1, here.y)].z += 0.5f;
    EXPECT_NEAR(filter::light_of_lit(frame_of(shot, outshone), here, kReach).x, 200.0f, 1e-3f);
}

}  // namespace
}  // namespace gh
