#include "render/gleams.h"

#include "base/contracts.h"
#include "base/det_math.h"
#include "base/random.h"
#include "render/emitters.h"
#include "render/light_math.h"
#include "render/sane.h"
#include "render/scene_view.h"
#include "render/shading_point.h"
#include "world/layers.h"

#include "raycore/query.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace gh::render {

namespace {

constexpr int kRaysALamp = 256;
constexpr int kLooksACell = 12;  // at each gleam that might be seen
constexpr float kNeighbourShare =
    0.2f;  // of what a cell sees counts for those around it, which may see it as well
constexpr float kLeastShare = 0.03f;  // of a lamp's light that has to come back out of a ball worth aiming at
constexpr float kWidest = 1.0f / 24.0f;  // radius of a gleam, of the level's size
constexpr float kFaintestShare = 0.01f;  // gleams weaker than that share of a cell's strongest are left out
constexpr float kLeastHeight = 0.1f;     // at which a gleam low over the horizon still counts

// Something small that shines all around.
struct Source {
    std::uint32_t part = world::kNoIndex, lamp = world::kNoIndex;
    glm::vec3 centre{0.0f};
    float radius = 0.0f;  // rays start there
    float power = 0.0f;   // W
};

// A place that a lamp lights.
struct LitPlace {
    rc::SurfacePoint at;
    glm::vec3 normal{0.0f};  // towards the lamp
    float distance = 0.0f;
    float power = 0.0f;  // W that come back from it
};

struct FoundGleam {
    Gleam gleam;
    std::vector<LitPlace> places;
    float power = 0.0f;
};

std::vector<Source> small_sources(const SceneView& view) {
    std::vector<Source> sources;
    for (const Emitter& emitter : view.prepared.emitters) {
        if (emitter.kind != EmitterKind::Bulb) continue;
        const glm::mat4x3& to_world = view.snapshot.scene->instance(emitter.part).world_from_instance;
        const world::Mesh& mesh = view.level.meshes[view.level.parts[emitter.part].mesh];
        const auto& material = view.level.materials[mesh.materials[emitter.primitives[0]]];
        const float radius = emitter.radius * glm::length(linear_part(to_world)[0]);
        const float power = 4.0f * kPi * kPi * radius * radius * mean(sane_light(material.emission));
        sources.push_back({.part = emitter.part,
                           .centre = to_world * glm::vec4(emitter.centre, 1.0f),
                           .radius = radius,
                           .power = power});
    }
    for (std::uint32_t i = 0; i < view.level.lamps.size(); ++i) {
        const world::Lamp& lamp = view.level.lamps[i];
        if (lamp.part != world::kNoIndex) continue;
        const float radiant = mean(sane_light(lamp.intensity));
        if (lamp.shape == world::LampShape::Point)
            sources.push_back({.lamp = i, .centre = lamp.position, .power = 4.0f * kPi * radiant});
        if (lamp.shape == world::LampShape::Sphere)
            sources.push_back({.lamp = i,
                               .centre = lamp.position,
                               .radius = lamp.radius,
                               .power = 4.0f * kPi * kPi * lamp.radius * lamp.radius * radiant});
    }
    return sources;
}

// What a lamp lights, nearest first.
std::vector<LitPlace> lit_places(const SceneView& view, const Source& source) {
    constexpr float kGoldenAngle = 2.39996322972865332f;
    std::vector<LitPlace> places;
    for (int i = 0; i < kRaysALamp; ++i) {
        const float y = 1.0f - 2.0f * (static_cast<float>(i) + 0.5f) / kRaysALamp;
        const auto [sine, cosine] = det::sin_cos(kGoldenAngle * static_cast<float>(i));
        const float ring = std::sqrt(1.0f - y * y);
        const glm::vec3 way(ring * cosine, y, ring * sine);
        const rc::Ray ray{.origin = source.centre + way * source.radius, .direction = way};
        const auto hit = rc::closest_hit(*view.snapshot.scene, ray, world::Light);
        if (!hit || hit->instance == source.part) continue;
        const ShadingPoint at = shading_point(view, ray, *hit, 0.0f, 1.0f);
        if (at.material->transmission > 0.0f) continue;
        const float albedo = mean(sane_colour(at.base_color));
        places.push_back(
            {at.surface, at.geometric, source.radius + hit->t, albedo * source.power / kRaysALamp});
    }
    std::stable_sort(places.begin(), places.end(),
                     [](const LitPlace& a, const LitPlace& b) { return a.distance < b.distance; });
    return places;
}

// The most power for its radius; nothing if that is little, or lies far off.
FoundGleam gleam_of(const SceneView& view, const Source& source) {
    FoundGleam found;
    found.places = lit_places(view, source);
    const float widest = kWidest * glm::distance(view.level.bounds.min, view.level.bounds.max);
    std::size_t kept = 0;
    float sum = 0.0f, best = 0.0f;
    for (std::size_t i = 0; i < found.places.size() && found.places[i].distance < widest; ++i) {
        sum += found.places[i].power;
        if (!(sum > best * found.places[i].distance)) continue;
        best = sum / found.places[i].distance;
        found.power = sum;
        kept = i + 1;
    }
    found.places.resize(kept);
    if (!(found.power > kLeastShare * source.power)) return {};
    glm::vec3 low = found.places[0].at.position, high = low;
    for (const LitPlace& place : found.places) {
        low = glm::min(low, place.at.position);
        high = glm::max(high, place.at.position);
    }
    BallShape ball{0.5f * (low + high), 0.0f};
    for (const LitPlace& place : found.places)
        ball.radius = std::max(ball.radius, glm::distance(place.at.position, ball.centre));
    ball.radius *= 1.05f;  // the places are few of many
    found.gleam = {ball, source.part, source.lamp};
    return found;
}

// Mean irradiance that the gleam gives in the cell, by looks at some of its places.
float weight_in_cell(const SceneView& view, const Grid& grid, const glm::ivec3& cell, const FoundGleam& found,
                     Random& random) {
    float sum = 0.0f;
    for (int i = 0; i < kLooksACell; ++i) {
        const glm::vec3 inside(random.unit(), random.unit(), random.unit());
        const glm::vec3 from = grid.origin + grid.spacing * (glm::vec3(cell) + inside);
        const LitPlace& place = found.places[random.below(static_cast<std::uint32_t>(found.places.size()))];
        const glm::vec3 way = from - place.at.position;
        const float distance2 = glm::dot(way, way), facing = glm::dot(way, place.normal);
        if (!(facing > 0.0f) || !(distance2 > 0.0f)) continue;
        if (rc::any_hit(*view.snapshot.scene, rc::spawn_ray_to(place.at, from), world::Light)) continue;
        const float kept_off2 = std::max(distance2, found.gleam.ball.radius * found.gleam.ball.radius);
        sum += place.power * facing / (std::sqrt(distance2) * kPi * kept_off2);
    }
    return sum * static_cast<float>(found.places.size()) / kLooksACell;
}

bool is_stronger(const SeenGleam& a, const SeenGleam& b) {
    return a.weight != b.weight ? a.weight > b.weight : a.gleam < b.gleam;
}

// The strongest few that might be seen from the cell are looked at.
std::vector<SeenGleam> seen_from(const SceneView& view, const Grid& grid, std::size_t cell_index,
                                 std::span<const FoundGleam> found) {
    const glm::ivec3 cell = grid.cell_from_index(cell_index);
    const glm::vec3 middle = grid.origin + grid.spacing * (glm::vec3(cell) + 0.5f);
    std::vector<SeenGleam> near;
    for (std::uint32_t i = 0; i < found.size(); ++i) {
        const glm::vec3 way = found[i].gleam.ball.centre - middle;
        near.push_back(
            {i, found[i].power / std::max(glm::dot(way, way), glm::dot(grid.spacing, grid.spacing))});
    }
    constexpr std::size_t kLookedAt = 2 * GleamGuide::kMost;
    const std::size_t looked_at = std::min(near.size(), kLookedAt);
    std::partial_sort(near.begin(), near.begin() + static_cast<std::ptrdiff_t>(looked_at), near.end(),
                      is_stronger);
    near.resize(looked_at);
    Random random(hash_u32(static_cast<std::uint32_t>(cell_index), 0x61EA));
    for (SeenGleam& seen : near) seen.weight = weight_in_cell(view, grid, cell, found[seen.gleam], random);
    return near;
}

// Adds to `all` what a cell sees, each gleam once, at the most it counts anywhere.
void merge_seen(const std::vector<SeenGleam>& in_cell, float share, std::vector<SeenGleam>& all) {
    for (const SeenGleam& seen : in_cell) {
        const float weight = seen.weight * share;
        const auto known = std::find_if(all.begin(), all.end(), [&](const SeenGleam& known_one) {
            return known_one.gleam == seen.gleam;
        });
        if (known == all.end()) {
            all.push_back({seen.gleam, weight});
        } else {
            known->weight = std::max(known->weight, weight);
        }
    }
}

// What the cell sees itself, and some of what its 26 neighbours do: few looks find little through a narrow opening.
std::vector<SeenGleam> seen_around(const Grid& grid, std::size_t cell_index,
                                   const std::vector<std::vector<SeenGleam>>& of_cell) {
    const glm::ivec3 cell = grid.cell_from_index(cell_index);
    std::vector<SeenGleam> all;
    const glm::ivec3 low = glm::max(cell - 1, glm::ivec3(0)), high = glm::min(cell + 1, grid.cells - 1);
    for (int z = low.z; z <= high.z; ++z) {
        for (int y = low.y; y <= high.y; ++y) {
            for (int x = low.x; x <= high.x; ++x) {
                const std::size_t other = grid.cell_index({x, y, z});
                merge_seen(of_cell[other], other == cell_index ? 1.0f : kNeighbourShare, all);
            }
        }
    }
    std::sort(all.begin(), all.end(), is_stronger);
    all.resize(std::min(all.size(), GleamGuide::kMost));
    while (!all.empty() && !(all.back().weight > kFaintestShare * all.front().weight)) all.pop_back();
    return all;
}

}  // namespace

