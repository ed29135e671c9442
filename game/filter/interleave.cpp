#include "filter/interleave.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "filter/interleave.cpp"
#include <hwy/foreach_target.h>
// foreach_target must come before what is compiled once per target.
#include "filter/simd-inl.h"

HWY_BEFORE_NAMESPACE();
namespace gh::filter::HWY_NAMESPACE {

static void part_one_row(const float* from, std::size_t count, float* const to[3]) {
    std::size_t x = 0;
    for (; x + lane_count() <= count; x += lane_count()) {
        Floats a, b, c;
        hn::LoadInterleaved3(F(), from + 3 * x, a, b, c);
        store(a, to[0] + x);
        store(b, to[1] + x);
        store(c, to[2] + x);
    }
    for (; x < count; ++x) {
        for (std::size_t c = 0; c < 3; ++c) to[c][x] = from[3 * x + c];
    }
}

static void join_one_row(const float* const from[3], std::size_t count, float* to) {
    std::size_t x = 0;
    for (; x + lane_count() <= count; x += lane_count())
        hn::StoreInterleaved3(load(from[0] + x), load(from[1] + x), load(from[2] + x), F(), to + 3 * x);
    for (; x < count; ++x) {
        for (std::size_t c = 0; c < 3; ++c) to[3 * x + c] = from[c][x];
    }
}

}  // namespace gh::filter::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gh::filter {

HWY_EXPORT(part_one_row);
HWY_EXPORT(join_one_row);

void part_row(const float* from, std::size_t count, float* const to[3]) {
    HWY_DYNAMIC_DISPATCH(part_one_row)(from, count, to);
}

void join_row(const float* const from[3], std::size_t count, float* to) {
    HWY_DYNAMIC_DISPATCH(join_one_row)(from, count, to);
}

}  // namespace gh::filter
#endif
