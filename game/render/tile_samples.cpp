#include "render/tile_samples.h"

#include "base/contracts.h"
#include "base/random.h"
#include "render/sample_scrambling.h"

namespace gh::render {

namespace {

constexpr int kTileBits = 8;  // of the curve, within a tile

}  // namespace

void TileSamples::begin(const SampleSettings& settings, int x, int y, int columns, int rows,
                        std::uint32_t frame) {
    EXPECTS(x % kSide == 0 && y % kSide == 0 && columns <= kSide && rows <= kSide);
    kind_ = settings.kind;
    sequences_.clear();
    for (int row = 0; row < rows; ++row) {
        for (int column = 0; column < columns; ++column)
            sequences_.emplace_back(settings, x + column, y + row, frame);
    }
    if (kind_ != SampleKind::BlueNoise) return;
    curves_.resize(kCurves);
    for (Curve& curve : curves_) curve.coordinates = 0;
}

auto TileSamples::curve_of(std::uint32_t dimension, std::uint32_t coordinates) -> Curve& {
    Curve& curve = curves_[(dimension * 2 + coordinates) % kCurves];
    if (curve.dimension == dimension && curve.coordinates == coordinates) return curve;
    const SampleSequence& any = sequences_.front();
    curve.dimension = dimension;
    curve.coordinates = coordinates;
    curve.key = hash_u32(any.seed(), dimension, coordinates);
    curve.first = hash_u32(curve.key, 1);
    curve.second = hash_u32(curve.key, 2);
    curve.filled = 0;
    const int lower = kTileBits + static_cast<int>(any.log2_count());
    const std::uint32_t tile = any.curve() >> kTileBits;
    curve.above = 0;
    for (int left = kTileBits; left > 0; left -= 2)
        curve.above = (curve.above << 2) |
                      digit_order(tile >> left, curve.key, left + lower)[(tile >> (left - 2)) & 3u];
    return curve;
}

// The places of a block's pixels: two digits in common, two of their own.
void TileSamples::fill(Curve& curve, std::uint32_t block) const {
    const SampleSequence& any = sequences_.front();
    const int lower = static_cast<int>(any.log2_count());
    const std::uint32_t at =
        (any.curve() >> kTileBits << 4) | block;  // of the curve, but for the last four bits
    const std::uint32_t outer = digit_order(at >> 4, curve.key, 8 + lower)[block >> 2];
    const std::uint32_t inner = digit_order(at >> 2, curve.key, 6 + lower)[block & 3u];
    const std::uint32_t above = (curve.above << 4) | (outer << 2) | inner;
    const auto& order = digit_order(at, curve.key, 4 + lower);
    for (std::uint32_t quarter = 0; quarter < 4; ++quarter) {
        const auto& last = digit_order((at << 2) | quarter, curve.key, 2 + lower);
        for (std::uint32_t i = 0; i < 4; ++i)
            curve.places[block][quarter * 4 + i] =
                static_cast<std::uint16_t>((above << 4) | (std::uint32_t{order[quarter]} << 2) | last[i]);
    }
    curve.filled |= 1u << block;
}

std::uint32_t TileSamples::index(Curve& curve, std::size_t pixel, std::uint32_t sample) const {
    const SampleSequence& own = sequences_[pixel];
    const std::uint32_t block = (own.curve() >> 4) & 15u;
    if ((curve.filled >> block & 1u) == 0) fill(curve, block);
    const std::uint32_t place = curve.places[block][own.curve() & 15u];
    if (own.log2_count() == 0) return place;
    return scrambled_digits((own.curve() << own.log2_count()) | sample, static_cast<int>(own.log2_count()),
                            curve.key, place);
}

float TileSamples::one(std::size_t pixel, std::uint32_t sample, std::uint32_t dimension) {
    if (kind_ != SampleKind::BlueNoise) return sequences_[pixel].one(sample, dimension);
    Curve& curve = curve_of(dimension, 1);
    return first_coordinate(index(curve, pixel, sample), curve.first);
}

glm::vec2 TileSamples::two(std::size_t pixel, std::uint32_t sample, std::uint32_t dimension) {
    if (kind_ != SampleKind::BlueNoise) return sequences_[pixel].two(sample, dimension);
    Curve& curve = curve_of(dimension, 2);
    const std::uint32_t i = index(curve, pixel, sample);
    return {first_coordinate(i, curve.first), second_coordinate(i, curve.second)};
}

}  // namespace gh::render
