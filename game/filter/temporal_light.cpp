// The part of the upscaler that spreads light over surfaces.
#include "filter/temporal_light_kernel.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "filter/temporal_light.cpp"
#include <hwy/foreach_target.h>
// foreach_target must come before what is compiled once per target.
#include "filter/simd-inl.h"
#include "filter/temporal_past-inl.h"

HWY_BEFORE_NAMESPACE();
namespace gh::filter::HWY_NAMESPACE {

constexpr float kStillCount = 10.0f;  // samples a mean of light goes over where nothing moves ...
constexpr float kMovingCount =
    2.0f;  // ... and where each frame moves it: it blurs, and what is mirrored lags
constexpr float kLeastCount = 0.02f;  // what a sample counts that is far away,
constexpr float kMovingLeast = 0.5f;  // or this where things move: what is mirrored slides along,
constexpr float kFirstCount = 0.2f;   // or this where little is kept
constexpr float kBeyond = 0.5f;  // of the range of samples around, further than which nothing is believed

// Which show one surface, that goes on between them; it leaves its own plane by less than `reach`.
static HWY_INLINE Lanes are_one(const Seen& a, const Seen& b, Floats reach) {
    const Vector offset = minus(b.position, a.position);
    const Lanes goes_on =
        both(hn::Lt(hn::Abs(dot(offset, a.normal)), reach), hn::Lt(hn::Abs(dot(offset, b.normal)), reach));
    const Lanes is_surface = both(hn::Ge(dot(a.normal, b.normal), splat(kSameFacing)), goes_on);
    const Lanes is_sky = equal(a.part, hn::Set(I(), kSky));
    return both(equal(a.part, b.part), hn::Or(is_sky, is_surface));
}

// Reads lit pixels around the pixels of a vector: several of these may have the same.
class LitReader {
  public:
    LitReader(std::ptrdiff_t start, Ints from_start)
        : start_(start),
          floats_(hn::IndicesFromVec(F(), from_start)),
          ints_(hn::IndicesFromVec(I(), from_start)) {}

    [[nodiscard]] HWY_INLINE Floats read(const float* plane) const {
        return hn::TableLookupLanes(load(plane + start_), floats_);
    }
    [[nodiscard]] HWY_INLINE Vector read(const float* const planes[3]) const {
        return {read(planes[0]), read(planes[1]), read(planes[2])};
    }
    [[nodiscard]] HWY_INLINE Ints read(const std::uint32_t* plane) const {
        const auto* numbers = reinterpret_cast<const std::int32_t*>(plane);
        return hn::TableLookupLanes(hn::LoadU(I(), numbers + start_), ints_);
    }

