// From triangles to a tree the kernels walk: refs, a binary tree over them, eight wide, blocks filled.
#include "binned_builder.h"
#include "collapse.h"
#include "collect_refs.h"
#include "contract.h"
#include "fill_leaves.h"
#include "fit.h"
#include "morton_builder.h"
#include "spatial_builder.h"

#include "raycore/blas.h"

#include <limits>
#include <utility>

namespace rc {

namespace {

BinaryTree binary_tree_of(Unfilled<BuildRef> refs, const MeshView& mesh, BuildQuality quality) {
    switch (quality) {
        case BuildQuality::Fast:
            return build_morton_tree(refs, SplitCosts{});
        case BuildQuality::Default:
            break;
        case BuildQuality::High:
            return build_spatial_tree(std::move(refs), mesh, SplitCosts{});
    }
    return build_binary_tree(refs, SplitCosts{});
}

void grow_tree(Blas::Data& blas, const MeshView& mesh, BuildQuality quality) {
    const std::size_t n = mesh.triangles.size();
    CollectedRefs collected =
        collect_refs(mesh, quality == BuildQuality::High ? most_pieces_of(n) : n, blas.report);
    if (collected.refs.empty()) return;
    const BinaryTree binary = binary_tree_of(std::move(collected.refs), mesh, quality);
    WideTree wide = collapse_blas(binary, mesh, blas.can_refit);
    blas.nodes = std::move(wide.nodes);
    blas.root = wide.root;
    blas.bounds = box_of(collected.bounds);
    [[maybe_unused]] const bool is_filled = fill_leaves(blas, binary.items, mesh);
    RC_EXPECTS(is_filled, "leaves whose corners fit into their blocks");
}

}  // namespace

std::shared_ptr<Blas> build_blas(const MeshView& mesh, const BuildOptions& options) {
    auto data = std::make_unique<Blas::Data>();
    RC_EXPECTS(mesh.triangles.size() <= kMaxTriangles, "at most kMaxTriangles triangles in a mesh");
    const bool fits = mesh.triangles.size() <= kMaxTriangles;
    const MeshView view{mesh.positions, fits ? mesh.triangles : mesh.triangles.first(0)};

    data->vertex_count = view.positions.size();
    data->can_refit = options.can_refit;
    data->leaf_of_primitive.assign(view.triangles.size(), kNone);
    data->bounds = {glm::vec3(kInfinity), glm::vec3(-kInfinity)};
    grow_tree(*data, view, options.quality);
    data->cost = data->cost_when_built = cost_of(*data);
    return std::make_shared<Blas>(std::move(data));
}

}  // namespace rc
