// render/lattice.h - the order in which a row of pixels is visited when only some of them are worked out: every fifth
// and both ends first, the ones half-way between those next, the rest last.
//
// Same bits a function of the length.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace gh::render {

inline constexpr int kLatticePasses = 3;
inline constexpr int kLatticeStep = 5;

template <std::size_t kMost>
struct Lattice {
    std::array<std::uint8_t, kMost> pass{};  // in which a pixel is visited
    // The nearest pixels at or before, at or after it that were visited in an earlier pass.
    std::array<std::array<std::uint8_t, kMost>, kLatticePasses> before{}, after{};

    constexpr Lattice() = default;
    // Precondition: 1 <= length <= kMost.
    explicit constexpr Lattice(int length) {
        pass.fill(kLatticePasses - 1);
        const int last = length - 1;
        const int spans = (last + kLatticeStep - 1) / kLatticeStep;
        pass[0] = 0;
        for (int i = 1, from = 0; i <= spans; ++i) {
            const int to = (i * last + spans / 2) / spans;
            pass[static_cast<std::size_t>(to)] = 0;
            const auto middle = static_cast<std::size_t>((from + to) / 2);
            if (pass[middle] != 0) pass[middle] = 1;
            from = to;
        }
        for (std::size_t p = 1; p < kLatticePasses; ++p) {
            std::size_t nearest = 0;
            for (std::size_t i = 0; i < static_cast<std::size_t>(length); ++i) {
                if (pass[i] < p) nearest = i;
                before[p][i] = static_cast<std::uint8_t>(nearest);
            }
            for (std::size_t i = static_cast<std::size_t>(length); i-- > 0;) {
                if (pass[i] < p) nearest = i;
                after[p][i] = static_cast<std::uint8_t>(nearest);
            }
        }
    }
};

}  // namespace gh::render
