// Pearson's test of the points lamps are asked at, in fine bins, against the density they claim.
#include "base/random.h"
#include "render/solid_angle.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace gh {
namespace {

constexpr int kSide = 16, kFine = 12, kSamples = 200'000;

// Bins that expect fewer than 20 go together. Wilson and Hilferty: the cube root of chi-square is nearly normal.
void expect_fit(const std::vector<double>& seen, const std::vector<double>& expected,
                const std::string& what) {
    double chi2 = 0.0, rest_seen = 0.0, rest_expected = 0.0, total = 0.0;
    int bins = -1;  // one is given by the others
    for (std::size_t i = 0; i < seen.size(); ++i) {
        total += expected[i];
        if (expected[i] < 20.0) {
            rest_seen += seen[i];
            rest_expected += expected[i];
            continue;
        }
        chi2 += (seen[i] - expected[i]) * (seen[i] - expected[i]) / expected[i];
        ++bins;
    }
    EXPECT_NEAR(total / kSamples, 1.0, 3e-3) << what << ": densities integrate to one";
    EXPECT_LT(std::abs(rest_seen - rest_expected), 5.0 * std::sqrt(rest_expected) + 5.0) << what;
    ASSERT_GT(bins, 60) << what;
    const double z = (std::cbrt(chi2 / bins) - (1.0 - 2.0 / (9.0 * bins))) / std::sqrt(2.0 / (9.0 * bins));
    EXPECT_LT(std::abs(z), 4.0) << what << ": chi2 " << chi2 << " over " << bins;
}

// Of a flat shape with coordinates in the unit square: `at` gives a place, `area` how much of it there is per square.
template <class Shape, class At, class Place>
void expect_flat_shape_fits(const Shape& shape, const glm::vec3& from, const glm::vec3& normal, double area,
                            At at, Place place, const std::string& what) {
    std::vector<double> seen(kSide * kSide, 0.0), expected(kSide * kSide, 0.0);
    Random random(13);
    for (int i = 0; i < kSamples; ++i) {
        const glm::vec2 u(random.unit(), random.unit());
        const render::ShapeSample s = render::pick(shape, from, u);
        ASSERT_GT(s.density, 0.0f) << what;
        const glm::vec2 uv = place(from + s.direction * s.distance);
        const int x = std::clamp(static_cast<int>(uv.x * kSide), 0, kSide - 1);
        const int y = std::clamp(static_cast<int>(uv.y * kSide), 0, kSide - 1);
        seen[static_cast<std::size_t>(y * kSide + x)] += 1.0;
    }
    constexpr int kAcross = kSide * kFine;
    for (int j = 0; j < kAcross; ++j) {
        for (int i = 0; i < kAcross; ++i) {
            const glm::vec2 uv((static_cast<float>(i) + 0.5f) / kAcross,
                               (static_cast<float>(j) + 0.5f) / kAcross);
            const auto [position, share] = at(uv);
            if (!(share > 0.0)) continue;
            const glm::dvec3 way = glm::dvec3(position) - glm::dvec3(from);
            const double d2 = glm::dot(way, way);
            const double covers = std::abs(glm::dot(glm::dvec3(normal), way)) / (d2 * std::sqrt(d2));
            expected[static_cast<std::size_t>(j / kFine * kSide + i / kFine)] +=
                static_cast<double>(render::density(shape, from, position)) * covers * area * share /
                (kAcross * kAcross) * kSamples;
        }
    }
    expect_fit(seen, expected, what);
}

TEST(LampChiSquare, PanelsNearFarAndGrazed) {
    const render::RectShape rect{{0.3f, 2, -0.4f}, {1.2f, 0, 0}, {0, 0, 0.7f}, {0, -1, 0}};
    for (const glm::vec3& from : {glm::vec3(0, 1, 0), glm::vec3(3, 1.7f, 1), glm::vec3(0.1f, 1.8f, -0.2f),
                                  glm::vec3(-2, -14, 6), glm::vec3(2, 3, 0)}) {
        expect_flat_shape_fits(
            rect, from, rect.normal, 4.0 * 1.2 * 0.7,
            [&](const glm::vec2& uv) {
                const glm::vec3 p =
                    rect.centre + rect.half_u * (2.0f * uv.x - 1.0f) + rect.half_v * (2.0f * uv.y - 1.0f);
                return std::pair(p, 1.0);
            },
            [&](const glm::vec3& p) {
                const glm::vec3 off = p - rect.centre;
                return glm::vec2(0.5f + 0.5f * off.x / 1.2f, 0.5f + 0.5f * off.z / 0.7f);
            },
            "panel from " + std::to_string(from.x) + " " + std::to_string(from.y));
    }
}

TEST(LampChiSquare, TrianglesNearFarAndGrazed) {
    const render::TriangleShape triangle{{{{-1, 2, -1}, {2, 2, -0.5f}, {0, 2.5f, 1.5f}}}};
    const glm::vec3 a = triangle.corner[1] - triangle.corner[0], b = triangle.corner[2] - triangle.corner[0];
    const glm::vec3 n = glm::cross(a, b);
    for (const glm::vec3& from : {glm::vec3(0, 1, 0), glm::vec3(-2, 1.5f, 1), glm::vec3(0.2f, 2.0f, 0.1f),
                                  glm::vec3(4, -15, 2), glm::vec3(0, 5, 0)}) {
        // (x, y) of the square is the point of barycentrics (x (1 - y), x y): twice x times the area there.
        expect_flat_shape_fits(
            triangle, from, glm::normalize(n), 0.5 * static_cast<double>(glm::length(n)),
            [&](const glm::vec2& uv) {
                const glm::vec3 p = triangle.corner[0] + a * (uv.x * (1.0f - uv.y)) + b * (uv.x * uv.y);
                return std::pair(p, 2.0 * static_cast<double>(uv.x));
            },
            [&](const glm::vec3& p) {
                const glm::vec3 off = p - triangle.corner[0];
                const float u = glm::dot(glm::cross(off, b), n) / glm::dot(n, n);
                const float v = glm::dot(glm::cross(a, off), n) / glm::dot(n, n);
                return glm::vec2(u + v, v / std::max(u + v, 1e-12f));
            },
            "triangle from " + std::to_string(from.x) + " " + std::to_string(from.y));
    }
}

// A ball is picked evenly over the cone it fills: bins of equal solid angle expect the same.
TEST(LampChiSquare, BallsFillTheirConeEvenly) {
    const render::BallShape ball{{0.2f, 3, -0.4f}, 0.7f};
    for (const glm::vec3& from :
         {glm::vec3(0.5f, 0, 0), glm::vec3(0.2f, 2.25f, -0.4f), glm::vec3(40, 3, 2)}) {
        const glm::dvec3 way = glm::dvec3(ball.centre) - glm::dvec3(from);
        const double distance = glm::length(way), sine = 0.7 / distance;
        const double cap = sine * sine / (1.0 + std::sqrt(1.0 - sine * sine));  // 1 - cosine
        const glm::dvec3 axis = way / distance;
        const glm::dvec3 side = glm::normalize(glm::cross(axis, glm::dvec3(0.3, 0.2, 0.9)));
        const glm::dvec3 over = glm::cross(axis, side);
        std::vector<double> seen(kSide * kSide, 0.0),
            expected(kSide * kSide, kSamples / double(kSide * kSide));
        Random random(29);
        for (int i = 0; i < kSamples; ++i) {
            const glm::vec2 u(random.unit(), random.unit());
            const render::ShapeSample s = render::pick(ball, from, u);
            EXPECT_NEAR(static_cast<double>(s.density) * 6.283185307 * cap, 1.0, 1e-4);
            const glm::dvec3 d(s.direction);
            const double x = glm::dot(d, side), y = glm::dot(d, over);
            const double off = (x * x + y * y) / (1.0 + glm::dot(d, axis)) / cap;  // 1 - cosine, in [0, 1]
            const double turn = std::atan2(y, x) / 6.283185307 + 0.5;
            const int row = std::clamp(static_cast<int>(off * kSide), 0, kSide - 1);
            const int column = std::clamp(static_cast<int>(turn * kSide), 0, kSide - 1);
            seen[static_cast<std::size_t>(row * kSide + column)] += 1.0;
        }
        expect_fit(seen, expected, "ball from " + std::to_string(from.x));
    }
}

}  // namespace
}  // namespace gh
