// filter/taps-inl.h - reading four pixels of the last frame for each pixel of a vector. Compiled once per instruction
// set; see simd-inl.h.
//
// Mostly a vector's pixels were side by side a frame ago as well: then four plain loads do. Where motion tears them
// apart it is into a few runs, each of which is read by plain loads again (a gather takes as long as six of them); only
// what lies in more pieces is gathered. Either way the same numbers come back.
#if defined(GH_FILTER_TAPS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GH_FILTER_TAPS_INL_H_
#undef GH_FILTER_TAPS_INL_H_
#else
#define GH_FILTER_TAPS_INL_H_
#endif

#include "filter/simd-inl.h"

#include <hwy/cache_control.h>

HWY_BEFORE_NAMESPACE();
namespace gh::filter::HWY_NAMESPACE {

// Where motion tears pixels apart, into how many runs at most that are read each by plain loads.
constexpr int kMostRuns = 4;

struct TapPlace {
    Ints first;
    int runs;                         // 0: too many, gather
    std::ptrdiff_t start[kMostRuns];  // of a run, if its lane were the first
    Lanes lanes[kMostRuns];           // of the first all that belong to no other
};

// Of pixels that were side by side: of the vector's first.
struct RunPlace {
    std::ptrdiff_t start;
};

// Of pixels that lie anywhere.
static HWY_INLINE TapPlace scattered(Ints first) {
    TapPlace place;
    place.first = first;
    place.runs = 0;
    return place;
}

// Of those lanes whose taps matter; at least one must. The others read somewhere near.
static HWY_INLINE TapPlace place_of(Ints first, Lanes matter) {
    HWY_ALIGN std::int32_t places[HWY_MAX_BYTES / sizeof(std::int32_t)];
    hn::Store(first, I(), places);
    TapPlace to;
    to.first = first;
    to.runs = 0;
    for (Lanes left = matter; !hn::AllFalse(F(), left);) {
        if (to.runs == kMostRuns) {
            to.runs = 0;
            break;
        }
        const std::ptrdiff_t lane = hn::FindFirstTrue(F(), left);
        const auto start = static_cast<std::int32_t>(places[lane] - lane);
        const Lanes run = hn::RebindMask(F(), hn::Eq(first, hn::Iota(I(), start)));
        to.start[to.runs] = start;
        to.lanes[to.runs] = run;
        ++to.runs;
        left = hn::AndNot(run, left);
    }
    return to;
}

// Fetches what the row below will read about here, `step` numbers on. Each plane of the last frame is a stream of its own:
// too many for the processor to foresee them itself (a seventh of the denoiser's time was waiting).
template <class T>
static HWY_INLINE void foresee_tap(const T* plane, const TapPlace& place, std::ptrdiff_t step) {
    if (place.runs > 0) hwy::Prefetch(plane + place.start[0] + step);
}

static HWY_INLINE Floats read_tap(const float* plane, const RunPlace& place, std::ptrdiff_t step) {
    return load(plane + place.start + step);
}

static HWY_INLINE Ints read_tap(const std::uint32_t* plane, const RunPlace& place, std::ptrdiff_t step) {
    return hn::LoadU(I(), reinterpret_cast<const std::int32_t*>(plane) + place.start + step);
}

static HWY_INLINE Floats read_tap(const float* plane, const TapPlace& place, std::ptrdiff_t step) {
    if (place.runs == 0) return hn::GatherIndex(F(), plane + step, place.first);
    Floats value = load(plane + place.start[0] + step);
    for (int run = 1; run < place.runs; ++run)
        value = choose(place.lanes[run], load(plane + place.start[run] + step), value);
    return value;
}

static HWY_INLINE Ints read_tap(const std::uint32_t* plane, const TapPlace& place, std::ptrdiff_t step) {
    const auto* numbers = reinterpret_cast<const std::int32_t*>(plane) + step;
    if (place.runs == 0) return hn::GatherIndex(I(), numbers, place.first);
    Ints value = hn::LoadU(I(), numbers + place.start[0]);
    for (int run = 1; run < place.runs; ++run) {
        const auto lanes = hn::RebindMask(I(), place.lanes[run]);
        value = hn::IfThenElse(lanes, hn::LoadU(I(), numbers + place.start[run]), value);
    }
    return value;
}

}  // namespace gh::filter::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // GH_FILTER_TAPS_INL_H_
