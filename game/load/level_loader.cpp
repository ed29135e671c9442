#include "load/level_loader.h"

#include "base/file.h"
#include "base/hash.h"
#include "load/defaults.h"
#include "load/fuse_parts.h"
#include "load/gltf_file.h"
#include "load/level_build.h"
#include "load/level_check.h"
#include "load/limits.h"
#include "load/navmesh.h"
#include "load/part_geometry.h"
#include "world/clear_parts.h"

#include <fmt/format.h>

#include <exception>
#include <optional>

namespace gh::load {
namespace {

// Side files that hold geometry belong to what was loaded; pictures do not decide anything.
std::uint64_t hash_of(std::span<const std::byte> bytes, const tinygltf::Model& model) {
    Hasher hasher;
    hasher.add(bytes);
    for (const tinygltf::Buffer& buffer : model.buffers) {
        if (!buffer.uri.empty()) hasher.add(std::as_bytes(std::span(buffer.data)));
    }
    return hasher.digest();
}

// Exact where that is affordable; a file of a few kilobytes can put one large mesh in a great many places, and
// then the corners of its box have to do.
world::Aabb bounds_of_parts(const LevelBuild& build) {
    std::size_t budget = 4 * kMaxVertices;
    std::vector<std::optional<world::Aabb>> mesh_box(build.meshes.size());
    world::Aabb box = empty_box();
    for (const world::Part& part : build.level.parts) {
        if (part.mover == world::Mover::Stone || part.mover == world::Mover::Guard) continue;
        const glm::mat4x3 world_from_part = world_from_part_at_rest(build.level, part);
        const std::vector<glm::vec3>& positions = build.meshes.mesh(part.mesh).positions;
        if (positions.size() <= budget) {
            budget -= positions.size();
            for (const glm::vec3& p : positions) grow(box, transform_point(world_from_part, p));
            continue;
        }
        std::optional<world::Aabb>& local = mesh_box[part.mesh];
        if (!local) local = bounds_of(positions);
        for (unsigned corner = 0; corner < 8; ++corner) {
            const glm::vec3 p((corner & 1u) != 0 ? local->max.x : local->min.x,
                              (corner & 2u) != 0 ? local->max.y : local->min.y,
                              (corner & 4u) != 0 ? local->max.z : local->min.z);
            grow(box, transform_point(world_from_part, p));
        }
    }
    return box;
}

bool has_spawn(const LevelBuild& build) {
    for (const std::uint32_t id : build.tree.order) {
        if (build.facts[id].kind == Kind::Spawn) return true;
    }
    return false;
}

Result<world::Level> build_level(const tinygltf::Model& model, const LoadOptions& options) {
    TextureSet textures(model);
    Result<MaterialSet> materials = read_materials(model, textures);
    if (!materials) return materials.error();
    Result<NodeTree> tree = read_nodes(model);
    if (!tree) return tree.error();
    LevelBuild build{model, *materials, std::move(*tree), MeshSet(model, *materials), {}, {}};
    for (const auto step : {&find_kinds, &find_unread, &build_movers, &build_parts, &finish_movers,
                            &build_places, &build_lamps, &build_guards, &build_stones}) {
        if (const Result<void> built = step(build); !built) return built.error();
    }
    build.level.origin = build.tree.origin;
    build.level.bounds = bounds_of_parts(build);
    if (build.level.bounds.min.x > build.level.bounds.max.x) return Error{"has no triangles"};
    add_missing_light(build, options.hangs_sun);
    const bool needs_spawn = !has_spawn(build);
    world::Level level = std::move(build.level);
    level.remarks.insert(level.remarks.begin(), materials->remarks.begin(), materials->remarks.end());
    for (const std::string& extension : unread_extensions(model))
        level.remarks.push_back(fmt::format("uses the extension {}, which is not read", extension));
    level.remarks.insert(level.remarks.end(), build.meshes.remarks().begin(), build.meshes.remarks().end());
    level.meshes = build.meshes.take();
    level.materials = std::move(materials->materials);
    level.textures = textures.take();
    if (const Result<void> checked = check_ranges(level); !checked) return checked.error();
    world::mark_clear_parts(level);
    if (needs_spawn) level.spawn = find_spawn(level);
    return level;
}

Result<world::Level> read_level(std::span<const std::byte> bytes, const std::filesystem::path& base_dir,
                                const LoadOptions& options) {
    const Result<tinygltf::Model> model = parse_gltf(bytes, base_dir);
    if (!model) return model.error();
    Result<world::Level> level = build_level(*model, options);
    if (level) level->file_hash = hash_of(bytes, *model);
    return level;
}

// Ways are needed where somebody walks them or a check must follow them; any other place is spared the wait.
bool needs_ways(const world::Level& level) {
    return !level.guards.empty() || !level.lenses.empty() || !level.exits.empty();
}

// Without ways guards stand still; no level is refused for that (check_level tells).
void add_ways(const std::filesystem::path& navmesh_file, world::Level& level) {
    if (!needs_ways(level)) return;
    const Result<Ground> ground = collect_ground(level);
    if (!ground) return;
    std::optional<std::vector<std::byte>> kept;
    if (!navmesh_file.empty()) kept = read_navmesh_file(navmesh_file, *ground);
    if (kept) {
        level.navmesh = std::move(*kept);
    } else if (Result<std::vector<std::byte>> baked = bake_navmesh(*ground); baked) {
        level.navmesh = std::move(*baked);
    }
    level.navmesh_hash = hash_bytes(level.navmesh);
}

Error in_file(const std::string& name, const Error& error) {
    return Error{fmt::format("{}: {}", name, error.sentence)};
}

struct Origin {
    std::string name;  // for sentences
    std::filesystem::path base_dir;
    std::filesystem::path navmesh_file;  // empty: none is looked for
};

Result<world::Level> load_named(std::span<const std::byte> bytes, const Origin& origin,
                                const LoadOptions& options) {
    try {
        Result<world::Level> level = read_level(bytes, origin.base_dir, options);
        if (!level) return in_file(origin.name, level.error());
        level->name = std::filesystem::path(origin.name).stem().string();
        if (options.finds_ways) add_ways(origin.navmesh_file, *level);
        if (options.fuses_parts) fuse_still_parts(*level);
        return level;
    } catch (const std::bad_alloc&) {
        return in_file(origin.name, Error{"needs more memory than there is"});
    }
}

}  // namespace

Result<world::Level> load_level_from_memory(std::span<const std::byte> bytes, const std::string& name,
                                            const std::filesystem::path& base_dir,
                                            const LoadOptions& options) {
    return load_named(bytes, {name, base_dir, {}}, options);
}

Result<world::Level> load_level(const std::filesystem::path& path, const LoadOptions& options) {
    const Result<std::vector<std::byte>> bytes = read_file(path, kMaxFileBytes);
    if (!bytes) return bytes.error();
    std::filesystem::path base_dir = path.parent_path();
    if (base_dir.empty()) base_dir = ".";
    return load_named(*bytes, {path.filename().string(), base_dir, navmesh_path(path)}, options);
}

}  // namespace gh::load
