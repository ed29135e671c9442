#include "filter/tone_map.h"

#include "base/det_math.h"
#include "filter/tone_map_kernel.h"

#include <algorithm>
#include <cmath>

namespace gh::filter {

namespace {

// The eye follows the light half way only (in stops): a dark room is to look dark, and a bright one bright.
constexpr float kFollows = 0.5f;
constexpr float kExposureOfOne = 0.63f;  // where the logarithmic mean of the radiance is 1
constexpr float kLeastExposure = 0.02f, kMostExposure = 48.0f;  // a moonlit gallery needs 34
constexpr float kDarkest = 1e-4f;                  // radiance below which darkness is just darkness
constexpr float kToBright = 0.3f, kToDark = 2.0f;  // seconds to two thirds of the way

float luminance(const glm::vec3& c) {
    return 0.2126f * c.x + 0.7152f * c.y + 0.0722f * c.z;
}

// An 8x8 Bayer matrix in [0, 1): the bits of x ^ y and y interleaved, lowest first.
float threshold(std::uint32_t x, std::uint32_t y, std::uint32_t frame) {
    std::uint32_t rank = 0;
    for (std::uint32_t bit = 0; bit < 3; ++bit) {
        rank = (rank << 2) | ((((x ^ y) >> bit) & 1u) << 1) | ((y >> bit) & 1u);
    }
    const float turned =
        (static_cast<float>(rank) + 0.5f) / 64.0f + static_cast<float>(frame % 64) * 0.61803398875f;
    return turned - std::floor(turned);
}

}  // namespace

float film_curve(float x) {
    if (!(x > kKnee)) return x > 0.0f ? x : 0.0f;
    const float over = (x - kKnee) / (1.0f - kKnee);
    return kKnee + (1.0f - kKnee) * (over / (1.0f + over));
}

float metered_exposure(const Image& picture) {
    const int step = picture.width * picture.height > 64 * 64 ? 4 : 1;
    double sum = 0.0;
    int count = 0;
    for (int y = 0; y < picture.height; y += step) {
        for (int x = 0; x < picture.width; x += step) {
            const float light = luminance(picture.at(x, y));
            if (!(light < 1e30f)) continue;
            sum += static_cast<double>(det::log2(std::max(light, kDarkest)));
            ++count;
        }
    }
    if (count == 0) return kMostExposure;
    const float stops = static_cast<float>(sum / count);
    return std::clamp(kExposureOfOne * det::exp2(-kFollows * stops), kLeastExposure, kMostExposure);
}

float adapted_exposure(const Image& picture, float previous, float seconds) {
    EXPECTS(previous > 0.0f && seconds >= 0.0f);
    const float wanted = metered_exposure(picture);
    const float time = wanted < previous ? kToBright : kToDark;
    const float share = 1.0f - det::exp(-seconds / time);
    return previous * det::exp2(det::log2(wanted / previous) * share);
}

void tone_map(const Image& picture, float exposure, std::uint32_t frame, const Jobs& jobs, Image8& out) {
    if (picture.width == 0 || picture.height == 0) {
        out = Image8(picture.width, picture.height, 3);
        return;
    }
    if (out.width != picture.width || out.height != picture.height || out.channels != 3) {
        out = Image8(picture.width, picture.height, 3);
    }
    jobs.run(static_cast<std::size_t>(picture.height), [&](std::size_t y, int) {
        ToneRow row{};
        row.radiance = &picture.pixels[y * static_cast<std::size_t>(picture.width)].x;
        row.width = static_cast<std::size_t>(picture.width);
        row.exposure = exposure;
        for (std::uint32_t x = 0; x < kDitherSide + kMostLanes; ++x)
            row.dither[x] = 0.5f * threshold(x, static_cast<std::uint32_t>(y), frame);
        row.bytes = out.at(0, static_cast<int>(y));
        tone_row(row);
    });
}

}  // namespace gh::filter
