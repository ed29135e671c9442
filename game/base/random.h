// base/random.h - random numbers with the same bits on every machine. Two kinds:
//   Random    a small generator one draws from in order; eight bytes, may live in State and be copied.
//   hash_u32  a counter turned to noise: no state, so the answer does not depend on who asks first.
//
// Cost      a few integer operations.
// Threads   a Random belongs to one thread; the functions are pure.
// Not for   secrets.
#pragma once

#include "base/contracts.h"

#include <bit>
#include <cstdint>

namespace gh {

// Stafford's variant 13 of the MurmurHash3 finaliser (as in splitmix64): every input bit moves every output
// bit.
[[nodiscard]] constexpr std::uint64_t mix_bits(std::uint64_t x) {
    x ^= x >> 30;
    x *= 0xBF58476D1CE4E5B9u;
    x ^= x >> 27;
    x *= 0x94D049BB133111EBu;
    x ^= x >> 31;
    return x;
}

// Noise of up to three counters, e.g. (pixel, sample, dimension) or (seed, tick, guard).
[[nodiscard]] constexpr std::uint32_t hash_u32(std::uint32_t a, std::uint32_t b = 0, std::uint32_t c = 0) {
    const std::uint64_t ab = (std::uint64_t{a} << 32) | b;
    const std::uint64_t first = mix_bits(ab + 0x9E3779B97F4A7C15u);
    return static_cast<std::uint32_t>(mix_bits(first + std::uint64_t{c} * 0x9E3779B97F4A7C15u) >> 32);
}

// The 24 leading bits as a float in [0, 1): every value exact, 1 never reached.
[[nodiscard]] constexpr float unit_from_bits(std::uint32_t bits) {
    return static_cast<float>(bits >> 8) * 0x1p-24f;
}

// PCG-XSH-RR 64/32 (O'Neill 2014). Seeds are mixed first, so that 0, 1, 2, ... are unrelated.
class Random {
  public:
    constexpr explicit Random(std::uint64_t seed) : state_(mix_bits(seed + 0x9E3779B97F4A7C15u)) {}

    constexpr std::uint32_t next_u32() {
        const std::uint64_t old = state_;
        state_ = old * 6364136223846793005u + 1442695040888963407u;
        const auto shifted = static_cast<std::uint32_t>(((old >> 18) ^ old) >> 27);
        return std::rotr(shifted, static_cast<int>(old >> 59));
    }

    // In [0, 1).
    constexpr float unit() { return unit_from_bits(next_u32()); }

    // In [low, high], both finite; high itself comes up only where rounding gives it.
    constexpr float in_range(float low, float high) { return low + (high - low) * unit(); }

    // In [0, count), every value equally likely. Precondition: count > 0.
    constexpr std::uint32_t below(std::uint32_t count) {
        EXPECTS(count > 0);
        const std::uint32_t uneven = (0u - count) % count;  // 2^32 mod count values too many: drawn again
        std::uint32_t bits = next_u32();
        while (bits < uneven) bits = next_u32();
        return bits % count;
    }

    // What a state hash adds.
    [[nodiscard]] constexpr std::uint64_t state() const { return state_; }

  private:
    std::uint64_t state_;
};
static_assert(sizeof(Random) == 8);

}  // namespace gh
