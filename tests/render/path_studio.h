// tests/render/path_studio.h - path-traced pictures of little scenes, judged by t-tests over independent seeds.
#pragma once

#include "render/environment.h"
#include "render/path_tracer.h"
#include "studio.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <vector>

namespace gh::test {

inline constexpr int kSeeds = 24;

// Nothing left out, nothing clamped.
inline render::PathSettings reference(int samples_per_pixel = 64) {
    render::PathSettings settings;
    settings.samples_per_pixel = samples_per_pixel;
    return settings;
}

inline Image path_picture(const Studio& studio, const render::Camera& camera, int width, int height,
                          const render::PathSettings& settings, std::uint32_t frame = 0,
                          const Jobs& jobs = Jobs(1)) {
    render::Film film(width, height);
    render::render_path({studio.level, studio.snapshot, studio.prepared}, camera, settings, frame, jobs,
                        film);
    return std::move(film.radiance);
}

// Mean of green over a picture of 4x4, one a seed.
inline std::vector<double> means(const Studio& studio, const render::Camera& camera,
                                 render::PathSettings settings, int seeds = kSeeds) {
    std::vector<double> result;
    for (int seed = 0; seed < seeds; ++seed) {
        settings.seed = static_cast<std::uint32_t>(seed + 1);
        double sum = 0.0;
        const Image picture = path_picture(studio, camera, 4, 4, settings);
        for (const glm::vec3& pixel : picture.pixels) sum += static_cast<double>(pixel.y);
        result.push_back(sum / 16.0);
    }
    return result;
}

struct Moments {
    double mean = 0.0, error = 0.0;  // standard error of the mean
};
inline Moments moments(const std::vector<double>& values) {
    Moments m;
    for (const double v : values) m.mean += v;
    m.mean /= static_cast<double>(values.size());
    double sum = 0.0;
    for (const double v : values) sum += (v - m.mean) * (v - m.mean);
    m.error = std::sqrt(sum / static_cast<double>(values.size() * (values.size() - 1)));
    return m;
}

// |t| < 4 and nearer than `tolerance`; what rounding leaves counts as no error at all.
inline void expect_mean(const std::vector<double>& values, double truth, double tolerance,
                        const std::string& what = {}) {
    const Moments m = moments(values);
    const double error = std::max(m.error, 2e-7 * std::abs(truth));
    EXPECT_LT(std::abs(m.mean - truth) / error, 4.0)
        << what << " mean " << m.mean << " +- " << m.error << ", truth " << truth;
    EXPECT_LT(std::abs(m.mean - truth), tolerance) << what << " mean " << m.mean << ", truth " << truth;
}

inline void expect_same_mean(const std::vector<double>& a, const std::vector<double>& b,
                             const std::string& what = {}) {
    const Moments x = moments(a), y = moments(b);
    const double error = std::max(std::sqrt(x.error * x.error + y.error * y.error), 4e-7 * std::abs(x.mean));
    EXPECT_LT(std::abs(x.mean - y.mean) / error, 4.0)
        << what << " " << x.mean << " +- " << x.error << " against " << y.mean << " +- " << y.error;
}

inline render::Environment even_light(float radiance = 1.0f) {
    Image picture(1, 1);
    picture.pixels[0] = glm::vec3(radiance);
    return render::Environment(std::move(picture));
}

// A floor below the origin's xz plane, seen from just above.
inline render::Camera looking_down(float height = 0.5f) {
    return narrow({0.0f, height, 0.0f}, 0.0f, kDown);
}

}  // namespace gh::test
