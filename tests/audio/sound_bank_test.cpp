#include "audio/sound_bank.h"

#include "audio/listening.h"
#include "support/random.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace gh::audio {
namespace {

namespace fs = std::filesystem;

class BrokenSounds : public testing::Test {
  protected:
    void SetUp() override {
        folder_ = fs::temp_directory_path() / ("glasshouse_sounds_" + std::to_string(::getpid()));
        fs::copy(test::sounds_folder(), folder_);
    }
    void TearDown() override { fs::remove_all(folder_); }

    // A 16-bit WAV of silence, said to have `frames` frames though `written` of them follow.
    void write_wav(const fs::path& path, std::uint16_t channels, std::uint32_t rate, std::uint32_t frames,
                   std::uint32_t written) const {
        const auto put = [](std::string& to, std::uint32_t value, int bytes) {
            for (int i = 0; i < bytes; ++i) to.push_back(static_cast<char>((value >> (8 * i)) & 0xFFu));
        };
        const std::uint32_t size = frames * channels * 2;
        std::string file = "RIFF";
        put(file, 36 + size, 4);
        file += "WAVEfmt ";
        put(file, 16, 4);
        put(file, 1, 2);
        put(file, channels, 2);
        put(file, rate, 4);
        put(file, rate * channels * 2, 4);
        put(file, channels * 2u, 2);
        put(file, 16, 2);
        file += "data";
        put(file, size, 4);
        file.append(written * channels * 2, '\0');
        std::ofstream(path, std::ios::binary) << file;
    }

    std::string sentence() const {
        const Result<SoundBank> bank = SoundBank::load(folder_);
        return bank ? std::string() : bank.error().sentence;
    }

    fs::path folder_;
};

// Every name in the table has a file, and every sound can be played: neither silent nor clipped, no DC that a
// voice's start would turn into a click.
TEST(SoundBank, EverySoundOfTheGameIsThereAndClean) {
    std::size_t counted = 0;
    for (std::size_t family = 0; family < kSoundCount; ++family) {
        const auto sound = static_cast<Sound>(family);
        for (std::uint8_t variant = 0; variant < traits(sound).variants; ++variant, ++counted) {
            const SoundId id{sound, variant};
            ASSERT_EQ(flat_index(id), counted);
            const Result<std::vector<float>> samples = read_sound(test::sounds_folder() / file_name(id));
            ASSERT_TRUE(samples) << samples.error().sentence;
            double sum = 0.0, peak = 0.0;
            for (const float x : *samples) {
                sum += static_cast<double>(x);
                peak = std::max(peak, std::abs(static_cast<double>(x)));
            }
            EXPECT_LT(std::abs(sum) / static_cast<double>(samples->size()), 1e-4) << file_name(id);
            EXPECT_LT(peak, 0.999) << file_name(id);
            EXPECT_GT(peak, 0.01) << file_name(id);
        }
    }
    EXPECT_EQ(counted, flat_count());
    // And no file lies there that nobody plays.
    EXPECT_EQ(static_cast<std::size_t>(std::distance(fs::directory_iterator(test::sounds_folder()), {})),
              counted);
}

// The player stands under a lamp for minutes: the end of a loop must meet its beginning in value and in slope.
TEST(SoundBank, LoopsHaveNoSeam) {
    const SoundBank bank = test::load_bank();
    for (const Sound sound : {Sound::LampHum, Sound::RoomTone}) {
        const Recording& recording = bank[{sound, 0}];
        ASSERT_TRUE(recording.loops);
        for (const std::vector<float>& band : recording.bands) {
            const std::size_t n = band.size();
            float largest = 0.0f;
            for (std::size_t i = 2; i < n; ++i) {
                largest = std::max(largest, std::abs(band[i] - 2.0f * band[i - 1] + band[i - 2]));
            }
            EXPECT_LE(std::abs(band[0] - 2.0f * band[n - 1] + band[n - 2]), largest);
            EXPECT_LE(std::abs(band[1] - 2.0f * band[0] + band[n - 1]), largest);
        }
    }
}

TEST_F(BrokenSounds, AMissingFileIsASentenceThatNamesIt) {
    fs::remove(folder_ / "door_open_2.flac");
    EXPECT_NE(sentence().find("door_open_2.flac"), std::string::npos) << sentence();
    EXPECT_NE(sentence().find("no such file"), std::string::npos) << sentence();
}

TEST_F(BrokenSounds, AFileThatIsNoSoundIsASentence) {
    std::ofstream(folder_ / "switch_1.flac", std::ios::trunc) << "not a sound at all";
    EXPECT_NE(sentence().find("switch_1.flac"), std::string::npos) << sentence();
}

TEST_F(BrokenSounds, AFileThatEndsEarlyIsASentence) {
    const fs::path path = folder_ / "lens_taken_1.flac";
    fs::resize_file(path, fs::file_size(path) / 2);
    EXPECT_NE(sentence().find("lens_taken_1.flac"), std::string::npos) << sentence();
}

TEST_F(BrokenSounds, StereoWrongRateEmptyAndOverlongFilesAreSentences) {
    const fs::path path = folder_ / "throw_1.flac";
    const struct {
        std::uint16_t channels;
        std::uint32_t rate, frames;
        const char* reason;
    } cases[] = {{2, 48000, 100, "channels"},
                 {1, 44100, 100, "44100"},
                 {1, 48000, 0, "empty"},
                 {1, 48000, 31 * 48000, "longer"}};
    for (const auto& [channels, rate, frames, reason] : cases) {
        write_wav(path, channels, rate, frames, frames);
        const Result<std::vector<float>> samples = read_sound(path);
        ASSERT_FALSE(samples) << reason;
        EXPECT_NE(samples.error().sentence.find(reason), std::string::npos) << samples.error().sentence;
        EXPECT_NE(samples.error().sentence.find("throw_1.flac"), std::string::npos)
            << samples.error().sentence;
    }
}

// A header may claim gigabytes; only what a sound may have is ever allocated.
TEST_F(BrokenSounds, AHeaderThatClaimsTooMuchIsRefused) {
    const fs::path path = folder_ / "throw_1.flac";
    write_wav(path, 1, 48000, 0x3FFFFFFFu, 10);
    const Result<std::vector<float>> samples = read_sound(path);
    if (samples) {
        EXPECT_LE(samples->size(), 10u) << "the library may believe the file's length instead";
    }
}

// Bits flip on a disk: whatever happens, a sound or a sentence, never a crash.
TEST_F(BrokenSounds, FlippedBitsAreASoundOrASentence) {
    std::ifstream in(folder_ / "switch_2.flac", std::ios::binary);
    const std::string whole((std::istreambuf_iterator<char>(in)), {});
    ::test::Random random(11);
    for (int i = 0; i < 100; ++i) {
        std::string broken = whole;
        for (int k = 0; k < 4; ++k) {
            const auto at = static_cast<std::size_t>(random.unit() * static_cast<float>(broken.size() - 1));
            broken[at] = static_cast<char>(broken[at] ^ (1 << static_cast<int>(random.unit() * 7.99f)));
        }
        const fs::path path = folder_ / "broken.flac";
        std::ofstream(path, std::ios::binary | std::ios::trunc) << broken;
        const Result<std::vector<float>> samples = read_sound(path);
        if (samples) {
            EXPECT_LE(samples->size(), kMaxFrames);
        } else {
            EXPECT_NE(samples.error().sentence.find("broken.flac"), std::string::npos);
        }
    }
}

}  // namespace
}  // namespace gh::audio
