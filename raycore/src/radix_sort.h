// radix_sort.h - keys sorted by several threads, into one order whatever their number.
#pragma once

#include <cstdint>
#include <span>

namespace rc::build {

// By bits [lowest, lowest + 12 * passes) only; equal ones keep their order. `spare` is as long as `keys`.
void radix_sort(std::span<std::uint64_t> keys, std::span<std::uint64_t> spare, int lowest, int passes);

}  // namespace rc::build
