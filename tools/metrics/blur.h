// metrics/blur.h - separable convolution in double precision; the border repeats.
#pragma once

#include <cstddef>
#include <vector>

namespace metrics {

struct Grid {
    int width = 0, height = 0;
    std::vector<double> values;

    Grid(int w, int h)
        : width(w), height(h), values(static_cast<std::size_t>(w) * static_cast<std::size_t>(h)) {}
    [[nodiscard]] std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
    }
};

// Kernels have 2 r + 1 weights, for distances -r ... r.
using Kernel = std::vector<double>;

// exp(-x^2 / (2 sigma^2)), sum 1.
[[nodiscard]] Kernel gaussian_kernel(double sigma, int radius);

[[nodiscard]] Grid convolved(const Grid& in, const Kernel& across, const Kernel& down);

}  // namespace metrics
