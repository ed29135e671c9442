#include "bench_queries.h"

#include "bench_race.h"
#include "raycore_side.h"
#ifdef BENCH_HAS_EMBREE
#include "embree_side.h"
#endif

#include <algorithm>
#include <cstdio>
#include <memory>

namespace bench {

namespace {

struct Field {
    std::vector<std::unique_ptr<RaycoreSide>> ours;
    std::vector<Contestant> contestants;
    std::size_t single = 0, batched = 0, fast = 0, medium = 0, robust = 0, packets = 0;
#ifdef BENCH_HAS_EMBREE
    std::vector<std::unique_ptr<EmbreeSide>> peers;
#endif
};

std::size_t enter_ours(Field& field, const RaycoreSide& side, const std::string& name, std::size_t batch) {
    field.contestants.push_back({name, [&side, batch](std::span<const rc::Ray> rays, bool any) {
                                     return side.ask(rays, any, batch);
                                 }});
    return field.contestants.size() - 1;
}

#ifdef BENCH_HAS_EMBREE
struct EmbreeWay {
    EmbreeMode mode;
    EmbreeQuality quality;
    EmbreeCall call;
};

std::size_t enter_embree(Field& field, const BenchScene& scene, unsigned threads, const std::string& name,
                         const EmbreeWay& way) {
    field.peers.push_back(std::make_unique<EmbreeSide>(scene, way.mode, way.quality, threads));
    const EmbreeSide* peer = field.peers.back().get();
    field.contestants.push_back(
        {name, [peer, call = way.call](auto rays, bool any) { return peer->ask(rays, any, call); }});
    return field.contestants.size() - 1;
}
#endif

void enter_all(Field& field, const BenchScene& scene, const QueryOptions& options) {
    field.ours.push_back(std::make_unique<RaycoreSide>(scene, rc::BuildQuality::High));
    field.ours.push_back(std::make_unique<RaycoreSide>(scene, rc::BuildQuality::Default));
    const std::string batches = "batches of " + std::to_string(options.batch);
    field.single = enter_ours(field, *field.ours[0], "raycore high, single", 1);
    field.batched = enter_ours(field, *field.ours[0], "raycore high, " + batches, options.batch);
    enter_ours(field, *field.ours[1], "raycore default, single", 1);
    enter_ours(field, *field.ours[1], "raycore default, " + batches, options.batch);
#ifdef BENCH_HAS_EMBREE
    if (!options.with_embree) return;
    const auto enter = [&](const char* name, EmbreeMode mode, EmbreeQuality quality, EmbreeCall call) {
        return enter_embree(field, scene, options.threads, name, {mode, quality, call});
    };
    field.packets =
        enter("embree high, packets of 16", EmbreeMode::Fast, EmbreeQuality::High, EmbreeCall::Packet16);
    field.robust = enter("embree high, robust", EmbreeMode::Robust, EmbreeQuality::High, EmbreeCall::Single);
    field.medium = enter("embree medium", EmbreeMode::Fast, EmbreeQuality::Medium, EmbreeCall::Single);
    field.fast = enter("embree high", EmbreeMode::Fast, EmbreeQuality::High, EmbreeCall::Single);
#endif
}

void report_trees(Report& report, const Field& field, const std::string& title,
                  const std::vector<RaySet>& sets) {
    std::vector<std::string> columns{"bytes/tri", "SAH cost"};
    for (const RaySet& set : sets) columns.push_back(set.name);
    report.table(title + ": nodes + leaves a ray", "tree", columns);
    for (const auto& side : field.ours) {
        report.row("raycore " + side->quality_name());
        report.number(side->bytes_per_triangle(), 1).number(static_cast<double>(side->blas().sah_cost()), 1);
        for (const RaySet& set : sets) {
            const rc::Counters c = side->count(set.rays, set.any);
            const double rays = static_cast<double>(std::max<std::uint64_t>(1, c.rays));
            char text[48];
            std::snprintf(text, sizeof(text), "%.2f + %.2f", static_cast<double>(c.nodes) / rays,
                          static_cast<double>(c.leaves) / rays);
            report.text(text);
        }
    }
}

// The comparisons somebody who would otherwise take Embree asks for.
void report_ratios(Report& report, const Field& field, const std::string& title,
                   const std::vector<RaySet>& sets, const RaceResult& result) {
    const std::vector<std::string> columns = names_of(sets);
    report.table(title + ": ratios, round by round [quartiles]", "raycore high / embree high", columns);
    const auto row = [&](const char* name, std::size_t ours, auto&& theirs) {
        report.row(name);
        for (std::size_t s = 0; s < sets.size(); ++s)
            report.spread(ratio_of(result.speed[ours][s], result.speed[theirs(s)][s]));
    };
    const auto median = [&](std::size_t c, std::size_t s) { return result.speed[c][s].at(0.5); };
    const auto best_single = [&](std::size_t s) {
        return median(field.medium, s) > median(field.fast, s) ? field.medium : field.fast;
    };
    row("single / fast", field.single, [&](std::size_t) { return field.fast; });
    row("single / robust", field.single, [&](std::size_t) { return field.robust; });
    row("batched / fast or medium, the best", field.batched, best_single);
    row("batched / packets of 16", field.batched, [&](std::size_t) { return field.packets; });
}

}  // namespace

void bench_queries(Report& report, const BenchScene& scene, const QueryOptions& options) {
    Field field;
    enter_all(field, scene, options);
    const std::vector<RaySet> sets = make_ray_sets(scene, field.ours[0]->scene(), options.keep);
    const std::string name = scene.name + ", " + std::to_string(scene.triangles.size()) + " triangles";
    report_trees(report, field, name, sets);
    for (const unsigned threads : {1u, options.threads}) {
        const RaceResult result = race(field.contestants, sets, {options.rounds, threads});
        const std::string title = name + ", " + std::to_string(threads) + " thread(s)";
        report_race(report, title, field.contestants, sets, result,
                    field.fast != 0 ? field.fast : field.contestants.size() - 1);
        if (threads == 1) report_answers(report, title, field.contestants, sets, result);
        if (field.fast != 0) report_ratios(report, field, title, sets, result);
        if (options.threads == 1) break;
    }
}

}  // namespace bench
