// audio/room_sound.h - how long and how loudly a room rings, from what it is built and furnished with.
//
// By Eyring: T = 24 ln 10 V / (c S (-ln(1 - a))) with the room's volume V, the area S of all its surfaces and their mean
// absorption a, a band at a time. Doorways count as nothing: rooms with wide ones ring a little shorter in truth.
//
// Cost      a pass over the level's triangles, once a level. Threads: pure.
// Bad input a room without a surface or a volume rings like a small plain one.
#pragma once

#include "world/level.h"

#include <glm/vec3.hpp>

#include <array>
#include <cstdint>
#include <vector>

namespace gh::audio {

struct RoomSound {
    std::array<float, world::kBands> decay{0.6f, 0.6f, 0.6f};  // seconds to fall by 60 dB, at 250 Hz, 1 kHz, 4 kHz
    float mean_free_path = 2.0f;                               // metres between two walls, on average
    float level = 1.0f;  // amplitude of the steady reverberation beside that of kOrdinaryRoom

    bool operator==(const RoomSound&) const = default;
};

// Absorbing area of a room whose reverberation is as loud as the mixer's middle: square metres.
inline constexpr float kOrdinaryRoom = 40.0f;

// One a Level::rooms.
[[nodiscard]] std::vector<RoomSound> room_sounds(const world::Level& level);

// The room that holds a point, or kNoIndex: doorways are in none.
[[nodiscard]] std::uint32_t room_at(const world::Level& level, const glm::vec3& point);

}  // namespace gh::audio
