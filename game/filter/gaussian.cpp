#include "filter/gaussian.h"

#include "base/det_math.h"
#include "filter/gaussian_kernel.h"
#include "filter/rows.h"

#include <cmath>
#include <vector>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "filter/gaussian.cpp"
#include <hwy/foreach_target.h>
// foreach_target must come before what is compiled once per target.
#include "filter/simd-inl.h"

HWY_BEFORE_NAMESPACE();
namespace gh::filter::HWY_NAMESPACE {

static void across_row(const AcrossRow& row) {
    const std::size_t padded = (static_cast<std::size_t>(row.width) + 15) / 16 * 16;
    for (std::size_t x = 0; x < padded; x += lane_count()) {
        Floats sums[4] = {hn::Zero(F()), hn::Zero(F()), hn::Zero(F()), hn::Zero(F())};
        for (int dx = -row.reach; dx <= row.reach; ++dx) {
            const std::ptrdiff_t at = static_cast<std::ptrdiff_t>(x) + dx;
            const Floats r = load(row.in[0] + at), g = load(row.in[1] + at), b = load(row.in[2] + at);
            const Lanes good = hn::And(hn::And(is_finite(r), is_finite(g)),
                                       hn::And(is_finite(b), inside(pixel_numbers(at), row.width)));
            const Floats weight = zero_unless(good, splat(row.weights[dx < 0 ? -dx : dx]));
            sums[0] = hn::Add(sums[0], zero_unless(good, hn::Mul(weight, r)));
            sums[1] = hn::Add(sums[1], zero_unless(good, hn::Mul(weight, g)));
            sums[2] = hn::Add(sums[2], zero_unless(good, hn::Mul(weight, b)));
            sums[3] = hn::Add(sums[3], weight);
        }
        for (std::size_t i = 0; i < 4; ++i) store(sums[i], row.sums[i] + x);
    }
}

static void down_row(const DownRow& row) {
    for (std::size_t x = 0; x < static_cast<std::size_t>(row.width); x += lane_count()) {
        Floats sums[4] = {hn::Zero(F()), hn::Zero(F()), hn::Zero(F()), hn::Zero(F())};
        for (int dy = -row.reach; dy <= row.reach; ++dy) {
            const Floats weight = splat(row.weights[dy < 0 ? -dy : dy]);
            for (std::size_t i = 0; i < 4; ++i) {
                const float* from = row.sums[i][dy + row.reach];
                if (from != nullptr) sums[i] = hn::Add(sums[i], hn::Mul(weight, load(from + x)));
            }
        }
        const Lanes any = hn::Gt(sums[3], hn::Zero(F()));
        for (std::size_t i = 0; i < 3; ++i)
            store(zero_unless(any, hn::Div(sums[i], sums[3])), row.out[i] + x);
    }
}

}  // namespace gh::filter::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gh::filter {

HWY_EXPORT(across_row);
HWY_EXPORT(down_row);

void gaussian(const Plane3& in, float sigma, const Jobs& jobs, Plane3& out) {
    EXPECTS(sigma > 0.0f && sigma <= 20.0f);
    const int width = in.width(), height = in.height();
    const int reach = static_cast<int>(std::ceil(3.0f * sigma));
    std::vector<float> weights(static_cast<std::size_t>(reach) + 1);
    for (std::size_t i = 0; i < weights.size(); ++i) {
        const float d = static_cast<float>(i) / sigma;
        weights[i] = det::exp(-0.5f * d * d);
    }
    Plane sums[4];
    for (Plane& plane : sums) plane.fit(width, height);
    run_rows(height, jobs, [&](int y) {
        AcrossRow row{};
        point_to(row.in, in, y);
        row.weights = weights.data();
        row.reach = reach;
        row.width = width;
        for (std::size_t i = 0; i < 4; ++i) row.sums[i] = sums[i].row(y);
        HWY_DYNAMIC_DISPATCH(across_row)(row);
    });
    out.fit(width, height);
    run_rows(height, jobs, [&](int y) {
        DownRow row{};
        for (std::size_t i = 0; i < 4; ++i) {
            for (int dy = -reach; dy <= reach; ++dy) {
                if (0 <= y + dy && y + dy < height) row.sums[i][dy + reach] = sums[i].row(y + dy);
            }
        }
        row.weights = weights.data();
        row.reach = reach;
        row.width = width;
        point_to(row.out, out, y);
        HWY_DYNAMIC_DISPATCH(down_row)(row);
    });
}

}  // namespace gh::filter
#endif
