#include "app/quality.h"

#include <gtest/gtest.h>

namespace gh::app {
namespace {

TEST(Quality, EveryWordOfTheMenuNamesOneAndNothingElseDoes) {
    for (std::size_t i = 0; i < present::kQualityWords.size(); ++i) {
        const auto name = quality_named(present::kQualityWords[i]);
        ASSERT_TRUE(name) << present::kQualityWords[i];
        EXPECT_EQ(static_cast<std::size_t>(*name), i);
    }
    for (const char* word : {"", "Low", "best", "medium "}) EXPECT_FALSE(quality_named(word)) << word;
}

// A better one never asks for fewer pixels, coarser textures or coarser light.
TEST(Quality, EachIsAtLeastAsFineAsTheOneBefore) {
    for (int i = 1; i < static_cast<int>(present::kQualityWords.size()); ++i) {
        const Quality worse = quality_of(static_cast<present::QualityName>(i - 1));
        const Quality better = quality_of(static_cast<present::QualityName>(i));
        EXPECT_GT(better.fewest_shown, worse.fewest_shown);
        EXPECT_GE(better.most_lit, worse.most_lit);
        EXPECT_LE(better.fewest_shown, better.most_lit);
        EXPECT_GE(better.whitted.texture_taps, worse.whitted.texture_taps);
        EXPECT_GE(better.path.texture_taps, worse.path.texture_taps);
        EXPECT_GE(better.path.max_scatters, worse.path.max_scatters);
        if (better.whitted.is_adaptive) {
            EXPECT_LE(better.whitted.contrast, worse.whitted.contrast);
        }
    }
}

}  // namespace
}  // namespace gh::app
