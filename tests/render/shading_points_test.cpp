// Hits that are made ready for shading side by side are what each would be by itself.
#include "base/random.h"
#include "render/shading_point.h"
#include "studio.h"

#include "raycore/query.h"

#include <gtest/gtest.h>

#include <vector>

namespace gh {
namespace {

using test::Studio;

// A box whose material has the first `textures` of base colour, roughness, normal map and emission; all are noise.
void add_textured_box(Studio& studio, const glm::vec3& min, const glm::vec3& max, int textures,
                      Random& random) {
    world::Material material;
    material.emission = glm::vec3(1.0f);
    std::uint32_t* const slots[] = {&material.base_color_texture, &material.metallic_roughness_texture,
                                    &material.normal_texture, &material.emission_texture};
    for (int i = 0; i < textures; ++i) {
        *slots[i] = static_cast<std::uint32_t>(studio.level.textures.size());
        world::Texture texture{.name = "noise", .width = 16, .height = 16, .rgba = {}};
        for (int k = 0; k < 16 * 16 * 4; ++k)
            texture.rgba.push_back(static_cast<std::uint8_t>(random.below(256)));
        studio.level.textures.push_back(texture);
    }
    studio.add_box(min, max, material);
}

bool are_same(const render::ShadingPoint& a, const render::ShadingPoint& b) {
    return a.surface.position == b.surface.position && a.material == b.material && a.part == b.part &&
           a.is_entering == b.is_entering && a.geometric == b.geometric && a.normal == b.normal &&
           a.smooth == b.smooth && a.base_color == b.base_color && a.alpha == b.alpha &&
           a.metallic == b.metallic && a.roughness == b.roughness && a.emission == b.emission;
}

TEST(ShadingPoints, AreThoseOfEachHit) {
    Random random(3);
    Studio studio;
    for (int i = 0; i < 5; ++i) {
        const auto x = static_cast<float>(i);
        add_textured_box(studio, {x, 0, 0}, {x + 0.8f, 1, 1}, i, random);
    }
    studio.open();
    const render::SceneView view{studio.level, studio.snapshot, studio.prepared};
    std::vector<rc::Ray> rays;
    std::vector<rc::Hit> hits;
    while (hits.size() < 200) {
        const glm::vec3 at(5.0f * random.unit(), random.unit(), 0.5f);
        const rc::Ray ray{.origin = {2.5f, 2.0f, 3.0f},
                          .direction = glm::normalize(at - glm::vec3(2.5f, 2.0f, 3.0f))};
        const auto hit = rc::closest_hit(*studio.snapshot.scene, ray, world::Light);
        if (!hit) continue;
        rays.push_back(ray);
        hits.push_back(*hit);
    }
    std::vector<render::PointAsked> asked;
    for (std::size_t i = 0; i < hits.size(); ++i)
        asked.push_back({&rays[i], &hits[i], 0.1f * random.unit(), i % 7 < 4 ? 1.0f : 4.0f});
    std::vector<render::ShadingPoint> points(asked.size());
    render::shading_points(view, asked, points);
    int differences = 0;
    for (std::size_t i = 0; i < asked.size(); ++i) {
        const auto alone =
            render::shading_point(view, rays[i], hits[i], asked[i].cone_width, asked[i].max_taps);
        differences += !are_same(points[i], alone);
    }
    EXPECT_EQ(differences, 0);
}

}  // namespace
}  // namespace gh
