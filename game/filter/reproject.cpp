#include "filter/reproject.h"

#include "filter/reproject_kernel.h"
#include "filter/rows.h"

#include <glm/geometric.hpp>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "filter/reproject.cpp"
#include <hwy/foreach_target.h>
// foreach_target must come before what is compiled once per target.
#include "filter/reproject_place-inl.h"
#include "filter/simd-inl.h"
#include "filter/taps-inl.h"
#include "filter/vector-inl.h"

HWY_BEFORE_NAMESPACE();
namespace gh::filter::HWY_NAMESPACE {

constexpr float kNearnessTolerance = 0.01f;       // off the plane, as a share of the nearness
constexpr float kNormalTolerance = 0.906307787f;  // cosine of 25 degrees
constexpr float kLeastWeight = 0.01f;             // of four taps together: less is mere chance
// The same two where nothing better is known: a thin thing's next pixel may face elsewhere and yet be lit alike.
constexpr float kLooseNearness = 0.05f;
constexpr float kLooseNormal = 0.5f;

// What is asked of each tap.
struct Wanted {
    Vector normal;
    Floats nearness, tolerance;
    Floats least_cosine;
    Ints part;
    Floats right, below;  // the surface's point seen from the first tap, in pixels
};

template <class Place>
static HWY_INLINE Lanes is_of_part(const ReprojectRow& row, const Place& place, std::ptrdiff_t step,
                                   const Wanted& wanted) {
    return hn::RebindMask(F(), hn::Eq(read_tap(row.then_part, place, step), wanted.part));
}

// `right`, `below`: of the place.
template <class Place>
static HWY_INLINE Lanes same_surface(const ReprojectRow& row, const Place& place, int right, int below,
                                     const Wanted& wanted) {
    const std::ptrdiff_t step = below * row.then_stride + right;
    const GuideRows& guides = row.then_guides;
    const Floats dx = hn::Sub(wanted.right, splat(static_cast<float>(right)));
    const Floats dy = hn::Sub(wanted.below, splat(static_cast<float>(below)));
    const Floats foretold = hn::Add(read_tap(guides.nearness, place, step),
                                    hn::Add(hn::Mul(read_tap(guides.slope_x, place, step), dx),
                                            hn::Mul(read_tap(guides.slope_y, place, step), dy)));
    const Floats cosine =
        dot(read_tap(guides.normal[0], place, step), read_tap(guides.normal[1], place, step),
            read_tap(guides.normal[2], place, step), wanted.normal.x, wanted.normal.y, wanted.normal.z);
    const Lanes same_plane = hn::Le(hn::Abs(hn::Sub(foretold, wanted.nearness)), wanted.tolerance);
    const Lanes same_part = is_of_part(row, place, step, wanted);
    return hn::And(same_part, hn::And(same_plane, hn::Ge(cosine, wanted.least_cosine)));
}

// For the row below, whose lower taps lie two rows on.
static HWY_INLINE void foresee_taps(const ReprojectRow& row, const TapPlace& place) {
    const GuideRows& guides = row.then_guides;
    for (const float* plane : {guides.nearness, guides.slope_x, guides.slope_y, guides.normal[0],
                               guides.normal[1], guides.normal[2]})
        foresee_tap(plane, place, 2 * row.then_stride);
    foresee_tap(row.then_part, place, 2 * row.then_stride);
}

// For `lost` pixels, whose four taps showed other things: the nearest of the nine pixels around that showed this one.
static void ask_around(const ReprojectRow& row, std::size_t x, const Then& then, const Wanted& wanted,
                       Lanes lost) {
    static constexpr int kAround[9][2] = {{0, 0}, {1, 0},  {0, 1},  {-1, 0}, {0, -1},
                                          {1, 1}, {-1, 1}, {1, -1}, {-1, -1}};
    const Floats zero = hn::Zero(F());
    const Floats half = splat(0.5f);
    const Floats column = zero_unless(lost, hn::Floor(hn::Add(then.x, half)));
    const Floats line = zero_unless(lost, hn::Floor(hn::Add(then.y, half)));
    const Ints middle =
        hn::Add(hn::Mul(hn::ConvertTo(I(), line), hn::Set(I(), static_cast<std::int32_t>(row.then_stride))),
                hn::ConvertTo(I(), column));
    const TapPlace place = place_of(middle, lost);  // the slack holds all that lie around it
    Wanted loose = wanted;
    loose.tolerance = hn::Mul(hn::Abs(wanted.nearness), splat(kLooseNearness));
    loose.least_cosine = splat(kLooseNormal);
    loose.right = hn::Sub(then.surface.x, column);
    loose.below = hn::Sub(then.surface.y, line);
    for (const auto& [dx, dy] : kAround) {
        const Floats u = hn::Add(column, splat(static_cast<float>(dx)));
        const Floats v = hn::Add(line, splat(static_cast<float>(dy)));
        const Lanes in =
            hn::And(hn::And(hn::Ge(u, zero), hn::Lt(u, splat(static_cast<float>(row.then_width)))),
                    hn::And(hn::Ge(v, zero), hn::Lt(v, splat(static_cast<float>(row.then_height)))));
        const std::ptrdiff_t step = dy * row.then_stride + dx;
        // Mostly none: then nothing else is read.
        const Lanes asks = hn::And(hn::And(lost, in), is_of_part(row, place, step, wanted));
        if (hn::AllFalse(F(), asks)) continue;
        const Lanes found = hn::And(asks, same_surface(row, place, dx, dy, loose));
        if (hn::AllFalse(F(), found)) continue;
        store(choose(found, splat(1.0f), load(row.weight[0] + x)), row.weight[0] + x);
        const auto chosen = hn::RebindMask(I(), found);
        const Ints at = hn::Add(middle, hn::Set(I(), static_cast<std::int32_t>(step)));
        hn::StoreU(hn::IfThenElse(chosen, at, hn::LoadU(I(), row.first + x)), I(), row.first + x);
        lost = hn::AndNot(found, lost);
        if (hn::AllFalse(F(), lost)) return;
    }
}

// Leaves only the weights of taps that showed the same surface; their sum.
template <class Place>
static HWY_INLINE Floats keep_surface(const ReprojectRow& row, const Place& place, const Wanted& wanted,
                                      Floats weight[4]) {
    const Floats zero = hn::Zero(F());
    Floats sum = zero;
    for (int tap = 0; tap < 4; ++tap) {
        // In a picture that stands still one tap in four is asked.
        if (hn::AllTrue(F(), hn::Eq(weight[tap], zero))) continue;
        weight[tap] = zero_unless(same_surface(row, place, tap % 2, tap / 2, wanted), weight[tap]);
        sum = hn::Add(sum, weight[tap]);
    }
    return sum;
}

static void weigh_taps(const ReprojectRow& row, std::size_t x, const Then& then) {
    const Floats one = splat(1.0f), zero = hn::Zero(F()), low = splat(-1.0f);
    const Floats left = hn::Floor(then.x), top = hn::Floor(then.y);
    const Floats last_column = splat(static_cast<float>(row.then_width - 1));
    const Floats last_line = splat(static_cast<float>(row.then_height - 1));
    // Written so that a NaN is a no.
    const Lanes in_picture = hn::And(hn::And(hn::Ge(left, low), hn::Le(left, last_column)),
                                     hn::And(hn::Ge(top, low), hn::Le(top, last_line)));
    const Lanes is_surface = hn::Gt(load(row.nearness + x), zero);
    const Lanes usable = hn::And(hn::And(in_picture, is_surface), hn::Gt(then.surface.nearness, zero));
    const Floats column = zero_unless(usable, left), line = zero_unless(usable, top);
    const Ints first =
        hn::Add(hn::Mul(hn::ConvertTo(I(), line), hn::Set(I(), static_cast<std::int32_t>(row.then_stride))),
                hn::ConvertTo(I(), column));
    if (hn::AllFalse(F(), usable)) {
        for (float* weight : row.weight) store(zero, weight + x);
        hn::StoreU(hn::Zero(I()), I(), row.first + x);
        return;
    }
    const TapPlace place = place_of(first, usable);
    foresee_taps(row, place);

    Wanted wanted;
    wanted.normal = load3_at(row.normal, static_cast<std::ptrdiff_t>(x));
    wanted.nearness = then.surface.nearness;
    wanted.tolerance = hn::Mul(hn::Abs(wanted.nearness), splat(kNearnessTolerance));
    wanted.least_cosine = splat(kNormalTolerance);
    wanted.part = hn::LoadU(I(), reinterpret_cast<const std::int32_t*>(row.part) + x);
    wanted.right = hn::Sub(then.surface.x, left);
    wanted.below = hn::Sub(then.surface.y, top);

    const Floats right = hn::Sub(then.x, left), below = hn::Sub(then.y, top);
    const Floats across[2] = {hn::Sub(one, right), right};
    const Floats down[2] = {hn::Sub(one, below), below};
    const Lanes column_in[2] = {hn::Ge(column, zero), hn::Lt(column, last_column)};
    const Lanes line_in[2] = {hn::Ge(line, zero), hn::Lt(line, last_line)};
    Floats weight[4];
    for (int tap = 0; tap < 4; ++tap) {
        const Lanes in = hn::And(usable, hn::And(column_in[tap % 2], line_in[tap / 2]));
        weight[tap] = zero_unless(in, hn::Mul(across[tap % 2], down[tap / 2]));
    }
    const Floats sum = place.runs == 1 ? keep_surface(row, RunPlace{place.start[0]}, wanted, weight)
                                       : keep_surface(row, place, wanted, weight);
    const Floats share = zero_unless(hn::Ge(sum, splat(kLeastWeight)), hn::Div(one, sum));
    for (int tap = 0; tap < 4; ++tap) store_far(hn::Mul(weight[tap], share), row.weight[tap] + x);
    hn::StoreU(first, I(), row.first + x);
    const Lanes lost = hn::And(usable, hn::Lt(sum, splat(kLeastWeight)));
    if (!hn::AllFalse(F(), lost)) ask_around(row, x, then, wanted, lost);
}

static void reproject_row(const ReprojectRow& row) {
    for (std::size_t x = 0; x < static_cast<std::size_t>(row.width); x += lane_count()) {
        const Then then = find_place(row, x);
        weigh_taps(row, x, then);
        if (row.motion[0] != nullptr) leave_movement(row, x, then);
    }
}

}  // namespace gh::filter::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gh::filter {

