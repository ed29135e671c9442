// audio/bands.h - a sound cut into low (below 500 Hz), middle and high (above 2 kHz) once, at load.
//
// A wall is then three gains: OpenAL's filters are not interpolated and click when they move, its gains are.
// low + mid + high is the sound again to the last bit or two of a float, because the bands are made by
// subtraction: low = L500 x, high = x - L2000 x, mid = x - low - high, and L is a Butterworth low-pass run
// forwards and backwards, so it delays nothing and its complement is as steep as itself (24 dB an octave).
//
// Cost      about 10 ns a sample. Threads pure. Same bits no libm.
#pragma once

#include "world/surface.h"

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace gh::audio {

inline constexpr int kSampleRate = 48'000;
inline constexpr float kLowEdge = 500.0f;        // Hz: half the amplitude of either neighbour
inline constexpr float kHighEdge = 2000.0f;      // Hz
inline constexpr std::size_t kBandMargin = 256;  // samples of silence put before and after a sound that ends

using Bands = std::array<std::vector<float>, world::kBands>;

// A sound that loops is filtered as a circle and keeps its length; one that ends grows by kBandMargin on
// either side, where the filters ring out.
[[nodiscard]] Bands split_bands(std::span<const float> samples, bool loops);

}  // namespace gh::audio
