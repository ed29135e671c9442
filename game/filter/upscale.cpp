#include "filter/upscale.h"

#include "base/contracts.h"
#include "filter/cubic.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace gh::filter {

namespace {

// Which old places make one new place, and how much each counts; weights sum to 1.
struct Taps {
    int first = 0;
    std::vector<float> weights;
};

std::vector<Taps> make_taps(int from, int to) {
    const float scale = static_cast<float>(from) / static_cast<float>(to);
    const float widen = std::max(1.0f, scale);
    std::vector<Taps> all(static_cast<std::size_t>(to));
    for (int i = 0; i < to; ++i) {
        const float centre = (static_cast<float>(i) + 0.5f) * scale - 0.5f;
        Taps& taps = all[static_cast<std::size_t>(i)];
        taps.first = static_cast<int>(std::ceil(centre - 2.0f * widen));
        const int last = static_cast<int>(std::floor(centre + 2.0f * widen));
        float sum = 0.0f;
        for (int k = taps.first; k <= last; ++k) {
            taps.weights.push_back(mitchell(std::abs((static_cast<float>(k) - centre) / widen)));
            sum += taps.weights.back();
        }
        for (float& weight : taps.weights) weight /= sum;
    }
    return all;
}

// One weighted sum, within the values it blends. `step` floats lie between neighbours; the border repeats.
float blended(const float* line, std::size_t step, int count, const Taps& taps) {
    float sum = 0.0f, low = line[static_cast<std::size_t>(std::clamp(taps.first, 0, count - 1)) * step],
          high = low;
    for (std::size_t k = 0; k < taps.weights.size(); ++k) {
        const int at = std::clamp(taps.first + static_cast<int>(k), 0, count - 1);
        const float value = line[static_cast<std::size_t>(at) * step];
        low = std::min(low, value);
        high = std::max(high, value);
        sum += value * taps.weights[k];
    }
    return std::clamp(sum, low, high);
}

struct Floats {
    int width, height, channels;
    std::vector<float> values;
};

std::size_t at(const Floats& f, int x, int y) {
    return (static_cast<std::size_t>(y) * static_cast<std::size_t>(f.width) + static_cast<std::size_t>(x)) *
           static_cast<std::size_t>(f.channels);
}

Floats resampled(const Floats& in, int width, int height, const Jobs& jobs) {
    const std::vector<Taps> across = make_taps(in.width, width), down = make_taps(in.height, height);
    const auto channels = static_cast<std::size_t>(in.channels);
    const auto size = [&](int w, int h) {
        return static_cast<std::size_t>(w) * static_cast<std::size_t>(h) * channels;
    };
    Floats wide{width, in.height, in.channels, std::vector<float>(size(width, in.height))};
    jobs.run(static_cast<std::size_t>(in.height), [&](std::size_t row, int) {
        const int y = static_cast<int>(row);
        for (int x = 0; x < width; ++x) {
            for (std::size_t c = 0; c < channels; ++c) {
                wide.values[at(wide, x, y) + c] = blended(in.values.data() + at(in, 0, y) + c, channels,
                                                          in.width, across[static_cast<std::size_t>(x)]);
            }
        }
    });
    Floats out{width, height, in.channels, std::vector<float>(size(width, height))};
    jobs.run(static_cast<std::size_t>(height), [&](std::size_t row, int) {
        for (int x = 0; x < width; ++x) {
            for (std::size_t c = 0; c < channels; ++c) {
                out.values[at(out, x, static_cast<int>(row)) + c] =
                    blended(wide.values.data() + at(wide, x, 0) + c,
                            channels * static_cast<std::size_t>(width), in.height, down[row]);
            }
        }
    });
    return out;
}

}  // namespace

void resample(const Image& in, const Jobs& jobs, Image& out) {
    EXPECTS(in.width >= 1 && in.height >= 1 && out.width >= 1 && out.height >= 1);
    Floats floats{in.width, in.height, 3, {}};
    floats.values.reserve(in.pixels.size() * 3);
    for (const glm::vec3& pixel : in.pixels) {
        for (std::size_t c = 0; c < 3; ++c)
            floats.values.push_back(std::isfinite(pixel[c]) ? pixel[c] : 0.0f);
    }
    const Floats result = resampled(floats, out.width, out.height, jobs);
    for (std::size_t i = 0; i < out.pixels.size(); ++i) {
        out.pixels[i] = {result.values[i * 3], result.values[i * 3 + 1], result.values[i * 3 + 2]};
    }
}

void resample(const Image8& in, const Jobs& jobs, Image8& out) {
    EXPECTS(in.width >= 1 && in.height >= 1 && out.width >= 1 && out.height >= 1 &&
            in.channels == out.channels);
    const Floats floats{in.width, in.height, in.channels,
                        std::vector<float>(in.bytes.begin(), in.bytes.end())};
    const Floats result = resampled(floats, out.width, out.height, jobs);
    for (std::size_t i = 0; i < out.bytes.size(); ++i) {
        const float half_up = std::clamp(result.values[i], 0.0f, 255.0f) + 0.5f;
        out.bytes[i] = static_cast<std::uint8_t>(half_up);
    }
}

}  // namespace gh::filter
