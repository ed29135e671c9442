#include "render/lamp_weights.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/lamp_weights.cpp"
#include <hwy/foreach_target.h>
// foreach_target must come before what is compiled once per target.
#include <hwy/highway.h>

#ifndef GLASSHOUSE_LAMP_WEIGHT_QUERY
#define GLASSHOUSE_LAMP_WEIGHT_QUERY
namespace gh::render {

// Plain numbers, since this crosses into code compiled for other instruction sets.
struct WeightQuery {
    const float* rows;
    std::size_t floats_a_row;
    const std::uint32_t* ids;
    std::size_t count;  // at least 1
    float position[3], normal[3];
    bool has_normal;
};

}  // namespace gh::render
#endif

HWY_BEFORE_NAMESPACE();
namespace gh::render::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using F = hn::CappedTag<float, 4>;
using Floats = hn::Vec<F>;

constexpr float kFront = static_cast<float>(LampWeights::Shines::Front);
constexpr float kBoth = static_cast<float>(LampWeights::Shines::Both);
constexpr float kBeam = static_cast<float>(LampWeights::Shines::Beam);

static HWY_INLINE Floats splat(float x) {
    return hn::Set(F(), x);
}

struct Columns {
    Floats column[4];
};

// Four numbers of each of four rows, turned; of one row where there is no vector to hold four.
static HWY_INLINE Columns columns_at(const float* const rows[4], std::size_t at) {
#if HWY_TARGET == HWY_SCALAR
    const float* row = rows[0] + at;
    return {{splat(row[0]), splat(row[1]), splat(row[2]), splat(row[3])}};
#else
    const Floats a = hn::Load(F(), rows[0] + at), b = hn::Load(F(), rows[1] + at);
    const Floats c = hn::Load(F(), rows[2] + at), d = hn::Load(F(), rows[3] + at);
    const Floats ab_low = hn::InterleaveLower(F(), a, b), ab_high = hn::InterleaveUpper(F(), a, b);
    const Floats cd_low = hn::InterleaveLower(F(), c, d), cd_high = hn::InterleaveUpper(F(), c, d);
    return {{hn::ConcatLowerLower(F(), cd_low, ab_low), hn::ConcatUpperUpper(F(), cd_low, ab_low),
             hn::ConcatLowerLower(F(), cd_high, ab_high), hn::ConcatUpperUpper(F(), cd_high, ab_high)}};
#endif
}

// A cosine, kept off 0 so that a lamp that just shows is not forgotten; 1 where there is no way to tell.
static HWY_INLINE Floats facing_share(Floats height, Floats distance) {
    constexpr float kLeastFacing = 0.05f;
    const Floats share = hn::Min(hn::Max(hn::Div(height, distance), splat(kLeastFacing)), splat(1.0f));
    return hn::IfThenElse(hn::Gt(distance, splat(0.0f)), share, splat(1.0f));
}

static void weigh_lamps(const WeightQuery& query, float* weights) {
    const Floats zero = splat(0.0f), one = splat(1.0f);
    for (std::size_t i = 0; i < query.count; i += hn::Lanes(F())) {
        const float* rows[4];
        for (std::size_t k = 0; k < 4; ++k) {
            const std::size_t place = i + k < query.count ? i + k : query.count - 1;
            rows[k] = query.rows + query.ids[place] * query.floats_a_row;
        }
        const auto [centre_x, centre_y, centre_z, extent] = columns_at(rows, 0).column;
        const auto [axis_x, axis_y, axis_z, power] = columns_at(rows, 4).column;
        const auto [shines, cos_outer, unused, unused_too] = columns_at(rows, 8).column;
        const Floats x = hn::Sub(centre_x, splat(query.position[0]));
        const Floats y = hn::Sub(centre_y, splat(query.position[1]));
        const Floats z = hn::Sub(centre_z, splat(query.position[2]));
        const auto along = [&](Floats nx, Floats ny, Floats nz) {
            return hn::Add(hn::Add(hn::Mul(nx, x), hn::Mul(ny, y)), hn::Mul(nz, z));
        };
        const Floats distance2 = along(x, y, z), distance = hn::Sqrt(distance2);
        Floats share = one;
        auto is_open = hn::Gt(power, zero);
        if (query.has_normal) {
            const Floats height = hn::Add(
                along(splat(query.normal[0]), splat(query.normal[1]), splat(query.normal[2])), extent);
            is_open = hn::And(is_open, hn::Gt(height, zero));
            share = facing_share(height, distance);
        }
        const Floats facing = hn::Neg(along(axis_x, axis_y, axis_z));
        const auto is_front = hn::Eq(shines, splat(kFront)), is_beam = hn::Eq(shines, splat(kBeam));
        is_open = hn::And(is_open, hn::Or(hn::Not(is_front), hn::Gt(facing, zero)));
        // Outside a cone by more than rounding: nothing.
        const Floats edge = hn::Mul(hn::Sub(cos_outer, splat(0x1p-20f)), distance);
        is_open = hn::And(is_open, hn::Or(hn::Not(is_beam), hn::Ge(facing, edge)));
        const auto is_panel = hn::Or(is_front, hn::Eq(shines, splat(kBoth)));
        const Floats faced = hn::Mul(share, facing_share(hn::Abs(facing), distance));
        share = hn::IfThenElse(is_panel, faced, share);
        const Floats kept_off2 = hn::IfThenElse(is_beam, one, hn::Max(distance2, hn::Mul(extent, extent)));
        hn::StoreU(hn::IfThenElseZero(is_open, hn::Div(hn::Mul(power, share), kept_off2)), F(), weights + i);
    }
}

}  // namespace gh::render::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

#include "base/contracts.h"

#include <algorithm>

namespace gh::render {

HWY_EXPORT(weigh_lamps);

void LampWeights::set(std::uint32_t id, const Lamp& lamp) {
    EXPECTS(id < lamps_.size());
    lamps_[id] = {.centre = {lamp.centre.x, lamp.centre.y, lamp.centre.z},
                  .extent = lamp.extent,
                  .axis = {lamp.axis.x, lamp.axis.y, lamp.axis.z},
                  .power = lamp.power,
                  .shines = static_cast<float>(lamp.shines),
                  .cos_outer = lamp.cos_outer,
                  .unused = {}};
}

void LampWeights::at(const LightQuery& query, std::span<const std::uint32_t> ids, Weights& weights) const {
    EXPECTS(ids.size() <= kTogether);
    if (!ids.empty()) {
        const WeightQuery asked{.rows = lamps_[0].centre,
                                .floats_a_row = sizeof(Row) / sizeof(float),
                                .ids = ids.data(),
                                .count = ids.size(),
                                .position = {query.position.x, query.position.y, query.position.z},
                                .normal = {query.normal.x, query.normal.y, query.normal.z},
                                .has_normal = query.normal != glm::vec3(0.0f)};
        HWY_DYNAMIC_DISPATCH(weigh_lamps)(asked, weights.data());
    }
    std::fill(weights.begin() + static_cast<std::ptrdiff_t>(ids.size()), weights.end(), 0.0f);
}

}  // namespace gh::render
#endif
