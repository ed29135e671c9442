#include "metrics/picture_metrics.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace metrics {

namespace {

double sound(float x) {
    return std::isfinite(x) ? static_cast<double>(x) : 0.0;
}

bool is_finite(const glm::vec3& c) {
    return std::isfinite(c.x) && std::isfinite(c.y) && std::isfinite(c.z);
}

}  // namespace

RelMse rel_mse(const gh::Image& picture, const gh::Image& reference) {
    EXPECTS(picture.width == reference.width && picture.height == reference.height &&
            !picture.pixels.empty());
    RelMse out;
    std::vector<double> errors;
    errors.reserve(picture.pixels.size());
    for (std::size_t i = 0; i < picture.pixels.size(); ++i) {
        double error = 0.0;
        for (std::size_t c = 0; c < 3; ++c) {
            const double a = sound(picture.pixels[i][c]), b = sound(reference.pixels[i][c]);
            error += (a - b) * (a - b) / (b * b + 0.01) / 3.0;
        }
        errors.push_back(error);
        out.not_finite += !is_finite(picture.pixels[i]);
    }
    std::sort(errors.begin(), errors.end());
    const std::size_t kept = errors.size() - errors.size() / 1000;
    double sum = 0.0;
    for (std::size_t i = 0; i < errors.size(); ++i) {
        sum += errors[i];
        if (i + 1 == kept) out.trimmed = sum / static_cast<double>(kept);
    }
    out.all = sum / static_cast<double>(errors.size());
    return out;
}

}  // namespace metrics
