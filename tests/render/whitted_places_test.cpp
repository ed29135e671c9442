// Where in a pixel its samples lie: edges of a film stand still, and the mean of many pictures is as smooth as it is deep.
#include "studio.h"

#include <gtest/gtest.h>

#include <cmath>

namespace gh {
namespace {

using test::exact;
using test::narrow;
using test::Studio;

// A bright sheet that ends at .3 of the one pixel.
constexpr float kCovered = 0.3f;

Studio half_hidden() {
    Studio studio;
    const render::Camera camera = narrow(glm::vec3(0.0f));
    const float side = 2.0f * std::tan(0.5f * camera.fov_y);  // of the pixel, a metre away
    const float edge = (kCovered - 0.5f) * side;
    studio.add_sheet({edge - 1.0f, 0.0f, -1.0f}, {1.0f, 0, 0}, {0, 1.0f, 0}, test::glowing(1.0f));
    studio.open();
    return studio;
}

render::WhittedSettings sixteen(std::uint32_t places) {
    render::WhittedSettings settings = exact();
    settings.samples_per_pixel = 16;
    settings.places = places;
    return settings;
}

TEST(WhittedPlaces, EdgesOfAFilmStandStill) {
    const Studio studio = half_hidden();
    const Image first = studio.picture(narrow(glm::vec3(0.0f)), 1, 1, sixteen(0), 0);
    for (std::uint32_t frame = 1; frame < 16; ++frame)
        EXPECT_EQ(studio.picture(narrow(glm::vec3(0.0f)), 1, 1, sixteen(0), frame).pixels, first.pixels);
}

// 64 pictures of 16 samples, each evenly over the pixel: a picture is wrong by a sixteenth at most, their mean by about
// 1/16 / sqrt(12 * 64) = .0023. Through the same places all of them would have 4 or 5 of 16.
TEST(WhittedPlaces, TheMeanOfPicturesThroughOthersKnowsWhereAnEdgeIs) {
    const Studio studio = half_hidden();
    double sum = 0.0;
    constexpr std::uint32_t kPictures = 64;
    for (std::uint32_t i = 0; i < kPictures; ++i) {
        const Image one = studio.picture(narrow(glm::vec3(0.0f)), 1, 1, sixteen(i), 0);
        const float sixteenths = 16.0f * one.pixels[0].x;
        EXPECT_NEAR(sixteenths, std::round(sixteenths), 1e-4f);
        sum += static_cast<double>(one.pixels[0].x);
    }
    EXPECT_NEAR(sum / kPictures, static_cast<double>(kCovered), 4 * 0.0023);
}

}  // namespace
}  // namespace gh