  private:
    std::ptrdiff_t start_;
    decltype(hn::IndicesFromVec(F(), hn::Zero(I()))) floats_;
    decltype(hn::IndicesFromVec(I(), hn::Zero(I()))) ints_;
};

struct Fresh {
    Vector light, low, high;
    Lanes is_known;
    Floats count;  // what it is worth
};

// This frame's light on the pixels' surfaces, by the lit pixels around them.
static HWY_INLINE Fresh fresh_light(const SpreadRow& row, std::size_t x, const Seen& here, Floats distance) {
    const Floats zero = hn::Zero(F()), one = splat(1.0f);
    const Vector nothing{zero, zero, zero};
    const Vector most{splat(1e30f), splat(1e30f), splat(1e30f)};
    Fresh fresh{nothing, most, minus(nothing, most), hn::FirstN(F(), 0), zero};
    const Ints u = hn::LoadU(I(), row.u + x);
    const Floats share_x = load(row.share_x + x), reach = hn::Mul(distance, splat(row.reach));
    Floats total = zero, nearest_off = splat(1e30f);
    Vector nearest = nothing;
    for (int corner = 0; corner < 4; ++corner) {
        const int right = corner % 2, below = corner / 2, v = row.v + below;
        const float weight_y = below != 0 ? row.share_y : 1.0f - row.share_y;
        if (v < 0 || v >= row.lit.height || !(weight_y > 0.0f)) continue;
        const LitReader reader(v * row.lit.stride + row.u[x] + right, hn::Sub(u, hn::Set(I(), row.u[x])));
        const Floats to_left = right != 0 ? hn::Sub(one, share_x) : share_x;
        const Floats weight = hn::Mul(hn::Sub(one, to_left), splat(weight_y));
        const Lanes is_there =
            both(both(inside(hn::Add(u, hn::Set(I(), right)), row.lit.width), hn::Gt(weight, zero)),
                 hn::Gt(reader.read(row.lit.known), zero));
        const Vector light = reader.read(row.lit.light);
        const Floats off_x = hn::Mul(to_left, splat(row.step));
        const float off_y = (1.0f - weight_y) * row.step;
        const Floats off2 = hn::Add(hn::Mul(off_x, off_x), splat(off_y * off_y));
        const Lanes is_nearest = both(is_there, hn::Lt(off2, nearest_off));
        nearest_off = choose(is_nearest, off2, nearest_off);
        nearest = choose(is_nearest, light, nearest);

        const Seen there{reader.read(row.lit.part), reader.read(row.lit.normal),
                         reader.read(row.lit.position)};
        const Lanes is_itself = hn::Eq(off2, zero);
        const Lanes counts = both(is_there, hn::Or(is_itself, are_one(here, there, reach)));
        const Floats share = zero_unless(counts, weight);
        fresh.light = plus(fresh.light, scaled(light, share));
        total = hn::Add(total, share);
        fresh.low = choose(counts, least(fresh.low, reader.read(row.lit.low)), fresh.low);
        fresh.high = choose(counts, greatest(fresh.high, reader.read(row.lit.high)), fresh.high);
        const Floats count = hn::Mul(load(row.near_x[right] + x), splat(row.near_y[below]));
        fresh.count = hn::Max(fresh.count, zero_unless(counts, count));
    }
    fresh.is_known = hn::Gt(total, zero);
    const Floats scale = hn::Div(one, choose(fresh.is_known, total, one));
    fresh.light = choose(fresh.is_known, scaled(fresh.light, scale), nearest);  // of something else, but near
    fresh.count = zero_unless(fresh.is_known, hn::Max(fresh.count, splat(kLeastCount)));
    return fresh;
}

// Brings what is kept back to the range of what is around: the further, the less its past is worth.
static HWY_INLINE void believe(const Fresh& fresh, Kept& kept) {
    const Lanes judged = both(hn::Gt(kept.count, hn::Zero(F())), fresh.is_known);
    const Vector slack = scaled(minus(fresh.high, fresh.low), splat(kBeyond));
    Vector believed = clamped(kept.light, minus(fresh.low, slack), plus(fresh.high, slack));
    const Lanes as_it_was = both(hn::Eq(believed.x, kept.light.x),
                                 both(hn::Eq(believed.y, kept.light.y), hn::Eq(believed.z, kept.light.z)));
    // What is proved wrong is given no slack: a lamp's last tenth would linger in it.
    believed = choose(as_it_was, believed, clamped(kept.light, fresh.low, fresh.high));
    const Floats off = length(minus(believed, kept.light));
    const Floats size = hn::Add(length(kept.light), splat(1e-6f)), one = splat(1.0f);
    const Floats left = hn::Sub(one, hn::Min(one, hn::Div(off, size)));
    kept.count = choose(judged, hn::Mul(kept.count, left), kept.count);
    kept.light = choose(judged, believed, kept.light);
}

static HWY_INLINE void spread_vector(const SpreadRow& row, std::size_t x) {
    const auto width = static_cast<std::size_t>(row.width);
    const Seen here{load_part(row.part, x, width), load3(row.normal, x, width),
                    load3(row.position, x, width)};
    const Motion motion = motion_of(row, x, here);
    const Fresh fresh = fresh_light(row, x, here, motion.distance);
    Kept kept = kept_light(row, x, motion, here);
    believe(fresh, kept);

    const Floats zero = hn::Zero(F()), one = splat(1.0f);
    const Floats by = hn::Sqrt(hn::Add(hn::Mul(motion.x, motion.x), hn::Mul(motion.y, motion.y)));
    const Floats moved = hn::Min(one, hn::Add(by, by));
    Floats count = fresh.count;
    count = choose(hn::Lt(kept.count, one), hn::Max(count, splat(kFirstCount)), count);
    count = zero_unless(fresh.is_known, hn::Max(count, hn::Mul(splat(kMovingLeast), moved)));
    const Floats total = hn::Add(kept.count, count);
    const Floats share = hn::Div(count, choose(hn::Gt(total, zero), total, one));
    const Vector mixed = plus(kept.light, scaled(minus(fresh.light, kept.light), share));
    const Vector light = choose(hn::Gt(total, zero), mixed, fresh.light);
    const Floats longest = hn::Add(splat(kStillCount), hn::Mul(splat(kMovingCount - kStillCount), moved));
    store3(light, row.light, x);
    store(hn::Min(total, longest), row.count + x);
    store(motion.distance, row.distance + x);
    hn::StoreU(here.part, I(), reinterpret_cast<std::int32_t*>(row.kept_part) + x);
    hn::StoreU(packed_facing(here.normal), I(), reinterpret_cast<std::int32_t*>(row.kept_facing) + x);
    store(motion.x, row.motion[0] + x);
    store(motion.y, row.motion[1] + x);
    const Lanes stays = hn::Or(equal(here.part, hn::Set(I(), kSky)),
                               stays_put(here.position, load3(row.previous, x, width), splat3(row.eye)));
    store(choose(stays, zero, one), row.moves + x);
    const Vector colour = plus(times(light, load3(row.albedo, x, width)), load3(row.clean, x, width));
    const Lanes is_number = both(is_finite(colour.x), both(is_finite(colour.y), is_finite(colour.z)));
    store3({hn::Max(zero_unless(is_number, colour.x), zero), hn::Max(zero_unless(is_number, colour.y), zero),
            hn::Max(zero_unless(is_number, colour.z), zero)},
           row.lighted, x);
}

static void spread(const SpreadRow& row) {
    for (std::size_t x = 0; x < static_cast<std::size_t>(row.width); x += lane_count()) spread_vector(row, x);
}

static HWY_INLINE Seen lit_at(const LitPlanes& lit, std::ptrdiff_t i) {
    return {hn::LoadU(I(), reinterpret_cast<const std::int32_t*>(lit.part) + i), load3_at(lit.normal, i),
            load3_at(lit.position, i)};
}

static void range(const RangeRow& row) {
    const LitPlanes& lit = row.lit;
    for (int u = 0; u < lit.width; u += static_cast<int>(lane_count())) {
        const std::ptrdiff_t i = row.v * lit.stride + u;
        const Seen here = lit_at(lit, i);
        const Floats reach = hn::Mul(load(lit.distance + i), splat(row.reach));
        Vector low = load3_at(lit.light, i), high = low;
        for (int k = 0; k < 9; ++k) {
            const int right = k % 3 - 1, below = k / 3 - 1;
            if (k == 4 || row.v + below < 0 || row.v + below >= lit.height) continue;
            const std::ptrdiff_t j = i + below * lit.stride + right;
            const Lanes counts = both(
                both(inside(pixel_numbers(u + right), lit.width), hn::Gt(load(lit.known + j), hn::Zero(F()))),
                are_one(here, lit_at(lit, j), reach));
            const Vector light = load3_at(lit.light, j);
            low = choose(counts, least(low, light), low);
            high = choose(counts, greatest(high, light), high);
        }
        store3(low, row.low, static_cast<std::size_t>(u));
        store3(high, row.high, static_cast<std::size_t>(u));
    }
}

}  // namespace gh::filter::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gh::filter {

HWY_EXPORT(spread);
HWY_EXPORT(range);

void spread_light(const SpreadRow& row) {
    HWY_DYNAMIC_DISPATCH(spread)(row);
}

void find_range(const RangeRow& row) {
    HWY_DYNAMIC_DISPATCH(range)(row);
}

}  // namespace gh::filter
#endif
