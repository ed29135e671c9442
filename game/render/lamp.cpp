#include "render/lamp.h"

#include "base/det_math.h"
#include "render/fresnel.h"
#include "render/gloss.h"

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace gh::render {

namespace {

using world::Lamp;
using world::LampShape;

constexpr float kFadeShare = 1.0f / 6.0f;       // of the range
constexpr float kBulbMargin = 1.0f + 0x1p-10f;  // a vertex that lies on the fitted ball must not shadow it

float range_fade(const Lamp& lamp, float distance) {
    if (!(lamp.range < rc::kInfinity)) return 1.0f;
    return std::clamp((lamp.range - distance) / (lamp.range * kFadeShare), 0.0f, 1.0f);
}

float cone_share(const Lamp& lamp, const glm::vec3& to_lamp) {
    if (lamp.shape != LampShape::Spot) return 1.0f;
    const float cosine = -glm::dot(to_lamp, lamp.direction);
    const float share = (cosine - lamp.cos_outer) / std::max(lamp.cos_inner - lamp.cos_outer, 1e-4f);
    const float clamped = std::clamp(share, 0.0f, 1.0f);
    return clamped * clamped;
}

float rect_area(const Lamp& lamp) {
    return 4.0f * glm::length(lamp.half_u) * glm::length(lamp.half_v);
}

// Irradiance over radiance of a ball of angular radius asin(sin_radius), partly below the horizon (Snyder 1996).
float clipped_ball(float cosine, float sin_radius) {
    const float sine = std::sqrt(std::max(0.0f, 1.0f - cosine * cosine));
    const float sin2 = sin_radius * sin_radius;
    const float cotangent = std::sqrt(std::max(0.0f, 1.0f / sin2 - 1.0f));
    const float y = std::clamp(-cotangent * cosine / std::max(sine, 1e-7f), -1.0f, 1.0f);
    const float s = sine * std::sqrt(1.0f - y * y);
    const float below = sin2 * (cosine * det::acos(y) - cotangent * s);
    return std::max(0.0f, below + det::atan2(s, cotangent));
}

float ball_irradiance(const Lamp& lamp, const glm::vec3& position, const glm::vec3& normal) {
    const glm::vec3 to_lamp = lamp.position - position;
    const float distance = glm::length(to_lamp);
    if (!(distance > lamp.radius)) return kPi;
    const float sin_radius = lamp.radius / distance;
    const float cosine = glm::dot(normal, to_lamp) / distance;
    if (cosine >= sin_radius) return kPi * sin_radius * sin_radius * cosine;
    return cosine <= -sin_radius ? 0.0f : clipped_ball(cosine, sin_radius);
}

// Lambert's polygon formula over what of the rectangle is above the horizon.
float rect_irradiance(const Lamp& lamp, const glm::vec3& position, const glm::vec3& normal) {
    const glm::vec3 centre = lamp.position - position;
    if (!(glm::dot(centre, lamp.direction) < 0.0f)) return 0.0f;  // behind it
    const std::array<glm::vec3, 4> corner = {
        centre - lamp.half_u - lamp.half_v, centre + lamp.half_u - lamp.half_v,
        centre + lamp.half_u + lamp.half_v, centre - lamp.half_u + lamp.half_v};
    std::array<glm::vec3, 6> visible;
    std::size_t count = 0;
    for (std::size_t i = 0; i < 4; ++i) {
        const glm::vec3& a = corner[i];
        const glm::vec3& b = corner[(i + 1) % 4];
        const float height_a = glm::dot(normal, a), height_b = glm::dot(normal, b);
        if (height_a >= 0.0f) visible[count++] = a;
        if ((height_a < 0.0f) != (height_b < 0.0f))
            visible[count++] = a + (b - a) * (height_a / (height_a - height_b));
    }
    float sum = 0.0f;
    for (std::size_t i = 0; i < count; ++i) {
        const glm::vec3& a = visible[i];
        const glm::vec3& b = visible[i + 1 < count ? i + 1 : 0];
        const glm::vec3 across = glm::cross(a, b);
        const float length = glm::length(across);
        if (length > 0.0f) sum += det::atan2(length, glm::dot(a, b)) * glm::dot(normal, across) / length;
    }
    return 0.5f * std::abs(sum);
}

// Where the reflected ray comes nearest to the rectangle's middle, within the rectangle.
glm::vec3 best_rect_point(const Lamp& lamp, const glm::vec3& centre, const glm::vec3& reflected) {
    const float towards = glm::dot(reflected, lamp.direction);
    const glm::vec3 on_plane = towards < -1e-4f ? reflected * (glm::dot(centre, lamp.direction) / towards)
                                                : reflected * glm::length(centre);
    const glm::vec3 offset = on_plane - centre;
    const float u = glm::dot(offset, lamp.half_u) / glm::dot(lamp.half_u, lamp.half_u);
    const float v = glm::dot(offset, lamp.half_v) / glm::dot(lamp.half_v, lamp.half_v);
    return centre + lamp.half_u * std::clamp(u, -1.0f, 1.0f) + lamp.half_v * std::clamp(v, -1.0f, 1.0f);
}

// A lamp as one direction with a perpendicular irradiance and a lobe widened by the lamp's size.
struct StandIn {
    glm::vec3 to_lamp{0.0f};  // unit
    glm::vec3 irradiance{0.0f};
    float alpha_u = 1.0f;
    float alpha_v = 1.0f;
};

StandIn stand_in(const Lamp& lamp, const glm::vec3& position, const Gloss& gloss) {
    if (lamp.shape == LampShape::Sun) {
        const float alpha = std::max(gloss.alpha, kSmallestAlpha);
        return {-lamp.direction, lamp.intensity, alpha, alpha};
    }
    const glm::vec3 centre = lamp.position - position;
    const float distance = std::max(glm::length(centre), lamp.radius);
    if (!(distance > 0.0f)) return {};
    const float per_distance2 = range_fade(lamp, distance) / (distance * distance);
    const glm::vec3 reflected = gloss.normal * (2.0f * glm::dot(gloss.normal, gloss.to_eye)) - gloss.to_eye;

    if (lamp.shape == LampShape::Sphere) {
        const glm::vec3 to_ray = reflected * glm::dot(centre, reflected) - centre;
        const float off = glm::length(to_ray);
        const glm::vec3 best = off > lamp.radius ? centre + to_ray * (lamp.radius / off) : centre + to_ray;
        const float wide = gloss.alpha + 0.5f * lamp.radius / distance;
        return {glm::normalize(best), lamp.intensity * (kPi * lamp.radius * lamp.radius * per_distance2),
                wide, wide};
    }
    if (lamp.shape == LampShape::Rect) {
        const float facing = -glm::dot(centre, lamp.direction) / distance;
        if (!(facing > 0.0f)) return {};
        const float spread = std::sqrt(facing / kPi) / distance;
        return {glm::normalize(best_rect_point(lamp, centre, reflected)),
                lamp.intensity * (rect_area(lamp) * facing * per_distance2),
                gloss.alpha + glm::length(lamp.half_u) * spread,
                gloss.alpha + glm::length(lamp.half_v) * spread};
    }
    const glm::vec3 to_lamp = centre / distance;
    const float alpha = std::max(gloss.alpha, kSmallestAlpha);
    return {to_lamp, lamp.intensity * (per_distance2 * cone_share(lamp, to_lamp)), alpha, alpha};
}

}  // namespace

BulbClearance bulb_clearance(const world::Level& level, const world::Snapshot& snapshot, const Lamp& lamp) {
    BulbClearance clearance{.radius = lamp.radius};
    if (lamp.part == world::kNoIndex) return clearance;
    const glm::mat4x3& to_world = snapshot.scene->instance(lamp.part).world_from_instance;
    float size = lamp.radius;
    for (const glm::vec3& p : level.meshes[level.parts[lamp.part].mesh].positions) {
        const glm::vec3 offset = to_world * glm::vec4(p, 1.0f) - lamp.position;
        size = std::max(size, glm::length(offset));
        clearance.front = std::max(clearance.front, glm::dot(offset, lamp.direction));
    }
    clearance.radius = size * kBulbMargin;
    clearance.front += size * (kBulbMargin - 1.0f);
    return clearance;
}

glm::vec3 lamp_irradiance(const Lamp& lamp, const glm::vec3& position, const glm::vec3& normal) {
    if (lamp.shape == LampShape::Sun)
        return lamp.intensity * std::max(0.0f, -glm::dot(normal, lamp.direction));
    const glm::vec3 offset = lamp.position - position;
    const float distance2 = glm::dot(offset, offset);
    const float distance = std::sqrt(distance2);
    const float fade = range_fade(lamp, distance);
    if (!(fade > 0.0f) || !(distance > 0.0f)) return glm::vec3(0.0f);
    if (lamp.shape == LampShape::Sphere)
        return lamp.intensity * (fade * ball_irradiance(lamp, position, normal));
    if (lamp.shape == LampShape::Rect)
        return lamp.intensity * (fade * rect_irradiance(lamp, position, normal));
    const glm::vec3 to_lamp = offset / distance;
    const float cosine = std::max(0.0f, glm::dot(normal, to_lamp));
    return lamp.intensity * (fade * cone_share(lamp, to_lamp) * cosine / distance2);
}

float lamp_bound(const Lamp& lamp, float distance) {
    const float brightest = std::max({lamp.intensity.x, lamp.intensity.y, lamp.intensity.z});
    if (lamp.shape == LampShape::Sun) return brightest;
    const float fade = range_fade(lamp, distance);
    if (lamp.shape == LampShape::Sphere) {
        const float ratio = distance > lamp.radius ? lamp.radius / distance : 1.0f;
        return brightest * fade * kPi * ratio * ratio;
    }
    if (lamp.shape == LampShape::Rect) {
        const float nearest = distance - glm::length(lamp.half_u) - glm::length(lamp.half_v);
        if (!(nearest > 0.0f)) return brightest * fade * kPi;
        return brightest * fade * std::min(kPi, rect_area(lamp) / (nearest * nearest));
    }
    return brightest * fade / (distance * distance);
}

bool is_area(const Lamp& lamp) {
    return lamp.shape == LampShape::Sphere || lamp.shape == LampShape::Rect;
}

glm::vec3 lamp_point(const Lamp& lamp, const glm::vec3& position, const glm::vec2& u) {
    switch (lamp.shape) {
        case LampShape::Rect:
            return lamp.position + lamp.half_u * (2.0f * u.x - 1.0f) + lamp.half_v * (2.0f * u.y - 1.0f);
        case LampShape::Sphere: {
            const glm::vec3 axis = direction_to(lamp, position);
            const glm::vec3 side = glm::normalize(std::abs(axis.y) < 0.9f ? glm::vec3(axis.z, 0.0f, -axis.x)
                                                                          : glm::vec3(0.0f, -axis.z, axis.y));
            const glm::vec3 over = glm::cross(axis, side);
            const float radius = std::sqrt(u.x);
            const auto [sine, cosine] = det::sin_cos(kTwoPi * u.y);
            const glm::vec3 on_disc = side * (radius * cosine) + over * (radius * sine);
            return lamp.position +
                   (on_disc - axis * std::sqrt(1.0f - u.x)) * lamp.radius;  // the half that faces us
        }
        default:
            return lamp.position;
    }
}

glm::vec3 direction_to(const Lamp& lamp, const glm::vec3& position) {
    if (lamp.shape == LampShape::Sun) return -lamp.direction;
    const glm::vec3 offset = lamp.position - position;
    const float length = glm::length(offset);
    return length > 0.0f ? offset / length : -lamp.direction;
}

std::optional<rc::Ray> shadow_ray(const Lamp& lamp, const BulbClearance& bulb, const rc::SurfacePoint& point,
                                  const glm::vec3& target) {
    if (lamp.shape == LampShape::Sun) return rc::spawn_ray(point, -lamp.direction);
    if (lamp.shape == LampShape::Rect) {
        const float height = glm::dot(point.position - target, lamp.direction);
        const float end = 1.0f - bulb.front / height;
        if (!(end > 0.0f)) return std::nullopt;
        rc::Ray ray = rc::spawn_ray_to(point, target);
        ray.t_max = std::min(ray.t_max, end);
        return ray;
    }
    // The way into the ball around the bulb: |from + t * way - centre| = radius, the smaller root.
    const glm::vec3 way = target - point.position;
    const glm::vec3 from = point.position - lamp.position;
    const float outside = glm::dot(from, from) - bulb.radius * bulb.radius;
    if (!(outside > 0.0f)) return std::nullopt;
    rc::Ray ray = rc::spawn_ray_to(point, target);
    const float a = glm::dot(way, way), b = glm::dot(from, way);
    const float root2 = b * b - a * outside;
    if (root2 > 0.0f && b < 0.0f) ray.t_max = std::min(ray.t_max, outside / (std::sqrt(root2) - b));
    return ray.t_max > ray.t_min ? std::optional<rc::Ray>(ray) : std::nullopt;
}

glm::vec3 lamp_highlight(const Lamp& lamp, const glm::vec3& position, const Gloss& gloss) {
    const StandIn light = stand_in(lamp, position, gloss);
    const float cos_eye = glm::dot(gloss.normal, gloss.to_eye);
    const float cos_light = glm::dot(gloss.normal, light.to_lamp);
    if (!(cos_light > 0.0f) || !(cos_eye > 0.0f)) return glm::vec3(0.0f);
    const glm::vec3 half = glm::normalize(gloss.to_eye + light.to_lamp);
    const float cos_half = std::clamp(glm::dot(gloss.normal, half), 0.0f, 1.0f);
    const float cos_half_eye = std::clamp(glm::dot(gloss.to_eye, half), 0.0f, 1.0f);

    const float alpha = std::max(gloss.alpha, 1e-4f);
    const float widened = (alpha * alpha) / (light.alpha_u * light.alpha_v);
    const float lobe =
        ggx_density(cos_half, alpha) * std::min(widened, 1.0f) * ggx_visibility(cos_eye, cos_light, alpha);
    return light.irradiance * schlick(gloss.f0, gloss.f90, cos_half_eye) * (lobe * cos_light);
}

}  // namespace gh::render
