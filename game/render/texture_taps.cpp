#include "render/texture_taps.h"

#include <hwy/cache_control.h>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/texture_taps.cpp"
#include <hwy/foreach_target.h>
// foreach_target must come before what is compiled once per target.
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace gh::render::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using F = hn::CappedTag<float, 4>;
using I = hn::RebindToSigned<F>;
using Half = hn::Rebind<std::uint16_t, F>;
using Floats = hn::Vec<F>;
using Ints = hn::Vec<I>;

using Wide = hn::CappedTag<float, 2 * kMostTaps>;
using WideInts = hn::RebindToSigned<Wide>;
using Spread = hn::Vec<Wide>;
using SpreadInts = hn::Vec<WideInts>;

constexpr std::size_t kAhead = 16;  // queries whose memory is asked for

// Of one query, number 2 * tap + level: where the four texels around the place lie in memory, and how far the place is
// from the first to the last.
struct Places {
    HWY_ALIGN std::int32_t left_top[2 * kMostTaps], right_top[2 * kMostTaps];
    HWY_ALIGN std::int32_t left_bottom[2 * kMostTaps], right_bottom[2 * kMostTaps];
    HWY_ALIGN float across[2 * kMostTaps], down[2 * kMostTaps];
};

// Of one axis.
struct Neighbours {
    SpreadInts first, second;  // offsets in texels
    Spread share;
};

// A level's number for lanes that are now the fine one's and now the coarse one's.
template <class D, class T>
static HWY_INLINE hn::Vec<D> by_turns(D d, const T (&number)[4], std::size_t i) {
    return hn::LoadDup128(d, number + (hn::MaxLanes(d) == 1 ? i % 2 : 0));
}

// Brings coordinates into [0, 1].
static HWY_INLINE Spread folded(Spread t, Edge edge) {
    const Wide d;
    if (edge == Edge::Repeat) return hn::Sub(t, hn::Floor(t));
    const Spread one = hn::Set(d, 1.0f), zero = hn::Zero(d);
    if (edge == Edge::Clamp)
        return hn::IfThenElse(hn::Gt(t, one), one, hn::IfThenElse(hn::Lt(t, zero), zero, t));
    const Spread two = hn::Set(d, 2.0f);
    const Spread back = hn::Sub(t, hn::Mul(two, hn::Floor(hn::Mul(hn::Set(d, 0.5f), t))));
    return hn::IfThenElse(hn::Le(back, one), back, hn::Sub(two, back));
}

static HWY_INLINE SpreadInts offset_of(SpreadInts texel, const MipAxis& axis, std::size_t i) {
    const WideInts d;
    const SpreadInts block = hn::ShiftRight<2>(texel), within = hn::And(texel, hn::Set(d, kBlockSide - 1));
    return hn::Add(hn::Mul(block, by_turns(d, axis.block_step, i)),
                   hn::Mul(within, hn::Set(d, axis.texel_step)));
}

static HWY_INLINE Neighbours neighbours(const MipAxis& axis, float first_tap, float step, std::size_t i) {
    HWY_ALIGN static constexpr float kTap[2 * kMostTaps] = {0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 5, 5, 6, 6, 7, 7};
    const Wide d;
    const WideInts ints;
    const Spread t = hn::Add(hn::Set(d, first_tap), hn::Mul(hn::Set(d, step), hn::Load(d, kTap + i)));
    const Spread at = hn::Sub(hn::Mul(folded(t, axis.edge), by_turns(d, axis.size, i)), hn::Set(d, 0.5f));
    const Spread floor = hn::Floor(at);
    const SpreadInts low = hn::ConvertTo(ints, floor), high = hn::Add(low, hn::Set(ints, 1));
    const SpreadInts last = by_turns(ints, axis.last, i);
    const SpreadInts first = hn::IfThenElse(hn::Lt(low, hn::Zero(ints)), by_turns(ints, axis.below, i), low);
    const SpreadInts second = hn::IfThenElse(hn::Gt(high, last), by_turns(ints, axis.above, i), high);
    return {offset_of(hn::Min(first, last), axis, i), offset_of(second, axis, i), hn::Sub(at, floor)};
}

static HWY_INLINE void find_places(const TapQuery& query, Places& places) {
    const Wide d;
    const WideInts ints;
    const auto count = 2 * static_cast<std::size_t>(query.taps);
    for (std::size_t i = 0; i < count; i += hn::Lanes(d)) {
        const Neighbours u = neighbours(query.levels->axis[0], query.uv[0], query.step[0], i);
        const Neighbours v = neighbours(query.levels->axis[1], query.uv[1], query.step[1], i);
        hn::Store(hn::Add(u.first, v.first), ints, places.left_top + i);
        hn::Store(hn::Add(u.second, v.first), ints, places.right_top + i);
        hn::Store(hn::Add(u.first, v.second), ints, places.left_bottom + i);
        hn::Store(hn::Add(u.second, v.second), ints, places.right_bottom + i);
        hn::Store(u.share, d, places.across + i);
        hn::Store(v.share, d, places.down + i);
    }
}

