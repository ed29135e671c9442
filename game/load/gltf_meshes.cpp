#include "load/gltf_meshes.h"

#include "load/gltf_file.h"
#include "load/gltf_primitive.h"
#include "load/limits.h"

#include <fmt/format.h>

namespace gh::load {
namespace {

// Appends `more`, or as many `filler`s as there are new vertices when only one of the two has the attribute.
template <class T>
void append(std::vector<T>& to, const std::vector<T>& more, std::size_t before, std::size_t added,
            const T& filler) {
    if (to.empty() && more.empty()) return;
    to.resize(before, filler);
    if (more.empty()) {
        to.resize(before + added, filler);
    } else {
        to.insert(to.end(), more.begin(), more.end());
    }
}

void append_vertices(const Primitive& from, world::Mesh& to) {
    const std::size_t before = to.positions.size(), added = from.positions.size();
    to.positions.insert(to.positions.end(), from.positions.begin(), from.positions.end());
    to.normals.insert(to.normals.end(), from.normals.begin(), from.normals.end());
    append(to.uvs, from.uvs, before, added, glm::vec2(0.0f));
    append(to.tangents, from.tangents, before, added, glm::vec4(0.0f, 0.0f, 0.0f, 1.0f));
    append(to.colors, from.colors, before, added, glm::vec4(1.0f));
    append(to.joints, from.joints, before, added, glm::u16vec4(0));
    append(to.weights, from.weights, before, added, glm::vec4(1.0f, 0.0f, 0.0f, 0.0f));
}

void append_triangles(const Primitive& from, std::uint32_t first_vertex, std::uint32_t material,
                      world::Mesh& to) {
    for (const glm::uvec3& triangle : from.triangles) to.triangles.push_back(triangle + first_vertex);
    to.materials.resize(to.triangles.size(), material);
}

}  // namespace

bool MeshSet::is_glass(const tinygltf::Primitive& primitive) const {
    const std::size_t material = materials_.index_of(primitive.material);
    return material < materials_.materials.size() && materials_.materials[material].transmission > 0.0f;
}

Result<world::Mesh> MeshSet::read(int gltf_mesh, Which which) {
    const auto id = static_cast<std::size_t>(gltf_mesh);
    if (gltf_mesh < 0 || id >= model_.meshes.size())
        return Error{fmt::format("mesh {} does not exist", gltf_mesh)};
    const tinygltf::Mesh& from = model_.meshes[id];
    world::Mesh mesh;
    mesh.name = from.name;

    // Exporters let many primitives share one set of vertices: these are read once.
    using Attributes = std::pair<std::map<std::string, int>, int>;
    std::map<Attributes, std::uint32_t> first_vertex_of;
    for (std::size_t p = 0; p < from.primitives.size(); ++p) {
        const tinygltf::Primitive& primitive = from.primitives[p];
        const std::size_t material = materials_.index_of(primitive.material);
        const auto refuse = [&](const std::string& why) {
            return Error{fmt::format("mesh {} primitive {}: {}", name_or_number(from.name, id), p, why)};
        };
        if (material >= materials_.materials.size())
            return refuse(fmt::format("material {} does not exist", material));
        if (which != Which::All && is_glass(primitive) != (which == Which::Glass)) continue;
        const UvUse& uvs = materials_.uvs[material];
        if (uvs.set != 0 && primitive.attributes.count(fmt::format("TEXCOORD_{}", uvs.set)) == 0)
            remarks_.push_back(
                refuse(fmt::format("has no TEXCOORD_{}, and TEXCOORD_0 is taken", uvs.set)).sentence);
        const Result<Primitive> read =
            read_primitive(model_, primitive, uvs, {kMaxVertices - vertices_, kMaxTriangles - triangles_});
        if (!read) return refuse(read.error().sentence);

        const bool can_share = uvs.is_plain && uvs.set == 0 && primitive.attributes.count("NORMAL") != 0;
        const Attributes key{primitive.attributes, can_share ? -1 : static_cast<int>(p)};
        const auto [known, is_new] =
            first_vertex_of.emplace(key, static_cast<std::uint32_t>(mesh.positions.size()));
        if (is_new) {
            append_vertices(*read, mesh);
        }
        vertices_ += read->positions.size();  // shared ones too: reading them costs the same
        append_triangles(*read, known->second, static_cast<std::uint32_t>(material), mesh);
        triangles_ += read->triangles.size();
    }
    return mesh;
}

Result<world::Mesh> MeshSet::read_whole(int gltf_mesh) {
    return read(gltf_mesh, Which::All);
}

std::uint32_t MeshSet::add(world::Mesh mesh) {
    meshes_.push_back(std::move(mesh));
    return static_cast<std::uint32_t>(meshes_.size() - 1);
}

Result<MeshPieces> MeshSet::use(int gltf_mesh, Split split) {
    const std::pair<int, Split> key{gltf_mesh, split};
    if (const auto known = known_.find(key); known != known_.end()) return known->second;
    MeshPieces pieces;
    Result<world::Mesh> solid = read(gltf_mesh, split == Split::Whole ? Which::All : Which::Solid);
    if (!solid) return solid.error();
    if (!solid->triangles.empty()) pieces.solid = add(std::move(*solid));
    if (split == Split::GlassApart) {
        Result<world::Mesh> glass = read(gltf_mesh, Which::Glass);
        if (!glass) return glass.error();
        if (!glass->triangles.empty()) pieces.glass = add(std::move(*glass));
    }
    known_.emplace(key, pieces);
    return pieces;
}

}  // namespace gh::load
