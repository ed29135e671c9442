// Varnish, cloth and brushed metal: never more light than there is, both ways alike, sampled as they claim.
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
using render::Lobe;
using test::energy;
using test::Studio;
using test::tilted;

struct Surface {
    std::string name;
    world::Material material;
    render::ShadingPoint at;
};

// A white surface facing +z with a layer of its own.
Surface surface(const std::string& name, float metallic, float roughness) {
    Surface s;
    s.name = name;
    s.material.has_layers = true;
    s.at.geometric = s.at.normal = s.at.smooth = s.at.coat_normal = {0, 0, 1};
    s.at.base_color = glm::vec3(1.0f);
    s.at.metallic = metallic;
    s.at.roughness = roughness;
    return s;
}

std::vector<Surface> surfaces() {
    std::vector<Surface> all;
    for (const float roughness : {0.3f, 0.9f}) {
        Surface varnish = surface("varnish", 0.0f, 0.8f);
        varnish.at.coat = 1.0f;
        varnish.at.coat_roughness = roughness;
        all.push_back(varnish);
        Surface cloth = surface("cloth", 0.0f, 1.0f);
        cloth.at.sheen_color = glm::vec3(1.0f, 0.5f, 0.2f);
        cloth.at.sheen_roughness = roughness;
        all.push_back(cloth);
        Surface brushed = surface("brushed", 1.0f, roughness);
        brushed.at.anisotropy = 0.8f;
        brushed.at.drawn_out = {0.6f, 0.8f, 0.0f};
        all.push_back(brushed);
        Surface grained = brushed;
        grained.name = "brushed plastic";
        grained.at.metallic = 0.0f;
        all.push_back(grained);
        Surface everything = brushed;
        everything.name = "everything";
        everything.at.metallic = 0.4f;
        everything.at.coat = 0.6f;
        everything.at.coat_roughness = 0.4f;
        everything.at.sheen_color = glm::vec3(0.8f);
        everything.at.sheen_roughness = roughness;
        everything.at.specular_color = glm::vec3(3.0f, 1.0f, 0.1f);
        all.push_back(everything);
    }
    for (Surface& s : all) s.name += " " + std::to_string(s.at.roughness);
    return all;
}

// Mean weight over stratified samples, every lobe by itself, as often as it is picked: the albedo.
glm::dvec3 albedo_of(const Bsdf& bsdf, std::uint64_t seed = 7, bool with_diffuse = true) {
    constexpr int kSide = 64;
    glm::dvec3 sum(0.0);
    Random random(seed);
    for (int i = 0; i < kSide * kSide; ++i) {
        const glm::vec2 u((static_cast<float>(i % kSide) + random.unit()) / kSide,
                          (static_cast<float>(i / kSide) + random.unit()) / kSide);
        float below = 0.0f;
        for (std::size_t lobe = 0; lobe < render::kLobes; ++lobe) {
            const float p = bsdf.probability(static_cast<Lobe>(lobe));
            const bool counts = with_diffuse || static_cast<Lobe>(lobe) != Lobe::Diffuse;
            if (p > 0.0f && counts) sum += glm::dvec3(bsdf.sample(below + 0.5f * p, u).weight * p);
            below += p;
        }
    }
    return sum / static_cast<double>(kSide * kSide);
}

TEST(PathLayers, NoSurfaceGivesMoreThanItGets) {
    for (Surface& s : surfaces()) {
        s.at.material = &s.material;
        for (const float cosine : {0.05f, 0.3f, 0.7f, 1.0f}) {
            const Bsdf bsdf(s.at, tilted(cosine), {}, energy());
            for (glm::length_t c = 0; c < 3; ++c) {
                std::vector<double> all;
                for (std::uint64_t seed = 1; seed <= 16; ++seed) all.push_back(albedo_of(bsdf, seed)[c]);
                const test::Moments albedo = test::moments(all);
                EXPECT_LT(albedo.mean, 1.0 + 1e-5 + 4.0 * albedo.error) << s.name << " at " << cosine;
                if (c == 0) {
                    EXPECT_GT(albedo.mean, 0.5) << s.name << " at " << cosine << ": white in red";
                }
            }
        }
    }
}

// Filters take the light off gloss apart from this and put it on again: were it far off, textures would blur.
TEST(PathLayers, GlossAlbedoIsWhatAllButTheDiffuseLobeGiveBack) {
    for (Surface& s : surfaces()) {
        s.at.material = &s.material;
        for (const float cosine : {0.3f, 0.7f, 1.0f}) {
            const Bsdf bsdf(s.at, tilted(cosine), {}, energy());
            for (glm::length_t c = 0; c < 3; ++c) {
                const auto found = static_cast<float>(albedo_of(bsdf, 7, false)[c]);
                // Highlights drawn out darken, of which the tables know nothing.
                const float most = s.at.anisotropy > 0.0f ? 3.0f * found : found;
                EXPECT_LT(bsdf.gloss_albedo()[c], 0.01f + 1.1f * most) << s.name << " at " << cosine;
                EXPECT_GT(bsdf.gloss_albedo()[c], 0.9f * found - 0.01f) << s.name << " at " << cosine;
            }
        }
    }
}

