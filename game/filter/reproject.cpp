#include "filter/reproject.h"

#include "filter/reproject_kernel.h"
#include "filter/rows.h"

#include <glm/geometric.hpp>

#include <bit>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "filter/reproject.cpp"
#include <hwy/foreach_target.h>
// foreach_target must come before what is compiled once per target.
#include "filter/simd-inl.h"

HWY_BEFORE_NAMESPACE();
namespace gh::filter::HWY_NAMESPACE {

constexpr std::size_t kChunk = 64;                 // pixels done at a time
constexpr float kPlaneTolerance = 0.01f;           // distance from the plane, as a share of the distance to the eye
constexpr float kNormalTolerance = 0.906307787f;   // cosine of 25 degrees
constexpr float kNowhere = 2.0f;
constexpr float kLeastWeight = 0.01f;              // of four taps together: less is mere chance

// Rows are done to the end of their last vector, however wide the picture.
static HWY_INLINE std::size_t chunk_end(int width, std::size_t begin) {
    const std::size_t padded = (static_cast<std::size_t>(width) + 15) / 16 * 16;
    return padded - begin < kChunk ? padded - begin : kChunk;
}

struct Vector {
    Floats x, y, z;
};

static HWY_INLINE Vector load3(const float* const from[3], std::size_t x) {
    return {load(from[0] + x), load(from[1] + x), load(from[2] + x)};
}

static HWY_INLINE Vector minus(const Vector& p, const float* q) {
    return {hn::Sub(p.x, splat(q[0])), hn::Sub(p.y, splat(q[1])), hn::Sub(p.z, splat(q[2]))};
}

static HWY_INLINE Floats along(const float* axis, const Vector& d) {
    return dot(splat(axis[0]), splat(axis[1]), splat(axis[2]), d.x, d.y, d.z);
}

// Picture points; returns which of them lie before the eye.
static HWY_INLINE Lanes project(const Projector& eye, const Vector& p, Floats& x, Floats& y) {
    const Vector d = minus(p, eye.eye);
    const Floats depth = along(eye.ahead, d);
    x = hn::Div(along(eye.across, d), depth);
    y = hn::Div(along(eye.down, d), depth);
    return hn::Gt(depth, hn::Zero(F()));
}

// How far behind the surface what it reflects seems to be: the whole way for a mirror, none for a rough surface.
static HWY_INLINE Vector behind(const ReprojectRow& row, std::size_t x, const Vector& p) {
    const Vector d = minus(p, row.now.eye);
    const Floats length = hn::Sqrt(dot(d.x, d.y, d.z, d.x, d.y, d.z));
    const Floats rough = row.roughness != nullptr ? load(row.roughness + x) : splat(1.0f);
    const Floats smooth = positive(hn::Sub(splat(1.0f), hn::Mul(rough, rough)));
    const Floats follows = hn::Mul(smooth, hn::Add(hn::Sqrt(smooth), hn::Mul(rough, rough)));
    const Floats share = hn::Div(hn::Mul(positive(load(row.reflected + x)), follows), length);
    return {hn::Mul(d.x, share), hn::Mul(d.y, share), hn::Mul(d.z, share)};
}

static HWY_INLINE Vector plus(const Vector& a, const Vector& b) {
    return {hn::Add(a.x, b.x), hn::Add(a.y, b.y), hn::Add(a.z, b.z)};
}

struct Chunk {
    HWY_ALIGN std::int32_t first[kChunk];
    HWY_ALIGN float column[kChunk];                // of the first tap; -1 ... width - 1
    HWY_ALIGN float across[kChunk], down[kChunk];  // where between the taps, [0, 1); kNowhere: outside the picture
    HWY_ALIGN float place[4][4 * kChunk];
    HWY_ALIGN float facing[4][4 * kChunk];
};

// Where each pixel's point was in the last picture. Points outside of it stay without taps.
static void find_places(const ReprojectRow& row, std::size_t begin, std::size_t count, Chunk& chunk) {
    for (std::size_t i = 0; i < count; i += lane_count()) {
        const std::size_t x = begin + i;
        Vector here = load3(row.position, x), before = load3(row.previous, x);
        if (row.reflected != nullptr) {
            const Vector image = behind(row, x, here);
            here = plus(here, image);
            before = plus(before, image);
        }
        Floats now_x, now_y, then_x, then_y;
        const Lanes seen = hn::And(project(row.now, here, now_x, now_y), project(row.then, before, then_x, then_y));

        const Floats centre = hn::Add(hn::ConvertTo(F(), pixel_numbers(static_cast<std::ptrdiff_t>(x))), splat(0.5f));
        const Floats at_x = hn::Sub(hn::Add(hn::Sub(then_x, hn::Mul(now_x, splat(row.scale_x))),
                                            hn::Mul(centre, splat(row.scale_x))),
                                    splat(0.5f));
        const Floats at_y = hn::Add(hn::Sub(then_y, hn::Mul(now_y, splat(row.scale_y))),
                                    splat(row.y * row.scale_y - 0.5f));
        const Floats left = hn::Floor(at_x), top = hn::Floor(at_y);
        const Floats low = splat(-1.0f);
        const Lanes in_picture =
            hn::And(hn::And(seen, hn::And(hn::Ge(left, low), hn::Lt(left, splat(static_cast<float>(row.then_width))))),
                    hn::And(hn::Ge(top, low), hn::Lt(top, splat(static_cast<float>(row.then_height)))));

        const Floats column = zero_unless(in_picture, left);
        const Ints line = hn::ConvertTo(I(), zero_unless(in_picture, top));
        const Ints first = hn::Add(hn::Mul(line, hn::Set(I(), row.then_stride)), hn::ConvertTo(I(), column));
        hn::StoreU(first, I(), chunk.first + i);
        store(column, chunk.column + i);
        store(choose(in_picture, hn::Sub(at_x, left), splat(kNowhere)), chunk.across + i);
        store(choose(in_picture, hn::Sub(at_y, top), splat(kNowhere)), chunk.down + i);
    }
}

static void copy_taps(const ReprojectRow& row, std::size_t count, Chunk& chunk) {
    const hn::CappedTag<float, 4> four;
    const std::ptrdiff_t step[4] = {0, 1, row.then_stride, row.then_stride + 1};
    for (std::size_t i = 0; i < count; ++i) {
        for (std::size_t tap = 0; tap < 4; ++tap) {
            const std::ptrdiff_t at = 4 * (chunk.first[i] + step[tap]);
            hn::Store(hn::Load(four, row.then_place + at), four, chunk.place[tap] + 4 * i);
            hn::Store(hn::Load(four, row.then_facing + at), four, chunk.facing[tap] + 4 * i);
        }
    }
}

// The surface a pixel shows now, as it was.
struct Wanted {
    Vector before;  // position
    Vector normal;
    Floats tolerance;  // metres off the plane
    Ints part;
};

static HWY_INLINE Lanes same_surface(const Chunk& chunk, std::size_t tap, std::size_t i, const Wanted& wanted) {
    Floats px, py, pz, part, nx, ny, nz, rough;
    hn::LoadInterleaved4(F(), chunk.place[tap] + 4 * i, px, py, pz, part);
    hn::LoadInterleaved4(F(), chunk.facing[tap] + 4 * i, nx, ny, nz, rough);
    const Floats off = dot(nx, ny, nz, hn::Sub(wanted.before.x, px), hn::Sub(wanted.before.y, py),
                           hn::Sub(wanted.before.z, pz));
    const Floats cosine = dot(nx, ny, nz, wanted.normal.x, wanted.normal.y, wanted.normal.z);
    const Lanes same_part = hn::RebindMask(F(), hn::Eq(hn::BitCast(I(), part), wanted.part));
    return hn::And(same_part, hn::And(hn::Le(hn::Abs(off), wanted.tolerance), hn::Ge(cosine, splat(kNormalTolerance))));
}

static HWY_INLINE Wanted wanted_surface(const ReprojectRow& row, std::size_t x) {
    Wanted wanted;
    wanted.before = load3(row.previous, x);
    wanted.normal = load3(row.normal, x);
    const Vector d = minus(wanted.before, row.then.eye);
    wanted.tolerance = hn::Mul(splat(kPlaneTolerance), hn::Sqrt(dot(d.x, d.y, d.z, d.x, d.y, d.z)));
    wanted.part = hn::LoadU(I(), reinterpret_cast<const std::int32_t*>(row.part) + x);
    return wanted;
}

static void weigh_taps(const ReprojectRow& row, std::size_t begin, std::size_t count, const Chunk& chunk) {
    const Floats one = splat(1.0f), zero = hn::Zero(F());
    const Floats last_column = splat(static_cast<float>(row.then_width - 1));
    for (std::size_t i = 0; i < count; i += lane_count()) {
        const std::size_t x = begin + i;
        const Wanted wanted = wanted_surface(row, x);
        const Floats right = load(chunk.across + i), below = load(chunk.down + i), column = load(chunk.column + i);
        const Ints sky = hn::Set(I(), static_cast<std::int32_t>(kNoSurface));
        const Lanes usable = hn::And(hn::RebindMask(F(), hn::Ne(wanted.part, sky)), hn::Lt(right, one));
        // Above and below the picture lies slack without surfaces; left and right of it, the neighbouring rows.
        const Lanes left_in = hn::And(usable, hn::Ge(column, zero));
        const Lanes right_in = hn::And(usable, hn::Lt(column, last_column));
        const Floats left = hn::Sub(one, right), above = hn::Sub(one, below);
        Floats weight[4] = {hn::Mul(left, above), hn::Mul(right, above), hn::Mul(left, below), hn::Mul(right, below)};
        Floats sum = zero;
        for (std::size_t tap = 0; tap < 4; ++tap) {
            const Lanes in = tap % 2 == 0 ? left_in : right_in;
            weight[tap] = zero_unless(hn::And(in, same_surface(chunk, tap, i, wanted)), weight[tap]);
            sum = hn::Add(sum, weight[tap]);
        }
        const Floats share = zero_unless(hn::Ge(sum, splat(kLeastWeight)), hn::Div(one, sum));
        for (std::size_t tap = 0; tap < 4; ++tap) store(hn::Mul(weight[tap], share), row.weight[tap] + x);
        hn::StoreU(hn::LoadU(I(), chunk.first + i), I(), row.first + x);
    }
}

static void reproject_row(const ReprojectRow& row) {
    Chunk chunk;
    for (std::size_t x = 0; x < static_cast<std::size_t>(row.width); x += kChunk) {
        const std::size_t count = chunk_end(row.width, x);
        find_places(row, x, count, chunk);
        copy_taps(row, count, chunk);
        weigh_taps(row, x, count, chunk);
    }
}

static void remember_row(const RememberRow& row) {
    const auto width = static_cast<std::size_t>(row.width);
    for (std::size_t x = 0; x < width; x += lane_count()) {
        const Floats part = load(reinterpret_cast<const float*>(row.part) + x);
        const Floats rough = row.roughness != nullptr ? load(row.roughness + x) : splat(1.0f);
        hn::StoreInterleaved4(load(row.position[0] + x), load(row.position[1] + x), load(row.position[2] + x), part,
                              F(), row.place + 4 * x);
        hn::StoreInterleaved4(load(row.normal[0] + x), load(row.normal[1] + x), load(row.normal[2] + x), rough, F(),
                              row.facing + 4 * x);
    }
}

}  // namespace gh::filter::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gh::filter {

