// What few surfaces have: colours at their corners, mirrored parts, a varnish with bumps of its own, glass by a picture.
#include "load/fuse_parts.h"
#include "render/clear_mesh.h"
#include "render/environment.h"
#include "render/shading_point.h"
#include "shaded.h"
#include "studio.h"

#include "raycore/query.h"

#include <gtest/gtest.h>

namespace gh {
namespace {

using test::Studio;

constexpr glm::vec3 kAhead(0.0f, 0.0f, -1.0f);

// A square of 2 m in the plane z = 0 that faces +z, u to the right and v down.
world::Mesh uv_square() {
    world::Mesh mesh;
    mesh.positions = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
    mesh.normals.assign(4, {0, 0, 1});
    mesh.uvs = {{0, 1}, {1, 1}, {1, 0}, {0, 0}};
    mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
    return mesh;
}

// One colour all over.
std::uint32_t add_texture(Studio& studio, const glm::u8vec4& color) {
    studio.level.textures.push_back(
        {.name = "plain", .width = 1, .height = 1, .rgba = {color.x, color.y, color.z, color.w}});
    return static_cast<std::uint32_t>(studio.level.textures.size() - 1);
}

// What is straight ahead of (x, y, 1).
render::ShadingPoint seen_from(const Studio& studio, float x, float y) {
    const rc::Ray ray{.origin = {x, y, 1.0f}, .direction = kAhead};
    const auto hit = rc::closest_hit(*studio.snapshot.scene, ray, world::Light);
    EXPECT_TRUE(hit);
    return render::shading_point({studio.level, studio.snapshot, studio.prepared}, ray, *hit, 0.0f);
}

void expect_near(const glm::vec3& found, const glm::vec3& truth) {
    for (glm::length_t i = 0; i < 3; ++i) EXPECT_NEAR(found[i], truth[i], 1e-6f) << "component " << i;
}

TEST(SurfaceDetails, ColoursOfCornersTimesTheMaterialsOwn) {
    Studio studio;
    world::Mesh mesh = uv_square();
    for (const glm::vec3& p : mesh.positions)  // linear in x and y, and so exact in between
        mesh.colors.emplace_back(0.5f + 0.25f * p.x, 0.5f + 0.5f * p.y, 1.0f, 0.5f + 0.25f * p.x);
    world::Material material = test::matte({0.8f, 0.6f, 0.4f});
    material.alpha_mode = world::AlphaMode::Blend;
    studio.add_part(mesh, material);
    studio.open();
    for (const glm::vec2 at : {glm::vec2(0.3f, -0.6f), glm::vec2(-0.7f, 0.2f)}) {
        const render::ShadingPoint point = seen_from(studio, at.x, at.y);
        const float share = 0.5f + 0.25f * at.x;
        expect_near(point.base_color, {0.8f * share, 0.6f * (0.5f + 0.5f * at.y), 0.4f});
        EXPECT_NEAR(point.alpha, share, 1e-6f);
        const rc::Ray ray{.origin = {at.x, at.y, 1.0f}, .direction = kAhead};
        const auto hit = rc::closest_hit(*studio.snapshot.scene, ray, world::Light);
        const auto clear = render::clearness({studio.level, studio.snapshot, studio.prepared}, *hit);
        expect_near(clear.share, glm::vec3(1.0f - share));
    }
}

// A part that is mirrored shows the mirror image of its bumps, whether it stands by itself or was fused with others.
// Texel (.75, .5 + .25, ...) leans right and up; mirrored left to right it must lean left and up.
TEST(SurfaceDetails, BumpsOfAMirroredPartAreMirrored) {
    for (const bool has_tangents : {false, true}) {
        for (const glm::vec3& scale : {glm::vec3(1, 1, 1), glm::vec3(-1, 1, 1), glm::vec3(1, -1, 1)}) {
            Studio studio;
            world::Mesh mesh = uv_square();
            if (has_tangents) mesh.tangents.assign(4, {1, 0, 0, 1});
            world::Material material;
            material.normal_texture = add_texture(studio, {191, 217, 233, 255});
            const std::uint32_t part = studio.add_part(mesh, material);
            studio.level.parts[part].mover_from_part = glm::mat4x3(
                glm::vec3(scale.x, 0, 0), glm::vec3(0, scale.y, 0), glm::vec3(0, 0, 1), glm::vec3(0.0f));
            studio.level.stone_part_begin = 1;
            studio.open();
            const glm::vec3 texel = glm::vec3(191, 217, 233) / 255.0f * 2.0f - 1.0f;
            expect_near(seen_from(studio, 0.3f, 0.4f).normal, glm::normalize(texel * scale));
        }
    }
}

TEST(SurfaceDetails, VarnishHasBumpsOfItsOwn) {
    Studio studio;
    world::Material material;
    material.has_layers = true;
    material.layers.coat = 1.0f;
    material.layers.coat_normal_scale = 0.5f;
    material.layers.coat_normal_texture = add_texture(studio, {204, 128, 255, 255});
    studio.add_part(uv_square(), material);
    studio.open();
    const render::ShadingPoint point = seen_from(studio, 0.1f, 0.2f);
    const glm::vec3 texel = glm::vec3(204, 128, 255) / 255.0f * 2.0f - 1.0f;
    expect_near(point.coat_normal, glm::normalize(texel * glm::vec3(0.5f, 0.5f, 1.0f)));
    expect_near(point.normal, {0, 0, 1});
    // And mirrors by them: what the coat gives is most where half of the way between eye and light is its normal.
    const render::Bsdf bsdf(point, {0, 0, 1}, {}, test::energy());
    const glm::vec3 mirrored = 2.0f * point.coat_normal.z * point.coat_normal - glm::vec3(0, 0, 1);
    const float there = bsdf.value(render::Lobe::Coat, mirrored).value.x;
    const float beside = bsdf.value(render::Lobe::Coat, glm::vec3(0, 0, 1)).value.x;
    EXPECT_GT(there, 100.0f * beside);
}

TEST(SurfaceDetails, APictureSaysHowMuchIsGlass) {
    Studio studio;
    world::Material glass = test::clear_glass(1.5f);
    glass.transmission = 0.5f;
    glass.transmission_texture = add_texture(studio, {51, 255, 255, 255});  // a fifth
    studio.add_part(uv_square(), glass);
    studio.open();
    const render::ShadingPoint point = seen_from(studio, 0.1f, 0.2f);
    EXPECT_NEAR(point.transmission, 0.1f, 1e-6f);
    const rc::Ray ray{.origin = {0.1f, 0.2f, 1.0f}, .direction = kAhead};
    const auto hit = rc::closest_hit(*studio.snapshot.scene, ray, world::Light);
    const auto clear = render::clearness({studio.level, studio.snapshot, studio.prepared}, *hit);
    EXPECT_NEAR(clear.glass, 0.1f, 1e-6f);
}

// A ball whose first and last meridian were computed apart, as many programs write it: sin(2 pi) is not 0, and the poles are
// not points. `turn`: of its seam about the axis.
world::Mesh ball_with_seam(float turn) {
    world::Mesh ball;
    constexpr unsigned kRings = 12, kSectors = 24, kCorners = kSectors + 1;
    for (unsigned r = 0; r <= kRings; ++r) {
        for (unsigned s = 0; s < kCorners; ++s) {
            const float theta = test::kPiF * static_cast<float>(r) / kRings,
                        phi = 2.0f * test::kPiF * static_cast<float>(s) / kSectors + turn;
            ball.positions.emplace_back(std::sin(theta) * std::cos(phi), std::cos(theta),
                                        std::sin(theta) * std::sin(phi));
        }
    }
    for (unsigned r = 0; r < kRings; ++r) {
        for (unsigned s = 0; s < kSectors; ++s) {
            const unsigned a = r * kCorners + s, b = a + kCorners;
            if (r > 0) ball.triangles.emplace_back(a, a + 1, b);
            if (r + 1 < kRings) ball.triangles.emplace_back(a + 1, b + 1, b);
        }
    }
    ball.materials.assign(ball.triangles.size(), 0);
    return ball;
}

TEST(SurfaceDetails, ABallOfGlassIsClosedAlongItsSeam) {
    world::Level level;
    level.materials.push_back(test::clear_glass(1.5f));
    for (const float turn : {0.0f, 0.4f, 2.5f}) {
        world::Mesh ball = ball_with_seam(turn);
        EXPECT_TRUE(render::is_closed_glass(level, ball)) << turn;
        for (glm::vec3& p : ball.positions) p = p * 0.001f + glm::vec3(0.003f);  // small, beside its origin
        EXPECT_TRUE(render::is_closed_glass(level, ball)) << turn;
        ball.triangles.pop_back();
        ball.materials.pop_back();
        EXPECT_FALSE(render::is_closed_glass(level, ball)) << turn;
    }
}

// The middle of a sky's picture is +x and a quarter left of it is -z: what was turned to look right in Blender does here.
TEST(SurfaceDetails, ASkysPictureIsTurnedAsInBlender) {
    Image picture(4, 2);
    for (int x = 0; x < 4; ++x) picture.at(x, 0) = picture.at(x, 1) = glm::vec3(static_cast<float>(x + 1));
    const render::Environment sky(std::move(picture));
    const auto along = [&](float x, float z) {
        return sky.radiance(glm::normalize(glm::vec3(x, 0.1f, z))).x;
    };
    EXPECT_EQ(along(-1.0f, -0.1f), 1.0f);
    EXPECT_EQ(along(0.1f, -1.0f), 2.0f);
    EXPECT_EQ(along(1.0f, 0.1f), 3.0f);
    EXPECT_EQ(along(-0.1f, 1.0f), 4.0f);
}

// glTF's word for what mirrors all that its colour of reflection lets it.
TEST(SurfaceDetails, AnIndexOfZeroMirrorsAll) {
    world::Material material;
    material.ior = 0.0f;
    material.roughness = 0.0f;
    const render::ShadingPoint at = test::facing_z(material);
    const render::Bsdf bsdf(at, test::tilted(0.6f), {}, test::energy());
    expect_near(bsdf.gloss_albedo(), glm::vec3(1.0f));
}

}  // namespace
}  // namespace gh
