// A recording is evidence: what comes back must be what was played, or be refused.
#include "input/replay.h"

#include "base/file.h"
#include "base/random.h"
#include "input/replay_format.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

namespace gh::input {
namespace {

namespace fs = std::filesystem;

ReplayHeader a_header() {
    return {.simulation_version = 3,
            .layout_hash = 0x1111,
            .level_name = "foyer",
            .level_hash = 0x2222,
            .navmesh_hash = 0x3333,
            .seed = 0x4444,
            .parts = {"player", "guards", "doors"}};
}

// A run as a game would make it: somebody walks and looks about, doors hardly ever change.
Replay a_run(std::size_t ticks, ReplayHeader header = a_header()) {
    Random random(ticks);
    Replay run;
    run.header = std::move(header);
    Command command{.move_forward = 127};
    for (std::size_t tick = 0; tick < ticks; ++tick) {
        command.yaw = static_cast<std::int16_t>(command.yaw + static_cast<int>(random.below(200)) - 100);
        command.buttons = tick % 50 < 10 ? std::uint16_t{Jump} : std::uint16_t{0};
        run.commands.push_back(command);
        run.state_hashes.push_back(mix_bits(tick + 1));
        for (std::size_t part = 0; part < run.header.parts.size(); ++part) {
            run.part_hashes.push_back(mix_bits(part == 2 ? tick / 400 : tick * 3 + part));
        }
    }
    return run;
}

Result<void> append(ReplayWriter& writer, const Replay& run, std::size_t first, std::size_t last) {
    for (std::size_t tick = first; tick < last; ++tick) {
        const auto done = writer.append(run.commands[tick], run.state_hashes[tick], run.parts_at(tick));
        if (!done) return done;
    }
    return {};
}

void expect_prefix(const Replay& got, const Replay& run, std::size_t ticks) {
    ASSERT_EQ(got.ticks(), ticks);
    EXPECT_EQ(got.header, run.header);
    EXPECT_TRUE(std::equal(got.commands.begin(), got.commands.end(), run.commands.begin()));
    EXPECT_TRUE(std::equal(got.state_hashes.begin(), got.state_hashes.end(), run.state_hashes.begin()));
    EXPECT_TRUE(std::equal(got.part_hashes.begin(), got.part_hashes.end(), run.part_hashes.begin()));
}

class ReplayTest : public testing::Test {
  protected:
    void SetUp() override {
        const auto* test = testing::UnitTest::GetInstance()->current_test_info();
        folder_ = fs::temp_directory_path() /
                  (std::string("glasshouse_") + test->name() + std::to_string(::getpid()));
        fs::create_directories(folder_);
    }
    void TearDown() override { fs::remove_all(folder_); }

