#include "audio/bands.h"

#include "base/det_math.h"

#include <algorithm>
#include <cmath>

namespace gh::audio {

namespace {

// Second-order Butterworth low-pass by the bilinear transform, transposed direct form II.
struct LowPass {
    double b0, b1, b2, a1, a2;
};

LowPass butterworth(float edge) {
    const double k = static_cast<double>(det::tan(kPi * edge / static_cast<float>(kSampleRate)));
    const double norm = 1.0 / (1.0 + std::sqrt(2.0) * k + k * k);
    const double b0 = k * k * norm;
    return {b0, 2.0 * b0, b0, 2.0 * (k * k - 1.0) * norm, (1.0 - std::sqrt(2.0) * k + k * k) * norm};
}

// Filters in place. A circle is run round twice: after the first round the filter's memory is that of a
// signal which has gone on for ever.
void run(const LowPass& filter, std::vector<double>& signal, bool is_circle) {
    double s1 = 0.0, s2 = 0.0;
    if (is_circle) {
        for (const double x : signal) {
            const double y = filter.b0 * x + s1;
            s1 = filter.b1 * x - filter.a1 * y + s2;
            s2 = filter.b2 * x - filter.a2 * y;
        }
    }
    for (double& x : signal) {
        const double y = filter.b0 * x + s1;
        s1 = filter.b1 * x - filter.a1 * y + s2;
        s2 = filter.b2 * x - filter.a2 * y;
        x = y;
    }
}

// Forwards, then backwards: the delays cancel and the slope doubles.
std::vector<double> low_passed(std::vector<double> signal, float edge, bool is_circle) {
    const LowPass filter = butterworth(edge);
    for (int pass = 0; pass < 2; ++pass) {
        run(filter, signal, is_circle);
        std::reverse(signal.begin(), signal.end());
    }
    return signal;
}

}  // namespace

Bands split_bands(std::span<const float> samples, bool loops) {
    const std::size_t margin = loops ? 0 : kBandMargin;
    std::vector<double> whole(samples.size() + 2 * margin, 0.0);
    std::transform(samples.begin(), samples.end(), whole.begin() + static_cast<std::ptrdiff_t>(margin),
                   [](float x) { return static_cast<double>(x); });

    const std::vector<double> below_low = low_passed(whole, kLowEdge, loops);
    const std::vector<double> below_high = low_passed(whole, kHighEdge, loops);
    Bands bands;
    for (std::vector<float>& band : bands) band.resize(whole.size());
    for (std::size_t i = 0; i < whole.size(); ++i) {
        bands[0][i] = static_cast<float>(below_low[i]);
        bands[1][i] = static_cast<float>(below_high[i] - below_low[i]);
        bands[2][i] = static_cast<float>(whole[i] - below_high[i]);
    }
    return bands;
}

}  // namespace gh::audio
