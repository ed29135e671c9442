#include "sim/motion.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>

#include "sim/geometry.h"
#include "sim/planes.h"
#include "world/layers.h"

namespace gh::sim {

namespace {

constexpr int kMaxSlides = 5;
constexpr float kMinApproach = 0.1f;   // sine of the angle below which padding is no longer kept to the letter
constexpr float kShortest = 1e-6f;     // metres: less is no displacement
constexpr float kDeepestPush = 0.1f;   // metres: a third of the radius, so that no push crosses a wall
constexpr float kSettled = 1e-4f;      // metres: a body nearer to its floor than this is not moved: bits stay


bool is_floor(const glm::vec3& normal) { return normal.y >= kMinGroundY; }

// What a walker takes a surface for: floors stay, all else stands upright so that nobody is led up or down it.
glm::vec3 plane_for_walking(const glm::vec3& normal) {
    if (is_floor(normal)) return normal;
    const float length = flat_length(normal);
    return length > 0.01f ? flat(normal) / length : normal;
}

// Walking: walls turn the way in the horizontal plane; floors then only lift or lower it, so that a slope costs
// no speed.
glm::vec3 along_for_walking(std::span<const glm::vec3> planes, const glm::vec3& v) {
    std::array<glm::vec3, kMaxSlides> walls;
    std::size_t wall_count = 0;
    for (const glm::vec3& plane : planes) {
        if (!is_floor(plane)) walls[wall_count++] = plane;
    }
    glm::vec3 way = along_planes(std::span(walls).first(wall_count), {v.x, 0.0f, v.z});
    way.y = wall_count == planes.size() ? v.y : -rc::kInfinity;
    for (const glm::vec3& plane : planes) {
        if (is_floor(plane)) way.y = std::max(way.y, -(plane.x * way.x + plane.z * way.z) / plane.y);
    }
    return way;
}

float progress(const glm::vec3& from, const glm::vec3& to, const glm::vec3& wanted) {
    return (to.x - from.x) * wanted.x + (to.z - from.z) * wanted.z;
}

// A round bottom on the edge of a step meets it at a slant; what matters is the tread beyond the edge.
bool is_tread_beyond(const rc::Scene& scene, const Body& body, const rc::CastHit& hit) {
    const glm::vec3 out = flat(hit.point - body.feet);
    const float length = length_of(out);
    if (!(length > kShortest)) return false;
    const rc::Ray ray{.origin = hit.point + out * (0.02f / length) + kUp * 0.05f,
                      .direction = {0.0f, -0.1f, 0.0f},
                      .t_max = 1.0f};
    const std::optional<rc::Hit> tread = rc::closest_hit(scene, ray, world::Solid);
    return tread && std::abs(scene.surface(*tread).normal.y) >= kMinGroundY;
}

// How far the body can go straight up or down, keeping its padding.
float clear_height(const rc::Scene& scene, const Body& body, float height) {
    const glm::vec3 displacement{0.0f, height, 0.0f};
    const auto hit = rc::capsule_cast(scene, axis_of(body), body.radius, displacement, world::Solid);
    if (!hit) return height;
    return std::max(hit->t * height - kPadding, 0.0f);
}

}  // namespace

rc::Segment axis_of(const Body& body) {
    const float low = body.radius + kPadding;
    const float high = std::max(body.height - body.radius, low);
    return {body.feet + kUp * low, body.feet + kUp * high};
}

void slide(const rc::Scene& scene, Body& body, glm::vec3 displacement, bool is_walking, glm::vec3& velocity) {
    std::array<glm::vec3, kMaxSlides> planes;
    for (std::size_t i = 0; i < kMaxSlides; ++i) {
        const float length = length_of(displacement);
        if (!(length > kShortest)) return;
        // Looking ahead by the padding, so that the last step before a wall does not end inside it.
        const glm::vec3 direction = displacement / length;
        const float ahead = length + kPadding;
        const auto hit = rc::capsule_cast(scene, axis_of(body), body.radius, direction * ahead, world::Solid);
        const float approach = hit ? std::max(-glm::dot(direction, hit->normal), kMinApproach) : 1.0f;
        const float advance = hit ? std::max(hit->t * ahead - kPadding / approach, 0.0f) : length;
        if (!hit || advance >= length) {
            body.feet += displacement;
            return;
        }
        body.feet += direction * advance;

        planes[i] = is_walking ? plane_for_walking(hit->normal) : hit->normal;
        const std::span<const glm::vec3> met = std::span(planes).first(i + 1);
        const glm::vec3 rest = direction * (length - advance);
        displacement = is_walking ? along_for_walking(met, rest) : along_planes(met, rest);
        velocity = is_walking ? along_for_walking(met, velocity) : along_planes(met, velocity);
    }
}

void walk(const rc::Scene& scene, Body& body, const glm::vec3& displacement, glm::vec3& velocity) {
    const Body start = body;
    const glm::vec3 velocity_before = velocity;
    slide(scene, body, displacement, true, velocity);
    const float wanted = displacement.x * displacement.x + displacement.z * displacement.z;
    const float reached = progress(start.feet, body.feet, displacement);
    if (reached > 0.999f * wanted) return;

    // Something is in the way: over it, if it is a step. Up, along, and down on to a floor.
    Body over = start;
    const float rise = clear_height(scene, over, kStepHeight);
    over.feet.y += rise;
    glm::vec3 velocity_over = velocity_before;
    slide(scene, over, displacement, true, velocity_over);
    if (progress(start.feet, over.feet, displacement) <= reached + 1e-3f * wanted) return;
    const Ground tread = stand(scene, over, rise + kPadding);
    constexpr float kRounding = 1e-3f;
    if (!tread.is_there || tread.height > start.feet.y + kStepHeight + kRounding) return;
    body = over;
    velocity = velocity_over;
}

Ground stand(const rc::Scene& scene, Body& body, float reach) {
    Ground ground;
    const float drop = reach + kPadding;
    const auto hit =
        rc::capsule_cast(scene, axis_of(body), body.radius, {0.0f, -drop, 0.0f}, world::Solid);
    if (!hit) return ground;
    if (!is_floor(hit->normal) && !is_tread_beyond(scene, body, *hit)) return ground;

    ground = {true, hit->point.y, hit->instance, hit->primitive};
    const float fall = hit->t * drop - kPadding;
    if (fall > kSettled) body.feet.y -= fall;
    if (fall < -kSettled) body.feet.y += clear_height(scene, body, -fall);
    return ground;
}

void push_out(const rc::Scene& scene, Body& body) {
    constexpr float kClearance = 0.5f * kPadding;  // restores part of the padding, too
    const Body start = body;
    std::array<rc::CastHit, 8> contacts;
    float first_depth = 0.0f;
    for (int i = 0; i < 4; ++i) {
        const std::size_t count =
            rc::capsule_overlaps(scene, axis_of(body), body.radius + kClearance, world::Solid, contacts);
        if (count == 0) return;
        if (i == 0) first_depth = contacts[0].depth;
        body.feet += contacts[0].normal * std::min(contacts[0].depth + kSettled, kDeepestPush);
    }
    // Squeezed from two sides: better to overlap as before than to be pressed through one of them.
    const std::size_t count =
        rc::capsule_overlaps(scene, axis_of(body), body.radius + kClearance, world::Solid, contacts);
    if (count != 0 && contacts[0].depth >= first_depth) body = start;
}

bool has_room(const rc::Scene& scene, const Body& body) {
    std::array<rc::CastHit, 1> contact;
    return rc::capsule_overlaps(scene, axis_of(body), body.radius, world::Solid, contact) == 0;
}

}  // namespace gh::sim
