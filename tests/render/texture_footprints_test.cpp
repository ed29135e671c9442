// The patches of texture under pixels: against the ellipse worked out in double precision, and alike on every instruction
// set.
#include "render/texture_footprints.h"

#include "base/random.h"
#include "targets.h"

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <vector>

namespace gh {
namespace {

constexpr float kMostTaps = 4.0f;

glm::vec3 unit(Random& random) {
    const glm::vec3 v(random.unit() - 0.5f, random.unit() - 0.5f, random.unit() - 0.5f);
    return glm::normalize(v + glm::vec3(0.0f, 1e-3f, 0.0f));
}

void put(const glm::vec3& way, render::TexturePatches::Lanes (&lanes)[3], std::size_t i) {
    for (glm::length_t axis = 0; axis < 3; ++axis) lanes[axis][i] = way[axis];
}
glm::dvec3 taken(const render::TexturePatches::Lanes (&lanes)[3], std::size_t i) {
    return {lanes[0][i], lanes[1][i], lanes[2][i]};
}

render::TexturePatches some_patches(Random& random) {
    render::TexturePatches patches;
    std::memset(&patches, 0, sizeof(patches));
    for (std::size_t i = 0; i < render::kPatches; ++i) {
        const glm::vec3 normal = unit(random);
        put(normal, patches.normal, i);
        put(i % 5 == 0 ? -normal : unit(random), patches.direction, i);  // every fifth head on
        const glm::vec3 u = unit(random);
        put(u - normal * glm::dot(u, normal), patches.u_gradient, i);
        put(glm::cross(u, normal) * 0.7f, patches.v_gradient, i);
        patches.cone_width[i] = std::exp2(random.unit() * 12.0f - 11.0f);
        patches.uv[0][i] = random.unit() * 8.0f - 4.0f;
        patches.uv[1][i] = random.unit() * 8.0f - 4.0f;
        patches.size[0][i] = 512.0f;
        patches.size[1][i] = 256.0f;
        patches.last_level[i] = 7.0f;
    }
    return patches;
}

struct Ellipse {
    glm::dvec2 major;  // texture units
    double major_texels, minor_texels;
};
Ellipse ellipse_of(const render::TexturePatches& patches, std::size_t i) {
    const glm::dvec3 d = taken(patches.direction, i), n = taken(patches.normal, i);
    const glm::dvec3 gradient_u = taken(patches.u_gradient, i), gradient_v = taken(patches.v_gradient, i);
    const double cosine = glm::dot(d, n);
    const glm::dvec3 slant = d - n * cosine;
    const glm::dvec3 along = glm::normalize(slant), across = glm::cross(n, along);
    const auto width = static_cast<double>(patches.cone_width[i]);
    const auto uv_along = [&](const glm::dvec3& way) {
        return glm::dvec2(glm::dot(way, gradient_u), glm::dot(way, gradient_v));
    };
    const glm::dvec2 size(patches.size[0][i], patches.size[1][i]);
    const glm::dvec2 major = uv_along(along * (width / std::max(std::abs(cosine), 0.02)));
    return {major, glm::length(major * size), glm::length(uv_along(across * width) * size)};
}

TEST(TextureFootprints, AreTheConesEllipse) {
    Random random(5);
    int many = 0;
    for (int round = 0; round < 200; ++round) {
        render::TexturePatches patches = some_patches(random);
        render::place_taps(patches, render::kPatches, kMostTaps);
        for (std::size_t i = 0; i < render::kPatches; ++i) {
            if (i % 5 == 0) continue;  // it has no long axis
            const Ellipse ellipse = ellipse_of(patches, i);
            const double wanted = std::ceil(ellipse.major_texels / std::max(ellipse.minor_texels, 1.0));
            const double taps = std::clamp(wanted, 1.0, static_cast<double>(kMostTaps));
            if (std::abs(static_cast<double>(patches.taps[i]) - taps) > 0.5) {  // but where rounding decides
                const double ratio = ellipse.major_texels / std::max(ellipse.minor_texels, 1.0);
                EXPECT_LT(std::abs(ratio - std::round(ratio)), 1e-4);
                continue;
            }
            many += taps > 1.0 ? 1 : 0;
            const double width = std::max(ellipse.minor_texels, ellipse.major_texels / taps);
            // The logarithm is good to 1.2e-4; a slant of 1e-3 has lost three digits of seven.
            EXPECT_NEAR(static_cast<double>(patches.level[i]), std::clamp(std::log2(width), 0.0, 7.0), 4e-4);
            const glm::dvec2 first(patches.first[0][i], patches.first[1][i]);
            const glm::dvec2 step(patches.step[0][i], patches.step[1][i]);
            const glm::dvec2 middle = first + step * (0.5 * (taps - 1.0));
            EXPECT_LT(glm::length(middle - glm::dvec2(patches.uv[0][i], patches.uv[1][i])),
                      1e-5 * (1.0 + glm::length(ellipse.major)));
            const glm::dvec2 whole = taps > 1.0 ? ellipse.major : glm::dvec2(0.0);
            EXPECT_LE(glm::length(step * taps - whole), 1e-3 * glm::length(whole));
        }
    }
    EXPECT_GT(many, 500);
}

TEST(TextureFootprints, HaveTheSameBitsOnEveryInstructionSet) {
    Random random(6);
    for (int round = 0; round < 50; ++round) {
        const render::TexturePatches asked = some_patches(random);
        std::vector<std::byte> first;
        test::on_every_target([&] {
            render::TexturePatches patches = asked;
            render::place_taps(patches, render::kPatches, kMostTaps);
            std::vector<std::byte> bytes(sizeof(patches));
            std::memcpy(bytes.data(), &patches, sizeof(patches));
            if (first.empty()) first = bytes;
            EXPECT_EQ(bytes, first);
        });
    }
}

// A mesh without area or with uvs of nonsense must not send a look-up out of its texture.
TEST(TextureFootprints, OfNonsenseAreOneTapOfTheFinestLevelAtTheOrigin) {
    Random random(7);
    render::TexturePatches patches = some_patches(random);
    for (std::size_t i = 0; i < render::kPatches; ++i) {
        patches.u_gradient[0][i] = NAN;
        patches.uv[i % 2][i] = i % 3 == 0 ? NAN : 1e30f;
    }
    render::place_taps(patches, render::kPatches, kMostTaps);
    for (std::size_t i = 0; i < render::kPatches; ++i) {
        EXPECT_EQ(patches.taps[i], 1.0f);
        EXPECT_EQ(patches.level[i], 0.0f);
        EXPECT_EQ(patches.first[0][i], 0.0f);
        EXPECT_EQ(patches.first[1][i], 0.0f);
    }
}

}  // namespace
}  // namespace gh
