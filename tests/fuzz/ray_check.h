// fuzz/ray_check.h - whether raycore answers a world as the specification does, and every tree and instruction set alike.
#pragma once

#include "fuzzed_world.h"

#include <string>

namespace fuzz {

// Empty when all agree; else a sentence that says who differs on what.
[[nodiscard]] std::string check(const World& world);

}  // namespace fuzz
