// raycore_bench - how fast and how right, beside Embree 3 on the same rays in the same interleaved run.
#include "bench_builds.h"
#include "bench_casts.h"
#include "bench_errors.h"
#include "bench_placed.h"
#include "bench_queries.h"
#include "bench_refit.h"
#include "bench_report.h"
#include "bench_sah.h"
#include "bench_scenes.h"

#include "raycore/isa.h"

#include <CLI/CLI.hpp>

#include <cstdio>
#include <exception>
#include <functional>

namespace {

struct Options {
    std::vector<std::string> scenes;
    std::string isa, json;
    std::vector<float> camera;
    int rounds = 7, keep = 8;
    unsigned threads = 2;
    std::size_t batch = 64, rays = 1'000'000;
    bool no_embree = false, no_builds = false, no_queries = false, is_quick = false;
    bool hard_cases = false, speed_error = false, sah = false;
};

Options read_options(int argc, char** argv) {
    Options options;
    CLI::App app(
        "Rays, builds, refits and casts of raycore beside Embree 3; without --scene, every built-in scene.");
    app.add_option(
        "--scene", options.scenes,
        "a glTF file, a raw mesh, or one of: museum placed interior landscape stadium cloth crowd refit");
    app.add_option("--camera", options.camera, "x,y,z,yaw,pitch,fov in metres and radians")
        ->delimiter(',')
        ->expected(6);
    app.add_option("--rounds", options.rounds, "rounds of each race; medians are over them")
        ->check(CLI::Range(1, 1'000'000'000));
    app.add_option("--keep", options.keep, "every how many-th 8x8 tile of 1280x720 is asked")
        ->check(CLI::Range(1, 1'000'000'000));
    app.add_option("--threads", options.threads, "threads of the second rows; 1: none")
        ->check(CLI::Range(1, 1'000'000'000));
    app.add_option("--batch", options.batch, "rays a batch")->check(CLI::Range(1, 1'000'000'000));
    app.add_option("--isa", options.isa, "scalar, avx2 or avx512");
    app.add_option("--json", options.json, "write every figure to this file as well");
    app.add_flag("--no-embree", options.no_embree, "raycore alone");
    app.add_flag("--no-builds", options.no_builds, "queries alone");
    app.add_flag("--no-queries", options.no_queries, "builds alone");
    app.add_flag("--hard-cases", options.hard_cases, "only the table of rays that must hit");
    app.add_flag("--speed-error", options.speed_error, "only the table of speed against error");
    app.add_flag("--sah", options.sah, "only how good the trees of the scenes are, beside those of Embree's builders");
    app.add_option("--rays", options.rays, "of the largest hard case; 50000000 asks 150 million in all")
        ->check(CLI::Range(1, 1'000'000'000));
    app.add_flag("--quick", options.is_quick, "under a minute: fewer rays, rounds and scenes");
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        std::exit(app.exit(error) == 0 ? 0 : 2);
    }
    return options;
}

constexpr const char* kMuseum = GLASSHOUSE_SOURCE_DIR "/assets/levels/foyer.glb";

std::optional<bench::BenchScene> scene_named(const std::string& name) {
    if (name == "museum") return bench::read_scene(kMuseum);
    if (name == "interior") return bench::make_interior();
    if (name == "landscape") return bench::make_landscape();
    if (name == "stadium") return bench::make_stadium();
    return bench::read_scene(name);
}

void bench_scene(bench::Report& report, const bench::BenchScene& scene, const Options& options) {
    const bool with_embree = !options.no_embree;
    if (!options.no_builds) bench::bench_sah(report, scene, with_embree);
    if (options.sah) return;
    if (!options.no_queries)
        bench::bench_queries(report, scene,
                             {options.rounds, options.keep, options.threads, options.batch, with_embree});
    if (!options.no_queries) bench::bench_casts(report, scene, options.rounds);
    if (!options.no_builds)
        bench::bench_builds(report, scene, {options.rounds, options.threads, with_embree});
}

bool run(bench::Report& report, const Options& options) {
    const bench::BuildOptions moving{options.rounds, options.threads, !options.no_embree};
    for (const std::string& name : options.scenes) {
        if (name == "cloth") {
            bench::bench_cloth(report, moving);
        } else if (name == "crowd") {
            bench::bench_crowd(report, moving);
        } else if (name == "refit") {
            bench::bench_refit(report, {.rounds = options.rounds});
        } else if (name == "placed") {
            const bench::QueryOptions queries{options.rounds, options.keep, 1, options.batch,
                                              !options.no_embree};
            if (!bench::bench_placed(report, kMuseum, queries)) return false;
        } else {
            std::optional<bench::BenchScene> scene = scene_named(name);
            if (!scene) return false;
            if (options.camera.size() == 6) {
                const std::vector<float>& c = options.camera;
                scene->camera = {{c[0], c[1], c[2]}, c[3], c[4], c[5]};
            }
            bench_scene(report, *scene, options);
        }
    }
    return true;
}

int bench_all(int argc, char** argv) {
    Options options = read_options(argc, argv);
    if (!options.isa.empty()) {
        const std::optional<rc::Isa> isa = rc::isa_from_name(options.isa);
        if (!isa || !rc::use_isa(*isa))
            return std::fprintf(stderr, "--isa %s: not known here\n", options.isa.c_str()), 2;
    }
    if (options.is_quick) options.rounds = 3, options.keep = 32;
    const bool is_all = options.scenes.empty() && !options.hard_cases && !options.speed_error && !options.sah;
    if (options.sah && options.scenes.empty()) options.scenes = {"museum", "interior", "landscape"};
    if (is_all) {
        options.scenes = {"museum", "placed", "interior", "cloth", "crowd", "refit"};
        if (!options.is_quick) options.scenes.insert(options.scenes.begin() + 3, {"landscape", "stadium"});
    }
    bench::Report report;
    // Whether it can be written is known before the first race, not after the last.
    if (!options.json.empty() && !report.write_json(options.json)) return 2;
    report.fact("instructions", std::string(rc::isa_name(rc::active_isa())));
    if (!run(report, options)) return 2;
    const bench::ErrorOptions errors{options.is_quick ? 100'000 : options.rays, options.rounds,
                                     !options.no_embree};
    if (is_all || options.speed_error) bench::bench_speed_error(report, errors);
    if (is_all || options.hard_cases) {
        bench::bench_hard_cases(report, errors);
        bench::bench_same_bits(report, errors);
    }
    return options.json.empty() || report.write_json(options.json) ? 0 : 2;
}

}  // namespace

int main(int argc, char** argv) {
    try {
        return bench_all(argc, argv);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "raycore_bench: %s\n", error.what());
        return 2;
    }
}
