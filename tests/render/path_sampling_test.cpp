// The numbers paths are made from: how evenly they lie, and how fast errors fall because of it.
#include "base/random.h"
#include "path_studio.h"
#include "render/environment.h"
#include "render/light_tree.h"
#include "render/sample_sequence.h"
#include "render/solid_angle.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <numeric>

namespace gh {
namespace {

using render::SampleKind;
using render::SampleSequence;

constexpr SampleKind kKinds[] = {SampleKind::Iid, SampleKind::Jittered, SampleKind::Sobol,
                                 SampleKind::BlueNoise};

// Irradiance from a 1x1 panel 1 m above, asked by area.
double panel(const glm::vec2& u) {
    const double x = static_cast<double>(u.x) - 0.5, z = static_cast<double>(u.y) - 0.5,
                 d2 = x * x + z * z + 1.0;
    return 1.0 / (d2 * d2);
}
constexpr double kPanel = 0.11972824 * 2.0 * 3.14159265358979;

double relative_error(SampleKind kind, std::uint32_t count) {
    double sum = 0.0;
    constexpr int kPixels = 400;
    for (int pixel = 0; pixel < kPixels; ++pixel) {
        const SampleSequence sequence({kind, count, 77}, pixel % 20, pixel / 20, 0);
        double mean = 0.0;
        for (std::uint32_t s = 0; s < count; ++s) mean += panel(sequence.two(s, 5));
        mean /= count;
        sum += (mean / kPanel - 1.0) * (mean / kPanel - 1.0);
    }
    return std::sqrt(sum / kPixels);
}

TEST(PathSampling, ErrorsFallAsFastAsTheirKindPromises) {
    const auto slope = [](SampleKind kind) {
        return std::log(relative_error(kind, 256) / relative_error(kind, 4)) / std::log(64.0);
    };
    EXPECT_NEAR(slope(SampleKind::Iid), -0.50, 0.08);
    EXPECT_NEAR(slope(SampleKind::Jittered), -1.01, 0.08);
    EXPECT_NEAR(slope(SampleKind::Sobol), -1.41, 0.08);
    EXPECT_NEAR(slope(SampleKind::BlueNoise), -1.41, 0.08);
}

TEST(PathSampling, EveryKindIsUnbiased) {
    for (const SampleKind kind : kKinds) {
        for (const std::uint32_t count : {1u, 3u, 7u, 16u}) {
            std::vector<double> results;
            for (std::uint32_t seed = 0; seed < 600; ++seed) {
                const SampleSequence sequence({kind, count, seed}, 13, 8, 2);
                double mean = 0.0;
                for (std::uint32_t s = 0; s < count; ++s)
                    mean += panel(sequence.two(s, 3)) * static_cast<double>(sequence.one(s, 4)) * 2.0;
                results.push_back(mean / count);
            }
            test::expect_mean(results, kPanel, 0.05, "kind " + std::to_string(static_cast<int>(kind)));
        }
    }
}

TEST(PathSampling, NumbersLieInTheUnitIntervalAndFillIt) {
    for (const SampleKind kind : kKinds) {
        std::array<int, 16> seen{};
        for (std::uint32_t pixel = 0; pixel < 64; ++pixel) {
            const SampleSequence sequence({kind, 16, 1}, static_cast<int>(pixel), 300, 7);
            for (std::uint32_t s = 0; s < 16; ++s) {
                const float x = sequence.one(s, 9);
                const glm::vec2 u = sequence.two(s, 9);
                EXPECT_TRUE(x >= 0.0f && x < 1.0f && u.x >= 0.0f && u.x < 1.0f && u.y >= 0.0f && u.y < 1.0f);
                ++seen[static_cast<std::size_t>(x * 16.0f)];
            }
        }
        for (const int count : seen) EXPECT_NEAR(count, 64, 40);
    }
}

// Sixteen points of a pixel put one into each cell of every 16-cell grid whose sides are powers of two.
TEST(PathSampling, SobolPointsAreEven) {
    for (const SampleKind kind : {SampleKind::Sobol, SampleKind::BlueNoise}) {
        const SampleSequence sequence({kind, 16, 5}, 3, 4, 9);
        for (const int across : {1, 2, 4, 8, 16}) {
            std::array<int, 16> seen{};
            for (std::uint32_t s = 0; s < 16; ++s) {
                const glm::vec2 u = sequence.two(s, 11);
                const int x = static_cast<int>(u.x * static_cast<float>(across));
                const int y = static_cast<int>(u.y * (16.0f / static_cast<float>(across)));
                ++seen[static_cast<std::size_t>(y * across + x)];
            }
            for (const int count : seen) EXPECT_EQ(count, 1) << across;
        }
    }
}

// Blurring a picture by 4x4 takes more of blue noise's error away than of white noise's.
TEST(PathSampling, BlueNoiseHidesItsErrorFromTheNeighbours) {
    const auto blurred_error = [](SampleKind kind) {
        constexpr int kSide = 64, kBlur = 4;
        std::vector<double> error(kSide * kSide);
        for (int i = 0; i < kSide * kSide; ++i) {
            const SampleSequence sequence({kind, 1, 3}, i % kSide, i / kSide, 0);
            error[static_cast<std::size_t>(i)] = panel(sequence.two(0, 2)) - kPanel;
        }
        double sum = 0.0;
        for (int y = 0; y < kSide; y += kBlur) {
            for (int x = 0; x < kSide; x += kBlur) {
                double block = 0.0;
                for (int k = 0; k < kBlur * kBlur; ++k)
                    block += error[static_cast<std::size_t>((y + k / kBlur) * kSide + x + k % kBlur)];
                sum += block * block;
            }
        }
        return std::sqrt(sum);
    };
    EXPECT_LT(blurred_error(SampleKind::BlueNoise), 0.5 * blurred_error(SampleKind::Iid));
    EXPECT_LT(blurred_error(SampleKind::BlueNoise), 0.5 * blurred_error(SampleKind::Sobol));
}

// Frames go on where the last one stopped.
TEST(PathSampling, SobolGainsOverFrames) {
    double together = 0.0, apart = 0.0;
    for (int pixel = 0; pixel < 200; ++pixel) {
        double mean = 0.0, same = 0.0;
        for (std::uint32_t frame = 0; frame < 16; ++frame) {
            mean += panel(SampleSequence({SampleKind::Sobol, 1, 3}, pixel, 0, frame).two(0, 2)) / 16.0;
            same += panel(SampleSequence({SampleKind::Iid, 1, 3}, pixel, 0, frame).two(0, 2)) / 16.0;
        }
        together += (mean - kPanel) * (mean - kPanel);
        apart += (same - kPanel) * (same - kPanel);
    }
    EXPECT_LT(together, 0.1 * apart);
}

// Directions picked over a shape's solid angle, gathered in bins of its surface, against what their density says.
template <class Shape, class Bin>
void expect_even(const Shape& shape, const glm::vec3& from, std::size_t bins, Bin bin_of) {
    Random random(5);
    std::vector<double> weight(bins, 0.0), seen(bins, 0.0);
    constexpr int kCount = 40'000;
    for (int i = 0; i < kCount; ++i) {
        const glm::vec2 u(random.unit(), random.unit());
        const render::ShapeSample s = render::pick(shape, from, u);
        ASSERT_GT(s.density, 0.0f);
        EXPECT_NEAR(glm::length(s.direction), 1.0f, 1e-5f);
        const std::size_t bin = bin_of(from + s.direction * s.distance, s);
        ASSERT_LT(bin, bins);
        seen[bin] += 1.0;
        weight[bin] += 1.0 / static_cast<double>(s.density);  // sums to the bin's solid angle
    }
    // Inside a bin all densities are alike: its share of samples is its solid angle times that.
    const double whole = std::accumulate(weight.begin(), weight.end(), 0.0);
    double chi2 = 0.0;
    for (std::size_t i = 0; i < bins; ++i) {
        const double expected = kCount * weight[i] / whole;
        chi2 += (seen[i] - expected) * (seen[i] - expected) / expected;
    }
    EXPECT_LT(chi2, 1e-3 * kCount);
}

double solid_angle_by_grid(const glm::vec3& centre, const glm::vec3& half_u, const glm::vec3& half_v,
                           const glm::vec3& from) {
    const glm::vec3 normal = glm::normalize(glm::cross(half_u, half_v));
    double sum = 0.0;
    constexpr int kSide = 600;
    for (int i = 0; i < kSide * kSide; ++i) {
        const float x = (static_cast<float>(i % kSide) + 0.5f) * 2.0f / kSide - 1.0f;
        const float y = (static_cast<float>(i / kSide) + 0.5f) * 2.0f / kSide - 1.0f;
        const glm::vec3 offset = centre + half_u * x + half_v * y - from;
        const double d2 = static_cast<double>(glm::dot(offset, offset));
        sum += std::abs(static_cast<double>(glm::dot(normal, offset))) / (d2 * std::sqrt(d2));
    }
    return sum * 4.0 * static_cast<double>(glm::length(half_u) * glm::length(half_v)) / (kSide * kSide);
}

TEST(PathSampling, ARectangleIsPickedEvenlyOverItsSolidAngle) {
    const render::RectShape rect{{0.3f, 2, -0.4f}, {1.2f, 0, 0}, {0, 0, 0.7f}, {0, -1, 0}};
    for (const glm::vec3& from : {glm::vec3(0, 1, 0), glm::vec3(3, 1.7f, 1), glm::vec3(0, 1.95f, 0)}) {
        const auto bin = [&](const glm::vec3& at, const render::ShapeSample&) {
            const glm::vec3 local = at - rect.centre;
            EXPECT_NEAR(local.y, 0.0f, 2e-4f);
            const int x = std::clamp(static_cast<int>((local.x / 1.2f + 1.0f) * 4.0f), 0, 7);
            const int z = std::clamp(static_cast<int>((local.z / 0.7f + 1.0f) * 4.0f), 0, 7);
            return static_cast<std::size_t>(z * 8 + x);
        };
        expect_even(rect, from, 64, bin);
        const double truth = solid_angle_by_grid(rect.centre, rect.half_u, rect.half_v, from);
        EXPECT_NEAR(1.0 / (static_cast<double>(render::density(rect, from, rect.centre)) * truth), 1.0, 2e-3);
        EXPECT_NEAR(render::pick(rect, from, {0.3f, 0.6f}).density, render::density(rect, from, rect.centre),
                    1e-4f);
    }
}

TEST(PathSampling, ATriangleIsPickedEvenlyOverItsSolidAngle) {
    const render::TriangleShape triangle{{{{-1, 2, -1}, {2, 2, -0.5f}, {0, 2.5f, 1.5f}}}};
    for (const glm::vec3& from : {glm::vec3(0, 1, 0), glm::vec3(-2, 1.5f, 1)}) {
        const auto bin = [&](const glm::vec3& at, const render::ShapeSample&) {
            const glm::vec3 a = triangle.corner[1] - triangle.corner[0],
                            b = triangle.corner[2] - triangle.corner[0];
            const glm::vec3 n = glm::cross(a, b), p = at - triangle.corner[0];
            const float u = glm::dot(glm::cross(p, b), n) / glm::dot(n, n),
                        v = glm::dot(glm::cross(a, p), n) / glm::dot(n, n);
            EXPECT_TRUE(u > -1e-3f && v > -1e-3f && u + v < 1.001f) << u << " " << v;
            return static_cast<std::size_t>(std::clamp(static_cast<int>(u * 4.0f), 0, 3) * 4 +
                                            std::clamp(static_cast<int>(v * 4.0f), 0, 3));
        };
        Random random(9);
        std::array<double, 16> seen{}, truth{};
        for (int i = 0; i < 40'000; ++i) {
            const render::ShapeSample s = render::pick(triangle, from, {random.unit(), random.unit()});
            seen[bin(from + s.direction * s.distance, s)] += 1.0 / 40'000;
            // By area, weighed by what each point covers.
            const float root = std::sqrt(random.unit()), v = random.unit();
            const glm::vec3 at = triangle.corner[0] * (1.0f - root) +
                                 triangle.corner[1] * (root * (1.0f - v)) + triangle.corner[2] * (root * v);
            const glm::vec3 a = triangle.corner[1] - triangle.corner[0],
                            b = triangle.corner[2] - triangle.corner[0];
            const glm::vec3 n = glm::cross(a, b), offset = at - from;
            const double d2 = static_cast<double>(glm::dot(offset, offset));
            const double covers =
                0.5 * std::abs(static_cast<double>(glm::dot(n, offset))) / (d2 * std::sqrt(d2)) / 40'000;
            truth[bin(at, s)] += covers * static_cast<double>(s.density);
        }
        for (std::size_t i = 0; i < 16; ++i) EXPECT_NEAR(seen[i], truth[i], 0.012) << i;
        EXPECT_NEAR(std::accumulate(truth.begin(), truth.end(), 0.0), 1.0, 0.02);
    }
}

TEST(PathSampling, ABallIsPickedInItsConeOnly) {
    const render::BallShape ball{{0, 3, 0}, 0.7f};
    Random random(2);
    glm::dvec3 mean(0.0);
    for (int i = 0; i < 20'000; ++i) {
        const render::ShapeSample s = render::pick(ball, {0.5f, 0, 0}, {random.unit(), random.unit()});
        EXPECT_GE(render::distance_to(render::BallShape{ball.centre, 0.7001f}, {0.5f, 0, 0}, s.direction),
                  0.0f);
        mean += glm::dvec3(s.direction) / 20'000.0;
    }
    // The mean direction of a cone of half angle t is its axis times (1 + cos t) / 2.
    const double sin2 = 0.49 / 9.25;
    EXPECT_NEAR(glm::length(mean), 0.5 * (1.0 + std::sqrt(1.0 - sin2)), 2e-4);
    EXPECT_NEAR(static_cast<double>(render::density(ball, {0.5f, 0, 0})) * 2.0 * 3.14159265 *
                    (1.0 - std::sqrt(1.0 - sin2)),
                1.0, 1e-4);
}

TEST(PathSampling, TheTreePicksAsOftenAsItSays) {
    Random random(4);
    std::vector<render::LightBounds> lights(40);
    for (render::LightBounds& light : lights) {
        light.min = {random.in_range(-5, 5), random.in_range(0, 5), random.in_range(-5, 5)};
        light.max = light.min + glm::vec3(random.unit(), random.unit(), random.unit());
        light.axis = glm::normalize(glm::vec3(random.in_range(-1, 1), -1.0f, random.in_range(-1, 1)));
        light.cos_normals = random.unit() < 0.5f ? 1.0f : -1.0f;
        light.power = random.unit() < 0.1f ? 0.0f : random.unit() * 10.0f;
    }
    const render::LightTree tree(lights);
    for (const glm::vec3& normal : {glm::vec3(0, 1, 0), glm::vec3(1, 0, 0), glm::vec3(0.0f)}) {
        const render::LightQuery query{{0.3f, -0.5f, 0.2f}, normal};
        std::vector<double> seen(lights.size(), 0.0);
        constexpr int kCount = 40'000;
        for (int i = 0; i < kCount; ++i) {
            const auto pick = tree.pick(query, (static_cast<float>(i) + 0.5f) / kCount);
            if (!(pick.probability > 0.0f)) continue;
            seen[pick.light] += 1.0 / kCount;
            EXPECT_NEAR(pick.probability / tree.probability(query, pick.light), 1.0f, 1e-5f);
        }
        for (std::uint32_t i = 0; i < lights.size(); ++i)
            EXPECT_NEAR(seen[i], static_cast<double>(tree.probability(query, i)), 3e-4) << i;
    }
}

TEST(PathSampling, TheEnvironmentIsPickedAsOftenAsItIsBright) {
    Image picture(6, 5);
    Random random(8);
    for (glm::vec3& pixel : picture.pixels)
        pixel = glm::vec3(random.unit() < 0.3f ? 0.0f : random.unit() * 4.0f);
    const render::Environment sky(std::move(picture));
    double sum = 0.0;
    for (int i = 0; i < 20'000; ++i) {
        const auto pick = sky.pick({random.unit(), random.unit()});
        ASSERT_GT(pick.density, 0.0f);
        EXPECT_NEAR(pick.density, sky.density(pick.direction), 1e-3f * pick.density);
        EXPECT_EQ(pick.radiance, sky.radiance(pick.direction));
        sum += static_cast<double>(pick.radiance.y / pick.density) / 20'000.0;
    }
    EXPECT_NEAR(sum / (4.0 * 3.14159265) / static_cast<double>(sky.mean_radiance()), 1.0, 1e-4);
}

}  // namespace
}  // namespace gh
