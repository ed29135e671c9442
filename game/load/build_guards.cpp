// Guards: the bodies they wear, where they stand and what they walk.
#include "load/gltf_extras.h"
#include "load/guard_model.h"
#include "load/level_build.h"
#include "world/layers.h"
#include "world/state.h"

#include <fmt/format.h>

#include <map>

namespace gh::load {
namespace {

using PatrolPoints = std::map<std::string, world::PatrolPoint>;

Result<void> read_models(LevelBuild& build) {
    for (const std::uint32_t id : build.tree.order) {
        if (build.facts[id].kind != Kind::GuardModel) continue;
        Result<world::Model> model = read_guard_model(build, id);
        if (!model) return at_node(build, id, model.error().sentence);
        build.level.models.push_back(std::move(*model));
    }
    return {};
}

Result<PatrolPoints> read_patrol_points(const LevelBuild& build) {
    PatrolPoints points;
    for (const std::uint32_t id : build.tree.order) {
        if (build.facts[id].kind != Kind::Patrol) continue;
        const Result<float> wait_s = number_or(build.extras(id), "wait_s", 2.0f);
        if (!wait_s) return at_node(build, id, wait_s.error().sentence);
        if (!(*wait_s >= 0.0f && *wait_s <= 600.0f))
            return at_node(build, id, "wait_s must lie within 0 and 600");
        const Result<bool> looks = flag_or(build.extras(id), "look", false);
        if (!looks) return at_node(build, id, looks.error().sentence);
        const glm::dmat4& world_from_node = build.tree.world_from_node[id];
        const std::string& name = build.node(id).name;
        const bool is_new =
            points
                .emplace(name, world::PatrolPoint{.name = name,
                                                  .position = glm::vec3(world_from_node[3]),
                                                  .yaw = yaw_of(world_from_node),
                                                  .wait_ticks =
                                                      *wait_s * static_cast<float>(world::kTicksPerSecond),
                                                  .looks_round = *looks})
                .second;
        if (!is_new) return at_node(build, id, "is a second patrol point of this name");
    }
    return points;
}

// The body named `name`; a level may leave out the default one, and then its guards are heard but not seen.
Result<std::uint32_t> model_by_name(const LevelBuild& build, const std::string& name) {
    for (std::size_t i = 0; i < build.level.models.size(); ++i) {
        if (build.level.models[i].name == name) return static_cast<std::uint32_t>(i);
    }
    if (name == "guard" && build.level.models.empty()) return world::kNoIndex;
    return Error{fmt::format("there is no guard_model '{}'", name)};
}

Result<world::Guard> read_guard(const LevelBuild& build, std::uint32_t id, const PatrolPoints& points) {
    const tinygltf::Value& extras = build.extras(id);
    const Result<std::string> title = text_or(extras, "title", "");
    if (!title) return title.error();
    const Result<std::string> patrol = text_or(extras, "patrol", "");
    if (!patrol) return patrol.error();
    const Result<std::string> model_name = text_or(extras, "model", "guard");
    if (!model_name) return model_name.error();
    const Result<std::uint32_t> model = model_by_name(build, *model_name);
    if (!model) return model.error();
    world::Guard guard;
    guard.name = build.node(id).name;
    guard.title = *title;
    guard.position = glm::vec3(build.tree.world_from_node[id][3]);
    guard.yaw = yaw_of(build.tree.world_from_node[id]);
    guard.model = *model;
    for (const std::string& name : split_names(*patrol)) {
        const auto point = points.find(name);
        if (point == points.end()) return Error{fmt::format("there is no patrol point '{}'", name)};
        guard.patrol.push_back(point->second);
    }
    constexpr std::size_t kMostPoints = 1024;
    if (guard.patrol.size() > kMostPoints)
        return Error{fmt::format("walks more than {} points", kMostPoints)};
    return guard;
}

// Bodies are in nobody's way as geometry: characters keep apart as capsules, and no look stops at its own
// head.
void add_body(LevelBuild& build, std::uint32_t index) {
    const world::Guard& guard = build.level.guards[index];
    if (guard.model == world::kNoIndex) return;
    const world::Model& model = build.level.models[guard.model];
    world::Part body;
    body.name = guard.name;
    body.mesh = model.mesh;
    body.mover_from_part = model.model_from_mesh;
    body.layers = world::Light;
    body.mover = world::Mover::Guard;
    body.mover_index = index;
    build.level.parts.push_back(std::move(body));
}

}  // namespace

Result<void> build_guards(LevelBuild& build) {
    if (Result<void> read = read_models(build); !read) return read;
    const Result<PatrolPoints> points = read_patrol_points(build);
    if (!points) return points.error();
    for (const std::uint32_t id : build.tree.order) {
        if (build.facts[id].kind != Kind::Guard) continue;
        if (build.level.guards.size() == world::kMaxGuards) {
            return at_node(build, id, fmt::format("is one guard more than {}", world::kMaxGuards));
        }
        Result<world::Guard> guard = read_guard(build, id, *points);
        if (!guard) return at_node(build, id, guard.error().sentence);
        build.level.guards.push_back(std::move(*guard));
        add_body(build, static_cast<std::uint32_t>(build.level.guards.size() - 1));
    }
    return {};
}

}  // namespace gh::load