    fs::path folder_;
};

TEST_F(ReplayTest, WhatWasPlayedIsReadBack) {
    for (const std::size_t ticks : {0u, 1u, 59u, 60u, 61u, 1000u}) {
        const Replay run = a_run(ticks);
        const fs::path path = folder_ / "runs" / "run.replay";
        auto writer = ReplayWriter::create(path, run.header);
        ASSERT_TRUE(writer) << writer.error().sentence;
        ASSERT_TRUE(append(*writer, run, 0, ticks));
        EXPECT_EQ(writer->ticks(), ticks);
        ASSERT_TRUE(writer->finish());
        EXPECT_FALSE(fs::exists(path.string() + ".part"));

        const auto read = read_replay(path);
        ASSERT_TRUE(read) << read.error().sentence;
        EXPECT_FALSE(read->is_cut_short);
        expect_prefix(*read, run, ticks);
    }
}

TEST_F(ReplayTest, RunsWithoutPartsAndWithTheMostArePossible) {
    for (const std::size_t parts : {std::size_t{0}, kMaxReplayParts}) {
        ReplayHeader header = a_header();
        header.parts.assign(parts, std::string(kMaxReplayName, 'p'));
        const Replay run = a_run(130, header);
        auto writer = ReplayWriter::create(folder_ / "run.replay", header);
        ASSERT_TRUE(writer && append(*writer, run, 0, 130) && writer->finish());
        const auto read = read_replay(folder_ / "run.replay");
        ASSERT_TRUE(read);
        expect_prefix(*read, run, 130);
    }
}

TEST_F(ReplayTest, TheFileHasItsOwnNameOnlyWhenFinished) {
    const fs::path path = folder_ / "run.replay";
    const Replay run = a_run(100);
    {
        auto writer = ReplayWriter::create(path, run.header);
        ASSERT_TRUE(writer && append(*writer, run, 0, 100));
        EXPECT_FALSE(fs::exists(path));
    }  // the window was closed: everything up to now is kept
    EXPECT_FALSE(fs::exists(path));
    const auto read = read_replay(path.string() + ".part");
    ASSERT_TRUE(read) << read.error().sentence;
    EXPECT_TRUE(read->is_cut_short);
    expect_prefix(*read, run, 100);
}

TEST_F(ReplayTest, ACrashLosesLessThanASecond) {
    const fs::path path = folder_ / "run.replay";
    const Replay run = a_run(150);
    const pid_t child = ::fork();
    if (child == 0) {  // dies in the middle of its third second, without a destructor
        auto writer = ReplayWriter::create(path, run.header);
        if (writer) (void)append(*writer, run, 0, 150);
        ::_exit(0);
    }
    int status = 0;
    ASSERT_EQ(::waitpid(child, &status, 0), child);
    const auto read = read_replay(path.string() + ".part");
    ASSERT_TRUE(read) << read.error().sentence;
    EXPECT_TRUE(read->is_cut_short);
    expect_prefix(*read, run, 120);
}

TEST_F(ReplayTest, AnHourFitsIntoAFewMegabytes) {
    const std::size_t ticks = 60 * 60;  // a minute stands for it
    const Replay run = a_run(ticks);
    auto writer = ReplayWriter::create(folder_ / "run.replay", run.header);
    ASSERT_TRUE(writer && append(*writer, run, 0, ticks) && writer->finish());
    // Three hashes a tick change and can not be compressed; all else has to fit into as much again.
    EXPECT_LT(fs::file_size(folder_ / "run.replay"), ticks * 2 * 3 * sizeof(std::uint64_t));
}

TEST_F(ReplayTest, AFullDiskIsSaidInASentence) {
    if (!fs::exists("/dev/full")) GTEST_SKIP() << "no /dev/full here";
    fs::create_symlink("/dev/full", folder_ / "run.replay.part");
    const auto writer = ReplayWriter::create(folder_ / "run.replay", a_header());
    ASSERT_FALSE(writer);
    EXPECT_NE(writer.error().sentence.find("run.replay.part': No space left on device"), std::string::npos)
        << writer.error().sentence;
}

TEST_F(ReplayTest, AFolderThatCanNotBeMadeIsSaidInASentence) {
    std::ofstream(folder_ / "file") << "x";
    const auto writer = ReplayWriter::create(folder_ / "file" / "run.replay", a_header());
    ASSERT_FALSE(writer);
    EXPECT_NE(writer.error().sentence.find("run.replay"), std::string::npos);
}

TEST(Replay, NamesTheFirstPartThatDiffers) {
    const Replay run = a_run(5);
    std::vector<std::uint64_t> parts(run.parts_at(3).begin(), run.parts_at(3).end());
    EXPECT_EQ(run.first_difference(3, parts), std::nullopt);
    parts[2] ^= 1;
    EXPECT_EQ(run.first_difference(3, parts), "doors");
    parts[1] ^= 1;
    EXPECT_EQ(run.first_difference(3, parts), "guards");
}

TEST(Replay, IsRefusedWithASentenceWhereItDoesNotFit) {
    const ReplayHeader here = a_header();
    EXPECT_TRUE(check_fits(here, here, "a.replay"));

    const auto sentence = [&](auto&& change) {
        ReplayHeader recorded = here;
        change(recorded);
        const auto fits = check_fits(recorded, here, "a.replay");
        return fits ? std::string() : fits.error().sentence;
    };
    EXPECT_EQ(sentence([](ReplayHeader& h) { h.simulation_version = 2; }),
              "cannot play 'a.replay': it was recorded under simulation version 2, this is version 3");
    EXPECT_NE(sentence([](ReplayHeader& h) { h.layout_hash ^= 1; }).find("another layout"),
              std::string::npos);
    EXPECT_NE(sentence([](ReplayHeader& h) { h.level_name = "crypt"; }).find("'crypt'"), std::string::npos);
    EXPECT_NE(sentence([](ReplayHeader& h) { h.level_hash ^= 1; }).find("0000000000002222"),
              std::string::npos);
    EXPECT_NE(sentence([](ReplayHeader& h) { h.navmesh_hash ^= 1; }).find("navmesh"), std::string::npos);
    EXPECT_EQ(sentence([](ReplayHeader& h) { h.seed ^= 1; }), "") << "the seed is the recording's own";
}

}  // namespace
}  // namespace gh::input
