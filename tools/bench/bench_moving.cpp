// What moves every frame: a cloth that is refitted, and a crowd whose top level is built anew.
#include "bench_builds.h"
#include "bench_race.h"
#include "bench_timing.h"
#include "raycore_side.h"
#include "support/shapes.h"
#ifdef BENCH_HAS_EMBREE
#include "embree_side.h"
#endif

#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include <cmath>
#include <string>

namespace bench {

namespace {

constexpr std::uint32_t kClothCells = 256;

BenchScene make_cloth() {
    test::Mesh sheet = test::make_sheet(1.0f, 0.0f, kClothCells);
    return {"cloth", std::move(sheet.positions), std::move(sheet.triangles), {}, {}, {}};
}

void swing(const BenchScene& cloth, int frame, std::vector<glm::vec3>& out) {
    const float time = static_cast<float>(frame) / 60.0f;
    out = cloth.positions;
    for (glm::vec3& p : out) {
        const float far = 0.5f * (p.x + 1.0f);
        p.y =
            0.3f * far * std::sin(5.0f * p.x + 6.0f * time) + 0.1f * far * std::sin(9.0f * p.z + 4.0f * time);
        p.z += 0.1f * far * std::sin(3.0f * time);
    }
}

glm::mat4x3 place_of(std::size_t i, int frame) {
    const float angle = 0.1f * static_cast<float>(frame) + 0.7f * static_cast<float>(i);
    const float c = std::cos(angle), s = std::sin(angle);
    const std::size_t row = i / 100;
    const float x = static_cast<float>(i % 100) * 1.5f, z = static_cast<float>(row) * 1.5f;
    return {glm::vec3(c, 0, -s), glm::vec3(0, 1, 0), glm::vec3(s, 0, c),
            glm::vec3(x + 0.4f * c, 0.2f * s, z + 0.4f * s)};
}

std::vector<glm::mat4x3> places(std::size_t count, int frame) {
    std::vector<glm::mat4x3> all;
    for (std::size_t i = 0; i < count; ++i) all.push_back(place_of(i, frame));
    return all;
}

template <class Work>
void on_threads(unsigned threads, Work&& work) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    tbb::task_arena arena(static_cast<int>(threads));
    arena.execute(work);
}

void report_timing(Report& report, const std::string& name, const Timing& timing, double items,
                   const Timing* peer) {
    report.row(name).spread(timing.wall, 3).number(timing.core.at(0.5), 3);
    report.number(items / timing.wall.at(0.5) * 1e-3);
    peer != nullptr && !peer->wall.ms.empty() ? report.text(times_as_fast(timing, *peer)) : report.none();
}

void bench_cloth_on(Report& report, unsigned threads, const BuildOptions& options) {
    const BenchScene cloth = make_cloth();
    const std::shared_ptr<rc::Blas> blas = rc::build_blas(cloth.view());
    Timing refit, rebuild, their_refit;
    std::vector<glm::vec3> positions;
    on_threads(threads, [&] {
#ifdef BENCH_HAS_EMBREE
        std::unique_ptr<EmbreeCloth> peer;
        if (options.with_embree) peer = std::make_unique<EmbreeCloth>(cloth, threads);
#endif
        for (int frame = 0; frame < 4 * options.rounds; ++frame) {
            swing(cloth, frame, positions);
            refit.run([&] { rc::refit_blas(*blas, positions); });
            rebuild.run([&] {
                (void)rc::build_blas({positions, cloth.triangles}, {rc::BuildQuality::Fast});
            });
#ifdef BENCH_HAS_EMBREE
            if (!peer) continue;
            const BuildTime theirs = peer->move(positions);
            their_refit.add(theirs.wall_ms, theirs.core_ms);
#endif
        }
    });
    const double triangles = static_cast<double>(cloth.triangles.size());
    const std::string on = ", " + std::to_string(threads) + " thread(s)";
    report_timing(report, "raycore refit" + on, refit, triangles, &their_refit);
    if (!their_refit.wall.ms.empty())
        report_timing(report, "embree refit" + on, their_refit, triangles, nullptr);
    report_timing(report, "raycore build, fast" + on, rebuild, triangles, nullptr);
    report.note("cost after the last frame is " + std::to_string(blas->refit_degradation()) +
                " of what it was when built");
}

BenchScene make_walker() {
    test::Mesh ball = test::make_ball(glm::vec3(0.0f), 0.5f, 7);
    for (glm::vec3& p : ball.positions) p.y *= 1.0f + 0.5f * p.x;  // so that it matters which way it faces
    return {"walker", std::move(ball.positions), std::move(ball.triangles), {}, {}, {}};
}

struct Crowd {
    BenchScene walker = make_walker();
    std::shared_ptr<rc::Blas> blas = rc::build_blas(walker.view());
    rc::SceneBuilder builder;
    std::shared_ptr<const rc::Scene> scene;
#ifdef BENCH_HAS_EMBREE
    std::unique_ptr<EmbreeCrowd> low, medium;
#endif
};

void bench_crowd_on(Report& report, Crowd& crowd, std::size_t count, unsigned threads,
                    const BuildOptions& options) {
    Timing ours, low, medium;
    on_threads(threads, [&] {
        const std::vector<glm::mat4x3> start = places(count, 0);
        crowd.builder = {};
        for (const glm::mat4x3& place : start) crowd.builder.add({crowd.blas, place});
#ifdef BENCH_HAS_EMBREE
        if (options.with_embree) {
            crowd.low = std::make_unique<EmbreeCrowd>(crowd.walker, start, EmbreeQuality::Low, threads);
            crowd.medium = std::make_unique<EmbreeCrowd>(crowd.walker, start, EmbreeQuality::Medium, threads);
        }
#endif
        for (int frame = 1; frame <= 4 * options.rounds; ++frame) {
            const std::vector<glm::mat4x3> now = places(count, frame);
            ours.run([&] {
                for (std::uint32_t i = 0; i < count; ++i) crowd.builder.set_transform(i, now[i]);
                crowd.scene = crowd.builder.commit();
            });
#ifdef BENCH_HAS_EMBREE
            for (auto [peer, timing] : {std::pair(crowd.low.get(), &low), {crowd.medium.get(), &medium}}) {
                if (peer == nullptr) continue;
                const BuildTime theirs = peer->move(now);
                timing->add(theirs.wall_ms, theirs.core_ms);
            }
#endif
        }
    });
    const std::string on = ", " + std::to_string(count) + " on " + std::to_string(threads);
    report_timing(report, "raycore" + on, ours, static_cast<double>(count), &medium);
    if (low.wall.ms.empty()) return;
    report_timing(report, "embree low" + on, low, static_cast<double>(count), nullptr);
    report_timing(report, "embree medium" + on, medium, static_cast<double>(count), nullptr);
}

}  // namespace

