// filter/taps-inl.h - reading four pixels of the last frame for each pixel of a vector. Compiled once per instruction
// set; see simd-inl.h.
//
// Mostly a vector's pixels were side by side a frame ago as well: then four plain loads do. Where motion tears them
// apart they are gathered. Either way the same numbers come back.
#if defined(GH_FILTER_TAPS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GH_FILTER_TAPS_INL_H_
#undef GH_FILTER_TAPS_INL_H_
#else
#define GH_FILTER_TAPS_INL_H_
#endif

#include "filter/simd-inl.h"

HWY_BEFORE_NAMESPACE();
namespace gh::filter::HWY_NAMESPACE {

struct TapPlace {
    Ints first;
    std::ptrdiff_t start;  // of the first lane
    bool side_by_side;
};

// Of those lanes whose taps matter; at least one must. The others read somewhere near.
static HWY_INLINE TapPlace place_of(Ints first, Lanes matter) {
    HWY_ALIGN std::int32_t places[HWY_MAX_BYTES / sizeof(std::int32_t)];
    hn::Store(first, I(), places);
    const std::ptrdiff_t lane = hn::FindFirstTrue(F(), matter);
    const auto start = static_cast<std::int32_t>(places[lane] - lane);
    const Ints in_line = hn::Iota(I(), start);
    const Lanes fits = hn::RebindMask(F(), hn::Eq(first, in_line));
    const bool side_by_side = hn::AllTrue(F(), hn::Or(fits, hn::Not(matter)));
    return {side_by_side ? in_line : first, start, side_by_side};
}

static HWY_INLINE Floats read_tap(const float* plane, const TapPlace& place, std::ptrdiff_t step) {
    return place.side_by_side ? load(plane + place.start + step)
                              : hn::GatherIndex(F(), plane + step, place.first);
}

static HWY_INLINE Ints read_tap(const std::uint32_t* plane, const TapPlace& place, std::ptrdiff_t step) {
    const auto* numbers = reinterpret_cast<const std::int32_t*>(plane) + step;
    return place.side_by_side ? hn::LoadU(I(), numbers + place.start)
                              : hn::GatherIndex(I(), numbers, place.first);
}

}  // namespace gh::filter::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // GH_FILTER_TAPS_INL_H_
