// What each node is, what it moves with, and what is drawn there.
#include "load/gltf_extras.h"
#include "load/gltf_file.h"
#include "load/level_build.h"
#include "load/limits.h"
#include "world/layers.h"

#include <fmt/format.h>

#include <array>
#include <optional>
#include <string_view>
#include <utility>

namespace gh::load {
namespace {

constexpr std::array<std::pair<std::string_view, Kind>, 14> kKinds{{
    {"shell", Kind::Shell},
    {"room", Kind::Room},
    {"spawn", Kind::Spawn},
    {"exit", Kind::Exit},
    {"lens", Kind::Lens},
    {"door", Kind::Door},
    {"mirror", Kind::Mirror},
    {"switch", Kind::Switch},
    {"lamp", Kind::Lamp},
    {"glow", Kind::Glow},
    {"guard", Kind::Guard},
    {"patrol", Kind::Patrol},
    {"guard_model", Kind::GuardModel},
    {"stone_model", Kind::StoneModel},
}};

std::optional<Kind> kind_from_name(std::string_view name) {
    if (name.empty()) return Kind::None;
    for (const auto& [known, kind] : kKinds) {
        if (known == name) return kind;
    }
    return std::nullopt;
}

bool is_mover(Kind kind) {
    return kind == Kind::Door || kind == Kind::Mirror || kind == Kind::Lens;
}

Result<rc::LayerMask> layers_from_names(const std::string& names) {
    rc::LayerMask layers = 0;
    for (const std::string& name : split_names(names)) {
        if (name == "light")
            layers |= world::Light;
        else if (name == "sight")
            layers |= world::Sight;
        else if (name == "sound")
            layers |= world::Sound;
        else if (name == "solid")
            layers |= world::Solid;
        else
            return Error{fmt::format("there is no layer '{}'", name)};
    }
    return layers;
}

struct Drawn {
    std::uint32_t mesh;
    rc::LayerMask layers;
};

void add_part(LevelBuild& build, std::uint32_t id, const Drawn& drawn) {
    const NodeFacts& facts = build.facts[id];
    glm::dmat4 mover_from_part = build.tree.world_from_node[id];
    if (facts.mover_node != world::kNoIndex) {
        const Pose mover = pose_of(build.tree.world_from_node[facts.mover_node]);
        mover_from_part = glm::inverse(mover.matrix()) * mover_from_part;
    }
    world::Part part;
    part.name = build.node(id).name;
    part.mesh = drawn.mesh;
    part.mover_from_part = to_affine(mover_from_part);
    part.layers = drawn.layers;
    part.mover = facts.mover;
    part.mover_index = facts.mover_index;
    part.is_shell = facts.kind == Kind::Shell;
    build.level.parts.push_back(std::move(part));
}

// Solid things stop everything, glass lets sight through, and a lens one only sees: it is in nobody's way.
Result<void> draw_node(LevelBuild& build, std::uint32_t id) {
    const Kind kind = build.facts[id].kind;
    const Result<MeshPieces> pieces =
        build.meshes.use(build.node(id).mesh, kind == Kind::Shell ? Split::Whole : Split::GlassApart);
    if (!pieces) return pieces.error();
    const Result<std::string> names = text_or(build.extras(id), "layers", "");
    if (!names) return at_node(build, id, names.error().sentence);
    const Result<rc::LayerMask> given = layers_from_names(*names);
    if (!given) return at_node(build, id, given.error().sentence);

    const bool is_lens = build.facts[id].mover == world::Mover::Lens;
    const rc::LayerMask usual = is_lens ? world::Light : world::kEverything;
    const rc::LayerMask solid = names->empty() ? usual : *given;
    const rc::LayerMask glass = names->empty() ? usual & ~world::Sight : *given;
    if (pieces->solid != world::kNoIndex) add_part(build, id, {pieces->solid, solid});
    if (pieces->glass != world::kNoIndex) add_part(build, id, {pieces->glass, glass});
    if (build.level.parts.size() > kMaxParts) return Error{fmt::format("has more than {} parts", kMaxParts)};
    return {};
}

}  // namespace

Error at_node(const LevelBuild& build, std::uint32_t node, const std::string& why) {
    return Error{fmt::format("{}: {}", node_name(build.model, node), why)};
}

Result<std::uint32_t> group_by_name(LevelBuild& build, const std::string& name) {
    if (name.empty()) return world::kNoIndex;
    std::vector<std::string>& groups = build.level.lamp_groups;
    for (std::size_t i = 0; i < groups.size(); ++i) {
        if (groups[i] == name) return static_cast<std::uint32_t>(i);
    }
    if (groups.size() == world::kMaxLampGroups) {
        return Error{fmt::format("lamp group '{}' is one more than {}", name, world::kMaxLampGroups)};
    }
    groups.push_back(name);
    return static_cast<std::uint32_t>(groups.size() - 1);
}

Result<void> find_kinds(LevelBuild& build) {
    build.facts.assign(build.model.nodes.size(), {});
    for (const std::uint32_t id : build.tree.order) {
        NodeFacts& facts = build.facts[id];
        const Result<std::string> name = text_or(build.extras(id), "kind", "");
        if (!name) return at_node(build, id, name.error().sentence);
        const std::optional<Kind> kind = kind_from_name(*name);
        if (!kind) return at_node(build, id, fmt::format("there is no kind '{}'", *name));
        facts.kind = *kind;
        const std::uint32_t parent = build.tree.parent[id];
        const NodeFacts above = parent == world::kNoIndex ? NodeFacts{} : build.facts[parent];
        facts.is_in_model = above.is_in_model || *kind == Kind::GuardModel || *kind == Kind::StoneModel;
        facts.mover_node = above.mover_node;
        if (!is_mover(*kind)) continue;
        if (above.mover_node != world::kNoIndex) {
            return at_node(build, id,
                           fmt::format("a {} cannot hang on another thing that moves, {}", *name,
                                       node_name(build.model, above.mover_node)));
        }
        facts.mover_node = id;
    }
    return {};
}

Result<void> build_parts(LevelBuild& build) {
    for (const std::uint32_t id : build.tree.order) {
        NodeFacts& facts = build.facts[id];
        if (facts.mover_node != world::kNoIndex) {  // what moves a child moves the parts of it
            facts.mover = build.facts[facts.mover_node].mover;
            facts.mover_index = build.facts[facts.mover_node].mover_index;
        }
        facts.part_begin = static_cast<std::uint32_t>(build.level.parts.size());
        if (build.node(id).mesh >= 0 && !facts.is_in_model) {
            if (Result<void> drawn = draw_node(build, id); !drawn) return drawn;
        }
        facts.part_end = static_cast<std::uint32_t>(build.level.parts.size());
    }
    return {};
}

}  // namespace gh::load
