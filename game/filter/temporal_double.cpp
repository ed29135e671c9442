// The part of the upscaler that adds its pictures up in one of twice their sides.
#include "filter/temporal_picture_kernel.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "filter/temporal_double.cpp"
#include <hwy/foreach_target.h>
// foreach_target must come before what is compiled once per target.
#include "filter/picture_past-inl.h"

HWY_BEFORE_NAMESPACE();
namespace gh::filter::HWY_NAMESPACE {

constexpr std::size_t kMostLanes = HWY_MAX_BYTES / sizeof(float);

// What this picture says of two vectors' worth of large pixels: of the even ones first, then side by side.
struct Twofold {
    HWY_ALIGN float at[2 * kMostLanes];

    HWY_INLINE void put(Floats even, Floats odd) { hn::StoreInterleaved2(even, odd, F(), at); }
    [[nodiscard]] HWY_INLINE Floats get(std::size_t half) const {
        return hn::Load(F(), at + half * lane_count());
    }
};
struct Twofold3 {
    Twofold x, y, z;

    HWY_INLINE void put(const Vector& even, const Vector& odd) {
        x.put(even.x, odd.x);
        y.put(even.y, odd.y);
        z.put(even.z, odd.z);
    }
    [[nodiscard]] HWY_INLINE Vector get(std::size_t half) const {
        return {x.get(half), y.get(half), z.get(half)};
    }
};

// The light that samples around give a place between them, and their range.
struct Around {
    Vector now, low, high;
};

static HWY_INLINE Around around(const DoubleRow& row, std::ptrdiff_t column, const float across[3]) {
    const Floats zero = hn::Zero(F());
    Around here{{zero, zero, zero}, {}, {}};
    here.low = here.high = load3_at(row.picture[1], column);
    for (std::ptrdiff_t v = 0; v < 3; ++v) {
        for (std::ptrdiff_t u = 0; u < 3; ++u) {
            const Vector light = load3_at(row.picture[v], column + u - 1);
            here.now = plus(here.now, scaled(light, splat(across[u] * row.down[v])));
            here.low = least(here.low, light);
            here.high = greatest(here.high, light);
        }
    }
    here.now = clamped(here.now, here.low, here.high);  // whatever was rounded
    return here;
}

// Of a row without borders, whose outermost numbers repeat.
static HWY_INLINE Floats load_within(const float* row, std::ptrdiff_t first, std::int32_t width) {
    if (first >= 0 && first + static_cast<std::ptrdiff_t>(lane_count()) <= width) return load(row + first);
    const Ints place = hn::Min(hn::Max(pixel_numbers(first), hn::Zero(I())), hn::Set(I(), width - 1));
    return hn::GatherIndex(F(), row, place);
}

struct Columns {
    Twofold3 now, low, high;
    Twofold by_x, by_y, moves, nearness;
};

static HWY_INLINE void double_vector(const DoubleRow& row, const Columns& here, std::size_t half,
                                     std::size_t x) {
    const auto i = static_cast<std::ptrdiff_t>(x);
    const Vector now = here.now.get(half);
    Vector mean = now;
    const Floats zero = hn::Zero(F()), one = splat(1.0f), column = hn::ConvertTo(F(), pixel_numbers(i));
    const Floats by_x = here.by_x.get(half), by_y = here.by_y.get(half);
    const Floats at_x = hn::Add(column, hn::Add(by_x, by_x));
    const Floats at_y = hn::Add(splat(static_cast<float>(row.y)), hn::Add(by_y, by_y));
    const Lanes seen =
        hn::And(hn::And(inside(pixel_numbers(i), row.width), hn::And(hn::Ge(at_x, zero), hn::Ge(at_y, zero))),
                hn::And(hn::Le(at_x, splat(static_cast<float>(row.past.width - 1))),
                        hn::Le(at_y, splat(static_cast<float>(row.past.height - 1)))));
    if (row.past.is_there && !hn::AllFalse(F(), seen)) {
        const Vector before =
            clamped(picture_at(row.past, at_x, at_y, seen), here.low.get(half), here.high.get(half));
        const Floats by = hn::Sqrt(hn::Add(hn::Mul(by_x, by_x), hn::Mul(by_y, by_y)));
        const Floats moved = hn::Min(one, hn::Add(by, by));
        const Floats pictures = hn::Add(splat(row.pictures.still),
                                        hn::Mul(splat(row.pictures.moving - row.pictures.still), moved));
        const Floats nearness = here.nearness.get(half);
        const Floats evened = hn::Mul(splat(1.0f - row.nearness_moving), moved);
        const Floats counts = hn::Add(nearness, hn::Mul(evened, hn::Sub(one, nearness)));
        Floats share = hn::Min(hn::Div(counts, pictures), one);
        if (row.past.moved != nullptr) {
            const auto small = [&](Floats at) { return hn::Mul(hn::Sub(at, splat(0.5f)), splat(0.5f)); };
            const Lanes fresh = was_hidden(row.past, here.moves.get(half), small(at_x), small(at_y), seen);
            share = choose(fresh, one, share);
        }
        const Vector mixed = plus(before, scaled(minus(now, before), share));
        mean = choose(seen, mixed, now);
    }
    store3(mean, row.next, x);
    store3(mean, row.out, x, static_cast<std::size_t>(row.width));
}

static void double_up(const DoubleRow& row) {
    const std::int32_t small = row.width / 2;
    Columns here;
    here.nearness.put(splat(row.nearness[0]), splat(row.nearness[1]));
    for (std::ptrdiff_t u = 0; u < small; u += static_cast<std::ptrdiff_t>(lane_count())) {
        const std::ptrdiff_t even = u + row.nearest[0], odd = u + row.nearest[1];
        const Around left = around(row, even, row.across[0]), right = around(row, odd, row.across[1]);
        here.now.put(left.now, right.now);
        here.low.put(left.low, right.low);
        here.high.put(left.high, right.high);
        here.by_x.put(load_within(row.motion[0], even, small), load_within(row.motion[0], odd, small));
        here.by_y.put(load_within(row.motion[1], even, small), load_within(row.motion[1], odd, small));
        if (row.past.moved != nullptr)
            here.moves.put(load_within(row.moves, even, small), load_within(row.moves, odd, small));
        for (std::size_t half = 0; half < 2; ++half) {
            const std::size_t x = 2 * static_cast<std::size_t>(u) + half * lane_count();
            if (x < static_cast<std::size_t>(row.width)) double_vector(row, here, half, x);
        }
    }
}

}  // namespace gh::filter::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gh::filter {

HWY_EXPORT(double_up);

void double_picture(const DoubleRow& row) {
    HWY_DYNAMIC_DISPATCH(double_up)(row);
}

}  // namespace gh::filter
#endif
