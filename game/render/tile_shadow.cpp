// The part of a tile that decides which shadow rays are worth sending.
#include "base/det_math.h"
#include "render/tile.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace gh::render {

namespace {

// What stands near is lit about as this is, and gives that share of it back: corners are dark, not black.
constexpr float kBounced = 0.4f;
constexpr float kSpeaksForAll = 0.2f;  // of all light that arrives: in a glimmer, lamps that give more
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

// Every pixel for itself: a ray to everything.
void TileTracer::ask_for_all(const SeenSurface& surface) {
    for (const Arrival& arrival : arrivals_) {
        const bool is_ambient = arrival.lamp == world::kNoIndex;
        ask(surface, arrival, is_ambient ? frame_.settings.ambient_samples : frame_.settings.shadow_samples);
    }
}

// What glimmers in a polished floor counts little and is shared by nobody: the lamps that matter speak for all.
void TileTracer::ask_for_brightest(const SeenSurface& surface) {
    glm::vec3 total(0.0f), asked(0.0f);
    float most = 0.0f;
    for (const Arrival& arrival : arrivals_) {
        total += arrival.light;
        most = std::max(most, brightest(arrival.light));
    }
    const float least = std::min(most, kSpeaksForAll * brightest(total));
    for (const Arrival& arrival : arrivals_) {
        if (brightest(arrival.light) >= least) asked += arrival.light;
    }
    const glm::vec3 scale(asked.x > 0.0f ? total.x / asked.x : 1.0f,
                          asked.y > 0.0f ? total.y / asked.y : 1.0f,
                          asked.z > 0.0f ? total.z / asked.z : 1.0f);
    for (const Arrival& arrival : arrivals_) {
        if (brightest(arrival.light) >= least) ask(surface, {arrival.light * scale, arrival.lamp}, 1);
    }
}

// To every lamp that gives at least the share `matters` of the light, twice to those that give four times that, and one
// ray for all the faint ones together.
void TileTracer::ask_for_shares(const SeenSurface& surface, float matters) {
    SharedLight& found = main_.found_at(surface.path.pixel);
    float total = 0.0f;
    for (const Arrival& arrival : arrivals_) {
        total += brightest(arrival.light);
        found.unshadowed += arrival.light;
    }
    const float least = matters * total;
    for (const Arrival& arrival : arrivals_) {
        const float share = brightest(arrival.light);
        if (share < least) {
            // It takes no ray to know that some of it arrives. Left to chance among lamps that are all hidden, it
            // would be missed: a dark room next to bright ones would be black.
            if (arrival.lamp == world::kNoIndex) settle(surface.path, std::nullopt, arrival.light);
            continue;
        }
        ask(surface, arrival, frame_.settings.shadow_samples * (share >= 4.0f * least ? 2 : 1));
    }
    ask_one_below(surface, least);
}

// Neighbours choose others, so that together they ask for each as often as it counts.
void TileTracer::ask_one_below(const SeenSurface& surface, float least) {
    const auto is_left_to_chance = [&](const Arrival& arrival) {
        return arrival.lamp != world::kNoIndex && brightest(arrival.light) < least;
    };
    float total = 0.0f;
    for (const Arrival& arrival : arrivals_) {
        if (is_left_to_chance(arrival)) total += brightest(arrival.light);
    }
    const auto number = static_cast<std::uint32_t>(sample_);
    const PathRay& path = surface.path;
    float choice = samplers_[path.pixel].point(number, kChoicePurpose, path.depth).x * total;
    const Arrival* chosen = nullptr;
    for (const Arrival& arrival : arrivals_) {
        if (!is_left_to_chance(arrival)) continue;
        chosen = &arrival;  // rounding may run past the last one, which then is it
        choice -= brightest(arrival.light);
        if (choice < 0.0f) break;
    }
    if (chosen != nullptr)
        ask(surface, {chosen->light * (total / brightest(chosen->light)), chosen->lamp}, 1);
}

void TileTracer::ask(const SeenSurface& surface, const Arrival& arrival, int count) {
    const Arrival part{arrival.light / static_cast<float>(count), arrival.lamp};
    for (int i = 0; i < count; ++i) {
        const auto number = static_cast<std::uint32_t>(sample_ * count + i);
        if (arrival.lamp != world::kNoIndex) {
            ask_lamp(surface, part, number);
        } else if (frame_.settings.ambient_samples > 0) {
            ask_around(surface, part.light, number);
        } else {
            settle(surface.path, std::nullopt, part.light);
        }
    }
}

void TileTracer::ask_lamp(const SeenSurface& surface, const Arrival& arrival, std::uint32_t number) {
    const PathRay& path = surface.path;
    const ShadingPoint& at = surface.at;
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
        if (share_of(path) == Share::Neighbours) main_.found_at(path.pixel).tried += arrival.light;
        return;
    }
    settle(path, shadow_ray(lamp, frame_.view.prepared.bulbs[arrival.lamp], at.surface, target),
           arrival.light);
}

void TileTracer::ask_around(const SeenSurface& surface, const glm::vec3& light, std::uint32_t number) {
    const PathRay& path = surface.path;
    const ShadingPoint& at = surface.at;
    const PixelSampler& sampler = samplers_[path.pixel];
    const glm::vec3& cell = frame_.view.prepared.ambient.grid.spacing;
    const float reach = 0.5f * std::min({cell.x, cell.y, cell.z});
    glm::vec3 way = cosine_direction(at.normal, sampler.point(number, kAmbientPurpose, path.depth));
    const float height = glm::dot(way, at.geometric);
    if (height < 0.01f) way += at.geometric * (0.01f - height);
    // A reach between nothing and all of it: what is near darkens more.
    const float share = sampler.point(number, kReachPurpose, path.depth).x;
    settle(path, std::nullopt, light * kBounced);
    settle(path, rc::spawn_ray(at.surface, way, reach * share), light * (1.0f - kBounced));
}

// Without a ray there is nothing that could stand in the way.
void TileTracer::settle(const PathRay& path, const std::optional<rc::Ray>& ray, const glm::vec3& light) {
    const Share share = share_of(path);
    if (share == Share::Neighbours) main_.found_at(path.pixel).tried += light;
    if (ray) {
        shadow_rays_.push_back(*ray);
        shadows_.push_back({light, path.pixel, share});
    } else {
        light_of(path.pixel, share) += light;
    }
}

}  // namespace gh::render
