// The glass part: smooth borders split light in two, rough ones do so facet by facet (Walter et al. 2007).
#include "render/bsdf.h"
#include "render/fresnel.h"
#include "render/microfacets.h"

#include <algorithm>
#include <cmath>

namespace gh::render {

namespace {

constexpr float kSameIndex = 1e-3f;  // of eta to 1: facets do not bend light that the border does not

float mirrored_share(const Border& border, float cosine) {
    const float reflectance = fresnel(std::clamp(cosine, 0.0f, 1.0f), border.eta).reflectance;
    return border.is_thin ? thin_sheet_reflectance(reflectance) : reflectance;
}

bool bends(const Border& border) {
    return !border.is_thin && std::abs(border.eta - 1.0f) > kSameIndex;
}

}  // namespace

float Bsdf::mirrored_probability() const {
    return mirrored_share(border_, eye_.z);
}

BsdfSample Bsdf::sample_smooth_glass(float u_choice) const {
    BsdfSample sample;
    sample.is_delta = true;
    const float share = clear_ / probability(Lobe::Glass);
    const float mirrored = mirrored_share(border_, eye_.z);
    if (u_choice < mirrored) {
        sample.direction = mirrored_direction(-to_eye_, at_);
        sample.weight = glm::vec3(share);
        return sample;
    }
    sample.passes = true;
    sample.is_straight = border_.is_thin;
    sample.direction = -to_eye_;
    sample.weight = tint_ * share;
    if (!border_.is_thin) {
        const float cosine = std::min(eye_.z, 1.0f);
        sample.direction = refracted(-to_eye_, at_.normal, border_.eta, cosine,
                                     fresnel(cosine, border_.eta).cos_transmitted);
        sample.weight /= border_.eta * border_.eta;
    }
    // A bent normal must not send the ray back to the side it came from.
    if (!(glm::dot(sample.direction, at_.geometric) < 0.0f)) sample.weight = glm::vec3(0.0f);
    return sample;
}

BsdfSample Bsdf::sample_rough_glass(float u_choice, const glm::vec2& u) const {
    BsdfSample sample;
    const glm::vec3 half = pick_facet(eye_, alpha_, u);
    const float facing = glm::dot(eye_, half);
    const float mirrored = mirrored_share(border_, facing);
    const float visible = visible_density(eye_, half, alpha_);
    const glm::vec3 reflection = half * (2.0f * facing) - eye_;
    glm::vec3 local = reflection;
    float density = mirrored * visible / (4.0f * facing);
    glm::vec3 weight(1.0f);
    if (u_choice >= mirrored) {
        sample.passes = true;
        weight = tint_;
        density = (1.0f - mirrored) * visible / (4.0f * facing);
        local.z = -reflection.z;
        if (bends(border_)) {
            const float bent = fresnel(std::min(facing, 1.0f), border_.eta).cos_transmitted;
            local = glm::normalize(half * (facing / border_.eta - bent) - eye_ / border_.eta);
            const float along = facing + border_.eta * glm::dot(local, half);
            density = (1.0f - mirrored) * visible * std::abs(glm::dot(local, half)) * border_.eta *
                      border_.eta / (along * along);
        }
        if (!border_.is_thin) weight /= border_.eta * border_.eta;
    }
    sample.direction = glm::normalize(basis_.world_from_local(local));
    const bool goes_through = glm::dot(sample.direction, at_.geometric) < 0.0f;
    if (goes_through != sample.passes || (local.z < 0.0f) != sample.passes || local.z == 0.0f) return sample;
    sample.density = probability(Lobe::Glass) * density;
    if (!(sample.density > 0.0f)) return sample;
    sample.weight = weight * (clear_ / probability(Lobe::Glass) *
                              unshadowed_share(lambda_eye_, smith_lambda(local, alpha_)));
    return sample;
}

// Facets that mirror, and sheets, which let light through as if mirrored to the other side.
LobeValue Bsdf::glass_value(const glm::vec3& local) const {
    if (local.z < 0.0f && bends(border_)) return bent_value(local);
    const glm::vec3 above(local.x, local.y, std::abs(local.z));
    const glm::vec3 half = glm::normalize(eye_ + above);
    const float facing = glm::dot(eye_, half);
    if (!(facing > 0.0f)) return {};
    const float mirrored = mirrored_share(border_, facing);
    const float visible = visible_density(eye_, half, alpha_) / (4.0f * facing);
    const float open = unshadowed_share(lambda_eye_, smith_lambda(above, alpha_));
    if (local.z > 0.0f)
        return {glm::vec3(clear_ * mirrored * visible * open), probability(Lobe::Glass) * mirrored * visible};
    const float squeeze = border_.is_thin ? 1.0f : 1.0f / (border_.eta * border_.eta);
    return {tint_ * (clear_ * (1.0f - mirrored) * visible * open * squeeze),
            probability(Lobe::Glass) * (1.0f - mirrored) * visible};
}

LobeValue Bsdf::bent_value(const glm::vec3& local) const {
    glm::vec3 half = eye_ + local * border_.eta;
    const float length2 = glm::dot(half, half);
    if (!(length2 > 0.0f)) return {};
    half /= std::sqrt(length2);
    if (half.z < 0.0f) half = -half;
    const float facing = glm::dot(eye_, half), behind = glm::dot(local, half);
    if (!(facing > 0.0f) || !(behind < 0.0f)) return {};
    const float passed = 1.0f - mirrored_share(border_, facing);
    const float along = facing + border_.eta * behind;
    const float density = passed * visible_density(eye_, half, alpha_) * std::abs(behind) * border_.eta *
                          border_.eta / (along * along);
    const float open = unshadowed_share(lambda_eye_, smith_lambda(local, alpha_));
    return {tint_ * (clear_ * density * open / (border_.eta * border_.eta)),
            probability(Lobe::Glass) * density};
}

}  // namespace gh::render
