#include "app/recording.h"

#include "app/settings.h"
#include "base/hash.h"
#include "sim/version.h"
#include "world/state_hash.h"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <chrono>
#include <ctime>

namespace gh::app {

namespace {

// Hashes of two builds can be compared only when State has the same shape and the same parts are hashed.
std::uint64_t layout_hash() {
    Hasher hasher;
    hasher.add(static_cast<std::uint64_t>(sizeof(world::State)));
    for (std::size_t part = 0; part < world::kHashParts; ++part) {
        const std::string_view name = world::hash_part_name(static_cast<world::HashPart>(part));
        hasher.add(std::as_bytes(std::span(name)));
    }
    return hasher.digest();
}

}  // namespace

input::ReplayHeader recording_header(const std::string& level_name, const world::Level& level,
                                     std::uint32_t seed) {
    input::ReplayHeader header;
    header.simulation_version = sim::kSimulationVersion;
    header.layout_hash = layout_hash();
    header.level_name = level_name;
    header.level_hash = level.file_hash;
    header.navmesh_hash = level.navmesh_hash;
    header.seed = seed;
    for (std::size_t part = 0; part < world::kHashParts; ++part) {
        header.parts.emplace_back(world::hash_part_name(static_cast<world::HashPart>(part)));
    }
    return header;
}

Recorder::Recorder(std::filesystem::path path, input::ReplayWriter writer)
    : path_(std::move(path)), writer_(std::move(writer)) {}

Result<Recorder> Recorder::start(const std::filesystem::path& path, input::ReplayHeader header) {
    std::error_code ignored;
    if (path.has_parent_path()) std::filesystem::create_directories(path.parent_path(), ignored);
    auto writer = input::ReplayWriter::create(path, std::move(header));
    if (!writer) return writer.error();
    return Recorder(path, *std::move(writer));
}

Result<void> Recorder::note_tick(const input::Command& command, const world::State& state) {
    const world::StateHash hash = world::state_hash(state);
    return writer_.append(command, hash.total, hash.part);
}

Result<void> Recorder::finish() {
    return writer_.finish();
}

std::filesystem::path fresh_recording_path(const std::string& level_name) {
    const std::time_t now = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
    const std::string stem = std::filesystem::path(level_name).stem().string();
    const std::string name = fmt::format("{:%Y-%m-%d_%H-%M-%S}_{}", fmt::localtime(now), stem);
    std::filesystem::path path = recordings_path() / (name + ".rec");
    std::error_code ignored;
    for (int i = 2; std::filesystem::exists(path, ignored); ++i)
        path = recordings_path() / fmt::format("{}_{}.rec", name, i);
    return path;
}

}  // namespace gh::app
