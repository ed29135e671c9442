// filter/anti_lag_kernel.h - plain data between anti_lag.cpp and its kernels.
#pragma once

#include <cstddef>
#include <cstdint>

namespace gh::filter {

struct ChangeRow {
    const float *now, *then;
    int width;
    float* change;
};

// Sums over five rows: of the fast mean less the long one, and of the samples' variance.
struct ColumnSumRow {
    const float *fast[5], *light[5], *square[5];
    int begin, end;  // of the columns asked
    float *difference, *variance;
};

struct SettleRow {
    const float *difference, *variance;
    int begin, end;  // of the columns asked
    int width;
    float least_length;  // a mean is not made shorter, and a shorter one is left alone
    float noise_share;   // variance of the mean difference, by the sum of the samples' variances
    float sigmas;
    float* light[3];  // red, luminance, blue
    float *square, *length;
};

// Change in a row of pixels from where each was, taps as reproject() has found them.
struct CarryRow {
    const float* then;  // of row 0
    std::ptrdiff_t then_stride;
    std::int32_t low, high;  // the first tap of whoever asks anything that has changed lies in [low, high)
    const std::int32_t* first;
    const float* weight[4];
    float sharpness;
    int width;
    float* change;
};

}  // namespace gh::filter
