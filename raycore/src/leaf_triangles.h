// leaf_triangles.h - which vertices the lanes of all leaves have, kept for refits.
//
// Eight bytes a lane where the corners of every triangle lie within 2^16 of each other in the vertex array, as they
// mostly do; twelve for the whole mesh where they do not.
#pragma once

#include "unfilled.h"

#include <glm/vec3.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

namespace rc {

class LeafTriangles {
  public:
    // Room for so many lanes of a mesh's triangles.
    void resize(std::size_t lanes, std::span<const glm::uvec3> mesh) {
        is_near_ = std::all_of(mesh.begin(), mesh.end(), [](const glm::uvec3& t) { return is_near(t); });
        is_near_ ? near_.resize(lanes) : far_.resize(lanes);
    }

    void set(std::size_t lane, const glm::uvec3& t) {
        if (is_near_) {
            near_[lane] = std::uint64_t{t.x} | std::uint64_t{t.y - t.x + kBias} << kFirstBits |
                          std::uint64_t{t.z - t.x + kBias} << (kFirstBits + kStepBits);
        } else {
            far_[lane] = t;
        }
    }

    // Three words a lane, in order.
    void get(std::size_t first, std::size_t count, std::uint32_t* out) const {
        for (std::size_t i = 0; i < count; ++i, out += 3) {
            const glm::uvec3 t = is_near_ ? unpacked(near_[first + i]) : far_[first + i];
            out[0] = t.x, out[1] = t.y, out[2] = t.z;
        }
    }

    bool operator==(const LeafTriangles&) const = default;

    [[nodiscard]] std::size_t byte_size() const {
        return near_.capacity() * sizeof(std::uint64_t) + far_.capacity() * sizeof(glm::uvec3);
    }

  private:
    static constexpr std::uint32_t kFirstBits = 30, kStepBits = 17, kBias = 1u << (kStepBits - 1);

    static constexpr std::uint32_t bits_of(std::uint64_t packed, std::uint32_t from, std::uint32_t bits) {
        return static_cast<std::uint32_t>(packed >> from) & ((1u << bits) - 1);
    }
    static bool is_near(const glm::uvec3& t) {
        // Unsigned, so that what wraps round is far.
        return t.x < 1u << kFirstBits && t.y - t.x + kBias < 2 * kBias && t.z - t.x + kBias < 2 * kBias;
    }
    static glm::uvec3 unpacked(std::uint64_t packed) {
        const std::uint32_t first = bits_of(packed, 0, kFirstBits);
        return {first, first + bits_of(packed, kFirstBits, kStepBits) - kBias,
                first + bits_of(packed, kFirstBits + kStepBits, kStepBits) - kBias};
    }

    Unfilled<std::uint64_t> near_;  // the first corner, and how far the others are from it
    Unfilled<glm::uvec3> far_;
    bool is_near_ = true;
};

}  // namespace rc
