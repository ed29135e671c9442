// filter/anti_lag_kernel.h - plain data between anti_lag.cpp and its kernels.
#pragma once

namespace gh::filter {

struct ChangeRow {
    const float *now, *then;
    int width;
    float* change;
};

// Sums over five rows: of the fast mean less the long one, and of the samples' variance.
struct ColumnSumRow {
    const float *fast[5], *light[5], *square[5];
    int width;
    float *difference, *variance;
};

struct SettleRow {
    const float *difference, *variance;
    int width;
    float least_length;  // a mean is not made shorter, and a shorter one is left alone
    float noise_share;   // variance of the mean difference, by the sum of the samples' variances
    float sigmas;
    float* light[3];  // red, luminance, blue
    float *square, *length;
};

}  // namespace gh::filter
