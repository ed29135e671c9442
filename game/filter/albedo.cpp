#include "filter/albedo.h"

#include "filter/albedo_kernel.h"
#include "filter/rows.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "filter/albedo.cpp"
#include <hwy/foreach_target.h>
// foreach_target must come before what is compiled once per target.
#include "filter/simd-inl.h"

HWY_BEFORE_NAMESPACE();
namespace gh::filter::HWY_NAMESPACE {

static HWY_INLINE Floats usable_albedo(const float* from) {
    const Floats albedo = load(from), least = splat(kLeastAlbedo);
    return choose(hn::And(hn::Gt(albedo, least), is_finite(albedo)), albedo, least);
}

static void demodulate_row(const DemodulateRow& row) {
    for (std::size_t x = 0; x < static_cast<std::size_t>(row.width); x += lane_count()) {
        for (std::size_t c = 0; c < 3; ++c) {
            store(hn::Div(load(row.light[c] + x), usable_albedo(row.albedo[c] + x)), row.out[c] + x);
        }
    }
}

static HWY_INLINE Floats light_or_black(const float* from, std::size_t x) {
    return from != nullptr ? load(from + x) : hn::Zero(F());
}

static void remodulate_row(const RemodulateRow& row) {
    for (std::size_t x = 0; x < static_cast<std::size_t>(row.width); x += lane_count()) {
        for (std::size_t c = 0; c < 3; ++c) {
            Floats light = hn::Add(light_or_black(row.parts[0][c], x), light_or_black(row.parts[1][c], x));
            if (row.albedo[c] != nullptr) light = hn::Mul(light, usable_albedo(row.albedo[c] + x));
            light = hn::Add(light, light_or_black(row.parts[2][c], x));
            store(hn::Add(light, light_or_black(row.parts[3][c], x)), row.out[c] + x);
        }
    }
}

}  // namespace gh::filter::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gh::filter {

HWY_EXPORT(demodulate_row);
HWY_EXPORT(remodulate_row);

void demodulate(const Plane3& light, const Plane3& albedo, const Jobs& jobs, Plane3& out) {
    if (albedo.empty()) {
        if (&out != &light) out = light;
        return;
    }
    EXPECTS(light.width() == albedo.width() && light.height() == albedo.height());
    out.fit(light.width(), light.height());
    run_rows(light.height(), jobs, [&](int y) {
        DemodulateRow row{};
        point_to(row.light, light, y);
        point_to(row.albedo, albedo, y);
        row.width = light.width();
        point_to(row.out, out, y);
        HWY_DYNAMIC_DISPATCH(demodulate_row)(row);
    });
}

void remodulate(const Parts& parts, const Plane3& albedo, const Jobs& jobs, Plane3& out) {
    const Plane3* lights[] = {parts.direct, parts.indirect, parts.specular, parts.clean};
    const Plane3* size = albedo.empty() ? nullptr : &albedo;
    for (const Plane3*& light : lights) {
        if (light != nullptr && light->empty()) light = nullptr;
        if (size == nullptr) size = light;
    }
    const int width = size != nullptr ? size->width() : 0, height = size != nullptr ? size->height() : 0;
    for (const Plane3* light : lights) {
        EXPECTS(light == nullptr || (light->width() == width && light->height() == height));
    }
    out.fit(width, height);
    run_rows(height, jobs, [&](int y) {
        RemodulateRow row{};
        for (std::size_t i = 0; i < 4; ++i) {
            if (lights[i] != nullptr) point_to(row.parts[i], *lights[i], y);
        }
        if (!albedo.empty()) point_to(row.albedo, albedo, y);
        row.width = width;
        point_to(row.out, out, y);
        HWY_DYNAMIC_DISPATCH(remodulate_row)(row);
    });
}

}  // namespace gh::filter
#endif
