// Randomness that decides anything must be the same everywhere, and must not favour anything.
#include "base/random.h"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>

namespace gh {
namespace {

// Chi-square with k - 1 degrees of freedom lies within 5 standard deviations of its mean.
template <std::size_t Bins>
void expect_uniform(const std::array<int, Bins>& counts) {
    double total = 0.0, chi_square = 0.0;
    for (const int count : counts) total += count;
    const double expected = total / static_cast<double>(Bins);
    for (const int count : counts) chi_square += (count - expected) * (count - expected) / expected;
    const double degrees = static_cast<double>(Bins) - 1.0;
    EXPECT_LT(std::abs(chi_square - degrees), 5.0 * std::sqrt(2.0 * degrees));
}

TEST(Random, DrawsAreThoseOfTheFirstDay) {
    Random random(42);
    EXPECT_EQ(random.next_u32(), 3344234869u);
    EXPECT_EQ(random.next_u32(), 1768956483u);
    EXPECT_EQ(hash_u32(1, 2, 3), 1760395401u);
    EXPECT_EQ(hash_u32(0, 0, 0), 1210155558u);
}

TEST(Random, ACopyGoesOnAsTheOriginalWould) {
    Random original(7);
    original.next_u32();
    Random copy = original;
    EXPECT_EQ(copy.state(), original.state());
    for (int i = 0; i < 100; ++i) ASSERT_EQ(copy.next_u32(), original.next_u32());
}

TEST(Random, UnitsFillTheHalfOpenIntervalEvenly) {
    Random random(1);
    std::array<int, 64> counts{};
    for (int i = 0; i < 200'000; ++i) {
        const float u = random.unit();
        ASSERT_GE(u, 0.0f);
        ASSERT_LT(u, 1.0f);
        ++counts[static_cast<std::size_t>(u * 64.0f)];
    }
    expect_uniform(counts);
    EXPECT_LT(unit_from_bits(0xFFFFFFFFu), 1.0f);
}

TEST(Random, CountsBelowABoundAreEvenlyLikely) {
    Random random(2);
    std::array<int, 7> counts{};
    for (int i = 0; i < 100'000; ++i) ++counts[random.below(7)];
    expect_uniform(counts);
    EXPECT_EQ(random.below(1), 0u);
}

TEST(Random, RangesStayWithinTheirEnds) {
    Random random(3);
    for (int i = 0; i < 10'000; ++i) {
        const float x = random.in_range(-3.0f, 5.0f);
        ASSERT_GE(x, -3.0f);
        ASSERT_LE(x, 5.0f);
    }
}

// Neighbouring seeds are what levels and guards will have.
TEST(Random, NeighbouringSeedsAreUnrelated) {
    int equal_bits = 0;
    for (std::uint64_t seed = 0; seed < 1000; ++seed) {
        Random a(seed), b(seed + 1);
        equal_bits += std::popcount(~(a.next_u32() ^ b.next_u32()));
    }
    EXPECT_NEAR(equal_bits, 16'000, 5 * std::sqrt(32'000 * 0.25));
}

// hash_u32 names a pixel, a sample and a dimension: every bit of each must change half of the answer.
TEST(Random, EveryBitOfACounterMovesHalfTheBitsOfItsHash) {
    for (unsigned which = 0; which < 3; ++which) {
        for (unsigned bit = 0; bit < 32; ++bit) {
            int changed = 0;
            for (std::uint32_t i = 0; i < 300; ++i) {
                std::array<std::uint32_t, 3> counters = {i, i * 3, 17};
                const std::uint32_t before = hash_u32(counters[0], counters[1], counters[2]);
                counters[which] ^= 1u << bit;
                changed += std::popcount(before ^ hash_u32(counters[0], counters[1], counters[2]));
            }
            ASSERT_NEAR(changed, 300 * 16, 6 * std::sqrt(300 * 32 * 0.25))
                << "counter " << which << " bit " << bit;
        }
    }
}

}  // namespace
}  // namespace gh
