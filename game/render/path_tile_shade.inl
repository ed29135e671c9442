// The part of a tile that decides what becomes of a path where it meets something.
#include "render/clear_way.h"
#include "render/colour.h"
#include "render/environment.h"
#include "render/path_choices.h"
#include "render/path_tile.h"
#include "render/sane.h"
#include "render/sky.h"
#include "render/touching_glass.h"
#include "render/transmittance.h"

#include <glm/geometric.hpp>

#include <algorithm>

namespace gh::render {

namespace {

constexpr int kMostSplit = 8;  // borders of glass one behind the other that split the eye's path

}  // namespace

template <unsigned kFeatures>
void PathTile<kFeatures>::meet_nothing(const Path& path) {
    const glm::vec3& way = path.ray.direction;
    if (const Environment* environment = frame_.settings.environment) {
        add_met_light(path, environment->radiance(way), frame_.lights.environment_density(path.from, way));
        return;
    }
    add_met_light(path, sky_radiance(frame_.light.sun, way), 0.0f);
}

template <unsigned kFeatures>
void PathTile<kFeatures>::add_bare_lamps(const Path& path, float t_max) {
    // The eye does not see what has no surface.
    if (path.is_eye && path.depth == 0) return;
    frame_.lights.visit_bare(
        path.from, path.start, path.ray.direction, t_max,
        [&](const LightSet::BareHit& hit) { add_met_light(path, hit.light, hit.density); });
}

// Light that a path ran into, while a lamp might have been asked for it with `lamp_density`.
template <unsigned kFeatures>
void PathTile<kFeatures>::add_met_light(const Path& path, const glm::vec3& light, float lamp_density) {
    float share = 1.0f;
    const LampFinding finding = frame_.settings.lamps;
    if (path.density > 0.0f && lamp_density > 0.0f && finding != LampFinding::MeetOnly) {
        if (!path.has_bent) {
            share = finding == LampFinding::AskOnly ? 0.0f : counts(path.density, lamp_density);
        } else if (frame_.settings.caustics == Caustics::Unbent) {
            share = 0.0f;
        }
    }
    const Channel channel = path.is_first_leg && path.channel == Channel::Indirect && lamp_density > 0.0f
                                ? Channel::Direct
                                : path.channel;
    add(path.pixel, channel, path.weight * light * share, !path.is_eye && !path.is_first_leg, path.is_beside);
}

template <unsigned kFeatures>
void PathTile<kFeatures>::meet(Path path, const rc::Hit& hit, ShadingPoint& at, FrameStats& stats) {
    if (const world::Material* glass = path.media.top(); kHasClear && glass != nullptr) {
        const glm::vec3 left = sane_colour(absorbed(*glass, glm::distance(path.start, at.surface.position)));
        path.weight *= left;
        path.survival *= brightest(left);
    }
    if constexpr (kHasPlanes) note_reflection(path, glm::distance(path.start, at.surface.position));
    path.start = at.surface.position;
    if (kHasClear && passes_hole(path, at, stats)) return;
    add_emission(path, at, hit);
    if (path.is_rough && !(at.material->transmission > 0.0f))
        at.roughness = std::max(at.roughness, frame_.settings.least_indirect_roughness);

    const Crossing crossing = crossing_at(path, at);
    if (kHasClear && !crossing.is_seen) {
        path.media = crossing.beyond;
        go_straight_on(path, at, stats);
        return;
    }
    Bsdf bsdf(at, -path.ray.direction, crossing.border, frame_.view.prepared.energy);
    const bool is_main = path.is_eye && (bsdf.takes_lamps() || path.depth >= frame_.settings.max_depth);
    if (is_main) {
        if constexpr (kHasPlanes) note_surface(path, at, hit, bsdf);
        path.channel = path.is_leading ? Channel::Clean : Channel::Mirrored;
        path.is_beside = kHasPlanes && shows_another(path, at, bsdf);
    }
    Scatterer here{at, bsdf, crossing.beyond, crossing.gap, {}};
    if (path.depth >= frame_.settings.max_depth) return;
    if (frame_.settings.ends_in_bake && path.scatters >= frame_.settings.max_scatters && bsdf.takes_lamps()) {
        end_in_bake(path, here);
        return;
    }
    const bool splits = kHasClear && frame_.settings.splits_glass && path.is_eye && !bsdf.takes_lamps() &&
                        bsdf.probability(Lobe::Glass) == 1.0f && path.splits < kMostSplit;
    if (splits) {
        split(path, here, stats);
        return;
    }
    const bool asks = bsdf.takes_lamps() && frame_.settings.lamps != LampFinding::MeetOnly;
    if (frame_.settings.lights == LightPaths::Glossy) {
        add_baked_light(path, here);
        bsdf.follow_glossy_only();
    } else if (frame_.settings.seeks_gleams && bsdf.probability(Lobe::Diffuse) > 0.0f) {
        here.guide = frame_.lights.gleams_at({at.surface.position, at.normal});
    }
    if (asks) ask_lamp(path, here, false);
    send_on(path, here, pick_onward(path, here), stats);
}

// Cut-out and blended materials let some paths go on as if nothing was there.
template <unsigned kFeatures>
bool PathTile<kFeatures>::passes_hole(Path& path, const ShadingPoint& at, FrameStats& stats) {
    float covered = 1.0f;
    if (at.material->alpha_mode == world::AlphaMode::Mask)
        covered = at.alpha < at.material->alpha_cutoff ? 0.0f : 1.0f;
    if (at.material->alpha_mode == world::AlphaMode::Blend) covered = sane(at.alpha, 0.0f, 1.0f);
    if (covered == 1.0f) return false;
    if (one(path, kHolePurpose) < covered) return false;
    go_straight_on(path, at, stats);
    return true;
}

template <unsigned kFeatures>
void PathTile<kFeatures>::go_straight_on(Path& path, const ShadingPoint& at, FrameStats& stats) {
    if (path.passes >= kMostPasses) return;
    ++path.passes;
    path.ray = rc::spawn_ray(at.surface, path.ray.direction);
    ++stats.refracted_rays;
    next_.push_back(path);
}

template <unsigned kFeatures>
void PathTile<kFeatures>::add_emission(const Path& path, const ShadingPoint& at, const rc::Hit& hit) {
    if (frame_.light.emission_on[at.part] == 0) return;
    if (!at.is_entering && !at.material->is_double_sided) return;
    const glm::vec3 light = sane_light(at.emission);
    if (!(brightest(light) > 0.0f)) return;
    const float density = path.density > 0.0f
                              ? frame_.lights.density(path.from, at.part, hit.primitive, at.surface.position)
                              : 0.0f;
    add_met_light(path, light, density);
}

// What a path is in behind the surface, should it go through.
template <unsigned kFeatures>
auto PathTile<kFeatures>::crossing_at(const Path& path, const ShadingPoint& at) const -> Crossing {
    Crossing crossing{.beyond = path.media, .border = {}};
    if constexpr (kHasClear) {
        crossing.border = {.eta = sane(at.material->ior, 1.0f, 5.0f), .is_thin = true};
        if (!frame_.view.prepared.parts[at.part].is_solid_glass || !(at.material->transmission > 0.0f))
            return crossing;
        crossing.beyond.cross(at.part, *at.material, at.is_entering);
        if (frame_.view.prepared.needs.has(Need::NestedGlass)) {
            const Touches touches = touches_at(frame_.view, at, path.ray.direction);
            for (std::size_t i = 0; i < touches.count; ++i)
                crossing.beyond.cross(touches.other[i].part, *touches.other[i].glass,
                                      touches.other[i].enters);
            if (touches.count > 0) crossing.gap = 2.0f * touches.gap;
        }
        const Sides sides = sides_of(path.media, crossing.beyond, *at.material, at.is_entering);
        crossing.border = {.eta = sides.eta()};
        // Nor is a border without a colour between two glasses of one index.
        const bool is_matched = crossing.border.eta == 1.0f && at.base_color == glm::vec3(1.0f);
        crossing.is_seen = sides.is_border() && !is_matched;
    }
    return crossing;
}

}  // namespace gh::render