TEST(PathLayers, LightGoesBothWaysAlike) {
    for (Surface& s : surfaces()) {
        s.at.material = &s.material;
        const glm::vec3 a = tilted(0.3f, 0.1f), b = tilted(0.8f, 2.0f);
        glm::vec3 there(0.0f), back(0.0f);
        for (const render::LobeValue& v : Bsdf(s.at, a, {}, energy()).value(b)) there += v.value / b.z;
        for (const render::LobeValue& v : Bsdf(s.at, b, {}, energy()).value(a)) back += v.value / a.z;
        for (glm::length_t c = 0; c < 3; ++c) EXPECT_NEAR(there[c] / back[c], 1.0f, 5e-5f) << s.name;
    }
}

// Directions that were sampled, against the density integrated over the cells of a fine grid (32 x 64, each cell 8 x 8
// midpoints); Pearson's test, Wilson and Hilferty's normal deviate.
void expect_directions_fit(const Bsdf& bsdf, const std::string& what) {
    constexpr int kRows = 32, kColumns = 64, kSamples = 100'000, kFine = 8;
    std::vector<double> seen(kRows * kColumns, 0.0), expected(kRows * kColumns, 0.0);
    Random random(11);
    for (int i = 0; i < kSamples; ++i) {
        const float u_lobe = random.unit();
        const glm::vec2 u(random.unit(), random.unit());
        const render::BsdfSample s = bsdf.sample(u_lobe, u);
        if (!(s.density > 0.0f)) continue;
        const int row = std::clamp(static_cast<int>((1.0f - s.direction.z) * kRows), 0, kRows - 1);
        const float turn = std::atan2(s.direction.y, s.direction.x) / (2.0f * test::kPiF) + 0.5f;
        const int column = std::min(kColumns - 1, static_cast<int>(turn * kColumns));
        seen[static_cast<std::size_t>(row * kColumns + column)] += 1.0;
    }
    for (int r = 0; r < kRows * kFine; ++r) {
        for (int c = 0; c < kColumns * kFine; ++c) {
            const float z = 1.0f - (static_cast<float>(r) + 0.5f) / (kRows * kFine);
            const float turn =
                ((static_cast<float>(c) + 0.5f) / (kColumns * kFine) - 0.5f) * 2.0f * test::kPiF;
            double density = 0.0;
            for (const render::LobeValue& v : bsdf.value(tilted(z, turn)))
                density += static_cast<double>(v.density);
            expected[static_cast<std::size_t>(r / kFine * kColumns + c / kFine)] +=
                density * 2.0 * 3.14159265358979 / (kRows * kFine * kColumns * kFine) * kSamples;
        }
    }
    double chi2 = 0.0;
    int cells = 0;
    for (std::size_t i = 0; i < seen.size(); ++i) {
        if (expected[i] < 20.0) continue;
        chi2 += (seen[i] - expected[i]) * (seen[i] - expected[i]) / expected[i];
        ++cells;
    }
    ASSERT_GT(cells, 100) << what;
    const double z = (std::cbrt(chi2 / cells) - (1.0 - 2.0 / (9.0 * cells))) / std::sqrt(2.0 / (9.0 * cells));
    EXPECT_LT(z, 4.0) << what << ": chi2 " << chi2 << " over " << cells << " cells";
}

TEST(PathLayers, DirectionsComeAsOftenAsTheirDensitySays) {
    for (Surface& s : surfaces()) {
        s.at.material = &s.material;
        expect_directions_fit(Bsdf(s.at, tilted(0.7f), {}, energy()), s.name);
    }
}

TEST(PathLayers, WeightsAreValuesOverDensities) {
    Random random(3);
    for (Surface& s : surfaces()) {
        s.at.material = &s.material;
        const Bsdf bsdf(s.at, tilted(0.6f), {}, energy());
        for (int i = 0; i < 500; ++i) {
            const float u_lobe = random.unit();
            const glm::vec2 u(random.unit(), random.unit());
            const render::BsdfSample sample = bsdf.sample(u_lobe, u);
            if (!(sample.weight.x > 0.0f)) continue;
            const render::LobeValue v = bsdf.value(sample.lobe, sample.direction);
            EXPECT_NEAR(v.density / sample.density, 1.0f, 5e-3f) << s.name << static_cast<int>(sample.lobe);
            EXPECT_NEAR(v.value.x / v.density / sample.weight.x, 1.0f, 5e-3f) << s.name;
        }
    }
}

