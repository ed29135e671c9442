// Half a metal is metal on half of the surface (glTF 2.0, appendix B): it gives back the mean of what paint and metal do.
#include "studio.h"

#include <gtest/gtest.h>

#include <cstddef>

namespace gh {
namespace {

constexpr glm::ivec2 kSize(32, 24);
constexpr glm::vec3 kColour(0.8f, 0.3f, 0.1f);

// A floor of it under a lamp that nothing hides, and nothing else to mirror. Rough enough for paint to send no mirrored ray,
// and below where its highlights fade.
Image floor_picture(float metallic, float roughness) {
    world::Material floor = test::matte(kColour);
    floor.ior = 1.5f;
    floor.metallic = metallic;
    floor.roughness = roughness;
    test::Studio studio;
    studio.add_sheet({0, 0, 0}, {4, 0, 0}, {0, 0, -4}, floor);
    studio.add_lamp({.name = {},
                     .shape = world::LampShape::Sphere,
                     .position = {0.3f, 1.5f, -1.0f},
                     .intensity = glm::vec3(300.0f),
                     .radius = 0.05f});
    studio.open();
    return studio.picture({.position = {0.0f, 1.4f, 2.5f}, .pitch = -0.5f, .fov_y = 1.0f}, kSize.x, kSize.y,
                          test::exact());
}

TEST(Whitted, HalfAMetalIsTheMeanOfPaintAndMetal) {
    for (const float roughness : {0.3f, 0.45f, 0.6f}) {
        const Image paint = floor_picture(0.0f, roughness), metal = floor_picture(1.0f, roughness);
        for (const float metallic : {0.25f, 0.5f}) {
            const Image mixed = floor_picture(metallic, roughness);
            int lit = 0;
            for (std::size_t i = 0; i < mixed.pixels.size(); ++i) {
                const glm::vec3 mean = glm::mix(paint.pixels[i], metal.pixels[i], metallic);
                if (mean.x < 0.1f)
                    continue;  // lamps that bring next to nothing fade away, each picture's at its own place
                ++lit;
                for (const std::size_t c : {0u, 1u, 2u}) {
                    // Everything is linear in what is given back head on and at grazing angles; a few roundings remain.
                    EXPECT_NEAR(mixed.pixels[i][c], mean[c], 2e-5f * mean[c]) << roughness << " " << i;
                }
            }
            EXPECT_GT(lit, 50);
        }
    }
}

}  // namespace
}  // namespace gh
