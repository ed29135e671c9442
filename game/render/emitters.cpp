#include "render/emitters.h"

#include "base/det_math.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace gh::render {

namespace {

constexpr float kFlat = 1e-5f;         // cosines and lengths relative to the rectangle
constexpr float kRoundEnough = 0.35f;  // of the ball's surface: less would waste most looks

bool shines(const world::Material& material) {
    const glm::vec3& e = material.emission;
    return material.alpha_mode == world::AlphaMode::Opaque && (e.x > 0.0f || e.y > 0.0f || e.z > 0.0f);
}

struct Corners {
    std::array<glm::vec3, 3> at;
    glm::vec3 front{0.0f};  // twice the area along the side its normals point to
};

Corners corners_of(const world::Mesh& mesh, std::uint32_t primitive) {
    const glm::uvec3& index = mesh.triangles[primitive];
    Corners corners{{mesh.positions[index.x], mesh.positions[index.y], mesh.positions[index.z]}};
    corners.front = glm::cross(corners.at[1] - corners.at[0], corners.at[2] - corners.at[0]);
    if (!mesh.normals.empty()) {
        const glm::vec3 smooth = mesh.normals[index.x] + mesh.normals[index.y] + mesh.normals[index.z];
        if (glm::dot(smooth, corners.front) < 0.0f) corners.front = -corners.front;
    }
    return corners;
}

// Two triangles, all in one plane, facing one way, whose bounds in the frame of one's edges they fill.
bool fit_rect(const world::Mesh& mesh, Emitter& emitter) {
    if (emitter.primitives.size() != 2) return false;
    const Corners first = corners_of(mesh, emitter.primitives[0]);
    const Corners second = corners_of(mesh, emitter.primitives[1]);
    const float area = glm::length(first.front) + glm::length(second.front);
    const glm::vec3 normal = glm::normalize(first.front);
    if (!(glm::dot(normal, second.front) > (1.0f - kFlat) * glm::length(second.front))) return false;
    // Legs: the two edges that are most nearly at right angles.
    std::size_t right = 0;
    float least = 2.0f;
    for (std::size_t i = 0; i < 3; ++i) {
        const glm::vec3 a = glm::normalize(first.at[(i + 1) % 3] - first.at[i]);
        const glm::vec3 b = glm::normalize(first.at[(i + 2) % 3] - first.at[i]);
        if (const float cosine = std::abs(glm::dot(a, b)); cosine < least) {
            least = cosine;
            right = i;
        }
    }
    if (!(least < kFlat)) return false;
    const glm::vec3 u = glm::normalize(first.at[(right + 1) % 3] - first.at[right]);
    const glm::vec3 v = glm::cross(normal, u);
    const glm::vec3 from = first.at[right];
    glm::vec3 low(0.0f), high(0.0f);
    for (const Corners& corners : {first, second}) {
        for (const glm::vec3& p : corners.at) {
            const glm::vec3 at(glm::dot(p - from, u), glm::dot(p - from, v), glm::dot(p - from, normal));
            low = glm::min(low, at);
            high = glm::max(high, at);
        }
    }
    const glm::vec3 size = high - low;
    if (!(size.z <= kFlat * (size.x + size.y))) return false;
    if (!(std::abs(2.0f * size.x * size.y - area) <= 4.0f * kFlat * area)) return false;
    emitter.kind = EmitterKind::Rect;
    emitter.centre = from + u * (0.5f * (low.x + high.x)) + v * (0.5f * (low.y + high.y));
    emitter.half_u = u * (0.5f * size.x);
    emitter.half_v = v * (0.5f * size.y);
    return true;
}

void fit_ball(const world::Mesh& mesh, Emitter& emitter) {
    glm::vec3 low(rc::kInfinity), high(-rc::kInfinity);
    float area = 0.0f;
    for (const std::uint32_t primitive : emitter.primitives) {
        const Corners corners = corners_of(mesh, primitive);
        area += 0.5f * glm::length(corners.front);
        for (const glm::vec3& p : corners.at) {
            low = glm::min(low, p);
            high = glm::max(high, p);
        }
    }
    emitter.centre = 0.5f * (low + high);
    for (const std::uint32_t primitive : emitter.primitives) {
        for (const glm::vec3& p : corners_of(mesh, primitive).at)
            emitter.radius = std::max(emitter.radius, glm::distance(p, emitter.centre));
    }
    constexpr float kMargin = 1.0f + 0x1p-10f;
    emitter.radius *= kMargin;
    const float whole = 4.0f * kPi * emitter.radius * emitter.radius;
    // Seen from outside only: a backdrop that faces inwards, or rooms' worth of panes, are no bulb.
    const bool faces_out =
        std::all_of(emitter.primitives.begin(), emitter.primitives.end(), [&](std::uint32_t primitive) {
            const Corners corners = corners_of(mesh, primitive);
            return glm::dot(corners.front, corners.at[0] - emitter.centre) >= 0.0f;
        });
    if (emitter.primitives.size() > 4 && area > kRoundEnough * whole && faces_out)
        emitter.kind = EmitterKind::Bulb;
}

}  // namespace

std::vector<Emitter> find_emitters(const world::Level& level) {
    std::vector<std::uint8_t> material_shines(level.materials.size());
    for (std::size_t i = 0; i < level.materials.size(); ++i)
        material_shines[i] = shines(level.materials[i]) ? 1 : 0;
    std::vector<Emitter> emitters;
    for (std::uint32_t part = 0; part < level.parts.size(); ++part) {
        const world::Mesh& mesh = level.meshes[level.parts[part].mesh];
        Emitter emitter;
        emitter.part = part;
        bool is_plain = true;
        for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
            if (material_shines[mesh.materials[t]] == 0) continue;
            if (!(glm::length(corners_of(mesh, t).front) > 0.0f)) continue;
            const world::Material& material = level.materials[mesh.materials[t]];
            emitter.primitives.push_back(t);
            emitter.is_double_sided |= material.is_double_sided;
            is_plain = is_plain && material.emission_texture == world::kNoIndex &&
                       mesh.materials[t] == mesh.materials[emitter.primitives[0]];
        }
        if (emitter.primitives.empty()) continue;
        const bool is_rect = is_plain && mesh.joints.empty() && fit_rect(mesh, emitter);
        if (!is_rect && mesh.joints.empty()) fit_ball(mesh, emitter);
        emitters.push_back(std::move(emitter));
    }
    return emitters;
}

}  // namespace gh::render