std::span<const SeenGleam> Gleams::at(const glm::vec3& position) const {
    if (begin.empty()) return {};
    const std::size_t cell = grid.cell_index(grid.cell_at(position));
    return std::span(seen).subspan(begin[cell], begin[cell + 1] - begin[cell]);
}

Gleams find_gleams(const SceneView& view, const Grid& grid, const Jobs& jobs) {
    const std::vector<Source> sources = small_sources(view);
    std::vector<FoundGleam> all(sources.size());
    jobs.run(all.size(), [&](std::size_t i, int) { all[i] = gleam_of(view, sources[i]); });
    std::vector<FoundGleam> found;
    for (FoundGleam& gleam : all) {
        if (gleam.power > 0.0f && !gleam.places.empty()) found.push_back(std::move(gleam));
    }
    Gleams gleams{.grid = grid, .gleams = {}, .begin = {}, .seen = {}};
    if (found.empty()) return gleams;
    for (const FoundGleam& gleam : found) gleams.gleams.push_back(gleam.gleam);
    std::vector<std::vector<SeenGleam>> of_cell(grid.cell_count());
    jobs.run(of_cell.size(),
             [&](std::size_t cell, int) { of_cell[cell] = seen_from(view, grid, cell, found); });
    gleams.begin.push_back(0);
    for (std::size_t cell = 0; cell < of_cell.size(); ++cell) {
        const std::vector<SeenGleam> seen = seen_around(grid, cell, of_cell);
        gleams.seen.insert(gleams.seen.end(), seen.begin(), seen.end());
        gleams.begin.push_back(static_cast<std::uint32_t>(gleams.seen.size()));
    }
    return gleams;
}

