// The part of a light set that gathers what shines in a frame.
#include "base/det_math.h"
#include "render/environment.h"
#include "render/light_math.h"
#include "render/light_set.h"
#include "render/sane.h"
#include "world/layers.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace gh::render {

namespace {

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

}  // namespace

LightSet::LightSet(const SceneView& view, const FrameLight& frame, const Environment* environment,
                   std::shared_ptr<const KeptLightTree>& kept)
    : view_(view),
      environment_(environment),
      is_beam_(view.level.lamps.size(), 0),
      lamp_weights_(view.level.lamps.size()) {
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
    weigh_lamps();
    tree_ = kept = light_tree_of(std::move(bounds), std::move(kept));
    for (const Gleam& gleam : view.prepared.gleams.gleams) {
        const bool is_on = gleam.part != world::kNoIndex ? emitter_of_part_[gleam.part] != nullptr
                                                         : frame.lamp_on[gleam.lamp] != 0;
        gleam_on_.push_back(is_on ? 1 : 0);
    }
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

// What lamps that are picked by list may give.
void LightSet::weigh_lamps() {
    using Shines = LampWeights::Shines;
    for (const Light& light : lights_) {
        if (light.listed_as == world::kNoIndex) continue;
        LampWeights::Lamp lamp{.power = light.power};
        if (light.kind == Kind::Rect) {
            lamp.centre = light.rect.centre;
            lamp.axis = light.rect.normal;
            lamp.extent = glm::length(light.rect.half_u) + glm::length(light.rect.half_v);
            lamp.shines = light.is_double_sided ? Shines::Both : Shines::Front;
        } else if (light.kind == Kind::Ball) {
            lamp.centre = light.ball.centre;
            lamp.extent = light.ball.radius;
        } else {
            const world::Lamp& own = view_.level.lamps[light.listed_as];
            lamp.centre = own.position;
            lamp.axis = own.direction;
            if (own.shape == world::LampShape::Spot) lamp.cos_outer = own.cos_outer;
            lamp.power = 1.0f;
            lamp.shines = Shines::Beam;
            is_beam_[light.listed_as] = 1;
        }
        lamp_weights_.set(light.listed_as, lamp);
    }
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
            light.radiance = sane_light(first.emission);
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

}  // namespace gh::render
