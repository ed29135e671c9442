// audio/sound_id.h - every sound the game has, by what makes it, and the file each lies in.
//
// A Sound is a family of variants of one thing (four steps on marble); a SoundId is one of them. Files are
// named assets/sounds/NAME_1.flac .. NAME_n.flac. The table is the only place where names and numbers meet.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace gh::audio {

enum class Sound : std::uint8_t {
    StepMarble,
    StepParquet,
    StepCarpet,
    StepMetal,
    StepGlass,
    BootMarble,
    BootParquet,
    BootCarpet,
    BootMetal,
    BootGlass,
    StoneMarble,
    StoneParquet,
    StoneCarpet,
    StoneMetal,
    StoneGlass,
    Land,
    Throw,
    DoorOpen,
    DoorClose,
    GateOpen,  // of iron
    GateClose,
    VitrineOpen,
    VitrineClose,
    Switch,
    MirrorTurn,
    LensTaken,
    PickUp,
    VoiceHm,       // something caught his eye or ear
    VoiceWho,      // calls into the dark
    VoiceAlarm,    // has seen the player
    VoiceGaveUp,   // a sigh
    VoiceCaught,   // "ha-ha"
    VoiceWhistle,  // to himself, on patrol
    LampHum,       // loop
    RoomTone,      // loop
    StingCaught,
    StingWon,
};
inline constexpr std::size_t kSoundCount = 37;

struct SoundTraits {
    std::string_view name;      // of its files, without number and ending
    std::uint8_t variants = 1;  // >= 1
    bool loops = false;
    float reference_db = 60.0f;  // a world::Noise this loud plays the file as it is
};

[[nodiscard]] const SoundTraits& traits(Sound sound);

struct SoundId {
    Sound sound = Sound::StepMarble;
    std::uint8_t variant = 0;  // below traits(sound).variants

    friend bool operator==(const SoundId&, const SoundId&) = default;
};

// Position in a list of all variants of all sounds, families in the order of the enumeration.
[[nodiscard]] std::size_t flat_index(SoundId id);
[[nodiscard]] std::size_t flat_count();

// "step_marble_2.flac"
[[nodiscard]] std::string file_name(SoundId id);

}  // namespace gh::audio
