#include "raycore/blas.h"

#include "binned_builder.h"
#include "collapse.h"
#include "contract.h"
#include "fit.h"
#include "triangle_check.h"

#include <algorithm>
#include <bit>
#include <utility>

namespace rc {

namespace {

// A box around each triangle worth keeping, in order of primitives; the others are counted.
std::vector<BuildRef> collect_refs(const MeshView& mesh, MeshReport& report) {
    std::vector<BuildRef> refs;
    refs.reserve(mesh.triangles.size());
    report.triangles = mesh.triangles.size();
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        const glm::uvec3& t = mesh.triangles[i];
        switch (fault_of(mesh.positions, t)) {
            case TriangleFault::None:
                break;
            case TriangleFault::IndexOutOfRange:
                ++report.index_out_of_range;
                continue;
            case TriangleFault::NotFinite:
                ++report.not_finite;
                continue;
            case TriangleFault::ZeroArea:
                ++report.zero_area;
                continue;
        }
        const glm::vec3 &a = mesh.positions[t.x], &b = mesh.positions[t.y], &c = mesh.positions[t.z];
        BuildRef& ref = refs.emplace_back();
        for (std::size_t k = 0; k < 3; ++k) {
            ref.neg_min[k] = -std::min(a[k], std::min(b[k], c[k]));
            ref.max[k] = std::max(a[k], std::max(b[k], c[k]));
        }
        ref.item = static_cast<std::uint32_t>(i);
    }
    return refs;
}

// Gives every block of `node`'s leaves its primitive row, and every primitive its leaf.
void name_primitives(Blas::Data& blas, std::span<const BuildRef> refs, std::uint32_t item) {
    if (item & kernel::kLeafBit) {
        const LeafRange leaf = leaf_range(item);
        float* row =
            blas.leaves.data() + std::size_t{leaf.first} * kernel::kWordsPerTriangle + 9 * leaf.count;
        for (std::uint32_t lane = 0; lane < leaf.count; ++lane) {
            const std::uint32_t primitive = refs[leaf.first + lane].item;
            row[lane] = std::bit_cast<float>(primitive);
            blas.leaf_of_primitive[primitive] = item;
        }
        return;
    }
    const kernel::WideNode& node = blas.nodes[item];
    for (int lane = 0; lane < kernel::kWidth; ++lane)
        if (node.layers[lane] != 0) name_primitives(blas, refs, node.child[lane]);
}

}  // namespace

Blas::Blas(std::unique_ptr<Data> data) : data_(std::move(data)) {}
Blas::Blas(const Blas& other) : data_(std::make_unique<Data>(*other.data_)) {}
Blas::Blas(Blas&&) noexcept = default;
Blas& Blas::operator=(Blas&&) noexcept = default;
Blas::~Blas() = default;

const MeshReport& Blas::report() const {
    return data_->report;
}
Box Blas::bounds() const {
    return data_->bounds;
}
float Blas::sah_cost() const {
    return data_->cost;
}

std::size_t Blas::byte_size() const {
    const auto bytes = [](const auto& v) { return v.capacity() * sizeof(v[0]); };
    return sizeof(Data) + bytes(data_->nodes) + bytes(data_->leaves) + bytes(data_->triangles) +
           bytes(data_->leaf_of_primitive);
}

float Blas::refit_degradation() const {
    return data_->cost_when_built > 0.0f ? data_->cost / data_->cost_when_built : 1.0f;
}

std::shared_ptr<Blas> build_blas(const MeshView& mesh, const BuildOptions&) {
    auto data = std::make_unique<Blas::Data>();
    RC_EXPECTS(mesh.triangles.size() <= kMaxTriangles, "at most kMaxTriangles triangles in a mesh");
    const bool fits = mesh.triangles.size() <= kMaxTriangles;
    const MeshView view{mesh.positions, fits ? mesh.triangles : mesh.triangles.first(0)};

    std::vector<BuildRef> refs = collect_refs(view, data->report);
    data->vertex_count = view.positions.size();
    data->triangles.assign(view.triangles.begin(), view.triangles.end());
    data->leaf_of_primitive.assign(view.triangles.size(), kNone);
    if (!refs.empty()) {
        const auto binary = build_binary_tree(refs, SplitCosts{});
        WideTree tree = collapse_blas(binary.nodes.get());
        data->nodes = std::move(tree.nodes);
        data->root = tree.root;
        data->leaves.resize(refs.size() * kernel::kWordsPerTriangle + kernel::kLeafPadding);
        name_primitives(*data, refs, data->root);
    }
    fit(*data, view.positions);
    data->cost_when_built = data->cost;
    return std::make_shared<Blas>(std::move(data));
}

}  // namespace rc
