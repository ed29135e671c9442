// load/gltf_materials.h - glTF materials with the extensions world/level.h names, and where their uvs go.
//
// Bad input  factors outside their range count as the nearest in it, with a remark; textures that do not exist or cannot be decoded
//            give a sentence.
#pragma once

#include "base/result.h"
#include "load/gltf_textures.h"
#include "world/level.h"

#include <glm/mat3x2.hpp>
#include <tiny_gltf.h>

#include <string>
#include <vector>

namespace gh::load {

// KHR_texture_transform, to be baked into the mesh that wears the material where all its textures agree (otherwise
// Material::uv_transforms has them); and which of the mesh's uv sets the material's first texture wants.
struct UvUse {
    glm::mat3x2 uv_from_file{1.0f};  // columns: u, v, offset
    int set = 0;
    bool is_plain = true;  // the identity
};

struct MaterialSet {
    std::vector<world::Material> materials;  // one more than the file's: the last is for what has none
    std::vector<UvUse> uvs;                  // as many
    std::vector<std::string> remarks;        // what made no sense and was taken for something else

    // Of a primitive's material index, -1 included.
    [[nodiscard]] std::size_t index_of(int gltf_material) const {
        return gltf_material < 0 ? materials.size() - 1 : static_cast<std::size_t>(gltf_material);
    }
};

[[nodiscard]] Result<MaterialSet> read_materials(const tinygltf::Model& model, TextureSet& textures);

}  // namespace gh::load
