#include "filter/picture_mean.h"

#include "filter/bordered.h"
#include "filter/picture_mean_kernel.h"
#include "filter/rows.h"
#include "filter/temporal_picture_kernel.h"

#include <algorithm>
#include <utility>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "filter/picture_mean.cpp"
#include <hwy/foreach_target.h>
// foreach_target must come before what is compiled once per target.
#include "filter/simd-inl.h"
#include "filter/vector-inl.h"

HWY_BEFORE_NAMESPACE();
namespace gh::filter::HWY_NAMESPACE {

constexpr float kUnseen = -1e6f;  // pixels: outside any picture
// Of a pixel. Rounding noise about a whole pixel would else blur a little.
constexpr float kSteps = 256.0f;

struct OnPicture {
    Floats x, y, depth;
};

static HWY_INLINE OnPicture shown_at(const Projector& eye, const Vector& offset) {
    const Floats depth = dot(splat3(eye.ahead), offset);
    return {hn::Div(dot(splat3(eye.across), offset), depth), hn::Div(dot(splat3(eye.down), offset), depth),
            depth};
}

static HWY_INLINE Floats in_steps(Floats place) {
    const Floats steps = hn::Floor(hn::Add(hn::Mul(place, splat(kSteps)), splat(0.5f)));
    return hn::Mul(steps, splat(1.0f / kSteps));
}

static void find_places(const PlaceRow& row) {
    const Floats half = splat(0.5f), far = splat(-kUnseen);
    for (std::size_t x = 0; x < static_cast<std::size_t>(row.width); x += lane_count()) {
        const auto i = static_cast<std::ptrdiff_t>(x);
        const Floats number = hn::ConvertTo(F(), pixel_numbers(i)), centre = hn::Add(number, half);
        const Ints part = hn::LoadU(I(), reinterpret_cast<const std::int32_t*>(row.part) + x);
        const Lanes is_sky = hn::RebindMask(F(), hn::Eq(part, hn::Set(I(), -1)));
        const Vector way = plus(splat3(row.corner), scaled(splat3(row.right), centre));
        const Vector here = choose(is_sky, way, minus(load3_at(row.position, i), splat3(row.now.eye)));
        const Vector was = choose(is_sky, way, minus(load3_at(row.previous, i), splat3(row.then.eye)));
        const OnPicture now = shown_at(row.now, here), then = shown_at(row.then, was);
        // Measured from the point itself, wherever in its pixel it lies.
        const Floats moved_x = hn::Sub(then.x, hn::Mul(now.x, splat(row.scale_x)));
        const Floats moved_y = hn::Sub(then.y, hn::Mul(now.y, splat(row.scale_y)));
        const Floats by_x =
            hn::Sub(in_steps(hn::Add(moved_x, hn::Sub(hn::Mul(centre, splat(row.scale_x)), half))), number);
        const Floats by_y =
            hn::Sub(in_steps(hn::Add(moved_y, splat(row.y * row.scale_y - 0.5f))), splat(row.y - 0.5f));
        const Lanes is_seen = hn::And(hn::Gt(then.depth, hn::Zero(F())),
                                      hn::And(hn::Lt(hn::Abs(by_x), far), hn::Lt(hn::Abs(by_y), far)));
        store(choose(is_seen, by_x, splat(kUnseen)), row.motion[0] + x);
        store(choose(is_seen, by_y, splat(kUnseen)), row.motion[1] + x);
    }
}

}  // namespace gh::filter::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gh::filter {

HWY_EXPORT(find_places);

namespace {

// That are added up where nothing moves, and where each frame moves them.
constexpr float kStillPictures = 10.0f, kMovingPictures = 4.0f;

}  // namespace

void PictureMean::place_row(const GBuffer& surfaces, const Plane3& picture, int y) {
    const int width = picture.width();
    const Plane* const from[3] = {&picture.x, &picture.y, &picture.z};
    float* to[3];
    point_to_bordered(to, now_, y);
    for (std::size_t c = 0; c < 3; ++c) std::copy_n(from[c]->row(y), width, to[c]);
    repeat_sides(now_, width, y);
    if (!has_past_) return;
    PlaceRow row{};
    row.now = projector_of(surfaces.lens);
    row.then = projector_of(before_);
    row.y = static_cast<float>(y) + 0.5f;
    const glm::vec3 corner = surfaces.lens.corner + surfaces.lens.down * row.y;
    for (glm::length_t c = 0; c < 3; ++c) {
        row.corner[c] = corner[c];
        row.right[c] = surfaces.lens.right[c];
    }
    point_to(row.position, surfaces.position, y);
    point_to(row.previous, surfaces.previous.empty() ? surfaces.position : surfaces.previous, y);
    row.part = surfaces.part.row(y);
    row.width = width;
    row.scale_x = static_cast<float>(size_then_.x) / static_cast<float>(size_.x);
    row.scale_y = static_cast<float>(size_then_.y) / static_cast<float>(size_.y);
    row.motion[0] = motion_x_.row(y);
    row.motion[1] = motion_y_.row(y);
    HWY_DYNAMIC_DISPATCH(find_places)(row);
}

void PictureMean::smooth_row(int y, const Plane& change, Plane3& out) {
    SmoothRow row{};
    row.y = y;
    row.width = size_.x;
    row.motion[0] = motion_x_.row(y);
    row.motion[1] = motion_y_.row(y);
    point_to_bordered(row.lighted, std::as_const(now_), y);
    row.above = y > 0 ? -now_.x.stride() : 0;
    row.below = y + 1 < size_.y ? now_.x.stride() : 0;
    row.has_past = has_past_;
    row.change = change.empty() ? nullptr : change.row(y);
    row.still = kStillPictures;
    row.moving = kMovingPictures;
    if (has_past_) {
        row.then_width = size_then_.x;
        row.then_height = size_then_.y;
        point_to_bordered(row.then, std::as_const(mean_), 0);
        row.then_stride = mean_.x.stride();
    }
    point_to_bordered(row.next, next_, y);
    point_to(row.out_planes, out, y);
    smooth_picture(row);
    repeat_sides(next_, size_.x, y);
}

void PictureMean::add_rows(const GBuffer& surfaces, const Plane3& picture, const Plane& change,
                           RowPasses& passes, Plane3& out) {
    EXPECTS(&picture != &out);
    size_ = {surfaces.width(), surfaces.height()};
    out.fit(size_.x, size_.y);
    motion_x_.fit(size_.x, size_.y);
    motion_y_.fit(size_.x, size_.y);
    fit_bordered(now_, size_);
    fit_bordered(next_, size_);
    passes.add([this, &surfaces, &picture](int y) { place_row(surfaces, picture, y); });
    passes.begin(1);
    passes.add([this, &change, &out](int y) { smooth_row(y, change, out); });
}

void PictureMean::finish(const GBuffer& surfaces) {
    if (size_.x == 0 || size_.y == 0) return;
    repeat_rows(next_, size_.y);
    std::swap(mean_, next_);
    before_ = surfaces.lens;
    size_then_ = size_;
    has_past_ = true;
}

}  // namespace gh::filter
#endif
