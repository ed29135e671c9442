#include "sim/simulation.h"

#include <utility>

#include "base/contracts.h"
#include "sim/noises.h"
#include "sim/player.h"
#include "spatial/stage.h"
#include "world/initial_state.h"

namespace gh::sim {

struct Simulation::Data {
    std::shared_ptr<const world::Level> level;
    const Jobs* jobs = nullptr;
    spatial::Stage stage;
    world::State state;
    std::shared_ptr<const world::Snapshot> snapshot;

    Data(std::shared_ptr<const world::Level> of, const Jobs* with)
        : level(std::move(of)), jobs(with), stage(level) {}

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

void Simulation::step(const input::Command& command, PhaseObserver* observer) {
    const auto begin = [observer](Phase phase) {
        if (observer != nullptr) observer->begin(phase);
    };
    Data& d = *data_;
    const world::Snapshot& before = *d.snapshot;

    begin(Phase::Decide);
    d.state.tick += 1;
    d.state.noise_count = 0;
    d.state.noises = {};
    fade_noise_needle(d.state.player);
    decide_player(before, command, d.state);

    begin(Phase::Doors);

    begin(Phase::Motion);
    move_player(*d.level, before, command, d.state);

    begin(Phase::Stones);

    begin(Phase::Noise);
    sound_player(before.state, command, d.state);

    begin(Phase::Commit);
    const std::shared_ptr<world::Snapshot> now = d.commit();

    begin(Phase::Perceive);

    begin(Phase::Judge);
    d.state.player.buttons_before = command.buttons;

    now->state = d.state;
    d.snapshot = now;
    if (observer != nullptr) observer->end();
}

}  // namespace gh::sim
