#include "render/light_set.h"

#include "base/det_math.h"
#include "render/environment.h"
#include "render/light_math.h"
#include "render/sane.h"
#include "world/layers.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace gh::render {

namespace {

constexpr float kJustBefore =
    1.0f - 0x1p-16f;                        // of the way to a panel: rounding of its plane at a cosine of .01
constexpr float kAboutTriangle = 0x1p-10f;  // of the way to one, at a cosine of 1e-4
constexpr float kBallReach = 2.0f;  // radii: a sheared instance draws a ball out by less than the root of 3

}  // namespace

// Between which two distances a light lies whose own triangles are looked for; `distance`: to the place on it.
void LightSet::limit(const Light& light, float distance, LightSample& sample) {
    if (light.kind == Kind::Triangle) {
        sample.ray.t_max = distance * (1.0f - kAboutTriangle);
        sample.reach = distance * (1.0f + kAboutTriangle);
        return;
    }
    const float middle = glm::distance(light.ball.centre, sample.ray.origin);
    const float around = kBallReach * light.ball.radius;
    sample.ray.t_max = std::max(middle - around, 0.0f);
    sample.reach = middle + around;
}

std::optional<LightSample> LightSet::sample(const rc::SurfacePoint& point, const LightQuery& query,
                                            float u_light, const glm::vec2& u) const {
    const float far = far_share(query);
    if (u_light < far) return sample_far(point, query, u_light / far, u, far);
    const auto pick = pick_near(query, std::clamp((u_light - far) / (1.0f - far), 0.0f, 0x1.fffffep-1f));
    if (!pick) return std::nullopt;
    LightSample sample = sample_light(lights_[pick->light], point, u);
    sample.density *= pick->probability * (1.0f - far);
    if (!(sample.density > 0.0f)) return std::nullopt;
    return sample;
}

std::optional<LightSample> LightSet::sample_far(const rc::SurfacePoint& point, const LightQuery& query,
                                                float u_light, const glm::vec2& u, float share) const {
    const float total = far_weight(query);
    LightSample sample;
    float left = u_light * total - environment_weight();
    if (left < 0.0f) {
        const Environment::Pick pick = environment_->pick(u);
        sample.direction = pick.direction;
        sample.light = pick.radiance;
        sample.density = pick.density * share * environment_weight() / total;
        sample.ray = rc::spawn_ray(point, sample.direction);
        return sample.density > 0.0f ? std::optional(sample) : std::nullopt;
    }
    float weight = 0.0f;
    const world::Lamp* chosen = nullptr;
    for (const std::uint32_t sun : suns_) {
        const float own = sun_weight(sun, query);
        if (!(own > 0.0f)) continue;
        chosen = &view_.level.lamps[sun];
        weight = own;
        if (left < own) break;
        left -= own;
    }
    if (chosen == nullptr) return std::nullopt;
    sample.direction = -chosen->direction;
    sample.light = sane_light(chosen->intensity);
    sample.density = share * weight / total;
    sample.is_delta = true;
    sample.ray = rc::spawn_ray(point, sample.direction);
    return sample;
}

LightSample LightSet::sample_light(const Light& light, const rc::SurfacePoint& point,
                                   const glm::vec2& u) const {
    LightSample sample;
    if (light.kind == Kind::Point) {
        const world::Lamp& lamp = view_.level.lamps[light.lamp];
        sample.direction = direction_to(lamp, point.position);
        sample.light = sane_light(lamp_irradiance(lamp, point.position, sample.direction));
        if (!(mean(sample.light) > 0.0f)) return sample;
        sample.density = 1.0f;
        sample.is_delta = true;
        sample.ray = rc::spawn_ray_to(point, lamp.position);
        return sample;
    }
    ShapeSample shape;
    if (light.kind == Kind::Rect) {
        if (!light.is_double_sided &&
            !(glm::dot(light.rect.normal, point.position - light.rect.centre) > 0.0f))
            return sample;
        shape = pick(light.rect, point.position, u);
    } else if (light.kind == Kind::Ball) {
        shape = pick(light.ball, point.position, u);
    } else {
        shape = pick(light.triangle, point.position, u);
    }
    if (!(shape.density > 0.0f)) return sample;
    sample.direction = shape.direction;
    sample.density = shape.density;
    sample.part = light.part;
    if (light.lamp != world::kNoIndex) {
        sample.light = light.radiance;
        sample.ray = rc::spawn_ray(point, shape.direction, shape.distance);
    } else {
        sample.ray = rc::spawn_ray(point, shape.direction);
        // From where the ray really starts: parallel to it, a ray passes by some of what is small (.2 % of triangles of
        // 4 mm, from a floor of 20 m), and nobody else's ray finds it instead.
        const glm::vec3 way = point.position + shape.direction * shape.distance - sample.ray.origin;
        sample.ray.direction = glm::normalize(way);
        if (light.kind == Kind::Rect) {
            // A flat panel of one colour is not in its own way: whether anything is before it answers at half the cost of
            // what the ray meets first.
            sample.light = light.radiance;
            sample.ray.t_max = glm::length(way) * kJustBefore;
            return sample;
        }
        sample.target_part = light.part;
        sample.target_primitive = light.primitive;
        limit(light, glm::length(way), sample);
    }
    return sample;
}