static HWY_INLINE void fetch(const std::uint16_t* rgba, std::int32_t texel) {
    hwy::Prefetch(rgba + 4 * static_cast<std::size_t>(texel));
}

static HWY_INLINE void fetch_texels(const TapQuery& query, const Places& places) {
    for (std::size_t i = 0; i < 2 * static_cast<std::size_t>(query.taps); i += 2) {
        fetch(query.fine, places.left_top[i]);
        fetch(query.fine, places.right_bottom[i]);
        fetch(query.coarse, places.left_top[i + 1]);
    }
}

static HWY_INLINE Floats channels(const std::uint16_t* rgba, std::int32_t texel, std::size_t channel) {
    const auto bits = hn::LoadU(Half(), rgba + 4 * static_cast<std::size_t>(texel) + channel);
    return hn::ConvertTo(F(), hn::PromoteTo(I(), bits));
}

static HWY_INLINE Floats mixed(Floats a, Floats b, float share) {
    return hn::Add(hn::Mul(a, hn::Set(F(), 1.0f - share)), hn::Mul(b, hn::Set(F(), share)));
}

static HWY_INLINE Floats bilinear(const std::uint16_t* rgba, const Places& places, std::size_t i,
                                  std::size_t channel) {
    const Floats above = mixed(channels(rgba, places.left_top[i], channel),
                               channels(rgba, places.right_top[i], channel), places.across[i]);
    const Floats below = mixed(channels(rgba, places.left_bottom[i], channel),
                               channels(rgba, places.right_bottom[i], channel), places.across[i]);
    return mixed(above, below, places.down[i]);
}

static HWY_INLINE void average_at(const TapQuery& query, const Places& places, float* rgba) {
    const float scale = 1.0f / (65535.0f * static_cast<float>(query.taps));
    for (std::size_t c = 0; c < 4; c += hn::Lanes(F())) {
        Floats sum = hn::Zero(F());
        for (std::size_t i = 0; i < 2 * static_cast<std::size_t>(query.taps); i += 2) {
            Floats light = bilinear(query.fine, places, i, c);
            if (query.blend != 0.0f)
                light = mixed(light, bilinear(query.coarse, places, i + 1, c), query.blend);
            sum = hn::Add(sum, light);
        }
        hn::StoreU(hn::Mul(sum, hn::Set(F(), scale)), F(), rgba + c);
    }
}

// The memory of all is asked for before the first is read.
static void average(const TapQuery* queries, std::size_t count, float* rgba) {
    Places places[kAhead];
    for (std::size_t begin = 0; begin < count; begin += kAhead) {
        const std::size_t group = count - begin < kAhead ? count - begin : kAhead;
        for (std::size_t i = 0; i < group; ++i) {
            find_places(queries[begin + i], places[i]);
            if (group > 1) fetch_texels(queries[begin + i], places[i]);
        }
        for (std::size_t i = 0; i < group; ++i)
            average_at(queries[begin + i], places[i], rgba + 4 * (begin + i));
    }
}

}  // namespace gh::render::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gh::render {

HWY_EXPORT(average);

MipPair mip_pair(const MipView& fine, const MipView& coarse, Edge edge_u, Edge edge_v) {
    MipPair pair;
    for (int a = 0; a < 2; ++a) {
        MipAxis& axis = pair.axis[a];
        axis.edge = a == 0 ? edge_u : edge_v;
        axis.texel_step = a == 0 ? 1 : kBlockSide;
        const bool repeats = axis.edge == Edge::Repeat;
        for (int i = 0; i < 4; ++i) {
            const MipView& mip = i % 2 == 0 ? fine : coarse;
            const int size = a == 0 ? mip.width : mip.height;
            axis.size[i] = static_cast<float>(size);
            axis.last[i] = size - 1;
            axis.below[i] = repeats ? size - 1 : 0;
            axis.above[i] = repeats ? 0 : size - 1;
            axis.block_step[i] = kBlockSide * kBlockSide * (a == 0 ? 1 : mip.blocks_across);
        }
    }
    return pair;
}

void average_taps(const TapQuery* queries, std::size_t count, float* rgba) {
    HWY_DYNAMIC_DISPATCH(average)(queries, count, rgba);
}

}  // namespace gh::render
#endif
