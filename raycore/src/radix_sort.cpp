#include "radix_sort.h"

#include "parallel.h"

#include <algorithm>
#include <array>
#include <vector>

namespace rc::build {

namespace {

constexpr int kBits = 12;
constexpr std::size_t kBuckets = std::size_t{1} << kBits;
constexpr std::size_t kKeysAtATime = 65536;  // keys one thread takes at a time

using Histogram = std::array<std::uint32_t, kBuckets>;

void sort_by(std::span<const std::uint64_t> from, std::span<std::uint64_t> to, int lowest) {
    const auto bucket = [&](std::uint64_t key) { return key >> lowest & (kBuckets - 1); };
    std::vector<Histogram> blocks((from.size() + kKeysAtATime - 1) / kKeysAtATime);
    const auto for_blocks = [&](const auto& body) {
        for_in_parallel(blocks.size(), [&](std::size_t b) {
            body(blocks[b], b * kKeysAtATime, std::min(from.size(), (b + 1) * kKeysAtATime));
        });
    };
    for_blocks([&](Histogram& counts, std::size_t begin, std::size_t end) {
        counts.fill(0);
        for (std::size_t i = begin; i < end; ++i) ++counts[bucket(from[i])];
    });
    // Counts become places: bucket by bucket, within each block by block.
    std::uint32_t place = 0;
    for (std::size_t k = 0; k < kBuckets; ++k) {
        for (Histogram& counts : blocks) {
            const std::uint32_t count = counts[k];
            counts[k] = place;
            place += count;
        }
    }
    for_blocks([&](Histogram& places, std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) to[places[bucket(from[i])]++] = from[i];
    });
}

}  // namespace

void radix_sort(std::span<std::uint64_t> keys, std::span<std::uint64_t> spare, int lowest, int passes) {
    std::span<std::uint64_t> from = keys, to = spare;
    for (int pass = 0; pass < passes; ++pass) {
        sort_by(from, to, lowest + pass * kBits);
        std::swap(from, to);
    }
    if (from.data() != keys.data()) std::copy(from.begin(), from.end(), keys.begin());
}

}  // namespace rc::build
