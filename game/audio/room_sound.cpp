#include "audio/room_sound.h"

#include "world/surface.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace gh::audio {

namespace {

constexpr float kWallReach = 0.05f;      // metres: a room's walls lie on its box
constexpr float kShortest = 0.15f;  // seconds; EFX knows nothing below 0.1
constexpr float kLongest = 4.0f;
constexpr float kMostAbsorbing = 0.98f;

// Area in all, and absorbing area a band, in square metres.
struct Surfaces {
    float area = 0.0f;
    std::array<float, world::kBands> absorbing{};
};

bool holds(const world::Aabb& box, const glm::vec3& p, float reach) {
    return glm::all(glm::lessThanEqual(box.min - reach, p)) && glm::all(glm::lessThanEqual(p, box.max + reach));
}

void add_part(const world::Level& level, const world::Part& part, std::vector<Surfaces>& rooms) {
    const world::Mesh& mesh = level.meshes[part.mesh];
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        const auto corner = [&](std::uint32_t vertex) {
            return part.mover_from_part * glm::vec4(mesh.positions[vertex], 1.0f);
        };
        const glm::uvec3& triangle = mesh.triangles[i];
        const glm::vec3 p = corner(triangle.x), q = corner(triangle.y), r = corner(triangle.z);
        const glm::vec3 middle = (p + q + r) / 3.0f;
        const float area = 0.5f * glm::length(glm::cross(q - p, r - p));
        const auto& absorption = world::acoustics(level.materials[mesh.materials[i]].surface).absorption;
        for (std::size_t room = 0; room < rooms.size(); ++room) {
            if (!holds(level.rooms[room].box, middle, kWallReach)) continue;
            rooms[room].area += area;
            for (std::size_t b = 0; b < world::kBands; ++b) rooms[room].absorbing[b] += area * absorption[b];
        }
    }
}

RoomSound sound_of(const world::Aabb& box, const Surfaces& surfaces) {
    const glm::vec3 size = box.max - box.min;
    const float volume = size.x * size.y * size.z;
    if (!(volume > 0.0f) || !(surfaces.area > 0.0f)) return {};
    RoomSound sound;
    sound.mean_free_path = 4.0f * volume / surfaces.area;
    for (std::size_t b = 0; b < world::kBands; ++b) {
        const float share = std::clamp(surfaces.absorbing[b] / surfaces.area, 1e-4f, kMostAbsorbing);
        const float seconds = 24.0f * std::log(10.0f) * volume /
                              (world::kSpeedOfSound * surfaces.area * -std::log(1.0f - share));
        sound.decay[b] = std::clamp(seconds, kShortest, kLongest);
    }
    const float share = std::clamp(surfaces.absorbing[1] / surfaces.area, 1e-4f, kMostAbsorbing);
    const float room_constant = surfaces.area * share / (1.0f - share);
    sound.level = std::sqrt(kOrdinaryRoom / room_constant);
    return sound;
}

}  // namespace

std::vector<RoomSound> room_sounds(const world::Level& level) {
    std::vector<Surfaces> surfaces(level.rooms.size());
    for (const world::Part& part : level.parts) {
        if (part.mover == world::Mover::None) add_part(level, part, surfaces);
    }
    std::vector<RoomSound> sounds;
    for (std::size_t r = 0; r < surfaces.size(); ++r) sounds.push_back(sound_of(level.rooms[r].box, surfaces[r]));
    return sounds;
}

std::uint32_t room_at(const world::Level& level, const glm::vec3& point) {
    for (std::uint32_t r = 0; r < level.rooms.size(); ++r) {
        if (holds(level.rooms[r].box, point, 0.0f)) return r;
    }
    return world::kNoIndex;
}

}  // namespace gh::audio
