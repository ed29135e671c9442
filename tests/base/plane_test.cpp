#include "base/plane.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <utility>

namespace gh {
namespace {

// Whoever writes one of several planes that live in one block, slack and all, leaves the others alone.
TEST(Plane, SiblingsOfABlockDoNotTouch) {
    constexpr int kWidth = 37, kHeight = 5;
    Plane a;
    PlaneU32 b;
    Plane3 c;
    fit_together(kWidth, kHeight, a, b, c);
    a.fill(1.0f);
    b.fill(7u);
    c.fill({2.0f, 3.0f, 4.0f});
    for (int y = 0; y < kHeight; ++y) {
        EXPECT_EQ(reinterpret_cast<std::uintptr_t>(a.row(y)) % 64, 0u);
        for (int x = 0; x < kWidth; ++x) {
            EXPECT_EQ(a.at(x, y), 1.0f);
            EXPECT_EQ(b.at(x, y), 7u);
            EXPECT_EQ(c.get(x, y), glm::vec3(2.0f, 3.0f, 4.0f));
        }
    }
}

// A frame's planes are fitted every frame: what they hold stays, but when one of them has another size.
TEST(Plane, FittingTogetherKeepsWhatFits) {
    Plane a, b;
    fit_together(20, 3, a, b);
    a.at(19, 2) = 5.0f;
    fit_together(20, 3, a, b);
    EXPECT_EQ(a.at(19, 2), 5.0f);
    b.resize(21, 3);
    fit_together(20, 3, a, b);
    EXPECT_EQ(a.at(19, 2), 0.0f);
    EXPECT_TRUE(b.has_size(20, 3));
}

// A copy is nobody's sibling, and a plane outlives those it shared its block with.
TEST(Plane, CopiesAndSurvivorsHaveTheirOwn) {
    Plane kept, copy;
    {
        Plane gone;
        fit_together(16, 2, kept, gone);
        kept.fill(1.0f);
        copy = kept;
    }
    kept.at(3, 1) = 2.0f;
    EXPECT_EQ(copy.at(3, 1), 1.0f);
    const Plane moved = std::move(kept);
    EXPECT_EQ(moved.at(3, 1), 2.0f);
    copy = Plane();
    EXPECT_TRUE(copy.empty());
}

// Kernels look at rows two above the first and below the last, and kMargin beside them (under asan this would tell).
TEST(Plane, SlackIsThere) {
    Plane plane(17, 3, 4.0f);
    const auto margin = static_cast<std::ptrdiff_t>(Plane::kMargin);
    EXPECT_EQ(*(plane.row(0) - 2 * plane.stride() - margin), 4.0f);
    EXPECT_EQ(*(plane.row(2) + 3 * plane.stride() + margin - 1), 4.0f);
}

}  // namespace
}  // namespace gh
