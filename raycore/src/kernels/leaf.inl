// kernels/leaf.inl - a leaf's block taken apart, as kernel_abi.h has it.
//
// Where its corners lie is in the leaf's name, so that no load waits for another; how many triangles they make is in the
// block, and only asked when the arithmetic is under way.

namespace rc::kernel::RC_ISA {
namespace {

struct Leaf {
    const float* rows;  // x, y, z of the corners
    std::uint32_t corners;
};
static inline Leaf leaf_at(const float* leaves, std::uint32_t item) {
    return {leaves + std::uint64_t{item & kUnitMask} * kWordsPerUnit,
            ((item & ~kLeafBit) >> kCornersShift) + 1};
}

static inline const float* row_of(const Leaf& leaf, int axis) {
    return leaf.rows + std::uint32_t(axis) * leaf.corners;
}

// The half word of a triangle: which corners are its.
static inline std::uint32_t half_of(const Leaf& leaf, std::uint32_t triangle) {
    std::uint16_t half;
    __builtin_memcpy(&half, reinterpret_cast<const char*>(leaf.rows + 3 * leaf.corners) + 2 * triangle,
                     sizeof(half));
    return half;
}
static inline std::uint32_t corner_of(std::uint32_t half, std::uint32_t i) {
    return half >> (kCornerBits * i) & (kMaxCorners - 1);
}
// All of them; lanes beyond the last triangle mean nothing.
static inline Words halves_of(const Leaf& leaf) {
    return load_halves(leaf.rows + 3 * leaf.corners);
}
static inline std::uint32_t last_of(const Leaf& leaf) {
    return half_of(leaf, 0) >> kCountShift & kCountMask;
}
// Triangles that can be met.
static inline std::uint32_t triangle_bits(const Leaf& leaf) {
    return half_sign_bits(halves_of(leaf)) & ((2u << last_of(leaf)) - 1);
}

static inline const float* primitives_of(const Leaf& leaf) {
    return leaf.rows + 3 * leaf.corners + (last_of(leaf) + 2) / 2;
}
static inline std::uint32_t primitive_at(const Leaf& leaf, std::uint32_t triangle) {
    std::uint32_t primitive;
    __builtin_memcpy(&primitive, primitives_of(leaf) + triangle, sizeof(primitive));
    return primitive;
}

}  // namespace
}  // namespace rc::kernel::RC_ISA
