#include "render/texture_taps.h"

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

// For one tap: where the two texels of each axis lie in memory, and how far the place is from the first to the second.
struct Place {
    HWY_ALIGN std::int32_t first[4], second[4];
    HWY_ALIGN float share[4];
};

// Brings a coordinate into [0, 1].
static HWY_INLINE float folded(float t, Edge edge) {
    const auto floor = [](float x) {
        const auto whole = static_cast<float>(static_cast<std::int32_t>(x));
        return whole > x ? whole - 1.0f : whole;
    };
    if (edge == Edge::Repeat) return t - floor(t);
    if (edge == Edge::Clamp) return t < 0.0f ? 0.0f : t > 1.0f ? 1.0f : t;
    const float back = t - 2.0f * floor(0.5f * t);
    return back <= 1.0f ? back : 2.0f - back;
}

static HWY_INLINE Ints offset_of(Ints texel, const MipPair& levels, std::size_t i) {
    const Ints block = hn::ShiftRight<2>(texel), within = hn::And(texel, hn::Set(I(), kBlockSide - 1));
    return hn::Add(hn::Mul(block, hn::Load(I(), levels.block_step + i)),
                   hn::Mul(within, hn::Load(I(), levels.texel_step + i)));
}

static HWY_INLINE void find_place(const MipPair& levels, const float (&uv)[4], Place& place) {
    for (std::size_t i = 0; i < 4; i += hn::Lanes(F())) {
        const Floats at =
            hn::Sub(hn::Mul(hn::Load(F(), uv + i), hn::Load(F(), levels.size + i)), hn::Set(F(), 0.5f));
        const Floats floor = hn::Floor(at);
        const Ints low = hn::ConvertTo(I(), floor), last = hn::Load(I(), levels.last + i);
        const Ints high = hn::Add(low, hn::Set(I(), 1));
        const Ints first = hn::IfThenElse(hn::Lt(low, hn::Zero(I())), hn::Load(I(), levels.below + i), low);
        const Ints second = hn::IfThenElse(hn::Gt(high, last), hn::Load(I(), levels.above + i), high);
        hn::Store(offset_of(hn::Min(first, last), levels, i), I(), place.first + i);
        hn::Store(offset_of(second, levels, i), I(), place.second + i);
        hn::Store(hn::Sub(at, floor), F(), place.share + i);
    }
}

static HWY_INLINE Floats channels(const std::uint16_t* rgba, std::int32_t texel, std::size_t channel) {
    const auto bits = hn::LoadU(Half(), rgba + 4 * static_cast<std::size_t>(texel) + channel);
    return hn::ConvertTo(F(), hn::PromoteTo(I(), bits));
}

static HWY_INLINE Floats mixed(Floats a, Floats b, float share) {
    return hn::Add(hn::Mul(a, hn::Set(F(), 1.0f - share)), hn::Mul(b, hn::Set(F(), share)));
}

static HWY_INLINE Floats bilinear(const std::uint16_t* rgba, const Place& place, int axis,
                                  std::size_t channel) {
    const std::int32_t left = place.first[axis], right = place.second[axis];
    const std::int32_t top = place.first[axis + 1], bottom = place.second[axis + 1];
    const float x = place.share[axis], y = place.share[axis + 1];
    const Floats above = mixed(channels(rgba, left + top, channel), channels(rgba, right + top, channel), x);
    const Floats below =
        mixed(channels(rgba, left + bottom, channel), channels(rgba, right + bottom, channel), x);
    return mixed(above, below, y);
}

static void average(const TapQuery& query, float rgba[4]) {
    const MipPair& levels = *query.levels;
    HWY_ALIGN float sum[4] = {};
    Place place;
    for (int tap = 0; tap < query.taps; ++tap) {
        const auto number = static_cast<float>(tap);
        const float u = folded(query.uv[0] + query.step[0] * number, levels.edge[0]);
        const float v = folded(query.uv[1] + query.step[1] * number, levels.edge[1]);
        HWY_ALIGN const float uv[4] = {u, v, u, v};
        find_place(levels, uv, place);
        for (std::size_t c = 0; c < 4; c += hn::Lanes(F())) {
            Floats light = bilinear(query.fine, place, 0, c);
            if (query.blend != 0.0f) light = mixed(light, bilinear(query.coarse, place, 2, c), query.blend);
            hn::Store(hn::Add(hn::Load(F(), sum + c), light), F(), sum + c);
        }
    }
    const float scale = 1.0f / (65535.0f * static_cast<float>(query.taps));
    for (int c = 0; c < 4; ++c) rgba[c] = sum[c] * scale;
}

}  // namespace gh::render::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gh::render {

HWY_EXPORT(average);

MipPair mip_pair(const MipView& fine, const MipView& coarse, Edge edge_u, Edge edge_v) {
    MipPair pair;
    pair.edge[0] = edge_u;
    pair.edge[1] = edge_v;
    for (int i = 0; i < 4; ++i) {
        const MipView& mip = i < 2 ? fine : coarse;
        const bool is_v = i % 2 == 1, repeats = pair.edge[i % 2] == Edge::Repeat;
        const int size = is_v ? mip.height : mip.width;
        pair.size[i] = static_cast<float>(size);
        pair.last[i] = size - 1;
        pair.below[i] = repeats ? size - 1 : 0;
        pair.above[i] = repeats ? 0 : size - 1;
        pair.block_step[i] = kBlockSide * kBlockSide * (is_v ? mip.blocks_across : 1);
        pair.texel_step[i] = is_v ? kBlockSide : 1;
    }
    return pair;
}

void average_taps(const TapQuery& query, float rgba[4]) {
    HWY_DYNAMIC_DISPATCH(average)(query, rgba);
}

}  // namespace gh::render
#endif
