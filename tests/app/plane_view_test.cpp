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
        film.part.resize(kWidth, kHeight, 3);
        film.normal.resize(kWidth, kHeight, {0.0f, 0.0f, 1.0f});
        film.albedo.resize(kWidth, kHeight, {1.0f, 0.0f, 0.2140411f});  // sRGB 1, 0, .5
        film.rays.resize(kWidth, kHeight, 4.0f);
        for (int y = 0; y < kHeight; ++y) {
            for (int x = 0; x < kWidth; ++x) {
                const float across = static_cast<float>(x) + 0.5f, below = static_cast<float>(y) + 0.5f;
                film.position.set(x, y, film.eye + film.corner + film.right * across + film.down * below);
            }
        }
        film.previous = film.position;
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
    wall.film.part.at(2, 1) = render::FilmPlanes::kSky;
    for (Plane3* plane : {&wall.film.normal, &wall.film.albedo, &wall.film.position, &wall.film.direct})
        plane->set(3, 1, glm::vec3(nan));
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
