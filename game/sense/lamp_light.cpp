#include "sense/lamp_light.h"

#include "base/contracts.h"
#include "base/det_math.h"
#include "base/vectors.h"
#include "sense/glass.h"
#include "world/layers.h"
#include "world/lookup.h"

#include "raycore/query.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace gh::sense {
namespace {

constexpr std::size_t kStrata = 4;  // rays to an area lamp
constexpr std::size_t kBatch = 16;  // probes asked about at a time

// One way from a probe to a lamp, and what would come along it if nothing stood there.
struct Beam {
    glm::vec3 target{0.0f};
    glm::vec3 light{0.0f};  // W/m2
};
using Beams = std::array<Beam, kStrata>;  // unused ones carry no light

// How much of a beam from `direction` (unit, towards the lamp) the probe catches.
float caught(const Probe& probe, const glm::vec3& direction) {
    if (probe.normal == glm::vec3(0.0f)) return 1.0f;
    return std::max(0.0f, dot_of(probe.normal, direction));
}

float spot_share(const world::Lamp& lamp, float cosine) {
    if (!(cosine > lamp.cos_outer)) return 0.0f;
    if (cosine >= lamp.cos_inner) return 1.0f;
    const float share = (cosine - lamp.cos_outer) / (lamp.cos_inner - lamp.cos_outer);
    return share * share;  // as KHR_lights_punctual recommends
}

void beams_from_point(const world::Lamp& lamp, const Probe& probe, Beams& beams) {
    const glm::vec3 way = lamp.position - probe.position;
    const float squared = dot_of(way, way);
    if (!(squared > 0.0f)) return;
    const glm::vec3 direction = way / std::sqrt(squared);
    const float share =
        lamp.shape == world::LampShape::Spot ? spot_share(lamp, -dot_of(direction, lamp.direction)) : 1.0f;
    beams[0] = {.target = lamp.position,
                .light = lamp.intensity * (share * caught(probe, direction) / squared)};
}

void beams_from_sun(const world::Lamp& lamp, const Probe& probe, const rc::Box& bounds, Beams& beams) {
    const glm::vec3 middle = (bounds.min + bounds.max) * 0.5f;
    const float reach = length_of(bounds.max - bounds.min) + length_of(probe.position - middle);
    beams[0] = {.target = probe.position - lamp.direction * reach,
                .light = lamp.intensity * caught(probe, -lamp.direction)};
}

// Two unit vectors across a unit one. Any would do; these turn smoothly except where w.x overtakes w.z.
void make_frame(const glm::vec3& w, glm::vec3& u, glm::vec3& v) {
    const glm::vec3 side =
        std::abs(w.x) < std::abs(w.z) ? glm::vec3(0.0f, w.z, -w.y) : glm::vec3(-w.y, w.x, 0.0f);
    const float length = length_of(side);
    u = length > 0.0f ? side / length : glm::vec3(1.0f, 0.0f, 0.0f);
    v = cross_of(w, u);
}

// Over the cone in which the ball appears, evenly in solid angle: two cosines at the middles of their halves, each with
// two opposite azimuths. Their mean cosine to any normal is the cone's own, so the sum is pi L (r/d)^2 cos theta.
void beams_from_sphere(const world::Lamp& lamp, const Probe& probe, Beams& beams) {
    const glm::vec3 way = lamp.position - probe.position;
    const float distance = length_of(way);
    if (!(distance > lamp.radius)) {  // inside the bulb: light from half of all directions on any side
        beams[0] = {.target = probe.position, .light = lamp.intensity * kTwoPi};
        return;
    }
    const float sine = lamp.radius / distance;
    const float cosine = std::sqrt(1.0f - sine * sine);
    const float cap = sine * sine / (1.0f + cosine);  // 1 - cosine, without its cancellation
    const glm::vec3 w = way / distance;
    glm::vec3 u, v;
    make_frame(w, u, v);
    for (std::size_t i = 0; i < kStrata; ++i) {
        const float rest = (i < 2 ? 0.25f : 0.75f) * cap;  // 1 - cos of this beam to the axis
        const float off_axis = std::sqrt(rest * (2.0f - rest));
        const glm::vec3 aside = (i < 2 ? u : v) * (i % 2 == 0 ? off_axis : -off_axis);
        const glm::vec3 direction = w * (1.0f - rest) + aside;
        const float half_chord = std::sqrt(
            std::max(0.0f, lamp.radius * lamp.radius - distance * distance * (off_axis * off_axis)));
        const float to_surface = distance * (1.0f - rest) - half_chord;
        beams[i] = {.target = probe.position + direction * to_surface,
                    .light = lamp.intensity * (kTwoPi * cap / 4.0f * caught(probe, direction))};
    }
}

// A quarter of the face a beam; its light by 2 x 2 Gauss points, which cost no rays.
void beams_from_rect(const world::Lamp& lamp, const Probe& probe, Beams& beams) {
    constexpr float kGauss = 0.57735026919f;
    if (!(dot_of(probe.position - lamp.position, lamp.direction) > 0.0f)) return;
    const float patch = length_of(cross_of(lamp.half_u, lamp.half_v)) * 4.0f / 16.0f;
    for (std::size_t i = 0; i < kStrata; ++i) {
        const float s = (i % 2 == 0) ? -0.5f : 0.5f;
        const float t = (i < 2) ? -0.5f : 0.5f;
        float sum = 0.0f;
        for (int k = 0; k < 4; ++k) {
            const float su = s + (k % 2 == 0 ? -0.5f : 0.5f) * kGauss;
            const float tv = t + (k < 2 ? -0.5f : 0.5f) * kGauss;
            const glm::vec3 way = (lamp.position + lamp.half_u * su + lamp.half_v * tv) - probe.position;
            const float squared = dot_of(way, way);
            if (!(squared > 0.0f)) continue;
            const glm::vec3 direction = way / std::sqrt(squared);
            const float leaves = std::max(0.0f, -dot_of(direction, lamp.direction));
            sum += patch * leaves * caught(probe, direction) / squared;
        }
        beams[i] = {.target = lamp.position + lamp.half_u * s + lamp.half_v * t,
                    .light = lamp.intensity * sum};
    }
}

Beams beams_to(const world::Lamp& lamp, const rc::Scene& scene, const Probe& probe) {
    Beams beams{};
    if (lamp.shape != world::LampShape::Sun && length_of(lamp.position - probe.position) > lamp.range)
        return beams;
    switch (lamp.shape) {
        case world::LampShape::Point:
        case world::LampShape::Spot:
            beams_from_point(lamp, probe, beams);
            break;
        case world::LampShape::Sun:
            beams_from_sun(lamp, probe, scene.bounds(), beams);
            break;
        case world::LampShape::Sphere:
            beams_from_sphere(lamp, probe, beams);
            break;
        case world::LampShape::Rect:
            beams_from_rect(lamp, probe, beams);
            break;
    }
    return beams;
}

// Up to kBatch probes: all their beams in one batch of rays; only those that meet glass first are looked at again.
void light_batch(const world::Level& level, const rc::Scene& scene, const world::Lamp& lamp,
                 std::span<const Probe> probes, std::span<glm::vec3> out) {
    std::array<rc::Ray, kBatch * kStrata> rays;
    std::array<rc::Hit, kBatch * kStrata> hits;
    std::array<std::size_t, kBatch * kStrata> probe_of;
    std::array<Beam, kBatch * kStrata> beam_of;
    std::size_t count = 0;
    for (std::size_t p = 0; p < probes.size(); ++p) {
        out[p] = glm::vec3(0.0f);
        for (const Beam& beam : beams_to(lamp, scene, probes[p])) {
            if (beam.light == glm::vec3(0.0f)) continue;
            if (beam.target == probes[p].position) {  // nothing can stand in between
                out[p] += beam.light;
                continue;
            }
            rays[count] = {
                .origin = probes[p].position, .direction = beam.target - probes[p].position, .t_max = 1.0f};
            probe_of[count] = p;
            beam_of[count] = beam;
            ++count;
        }
    }
    rc::closest_hits(scene, std::span(rays).first(count), world::Light, std::span(hits).first(count));
    for (std::size_t i = 0; i < count; ++i) {
        glm::vec3& sum = out[probe_of[i]];
        if (hits[i].is_miss() || hits[i].instance == lamp.part) {
            sum += beam_of[i].light;
        } else if (lets_light_through(world::material_at(level, hits[i]))) {
            sum += beam_of[i].light *
                   light_transmittance(level, scene, rays[i].origin, beam_of[i].target, lamp.part);
        }
    }
}

}  // namespace

