#include "render/camera.h"

#include "base/contracts.h"
#include "base/det_math.h"
#include "render/directions.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace gh::render {

Camera camera_from(const world::Viewpoint& viewpoint) {
    return {.position = viewpoint.position,
            .yaw = viewpoint.yaw,
            .pitch = viewpoint.pitch,
            .roll = viewpoint.roll,
            .fov_y = viewpoint.fov_y};
}

Camera camera_around(const world::Aabb& box) {
    constexpr float kYaw = 0.6f, kPitch = -0.35f;
    Camera camera{.yaw = kYaw, .pitch = kPitch, .fov_y = 0.8f};
    const auto [sin_yaw, cos_yaw] = det::sin_cos(kYaw);
    const auto [sin_pitch, cos_pitch] = det::sin_cos(kPitch);
    const glm::vec3 forward(-sin_yaw * cos_pitch, sin_pitch, -cos_yaw * cos_pitch);
    const float radius = 0.5f * glm::length(box.max - box.min);
    const float distance = radius / det::sin(0.5f * camera.fov_y);  // the box's sphere just fits the picture
    camera.position = 0.5f * (box.min + box.max) - forward * distance;
    return camera;
}

Lens::Lens(const Camera& camera, int width, int height)
    : position_(camera.position), aperture_(camera.aperture), focus_(camera.focus) {
    EXPECTS(width >= 1 && height >= 1);
    EXPECTS(!(camera.aperture > 0.0f) || camera.focus > 0.0f);
    EXPECTS(camera.fov_y > 0.0f && camera.fov_y < kPi);
    const auto [sin_yaw, cos_yaw] = det::sin_cos(camera.yaw);
    const auto [sin_pitch, cos_pitch] = det::sin_cos(camera.pitch);
    const auto [sin_roll, cos_roll] = det::sin_cos(camera.roll);

    const glm::vec3 forward(-sin_yaw * cos_pitch, sin_pitch, -cos_yaw * cos_pitch);
    const glm::vec3 level_right(cos_yaw, 0.0f, -sin_yaw);
    const glm::vec3 level_up = glm::cross(level_right, forward);
    const glm::vec3 right = level_right * cos_roll + level_up * sin_roll;
    const glm::vec3 up = level_up * cos_roll - level_right * sin_roll;

    const float half_height = det::tan(0.5f * camera.fov_y);
    const float pixel = 2.0f * half_height / static_cast<float>(height);  // pixels are square
    right_ = right * pixel;
    down_ = -up * pixel;
    corner_ =
        forward - right_ * (0.5f * static_cast<float>(width)) - down_ * (0.5f * static_cast<float>(height));
    pixel_angle_ = pixel;
}

rc::Ray Lens::ray(const glm::vec2& point) const {
    const glm::vec3 direction = corner_ + right_ * point.x + down_ * point.y;
    return {.origin = position_, .direction = glm::normalize(direction)};
}

rc::Ray Lens::ray(const glm::vec2& point, const glm::vec2& u) const {
    if (!has_aperture()) return ray(point);
    const glm::vec2 within = circle_point(u.y) * (std::sqrt(u.x) * aperture_ / pixel_angle_);
    const glm::vec3 aside = right_ * within.x + down_ * within.y;
    const glm::vec3 to_sharp = (corner_ + right_ * point.x + down_ * point.y) * focus_;
    return {.origin = position_ + aside, .direction = glm::normalize(to_sharp - aside)};
}

Lens between(const Lens& a, const Lens& b, float share) {
    Lens lens = a;
    const auto blend = [share](auto& from, const auto& to) { from += (to - from) * share; };
    blend(lens.position_, b.position_);
    blend(lens.corner_, b.corner_);
    blend(lens.right_, b.right_);
    blend(lens.down_, b.down_);
    blend(lens.pixel_angle_, b.pixel_angle_);
    blend(lens.aperture_, b.aperture_);
    blend(lens.focus_, b.focus_);
    return lens;
}

}  // namespace gh::render
