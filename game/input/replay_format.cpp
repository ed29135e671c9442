#include "input/replay_format.h"

#include "base/contracts.h"
#include "base/hash.h"

#include <fmt/format.h>
#include <zstd.h>

#include <algorithm>
#include <array>

namespace gh::input::format {

namespace {

constexpr int kCompressionLevel = 3;

std::size_t payload_size(std::size_t ticks, std::size_t parts) {
    return ticks * (sizeof(Command) + sizeof(std::uint64_t) * (1 + parts));
}

std::uint64_t chunk_hash(std::uint32_t first, std::uint32_t ticks, std::span<const std::byte> payload) {
    Hasher hasher;
    hasher.add(kChunkMark);
    hasher.add(first);
    hasher.add(ticks);
    hasher.add(static_cast<std::uint32_t>(payload.size()));
    hasher.add(payload);
    return hasher.digest();
}

std::uint64_t ending_hash(std::uint32_t ticks) {
    Hasher hasher;
    hasher.add(kEndingMark);
    hasher.add(ticks);
    return hasher.digest();
}

std::vector<std::byte> compressed(std::span<const std::byte> plain) {
    std::vector<std::byte> out(ZSTD_compressBound(plain.size()));
    const std::size_t size =
        ZSTD_compress(out.data(), out.size(), plain.data(), plain.size(), kCompressionLevel);
    ENSURES(!ZSTD_isError(size));  // the bound leaves no way to fail but memory
    out.resize(ZSTD_isError(size) ? 0 : size);
    return out;
}

// Fills `plain` exactly, or fails. The only memory taken is zstd's own decoder state, whatever the frame
// claims.
bool decompress_exactly(std::span<const std::byte> packed, std::span<std::byte> plain) {
    return ZSTD_decompress(plain.data(), plain.size(), packed.data(), packed.size()) == plain.size();
}

void write_columns(const Replay& replay, std::size_t first, std::size_t last, ByteWriter& out) {
    const std::span<const Command> commands(replay.commands.data() + first, last - first);
    for (const Command& c : commands) out.write(c.yaw);
    for (const Command& c : commands) out.write(c.pitch);
    for (const Command& c : commands) out.write(c.move_right);
    for (const Command& c : commands) out.write(c.move_forward);
    for (const Command& c : commands) out.write(c.buttons);
    for (std::size_t tick = first; tick < last; ++tick) out.write(replay.state_hashes[tick]);
    for (std::size_t part = 0; part < replay.header.parts.size(); ++part) {
        std::uint64_t before = 0;
        for (std::size_t tick = first; tick < last; ++tick) {
            const std::uint64_t hash = replay.parts_at(tick)[part];
            out.write(hash ^ before);
            before = hash;
        }
    }
}

// A second of a recording, taken apart.
struct Ticks {
    std::array<Command, kTicksPerChunk> commands;
    std::array<std::uint64_t, kTicksPerChunk> state_hashes;
    std::array<std::uint64_t, kTicksPerChunk * kMaxReplayParts> part_hashes;
};

// `plain` has payload_size(count, parts) bytes. False when a command is out of its range.
bool read_columns(std::span<const std::byte> plain, std::size_t count, std::size_t parts, Ticks& out) {
    ByteReader in(plain);
    const std::span<Command> commands(out.commands.data(), count);
    for (Command& c : commands) in.read(c.yaw);
    for (Command& c : commands) in.read(c.pitch);
    for (Command& c : commands) in.read(c.move_right);
    for (Command& c : commands) in.read(c.move_forward);
    for (Command& c : commands) in.read(c.buttons);
    for (std::size_t i = 0; i < count; ++i) in.read(out.state_hashes[i]);
    for (std::size_t part = 0; part < parts; ++part) {
        std::uint64_t before = 0;
        for (std::size_t i = 0; i < count; ++i) {
            std::uint64_t difference = 0;
            in.read(difference);
            before ^= difference;
            out.part_hashes[i * parts + part] = before;
        }
    }
    ENSURES(!in.has_failed() && in.left() == 0);
    for (const Command& c : commands) {
        if (!is_valid(c)) return false;
    }
    return true;
}

bool parse_chunk(ByteReader& reader, Replay& replay) {
    std::uint32_t first = 0, count = 0, packed_size = 0;
    std::uint64_t hash = 0;
    std::span<const std::byte> packed;
    if (!reader.read(first) || !reader.read(count) || !reader.read(packed_size) || !reader.read(hash))
        return false;
    if (first != replay.ticks() || count < 1 || count > kTicksPerChunk) return false;
    if (replay.ticks() + count > kMaxReplayTicks) return false;
    if (!reader.read_bytes(packed_size, packed) || chunk_hash(first, count, packed) != hash) return false;

    const std::size_t parts = replay.header.parts.size();
    std::array<std::byte, (sizeof(Command) + 8 * (1 + kMaxReplayParts)) * kTicksPerChunk> buffer;
    const std::span<std::byte> plain(buffer.data(), payload_size(count, parts));
    Ticks ticks;
    if (!decompress_exactly(packed, plain) || !read_columns(plain, count, parts, ticks)) return false;

    const auto append = [](auto& column, const auto& source, std::size_t n) {
        column.insert(column.end(), source.begin(), source.begin() + static_cast<std::ptrdiff_t>(n));
    };
    append(replay.commands, ticks.commands, count);
    append(replay.state_hashes, ticks.state_hashes, count);
    append(replay.part_hashes, ticks.part_hashes, count * parts);
    return true;
}

bool parse_ending(ByteReader& reader, const Replay& replay) {
    std::uint32_t ticks = 0;
    std::uint64_t hash = 0;
    return reader.read(ticks) && reader.read(hash) && hash == ending_hash(ticks) && ticks == replay.ticks() &&
           reader.left() == 0;
}

bool parse_body(ByteReader body, ReplayHeader& header) {
    std::uint8_t parts = 0;
    body.read(header.simulation_version);
    body.read(header.layout_hash);
    body.read(header.level_hash);
    body.read(header.navmesh_hash);
    body.read(header.seed);
    body.read_string(header.level_name, kMaxReplayName);
    if (!body.read(parts) || parts > kMaxReplayParts) return false;
    header.parts.resize(parts);
    for (std::string& part : header.parts) body.read_string(part, kMaxReplayName);
    return !body.has_failed() && body.left() == 0;
}

}  // namespace

std::vector<std::byte> header_bytes(const ReplayHeader& header) {
    ByteWriter body;
    body.write(header.simulation_version);
    body.write(header.layout_hash);
    body.write(header.level_hash);
    body.write(header.navmesh_hash);
    body.write(header.seed);
    body.write_string(header.level_name);
    body.write(static_cast<std::uint8_t>(header.parts.size()));
    for (const std::string& part : header.parts) body.write_string(part);

    ByteWriter out;
    out.write_bytes(std::as_bytes(std::span(kMagic)));
    out.write(kVersion);
    out.write(static_cast<std::uint32_t>(body.size()));
    out.write_bytes(body.bytes());
    out.write(hash_bytes(out.bytes()));
    return out.bytes();
}

Result<ReplayHeader> parse_header(ByteReader& reader, std::string_view name) {
    ByteReader start = reader;
    std::span<const std::byte> magic, covered, body;
    const bool is_ours = start.read_bytes(kMagic.size(), magic) &&
                         std::equal(magic.begin(), magic.end(), std::as_bytes(std::span(kMagic)).begin());
    if (!is_ours) return Error{fmt::format("cannot play '{}': it is not a replay", name)};

    std::uint32_t version = 0, body_size = 0;
    std::uint64_t hash = 0;
    if (start.read(version) && version != kVersion) {
        return Error{fmt::format("cannot play '{}': its format is version {}, this program reads version {}",
                                 name, version, kVersion)};
    }
    ReplayHeader header;
    const bool is_whole =
        start.read(body_size) && body_size <= kMaxBodySize && start.read_bytes(body_size, body) &&
        reader.read_bytes(start.position() - reader.position(), covered) && reader.read(hash) &&
        hash == hash_bytes(covered) && parse_body(ByteReader(body), header);
    if (!is_whole) return Error{fmt::format("cannot play '{}': its header is damaged or cut short", name)};
    return header;
}

std::vector<std::byte> chunk_bytes(const Replay& replay, std::size_t first, std::size_t last,
                                   std::uint32_t number_of_first) {
    EXPECTS(first < last && last - first <= kTicksPerChunk);
    ByteWriter plain;
    write_columns(replay, first, last, plain);
    const std::vector<std::byte> packed = compressed(plain.bytes());

    const auto count = static_cast<std::uint32_t>(last - first);
    ByteWriter out;
    out.write(kChunkMark);
    out.write(number_of_first);
    out.write(count);
    out.write(static_cast<std::uint32_t>(packed.size()));
    out.write(chunk_hash(number_of_first, count, packed));
    out.write_bytes(packed);
    return out.bytes();
}

std::vector<std::byte> ending_bytes(std::uint32_t ticks) {
    ByteWriter out;
    out.write(kEndingMark);
    out.write(ticks);
    out.write(ending_hash(ticks));
    return out.bytes();
}

Next parse_next(ByteReader& reader, Replay& replay) {
    std::uint32_t mark = 0;
    if (!reader.read(mark)) return Next::Damage;
    if (mark == kChunkMark && parse_chunk(reader, replay)) return Next::Chunk;
    if (mark == kEndingMark && parse_ending(reader, replay)) return Next::Ending;
    return Next::Damage;
}

}  // namespace gh::input::format
