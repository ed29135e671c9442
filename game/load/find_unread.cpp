// Properties that a thing does not have: nobody reads them, and most are misspelt ones whose default holds instead.
#include "load/level_build.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <vector>

namespace gh::load {
namespace {

// What assets/README.md lists for each kind.
std::vector<std::string_view> properties_of(Kind kind) {
    switch (kind) {
        case Kind::Room:
            return {"size", "title"};
        case Kind::Exit:
            return {"size"};
        case Kind::Lens:
            return {"title", "layers"};
        case Kind::Door:
            return {"open_angle_deg", "open_time_s", "axis", "title", "layers"};
        case Kind::Mirror:
            return {"turn_step_deg", "carry", "title", "layers"};
        case Kind::Switch:
            return {"group", "title", "layers"};
        case Kind::Lamp:
            return {"group", "on", "shape", "layers"};
        case Kind::Glow:
            return {"group", "on", "layers"};
        case Kind::Guard:
            return {"patrol", "model", "title"};
        case Kind::Patrol:
            return {"wait_s", "look"};
        case Kind::Shell:
            return {"layers"};
        default:
            return {};
    }
}

}  // namespace

// Nodes without a kind may carry whatever other programs leave there.
Result<void> find_unread(LevelBuild& build) {
    for (const std::uint32_t id : build.tree.order) {
        const tinygltf::Value& extras = build.extras(id);
        if (build.facts[id].kind == Kind::None || !extras.IsObject()) continue;
        const std::vector<std::string_view> read = properties_of(build.facts[id].kind);
        for (const std::string& key : extras.Keys()) {
            if (key == "kind" || std::find(read.begin(), read.end(), key) != read.end()) continue;
            build.level.remarks.push_back(
                fmt::format("{}: the property '{}' is none of a {}, and nobody reads it",
                            node_name(build.model, id), key, extras.Get("kind").Get<std::string>()));
        }
    }
    return {};
}

}  // namespace gh::load
