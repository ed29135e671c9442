#include "bench_errors.h"
#include "bench_rays.h"
#include "support/brute_force.h"
#include "support/random.h"
#ifdef BENCH_HAS_EMBREE
#include "embree_side.h"
#endif

#include "raycore/isa.h"
#include "raycore/query.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <functional>
#include <numeric>

namespace bench {

namespace {

using Hits = std::vector<rc::Hit>;
// Who answers: the scene, the rays, single or in batches of 16, on the wide instruction set or on AVX2.
using Asker = std::function<Hits(const BenchScene&, std::span<const rc::Ray>, bool is_batched, bool is_avx2)>;

Hits ask_raycore(const BenchScene& scene, std::span<const rc::Ray> rays, bool is_batched, bool is_avx2) {
    const rc::Isa before = rc::active_isa();
    if (is_avx2) (void)rc::use_isa(rc::Isa::Avx2);
    rc::SceneBuilder builder;
    builder.add({rc::build_blas(scene.view(), {rc::BuildQuality::High})});
    const auto built = builder.commit();
    Hits hits(rays.size());
    for (std::size_t i = 0; i < rays.size(); i += is_batched ? 16 : 1) {
        const std::size_t n = std::min<std::size_t>(is_batched ? 16 : 1, rays.size() - i);
        rc::closest_hits(*built, rays.subspan(i, n), rc::kAllLayers, std::span(hits).subspan(i, n));
    }
    (void)rc::use_isa(before);
    return hits;
}

#ifdef BENCH_HAS_EMBREE
Asker embree(EmbreeMode mode) {
    return [mode](const BenchScene& scene, std::span<const rc::Ray> rays, bool is_batched, bool is_avx2) {
        const EmbreeSide side(scene, mode, EmbreeQuality::High, 1, is_avx2 ? "isa=avx2" : "");
        Hits hits(rays.size());
        side.closest(rays, is_batched ? EmbreeCall::Packet16 : EmbreeCall::Single, hits);
        return hits;
    };
}
#endif

struct Difference {
    std::uint64_t bits = 0, triangles = 0;
};

Difference difference(const Hits& a, const Hits& b) {
    Difference d;
    for (std::size_t i = 0; i < a.size(); ++i) {
        d.bits += !test::same_bits(a[i], b[i]);
        d.triangles += a[i].primitive != b[i].primitive;
    }
    return d;
}

BenchScene scaled(BenchScene scene, float factor) {
    for (glm::vec3& p : scene.positions) p *= factor;
    return scene;
}

// What a larger or smaller world says, brought back.
Hits at_scale(const Asker& ask, const BenchScene& scene, std::span<const rc::Ray> rays, float factor) {
    std::vector<rc::Ray> moved(rays.begin(), rays.end());
    for (rc::Ray& ray : moved) {
        ray.origin *= factor;
        ray.direction *= factor;
    }
    return ask(scaled(scene, factor), moved, false, false);
}

// The same triangles in another order, the answers named as before.
Hits in_another_order(const Asker& ask, const BenchScene& scene, std::span<const rc::Ray> rays) {
    std::vector<std::uint32_t> order(scene.triangles.size());
    std::iota(order.begin(), order.end(), 0u);
    test::Random random(81);
    for (std::size_t i = order.size(); i > 1; --i)
        std::swap(order[i - 1], order[random.below(static_cast<std::uint32_t>(i))]);
    BenchScene other = scene;
    for (std::size_t i = 0; i < order.size(); ++i) other.triangles[i] = scene.triangles[order[i]];
    Hits hits = ask(other, rays, false, false);
    for (rc::Hit& hit : hits)
        if (!hit.is_miss()) hit.primitive = order[hit.primitive];
    return hits;
}

void report_asker(Report& report, const char* name, const Asker& ask, const BenchScene& scene,
                  std::span<const rc::Ray> rays) {
    const Hits first = ask(scene, rays, false, false);
    const auto cell = [&](const Hits& other) {
        const Difference d = difference(first, other);
        report.text(std::to_string(d.bits) + ", " + std::to_string(d.triangles));
    };
    report.row(name).count(rays.size());
    cell(ask(scene, rays, false, true));
    cell(ask(scene, rays, true, false));
    cell(at_scale(ask, scene, rays, 0x1p20f));
    cell(at_scale(ask, scene, rays, 0x1p-33f));
    cell(in_another_order(ask, scene, rays));
}

}  // namespace

void bench_same_bits(Report& report, const ErrorOptions& options) {
    const BenchScene interior = make_interior();
    rc::SceneBuilder builder;
    builder.add({rc::build_blas(interior.view())});
    const auto built = builder.commit();
    std::vector<rc::Ray> rays;
    for (const RaySet& set : make_ray_sets(interior, *built, 32))
        if (!set.any) rays.insert(rays.end(), set.rays.begin(), set.rays.end());
    report.table("rays answered differently: in a bit, by another triangle", "who",
                 {"rays", "AVX2 for 512", "batched", "times 2^20", "times 2^-33", "triangles shuffled"});
    report_asker(report, "raycore", ask_raycore, interior, rays);
#ifdef BENCH_HAS_EMBREE
    if (options.with_embree) {
        report_asker(report, "embree fast", embree(EmbreeMode::Fast), interior, rays);
        report_asker(report, "embree robust", embree(EmbreeMode::Robust), interior, rays);
    }
#else
    (void)options;
#endif
    report.note("where raycore meets two triangles at one t the lower id wins, and shuffling renames those");
}

}  // namespace bench
