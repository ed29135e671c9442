// The lobes that scatter light all over the hemisphere, taken together: what distributed ray tracing does not follow.
#include "render/bsdf.h"
#include "render/sane.h"

#include <algorithm>

namespace gh::render {

namespace {

constexpr std::array<Lobe, 3> kEven{Lobe::Diffuse, Lobe::Multi, Lobe::Sheen};

}  // namespace

void Bsdf::follow_glossy_only() {
    for (const Lobe lobe : kEven) probability_[static_cast<std::size_t>(lobe)] = 0.0f;
    float total = 0.0f;
    for (const float p : probability_) total += p;
    if (!(total > 0.0f)) return;
    for (float& p : probability_) p /= total;
}

void Bsdf::forget_even(BsdfValue& value) {
    for (const Lobe lobe : kEven) value[static_cast<std::size_t>(lobe)] = {};
}

// The integrals of cosine_value() and sheen_value() over the hemisphere. Layers let as much in as they do head on.
glm::vec3 Bsdf::even_share() const {
    const glm::vec3 out = coat_of_paint_.of(mean_);
    const float in = std::max(0.0f, 1.0f - std::max({out.x, out.y, out.z}));
    glm::vec3 share = (base_ * (coat_left_ * in) + gloss_.multi * (1.0f - seen_.white)) * (1.0f - clear_);
    if (!has_layers_) return share;
    share *= eye_below_ * below_layers(coat_basis_.normal, 1.0f);
    if (sheen_most_ > 0.0f) {
        const float back = energy_.sheen().albedo(eye_.z, sane(at_.sheen_roughness, 0.0f, 1.0f));
        share += sheen_color_ * (back * eye_below_coat_);
    }
    return share;
}

glm::vec3 Bsdf::gloss_albedo() const {
    glm::vec3 share = glm::vec3(clear_);
    if (gloss_.f90 > 0.0f) share += gloss_.of(seen_) * (1.0f - clear_);
    if (!has_layers_) return share;
    // Light comes in through the layers about as steeply as it goes out.
    share = share * (eye_below_ * eye_below_) + glm::vec3(1.0f - eye_below_coat_);
    if (sheen_most_ > 0.0f) {
        const float back = energy_.sheen().albedo(eye_.z, sane(at_.sheen_roughness, 0.0f, 1.0f));
        share += sheen_color_ * (back * eye_below_coat_ * eye_below_coat_);
    }
    return share;
}

}  // namespace gh::render
