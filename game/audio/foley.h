// audio/foley.h - which sound a noise of the simulation makes.
//
// Pure: the variant follows from tick and place in the tick's list, so a replay sounds as the game did.
#pragma once

#include "audio/sound_id.h"
#include "world/level.h"
#include "world/state.h"
#include "world/surface.h"

#include <cstdint>
#include <optional>

namespace gh::audio {

// How a surface answers to a foot or a stone; the twelve surfaces share five voices.
enum class Ground : std::uint8_t { Marble, Parquet, Carpet, Metal, Glass };
[[nodiscard]] Ground ground_of(world::Surface surface);

// `index` is the noise's place in State::noises; `is_lid` says that what opens or shuts is a vitrine's lid. None
// for a noise that only guards react to.
[[nodiscard]] std::optional<SoundId> sound_of(const world::Noise& noise, std::uint32_t tick,
                                              std::uint32_t index, bool is_lid = false);

// Whether the door nearest to `position` turns about a level axis, as lids do and doors do not.
[[nodiscard]] bool is_lid_at(const world::Level& level, const glm::vec3& position);

// One of a family's variants, spread evenly over (tick, salt).
[[nodiscard]] SoundId variant_of(Sound sound, std::uint32_t tick, std::uint32_t salt);

}  // namespace gh::audio
