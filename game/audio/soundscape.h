// audio/soundscape.h - everything that sounds now: this tick's noises, what still rings, lamps, the rooms.
//
//   Soundscape soundscape(bank);
//   each tick, after the simulation's:
//     for (const Source& s : soundscape.sources(level, state, ear.position))
//         heard.push_back(s.is_everywhere ? heard_everywhere(s, ear)
//                                         : heard_by(s, sense::hear(level, scene, s.position, ear.position)));
//     mixer.tick(ear, heard);
//
// A noise lives for one tick in State, its sound for longer: the Soundscape keeps its place until it has rung
// out, so that walls and doors go on shaping it. It reads State and writes nothing there.
//
// Cost      O(noises + lamps). Threads one at a time.
// Same bits a function of the states it was shown, in order.
#pragma once

#include "audio/sound_bank.h"
#include "world/level.h"
#include "world/state.h"

#include <glm/vec3.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace gh::audio {

inline constexpr std::size_t kMaxRinging = 32;  // noises that ring at once; the oldest makes room
inline constexpr std::size_t kMaxHums = 4;      // lamps heard humming: the nearest
inline constexpr float kHumRange = 9.0f;        // metres

struct Source {
    SoundId sound;
    std::uint32_t key = 0;
    glm::vec3 position{0.0f};  // metres, world
    float gain = 1.0f;         // at 1 m
    bool loops = false;
    bool is_everywhere = false;  // position means nothing
};

class Soundscape {
  public:
    explicit Soundscape(const SoundBank& bank);

    // Call once for each tick, in order; a state that does not follow on the last (a checkpoint, another
    // replay) starts afresh. The span lives until the next call.
    [[nodiscard]] std::span<const Source> sources(const world::Level& level, const world::State& state,
                                                  const glm::vec3& ear);

  private:
    struct Ringing {
        Source source;
        std::uint32_t ends_tick = 0;
        std::uint8_t follows_guard = 0xFF;  // voices and steps stay with the guard who made them
    };

    void add_noises(const world::Level& level, const world::State& state);
    void add_rules(const world::State& state);
    void add_whistles(const world::Level& level, const world::State& state);
    void ring(const Source& source, std::uint32_t tick, std::uint8_t guard);
    void list_hums(const world::Level& level, const world::State& state, const glm::vec3& ear);

    std::vector<std::uint32_t> lengths_;  // ticks, by flat_index
    std::vector<Ringing> ringing_;        // oldest first
    std::vector<Source> listed_;
    std::uint32_t last_tick_ = 0;
    world::Outcome last_outcome_ = world::Outcome::Playing;
    std::uint32_t last_caught_ = 0;
};

}  // namespace gh::audio
