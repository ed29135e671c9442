// render/bsdf.h - what a surface does to light at one point, seen from one side: glTF's metallic-roughness with an
// energy-preserving GGX coat, and glass, smooth or rough, thin or solid.
//
// The light is split into lobes that are estimated apart: each is picked with a probability of its own, sampled by
// its own shape, and weighed against lamps by its own density. So what a filter has to keep apart stays apart.
//
//   Diffuse  the base below the coat, what enters and leaves it dimmed alike: reciprocal (Kelemen 2001)
//   Gloss    one bounce among the facets (GGX, visible normals; Dupuy and Benyoub 2023)
//   Multi    more bounces (Kulla and Conty 2017): a white surface gives all light back at any roughness
//   Glass    mirrored and bent, by the exact Fresnel equations. Rough glass bounces once only and darkens a little
//
//   Coat     a varnish of index 1.5 over all of these, and
//   Sheen    the fibres of a cloth (sheen.h). Both dim what lies below by what they give back themselves, towards the eye
//            and from the light alike: reciprocal, and never more than all
//
// Highlights drawn out along the surface (anisotropy) get half the further bounces that a round one as narrow as their
// narrow side would get: they darken, and never give more than they get.
//
// Units     radiance; weights are value * |cos| / density. Radiance is squeezed by 1 / eta^2 into a denser medium.
// Same bits pure.
// Bad input material numbers that are NaN, infinite or out of range count as the nearest sane ones: no weight is NaN.
#pragma once

#include "render/directions.h"
#include "render/gloss_energy.h"
#include "render/shading_point.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <array>
#include <cstdint>

namespace gh::render {

enum class Lobe : std::uint8_t { Diffuse, Gloss, Multi, Glass, Coat, Sheen };
inline constexpr std::size_t kLobes = 6;

// A border between two clear media, as the path meets it.
struct Border {
    float eta = 1.0f;      // index behind it over index before it
    bool is_thin = false;  // a sheet: what enters leaves at once, straight on
};

struct BsdfSample {
    glm::vec3 direction{0.0f};
    glm::vec3 weight{0.0f};  // 0: absorbed
    float density =
        0.0f;  // of this lobe, times the probability of picking it; 0 for a mirror or smooth glass
    Lobe lobe = Lobe::Diffuse;
    bool is_delta = false;
    bool passes = false;       // went through the surface
    bool is_straight = false;  // and did not turn
};

// One lobe's answer for one direction.
struct LobeValue {
    glm::vec3 value{0.0f};  // times |cos|
    float density = 0.0f;   // times the probability of picking the lobe
};
using BsdfValue = std::array<LobeValue, kLobes>;

class Bsdf {
  public:
    // `to_eye` unit; `at` and `energy` must outlive it.
    Bsdf(const ShadingPoint& at, const glm::vec3& to_eye, const Border& border, const GlossEnergy& energy);

    // `u_lobe` picks the lobe (and for glass whether light is mirrored), `u` the direction.
    [[nodiscard]] BsdfSample sample(float u_lobe, const glm::vec2& u) const;
    [[nodiscard]] BsdfValue value(const glm::vec3& direction) const;
    // One lobe of that.
    [[nodiscard]] LobeValue value(Lobe lobe, const glm::vec3& direction) const;

    // Sends nothing on from here by the lobes that scatter light all over the hemisphere (Diffuse, Multi, Sheen): lamps
    // still shine on them. even_share() is what they give back, towards the eye, of light that is the same from everywhere;
    // forget_even() takes them out of an answer.
    void follow_glossy_only();
    [[nodiscard]] glm::vec3 even_share() const;
    static void forget_even(BsdfValue& value);

    // Whether a lamp can be seen by it at all: not if everything is a mirror or smooth glass.
    [[nodiscard]] bool takes_lamps() const { return takes_lamps_; }
    // Whether light from behind the surface counts.
    [[nodiscard]] bool is_clear() const { return probability_[static_cast<std::size_t>(Lobe::Glass)] > 0.0f; }
    [[nodiscard]] float probability(Lobe lobe) const { return probability_[static_cast<std::size_t>(lobe)]; }
    // With which glass mirrors rather than lets through.
    [[nodiscard]] float mirrored_probability() const;
    [[nodiscard]] float alpha() const { return alpha_; }
    // Of the diffuse base, before the coat takes its share.
    [[nodiscard]] const glm::vec3& diffuse_albedo() const { return base_; }
    // What all other lobes together give back, towards the eye, of light that is the same from everywhere.
    [[nodiscard]] glm::vec3 gloss_albedo() const;

