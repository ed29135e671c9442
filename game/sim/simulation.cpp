#include "sim/simulation.h"

#include <utility>

#include "base/contracts.h"
#include "sim/doors.h"
#include "sim/guards.h"
#include "sim/navigation.h"
#include "sim/noises.h"
#include "sim/player.h"
#include "sim/rules.h"
#include "sim/stones.h"
#include "sim/use.h"
#include "sim/use_target.h"
#include "spatial/stage.h"
#include "world/initial_state.h"

namespace gh::sim {

struct Simulation::Data {
    std::shared_ptr<const world::Level> level;
    const Jobs* jobs = nullptr;
    spatial::Stage stage;
    Navigation navigation;
    DoorBodies doors;
    world::State state;
    std::shared_ptr<const world::Snapshot> snapshot;

    Data(std::shared_ptr<const world::Level> of, const Jobs* with)
        : level(std::move(of)), jobs(with), stage(level), navigation(*level), doors(*level) {}

    [[nodiscard]] std::shared_ptr<world::Snapshot> commit() {
        return std::make_shared<world::Snapshot>(jobs != nullptr ? stage.commit(state, *jobs)
                                                                 : stage.commit(state));
    }
};

Simulation::Simulation(std::shared_ptr<const world::Level> level, std::uint32_t seed, const Jobs* jobs) {
    EXPECTS(level != nullptr);
    data_ = std::make_unique<Data>(std::move(level), jobs);
    restore(world::initial_state(*data_->level, seed));
}

Simulation::~Simulation() = default;

const world::State& Simulation::state() const { return data_->state; }
std::shared_ptr<const world::Snapshot> Simulation::snapshot() const { return data_->snapshot; }
const world::Level& Simulation::level() const { return *data_->level; }

void Simulation::restore(const world::State& state) {
    data_->state = state;
    data_->snapshot = data_->commit();
}

void Simulation::step(const input::Command& given, PhaseObserver* observer) {
    const auto begin = [observer](Phase phase) {
        if (observer != nullptr) observer->begin(phase);
    };
    Data& d = *data_;
    world::State& state = d.state;
    const world::Level& level = *d.level;
    const world::Snapshot& before = *d.snapshot;
    const GuardWorld then{level, before, d.navigation, d.doors};

    begin(Phase::Decide);
    state.tick += 1;
    state.noise_count = 0;
    state.noises = {};
    fade_noise_needle(state.player);
    const bool starts_again = wants_checkpoint(state, given);
    if (starts_again) state = checkpoint(level, state);
    const input::Command command = allowed(state, given);
    if (!starts_again) {
        decide_player(before, command, state);
        decide_throw(level, before, command, state);
        if (is_pressed(state.player, command, input::Button::Use)) {
            use(level, use_target(level, before, state.player), state);
        }
        decide_guards(then, state);

        begin(Phase::Doors);
        move_doors(level, d.doors, state);
        move_mirrors(level, state);

        begin(Phase::Motion);
        move_player(level, before, d.doors, command, state);
        move_guards(then, state);

        begin(Phase::Stones);
        move_stones(level, before, state);

        begin(Phase::Noise);
        sound_player(before.state, command, state);
    }

    begin(Phase::Commit);
    const std::shared_ptr<world::Snapshot> now = d.commit();

    const GuardWorld as_it_stands{level, *now, d.navigation, d.doors};

    begin(Phase::Perceive);
    perceive(as_it_stands, starts_again ? state : before.state, state);

    begin(Phase::Judge);
    judge_guards(as_it_stands, state);
    judge_rules(level, state);
    state.player.buttons_before = given.buttons;

    now->state = state;
    d.snapshot = now;
    if (observer != nullptr) observer->end();
}

}  // namespace gh::sim
