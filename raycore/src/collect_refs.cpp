#include "collect_refs.h"

#include "contract.h"
#include "dispatch.h"
#include "parallel.h"
#include "tree_math.h"
#include "triangle_check.h"

#include <algorithm>
#include <vector>

namespace rc {

namespace {

constexpr std::size_t kTrianglesAtATime = 8192;

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
    const kernel::BuildKernels& kernels = active_build_kernels();
    const kernel::MeshArrays arrays{reinterpret_cast<const float*>(mesh.positions.data()),
                                    reinterpret_cast<const std::uint32_t*>(mesh.triangles.data())};
    // Each block fills its own part of `refs` from the front.
    std::vector<MeshReport> reports((n + kTrianglesAtATime - 1) / kTrianglesAtATime);
    std::vector<GrowingBox> bounds(reports.size(), build::kNoBox);
    for_in_parallel(reports.size(), [&](std::size_t block) {
        const std::size_t begin = block * kTrianglesAtATime, end = std::min(begin + kTrianglesAtATime, n);
        const std::size_t kept =
            kernels.box_triangles(arrays, mesh.positions.size(), begin, end, &refs[begin], bounds[block]);
        MeshReport& part = reports[block];
        part.triangles = end - begin;
        for (std::size_t i = begin; kept < part.triangles && i < end; ++i)
            count(fault_of(mesh.positions, mesh.triangles[i]), part);
        RC_EXPECTS(part.kept() == kept, "one answer to which triangles are worth keeping");
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
