// Surfaces: nothing gained, nothing lost, in furnaces and mirrors; and samplers that do what they say.
#include "base/random.h"
#include "path_studio.h"
#include "render/bsdf.h"
#include "shaded.h"

#include <gtest/gtest.h>

#include <array>
#include <string>

namespace gh {
namespace {

using render::Bsdf;
using test::energy;
using test::facing_z;
using test::means;
using test::Studio;
using test::tilted;

world::Material metal(float roughness, float albedo = 1.0f) {
    world::Material material = test::mirror(albedo);
    material.roughness = roughness;
    return material;
}

// Mean weight over stratified samples of an opaque surface: the albedo.
double albedo_of(const Bsdf& bsdf, int side = 48, std::uint64_t seed = 7) {
    double sum = 0.0;
    Random random(seed);
    for (int i = 0; i < side; ++i) {
        for (int j = 0; j < side; ++j) {
            const glm::vec2 u((static_cast<float>(i) + random.unit()) / static_cast<float>(side),
                              (static_cast<float>(j) + random.unit()) / static_cast<float>(side));
            // Every lobe by itself, as often as it is picked: no chance in that.
            float below = 0.0f;
            for (const render::Lobe lobe :
                 {render::Lobe::Diffuse, render::Lobe::Gloss, render::Lobe::Multi}) {
                const float p = bsdf.probability(lobe);
                if (!(p > 0.0f)) continue;
                sum += static_cast<double>(p * bsdf.sample(below + 0.5f * p, u).weight.y);
                below += p;
            }
        }
    }
    return sum / (side * side);
}

// The same by sixteen independent estimates, with the error of their mean.
test::Moments albedos_of(const Bsdf& bsdf) {
    std::vector<double> all;
    for (std::uint64_t seed = 1; seed <= 16; ++seed) all.push_back(albedo_of(bsdf, 40, seed));
    return test::moments(all);
}

TEST(PathSurface, ALambertFurnaceGivesItsAlbedo) {
    const render::Environment light = test::even_light();
    Studio studio;
    studio.add_sheet(glm::vec3(0.0f), {0, 0, 10}, {10, 0, 0}, test::matte(glm::vec3(0.5f)));
    studio.open();
    render::PathSettings settings = test::reference(16);
    settings.environment = &light;
    settings.lamps = render::LampFinding::MeetOnly;
    for (const double mean : means(studio, test::looking_down(), settings, 3)) EXPECT_NEAR(mean, 0.5, 1e-6);
}

TEST(PathSurface, WhiteMetalGivesAllLightBackAtAnyRoughness) {
    for (const float alpha : {1e-4f, 1e-3f, 1e-2f, 0.04f, 0.1f, 0.25f, 0.5f, 0.8f, 1.0f}) {
        const world::Material material = metal(std::sqrt(alpha));
        const render::ShadingPoint at = facing_z(material);
        for (const float cosine : {0.1f, 0.3f, 0.6f, 0.9f, 1.0f}) {
            const Bsdf bsdf(at, tilted(cosine), {}, energy());
            const test::Moments albedo = albedos_of(bsdf);
            EXPECT_LT(albedo.mean, 1.0 + 1e-5 + 4.0 * albedo.error) << alpha << " cosine " << cosine;
            // What the table is kept above the truth by (gloss_energy.h) is what is lost.
            EXPECT_GT(albedo.mean, 1.0 - 1e-3 - 4.0 * albedo.error) << alpha << " cosine " << cosine;
        }
    }
}

// The same as a picture: what a furnace shows. What is lost is what the table is kept above the truth by.
TEST(PathSurface, AMetalFurnaceIsInvisible) {
    const render::Environment light = test::even_light();
    for (const float alpha : {1e-4f, 1e-2f, 0.1f, 1.0f}) {
        Studio studio;
        studio.add_sheet(glm::vec3(0.0f), {0, 0, 10}, {10, 0, 0}, metal(std::sqrt(alpha)));
        studio.open();
        render::PathSettings settings = test::reference(512);
        settings.environment = &light;
        settings.lamps = render::LampFinding::MeetOnly;
        const test::Moments seen =
            test::moments(means(studio, test::narrow({0, 0.5f, 0}, 0, -1.1f), settings, 16));
        EXPECT_LT(seen.mean, 1.0 + 1e-5 + 4.0 * seen.error) << "alpha " << alpha;
        EXPECT_GT(seen.mean, 1.0 - 1e-3 - 4.0 * seen.error) << "alpha " << alpha;
    }
}

TEST(PathSurface, NoSurfaceGivesMoreThanItGets) {
    for (const float metallic : {0.0f, 0.5f, 1.0f}) {
        for (const float roughness : {0.0f, 0.05f, 0.2f, 0.5f, 1.0f}) {
            world::Material material = metal(roughness);
            material.metallic = metallic;
            const render::ShadingPoint at = facing_z(material);
            for (const float cosine : {0.02f, 0.2f, 0.7f, 1.0f}) {
                const Bsdf bsdf(at, tilted(cosine), {}, energy());
                const test::Moments albedo = albedos_of(bsdf);
                EXPECT_LT(albedo.mean, 1.0 + 1e-5 + 4.0 * albedo.error)
                    << metallic << " " << roughness << " " << cosine;
            }
        }
    }
}

// A white base below a coat loses only what the coat's edges hide.
// glTF mixes what a metal and what a paint do, and so do edges in textures: half a metal gives back the mean of both. Paint
// dimmed by the mean's gloss gave a quarter too little.
TEST(PathSurface, HalfAMetalIsTheMeanOfMetalAndPaint) {
    const glm::vec3 color(0.8f, 0.5f, 0.3f);
    const auto gives = [&](float metallic, float roughness, float cos_eye, const glm::vec3& light) {
        world::Material material;
        material.base_color = glm::vec4(color, 1.0f);
        material.metallic = metallic;
        material.roughness = roughness;
        const render::ShadingPoint at = facing_z(material);
        const Bsdf bsdf(at, tilted(cos_eye), {}, energy());
        glm::vec3 sum(0.0f);
        for (const render::LobeValue& lobe : bsdf.value(light)) sum += lobe.value;
        return sum;
    };
    for (const float roughness : {0.0f, 0.3f, 1.0f}) {
        for (const float cos_eye : {0.2f, 0.9f}) {
            for (const glm::vec3& light : {tilted(0.3f, 1.0f), tilted(0.8f, 2.5f)}) {
                const glm::vec3 paint = gives(0.0f, roughness, cos_eye, light),
                                metal = gives(1.0f, roughness, cos_eye, light);
                for (const float metallic : {0.25f, 0.5f, 0.9f}) {
                    const glm::vec3 mean = glm::mix(paint, metal, metallic),
                                    found = gives(metallic, roughness, cos_eye, light);
                    for (glm::length_t i = 0; i < 3; ++i)  // roundings
                        EXPECT_NEAR(found[i], mean[i], 1e-5f * (1.0f + mean[i]))
                            << roughness << " " << metallic;
                }
            }
        }
    }
}

TEST(PathSurface, AWhiteBaseUnderACoatLosesNothingOnAverage) {
    for (const float roughness : {0.0f, 0.1f, 0.4f, 1.0f}) {
        world::Material material;
        material.roughness = roughness;
        const render::ShadingPoint at = facing_z(material);
        for (const float cosine : {0.2f, 0.6f, 1.0f}) {
            const Bsdf bsdf(at, tilted(cosine), {}, energy());
            const test::Moments albedo = albedos_of(bsdf);
            EXPECT_LT(albedo.mean, 1.0 + 1e-5 + 4.0 * albedo.error) << roughness << " " << cosine;
            EXPECT_GT(albedo.mean, 1.0 - 2e-3 - 4.0 * albedo.error) << roughness << " " << cosine;
        }
    }
}

TEST(PathSurface, LightGoesBothWaysAlike) {
    for (const float metallic : {0.0f, 0.3f, 1.0f}) {
        for (const float roughness : {0.15f, 0.5f, 1.0f}) {
            world::Material material = metal(roughness, 0.7f);
            material.metallic = metallic;
            const render::ShadingPoint at = facing_z(material);
            const glm::vec3 a = tilted(0.3f, 0.1f), b = tilted(0.8f, 2.0f);
            glm::vec3 there(0.0f), back(0.0f);
            for (const render::LobeValue& v : Bsdf(at, a, {}, energy()).value(b)) there += v.value / b.z;
            for (const render::LobeValue& v : Bsdf(at, b, {}, energy()).value(a)) back += v.value / a.z;
            EXPECT_NEAR(there.y / back.y, 1.0f, 2e-5f) << metallic << " " << roughness;
        }
    }
}

// Pearson's test of the directions a lobe gives against the density it claims, over cells of the sphere.
void expect_directions_fit(const Bsdf& bsdf, const std::string& what) {
    constexpr int kRows = 12, kColumns = 16, kSamples = 60'000, kFine = 12;
    std::vector<double> seen(kRows * kColumns, 0.0), expected(kRows * kColumns, 0.0);
    Random random(11);
    for (int i = 0; i < kSamples; ++i) {
        const float u_lobe = random.unit();
        const glm::vec2 u(random.unit(), random.unit());
        const render::BsdfSample s = bsdf.sample(u_lobe, u);
        if (!(s.density > 0.0f)) continue;
        const int row = std::min(kRows - 1, static_cast<int>((0.5f - 0.5f * s.direction.z) * kRows));
        const float turn = std::atan2(s.direction.y, s.direction.x) / 6.2831853f + 0.5f;
        const int column = std::min(kColumns - 1, static_cast<int>(turn * kColumns));
        seen[static_cast<std::size_t>(row * kColumns + column)] += 1.0;
    }
    for (int r = 0; r < kRows * kFine; ++r) {
        for (int c = 0; c < kColumns * kFine; ++c) {
            const float z = 1.0f - 2.0f * (static_cast<float>(r) + 0.5f) / (kRows * kFine);
            const float turn = ((static_cast<float>(c) + 0.5f) / (kColumns * kFine) - 0.5f) * 6.2831853f;
            const float sine = std::sqrt(1.0f - z * z);
            double density = 0.0;
            for (const render::LobeValue& v : bsdf.value({sine * std::cos(turn), sine * std::sin(turn), z}))
                density += static_cast<double>(v.density);
            expected[static_cast<std::size_t>(r / kFine * kColumns + c / kFine)] +=
                density * 4.0 * 3.14159265 / (kRows * kFine * kColumns * kFine) * kSamples;
        }
    }
    double chi2 = 0.0, rest_seen = 0.0, rest_expected = 0.0;
    int cells = 0;
    for (std::size_t i = 0; i < seen.size(); ++i) {
        if (expected[i] < 20.0) {
            rest_seen += seen[i];
            rest_expected += expected[i];
            continue;
        }
        chi2 += (seen[i] - expected[i]) * (seen[i] - expected[i]) / expected[i];
        ++cells;
    }
    EXPECT_LT(std::abs(rest_seen - rest_expected), 6.0 * std::sqrt(rest_expected) + 20.0) << what;
    // Wilson and Hilferty: the cube root is nearly normal.
    const double z = (std::cbrt(chi2 / cells) - (1.0 - 2.0 / (9.0 * cells))) / std::sqrt(2.0 / (9.0 * cells));
    EXPECT_LT(z, 4.0) << what << ": chi2 " << chi2 << " over " << cells << " cells";
    EXPECT_GT(cells, 8) << what;
}

TEST(PathSurface, DirectionsComeAsOftenAsTheirDensitySays) {
    for (const float roughness : {0.5f, 0.8f, 1.0f}) {
        for (const float cosine : {0.3f, 0.9f}) {
            const std::string what =
                "roughness " + std::to_string(roughness) + " cosine " + std::to_string(cosine);
            const world::Material shiny = metal(roughness);
            const render::ShadingPoint at = facing_z(shiny);
            expect_directions_fit(Bsdf(at, tilted(cosine), {}, energy()), "metal " + what);
            world::Material coated;
            coated.roughness = roughness;
            const render::ShadingPoint on_coat = facing_z(coated);
            expect_directions_fit(Bsdf(on_coat, tilted(cosine), {}, energy()), "coat " + what);
            world::Material glass = test::clear_glass(1.5f);
            glass.roughness = roughness;
            const render::ShadingPoint on_glass = facing_z(glass);
            expect_directions_fit(Bsdf(on_glass, tilted(cosine), {.eta = 1.5f}, energy()),
                                  "into glass " + what);
            expect_directions_fit(Bsdf(on_glass, tilted(cosine), {.eta = 1.0f / 1.5f}, energy()),
                                  "out of glass " + what);
            expect_directions_fit(Bsdf(on_glass, tilted(cosine), {.eta = 1.5f, .is_thin = true}, energy()),
                                  "sheet " + what);
        }
    }
}

// A sample's weight is its value over its density.
TEST(PathSurface, WeightsAreValuesOverDensities) {
    Random random(3);
    for (const float roughness : {0.1f, 0.5f, 1.0f}) {
        world::Material material = test::clear_glass(1.5f);
        material.transmission = 0.4f;
        material.metallic = 0.2f;
        material.base_color = {0.9f, 0.6f, 0.3f, 1.0f};
        material.roughness = roughness;
        const render::ShadingPoint at = facing_z(material);
        const Bsdf bsdf(at, tilted(0.6f), {.eta = 1.5f}, energy());
        for (int i = 0; i < 2000; ++i) {
            const float u_lobe = random.unit();
            const glm::vec2 u(random.unit(), random.unit());
            const render::BsdfSample s = bsdf.sample(u_lobe, u);
            if (!(s.weight.y > 0.0f)) continue;
            const render::LobeValue v = bsdf.value(s.direction)[static_cast<std::size_t>(s.lobe)];
            EXPECT_NEAR(v.density / s.density, 1.0f, 5e-3f) << static_cast<int>(s.lobe);
            EXPECT_NEAR(v.value.y / v.density / s.weight.y, 1.0f, 5e-3f) << static_cast<int>(s.lobe);
        }
    }
}

TEST(PathSurface, GlossGoesOverIntoAMirror) {
    world::Material smooth = metal(0.0f, 0.8f), rough = metal(0.0101f, 0.8f);
    const render::ShadingPoint at = facing_z(smooth), beside = facing_z(rough);
    for (const float cosine : {0.2f, 1.0f}) {
        EXPECT_NEAR(albedo_of(Bsdf(at, tilted(cosine), {}, energy())),
                    albedo_of(Bsdf(beside, tilted(cosine), {}, energy())), 1e-3);
    }
}

}  // namespace
}  // namespace gh
