#include "bench_errors.h"
#include "bench_rays.h"
#include "comparators/closest.h"
#include "hard_rays.h"
#include "support/specification.h"
#ifdef BENCH_HAS_EMBREE
#include "embree_side.h"
#endif

#include "raycore/isa.h"
#include "raycore/query.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <functional>

namespace bench {

namespace {

// A mesh prepared for everybody.
struct Arena {
    explicit Arena(const BenchScene& source)
        : scene(source), soup(source.view()), all(soup), grid(soup), tree(soup) {
        rc::SceneBuilder builder;
        builder.add({rc::build_blas(source.view(), {rc::BuildQuality::High})});
        built = builder.commit();
    }

    const BenchScene& scene;
    comparators::Soup soup;
    comparators::BruteForce all;
    comparators::UniformGrid grid;
    comparators::KdTree tree;
    std::shared_ptr<const rc::Scene> built;
#ifdef BENCH_HAS_EMBREE
    EmbreeSide fast{scene, EmbreeMode::Fast, EmbreeQuality::High, 1};
    EmbreeSide robust{scene, EmbreeMode::Robust, EmbreeQuality::High, 1};
#endif
};

using Asker = std::function<void(const Arena&, std::span<const rc::Ray>, std::span<rc::Hit>)>;

struct Method {
    std::string name;
    std::size_t share = 1;  // asks every so many-th part of the rays
    Asker ask;
    Samples speed{};
    std::uint64_t leaks = 0, aimed = 0, wrong = 0, asked = 0;
    std::vector<double> ulps{};  // of t, one a hit
    double worst_conditioned =
        0;  // error of t over what moving the ray by 2^-24 of the distances involved does
};

template <class Test, class Choose>
Asker asker(Choose choose) {
    return [choose](const Arena& arena, std::span<const rc::Ray> rays, std::span<rc::Hit> hits) {
        for (std::size_t i = 0; i < rays.size(); ++i)
            hits[i] = comparators::closest<Test>(choose(arena), rays[i]);
    };
}

template <class Choose>
void add_structure(std::vector<Method>& methods, const std::string& name, std::size_t share, Choose choose) {
    using comparators::MoellerTrumbore;
    methods.push_back({name + ", Moeller-Trumbore", share, asker<MoellerTrumbore<float>>(choose)});
    methods.push_back({name + ", the same in double", share, asker<MoellerTrumbore<double>>(choose)});
    methods.push_back({name + ", Woop", share, asker<comparators::Woop>(choose)});
    methods.push_back({name + ", raycore's test", share, asker<test::Specification>(choose)});
}

std::vector<Method> all_methods(bool with_embree) {
    std::vector<Method> methods;
    add_structure(
        methods, "brute force", 400, [](const Arena& a) -> auto& { return a.all; });
    add_structure(
        methods, "grid", 8, [](const Arena& a) -> auto& { return a.grid; });
    add_structure(
        methods, "kD-tree", 8, [](const Arena& a) -> auto& { return a.tree; });
    for (const rc::Isa isa : {rc::Isa::Scalar, rc::Isa::Avx2, rc::Isa::Avx512}) {
        if (!rc::is_isa_supported(isa)) continue;
        methods.push_back({"raycore " + std::string(rc::isa_name(isa)), 1,
                           [isa](const Arena& arena, std::span<const rc::Ray> rays, std::span<rc::Hit> hits) {
                               const rc::Isa before = rc::active_isa();
                               (void)rc::use_isa(isa);
                               rc::closest_hits(*arena.built, rays, rc::kAllLayers, hits);
                               (void)rc::use_isa(before);
                           }});
    }
#ifdef BENCH_HAS_EMBREE
    if (!with_embree) return methods;
    const auto embree = [](EmbreeMode mode, EmbreeCall call) -> Asker {
        return [mode, call](const Arena& arena, std::span<const rc::Ray> rays, std::span<rc::Hit> hits) {
            (mode == EmbreeMode::Fast ? arena.fast : arena.robust).closest(rays, call, hits);
        };
    };
    methods.push_back({"embree fast", 1, embree(EmbreeMode::Fast, EmbreeCall::Single)});
    methods.push_back({"embree fast, packets of 16", 1, embree(EmbreeMode::Fast, EmbreeCall::Packet16)});
    methods.push_back({"embree robust", 1, embree(EmbreeMode::Robust, EmbreeCall::Single)});
#else
    (void)with_embree;
#endif
    return methods;
}

// How a ray passes one triangle, in double: t, and how deep inside its outline (negative: outside), in metres.
struct Passing {
    double t = 0, inside = 0, cosine = 0;
    bool is_parallel = true;
};

Passing passing(const rc::Ray& ray, const comparators::Corners& p) {
    const glm::dvec3 a(p[0]), e1 = glm::dvec3(p[1]) - a, e2 = glm::dvec3(p[2]) - a, d(ray.direction);
    const glm::dvec3 h = glm::cross(d, e2), s = glm::dvec3(ray.origin) - a, q = glm::cross(s, e1);
    const double determinant = glm::dot(e1, h);
    if (determinant == 0) return {};
    const double u = glm::dot(s, h) / determinant, v = glm::dot(d, q) / determinant;
    const double twice_area = glm::length(glm::cross(e1, e2));
    const double inside =
        twice_area * std::min({u / glm::length(e2), v / glm::length(e1), (1 - u - v) / glm::length(e2 - e1)});
    const double cosine = std::abs(determinant) / (twice_area * glm::length(d));
    return {glm::dot(e2, q) / determinant, inside, cosine, false};
}

// Wrong: met what the ray passes clearly outside of, or passed what it clearly meets.
void judge(const Arena& arena, std::span<const std::uint32_t> soup_of, const rc::Ray& ray, const rc::Hit& hit,
           Method& method) {
    const double reach = comparators::reach_of(ray.origin) + arena.soup.reach;
    const double sure = 16 * 0x1p-24 * reach;
    const rc::Hit truth = comparators::closest<comparators::MoellerTrumbore<double>>(arena.tree, ray);
    ++method.asked;
    Passing met;
    if (!hit.is_miss()) {
        met = passing(ray, arena.soup.corners[soup_of[hit.primitive]]);
        const double error = std::abs(static_cast<double>(hit.t) - met.t);
        const float step = std::nextafter(std::abs(hit.t), rc::kInfinity) - std::abs(hit.t);
        if (!met.is_parallel) {
            method.ulps.push_back(error / static_cast<double>(step));
            const double length = glm::length(glm::dvec3(ray.direction));
            const double moved = 0x1p-24 * reach / (length * met.cosine) + 0.5 * static_cast<double>(step);
            method.worst_conditioned = std::max(method.worst_conditioned, error / moved);
        }
        if (met.is_parallel || met.inside < -sure) {
            ++method.wrong;
            return;
        }
    }
    if (truth.is_miss()) return;
    const Passing best = passing(ray, arena.soup.corners[soup_of[truth.primitive]]);
    const double slack = sure / comparators::reach_of(ray.direction) + 1e-6 * std::abs(best.t);
    if (best.inside > sure && (hit.is_miss() || met.t > best.t + slack)) ++method.wrong;
}

double share_of(std::vector<double>& values, double share) {
    if (values.empty()) return 0;
    const auto at =
        values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
    std::nth_element(values.begin(), at, values.end());
    return *at;
}

// Speed, wrong hits and t: diffuse rays in the interior.
void run_interior(std::vector<Method>& methods, const ErrorOptions& options) {
    const BenchScene interior = make_interior();
    const Arena arena(interior);
    const std::vector<rc::Ray> rays = make_ray_sets(interior, *arena.built, 16).back().rays;
    std::vector<std::uint32_t> soup_of(interior.triangles.size(), 0);
    for (std::uint32_t i = 0; i < arena.soup.primitive.size(); ++i) soup_of[arena.soup.primitive[i]] = i;
    std::vector<rc::Hit> hits(rays.size());
    for (int round = 0; round < options.rounds; ++round) {
        for (Method& method : methods) {
            const std::span<const rc::Ray> some = std::span(rays).first(rays.size() / method.share);
            const double start = thread_ms();
            method.ask(arena, some, std::span(hits).first(some.size()));
            method.speed.ms.push_back(static_cast<double>(some.size()) / (thread_ms() - start) * 1e-3);
            if (round != 0) continue;
            for (std::size_t i = 0; i < std::min<std::size_t>(some.size(), 20'000); ++i)
                judge(arena, soup_of, some[i], hits[i], method);
        }
    }
}

// Leaks: at vertices and edges of a closed ball, from inside.
void run_closed_ball(std::vector<Method>& methods, const ErrorOptions& options) {
    const std::vector<HardCase> cases = hard_cases();
    for (std::size_t c = 0; c < 2; ++c) {
        const Arena arena(cases[c].scene);
        test::Random random(72);
        std::vector<rc::Ray> rays;
        for (std::size_t i = 0; i < options.rays / 5; ++i) rays.push_back(cases[c].ray(random));
        std::vector<rc::Hit> hits(rays.size());
        for (Method& method : methods) {
            const std::size_t n = rays.size() / method.share;
            method.ask(arena, std::span(rays).first(n), std::span(hits).first(n));
            method.aimed += n;
            for (std::size_t i = 0; i < n; ++i) method.leaks += hits[i].is_miss();
        }
    }
}

}  // namespace

void bench_speed_error(Report& report, const ErrorOptions& options) {
    std::vector<Method> methods = all_methods(options.with_embree);
    run_interior(methods, options);
    run_closed_ball(methods, options);
    report.table(
        "speed against error: diffuse rays in the interior; leaks at vertices and edges of a closed ball",
        "structure, triangle test",
        {"Mrays/s [quartiles]", "leaks a million", "wrong a million", "t: median ulp", "99.9 %", "worst",
         "conditioned"});
    for (Method& method : methods) {
        const auto per_million = [](std::uint64_t n, std::uint64_t of) {
            return 1e6 * static_cast<double>(n) / static_cast<double>(std::max<std::uint64_t>(1, of));
        };
        report.row(method.name).spread(method.speed, 3);
        report.number(per_million(method.leaks, method.aimed), 1)
            .number(per_million(method.wrong, method.asked), 1);
        report.number(share_of(method.ulps, 0.5), 1).number(share_of(method.ulps, 0.999), 1);
        report.number(share_of(method.ulps, 1.0), 1).number(method.worst_conditioned, 2);
    }
    report.note(
        "conditioned: the worst error of t over what moving the ray by 2^-24 of the distances involved would "
        "do to it");
    report.note("brute force is asked every 400th part of the rays, grid and kD-tree every 8th");
}

}  // namespace bench
