// thief.h - a player made of code: from what stands in State alone, the keys to press next.
//
// Knows     everything: paths, doors, where the lens is. It has no memory, so that a planner can go back to any
//           earlier State and try something else from there.
// Same bits a function of (Level, Snapshot, Manner).
#pragma once

#include <cstdint>
#include <vector>

#include "input/command.h"
#include "sim/navigation.h"
#include "world/level.h"
#include "world/snapshot.h"

namespace gh::tools {

enum class Move : std::uint8_t { Walk, Hide };

// How this thief goes about it.
struct Manner {
    Move move = Move::Walk;
    std::uint32_t side = 0;        // from which side it reaches for things
    bool turns_mirror = true;      // the one nearest to the lens, in passing
    bool puts_out_lamps = true;    // at the lens
};

class Thief {
  public:
    Thief(const world::Level& level, const sim::Navigation& navigation);

    // Steals every lens and leaves.
    [[nodiscard]] input::Command steal(const world::Snapshot& now, const Manner& manner) const;

    // Walks up to the nearest guard, and asks for the checkpoint once caught.
    [[nodiscard]] input::Command get_caught(const world::Snapshot& now) const;

  private:
    struct Goal {
        glm::vec3 place{0.0f};  // where to stand
        glm::vec3 thing{0.0f};  // what to reach for, when there is something
        bool is_thing = false;
    };
    [[nodiscard]] Goal goal_of(const world::Snapshot& now, const Manner& manner) const;
    [[nodiscard]] Goal reach_for(const world::Snapshot& now, const glm::vec3& thing, std::uint32_t side) const;
    [[nodiscard]] input::Command go(const world::Snapshot& now, const glm::vec3& place) const;
    // To the nearest place that no guard's round overlooks, as the doors stand now; there it crouches. Not behind a leaf
    // that stands open between it and the goal.
    [[nodiscard]] input::Command hide(const world::Snapshot& now, const glm::vec3& goal) const;
    [[nodiscard]] bool is_behind_a_leaf(const world::Snapshot& now, const glm::vec3& place,
                                        const glm::vec3& goal) const;
    [[nodiscard]] bool is_overlooked(const world::Snapshot& now, const glm::vec3& place) const;
    [[nodiscard]] input::Command open_door(const world::Snapshot& now, std::uint32_t door) const;
    [[nodiscard]] input::Command handle_thing(const world::Snapshot& now, const glm::vec3& thing) const;

    const world::Level& level_;
    const sim::Navigation& navigation_;
    std::vector<glm::vec3> shelters_;  // places all over the floor
    std::vector<glm::vec3> rounds_;    // eyes of guards along their rounds
    std::uint32_t switch_ = world::kNoIndex;  // of the lamps nearest to the first lens
    std::uint32_t mirror_ = world::kNoIndex;  // the turnable one nearest to it
};

}  // namespace gh::tools
