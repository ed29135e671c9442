#include "audio/bands.h"

#include "support/random.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

namespace gh::audio {
namespace {

std::vector<float> tone(double hertz, std::size_t frames) {
    std::vector<float> samples(frames);
    for (std::size_t i = 0; i < frames; ++i) {
        samples[i] = static_cast<float>(
            0.5 * std::sin(2.0 * std::numbers::pi * hertz * static_cast<double>(i) / kSampleRate));
    }
    return samples;
}

std::vector<float> noise(std::size_t frames) {
    ::test::Random random(7);
    std::vector<float> samples(frames);
    for (float& x : samples) x = 2.0f * random.unit() - 1.0f;
    return samples;
}

double energy(const std::vector<float>& samples) {
    double sum = 0.0;
    for (const float x : samples) sum += static_cast<double>(x) * static_cast<double>(x);
    return sum;
}

// With all walls gone the player hears the sound as it was made: three roundings to float, no more.
TEST(Bands, LowMiddleAndHighAddUpToTheSound) {
    for (const bool loops : {false, true}) {
        const std::vector<float> whole = noise(4801);
        const Bands bands = split_bands(whole, loops);
        const std::size_t margin = loops ? 0 : kBandMargin;
        ASSERT_EQ(bands[0].size(), whole.size() + 2 * margin);
        for (std::size_t i = 0; i < whole.size(); ++i) {
            const float sum = bands[0][i + margin] + bands[1][i + margin] + bands[2][i + margin];
            ASSERT_NEAR(sum, whole[i], 3e-7f) << "sample " << i;
        }
    }
}

// The margin that a sound grows by holds all of the filters' ringing but -80 dB.
TEST(Bands, NothingIsCutOffAtTheMargins) {
    std::vector<float> click(1000, 0.0f);
    click.front() = 1.0f;
    click.back() = 1.0f;
    for (const std::vector<float>& band : split_bands(click, false)) {
        EXPECT_LT(std::abs(band.front()), 1e-4f);
        EXPECT_LT(std::abs(band.back()), 1e-4f);
    }
}

// |L|^2 of the two passes is 1 / (1 + (f / edge)^4): the tones lie two octaves from an edge, so a neighbour gets
// at most 1 / 257 of the amplitude, -48 dB.
TEST(Bands, EachToneLiesInItsBand) {
    const struct {
        double hertz;
        std::size_t band;
    } cases[] = {{100.0, 0}, {1000.0, 1}, {9600.0, 2}};
    for (const auto& [hertz, band] : cases) {
        const Bands bands = split_bands(tone(hertz, kSampleRate), true);
        const double total = energy(tone(hertz, kSampleRate));
        for (std::size_t b = 0; b < bands.size(); ++b) {
            // The middle band is an octave wide on either side of 1 kHz: a neighbour still has 1 / 17 of its amplitude.
            const double most = b == band         ? 1.0
                                : hertz == 1000.0 ? 1.1 / (17.0 * 17.0)
                                                  : 1.1 / (257.0 * 257.0);
            const double least = b != band ? 0.0 : hertz == 1000.0 ? 0.75 : 0.98;
            EXPECT_LE(energy(bands[b]) / total, most) << hertz << " Hz in band " << b;
            EXPECT_GE(energy(bands[b]) / total, least) << hertz << " Hz in band " << b;
        }
    }
}

// A loop has no beginning: filtering it from another starting point gives the same loop, turned.
TEST(Bands, ALoopHasNoSeam) {
    const std::vector<float> loop = noise(6000);
    std::vector<float> turned(loop.begin() + 2500, loop.end());
    turned.insert(turned.end(), loop.begin(), loop.begin() + 2500);
    const Bands a = split_bands(loop, true);
    const Bands b = split_bands(turned, true);
    for (std::size_t band = 0; band < a.size(); ++band) {
        for (std::size_t i = 0; i < loop.size(); ++i) {
            ASSERT_NEAR(b[band][i], a[band][(i + 2500) % loop.size()], 1e-6f)
                << "band " << band << ", sample " << i;
        }
    }
}

}  // namespace
}  // namespace gh::audio
