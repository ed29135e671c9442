#include "bench_builds.h"

#include "bench_timing.h"
#include "raycore_side.h"
#ifdef BENCH_HAS_EMBREE
#include "embree_side.h"
#endif

#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include <array>

namespace bench {

namespace {

constexpr std::array kQualities = {rc::BuildQuality::Fast, rc::BuildQuality::Default, rc::BuildQuality::High};

struct Race {
    std::array<Timing, 3> ours, theirs;
    std::array<double, 3> our_bytes{}, their_bytes{}, cost{};
};

void run_round(Race& race, const BenchScene& scene, unsigned threads, const BuildOptions& options) {
    const double triangles = static_cast<double>(std::max<std::size_t>(1, scene.triangles.size()));
    for (std::size_t q = 0; q < kQualities.size(); ++q) {
        std::shared_ptr<rc::Blas> blas;
        race.ours[q].run([&] { blas = rc::build_blas(scene.view(), {kQualities[q]}); });
        race.our_bytes[q] = static_cast<double>(blas->byte_size()) / triangles;
        race.cost[q] = static_cast<double>(blas->sah_cost());
#ifdef BENCH_HAS_EMBREE
        if (!options.with_embree) continue;
        constexpr std::array kTheirs = {EmbreeQuality::Low, EmbreeQuality::Medium, EmbreeQuality::High};
        const EmbreeSide side(scene, EmbreeMode::Fast, kTheirs[q], threads);
        race.theirs[q].add(side.build_time().wall_ms, side.build_time().core_ms);
        race.their_bytes[q] = static_cast<double>(side.byte_size()) / triangles;
#else
        (void)threads;
        (void)options;
#endif
    }
}

void report_race_of(Report& report, const Race& race, double triangles, unsigned threads, bool with_embree) {
    const char* their_names[] = {"embree low", "embree medium", "embree high"};
    const std::string on = ", " + std::to_string(threads) + " thread(s)";
    for (std::size_t q = 0; q < kQualities.size(); ++q) {
        report.row("raycore " + name_of(kQualities[q]) + on);
        report.spread(race.ours[q].wall, 1).number(race.ours[q].core.at(0.5), 1);
        report.number(triangles / race.ours[q].wall.at(0.5) * 1e-3).number(race.our_bytes[q], 1);
        report.number(race.cost[q], 2);
        if (!with_embree) {
            report.none();
            continue;
        }
        report.text(times_as_fast(race.ours[q], race.theirs[q]));
        report.row(their_names[q] + on);
        report.spread(race.theirs[q].wall, 1).number(race.theirs[q].core.at(0.5), 1);
        report.number(triangles / race.theirs[q].wall.at(0.5) * 1e-3).number(race.their_bytes[q], 1);
        report.none().none();
    }
}

}  // namespace

void bench_builds(Report& report, const BenchScene& scene, const BuildOptions& options) {
#ifdef BENCH_HAS_EMBREE
    const bool with_embree = options.with_embree;
#else
    const bool with_embree = false;
#endif
    report.table(
        "builds of " + scene.name + ", " + std::to_string(scene.triangles.size()) + " triangles", "who",
        {"wall ms [quartiles]", "core ms", "Mtri/s", "bytes/tri", "SAH cost", "x as fast, wall / core"});
    for (const unsigned threads : {1u, options.threads}) {
        const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
        Race race;
        tbb::task_arena arena(static_cast<int>(threads));
        arena.execute([&] {
            for (int round = 0; round < options.rounds; ++round) run_round(race, scene, threads, options);
        });
        report_race_of(report, race, static_cast<double>(scene.triangles.size()), threads, with_embree);
        if (options.threads == 1) break;
    }
}

}  // namespace bench
