// support/random.h - the tests' own random numbers: the same on every machine, independent of the game's.
#pragma once

#include <glm/vec3.hpp>

#include <cmath>
#include <cstdint>

namespace test {

// SplitMix64 (Steele, Lea, Flood 2014).
class Random {
  public:
    explicit Random(std::uint64_t seed) : state_(seed) {}

    std::uint64_t bits() {
        std::uint64_t z = state_ += 0x9E3779B97F4A7C15u;
        z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
        z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
        return z ^ (z >> 31);
    }
    std::uint32_t below(std::uint32_t n) { return static_cast<std::uint32_t>((bits() >> 32) * n >> 32); }
    float unit() { return static_cast<float>(bits() >> 40) * 0x1p-24f; }  // [0, 1)
    float between(float low, float high) { return low + (high - low) * unit(); }
    glm::vec3 in_cube(float half) {
        const float x = between(-half, half), y = between(-half, half);
        return {x, y, between(-half, half)};
    }
    glm::vec3 direction() {  // unit to rounding, uniform by rejection
        for (;;) {
            const glm::vec3 v = in_cube(1.0f);
            const float square = v.x * v.x + v.y * v.y + v.z * v.z;
            if (square > 1e-4f && square <= 1.0f) return v / std::sqrt(square);
        }
    }

  private:
    std::uint64_t state_;
};

}  // namespace test
