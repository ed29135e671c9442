// The file beside a level: magic, version, the ground's hash, the tile's hash, the tile.
#include "base/bytes.h"
#include "base/file.h"
#include "base/hash.h"
#include "load/level_loader.h"
#include "load/navmesh.h"

#include <fmt/format.h>

namespace gh::load {
namespace {

constexpr std::uint32_t kNavmeshMagic = 0x564E4847u;  // "GHNV"
constexpr std::uint32_t kVersion = 1;                 // raise it when bake_navmesh would make another tile
constexpr std::size_t kMostBytes = std::size_t{256} << 20;

}  // namespace

std::filesystem::path navmesh_path(const std::filesystem::path& level_path) {
    return std::filesystem::path(level_path).replace_extension(".navmesh");
}

std::optional<std::vector<std::byte>> read_navmesh_file(const std::filesystem::path& path,
                                                        const Ground& ground) {
    const Result<std::vector<std::byte>> bytes = read_file(path, kMostBytes);
    if (!bytes) return std::nullopt;
    ByteReader reader(*bytes);
    std::uint32_t magic = 0, version = 0;
    std::uint64_t ground_hash = 0, tile_hash = 0;
    reader.read(magic);
    reader.read(version);
    reader.read(ground_hash);
    reader.read(tile_hash);
    std::span<const std::byte> tile;
    if (!reader.read_bytes(reader.left(), tile) || magic != kNavmeshMagic || version != kVersion)
        return std::nullopt;
    if (tile_hash != hash_bytes(tile) || ground_hash != ground.hash()) return std::nullopt;
    return std::vector<std::byte>(tile.begin(), tile.end());
}

Result<void> bake_navmesh_file(const std::filesystem::path& level_path) {
    const Result<world::Level> level = load_level(level_path, {.finds_ways = false});
    if (!level) return level.error();
    const auto refuse = [&](const Error& error) {
        return Error{fmt::format("{}: {}", level_path.filename().string(), error.sentence)};
    };
    const Result<Ground> ground = collect_ground(*level);
    if (!ground) return refuse(ground.error());
    const Result<std::vector<std::byte>> tile = bake_navmesh(*ground);
    if (!tile) return refuse(tile.error());
    if (tile->empty()) return refuse(Error{"there is nothing to walk on"});
    ByteWriter writer;
    writer.write(kNavmeshMagic);
    writer.write(kVersion);
    writer.write(ground->hash());
    writer.write(hash_bytes(*tile));
    writer.write_bytes(*tile);
    return write_file_atomically(navmesh_path(level_path), writer.bytes());
}

}  // namespace gh::load
