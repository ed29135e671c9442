#include "filter/enlarge.h"

#include "filter/cubic.h"
#include "filter/enlarge_kernel.h"
#include "filter/rows.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "filter/enlarge.cpp"
#include <hwy/foreach_target.h>
// foreach_target must come before what is compiled once per target.
#include "filter/joint-inl.h"
#include "filter/simd-inl.h"

HWY_BEFORE_NAMESPACE();
namespace gh::filter::HWY_NAMESPACE {

// Four values blended, within the range of the four. None is NaN.
static HWY_INLINE Floats blend(const Floats value[4], const Floats weight[4]) {
    Floats sum = hn::Mul(value[0], weight[0]);
    Floats low = value[0], high = value[0];
    for (std::size_t k = 1; k < 4; ++k) {
        sum = hn::Add(sum, hn::Mul(value[k], weight[k]));
        low = hn::Min(low, value[k]);
        high = hn::Max(high, value[k]);
    }
    const Floats raised = choose(hn::Lt(sum, low), low, sum);
    const Floats clamped = choose(hn::Gt(raised, high), high, raised);
    return hn::Add(clamped,
                   hn::Zero(F()));  // there is one zero: targets differ in which of two Min and Max return
}

static void cubic_down_row(const CubicDownRow& row) {
    const std::size_t padded = (static_cast<std::size_t>(row.width) + 15) / 16 * 16;
    Floats weight[4], value[4];
    for (std::size_t k = 0; k < 4; ++k) weight[k] = splat(row.weight[k]);
    for (std::size_t x = 0; x < padded; x += lane_count()) {
        for (std::size_t k = 0; k < 4; ++k) {
            const Floats v = load(row.in[k] + x);
            value[k] = zero_unless(is_finite(v), v);
        }
        store(blend(value, weight), row.middle + x);
    }
    // The border repeats.
    const float last = row.middle[row.width - 1];
    row.middle[-2] = row.middle[-1] = row.middle[0];
    row.middle[row.width] = row.middle[row.width + 1] = last;
}

static void cubic_across_row(const CubicAcrossRow& row) {
    for (std::size_t x = 0; x < static_cast<std::size_t>(row.width); x += lane_count()) {
        const Places places = places_at(hn::LoadU(I(), row.taps.first + x));
        Floats weight[4], value[4];
        for (std::size_t k = 0; k < 4; ++k) {
            weight[k] = load(row.taps.weight[k] + x);
            value[k] = read_at(row.middle, places, static_cast<std::ptrdiff_t>(k));
        }
        store(blend(value, weight), row.out + x);
    }
}

static void joint_row(const JointRow& row) {
    const Floats one = splat(1.0f), zero = hn::Zero(F());
    for (std::size_t x = 0; x < static_cast<std::size_t>(row.width); x += lane_count()) {
        const Surface surface = surface_at(row.large, x, 2.0f);
        const Places places = places_at(hn::LoadU(I(), row.first + x));
        const Floats right = load(row.right + x);
        Floats sum[3] = {zero, zero, zero}, total = zero;
        for (int tap = 0; tap < 4; ++tap) {
            const int i = tap % 2, j = tap / 2;
            const Floats across = i == 0 ? hn::Sub(one, right) : right;
            const Floats down = splat(j == 0 ? 1.0f - row.below : row.below);
            const Floats kind =
                alike(surface, row.small[j], places, i, load(row.offset_x[i] + x), splat(row.offset_y[j]));
            const Floats weight = hn::Mul(hn::Mul(across, down), kind);
            for (std::size_t c = 0; c < 3; ++c) {
                sum[c] = hn::Add(sum[c], hn::Mul(weight, read_at(row.light[j][c], places, i)));
            }
            total = hn::Add(total, weight);
        }
        for (std::size_t c = 0; c < 3; ++c) store(hn::Div(sum[c], total), row.out[c] + x);
    }
}

}  // namespace gh::filter::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gh::filter {

HWY_EXPORT(cubic_down_row);
HWY_EXPORT(cubic_across_row);
HWY_EXPORT(joint_row);

