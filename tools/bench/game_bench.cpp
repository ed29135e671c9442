// game_bench - milliseconds of the game on a level: posing and asking the world, whole ticks by room, and pictures.
//
//   game_bench assets/levels/foyer.glb --replay assets/replays/win.replay
#include "bench_films.h"
#include "bench_frames.h"
#include "bench_needs.h"
#include "bench_paths.h"
#include "bench_senses.h"
#include "bench_ticks.h"
#include "bench_window.h"
#include "input/replay.h"
#include "load/level_loader.h"

#include "raycore/isa.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <exception>

namespace {

struct Options {
    std::string level = "assets/levels/foyer.glb";
    std::string replay, isa;
    int rounds = 10;
    int ticks = 1800;
    int threads = 2;
    bool without_frames = false;
    bool only_needs = false;
    bool only_films = false;
    bool only_paths = false;
    bool only_window = false;
};

Options read_options(int argc, char** argv) {
    Options options;
    CLI::App app("What the game costs on a level: spatial and sense by call, ticks by room, frames.");
    app.add_option("LEVEL", options.level, "a glTF level");
    app.add_option("--replay", options.replay,
                   "whose commands to tick through; without it a restless player's");
    app.add_option("--rounds", options.rounds, "samples; medians are over them")->check(CLI::Range(3, 1000));
    app.add_option("--ticks", options.ticks, "ticks of a run without a replay")
        ->check(CLI::Range(1, 1'000'000));
    app.add_option("--threads", options.threads, "for frames")->check(CLI::Range(1, 256));
    app.add_option("--isa", options.isa, "scalar, avx2 or avx512");
    app.add_flag("--without-frames", options.without_frames, "ticks alone");
    app.add_flag("--needs", options.only_needs,
                 "only what it costs to path trace a scene by a kernel that can do more than it needs");
    app.add_flag("--films", options.only_films,
                 "only what the filters take of path-traced films, as the window has them");
    app.add_flag("--paths", options.only_paths, "only what path-traced pictures cost, by stage");
    app.add_flag("--window", options.only_window, "only what the window's pictures cost, by stage");
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        std::exit(app.exit(error) == 0 ? 0 : 2);
    }
    return options;
}

int refuse(const std::string& sentence) {
    std::fprintf(stderr, "game_bench: %s\n", sentence.c_str());
    return 2;
}

int bench_all(int argc, char** argv) {
    const Options options = read_options(argc, argv);
    if (!options.isa.empty()) {
        const std::optional<rc::Isa> isa = rc::isa_from_name(options.isa);
        if (!isa || !rc::use_isa(*isa)) return refuse("--isa " + options.isa + ": not known here");
    }
    gh::Result<gh::world::Level> loaded = gh::load::load_level(options.level);
    if (!loaded) return refuse(loaded.error().sentence);
    const auto level = std::make_shared<const gh::world::Level>(std::move(*loaded));
    std::size_t triangles = 0;
    for (const gh::world::Part& part : level->parts) triangles += level->meshes[part.mesh].triangles.size();
    std::printf("%s: %zu parts, %zu triangles, %zu lamps, %zu guards; %s\n", options.level.c_str(),
                level->parts.size(), triangles, level->lamps.size(), level->guards.size(),
                std::string(rc::isa_name(rc::active_isa())).c_str());

    if (options.only_needs) {
        bench::bench_needs(level, options.rounds);
        return 0;
    }
    if (options.only_films) {
        bench::bench_films(level, options.threads, options.rounds);
        return 0;
    }
    if (options.only_paths) {
        bench::bench_paths(level, options.threads, options.rounds);
        return 0;
    }
    if (options.only_window) {
        bench::bench_window(level, options.threads, options.rounds);
        return 0;
    }
    std::vector<gh::input::Command> commands = bench::restless_player(options.ticks);
    if (!options.replay.empty()) {
        gh::Result<gh::input::Replay> replay = gh::input::read_replay(options.replay);
        if (!replay) return refuse(replay.error().sentence);
        commands = std::move(replay->commands);
    }
    bench::bench_stage_and_senses(level, options.rounds);
    bench::bench_ticks(level, commands, options.rounds);
    if (!options.without_frames) bench::bench_frames(level, options.threads, options.rounds);
    return 0;
}

}  // namespace

int main(int argc, char** argv) {
    try {
        return bench_all(argc, argv);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "game_bench: %s\n", error.what());
        return 2;
    }
}
