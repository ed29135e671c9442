#include "filter/mend.h"

#include "filter/mend_kernel.h"
#include "filter/rows.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "filter/mend.cpp"
#include <hwy/foreach_target.h>
// foreach_target must come before what is compiled once per target.
#include "filter/albedo-inl.h"
#include "filter/simd-inl.h"

HWY_BEFORE_NAMESPACE();
namespace gh::filter::HWY_NAMESPACE {

struct Colour {
    Floats r, g, b;
};

static HWY_INLINE Colour colour_at(const MendRow& row, std::ptrdiff_t at) {
    return {load(row.light[0] + at), load(row.light[1] + at), load(row.light[2] + at)};
}

static HWY_INLINE Lanes is_sound(Floats v) {
    return hn::And(hn::Ge(v, hn::Zero(F())), hn::Le(v, splat(kInfiniteLight)));
}

static HWY_INLINE Lanes is_sound(const Colour& c) {
    return hn::And(is_sound(c.r), hn::And(is_sound(c.g), is_sound(c.b)));
}

// The mean of the sound ones among the eight neighbours; black where there are none.
static Colour mean_around(const MendRow& row, std::size_t x) {
    const Floats zero = hn::Zero(F()), one = splat(1.0f);
    Colour sum{zero, zero, zero};
    Floats count = zero;
    for (int dy = -1; dy <= 1; ++dy) {
        if (row.y + dy < 0 || row.y + dy >= row.height) continue;
        for (int dx = -1; dx <= 1; ++dx) {
            if (dx == 0 && dy == 0) continue;
            const std::ptrdiff_t beside = static_cast<std::ptrdiff_t>(x) + dx;
            const Colour c = colour_at(row, beside + dy * row.stride);
            const Lanes counts = hn::And(is_sound(c), inside(pixel_numbers(beside), row.width));
            sum.r = hn::Add(sum.r, zero_unless(counts, c.r));
            sum.g = hn::Add(sum.g, zero_unless(counts, c.g));
            sum.b = hn::Add(sum.b, zero_unless(counts, c.b));
            count = hn::Add(count, zero_unless(counts, one));
        }
    }
    const Floats share = hn::Div(one, choose(hn::Gt(count, zero), count, one));
    return {hn::Mul(sum.r, share), hn::Mul(sum.g, share), hn::Mul(sum.b, share)};
}

static void mend_row(const MendRow& row) {
    for (std::size_t x = 0; x < static_cast<std::size_t>(row.width); x += lane_count()) {
        Colour c{load_far(row.light[0] + x), load_far(row.light[1] + x), load_far(row.light[2] + x)};
        const Lanes sound = is_sound(c);
        const Lanes fine = hn::And(sound, hn::Le(luminance(c.r, c.g, c.b), splat(row.floor)));
        if (!hn::AllTrue(F(), fine)) {
            const Colour around = mean_around(row, x);
            c = {choose(sound, c.r, around.r), choose(sound, c.g, around.g), choose(sound, c.b, around.b)};
            const Floats bright = luminance(c.r, c.g, c.b);
            const Floats by_neighbours = hn::Mul(luminance(around.r, around.g, around.b), splat(row.factor));
            const Floats floor = splat(row.floor);
            const Floats most = choose(hn::Gt(by_neighbours, floor), by_neighbours, floor);
            const Lanes too_bright = hn::And(hn::Gt(bright, most), is_finite(bright));
            const Floats factor = choose(too_bright, hn::Div(most, bright), splat(1.0f));
            c = {hn::Mul(c.r, factor), hn::Mul(c.g, factor), hn::Mul(c.b, factor)};
        }
        if (row.albedo[0] != nullptr) {
            c.r = hn::Div(c.r, usable_albedo(row.albedo[0] + x));
            c.g = hn::Div(c.g, usable_albedo(row.albedo[1] + x));
            c.b = hn::Div(c.b, usable_albedo(row.albedo[2] + x));
        }
        store_far(c.r, row.out[0] + x);
        store_far(c.g, row.out[1] + x);
        store_far(c.b, row.out[2] + x);
    }
}

}  // namespace gh::filter::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gh::filter {

HWY_EXPORT(mend_row);

void mend(const Plane3& light, const MendSettings& settings, const Jobs& jobs, Plane3& out) {
    run_rows(light.height(), jobs, mend_rows(light, settings, out));
}

RowWork mend_rows(const Plane3& light, const MendSettings& settings, Plane3& out) {
    return mend_rows(light, settings, nullptr, out);
}

RowWork mend_rows(const Plane3& light, const MendSettings& settings, const Plane3* albedo, Plane3& out) {
    EXPECTS(&light != &out && settings.floor >= 0.0f && settings.factor >= 1.0f);
    out.fit(light.width(), light.height());
    if (albedo != nullptr && albedo->empty()) albedo = nullptr;
    return [settings, albedo, &light, &out](int y) {
        MendRow row{};
        point_to(row.light, light, y);
        if (albedo != nullptr) point_to(row.albedo, *albedo, y);
        row.width = light.width();
        row.height = light.height();
        row.y = y;
        row.stride = light.x.stride();
        row.floor = settings.floor;
        row.factor = settings.factor;
        point_to(row.out, out, y);
        HWY_DYNAMIC_DISPATCH(mend_row)(row);
    };
}

}  // namespace gh::filter
#endif
