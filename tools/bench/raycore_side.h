// raycore_side.h - raycore as a contestant: one mesh, asked one ray at a time or in batches.
#pragma once

#include "bench_rays.h"

#include "raycore/query.h"

#include <cstddef>
#include <memory>
#include <span>
#include <string>

namespace bench {

class RaycoreSide {
  public:
    RaycoreSide(const BenchScene& scene, rc::BuildQuality quality);

    [[nodiscard]] const rc::Scene& scene() const { return *scene_; }
    [[nodiscard]] const rc::Blas& blas() const { return *blas_; }
    [[nodiscard]] std::string quality_name() const;
    [[nodiscard]] double bytes_per_triangle() const;

    // `batch` rays a call; 1 asks the single queries.
    [[nodiscard]] Answer ask(std::span<const rc::Ray> rays, bool any, std::size_t batch) const;
    [[nodiscard]] rc::Counters count(std::span<const rc::Ray> rays, bool any) const;

  private:
    rc::BuildQuality quality_;
    std::shared_ptr<rc::Blas> blas_;
    std::shared_ptr<const rc::Scene> scene_;
};

[[nodiscard]] Answer ask_single(const rc::Scene& scene, std::span<const rc::Ray> rays, bool any);
[[nodiscard]] Answer ask_batches(const rc::Scene& scene, std::span<const rc::Ray> rays, bool any,
                                 std::size_t batch);

// What asking in batches does, by the counters.
[[nodiscard]] rc::Counters count_work(const rc::Scene& scene, std::span<const rc::Ray> rays, bool any);

[[nodiscard]] std::string name_of(rc::BuildQuality quality);

}  // namespace bench
