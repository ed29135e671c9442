// planner.h - finds a winning run by trying. A run is a few errands (a lamp put out, the lens, the exit); before each
// the thief waits for a while, and the shortest waits that keep the guards calm are searched for. The simulation itself
// is the map of what guards will do.
//
// Cost      a second of wait costs a second of game to try; the foyer takes a minute of one core.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "input/command.h"
#include "sim/simulation.h"
#include "thief.h"

namespace gh::tools {

// What a run may cost, and how it is gone about.
struct Attempt {
    std::uint32_t seed = 1;           // of the simulation
    std::uint32_t side = 0;           // see Manner
    bool turns_mirror = true;
    bool puts_out_lamps = true;
    int first_wait = 0;               // ticks in hiding before anything is done: lets a guard's round go by
    world::Alert most_alert = world::Alert::Calm;  // that any guard may ever reach
};

// The commands of a run that wins, or nothing within the attempt's means.
[[nodiscard]] std::optional<std::vector<input::Command>> plan_win(const std::shared_ptr<const world::Level>& level,
                                                                  const Attempt& attempt);

// The commands of a run that is caught, goes back to the checkpoint and stands there for a second.
[[nodiscard]] std::optional<std::vector<input::Command>> plan_arrest(const std::shared_ptr<const world::Level>& level,
                                                                     std::uint32_t seed);

}  // namespace gh::tools
