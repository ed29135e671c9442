// raycore_bench - how fast, beside Embree 3 on the same rays in the same interleaved run.
//
// Every contestant answers every ray set once a round, in turn, so that a slow second of the machine hits all alike;
// medians over the rounds, with quartiles, and a hash of the answers, so that a fast wrong answer is caught.
#include "bench_rays.h"
#include "bench_scenes.h"

#include <CLI/CLI.hpp>
#include <tbb/global_control.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <ctime>
#include <functional>
#ifdef BENCH_HAS_EMBREE
#include "embree_side.h"
#endif

#include "raycore/isa.h"
#include "raycore/query.h"

namespace {

double now_ms() {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now().time_since_epoch())
        .count();
}

// Processor time of this thread: what others on the machine take is not counted against whoever was asked meanwhile.
double thread_ms() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return double(now.tv_sec) * 1e3 + double(now.tv_nsec) * 1e-6;
}

struct Figures {
    std::vector<double> samples;

    double at(double share) const {
        std::vector<double> sorted = samples;
        std::sort(sorted.begin(), sorted.end());
        return sorted[static_cast<std::size_t>(share * double(sorted.size() - 1) + 0.5)];
    }
};

struct Answer {
    std::uint64_t hits = 0, hash = 0;
    void add(bool is_hit, std::uint32_t primitive) {
        hits += is_hit;
        hash = (hash ^ (is_hit ? primitive + 1u : 0u)) * 0x100000001B3u;
    }
};

struct Contestant {
    std::string name;
    std::function<Answer(const bench::RaySet&)> ask;
};

Answer ask_single(const rc::Scene& scene, const bench::RaySet& set) {
    Answer answer;
    for (const rc::Ray& ray : set.rays) {
        if (set.any) {
            answer.add(rc::any_hit(scene, ray, rc::kAllLayers), 0);
        } else {
            const std::optional<rc::Hit> hit = rc::closest_hit(scene, ray, rc::kAllLayers);
            answer.add(hit.has_value(), hit ? hit->primitive : 0);
        }
    }
    return answer;
}

Answer ask_batches(const rc::Scene& scene, const bench::RaySet& set, std::size_t size) {
    Answer answer;
    std::vector<rc::Hit> hits(size);
    std::vector<std::uint8_t> is_hit(size);
    for (std::size_t begin = 0; begin < set.rays.size(); begin += size) {
        const std::size_t n = std::min(size, set.rays.size() - begin);
        const std::span<const rc::Ray> rays(set.rays.data() + begin, n);
        if (set.any) {
            rc::any_hits(scene, rays, rc::kAllLayers, std::span(is_hit).first(n));
            for (std::size_t i = 0; i < n; ++i) answer.add(is_hit[i] != 0, 0);
        } else {
            rc::closest_hits(scene, rays, rc::kAllLayers, std::span(hits).first(n));
            for (std::size_t i = 0; i < n; ++i) answer.add(!hits[i].is_miss(), hits[i].primitive);
        }
    }
    return answer;
}

void race(const std::vector<Contestant>& contestants, const std::vector<bench::RaySet>& sets, int rounds) {
    std::printf("%-9s %-22s %8s %15s %7s  %10s %s\n", "rays", "who", "Mrays/s", "[quartiles]", "ratio",
                "hits", "answer");
    for (const bench::RaySet& set : sets) {
        std::vector<Figures> speed(contestants.size());
        std::vector<Answer> answers(contestants.size());
        for (int round = 0; round < rounds; ++round) {
            for (std::size_t c = 0; c < contestants.size(); ++c) {
                const double start = thread_ms();
                answers[c] = contestants[c].ask(set);
                speed[c].samples.push_back(double(set.rays.size()) / (thread_ms() - start) * 1e-3);
            }
        }
        for (std::size_t c = 0; c < contestants.size(); ++c) {
            Figures ratio;  // to the last contestant, round by round
            for (std::size_t r = 0; r < speed[c].samples.size(); ++r)
                ratio.samples.push_back(speed[c].samples[r] / speed.back().samples[r]);
            std::printf("%-9s %-22s %8.2f [%6.2f %6.2f] %7.2f  %10llu %016llx\n", set.name.c_str(),
                        contestants[c].name.c_str(), speed[c].at(0.5), speed[c].at(0.25), speed[c].at(0.75),
                        ratio.at(0.5), static_cast<unsigned long long>(answers[c].hits),
                        static_cast<unsigned long long>(answers[c].hash));
        }
    }
}

struct Options {
    std::string scene, isa;
    std::vector<float> camera;
    int rounds = 10, keep = 4;
    unsigned threads = 2;
    bool no_embree = false, no_builds = false;
};

void print_tree(const rc::Blas& blas, const std::vector<bench::RaySet>& sets, const rc::Scene& scene) {
    std::printf("tree: %.1f bytes a triangle, cost %.1f\n",
                double(blas.byte_size()) / double(std::max<std::size_t>(1, blas.report().kept())),
                double(blas.sah_cost()));
    for (const bench::RaySet& set : sets) {
        rc::Counters counters;
        std::vector<rc::Hit> hits(set.rays.size());
        std::vector<std::uint8_t> any(set.rays.size());
        if (set.any)
            rc::any_hits(scene, set.rays, rc::kAllLayers, any, &counters);
        else
            rc::closest_hits(scene, set.rays, rc::kAllLayers, hits, &counters);
        std::printf("  %-8s %.2f nodes, %.2f leaves a ray\n", set.name.c_str(),
                    double(counters.nodes) / double(counters.rays),
                    double(counters.leaves) / double(counters.rays));
    }
}

