// The part of a tile that sends light and paths on: which lamp a place asks, and where its path goes next.
#include "base/det_math.h"
#include "render/clear_way.h"
#include "render/colour.h"
#include "render/path_choices.h"
#include "render/path_tile.h"
#include "render/sane.h"

#include <glm/geometric.hpp>

#include <algorithm>

namespace gh::render {

namespace {

constexpr int kRouletteDepth = 2;          // paths shorter than that go on whatever they carry ...
constexpr float kLeastEarlyChance = 0.7f;  // ... or, where they end early, this often at least (README.md)
constexpr float kLeastSeen = 0.03f;   // of split paths: what the eye sees of more weight never ends by chance
constexpr float kRoughAlpha = 0.1f;   // gloss that scatters so widely is rough
constexpr float kGleamShare = 0.35f;  // of diffuse paths, where gleams are seen

// Of the diffuse lobe together with what seeks gleams, times the probability of picking it; `own` is the lobe's alone.
float guided_density(const Bsdf& bsdf, const GleamGuide& guide, float own, const glm::vec3& direction) {
    return own * (1.0f - kGleamShare) +
           kGleamShare * bsdf.probability(Lobe::Diffuse) * guide.density(direction);
}

}  // namespace

// Where the surface sends the path by itself, or now and then towards a gleam: one density for both together.
template <unsigned kFeatures>
auto PathTile<kFeatures>::pick_onward(const Path& path, const Scatterer& here) -> Onward {
    const float u_lobe = one(path, kLobePurpose);
    const glm::vec2 u = two(path, kDirectionPurpose);
    Onward onward{here.bsdf.sample(u_lobe, u)};
    onward.survival = brightest(onward.weight);
    if (here.guide.empty() || onward.lobe != Lobe::Diffuse) return onward;
    if (one(path, kGleamPurpose) < kGleamShare) {
        const float u_gleam = one(path, kWhichGleamPurpose);
        onward.direction = here.guide.pick(u_gleam, u);
    }
    const LobeValue value = here.bsdf.value(Lobe::Diffuse, onward.direction);
    onward.density = guided_density(here.bsdf, here.guide, value.density, onward.direction);
    onward.weight = value.density > 0.0f ? value.value / onward.density : glm::vec3(0.0f);
    onward.survival = value.density > 0.0f ? brightest(value.value / value.density) : 0.0f;
    return onward;
}

template <unsigned kFeatures>
void PathTile<kFeatures>::ask_lamp(const Path& path, const Scatterer& here, bool is_last) {
    const ShadingPoint& at = here.at;
    const Bsdf& bsdf = here.bsdf;
    const LightQuery query{at.surface.position, bsdf.is_clear() ? glm::vec3(0.0f) : at.normal};
    const auto light =
        frame_.lights.sample(at.surface, query, one(path, kLampPurpose), two(path, kOnLampPurpose));
    if (!light) return;
    // What glows without being a lamp is in the bake that a path ends in, and must not be counted twice.
    const bool is_baked =
        light->part != world::kNoIndex && frame_.view.prepared.parts[light->part].lamp == world::kNoIndex;
    if (is_last && is_baked) return;
    BsdfValue value = bsdf.value(light->direction);
    LobeValue& base = value[static_cast<std::size_t>(Lobe::Diffuse)];
    if (!here.guide.empty() && base.density > 0.0f)
        base.density = guided_density(bsdf, here.guide, base.density, light->direction);
    if (is_baked && frame_.settings.lights == LightPaths::Glossy) bsdf.forget_even(value);
    glm::vec3 diffuse(0.0f), gloss(0.0f);
    for (std::size_t i = 0; i < kLobes; ++i) {
        const bool is_alone = is_last || light->is_delta || frame_.settings.lamps == LampFinding::AskOnly;
        const float share = is_alone ? 1.0f : counts(light->density, value[i].density);
        (static_cast<Lobe>(i) == Lobe::Diffuse ? diffuse : gloss) += value[i].value * share;
    }
    const bool has_target = light->target_part != world::kNoIndex;
    const glm::vec3 scale = path.weight * (has_target ? glm::vec3(1.0f) : light->light) / light->density;
    Shadow shadow{.diffuse = diffuse * scale,
                  .gloss = gloss * scale,
                  .start = at.surface.position,
                  .reach = light->reach,
                  .inside = nullptr,
                  .target_part = light->target_part,
                  .target_primitive = light->target_primitive,
                  .pixel = path.pixel,
                  .diffuse_channel = path.channel,
                  .gloss_channel = path.channel,
                  .is_indirect = !path.is_eye,
                  .is_beside = path.is_beside};
    if (!(brightest(shadow.diffuse + shadow.gloss) > 0.0f)) return;
    if (path.is_eye && path.is_leading) {
        shadow.diffuse_channel = Channel::Direct;
        shadow.gloss_channel = Channel::Specular;
    }
    const bool goes_through = glm::dot(light->direction, at.geometric) < 0.0f;
    shadow.inside = goes_through ? here.beyond.top() : path.media.top();
    shadow_rays_.push_back(light->ray);
    shadows_.push_back(shadow);
}

// The last surface of a path gives back what its lamps give it and the light that was baked about it, as if it was dull.
template <unsigned kFeatures>
void PathTile<kFeatures>::end_in_bake(const Path& path, const Scatterer& here) {
    ask_lamp(path, here, true);
    const ShadingPoint& at = here.at;
    const glm::vec3 albedo = sane_colour(at.base_color) * (1.0f - here.bsdf.probability(Lobe::Glass));
    const glm::vec3 light = frame_.light.ambient.irradiance(at.surface.position, at.normal);
    add(path.pixel, path.channel, path.weight * albedo * light * (1.0f / kPi), !path.is_eye, path.is_beside);
}

// What the lobes that send no path on give back of the light that was baked about the place.
template <unsigned kFeatures>
void PathTile<kFeatures>::add_baked_light(const Path& path, const Scatterer& here) {
    const glm::vec3 share = here.bsdf.even_share();
    if (!(brightest(share) > 0.0f)) return;
    const glm::vec3 light = frame_.light.ambient.irradiance(here.at.surface.position, here.at.normal);
    const Channel channel = path.is_eye && path.is_leading ? Channel::Indirect : path.channel;
    add(path.pixel, channel, path.weight * share * light * (1.0f / kPi), !path.is_eye, path.is_beside);
}

// Both what is mirrored and what goes through, each by its share.
template <unsigned kFeatures>
void PathTile<kFeatures>::split(const Path& path, const Scatterer& here, FrameStats& stats) {
    const float mirrored = here.bsdf.mirrored_probability();
    for (const bool passes : {false, true}) {
        const float share = passes ? 1.0f - mirrored : mirrored;
        if (!(share > 0.0f)) continue;
        Path part = path;
        part.weight *= share;
        ++part.splits;
        part.branch = path.branch * 2u + (passes ? 1u : 0u);
        part.is_leading = path.is_leading && share > 0.5f;
        if (!part.is_leading) part.channel = Channel::Mirrored;
        Onward onward{here.bsdf.sample(passes ? 0x1.fffffep-1f : 0.0f, glm::vec2(0.0f))};
        onward.survival = brightest(onward.weight);
        part.survival *= share;
        send_on(part, here, onward, stats);
    }
}

template <unsigned kFeatures>
void PathTile<kFeatures>::send_on(const Path& path, const Scatterer& here, const Onward& sample,
                                  FrameStats& stats) {
    if (!(brightest(sample.weight) > 0.0f)) return;
    const ShadingPoint& at = here.at;
    const Bsdf& bsdf = here.bsdf;
    Path onward = path;
    onward.weight *= sample.weight;
    onward.survival *= sample.survival;
    onward.ray = rc::spawn_ray(at.surface, sample.direction);
    const bool is_straight = kHasClear && sample.is_straight && is_smooth_glass(*at.material);
    if (kHasClear && sample.passes) onward.media = here.beyond;
    if (kHasClear && here.gap > 0.0f)
        onward.ray.t_min = here.gap / std::max(std::abs(glm::dot(sample.direction, at.geometric)), 1e-2f);
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
            if (bsdf.takes_lamps()) ++onward.scatters;
            onward.has_bent = false;
            onward.is_rough |= sample.lobe != Lobe::Glass && sample.lobe != Lobe::Coat &&
                               !(sample.lobe == Lobe::Gloss && bsdf.alpha() < kRoughAlpha);
            onward.cone_angle += sample.lobe == Lobe::Gloss || sample.lobe == Lobe::Glass
                                     ? 2.0f * bsdf.alpha()
                                 : sample.lobe == Lobe::Coat ? 2.0f * at.coat_roughness * at.coat_roughness
                                                             : 0.5f;
        }
        if (!path.is_eye) onward.is_first_leg = false;
    }
    if (!survives(onward)) return;
    ++(sample.passes ? stats.refracted_rays : stats.reflected_rays);
    next_.push_back(onward);
}

template <unsigned kFeatures>
bool PathTile<kFeatures>::survives(Path& path) {
    const bool is_early = frame_.settings.ends_early && path.scatters > 0;
    if (!frame_.settings.uses_roulette || (path.depth <= kRouletteDepth && !is_early)) return true;
    // Radiance is squeezed in glass, and comes out again as it was.
    const float ior = sane(path.media.ior(), 1.0f, 5.0f);
    const float faint = frame_.settings.splits_glass && path.is_eye ? kLeastSeen : 1.0f;
    const float least = is_early ? kLeastEarlyChance : 0.0f;
    const float chance = std::max(std::min(1.0f, path.survival * ior * ior / faint), least);
    if (!(one(path, kRoulettePurpose) < chance)) return false;
    path.weight /= chance;
    path.survival /= chance;
    return true;
}

}  // namespace gh::render
