// sim/simulation.h - the tick: sixty a second, each a pure function of (Level, State, Command).
//
//   sim::Simulation simulation(level, seed);
//   simulation.step(command);                        // one tick
//   render(*simulation.snapshot());                  // the world as it now stands, frozen
//
// Cost      see Phase; the observer is how the app measures it.
// Threads   one Simulation belongs to one thread. With `jobs`, guards are posed side by side; Snapshots may be
//           read on any thread for as long as they are held.
// Same bits on any number of threads, machine and compiler: reads no clock, device, thread id or pixel. After
//           restore(s) the same commands give the same bytes again.
// Bad input a Level that has passed level_check; a Command that is_valid.
#pragma once

#include <cstdint>
#include <memory>

#include "base/jobs.h"
#include "input/command.h"
#include "world/level.h"
#include "world/snapshot.h"
#include "world/state.h"

namespace gh::sim {

// What a tick does, in this order.
enum class Phase : std::uint8_t {
    Decide,    // player and guards, from what was perceived a tick ago
    Doors,     // doors and mirrors move
    Motion,    // characters, against the Scene as it last stood
    Stones,
    Noise,     // what was done is heard
    Commit,    // the world has moved
    Perceive,  // light, sight, sound, in the Scene as it now stands
    Judge,     // suspicion, winning, losing
};
inline constexpr std::size_t kPhaseCount = 8;

// Told when a phase begins; the clock, if any, is the observer's own.
class PhaseObserver {
  public:
    virtual ~PhaseObserver() = default;
    virtual void begin(Phase phase) = 0;
    virtual void end() = 0;  // of the tick
};

class Simulation {
  public:
    Simulation(std::shared_ptr<const world::Level> level, std::uint32_t seed, const Jobs* jobs = nullptr);
    ~Simulation();
    Simulation(const Simulation&) = delete;
    Simulation& operator=(const Simulation&) = delete;

    void step(const input::Command& command, PhaseObserver* observer = nullptr);

    [[nodiscard]] const world::State& state() const;
    [[nodiscard]] std::shared_ptr<const world::Snapshot> snapshot() const;  // of state(), never null
    [[nodiscard]] const world::Level& level() const;

    // Goes on from a State of this level, as if it had just been reached.
    void restore(const world::State& state);

  private:
    struct Data;
    std::unique_ptr<Data> data_;
};

}  // namespace gh::sim
