#include "raycore/ray.h"

#include <cmath>

namespace rc {

namespace {

// The next float away from zero on the side of `offset`, so that rounding never brings the origin back.
float step_away(float value, float offset) {
    const float moved = value + offset;
    if (offset == 0.0f || moved != value) return moved;
    return std::nextafter(value, offset > 0.0f ? kInfinity : -kInfinity);
}

glm::vec3 leave(const SurfacePoint& point, const glm::vec3& towards) {
    const glm::vec3& n = point.normal;
    const glm::vec3& e = point.position_error;
    const float along = (towards.x * n.x + towards.y * n.y) + towards.z * n.z;
    const float bound = (std::abs(n.x) * e.x + std::abs(n.y) * e.y) + std::abs(n.z) * e.z;
    const float distance = (along < 0.0f ? -4.0f : 4.0f) * bound;
    return {step_away(point.position.x, distance * n.x), step_away(point.position.y, distance * n.y),
            step_away(point.position.z, distance * n.z)};
}

}  // namespace

Ray spawn_ray(const SurfacePoint& point, const glm::vec3& direction, float t_max) {
    return {.origin = leave(point, direction),
            .direction = direction,
            .t_min = 0.0f,
            .t_max = t_max,
            .skip_instance = point.instance,
            .skip_primitive = point.primitive};
}

Ray spawn_ray_to(const SurfacePoint& point, const glm::vec3& target) {
    Ray ray = spawn_ray(point, target - point.position, 1.0f);
    ray.direction = target - ray.origin;
    return ray;
}

}  // namespace rc
