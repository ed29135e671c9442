// The part of a tile that decides which shadow rays are worth sending: one to every lamp that matters here, and one for
// all the faint ones together, each in its turn as often as it counts.
#include "base/det_math.h"
#include "render/tile.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace gh::render {

namespace {

constexpr float kMatters = 0.2f;  // of all light that arrives: more gets a shadow ray of its own
constexpr std::uint32_t kAmbientPurpose = 0xA0u << 16, kReachPurpose = 0xA1u << 16,
                        kChoicePurpose = 0xA2u << 16;

float brightest(const glm::vec3& c) {
    return std::max({c.x, c.y, c.z});
}

// The lamp's own coordinates of its middle, as the eye sees it.
glm::vec2 middle_of(const world::Lamp& lamp) {
    return lamp.shape == world::LampShape::Sphere ? glm::vec2(0.0f) : glm::vec2(0.5f);
}

// Around the normal, more of them where they count more.
glm::vec3 cosine_direction(const glm::vec3& normal, const glm::vec2& u) {
    const glm::vec3 any =
        std::abs(normal.y) < 0.9f ? glm::vec3(0.0f, 1.0f, 0.0f) : glm::vec3(1.0f, 0.0f, 0.0f);
    const glm::vec3 side = glm::normalize(glm::cross(any, normal));
    const glm::vec3 over = glm::cross(normal, side);
    const auto [sine, cosine] = det::sin_cos(kTwoPi * u.y);
    const float radius = std::sqrt(u.x);
    return side * (radius * cosine) + over * (radius * sine) + normal * std::sqrt(1.0f - u.x);
}

}  // namespace

void TileTracer::ask_for_shadows(const PathRay& path, const ShadingPoint& at) {
    if (!is_shared(path)) {
        for (const Arrival& arrival : arrivals_) {
            const bool is_ambient = arrival.lamp == world::kNoIndex;
            ask(path, at, arrival,
                is_ambient ? frame_.settings.ambient_samples : frame_.settings.shadow_samples);
        }
        return;
    }
    float total = 0.0f;
    for (const Arrival& arrival : arrivals_) {
        total += brightest(arrival.light);
        pixel(path).unshadowed += arrival.light;
    }
    const float least = kMatters * total;
    for (const Arrival& arrival : arrivals_) {
        if (brightest(arrival.light) >= least) ask(path, at, arrival, frame_.settings.shadow_samples);
    }
    ask_one_below(path, at, least);
}

// Neighbours choose others, so that together they ask for each as often as it counts.
void TileTracer::ask_one_below(const PathRay& path, const ShadingPoint& at, float least) {
    float total = 0.0f;
    for (const Arrival& arrival : arrivals_) {
        if (brightest(arrival.light) < least) total += brightest(arrival.light);
    }
    const auto number = static_cast<std::uint32_t>(sample_);
    float choice = samplers_[path.pixel].point(number, kChoicePurpose, path.depth).x * total;
    const Arrival* chosen = nullptr;
    for (const Arrival& arrival : arrivals_) {
        const float share = brightest(arrival.light);
        if (share >= least) continue;
        chosen = &arrival;  // rounding may run past the last one, which then is it
        choice -= share;
        if (choice < 0.0f) break;
    }
    if (chosen != nullptr)
        ask(path, at, {chosen->light * (total / brightest(chosen->light)), chosen->lamp}, 1);
}

void TileTracer::ask(const PathRay& path, const ShadingPoint& at, const Arrival& arrival, int count) {
    const Arrival part{arrival.light / static_cast<float>(count), arrival.lamp};
    for (int i = 0; i < count; ++i) {
        const auto number = static_cast<std::uint32_t>(sample_ * count + i);
        if (arrival.lamp == world::kNoIndex) {
            ask_around(path, at, part.light, number);
        } else {
            ask_lamp(path, at, part, number);
        }
    }
}

void TileTracer::ask_lamp(const PathRay& path, const ShadingPoint& at, const Arrival& arrival,
                          std::uint32_t number) {
    const world::Lamp& lamp = frame_.view.level.lamps[arrival.lamp];
    const glm::vec3& position = at.surface.position;
    // What is seen in a mirror's glimmer is not shared; one look at the middle is better than noise.
    const bool looks_about = path.is_leading || frame_.settings.samples_per_pixel > 1;
    const glm::vec2 u =
        looks_about ? samplers_[path.pixel].point(number, arrival.lamp, path.depth) : middle_of(lamp);
    glm::vec3 target = lamp_point(lamp, position, u);
    // What of the lamp is below the horizon is not in the light; a point there says nothing about the rest.
    const auto is_below = [&](const glm::vec3& p) { return glm::dot(p - position, at.geometric) <= 0.0f; };
    if (lamp.shape == world::LampShape::Sun) {
        target = position - lamp.direction;
    } else if (is_below(target)) {
        target = lamp.position;
    }
    if (is_below(target)) {
        if (is_shared(path)) pixel(path).tried += arrival.light;
        return;
    }
    settle(path, shadow_ray(lamp, frame_.view.prepared.bulbs[arrival.lamp], at.surface, target),
           arrival.light);
}

void TileTracer::ask_around(const PathRay& path, const ShadingPoint& at, const glm::vec3& light,
                            std::uint32_t number) {
    const PixelSampler& sampler = samplers_[path.pixel];
    const glm::vec3& cell = frame_.view.prepared.ambient.grid.spacing;
    const float reach = 0.5f * std::min({cell.x, cell.y, cell.z});
    glm::vec3 way = cosine_direction(at.normal, sampler.point(number, kAmbientPurpose, path.depth));
    const float height = glm::dot(way, at.geometric);
    if (height < 0.01f) way += at.geometric * (0.01f - height);
    // A reach between nothing and all of it: what is near darkens more.
    const float share = sampler.point(number, kReachPurpose, path.depth).x;
    settle(path, rc::spawn_ray(at.surface, way, reach * share), light);
}

// Without a ray there is nothing that could stand in the way.
void TileTracer::settle(const PathRay& path, const std::optional<rc::Ray>& ray, const glm::vec3& light) {
    const bool shares = is_shared(path);
    PixelLight& out = pixel(path);
    if (shares) out.tried += light;
    if (ray) {
        shadow_rays_.push_back(*ray);
        shadows_.push_back({light, path.pixel, shares});
    } else {
        (shares ? out.arrived : out.clean) += light;
    }
}

}  // namespace gh::render
