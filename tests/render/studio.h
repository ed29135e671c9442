// tests/render/studio.h - little scenes with known answers: sheets, boxes and balls, lit and looked at.
#pragma once

#include "render/whitted.h"
#include "world/clear_parts.h"
#include "world/layers.h"
#include "world/level.h"

#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>

#include <cmath>
#include <cstdint>
#include <memory>
#include <utility>

namespace gh::test {

inline constexpr float kPiF = 3.14159265358979f;

// A Lambert surface: an index of 1 mirrors nothing.
inline world::Material matte(const glm::vec3& albedo) {
    world::Material material;
    material.base_color = glm::vec4(albedo, 1.0f);
    material.ior = 1.0f;
    return material;
}
inline world::Material glowing(float radiance) {
    world::Material material = matte(glm::vec3(0.0f));
    material.emission = glm::vec3(radiance);
    return material;
}
inline world::Material mirror(float reflectance) {
    world::Material material;
    material.base_color = glm::vec4(glm::vec3(reflectance), 1.0f);
    material.metallic = 1.0f;
    material.roughness = 0.0f;
    return material;
}
inline world::Material clear_glass(float ior) {
    world::Material material;
    material.transmission = 1.0f;
    material.roughness = 0.0f;
    material.ior = ior;
    return material;
}

class Studio {
  public:
    world::Level level;
    world::Snapshot snapshot;
    render::Prepared prepared;

    // Faces along cross(half_u, half_v).
    std::uint32_t add_sheet(const glm::vec3& centre, const glm::vec3& half_u, const glm::vec3& half_v,
                            const world::Material& material) {
        world::Mesh mesh;
        append_sheet(mesh, centre, half_u, half_v);
        return add_part(std::move(mesh), material);
    }

    // Closed, normals outwards; a room when `is_inside_out`.
    std::uint32_t add_box(const glm::vec3& min, const glm::vec3& max, const world::Material& material,
                          bool is_inside_out = false) {
        world::Mesh mesh;
        const glm::vec3 centre = 0.5f * (min + max), half = 0.5f * (max - min);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            glm::vec3 u(0.0f), v(0.0f), out(0.0f);
            out[axis] = half[axis];
            u[(axis + 1) % 3] = half[(axis + 1) % 3];
            v[(axis + 2) % 3] = half[(axis + 2) % 3];
            if (is_inside_out) std::swap(u, v);
            append_sheet(mesh, centre + out, u, v);
            append_sheet(mesh, centre - out, v, u);
        }
        return add_part(std::move(mesh), material);
    }

    // Rings and sectors; smooth normals.
    std::uint32_t add_ball(const glm::vec3& centre, float radius, unsigned rings,
                           const world::Material& material) {
        world::Mesh mesh;
        const unsigned sectors = 2 * rings;
        for (unsigned r = 0; r <= rings; ++r) {
            for (unsigned s = 0; s < sectors; ++s) {
                const float theta = kPiF * static_cast<float>(r) / static_cast<float>(rings);
                const float ring = r == rings ? 0.0f : std::sin(theta);  // all corners of a pole in one place
                const float phi = 2.0f * kPiF * static_cast<float>(s) / static_cast<float>(sectors);
                const glm::vec3 n(ring * std::cos(phi), std::cos(theta), ring * std::sin(phi));
                mesh.positions.push_back(centre + n * radius);
                mesh.normals.push_back(n);
            }
        }
        for (unsigned r = 0; r < rings; ++r) {
            for (unsigned s = 0; s < sectors; ++s) {
                const unsigned a = r * sectors + s, b = r * sectors + (s + 1) % sectors;
                if (r > 0) mesh.triangles.emplace_back(a, b, b + sectors);
                if (r + 1 < rings) mesh.triangles.emplace_back(a, b + sectors, a + sectors);
            }
        }
        return add_part(std::move(mesh), material);
    }

    std::uint32_t add_part(world::Mesh mesh, const world::Material& material) {
        level.materials.push_back(material);
        mesh.materials.assign(mesh.triangles.size(), static_cast<std::uint32_t>(level.materials.size() - 1));
        level.meshes.push_back(std::move(mesh));
        world::Part part;
        part.mesh = static_cast<std::uint32_t>(level.meshes.size() - 1);
        part.layers = world::kEverything;
        level.parts.push_back(part);
        return static_cast<std::uint32_t>(level.parts.size() - 1);
    }

    void add_lamp(const world::Lamp& lamp) { level.lamps.push_back(lamp); }

    // Places every part, finds the bounds, prepares. Ambient light only when asked for.
    void open(const render::PrepareSettings& settings = {.bakes_ambient = false},
              const Jobs& jobs = Jobs(1)) {
        world::mark_clear_parts(level);
        rc::SceneBuilder builder;
        for (const world::Part& part : level.parts) {
            const world::Mesh& mesh = level.meshes[part.mesh];
            builder.add({.blas = rc::build_blas({mesh.positions, mesh.triangles}),
                         .world_from_instance = part.mover_from_part,
                         .layers = part.layers});
        }
        snapshot.scene = builder.commit();
        snapshot.state = {};
        snapshot.state.group_on.fill(1);
        level.bounds = {snapshot.scene->bounds().min, snapshot.scene->bounds().max};
        prepared = render::prepare(level, snapshot, jobs, settings);
    }

    [[nodiscard]] Image picture(const render::Camera& camera, int width, int height,
                                const render::WhittedSettings& settings, std::uint32_t frame = 0,
                                const Jobs& jobs = Jobs(1)) const {
        render::Film film(width, height);
        render::render_whitted({level, snapshot, prepared}, camera, settings, frame, jobs, film);
        return std::move(film.radiance);
    }

  private:
    static void append_sheet(world::Mesh& mesh, const glm::vec3& centre, const glm::vec3& u,
                             const glm::vec3& v) {
        const auto first = static_cast<std::uint32_t>(mesh.positions.size());
        for (const glm::vec2 corner :
             {glm::vec2(-1, -1), glm::vec2(1, -1), glm::vec2(1, 1), glm::vec2(-1, 1)}) {
            mesh.positions.push_back(centre + u * corner.x + v * corner.y);
            mesh.normals.push_back(glm::normalize(glm::cross(u, v)));
            mesh.uvs.emplace_back(0.5f + 0.5f * corner.x, 0.5f - 0.5f * corner.y);
        }
        mesh.triangles.emplace_back(first, first + 1, first + 2);
        mesh.triangles.emplace_back(first, first + 2, first + 3);
    }
};

// Every pixel by itself, everything followed to its end, nothing baked: what closed forms describe.
inline render::WhittedSettings exact() {
    return {.samples_per_pixel = 1,
            .max_depth = 24,
            .shadow_samples = 1,
            .ambient_samples = 0,
            .min_weight = 0.0f,
            .uses_ambient = false,
            .shares_samples = false};
}

// One pixel wide and nearly without perspective, looking along -z unless turned.
inline render::Camera narrow(const glm::vec3& position, float yaw = 0.0f, float pitch = 0.0f) {
    return {.position = position, .yaw = yaw, .pitch = pitch, .fov_y = 1e-3f};
}

inline constexpr float kDown = -1.5707963f;

}  // namespace gh::test
