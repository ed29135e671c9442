#include "render/light_set.h"

#include "base/det_math.h"
#include "render/environment.h"
#include "render/sane.h"
#include "world/layers.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

#include <algorithm>
#include <cmath>

namespace gh::render {

namespace {

float mean(const glm::vec3& c) {
    return (c.x + c.y + c.z) / 3.0f;
}

glm::mat3 linear_part(const glm::mat4x3& m) {
    return glm::mat3(m[0], m[1], m[2]);
}

glm::mat3 cofactors(const glm::mat3& m) {
    const glm::mat3 c(glm::cross(m[1], m[2]), glm::cross(m[2], m[0]), glm::cross(m[0], m[1]));
    return glm::dot(m[0], c[0]) < 0.0f ? -c : c;
}

LightBounds point_bounds(const glm::vec3& position, float power) {
    LightBounds bounds;
    bounds.min = bounds.max = position;
    bounds.power = power;
    return bounds;
}

LightBounds ball_bounds(const BallShape& ball, float power) {
    LightBounds bounds;
    bounds.min = ball.centre - glm::vec3(ball.radius);
    bounds.max = ball.centre + glm::vec3(ball.radius);
    bounds.power = power;
    return bounds;
}

LightBounds rect_bounds(const RectShape& rect, float power, bool is_double_sided) {
    const glm::vec3 reach = glm::abs(rect.half_u) + glm::abs(rect.half_v);
    LightBounds bounds;
    bounds.min = rect.centre - reach;
    bounds.max = rect.centre + reach;
    bounds.axis = rect.normal;
    bounds.cos_normals = is_double_sided ? -1.0f : 1.0f;
    bounds.power = power;
    return bounds;
}

constexpr float kListedShare = 0.85f;  // of picks, where the lists know of lamps
constexpr float kLeastCosine = 0.05f;

}  // namespace

LightSet::LightSet(const SceneView& view, const FrameLight& frame, const Environment* environment)
    : view_(view), environment_(environment) {
    std::vector<LightBounds> bounds;
    light_of_lamp_.assign(view.level.lamps.size(), world::kNoIndex);
    add_lamps(frame, bounds);
    first_of_part_.assign(view.level.parts.size(), world::kNoIndex);
    emitter_of_part_.assign(view.level.parts.size(), nullptr);
    for (const Emitter& emitter : view.prepared.emitters) {
        if (frame.emission_on[emitter.part] == 0) continue;
        if ((view.snapshot.scene->instance(emitter.part).layers & world::Light) == 0) continue;
        emitter_of_part_[emitter.part] = &emitter;
        first_of_part_[emitter.part] = static_cast<std::uint32_t>(lights_.size());
        add_emitter(emitter, bounds);
        const std::uint32_t lamp = view.prepared.parts[emitter.part].lamp,
                            light = first_of_part_[emitter.part];
        if (lamp != world::kNoIndex && lights_[light].kind != Kind::Triangle) note_listed(lamp, light);
    }
    for (std::size_t i = 0; i < lights_.size(); ++i) lights_[i].power = bounds[i].power;
    tree_ = LightTree(bounds);
}

void LightSet::add_lamps(const FrameLight& frame, std::vector<LightBounds>& bounds) {
    for (std::uint32_t i = 0; i < view_.level.lamps.size(); ++i) {
        const world::Lamp& lamp = view_.level.lamps[i];
        if (frame.lamp_on[i] == 0 || lamp.part != world::kNoIndex) continue;
        Light light;
        light.lamp = i;
        light.radiance = sane_light(lamp.intensity);
        const float power = mean(light.radiance);
        const auto id = static_cast<std::uint32_t>(lights_.size());
        switch (lamp.shape) {
            case world::LampShape::Sun:
                if (power > 0.0f) suns_.push_back(i);
                continue;
            case world::LampShape::Point:
                bounds.push_back(point_bounds(lamp.position, power));
                break;
            case world::LampShape::Spot:
                bounds.push_back(point_bounds(lamp.position, power));
                bounds.back().axis = lamp.direction;
                bounds.back().cos_normals = 1.0f;
                bounds.back().cos_emission = lamp.cos_outer;
                break;
            case world::LampShape::Sphere:
                light.kind = Kind::Ball;
                light.ball = {lamp.position, lamp.radius};
                bounds.push_back(ball_bounds(light.ball, power * kPi * lamp.radius * lamp.radius));
                bare_.push_back(id);
                break;
            case world::LampShape::Rect:
                light.kind = Kind::Rect;
                light.rect = {lamp.position, lamp.half_u, lamp.half_v, lamp.direction};
                bounds.push_back(rect_bounds(
                    light.rect, power * 4.0f * glm::length(lamp.half_u) * glm::length(lamp.half_v), false));
                bare_.push_back(id);
                break;
        }
        lights_.push_back(light);
        note_listed(i, id);
    }
}

void LightSet::note_listed(std::uint32_t lamp, std::uint32_t light) {
    light_of_lamp_[lamp] = light;
    lights_[light].listed_as = lamp;
}

void LightSet::add_emitter(const Emitter& emitter, std::vector<LightBounds>& bounds) {
    const glm::mat4x3& to_world = view_.snapshot.scene->instance(emitter.part).world_from_instance;
    const glm::mat3 linear = linear_part(to_world);
    const world::Mesh& mesh = view_.level.meshes[view_.level.parts[emitter.part].mesh];
    const auto& first = view_.level.materials[mesh.materials[emitter.primitives[0]]];
    Light light;
    light.part = emitter.part;
    light.is_double_sided = emitter.is_double_sided;
    const float radiance = mean(sane_light(first.emission));
    if (emitter.kind == EmitterKind::Rect) {
        const glm::vec3 u = linear * emitter.half_u, v = linear * emitter.half_v;
        const glm::vec3 normal = cofactors(linear) * glm::cross(emitter.half_u, emitter.half_v);
        const float area = glm::length(u) * glm::length(v);
        // A sheared instance makes it a parallelogram.
        if (std::abs(glm::dot(u, v)) <= 1e-5f * area && glm::dot(normal, normal) > 0.0f) {
            light.kind = Kind::Rect;
            light.rect = {to_world * glm::vec4(emitter.centre, 1.0f), u, v, glm::normalize(normal)};
            bounds.push_back(rect_bounds(light.rect, radiance * 4.0f * area, emitter.is_double_sided));
            lights_.push_back(light);
            return;
        }
    }
    if (emitter.kind == EmitterKind::Bulb) {
        light.kind = Kind::Ball;
        const float scale2 = std::max(
            {glm::dot(linear[0], linear[0]), glm::dot(linear[1], linear[1]), glm::dot(linear[2], linear[2])});
        light.ball = {to_world * glm::vec4(emitter.centre, 1.0f), emitter.radius * std::sqrt(scale2)};
        bounds.push_back(ball_bounds(light.ball, radiance * kPi * light.ball.radius * light.ball.radius));
        lights_.push_back(light);
        return;
    }
    for (const std::uint32_t primitive : emitter.primitives) add_triangle(emitter, primitive, bounds);
}

void LightSet::add_triangle(const Emitter& emitter, std::uint32_t primitive,
                            std::vector<LightBounds>& bounds) {
    const rc::Scene& scene = *view_.snapshot.scene;
    const glm::mat4x3& to_world = scene.instance(emitter.part).world_from_instance;
    const world::Mesh& mesh = view_.level.meshes[view_.level.parts[emitter.part].mesh];
    const world::Material& material = view_.level.materials[mesh.materials[primitive]];
    Light light;
    light.kind = Kind::Triangle;
    light.part = emitter.part;
    light.primitive = primitive;
    light.is_double_sided = material.is_double_sided;
    const std::array<glm::vec3, 3> local = scene.triangle(emitter.part, primitive);
    for (std::size_t i = 0; i < 3; ++i) light.triangle.corner[i] = to_world * glm::vec4(local[i], 1.0f);
    const auto& corner = light.triangle.corner;
    glm::vec3 normal = glm::cross(corner[1] - corner[0], corner[2] - corner[0]);
    const float length = glm::length(normal);
    LightBounds own;
    own.min = glm::min(corner[0], glm::min(corner[1], corner[2]));
    own.max = glm::max(corner[0], glm::max(corner[1], corner[2]));
    own.power =
        length > 0.0f && length < rc::kInfinity ? mean(sane_light(material.emission)) * 0.5f * length : 0.0f;
    if (own.power > 0.0f && !light.is_double_sided) {
        const glm::uvec3& index = mesh.triangles[primitive];
        const auto& posed = view_.snapshot.posed;
        const bool is_posed = emitter.part < posed.size() && posed[emitter.part] != nullptr;
        const std::vector<glm::vec3>& normals = is_posed ? posed[emitter.part]->normals : mesh.normals;
        if (!normals.empty()) {
            const glm::vec3 smooth =
                cofactors(linear_part(to_world)) * (normals[index.x] + normals[index.y] + normals[index.z]);
            if (glm::dot(smooth, normal) < 0.0f) normal = -normal;
        }
        own.axis = normal / length;
        own.cos_normals = 1.0f;
    }
    bounds.push_back(own);
    lights_.push_back(light);
}

float LightSet::sun_weight(std::uint32_t sun, const LightQuery& query) const {
    const world::Lamp& lamp = view_.level.lamps[sun];
    const float cosine = query.normal == glm::vec3(0.0f) ? 1.0f : -glm::dot(query.normal, lamp.direction);
    return mean(sane_light(lamp.intensity)) * std::max(0.0f, cosine);
}

float LightSet::environment_weight() const {
    return environment_ != nullptr ? kPi * environment_->mean_radiance() : 0.0f;
}

float LightSet::far_weight(const LightQuery& query) const {
    float weight = environment_weight();
    for (const std::uint32_t sun : suns_) weight += sun_weight(sun, query);
    return weight;
}

// How often what is far is picked rather than anything near: by what both may give, but neither is ever forgotten.
float LightSet::far_share(const LightQuery& query) const {
    const float far = far_weight(query);
    if (!(far > 0.0f)) return 0.0f;
    const float near = tree_.importance(query);
    if (!(near > 0.0f)) return 1.0f;
    return std::clamp(far / (far + near), 0.1f, 0.9f);
}

float LightSet::environment_density(const LightQuery& query, const glm::vec3& direction) const {
    const float own = environment_weight();
    if (!(own > 0.0f)) return 0.0f;
    return environment_->density(direction) * far_share(query) * own / far_weight(query);
}

float LightSet::listed_weight(std::uint32_t lamp, const LightQuery& query) const {
    const std::uint32_t id = light_of_lamp_[lamp];
    if (id == world::kNoIndex) return 0.0f;
    const Light& light = lights_[id];
    const glm::vec3 centre = light.kind == Kind::Rect   ? light.rect.centre
                             : light.kind == Kind::Ball ? light.ball.centre
                                                        : view_.level.lamps[lamp].position;
    const float extent = light.kind == Kind::Rect
                             ? glm::length(light.rect.half_u) + glm::length(light.rect.half_v)
                             : light.ball.radius;
    const glm::vec3 offset = centre - query.position;
    const float distance2 = glm::dot(offset, offset);
    const float distance = std::sqrt(distance2);
    float share = 1.0f;
    if (query.normal != glm::vec3(0.0f)) {
        const float height = glm::dot(query.normal, offset) + extent;
        if (!(height > 0.0f)) return 0.0f;
        share = distance > 0.0f ? std::clamp(height / distance, kLeastCosine, 1.0f) : 1.0f;
    }
    if (light.kind == Kind::Point) {
        const world::Lamp& own = view_.level.lamps[lamp];
        return share *
               mean(sane_light(lamp_irradiance(own, query.position, direction_to(own, query.position))));
    }
    if (light.kind == Kind::Rect) {
        const float facing = -glm::dot(light.rect.normal, offset);
        if (!light.is_double_sided && !(facing > 0.0f)) return 0.0f;
        share *= distance > 0.0f ? std::clamp(std::abs(facing) / distance, kLeastCosine, 1.0f) : 1.0f;
    }
    return light.power * share / std::max(distance2, extent * extent);
}

LightSet::Listed LightSet::listed_at(const LightQuery& query) const {
    Listed listed;
    std::size_t count = 0;
    for (const std::uint32_t lamp : view_.prepared.lamp_lists.at(query.position)) {
        listed.weight += listed_weight(lamp, query);
        count += light_of_lamp_[lamp] != world::kNoIndex;
    }
    if (listed.weight > 0.0f) listed.share = count == lights_.size() ? 1.0f : kListedShare;
    return listed;
}

bool LightSet::is_listed(const Light& light, const LightQuery& query) const {
    if (light.listed_as == world::kNoIndex) return false;
    const auto list = view_.prepared.lamp_lists.at(query.position);
    return std::binary_search(list.begin(), list.end(), light.listed_as);
}

// The lists' lamps by the lists only, all others by the tree only: one way to each, whose probability is known at once.
std::optional<LightTree::Pick> LightSet::pick_near(const LightQuery& query, float u) const {
    const Listed listed = listed_at(query);
    if (u < listed.share) {
        float left = u / listed.share * listed.weight, weight = 0.0f;
        std::uint32_t chosen = world::kNoIndex;
        for (const std::uint32_t lamp : view_.prepared.lamp_lists.at(query.position)) {
            const float own = listed_weight(lamp, query);
            if (!(own > 0.0f)) continue;
            chosen = light_of_lamp_[lamp];
            weight = own;
            if (left < own) break;
            left -= own;
        }
        return LightTree::Pick{chosen, listed.share * weight / listed.weight};
    }
    const LightTree::Pick pick =
        tree_.pick(query, std::clamp((u - listed.share) / (1.0f - listed.share), 0.0f, 0x1.fffffep-1f));
    if (!(pick.probability > 0.0f) || is_listed(lights_[pick.light], query)) return std::nullopt;
    return LightTree::Pick{pick.light, pick.probability * (1.0f - listed.share)};
}

float LightSet::near_probability(const LightQuery& query, std::uint32_t light) const {
    const Listed listed = listed_at(query);
    if (is_listed(lights_[light], query)) {
        const float own = listed_weight(lights_[light].listed_as, query);
        return own > 0.0f ? listed.share * own / listed.weight : 0.0f;
    }
    return listed.share < 1.0f ? (1.0f - listed.share) * tree_.probability(query, light) : 0.0f;
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
    if (light.lamp != world::kNoIndex) {
        sample.light = light.radiance;
        sample.ray = rc::spawn_ray(point, shape.direction, shape.distance);
    } else {
        sample.ray = rc::spawn_ray(point, shape.direction);
        sample.target_part = light.part;
        sample.target_primitive = light.primitive;
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
        const glm::vec2 uv = mesh.uvs[index.x] * (1.0f - hit.u - hit.v) + mesh.uvs[index.y] * hit.u +
                             mesh.uvs[index.z] * hit.v;
        emission *= glm::vec3(view_.prepared.textures[material.emission_texture].sample(uv, {}));
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
