// world/layers.h - who meets what: one bit of an instance's mask each.
#pragma once

#include "raycore/ray.h"

namespace gh::world {

inline constexpr rc::LayerMask Light = 1u << 0;  // drawn, and casts shadows
inline constexpr rc::LayerMask Sight = 1u << 1;  // stops a creature's look (glass does not)
inline constexpr rc::LayerMask Sound = 1u << 2;  // takes its share of a sound that crosses it
inline constexpr rc::LayerMask Solid = 1u << 3;  // stops feet and stones


// What a drawn part does to a shadow ray, told apart so that most need one query (world/clear_parts.h sets them).
inline constexpr rc::LayerMask Blocker = 1u << 4;  // blocks it for good
inline constexpr rc::LayerMask Clear = 1u << 5;   // holds glass, holes or tints: one must look closer

inline constexpr rc::LayerMask kEverything = Light | Sight | Sound | Solid;

}  // namespace gh::world
