// visit.h - every triangle near a box of the world: what sweeps of bodies walk over.
//
// Cost      O(log triangles + found); no allocation, no lock. Prunes by both trees, then by each triangle's box.
// Same bits which triangles are visited depends on the trees only in what lies outside the box, which callers
//           must be indifferent to; the order depends on the trees, so callers must not let it decide anything.
// Bad input a box with min > max or NaN visits nothing.
#pragma once

#include "data.h"

#include <glm/common.hpp>
#include <glm/mat4x3.hpp>
#include <glm/vec3.hpp>

#include <array>
#include <cstdint>

namespace rc {

inline bool overlaps(const Box& a, const Box& b) {
    return a.min.x <= b.max.x && b.min.x <= a.max.x && a.min.y <= b.max.y && b.min.y <= a.max.y &&
           a.min.z <= b.max.z && b.min.z <= a.max.z;
}

// The lanes of `node` whose boxes overlap `box`.
std::uint32_t overlapping_children(const kernel::WideNode& node, const Box& box);

// How far, squared, the boxes of `node`'s lanes are from a point.
void square_distances(const kernel::WideNode& node, const glm::dvec3& point, double (&out)[kernel::kWidth]);

// A box in the instance's frame that holds everything of it that lies in `world_box`, rounding included.
Box local_box(const kernel::InstanceView& instance, const glm::mat4x3& world_from_instance,
              const Box& world_box);

// Where a corner of an instance's triangle lies in the world: one formula for everybody.
glm::vec3 world_corner(const glm::mat4x3& world_from_instance, const glm::vec3& corner);

// Calls visit(instance, primitive, corners) with corners in the world frame for every triangle met by `layers`
// whose box may overlap `world_box`. `visit` returns whether it has made `world_box` smaller meanwhile; from then on
// the smaller box prunes. A triangle may be visited more than once (spatial splits).
template <class Visit>
void visit_triangles(const Scene& scene, const Box& world_box, LayerMask layers, Visit&& visit);

namespace detail {

template <class Visit>
void visit_instance(const Scene::Data& scene, std::uint32_t id, const Box& world_box, Visit& visit) {
    const glm::mat4x3& world_from_instance = scene.instances[id].world_from_instance;
    const kernel::BlasView& blas = scene.views[id].blas;
    Box box = local_box(scene.views[id], world_from_instance, world_box);

    std::uint32_t stack[kernel::kStackSize];
    int top = 0;
    if (blas.root != kernel::kEmptyTree) stack[top++] = blas.root;
    while (top > 0) {
        const std::uint32_t item = stack[--top];
        if (!(item & kernel::kLeafBit)) {
            const kernel::WideNode& node = blas.nodes[item];
            for (std::uint32_t hit = overlapping_children(node, box); hit != 0; hit &= hit - 1)
                stack[top++] = node.child[std::countr_zero(hit)];
            continue;
        }
        const Leaf leaf(blas.leaves, item);
        for (std::uint32_t at = 0; at < leaf.size(); ++at) {
            std::array<glm::vec3, 3> p;
            for (std::uint32_t c = 0; c < 3; ++c) p[c] = leaf.corner(at, c);
            const Box around{glm::min(p[0], glm::min(p[1], p[2])), glm::max(p[0], glm::max(p[1], p[2]))};
            if (!overlaps(around, box)) continue;
            for (glm::vec3& corner : p) corner = world_corner(world_from_instance, corner);
            if (visit(id, leaf.primitive(at), p))
                box = local_box(scene.views[id], world_from_instance, world_box);
        }
    }
}

}  // namespace detail

template <class Visit>
void visit_triangles(const Scene& scene, const Box& world_box, LayerMask layers, Visit&& visit) {
    const Scene::Data& data = scene.data();
    std::uint32_t stack[kernel::kStackSize];
    int top = 0;
    if (data.view.root != kernel::kEmptyTree) stack[top++] = data.view.root;
    while (top > 0) {
        const std::uint32_t item = stack[--top];
        if (item & kernel::kLeafBit) {
            const std::uint32_t id = item & ~kernel::kLeafBit;
            if (data.views[id].layers & layers) detail::visit_instance(data, id, world_box, visit);
            continue;
        }
        const kernel::WideNode& node = data.nodes[item];
        for (std::uint32_t hit = overlapping_children(node, world_box); hit != 0; hit &= hit - 1) {
            const int lane = std::countr_zero(hit);
            if (node.layers[lane] & layers) stack[top++] = node.child[lane];
        }
    }
}

}  // namespace rc
