#include "load/level_check.h"

#include "load/open_edges.h"
#include "load/part_geometry.h"
#include "load/place_words.h"
#include "load/walkways.h"

#include "raycore/mesh.h"

#include <fmt/format.h>

#include <algorithm>

namespace gh::load {
namespace {

constexpr float kArm = 1.6f;   // metres from the eyes to what one takes
constexpr float kEyes = 1.6f;  // metres above the feet

void check_shells(const world::Level& level, LevelReport& report) {
    for (const world::Part& part : level.parts) {
        if (!part.is_shell) continue;
        const OpenEdges open = find_open_edges(level.meshes[part.mesh]);
        if (open.count == 0) continue;
        const glm::mat4x3 world_from_part = world_from_part_at_rest(level, part);
        std::string places;
        for (const glm::vec3& middle : open.middles)
            places += " " + at(transform_point(world_from_part, middle));
        report.errors.push_back(
            fmt::format("shell '{}' is not closed: {} open edges, near{}", part.name, open.count, places));
    }
}

// Lenses and exits from the spawn.
void check_goals(const world::Level& level, const Walkways& ways, LevelReport& report) {
    const std::vector<bool> reached = ways.reached_polygons({&level.spawn.position, 1});
    if (!ways.is_on_floor(level.spawn.position)) {
        report.errors.push_back(fmt::format("the spawn at {} is not on any floor", at(level.spawn.position)));
        return;
    }
    for (const world::Lens& lens : level.lenses) {
        if (ways.is_in_reach(lens.centre, kArm, kArm + kEyes, reached)) continue;
        report.errors.push_back(
            fmt::format("lens '{}' at {} cannot be reached from the spawn", lens.name, at(lens.centre)));
    }
    for (const world::Aabb& exit : level.exits) {
        const glm::vec3 centre = 0.5f * (exit.min + exit.max), half = exit.max - centre;
        if (ways.is_in_reach(centre, std::min(half.x, half.z), half.y + 0.5f, reached)) continue;
        report.errors.push_back(fmt::format("the exit at {} cannot be reached from the spawn", at(centre)));
    }
}

void check_patrols(const world::Level& level, const Walkways& ways, LevelReport& report) {
    for (const world::Guard& guard : level.guards) {
        if (!ways.is_on_floor(guard.position)) {
            report.errors.push_back(
                fmt::format("guard '{}' at {} is not on any floor", guard.name, at(guard.position)));
            continue;
        }
        const std::vector<bool> reached = ways.reached_polygons({&guard.position, 1});
        for (const world::PatrolPoint& point : guard.patrol) {
            if (ways.is_reached(point.position, reached)) continue;
            report.errors.push_back(fmt::format("guard '{}' cannot walk to patrol point '{}' at {}",
                                                guard.name, point.name, at(point.position)));
        }
        if (guard.model == world::kNoIndex)
            report.warnings.push_back(fmt::format("guard '{}' has no body", guard.name));
    }
}

void check_lights(const world::Level& level, LevelReport& report) {
    std::vector<bool> has_light(level.lamp_groups.size(), false), has_switch(level.lamp_groups.size(), false);
    for (const world::Lamp& lamp : level.lamps) {
        if (lamp.group != world::kNoIndex) has_light[lamp.group] = true;
        if (lamp.group == world::kNoIndex && !lamp.starts_on) {
            report.warnings.push_back(
                fmt::format("lamp '{}' is off and no switch can turn it on", lamp.name));
        }
    }
    for (const world::Part& part : level.parts) {
        if (part.lamp_group != world::kNoIndex) has_light[part.lamp_group] = true;
    }
    for (const world::Switch& wall_switch : level.switches) {
        has_switch[wall_switch.group] = true;
        if (has_light[wall_switch.group]) continue;
        report.warnings.push_back(fmt::format("switch '{}' turns no lamp: group '{}' has none",
                                              wall_switch.name, level.lamp_groups[wall_switch.group]));
    }
    for (std::size_t g = 0; g < has_switch.size(); ++g) {
        if (has_light[g] && !has_switch[g]) {
            report.warnings.push_back(fmt::format("no switch turns lamp group '{}'", level.lamp_groups[g]));
        }
    }
}

void check_triangles(const world::Level& level, LevelReport& report) {
    for (const world::Mesh& mesh : level.meshes) {
        const rc::MeshReport dropped = rc::check_mesh({mesh.positions, mesh.triangles});
        if (dropped.dropped() == 0) continue;
        report.warnings.push_back(fmt::format("mesh '{}' has {} triangle{} without area, which nothing meets",
                                              mesh.name, dropped.dropped(),
                                              dropped.dropped() == 1 ? "" : "s"));
    }
}

void check_rules(const world::Level& level, LevelReport& report) {
    if (!level.lenses.empty() && level.exits.empty()) {
        report.errors.push_back("there is a lens to steal but no exit to leave by");
    }
    if (level.navmesh.empty() && !level.guards.empty()) {
        report.errors.push_back("no navmesh could be made, so its guards stand still");
    }
}

}  // namespace

LevelReport check_level(const world::Level& level) {
    LevelReport report{.errors = {}, .warnings = level.remarks};
    check_rules(level, report);
    check_shells(level, report);
    if (!level.navmesh.empty()) {
        const Walkways ways(level.navmesh);
        check_goals(level, ways, report);
        check_patrols(level, ways, report);
    }
    check_lights(level, report);
    check_triangles(level, report);
    return report;
}

}  // namespace gh::load