HWY_EXPORT(reproject_row);

namespace {

void copy(const glm::vec3& from, float to[3]) {
    for (std::size_t i = 0; i < 3; ++i) to[i] = from[i];
}

}  // namespace

Projector projector_of(const Pinhole& lens) {
    const float volume = glm::dot(lens.right, glm::cross(lens.down, lens.corner));
    EXPECTS(volume != 0.0f);
    Projector out;
    copy(lens.eye, out.eye);
    copy(glm::cross(lens.down, lens.corner) / volume, out.across);
    copy(glm::cross(lens.corner, lens.right) / volume, out.down);
    copy(glm::cross(lens.right, lens.down) / volume, out.ahead);
    return out;
}

void Taps::fit(int width, int height) {
    fit_together(width, height, first, weight[0], weight[1], weight[2], weight[3]);
}

ReprojectRow reproject_row_of(const GBuffer& now, const Pinhole& then, glm::ivec2 size_then) {
    ReprojectRow row{};
    row.now = projector_of(now.lens);
    row.then = projector_of(then);
    row.width = now.width();
    row.then_width = size_then.x;
    row.then_height = size_then.y;
    row.scale_x = static_cast<float>(size_then.x) / static_cast<float>(now.width());
    row.scale_y = static_cast<float>(size_then.y) / static_cast<float>(now.height());
    return row;
}

