// load/gltf_primitive.h - one primitive of a glTF mesh as checked triangles with all the attributes we keep.
//
// Bad input  attributes of unequal length, indices beyond the vertices, numbers that are not finite: a
//            sentence. Points and lines have no triangles. Missing normals are those of the triangles, as
//            glTF asks.
#pragma once

#include "base/result.h"
#include "load/gltf_materials.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <tiny_gltf.h>

#include <vector>

namespace gh::load {

// Arrays of vertices have equal length or are empty.
struct Primitive {
    std::vector<glm::vec3> positions;
    std::vector<glm::vec3> normals;  // unit
    std::vector<glm::vec2> uvs;
    std::vector<glm::vec4> tangents;
    std::vector<glm::vec4> colors;
    std::vector<glm::u16vec4> joints;  // of the skin, as in the file
    std::vector<glm::vec4> weights;    // sum to 1
    std::vector<glm::uvec3> triangles;
};

// At most `triangles_left` triangles and `vertices_left` vertices are read.
struct PrimitiveBudget {
    std::size_t vertices_left;
    std::size_t triangles_left;
};

[[nodiscard]] Result<Primitive> read_primitive(const tinygltf::Model& model, const tinygltf::Primitive& from,
                                               const UvUse& uvs, const PrimitiveBudget& budget);

}  // namespace gh::load
