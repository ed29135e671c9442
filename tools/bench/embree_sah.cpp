#include "embree_sah.h"

#include "embree_device.h"

#include <glm/common.hpp>

#include <algorithm>
#include <array>
#include <limits>
#include <vector>

namespace bench {

namespace {

constexpr float kInfinite = std::numeric_limits<float>::infinity();
constexpr unsigned kWidth = 8;

struct Bounds {
    glm::vec3 min{kInfinite}, max{-kInfinite};

    void grow(const glm::vec3& p) {
        min = glm::min(min, p);
        max = glm::max(max, p);
    }
    [[nodiscard]] double half_area() const {
        if (!(min.x <= max.x)) return 0.0;
        const glm::dvec3 d(max - min);
        return (d.x * d.y + d.y * d.z) + d.z * d.x;
    }
};

// A leaf has triangles and no children.
struct Node {
    std::array<Node*, kWidth> child{};
    std::array<Bounds, kWidth> bounds{};
    unsigned children = 0;
    std::size_t triangles = 0;
};

void* new_node(RTCThreadLocalAllocator allocator, unsigned children, void*) {
    Node* node = new (rtcThreadLocalAlloc(allocator, sizeof(Node), 16)) Node;
    node->children = children;
    return node;
}

void* new_leaf(RTCThreadLocalAllocator allocator, const RTCBuildPrimitive*, std::size_t count, void*) {
    Node* node = new (rtcThreadLocalAlloc(allocator, sizeof(Node), 16)) Node;
    node->triangles = count;
    return node;
}

void set_children(void* node, void** children, unsigned count, void*) {
    for (unsigned i = 0; i < count; ++i) static_cast<Node*>(node)->child[i] = static_cast<Node*>(children[i]);
}

void set_bounds(void* node, const RTCBounds** bounds, unsigned count, void*) {
    for (unsigned i = 0; i < count; ++i) {
        const RTCBounds& b = *bounds[i];
        static_cast<Node*>(node)->bounds[i] = {{b.lower_x, b.lower_y, b.lower_z},
                                               {b.upper_x, b.upper_y, b.upper_z}};
    }
}

// The boxes of what lies on either side of a plane across a triangle, within the box it had so far.
void split_triangle(const RTCBuildPrimitive* primitive, unsigned dimension, float position, RTCBounds* left,
                    RTCBounds* right, void* user) {
    const BenchScene& scene = *static_cast<const BenchScene*>(user);
    const glm::uvec3& corners = scene.triangles[primitive->primID];
    const auto axis = static_cast<glm::length_t>(dimension);
    Bounds side[2];
    for (glm::length_t i = 0; i < 3; ++i) {
        const glm::vec3& a = scene.positions[corners[i]];
        const glm::vec3& b = scene.positions[corners[(i + 1) % 3]];
        if (a[axis] <= position) side[0].grow(a);
        if (a[axis] >= position) side[1].grow(a);
        if ((a[axis] < position) == (b[axis] < position) || a[axis] == position || b[axis] == position)
            continue;
        const double share = (double(position) - double(a[axis])) / (double(b[axis]) - double(a[axis]));
        const glm::vec3 at(glm::dvec3(a) + (glm::dvec3(b) - glm::dvec3(a)) * share);
        side[0].grow(at);
        side[1].grow(at);
    }
    RTCBounds* out[] = {left, right};
    for (std::size_t s = 0; s < 2; ++s) {
        *out[s] = {std::max(side[s].min.x, primitive->lower_x), std::max(side[s].min.y, primitive->lower_y),
                   std::max(side[s].min.z, primitive->lower_z), 0,
                   std::min(side[s].max.x, primitive->upper_x), std::min(side[s].max.y, primitive->upper_y),
                   std::min(side[s].max.z, primitive->upper_z), 0};
    }
}

std::vector<RTCBuildPrimitive> primitives_of(const BenchScene& scene, Bounds& all) {
    std::vector<RTCBuildPrimitive> primitives;
    for (std::uint32_t i = 0; i < scene.triangles.size(); ++i) {
        Bounds bounds;
        for (glm::length_t c = 0; c < 3; ++c) bounds.grow(scene.positions[scene.triangles[i][c]]);
        all.grow(bounds.min);
        all.grow(bounds.max);
        primitives.push_back(
            {bounds.min.x, bounds.min.y, bounds.min.z, 0, bounds.max.x, bounds.max.y, bounds.max.z, i});
    }
    return primitives;
}

double cost_of_leaf(const Node& leaf, unsigned block) {
    const std::size_t blocks = (leaf.triangles + block - 1) / block;
    return static_cast<double>(blocks);
}

// Of all below a node: 1 a node, 1 a block of triangles, by half areas.
double cost_below(const Node& node, unsigned block) {
    double sum = 0.0;
    for (unsigned i = 0; i < node.children; ++i) {
        const Node& child = *node.child[i];
        const bool is_leaf = child.children == 0;
        sum += node.bounds[i].half_area() * (is_leaf ? cost_of_leaf(child, block) : 1.0);
        if (!is_leaf) sum += cost_below(child, block);
    }
    return sum;
}

}  // namespace

double embree_sah_cost(const BenchScene& scene, EmbreeQuality quality, unsigned block) {
    const EmbreeDevice device(0);
    RTCBVH bvh = rtcNewBVH(device.get());
    Bounds all;
    std::vector<RTCBuildPrimitive> primitives = primitives_of(scene, all);
    const std::size_t count = primitives.size();
    primitives.resize(2 * count);  // room for pieces
    RTCBuildArguments arguments = rtcDefaultBuildArguments();
    arguments.byteSize = sizeof(arguments);
    arguments.buildQuality = embree_quality(quality);
    arguments.maxBranchingFactor = kWidth;
    arguments.maxDepth = 64;
    arguments.sahBlockSize = block;
    arguments.minLeafSize = 1;
    arguments.maxLeafSize = kWidth;
    arguments.traversalCost = arguments.intersectionCost = 1.0f;
    arguments.bvh = bvh;
    arguments.primitives = primitives.data();
    arguments.primitiveCount = count;
    arguments.primitiveArrayCapacity = primitives.size();
    arguments.createNode = new_node;
    arguments.setNodeChildren = set_children;
    arguments.setNodeBounds = set_bounds;
    arguments.createLeaf = new_leaf;
    arguments.splitPrimitive = split_triangle;
    arguments.userPtr = const_cast<BenchScene*>(&scene);  // handed to split_triangle, which only reads
    const Node* root = static_cast<const Node*>(rtcBuildBVH(&arguments));
    double cost = 0.0;
    if (root != nullptr)
        cost = root->children == 0 ? cost_of_leaf(*root, block)
                                   : 1.0 + cost_below(*root, block) / all.half_area();
    rtcReleaseBVH(bvh);
    return cost;
}

}  // namespace bench
