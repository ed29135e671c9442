// load/gltf_file.h - a glTF file parsed, with its side files read, but nothing in it believed yet: indices,
// counts and offsets are checked where they are used (gltf_accessor, gltf_nodes, gltf_materials).
#pragma once

#include "base/result.h"

#include <tiny_gltf.h>

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace gh::load {

// Images arrive undecoded: those with a buffer view keep it, the others have their file's bytes in `image`.
// External files are looked for in `base_dir` and below it only.
[[nodiscard]] Result<tinygltf::Model> parse_gltf(std::span<const std::byte> bytes,
                                                 const std::filesystem::path& base_dir);

// What the file uses and could be read without, that is passed over.
[[nodiscard]] std::vector<std::string> unread_extensions(const tinygltf::Model& model);

// "'Wall'", or "number 7" for what has no name: how sentences name a thing of the file.
[[nodiscard]] std::string name_or_number(const std::string& name, std::size_t number);

}  // namespace gh::load
