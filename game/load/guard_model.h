// load/guard_model.h - a glTF skin below a `guard_model` node becomes a Model: joints, skinned mesh, clips.
//
// Frames    the mesh's frame is the armature's; model_from_mesh keeps the armature's scale and drops where it
//           stands and how it is turned, since the body is worn by guards elsewhere.
// Bad input skins without joints, weights of joints that do not exist, keys that do not rise: a sentence.
#pragma once

#include "base/result.h"
#include "load/level_build.h"
#include "world/level.h"

#include <cstdint>
#include <vector>

namespace gh::load {

// The model below node `root`; its mesh is added to the build's.
[[nodiscard]] Result<world::Model> read_guard_model(LevelBuild& build, std::uint32_t root);

// The file's animations as far as they move these joints (node_of_joint[i] is joint i's node), starting at 0
// s. `keys_left` is what may still be read, and is lowered by what was.
[[nodiscard]] Result<std::vector<world::Clip>> read_clips(const tinygltf::Model& model,
                                                          const std::vector<std::uint32_t>& node_of_joint,
                                                          std::size_t& keys_left);

}  // namespace gh::load
