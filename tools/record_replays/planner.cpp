#include "planner.h"

#include "sim/geometry.h"

namespace gh::tools {

namespace {

constexpr int kWaitTicks = 120;            // one more of these is waited at a time
constexpr int kMostWaits = 30;             // a guard's round
constexpr int kMostTicks = 24'000;         // tried in one attempt: a manner that takes more thought is given up
constexpr int kMostErrandTicks = 60 * 90;  // nothing is further away than that
constexpr int kStuckPlanTicks = 240;
constexpr int kArrestTicks = 60 * 180;

// How much of the job is done: whatever changes it is the end of an errand.
int progress(const world::Level& level, const world::State& state) {
    int done = state.rules.outcome == world::Outcome::Won ? 1 : 0;
    done += state.rules.lenses_taken_count;
    for (std::size_t g = 0; g < level.lamp_groups.size(); ++g) done += state.group_on[g] == 0;
    for (std::size_t m = 0; m < level.mirrors.size(); ++m) done += state.mirrors[m].target != 0.0f;
    return done;
}

class Search {
  public:
    Search(const std::shared_ptr<const world::Level>& level, const Attempt& attempt)
        : simulation_(level, attempt.seed), navigation_(*level), thief_(*level, navigation_), level_(*level),
          attempt_(attempt) {}

    // Whether hiding that long goes unnoticed.
    bool hides(int ticks) { return go_on(Move::Hide, ticks); }

    // Whether the rest of the job can be done from here; then run() holds all of it.
    bool can_finish() {
        const world::State start = simulation_.state();
        if (start.rules.outcome == world::Outcome::Won) return true;
        const std::size_t run_here = run_.size();
        world::State waited = start;
        for (int i = 0; i <= kMostWaits; ++i) {
            if (does_errand() && can_finish()) return true;
            if (ticks_tried_ > kMostTicks) return false;
            simulation_.restore(waited);
            run_.resize(run_here + static_cast<std::size_t>(i) * kWaitTicks);
            if (!go_on(Move::Hide, kWaitTicks)) return false;  // noticed where it hides
            waited = simulation_.state();
        }
        return false;
    }

    [[nodiscard]] const std::vector<input::Command>& run() const { return run_; }

  private:
    bool is_unnoticed() const {
        const world::State& state = simulation_.state();
        if (state.rules.outcome == world::Outcome::Caught) return false;
        for (std::size_t g = 0; g < level_.guards.size(); ++g) {
            if (state.guards[g].alert > attempt_.most_alert) return false;
        }
        return true;
    }

    bool go_on(Move move, int ticks) {
        const Manner manner{.move = move,
                            .side = attempt_.side,
                            .turns_mirror = attempt_.turns_mirror,
                            .puts_out_lamps = attempt_.puts_out_lamps};
        for (int i = 0; i < ticks; ++i) {
            if (++ticks_tried_ > kMostTicks) return false;
            run_.push_back(thief_.steal(*simulation_.snapshot(), manner));
            simulation_.step(run_.back());
            if (!is_unnoticed()) return false;
        }
        return true;
    }

    bool does_errand() {
        const int before = progress(level_, simulation_.state());
        glm::vec3 was_at = simulation_.state().player.position;
        for (int i = 0; i < kMostErrandTicks; ++i) {
            if (!go_on(Move::Walk, 1)) return false;
            if (progress(level_, simulation_.state()) > before) return true;
            if (i % kStuckPlanTicks != kStuckPlanTicks - 1) continue;
            const glm::vec3 is_at = simulation_.state().player.position;
            if (sim::length_of(is_at - was_at) < 0.1f) return false;  // an open leaf is in the way
            was_at = is_at;
        }
        return false;
    }

    sim::Simulation simulation_;
    sim::Navigation navigation_;
    Thief thief_;
    const world::Level& level_;
    Attempt attempt_;
    std::vector<input::Command> run_;
    int ticks_tried_ = 0;
};

}  // namespace

std::optional<std::vector<input::Command>> plan_win(const std::shared_ptr<const world::Level>& level,
                                                    const Attempt& attempt) {
    Search search(level, attempt);
    if (!search.hides(attempt.first_wait)) return std::nullopt;
    if (!search.can_finish()) return std::nullopt;
    std::vector<input::Command> run = search.run();
    run.insert(run.end(), 90, run.back());  // and look at the night outside
    return run;
}

std::optional<std::vector<input::Command>> plan_arrest(const std::shared_ptr<const world::Level>& level,
                                                       std::uint32_t seed) {
    sim::Simulation simulation(level, seed);
    const sim::Navigation navigation(*level);
    const Thief thief(*level, navigation);
    std::vector<input::Command> run;
    for (int i = 0; i < kArrestTicks; ++i) {
        run.push_back(thief.get_caught(*simulation.snapshot()));
        simulation.step(run.back());
        const bool is_back = simulation.state().rules.times_caught > 0 &&
                             simulation.state().rules.outcome == world::Outcome::Playing;
        if (!is_back) continue;
        const input::Command still{.yaw = simulation.state().player.yaw};
        run.insert(run.end(), 60, still);
        return run;
    }
    return std::nullopt;
}

}  // namespace gh::tools