float LightSet::density_of(const Light& light, const glm::vec3& from, const glm::vec3& at) const {
    switch (light.kind) {
        case Kind::Point:
            return 0.0f;
        case Kind::Rect:
            return render::density(light.rect, from, at);
        case Kind::Ball:
            return render::density(light.ball, from);
        case Kind::Triangle:
            return render::density(light.triangle, from, at);
    }
    return 0.0f;
}

float LightSet::density(const LightQuery& query, std::uint32_t part, std::uint32_t primitive,
                        const glm::vec3& position) const {
    const Emitter* emitter = emitter_of_part_[part];
    if (emitter == nullptr) return 0.0f;
    const auto place = std::lower_bound(emitter->primitives.begin(), emitter->primitives.end(), primitive);
    if (place == emitter->primitives.end() || *place != primitive) return 0.0f;
    std::uint32_t light = first_of_part_[part];
    if (lights_[light].kind == Kind::Triangle)
        light += static_cast<std::uint32_t>(place - emitter->primitives.begin());
    const float picked = near_probability(query, light) * (1.0f - far_share(query));
    return picked > 0.0f ? picked * density_of(lights_[light], query.position, position) : 0.0f;
}

glm::vec3 LightSet::emission_at(const rc::Hit& hit, const glm::vec3& direction) const {
    if (emitter_of_part_[hit.instance] == nullptr) return glm::vec3(0.0f);
    const world::Mesh& mesh = view_.level.meshes[view_.level.parts[hit.instance].mesh];
    const world::Material& material = view_.level.materials[mesh.materials[hit.primitive]];
    if (!material.is_double_sided) {
        glm::vec3 front = view_.snapshot.scene->surface(hit).normal;
        const auto& posed = view_.snapshot.posed;
        const bool is_posed = hit.instance < posed.size() && posed[hit.instance] != nullptr;
        const std::vector<glm::vec3>& normals = is_posed ? posed[hit.instance]->normals : mesh.normals;
        if (!normals.empty()) {
            const glm::uvec3& index = mesh.triangles[hit.primitive];
            const glm::mat3 linear =
                linear_part(view_.snapshot.scene->instance(hit.instance).world_from_instance);
            const glm::vec3 smooth =
                cofactors(linear) * (normals[index.x] + normals[index.y] + normals[index.z]);
            if (glm::dot(smooth, front) < 0.0f) front = -front;
        }
        if (!(glm::dot(front, direction) < 0.0f)) return glm::vec3(0.0f);
    }
    glm::vec3 emission = sane_light(material.emission);
    if (material.emission_texture != world::kNoIndex && !mesh.uvs.empty()) {
        const glm::uvec3& index = mesh.triangles[hit.primitive];
        glm::vec2 uv = mesh.uvs[index.x] * (1.0f - hit.u - hit.v) + mesh.uvs[index.y] * hit.u +
                       mesh.uvs[index.z] * hit.v;
        if (!material.uv_transforms.empty())
            uv = material.uv_transforms[static_cast<std::size_t>(world::TextureSlot::Emission)] *
                 glm::vec3(uv, 1.0f);
        emission *= glm::vec3(view_.prepared.textures[material.emission_texture].at(uv));
    }
    return emission;
}

std::optional<LightSet::BareHit> LightSet::bare_hit(std::uint32_t id, const LightQuery& query,
                                                    const glm::vec3& from, const glm::vec3& direction,
                                                    float t_max) const {
    const Light& light = lights_[id];
    const float t = light.kind == Kind::Rect ? distance_to(light.rect, from, direction)
                                             : distance_to(light.ball, from, direction);
    if (!(t > 0.0f) || !(t <= t_max)) return std::nullopt;
    if (light.kind == Kind::Rect && !(glm::dot(light.rect.normal, direction) < 0.0f)) return std::nullopt;
    const float picked = near_probability(query, id) * (1.0f - far_share(query));
    return BareHit{light.radiance,
                   picked > 0.0f ? picked * density_of(light, query.position, from + direction * t) : 0.0f};
}

}  // namespace gh::render
