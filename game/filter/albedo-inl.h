// filter/albedo-inl.h - the colour light is divided by. Compiled once per instruction set; see simd-inl.h.
#if defined(GH_FILTER_ALBEDO_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GH_FILTER_ALBEDO_INL_H_
#undef GH_FILTER_ALBEDO_INL_H_
#else
#define GH_FILTER_ALBEDO_INL_H_
#endif

#include "filter/albedo.h"
#include "filter/simd-inl.h"

HWY_BEFORE_NAMESPACE();
namespace gh::filter::HWY_NAMESPACE {

static HWY_INLINE Floats usable_albedo(const float* from) {
    const Floats albedo = load_far(from), least = splat(kLeastAlbedo);
    return choose(hn::And(hn::Gt(albedo, least), is_finite(albedo)), albedo, least);
}

}  // namespace gh::filter::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // GH_FILTER_ALBEDO_INL_H_
