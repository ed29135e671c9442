// The layers over a surface: a varnish and the fibres of a cloth (KHR_materials_clearcoat, _sheen).
//
// glTF dims what lies below by what the layer mirrors towards the eye. Light has to come in through it as well: here both
// ways count, each by the share that the layer gives back of light from everywhere.
#include "render/bsdf.h"
#include "render/fresnel.h"
#include "render/microfacets.h"
#include "render/sane.h"

#include <algorithm>
#include <cmath>

namespace gh::render {

namespace {

constexpr float kCoatHeadOn = 0.04f;     // index 1.5, as the extension has it
constexpr float kSmoothestCoat = 0.02f;  // roughness: what is smoother looks the same

}  // namespace

void Bsdf::lay_over() {
    coat_ = sane(at_.coat, 0.0f, 1.0f);
    sheen_color_ = sane_colour(at_.sheen_color);
    sheen_most_ = std::max({sheen_color_.x, sheen_color_.y, sheen_color_.z});
    has_layers_ = coat_ > 0.0f || sheen_most_ > 0.0f;
    if (!has_layers_) return;
    // Varnish fills the bumps of a normal map, and may have its own.
    coat_roughness_ = sane(at_.coat_roughness, kSmoothestCoat, 1.0f);
    coat_basis_ = basis_around(at_.coat_normal);
    coat_eye_ = coat_basis_.local_from_world(to_eye_);
    coat_eye_.z = std::max(coat_eye_.z, 1e-4f);
    eye_below_coat_ = below_coat(to_eye_);
    eye_below_ = below_layers(to_eye_, eye_.z);
}

float Bsdf::below_coat(const glm::vec3& direction) const {
    if (!(coat_ > 0.0f)) return 1.0f;
    const float cosine = std::abs(glm::dot(direction, coat_basis_.normal));
    const GlossEnergy::Share back = energy_.towards(cosine, coat_roughness_);
    return 1.0f - coat_ * back.of(glm::vec3(kCoatHeadOn), 1.0f).x;
}

float Bsdf::below_layers(const glm::vec3& direction, float cosine) const {
    const float fibres =
        sheen_most_ > 0.0f ? 1.0f - sheen_most_ * energy_.sheen().albedo(
                                                      std::abs(cosine), sane(at_.sheen_roughness, 0.0f, 1.0f))
                           : 1.0f;
    return below_coat(direction) * fibres;
}

BsdfSample Bsdf::sample_coat(const glm::vec2& u) const {
    const float alpha = coat_roughness_ * coat_roughness_;
    const glm::vec3 half = pick_facet(coat_eye_, alpha, u);
    const glm::vec3 local = half * (2.0f * glm::dot(coat_eye_, half)) - coat_eye_;
    BsdfSample sample;
    sample.direction = glm::normalize(coat_basis_.world_from_local(local));
    const LobeValue value = coat_value(sample.direction);
    sample.density = value.density;
    if (value.density > 0.0f) sample.weight = value.value / value.density;
    return sample;
}

LobeValue Bsdf::coat_value(const glm::vec3& direction) const {
    const glm::vec3 local = coat_basis_.local_from_world(direction);
    if (!(local.z > 0.0f) || !(glm::dot(direction, at_.geometric) > 0.0f)) return {};
    const float alpha = coat_roughness_ * coat_roughness_;
    const glm::vec3 half = glm::normalize(coat_eye_ + local);
    const float facing = glm::dot(coat_eye_, half);
    if (!(facing > 0.0f)) return {};
    const float density = visible_density(coat_eye_, half, alpha) / (4.0f * facing);
    const float open = unshadowed_share(smith_lambda(coat_eye_, alpha), smith_lambda(local, alpha));
    return {schlick(glm::vec3(kCoatHeadOn), 1.0f, facing) * (coat_ * density * open),
            probability(Lobe::Coat) * density};
}

// Picked by the cosine: fibres send light all over the hemisphere.
LobeValue Bsdf::sheen_value(const glm::vec3& direction, const glm::vec3& local) const {
    const float white = energy_.sheen().value(eye_, local, sane(at_.sheen_roughness, 0.0f, 1.0f));
    return {sheen_color_ * (white * eye_below_coat_ * below_coat(direction)),
            probability(Lobe::Sheen) * local.z / kPi};
}

}  // namespace gh::render
