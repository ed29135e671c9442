#include "collect_refs.h"

#include "triangle_check.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <vector>

namespace rc {

namespace {

constexpr std::size_t kBlock = 8192;

BuildRef ref_around(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c, std::size_t item) {
    BuildRef ref{};
    for (std::size_t k = 0; k < 3; ++k) {
        ref.neg_min[k] = -std::min(a[k], std::min(b[k], c[k]));
        ref.max[k] = std::max(a[k], std::max(b[k], c[k]));
    }
    ref.item = static_cast<std::uint32_t>(item);
    return ref;
}

}  // namespace

Unfilled<BuildRef> collect_refs(const MeshView& mesh, MeshReport& report) {
    const std::size_t n = mesh.triangles.size();
    Unfilled<BuildRef> refs(n);
    // Each block fills its own part of `refs` from the front.
    std::vector<MeshReport> reports((n + kBlock - 1) / kBlock);
    tbb::parallel_for(std::size_t{0}, reports.size(), [&](std::size_t block) {
        const std::size_t begin = block * kBlock, end = std::min(begin + kBlock, n);
        std::size_t kept = begin;
        for (std::size_t i = begin; i < end; ++i) {
            const glm::uvec3& t = mesh.triangles[i];
            const TriangleFault fault = fault_of(mesh.positions, t);
            count(fault, reports[block]);
            if (fault == TriangleFault::None)
                refs[kept++] = ref_around(mesh.positions[t.x], mesh.positions[t.y], mesh.positions[t.z], i);
        }
        reports[block].triangles = end - begin;
    });
    // Then the parts are pushed together; where nothing was dropped they already are.
    std::size_t kept = 0;
    for (std::size_t block = 0; block < reports.size(); ++block) {
        const MeshReport& part = reports[block];
        if (kept != block * kBlock)
            std::move(&refs[block * kBlock], &refs[block * kBlock] + part.kept(), &refs[kept]);
        kept += part.kept();
        report.triangles += part.triangles;
        report.index_out_of_range += part.index_out_of_range;
        report.not_finite += part.not_finite;
        report.zero_area += part.zero_area;
    }
    refs.resize(kept);
    return refs;
}

}  // namespace rc
