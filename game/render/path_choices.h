// render/path_choices.h - what a tile's decisions have in common: which random number is for what, and how finds are
// weighed.
#pragma once

#include <cstdint>

namespace gh::render {

// Dimensions of the sample sequence, at the eye.
enum EyePurpose : std::uint32_t { kPixelDimension, kApertureDimension, kShutterDimension };

// And at each bounce.
enum Purpose : std::uint32_t {
    kLobePurpose,
    kDirectionPurpose,
    kLampPurpose,
    kOnLampPurpose,
    kRoulettePurpose,
    kHolePurpose,
    kGleamPurpose,
    kWhichGleamPurpose
};

// The power heuristic: what a find by the way of density `own` counts when another one might have found it too.
[[nodiscard]] inline float counts(float own, float other) {
    if (!(other > 0.0f)) return 1.0f;
    const float ratio = other / own;
    return 1.0f / (1.0f + ratio * ratio);
}

}  // namespace gh::render
