// Passes that run side by side, row by row: a row that is asked for too early is noise of the last frame in the picture.
#include "filter/rows.h"

#include <gtest/gtest.h>

#include <atomic>
#include <vector>

namespace gh {
namespace {

// Two arrays by turns, as the a-trous levels have them. Every row must hold what the pass before has left when it is
// read, and no pass may write over what somebody still has to read.
void run_and_check(int height, const std::vector<int>& reach, int threads) {
    const Jobs jobs(threads);
    std::vector<std::atomic<int>> done[2];
    for (auto& rows : done) {
        rows = std::vector<std::atomic<int>>(static_cast<std::size_t>(height));
        for (auto& row : rows) row = -1;
    }
    std::atomic<int> wrong = 0, calls = 0;
    filter::run_passes(height, reach, jobs, [&](int pass, int y) {
        ++calls;
        const int r = reach[static_cast<std::size_t>(pass)];
        for (int at = std::max(0, y - r); pass > 0 && at <= std::min(height - 1, y + r); ++at)
            wrong += done[(pass + 1) % 2][static_cast<std::size_t>(at)] != pass - 1;
        done[pass % 2][static_cast<std::size_t>(y)] = pass;
    });
    EXPECT_EQ(wrong, 0) << height << " rows, " << reach.size() << " passes, " << threads << " threads";
    EXPECT_EQ(calls, height * static_cast<int>(reach.size()));
}

TEST(Rows, EveryPassFindsWhatTheOneBeforeHasLeftAtAnyHeight) {
    for (const int threads : {1, 3, 20}) {
        for (const int height : {1, 2, 7, 45, 90, 181, 360, 1000}) {
            run_and_check(height, {0}, threads);
            run_and_check(height, {0, 2}, threads);
            run_and_check(height, {0, 2, 4}, threads);
            run_and_check(height, {0, 2, 4, 8, 16}, threads);
            run_and_check(height, {0, 4, 8, 16, 32}, threads);
            run_and_check(height, {0, 1, 2, 2, 4, 8}, threads);
        }
    }
}

}  // namespace
}  // namespace gh