GleamGuide::GleamGuide(const Gleams& gleams, std::span<const std::uint8_t> is_on, const glm::vec3& position,
                       const glm::vec3& normal) {
    float total = 0.0f;
    for (const SeenGleam& seen : gleams.at(position)) {
        if (is_on[seen.gleam] == 0) continue;
        const BallShape& ball = gleams.gleams[seen.gleam].ball;
        const glm::vec3 way = ball.centre - position;
        const float distance2 = glm::dot(way, way), radius2 = ball.radius * ball.radius;
        // From within, or all but, every direction finds it.
        if (!(distance2 > 1.2f * radius2)) continue;
        const float distance = std::sqrt(distance2);
        float weight = seen.weight;
        if (normal != glm::vec3(0.0f)) {
            const float height = glm::dot(normal, way) + ball.radius;
            if (!(height > 0.0f)) continue;
            weight *= std::clamp(height / distance, kLeastHeight, 1.0f);
        }
        const float sin2 = radius2 / distance2;
        cones_[count_++] = {way / distance, sin2 / (1.0f + std::sqrt(1.0f - sin2)), weight};
        total += weight;
    }
    for (std::size_t i = 0; i < count_; ++i) cones_[i].probability /= total;
}

glm::vec3 GleamGuide::pick(float u_gleam, const glm::vec2& u) const {
    EXPECTS(count_ > 0);
    std::size_t i = 0;
    while (i + 1 < count_ && u_gleam >= cones_[i].probability) u_gleam -= cones_[i++].probability;
    return basis_around(cones_[i].axis).world_from_local(uniform_cone(u, cones_[i].one_minus_cos));
}

float GleamGuide::density(const glm::vec3& direction) const {
    float sum = 0.0f;
    for (std::size_t i = 0; i < count_; ++i) {
        // By the chord, which keeps its digits in narrow cones; a hair wider, so that what was picked is within.
        const glm::vec3 off = direction - cones_[i].axis;
        if (0.5f * glm::dot(off, off) <= cones_[i].one_minus_cos * (1.0f + 1e-5f))
            sum += cones_[i].probability / (kTwoPi * cones_[i].one_minus_cos);
    }
    return sum;
}

}  // namespace gh::render
