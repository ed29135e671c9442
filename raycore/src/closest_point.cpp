// The point of a scene nearest to a given one: both trees walked from near to far, cut off at the best so far.
#include "cast_math.h"
#include "contract.h"
#include "visit.h"

#include "raycore/bodies.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <tuple>

namespace rc {

namespace {

// Lower bounds are formed in double; this much of them is given to rounding.
constexpr double kSure = 1.0 - 0x1p-40;

// The largest stretch of the way into an instance's frame, from above. Rotations and scales along the axes of either
// frame are met exactly (Gershgorin's bound for A A^T and A^T A, the smaller).
double stretch_of(const double (&m)[4][4]) {
    double by_rows = 0, by_columns = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        double row_sum = 0, column_sum = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            double row = 0, column = 0;
            for (std::size_t j = 0; j < 3; ++j) {
                row += m[j][i] * m[j][k];
                column += m[i][j] * m[k][j];
            }
            row_sum += std::abs(row);
            column_sum += std::abs(column);
        }
        by_rows = std::max(by_rows, row_sum);
        by_columns = std::max(by_columns, column_sum);
    }
    return std::sqrt(std::min(by_rows, by_columns));
}

class Search {
  public:
    Search(const Scene& scene, const glm::vec3& point, float max_distance)
        : scene_(scene.data()), point_(point), limit_(double(max_distance)) {}

    Nearest run(LayerMask layers) {
        walk(
            scene_.nodes.data(), scene_.view.root, {.point = point_},
            [&](const kernel::WideNode& node, int lane) { return (node.layers[lane] & layers) != 0; },
            [&](std::uint32_t item) {
                const std::uint32_t id = item & ~kernel::kLeafBit;
                if (scene_.views[id].layers & layers) search_instance(id);
            });
        return best_;
    }

  private:
    // How distances in a tree's frame bound those in the world: world >= local * per_local - slack.
    struct Frame {
        glm::dvec3 point;
        double per_local = 1.0, slack = 0.0;
    };
    struct Waiting {
        double bound;
        std::uint32_t item;
    };

    // What begins farther away can not be nearer any more; what may tie can.
    [[nodiscard]] bool is_beyond(double bound) const { return bound * kSure > limit_; }

    template <class Enter, class Leaf>
    void walk(const kernel::WideNode* nodes, std::uint32_t root, const Frame& frame, Enter&& enter,
              Leaf&& leaf) {
        Waiting stack[kernel::kStackSize];
        int top = 0;
        if (root != kernel::kEmptyTree) stack[top++] = {0.0, root};
        while (top > 0) {
            const Waiting next = stack[--top];
            if (is_beyond(next.bound)) continue;
            if (next.item & kernel::kLeafBit) {
                leaf(next.item);
                continue;
            }
            const kernel::WideNode& node = nodes[next.item];
            double squares[kernel::kWidth];
            square_distances(node, frame.point, squares);
            const int below = top;
            for (int lane = 0; lane < kernel::kWidth; ++lane) {
                const double bound = std::sqrt(squares[lane]) * frame.per_local - frame.slack;
                if (node.layers[lane] == 0 || is_beyond(bound) || !enter(node, lane)) continue;
                int at = top++;  // farthest first, so that the nearest is taken next
                for (; at > below && stack[at - 1].bound < bound; --at) stack[at] = stack[at - 1];
                stack[at] = {bound, node.child[lane]};
            }
        }
    }

    void search_instance(std::uint32_t id) {
        const kernel::InstanceView& view = scene_.views[id];
        const glm::mat4x3& world_from_instance = scene_.instances[id].world_from_instance;
        Frame frame{.point = point_};
        if (!view.is_identity) {
            double reach = 0, offset = 0, off = 0;
            for (std::size_t r = 0; r < 3; ++r) {
                const auto& m = view.local_from_world;
                frame.point[r] = ((m[0][r] * point_.x + m[1][r] * point_.y) + m[2][r] * point_.z) + m[3][r];
                off = std::max(off, std::abs(m[0][r] * point_.x) + std::abs(m[1][r] * point_.y) +
                                        std::abs(m[2][r] * point_.z) + std::abs(m[3][r]));
                offset = std::max(offset, std::abs(double(world_from_instance[3][r])));
                for (std::size_t c = 0; c < 3; ++c)
                    reach = std::max(reach, std::abs(double(world_from_instance[c][r])) *
                                                std::max(std::abs(double(view.blas.min[c])),
                                                         std::abs(double(view.blas.max[c]))));
            }
            frame.per_local = 1.0 / stretch_of(view.local_from_world);
            // world_corner's rounding, and that of the point's way into the frame.
            frame.slack = 0x1p-20 * (offset + 3 * reach) + 0x1p-48 * off * frame.per_local;
        }
        walk(
            view.blas.nodes, view.blas.root, frame, [](const kernel::WideNode&, int) { return true; },
            [&](std::uint32_t item) { search_leaf(id, Leaf(view.blas.leaves, item)); });
    }

