#include "filter/halve.h"

#include "filter/halve_kernel.h"

#include <algorithm>
#include <utility>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "filter/halve.cpp"
#include <hwy/foreach_target.h>
// foreach_target must come before what is compiled once per target.
#include "filter/joint-inl.h"
#include "filter/vector-inl.h"

HWY_BEFORE_NAMESPACE();
namespace gh::filter::HWY_NAMESPACE {

constexpr float kLeastCosine = 0.9f;  // between normals of a block's pixels that are of one surface

// Two columns of a row of blocks.
struct Columns {
    Floats at[2];
};

static HWY_INLINE Columns columns_of(const float* row, std::size_t u) {
    Columns columns;
    hn::LoadInterleaved2(F(), row + 2 * u, columns.at[0], columns.at[1]);
    return columns;
}

struct PartColumns {
    Ints at[2];
};

static HWY_INLINE PartColumns columns_of(const std::uint32_t* row, std::size_t u) {
    PartColumns columns;
    hn::LoadInterleaved2(I(), reinterpret_cast<const std::int32_t*>(row) + 2 * u, columns.at[0],
                         columns.at[1]);
    return columns;
}

// Of the four pixels of each block: which lie on the surface of the first.
static HWY_INLINE void find_alike(const HalveRow& row, std::size_t u, Lanes fits[4]) {
    Columns near[2], normal[2][3];
    PartColumns part[2];
    for (std::size_t j = 0; j < 2; ++j) {
        near[j] = columns_of(row.guides[j].nearness, u);
        part[j] = columns_of(row.part[j], u);
        for (std::size_t c = 0; c < 3; ++c) normal[j][c] = columns_of(row.guides[j].normal[c], u);
    }
    const Floats slope_x = columns_of(row.guides[0].slope_x, u).at[0];
    const Floats slope_y = columns_of(row.guides[0].slope_y, u).at[0];
    const Floats first = near[0].at[0];
    const Floats slant = hn::Mul(hn::Add(hn::Abs(slope_x), hn::Abs(slope_y)), splat(kSlantTolerance));
    const Floats tolerance = hn::Add(hn::Mul(first, splat(kDepthTolerance)), slant);
    const Ints column = pixel_numbers(static_cast<std::ptrdiff_t>(u));
    const Lanes has_right = inside(hn::Add(hn::Add(column, column), hn::Set(I(), 1)), row.width);
    for (std::size_t k = 0; k < 4; ++k) {
        const std::size_t i = k % 2, j = k / 2;
        const Floats along = hn::Add(i == 1 ? slope_x : hn::Zero(F()), j == 1 ? slope_y : hn::Zero(F()));
        const Floats off = hn::Abs(hn::Sub(near[j].at[i], hn::Add(first, along)));
        const Floats cosine = dot(normal[0][0].at[0], normal[0][1].at[0], normal[0][2].at[0],
                                  normal[j][0].at[i], normal[j][1].at[i], normal[j][2].at[i]);
        const Lanes same_part = hn::RebindMask(F(), hn::Eq(part[j].at[i], part[0].at[0]));
        fits[k] = hn::And(same_part, hn::And(hn::Le(off, tolerance), hn::Ge(cosine, splat(kLeastCosine))));
        if (i == 1) fits[k] = hn::And(fits[k], has_right);
        if (j == 1 && !row.has_second) fits[k] = hn::FirstN(F(), 0);
    }
    fits[0] = hn::Eq(first, first);  // whatever it is
}

static void halve_row(const HalveRow& row) {
    const std::size_t half = (static_cast<std::size_t>(row.width) + 1) / 2;
    const Floats zero = hn::Zero(F()), one = splat(1.0f);
    for (std::size_t u = 0; u < half; u += lane_count()) {
        for (int plane = 0; plane < row.picked; ++plane) {
            fetch_far(row.from[plane] + 2 * u);
            fetch_far(row.from[plane] + 2 * u + lane_count());
            fetch_far(row.to[plane] + u);
            hn::StoreU(columns_of(row.from[plane], u).at[0], I(),
                       reinterpret_cast<std::int32_t*>(row.to[plane]) + u);
        }
        if (row.lights == 0) continue;
        Lanes fits[4];
        find_alike(row, u, fits);
        Floats count = zero;
        for (const Lanes& lanes : fits) count = hn::Add(count, zero_unless(lanes, one));
        const Floats share = hn::Div(one, count);
        for (int light = 0; light < row.lights; ++light) {
            for (std::size_t c = 0; c < 3; ++c) {
                const Columns upper = columns_of(row.light[light][0][c], u);
                const Columns lower = columns_of(row.light[light][1][c], u);
                const Floats above = hn::Add(upper.at[0], zero_unless(fits[1], upper.at[1]));
                const Floats below =
                    hn::Add(zero_unless(fits[2], lower.at[0]), zero_unless(fits[3], lower.at[1]));
                store_far(hn::Mul(hn::Add(above, below), share), row.out_light[light][c] + u);
            }
        }
    }
}

// How the pixels of a vector lie between small ones.
struct Between {
    Ints left;                // of the two beside each
    Floats share[2], off[2];  // what either counts for its nearness; large columns to its middle
};

static HWY_INLINE Between between(std::size_t x) {
    const Ints number = pixel_numbers(static_cast<std::ptrdiff_t>(x));
    Between to;
    to.left = hn::ShiftRight<1>(hn::Sub(number, hn::Set(I(), 1)));
    // From the pixel's middle to that of the left small one: half a column where it is odd, else one and a half.
    const Ints twice = hn::Sub(hn::Add(to.left, to.left), number);
    to.off[0] = hn::Add(hn::ConvertTo(F(), twice), splat(0.5f));
    to.off[1] = hn::Add(to.off[0], splat(2.0f));
    to.share[1] = hn::Mul(hn::Abs(to.off[0]), splat(0.5f));
    to.share[0] = hn::Sub(splat(1.0f), to.share[1]);
    return to;
}

static HWY_INLINE void widen_vector(const WidenRow& row, std::size_t x) {
    const Floats zero = hn::Zero(F()), one = splat(1.0f);
    const Surface surface = surface_at(row.large, x, 2.0f);
    const Ints part = hn::LoadU(I(), reinterpret_cast<const std::int32_t*>(row.large_part) + x);
    const Between at = between(x);
    const Places places = places_at(at.left);
    Floats sum[2][3] = {{zero, zero, zero}, {zero, zero, zero}}, total[2] = {zero, zero};
    for (int tap = 0; tap < 4; ++tap) {
        const int i = tap % 2, j = tap / 2;
        const Floats down = splat(j == 0 ? 1.0f - row.below : row.below);
        const Lanes is_in = inside(hn::Add(at.left, hn::Set(I(), i)), row.small_width);
        // Sky has no light to give and takes none.
        const Lanes is_sky = hn::Eq(read_at(row.small[j].nearness, places, i), zero);
        const Lanes is_apart = hn::Xor(is_sky, hn::Eq(surface.nearness, zero));
        const Lanes counts = hn::AndNot(is_apart, is_in);
        const Floats near = zero_unless(counts, hn::Mul(at.share[i], down));
        const Floats kind = alike(surface, row.small[j], places, i, at.off[i], splat(row.offset_y[j]));
        const auto small_part = hn::TableLookupLanes(
            hn::LoadU(I(), reinterpret_cast<const std::int32_t*>(row.small_part[j]) + places.start + i),
            hn::IndicesFromVec(I(), places.beyond));
        const Lanes same_part = hn::RebindMask(F(), hn::Eq(small_part, part));
        for (int light = 0; light < row.lights; ++light) {
            const Floats fits = row.asks_part[light] ? choose(same_part, kind, splat(kForeign)) : kind;
            const Floats weight = hn::Mul(near, fits);
            total[light] = hn::Add(total[light], weight);
            for (std::size_t c = 0; c < 3; ++c) {
                const Floats value = zero_unless(counts, read_at(row.light[light][j][c], places, i));
                sum[light][c] = hn::Add(sum[light][c], hn::Mul(weight, value));
            }
        }
    }
    for (int light = 0; light < row.lights; ++light) {
        const Lanes found = hn::Gt(total[light], zero);
        const Floats scale = hn::Div(one, choose(found, total[light], one));
        const Floats own_red = load(row.out[light][0] + x), own_blue = load(row.out[light][2] + x);
        const Floats own[3] = {own_red, luminance(own_red, load(row.out[light][1] + x), own_blue), own_blue};
        for (std::size_t c = 0; c < 3; ++c)
            store(choose(found, hn::Mul(sum[light][c], scale), own[c]), row.out[light][c] + x);
    }
}

static void widen_row(const WidenRow& row) {
    for (std::size_t x = 0; x < static_cast<std::size_t>(row.width); x += lane_count()) widen_vector(row, x);
}

}  // namespace gh::filter::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gh::filter {

