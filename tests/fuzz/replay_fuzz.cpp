// libFuzzer target: any bytes at all as a replay file, as the body of its header and as a second of ticks,
// because hardly any mutation gets past the hashes by itself.
//
//   cmake -DGLASSHOUSE_FUZZ=ON -DCMAKE_CXX_COMPILER=clang++ ...; bin/replay_fuzz -max_total_time=60
#include "base/bytes.h"
#include "base/hash.h"
#include "input/replay.h"
#include "input/replay_format.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace {

using gh::input::format::kChunkMark;

void require(bool holds) {
    if (!holds) __builtin_trap();
}

void parse(std::span<const std::byte> bytes) {
    const auto replay = gh::input::parse_replay(bytes, "fuzz");
    if (!replay) {
        require(!replay.error().sentence.empty());
        return;
    }
    require(replay->state_hashes.size() == replay->ticks());
    require(replay->part_hashes.size() == replay->ticks() * replay->header.parts.size());
    for (const gh::input::Command& command : replay->commands) require(gh::input::is_valid(command));
}

// The input as the payload of one chunk whose hash is right.
std::vector<std::byte> as_chunk(std::span<const std::byte> payload, std::uint32_t ticks) {
    gh::ByteWriter head;
    head.write(kChunkMark);
    head.write(std::uint32_t{0});
    head.write(ticks);
    head.write(static_cast<std::uint32_t>(payload.size()));
    gh::Hasher hasher;
    hasher.add(std::span<const std::byte>(head.bytes()));
    hasher.add(payload);

    gh::ByteWriter file;
    file.write_bytes(gh::input::format::header_bytes({.level_name = "fuzz", .parts = {"player"}}));
    file.write_bytes(head.bytes());
    file.write(hasher.digest());
    file.write_bytes(payload);
    return file.bytes();
}

// The input as the body of a header whose size and hash are right.
std::vector<std::byte> as_header(std::span<const std::byte> body) {
    gh::ByteWriter file;
    file.write_bytes(std::as_bytes(std::span(gh::input::format::kMagic)));
    file.write(gh::input::format::kVersion);
    file.write(static_cast<std::uint32_t>(body.size()));
    file.write_bytes(body);
    file.write(gh::hash_bytes(file.bytes()));
    return file.bytes();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::span<const std::byte> bytes = std::as_bytes(std::span(data, size));
    parse(bytes);
    parse(as_header(bytes));
    if (size > 0) parse(as_chunk(bytes.subspan(1), data[0]));
    return 0;
}
