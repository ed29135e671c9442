// The opaque part, and which lobe is picked.
#include "render/bsdf.h"

#include "render/colour.h"
#include "render/fresnel.h"
#include "render/microfacets.h"
#include "render/sane.h"

#include <glm/common.hpp>

#include <algorithm>

namespace gh::render {

namespace {

constexpr float kSmoothAlpha = 1e-4f;  // and below: a mirror

std::size_t index_of(Lobe lobe) {
    return static_cast<std::size_t>(lobe);
}

// Takes light away smoothly where the smooth surface still faces a direction that its triangle turns away from, which
// would otherwise show triangles one by one (Chiang, Li and Burley 2019).
float terminator(float cos_geometric, float cos_smooth, float cos_bend) {
    if (cos_bend > 0.99999f) return 1.0f;
    const float g = std::clamp(cos_geometric / (cos_smooth * std::max(cos_bend, 0.05f)), 0.0f, 1.0f);
    return g * (1.0f + g - g * g);
}

}  // namespace

Bsdf::Bsdf(const ShadingPoint& at, const glm::vec3& to_eye, const Border& border, const GlossEnergy& energy)
    : at_(at), energy_(energy), to_eye_(to_eye), basis_(basis_around(at.normal)), border_(border) {
    if (at.anisotropy > 0.0f) draw_out();
    eye_ = basis_.local_from_world(to_eye);
    eye_.z = std::max(eye_.z, 1e-4f);
    const world::Material& material = *at.material;
    const glm::vec3 color = sane_colour(at.base_color);
    const float metallic = sane(at.metallic, 0.0f, 1.0f);
    roughness_ = sane(at.roughness, 0.0f, 1.0f);
    alpha_ = roughness_ * roughness_;
    is_smooth_ = alpha_ < kSmoothAlpha;
    clear_ = sane(at.transmission, 0.0f, 1.0f) * (1.0f - metallic);
    tint_ = color;
    const float dielectric = sane(at.specular, 0.0f, 1.0f);
    // An index of 0 mirrors all, head on as well: glTF's word for a colour of reflection that is meant as it is.
    const float head_on = material.ior == 0.0f ? 1.0f : reflectance_head_on(sane(material.ior, 1.0f, 5.0f));
    coat_of_paint_.f0 = sane_colour(at.specular_color * head_on) * dielectric;
    coat_of_paint_.f90 = grazing_share(coat_of_paint_.f0) * dielectric;
    gloss_.f0 = glm::mix(coat_of_paint_.f0, color, metallic);
    gloss_.f90 = glm::mix(coat_of_paint_.f90, grazing_share(color), metallic);
    base_ = color * (1.0f - metallic);
    if (is_drawn_out_) {
        const float stretch = sane(at.anisotropy, 0.0f, 1.0f);
        const float narrow = std::max(alpha_, kSmoothAlpha);
        alphas_ = {glm::mix(narrow, 1.0f, stretch * stretch), narrow};
        is_smooth_ = false;
    }
    if (!is_smooth_) lambda_eye_ = lambda(eye_);
    weigh_coat(color, metallic);
    if (material.has_layers) lay_over();
    choose_lobes();
}

void Bsdf::add_bounces(Mirrored& mirrored) const {
    const glm::vec3 f_mean = mirrored.f0 + (glm::vec3(mirrored.f90) - mirrored.f0) / 21.0f;
    mirrored.multi = f_mean * f_mean * mean_.white / (glm::vec3(1.0f) - f_mean * (1.0f - mean_.white));
    // The tables know round highlights only; at grazing angles drawn out ones give back up to 2 % more at once.
    if (is_drawn_out_) mirrored.multi *= 0.5f;
}

// How the coat's light and the base's are shared, averaged over facets. Half a metal is metal on half of the surface: its
// gloss is the mean of both, and paint is dimmed by its own coat alone.
void Bsdf::weigh_coat(const glm::vec3& metal, float metallic) {
    if (!(gloss_.f90 > 0.0f)) {
        seen_ = mean_ = {};
        return;
    }
    if (is_smooth_) {
        const float m = 1.0f - std::min(eye_.z, 1.0f);
        seen_ = {1.0f, m * m * m * m * m};
        mean_ = {1.0f, 1.0f / 21.0f};
    } else {
        seen_ = energy_.towards(eye_.z, roughness_);
        mean_ = energy_.mean(roughness_);
        add_bounces(coat_of_paint_);
        gloss_.multi = coat_of_paint_.multi;
        if (metallic > 0.0f) {
            Mirrored of_metal{metal, grazing_share(metal), {}};
            add_bounces(of_metal);
            gloss_.multi = glm::mix(coat_of_paint_.multi, of_metal.multi, metallic);
        }
    }
    const float out = brightest(coat_of_paint_.of(mean_)), seen = brightest(coat_of_paint_.of(seen_));
    coat_left_ = out < 0.9999f ? std::max(0.0f, 1.0f - seen) / (1.0f - out) : 0.0f;
}

void Bsdf::choose_lobes() {
    std::array<float, kLobes> share{};
    share[index_of(Lobe::Glass)] = clear_;
    // What the diffuse lobe gives, were everything evenly lit: coat_left_ is relative to the average.
    const float let_in = std::max(0.0f, 1.0f - brightest(coat_of_paint_.of(mean_)));
    const float diffuse = brightest(base_) * coat_left_ * let_in;
    const float gloss = gloss_.f90 > 0.0f ? brightest(seen_.of(gloss_.f0, gloss_.f90)) : 0.0f;
    const float multi = brightest(gloss_.multi) * std::max(0.0f, 1.0f - seen_.white);
    share[index_of(Lobe::Diffuse)] = (1.0f - clear_) * diffuse;
    share[index_of(Lobe::Gloss)] = (1.0f - clear_) * gloss;
    share[index_of(Lobe::Multi)] = (1.0f - clear_) * multi;
    if (has_layers_) {
        for (float& below : share) below *= eye_below_;
        share[index_of(Lobe::Coat)] = 1.0f - eye_below_coat_;
        share[index_of(Lobe::Sheen)] = eye_below_coat_ - eye_below_;
    }
    // By the root of what each gives: a lobe that gives little is so picked more often than it gives, and then counts
    // for less: the gloss of plaster, 4 % of its light, were else one bright pixel in 25.
    lobes_ = has_layers_ ? kLobes : clear_ > 0.0f ? index_of(Lobe::Glass) + 1 : index_of(Lobe::Glass);
    float total = 0.0f;
    for (std::size_t i = 0; i < lobes_; ++i) {
        share[i] = share[i] > 0.0f ? std::sqrt(share[i]) : 0.0f;
        total += share[i];
    }
    if (!(total > 0.0f)) return;
    for (std::size_t i = 0; i < lobes_; ++i) {
        probability_[i] = share[i] / total;
        gives_[i] = probability_[i] > 0.0f;
    }
    takes_lamps_ = share[index_of(Lobe::Diffuse)] > 0.0f || share[index_of(Lobe::Multi)] > 0.0f ||
                   share[index_of(Lobe::Coat)] > 0.0f || share[index_of(Lobe::Sheen)] > 0.0f ||
                   (!is_smooth_ && (gloss > 0.0f || clear_ > 0.0f));
}

glm::vec3 Bsdf::schlick_at(float cosine) const {
    return schlick(gloss_.f0, gloss_.f90, cosine);
}

auto Bsdf::incoming(const glm::vec3& direction, const glm::vec3& local) const -> Incoming {
    Incoming in{direction, local, facing_share(direction, local.z), {}};
    const bool is_asked = gives_[index_of(Lobe::Diffuse)] || gives_[index_of(Lobe::Multi)];
    if (!(in.open > 0.0f) || !is_asked || !(gloss_.f90 > 0.0f)) return in;
    if (is_smooth_) {
        const float m = 1.0f - std::min(local.z, 1.0f);
        in.coated = {1.0f, m * m * m * m * m};
    } else {
        in.coated = energy_.towards(local.z, roughness_);
    }
    return in;
}

// What the coat lets in from one side.
float Bsdf::coat_share(const GlossEnergy::Share& coated) const {
    if (!(coat_of_paint_.f90 > 0.0f)) return 1.0f;
    return std::max(0.0f, 1.0f - brightest(coat_of_paint_.of(coated)));
}

// 0 for directions that the triangle itself does not face.
float Bsdf::facing_share(const glm::vec3& direction, float cosine) const {
    const float cos_geometric = glm::dot(direction, at_.geometric);
    if (!(cos_geometric > 0.0f) || !(cosine > 0.0f)) return 0.0f;
    return terminator(cos_geometric, cosine, glm::dot(at_.geometric, at_.normal));
}

BsdfSample Bsdf::sample(float u_lobe, const glm::vec2& u) const {
    float below = 0.0f;
    std::size_t pick = kLobes;
    for (std::size_t i = 0; i < lobes_; ++i) {
        if (!(probability_[i] > 0.0f)) continue;
        pick = i;
        if (u_lobe < below + probability_[i]) break;
        below += probability_[i];
    }
    if (pick == kLobes) return {};
    const float u_within = std::clamp((u_lobe - below) / probability_[pick], 0.0f, 0x1.fffffep-1f);
    const auto lobe = static_cast<Lobe>(pick);
    BsdfSample sample = sample_base(lobe, u_within, u);
    sample.lobe = lobe;
    return sample;
}

// Weights of the cosine's samples come from value_of(), which knows of the layers; the others are dimmed here.
BsdfSample Bsdf::sample_base(Lobe lobe, float u_within, const glm::vec2& u) const {
    if (lobe == Lobe::Coat) return sample_coat(u);
    if (lobe != Lobe::Gloss && lobe != Lobe::Glass) return sample_cosine(lobe, u);
    BsdfSample sample = lobe == Lobe::Gloss ? sample_gloss(u)
                        : is_smooth_        ? sample_smooth_glass(u_within)
                                            : sample_rough_glass(u_within, u);
    if (has_layers_)
        sample.weight *=
            eye_below_ * below_layers(sample.direction, glm::dot(sample.direction, basis_.normal));
    return sample;
}

// The frame's x goes along the way highlights are drawn out.
void Bsdf::draw_out() {
    const glm::vec3 along = at_.drawn_out - at_.normal * glm::dot(at_.drawn_out, at_.normal);
    const float length2 = glm::dot(along, along);
    if (!(length2 > 1e-6f) || at_.material->transmission > 0.0f) return;
    basis_.tangent = along / std::sqrt(length2);
    basis_.bitangent = glm::cross(at_.normal, basis_.tangent);
    is_drawn_out_ = true;
}

float Bsdf::lambda(const glm::vec3& local) const {
    return is_drawn_out_ ? smith_lambda(local, alphas_) : smith_lambda(local, alpha_);
}

float Bsdf::visible(const glm::vec3& half) const {
    return is_drawn_out_ ? visible_density(eye_, half, alphas_) : visible_density(eye_, half, alpha_);
}

BsdfSample Bsdf::sample_cosine(Lobe lobe, const glm::vec2& u) const {
    BsdfSample sample;
    const glm::vec3 local = cosine_hemisphere(u);
    sample.direction = basis_.world_from_local(local);
    const LobeValue value = value_of(lobe, incoming(sample.direction, local));
    sample.density = value.density;
    if (value.density > 0.0f) sample.weight = value.value / value.density;
    return sample;
}

BsdfSample Bsdf::sample_gloss(const glm::vec2& u) const {
    const float share = (1.0f - clear_) / probability(Lobe::Gloss);
    BsdfSample sample;
    if (is_smooth_) {
        sample.is_delta = true;
        sample.direction = mirrored_direction(-to_eye_, at_);
        sample.weight = schlick_at(eye_.z) * share;
        return sample;
    }
    const glm::vec3 half = is_drawn_out_ ? pick_facet(eye_, alphas_, u) : pick_facet(eye_, alpha_, u);
    const float facing = glm::dot(eye_, half);
    const glm::vec3 local = half * (2.0f * facing) - eye_;
    sample.direction = glm::normalize(basis_.world_from_local(local));
    const float open = facing_share(sample.direction, local.z);
    if (!(open > 0.0f)) return sample;
    sample.density = probability(Lobe::Gloss) * visible(half) / (4.0f * facing);
    sample.weight = schlick_at(facing) * (share * open * unshadowed_share(lambda_eye_, lambda(local)));
    return sample;
}

BsdfValue Bsdf::value(const glm::vec3& direction) const {
    const Incoming in = incoming(direction, basis_.local_from_world(direction));
    BsdfValue result{};
    for (std::size_t i = 0; i < lobes_; ++i) {
        if (gives_[i]) result[i] = value_of(static_cast<Lobe>(i), in);
    }
    return result;
}

LobeValue Bsdf::value(Lobe lobe, const glm::vec3& direction) const {
    return value_of(lobe, incoming(direction, basis_.local_from_world(direction)));
}

LobeValue Bsdf::value_of(Lobe lobe, const Incoming& in) const {
    if (lobe == Lobe::Coat) return coat_value(in.direction);
    const float below =
        has_layers_ && lobe != Lobe::Sheen ? eye_below_ * below_layers(in.direction, in.local.z) : 1.0f;
    if (lobe == Lobe::Glass) {
        if (is_smooth_) return {};
        const bool is_outside = glm::dot(in.direction, at_.geometric) > 0.0f;
        if (is_outside != (in.local.z > 0.0f) || in.local.z == 0.0f) return {};
        LobeValue glass = glass_value(in.local);
        glass.value *= below;
        return glass;
    }
    if (!(in.open > 0.0f)) return {};
    if (lobe == Lobe::Sheen) {
        LobeValue sheen = sheen_value(in.direction, in.local);
        sheen.value *= in.open;
        return sheen;
    }
    LobeValue result = lobe == Lobe::Gloss ? gloss_value(in.local) : cosine_value(lobe, in);
    result.value *= in.open * (1.0f - clear_) * below;
    return result;
}

LobeValue Bsdf::cosine_value(Lobe lobe, const Incoming& in) const {
    const float even = in.local.z / kPi;
    LobeValue result{.density = probability(lobe) * even};
    if (lobe == Lobe::Diffuse) {
        result.value = base_ * (coat_left_ * coat_share(in.coated) * even);
    } else {
        const float light = 1.0f - in.coated.white;
        result.value =
            gloss_.multi * ((1.0f - seen_.white) * light / std::max(1.0f - mean_.white, 1e-6f) * even);
    }
    return result;
}

LobeValue Bsdf::gloss_value(const glm::vec3& local) const {
    if (is_smooth_) return {};
    const glm::vec3 half = glm::normalize(eye_ + local);
    const float facing = glm::dot(eye_, half);
    if (!(facing > 0.0f)) return {};
    const float density = visible(half) / (4.0f * facing);
    return {schlick_at(facing) * (density * unshadowed_share(lambda_eye_, lambda(local))),
            probability(Lobe::Gloss) * density};
}

}  // namespace gh::render
