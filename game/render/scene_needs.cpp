#include "render/scene_needs.h"

#include "render/material_textures.h"

#include "render/clear_mesh.h"

#include <glm/common.hpp>
#include <glm/vec4.hpp>

#include <algorithm>
#include <array>

namespace gh::render {

namespace {

constexpr std::size_t kManyLights = 16;    // as many as a list keeps the weights of
constexpr float kMirrorRoughness = 0.01f;  // as bsdf.cpp has it, squared

constexpr std::array<const char*, kNeeds> kNames{
    "textures",     "normal maps", "gloss",       "mirrors",   "holes", "thin glass", "solid glass",
    "nested glass", "rough glass", "absorption",  "varnish",   "cloth", "anisotropy", "emitters",
    "bare lamps",   "suns",        "many lights", "deforming", "moving"};

void add_material(const world::Material& m, SceneNeeds& needs) {
    needs.add(Need::Textures, textures_of(m).count > 0);
    needs.add(Need::NormalMaps, m.normal_texture != world::kNoIndex);
    const bool mirrors = m.metallic > 0.0f || (m.ior != 1.0f && m.specular > 0.0f);
    needs.add(Need::Gloss, mirrors);
    needs.add(Need::Mirrors, mirrors && m.roughness < kMirrorRoughness);
    needs.add(Need::Holes, m.alpha_mode != world::AlphaMode::Opaque);
    needs.add(Need::RoughGlass, m.transmission > 0.0f && m.roughness >= kMirrorRoughness);
    if (m.has_layers) {
        needs.add(Need::Varnish, m.layers.coat > 0.0f);
        needs.add(Need::Cloth, m.layers.sheen_color != glm::vec3(0.0f));
        needs.add(Need::Anisotropy, m.layers.anisotropy > 0.0f);
    }
}

// The box of a part's clear triangles, in the frame of what moves it.
struct Body {
    glm::vec3 low{rc::kInfinity}, high{-rc::kInfinity};
    world::Mover mover = world::Mover::None;
    std::uint32_t mover_index = 0;
};
Body body_of(const world::Level& level, const world::Part& part) {
    const world::Mesh& mesh = level.meshes[part.mesh];
    Body body;
    body.mover = part.mover;
    body.mover_index = part.mover_index;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        if (!(level.materials[mesh.materials[t]].transmission > 0.0f)) continue;
        for (glm::length_t c = 0; c < 3; ++c) {
            const glm::vec3 p = part.mover_from_part * glm::vec4(mesh.positions[mesh.triangles[t][c]], 1.0f);
            body.low = glm::min(body.low, p);
            body.high = glm::max(body.high, p);
        }
    }
    return body;
}

bool meet(const Body& a, const Body& b) {
    if (a.mover != b.mover || a.mover_index != b.mover_index) return false;
    for (glm::length_t axis = 0; axis < 3; ++axis) {
        if (!(a.low[axis] <= b.high[axis]) || !(b.low[axis] <= a.high[axis])) return false;
    }
    return true;
}

bool has_two_glasses(const world::Level& level, const world::Mesh& mesh) {
    std::uint32_t first = world::kNoIndex;
    for (const std::uint32_t id : mesh.materials) {
        if (!(level.materials[id].transmission > 0.0f)) continue;
        if (first == world::kNoIndex) first = id;
        if (id != first) return true;
    }
    return false;
}

// Whether two bodies of glass that stand still, or move together, share a place. What is carried into another one for a
// while is not looked for.
bool has_nested(const world::Level& level, const std::vector<std::uint8_t>& is_solid) {
    std::vector<Body> bodies;
    for (std::size_t i = 0; i < level.parts.size(); ++i) {
        if (is_solid[i] == 0) continue;
        if (has_two_glasses(level, level.meshes[level.parts[i].mesh])) return true;
        bodies.push_back(body_of(level, level.parts[i]));
    }
    std::sort(bodies.begin(), bodies.end(), [](const Body& a, const Body& b) { return a.low.x < b.low.x; });
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        for (std::size_t k = i + 1; k < bodies.size() && bodies[k].low.x <= bodies[i].high.x; ++k) {
            if (meet(bodies[i], bodies[k])) return true;
        }
    }
    return false;
}

void add_lights(const world::Level& level, std::size_t emissive_triangles, SceneNeeds& needs) {
    std::size_t bare = 0;
    for (const world::Lamp& lamp : level.lamps) {
        if (lamp.part != world::kNoIndex) continue;
        needs.add(lamp.shape == world::LampShape::Sun ? Need::Suns : Need::BareLamps);
        ++bare;
    }
    needs.add(Need::Emitters, emissive_triangles > 0);
    needs.add(Need::ManyLights, bare + emissive_triangles > kManyLights);
}

}  // namespace

SceneNeeds scene_needs(const world::Level& level, const std::vector<std::uint8_t>& is_solid) {
    SceneNeeds needs;
    std::vector<std::uint8_t> is_used(level.materials.size(), 0);
    std::size_t emissive = 0;
    for (std::size_t i = 0; i < level.parts.size(); ++i) {
        const world::Part& part = level.parts[i];
        const world::Mesh& mesh = level.meshes[part.mesh];
        needs.add(Need::Moving, part.mover != world::Mover::None);
        needs.add(Need::Deforming, !mesh.joints.empty());
        for (const std::uint32_t id : mesh.materials) {
            const world::Material& material = level.materials[id];
            is_used[id] = 1;
            emissive += material.emission != glm::vec3(0.0f) ? 1u : 0u;
            if (!(material.transmission > 0.0f)) continue;
            needs.add(is_solid[i] != 0 ? Need::SolidGlass : Need::Sheets);
            needs.add(Need::Absorption, is_solid[i] != 0 && material.attenuation_distance < rc::kInfinity);
        }
    }
    for (std::size_t m = 0; m < is_used.size(); ++m) {
        if (is_used[m] != 0) add_material(level.materials[m], needs);
    }
    needs.add(Need::NestedGlass, needs.has(Need::SolidGlass) && has_nested(level, is_solid));
    add_lights(level, emissive, needs);
    return needs;
}

SceneNeeds scene_needs(const world::Level& level) {
    std::vector<std::uint8_t> of_mesh(level.meshes.size());
    for (std::size_t m = 0; m < of_mesh.size(); ++m)
        of_mesh[m] = is_closed_glass(level, level.meshes[m]) ? 1 : 0;
    std::vector<std::uint8_t> of_part;
    for (const world::Part& part : level.parts) of_part.push_back(of_mesh[part.mesh]);
    return scene_needs(level, of_part);
}

std::string sentence_of(const SceneNeeds& needs) {
    std::string sentence;
    for (std::size_t i = 0; i < kNeeds; ++i) {
        if (!needs.has(static_cast<Need>(i))) continue;
        if (!sentence.empty()) sentence += ", ";
        sentence += kNames[i];
    }
    return sentence.empty() ? "nothing" : sentence;
}

}  // namespace gh::render
