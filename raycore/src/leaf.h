// leaf.h - a leaf's block outside the kernels: where its parts lie (kernel_abi.h), and what they say.
#pragma once

#include "kernels/kernel_abi.h"

#include "raycore/mesh.h"

#include <glm/vec3.hpp>

#include <bit>
#include <cstdint>
#include <cstring>
#include <limits>

namespace rc {

// In words from the block's first.
struct LeafPlaces {
    std::uint32_t halves, primitives, vertices, end;
};
inline constexpr LeafPlaces places_in_leaf(std::uint32_t corners, std::uint32_t triangles) {
    const std::uint32_t halves = 3 * corners, primitives = halves + (triangles + 1) / 2;
    return {halves, primitives, primitives + triangles, primitives + triangles + corners};
}
inline constexpr std::uint32_t units_of_leaf(std::uint32_t corners, std::uint32_t triangles, bool can_refit) {
    const LeafPlaces places = places_in_leaf(corners, triangles);
    return ((can_refit ? places.end : places.vertices) + kernel::kWordsPerUnit - 1) / kernel::kWordsPerUnit;
}

// However large a mesh, leaves of a single triangle lie within reach of their names.
static_assert(kMaxTriangles * units_of_leaf(3, 1, true) <= std::size_t{kernel::kUnitMask} + 1);

inline std::uint32_t leaf_code(std::uint32_t corners, std::size_t unit) {
    return kernel::kLeafBit | (corners - 1) << kernel::kCornersShift | static_cast<std::uint32_t>(unit);
}
inline std::size_t unit_of(std::uint32_t leaf) {
    return leaf & kernel::kUnitMask;
}
inline std::uint32_t corners_of(std::uint32_t leaf) {
    return ((leaf & ~kernel::kLeafBit) >> kernel::kCornersShift) + 1;
}

class Leaf {
  public:
    Leaf(const float* leaves, std::uint32_t code)
        : block_(leaves + unit_of(code) * kernel::kWordsPerUnit),
          corners_(corners_of(code)),
          places_(places_in_leaf(corners_, (half(0) >> kernel::kCountShift & kernel::kCountMask) + 1)) {}

    // How many triangles.
    [[nodiscard]] std::uint32_t size() const { return places_.vertices - places_.primitives; }

    [[nodiscard]] std::uint32_t primitive(std::uint32_t triangle) const {
        return std::bit_cast<std::uint32_t>(block_[places_.primitives + triangle]);
    }
    // NaN where a refit has left nothing that could be met.
    [[nodiscard]] glm::vec3 corner(std::uint32_t triangle, std::uint32_t i) const {
        const std::uint32_t names = half(triangle);
        if ((names & kernel::kIsMet) == 0) return glm::vec3(std::numeric_limits<float>::quiet_NaN());
        const float* x = block_ + (names >> (kernel::kCornerBits * i) & (kernel::kMaxCorners - 1));
        return {x[0], x[corners_], x[2 * corners_]};
    }

  private:
    [[nodiscard]] std::uint32_t half(std::uint32_t triangle) const {
        std::uint16_t names;
        std::memcpy(&names, reinterpret_cast<const char*>(block_ + 3 * corners_) + 2 * triangle,
                    sizeof(names));
        return names;
    }

    const float* block_;
    std::uint32_t corners_;
    LeafPlaces places_;
};

}  // namespace rc
