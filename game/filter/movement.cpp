#include "filter/movement.h"

#include "filter/reproject_kernel.h"

#include <utility>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "filter/movement.cpp"
#include <hwy/foreach_target.h>
// foreach_target must come before what is compiled once per target.
#include "filter/reproject_place-inl.h"

HWY_BEFORE_NAMESPACE();
namespace gh::filter::HWY_NAMESPACE {

static void movement_row(const ReprojectRow& row) {
    for (std::size_t x = 0; x < static_cast<std::size_t>(row.width); x += lane_count())
        leave_movement(row, x, find_place(row, x));
}

}  // namespace gh::filter::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace gh::filter {

HWY_EXPORT(movement_row);

void Movement::fit(int width, int height) {
    fit_together(width, height, x, y, moves);
    itself.resize(static_cast<std::size_t>(height));
}

void Movement::finish() {
    const auto height = static_cast<int>(itself.size());
    const auto is_still = [this](int line) {
        const RowSpan& span = itself[static_cast<std::size_t>(line)];
        return span.begin == span.end;
    };
    moved_begin = 0;
    moved_end = height;
    while (moved_begin < moved_end && is_still(moved_begin)) ++moved_begin;
    while (moved_end > moved_begin && is_still(moved_end - 1)) --moved_end;
    std::swap(moves, moved_before);
}

void point_to_movement(const GBuffer& now, int y, Movement& movement, ReprojectRow& row) {
    row.motion[0] = movement.x.row(y);
    row.motion[1] = movement.y.row(y);
    row.moves = movement.moves.row(y);
    row.itself = &movement.itself[static_cast<std::size_t>(y)];
    *row.itself = {};
    const glm::vec3 corner = now.lens.corner + now.lens.down * row.y;
    for (glm::length_t c = 0; c < 3; ++c) {
        row.corner[c] = corner[c];
        row.right[c] = now.lens.right[c];
    }
}

RowWork movement_rows(const GBuffer& now, const Pinhole& then, glm::ivec2 size_then, Movement& movement) {
    movement.fit(now.width(), now.height());
    const ReprojectRow shared = reproject_row_of(now, then, size_then);
    return [shared, &now, &movement](int y) {
        ReprojectRow row = shared;
        point_to_surfaces(now, y, row);
        point_to_movement(now, y, movement, row);
        HWY_DYNAMIC_DISPATCH(movement_row)(row);
    };
}

}  // namespace gh::filter
#endif
