#include "metrics/blur.h"
#include "metrics/picture_metrics.h"

#include <algorithm>

namespace metrics {

namespace {

constexpr int kRadius = 5;

double luma(const glm::vec3& shown) {
    const auto part = [](float x) { return x > 0.0f ? static_cast<double>(std::min(x, 1.0f)) : 0.0; };
    return 0.2126 * part(shown.x) + 0.7152 * part(shown.y) + 0.0722 * part(shown.z);
}

// Window means of a * b.
Grid window_means(const Grid& a, const Grid& b) {
    Grid product(a.width, a.height);
    for (std::size_t i = 0; i < a.values.size(); ++i) product.values[i] = a.values[i] * b.values[i];
    const Kernel window = gaussian_kernel(1.5, kRadius);
    return convolved(product, window, window);
}

double similarity(double mean_a, double mean_b, double aa, double bb, double ab) {
    constexpr double kC1 = 0.01 * 0.01, kC2 = 0.03 * 0.03;
    const double variance_a = aa - mean_a * mean_a, variance_b = bb - mean_b * mean_b;
    const double covariance = ab - mean_a * mean_b;
    return (2.0 * mean_a * mean_b + kC1) * (2.0 * covariance + kC2) /
           ((mean_a * mean_a + mean_b * mean_b + kC1) * (variance_a + variance_b + kC2));
}

}  // namespace

double ssim(const gh::Image& shown, const gh::Image& reference) {
    EXPECTS(shown.width == reference.width && shown.height == reference.height && !shown.pixels.empty());
    Grid a(shown.width, shown.height), b(shown.width, shown.height), one(shown.width, shown.height);
    for (std::size_t i = 0; i < a.values.size(); ++i) {
        a.values[i] = luma(shown.pixels[i]);
        b.values[i] = luma(reference.pixels[i]);
        one.values[i] = 1.0;
    }
    const Grid mean_a = window_means(a, one), mean_b = window_means(b, one);
    const Grid aa = window_means(a, a), bb = window_means(b, b), ab = window_means(a, b);
    const int inset_x = shown.width > 2 * kRadius ? kRadius : 0,
              inset_y = shown.height > 2 * kRadius ? kRadius : 0;
    double sum = 0.0;
    int count = 0;
    for (int y = inset_y; y < shown.height - inset_y; ++y) {
        for (int x = inset_x; x < shown.width - inset_x; ++x) {
            const std::size_t i = a.index(x, y);
            sum += similarity(mean_a.values[i], mean_b.values[i], aa.values[i], bb.values[i], ab.values[i]);
            ++count;
        }
    }
    return sum / count;
}

}  // namespace metrics
