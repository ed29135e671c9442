// world/state_hash.h - one number for all that changes, and one for each kind of thing, so that two runs that
// part company can say in which tick and over what.
//
// Hashed    field by field in written order; padding and the pad_ members never. Entries beyond what the level
//           has are hashed too: they are part of State and must stay as they were made.
// Cost      about 30 us.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "world/state.h"

namespace gh::world {

enum class HashPart : std::uint8_t { Player, Rules, Doors, Mirrors, Lamps, Lenses, Stones, Guards, Noises };
inline constexpr std::size_t kHashParts = 9;

struct StateHash {
    std::uint64_t total = 0;
    std::array<std::uint64_t, kHashParts> part{};

    bool operator==(const StateHash&) const = default;
};

[[nodiscard]] StateHash state_hash(const State& state);

[[nodiscard]] std::string_view hash_part_name(HashPart part);  // "player", ...

}  // namespace gh::world
