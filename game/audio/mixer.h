// audio/mixer.h - what the player hears, mixed by OpenAL Soft with HRTF, in the room the player is in.
//
//   Result<SoundBank> bank = SoundBank::load(assets / "sounds");
//   Result<Mixer> mixer = Mixer::open_device(*bank);   // no device: a sentence; go on without a mixer
//   each tick: mixer->tick(ear, heard);                // and, for a loopback, mixer->render(stereo)
//
// A voice is three sources, one a band, that start on the same sample; only their gains and their direction
// ever change, and OpenAL Soft ramps both, so nothing clicks. How loud a voice is, is the caller's: OpenAL's
// own distance law is off, and a position says only where a sound comes from.
//
// Voices    the same key tick after tick is the same voice. A voice that is not named any more fades when it
//           loops, and otherwise rings out as it last was. A key whose sound has ended stays silent until it
//           has not been named for a tick. More keys than kMaxVoices: the loudest have it, lower keys first;
//           a sound that loses its voice is over, a loop may come back.
// Cost      6 to 8 % of a core with all voices, on OpenAL's own thread (device) or in render (loopback).
// Threads   one at a time per Mixer; the bank must outlive nothing: its samples are copied into OpenAL.
// Same bits a loopback given the same ticks renders the same samples on the same machine.
// Bad input a NaN in a position or gain: that sound is not played.
#pragma once

#include "audio/room_sound.h"
#include "audio/sound_bank.h"
#include "base/result.h"

#include <glm/vec3.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

namespace gh::audio {

inline constexpr std::size_t kMaxFading = 8;                     // voices on their way out, besides
inline constexpr std::size_t kMaxVoices = 24;                    // heard at once
inline constexpr std::size_t kFramesPerTick = kSampleRate / 60;  // 800
inline constexpr float kMostVolume = 4.0f;
inline constexpr float kMaxGain = 10.0f;  // of one band of one voice: 10 cm away

struct Ear {
    glm::vec3 position{0.0f};  // metres, world
    glm::vec3 forward{0.0f, 0.0f, -1.0f};
    glm::vec3 up{0.0f, 1.0f, 0.0f};
};

// One sound of this tick as it arrives at the ear.
struct Heard {
    SoundId sound;
    std::uint32_t voice_key = 0;
    glm::vec3 position{0.0f};  // where it seems to come from, world; at the ear itself: from everywhere
    float gain = 1.0f;         // times the file, before the bands
    std::array<float, world::kBands> band_gain{1.0f, 1.0f, 1.0f};
    bool loop = false;
};

class Mixer {
  public:
    // The system's own device, with HRTF where it can. Its absence is a sentence to show; the game goes on.
    [[nodiscard]] static Result<Mixer> open_device(const SoundBank& bank);
    // No device at all: the caller takes the samples. HRTF and the hall, or plain dry stereo for
    // measurements.
    [[nodiscard]] static Result<Mixer> open_loopback(const SoundBank& bank, bool hrtf = true);

    Mixer(Mixer&&) noexcept;
    Mixer& operator=(Mixer&&) noexcept;
    ~Mixer();

    // Starts, moves and fades voices so that this tick's sounds are those of `heard`.
    void tick(const Ear& ear, std::span<const Heard> heard);

    // The room that placed sounds ring in from the next tick on; faded over in half a second. A plain small one at first.
    void set_room(const RoomSound& room);

    // One tick of sound, left and right in turn: exactly 2 * kFramesPerTick samples. Loopback only.
    void render(std::span<float> stereo);

    // 0 silent, 1 as the files are, at most kMostVolume; anything else is brought into that range.
    void set_volume(float volume);
    // Holds every voice where it is. A device stops; a loopback renders silence.
    void set_paused(bool is_paused);

    [[nodiscard]] std::size_t voices() const;  // that sound now, those fading out included

  private:
    struct Engine;
    explicit Mixer(std::unique_ptr<Engine> engine);
    std::unique_ptr<Engine> engine_;
};

}  // namespace gh::audio
