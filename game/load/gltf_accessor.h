// load/gltf_accessor.h - the numbers of a glTF accessor, after proving that they are there.
//
// Checked   accessor, view and buffer exist; offset + count x stride lies inside all three; types are what
//           the reader asked for; every number read is finite. Sparse accessors are read, accessors without a
//           view are zeros. Nothing is allocated for elements the file has no bytes for.
// Sentences name the accessor; the caller puts mesh, primitive and attribute in front.
#pragma once

#include "base/result.h"

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <tiny_gltf.h>

#include <cstdint>
#include <span>
#include <vector>

namespace gh::load {

// Floats, or integers mapped to [0, 1] or [-1, 1] where the accessor says they are normalised.
[[nodiscard]] Result<std::vector<float>> read_scalars(const tinygltf::Model& model, int accessor);
[[nodiscard]] Result<std::vector<glm::vec2>> read_vec2s(const tinygltf::Model& model, int accessor);
[[nodiscard]] Result<std::vector<glm::vec3>> read_vec3s(const tinygltf::Model& model, int accessor);
[[nodiscard]] Result<std::vector<glm::vec4>> read_vec4s(const tinygltf::Model& model, int accessor);
[[nodiscard]] Result<std::vector<glm::mat4>> read_mat4s(const tinygltf::Model& model, int accessor);

// Unsigned integers as they are: triangle indices (1 component), joint ids (4).
[[nodiscard]] Result<std::vector<std::uint32_t>> read_indices(const tinygltf::Model& model, int accessor);
[[nodiscard]] Result<std::vector<glm::u16vec4>> read_joints(const tinygltf::Model& model, int accessor);

// The bytes of a buffer view: encoded images.
[[nodiscard]] Result<std::span<const unsigned char>> view_bytes(const tinygltf::Model& model, int view);

}  // namespace gh::load
