#include "filter/bilateral.h"

#include "filter/bilateral_kernel.h"
#include "filter/mend.h"
#include "filter/rows.h"

#include <cmath>
#include <vector>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "filter/bilateral.cpp"
#include <hwy/foreach_target.h>
// foreach_target must come before what is compiled once per target.
#include "filter/geometry-inl.h"
#include "filter/simd-inl.h"

HWY_BEFORE_NAMESPACE();
namespace gh::filter::HWY_NAMESPACE {

struct Colour {
    Floats r, g, b;
};

static HWY_INLINE Colour colour_at(const float* const planes[3], std::ptrdiff_t at) {
    return {load(planes[0] + at), load(planes[1] + at), load(planes[2] + at)};
}

// Everything but geometry that tells two pixels apart.
static HWY_INLINE Floats unlike(const BilateralRow& row, std::ptrdiff_t x, std::ptrdiff_t at) {
    const Colour here = colour_at(row.light, x), there = colour_at(row.light, at);
    const Floats luma =
        hn::Abs(hn::Sub(luminance(here.r, here.g, here.b), luminance(there.r, there.g, there.b)));
    Floats sum = hn::Mul(luma, splat(row.luminance_scale));
    if (row.albedo[0] != nullptr) {
        const Colour a = colour_at(row.albedo, x), b = colour_at(row.albedo, at);
        const Floats off = hn::Add(hn::Add(hn::Abs(hn::Sub(a.r, b.r)), hn::Abs(hn::Sub(a.g, b.g))),
                                   hn::Abs(hn::Sub(a.b, b.b)));
        sum = hn::Add(sum, hn::Mul(off, splat(row.albedo_scale)));
    }
    return sum;
}

static void bilateral_pixels(const BilateralRow& row, std::size_t x) {
    const bool has_guides = row.guides.nearness != nullptr;
    Surface surface = {};
    if (has_guides) surface = surface_at(row.guides, x, static_cast<float>(row.reach));
    const auto first = static_cast<std::ptrdiff_t>(x);
    Colour sum = colour_at(row.light, first);
    Floats total = splat(1.0f);
    const float* spatial = row.spatial;
    for (int dy = -row.reach; dy <= row.reach; ++dy) {
        const bool is_in = 0 <= row.y + dy && row.y + dy < row.height;
        const Floats base = has_guides ? below(surface, dy) : hn::Zero(F());
        for (int dx = -row.reach; dx <= row.reach; ++dx, ++spatial) {
            if (!is_in || (dx == 0 && dy == 0) || *spatial >= 1.0f) continue;
            const std::ptrdiff_t at = first + dx + dy * row.stride;
            Floats off = hn::Add(unlike(row, first, at), splat(*spatial));
            if (has_guides) off = hn::Add(off, apart(surface, row.guides, at, beside(surface, base, dx)));
            // An albedo may be anything, NaN too: then it is not alike.
            const Lanes counts =
                hn::And(inside(pixel_numbers(first + dx), row.width), hn::Lt(off, splat(1.0f)));
            const Floats weight = zero_unless(counts, falloff(zero_unless(counts, off)));
            const Colour there = colour_at(row.light, at);
            sum = {hn::Add(sum.r, hn::Mul(weight, there.r)), hn::Add(sum.g, hn::Mul(weight, there.g)),
                   hn::Add(sum.b, hn::Mul(weight, there.b))};
            total = hn::Add(total, weight);
        }
    }
    store(hn::Div(sum.r, total), row.out[0] + x);
    store(hn::Div(sum.g, total), row.out[1] + x);
    store(hn::Div(sum.b, total), row.out[2] + x);
}

static void bilateral_row(const BilateralRow& row) {
    for (std::size_t x = 0; x < static_cast<std::size_t>(row.width); x += lane_count())
        bilateral_pixels(row, x);
}

}  // namespace gh::filter::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gh::filter {

HWY_EXPORT(bilateral_row);

namespace {

float quarter_by(float difference) {
    return difference > 0.0f ? 0.25f / difference : 0.0f;
}

// Gaussian in the distance: exponent d^2 / (2 sigma^2).
std::vector<float> spatial_exponents(int reach, float sigma) {
    std::vector<float> exponents;
    for (int dy = -reach; dy <= reach; ++dy) {
        for (int dx = -reach; dx <= reach; ++dx) {
            exponents.push_back(0.25f * static_cast<float>(dx * dx + dy * dy) / (2.0f * sigma * sigma));
        }
    }
    return exponents;
}

void run(const Plane3& in, const Guides* guides, const Plane3* albedo, const BilateralSettings& settings,
         const Jobs& jobs, Plane3& out) {
    EXPECTS(settings.sigma_px > 0.0f && settings.sigma_px <= 16.0f && &in != &out);
    EXPECTS(settings.luminance >= 0.0f && settings.albedo >= 0.0f);
    const int width = in.width(), height = in.height();
    const int reach = static_cast<int>(std::ceil(2.0f * settings.sigma_px));
    const std::vector<float> spatial = spatial_exponents(reach, settings.sigma_px);
    Plane3 sound;
    mend(in, {.floor = kInfiniteLight, .factor = 1.0f}, jobs, sound);
    out.fit(width, height);
    run_rows(height, jobs, [&](int y) {
        BilateralRow row{};
        point_to(row.light, sound, y);
        if (albedo != nullptr && settings.albedo > 0.0f) point_to(row.albedo, *albedo, y);
        if (guides != nullptr) row.guides = rows_of(*guides, y);
        row.spatial = spatial.data();
        row.reach = reach;
        row.width = width;
        row.height = height;
        row.y = y;
        row.stride = sound.x.stride();
        row.luminance_scale = quarter_by(settings.luminance);
        row.albedo_scale = quarter_by(settings.albedo);
        point_to(row.out, out, y);
        HWY_DYNAMIC_DISPATCH(bilateral_row)(row);
    });
}

}  // namespace

void bilateral(const Plane3& in, const BilateralSettings& settings, const Jobs& jobs, Plane3& out) {
    run(in, nullptr, nullptr, settings, jobs, out);
}

void cross_bilateral(const Plane3& in, const Guides& guides, const Plane3& albedo,
                     const BilateralSettings& settings, const Jobs& jobs, Plane3& out) {
    EXPECTS(guides.width() == in.width() && guides.height() == in.height());
    EXPECTS(albedo.empty() || (albedo.width() == in.width() && albedo.height() == in.height()));
    run(in, &guides, albedo.empty() ? nullptr : &albedo, settings, jobs, out);
}

}  // namespace gh::filter
#endif
