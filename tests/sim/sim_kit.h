// sim/sim_kit.h - driving a Simulation in tests.
#pragma once

#include <cmath>
#include <cstdint>
#include <functional>

#include "base/det_math.h"
#include "input/command.h"
#include "sim/simulation.h"
#include "world/eye.h"

namespace gh::test {

// Looking along `yaw`, `pitch` (radians), walking forward by `forward` of full speed.
[[nodiscard]] inline input::Command command(float yaw, float pitch = 0.0f, float forward = 0.0f,
                                            std::uint16_t buttons = 0) {
    return {.yaw = input::quantise_yaw(yaw),
            .pitch = input::quantise_pitch(pitch),
            .move_right = 0,
            .move_forward = input::quantise_move(forward),
            .buttons = buttons};
}

// Looks at a point from where the eyes are.
[[nodiscard]] inline input::Command look_at(const world::State& state, const glm::vec3& point, float forward = 0.0f,
                                            std::uint16_t buttons = 0) {
    const glm::vec3 way = point - world::eye_of(state.player);
    const float flat = std::sqrt(way.x * way.x + way.z * way.z);
    return command(world::yaw_towards(way), det::atan2(way.y, flat), forward, buttons);
}

inline void run(sim::Simulation& simulation, const input::Command& with, int ticks) {
    for (int i = 0; i < ticks; ++i) simulation.step(with);
}

// Steps until `is_done` says so; the number of ticks, or -1 after `limit`.
inline int run_until(sim::Simulation& simulation, const std::function<input::Command(const world::State&)>& next,
                     const std::function<bool(const world::State&)>& is_done, int limit) {
    for (int i = 0; i < limit; ++i) {
        if (is_done(simulation.state())) return i;
        simulation.step(next(simulation.state()));
    }
    return is_done(simulation.state()) ? limit : -1;
}

// One press: down for a tick, then up.
inline void press(sim::Simulation& simulation, input::Command with, input::Button button) {
    with.buttons |= button;
    simulation.step(with);
    with.buttons = static_cast<std::uint16_t>(with.buttons & ~button);
    simulation.step(with);
}

}  // namespace gh::test
