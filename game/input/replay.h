// input/replay.h - a run as a file: one Command a tick, and hashes that prove a replay went the same way.
//
// Writing   a second of ticks at a time, flushed at once, to FILE.part; finish() gives the file its own name.
//           After a crash FILE.part holds all but the last second and is read like any other.
// Cost      append: a copy; once a second about 0.1 ms to compress. About 100 kB a minute, nearly all of it
//           hashes.
// Threads   a writer belongs to one thread; a Replay that was read is plain data.
// Bad input any bytes at all: an Error with one sentence, or the ticks before the first damage with
//           is_cut_short set. Memory is bounded by the file's size and by kMaxReplayTicks. replay_format.h
//           describes the bytes.
#pragma once

#include "base/result.h"
#include "input/command.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace gh::input {

inline constexpr std::size_t kMaxReplayParts = 16;
inline constexpr std::size_t kMaxReplayTicks = 60u * 60u * 60u * 6u;  // six hours
inline constexpr std::size_t kMaxReplayBytes = std::size_t{512} << 20;
inline constexpr std::size_t kMaxReplayName = 255;  // bytes of a level's or a part's name

// What a run depends on besides its commands. All of it must fit before a replay means anything.
struct ReplayHeader {
    std::uint32_t simulation_version = 0;  // raised whenever behaviour changes
    std::uint64_t layout_hash = 0;         // of State's fields, so that hashes are comparable
    std::string level_name;
    std::uint64_t level_hash = 0;
    std::uint64_t navmesh_hash = 0;
    std::uint64_t seed = 0;
    std::vector<std::string> parts;  // names of the partial hashes: "player", "guards", "doors", ...

    bool operator==(const ReplayHeader&) const = default;
};

// Column by column: entry i belongs to tick i.
struct Replay {
    ReplayHeader header;
    std::vector<Command> commands;
    std::vector<std::uint64_t> state_hashes;
    std::vector<std::uint64_t> part_hashes;  // ticks() * header.parts.size()
    bool is_cut_short = false;  // the file ends early or is damaged; what is here is whole and true

    [[nodiscard]] std::size_t ticks() const { return commands.size(); }
    [[nodiscard]] std::span<const std::uint64_t> parts_at(std::size_t tick) const;
    // The first part that differs from what was recorded for `tick`; none when all agree.
    [[nodiscard]] std::optional<std::string_view> first_difference(
        std::size_t tick, std::span<const std::uint64_t> parts) const;
};

[[nodiscard]] Result<Replay> read_replay(const std::filesystem::path& path);
// The same from memory; `name` stands in sentences.
[[nodiscard]] Result<Replay> parse_replay(std::span<const std::byte> bytes, std::string_view name);

// Whether a run recorded under `recorded` can be repeated where `here` holds; the sentence says what differs.
// The seed is the recording's own and is not compared, nor are the parts' names.
[[nodiscard]] Result<void> check_fits(const ReplayHeader& recorded, const ReplayHeader& here,
                                      std::string_view name);

class ReplayWriter {
  public:
    // Starts FILE.part. Names longer than kMaxReplayName and more parts than kMaxReplayParts break the
    // contract.
    [[nodiscard]] static Result<ReplayWriter> create(const std::filesystem::path& path, ReplayHeader header);

    ReplayWriter(ReplayWriter&&) noexcept;
    ReplayWriter& operator=(ReplayWriter&&) noexcept;
    ~ReplayWriter();  // without finish(): flushes and leaves FILE.part

    // One tick; `parts` has one hash for each of the header's names. Every sixtieth call writes to the disk.
    Result<void> append(const Command& command, std::uint64_t state_hash,
                        std::span<const std::uint64_t> parts);
    // Brings what was appended so far to the disk.
    Result<void> flush();
    // Flushes, waits for the disk, marks the recording as complete and gives it its own name. Nothing may be
    // appended afterwards.
    Result<void> finish();

    [[nodiscard]] std::size_t ticks() const;

  private:
    struct Open;
    explicit ReplayWriter(std::unique_ptr<Open> open);
    std::unique_ptr<Open> open_;
};

}  // namespace gh::input
