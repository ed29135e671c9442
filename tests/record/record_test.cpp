// What is written is read back by the libraries' own readers.
#include "record/picture.h"
#include "record/wav.h"

#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>
#include <sndfile.h>
#include <sys/resource.h>

#include <array>
#include <cmath>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <limits>
#include <string>
#include <vector>

namespace gh {
namespace {

// An empty folder of this test's own, gone afterwards.
class Record : public ::testing::Test {
  protected:
    Record()
        : folder_(std::filesystem::temp_directory_path() /
                  (std::string("glasshouse_record_") +
                   ::testing::UnitTest::GetInstance()->current_test_info()->name())) {
        std::filesystem::remove_all(folder_);
        std::filesystem::create_directories(folder_);
    }
    ~Record() override { std::filesystem::remove_all(folder_); }

    [[nodiscard]] std::vector<std::string> names() const {
        std::vector<std::string> all;
        for (const auto& entry : std::filesystem::directory_iterator(folder_))
            all.push_back(entry.path().filename());
        return all;
    }

    std::filesystem::path folder_;
};

TEST_F(Record, APngHoldsTheBytesItWasGiven) {
    Image8 picture(5, 3);
    for (std::size_t i = 0; i < picture.bytes.size(); ++i)
        picture.bytes[i] = static_cast<std::uint8_t>(i * 37);
    const auto path = folder_ / "deep" / "er" / "picture.png";
    ASSERT_TRUE(record::write_png(path, picture)) << "folders are made";
    const auto in = OIIO::ImageInput::open(path.string());
    ASSERT_NE(in, nullptr);
    EXPECT_EQ(in->spec().width, 5);
    EXPECT_EQ(in->spec().height, 3);
    ASSERT_EQ(in->spec().nchannels, 3);
    std::vector<std::uint8_t> bytes(picture.bytes.size());
    ASSERT_TRUE(in->read_image(0, 0, 0, -1, OIIO::TypeDesc::UINT8, bytes.data()));
    EXPECT_EQ(bytes, picture.bytes);
}

TEST_F(Record, AnExrHoldsEveryBitOfEveryFloat) {
    Image picture(4, 2);
    for (std::size_t i = 0; i < picture.pixels.size(); ++i) {
        picture.pixels[i] = {std::sqrt(static_cast<float>(i)), 1e-20f * static_cast<float>(i),
                             65'000.0f + static_cast<float>(i)};
    }
    const auto path = folder_ / "picture.exr";
    ASSERT_TRUE(record::write_exr(path, picture));
    const auto in = OIIO::ImageInput::open(path.string());
    ASSERT_NE(in, nullptr);
    std::vector<glm::vec3> pixels(picture.pixels.size());
    ASSERT_TRUE(in->read_image(0, 0, 0, -1, OIIO::TypeDesc::FLOAT, pixels.data()));
    EXPECT_EQ(pixels, picture.pixels);
}

// A limit on files' sizes stands for a full disk. A film of broken pictures must not pass for a whole one.
TEST_F(Record, APictureThatDoesNotFitOnTheDiskIsRefusedAndLeavesNothing) {
    Image8 noise(64, 64);
    Image light(64, 64);
    std::uint32_t state = 1;
    for (std::uint8_t& byte : noise.bytes)
        byte = static_cast<std::uint8_t>((state = state * 747796405u + 1u) >> 24);
    for (std::size_t i = 0; i < light.pixels.size(); ++i) light.pixels[i] = glm::vec3(noise.bytes[i]);

    rlimit usual{};
    ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &usual), 0);
    const rlimit small{.rlim_cur = 1000, .rlim_max = usual.rlim_max};
    const auto before =
        std::signal(SIGXFSZ, SIG_IGN);  // then writing too much is an error, as on a full disk
    ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &small), 0);
    const Result<void> png = record::write_png(folder_ / "a.png", noise);
    const Result<void> exr = record::write_exr(folder_ / "a.exr", light);
    ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &usual), 0);
    std::signal(SIGXFSZ, before);

    ASSERT_FALSE(png);
    EXPECT_NE(png.error().sentence.find("a.png"), std::string::npos) << png.error().sentence;
    ASSERT_FALSE(exr);
    EXPECT_NE(exr.error().sentence.find("a.exr"), std::string::npos) << exr.error().sentence;
    EXPECT_TRUE(names().empty());
}

