#include "base/jobs.h"

#include "base/random.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cstdint>
#include <vector>

namespace gh {
namespace {

TEST(Jobs, EveryItemIsDoneOnceWhateverTheNumberOfThreads) {
    for (const int threads : {1, 2, 8}) {
        const Jobs jobs(threads);
        EXPECT_EQ(jobs.threads(), threads);
        std::vector<std::uint32_t> slots(10'000, 0);
        jobs.run(slots.size(),
                 [&](std::size_t i, int) { slots[i] += hash_u32(static_cast<std::uint32_t>(i)); });
        for (std::size_t i = 0; i < slots.size(); ++i) {
            ASSERT_EQ(slots[i], hash_u32(static_cast<std::uint32_t>(i))) << i << " with " << threads;
        }
    }
}

TEST(Jobs, NoTwoItemsShareAWorkerAtTheSameTime) {
    const Jobs jobs(4);
    std::vector<std::atomic<int>> inside(4);
    std::atomic<int> clashes = 0;
    jobs.run(2000, [&](std::size_t, int worker) {
        ASSERT_GE(worker, 0);
        ASSERT_LT(worker, 4);
        auto& count = inside[static_cast<std::size_t>(worker)];
        clashes += count.fetch_add(1) != 0;
        for (int spin = 0; spin < 200; ++spin) (void)count.load();  // stays inside for a while
        count.fetch_sub(1);
    });
    EXPECT_EQ(clashes, 0);
}

TEST(Jobs, ItemsMayRunJobsOfTheirOwn) {
    const Jobs jobs(2);
    std::vector<std::uint32_t> sums(20, 0);
    jobs.run(sums.size(), [&](std::size_t i, int) {
        std::vector<std::uint32_t> parts(50, 0);
        jobs.run(parts.size(), [&](std::size_t j, int) { parts[j] = static_cast<std::uint32_t>(i * j); });
        for (const std::uint32_t part : parts) sums[i] += part;
    });
    for (std::size_t i = 0; i < sums.size(); ++i) EXPECT_EQ(sums[i], i * (49 * 50 / 2));
}

TEST(Jobs, NothingToDoIsDoneAtOnceAndZeroMeansAllCores) {
    const Jobs jobs;
    EXPECT_GE(jobs.threads(), 1);
    jobs.run(0, [](std::size_t, int) { FAIL(); });
    bool was_called = false;
    jobs.run_in([&] { was_called = true; });
    EXPECT_TRUE(was_called);
}

}  // namespace
}  // namespace gh