void point_to_surfaces(const GBuffer& now, int y, ReprojectRow& row) {
    point_to(row.position, now.position, y);
    point_to(row.previous, now.previous.empty() ? now.position : now.previous, y);
    row.part = now.part.row(y);
    row.y = static_cast<float>(y) + 0.5f;
}

void reproject(const GBuffer& now, const Guides& guides, const SeenSurfaces& seen, Motion motion,
               const Jobs& jobs, Taps& taps) {
    run_rows(now.height(), jobs, reproject_rows(now, guides, seen, motion, taps));
}

RowWork reproject_rows(const GBuffer& now, const Guides& guides, const SeenSurfaces& seen, Motion motion,
                       Taps& taps, Movement* movement) {
    const int width = now.width(), height = now.height();
    EXPECTS(guides.width() == width && guides.height() == height);
    EXPECTS(movement == nullptr || motion == Motion::OfSurface);
    if (seen.part.empty()) {
        taps.first.resize(width, height);
        for (Plane& weight : taps.weight) weight.resize(width, height);
        return {};
    }
    taps.fit(width, height);
    if (movement != nullptr) movement->fit(width, height);
    ReprojectRow shared = reproject_row_of(now, seen.lens, {seen.part.width(), seen.part.height()});
    shared.then_guides = rows_of(seen.guides, 0);
    shared.then_part = seen.part.row(0);
    shared.then_stride = seen.part.stride();
    const bool follows_reflection = motion == Motion::OfReflection && !now.reflected.empty();
    return [shared, follows_reflection, movement, &now, &guides, &taps](int y) {
        ReprojectRow row = shared;
        point_to_surfaces(now, y, row);
        point_to(row.normal, now.normal, y);
        row.nearness = guides.nearness.row(y);
        row.roughness = now.roughness.empty() ? nullptr : now.roughness.row(y);
        row.reflected = follows_reflection ? now.reflected.row(y) : nullptr;
        row.first = taps.first.row(y);
        for (std::size_t tap = 0; tap < 4; ++tap) row.weight[tap] = taps.weight[tap].row(y);
        if (movement != nullptr) point_to_movement(now, y, *movement, row);
        HWY_DYNAMIC_DISPATCH(reproject_row)(row);
    };
}

}  // namespace gh::filter
#endif