TEST_F(Record, OnlyWholeFilesHaveNames) {
    ASSERT_TRUE(record::write_png(folder_ / "a.png", Image8(2, 2)));
    EXPECT_EQ(names(), std::vector<std::string>{"a.png"});
    {
        auto wav = record::WavWriter::open(folder_ / "b.wav");
        ASSERT_TRUE(wav);
        const std::array<float, 4> samples = {0.1f, 0.2f, 0.3f, 0.4f};
        ASSERT_TRUE(wav->write(samples));
        EXPECT_FALSE(std::filesystem::exists(folder_ / "b.wav"));
    }
    EXPECT_EQ(names(), std::vector<std::string>{"a.png"}) << "a recording that was not closed leaves nothing";
}

TEST_F(Record, WhatCanNotBeWrittenIsOneSentenceThatNamesTheFile) {
    std::ofstream(folder_ / "file") << "in the way";
    for (const auto& path : {folder_ / "file" / "x.png", folder_}) {
        const Result<void> result = record::write_png(path, Image8(2, 2));
        ASSERT_FALSE(result);
        EXPECT_NE(result.error().sentence.find(path.string()), std::string::npos) << result.error().sentence;
    }
    EXPECT_FALSE(record::write_png(folder_ / "empty.png", Image8{}));
    EXPECT_FALSE(record::WavWriter::open(folder_ / "file" / "x.wav"));
    EXPECT_EQ(names(), std::vector<std::string>{"file"});
}

TEST_F(Record, AWavHoldsTheSoundInEitherDepth) {
    std::vector<float> sound;
    for (int i = 0; i < 960; ++i) {
        sound.push_back(0.5f * std::sin(static_cast<float>(i) * 0.05f));
        sound.push_back(0.25f * std::cos(static_cast<float>(i) * 0.03f));
    }
    for (const auto& [depth, step] :
         {std::pair(record::WavDepth::Bits16, 1.0f / 32'768), {record::WavDepth::Bits24, 1.0f / 8'388'608}}) {
        auto wav = record::WavWriter::open(folder_ / "sound.wav", depth);
        ASSERT_TRUE(wav);
        ASSERT_TRUE(wav->write(std::span(sound).first(960)));
        ASSERT_TRUE(wav->write(std::span(sound).subspan(960)));
        EXPECT_EQ(wav->frames_written(), 960u);
        ASSERT_TRUE(wav->close());
        SF_INFO info{};
        SNDFILE* in = sf_open((folder_ / "sound.wav").c_str(), SFM_READ, &info);
        ASSERT_NE(in, nullptr);
        EXPECT_EQ(info.samplerate, 48'000);
        EXPECT_EQ(info.channels, 2);
        std::vector<float> back(sound.size());
        EXPECT_EQ(sf_readf_float(in, back.data(), 960), 960);
        sf_close(in);
        for (std::size_t i = 0; i < sound.size(); ++i) ASSERT_NEAR(back[i], sound[i], 1.01f * step);
    }
}

TEST_F(Record, LoudSoundIsClippedAndNanIsSilence) {
    auto wav = record::WavWriter::open(folder_ / "loud.wav");
    ASSERT_TRUE(wav);
    const std::array<float, 4> samples = {7.0f, -7.0f, std::numeric_limits<float>::quiet_NaN(), 0.0f};
    ASSERT_TRUE(wav->write(samples));
    ASSERT_TRUE(wav->close());
    SF_INFO info{};
    SNDFILE* in = sf_open((folder_ / "loud.wav").c_str(), SFM_READ, &info);
    ASSERT_NE(in, nullptr);
    std::array<float, 4> back{};
    EXPECT_EQ(sf_readf_float(in, back.data(), 2), 2);
    sf_close(in);
    EXPECT_NEAR(back[0], 1.0f, 1e-4f);
    EXPECT_NEAR(back[1], -1.0f, 1e-4f);
    EXPECT_EQ(back[2], 0.0f);
}

}  // namespace
}  // namespace gh
