#include "base/file.h"
#include "base/hash.h"
#include "input/replay.h"
#include "input/replay_format.h"

#include <fmt/format.h>

#include <algorithm>

namespace gh::input {

std::span<const std::uint64_t> Replay::parts_at(std::size_t tick) const {
    EXPECTS(tick < ticks());
    const std::size_t parts = header.parts.size();
    return std::span(part_hashes).subspan(tick * parts, parts);
}

std::optional<std::string_view> Replay::first_difference(std::size_t tick,
                                                         std::span<const std::uint64_t> parts) const {
    const std::span<const std::uint64_t> recorded = parts_at(tick);
    EXPECTS(parts.size() == recorded.size());
    for (std::size_t i = 0; i < std::min(parts.size(), recorded.size()); ++i) {
        if (parts[i] != recorded[i]) return header.parts[i];
    }
    return std::nullopt;
}

Result<Replay> read_replay(const std::filesystem::path& path) {
    const Result<std::vector<std::byte>> bytes = read_file(path, kMaxReplayBytes);
    if (!bytes) return bytes.error();
    return parse_replay(*bytes, path.string());
}

Result<Replay> parse_replay(std::span<const std::byte> bytes, std::string_view name) {
    ByteReader reader(bytes);
    Result<ReplayHeader> header = format::parse_header(reader, name);
    if (!header) return header.error();

    Replay replay;
    replay.header = *std::move(header);
    format::Next next = format::Next::Chunk;
    while (next == format::Next::Chunk) next = format::parse_next(reader, replay);
    replay.is_cut_short = next == format::Next::Damage;
    return replay;
}

Result<void> check_fits(const ReplayHeader& recorded, const ReplayHeader& here, std::string_view name) {
    if (recorded.simulation_version != here.simulation_version) {
        return Error{
            fmt::format("cannot play '{}': it was recorded under simulation version {}, this is version {}",
                        name, recorded.simulation_version, here.simulation_version)};
    }
    if (recorded.layout_hash != here.layout_hash) {
        return Error{
            fmt::format("cannot play '{}': its hashes cover another layout of the state ({}, here {})", name,
                        hex16(recorded.layout_hash), hex16(here.layout_hash))};
    }
    if (recorded.level_name != here.level_name) {
        return Error{fmt::format("cannot play '{}': it was recorded in level '{}', not in '{}'", name,
                                 recorded.level_name, here.level_name)};
    }
    if (recorded.level_hash != here.level_hash) {
        return Error{
            fmt::format("cannot play '{}': level '{}' has changed since it was recorded ({}, now {})", name,
                        here.level_name, hex16(recorded.level_hash), hex16(here.level_hash))};
    }
    if (recorded.navmesh_hash != here.navmesh_hash) {
        return Error{fmt::format(
            "cannot play '{}': the navmesh of level '{}' has changed since it was recorded ({}, now {})",
            name, here.level_name, hex16(recorded.navmesh_hash), hex16(here.navmesh_hash))};
    }
    return {};
}

}  // namespace gh::input
