#include "render/sample_sequence.h"

#include "base/contracts.h"
#include "base/random.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

namespace gh::render {

namespace {

constexpr int kBlockBits = 8;  // of pixels a side that share one sequence under blue noise

constexpr std::uint32_t reversed(std::uint32_t x) {
    x = ((x >> 1) & 0x55555555u) | ((x & 0x55555555u) << 1);
    x = ((x >> 2) & 0x33333333u) | ((x & 0x33333333u) << 2);
    x = ((x >> 4) & 0x0F0F0F0Fu) | ((x & 0x0F0F0F0Fu) << 4);
    x = ((x >> 8) & 0x00FF00FFu) | ((x & 0x00FF00FFu) << 8);
    return (x >> 16) | (x << 16);
}

// Flips every bit by a hash of the ones below it: in the order of reversed bits that is nested uniform scrambling
// (Laine and Karras 2011). Additions, odd multiplications and x ^= x * even carry upwards only.
constexpr std::uint32_t carried_up(std::uint32_t x, std::uint32_t seed) {
    x ^= x * 0x3d20adeau;
    x += seed;
    x *= (seed >> 16) | 1u;
    x ^= x * 0x05526c56u;
    x ^= x * 0x53a22864u;
    return x;
}

// The second Sobol dimension's bits, last one first: row j of Pascal's triangle modulo 2 takes every index bit whose
// number contains that of j (Lucas), a sum over supersets.
constexpr std::uint32_t second_dimension(std::uint32_t index) {
    index ^= (index & 0xAAAAAAAAu) >> 1;
    index ^= (index & 0xCCCCCCCCu) >> 2;
    index ^= (index & 0xF0F0F0F0u) >> 4;
    index ^= (index & 0xFF00FF00u) >> 8;
    index ^= (index & 0xFFFF0000u) >> 16;
    return index;
}

float first_coordinate(std::uint32_t index, std::uint32_t key) {
    return unit_from_bits(reversed(carried_up(index, hash_u32(key, 1))));
}
float second_coordinate(std::uint32_t index, std::uint32_t key) {
    return unit_from_bits(reversed(carried_up(second_dimension(index), hash_u32(key, 2))));
}

// Where `i` comes in a random order of [0, length), by walking through an order of the next power of two.
std::uint32_t shuffled(std::uint32_t i, std::uint32_t length, std::uint32_t seed) {
    if (length <= 1) return 0;
    const std::uint32_t mask = std::bit_ceil(length) - 1u;
    const unsigned half = std::max(1u, static_cast<unsigned>(std::bit_width(mask)) / 2u);
    do {
        for (std::uint32_t round = 0; round < 4; ++round) {
            i = (i * (hash_u32(seed, round) | 1u) + hash_u32(seed, round, 1)) & mask;
            i ^= i >> half;
        }
    } while (i >= length);
    return i;
}

constexpr std::uint32_t spread_bits(std::uint32_t x) {
    x = (x | (x << 4)) & 0x0F0Fu;
    x = (x | (x << 2)) & 0x3333u;
    return (x | (x << 1)) & 0x5555u;
}

// All orders of four children.
constexpr std::array<std::array<std::uint8_t, 4>, 24> kOrders = [] {
    std::array<std::array<std::uint8_t, 4>, 24> orders{};
    std::size_t n = 0;
    for (unsigned a = 0; a < 4; ++a) {
        for (unsigned b = 0; b < 4; ++b) {
            for (unsigned c = 0; c < 4; ++c) {
                if (a == b || a == c || b == c) continue;
                const unsigned d = 6 - a - b - c;
                orders[n++] = {static_cast<std::uint8_t>(a), static_cast<std::uint8_t>(b),
                               static_cast<std::uint8_t>(c), static_cast<std::uint8_t>(d)};
            }
        }
    }
    return orders;
}();

// Renames the children of every node of the tree of digits, each node by itself.
std::uint32_t scrambled_digits(std::uint32_t index, int bits, std::uint32_t key) {
    std::uint32_t result = 0;
    int left = bits;
    for (; left >= 2; left -= 2) {
        const std::uint32_t above = left < 32 ? index >> left : 0u;
        const std::uint32_t order = hash_u32(above, key, static_cast<std::uint32_t>(left)) % 24u;
        result = (result << 2) | kOrders[order][(index >> (left - 2)) & 3u];
    }
    if (left == 1) result = (result << 1) | ((index ^ hash_u32(index >> 1, key)) & 1u);
    return result;
}

}  // namespace

SampleSequence::SampleSequence(const SampleSettings& settings, int x, int y, std::uint32_t frame)
    : kind_(settings.kind), count_(settings.samples_per_pixel) {
    EXPECTS(count_ >= 1 && count_ <= 65536);
    auto column = static_cast<std::uint32_t>(x), row = static_cast<std::uint32_t>(y);
    log2_count_ = static_cast<std::uint32_t>(std::bit_width(count_ - 1u));
    std::uint32_t salt = hash_u32(settings.seed, frame, 0x5EED5u);
    if (kind_ == SampleKind::Sobol) {
        salt = hash_u32(settings.seed, 0, 0x5EED5u);
        first_ = frame * count_;
    }
    if (kind_ == SampleKind::BlueNoise) {
        constexpr std::uint32_t kMask = (1u << kBlockBits) - 1u;
        curve_ = spread_bits(column & kMask) | (spread_bits(row & kMask) << 1);
        column >>= kBlockBits;
        row >>= kBlockBits;
    }
    seed_ = hash_u32(column, row, salt);
}

std::uint32_t SampleSequence::index(std::uint32_t sample, std::uint32_t key) const {
    if (kind_ == SampleKind::BlueNoise) {
        const int bits = 2 * kBlockBits + static_cast<int>(log2_count_);
        return scrambled_digits((curve_ << log2_count_) | sample, bits, key);
    }
    return reversed(carried_up(reversed(first_ + sample), key));
}

float SampleSequence::one(std::uint32_t sample, std::uint32_t dimension) const {
    const std::uint32_t key = hash_u32(seed_, dimension, 1);
    if (kind_ == SampleKind::Iid) return unit_from_bits(hash_u32(key, sample));
    if (kind_ == SampleKind::Jittered) {
        const float within = unit_from_bits(hash_u32(key, sample, 3));
        const float cell = static_cast<float>(shuffled(sample, count_, key));
        return std::min((cell + within) / static_cast<float>(count_), 0x1.fffffep-1f);
    }
    return first_coordinate(index(sample, key), key);
}

glm::vec2 SampleSequence::two(std::uint32_t sample, std::uint32_t dimension) const {
    const std::uint32_t key = hash_u32(seed_, dimension, 2);
    if (kind_ == SampleKind::Iid)
        return {unit_from_bits(hash_u32(key, sample, 3)), unit_from_bits(hash_u32(key, sample, 4))};
    if (kind_ == SampleKind::Jittered) {
        const auto across = static_cast<std::uint32_t>(std::ceil(std::sqrt(static_cast<float>(count_))));
        const std::uint32_t down = (count_ + across - 1) / across;
        const std::uint32_t cell = shuffled(sample, across * down, key);
        const glm::vec2 within(unit_from_bits(hash_u32(key, sample, 3)),
                               unit_from_bits(hash_u32(key, sample, 4)));
        const glm::uvec2 column_row(cell % across, cell / across);
        const glm::vec2 corner(column_row);
        const glm::vec2 at =
            (corner + within) / glm::vec2(static_cast<float>(across), static_cast<float>(down));
        return {std::min(at.x, 0x1.fffffep-1f), std::min(at.y, 0x1.fffffep-1f)};
    }
    const std::uint32_t i = index(sample, key);
    return {first_coordinate(i, key), second_coordinate(i, key)};
}

}  // namespace gh::render
