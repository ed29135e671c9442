#include "load/gltf_primitive.h"

#include "load/gltf_accessor.h"
#include "load/limits.h"

#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace gh::load {
namespace {

int attribute(const tinygltf::Primitive& from, const std::string& name) {
    const auto found = from.attributes.find(name);
    return found == from.attributes.end() ? -1 : found->second;
}

// Reads one attribute into `to` when the file has it.
template <class T>
Result<void> read_attribute(const tinygltf::Model& model, const tinygltf::Primitive& from,
                            const std::string& name,
                            Result<std::vector<T>> (*read)(const tinygltf::Model&, int), std::size_t vertices,
                            std::vector<T>& to) {
    const int accessor = attribute(from, name);
    if (accessor < 0) return {};
    Result<std::vector<T>> values = read(model, accessor);
    if (!values) return Error{fmt::format("{}: {}", name, values.error().sentence)};
    if (values->size() != vertices) {
        return Error{fmt::format("{} has {} values for {} vertices", name, values->size(), vertices)};
    }
    to = std::move(*values);
    return {};
}

// With or without alpha; none takes light away.
Result<std::vector<glm::vec4>> read_colors(const tinygltf::Model& model, int accessor) {
    const auto id = static_cast<std::size_t>(accessor);
    std::vector<glm::vec4> colors;
    if (id < model.accessors.size() && model.accessors[id].type == TINYGLTF_TYPE_VEC3) {
        const Result<std::vector<glm::vec3>> opaque = read_vec3s(model, accessor);
        if (!opaque) return opaque.error();
        for (const glm::vec3& color : *opaque) colors.emplace_back(color, 1.0f);
    } else {
        Result<std::vector<glm::vec4>> clear = read_vec4s(model, accessor);
        if (!clear) return clear.error();
        colors = std::move(*clear);
    }
    for (glm::vec4& color : colors) color = glm::max(color, glm::vec4(0.0f));
    return colors;
}

Result<void> read_vertices(const tinygltf::Model& model, const tinygltf::Primitive& from, const UvUse& uvs,
                           const PrimitiveBudget& budget, Primitive& to) {
    const int position = attribute(from, "POSITION");
    if (position < 0) return Error{"has no POSITION"};
    if (static_cast<std::size_t>(position) < model.accessors.size() &&
        model.accessors[static_cast<std::size_t>(position)].count > budget.vertices_left) {
        return Error{fmt::format("makes more than {} vertices together", kMaxVertices)};
    }
    Result<std::vector<glm::vec3>> positions = read_vec3s(model, position);
    if (!positions) return Error{"POSITION: " + positions.error().sentence};
    to.positions = std::move(*positions);
    const std::size_t count = to.positions.size();

    std::string uv_name = fmt::format("TEXCOORD_{}", uvs.set);
    if (attribute(from, uv_name) < 0) uv_name = "TEXCOORD_0";
    if (auto r = read_attribute(model, from, "NORMAL", &read_vec3s, count, to.normals); !r) return r;
    if (auto r = read_attribute(model, from, uv_name, &read_vec2s, count, to.uvs); !r) return r;
    if (auto r = read_attribute(model, from, "TANGENT", &read_vec4s, count, to.tangents); !r) return r;
    if (auto r = read_attribute(model, from, "COLOR_0", &read_colors, count, to.colors); !r) return r;
    if (auto r = read_attribute(model, from, "JOINTS_0", &read_joints, count, to.joints); !r) return r;
    if (auto r = read_attribute(model, from, "WEIGHTS_0", &read_vec4s, count, to.weights); !r) return r;
    if (to.joints.empty() != to.weights.empty())
        return Error{"has joints without weights, or weights without joints"};
    if (!uvs.is_plain) {
        for (glm::vec2& uv : to.uvs) uv = uvs.uv_from_file * glm::vec3(uv, 1.0f);
    }
    return {};
}

// Corners in the order of TRIANGLES, whatever the mode: strips turn every other triangle round.
std::vector<std::uint32_t> to_corners(int mode, std::vector<std::uint32_t> indices) {
    if (mode == TINYGLTF_MODE_TRIANGLES) return indices;
    std::vector<std::uint32_t> corners;
    for (std::size_t i = 2; i < indices.size(); ++i) {
        const bool is_fan = mode == TINYGLTF_MODE_TRIANGLE_FAN;
        const std::uint32_t first = is_fan ? indices[0] : indices[i - 2 + (i % 2)];
        const std::uint32_t second = is_fan ? indices[i - 1] : indices[i - 1 - (i % 2)];
        const std::uint32_t third = indices[i];
        if (first == second || second == third || third == first) continue;  // strips are joined by these
        corners.insert(corners.end(), {first, second, third});
    }
    return corners;
}

Result<void> read_triangles(const tinygltf::Model& model, const tinygltf::Primitive& from,
                            const PrimitiveBudget& budget, Primitive& to) {
    const int mode = from.mode < 0 ? TINYGLTF_MODE_TRIANGLES : from.mode;
    std::vector<std::uint32_t> indices;
    if (from.indices >= 0) {
        Result<std::vector<std::uint32_t>> read = read_indices(model, from.indices);
        if (!read) return read.error();
        indices = std::move(*read);
    } else {
        indices.resize(to.positions.size());
        for (std::size_t i = 0; i < indices.size(); ++i) indices[i] = static_cast<std::uint32_t>(i);
    }
    if (mode == TINYGLTF_MODE_TRIANGLES && indices.size() % 3 != 0) {
        return Error{fmt::format("has {} indices, which is no number of triangles", indices.size())};
    }
    for (const std::uint32_t index : indices) {
        if (index < to.positions.size()) continue;
        return Error{fmt::format("index {} is out of range ({} vertices)", index, to.positions.size())};
    }
    if (indices.size() / (mode == TINYGLTF_MODE_TRIANGLES ? 3 : 1) > budget.triangles_left) {
        return Error{fmt::format("makes more than {} triangles together", kMaxTriangles)};
    }
    const std::vector<std::uint32_t> corners = to_corners(mode, std::move(indices));
    to.triangles.reserve(corners.size() / 3);
    for (std::size_t i = 0; i + 2 < corners.size(); i += 3) {
        to.triangles.emplace_back(corners[i], corners[i + 1], corners[i + 2]);
    }
    return {};
}

glm::vec3 area_normal(const Primitive& primitive, const glm::uvec3& triangle) {
    const glm::vec3& a = primitive.positions[triangle[0]];
    return glm::cross(primitive.positions[triangle[1]] - a, primitive.positions[triangle[2]] - a);
}

glm::vec3 unit_or(const glm::vec3& vector, const glm::vec3& fallback) {
    const float largest = std::max({std::abs(vector.x), std::abs(vector.y), std::abs(vector.z)});
    if (!(largest > 0.0f) || !std::isfinite(largest)) return fallback;
    return glm::normalize(vector / largest);  // scaled first: squares of small ones would vanish
}

template <class T>
void give_corners_their_own(const std::vector<glm::uvec3>& triangles, std::vector<T>& values) {
    if (values.empty()) return;
    std::vector<T> own;
    own.reserve(triangles.size() * 3);
    for (const glm::uvec3& t : triangles) own.insert(own.end(), {values[t[0]], values[t[1]], values[t[2]]});
    values = std::move(own);
}

void make_flat_normals(Primitive& primitive) {
    give_corners_their_own(primitive.triangles, primitive.positions);
    give_corners_their_own(primitive.triangles, primitive.uvs);
    give_corners_their_own(primitive.triangles, primitive.colors);
    give_corners_their_own(primitive.triangles, primitive.joints);
    give_corners_their_own(primitive.triangles, primitive.weights);
    primitive.tangents.clear();  // glTF: ignored where there are no normals
    primitive.normals.resize(primitive.positions.size());
    std::uint32_t next = 0;
    for (glm::uvec3& triangle : primitive.triangles) {
        triangle = {next, next + 1, next + 2};
        const glm::vec3 normal = unit_or(area_normal(primitive, triangle), {0.0f, 1.0f, 0.0f});
        for (int i = 0; i < 3; ++i) primitive.normals[next++] = normal;
    }
}

// Exporters leave normals of zero at the corners of slivers, and quantised ones are not unit.
void mend_normals(Primitive& primitive) {
    std::vector<glm::vec3> sums;
    for (std::size_t i = 0; i < primitive.normals.size(); ++i) {
        const glm::vec3 unit = unit_or(primitive.normals[i], glm::vec3(0.0f));
        if (unit == glm::vec3(0.0f) && sums.empty()) {
            sums.resize(primitive.positions.size(), glm::vec3(0.0f));
            for (const glm::uvec3& t : primitive.triangles) {
                const glm::vec3 normal = area_normal(primitive, t);
                for (glm::length_t c = 0; c < 3; ++c) sums[t[c]] += normal;
            }
        }
        primitive.normals[i] = unit == glm::vec3(0.0f) ? unit_or(sums[i], {0.0f, 1.0f, 0.0f}) : unit;
    }
}

Result<void> mend_weights(Primitive& primitive) {
    for (std::size_t i = 0; i < primitive.weights.size(); ++i) {
        glm::vec4& weight = primitive.weights[i];
        weight = glm::max(weight, glm::vec4(0.0f));
        const float sum = (weight.x + weight.y) + (weight.z + weight.w);
        if (!(sum > 0.0f) || !std::isfinite(sum)) return Error{fmt::format("vertex {} hangs on no joint", i)};
        weight /= sum;
    }
    return {};
}

}  // namespace

Result<Primitive> read_primitive(const tinygltf::Model& model, const tinygltf::Primitive& from,
                                 const UvUse& uvs, const PrimitiveBudget& budget) {
    Primitive primitive;
    const bool has_area = from.mode < 0 || from.mode == TINYGLTF_MODE_TRIANGLES ||
                          from.mode == TINYGLTF_MODE_TRIANGLE_STRIP ||
                          from.mode == TINYGLTF_MODE_TRIANGLE_FAN;
    if (!has_area) return primitive;
    if (const Result<void> read = read_vertices(model, from, uvs, budget, primitive); !read)
        return read.error();
    if (const Result<void> read = read_triangles(model, from, budget, primitive); !read) return read.error();
    if (primitive.normals.empty()) {
        if (primitive.triangles.size() * 3 > budget.vertices_left) {
            return Error{fmt::format("makes more than {} vertices together", kMaxVertices)};
        }
        make_flat_normals(primitive);
    } else {
        mend_normals(primitive);
    }
    if (const Result<void> mended = mend_weights(primitive); !mended) return mended.error();
    return primitive;
}

}  // namespace gh::load
