// raycore/counters.h - what queries did, for profilers. Counting is an argument, never a global, and costs
// nothing when it is not asked for.
#pragma once

#include <cstdint>

namespace rc {

struct Counters {
    std::uint64_t rays = 0;
    std::uint64_t instances = 0;  // bottom-level trees entered
    std::uint64_t nodes = 0;      // tree nodes opened, both levels
    std::uint64_t leaves = 0;     // triangle blocks tested

    Counters& operator+=(const Counters& other) {
        rays += other.rays;
        instances += other.instances;
        nodes += other.nodes;
        leaves += other.leaves;
        return *this;
    }
};

}  // namespace rc
