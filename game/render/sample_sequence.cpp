#include "render/sample_sequence.h"

#include "base/contracts.h"
#include "base/random.h"
#include "render/sample_scrambling.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace gh::render {

namespace {

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
        return scrambled_digits((curve_ << log2_count_) | sample, bits, key, 0);
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
    return first_coordinate(index(sample, key), hash_u32(key, 1));
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
    return {first_coordinate(i, hash_u32(key, 1)), second_coordinate(i, hash_u32(key, 2))};
}

}  // namespace gh::render
