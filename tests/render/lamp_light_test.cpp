// What a lamp does at sixteen surfaces side by side is, to the bit, what lamp.h says of each alone.
#include "render/lamp_light.h"

#include "base/random.h"
#include "render/colour.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <gtest/gtest.h>
#include <hwy/highway.h>

#include <algorithm>
#include <vector>

namespace gh {
namespace {

using render::direction_to;
using render::kLitTogether;
using render::lamp_highlight;
using render::lamp_irradiance;
using render::lane;
using render::set_lane;

glm::vec3 place(Random& random) {
    return glm::vec3(random.unit(), random.unit(), random.unit()) * 6.0f - 3.0f;
}

// Of every shape; some touch the surfaces around them, some reach nowhere near.
world::Lamp random_lamp(Random& random, int i) {
    world::Lamp lamp;
    lamp.shape = static_cast<world::LampShape>(i % 5);
    lamp.position = place(random);
    lamp.direction = glm::normalize(place(random));
    lamp.intensity = glm::vec3(random.unit(), random.unit(), random.unit()) * (i % 3 == 0 ? 0.02f : 9.0f);
    if (i % 4 == 0) lamp.range = 4.0f * random.unit();
    if (lamp.shape == world::LampShape::Sphere) lamp.radius = (i % 2 == 0 ? 1.0f : 0.1f) * random.unit();
    if (lamp.shape == world::LampShape::Rect) {
        const glm::vec3 u = glm::normalize(glm::cross(lamp.direction, place(random)));
        lamp.half_u = u * (i % 2 == 0 ? 1.5f : 0.2f) * random.unit();
        lamp.half_v = glm::cross(lamp.direction, u) * random.unit();
    }
    lamp.cos_inner = 0.9f;
    lamp.cos_outer = 0.9f * random.unit();
    return lamp;
}

render::LitSurfaces random_surfaces(Random& random, std::size_t count) {
    render::LitSurfaces surfaces;
    surfaces.count = count;
    for (std::size_t i = 0; i < kLitTogether; ++i) {
        const glm::vec3 normal = glm::normalize(place(random));
        const glm::vec3 bent = i % 2 == 0 ? normal : glm::normalize(normal + place(random) * 0.1f);
        set_lane(surfaces.position, i, place(random));
        set_lane(surfaces.normal, i, bent);
        set_lane(surfaces.geometric, i, normal);
        set_lane(surfaces.to_eye, i, glm::normalize(normal * 3.1f + place(random)));
        set_lane(surfaces.f0, i, glm::vec3(0.04f, 0.5f, 0.9f) * random.unit());
        set_lane(surfaces.diffuse, i, glm::vec3(random.unit() * 0.3f));
        set_lane(surfaces.weight, i, glm::vec3(random.unit()));
        surfaces.f90[i] = i % 5 == 0 ? 0.0f : 1.0f;
        surfaces.alpha[i] = random.unit() * random.unit();
    }
    return surfaces;
}

// One surface's, in plain numbers.
struct Sums {
    glm::vec3 irradiance{0.0f}, shine{0.0f}, light{0.0f};
    glm::mat3 turns{0.0f};
};

float faded(float light) {
    return std::clamp(light / 4e-4f - 1.0f, 0.0f, 1.0f);
}

float terminator(const glm::vec3& geometric, const glm::vec3& normal, const glm::vec3& to_lamp) {
    const float cos_bend = glm::dot(geometric, normal), cos_smooth = glm::dot(normal, to_lamp);
    if (cos_bend > 0.99999f || !(cos_smooth > 0.0f)) return 1.0f;
    const float cos_geometric = glm::dot(geometric, to_lamp);
    const float g = std::clamp(cos_geometric / (cos_smooth * std::max(cos_bend, 0.05f)), 0.0f, 1.0f);
    return g * (1.0f + g - g * g);
}

// What lamp.h and lamp_bounds.h say; false where it is not to be seen.
bool add_by_itself(const world::Lamp& lamp, const render::LitSurfaces& surfaces, std::size_t i, Sums& sums) {
    const render::LampReach reach = render::lamp_reach(lamp);
    const glm::vec3 position = lane(surfaces.position, i), normal = lane(surfaces.normal, i);
    const glm::vec3 diffuse = lane(surfaces.diffuse, i), weight = lane(surfaces.weight, i);
    const render::Gloss gloss{normal, lane(surfaces.to_eye, i), lane(surfaces.f0, i), surfaces.f90[i],
                              surfaces.alpha[i]};
    const render::IrradianceBound bound = irradiance_bound(reach, position, normal);
    const bool scatters = bound.facing * render::brightest(diffuse) > 1e-4f;
    const bool shines =
        gloss.f90 > 0.0f && bound.any > 0.0f &&
        highlight_bound(reach, bound.any, position, gloss) * render::brightest(weight) > 1e-4f;
    if (!scatters && !shines) return false;
    const glm::vec3 to_lamp = direction_to(lamp, position);
    const float share = terminator(lane(surfaces.geometric, i), normal, to_lamp);
    glm::vec3 irradiance(0.0f), shine(0.0f);
    if (scatters) irradiance = lamp_irradiance(lamp, position, normal) * share;
    if (shines) shine = lamp_highlight(lamp, position, gloss) * share;
    const glm::vec3 light = diffuse * irradiance + weight * shine;
    const float counts = faded(render::brightest(light));
    if (!(counts > 0.0f)) return false;
    sums.light = light * counts;
    irradiance *= counts;
    sums.irradiance += irradiance;
    sums.shine += shine * counts;
    const float cosine = glm::dot(to_lamp, normal);
    if (cosine > 0.05f) sums.turns += glm::outerProduct(irradiance / cosine, to_lamp);
    return true;
}

TEST(LampsTogether, IsForEverySurfaceWhatLampsAreByThemselves) {
    Random random(5);
    int seen = 0, cut = 0;
    for (std::size_t round = 0; round < 100; ++round) {
        const render::LitSurfaces surfaces = random_surfaces(random, 1 + round % kLitTogether);
        render::LampSums sums;
        std::vector<Sums> alone(kLitTogether);
        for (int k = 0; k < 20; ++k) {
            const world::Lamp lamp = random_lamp(random, k);
            const render::LampNumbers numbers = lamp_numbers(lamp, render::lamp_reach(lamp));
            render::LampLight light;
            for (std::size_t i = 0; i < surfaces.count; ++i)
                light.asked[i] = random.unit() < 0.8f ? 0.5f : 0.0f;
            const bool is_seen = add_lamp(lamp, numbers, surfaces, light, sums);
            bool any = false;
            for (std::size_t i = 0; i < surfaces.count; ++i) {
                const bool counts = light.asked[i] != 0.0f && add_by_itself(lamp, surfaces, i, alone[i]);
                EXPECT_EQ(is_seen && light.counts[i] > 0.0f, counts) << "shape " << k % 5;
                if (!counts) continue;
                any = true;
                ++seen;
                cut += light.is_cut[i] != 0.0f;
                EXPECT_EQ(lane(light.light, i), alone[i].light) << "shape " << k % 5;
            }
            EXPECT_EQ(is_seen, any);
        }
        for (std::size_t i = 0; i < surfaces.count; ++i) {
            EXPECT_EQ(lane(sums.irradiance, i), alone[i].irradiance);
            EXPECT_EQ(lane(sums.shine, i), alone[i].shine);
            EXPECT_EQ(sums.turns_at(i), alone[i].turns);
        }
    }
    EXPECT_GT(seen, 100 * 8 * 2)
        << "one surface in six sees a lamp: the others face away, or are not asked for";
    EXPECT_GT(cut, 50) << "the horizon cuts some";
}

TEST(LampsTogether, HasTheSameBitsOnEveryInstructionSet) {
    Random random(6);
    for (int k = 0; k < 200; ++k) {
        const render::LitSurfaces surfaces = random_surfaces(random, kLitTogether);
        const world::Lamp lamp = random_lamp(random, k);
        const render::LampNumbers numbers = lamp_numbers(lamp, render::lamp_reach(lamp));
        std::vector<render::LampLight> lights;
        for (std::int64_t left = hwy::SupportedTargets() & HWY_TARGETS; left != 0; left &= left - 1) {
            hwy::SetSupportedTargetsForTest(left & -left);
            hwy::GetChosenTarget().Update(hwy::SupportedTargets());
            render::LampLight& light = lights.emplace_back();
            std::fill(std::begin(light.asked), std::end(light.asked), 1.0f);
            render::LampSums sums;
            (void)add_lamp(lamp, numbers, surfaces, light, sums);
            hwy::SetSupportedTargetsForTest(0);
            hwy::GetChosenTarget().Update(hwy::SupportedTargets());
            for (std::size_t i = 0; i < kLitTogether; ++i) {
                EXPECT_EQ(light.counts[i], lights[0].counts[i]);
                if (light.counts[i] > 0.0f) {
                    EXPECT_EQ(lane(light.light, i), lane(lights[0].light, i));
                }
            }
        }
    }
}

}  // namespace
}  // namespace gh
