#include "render/shading_point.h"

#include "base/contracts.h"
#include "base/det_math.h"
#include "render/polish.h"
#include "render/shading_corners.h"

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace gh::render {

namespace {

constexpr float kFlattestView = 0.02f;  // least cosine between a bent normal and the eye

glm::vec3 smooth_normal(const SceneView& view, const world::Mesh& mesh, const rc::Hit& hit,
                        const HitTriangle& corners, const glm::mat3& normal_to_world,
                        const glm::vec3& geometric) {
    const auto& posed = view.snapshot.posed;
    const std::vector<glm::vec3>& normals = hit.instance < posed.size() && posed[hit.instance] != nullptr
                                                ? posed[hit.instance]->normals
                                                : mesh.normals;
    if (normals.empty()) return geometric;
    const glm::vec3 local = normals[corners.index.x] * corners.share[0] +
                            normals[corners.index.y] * corners.share[1] +
                            normals[corners.index.z] * corners.share[2];
    return unit_or(normal_to_world * local, geometric);
}

// -1 in a mirrored part, where left is right of what is ahead.
float handedness_of(const glm::mat3& to_world) {
    return glm::dot(glm::cross(to_world[0], to_world[1]), to_world[2]) < 0.0f ? -1.0f : 1.0f;
}

// The ways u and v grow along a surface of this normal; 0 where the mesh does not say.
struct Tangents {
    glm::vec3 tangent{0.0f}, bitangent{0.0f};
};
Tangents tangents_at(const world::Mesh& mesh, const HitTriangle& corners, const glm::mat3& to_world,
                     const glm::vec3& smooth) {
    glm::vec3 tangent;
    float handedness = 1.0f;
    if (!mesh.tangents.empty()) {
        const glm::vec4 t = mesh.tangents[corners.index.x] * corners.share[0] +
                            mesh.tangents[corners.index.y] * corners.share[1] +
                            mesh.tangents[corners.index.z] * corners.share[2];
        tangent = to_world * glm::vec3(t);
        handedness = t.w < 0.0f ? -1.0f : 1.0f;
    } else {
        const float det = corners.uv_edge1.x * corners.uv_edge2.y - corners.uv_edge1.y * corners.uv_edge2.x;
        tangent = (corners.edge1 * corners.uv_edge2.y - corners.edge2 * corners.uv_edge1.y) *
                  (det < 0.0f ? -1.0f : 1.0f);
        handedness = det < 0.0f ? 1.0f : -1.0f;  // v runs down, the map's green runs up
    }
    tangent = unit_or(tangent - smooth * glm::dot(tangent, smooth), glm::vec3(0.0f));
    return {tangent, glm::cross(smooth, tangent) * (handedness * handedness_of(to_world))};
}

// Bends the smooth normal as the normal map says.
glm::vec3 mapped_normal(float scale, const Tangents& along, const glm::vec3& smooth, const glm::vec4& texel) {
    const float x = (texel.x * 2.0f - 1.0f) * scale, y = (texel.y * 2.0f - 1.0f) * scale;
    return unit_or(along.tangent * x + along.bitangent * y + smooth * (texel.z * 2.0f - 1.0f), smooth);
}

void add_layers(const world::Material& material, const Tangents& along, const Texels& texels,
                ShadingPoint& point) {
    using Slot = world::TextureSlot;
    const world::Layers& layers = material.layers;
    point.specular = material.specular * texels[Slot::Specular].w;
    point.specular_color = layers.specular_color * glm::vec3(texels[Slot::SpecularColor]);
    point.coat = layers.coat * texels[Slot::Coat].x;
    point.coat_roughness = layers.coat_roughness * texels[Slot::CoatRoughness].y;
    point.sheen_color = layers.sheen_color * glm::vec3(texels[Slot::SheenColor]);
    point.sheen_roughness = layers.sheen_roughness * texels[Slot::SheenRoughness].w;
    if (!(layers.anisotropy > 0.0f)) return;
    glm::vec2 way(1.0f, 0.0f);
    point.anisotropy = layers.anisotropy;
    if (layers.anisotropy_texture != world::kNoIndex) {
        const glm::vec4 texel = texels[Slot::Anisotropy];
        way = {texel.x * 2.0f - 1.0f, texel.y * 2.0f - 1.0f};
        point.anisotropy *= texel.z;
    }
    const det::SinCos turn = det::sin_cos(layers.anisotropy_rotation);
    const glm::vec2 turned(turn.cos * way.x - turn.sin * way.y, turn.sin * way.x + turn.cos * way.y);
    // Without a tangent there is no way to draw it out.
    point.drawn_out = unit_or(along.tangent * turned.x + along.bitangent * turned.y, glm::vec3(0.0f));
    if (point.drawn_out == glm::vec3(0.0f)) point.anisotropy = 0.0f;
}

// Between the corners' own colours.
glm::vec4 color_at(const world::Mesh& mesh, const HitTriangle& corners) {
    if (mesh.colors.empty()) return glm::vec4(1.0f);
    return mesh.colors[corners.index.x] * corners.share[0] + mesh.colors[corners.index.y] * corners.share[1] +
           mesh.colors[corners.index.z] * corners.share[2];
}

// A smooth normal may face away from the eye near a silhouette; there it is bent until it just does not.
glm::vec3 facing_eye(const glm::vec3& normal, const glm::vec3& to_eye) {
    const float cosine = glm::dot(normal, to_eye);
    if (cosine >= kFlattestView) return normal;
    return glm::normalize(normal + to_eye * (kFlattestView - cosine));
}

// A cache line each; GCC and Clang alike. A wrong address is no fault.
template <class T>
void fetch(const std::vector<T>& array, std::size_t index) {
    __builtin_prefetch(array.data() + index);
}

// A point whose textures are still to be looked up.
struct MetPlace {
    const world::Mesh* mesh = nullptr;
    const MaterialTextures* textures = nullptr;
    glm::mat3 to_world{1.0f};
    HitTriangle corners;
    glm::vec3 direction{0.0f}, outward{0.0f}, normal{0.0f};
    bool has_uvs = false;
    std::size_t first_look = 0;
};

MetPlace met_place(const SceneView& view, const rc::Ray& ray, const rc::Hit& hit, ShadingPoint& point) {
    EXPECTS(!hit.is_miss());
    MetPlace met;
    met.mesh = &view.level.meshes[view.level.parts[hit.instance].mesh];
    const std::uint32_t id = met.mesh->materials[hit.primitive];
    const world::Material& material = view.level.materials[id];
    met.textures = &view.prepared.material_textures[id];
    met.to_world = linear_part(view.snapshot.scene->instance(hit.instance).world_from_instance);

    point.surface = view.snapshot.scene->surface(hit);
    point.material = &material;
    point.part = hit.instance;
    met.has_uvs = !met.mesh->uvs.empty() && (met.textures->count > 0 || material.has_layers);
    met.corners = corners_of(view, *met.mesh, hit, met.to_world, met.has_uvs);
    met.normal =
        smooth_normal(view, *met.mesh, hit, met.corners, normal_matrix(met.to_world), point.surface.normal);

    met.outward =
        glm::dot(point.surface.normal, met.normal) < 0.0f ? -point.surface.normal : point.surface.normal;
    met.direction = glm::normalize(ray.direction);
    point.is_entering = glm::dot(met.direction, met.outward) <= 0.0f;
    point.geometric = point.is_entering ? met.outward : -met.outward;
    return met;
}

void add_looks(const SceneView& view, MetPlace& met, const world::Material& material, float cone_width,
               TextureLookUps& looks) {
    met.first_look = looks.count();
    if (!met.has_uvs || met.textures->count == 0) return;
    const TexturePlace place{met.corners.uv, uv_gradients(met.corners)};
    for (std::uint32_t i = 0; i < met.textures->count; ++i) {
        const auto [texture, slot] = met.textures->slots[i];
        looks.add(view.prepared.textures[texture], place_of(material, slot, place),
                  {met.direction, met.outward, cone_width});
    }
}

void add_materials(const MetPlace& met, const TextureLookUps& looks, ShadingPoint& point) {
    using Slot = world::TextureSlot;
    const world::Material& material = *point.material;
    Texels texels;
    for (std::uint32_t i = 0; met.has_uvs && i < met.textures->count; ++i)
        texels.values[static_cast<std::size_t>(met.textures->slots[i].slot)] =
            looks.value(met.first_look + i);
    const glm::vec4 base = material.base_color * texels[Slot::BaseColor] * color_at(*met.mesh, met.corners);
    const glm::vec4 rough_metal = texels[Slot::MetallicRoughness];
    point.base_color = glm::vec3(base);
    point.alpha = base.w;
    point.roughness = material.roughness * rough_metal.y;
    point.metallic = material.metallic * rough_metal.z;
    point.transmission = material.transmission * texels[Slot::Transmission].x;
    point.emission = material.emission * glm::vec3(texels[Slot::Emission]);
    point.specular = material.specular;
    glm::vec3 normal = met.normal;
    point.smooth = facing_eye(point.is_entering ? normal : -normal, -met.direction);
    point.coat_normal = point.smooth;
    const bool has_map = material.normal_texture != world::kNoIndex && met.has_uvs;
    if (has_map || material.has_layers) {
        const Tangents along = tangents_at(*met.mesh, met.corners, met.to_world, normal);
        if (material.has_layers) add_layers(material, along, texels, point);
        if (met.has_uvs && material.layers.coat_normal_texture != world::kNoIndex) {
            const glm::vec3 coat =
                mapped_normal(material.layers.coat_normal_scale, along, normal, texels[Slot::CoatNormal]);
            point.coat_normal = facing_eye(point.is_entering ? coat : -coat, -met.direction);
        }
        if (has_map) normal = mapped_normal(material.normal_scale, along, normal, texels[Slot::Normal]);
    }
    point.normal = facing_eye(point.is_entering ? normal : -normal, -met.direction);
}

}  // namespace

void fetch_indices(const SceneView& view, const rc::Hit& hit) {
    if (hit.is_miss()) return;
    const world::Mesh& mesh = view.level.meshes[view.level.parts[hit.instance].mesh];
    fetch(mesh.triangles, hit.primitive);
    fetch(mesh.materials, hit.primitive);
}

void fetch_corners(const SceneView& view, const rc::Hit& hit) {
    if (hit.is_miss()) return;
    const world::Mesh& mesh = view.level.meshes[view.level.parts[hit.instance].mesh];
    const glm::uvec3& corner = mesh.triangles[hit.primitive];
    for (glm::length_t i = 0; i < 3; ++i) {
        fetch(mesh.normals, corner[i]);
        if (!mesh.uvs.empty()) fetch(mesh.uvs, corner[i]);
    }
}

ShadingPoint shading_point(const SceneView& view, const rc::Ray& ray, const rc::Hit& hit, float cone_width,
                           float max_taps) {
    ShadingPoint point;
    TextureLookUps looks;
    MetPlace met = met_place(view, ray, hit, point);
    add_looks(view, met, *point.material, cone_width, looks);
    if (looks.count() > 0) looks.work_out(max_taps);
    add_materials(met, looks, point);
    return point;
}

void shading_points(const SceneView& view, std::span<const PointAsked> asked,
                    std::span<ShadingPoint> points) {
    EXPECTS(asked.size() == points.size());
    std::array<MetPlace, kPatches> met;
    TextureLookUps looks;
    for (std::size_t first = 0, next = 0; first < asked.size(); first = next) {
        looks.clear();
        for (; next < asked.size() && next - first < kPatches; ++next) {
            const PointAsked& ask = asked[next];
            const world::Mesh& mesh = view.level.meshes[view.level.parts[ask.hit->instance].mesh];
            const std::size_t count =
                view.prepared.material_textures[mesh.materials[ask.hit->primitive]].count;
            if (looks.count() + count > kPatches || ask.max_taps != asked[first].max_taps) break;
            points[next] = {};
            met[next - first] = met_place(view, *ask.ray, *ask.hit, points[next]);
            add_looks(view, met[next - first], *points[next].material, ask.cone_width, looks);
        }
        if (looks.count() > 0) looks.work_out(asked[first].max_taps);
        for (std::size_t i = first; i < next; ++i) add_materials(met[i - first], looks, points[i]);
    }
}

glm::vec3 mirrored_direction(const glm::vec3& direction, const ShadingPoint& at) {
    return mirrored_direction(direction, at.normal, at.geometric);
}

Clearness clearness(const SceneView& view, const rc::Hit& hit) {
    const world::Level& level = view.level;
    const world::Mesh& mesh = level.meshes[level.parts[hit.instance].mesh];
    const world::Material& material = level.materials[mesh.materials[hit.primitive]];
    Clearness result;
    result.material = &material;
    const bool has_holes = material.alpha_mode != world::AlphaMode::Opaque;
    if (!has_holes && !(material.transmission > 0.0f)) return result;

    const glm::mat3 to_world = linear_part(view.snapshot.scene->instance(hit.instance).world_from_instance);
    const HitTriangle corners = corners_of(view, mesh, hit, to_world, !mesh.uvs.empty());
    result.surface = view.snapshot.scene->surface(hit);
    const glm::vec3 smooth =
        smooth_normal(view, mesh, hit, corners, normal_matrix(to_world), result.surface.normal);
    result.outward =
        glm::dot(smooth, result.surface.normal) < 0.0f ? -result.surface.normal : result.surface.normal;

    glm::vec4 base = material.base_color * color_at(mesh, corners);
    if (material.base_color_texture != world::kNoIndex && !mesh.uvs.empty()) {
        base *= view.prepared.textures[material.base_color_texture].at(
            place_of(material, world::TextureSlot::BaseColor, {corners.uv, {}}).uv);
    }
    float covered = 1.0f;
    if (material.alpha_mode == world::AlphaMode::Mask) covered = base.w < material.alpha_cutoff ? 0.0f : 1.0f;
    if (material.alpha_mode == world::AlphaMode::Blend) covered = std::clamp(base.w, 0.0f, 1.0f);
    result.glass = covered * material.transmission;
    if (material.transmission_texture != world::kNoIndex && !mesh.uvs.empty()) {
        result.glass *= view.prepared.textures[material.transmission_texture]
                            .at(place_of(material, world::TextureSlot::Transmission, {corners.uv, {}}).uv)
                            .x;
    }
    result.glass_share = glm::vec3(base) * result.glass;
    result.share = glm::vec3(1.0f - covered) + result.glass_share;
    return result;
}

}  // namespace gh::render
