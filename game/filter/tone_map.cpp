#include "filter/tone_map.h"

#include "base/det_math.h"

#include <glm/common.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace gh::filter {

namespace {

constexpr float kKnee = 0.25f;      // below it the curve is straight
constexpr float kWhitening = 8.0f;  // exposed peak at which a colour is a quarter of the way to white
// The eye follows the light half way only (in stops): a dark room is to look dark, and a bright one bright.
constexpr float kFollows = 0.5f;
constexpr float kExposureOfOne = 0.63f;  // where the logarithmic mean of the radiance is 1
constexpr float kLeastExposure = 0.02f, kMostExposure = 12.0f;
constexpr float kDarkest = 1e-4f;                  // radiance below which darkness is just darkness
constexpr float kToBright = 0.3f, kToDark = 2.0f;  // seconds to two thirds of the way

float luminance(const glm::vec3& c) {
    return 0.2126f * c.x + 0.7152f * c.y + 0.0722f * c.z;
}

// sRGB codes over the square root of linear light, where the function is nearly straight.
constexpr std::size_t kSteps = 1024;
using EncodingTable = std::array<float, kSteps + 2>;

EncodingTable make_encoding() {
    EncodingTable table;
    for (std::size_t i = 0; i < table.size(); ++i) {
        const float root = static_cast<float>(i) / static_cast<float>(kSteps);
        table[i] = 255.0f * srgb_from_linear(root * root);
    }
    return table;
}

const EncodingTable kEncoding = make_encoding();

float srgb_code(float linear) {
    const float at = std::sqrt(std::clamp(linear, 0.0f, 1.0f)) * static_cast<float>(kSteps);
    const auto i = static_cast<std::size_t>(at);
    const float blend = at - static_cast<float>(i);
    return kEncoding[i] + (kEncoding[i + 1] - kEncoding[i]) * blend;
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

glm::vec3 displayed(const glm::vec3& radiance, float exposure) {
    glm::vec3 c = radiance * exposure;
    for (std::size_t i = 0; i < 3; ++i) c[i] = c[i] > 0.0f ? std::min(c[i], 1e9f) : 0.0f;  // NaN is black
    const float peak = std::max({c.x, c.y, c.z});
    if (!(peak > 0.0f)) return glm::vec3(0.0f);
    const float shown = film_curve(peak);
    const float half_way = peak / (peak + kWhitening);
    return glm::mix(c * (shown / peak), glm::vec3(shown), half_way * half_way);
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
    if (out.width != picture.width || out.height != picture.height || out.channels != 3) {
        out = Image8(picture.width, picture.height, 3);
    }
    jobs.run(static_cast<std::size_t>(picture.height), [&](std::size_t row, int) {
        const int y = static_cast<int>(row);
        for (int x = 0; x < picture.width; ++x) {
            const glm::vec3 shown = displayed(picture.at(x, y), exposure);
            const float dither =
                threshold(static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y), frame);
            std::uint8_t* bytes = out.at(x, y);
            for (std::size_t c = 0; c < 3; ++c) {
                // Half a step either way at most: black stays black and a code that fits stays.
                const float code = srgb_code(shown[c]) + 0.25f + 0.5f * dither;
                bytes[c] = static_cast<std::uint8_t>(std::min(code, 255.0f));
            }
        }
    });
}

}  // namespace gh::filter
