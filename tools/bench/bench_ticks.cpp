#include "bench_ticks.h"

#include "figures.h"
#include "sim/simulation.h"
#include "world/state_hash.h"

#include <array>

namespace bench {
namespace {

using namespace gh;

constexpr std::array<const char*, sim::kPhaseCount> kPhases = {
    "sim: decide", "sim: doors and mirrors", "sim: motion",     "sim: stones",
    "sim: noise",  "spatial: commit",        "sense: perceive", "sim: judge"};

// The clock the simulation itself does not have.
class PhaseClock final : public sim::PhaseObserver {
  public:
    std::array<double, sim::kPhaseCount> total_ms{};
    Samples ticks;

    void begin(sim::Phase phase) override {
        const double now = cpu_ms();
        if (is_running_) {
            total_ms[static_cast<std::size_t>(phase_)] += now - phase_start_;
        } else {
            tick_start_ = now;
        }
        phase_ = phase;
        phase_start_ = now;
        is_running_ = true;
    }
    void end() override {
        const double now = cpu_ms();
        total_ms[static_cast<std::size_t>(phase_)] += now - phase_start_;
        ticks.ms.push_back(now - tick_start_);
        is_running_ = false;
    }

  private:
    sim::Phase phase_ = sim::Phase::Decide;
    double phase_start_ = 0.0, tick_start_ = 0.0;
    bool is_running_ = false;
};

}  // namespace

std::vector<input::Command> restless_player(int ticks) {
    std::vector<input::Command> commands(static_cast<std::size_t>(ticks));
    for (std::size_t i = 0; i < commands.size(); ++i) {
        input::Command& command = commands[i];
        command.yaw =
            input::quantise_yaw(0.01f * static_cast<float>(i % 629) + (i % 240 < 120 ? 0.4f : -0.4f));
        command.move_forward = i % 300 < 240 ? input::kMaxMove : std::int8_t{0};
        if (i % 600 < 200) command.buttons |= input::Run;
        if (i % 50 < 2) command.buttons |= input::Use;
        if (i % 180 < 30) command.buttons |= input::Throw;
    }
    return commands;
}

void bench_ticks(const std::shared_ptr<const world::Level>& level,
                 const std::vector<input::Command>& commands, int rounds) {
    std::array<Samples, sim::kPhaseCount> phases;
    Samples whole, every_tick;
    std::uint64_t answer = 0;
    for (int round = 0; round < rounds; ++round) {
        sim::Simulation simulation(level, 1);
        PhaseClock clock;
        for (const input::Command& command : commands) simulation.step(command, &clock);
        answer = world::state_hash(simulation.state()).total;
        double sum = 0.0;
        for (std::size_t p = 0; p < phases.size(); ++p) {
            phases[p].ms.push_back(clock.total_ms[p] / static_cast<double>(commands.size()));
            sum += phases[p].ms.back();
        }
        whole.ms.push_back(sum);
        every_tick.ms.insert(every_tick.ms.end(), clock.ticks.ms.begin(), clock.ticks.ms.end());
    }
    print_head("a tick, core time (mean of a run; over runs)");
    for (std::size_t p = 0; p < phases.size(); ++p) print_row(kPhases[p], phases[p]);
    print_row("whole tick", whole, answer);
    std::printf("  (%zu ticks, %d runs; single ticks: 99 in 100 within %.3f ms, the slowest %.3f ms)\n",
                commands.size(), rounds, every_tick.at(0.99), every_tick.at(1.0));
}

}  // namespace bench