    void search_leaf(std::uint32_t id, const Leaf& leaf) {
        const glm::mat4x3& world_from_instance = scene_.instances[id].world_from_instance;
        for (std::uint32_t at = 0; at < leaf.size(); ++at) {
            cast::Corners corners;
            for (std::uint32_t c = 0; c < 3; ++c)
                corners[c] = glm::dvec3(world_corner(world_from_instance, leaf.corner(at, c))) - point_;
            // Never nearer than its own box, rounding or not: what a tree's boxes cut off could not have won.
            const double least = box_distance(corners);
            if (is_beyond(least)) continue;
            cast::Closest closest = cast::closest_points(glm::dvec3(0.0), corners, glm::dvec3(0.0));
            closest.distance = std::max(closest.distance, least);
            keep(closest, id, leaf.primitive(at));
        }
    }

    [[nodiscard]] static double box_distance(const cast::Corners& c) {
        const glm::dvec3 low = glm::min(c[0], glm::min(c[1], c[2])),
                         high = glm::max(c[0], glm::max(c[1], c[2]));
        const glm::dvec3 off = glm::max(glm::max(low, -high), glm::dvec3(0.0));
        return std::sqrt(glm::dot(off, off));
    }

    void keep(const cast::Closest& closest, std::uint32_t instance, std::uint32_t primitive) {
        // A triangle that refitting made non-finite has NaN corners, and no distance.
        if (!(closest.distance < std::numeric_limits<double>::infinity())) return;
        const auto distance =
            static_cast<float>(std::min(closest.distance, double(std::numeric_limits<float>::max())));
        const auto key = [](const Nearest& n) { return std::tie(n.distance, n.instance, n.primitive); };
        const Nearest found{.distance = distance,
                            .point = glm::vec3(point_ + closest.on_triangle),
                            .normal = glm::vec3(closest.normal),
                            .primitive = primitive,
                            .instance = instance};
        if (!(closest.distance <= limit_) || !(key(found) < key(best_))) return;
        best_ = found;
        // All that rounds to the same float may still win by its id.
        limit_ = std::min(limit_, double(std::bit_cast<float>(std::bit_cast<std::uint32_t>(distance) + 1)));
    }

    const Scene::Data& scene_;
    glm::dvec3 point_;
    double limit_;
    Nearest best_;
};

bool is_good(const glm::vec3& p, float max_distance) {
    constexpr float kMax = std::numeric_limits<float>::max();
    return std::abs(p.x) <= kMax && std::abs(p.y) <= kMax && std::abs(p.z) <= kMax && max_distance >= 0.0f;
}

Nearest nearest_of(const Scene& scene, const glm::vec3& point, float max_distance, LayerMask layers) {
    const bool good = is_good(point, max_distance);
    RC_EXPECTS(good, "a finite point and a distance that is not negative");
    return good ? Search(scene, point, max_distance).run(layers) : Nearest{};
}

}  // namespace

std::optional<Nearest> closest_point(const Scene& scene, const glm::vec3& point, float max_distance,
                                     LayerMask layers) {
    const Nearest nearest = nearest_of(scene, point, max_distance, layers);
    if (nearest.is_none()) return std::nullopt;
    return nearest;
}

void closest_points(const Scene& scene, std::span<const glm::vec3> points, float max_distance,
                    LayerMask layers, std::span<Nearest> nearest) {
    RC_EXPECTS(points.size() == nearest.size(), "an answer for every point");
    for (std::size_t i = 0; i < points.size(); ++i)
        nearest[i] = nearest_of(scene, points[i], max_distance, layers);
}

}  // namespace rc
