// The part of a tile that decides which shadow rays are worth sending.
#include "base/det_math.h"
#include "base/random.h"
#include "render/colour.h"
#include "render/tile.h"
#include "render/tile_blend.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <optional>

namespace gh::render {

namespace {

// What stands near is lit about as this is, and gives that share of it back: corners are dark, not black.
constexpr float kBounced = 0.4f;
constexpr float kSpeaksForAll = 0.2f;  // of all light that is expected: in a glimmer, lamps that give more
// Of all light that is expected: lamps that give more get shadow rays of their own.
constexpr float kMatters = 0.2f;
constexpr float kMattersToMany = 0.05f;  // from a pixel that speaks for those around it
constexpr float kHardlyOpen = 1.0f / 32.0f;
constexpr float kLeastDoubt = 0.02f;
constexpr std::uint32_t kAmbientPurpose = 0xA0u << 16, kReachPurpose = 0xA1u << 16,
                        kChoicePurpose = 0xA2u << 16;

// Where in the lamp's own coordinates what is seen in a glimmer looks: neighbours do not share what they find there, so
// the pattern that makes them differ would show as a grid of dots. They all look at the same places, first at the middle.
glm::vec2 glimmer_point(const world::Lamp& lamp, std::uint32_t number) {
    if (number == 0) return lamp.shape == world::LampShape::Sphere ? glm::vec2(0.0f) : glm::vec2(0.5f);
    return sobol_point(number, 0x61133Eu);
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

float TileTracer::Arrival::expected() const {
    return brightest(light) * open;
}

// What glimmers in a polished floor counts little and is shared by nobody: the lamps that matter speak for all.
void TileTracer::ask_for_brightest(const SeenSurface& surface) {
    glm::vec3 total(0.0f), asked(0.0f);
    float sum = 0.0f, most = 0.0f;
    for (const Arrival& arrival : arrivals_) {
        total += arrival.light * arrival.open;
        sum += arrival.expected();
        most = std::max(most, arrival.expected());
    }
    const float least = std::min(most, kSpeaksForAll * sum);
    for (const Arrival& arrival : arrivals_) {
        if (arrival.expected() >= least) asked += arrival.light * arrival.open;
    }
    const glm::vec3 scale = ratio(total, asked, 1.0f);
    for (const Arrival& arrival : arrivals_) {
        if (arrival.expected() >= least) ask(surface, {arrival.light * scale, arrival.lamp, arrival.open}, 1);
    }
}

// To every lamp of which a share of all that is expected comes, twice to those of four times that. A pixel that speaks
// for those around it asks for smaller shares, and twice as often for lamps that the tile sees in part.
void TileTracer::ask_for_shares(const SeenSurface& surface, bool speaks_for_many) {
    SharedLight& found = main_.found_at(surface.path.pixel);
    float total = 0.0f;
    for (const Arrival& arrival : arrivals_) {
        total += arrival.expected();
        found.unshadowed += arrival.light;
    }
    const float least = (speaks_for_many ? kMattersToMany : kMatters) * total;
    for (const Arrival& arrival : arrivals_) {
        const float share = arrival.expected();
        if (share < least) continue;
        int count = frame_.settings.shadow_samples;
        if (share >= 4.0f * least) count *= 2;
        if (speaks_for_many && arrival.open > kHardlyOpen && arrival.open < 1.0f - kHardlyOpen) count *= 2;
        ask(surface, arrival, count);
    }
    estimate_below(surface, least);
}

// Of the others what is expected is taken to arrive, and one look at one of them says how wrong that is: a control
// variate, on average exactly what gets through whatever was expected. Neighbours choose others, so that together they
// ask for each as often as it is in doubt.
void TileTracer::estimate_below(const SeenSurface& surface, float least) {
    const auto doubt = [](const Arrival& arrival) {
        const float deviation = std::sqrt(arrival.open * (1.0f - arrival.open));
        return brightest(arrival.light) * std::max(deviation, kLeastDoubt);
    };
    float total = 0.0f;
    glm::vec3 expected(0.0f);
    for (const Arrival& arrival : arrivals_) {
        if (arrival.expected() >= least) continue;
        total += doubt(arrival);
        expected += arrival.light * arrival.open;
    }
    const auto number = static_cast<std::uint32_t>(sample_);
    const PathRay& path = surface.path;
    float choice = samplers_[path.pixel].point(number, kChoicePurpose, path.depth).x * total;
    const Arrival* chosen = nullptr;
    for (const Arrival& arrival : arrivals_) {
        if (arrival.expected() >= least) continue;
        chosen = &arrival;  // rounding may run past the last one, which then is it
        choice -= doubt(arrival);
        if (choice < 0.0f) break;
    }
    if (chosen == nullptr) return;
    const glm::vec3 light = chosen->light * (total / doubt(*chosen));
    arrive(path, expected - light * chosen->open);
    ask(surface, {light, chosen->lamp, chosen->open}, 1);
}

void TileTracer::ask(const SeenSurface& surface, const Arrival& arrival, int count) {
    const Arrival part{arrival.light / static_cast<float>(count), arrival.lamp, arrival.open};
    for (int i = 0; i < count; ++i) {
        const auto number = static_cast<std::uint32_t>(sample_ * count + i);
        if (arrival.lamp != world::kNoIndex) {
            ask_lamp(surface, part, number);
        } else if (frame_.settings.ambient_samples > 0) {
            ask_around(surface, part.light, number);
        } else {
            arrive(surface.path, part.light);
        }
    }
}

void TileTracer::ask_lamp(const SeenSurface& surface, const Arrival& arrival, std::uint32_t number) {
    const PathRay& path = surface.path;
    const ShadingPoint& at = surface.at;
    const world::Lamp& lamp = frame_.view.level.lamps[arrival.lamp];
    const glm::vec3& position = at.surface.position;
    const glm::vec2 u = path.is_leading ? samplers_[path.pixel].point(number, arrival.lamp, path.depth)
                                        : glimmer_point(lamp, number);
    glm::vec3 target = lamp_point(lamp, position, u);
    // What of the lamp is below the horizon is not in the light; a point there says nothing about the rest.
    const auto is_below = [&](const glm::vec3& p) { return glm::dot(p - position, at.geometric) <= 0.0f; };
    if (lamp.shape == world::LampShape::Sun) {
        target = position - lamp.direction;
    } else if (is_below(target)) {
        target = lamp.position;
    }
    if (is_below(target)) return;
    const std::optional<rc::Ray> way =
        shadow_ray(lamp, frame_.view.prepared.bulbs[arrival.lamp], at.surface, target);
    if (way) {
        look(path, *way, arrival.light, arrival.lamp);
    } else {
        arrive(path, arrival.light);
    }
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
    arrive(path, light * kBounced);
    look(path, rc::spawn_ray(at.surface, way, reach * share), light * (1.0f - kBounced), world::kNoIndex);
}

// Nothing stands in its way.
void TileTracer::arrive(const PathRay& path, const glm::vec3& light) {
    light_of(path.pixel, share_of(path)) += light;
}

void TileTracer::look(const PathRay& path, const rc::Ray& ray, const glm::vec3& light, std::uint32_t lamp) {
    shadow_rays_.push_back(ray);
    shadows_.push_back({light, lamp, path.pixel, share_of(path)});
}

}  // namespace gh::render
