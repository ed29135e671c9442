// filter/anti_lag_kernel.h - plain data between anti_lag.cpp and its kernels.
#pragma once

namespace gh::filter {

struct ChangeRow {
    const float *now, *then;
    int width;
    float* change;
};

// Sums of the fast mean and of its square over five rows.
struct ColumnSumRow {
    const float* fast[5];
    int width;
    float *sum, *squares;
};

struct SettleRow {
    const float *sum, *squares;
    int width;
    float least_length;  // a shorter mean is left alone
    float sigmas;
    float* light[3];  // red, luminance, blue
    float *square, *length;
};

}  // namespace gh::filter
