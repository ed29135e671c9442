#include "audio/foley.h"

#include "base/random.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace gh::audio {

namespace {

// The five families of one thing lie next to each other in the order of Ground.
Sound on_ground(Sound marble, Ground ground) {
    return static_cast<Sound>(static_cast<std::uint8_t>(marble) + static_cast<std::uint8_t>(ground));
}

static_assert(static_cast<int>(Sound::StepGlass) - static_cast<int>(Sound::StepMarble) ==
              static_cast<int>(Ground::Glass));
static_assert(static_cast<int>(Sound::BootGlass) - static_cast<int>(Sound::BootMarble) ==
              static_cast<int>(Ground::Glass));
static_assert(static_cast<int>(Sound::StoneGlass) - static_cast<int>(Sound::StoneMarble) ==
              static_cast<int>(Ground::Glass));

std::optional<Sound> spoken(world::Bark bark) {
    switch (bark) {
        case world::Bark::None:
            return std::nullopt;
        case world::Bark::Huh:
            return Sound::VoiceHm;
        case world::Bark::WhoIsThere:
            return Sound::VoiceWho;
        case world::Bark::Alarm:
            return Sound::VoiceAlarm;
        case world::Bark::GaveUp:
            return Sound::VoiceGaveUp;
        case world::Bark::Caught:
            return Sound::VoiceCaught;
    }
    return std::nullopt;
}

std::optional<Sound> family_of(const world::Noise& noise, bool is_lid) {
    const auto surface = static_cast<world::Surface>(noise.surface);
    const bool is_iron = surface == world::Surface::Metal;
    switch (noise.kind) {
        case world::NoiseKind::Footstep:
            return on_ground(Sound::StepMarble, ground_of(surface));
        case world::NoiseKind::GuardStep:
            return on_ground(Sound::BootMarble, ground_of(surface));
        case world::NoiseKind::StoneHit:
            return on_ground(Sound::StoneMarble, ground_of(surface));
        case world::NoiseKind::Land:
            return Sound::Land;
        case world::NoiseKind::Throw:
            return Sound::Throw;
        case world::NoiseKind::DoorOpen:
            return is_lid ? Sound::VitrineOpen : is_iron ? Sound::GateOpen : Sound::DoorOpen;
        case world::NoiseKind::DoorClose:
            return is_lid ? Sound::VitrineClose : is_iron ? Sound::GateClose : Sound::DoorClose;
        case world::NoiseKind::Switch:
            return Sound::Switch;
        case world::NoiseKind::MirrorTurn:
            return Sound::MirrorTurn;
        case world::NoiseKind::PickUp:
            return Sound::PickUp;
        case world::NoiseKind::LensTaken:
            return Sound::LensTaken;
        case world::NoiseKind::Bark:
            return spoken(noise.bark);
    }
    return std::nullopt;
}

}  // namespace

Ground ground_of(world::Surface surface) {
    switch (surface) {
        case world::Surface::Marble:
        case world::Surface::Concrete:
        case world::Surface::Plaster:
            return Ground::Marble;
        case world::Surface::Parquet:
        case world::Surface::Oak:
        case world::Surface::Stud:
            return Ground::Parquet;
        case world::Surface::Metal:
            return Ground::Metal;
        case world::Surface::Glass:
        case world::Surface::Pane:
            return Ground::Glass;
        case world::Surface::Curtain:
        case world::Surface::Ceiling:
        case world::Surface::Carpet:
            return Ground::Carpet;
    }
    return Ground::Marble;
}

SoundId variant_of(Sound sound, std::uint32_t tick, std::uint32_t salt) {
    const std::uint32_t variants = traits(sound).variants;
    return {sound,
            static_cast<std::uint8_t>(hash_u32(tick, salt, static_cast<std::uint32_t>(sound)) % variants)};
}

std::optional<SoundId> sound_of(const world::Noise& noise, std::uint32_t tick, std::uint32_t index,
                                bool is_lid) {
    const std::optional<Sound> family = family_of(noise, is_lid);
    if (!family) return std::nullopt;
    return variant_of(*family, tick, index);
}

bool is_lid_at(const world::Level& level, const glm::vec3& position) {
    float nearest = rc::kInfinity;
    bool is_lid = false;
    for (const world::Door& door : level.doors) {
        const float metres =
            std::min(glm::distance(door.handle, position), glm::distance(door.hinge, position));
        if (!(metres < nearest)) continue;
        nearest = metres;
        is_lid = std::abs((door.world_from_rest * door.axis).y) < 0.7f;
    }
    return is_lid;
}

}  // namespace gh::audio
