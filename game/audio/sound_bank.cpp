#include "audio/sound_bank.h"

#include <sndfile.h>

#include <memory>
#include <utility>

namespace gh::audio {

namespace {

struct CloseFile {
    void operator()(SNDFILE* file) const { sf_close(file); }
};

Error cannot_use(const std::filesystem::path& path, const std::string& reason) {
    return {"cannot use the sound " + path.string() + ": " + reason};
}

}  // namespace

Result<std::vector<float>> read_sound(const std::filesystem::path& path) {
    std::error_code code;
    if (!std::filesystem::is_regular_file(path, code)) return cannot_use(path, "there is no such file");
    SF_INFO info{};
    const std::unique_ptr<SNDFILE, CloseFile> file(sf_open(path.c_str(), SFM_READ, &info));
    if (!file) return cannot_use(path, sf_strerror(nullptr));
    if (info.channels != 1) {
        return cannot_use(path, "it has " + std::to_string(info.channels) + " channels, and sounds have one");
    }
    if (info.samplerate != kSampleRate) {
        return cannot_use(path, "its rate is " + std::to_string(info.samplerate) + " Hz, not 48000");
    }
    if (info.frames <= 0 || static_cast<std::uint64_t>(info.frames) > kMaxFrames) {
        return cannot_use(path, "it is empty or longer than 30 seconds");
    }
    // The header's count is only a claim; what is really there decides.
    std::vector<float> samples(static_cast<std::size_t>(info.frames));
    const sf_count_t read = sf_readf_float(file.get(), samples.data(), info.frames);
    if (read != info.frames) return cannot_use(path, "it ends early or is damaged");
    for (const float x : samples) {
        if (!(x >= -8.0f && x <= 8.0f)) return cannot_use(path, "it holds a sample that is no number");
    }
    return samples;
}

Result<SoundBank> SoundBank::load(const std::filesystem::path& folder) {
    SoundBank bank;
    bank.recordings_.reserve(flat_count());
    for (std::size_t family = 0; family < kSoundCount; ++family) {
        const auto sound = static_cast<Sound>(family);
        for (std::uint8_t variant = 0; variant < traits(sound).variants; ++variant) {
            const Result<std::vector<float>> samples = read_sound(folder / file_name({sound, variant}));
            if (!samples) return samples.error();
            const bool loops = traits(sound).loops;
            bank.recordings_.push_back({split_bands(*samples, loops), loops});
        }
    }
    return bank;
}

std::uint32_t SoundBank::ticks(SoundId id) const {
    constexpr std::size_t kPerTick = kSampleRate / 60;
    return static_cast<std::uint32_t>(((*this)[id].frames() + kPerTick - 1) / kPerTick);
}

}  // namespace gh::audio
