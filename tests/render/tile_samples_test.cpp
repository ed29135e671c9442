// The numbers of a tile's pixels, worked out together, are those of each pixel's own sequence.
#include "render/tile_samples.h"

#include <gtest/gtest.h>

namespace gh {
namespace {

using render::SampleKind;
using render::SampleSequence;
using render::TileSamples;

// Also at a picture's edge, in a block whose corner is not the origin, for counts that are no power of four, and for more
// purposes than are remembered at a time.
TEST(TileSamples, AreThoseOfEveryPixel) {
    constexpr int kColumns = 16, kRows = 11;
    TileSamples samples;
    int differences = 0;
    for (const SampleKind kind :
         {SampleKind::Iid, SampleKind::Jittered, SampleKind::Sobol, SampleKind::BlueNoise}) {
        for (const std::uint32_t count : {1u, 2u, 7u, 16u}) {
            const int x = 16 * static_cast<int>(count), y = 272;
            const render::SampleSettings settings{kind, count, 5};
            samples.begin(settings, x, y, kColumns, kRows, 3);
            for (std::uint32_t dimension = 0; dimension < 100; dimension += 7) {
                for (int pixel = 0; pixel < kColumns * kRows; pixel += 3) {
                    const SampleSequence own(settings, x + pixel % kColumns, y + pixel / kColumns, 3);
                    const auto i = static_cast<std::size_t>(pixel);
                    const std::uint32_t sample = dimension % count;
                    differences += samples.one(i, sample, dimension) != own.one(sample, dimension);
                    differences += samples.two(i, sample, dimension) != own.two(sample, dimension);
                }
            }
        }
    }
    EXPECT_EQ(differences, 0);
}

// Two tiles one after the other have nothing in common, and a purpose asked again is still the same.
TEST(TileSamples, ForgetTheTileBefore) {
    const render::SampleSettings settings{SampleKind::BlueNoise, 1, 5};
    TileSamples samples;
    for (const int x : {0, 16, 256, 0}) {
        samples.begin(settings, x, 32, 16, 16, 1);
        for (const std::uint32_t dimension : {3u, 35u, 67u, 3u}) {
            const SampleSequence own(settings, x + 5, 34, 1);
            EXPECT_EQ(samples.one(2 * 16 + 5, 0, dimension), own.one(0, dimension)) << x;
            EXPECT_EQ(samples.two(2 * 16 + 5, 0, dimension), own.two(0, dimension)) << x;
        }
    }
}

}  // namespace
}  // namespace gh
