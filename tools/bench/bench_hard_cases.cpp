#include "bench_errors.h"
#include "comparators/closest.h"
#include "hard_rays.h"
#include "support/shapes.h"
#include "support/specification.h"
#ifdef BENCH_HAS_EMBREE
#include "embree_side.h"
#endif

#include "raycore/isa.h"
#include "raycore/query.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <tuple>

namespace bench {

namespace {

constexpr std::size_t kChunk = 16'384;
constexpr std::size_t kOracleEvery = 8;  // chunks: the oracle takes fifty times as long

struct Ours {
    std::uint64_t leaks = 0, any_differs = 0, bits_differ = 0, wrong = 0, asked_oracle = 0;
};
struct Theirs {
    std::uint64_t leaks = 0, any_differs = 0;
};

std::vector<rc::Isa> isas() {
    std::vector<rc::Isa> all;
    for (const rc::Isa isa : {rc::Isa::Avx512, rc::Isa::Avx2, rc::Isa::Scalar})
        if (rc::is_isa_supported(isa)) all.push_back(isa);
    return all;
}

std::vector<rc::Hit> ask(const rc::Scene& scene, std::span<const rc::Ray> rays, bool in_batches) {
    std::vector<rc::Hit> hits(rays.size());
    if (in_batches) {
        rc::closest_hits(scene, rays, rc::kAllLayers, hits);
        return hits;
    }
    for (std::size_t i = 0; i < rays.size(); ++i)
        hits[i] = rc::closest_hit(scene, rays[i], rc::kAllLayers).value_or(rc::Hit{});
    return hits;
}

std::uint64_t differing(std::span<const rc::Hit> a, std::span<const rc::Hit> b) {
    std::uint64_t count = 0;
    for (std::size_t i = 0; i < a.size(); ++i) count += !test::same_bits(a[i], b[i]);
    return count;
}

template <class Hits, class Any>
void count_leaks(const Hits& hits, const Any& any, std::uint64_t& leaks, std::uint64_t& any_differs) {
    for (std::size_t i = 0; i < hits.size(); ++i) {
        leaks += hits[i].is_miss();
        any_differs += hits[i].is_miss() == (any[i] != 0);
    }
}

// One by one on the best instruction set, in batches on the next, and now and then on the slowest and by the oracle.
void ask_ours(const rc::Scene& scene, const comparators::KdTree& oracle, std::span<const rc::Ray> rays,
              std::size_t chunk, Ours& ours) {
    const std::vector<rc::Isa> all = isas();
    (void)rc::use_isa(all.front());
    const std::vector<rc::Hit> hits = ask(scene, rays, false);
    std::vector<std::uint8_t> any(rays.size());
    (void)rc::use_isa(all[std::min<std::size_t>(1, all.size() - 1)]);
    ours.bits_differ += differing(hits, ask(scene, rays, true));
    rc::any_hits(scene, rays, rc::kAllLayers, any);
    count_leaks(hits, any, ours.leaks, ours.any_differs);
    if (chunk % kOracleEvery == 0) {
        (void)rc::use_isa(all.back());
        const std::span<const rc::Ray> some = rays.first(std::min<std::size_t>(rays.size(), kChunk / 8));
        ours.bits_differ += differing(std::span(hits).first(some.size()), ask(scene, some, true));
        for (std::size_t i = 0; i < some.size(); ++i)
            ours.wrong +=
                !test::same_bits(hits[i], comparators::closest<test::Specification>(oracle, some[i]));
        ours.asked_oracle += some.size();
    }
    (void)rc::use_isa(all.front());
}

#ifdef BENCH_HAS_EMBREE
struct Peer {
    EmbreeMode mode;
    EmbreeCall call;
};
constexpr Peer kPeers[] = {{EmbreeMode::Fast, EmbreeCall::Single},
                           {EmbreeMode::Fast, EmbreeCall::Packet16},
                           {EmbreeMode::Robust, EmbreeCall::Single},
                           {EmbreeMode::Robust, EmbreeCall::Packet16}};

void ask_theirs(const EmbreeSide& side, EmbreeCall call, std::span<const rc::Ray> rays, Theirs& theirs) {
    std::vector<rc::Hit> hits(rays.size());
    std::vector<std::uint8_t> any(rays.size());
    side.closest(rays, call, hits);
    side.any(rays, call, any);
    count_leaks(hits, any, theirs.leaks, theirs.any_differs);
}
#endif

void run_case(Report& report, const HardCase& hard, const ErrorOptions& options) {
    rc::SceneBuilder builder;
    builder.add({rc::build_blas(hard.scene.view(), {rc::BuildQuality::High})});
    const auto scene = builder.commit();
    const comparators::Soup soup(hard.scene.view());
    const comparators::KdTree oracle(soup);
    Ours ours;
    std::array<Theirs, 4> theirs;
#ifdef BENCH_HAS_EMBREE
    const EmbreeSide fast(hard.scene, EmbreeMode::Fast, EmbreeQuality::High, 1),
        robust(hard.scene, EmbreeMode::Robust, EmbreeQuality::High, 1);
#endif
    test::Random random(71);
    const auto count = static_cast<std::size_t>(hard.share * static_cast<double>(options.rays));
    std::vector<rc::Ray> rays;
    for (std::size_t begin = 0; begin < count; begin += kChunk) {
        rays.clear();
        for (std::size_t i = begin; i < std::min(count, begin + kChunk); ++i)
            rays.push_back(hard.ray(random));
        ask_ours(*scene, oracle, rays, begin / kChunk, ours);
#ifdef BENCH_HAS_EMBREE
        for (std::size_t p = 0; options.with_embree && p < std::size(kPeers); ++p)
            ask_theirs(kPeers[p].mode == EmbreeMode::Fast ? fast : robust, kPeers[p].call, rays, theirs[p]);
#endif
    }
    report.row(hard.name).count(count).count(ours.leaks).count(ours.any_differs).count(ours.bits_differ);
    report.text(std::to_string(ours.wrong) + " of " + std::to_string(ours.asked_oracle));
    for (const Theirs& t : theirs)
        options.with_embree ? report.text(std::to_string(t.leaks) + ", " + std::to_string(t.any_differs))
                            : report.none();
}

}  // namespace

void bench_hard_cases(Report& report, const ErrorOptions& options) {
    report.table("rays that must hit: leaks; Embree: leaks, rays whose closest and any disagree", "aimed at",
                 {"rays", "raycore leaks", "any differs", "bits differ", "not the oracle's", "embree fast",
                  "fast packets", "embree robust", "robust packets"});
    for (const HardCase& hard : hard_cases()) run_case(report, hard, options);
    report.note("bits differ: one by one on the best instruction set against batches on the others");
}

}  // namespace bench
