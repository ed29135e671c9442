#include "sense/hearing.h"

#include "base/det_math.h"
#include "base/vectors.h"
#include "sense/walls.h"

#include <algorithm>
#include <cmath>

namespace gh::sense {
namespace {

constexpr std::array<float, world::kBands> kFrequency = {250.0f, 1000.0f, 4000.0f};  // Hz
constexpr float kNearest = 0.1f;           // metres: a source is a thing with a size
constexpr float kEdgeLoss = 5.0f;          // dB, of an edge that just touches the straight line
constexpr float kLargestEdgeLoss = 24.0f;  // dB: more is not measured in the open
constexpr float kEdgeMargin = 0.06f;       // metres that a bent way keeps off the box of what it passes
constexpr float kLn10 = 2.30258509f;

float spreading_db(float metres) {
    return -20.0f * det::log10(std::max(metres, kNearest));
}

// One way a sound may take.
struct Way {
    BandDb db{};
    float metres = 0.0f;
    glm::vec3 arrives_from{0.0f};  // the last point before the ear
};

float power_of(const BandDb& db) {
    float power = 0.0f;
    for (const float level : db) power += det::exp(level * (kLn10 / 10.0f));
    return power / static_cast<float>(world::kBands);
}

void subtract(const BandDb& loss, BandDb& db) {
    for (std::size_t band = 0; band < db.size(); ++band) db[band] -= loss[band];
}

// The loudest so far, band by band, and which way is the loudest as a whole.
struct Loudest {
    BandDb db;
    float power = -1.0f;
    float metres = 0.0f;
    glm::vec3 arrives_from{0.0f};

