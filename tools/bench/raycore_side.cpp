#include "raycore_side.h"

#include <algorithm>
#include <vector>

namespace bench {

std::string name_of(rc::BuildQuality quality) {
    switch (quality) {
        case rc::BuildQuality::Fast:
            return "fast";
        case rc::BuildQuality::Default:
            return "default";
        case rc::BuildQuality::High:
            return "high";
    }
    return "unknown";
}

Answer ask_single(const rc::Scene& scene, std::span<const rc::Ray> rays, bool any) {
    Answer answer;
    for (const rc::Ray& ray : rays) {
        if (any) {
            answer.add(rc::any_hit(scene, ray, rc::kAllLayers), 0);
        } else {
            const std::optional<rc::Hit> hit = rc::closest_hit(scene, ray, rc::kAllLayers);
            answer.add(hit.has_value(), hit ? hit->primitive : 0);
        }
    }
    return answer;
}

Answer ask_batches(const rc::Scene& scene, std::span<const rc::Ray> rays, bool any, std::size_t batch) {
    Answer answer;
    std::vector<rc::Hit> hits(batch);
    std::vector<std::uint8_t> is_hit(batch);
    for (std::size_t begin = 0; begin < rays.size(); begin += batch) {
        const std::size_t n = std::min(batch, rays.size() - begin);
        if (any) {
            rc::any_hits(scene, rays.subspan(begin, n), rc::kAllLayers, std::span(is_hit).first(n));
            for (std::size_t i = 0; i < n; ++i) answer.add(is_hit[i] != 0, 0);
        } else {
            rc::closest_hits(scene, rays.subspan(begin, n), rc::kAllLayers, std::span(hits).first(n));
            for (std::size_t i = 0; i < n; ++i) answer.add(!hits[i].is_miss(), hits[i].primitive);
        }
    }
    return answer;
}

RaycoreSide::RaycoreSide(const BenchScene& scene, rc::BuildQuality quality)
    : quality_(quality),
      // High is for what never moves, and keeps nothing for refits, as Embree's static scenes do not.
      blas_(rc::build_blas(scene.view(), {quality})) {
    rc::SceneBuilder builder;
    builder.add({blas_});
    scene_ = builder.commit();
}

std::string RaycoreSide::quality_name() const {
    return name_of(quality_);
}

double RaycoreSide::bytes_per_triangle() const {
    return static_cast<double>(blas_->byte_size()) /
           static_cast<double>(std::max<std::size_t>(1, blas_->report().kept()));
}

Answer RaycoreSide::ask(std::span<const rc::Ray> rays, bool any, std::size_t batch) const {
    return batch <= 1 ? ask_single(*scene_, rays, any) : ask_batches(*scene_, rays, any, batch);
}

rc::Counters RaycoreSide::count(std::span<const rc::Ray> rays, bool any) const {
    return count_work(*scene_, rays, any);
}

rc::Counters count_work(const rc::Scene& scene, std::span<const rc::Ray> rays, bool any) {
    rc::Counters counters;
    if (any) {
        std::vector<std::uint8_t> is_hit(rays.size());
        rc::any_hits(scene, rays, rc::kAllLayers, is_hit, &counters);
    } else {
        std::vector<rc::Hit> hits(rays.size());
        rc::closest_hits(scene, rays, rc::kAllLayers, hits, &counters);
    }
    return counters;
}

}  // namespace bench
