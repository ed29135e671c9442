// Pictures added up must smooth edges, follow what moves, let go of what has changed, and invent nothing: a player sees
// stairs on every cornice otherwise, or trails behind every guard.
#include "filter/picture_mean.h"

#include "filter/isa.h"
#include "filter/wall.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace gh {
namespace {

using filter::Plane;
using filter::Plane3;
using test::lens_at, test::on_wall, test::Wall;

constexpr int kAcross = 117, kDown = 60;  // not a whole number of vectors

// Slanted bars a few pixels wide.
float bars(const glm::vec2& p) {
    return std::sin(25.0f * p.x + 9.0f * p.y) > 0.0f ? 0.9f : 0.2f;
}

// A wall taken at one place of each pixel, and what a G-buffer says of it.
struct Taken {
    filter::GBuffer surfaces;
    Plane3 picture{kAcross, kDown};
};

Taken take(const Wall& color, const glm::vec2& eye, std::uint32_t number) {
    Taken taken;
    taken.surfaces.lens = lens_at(eye, kAcross, kDown);
    taken.surfaces.fit(kAcross, kDown);
    const glm::vec2 jitter = filter::halton_jitter(number);
    for (int y = 0; y < kDown; ++y) {
        for (int x = 0; x < kAcross; ++x) {
            const glm::vec3 p = on_wall(taken.surfaces.lens, glm::vec2(x, y) + 0.5f + jitter);
            taken.surfaces.part.at(x, y) = 7;
            taken.surfaces.position.set(x, y, p);
            taken.picture.set(x, y, glm::vec3(color(glm::vec2(p)), 0.5f, 0.25f));
        }
    }
    return taken;
}

class Adder {
  public:
    explicit Adder(int threads = 1) : jobs_(threads) {}
    const Plane3& add(const Taken& taken, const Plane& change = {}) {
        filter::RowPasses passes;
        passes.begin(0);
        const auto picture = [&](int y, float* const to[3]) {
            const Plane* const from[3] = {&taken.picture.x, &taken.picture.y, &taken.picture.z};
            for (std::size_t c = 0; c < 3; ++c) std::copy_n(from[c]->row(y), taken.picture.width(), to[c]);
        };
        mean_.add_rows(taken.surfaces, picture, {change}, passes, out_);
        passes.run(taken.surfaces.height(), jobs_);
        mean_.finish(taken.surfaces);
        return out_;
    }

