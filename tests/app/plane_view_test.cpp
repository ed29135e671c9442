// The planes F4 shows must show what is in them: each is painted from numbers that are known.
#include "app/plane_view.h"

#include <gtest/gtest.h>

#include <limits>
#include <set>
#include <string>

namespace gh::app {
namespace {

constexpr int kWidth = 5, kHeight = 3;

// A wall two metres off, seen by an eye that has moved half a pixel's width to the right.
struct Wall {
    render::FilmPlanes film;
    filter::Plane variance{kWidth, kHeight, 0.0f};
    filter::Plane history{kWidth, kHeight, 32.0f};
    filter::Pinhole before;

    Wall() {
        film.resize(kWidth, kHeight);
        film.corner = before.corner = {-2.5f, 1.5f, -2.0f};
        film.right = before.right = {1.0f, 0.0f, 0.0f};
        film.down = before.down = {0.0f, -1.0f, 0.0f};
        film.eye = {0.5f, 0.0f, 0.0f};
        for (std::size_t i = 0; i < film.part.size(); ++i) {
            const auto x = static_cast<float>(i % kWidth), y = static_cast<float>(i / kWidth);
            film.part[i] = 3;
            film.position[i] = film.eye + film.corner + film.right * (x + 0.5f) + film.down * (y + 0.5f);
            film.previous[i] = film.position[i];
            film.normal[i] = {0.0f, 0.0f, 1.0f};
            film.albedo[i] = {1.0f, 0.0f, 0.2140411f};  // sRGB 1, 0, .5
            film.rays[i] = 4.0f;
        }
    }
    [[nodiscard]] Image8 painted(PlaneView view) const {
        Image8 out;
        paint_plane(view, {film, variance, history, before}, 1.0f, Jobs(2), out);
        return out;
    }
};

TEST(PlaneView, F4GoesThroughAllOfThemAndBackToThePictureAndEachSaysWhatItIs) {
    std::set<std::string> words;
    PlaneView view = PlaneView::Picture;
    for (int i = 0; i < kPlaneViews; ++i, view = next_of(view)) words.insert(words_of(view));
    EXPECT_EQ(view, PlaneView::Picture);
    EXPECT_EQ(words.size(), static_cast<std::size_t>(kPlaneViews));
}

TEST(PlaneView, ShowsColoursNormalsAndMotionAsTheyAre) {
    const Wall wall;
    const auto expect = [&](PlaneView view, int red, int green, int blue) {
        const Image8 out = wall.painted(view);
        ASSERT_EQ(out.width, kWidth);
        EXPECT_NEAR(out.at(2, 1)[0], red, 1) << words_of(view);
        EXPECT_NEAR(out.at(2, 1)[1], green, 1) << words_of(view);
        EXPECT_NEAR(out.at(2, 1)[2], blue, 1) << words_of(view);
    };
    expect(PlaneView::Albedo, 255, 0, 128);
    expect(PlaneView::Normal, 128, 128, 255);
    // The eye went half a pixel to the right, so the wall goes as far to the left: a sixteenth of full red less.
    expect(PlaneView::Motion, 128 - 8, 128, 128);
    expect(PlaneView::Depth, 170, 170, 170);  // two metres ahead: 4 / (4 + 2)
    expect(PlaneView::History, 255, 255, 255);
    expect(PlaneView::Rays, 26, 38, 204);  // a quarter of the scale
}

TEST(PlaneView, SkyAndWhatIsNoNumberAreBlackInEveryView) {
    Wall wall;
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const std::size_t middle = wall.film.direct.index(2, 1);
    wall.film.part[middle] = render::FilmPlanes::kSky;
    const std::size_t beside = wall.film.direct.index(3, 1);
    wall.film.normal[beside] = wall.film.albedo[beside] = wall.film.position[beside] = glm::vec3(nan);
    wall.film.direct.pixels[beside] = glm::vec3(nan);
    for (const PlaneView view :
         {PlaneView::Albedo, PlaneView::Normal, PlaneView::Depth, PlaneView::Variance}) {
        const Image8 out = wall.painted(view);
        for (int c = 0; c < 3; ++c) EXPECT_EQ(out.at(2, 1)[c], 0) << words_of(view);
    }
    for (const PlaneView view : {PlaneView::Normal, PlaneView::Depth, PlaneView::Direct}) {
        const Image8 out = wall.painted(view);
        for (int c = 0; c < 3; ++c) EXPECT_EQ(out.at(3, 1)[c], 0) << words_of(view);
    }
}

}  // namespace
}  // namespace gh::app
