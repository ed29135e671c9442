// filter/reproject_place-inl.h - where a vector of pixels was in the last picture. Compiled once per instruction set; see
// simd-inl.h.
#if defined(GH_FILTER_REPROJECT_PLACE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GH_FILTER_REPROJECT_PLACE_INL_H_
#undef GH_FILTER_REPROJECT_PLACE_INL_H_
#else
#define GH_FILTER_REPROJECT_PLACE_INL_H_
#endif

#include "filter/reproject_kernel.h"
#include "filter/simd-inl.h"
#include "filter/vector-inl.h"

HWY_BEFORE_NAMESPACE();
namespace gh::filter::HWY_NAMESPACE {

// Of a pixel. Rounding noise about a whole pixel would else blur a little and tear neighbours apart.
constexpr float kPlaceSteps = 256.0f;

static HWY_INLINE Vector minus(const Vector& p, const float* q) {
    return minus(p, splat3(q));
}

static HWY_INLINE Floats along(const float* axis, const Vector& d) {
    return dot(splat(axis[0]), splat(axis[1]), splat(axis[2]), d.x, d.y, d.z);
}

struct PicturePoint {
    Floats x, y;
    Floats nearness;
};

static HWY_INLINE PicturePoint project_way(const Projector& eye, const Vector& d) {
    const Floats nearness = hn::Div(splat(1.0f), along(eye.ahead, d));
    return {hn::Mul(along(eye.across, d), nearness), hn::Mul(along(eye.down, d), nearness), nearness};
}

static HWY_INLINE PicturePoint project(const Projector& eye, const Vector& p) {
    return project_way(eye, minus(p, eye.eye));
}

// How far behind the surface what it reflects seems to be: the whole way for a mirror, none for a rough surface.
static HWY_INLINE Vector behind(const ReprojectRow& row, std::size_t x, const Vector& p) {
    const Vector d = minus(p, row.now.eye);
    const Floats length = hn::Sqrt(dot(d.x, d.y, d.z, d.x, d.y, d.z));
    const Floats rough = row.roughness != nullptr ? load(row.roughness + x) : splat(1.0f);
    const Floats alpha = hn::Mul(rough, rough);
    const Floats smooth = positive(hn::Sub(splat(1.0f), alpha));
    const Floats follows = hn::Mul(smooth, hn::Add(hn::Sqrt(smooth), alpha));
    const Floats share = hn::Div(hn::Mul(positive(load(row.reflected + x)), follows), length);
    return {hn::Mul(d.x, share), hn::Mul(d.y, share), hn::Mul(d.z, share)};
}

// Where a pixel's light was in the last picture, in numbers of pixels from the centre of pixel (0, 0), jitter left out;
// and where the very point of the surface was, with how near.
struct Then {
    Floats x, y;
    PicturePoint surface;
};

static HWY_INLINE Floats to_steps(Floats place) {
    const Floats steps = hn::Floor(hn::Add(hn::Mul(place, splat(kPlaceSteps)), splat(0.5f)));
    return hn::Mul(steps, splat(1.0f / kPlaceSteps));
}

static HWY_INLINE Then then_of(const ReprojectRow& row, std::size_t x, const PicturePoint& now,
                               const PicturePoint& then, const PicturePoint& surface) {
    const Floats centre =
        hn::Add(hn::ConvertTo(F(), pixel_numbers(static_cast<std::ptrdiff_t>(x))), splat(0.5f));
    const Floats scale_x = splat(row.scale_x), scale_y = splat(row.scale_y), half = splat(0.5f);
    const Floats moved_x = hn::Sub(then.x, hn::Mul(now.x, scale_x));
    const Floats moved_y = hn::Sub(then.y, hn::Mul(now.y, scale_y));
    return {to_steps(hn::Add(moved_x, hn::Sub(hn::Mul(centre, scale_x), half))),
            to_steps(hn::Add(moved_y, hn::Sub(hn::Mul(splat(row.y), scale_y), half))),
            {hn::Sub(surface.x, half), hn::Sub(surface.y, half), surface.nearness}};
}

static HWY_INLINE Then find_place(const ReprojectRow& row, std::size_t x) {
    Vector here = load3_at(row.position, static_cast<std::ptrdiff_t>(x)),
           before = load3_far(row.previous, static_cast<std::ptrdiff_t>(x));
    const PicturePoint surface = project(row.then, before);
    if (row.reflected == nullptr) return then_of(row, x, project(row.now, here), surface, surface);
    const Vector image = behind(row, x, here);
    here = plus(here, image);
    return then_of(row, x, project(row.now, here), project(row.then, plus(before, image)), surface);
}

// The sky is as far away as anything: only its direction counts.
static HWY_INLINE Then find_sky(const ReprojectRow& row, std::size_t x) {
    const Floats centre =
        hn::Add(hn::ConvertTo(F(), pixel_numbers(static_cast<std::ptrdiff_t>(x))), splat(0.5f));
    const Vector way = plus(splat3(row.corner), scaled(splat3(row.right), centre));
    const PicturePoint then = project_way(row.then, way);
    return then_of(row, x, project_way(row.now, way), then, then);
}

// For those who asked: how far it is to `place`, and whether a surface came from elsewhere by itself.
static HWY_INLINE void leave_movement(const ReprojectRow& row, std::size_t x, Then place) {
    const auto i = static_cast<std::ptrdiff_t>(x);
    const Ints part = hn::LoadU(I(), reinterpret_cast<const std::int32_t*>(row.part) + x);
    const Lanes is_sky =
        hn::RebindMask(F(), hn::Eq(part, hn::Set(I(), static_cast<std::int32_t>(kNoSurface))));
    if (!hn::AllFalse(F(), is_sky)) {
        const Then sky = find_sky(row, x);
        place.x = choose(is_sky, sky.x, place.x);
        place.y = choose(is_sky, sky.y, place.y);
        place.surface.nearness = choose(is_sky, sky.surface.nearness, place.surface.nearness);
    }
    const Floats by_x = hn::Sub(place.x, hn::ConvertTo(F(), pixel_numbers(i)));
    const Floats by_y = hn::Sub(place.y, splat(row.y - 0.5f)), far = splat(-Movement::kUnseen);
    const Lanes is_seen = hn::And(hn::Gt(place.surface.nearness, hn::Zero(F())),
                                  hn::And(hn::Lt(hn::Abs(by_x), far), hn::Lt(hn::Abs(by_y), far)));
    store(choose(is_seen, by_x, splat(Movement::kUnseen)), row.motion[0] + x);
    store(choose(is_seen, by_y, splat(Movement::kUnseen)), row.motion[1] + x);

    store(hn::Zero(F()), row.moves + x);
    if (row.position[0] == row.previous[0]) return;
    const Vector here = load3_at(row.position, i), before = load3_at(row.previous, i);
    const Lanes stays = stays_put(here, before, splat3(row.now.eye));
    const Lanes still = hn::Or(hn::Or(stays, is_sky), hn::Not(inside(pixel_numbers(i), row.width)));
    if (hn::AllTrue(F(), still)) return;
    store(choose(still, hn::Zero(F()), splat(1.0f)), row.moves + x);
    const int block = static_cast<int>(x) / RowSpan::kBlock * RowSpan::kBlock;
    if (row.itself->begin == row.itself->end) row.itself->begin = block;
    row.itself->end = block + RowSpan::kBlock;
}

}  // namespace gh::filter::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // GH_FILTER_REPROJECT_PLACE_INL_H_