  private:
    Jobs jobs_;
    filter::PictureMean mean_;
    Plane3 out_;
};

// Root of the mean square of what is off the mean of 8x8 places in each pixel.
double error(const Plane3& picture, const Wall& wall, const glm::vec2& eye) {
    const filter::Pinhole lens = lens_at(eye, kAcross, kDown);
    double sum = 0.0;
    for (int y = 2; y < kDown - 2; ++y) {
        for (int x = 2; x < kAcross - 2; ++x) {
            float wanted = 0.0f;
            for (int i = 0; i < 64; ++i) {
                const glm::vec2 in((static_cast<float>(i % 8) + 0.5f) / 8,
                                   (static_cast<float>(i / 8) + 0.5f) / 8);
                wanted += wall(glm::vec2(on_wall(lens, glm::vec2(x, y) + in))) / 64.0f;
            }
            const auto off = static_cast<double>(picture.x.at(x, y) - wanted);
            sum += off * off;
        }
    }
    return std::sqrt(sum / ((kAcross - 4) * (kDown - 4)));
}

TEST(PictureMean, EdgesAreSmoothAfterAFewPictures) {
    Adder adder;
    const double first = error(adder.add(take(bars, {}, 0)), bars, {});
    for (std::uint32_t i = 1; i < 31; ++i) adder.add(take(bars, {}, i));
    EXPECT_LT(error(adder.add(take(bars, {}, 31)), bars, {}), 0.4 * first);
}

TEST(PictureMean, WhatMovesUnderTheCameraIsCarriedAlong) {
    Adder adder;
    const glm::vec2 step(0.0113f, 0.0041f);
    glm::vec2 eye(0.0f);
    for (std::uint32_t i = 0; i < 31; ++i, eye += step) adder.add(take(bars, eye, i));
    const Taken last = take(bars, eye, 31);
    EXPECT_LT(error(adder.add(last), bars, eye), 0.7 * error(last.picture, bars, eye));
}

TEST(PictureMean, AConstantStaysExactlyThat) {
    Adder adder;
    const Wall plain = [](const glm::vec2&) { return 0.64f; };
    Plane3 out;
    for (std::uint32_t i = 0; i < 20; ++i)
        out = adder.add(take(plain, glm::vec2(0.02f * static_cast<float>(i)), i));
    for (int y = 0; y < kDown; ++y) {
        for (int x = 0; x < kAcross; ++x) ASSERT_NEAR(out.x.at(x, y), 0.64f, 1e-6f);
    }
}

// What is around a pixel bounds what is believed of its past: with all of it 0, so is that.
TEST(PictureMean, ALampSwitchedOffIsDarkInTheNextPicture) {
    Adder adder;
    for (std::uint32_t i = 0; i < 20; ++i) adder.add(take(bars, {}, i));
    const Plane3& out = adder.add(take([](const glm::vec2&) { return 0.0f; }, {}, 20));
    for (int y = 0; y < kDown; ++y) {
        for (int x = 0; x < kAcross; ++x) ASSERT_EQ(out.x.at(x, y), 0.0f);
    }
}

// Half of the light is gone: what is around may hold as much as there was, by noise, but the renderer knows.
TEST(PictureMean, WhatIsKnownToBeNewIsShownAsItIs) {
    Adder adder;
    for (std::uint32_t i = 0; i < 20; ++i) adder.add(take(bars, {}, i));
    const Taken now = take([](const glm::vec2& p) { return 0.5f * bars(p); }, {}, 20);
    const Plane3& out = adder.add(now, Plane(kAcross, kDown, 1.0f));
    for (int y = 0; y < kDown; ++y) {
        for (int x = 0; x < kAcross; ++x) ASSERT_NEAR(out.x.at(x, y), now.picture.x.at(x, y), 1e-6f);
    }
}

// The sky has no place, but a direction: an eye that walks sees it stand still.
TEST(PictureMean, TheSkyStandsStillForAnEyeThatWalks) {
    Adder adder;
    const auto sky = [](float walked, std::uint32_t number) {
        Taken taken = take(bars, {}, number);
        taken.surfaces.lens.eye.x = walked;
        taken.surfaces.part.resize(kAcross, kDown, filter::kNoSurface);
        taken.surfaces.position = Plane3(kAcross, kDown, glm::vec3(0.0f));
        return taken;
    };
    for (std::uint32_t i = 0; i < 31; ++i) adder.add(sky(0.1f * static_cast<float>(i), i));
    const Taken last = sky(3.1f, 31);
    EXPECT_LT(error(adder.add(last), bars, {}), 0.4 * error(last.picture, bars, {}));
}

// A dark thing walks over a bright wall by itself: where it was, the wall is there in the very next picture, though the
// thing beside it would let a dark mean pass for right.
TEST(PictureMean, WhatSomethingThatWalkedOnHidIsShownAtOnce) {
    Adder adder;
    for (int frame = 0; frame < 24; ++frame) {
        Taken taken = take([](const glm::vec2&) { return 0.5f; }, {}, 0);
        taken.surfaces.previous = taken.surfaces.position;
        const auto is_thing = [&](int x) { return x >= 30 + frame && x < 50 + frame; };
        for (int y = 0; y < kDown; ++y) {
            for (int x = 0; x < kAcross; ++x) {
                if (!is_thing(x)) continue;
                taken.surfaces.part.at(x, y) = 8;
                taken.picture.set(x, y, glm::vec3(0.01f));
                taken.surfaces.previous.set(x, y,
                                            taken.surfaces.position.get(x, y) - taken.surfaces.lens.right);
            }
        }
        const Plane3& mean = adder.add(taken);
        if (frame < 2) continue;  // the first knows of no past, and so of nothing that moved
        for (int x = 2; x < kAcross - 2; ++x)
            ASSERT_NEAR(mean.y.at(x, 20), is_thing(x) ? 0.01f : 0.5f, 1e-3f) << frame << ' ' << x;
    }
}

TEST(PictureMean, ThreadsInstructionSetsAndPlacesThatAreNoNumbersDoNotMatterAndSizesMayChange) {
    const auto run = [](int threads) {
        Adder adder(threads);
        for (std::uint32_t i = 0; i < 5; ++i) {
            Taken taken = take(bars, glm::vec2(0.01f) * static_cast<float>(i), i);
            taken.surfaces.position.set(5, 6, glm::vec3(std::numeric_limits<float>::quiet_NaN()));
            adder.add(taken);
        }
        Taken small = take(bars, glm::vec2(0.05f), 5);
        Plane3 half(kAcross / 2, kDown / 2);
        filter::GBuffer surfaces;
        surfaces.lens = lens_at(glm::vec2(0.05f), half.width(), half.height());
        surfaces.fit(half.width(), half.height());
        for (int y = 0; y < half.height(); ++y) {
            for (int x = 0; x < half.width(); ++x) {
                surfaces.part.at(x, y) = 7;
                surfaces.position.set(x, y, on_wall(surfaces.lens, glm::vec2(x, y) + 0.5f));
                half.set(x, y, glm::vec3(bars(glm::vec2(surfaces.position.get(x, y)))));
            }
        }
        const Plane3& out = adder.add({std::move(surfaces), std::move(half)});
        std::vector<float> numbers;
        for (int y = 0; y < out.height(); ++y) {
            for (int x = 0; x < out.width(); ++x) numbers.push_back(out.x.at(x, y));
        }
        return numbers;
    };
    const auto one = run(1);
    EXPECT_EQ(one.size(), static_cast<std::size_t>((kAcross / 2) * (kDown / 2)));
    for (const float number : one) EXPECT_TRUE(std::isfinite(number));
    EXPECT_EQ(one, run(3));
    for (const std::string& isa : filter::isa_names()) {
        ASSERT_TRUE(filter::use_isa(isa));
        EXPECT_EQ(one, run(1)) << isa;
    }
    filter::use_isa("");
}

}  // namespace
}  // namespace gh
