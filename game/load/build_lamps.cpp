// Lamps: the file's punctual lights, meshes that are lamps, meshes that only glow.
#include "base/det_math.h"
#include "load/gltf_extras.h"
#include "load/gltf_numbers.h"
#include "load/level_build.h"
#include "load/mesh_lamps.h"

#include <fmt/format.h>

#include <algorithm>

namespace gh::load {
namespace {

// What glTF gives in lumens the game counts in watts, at the rate Blender's exporter turned watts into
// lumens.
constexpr double kLumensPerWatt = 683.0;
constexpr double kMostCandela = 1.0e9 * kLumensPerWatt;
constexpr Range kColors{0.0, 1.0e3};  // exporters know lamps that are redder than red

int light_of(const tinygltf::Node& node) {
    const auto extension = node.extensions.find("KHR_lights_punctual");
    if (extension == node.extensions.end() || !extension->second.Has("light")) return -1;
    const tinygltf::Value& light = extension->second.Get("light");
    return light.IsNumber() ? light.GetNumberAsInt() : -1;
}

void read_cone(const tinygltf::SpotLight& spot, const NumberReader& numbers, world::Lamp& lamp) {
    constexpr double kRightAngle = 1.5707963267948966;
    const double outer = numbers.nearest("outerConeAngle", spot.outerConeAngle, {1.0e-3, kRightAngle});
    lamp.cos_outer = det::cos(static_cast<float>(outer));
    lamp.cos_inner = det::cos(numbers.within("innerConeAngle", spot.innerConeAngle, {0.0, outer}));
}

Result<world::Lamp> punctual_lamp(LevelBuild& build, std::uint32_t id, int light_id) {
    if (light_id < 0 || static_cast<std::size_t>(light_id) >= build.model.lights.size()) {
        return Error{fmt::format("light {} does not exist", light_id)};
    }
    const tinygltf::Light& light = build.model.lights[static_cast<std::size_t>(light_id)];
    world::Lamp lamp;
    if (light.type == "point")
        lamp.shape = world::LampShape::Point;
    else if (light.type == "spot")
        lamp.shape = world::LampShape::Spot;
    else if (light.type == "directional")
        lamp.shape = world::LampShape::Sun;
    else
        return Error{fmt::format("there is no light of type '{}'", light.type)};

    const Pose pose = pose_of(build.tree.world_from_node[id]);
    lamp.name = build.node(id).name;
    lamp.position = glm::vec3(pose.position);
    lamp.direction = glm::vec3(pose.rotation * glm::dvec3(0.0, 0.0, -1.0));
    const NumberReader numbers(node_name(build.model, id), build.level.remarks);
    const double intensity = numbers.nearest("intensity", light.intensity, {0.0, kMostCandela});
    for (std::size_t i = 0; i < 3; ++i) {
        const double color = i < light.color.size()
                                 ? numbers.nearest(fmt::format("color[{}]", i), light.color[i], kColors)
                                 : 1.0;
        lamp.intensity[static_cast<glm::length_t>(i)] =
            static_cast<float>(std::min(intensity * color / kLumensPerWatt, 1.0e9));
    }
    if (lamp.shape == world::LampShape::Spot) read_cone(light.spot, numbers, lamp);
    lamp.range = range_of(lamp);
    if (light.range > 0.0)
        lamp.range = std::min(lamp.range, static_cast<float>(std::min(light.range, 1.0e9)));
    else if (light.range < 0.0)
        numbers.remark(fmt::format("range {} is no distance and is passed over", light.range));
    return lamp;
}

Result<MeshLampShape> shape_from_name(const std::string& name) {
    if (name.empty() || name == "point") return MeshLampShape::Either;
    if (name == "sphere") return MeshLampShape::Sphere;
    if (name == "rect") return MeshLampShape::Rect;
    return Error{fmt::format("there is no lamp shape '{}'", name)};
}

Result<void> add_lamp(LevelBuild& build, world::Lamp lamp) {
    if (build.level.lamps.size() == world::kMaxLamps) {
        return Error{fmt::format("lamp '{}' is one more than {}", lamp.name, world::kMaxLamps)};
    }
    build.level.lamps.push_back(std::move(lamp));
    return {};
}

// What `lamp` and `glow` nodes say beside their shape.
struct LampExtras {
    std::uint32_t group = world::kNoIndex;
    bool starts_on = true;
    MeshLampShape shape = MeshLampShape::Either;
};

Result<LampExtras> read_extras(LevelBuild& build, const tinygltf::Value& extras) {
    const Result<std::string> group_name = text_or(extras, "group", "");
    if (!group_name) return group_name.error();
    const Result<std::uint32_t> group = group_by_name(build, *group_name);
    if (!group) return group.error();
    const Result<bool> starts_on = flag_or(extras, "on", true);
    if (!starts_on) return starts_on.error();
    const Result<std::string> shape_name = text_or(extras, "shape", "");
    if (!shape_name) return shape_name.error();
    const Result<MeshLampShape> shape = shape_from_name(*shape_name);
    if (!shape) return shape.error();
    return LampExtras{*group, *starts_on, *shape};
}

// The parts of a lamp or glow go dark with their group; those that shine become lamps.
Result<void> read_mesh_lamp(LevelBuild& build, std::uint32_t id, const LampExtras& extras) {
    const NodeFacts& facts = build.facts[id];
    bool has_lamp = false;
    for (std::uint32_t part = facts.part_begin; part < facts.part_end; ++part) {
        build.level.parts[part].lamp_group = extras.group;
        if (facts.kind != Kind::Lamp) continue;
        std::optional<world::Lamp> lamp = lamp_of_part(build, part, extras.shape);
        if (!lamp) continue;
        has_lamp = true;
        lamp->group = extras.group;
        lamp->starts_on = extras.starts_on;
        if (Result<void> added = add_lamp(build, std::move(*lamp)); !added) return added;
    }
    if (facts.kind == Kind::Lamp && !has_lamp) return Error{"is a lamp, but no material of it is emissive"};
    return {};
}

Result<void> read_lamp(LevelBuild& build, std::uint32_t id) {
    // A light may hang below the node that says what it is.
    const std::uint32_t parent = build.tree.parent[id];
    const bool is_told_by_parent = build.facts[id].kind == Kind::None && parent != world::kNoIndex &&
                                   build.facts[parent].kind == Kind::Lamp && build.node(parent).mesh < 0;
    const Result<LampExtras> extras = read_extras(build, build.extras(is_told_by_parent ? parent : id));
    if (!extras) return extras.error();
    const int light = light_of(build.node(id));
    if (light >= 0) {
        Result<world::Lamp> lamp = punctual_lamp(build, id, light);
        if (!lamp) return lamp.error();
        lamp->group = extras->group;
        lamp->starts_on = extras->starts_on;
        if (Result<void> added = add_lamp(build, std::move(*lamp)); !added) return added;
    }
    if (build.facts[id].part_begin == build.facts[id].part_end) return {};
    const Kind kind = build.facts[id].kind;
    return kind == Kind::Lamp || kind == Kind::Glow ? read_mesh_lamp(build, id, *extras) : Result<void>{};
}

}  // namespace

Result<void> build_lamps(LevelBuild& build) {
    for (const std::uint32_t id : build.tree.order) {
        const Kind kind = build.facts[id].kind;
        if (kind != Kind::Lamp && kind != Kind::Glow && light_of(build.node(id)) < 0) continue;
        if (Result<void> read = read_lamp(build, id); !read) return at_node(build, id, read.error().sentence);
    }
    return {};
}

}  // namespace gh::load