HWY_EXPORT(reproject_row);
HWY_EXPORT(remember_row);

namespace {

void set(float to[3], const glm::vec3& from) {
    for (std::size_t i = 0; i < 3; ++i) to[i] = from[i];
}

}  // namespace

Projector projector_of(const Pinhole& lens) {
    const float volume = glm::dot(lens.right, glm::cross(lens.down, lens.corner));
    EXPECTS(volume != 0.0f);
    Projector out;
    set(out.eye, lens.eye);
    set(out.across, glm::cross(lens.down, lens.corner) / volume);
    set(out.down, glm::cross(lens.corner, lens.right) / volume);
    set(out.ahead, glm::cross(lens.right, lens.down) / volume);
    return out;
}

void Texels::resize(int width, int height) {
    EXPECTS(width >= 0 && height >= 0);
    if (width == width_ && height == height_ && !texels_.empty()) return;
    width_ = width;
    height_ = height;
    stride_ = (width + 15) / 16 * 16;
    // All bits set: a part that is no surface, and no number.
    const float none = std::bit_cast<float>(kNoSurface);
    texels_.assign(static_cast<std::size_t>(stride_) * static_cast<std::size_t>(height + 2) + 2 * kSlack,
                   Texel{{none, none, none, none}});
}

void Taps::fit(int width, int height) {
    first.fit(width, height);
    for (Plane& plane : weight) plane.fit(width, height);
}

