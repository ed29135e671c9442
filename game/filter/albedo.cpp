#include "filter/albedo.h"

#include "filter/albedo_kernel.h"
#include "filter/rows.h"

#include <algorithm>
#include <array>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "filter/albedo.cpp"
#include <hwy/foreach_target.h>
// foreach_target must come before what is compiled once per target.
#include "filter/albedo-inl.h"
#include "filter/simd-inl.h"

HWY_BEFORE_NAMESPACE();
namespace gh::filter::HWY_NAMESPACE {

static void demodulate_row(const DemodulateRow& row) {
    for (std::size_t x = 0; x < static_cast<std::size_t>(row.width); x += lane_count()) {
        for (std::size_t c = 0; c < 3; ++c) {
            store(hn::Div(load(row.light[c] + x), usable_albedo(row.albedo[c] + x)), row.out[c] + x);
        }
    }
}

static HWY_INLINE Floats light_or_black(const float* from, std::size_t x) {
    return from != nullptr ? load_far(from + x) : hn::Zero(F());
}

struct Colour {
    Floats r, g, b;
};

// Rounding may leave a little less than no green.
static HWY_INLINE Floats green_of(Floats r, Floats y, Floats b) {
    const Floats others = hn::Add(hn::Mul(splat(0.2126f), r), hn::Mul(splat(0.0722f), b));
    return positive(hn::Mul(hn::Sub(y, others), splat(1.0f / 0.7152f)));
}

static HWY_INLINE Colour part_at(const float* const from[3], std::size_t x) {
    const Floats r = light_or_black(from[0], x), y = light_or_black(from[1], x),
                 b = light_or_black(from[2], x);
    return {r, green_of(r, y, b), b};
}

static HWY_INLINE Floats on_albedo(const float* albedo, std::size_t x, Floats light) {
    return albedo != nullptr ? hn::Mul(light, usable_albedo(albedo + x)) : light;
}

static void remodulate_row(const RemodulateRow& row) {
    for (std::size_t x = 0; x < static_cast<std::size_t>(row.width); x += lane_count()) {
        const Colour direct = part_at(row.parts[0], x), indirect = part_at(row.parts[1], x);
        const Colour specular = part_at(row.parts[2], x);
        const Floats r = hn::Add(on_albedo(row.albedo[0], x, hn::Add(direct.r, indirect.r)),
                                 on_albedo(row.gloss[0], x, specular.r));
        const Floats g = hn::Add(on_albedo(row.albedo[1], x, hn::Add(direct.g, indirect.g)),
                                 on_albedo(row.gloss[1], x, specular.g));
        const Floats b = hn::Add(on_albedo(row.albedo[2], x, hn::Add(direct.b, indirect.b)),
                                 on_albedo(row.gloss[2], x, specular.b));
        store(hn::Add(r, light_or_black(row.parts[3][0], x)), row.out[0] + x);
        store(hn::Add(g, light_or_black(row.parts[3][1], x)), row.out[1] + x);
        store(hn::Add(b, light_or_black(row.parts[3][2], x)), row.out[2] + x);
    }
}

static void green_row(const GreenRow& row) {
    for (std::size_t x = 0; x < static_cast<std::size_t>(row.width); x += lane_count()) {
        const Floats r = load(row.from[0] + x), middle = load(row.from[1] + x), b = load(row.from[2] + x);
        store(r, row.to[0] + x);
        store(row.to_luminance ? luminance(r, middle, b) : green_of(r, middle, b), row.to[1] + x);
        store(b, row.to[2] + x);
    }
}

}  // namespace gh::filter::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gh::filter {

HWY_EXPORT(demodulate_row);
HWY_EXPORT(remodulate_row);
HWY_EXPORT(green_row);

namespace {

void rewrite_green(const Plane3& from, bool to_luminance, const Jobs& jobs, Plane3& to) {
    to.fit(from.width(), from.height());
    run_rows(from.height(), jobs, [&](int y) {
        GreenRow row{};
        point_to(row.from, from, y);
        row.width = from.width();
        row.to_luminance = to_luminance;
        point_to(row.to, to, y);
        HWY_DYNAMIC_DISPATCH(green_row)(row);
    });
}

}  // namespace

void luma_from(const Plane3& colour, const Jobs& jobs, Luma3& out) {
    rewrite_green(colour, true, jobs, out);
}

void colour_from(const Luma3& luma, const Jobs& jobs, Plane3& out) {
    rewrite_green(luma, false, jobs, out);
}

void demodulate(const Plane3& light, const Plane3& albedo, const Jobs& jobs, Plane3& out) {
    if (albedo.empty() && &out != &light) out = light;
    run_rows(light.height(), jobs, demodulate_rows(light, albedo, out));
}

RowWork demodulate_rows(const Plane3& light, const Plane3& albedo, Plane3& out) {
    EXPECTS(!albedo.empty() || &out == &light);
    if (albedo.empty()) return {};
    EXPECTS(light.width() == albedo.width() && light.height() == albedo.height());
    out.fit(light.width(), light.height());
    return [&light, &albedo, &out](int y) {
        DemodulateRow row{};
        point_to(row.light, light, y);
        point_to(row.albedo, albedo, y);
        row.width = light.width();
        point_to(row.out, out, y);
        HWY_DYNAMIC_DISPATCH(demodulate_row)(row);
    };
}

void remodulate(const Parts& parts, const Plane3& albedo, const Jobs& jobs, Plane3& out) {
    const RowWork work = remodulate_rows(parts, albedo, out);
    run_rows(out.height(), jobs, work);
}

RowWork remodulate_rows(const Parts& parts, const Plane3& albedo, Plane3& out) {
    const RemodulatedRows rows = remodulated_rows(parts, albedo);
    out.fit(rows.width, rows.height);
    return [work = rows.work, &out](int y) {
        float* to[3];
        point_to(to, out, y);
        work(y, to);
    };
}

RemodulatedRows remodulated_rows(const Parts& parts, const Plane3& albedo) {
    std::array<const Plane3*, 4> lights = {parts.direct, parts.indirect, parts.specular, parts.clean};
    const Plane3* size = albedo.empty() ? nullptr : &albedo;
    for (const Plane3*& light : lights) {
        if (light != nullptr && light->empty()) light = nullptr;
        if (size == nullptr) size = light;
    }
    const int width = size != nullptr ? size->width() : 0, height = size != nullptr ? size->height() : 0;
    for (const Plane3* light : lights) {
        EXPECTS(light == nullptr || (light->width() == width && light->height() == height));
    }
    const auto work = [lights, width, gloss = parts.gloss, &albedo](int y, float* const out[3]) {
        RemodulateRow row{};
        for (std::size_t i = 0; i < 4; ++i) {
            if (lights[i] != nullptr) point_to(row.parts[i], *lights[i], y);
        }
        if (!albedo.empty()) point_to(row.albedo, albedo, y);
        if (gloss != nullptr && !gloss->empty()) point_to(row.gloss, *gloss, y);
        row.width = width;
        std::copy_n(out, 3, row.out);
        HWY_DYNAMIC_DISPATCH(remodulate_row)(row);
    };
    return {width, height, work};
}

}  // namespace gh::filter
#endif
