// audio/sound_bank.h - all sounds of the game in memory, split into bands.
//
// Cost      loading decodes and splits about a minute of sound: some 100 ms and 30 MB.
// Threads   immutable after load().
// Bad input a missing, damaged, stereo, wrong-rate, empty or overlong file is one sentence naming it.
#pragma once

#include "audio/bands.h"
#include "audio/sound_id.h"
#include "base/result.h"

#include <cstddef>
#include <filesystem>
#include <vector>

namespace gh::audio {

inline constexpr std::size_t kMaxFrames = 30 * kSampleRate;  // of one file

struct Recording {
    Bands bands;  // of equal length
    bool loops = false;

    [[nodiscard]] std::size_t frames() const { return bands[0].size(); }
};

class SoundBank {
  public:
    // All files of `folder` that sound_id.h names.
    [[nodiscard]] static Result<SoundBank> load(const std::filesystem::path& folder);

    [[nodiscard]] const Recording& operator[](SoundId id) const { return recordings_[flat_index(id)]; }

    // How long a variant sounds, in ticks of 1/60 s, rounded up.
    [[nodiscard]] std::uint32_t ticks(SoundId id) const;

  private:
    std::vector<Recording> recordings_;  // by flat_index
};

// One file: mono, 48 kHz, whatever libsndfile reads.
[[nodiscard]] Result<std::vector<float>> read_sound(const std::filesystem::path& path);

}  // namespace gh::audio
