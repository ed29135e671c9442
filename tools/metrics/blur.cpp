#include "metrics/blur.h"

#include <algorithm>
#include <cmath>

namespace metrics {

Kernel gaussian_kernel(double sigma, int radius) {
    Kernel kernel;
    double sum = 0.0;
    for (int i = -radius; i <= radius; ++i) {
        kernel.push_back(std::exp(-0.5 * i * i / (sigma * sigma)));
        sum += kernel.back();
    }
    for (double& weight : kernel) weight /= sum;
    return kernel;
}

namespace {

int radius_of(const Kernel& kernel) {
    return static_cast<int>(kernel.size() / 2);
}

}  // namespace

Grid convolved(const Grid& in, const Kernel& across, const Kernel& down) {
    Grid middle(in.width, in.height), out(in.width, in.height);
    for (int y = 0; y < in.height; ++y) {
        for (int x = 0; x < in.width; ++x) {
            double sum = 0.0;
            int at = x - radius_of(across);
            for (const double weight : across)
                sum += weight * in.values[in.index(std::clamp(at++, 0, in.width - 1), y)];
            middle.values[in.index(x, y)] = sum;
        }
    }
    for (int y = 0; y < in.height; ++y) {
        for (int x = 0; x < in.width; ++x) {
            double sum = 0.0;
            int at = y - radius_of(down);
            for (const double weight : down) {
                sum += weight * middle.values[in.index(x, std::clamp(at++, 0, in.height - 1))];
            }
            out.values[in.index(x, y)] = sum;
        }
    }
    return out;
}

}  // namespace metrics
