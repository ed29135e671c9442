// Which pixels of a guide are lit in which frame.
#include "filter/jitter.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <set>
#include <utility>

namespace gh {
namespace {

// Every pixel of a block has its turn before one has another, and a lit pixel looks where its pixel of the guide does.
TEST(Jitter, EveryPixelIsLitInItsTurn) {
    for (int step = 1; step <= 4; ++step) {
        std::set<std::pair<int, int>> lit;
        for (std::uint32_t i = 100; i < 100 + static_cast<std::uint32_t>(step * step); ++i) {
            const glm::ivec2 offset = filter::lit_offset(i, step);
            lit.emplace(offset.x, offset.y);
            const glm::vec2 jitter = filter::halton_jitter(i);
            const glm::vec2 in_small =
                (filter::small_jitter(jitter, offset, step) + 0.5f) * static_cast<float>(step);
            EXPECT_LT(glm::distance(in_small, glm::vec2(offset) + 0.5f + jitter), 1e-5f);
        }
        EXPECT_EQ(lit.size(), static_cast<std::size_t>(step * step));
    }
}

}  // namespace
}  // namespace gh
