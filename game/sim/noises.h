// sim/noises.h - what sounds in a tick, and how loudly: dB at 1 m, by surface, speed and stance.
//
// A quiet museum hums at 22 dB; a step on marble (45 dB) is lost in that 14 m away, on carpet after 2 m.
// Guards hear State::noises through sense::hearing, players through audio: from one list.
// Threads   State belongs to the tick. Same bits: det_math only.
#pragma once

#include <cstdint>

#include "world/state.h"

namespace gh::sim {

inline constexpr std::uint8_t kNobody = 0xFF;     // Noise::by_guard of everything that no guard made
inline constexpr std::uint8_t kSomeGuard = 0xFE;  // of doors that guards open and close

enum class Gait : std::uint8_t { Crouch, Walk, Run };

// What a triangle is to feet and stones: the surface of its material. Marble where there is none.
[[nodiscard]] world::Surface surface_at(const world::Level& level, std::uint32_t instance,
                                        std::uint32_t primitive);

[[nodiscard]] float footstep_db(world::Surface surface, Gait gait);
[[nodiscard]] float landing_db(world::Surface surface, float speed);    // falling at `speed` m/s
[[nodiscard]] float stone_hit_db(world::Surface surface, float speed);  // at `speed` m/s into the surface

// Adds to this tick's noises; when the list is full the quietest one gives way, or this one.
void emit(world::State& state, const world::Noise& noise);

// The same for what the player did: the HUD's needle shows it, too.
void emit_by_player(world::State& state, const world::Noise& noise);

// The needle falls back.
void fade_noise_needle(world::PlayerState& player);

}  // namespace gh::sim
