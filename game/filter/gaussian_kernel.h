// filter/gaussian_kernel.h - plain data between gaussian.cpp and its kernels.
#pragma once

namespace gh::filter {

inline constexpr int kGaussianReach = 60;

struct AcrossRow {
    const float* in[3];
    const float* weights;  // of distances 0 ... reach
    int reach, width;
    float* sums[4];  // weighted light, weight
};

struct DownRow {
    const float* sums[4][2 * kGaussianReach + 1];  // rows y - reach ... y + reach; null outside the picture
    const float* weights;
    int reach, width;
    float* out[3];
};

}  // namespace gh::filter