double median_ms(int rounds, const std::function<void()>& work) {
    Figures ms;
    for (int i = 0; i < rounds; ++i) {
        const double start = now_ms();
        work();
        ms.samples.push_back(now_ms() - start);
    }
    return ms.at(0.5);
}

void time_builds(const bench::BenchScene& source, const Options& options) {
    const std::shared_ptr<rc::Blas> blas = rc::build_blas(source.view());
    for (const unsigned threads : {1u, options.threads}) {
        const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
        const double build = median_ms(5, [&] { (void)rc::build_blas(source.view()); });
        const double refit = median_ms(10, [&] { rc::refit_blas(*blas, source.positions); });
        std::printf("%u threads: build %.1f ms (%.2f Mtri/s), refit %.2f ms", threads, build,
                    double(source.triangles.size()) / build * 1e-3, refit);
#ifdef BENCH_HAS_EMBREE
        if (!options.no_embree) {
            const double medium =
                bench::EmbreeSide(source, bench::EmbreeMode::Fast, false, threads).build_ms();
            const double high = bench::EmbreeSide(source, bench::EmbreeMode::Fast, true, threads).build_ms();
            std::printf("; Embree medium %.1f ms, high %.1f ms", medium, high);
        }
#endif
        std::printf("\n");
    }
    for (const int n : {200, 10000}) {
        rc::SceneBuilder builder;
        for (int i = 0; i < n; ++i) {
            glm::mat4x3 place(1.0f);
            place[3] = glm::vec3(float(i % 100) * 3.0f, float(i / 100 % 10) * 3.0f, float(i / 1000) * 3.0f);
            builder.add({blas, place, rc::kAllLayers});
        }
        std::printf("top level of %d instances: %.3f ms\n", n,
                    median_ms(10, [&] { (void)builder.commit(); }));
    }
}

Options read_options(int argc, char** argv) {
    Options options;
    CLI::App app("Rays, builds and refits of raycore beside Embree 3.");
    app.add_option("--scene", options.scene, "a glTF file or a raw mesh; without it a procedural interior");
    app.add_option("--camera", options.camera, "x,y,z,yaw,pitch,fov in metres and radians")
        ->delimiter(',')
        ->expected(6);
    app.add_option("--rounds", options.rounds, "rounds of the race; medians are over them");
    app.add_option("--keep", options.keep, "every how many-th 8x8 tile of 1280x720 is asked");
    app.add_option("--threads", options.threads, "threads of the second build row");
    app.add_option("--isa", options.isa, "scalar, avx2 or avx512");
    app.add_flag("--no-embree", options.no_embree, "raycore alone");
    app.add_flag("--no-builds", options.no_builds, "queries alone");
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        std::exit(app.exit(error) == 0 ? 0 : 2);
    }
    return options;
}

}  // namespace

int main(int argc, char** argv) {
    const Options options = read_options(argc, argv);
    if (!options.isa.empty()) {
        const std::optional<rc::Isa> isa = rc::isa_from_name(options.isa);
        if (!isa || !rc::use_isa(*isa))
            return std::fprintf(stderr, "--isa %s: not known here\n", options.isa.c_str()), 2;
    }
    std::optional<bench::BenchScene> source =
        options.scene.empty() ? bench::make_interior() : bench::read_scene(options.scene);
    if (!source) return 2;
    if (options.camera.size() == 6)
        source->camera = {{options.camera[0], options.camera[1], options.camera[2]},
                          options.camera[3],
                          options.camera[4],
                          options.camera[5]};
    std::printf("%s: %zu triangles, %s\n", source->name.c_str(), source->triangles.size(),
                std::string(rc::isa_name(rc::active_isa())).c_str());

    rc::SceneBuilder builder;
    const std::shared_ptr<rc::Blas> blas = rc::build_blas(source->view());
    builder.add({blas});
    const std::shared_ptr<const rc::Scene> scene = builder.commit();
    const std::vector<bench::RaySet> sets = bench::make_ray_sets(*source, *scene, options.keep);
    print_tree(*blas, sets, *scene);

    std::vector<Contestant> contestants{
        {"raycore single", [&](const bench::RaySet& set) { return ask_single(*scene, set); }},
        {"raycore batches of 64", [&](const bench::RaySet& set) { return ask_batches(*scene, set, 64); }},
    };
#ifdef BENCH_HAS_EMBREE
    std::vector<std::unique_ptr<bench::EmbreeSide>> peers;
    if (!options.no_embree) {
        const auto enter = [&](const char* name, bench::EmbreeMode mode, bool high, bench::EmbreeCall call) {
            peers.push_back(std::make_unique<bench::EmbreeSide>(*source, mode, high, options.threads));
            contestants.push_back({name, [peer = peers.back().get(), call](const bench::RaySet& set) {
                                       const bench::Answer a = peer->ask(set, call);
                                       return Answer{a.hits, a.hash};
                                   }});
        };
        enter("embree packets of 16", bench::EmbreeMode::Fast, true, bench::EmbreeCall::Packet16);
        enter("embree robust", bench::EmbreeMode::Robust, true, bench::EmbreeCall::Single);
        enter("embree medium", bench::EmbreeMode::Fast, false, bench::EmbreeCall::Single);
        enter("embree high", bench::EmbreeMode::Fast, true, bench::EmbreeCall::Single);
    }
#endif
    race(contestants, sets, options.rounds);
    if (!options.no_builds) time_builds(*source, options);
    return 0;
}
