#include "collect_refs.h"

#include "parallel.h"
#include "tree_math.h"
#include "triangle_check.h"

#include <algorithm>
#include <vector>

namespace rc {

namespace {

constexpr std::size_t kTrianglesAtATime = 8192;

// Grows `bounds` by the triangle as well.
BuildRef ref_around(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c, std::size_t item,
                    GrowingBox& bounds) {
    BuildRef ref{};
    for (std::size_t k = 0; k < 3; ++k) {
        ref.neg_min[k] = -std::min(a[k], std::min(b[k], c[k]));
        ref.max[k] = std::max(a[k], std::max(b[k], c[k]));
    }
    for (std::size_t k = 0; k < 3; ++k) {
        bounds.neg_min[k] = std::max(bounds.neg_min[k], ref.neg_min[k]);
        bounds.max[k] = std::max(bounds.max[k], ref.max[k]);
    }
    const float slack = slack_of(a, b, c);
    for (std::size_t k = 0; k < 3; ++k) {
        ref.neg_min[k] += slack;
        ref.max[k] += slack;
    }
    ref.item = static_cast<std::uint32_t>(item);
    return ref;
}

}  // namespace

float slack_of(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
    float extent = 0.0f;
    for (std::size_t k = 0; k < 3; ++k)
        extent =
            std::max(extent, std::max(a[k], std::max(b[k], c[k])) - std::min(a[k], std::min(b[k], c[k])));
    return extent * kSlack;
}

CollectedRefs collect_refs(const MeshView& mesh, std::size_t most, MeshReport& report) {
    const std::size_t n = mesh.triangles.size();
    CollectedRefs collected{{}, build::kNoBox};
    Unfilled<BuildRef>& refs = collected.refs;
    refs.reserve(std::max(most, n));
    refs.resize(n);
    // Each block fills its own part of `refs` from the front.
    std::vector<MeshReport> reports((n + kTrianglesAtATime - 1) / kTrianglesAtATime);
    std::vector<GrowingBox> bounds(reports.size(), build::kNoBox);
    for_in_parallel(reports.size(), [&](std::size_t block) {
        const std::size_t begin = block * kTrianglesAtATime, end = std::min(begin + kTrianglesAtATime, n);
        std::size_t kept = begin;
        for (std::size_t i = begin; i < end; ++i) {
            const glm::uvec3& t = mesh.triangles[i];
            const TriangleFault fault = fault_of(mesh.positions, t);
            count(fault, reports[block]);
            if (fault == TriangleFault::None)
                refs[kept++] = ref_around(mesh.positions[t.x], mesh.positions[t.y], mesh.positions[t.z], i,
                                          bounds[block]);
        }
        reports[block].triangles = end - begin;
    });
    // Then the parts are pushed together; where nothing was dropped they already are.
    std::size_t kept = 0;
    for (std::size_t block = 0; block < reports.size(); ++block) {
        const MeshReport& part = reports[block];
        if (kept != block * kTrianglesAtATime)
            std::move(&refs[block * kTrianglesAtATime], &refs[block * kTrianglesAtATime] + part.kept(),
                      &refs[kept]);
        kept += part.kept();
        build::grow(collected.bounds, bounds[block]);
        report.triangles += part.triangles;
        report.index_out_of_range += part.index_out_of_range;
        report.not_finite += part.not_finite;
        report.zero_area += part.zero_area;
    }
    refs.resize(kept);
    return collected;
}

}  // namespace rc