HWY_EXPORT(halve_row);
HWY_EXPORT(widen_row);

namespace {

const std::uint32_t* numbers_of(const Plane& plane, int y) {
    return reinterpret_cast<const std::uint32_t*>(plane.row(y));
}
std::uint32_t* numbers_of(Plane& plane, int y) {
    return reinterpret_cast<std::uint32_t*>(plane.row(y));
}

void pick(const Plane& from, int y, Plane& to, int v, HalveRow& row) {
    if (from.empty()) return;
    EXPECTS(row.picked < kMostPicked);
    row.from[row.picked] = numbers_of(from, y);
    row.to[row.picked++] = numbers_of(to, v);
}

void pick(const Plane3& from, int y, Plane3& to, int v, HalveRow& row) {
    pick(from.x, y, to.x, v, row);
    pick(from.y, y, to.y, v, row);
    pick(from.z, y, to.z, v, row);
}

template <class Planes>
void fit_like(const Planes& of, int width, int height, Planes& to) {
    of.empty() ? void(to = {}) : to.fit(width, height);
}

}  // namespace

void Halved::fit(const GBuffer& of, const Light& lights, const Plane3& indirect, const Plane3& specular) {
    const int width = (of.width() + 1) / 2, height = (of.height() + 1) / 2;
    surfaces.lens = {of.lens.eye, of.lens.corner, 2.0f * of.lens.right, 2.0f * of.lens.down};
    surfaces.part.fit(width, height);
    fit_like(of.position, width, height, surfaces.position);
    fit_like(of.previous, width, height, surfaces.previous);
    fit_like(of.normal, width, height, surfaces.normal);
    fit_like(of.geometric, width, height, surfaces.geometric);
    fit_like(of.roughness, width, height, surfaces.roughness);
    fit_like(of.reflected, width, height, surfaces.reflected);
    fit_like(indirect, width, height, light.indirect);
    fit_like(specular, width, height, light.specular);
    fit_like(lights.direct_change, width, height, light.direct_change);
    fit_like(lights.indirect_change, width, height, light.indirect_change);
}