namespace {

// Small pixels' centres seen from a large one's, in small pixels from the centre of small pixel 0.
float centre_of(int large, int from, int to) {
    return (static_cast<float>(large) + 0.5f) * (static_cast<float>(from) / static_cast<float>(to)) - 0.5f;
}

std::size_t padded(int width) {
    return (static_cast<std::size_t>(width) + 15) / 16 * 16;
}

struct CubicTap {
    int first;  // -2 ... count - 2, where the border repeats
    std::array<float, 4> weight;
};

CubicTap cubic_tap(int large, int from, int to) {
    const float centre = centre_of(std::min(large, to - 1), from, to);
    const float left = std::floor(centre);
    const float t = centre - left;
    CubicTap tap{static_cast<int>(left) - 1,
                 {mitchell(1.0f + t), mitchell(t), mitchell(1.0f - t), mitchell(2.0f - t)}};
    const float sum = (tap.weight[0] + tap.weight[1]) + (tap.weight[2] + tap.weight[3]);
    for (float& weight : tap.weight) weight /= sum;
    return tap;
}

// All of a row's, channel by channel next to each other.
struct CubicColumns {
    std::vector<std::int32_t> first;
    std::vector<float> weight[4];

    CubicColumns(int from, int to) : first(padded(to)) {
        for (std::vector<float>& weights : weight) weights.resize(first.size());
        for (std::size_t x = 0; x < first.size(); ++x) {
            const CubicTap tap = cubic_tap(static_cast<int>(x), from, to);
            first[x] = tap.first;
            for (std::size_t k = 0; k < 4; ++k) weight[k][x] = tap.weight[k];
        }
    }
};

constexpr std::size_t kBefore = 16;  // room before and behind a middle row

void enlarge_row(const Plane& in, const CubicTap& lines, const ColumnTaps& columns,
                 std::vector<float>& middle, int width, float* out) {
    CubicDownRow down{};
    for (int k = 0; k < 4; ++k) {
        const int line = std::clamp(lines.first + k, 0, in.height() - 1);
        down.in[k] = in.row(line);
        down.weight[k] = lines.weight[static_cast<std::size_t>(k)];
    }
    down.width = in.width();
    down.middle = middle.data() + kBefore;
    HWY_DYNAMIC_DISPATCH(cubic_down_row)(down);
    const CubicAcrossRow across{.middle = down.middle, .taps = columns, .width = width, .out = out};
    HWY_DYNAMIC_DISPATCH(cubic_across_row)(across);
}

void copy_weights(const CubicTap& tap, float to[4]) {
    std::copy(tap.weight.begin(), tap.weight.end(), to);
}

// Rows 2 gap + 1 and 2 gap + 2 of the large picture, between the small ones `gap` and `gap` + 1.
void double_gap(const Plane3& in, int gap, std::vector<float> middle[2], Plane3& out) {
    DoubleRows rows{};
    const int upper = 2 * gap + 1, lower = upper + 1;
    const auto taps_of = [&](int line) {
        return cubic_tap(std::clamp(line, 0, out.height() - 1), in.height(), out.height());
    };
    copy_weights(taps_of(upper), rows.down[0]);
    copy_weights(taps_of(lower), rows.down[1]);
    copy_weights(cubic_tap(0, in.width(), out.width()), rows.across[0]);
    copy_weights(cubic_tap(1, in.width(), out.width()), rows.across[1]);
    rows.width = in.width();
    const Plane* const from[3] = {&in.x, &in.y, &in.z};
    Plane* const to[3] = {&out.x, &out.y, &out.z};
    for (std::size_t c = 0; c < 3; ++c) {
        for (int k = 0; k < 4; ++k) rows.in[k] = from[c]->row(std::clamp(gap - 1 + k, 0, in.height() - 1));
        rows.out[0] = upper >= 0 ? to[c]->row(upper) : nullptr;
        rows.out[1] = lower < out.height() ? to[c]->row(lower) : nullptr;
        for (std::size_t i = 0; i < 2; ++i) {
            middle[i].resize(padded(in.width()) + 3 * kBefore);
            rows.middle[i] = middle[i].data() + kBefore;
        }
        double_rows(rows);
    }
}

void enlarge_twice(const Plane3& in, const Jobs& jobs, Plane3& out) {
    const int gaps = in.height() + 1, bands = (gaps + kRowsAtOnce - 1) / kRowsAtOnce;
    std::vector<std::array<std::vector<float>, 2>> middles(static_cast<std::size_t>(jobs.threads()));
    jobs.run(static_cast<std::size_t>(bands), [&](std::size_t band, int worker) {
        const int begin = static_cast<int>(band) * kRowsAtOnce;
        for (int gap = begin; gap < std::min(begin + kRowsAtOnce, gaps); ++gap)
            double_gap(in, gap - 1, middles[static_cast<std::size_t>(worker)].data(), out);
    });
}

}  // namespace

