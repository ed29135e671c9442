#include "bench_sah.h"

#include "raycore_side.h"
#ifdef BENCH_HAS_EMBREE
#include "embree_sah.h"
#endif

#include "data.h"  // the tree itself is looked at

#include <string>

namespace bench {

namespace {

double half_area(double x, double y, double z) {
    return (x * y + y * z) + z * x;
}

double half_area(const rc::kernel::WideNode& node, int lane) {
    const auto extent = [&](int axis) {
        return double(node.bounds[2 * axis + 1][lane]) - double(node.bounds[2 * axis][lane]);
    };
    return half_area(extent(0), extent(1), extent(2));
}

// 1 a node, 1 for every `block` triangles of a leaf or part of them, by half areas.
double cost_of(const rc::Blas& blas, unsigned block) {
    const rc::Blas::Data& tree = blas.data();
    double sum = 0.0;
    for (const rc::kernel::WideNode& node : tree.nodes) {
        for (int lane = 0; lane < rc::kernel::kWidth; ++lane) {
            if (node.layers[lane] == 0) continue;
            const std::uint32_t item = node.child[lane];
            const bool is_leaf = (item & rc::kernel::kLeafBit) != 0;
            const unsigned blocks =
                is_leaf ? (rc::Leaf(tree.leaves.data(), item).size() + block - 1) / block : 1;
            sum += half_area(node, lane) * double(blocks);
        }
    }
    const glm::dvec3 size(tree.bounds.max - tree.bounds.min);
    return 1.0 + sum / half_area(size.x, size.y, size.z);
}

}  // namespace

void bench_sah(Report& report, const BenchScene& scene, bool with_embree) {
    for (const unsigned block : {1u, 4u}) {
        report.table("cost of a random ray by SAH in " + scene.name + ": 1 a node, 1 a " +
                         (block == 1 ? "triangle" : "block of four triangles"),
                     "quality", {"raycore", "Embree's builder", "ours / theirs"});
        for (const rc::BuildQuality quality : {rc::BuildQuality::Default, rc::BuildQuality::High}) {
            const double ours = cost_of(*rc::build_blas(scene.view(), {quality}), block);
            report.row(name_of(quality)).number(ours, 2);
#ifdef BENCH_HAS_EMBREE
            if (with_embree) {
                const bool is_high = quality == rc::BuildQuality::High;
                const double theirs =
                    embree_sah_cost(scene, is_high ? EmbreeQuality::High : EmbreeQuality::Medium, block);
                report.number(theirs, 2).number(ours / theirs, 3);
                continue;
            }
#else
            (void)with_embree;
#endif
            report.none().none();
        }
    }
}

}  // namespace bench
