#include "sense/sight.h"

#include "base/contracts.h"
#include "base/vectors.h"
#include "sense/exposure.h"
#include "world/layers.h"

#include "raycore/query.h"

#include <algorithm>
#include <cmath>

namespace gh::sense {
namespace {

using PointFlags = std::array<std::uint8_t, kBodyPoints>;

// A look that ends on a pane may end this share of its length before or behind it: rounding of the pane's own corners.
// A frame that stands in front of its glass by less than that hides nothing.
constexpr float kPaneTolerance = 1e-4f;

// Whether a look along `way` stays in the view cone; `distance` is how far the light has come by then.
bool is_in_view(const Eye& eye, const glm::vec3& way, float distance) {
    return distance > 0.0f && distance <= eye.range &&
           dot_of(way, eye.forward) >= eye.cos_half_fov * length_of(way);
}

void count_point(Sighting& sighting, float lit, float distance) {
    sighting.distance = sighting.clear == 0.0f ? distance : std::min(sighting.distance, distance);
    sighting.seen += lit;
    sighting.clear += 1.0f;
}

void average(Sighting& sighting) {
    sighting.seen /= static_cast<float>(kBodyPoints);
    sighting.clear /= static_cast<float>(kBodyPoints);
}

// What one pane shows one eye of the body.
struct Reflection {
    std::array<float, kBodyPoints> distance{};  // along the light
    PointFlags is_seen{};
};

// The place on the pane in which the eye sees `point`, if the pane is large enough and both are in front of it.
bool find_pane_point(const world::MirrorPane& pane, const glm::vec3& eye, const glm::vec3& point,
                     glm::vec3& at) {
    const float eye_height = dot_of(eye - pane.centre, pane.normal);
    const float point_height = dot_of(point - pane.centre, pane.normal);
    if (!(eye_height > 0.0f && point_height > 0.0f)) return false;
    const glm::vec3 image = point - pane.normal * (2.0f * point_height);
    at = eye + (image - eye) * (eye_height / (eye_height + point_height));
    const glm::vec3 off = at - pane.centre;
    return std::abs(dot_of(off, pane.half_u)) <= dot_of(pane.half_u, pane.half_u) &&
           std::abs(dot_of(off, pane.half_v)) <= dot_of(pane.half_v, pane.half_v);
}

// Two batches: which looks reach the pane, and which of those go on to the body.
Reflection reflect(const rc::Scene& scene, const world::MirrorPane& pane, const Eye& eye, const Body& body) {
    Reflection reflection;
    std::array<rc::Ray, kBodyPoints> looks;
    std::array<rc::Hit, kBodyPoints> met;
    std::array<std::size_t, kBodyPoints> point_of;
    std::size_t count = 0;
    for (std::size_t p = 0; p < kBodyPoints; ++p) {
        glm::vec3 at;
        if (!find_pane_point(pane, eye.position, body.point[p], at)) continue;
        const glm::vec3 way = at - eye.position;
        const float distance = length_of(way) + length_of(body.point[p] - at);
        if (!is_in_view(eye, way, distance)) continue;
        looks[count] = {.origin = eye.position, .direction = way, .t_max = 1.0f + kPaneTolerance};
        point_of[count] = p;
        reflection.distance[p] = distance;
        ++count;
    }
    rc::closest_hits(scene, std::span(looks).first(count), world::Sight, std::span(met).first(count));

    std::array<rc::Ray, kBodyPoints> onward;
    std::array<std::size_t, kBodyPoints> onward_point;
    PointFlags is_blocked{};
    std::size_t onward_count = 0;
    for (std::size_t i = 0; i < count; ++i) {
        if (met[i].instance != pane.part || met[i].t < 1.0f - kPaneTolerance) continue;
        onward[onward_count] = rc::spawn_ray_to(scene.surface(met[i]), body.point[point_of[i]]);
        onward_point[onward_count] = point_of[i];
        ++onward_count;
    }
    rc::any_hits(scene, std::span(onward).first(onward_count), world::Sight,
                 std::span(is_blocked).first(onward_count));
    for (std::size_t i = 0; i < onward_count; ++i)
        reflection.is_seen[onward_point[i]] = is_blocked[i] == 0 ? 1 : 0;
    return reflection;
}

Sighting sight_of(const rc::Scene& scene, const Eye& eye, const Body& body) {
    std::array<rc::Ray, kBodyPoints> rays;
    std::array<std::size_t, kBodyPoints> point_of;
    PointFlags is_blocked{};
    std::size_t count = 0;
    for (std::size_t p = 0; p < kBodyPoints; ++p) {
        const glm::vec3 way = body.point[p] - eye.position;
        if (!is_in_view(eye, way, length_of(way))) continue;
        rays[count] = {.origin = eye.position, .direction = way, .t_max = 1.0f};
        point_of[count] = p;
        ++count;
    }
    rc::any_hits(scene, std::span(rays).first(count), world::Sight, std::span(is_blocked).first(count));
    Sighting sighting;
    for (std::size_t i = 0; i < count; ++i) {
        if (is_blocked[i] == 0) count_point(sighting, body.lit[point_of[i]], length_of(rays[i].direction));
    }
    average(sighting);
    return sighting;
}

Sighting mirror_sight_of(const rc::Scene& scene, std::span<const world::MirrorPane> panes, const Eye& eye,
                         const Body& body) {
    std::array<float, kBodyPoints> best{};  // reflectance of the pane that shows a point best; 0: none does
    std::array<float, kBodyPoints> distance{};
    Sighting sighting;
    float most = 0.0f;
    for (std::size_t i = 0; i < panes.size(); ++i) {
        if (panes[i].part == world::kNoIndex) continue;
        const float reflectance = luminance(panes[i].reflectance);
        const Reflection reflection = reflect(scene, panes[i], eye, body);
        float shown = 0.0f;
        for (std::size_t p = 0; p < kBodyPoints; ++p) {
            if (reflection.is_seen[p] == 0) continue;
            shown += reflectance;
            if (reflectance > best[p]) {
                best[p] = reflectance;
                distance[p] = reflection.distance[p];
            }
        }
        if (shown > most) {
            most = shown;
            sighting.pane = static_cast<std::uint32_t>(i);
        }
    }
    for (std::size_t p = 0; p < kBodyPoints; ++p) {
        if (best[p] > 0.0f) count_point(sighting, body.lit[p] * best[p], distance[p]);
    }
    average(sighting);
    return sighting;
}

}  // namespace

void sight(const rc::Scene& scene, std::span<const Eye> eyes, const Body& body, std::span<Sighting> out) {
    EXPECTS(eyes.size() == out.size());
    for (std::size_t e = 0; e < eyes.size(); ++e) out[e] = sight_of(scene, eyes[e], body);
}

void mirror_sight(const rc::Scene& scene, std::span<const world::MirrorPane> panes, std::span<const Eye> eyes,
                  const Body& body, std::span<Sighting> out) {
    EXPECTS(eyes.size() == out.size());
    for (std::size_t e = 0; e < eyes.size(); ++e) out[e] = mirror_sight_of(scene, panes, eyes[e], body);
}

}  // namespace gh::sense
