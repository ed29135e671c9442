// A picture in more pixels than it was made in.
#include "filter/enlarge.h"

#include "base/random.h"
#include "filter/cubic.h"
#include "filter/isa.h"
#include "filter/planes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace gh {
namespace {

using filter::Plane3;

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

TEST(Enlarge, KeepsAConstantAtEveryRatioAndOvershootsNowhere) {
    const Jobs jobs(2);
    for (const auto& [width, height] :
         {std::pair(26, 14), std::pair(13, 7), std::pair(100, 31), std::pair(17, 8)}) {
        Plane3 out(width, height);
        filter::enlarge(Plane3(13, 7, {0.25f, 1.5f, 30.0f}), jobs, out);
        EXPECT_LT(test::largest_difference(out, Plane3(width, height, {0.25f, 1.5f, 30.0f})), 1e-4f);
    }
    Plane3 step(16, 16);
    for (int y = 0; y < 16; ++y) {
        for (int x = 8; x < 16; ++x) step.set(x, y, glm::vec3(1.0f));
    }
    step.set(12, 4, glm::vec3(kNan));
    Plane3 out(41, 37);
    filter::enlarge(step, jobs, out);
    for (int y = 0; y < 37; ++y) {
        for (int x = 0; x < 41; ++x) ASSERT_TRUE(out.x.at(x, y) >= 0.0f && out.x.at(x, y) <= 1.0f);
    }
    EXPECT_EQ(out.x.at(40, 36), 1.0f);
    EXPECT_EQ(out.x.at(0, 0), 0.0f);
}

// A ramp is what linear interpolation gets right; the cubic too, but at the borders it has less to go on.
TEST(Enlarge, PutsARampWhereItBelongs) {
    Plane3 ramp(32, 8);
    for (int y = 0; y < 8; ++y) {
        for (int x = 0; x < 32; ++x) ramp.set(x, y, glm::vec3(static_cast<float>(x)));
    }
    Plane3 out(77, 19);
    filter::enlarge(ramp, Jobs(1), out);
    for (int x = 8; x < 69; ++x) {
        EXPECT_NEAR(out.x.at(x, 9), (static_cast<float>(x) + 0.5f) * 32.0f / 77.0f - 0.5f, 0.02f) << x;
    }
}

// Mitchell and Netravali's cubic pixel by pixel, within what it blends; the border repeats, and what is no number is black.
TEST(Enlarge, TwiceTheSizeIsTheCubicAtEveryPixelOnEveryInstructionSet) {
    const int width = 37, height = 9;
    Plane3 in(width, height);
    Random random(3);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x)
            in.set(x, y, {random.unit(), x % 7 == 3 ? 40.0f : 0.1f, y % 3 == 0 ? kNan : 2.0f});
    }
    const auto blended = [](const float* values, int odd) {
        const float t = odd != 0 ? 0.25f : 0.75f;
        const float weights[4] = {filter::mitchell(1.0f + t), filter::mitchell(t), filter::mitchell(1.0f - t),
                                  filter::mitchell(2.0f - t)};
        float sum = 0.0f;
        for (int k = 0; k < 4; ++k) sum += weights[k] * values[k];
        return std::clamp(sum, *std::min_element(values, values + 4), *std::max_element(values, values + 4));
    };
    const auto wanted = [&](const filter::Plane& plane, int x, int y) {
        float lines[4];
        for (int i = 0; i < 4; ++i) {
            float values[4];
            for (int j = 0; j < 4; ++j) {  // down first, column by column
                const float v = plane.at(std::clamp((x + 1) / 2 - 2 + i, 0, width - 1),
                                         std::clamp((y + 1) / 2 - 2 + j, 0, height - 1));
                values[j] = std::isfinite(v) ? v : 0.0f;
            }
            lines[i] = blended(values, y % 2);
        }
        return blended(lines, x % 2);
    };
    for (const std::string& isa : filter::isa_names()) {
        ASSERT_TRUE(filter::use_isa(isa));
        Plane3 out(2 * width, 2 * height);
        filter::enlarge(in, Jobs(3), out);
        for (int y = 0; y < 2 * height; ++y) {
            for (int x = 0; x < 2 * width; ++x) {
                ASSERT_NEAR(out.x.at(x, y), wanted(in.x, x, y), 1e-5f) << isa << ' ' << x << ' ' << y;
                ASSERT_NEAR(out.y.at(x, y), wanted(in.y, x, y), 1e-4f) << isa << ' ' << x << ' ' << y;
                ASSERT_NEAR(out.z.at(x, y), wanted(in.z, x, y), 1e-5f) << isa << ' ' << x << ' ' << y;
            }
        }
    }
    filter::use_isa("");
}

TEST(Enlarge, WithTheLargeSurfacesKnownAnEdgeIsAsSharpAsTheyAre) {
    const Jobs jobs(1);
    // The step lies in the middle of a small pixel column: 21 is odd.
    const int width = 21, height = 12;
    filter::GBuffer small = test::stepped_wall(width, height),
                    large = test::stepped_wall(2 * width, 2 * height);
    const filter::Guides small_guides = test::guides_of(small), large_guides = test::guides_of(large);
    Plane3 in(width, height), wanted(2 * width, 2 * height);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) in.set(x, y, glm::vec3(small.part.at(x, y) == 1 ? 1.0f : 0.0f));
    }
    for (int y = 0; y < 2 * height; ++y) {
        for (int x = 0; x < 2 * width; ++x)
            wanted.set(x, y, glm::vec3(large.part.at(x, y) == 1 ? 1.0f : 0.0f));
    }
    Plane3 joint, plain(2 * width, 2 * height);
    filter::joint_enlarge(in, small_guides, large_guides, jobs, joint);
    filter::enlarge(in, jobs, plain);
    EXPECT_LT(test::largest_difference(joint, wanted), 1e-3f);
    EXPECT_GT(test::largest_difference(plain, wanted), 0.4f) << "the test's edge is no challenge";
}

}  // namespace
}  // namespace gh
