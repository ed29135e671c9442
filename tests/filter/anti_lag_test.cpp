// How light that changed is noticed, whether somebody tells or nobody does.
#include "filter/anti_lag.h"

#include "base/random.h"
#include "filter/planes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>

namespace gh {
namespace {

using filter::Plane;
using filter::Plane3;

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInf = std::numeric_limits<float>::infinity();
constexpr int kWidth = 80, kHeight = 48;

TEST(AntiLag, ChangeIsTheShareOfTheLightThatIsNew) {
    const Jobs jobs(1);
    Plane now(8, 1), then(8, 1), change;
    const float pairs[8][3] = {{0, 0, 0},     {1, 1, 0},     {0, 5, 1},    {5, 0, 1},
                               {1, 4, 0.75f}, {4, 1, 0.75f}, {kNan, 1, 0}, {kInf, 1, 0}};
    for (int x = 0; x < 8; ++x) {
        now.at(x, 0) = pairs[x][0];
        then.at(x, 0) = pairs[x][1];
    }
    filter::lamp_change(now, then, jobs, change);
    for (int x = 0; x < 8; ++x) EXPECT_EQ(change.at(x, 0), pairs[x][2]) << x;
}

TEST(AntiLag, GradientsFindALampThatWentOutAndNoChangeInNoise) {
    const Jobs jobs(1);
    filter::Reshaded samples{Plane(30, 20), Plane(30, 20), 3};
    Random random(5);
    for (int y = 0; y < 20; ++y) {
        for (int x = 0; x < 30; ++x) {
            const float light = random.unit();
            samples.then.at(x, y) = light;  // the same sample, shaded twice
            samples.now.at(x, y) = x < 15 ? light : 0.0f;
        }
    }
    Plane change;
    filter::gradients(samples, 90, 60, jobs, change);
    EXPECT_EQ(change.at(10, 30), 0.0f);
    EXPECT_EQ(change.at(80, 30), 1.0f);
}

// What was found in the last picture holds for the pixels that look there now: carried two pixels to the left along with
// them, sharpened, and none for a pixel that was nowhere.
TEST(AntiLag, ChangeIsCarriedAlongWithWhatChanged) {
    Plane then(40, 20);
    for (int y = 0; y < 20; ++y) {
        for (int x = 20; x < 40; ++x) then.at(x, y) = x < 30 ? 0.2f : 0.9f;
    }
    filter::Taps taps;
    taps.fit(40, 20);
    for (int y = 0; y < 20; ++y) {
        for (int x = 0; x < 38; ++x) {
            taps.first.at(x, y) = static_cast<std::int32_t>(y * then.stride()) + x + 1;
            taps.weight[0].at(x, y) = 0.25f;
            taps.weight[1].at(x, y) = 0.75f;
        }
    }
    Plane change;
    filter::carry_change(then, taps, 2.0f, Jobs(2), change);
    for (int y = 0; y < 20; ++y) {
        for (int x = 0; x < 40; ++x) {
            const float wanted = x < 18 || x >= 38 ? 0.0f : x < 28 ? 0.4f : 1.0f;
            ASSERT_FLOAT_EQ(change.at(x, y), wanted) << x << ' ' << y;
        }
    }
}

// Rows nobody's taps can find a change from are passed over: never those from which one of the four does, be it the lower
// right one of a pixel that looks beyond the picture's corner.
TEST(AntiLag, ALoneChangeIsFoundByEachOfTheFourTaps) {
    for (const auto& [u, v] : {std::pair(0, 0), std::pair(39, 0), std::pair(20, 7), std::pair(39, 19)}) {
        Plane then(40, 20);
        then.at(u, v) = 0.25f;
        const auto stride = static_cast<std::int32_t>(then.stride());
        for (std::size_t tap = 0; tap < 4; ++tap) {
            filter::Taps taps;
            taps.fit(40, 20);
            const auto right = static_cast<std::int32_t>(tap % 2), below = static_cast<std::int32_t>(tap / 2);
            taps.first.at(3, 2) = (v - below) * stride + u - right;
            taps.weight[tap].at(3, 2) = 1.0f;
            Plane change;
            filter::carry_change(then, taps, 1.0f, Jobs(1), change);
            EXPECT_EQ(change.at(3, 2), 0.25f) << "at " << u << ' ' << v << " by tap " << tap;
        }
    }
}

TEST(AntiLag, SettlingLeavesSteadyNoiseAloneAndPullsAStaleMeanDown) {
    const Jobs jobs(1);
    const filter::Taps taps = test::taps_of_still_wall(kWidth, kHeight, jobs);
    filter::Accumulated mean, before;
    Plane sums[2];
    for (int n = 1; n <= 32; ++n) {
        std::swap(mean, before);
        filter::accumulate(test::noise(kWidth, kHeight, static_cast<std::uint64_t>(n)), {}, {taps, before},
                           {}, jobs, mean);
        filter::settle({}, jobs, mean, sums);
    }
    EXPECT_NEAR(test::mean_of(mean.light.y), 0.5, 0.005);
    EXPECT_GT(test::mean_of(mean.length), 30.0);
    for (int n = 0; n < 3; ++n) {
        std::swap(mean, before);
        filter::accumulate(Plane3(kWidth, kHeight), {}, {taps, before}, {}, jobs, mean);
        filter::settle({}, jobs, mean, sums);
    }
    EXPECT_LT(test::mean_of(mean.light.y), 0.2) << "without settling it were 0.5 (31/32)^3 = 0.45";
    EXPECT_LT(test::mean_of(mean.length), 15.0);
}

// Where somebody tells of light that changed, a test by chance is asked of what moved by itself alone.
TEST(AntiLag, SettlesNothingButWhatMovedWhereOthersTellOfTheRest) {
    const Jobs jobs(1);
    filter::Movement movement;
    movement.fit(kWidth, kHeight);
    const filter::RowSpan guard{32, 48};
    for (int y = 10; y < 20; ++y) movement.itself[static_cast<std::size_t>(y)] = guard;
    filter::Accumulated all, some;
    for (filter::Accumulated* mean : {&all, &some}) {
        mean->fit(kWidth, kHeight);
        mean->light = Plane3(kWidth, kHeight, glm::vec3(0.5f));
        mean->square = Plane(kWidth, kHeight, 0.25f);
        mean->length = Plane(kWidth, kHeight, 20.0f);
        mean->fast = Plane(kWidth, kHeight, 0.1f);  // it became darker
    }
    Plane sums[2], others[2];
    filter::settle({}, jobs, all, sums);
    filter::run_rows(kHeight, jobs, filter::settle_sum_rows(some, others, &movement));
    filter::run_rows(kHeight, jobs, filter::settle_rows({}, others, some, &movement));
    for (int y = 0; y < kHeight; ++y) {
        for (int x = 0; x < kWidth; ++x) {
            ASSERT_LT(all.light.y.at(x, y), 0.11f);
            const bool moved = y >= 10 && y < 20 && x >= guard.begin && x < guard.end;
            ASSERT_EQ(some.light.y.at(x, y), moved ? all.light.y.at(x, y) : 0.5f) << x << ' ' << y;
            ASSERT_EQ(some.length.at(x, y), moved ? all.length.at(x, y) : 20.0f) << x << ' ' << y;
        }
    }
}

}  // namespace
}  // namespace gh