void irradiance_from_lamp(const world::Level& level, const rc::Scene& scene, std::size_t lamp,
                          std::span<const Probe> probes, std::span<glm::vec3> out) {
    EXPECTS(lamp < level.lamps.size() && probes.size() == out.size());
    for (std::size_t begin = 0; begin < probes.size(); begin += kBatch) {
        const std::size_t count = std::min(kBatch, probes.size() - begin);
        light_batch(level, scene, level.lamps[lamp], probes.subspan(begin, count), out.subspan(begin, count));
    }
}

void irradiance(const world::Level& level, const world::Snapshot& snapshot, std::span<const Probe> probes,
                std::span<glm::vec3> out) {
    EXPECTS(probes.size() == out.size());
    std::fill(out.begin(), out.end(), glm::vec3(0.0f));
    std::array<glm::vec3, kBatch> from_lamp;
    for (std::size_t begin = 0; begin < probes.size(); begin += kBatch) {
        const std::size_t count = std::min(kBatch, probes.size() - begin);
        for (std::size_t lamp = 0; lamp < level.lamps.size(); ++lamp) {
            if (!world::is_lamp_on(level, snapshot.state, lamp)) continue;
            light_batch(level, *snapshot.scene, level.lamps[lamp], probes.subspan(begin, count),
                        std::span(from_lamp).first(count));
            for (std::size_t p = 0; p < count; ++p) out[begin + p] += from_lamp[p];
        }
    }
}

}  // namespace gh::sense