void bench_cloth(Report& report, const BuildOptions& options) {
    report.table("a swinging cloth of " + std::to_string(2 * kClothCells * kClothCells) + " triangles", "who",
                 {"wall ms [quartiles]", "core ms", "Mtri/s", "x as fast, wall / core"});
    for (const unsigned threads : {1u, options.threads}) {
        bench_cloth_on(report, threads, options);
        if (options.threads == 1) break;
    }
}

void bench_crowd(Report& report, const BuildOptions& options) {
    Crowd crowd;
    report.table("top levels of instances that all move, on threads: transforms set and committed", "who",
                 {"wall ms [quartiles]", "core ms", "M instances/s", "x as fast as medium, wall / core"});
    for (const std::size_t count : {std::size_t{200}, std::size_t{10'000}}) {
        for (const unsigned threads : {1u, options.threads}) {
            bench_crowd_on(report, crowd, count, threads, options);
            if (options.threads == 1) break;
        }
    }
    BenchScene view;
    view.camera = {{75, 4.0f, 160}, 0.0f, -0.1f, 1.2f};
    view.lamp_low = {40, 30, 40};
    view.lamp_high = {110, 32, 110};
    const std::vector<RaySet> sets = make_ray_sets(view, *crowd.scene, 16);
    std::vector<Contestant> contestants{
        {"raycore, single", [&](auto rays, bool any) { return ask_single(*crowd.scene, rays, any); }},
        {"raycore, batches of 64",
         [&](auto rays, bool any) { return ask_batches(*crowd.scene, rays, any, 64); }}};
#ifdef BENCH_HAS_EMBREE
    if (crowd.medium) {
        contestants.push_back({"embree low", [&](auto rays, bool any) { return crowd.low->ask(rays, any); }});
        contestants.push_back(
            {"embree medium", [&](auto rays, bool any) { return crowd.medium->ask(rays, any); }});
    }
#endif
    const RaceResult result = race(contestants, sets, {options.rounds, 1});
    report_race(report, "10,000 moving instances", contestants, sets, result, contestants.size() - 1);
    report_answers(report, "10,000 moving instances", contestants, sets, result);
}

}  // namespace bench
