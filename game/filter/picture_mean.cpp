#include "filter/picture_mean.h"

#include "filter/bordered.h"
#include "filter/rows.h"
#include "filter/picture_past.h"

#include <algorithm>
#include <utility>

namespace gh::filter {

namespace {

// That are added up where nothing moves, and where each frame moves them.
constexpr MeanLength kPictures{.still = 10.0f, .moving = 4.0f};

}  // namespace

void PictureMean::smooth_row(int y, const Movement& movement, const Plane& change, Plane3& out) {
    SmoothRow row{};
    row.y = y;
    row.width = size_.x;
    row.motion[0] = movement.x.row(y);
    row.motion[1] = movement.y.row(y);
    point_to_bordered(row.lighted, std::as_const(now_), y);
    row.above = y > 0 ? -now_.x.stride() : 0;
    row.below = y + 1 < size_.y ? now_.x.stride() : 0;
    row.change = change.empty() ? nullptr : change.row(y);
    row.pictures = kPictures;
    if (has_past_) {
        row.past = past_of(mean_, size_then_);
        const Plane& moved = movement.moved_before;
        if (moved.width() == size_then_.x && moved.height() == size_then_.y &&
            movement.moved_begin < movement.moved_end) {
            row.moves = movement.moves.row(y);
            point_to_moved(row.past, moved, movement.moved_begin, movement.moved_end);
        }
    }
    point_to_bordered(row.next, next_, y);
    point_to(row.out_planes, out, y);
    smooth_picture(row);
    repeat_sides(next_, size_.x, y);
}

void PictureMean::add_rows(const GBuffer& surfaces, const PictureRows& picture, const Change& change,
                           RowPasses& passes, Plane3& out) {
    size_ = {surfaces.width(), surfaces.height()};
    out.fit(size_.x, size_.y);
    fit_bordered(now_, size_);
    fit_bordered(next_, size_);
    const Movement* movement = change.movement;
    if (movement == nullptr) {
        movement = &movement_;
        movement_.fit(size_.x, size_.y);
        if (has_past_) passes.add(movement_rows(surfaces, before_, size_then_, movement_));
    }
    passes.add([this, picture](int y) {
        float* to[3];
        point_to_bordered(to, now_, y);
        picture(y, to);
        repeat_sides(now_, size_.x, y);
    });
    passes.begin(1);
    passes.add(
        [this, movement, &share = change.share, &out](int y) { smooth_row(y, *movement, share, out); });
}

void PictureMean::finish(const GBuffer& surfaces) {
    if (size_.x == 0 || size_.y == 0) return;
    repeat_rows(next_, size_.y);
    movement_.finish();  // if it is asked at all
    std::swap(mean_, next_);
    before_ = surfaces.lens;
    size_then_ = size_;
    has_past_ = true;
}

}  // namespace gh::filter
