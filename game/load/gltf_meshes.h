// load/gltf_meshes.h - glTF meshes as the Level's: the primitives of one merged, once for every node that
// uses it.
//
// A mesh of glass and something else becomes two, because glass lets sight through and the rest does not, and
// who meets what is decided for a whole part. A room's shell stays whole: only then can it be proved closed.
#pragma once

#include "base/result.h"
#include "load/gltf_materials.h"
#include "world/level.h"

#include <tiny_gltf.h>

#include <cstdint>
#include <map>
#include <vector>

namespace gh::load {

// Ids of Level meshes; kNoIndex for none. `glass` is used only where a mesh was split or is glass throughout.
struct MeshPieces {
    std::uint32_t solid = world::kNoIndex;
    std::uint32_t glass = world::kNoIndex;
};

enum class Split { GlassApart, Whole };

class MeshSet {
  public:
    MeshSet(const tinygltf::Model& model, const MaterialSet& materials)
        : model_(model), materials_(materials) {}

    [[nodiscard]] Result<MeshPieces> use(int gltf_mesh, Split split);
    // A mesh made elsewhere.
    [[nodiscard]] std::uint32_t add(world::Mesh mesh);
    // All of a glTF mesh, with its skin's joints; not kept.
    [[nodiscard]] Result<world::Mesh> read_whole(int gltf_mesh);

    [[nodiscard]] const world::Mesh& mesh(std::uint32_t id) const { return meshes_[id]; }
    [[nodiscard]] std::size_t size() const { return meshes_.size(); }
    // What was missing and is done without.
    [[nodiscard]] const std::vector<std::string>& remarks() const { return remarks_; }
    [[nodiscard]] std::vector<world::Mesh> take() { return std::move(meshes_); }

  private:
    // The primitives whose material is glass, those whose is not, or all.
    enum class Which { Solid, Glass, All };
    [[nodiscard]] Result<world::Mesh> read(int gltf_mesh, Which which);
    [[nodiscard]] bool is_glass(const tinygltf::Primitive& primitive) const;

    const tinygltf::Model& model_;
    const MaterialSet& materials_;
    std::vector<world::Mesh> meshes_;
    std::vector<std::string> remarks_;
    std::map<std::pair<int, Split>, MeshPieces> known_;
    std::size_t vertices_ = 0;
    std::size_t triangles_ = 0;
};

}  // namespace gh::load
