// What lamps give is closed form; here against sums over the lamp's surface in double precision, and by hand.
#include "render/lamp.h"

#include "studio.h"
#include "support/random.h"

#include <gtest/gtest.h>

namespace gh {
namespace {

using world::Lamp;
using world::LampShape;

// The integral of cos cos / r^2 over the rectangle, by its middle points.
double summed_rect(const Lamp& lamp, const glm::dvec3& at, const glm::dvec3& normal) {
    constexpr int kSide = 400;
    double sum = 0.0;
    const glm::dvec3 u(lamp.half_u), v(lamp.half_v), direction(lamp.direction);
    for (int i = 0; i < kSide; ++i) {
        for (int j = 0; j < kSide; ++j) {
            const glm::dvec3 p = glm::dvec3(lamp.position) + u * ((2 * i + 1.0) / kSide - 1.0) +
                                 v * ((2 * j + 1.0) / kSide - 1.0) - at;
            const double r2 = glm::dot(p, p), r = std::sqrt(r2);
            const double there = -glm::dot(p, direction) / r, here = glm::dot(p, normal) / r;
            if (there > 0.0 && here > 0.0) sum += there * here / r2;
        }
    }
    return sum * 4.0 * glm::length(u) * glm::length(v) / (kSide * kSide);
}

// The integral of the cosine over the directions that meet the ball.
double summed_ball(double sin_radius, double cos_centre) {
    constexpr int kSide = 1500;
    const double cos_radius = std::sqrt(1.0 - sin_radius * sin_radius),
                 sin_centre = std::sqrt(1.0 - cos_centre * cos_centre);
    double sum = 0.0;
    for (int i = 0; i < kSide; ++i) {
        const double c = cos_radius + (1.0 - cos_radius) * (i + 0.5) / kSide, s = std::sqrt(1.0 - c * c);
        for (int j = 0; j < kSide; ++j) {
            const double phi = 2.0 * glm::pi<double>() * (j + 0.5) / kSide;
            sum += std::max(0.0, c * cos_centre + s * std::cos(phi) * sin_centre);
        }
    }
    return sum * 2.0 * glm::pi<double>() * (1.0 - cos_radius) / (static_cast<double>(kSide) * kSide);
}

Lamp unit_rect() {
    return {.name = {},
            .shape = LampShape::Rect,
            .position = {0, 1, 0},
            .direction = {0, -1, 0},
            .intensity = glm::vec3(1.0f),
            .half_u = {0.5f, 0, 0},
            .half_v = {0, 0, 0.5f}};
}

TEST(Lamp, AUnitPanelOneMetreAboveAGreyFloorGivesTheKnownRadiance) {
    const float irradiance = render::lamp_irradiance(unit_rect(), glm::vec3(0.0f), {0, 1, 0}).x;
    EXPECT_NEAR(irradiance * 0.5f / test::kPiF, 0.11972824f, 1e-6f);
}

TEST(Lamp, APanelGivesWhatItsPiecesGiveAlsoWhenItSetsBehindTheHorizon) {
    ::test::Random random(1);
    for (int i = 0; i < 12; ++i) {
        const glm::vec3 at = random.in_cube(1.5f) - glm::vec3(0, 1.2f, 0), normal = random.direction();
        const double expected = summed_rect(unit_rect(), glm::dvec3(at), glm::dvec3(normal));
        EXPECT_NEAR(render::lamp_irradiance(unit_rect(), at, normal).x, expected, 2e-4) << "case " << i;
    }
}

TEST(Lamp, APanelDoesNotShineBackwards) {
    EXPECT_EQ(render::lamp_irradiance(unit_rect(), {0, 2, 0}, {0, -1, 0}), glm::vec3(0.0f));
}

TEST(Lamp, ABallGivesPiLRadiusOverDistanceSquaredTimesTheCosine) {
    const Lamp ball{.name = {},
                    .shape = LampShape::Sphere,
                    .position = {0, 2, 0},
                    .intensity = glm::vec3(3.0f),
                    .radius = 0.25f};
    const glm::vec3 normal = glm::normalize(glm::vec3(0.6f, 0.8f, 0.0f));
    EXPECT_NEAR(render::lamp_irradiance(ball, glm::vec3(0.0f), normal).x, 3.0f * test::kPiF / 64.0f * 0.8f,
                1e-5f);
}

TEST(Lamp, ABallThatSetsBehindTheHorizonGivesWhatIsLeftOfIt) {
    const Lamp ball{.name = {},
                    .shape = LampShape::Sphere,
                    .position = {0, 2, 0},
                    .intensity = glm::vec3(1.0f),
                    .radius = 1.0f};
    for (const float cosine : {0.45f, 0.2f, 0.0f, -0.2f, -0.45f, -0.6f}) {
        const glm::vec3 normal(std::sqrt(1.0f - cosine * cosine), cosine, 0.0f);
        const float given = render::lamp_irradiance(ball, glm::vec3(0.0f), normal).x;
        EXPECT_NEAR(given, summed_ball(0.5, static_cast<double>(cosine)), 1e-4) << "cosine " << cosine;
    }
}

TEST(Lamp, PointSpotAndSunFollowTheirLaws) {
    Lamp point{.name = {}, .shape = LampShape::Point, .position = {0, 2, 0}, .intensity = glm::vec3(8.0f)};
    EXPECT_NEAR(render::lamp_irradiance(point, glm::vec3(0.0f), {0, 1, 0}).x, 2.0f, 1e-6f);
    point.range = 1.9f;
    EXPECT_EQ(render::lamp_irradiance(point, glm::vec3(0.0f), {0, 1, 0}).x, 0.0f) << "beyond its range";

    Lamp spot{.name = {},
              .shape = LampShape::Spot,
              .position = {0, 2, 0},
              .direction = {0, -1, 0},
              .intensity = glm::vec3(8.0f),
              .cos_inner = 0.9f,
              .cos_outer = 0.8f};
    EXPECT_NEAR(render::lamp_irradiance(spot, glm::vec3(0.0f), {0, 1, 0}).x, 2.0f, 1e-6f);
    EXPECT_EQ(render::lamp_irradiance(spot, {2, 0, 0}, {0, 1, 0}).x, 0.0f) << "beside its cone";

    const Lamp sun{
        .name = {}, .shape = LampShape::Sun, .direction = {0, -1, 0}, .intensity = glm::vec3(5.0f)};
    EXPECT_NEAR(render::lamp_irradiance(sun, {1e4f, 0, 0}, glm::normalize(glm::vec3(0, 3, 4))).x, 3.0f,
                1e-5f);
}

// Lists leave a lamp out by this bound, so it must never be too low.
TEST(Lamp, NoPointGetsMoreThanTheBoundForItsDistance) {
    ::test::Random random(5);
    Lamp ball{.name = {}, .shape = LampShape::Sphere, .intensity = glm::vec3(2.0f), .radius = 0.3f};
    Lamp panel = unit_rect();
    panel.position = glm::vec3(0.0f);
    for (int i = 0; i < 20'000; ++i) {
        const glm::vec3 at = random.in_cube(4.0f), normal = random.direction();
        for (const Lamp& lamp : {ball, panel}) {
            EXPECT_LE(render::lamp_irradiance(lamp, at, normal).x,
                      render::lamp_bound(lamp, glm::length(at)) * 1.0001f);
        }
    }
}

}  // namespace
}  // namespace gh
