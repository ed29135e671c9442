// load/fuse_parts.h - makes one part of all that stands still and is looked at alike.
//
// A ray enters every instance whose box it touches, and boxes of furniture overlap: in a museum a ray enters four
// instances and passes fourteen nodes where one tree over the same triangles costs it seven. Nothing is lost by fusing:
// materials belong to triangles.
//
// Left alone are parts that move, that belong to a lamp or its group, shells (level_check looks at them one by one),
// what lets light through, meshes that stand in so many places that they must stay instances, and all of a level that
// reaches farther than kFarthest from the origin, where a world coordinate has fewer digits than a part's own.
//
// Cost      one pass over the vertices. Same bits a function of the Level.
#pragma once

#include "world/level.h"

namespace gh::load {

inline constexpr float kFarthest = 1024.0f;  // metres: 2^-14 m between floats there

// Renumbers parts and meshes. Precondition: check_ranges holds; mark_clear_parts was called. The order of parts that
// are left is kept, fused ones come first.
void fuse_still_parts(world::Level& level);

}  // namespace gh::load
