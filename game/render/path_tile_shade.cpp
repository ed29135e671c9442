// The part of a tile that decides what becomes of a path where it meets something.
#include "render/clear_way.h"
#include "render/environment.h"
#include "render/path_tile.h"
#include "render/sane.h"
#include "render/sky.h"
#include "render/transmittance.h"

#include <glm/geometric.hpp>

#include <algorithm>

namespace gh::render {

namespace {

constexpr std::uint8_t kMostPasses = 32;
constexpr int kRouletteDepth = 2;      // paths shorter than that go on whatever they carry
constexpr float kIndirectTaps = 1.0f;  // of textures, where they are seen by scattered light
constexpr int kMostSplit = 4;          // panes one behind the other that split the eye's path
constexpr float kRoughAlpha = 0.1f;    // gloss that scatters so widely is rough
constexpr float kGleamShare = 0.35f;   // of diffuse paths, where gleams are seen

enum Purpose : std::uint32_t {
    kLobePurpose,
    kDirectionPurpose,
    kLampPurpose,
    kOnLampPurpose,
    kRoulettePurpose,
    kHolePurpose,
    kGleamPurpose,
    kWhichGleamPurpose
};

float brightest(const glm::vec3& c) {
    return std::max({c.x, c.y, c.z});
}

// The power heuristic: what a find by the way of density `own` counts when another one might have found it too.
float counts(float own, float other) {
    if (!(other > 0.0f)) return 1.0f;
    const float ratio = other / own;
    return 1.0f / (1.0f + ratio * ratio);
}

// Of the diffuse lobe together with what seeks gleams, times the probability of picking it; `own` is the lobe's alone.
float guided_density(const Bsdf& bsdf, const GleamGuide& guide, float own, const glm::vec3& direction) {
    return own * (1.0f - kGleamShare) +
           kGleamShare * bsdf.probability(Lobe::Diffuse) * guide.density(direction);
}

}  // namespace

void PathTile::meet_nothing(const Path& path) {
    const glm::vec3& way = path.ray.direction;
    if (const Environment* environment = frame_.settings.environment) {
        add_met_light(path, environment->radiance(way), frame_.lights.environment_density(path.from, way));
        return;
    }
    add_met_light(path, sky_radiance(frame_.light.sun, way), 0.0f);
}

void PathTile::add_bare_lamps(const Path& path, float t_max) {
    // The eye does not see what has no surface.
    if (path.is_eye && path.depth == 0) return;
    frame_.lights.visit_bare(
        path.from, path.start, path.ray.direction, t_max,
        [&](const LightSet::BareHit& hit) { add_met_light(path, hit.light, hit.density); });
}

// Light that a path ran into, while a lamp might have been asked for it with `lamp_density`.
void PathTile::add_met_light(const Path& path, const glm::vec3& light, float lamp_density) {
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
    add(path.pixel, channel, path.weight * light * share, !path.is_eye && !path.is_first_leg);
}

void PathTile::meet(Path path, const rc::Hit& hit, FrameStats& stats) {
    path.cone_width += path.cone_angle * hit.t;
    const float taps =
        path.is_eye ? frame_.settings.texture_taps : std::min(kIndirectTaps, frame_.settings.texture_taps);
    ShadingPoint at = shading_point(frame_.view, path.ray, hit, path.cone_width, taps);
    if (const world::Material* glass = path.media.top(); glass != nullptr) {
        const glm::vec3 left = sane_colour(absorbed(*glass, glm::distance(path.start, at.surface.position)));
        path.weight *= left;
        path.survival *= brightest(left);
    }
    note_reflection(path, glm::distance(path.start, at.surface.position));
    path.start = at.surface.position;
    if (passes_hole(path, at, stats)) return;
    add_emission(path, at, hit);
    if (path.is_rough && !(at.material->transmission > 0.0f))
        at.roughness = std::max(at.roughness, frame_.settings.least_indirect_roughness);

    const Bsdf bsdf(at, -path.ray.direction, border_at(path, at), frame_.view.prepared.energy);
    const bool is_main = path.is_eye && (bsdf.takes_lamps() || path.depth >= frame_.settings.max_depth);
    if (is_main) {
        note_surface(path, at, hit, bsdf);
        path.channel = path.is_leading ? Channel::Clean : Channel::Specular;
    }
    if (path.depth >= frame_.settings.max_depth) return;
    const bool splits = frame_.settings.splits_glass && path.is_eye && !bsdf.takes_lamps() &&
                        bsdf.probability(Lobe::Glass) == 1.0f && path.depth + path.passes < kMostSplit;
    if (splits) {
        split(path, at, bsdf, stats);
        return;
    }
    const bool asks = bsdf.takes_lamps() && frame_.settings.lamps != LampFinding::MeetOnly;
    Scatterer here{at, bsdf, {}};
    if (frame_.settings.seeks_gleams && bsdf.probability(Lobe::Diffuse) > 0.0f)
        here.guide = frame_.lights.gleams_at({at.surface.position, at.normal});
    if (asks) ask_lamp(path, here);
    send_on(path, at, pick_onward(path, here), bsdf, stats);
}

// Where the surface sends the path by itself, or now and then towards a gleam: one density for both together.
PathTile::Onward PathTile::pick_onward(const Path& path, const Scatterer& here) const {
    const float u_lobe = sequence(path).one(path.sample, dimension(path, kLobePurpose));
    const glm::vec2 u = sequence(path).two(path.sample, dimension(path, kDirectionPurpose));
    Onward onward{here.bsdf.sample(u_lobe, u)};
    onward.survival = brightest(onward.weight);
    if (here.guide.empty() || onward.lobe != Lobe::Diffuse) return onward;
    if (sequence(path).one(path.sample, dimension(path, kGleamPurpose)) < kGleamShare) {
        const float u_gleam = sequence(path).one(path.sample, dimension(path, kWhichGleamPurpose));
        onward.direction = here.guide.pick(u_gleam, u);
    }
    const LobeValue value = here.bsdf.value(Lobe::Diffuse, onward.direction);
    onward.density = guided_density(here.bsdf, here.guide, value.density, onward.direction);
    onward.weight = value.density > 0.0f ? value.value / onward.density : glm::vec3(0.0f);
    onward.survival = value.density > 0.0f ? brightest(value.value / value.density) : 0.0f;
    return onward;
}

// Cut-out and blended materials let some paths go on as if nothing was there.
bool PathTile::passes_hole(Path& path, const ShadingPoint& at, FrameStats& stats) {
    float covered = 1.0f;
    if (at.material->alpha_mode == world::AlphaMode::Mask)
        covered = at.alpha < at.material->alpha_cutoff ? 0.0f : 1.0f;
    if (at.material->alpha_mode == world::AlphaMode::Blend) covered = sane(at.alpha, 0.0f, 1.0f);
    if (covered == 1.0f) return false;
    if (sequence(path).one(path.sample, dimension(path, kHolePurpose)) < covered) return false;
    if (path.passes >= kMostPasses) return true;
    ++path.passes;
    path.ray = rc::spawn_ray(at.surface, path.ray.direction);
    ++stats.refracted_rays;
    next_.push_back(path);
    return true;
}

void PathTile::add_emission(const Path& path, const ShadingPoint& at, const rc::Hit& hit) {
    if (frame_.light.emission_on[at.part] == 0) return;
    if (!at.is_entering && !at.material->is_double_sided) return;
    const glm::vec3 light = sane_light(at.emission);
    if (!(brightest(light) > 0.0f)) return;
    const float density = path.density > 0.0f
                              ? frame_.lights.density(path.from, at.part, hit.primitive, at.surface.position)
                              : 0.0f;
    add_met_light(path, light, density);
}

Border PathTile::border_at(const Path& path, const ShadingPoint& at) const {
    const float own = sane(at.material->ior, 1.0f, 5.0f);
    if (!frame_.view.prepared.parts[at.part].is_solid_glass) return {.eta = own, .is_thin = true};
    if (at.is_entering) return {.eta = own / sane(path.media.ior(), 1.0f, 5.0f)};
    MediumStack beyond = path.media;
    beyond.leave(at.part);
    return {.eta = sane(beyond.ior(), 1.0f, 5.0f) / own};
}

void PathTile::ask_lamp(const Path& path, const Scatterer& here) {
    const ShadingPoint& at = here.at;
    const Bsdf& bsdf = here.bsdf;
    const LightQuery query{at.surface.position, bsdf.is_clear() ? glm::vec3(0.0f) : at.normal};
    const auto light = frame_.lights.sample(at.surface, query,
                                            sequence(path).one(path.sample, dimension(path, kLampPurpose)),
                                            sequence(path).two(path.sample, dimension(path, kOnLampPurpose)));
    if (!light) return;
    BsdfValue value = bsdf.value(light->direction);
    LobeValue& base = value[static_cast<std::size_t>(Lobe::Diffuse)];
    if (!here.guide.empty() && base.density > 0.0f)
        base.density = guided_density(bsdf, here.guide, base.density, light->direction);
    glm::vec3 diffuse(0.0f), gloss(0.0f);
    for (std::size_t i = 0; i < kLobes; ++i) {
        const bool is_alone = light->is_delta || frame_.settings.lamps == LampFinding::AskOnly;
        const float share = is_alone ? 1.0f : counts(light->density, value[i].density);
        (static_cast<Lobe>(i) == Lobe::Diffuse ? diffuse : gloss) += value[i].value * share;
    }
    const bool has_target = light->target_part != world::kNoIndex;
    const glm::vec3 scale = path.weight * (has_target ? glm::vec3(1.0f) : light->light) / light->density;
    Shadow shadow{.diffuse = diffuse * scale,
                  .gloss = gloss * scale,
                  .start = at.surface.position,
                  .inside = nullptr,
                  .target_part = light->target_part,
                  .target_primitive = light->target_primitive,
                  .pixel = path.pixel,
                  .diffuse_channel = path.channel,
                  .gloss_channel = path.channel,
                  .is_indirect = !path.is_eye};
    if (!(brightest(shadow.diffuse + shadow.gloss) > 0.0f)) return;
    if (path.is_eye && path.is_leading) {
        shadow.diffuse_channel = Channel::Direct;
        shadow.gloss_channel = Channel::Specular;
    }
    MediumStack media = path.media;
    if (glm::dot(light->direction, at.geometric) < 0.0f &&
        frame_.view.prepared.parts[at.part].is_solid_glass) {
        if (at.is_entering) {
            media.enter(at.part, *at.material);
        } else {
            media.leave(at.part);
        }
    }
    shadow.inside = media.top();
    (has_target ? target_rays_ : shadow_rays_).push_back(light->ray);
    (has_target ? targets_ : shadows_).push_back(shadow);
}

// Both what is mirrored and what goes through, each by its share.
void PathTile::split(const Path& path, const ShadingPoint& at, const Bsdf& bsdf, FrameStats& stats) {
    const float mirrored = bsdf.mirrored_probability();
    for (const bool passes : {false, true}) {
        const float share = passes ? 1.0f - mirrored : mirrored;
        if (!(share > 0.0f)) continue;
        Path part = path;
        part.weight *= share;
        part.branch = path.branch * 2u + (passes ? 1u : 0u);
        part.is_leading = path.is_leading && share > 0.5f;
        if (!part.is_leading) part.channel = Channel::Specular;
        Onward onward{bsdf.sample(passes ? 0x1.fffffep-1f : 0.0f, glm::vec2(0.0f))};
        onward.survival = brightest(onward.weight);
        part.survival *= share;
        send_on(part, at, onward, bsdf, stats);
    }
}

void PathTile::send_on(const Path& path, const ShadingPoint& at, const Onward& sample, const Bsdf& bsdf,
                       FrameStats& stats) {
    if (!(brightest(sample.weight) > 0.0f)) return;
    Path onward = path;
    onward.weight *= sample.weight;
    onward.survival *= sample.survival;
    onward.ray = rc::spawn_ray(at.surface, sample.direction);
    const bool is_straight = sample.is_straight && is_smooth_glass(*at.material);
    if (sample.passes && frame_.view.prepared.parts[at.part].is_solid_glass) {
        if (at.is_entering) {
            onward.media.enter(at.part, *at.material);
        } else {
            onward.media.leave(at.part);
        }
    }
    if (fills_planes(path) && path.is_eye && !bsdf.takes_lamps()) note_mirror(path, at, sample.passes);
    if (is_straight && path.passes < kMostPasses) {
        ++onward.passes;
    } else {
        onward.depth = static_cast<std::uint8_t>(path.depth + 1);
        if (bsdf.takes_lamps()) {
            onward.is_eye = false;
            onward.is_first_leg = path.is_eye;
            if (path.is_eye && path.is_leading)
                onward.channel = sample.lobe == Lobe::Diffuse ? Channel::Indirect : Channel::Specular;
        }
        if (sample.is_delta) {
            onward.has_bent = true;
        } else {
            onward.from = {at.surface.position, bsdf.is_clear() ? glm::vec3(0.0f) : at.normal};
            onward.density = sample.density;
            onward.has_bent = false;
            onward.is_rough |=
                sample.lobe != Lobe::Glass && !(sample.lobe == Lobe::Gloss && bsdf.alpha() < kRoughAlpha);
            onward.cone_angle +=
                sample.lobe == Lobe::Gloss || sample.lobe == Lobe::Glass ? 2.0f * bsdf.alpha() : 0.5f;
        }
        if (!path.is_eye) onward.is_first_leg = false;
    }
    if (!survives(onward)) return;
    ++(sample.passes ? stats.refracted_rays : stats.reflected_rays);
    next_.push_back(onward);
}

bool PathTile::survives(Path& path) const {
    if (!frame_.settings.uses_roulette || path.depth <= kRouletteDepth) return true;
    // Radiance is squeezed in glass, and comes out again as it was.
    const float ior = sane(path.media.ior(), 1.0f, 5.0f);
    const float chance = std::min(1.0f, path.survival * ior * ior);
    if (!(sequence(path).one(path.sample, dimension(path, kRoulettePurpose)) < chance)) return false;
    path.weight /= chance;
    path.survival /= chance;
    return true;
}

}  // namespace gh::render