void enlarge(const Plane3& in, const Jobs& jobs, Plane3& out) {
    EXPECTS(in.width() >= 1 && in.height() >= 1);
    EXPECTS(out.width() >= in.width() && out.height() >= in.height());
    if (out.width() == 2 * in.width() && out.height() == 2 * in.height()) return enlarge_twice(in, jobs, out);
    const CubicColumns columns(in.width(), out.width());
    const ColumnTaps taps{columns.first.data(),
                          {columns.weight[0].data(), columns.weight[1].data(), columns.weight[2].data(),
                           columns.weight[3].data()}};
    std::vector<std::vector<float>> middles(static_cast<std::size_t>(jobs.threads()));
    const int bands = (out.height() + kRowsAtOnce - 1) / kRowsAtOnce;
    jobs.run(static_cast<std::size_t>(bands), [&](std::size_t band, int worker) {
        std::vector<float>& middle = middles[static_cast<std::size_t>(worker)];
        middle.resize(padded(in.width()) + 3 * kBefore);
        const int begin = static_cast<int>(band) * kRowsAtOnce;
        for (int y = begin; y < std::min(begin + kRowsAtOnce, out.height()); ++y) {
            const CubicTap lines = cubic_tap(y, in.height(), out.height());
            enlarge_row(in.x, lines, taps, middle, out.width(), out.x.row(y));
            enlarge_row(in.y, lines, taps, middle, out.width(), out.y.row(y));
            enlarge_row(in.z, lines, taps, middle, out.width(), out.z.row(y));
        }
    });
}

namespace {

// The two small pixels about a large one along one axis.
struct PairTap {
    int first;  // 0 ... count - 1; the second may be the first again
    float share;
    float offset[2];  // in large pixels
};

PairTap pair_tap(int large, int from, int to) {
    const float ratio = static_cast<float>(to) / static_cast<float>(from);
    const float centre = centre_of(std::min(large, to - 1), from, to);
    const float left = std::clamp(std::floor(centre), 0.0f, static_cast<float>(std::max(0, from - 2)));
    return {static_cast<int>(left),
            std::clamp(centre - left, 0.0f, from > 1 ? 1.0f : 0.0f),
            {(left - centre) * ratio, (left + 1.0f - centre) * ratio}};
}

struct PairColumns {
    std::vector<std::int32_t> first;
    std::vector<float> share, offset[2];

    PairColumns(int from, int to) : first(padded(to)), share(first.size()) {
        for (std::vector<float>& offsets : offset) offsets.resize(first.size());
        for (std::size_t x = 0; x < first.size(); ++x) {
            const PairTap tap = pair_tap(static_cast<int>(x), from, to);
            first[x] = tap.first;
            share[x] = tap.share;
            for (std::size_t i = 0; i < 2; ++i) offset[i][x] = tap.offset[i];
        }
    }
};

}  // namespace

void joint_enlarge(const Plane3& in, const Guides& guides, const Guides& large, const Jobs& jobs,
                   Plane3& out) {
    EXPECTS(in.width() >= 1 && in.height() >= 1);
    EXPECTS(guides.width() == in.width() && guides.height() == in.height());
    EXPECTS(large.width() >= in.width() && large.height() >= in.height());
    out.fit(large.width(), large.height());
    const PairColumns columns(in.width(), out.width());
    run_rows(out.height(), jobs, [&](int y) {
        const PairTap lines = pair_tap(y, in.height(), out.height());
        const int second = std::min(lines.first + 1, in.height() - 1);
        JointRow row{};
        row.large = rows_of(large, y);
        row.small[0] = rows_of(guides, lines.first);
        row.small[1] = rows_of(guides, second);
        point_to(row.light[0], in, lines.first);
        point_to(row.light[1], in, second);
        row.below = lines.share;
        row.offset_y = lines.offset;
        row.first = columns.first.data();
        row.right = columns.share.data();
        row.offset_x[0] = columns.offset[0].data();
        row.offset_x[1] = columns.offset[1].data();
        row.width = out.width();
        point_to(row.out, out, y);
        HWY_DYNAMIC_DISPATCH(joint_row)(row);
    });
}

}  // namespace gh::filter
#endif
