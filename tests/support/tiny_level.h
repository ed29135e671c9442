// support/tiny_level.h - the smallest level with one of everything, as the bytes of a .glb (about 15 kB).
//
//            -z                 Two rooms of 8 x 3 x 3 m, closed by one shell, with a wall at z = 0 between
//            them
//   +-----------------+         and a doorway of 1.2 m in its middle.
//   | guard   lens    |         front (z > 0): spawn, exit, switch, bulb (group "main"), turnable mirror
//   | p1  p2     pane |         back  (z < 0): lens, a pane of glass, a guard who walks p1 - p2, a point
// light
//   +------[door]-----+
//   | switch  bulb    |         The shell is textured; the door's leaf is its child and turns with it; the
//   | exit spawn  mir |         guard's body is a skinned box of two joints with three clips: "stand"
// (linear),
//   +-----------------+         "walk" (cubic spline), "look" (step). A camera "door_view" looks at the door.
//            +z
#pragma once

#include <cstddef>
#include <vector>

namespace gh::test {

[[nodiscard]] std::vector<std::byte> tiny_level_glb();

}  // namespace gh::test