RowWork halve_rows(const GBuffer& surfaces, const Guides& guides, const Light& light, const Plane3& indirect,
                   const Plane3& specular, Halved& to) {
    return [&surfaces, &guides, &light, &indirect, &specular, &to](int v) {
        const int y = 2 * v, second = std::min(y + 1, surfaces.height() - 1);
        HalveRow row{};
        row.width = surfaces.width();
        row.has_second = second > y;
        for (std::size_t j = 0; j < 2; ++j) {
            const int line = j == 0 ? y : second;
            row.guides[j] = rows_of(guides, line);
            row.part[j] = surfaces.part.row(line);
        }
        for (const auto& [from, out] :
             {std::pair(&indirect, &to.light.indirect), std::pair(&specular, &to.light.specular)}) {
            if (from->empty()) continue;
            point_to(row.light[row.lights][0], *from, y);
            point_to(row.light[row.lights][1], *from, second);
            point_to(row.out_light[row.lights++], *out, v);
        }
        row.from[0] = surfaces.part.row(y);
        row.to[0] = to.surfaces.part.row(v);
        row.picked = 1;
        pick(surfaces.position, y, to.surfaces.position, v, row);
        pick(surfaces.previous, y, to.surfaces.previous, v, row);
        pick(surfaces.normal, y, to.surfaces.normal, v, row);
        pick(surfaces.geometric, y, to.surfaces.geometric, v, row);
        pick(surfaces.roughness, y, to.surfaces.roughness, v, row);
        pick(surfaces.reflected, y, to.surfaces.reflected, v, row);
        pick(light.direct_change, y, to.light.direct_change, v, row);
        pick(light.indirect_change, y, to.light.indirect_change, v, row);
        HWY_DYNAMIC_DISPATCH(halve_row)(row);
    };
}

RowWork widen_rows(const Widening& widening, const Guides& small, const PlaneU32& small_part,
                   const Guides& large, const PlaneU32& large_part) {
    for (std::size_t i = 0; i < widening.light.size(); ++i)
        EXPECTS(widening.light[i] == nullptr || widening.out[i]->width() == large.width());
    return [widening, &small, &small_part, &large, &large_part](int y) {
        WidenRow row{};
        row.large = rows_of(large, y);
        row.large_part = large_part.row(y);
        row.width = large.width();
        row.small_width = small.width();
        const int upper = (y + 1) / 2 - 1;  // -1 above the first
        const int lines[2] = {std::max(upper, 0), std::min(upper + 1, small.height() - 1)};
        const float off = static_cast<float>(2 * upper - y) + 0.5f;
        row.offset_y[0] = upper >= 0 ? off : off + 2.0f;
        row.offset_y[1] = upper + 1 < small.height() ? off + 2.0f : off;
        row.below = -0.5f * off;
        for (std::size_t j = 0; j < 2; ++j) {
            row.small[j] = rows_of(small, lines[j]);
            row.small_part[j] = small_part.row(lines[j]);
        }
        for (std::size_t i = 0; i < widening.light.size(); ++i) {
            if (widening.light[i] == nullptr) continue;
            point_to(row.light[row.lights][0], *widening.light[i], lines[0]);
            point_to(row.light[row.lights][1], *widening.light[i], lines[1]);
            row.asks_part[row.lights] = widening.asks_part[i];
            point_to(row.out[row.lights++], *widening.out[i], y);
        }
        HWY_DYNAMIC_DISPATCH(widen_row)(row);
    };
}

}  // namespace gh::filter
#endif
