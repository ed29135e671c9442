// render/lamp_looks.h - what one tile of a picture has seen of each lamp so far, so that it asks less for those that turn
// out to be hidden from it.
//
// Cost      begin() as many steps as lamps were looked at before, the others one step.
// Same bits a function of the calls since begin(), in their order.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace gh::render {

class LampLooks {
  public:
    // Forgets all looks; lamps have the numbers 0 ... lamps - 1.
    void begin(std::size_t lamps) {
        for (const std::uint32_t lamp : looked_at_) looks_[lamp] = {};
        looked_at_.clear();
        looks_.resize(lamps);
    }

    // A look of which `share` got through.
    void note(std::uint32_t lamp, float share) {
        Looks& looks = looks_[lamp];
        if (looks.count == 0.0f) looked_at_.push_back(lamp);
        looks.seen += share;
        looks.count += 1.0f;
    }

    // The share that the next look is likely to find, where `expected` was before any: that counts as much as kTrust
    // looks (the mean of a beta distribution that starts with as many). Never 0.
    [[nodiscard]] float open(std::uint32_t lamp, float expected) const {
        const Looks& looks = looks_[lamp];
        return (std::max(expected, kLeast) * kTrust + looks.seen) / (kTrust + looks.count);
    }

  private:
    static constexpr float kTrust = 0.25f;
    static constexpr float kLeast = 1.0f / 32.0f;  // what is known before is by few looks as well
    struct Looks {
        float seen = 0.0f, count = 0.0f;
    };
    std::vector<Looks> looks_;
    std::vector<std::uint32_t> looked_at_;
};

}  // namespace gh::render
