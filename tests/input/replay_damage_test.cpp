// Replays come from strangers: whatever the bytes, a sentence or a true beginning of the run, never a crash
// and never more memory than the file could honestly fill.
#include "base/hash.h"
#include "base/random.h"
#include "input/replay.h"
#include "input/replay_format.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace gh::input {
namespace {

constexpr std::size_t kTicks = 150;  // two whole chunks and a half

struct Recording {
    Replay run;
    std::vector<std::byte> bytes;
    std::vector<std::size_t> chunk_ends;  // bytes up to the end of the header, of each chunk
};

void append(std::vector<std::byte>& bytes, const std::vector<std::byte>& more) {
    bytes.insert(bytes.end(), more.begin(), more.end());
}

Recording a_recording() {
    Recording r;
    r.run.header = {.simulation_version = 1, .level_name = "foyer", .seed = 9, .parts = {"player", "doors"}};
    for (std::size_t tick = 0; tick < kTicks; ++tick) {
        r.run.commands.push_back({.yaw = static_cast<std::int16_t>(tick * 91), .move_forward = 100});
        r.run.state_hashes.push_back(mix_bits(tick));
        r.run.part_hashes.push_back(mix_bits(tick + 1000));
        r.run.part_hashes.push_back(77);
    }
    r.bytes = format::header_bytes(r.run.header);
    r.chunk_ends.push_back(r.bytes.size());
    for (std::size_t first = 0; first < kTicks; first += format::kTicksPerChunk) {
        const std::size_t last = std::min(first + format::kTicksPerChunk, kTicks);
        append(r.bytes, format::chunk_bytes(r.run, first, last, static_cast<std::uint32_t>(first)));
        r.chunk_ends.push_back(r.bytes.size());
    }
    append(r.bytes, format::ending_bytes(kTicks));
    return r;
}

bool is_beginning_of(const Replay& got, const Replay& run) {
    const auto starts = [](const auto& shorter, const auto& longer) {
        return shorter.size() <= longer.size() && std::equal(shorter.begin(), shorter.end(), longer.begin());
    };
    return got.header == run.header && starts(got.commands, run.commands) &&
           starts(got.state_hashes, run.state_hashes) && starts(got.part_hashes, run.part_hashes) &&
           got.state_hashes.size() == got.ticks() &&
           got.part_hashes.size() == got.ticks() * run.header.parts.size();
}

TEST(ReplayDamage, AFileCutAnywherePlaysToItsLastWholeChunk) {
    const Recording r = a_recording();
    for (std::size_t size = 0; size < r.bytes.size(); ++size) {
        const auto read = parse_replay(std::span(r.bytes).first(size), "cut");
        if (size < r.chunk_ends[0]) {
            ASSERT_FALSE(read) << "a header of " << size << " bytes";
            ASSERT_EQ(read.error().sentence.substr(0, 18), "cannot play 'cut':");
            continue;
        }
        const auto whole =
            std::upper_bound(r.chunk_ends.begin(), r.chunk_ends.end(), size) - r.chunk_ends.begin() - 1;
        ASSERT_TRUE(read) << read.error().sentence;
        ASSERT_TRUE(read->is_cut_short) << size;
        ASSERT_EQ(read->ticks(), std::min(static_cast<std::size_t>(whole) * format::kTicksPerChunk, kTicks))
            << size;
        ASSERT_TRUE(is_beginning_of(*read, r.run)) << size;
    }
    const auto whole = parse_replay(r.bytes, "whole");
    ASSERT_TRUE(whole);
    EXPECT_FALSE(whole->is_cut_short);
    EXPECT_EQ(whole->ticks(), kTicks);
}

TEST(ReplayDamage, AFlippedBitIsAnErrorOrEndsTheRunBeforeIt) {
    const Recording r = a_recording();
    Random random(1);
    for (int i = 0; i < 10'000; ++i) {
        std::vector<std::byte> bytes = r.bytes;
        const std::size_t at = random.below(static_cast<std::uint32_t>(bytes.size()));
        bytes[at] ^= static_cast<std::byte>(1u << random.below(8));
        const auto read = parse_replay(bytes, "flipped");
        ASSERT_EQ(read.has_value(), at >= r.chunk_ends[0]) << "byte " << at;
        if (!read) continue;
        ASSERT_TRUE(read->is_cut_short) << "byte " << at;
        ASSERT_TRUE(is_beginning_of(*read, r.run)) << "byte " << at;
        const auto whole =
            std::upper_bound(r.chunk_ends.begin(), r.chunk_ends.end(), at) - r.chunk_ends.begin() - 1;
        ASSERT_EQ(read->ticks(), std::min(static_cast<std::size_t>(whole) * format::kTicksPerChunk, kTicks));
    }
}

// Damage that hashes catch never reaches what is behind them; an attacker computes the hash too.
TEST(ReplayDamage, FlippedBitsUnderARepairedHashAreHarmless) {
    const Recording r = a_recording();
    const std::size_t start = r.chunk_ends[0];
    const std::size_t size = r.chunk_ends[1] - start;
    constexpr std::size_t kHashAt = 16, kPayloadAt = 24;
    Random random(2);
    int survived = 0;
    for (int i = 0; i < 10'000; ++i) {
        std::vector<std::byte> bytes = r.bytes;
        for (std::uint32_t flips = 1 + random.below(3); flips > 0; --flips) {
            const std::size_t at = kPayloadAt + random.below(static_cast<std::uint32_t>(size - kPayloadAt));
            bytes[start + at] ^= static_cast<std::byte>(1u << random.below(8));
        }
        Hasher hasher;
        hasher.add(std::span(bytes).subspan(start, kHashAt));
        hasher.add(std::span(bytes).subspan(start + kPayloadAt, size - kPayloadAt));
        ByteWriter hash;
        hash.write(hasher.digest());
        std::copy(hash.bytes().begin(), hash.bytes().end(),
                  bytes.begin() + static_cast<std::ptrdiff_t>(start + kHashAt));

        const auto read = parse_replay(bytes, "forged");
        ASSERT_TRUE(read);
        ASSERT_LE(read->ticks(), kTicks);
        ASSERT_TRUE(std::all_of(read->commands.begin(), read->commands.end(), is_valid));
        survived += read->ticks() > 0;
    }
    EXPECT_GT(survived, 100) << "the repaired hash is not the one that is checked";
}

TEST(ReplayDamage, AnotherFormatVersionIsRefusedByNumber) {
    Recording r = a_recording();
    r.bytes[format::kMagic.size()] = std::byte{9};
    const auto read = parse_replay(r.bytes, "new.replay");
    ASSERT_FALSE(read);
    EXPECT_EQ(read.error().sentence,
              "cannot play 'new.replay': its format is version 9, this program reads version 1");
}

TEST(ReplayDamage, APictureIsNotAReplay) {
    const std::string png = "\x89PNG\r\n\x1a\n and so on and so on";
    const auto read = parse_replay(std::as_bytes(std::span(png)), "a.png");
    ASSERT_FALSE(read);
    EXPECT_EQ(read.error().sentence, "cannot play 'a.png': it is not a replay");
}

// Chunks in another order, or one left out, would replay as a jump.
TEST(ReplayDamage, AMissingOrRepeatedSecondEndsTheRun) {
    const Recording r = a_recording();
    const auto piece = [&](std::size_t i) {
        return std::vector<std::byte>(r.bytes.begin() + static_cast<std::ptrdiff_t>(r.chunk_ends[i]),
                                      r.bytes.begin() + static_cast<std::ptrdiff_t>(r.chunk_ends[i + 1]));
    };
    const std::vector<std::byte> header = format::header_bytes(r.run.header);
    std::vector<std::byte> gap = header, twice = header, early = header;
    append(gap, piece(0)), append(gap, piece(2));
    append(twice, piece(0)), append(twice, piece(0));
    append(early, piece(0)), append(early, format::ending_bytes(kTicks));
    for (const auto& bytes : {gap, twice, early}) {
        const auto read = parse_replay(bytes, "odd");
        ASSERT_TRUE(read);
        EXPECT_EQ(read->ticks(), format::kTicksPerChunk);
        EXPECT_TRUE(read->is_cut_short);
    }
    std::vector<std::byte> longer = r.bytes;
    longer.push_back(std::byte{0});
    const auto read = parse_replay(longer, "longer");
    ASSERT_TRUE(read);
    EXPECT_TRUE(read->is_cut_short) << "something follows the ending";
}

}  // namespace
}  // namespace gh::input