  private:
    void draw_out();
    void weigh_coat(const glm::vec3& metal, float metallic);
    void choose_lobes();
    // A direction in which light comes in, and what several lobes ask about it.
    struct Incoming {
        glm::vec3 direction, local;
        float open;                 // facing_share()
        GlossEnergy::Share coated;  // what the coat turns away, where a lobe below it asks
    };
    [[nodiscard]] Incoming incoming(const glm::vec3& direction, const glm::vec3& local) const;
    [[nodiscard]] float coat_share(const GlossEnergy::Share& coated) const;
    [[nodiscard]] float facing_share(const glm::vec3& direction, float cosine) const;
    [[nodiscard]] glm::vec3 schlick_at(float cosine) const;

    // bsdf_layers.cpp
    void lay_over();
    // What the layers let through from one side; `direction` points away from the surface.
    [[nodiscard]] float below_coat(const glm::vec3& direction) const;
    [[nodiscard]] float below_layers(const glm::vec3& direction, float cosine) const;
    [[nodiscard]] BsdfSample sample_coat(const glm::vec2& u) const;
    [[nodiscard]] LobeValue coat_value(const glm::vec3& direction) const;
    [[nodiscard]] LobeValue sheen_value(const glm::vec3& direction, const glm::vec3& local) const;
    [[nodiscard]] BsdfSample sample_base(Lobe lobe, float u_within, const glm::vec2& u) const;

    // Facets, drawn out or round.
    [[nodiscard]] float lambda(const glm::vec3& local) const;
    [[nodiscard]] float visible(const glm::vec3& half) const;
    [[nodiscard]] BsdfSample sample_cosine(Lobe lobe, const glm::vec2& u) const;
    [[nodiscard]] BsdfSample sample_gloss(const glm::vec2& u) const;
    [[nodiscard]] BsdfSample sample_smooth_glass(float u_choice) const;
    [[nodiscard]] BsdfSample sample_rough_glass(float u_choice, const glm::vec2& u) const;
    [[nodiscard]] LobeValue value_of(Lobe lobe, const Incoming& in) const;
    [[nodiscard]] LobeValue cosine_value(Lobe lobe, const Incoming& in) const;
    [[nodiscard]] LobeValue gloss_value(const glm::vec3& local) const;
    [[nodiscard]] LobeValue glass_value(const glm::vec3& local) const;
    [[nodiscard]] LobeValue bent_value(const glm::vec3& local) const;

    const ShadingPoint& at_;
    const GlossEnergy& energy_;
    glm::vec3 to_eye_;
    Basis basis_;
    glm::vec3 eye_{0.0f, 0.0f, 1.0f};  // to_eye in the surface's frame
    Border border_;

    float clear_ = 0.0f;  // share of the surface that is glass
    glm::vec3 tint_{1.0f};
    glm::vec3 base_{0.0f};
    // What facets mirror: at once, by Schlick, and after more bounces.
    struct Mirrored {
        glm::vec3 f0{0.0f};
        float f90 = 0.0f;
        glm::vec3 multi{0.0f};
        [[nodiscard]] glm::vec3 of(const GlossEnergy::Share& share) const {
            return share.of(f0, f90) + multi * (1.0f - share.white);
        }
    };
    void add_bounces(Mirrored& mirrored) const;
    Mirrored coat_of_paint_;  // which dims the base; where the surface is metal there is no base
    Mirrored gloss_;          // of paint and metal by their shares
    float roughness_ = 1.0f;
    float alpha_ = 1.0f;
    bool is_smooth_ = false;
    bool is_drawn_out_ = false;
    glm::vec2 alphas_{1.0f};  // if it is

    bool has_layers_ = false;
    float coat_ = 0.0f, coat_roughness_ = 0.0f;
    Basis coat_basis_;
    glm::vec3 coat_eye_{0.0f, 0.0f, 1.0f};
    glm::vec3 sheen_color_{0.0f};
    float sheen_most_ = 0.0f;
    float eye_below_coat_ = 1.0f, eye_below_ = 1.0f;  // what the layers leave to the eye
    float lambda_eye_ = 0.0f;

    GlossEnergy::Share seen_, mean_;
    float coat_left_ = 1.0f;  // what the coat lets out towards the eye over what it lets out on average
    std::array<float, kLobes> probability_{};
    std::size_t lobes_ =
        kLobes;  // from here on there are none: glass and layers come last, since few surfaces have them
    std::array<bool, kLobes> gives_{};
    bool takes_lamps_ = false;
};

}  // namespace gh::render
