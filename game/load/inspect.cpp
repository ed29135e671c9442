#include "load/inspect.h"

#include "base/hash.h"
#include "load/level_check.h"
#include "load/level_loader.h"
#include "load/place_words.h"
#include "load/walkways.h"
#include "world/level.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>

namespace gh::load {
namespace {

using Page = std::string;

template <class... Args>
void line(Page& page, fmt::format_string<Args...> format, Args&&... args) {
    fmt::format_to(std::back_inserter(page), format, std::forward<Args>(args)...);
    page += '\n';
}

std::string titled(const std::string& name, const std::string& title) {
    return title.empty() || title == name ? name : fmt::format("{} \"{}\"", name, title);
}

template <class T, class Test>
std::size_t count(const std::vector<T>& items, const Test& test) {
    return static_cast<std::size_t>(std::count_if(items.begin(), items.end(), test));
}

void describe_geometry(const world::Level& level, Page& page) {
    std::size_t drawn = 0, stored = 0, texels = 0;
    for (const world::Part& part : level.parts) {
        if (part.mover != world::Mover::Stone) drawn += level.meshes[part.mesh].triangles.size();
    }
    for (const world::Mesh& mesh : level.meshes) stored += mesh.triangles.size();
    for (const world::Texture& texture : level.textures) texels += texture.rgba.size();
    const glm::vec3 size = level.bounds.max - level.bounds.min;
    line(page, "  extent     {:.1f} x {:.1f} x {:.1f} m, from {} to {}", size.x, size.y, size.z,
         at(level.bounds.min), at(level.bounds.max));
    const glm::dvec3& origin = level.origin;
    if (origin != glm::dvec3(0.0))
        line(page, "  origin     ({:.0f}, {:.0f}, {:.0f}) in the file: places here count from there",
             origin.x, origin.y, origin.z);
    line(page, "  triangles  {} drawn, {} stored in {} meshes, {} parts ({} shells)", drawn, stored,
         level.meshes.size(), level.parts.size(),
         count(level.parts, [](const world::Part& p) { return p.is_shell; }));
    line(page, "  textures   {}, {:.1f} MB decoded", level.textures.size(),
         static_cast<double>(texels) / 1e6);
}

void describe_materials(const world::Level& level, Page& page) {
    const auto having = [&](const auto& test) { return count(level.materials, test); };
    line(page,
         "  materials  {}: {} textured, {} with normal maps, {} glass, {} metal, {} mirror, {} emissive",
         level.materials.size(),
         having([](const world::Material& m) { return m.base_color_texture != world::kNoIndex; }),
         having([](const world::Material& m) { return m.normal_texture != world::kNoIndex; }),
         having([](const world::Material& m) { return m.transmission > 0.0f; }),
         having([](const world::Material& m) { return m.metallic > 0.5f; }),
         having([](const world::Material& m) { return m.metallic >= 0.999f && m.roughness <= 0.05f; }),
         having([](const world::Material& m) { return m.emission != glm::vec3(0.0f); }));
    std::string surfaces;
    for (std::size_t s = 0; s < world::kSurfaceCount; ++s) {
        const auto surface = static_cast<world::Surface>(s);
        const std::size_t n = having([&](const world::Material& m) { return m.surface == surface; });
        if (n > 0)
            surfaces += fmt::format("{}{} {}", surfaces.empty() ? "" : ", ", n, world::surface_name(surface));
    }
    line(page, "  surfaces   {}", surfaces);
}

void describe_lamps(const world::Level& level, Page& page) {
    constexpr std::array<const char*, 5> kNames{"point", "spot", "sun", "sphere", "rect"};
    std::string kinds;
    for (std::size_t k = 0; k < kNames.size(); ++k) {
        const auto shape = static_cast<world::LampShape>(k);
        const std::size_t n =
            count(level.lamps, [&](const world::Lamp& lamp) { return lamp.shape == shape; });
        if (n > 0) kinds += fmt::format("{}{} {}", kinds.empty() ? ": " : ", ", n, kNames[k]);
    }
    line(page, "  lamps      {}{}; {} groups, {} switches", level.lamps.size(), kinds,
         level.lamp_groups.size(), level.switches.size());
}

void describe_things(const world::Level& level, Page& page) {
    line(page, "  doors      {}", level.doors.size());
    line(page, "  mirrors    {}, {} of them turn", level.mirrors.size(),
         count(level.mirrors, [](const world::Mirror& m) { return m.turn_step != 0.0f; }));
    for (const world::Lens& lens : level.lenses)
        line(page, "  lens       {} at {}", titled(lens.name, lens.title), at(lens.centre));
    for (const world::Aabb& exit : level.exits)
        line(page, "  exit       {} to {}", at(exit.min), at(exit.max));
    line(page, "  spawn      {}, yaw {:.0f} deg", at(level.spawn.position), 57.29578f * level.spawn.yaw);
}

void describe_people(const world::Level& level, Page& page) {
    for (const world::Model& model : level.models) {
        std::string clips;
        for (const world::Clip& clip : model.clips)
            clips += fmt::format(" {} {:.1f} s,", clip.name, clip.duration);
        if (!clips.empty()) clips.pop_back();
        line(page, "  body       {}: {} triangles, {} joints, clips{}", model.name,
             level.meshes[model.mesh].triangles.size(), model.joints.size(), clips.empty() ? " none" : clips);
    }
    for (const world::Guard& guard : level.guards) {
        line(page, "  guard      {} at {}, {} patrol points", titled(guard.name, guard.title),
             at(guard.position), guard.patrol.size());
    }
}

void describe_places(const world::Level& level, Page& page) {
    for (const world::Room& room : level.rooms) {
        const glm::vec3 size = room.box.max - room.box.min;
        line(page, "  room       {}: {:.1f} x {:.1f} x {:.1f} m", titled(room.name, room.title), size.x,
             size.y, size.z);
    }
    for (const world::Viewpoint& view : level.viewpoints)
        line(page, "  viewpoint  {} at {}", view.name, at(view.position));
}

void describe_navmesh(const world::Level& level, Page& page) {
    if (level.navmesh.empty()) {
        line(page, "  navmesh    none");
        return;
    }
    line(page, "  navmesh    {} polygons, {:.1f} kB, hash {}", Walkways(level.navmesh).polygon_count(),
         static_cast<double>(level.navmesh.size()) / 1e3, hex16(level.navmesh_hash));
}

void describe_report(const LevelReport& report, Page& page) {
    for (const std::string& error : report.errors) line(page, "  ERROR      {}", error);
    for (const std::string& warning : report.warnings) line(page, "  warning    {}", warning);
    if (report.errors.empty() && report.warnings.empty()) line(page, "  check      nothing is wrong with it");
}

}  // namespace

Result<LevelPage> describe_level(const std::filesystem::path& path) {
    const Result<world::Level> level = load_level(path, {.fuses_parts = false});
    if (!level) return level.error();
    Page page;
    line(page, "{}: a level, hash {}", path.filename().string(), hex16(level->file_hash));
    describe_geometry(*level, page);
    describe_materials(*level, page);
    describe_lamps(*level, page);
    describe_things(*level, page);
    describe_people(*level, page);
    describe_navmesh(*level, page);
    describe_places(*level, page);
    const LevelReport report = check_level(*level);
    describe_report(report, page);
    return LevelPage{page, report.errors.size()};
}

}  // namespace gh::load