void remember(const GBuffer& surfaces, const Jobs& jobs, SeenSurfaces& seen) {
    const int width = surfaces.width(), height = surfaces.height();
    seen.lens = surfaces.lens;
    seen.place.resize(width, height);
    seen.facing.resize(width, height);
    run_rows(height, jobs, [&](int y) {
        RememberRow row{};
        point_to(row.position, surfaces.position, y);
        point_to(row.normal, surfaces.normal, y);
        row.roughness = surfaces.roughness.empty() ? nullptr : surfaces.roughness.row(y);
        row.part = surfaces.part.row(y);
        row.width = width;
        row.place = seen.place.row(y)->value;
        row.facing = seen.facing.row(y)->value;
        HWY_DYNAMIC_DISPATCH(remember_row)(row);
    });
}

void reproject(const GBuffer& now, const SeenSurfaces& seen, Motion motion, const Jobs& jobs, Taps& taps) {
    const int width = now.width(), height = now.height();
    taps.fit(width, height);
    if (seen.place.width() == 0 || seen.place.height() == 0) {
        for (Plane& weight : taps.weight) weight.resize(width, height);
        taps.first.resize(width, height);
        return;
    }
    ReprojectRow shared{};
    shared.now = projector_of(now.lens);
    shared.then = projector_of(seen.lens);
    shared.width = width;
    shared.then_place = seen.place.row(0)->value;
    shared.then_facing = seen.facing.row(0)->value;
    shared.then_width = seen.place.width();
    shared.then_height = seen.place.height();
    shared.then_stride = seen.place.stride();
    shared.scale_x = static_cast<float>(shared.then_width) / static_cast<float>(width);
    shared.scale_y = static_cast<float>(shared.then_height) / static_cast<float>(height);
    const bool follows_reflection = motion == Motion::OfReflection && !now.reflected.empty();
    run_rows(height, jobs, [&](int y) {
        ReprojectRow row = shared;
        point_to(row.position, now.position, y);
        point_to(row.previous, now.previous.empty() ? now.position : now.previous, y);
        point_to(row.normal, now.normal, y);
        row.roughness = now.roughness.empty() ? nullptr : now.roughness.row(y);
        row.reflected = follows_reflection ? now.reflected.row(y) : nullptr;
        row.part = now.part.row(y);
        row.y = static_cast<float>(y) + 0.5f;
        row.first = taps.first.row(y);
        for (std::size_t tap = 0; tap < 4; ++tap) row.weight[tap] = taps.weight[tap].row(y);
        HWY_DYNAMIC_DISPATCH(reproject_row)(row);
    });
}

}  // namespace gh::filter
#endif