    Loudest() { db.fill(kSilenceDb); }
    void offer(const Way& way) {
        for (std::size_t band = 0; band < db.size(); ++band) db[band] = std::max(db[band], way.db[band]);
        const float offered = power_of(way.db);
        if (!(offered > power)) return;
        power = offered;
        metres = way.metres;
        arrives_from = way.arrives_from;
    }
    // Whether a way that is at best this loud could add anything.
    [[nodiscard]] bool may_gain_from(const BandDb& bound) const {
        for (std::size_t band = 0; band < db.size(); ++band) {
            if (bound[band] > db[band]) return true;
        }
        return false;
    }
};

// 1/r along corners[0..n], and an edge's loss at each one between the ends; without what stands in the legs.
BandDb bent_db(std::span<const glm::vec3> points) {
    float metres = 0.0f;
    for (std::size_t i = 1; i < points.size(); ++i) metres += length_of(points[i] - points[i - 1]);
    BandDb db;
    db.fill(spreading_db(metres));
    for (std::size_t i = 1; i + 1 < points.size(); ++i) {
        const float extra = length_of(points[i] - points[i - 1]) + length_of(points[i + 1] - points[i]) -
                            length_of(points[i + 1] - points[i - 1]);
        for (std::size_t band = 0; band < db.size(); ++band) {
            db[band] -= barrier_loss_db(std::max(0.0f, extra), kFrequency[band]);
        }
    }
    return db;
}

void offer_bent_way(const world::Level& level, const rc::Scene& scene, std::span<const glm::vec3> points,
                    Loudest& loudest) {
    Way way;
    way.db = bent_db(points);
    if (!loudest.may_gain_from(way.db)) return;
    for (std::size_t i = 1; i < points.size(); ++i) {
        subtract(walls_between(level, scene, points[i - 1], points[i]).loss_db, way.db);
        way.metres += length_of(points[i] - points[i - 1]);
    }
    way.arrives_from = points[points.size() - 2];
    loudest.offer(way);
}

// The point of an edge a-b that lies nearest to the line from-to: there the way over the edge is nearly the shortest.
glm::vec3 nearest_on_edge(const glm::vec3& a, const glm::vec3& b, const glm::vec3& from,
                          const glm::vec3& to) {
    const glm::vec3 edge = b - a;
    const glm::vec3 line = to - from;
    const glm::vec3 gap = a - from;
    const float ee = dot_of(edge, edge), el = dot_of(edge, line), ll = dot_of(line, line);
    const float determinant = ee * ll - el * el;
    if (!(determinant > 0.0f)) return (a + b) * 0.5f;
    const float s = (el * dot_of(line, gap) - ll * dot_of(edge, gap)) / determinant;
    return a + edge * std::clamp(s, 0.0f, 1.0f);
}

// Corner `i` (bits: x, y, z) of an instance's box in the world, a margin off on every side.
glm::vec3 box_corner(const rc::Instance& instance, unsigned i) {
    const rc::Box box = instance.blas->bounds();
    glm::vec3 corner = instance.world_from_instance[3];
    for (glm::length_t axis = 0; axis < 3; ++axis) {
        const glm::vec3& column = instance.world_from_instance[axis];
        const float scale = length_of(column);
        const float margin = scale > 0.0f ? kEdgeMargin / scale : 0.0f;
        const bool is_far = ((i >> axis) & 1u) != 0;
        corner += column * (is_far ? box.max[axis] + margin : box.min[axis] - margin);
    }
    return corner;
}

// Over each of the twelve edges of the part's box.
void offer_ways_around(const world::Level& level, const rc::Scene& scene, std::uint32_t part,
                       const glm::vec3& source, const glm::vec3& ear, Loudest& loudest) {
    const rc::Instance& instance = scene.instance(part);
    for (unsigned axis = 0; axis < 3; ++axis) {
        for (unsigned i = 0; i < 8; ++i) {
            if (((i >> axis) & 1u) != 0) continue;
            const glm::vec3 edge_point =
                nearest_on_edge(box_corner(instance, i), box_corner(instance, i | (1u << axis)), source, ear);
            const std::array<glm::vec3, 3> points = {source, edge_point, ear};
            offer_bent_way(level, scene, points, loudest);
        }
    }
}

void offer_detour(const world::Level& level, const rc::Scene& scene, const glm::vec3& source,
                  const glm::vec3& ear, std::span<const glm::vec3> detour, Loudest& loudest) {
    constexpr std::size_t kMaxCorners = 32;  // as many as a guard's path has
    std::array<glm::vec3, kMaxCorners + 2> points;
    if (detour.empty() || detour.size() > kMaxCorners) return;
    points[0] = source;
    std::copy(detour.begin(), detour.end(), points.begin() + 1);
    points[detour.size() + 1] = ear;
    offer_bent_way(level, scene, std::span(points).first(detour.size() + 2), loudest);
}

}  // namespace

float barrier_loss_db(float extra_metres, float frequency) {
    const float fresnel_number = 2.0f * extra_metres * frequency / world::kSpeedOfSound;
    const float x = std::sqrt(kTwoPi * fresnel_number);
    if (x < 1e-3f) return kEdgeLoss;  // x / tanh x is 1 within 3e-7
    const float e = det::exp(-2.0f * x);
    const float tanh = (1.0f - e) / (1.0f + e);
    return std::min(kLargestEdgeLoss, kEdgeLoss + 20.0f * det::log10(x / tanh));
}

Transmission hear(const world::Level& level, const rc::Scene& scene, const glm::vec3& source,
                  const glm::vec3& ear, std::span<const glm::vec3> detour) {
    const Walls walls = walls_between(level, scene, source, ear);
    Way straight;
    straight.metres = length_of(ear - source);
    straight.arrives_from = source;
    straight.db.fill(spreading_db(straight.metres));
    subtract(walls.loss_db, straight.db);
    Loudest loudest;
    loudest.offer(straight);
    for (std::size_t i = 0; i < walls.part_count; ++i) {
        if (level.parts[walls.parts[i]].is_shell) continue;  // nobody walks round the house
        offer_ways_around(level, scene, walls.parts[i], source, ear, loudest);
    }
    if (walls.part_count != 0) offer_detour(level, scene, source, ear, detour, loudest);

    Transmission transmission;
    transmission.metres = loudest.metres;
    transmission.arrives_from = loudest.arrives_from;
    for (std::size_t band = 0; band < world::kBands; ++band) {
        transmission.band_db[band] = loudest.db[band];
        transmission.band_gain[band] = det::exp(loudest.db[band] * (kLn10 / 20.0f));
    }
    return transmission;
}

float level_db(float loudness_db, const Transmission& transmission) {
    float power = 0.0f;
    for (const float gain : transmission.band_gain) power += gain * gain;
    return loudness_db + 10.0f * det::log10(power / static_cast<float>(world::kBands));
}

}  // namespace gh::sense
