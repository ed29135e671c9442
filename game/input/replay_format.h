// input/replay_format.h - the bytes of a replay file. Private to replay_*.cpp and their tests.
//
//   file    "GHREPLAY", format version u32, size of the body u32, body, XXH64 of all that u64; chunks; ending
//   body    simulation version u32, layout, level, navmesh hashes and seed u64, level name, count u8, part
//           names
//   chunk   "TICK" u32, first tick u32, ticks u32 (1 to 60), compressed size u32, XXH64 of these and of the
//           payload u64, payload (zstd)
//   payload columns: yaw, pitch, right, forward, buttons, state hashes, then each part's hashes. Hashes of a
//           part are XORed with the tick before (in the chunk): doors that stand still cost nothing.
//   ending  "DONE" u32, ticks u32, XXH64 of both u64. A file without it was cut short.
//
// Numbers are little-endian; strings are a length u32 and bytes. Every field is covered by a hash.
#pragma once

#include "base/bytes.h"
#include "base/result.h"
#include "input/replay.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace gh::input::format {

inline constexpr std::string_view kMagic = "GHREPLAY";
inline constexpr std::uint32_t kVersion = 1;
inline constexpr std::uint32_t kChunkMark = 0x4B434954;   // "TICK"
inline constexpr std::uint32_t kEndingMark = 0x454E4F44;  // "DONE"
inline constexpr std::size_t kTicksPerChunk = 60;
inline constexpr std::size_t kMaxBodySize = 8192;

[[nodiscard]] std::vector<std::byte> header_bytes(const ReplayHeader& header);
[[nodiscard]] Result<ReplayHeader> parse_header(ByteReader& reader, std::string_view name);

// Ticks [first, last) of the replay, at most kTicksPerChunk of them and at least one.
[[nodiscard]] std::vector<std::byte> chunk_bytes(const Replay& replay, std::size_t first, std::size_t last,
                                                 std::uint32_t number_of_first);
[[nodiscard]] std::vector<std::byte> ending_bytes(std::uint32_t ticks);

// What comes next in the file.
enum class Next {
    Chunk,   // its ticks were appended to the replay
    Ending,  // and nothing may follow
    Damage,  // end of file, or bytes that do not add up; the replay is as it was
};
[[nodiscard]] Next parse_next(ByteReader& reader, Replay& replay);

}  // namespace gh::input::format
