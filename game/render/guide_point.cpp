#include "render/guide_point.h"

#include "render/polish.h"

#include <glm/geometric.hpp>

namespace gh::render {

namespace {

// What glass, paint and varnish give back, on average over angles and a little more: a dark seam in a polished floor
// mirrors as much as the plank beside it. Pictures lit in every ninth pixel err least between .1 and .2 (README.md).
constexpr float kPolish = 0.15f;

bool is_solid(const world::Material& material) {
    return material.alpha_mode == world::AlphaMode::Opaque && !(material.transmission > 0.0f);
}

// Guards bend, and wear no polish that their pictures would miss.
bool is_polished_all_over(const SceneView& view, const world::Material& material, std::uint32_t part) {
    if (material.metallic_roughness_texture != world::kNoIndex ||
        material.normal_texture != world::kNoIndex || material.has_layers ||
        view.level.parts[part].mover == world::Mover::Guard)
        return false;
    if (is_plain(material)) return material.roughness < kDullDielectric;
    return is_solid(material) && material.base_color_texture == world::kNoIndex &&
           material.roughness > kClearMirror;
}

// The mesh's normals at the triangle's corners, or its own.
void add_smooth_normals(const world::Mesh& mesh, const glm::uvec3& corners, const glm::mat3& to_world,
                        GuideTriangle& triangle) {
    triangle.smooth = triangle.normal;
    if (mesh.normals.empty()) return;
    const glm::mat3 turn = normal_matrix(to_world);
    const auto at = [&](std::uint32_t corner) {
        return unit_or(turn * mesh.normals[corner], triangle.normal);
    };
    triangle.smooth = at(corners.x);
    triangle.smooth_edge1 = at(corners.y) - triangle.smooth;
    triangle.smooth_edge2 = at(corners.z) - triangle.smooth;
}

}  // namespace

void note(const GuidePoint& point, std::size_t pixel, GuidePlanes& planes) {
    planes.part[pixel] = point.part;
    planes.position[pixel] = point.position;
    planes.previous[pixel] = point.previous;
    planes.geometric[pixel] = point.geometric;
    planes.albedo[pixel] = point.albedo;
}

glm::vec3 guide_albedo(const glm::vec3& base_color, float metallic) {
    return base_color + glm::vec3(kPolish * (1.0f - metallic) + 1e-3f);
}

glm::vec3 previous_position(const SceneView& view, const rc::Hit& hit, const glm::vec3& position) {
    if (view.before == nullptr || view.level.parts[hit.instance].mover == world::Mover::None) return position;
    return view.before->scene->surface(hit).position;
}

bool is_plain(const world::Material& material) {
    return is_solid(material) && !(material.metallic > 0.0f);
}

const GuideTriangle& GuideTriangles::of(const SceneView& view, const rc::Hit& hit) {
    GuideTriangle& triangle = kept_[(hit.primitive ^ hit.instance * 5u) % kKept];
    if (triangle.instance == hit.instance && triangle.primitive == hit.primitive) return triangle;
    const world::Mesh& mesh = view.level.meshes[view.level.parts[hit.instance].mesh];
    const std::uint32_t material = mesh.materials[hit.primitive];
    triangle = GuideTriangle();
    triangle.instance = hit.instance;
    triangle.primitive = hit.primitive;
    triangle.material = &view.level.materials[material];
    const bool is_painted = !mesh.colors.empty();  // corner by corner: the long way
    triangle.is_plain = !is_painted && is_plain(*triangle.material);
    triangle.is_polished = !is_painted && is_polished_all_over(view, *triangle.material, hit.instance);
    if (!triangle.is_plain && !triangle.is_polished) return triangle;
    triangle.is_textured = !mesh.uvs.empty() && view.prepared.material_textures[material].count > 0;
    const glm::mat3 to_world = linear_part(view.snapshot.scene->instance(hit.instance).world_from_instance);
    const HitTriangle corners = corners_of(view, mesh, hit, to_world, triangle.is_textured);
    triangle.normal = unit_or(glm::cross(corners.edge1, corners.edge2), glm::vec3(0.0f));
    if (triangle.is_polished) add_smooth_normals(mesh, corners.index, to_world, triangle);
    if (!triangle.is_textured) return triangle;
    triangle.uv = mesh.uvs[corners.index.x];
    triangle.uv_edge1 = corners.uv_edge1;
    triangle.uv_edge2 = corners.uv_edge2;
    triangle.gradients = uv_gradients(corners);
    return triangle;
}

GuidePoint plain_point(const SceneView& view, const GuideTriangle& triangle, const rc::Ray& ray,
                       const rc::Hit& hit) {
    const glm::vec3 normal = triangle.normal == glm::vec3(0.0f) ? -ray.direction : triangle.normal;
    GuidePoint point;
    point.part = hit.instance;
    point.position = ray.origin + ray.direction * hit.t;
    point.previous = previous_position(view, hit, point.position);
    point.geometric = glm::dot(normal, ray.direction) > 0.0f ? -normal : normal;
    return point;
}

}  // namespace gh::render
