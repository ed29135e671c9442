#include "input/command.h"

#include "base/contracts.h"
#include "base/det_math.h"

#include <algorithm>
#include <cmath>

namespace gh::input {

namespace {

constexpr float kRadiansPerUnit = kTwoPi / 65536.0f;

// Halves go away from zero, so that left and right are alike.
float nearest(float x) {
    return std::copysign(std::floor(std::abs(x) + 0.5f), x);
}

}  // namespace

bool is_valid(const Command& command) {
    return std::abs(int{command.pitch}) <= kMaxPitch && command.move_right >= -kMaxMove &&
           command.move_forward >= -kMaxMove && (command.buttons & ~kAllButtons) == 0;
}

float yaw_radians(std::int16_t yaw) {
    return static_cast<float>(yaw) * kRadiansPerUnit;
}

float pitch_radians(std::int16_t pitch) {
    return static_cast<float>(pitch) * kRadiansPerUnit;
}

std::int16_t quantise_yaw(float radians) {
    EXPECTS(std::isfinite(radians));
    const float units = nearest(wrap_angle(radians) / kRadiansPerUnit);
    // Half a turn is 32768, which wraps to -32768.
    return static_cast<std::int16_t>(static_cast<std::uint16_t>(static_cast<std::int32_t>(units)));
}

std::int16_t quantise_pitch(float radians) {
    EXPECTS(std::isfinite(radians));
    const auto limit = static_cast<float>(kMaxPitch);
    return static_cast<std::int16_t>(std::clamp(nearest(radians / kRadiansPerUnit), -limit, limit));
}

std::int8_t quantise_move(float share) {
    if (std::isnan(share)) return 0;
    return static_cast<std::int8_t>(nearest(std::clamp(share, -1.0f, 1.0f) * static_cast<float>(kMaxMove)));
}

glm::vec3 look_direction(float yaw, float pitch) {
    const det::SinCos y = det::sin_cos(yaw);
    const det::SinCos p = det::sin_cos(pitch);
    return {-y.sin * p.cos, p.sin, -y.cos * p.cos};
}

}  // namespace gh::input
