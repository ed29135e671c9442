// kernels/kernel_abi.h - what the kernels of every ISA share with the rest of raycore: plain layouts and one table.
//
// Kernel files are compiled with -m flags, so they include this, their SIMD header and nothing else: any inline
// function of a library would be compiled with those flags too and could replace the portable copy at link time.
#pragma once

#include <cstdint>

namespace rc::kernel {

inline constexpr int kWidth = 8;      // children a node, lanes a triangle block
inline constexpr int kMaxDepth = 64;  // of a tree; the builder proves it (binned_builder.h)
inline constexpr int kStackSize =
    (kWidth - 1) * kMaxDepth + 1;                  // siblings waiting at each level, and the root
inline constexpr std::uint32_t kMaxCorners = 16;   // of all triangles of a leaf
inline constexpr std::uint32_t kWordsPerUnit = 4;  // where a leaf may begin
inline constexpr int kLeafPadding = 64;            // words readable behind the last leaf

// A child is a node's index, or a leaf. In a BLAS a leaf is kLeafBit | (corners - 1) << kCornersShift | unit: its block
// starts at word unit * kWordsPerUnit. In a TLAS it is kLeafBit | instance. Empty lanes have an inverted box, and
// name some leaf that exists, so that even a lane let through by mistake leads to a true answer.
inline constexpr std::uint32_t kLeafBit = 0x80000000u;
inline constexpr std::uint32_t kCornersShift = 27;
inline constexpr std::uint32_t kUnitMask = (1u << kCornersShift) - 1;
inline constexpr std::uint32_t kEmptyTree = 0xFFFFFFFFu;

struct alignas(64) WideNode {
    float bounds[6][kWidth];  // min x, max x, min y, max y, min z, max z
    std::uint32_t child[kWidth];
    std::uint32_t layers[kWidth];  // TLAS: layers met below; BLAS: nodes in the subtree. 0 in an empty lane
};
static_assert(sizeof(WideNode) == 256);

// The block of a leaf of m corners and n <= 8 triangles: m x, m y, m z; half a word a triangle, which names its corners;
// n primitives; and m vertices, if it can be refitted. A half word has kCornerBits a corner, the first corner lowest;
// the first half word has n - 1 from kCountShift on; kIsMet where the triangle can be met at all.
inline constexpr std::uint32_t kCornerBits = 4, kCountShift = 12, kCountMask = 7, kIsMet = 0x8000u;
struct BlasView {
    const WideNode* nodes = nullptr;
    const float* leaves = nullptr;
    std::uint32_t root = kEmptyTree;
    float min[4] = {0, 0, 0, 0};  // read four wide
    float max[4] = {0, 0, 0, 0};
};

struct alignas(64) InstanceView {
    // Columns x, y, z, translation, four rows each: found and applied in double. The fourth row means nothing and is
    // zero: it is computed along, and what memory held before is often denormal, which a ray waits a tenth longer for.
    double local_from_world[4][4];
    BlasView blas;
    std::uint32_t layers = 0;
    bool is_identity = false;  // the way into its frame changes no bit, and is not gone
};

struct SceneView {
    const WideNode* nodes = nullptr;
    const InstanceView* instances = nullptr;
    std::uint32_t root = kEmptyTree;
    float condition = 1.0f;       // the worst norm(world_from_local) * norm(local_from_world) among instances
    float min[4] = {0, 0, 0, 0};  // read four wide
    float max[4] = {0, 0, 0, 0};
};

// rc::Ray and rc::Hit as kernels see them; query.cpp asserts that they are the same bytes.
struct __attribute__((may_alias)) RayIn {
    float origin[3];
    float direction[3];
    float t_min;
    float t_max;
    std::uint32_t skip_instance;
    std::uint32_t skip_primitive;
};
struct __attribute__((may_alias)) HitOut {
    float t;
    float u;
    float v;
    std::uint32_t primitive;
    std::uint32_t instance;
};

struct Counts {
    std::uint64_t instances = 0;
    std::uint64_t nodes = 0;
    std::uint64_t leaves = 0;
};

// Spans come as pointer and length. A bad ray is a miss. `counts` may be null.
struct Kernels {
    void (*closest)(const SceneView&, const RayIn* rays, std::uint64_t n, std::uint32_t layers, HitOut* hits,
                    Counts* counts);
    void (*any)(const SceneView&, const RayIn* rays, std::uint64_t n, std::uint32_t layers,
                std::uint8_t* is_hit, Counts* counts);
    // Only what follows `after`, unless that is null.
    std::uint32_t (*crossings)(const SceneView&, const RayIn& ray, std::uint32_t layers, const HitOut* after,
                               HitOut* out, std::uint32_t capacity);
};

extern const Kernels kScalarKernels;
extern const Kernels kAvx2Kernels;
extern const Kernels kAvx512Kernels;

}  // namespace rc::kernel
