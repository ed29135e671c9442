#include "filter/guides.h"

#include "filter/guides_kernel.h"
#include "filter/rows.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "filter/guides.cpp"
#include <hwy/foreach_target.h>
// foreach_target must come before what is compiled once per target.
#include "filter/simd-inl.h"

HWY_BEFORE_NAMESPACE();
namespace gh::filter::HWY_NAMESPACE {

static HWY_INLINE Floats along(const float* axis, Floats x, Floats y, Floats z) {
    return dot(splat(axis[0]), splat(axis[1]), splat(axis[2]), x, y, z);
}

static void guides_row(const GuidesRow& row) {
    const Floats one = splat(1.0f);
    for (std::size_t x = 0; x < static_cast<std::size_t>(row.width); x += lane_count()) {
        const Floats dx = hn::Sub(load_far(row.position[0] + x), splat(row.eye[0]));
        const Floats dy = hn::Sub(load_far(row.position[1] + x), splat(row.eye[1]));
        const Floats dz = hn::Sub(load_far(row.position[2] + x), splat(row.eye[2]));
        const Floats nx = load_far(row.geometric[0] + x), ny = load_far(row.geometric[1] + x),
                     nz = load_far(row.geometric[2] + x);

        const Floats direct = hn::Div(one, along(row.ahead, dx, dy, dz));
        const Floats scale = hn::Div(one, dot(nx, ny, nz, dx, dy, dz));
        const Floats slope_x = hn::Mul(along(row.right, nx, ny, nz), scale);
        const Floats slope_y = hn::Mul(along(row.down, nx, ny, nz), scale);
        const Floats column =
            hn::Add(hn::ConvertTo(F(), pixel_numbers(static_cast<std::ptrdiff_t>(x))), splat(0.5f));
        const Floats by_plane =
            hn::Add(hn::Add(hn::Mul(along(row.corner, nx, ny, nz), scale), hn::Mul(column, slope_x)),
                    hn::Mul(splat(row.y), slope_y));
        // The point lies within its pixel, so a plane that says much else is seen edge on: it foretells nothing.
        const Floats doubt = hn::Mul(splat(0.5f), direct);
        const Lanes sound = hn::And(hn::Lt(hn::Abs(hn::Sub(by_plane, direct)), doubt),
                                    hn::And(is_finite(slope_x), is_finite(slope_y)));

        const auto sky = hn::Set(I(), static_cast<std::int32_t>(kNoSurface));
        const Ints part = hn::LoadU(I(), reinterpret_cast<const std::int32_t*>(row.part) + x);
        const Floats sx = load_far(row.smooth[0] + x), sy = load_far(row.smooth[1] + x),
                     sz = load_far(row.smooth[2] + x);
        const Floats length = dot(sx, sy, sz, sx, sy, sz);
        // Written so that a NaN anywhere is a no: behind this door nobody looks again.
        const Lanes usable = hn::And(hn::And(hn::Gt(direct, hn::Zero(F())), is_finite(direct)),
                                     hn::And(hn::Gt(length, splat(0.5f)), hn::Lt(length, splat(2.0f))));
        const Lanes surface = hn::And(usable, hn::RebindMask(F(), hn::Ne(part, sky)));
        const Lanes foretells = hn::And(surface, sound);
        store_far(zero_unless(surface, choose(sound, by_plane, direct)), row.nearness + x);
        store_far(zero_unless(foretells, slope_x), row.slope_x + x);
        store_far(zero_unless(foretells, slope_y), row.slope_y + x);
        store_far(zero_unless(surface, sx), row.normal[0] + x);
        store_far(zero_unless(surface, sy), row.normal[1] + x);
        store_far(zero_unless(surface, sz), row.normal[2] + x);
    }
}

}  // namespace gh::filter::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gh::filter {

HWY_EXPORT(guides_row);

namespace {

void copy(const glm::vec3& from, float to[3]) {
    for (std::size_t i = 0; i < 3; ++i) to[i] = from[i];
}

}  // namespace

GuideRows rows_of(const Guides& guides, int y) {
    GuideRows rows{.nearness = guides.nearness.row(y),
                   .slope_x = guides.slope_x.row(y),
                   .slope_y = guides.slope_y.row(y),
                   .normal = {}};
    point_to(rows.normal, guides.normal, y);
    return rows;
}

void make_guides(const GBuffer& surfaces, const Jobs& jobs, Guides& guides) {
    run_rows(surfaces.height(), jobs, guide_rows(surfaces, guides));
}

RowWork guide_rows(const GBuffer& surfaces, Guides& guides) {
    const int width = surfaces.width(), height = surfaces.height();
    fit_together(width, height, guides.nearness, guides.slope_x, guides.slope_y, guides.normal);
    const Projector projector = projector_of(surfaces.lens);
    GuidesRow shared{};
    copy(surfaces.lens.eye, shared.eye);
    copy(surfaces.lens.corner, shared.corner);
    copy(surfaces.lens.right, shared.right);
    copy(surfaces.lens.down, shared.down);
    for (std::size_t i = 0; i < 3; ++i) shared.ahead[i] = projector.ahead[i];
    shared.width = width;
    return [shared, &surfaces, &guides](int y) {
        GuidesRow row = shared;
        point_to(row.position, surfaces.position, y);
        point_to(row.smooth, surfaces.normal, y);
        point_to(row.geometric, surfaces.geometric.empty() ? surfaces.normal : surfaces.geometric, y);
        row.part = surfaces.part.row(y);
        row.y = static_cast<float>(y) + 0.5f;
        row.nearness = guides.nearness.row(y);
        row.slope_x = guides.slope_x.row(y);
        row.slope_y = guides.slope_y.row(y);
        point_to(row.normal, guides.normal, y);
        HWY_DYNAMIC_DISPATCH(guides_row)(row);
    };
}

}  // namespace gh::filter
#endif
