// actor.h - plays a written part in a level: each beat below runs the simulation until it is done, and the keys that
// were pressed meanwhile are the recording.
//
// A beat that can not be done (no way, no such thing, too slow, caught) ends the part: what went wrong is a sentence
// with the time, and every later beat does nothing. So a part is written as plainly as stage directions.
//
// Same bits a function of (Level, seed, part).
#pragma once

#include "input/command.h"
#include "sim/navigation.h"
#include "sim/simulation.h"
#include "sim/use_target.h"

#include <glm/vec3.hpp>

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace gh::tools {

enum class Pace : std::uint8_t { Creep, Walk, Run };

// What a body does while the eyes are elsewhere.
struct Pose {
    bool is_low = false;
    float lean = 0.0f;  // -1 left, 1 right
    bool holds_mirror = false;
};

class Actor {
  public:
    using Enough = std::function<bool()>;

    Actor(std::shared_ptr<const world::Level> level, std::uint32_t seed);

    // To a place on the floor, along the way there; the eyes on `gaze` if there is one, else on the way ahead.
    void go(const glm::vec3& place, Pace pace, std::optional<glm::vec3> gaze = {});
    // The same; for the last steps the eyes are on what will be reached for, so that nobody stands there to turn.
    void go_for(const glm::vec3& place, Pace pace, const glm::vec3& thing);
    // The same with the eyes on the guard, no further than `enough`.
    void go_watching_guard(const glm::vec3& place, Pace pace, const Enough& enough = {});
    // The same with the eyes on the way.
    void go_until(const glm::vec3& place, Pace pace, const Enough& enough);

    // Presses `use` on a thing within reach, by its node's name.
    void put_out(std::string_view lamp_switch);
    void turn(std::string_view mirror, int steps);
    void take(std::string_view lens);
    void take_hand_mirror();
    // A door, or a lid; waits until it stands `wide` open, out of its way.
    void open(std::string_view door, float wide = 0.85f);
    void shut(std::string_view door);

    // Looks, for so many seconds at most, until `enough`.
    void watch(const glm::vec3& at, float seconds, Pose pose = {}, const Enough& enough = {});
    // The same with the eyes on the guard.
    void watch_guard(float seconds, Pose pose = {}, const Enough& enough = {});

    // The same in the hand mirror, held out to a side: turned so that the guard would stand in its middle.
    void watch_guard_in_mirror(float seconds, float side, const Enough& enough = {});

    // Aims until the arc ends at the place, and lets go.
    void throw_stone(const glm::vec3& at, Pose pose = {});

    [[nodiscard]] const world::State& state() const { return simulation_.state(); }
    [[nodiscard]] const world::GuardState& guard() const { return state().guards[0]; }
    [[nodiscard]] bool guard_is_in(std::string_view room) const;

    // A note in the log: when, how much of it was spent standing, where the guard is, what he makes of it.
    void note(std::string_view what) const;

    [[nodiscard]] const std::vector<input::Command>& run() const { return run_; }
    // Why the part broke off, if it did.
    [[nodiscard]] const std::optional<std::string>& trouble() const { return trouble_; }

    // Where the handle of a door is as it stands now; the place of a switch.
    [[nodiscard]] glm::vec3 handle_of(std::string_view door) const;
    [[nodiscard]] glm::vec3 switch_at(std::string_view lamp_switch) const;

  private:
    using Gaze = std::function<std::optional<glm::vec3>(float metres_left)>;
    void walk_to(const glm::vec3& place, Pace pace, const Gaze& gaze, const Enough& enough = {});
    void fail(std::string_view what);
    void step(input::Command command, const Pose& pose);
    [[nodiscard]] input::Command looking_at(const glm::vec3& point);
    [[nodiscard]] input::Command looking_along(const glm::vec3& way);
    void use(const glm::vec3& point, sim::UseKind kind, std::uint32_t index, std::string_view name);
    [[nodiscard]] glm::vec3 ahead_on(std::span<const glm::vec3> corners) const;
    [[nodiscard]] float arc_error(const glm::vec3& at, float pitch, std::uint16_t aim_ticks) const;

    std::shared_ptr<const world::Level> level_;
    sim::Simulation simulation_;
    sim::Navigation navigation_;
    std::vector<input::Command> run_;
    std::optional<std::string> trouble_;
    float turn_speed_ = 0.0f;  // radians a tick: the hand has weight
    float tilt_speed_ = 0.0f;
    int still_ticks_ = 0;  // so far: who stands about is dull to watch
};

}  // namespace gh::tools
