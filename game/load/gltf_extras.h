// load/gltf_extras.h - game meaning: the custom properties (glTF `extras`) of a node or material, by name and
// type.
//
// Bad input  a property of another type than asked for is a mistake of the author and gives a sentence,
//            except that 1 and 0 pass as true and false (Blender writes them so).
#pragma once

#include "base/result.h"

#include <glm/vec3.hpp>
#include <tiny_gltf.h>

#include <optional>
#include <string>
#include <vector>

namespace gh::load {

// Each reads property `key` of `extras`, or gives `fallback` when there is none.
[[nodiscard]] Result<std::string> text_or(const tinygltf::Value& extras, const char* key,
                                          const std::string& fallback);
[[nodiscard]] Result<float> number_or(const tinygltf::Value& extras, const char* key, float fallback);
[[nodiscard]] Result<bool> flag_or(const tinygltf::Value& extras, const char* key, bool fallback);
[[nodiscard]] Result<glm::vec3> vector_or(const tinygltf::Value& extras, const char* key,
                                          const glm::vec3& fallback);

// "p1, p2,p3" as its names, blanks around them dropped, empty ones too.
[[nodiscard]] std::vector<std::string> split_names(const std::string& names);

}  // namespace gh::load
