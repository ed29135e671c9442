// load/level_build.h - a Level in the making: the parsed file, the tree of its nodes with what each one is,
// and what has been read so far. The build_*.cpp files each turn one kind of node into nouns of the Level.
#pragma once

#include "base/result.h"
#include "load/gltf_materials.h"
#include "load/gltf_meshes.h"
#include "load/limits.h"
#include "load/node_tree.h"
#include "world/level.h"

#include <tiny_gltf.h>

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace gh::load {

// The node property `kind` (assets/README.md).
enum class Kind : std::uint8_t {
    None,
    Shell,
    Room,
    Spawn,
    Exit,
    Lens,
    Door,
    Mirror,
    Switch,
    Lamp,
    Glow,
    Guard,
    Patrol,
    GuardModel,
    StoneModel,
};

struct NodeFacts {
    Kind kind = Kind::None;
    bool is_in_model = false;                    // a guard's or stone's body: not drawn where it stands
    std::uint32_t mover_node = world::kNoIndex;  // the door, mirror or lens it moves with; may be itself
    world::Mover mover = world::Mover::None;
    std::uint32_t mover_index = 0;
    std::uint32_t part_begin = 0, part_end = 0;  // what of Level::parts it became
};

struct LevelBuild {
    const tinygltf::Model& model;
    const MaterialSet& materials;
    NodeTree tree;
    MeshSet meshes;
    std::vector<NodeFacts> facts;  // of every node of the file
    world::Level level;
    std::size_t keys_left = kMaxKeys;

    [[nodiscard]] const tinygltf::Node& node(std::uint32_t id) const { return model.nodes[id]; }
    [[nodiscard]] const tinygltf::Value& extras(std::uint32_t id) const { return model.nodes[id].extras; }
};

// Puts the node's name in front of what is wrong with it.
[[nodiscard]] Error at_node(const LevelBuild& build, std::uint32_t node, const std::string& why);

// The id of a lamp group by name, made when new; kNoIndex for the empty name.
[[nodiscard]] Result<std::uint32_t> group_by_name(LevelBuild& build, const std::string& name);

// In this order, each over all nodes.
[[nodiscard]] Result<void> find_kinds(LevelBuild& build);     // facts: kind, model membership, movers
[[nodiscard]] Result<void> find_unread(LevelBuild& build);    // properties that nothing has: remarks
[[nodiscard]] Result<void> build_movers(LevelBuild& build);   // doors, mirrors and lenses: where they turn
[[nodiscard]] Result<void> build_parts(LevelBuild& build);    // what is drawn
[[nodiscard]] Result<void> finish_movers(LevelBuild& build);  // handles, panes, centres: they need the parts
[[nodiscard]] Result<void> build_lamps(LevelBuild& build);
[[nodiscard]] Result<void> build_places(LevelBuild& build);  // spawn, exits, rooms, switches, viewpoints
[[nodiscard]] Result<void> build_guards(LevelBuild& build);  // models, clips, patrols, and their parts
[[nodiscard]] Result<void> build_stones(LevelBuild& build);

}  // namespace gh::load
