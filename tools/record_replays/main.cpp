// Plays a level and writes the recordings that ship with it: NAME_win.rec and NAME_caught.rec.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <string>

#include "app/recording.h"
#include "foyer_story.h"
#include "load/level_loader.h"
#include "planner.h"
#include "sim/geometry.h"
#include "world/state_hash.h"

namespace {

using namespace gh;

int complain(const std::string& sentence) {
    fmt::print(stderr, "replay_recorder: {}\n", sentence);
    return 2;
}

// Plays the commands once more from the start, into a file.
Result<std::uint64_t> record(const std::filesystem::path& path, const std::string& name,
                             const std::shared_ptr<const world::Level>& level, std::uint32_t seed,
                             const std::vector<input::Command>& run) {
    auto recorder = app::Recorder::start(path, app::recording_header(name, *level, seed));
    if (!recorder) return recorder.error();
    sim::Simulation simulation(level, seed);
    for (const input::Command& command : run) {
        simulation.step(command);
        if (auto noted = recorder->note_tick(command, simulation.state()); !noted) return noted.error();
    }
    if (auto finished = recorder->finish(); !finished) return finished.error();
    return world::state_hash(simulation.state()).total;
}

// The level with guards thin as paper: a plan needs their eyes, not their coats, and is made five times as fast. What
// little their shadows change is seen when the plan is played in the level itself.
std::shared_ptr<const world::Level> sketch_of(const world::Level& level) {
    world::Level sketch = level;
    for (const world::Model& model : sketch.models) {
        world::Mesh& mesh = sketch.meshes[model.mesh];
        const std::size_t corners = std::min<std::size_t>(mesh.positions.size(), 3);
        mesh.positions.resize(corners);
        mesh.normals.resize(corners);
        mesh.joints.resize(corners);
        mesh.weights.resize(corners);
        mesh.uvs.resize(std::min(mesh.uvs.size(), corners));
        mesh.tangents.resize(std::min(mesh.tangents.size(), corners));
        mesh.triangles.assign(1, glm::uvec3(0, 1, 2));
        mesh.materials.resize(1);
    }
    return std::make_shared<const world::Level>(std::move(sketch));
}

// What a run turns out to be in the level itself.
struct Trial {
    bool wins = false;
    float nearest = 1e9f;  // metres between the thief and a guard, at their closest
    float chased = 1e9f;   // the same while a guard runs after a thief who has the lens
    float still = 0.0f;    // share of the ticks in which the thief stands, until it is over
};

Trial tried(const std::shared_ptr<const world::Level>& level, std::uint32_t seed,
            const std::vector<input::Command>& run) {
    sim::Simulation simulation(level, seed);
    Trial trial;
    int still = 0;
    for (const input::Command& command : run) {
        simulation.step(command);
        const world::State& state = simulation.state();
        const bool is_over = state.rules.outcome != world::Outcome::Playing;  // nobody walks on
        still += !is_over && sim::flat_length(state.player.velocity) < 0.05f ? 1 : 0;
        const bool has_lens = !level->lenses.empty() && state.rules.lenses_taken_count != 0;
        for (std::size_t g = 0; g < level->guards.size(); ++g) {
            const float apart = sim::length_of(state.guards[g].position - state.player.position);
            trial.nearest = std::min(trial.nearest, apart);
            if (has_lens && !is_over && state.guards[g].alert == world::Alert::Chasing) trial.chased = std::min(trial.chased, apart);
        }
    }
    trial.wins = simulation.state().rules.outcome == world::Outcome::Won;
    trial.still = static_cast<float>(still) / static_cast<float>(run.size());
    return trial;
}

// A run worth showing: not long, and not without a guard.
bool is_a_good_show(const std::vector<input::Command>& run, const Trial& trial) {
    constexpr std::size_t kLongest = 120 * world::kTicksPerSecond;
    return run.size() <= kLongest && trial.nearest < 7.0f;
}

// The run that was written for this level, if there is one and it still plays: the first take that ends in a narrow
// escape, else the first that wins at all.
std::optional<std::vector<input::Command>> play_story(const std::string& name,
                                                      const std::shared_ptr<const world::Level>& level,
                                                      std::uint32_t seed) {
    constexpr float kNarrow = 5.0f;     // metres
    constexpr float kMostStill = 0.2f;  // of the time
    if (name != "foyer") return std::nullopt;
    std::optional<std::vector<input::Command>> won;
    for (int take = 0; take < tools::kTakes; ++take) {
        tools::Actor thief(level, seed);
        tools::play_foyer(thief, take);
        if (thief.trouble()) {
            fmt::print("the story of {}, take {}, breaks off: {}\n", name, take, *thief.trouble());
            continue;
        }
        const Trial trial = tried(level, seed, thief.run());
        fmt::print("the story of {}, take {}: {} in {} ticks, stands still {:.1f} %, the guard never nearer than "
                   "{:.1f} m, and {:.1f} m in the end\n",
                   name, take, trial.wins ? "wins" : "does not win", thief.run().size(), 100.0f * trial.still,
                   trial.nearest, trial.chased);
        if (!trial.wins) continue;
        if (trial.chased < kNarrow && trial.still < kMostStill) return thief.run();
        if (!won) won = thief.run();
    }
    return won;
}

// Manners of going about it, a burglar's and an artist's: the first that is a good show, else the shortest.
std::optional<std::vector<input::Command>> find_win(const std::shared_ptr<const world::Level>& level,
                                                    std::uint32_t seed) {
    const auto sketch = sketch_of(*level);
    std::optional<std::vector<input::Command>> shortest;
    constexpr std::uint32_t kManners = 12;
    for (std::uint32_t n = 0; n < 2 * kManners; ++n) {
        const std::uint32_t i = (n + kManners + 1) % (2 * kManners);  // the burglar's way first: it takes the least thought
        const tools::Attempt attempt{.seed = seed,
                                     .side = (i / 3) % 4,
                                     .turns_mirror = i % 3 != 1,
                                     .puts_out_lamps = i % 3 == 2,
                                     .first_wait = i < kManners ? 0 : 2000,
                                     .most_alert = i < kManners ? world::Alert::Suspicious : world::Alert::Searching};
        auto run = tools::plan_win(sketch, attempt);
        const Trial trial = run ? tried(level, seed, *run) : Trial{};
        fmt::print("attempt {}: side {}, mirror {}, lamps {}: {}\n", i, attempt.side, attempt.turns_mirror,
                   attempt.puts_out_lamps,
                   trial.wins ? fmt::format("wins in {} ticks, stands still {:.0f} %, a guard {:.1f} m away", run->size(),
                                            100.0f * trial.still, trial.nearest)
                              : "gives up");
        std::fflush(stdout);
        if (!trial.wins) continue;
        if (is_a_good_show(*run, trial)) return run;
        if (!shortest || run->size() < shortest->size()) shortest = std::move(run);
    }
    return shortest;
}

struct Options {
    std::string level_path, out = "assets/replays";
    std::uint32_t seed = 1;
    bool story_only = false;
};

int record_both(const Options& options) {
    auto loaded = load::load_level(options.level_path);
    if (!loaded) return complain(loaded.error().sentence);
    const auto level = std::make_shared<const world::Level>(*std::move(loaded));
    const std::string name = std::filesystem::path(options.level_path).stem().string();

    auto win = play_story(name, level, options.seed);
    if (!win && options.story_only) return complain(name + " is not won by its story");
    if (!win) win = find_win(level, options.seed);
    if (!win) return complain(name + " can not be won by any manner this player knows");
    auto arrest = tools::plan_arrest(level, options.seed);
    if (!arrest) return complain("nobody in " + name + " catches a player who walks up to the guard");
    for (const auto& [run, ending] : {std::pair(&*win, "win"), std::pair(&*arrest, "caught")}) {
        const std::filesystem::path path = std::filesystem::path(options.out) / fmt::format("{}_{}.rec", name, ending);
        const auto hash = record(path, name, level, options.seed, *run);
        if (!hash) return complain(hash.error().sentence);
        fmt::print("{}: {} ticks, hash {:016x}\n", path.string(), run->size(), *hash);
    }
    return 0;
}

}  // namespace

int main(int argc, char** argv) {
    try {
        CLI::App app("Plays a level by itself and writes NAME_win.rec and NAME_caught.rec.", "replay_recorder");
        Options options;
        app.add_option("LEVEL", options.level_path, "a .glb or .gltf file")->required();
        app.add_option("--out", options.out, "folder of the recordings");
        app.add_flag("--story", options.story_only, "do not search for another way when the written one breaks off");
        app.add_option("--seed", options.seed, "of the simulation");
        try {
            app.parse(argc, argv);
        } catch (const CLI::ParseError& error) {
            return app.exit(error) == 0 ? 0 : 2;
        }
        return record_both(options);
    } catch (const std::exception& error) {
        return complain(error.what());
    }
}
