#include "bench_placed.h"

#include "bench_race.h"
#include "load/level_loader.h"
#include "raycore_side.h"
#include "spatial/stage.h"
#include "spatial/transforms.h"
#include "world/initial_state.h"
#ifdef BENCH_HAS_EMBREE
#include "embree_side.h"
#endif

#include <cstdio>
#include <utility>

namespace bench {

namespace {

#ifdef BENCH_HAS_EMBREE
// The same instances in Embree's hands; a guard stands as it was modelled.
std::unique_ptr<EmbreePlaced> place_in_embree(const gh::world::Level& level, const gh::world::State& state,
                                              unsigned threads) {
    std::vector<BenchScene> meshes;
    for (const gh::world::Mesh& mesh : level.meshes)
        meshes.push_back({"", mesh.positions, mesh.triangles, {}, {}, {}});
    std::vector<EmbreePlaced::Placed> instances;
    for (std::size_t i = 0; i < level.parts.size(); ++i)
        if (gh::spatial::layers_of_part(level, state, i) != 0)
            instances.push_back({level.parts[i].mesh, gh::spatial::world_from_part(level, state, i)});
    return std::make_unique<EmbreePlaced>(meshes, instances, threads);
}
#endif

void report_counts(Report& report, const rc::Scene& placed, const RaycoreSide& whole,
                   const std::vector<RaySet>& sets) {
    const std::vector<std::string> columns = names_of(sets);
    report.table("museum as committed: instances, nodes, leaves a ray", "trees", columns);
    const auto row = [&](const char* name, auto&& count) {
        report.row(name);
        for (const RaySet& set : sets) {
            const rc::Counters c = count(set);
            const double rays = static_cast<double>(std::max<std::uint64_t>(1, c.rays));
            char text[64];
            std::snprintf(text, sizeof(text), "%.2f: %.2f + %.2f", static_cast<double>(c.instances) / rays,
                          static_cast<double>(c.nodes) / rays, static_cast<double>(c.leaves) / rays);
            report.text(text);
        }
    };
    row("one", [&](const RaySet& set) { return whole.count(set.rays, set.any); });
    row("as committed", [&](const RaySet& set) { return count_work(placed, set.rays, set.any); });
}

}  // namespace

bool bench_placed(Report& report, const std::string& level_file, const QueryOptions& options) {
    gh::Result<gh::world::Level> loaded = gh::load::load_level(level_file, {.finds_ways = false});
    if (!loaded) {
        std::fprintf(stderr, "%s\n", loaded.error().sentence.c_str());
        return false;
    }
    const auto level = std::make_shared<const gh::world::Level>(std::move(*loaded));
    const gh::world::State state = gh::world::initial_state(*level, 1);
    const std::shared_ptr<const rc::Scene> placed = gh::spatial::Stage(level).commit(state).scene;
    const BenchScene one = flatten(*level);
    const RaycoreSide whole(one, rc::BuildQuality::High);
    const std::vector<RaySet> sets = make_ray_sets(one, whole.scene(), options.keep);
    report_counts(report, *placed, whole, sets);

    std::vector<Contestant> contestants{
        {"one tree, single", [&](auto rays, bool any) { return whole.ask(rays, any, 1); }},
        {"one tree, batches", [&](auto rays, bool any) { return whole.ask(rays, any, options.batch); }},
        {"as committed, single", [&](auto rays, bool any) { return ask_single(*placed, rays, any); }},
        {"as committed, batches",
         [&](auto rays, bool any) { return ask_batches(*placed, rays, any, options.batch); }}};
#ifdef BENCH_HAS_EMBREE
    std::unique_ptr<EmbreePlaced> peer;
    if (options.with_embree) {
        peer = place_in_embree(*level, state, options.threads);
        contestants.push_back({"embree high, as committed",
                               [&](auto rays, bool any) { return peer->ask(rays, any); }});
    }
#endif
    const RaceResult result = race(contestants, sets, {options.rounds, 1});
    report_race(report, "museum as committed", contestants, sets, result, contestants.size() - 1);
    return true;
}

}  // namespace bench