// Brushed along x: the highlight is a streak along x (the facets' normals spread that way), and turning the brush by a
// right angle turns the streak.
TEST(PathLayers, BrushedMetalStreaksAlongItsGrain) {
    Surface s = surface("brushed", 1.0f, 0.3f);
    s.at.material = &s.material;
    s.at.anisotropy = 1.0f;
    s.at.drawn_out = {1, 0, 0};
    const auto gloss = [&](const glm::vec3& light) {
        return Bsdf(s.at, {0, 0, 1}, {}, energy()).value(Lobe::Gloss, light).value.x;
    };
    const glm::vec3 along = tilted(0.8f, 0.0f), across = tilted(0.8f, 0.5f * test::kPiF);
    const float with_grain = gloss(along), against = gloss(across);
    EXPECT_GT(with_grain, 10.0f * against);
    s.at.drawn_out = {0, 1, 0};
    EXPECT_NEAR(gloss(across) / with_grain, 1.0f, 1e-4f);
    EXPECT_NEAR(gloss(along) / against, 1.0f, 1e-4f);
    s.at.drawn_out = {0, 0, 1};  // no way along the surface
    EXPECT_NEAR(gloss(along) / gloss(across), 1.0f, 1e-4f) << "round again";
}

// Over black, varnish alone is seen: as much as the table says that facets of index 1.5 give back.
TEST(PathLayers, VarnishOverBlackGivesItsOwnAlbedo) {
    for (const float roughness : {0.2f, 0.6f, 1.0f}) {
        Surface s = surface("varnish", 0.0f, 1.0f);
        s.material.ior = 1.0f;
        s.at.material = &s.material;
        s.at.base_color = glm::vec3(0.0f);
        s.at.specular = 0.0f;
        s.at.coat = 0.5f;
        s.at.coat_roughness = roughness;
        const float expected = 0.5f * energy().towards(0.6f, roughness).of(glm::vec3(0.04f), 1.0f).x;
        const Bsdf bsdf(s.at, tilted(0.6f), {}, energy());
        EXPECT_NEAR(albedo_of(bsdf).x, static_cast<double>(expected), 1e-3) << roughness;
    }
}

// Cloth at grazing angles is brighter than face on, which is what one sees of velvet.
TEST(PathLayers, ClothShinesAtItsRim) {
    Surface s = surface("velvet", 0.0f, 1.0f);
    s.at.material = &s.material;
    s.at.base_color = glm::vec3(0.05f);
    s.at.specular = 0.0f;
    s.at.sheen_color = glm::vec3(0.6f);
    s.at.sheen_roughness = 0.4f;
    const double rim = albedo_of(Bsdf(s.at, tilted(0.1f), {}, energy())).x;
    const double middle = albedo_of(Bsdf(s.at, tilted(1.0f), {}, energy())).x;
    EXPECT_GT(rim, 2.0 * middle);
}

// Wrong numbers, no uvs, triangles without area in uv: a picture, and no pixel that is not a number.
TEST(PathLayers, BrokenLayersMakeAPicture) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    for (const float bad : {nan, -5.0f, 1e30f, rc::kInfinity}) {
        for (const bool has_uvs : {false, true}) {
            world::Material material;
            material.has_layers = true;
            material.layers = {.specular_color = glm::vec3(bad),
                               .sheen_color = glm::vec3(bad),
                               .sheen_roughness = bad,
                               .coat = bad,
                               .coat_roughness = bad,
                               .anisotropy = bad,
                               .anisotropy_rotation = 0.3f};
            Studio studio;
            studio.add_box({-2, 0, -2}, {2, 2, 2}, material, true);
            studio.add_sheet({0, 1.9f, 0}, {0.5f, 0, 0}, {0, 0, 0.5f}, test::glowing(10.0f));
            world::Mesh& mesh = studio.level.meshes[0];
            if (has_uvs) {
                mesh.uvs.assign(mesh.positions.size(), glm::vec2(0.25f));
            } else {
                mesh.uvs.clear();
            }
            studio.open();
            const Image picture = test::path_picture(studio, {.position = {0, 1, 1.5f}, .fov_y = 1.2f}, 16,
                                                     16, test::reference(4));
            for (const glm::vec3& pixel : picture.pixels)
                EXPECT_TRUE(pixel.x + pixel.y + pixel.z < rc::kInfinity) << "with " << bad;
        }
    }
}

}  // namespace
}  // namespace gh
