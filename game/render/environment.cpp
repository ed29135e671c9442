#include "render/environment.h"

#include "base/det_math.h"
#include "render/directions.h"
#include "render/sane.h"

#include <algorithm>
#include <cmath>

namespace gh::render {

namespace {

float mean_of(const glm::vec3& c) {
    return (c.x + c.y + c.z) / 3.0f;
}

// The first of `sums` beyond `u` of the last, and how far in between it is.
std::size_t find(const float* sums, std::size_t count, float u, float& within) {
    const float wanted = u * sums[count - 1];
    auto i = static_cast<std::size_t>(std::upper_bound(sums, sums + count, wanted) - sums);
    i = std::min(i, count - 1);
    while (i > 0 && !(sums[i] > sums[i - 1])) --i;  // rounding must not pick what weighs nothing
    const float below = i > 0 ? sums[i - 1] : 0.0f;
    within = std::clamp((wanted - below) / (sums[i] - below), 0.0f, 0x1.fffffep-1f);
    return i;
}

}  // namespace

Environment::Environment(Image picture) : picture_(std::move(picture)) {
    if (picture_.pixels.empty()) return;
    const auto width = static_cast<std::size_t>(picture_.width),
               height = static_cast<std::size_t>(picture_.height);
    for (glm::vec3& pixel : picture_.pixels) pixel = sane_light(pixel);
    columns_.resize(width * height);
    rows_.resize(height);
    double total = 0.0;
    for (std::size_t y = 0; y < height; ++y) {
        const float top = det::cos(kPi * static_cast<float>(y) / static_cast<float>(height));
        const float bottom = det::cos(kPi * static_cast<float>(y + 1) / static_cast<float>(height));
        solid_angle_.push_back(kTwoPi / static_cast<float>(width) * (top - bottom));
        double row = 0.0;
        for (std::size_t x = 0; x < width; ++x) {
            row += static_cast<double>(mean_of(picture_.pixels[y * width + x]) * solid_angle_[y]);
            columns_[y * width + x] = static_cast<float>(row);
        }
        total += row;
        rows_[y] = static_cast<float>(total);
    }
    mean_ = static_cast<float>(total) / (4.0f * kPi);
}

Environment::Texel Environment::texel(const glm::vec3& direction) const {
    const float across = det::atan2(direction.z, direction.x) / kTwoPi + 0.5f;
    const float down = det::acos(std::clamp(direction.y, -1.0f, 1.0f)) / kPi;
    const auto place = [](float u, int side) {
        return static_cast<std::size_t>(
            std::clamp(static_cast<int>(u * static_cast<float>(side)), 0, side - 1));
    };
    return {place(across, picture_.width), place(down, picture_.height)};
}

glm::vec3 Environment::radiance(const glm::vec3& direction) const {
    if (picture_.pixels.empty()) return glm::vec3(0.0f);
    const Texel at = texel(direction);
    return picture_.pixels[at.y * static_cast<std::size_t>(picture_.width) + at.x];
}

float Environment::texel_density(std::size_t x, std::size_t y) const {
    const auto width = static_cast<std::size_t>(picture_.width);
    const float own = columns_[y * width + x] - (x > 0 ? columns_[y * width + x - 1] : 0.0f);
    const float row = rows_[y] - (y > 0 ? rows_[y - 1] : 0.0f);
    const float row_sum = columns_[y * width + width - 1];
    if (!(row_sum > 0.0f) || !(solid_angle_[y] > 0.0f)) return 0.0f;
    return own / row_sum * (row / rows_.back()) / solid_angle_[y];
}

float Environment::density(const glm::vec3& direction) const {
    if (!(mean_ > 0.0f)) return 0.0f;
    const Texel at = texel(direction);
    return texel_density(at.x, at.y);
}

Environment::Pick Environment::pick(const glm::vec2& u) const {
    if (!(mean_ > 0.0f)) return {};
    const auto width = static_cast<std::size_t>(picture_.width),
               height = static_cast<std::size_t>(picture_.height);
    float down = 0.0f, across = 0.0f;
    const std::size_t y = find(rows_.data(), height, u.y, down);
    const std::size_t x = find(columns_.data() + y * width, width, u.x, across);
    // Evenly over the texel's solid angle: evenly in the cosine.
    const float top = det::cos(kPi * static_cast<float>(y) / static_cast<float>(height));
    const float cosine = top - down * solid_angle_[y] * static_cast<float>(width) / kTwoPi;
    const float sine = std::sqrt(std::max(0.0f, 1.0f - cosine * cosine));
    const glm::vec2 turn = circle_point((static_cast<float>(x) + across) / static_cast<float>(width));
    // Longitude -pi at the left edge: x = cos, z = sin.
    const glm::vec3 direction(-turn.x * sine, cosine, -turn.y * sine);
    return {direction, picture_.pixels[y * width + x], texel_density(x, y)};
}

}  // namespace gh::render
