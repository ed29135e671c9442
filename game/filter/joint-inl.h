// filter/joint-inl.h - reading a small picture for a large one by what both show. Compiled once per instruction set; see
// simd-inl.h.
#if defined(GH_FILTER_JOINT_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GH_FILTER_JOINT_INL_H_
#undef GH_FILTER_JOINT_INL_H_
#else
#define GH_FILTER_JOINT_INL_H_
#endif

#include "filter/geometry-inl.h"

HWY_BEFORE_NAMESPACE();
namespace gh::filter::HWY_NAMESPACE {

// Where a vector of large pixels lies in a small row: never further apart than they are themselves, so that one load and
// one shuffle bring a tap of each.
struct Places {
    std::ptrdiff_t start;
    Ints beyond;  // of `start`
};

static HWY_INLINE Places places_at(Ints places) {
    const std::int32_t start = hn::GetLane(places);
    return {start, hn::Sub(places, hn::Set(I(), start))};
}

static HWY_INLINE Floats read_at(const float* row, const Places& places, std::ptrdiff_t step) {
    return hn::TableLookupLanes(load(row + places.start + step), hn::IndicesFromVec(F(), places.beyond));
}

// What a tap on another surface still counts, so that a pixel with no surface of its own kind near takes something.
constexpr float kForeign = 1e-6f;

// From 0 to 1 (0 to kForeign only where it is another surface): whether the tap `right` of `places` shows the surface, whose
// place it lies dx, dy pixels off.
static HWY_INLINE Floats alike(const Surface& surface, const GuideRows& small, const Places& places,
                               int right, Floats dx, Floats dy) {
    const Floats nearness = read_at(small.nearness, places, right);
    const Floats foretold =
        hn::Add(surface.nearness, hn::Add(hn::Mul(surface.slope_x, dx), hn::Mul(surface.slope_y, dy)));
    const Floats off = hn::Mul(hn::Abs(hn::Sub(nearness, foretold)), surface.scale);
    const Floats cosine =
        dot(surface.nx, surface.ny, surface.nz, read_at(small.normal[0], places, right),
            read_at(small.normal[1], places, right), read_at(small.normal[2], places, right));
    const Floats apart = hn::Add(off, hn::Abs(hn::Sub(splat(0.25f * kNormalSharpness), cosine)));
    const Lanes both_sky = hn::Eq(hn::Add(nearness, surface.nearness), hn::Zero(F()));
    return choose(both_sky, splat(1.0f), hn::Add(falloff(apart), splat(kForeign)));
}

}  // namespace gh::filter::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // GH_FILTER_JOINT_INL_H_
