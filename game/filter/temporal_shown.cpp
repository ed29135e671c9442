// The part of the upscaler that adds pictures up into what is shown.
#include "filter/picture_past.h"
#include "filter/temporal_upscale.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace gh::filter {

namespace {

constexpr MeanLength kShown{.still = 8.0f, .moving = 4.0f};
// In a picture of twice the sides most pixels have no sample near them in most pictures: one that is d small pixels away
// counts exp(-kNearby d^2). While things move there are too few pictures for that, and neighbours that differ by how near
// theirs were would show as a chequer.
constexpr float kNearby = 4.0f, kNearbyMoving = 0.5f;
// The mean of that over samples half a small pixel off at most: sqrt(pi / kNearby) erf(sqrt(kNearby) / 2).
constexpr float kUsually = 0.746824f;
// The light between samples is theirs, each by exp(-kSharp d^2), softer where no other picture knows better.
constexpr float kSharp = 6.0f, kSharpAlone = 3.0f;
constexpr MeanLength kDoubled{.still = 12.0f, .moving = 4.0f};

// How large pixels 2 u and 2 u + 1 lie beside the samples of small ones, along one axis.
struct Beside {
    int nearest[2];  // from small pixel u
    float share[2][3];
    float nearness[2];
};

// `jitter`: where small pixels were looked through.
Beside beside(float jitter, float sharp) {
    Beside to{};
    for (int side = 0; side < 2; ++side) {
        const float place = (side == 0 ? -0.25f : 0.25f) - jitter;
        const float nearest = std::floor(place + 0.5f), off = place - nearest;
        float total = 0.0f;
        for (int i = 0; i < 3; ++i) {
            const float d = off - static_cast<float>(i - 1);
            to.share[side][i] = std::exp(-sharp * d * d);
            total += to.share[side][i];
        }
        for (float& share : to.share[side]) share /= total;
        to.nearest[side] = static_cast<int>(nearest);
        to.nearness[side] = std::exp(-kNearby * off * off) / kUsually;
    }
    return to;
}

}  // namespace

PicturePast TemporalUpscaler::past() const {
    PicturePast past = past_of(picture_, shown_);
    if (moved_before_.width() == moves_.width() && moved_before_.height() == moves_.height())
        point_to_moved(past, moved_before_, 0, moved_before_.height());
    return past;
}

void TemporalUpscaler::smooth_row(const GuidedFrame& frame, int y, Image& out) {
    const int width = frame.guide.width, height = frame.guide.height;
    SmoothRow row{};
    row.y = y;
    row.width = width;
    row.motion[0] = motion_x_.row(y);
    row.motion[1] = motion_y_.row(y);
    point_to_bordered(row.lighted, std::as_const(lighted_), y);
    row.above = y > 0 ? -lighted_.x.stride() : 0;
    row.below = y + 1 < height ? lighted_.x.stride() : 0;
    row.pictures = kShown;
    if (has_history_) row.past = past();
    row.moves = moves_.row(y);
    point_to_bordered(row.next, next_picture_, y);
    row.out = &out.pixels[out.index(0, y)].x;
    smooth_picture(row);
    repeat_sides(next_picture_, width, y);
}

void TemporalUpscaler::double_row(const GuidedFrame& frame, int y, Image& out) {
    const int height = frame.guide.height;
    const float sharp = has_history_ ? kSharp : kSharpAlone;
    const Beside across = beside(frame.guide.jitter.x, sharp), down = beside(frame.guide.jitter.y, sharp);
    const int side = y % 2, middle = std::clamp(y / 2 + down.nearest[side], 0, height - 1);
    DoubleRow row{};
    row.y = y;
    row.width = shown_.x;
    for (int v = 0; v < 3; ++v) {
        const int line = std::clamp(y / 2 + down.nearest[side] + v - 1, 0, height - 1);
        point_to_bordered(row.picture[v], std::as_const(lighted_), line);
        row.down[v] = down.share[side][v];
    }
    row.motion[0] = motion_x_.row(middle);
    row.motion[1] = motion_y_.row(middle);
    for (int x = 0; x < 2; ++x) {
        row.nearest[x] = across.nearest[x];
        row.nearness[x] = across.nearness[x] * down.nearness[side];
        std::copy_n(across.share[x], 3, row.across[x]);
    }
    row.pictures = kDoubled;
    row.nearness_moving = kNearbyMoving;
    if (has_history_) row.past = past();
    row.moves = moves_.row(middle);
    point_to_bordered(row.next, next_picture_, y);
    row.out = &out.pixels[out.index(0, y)].x;
    double_picture(row);
    repeat_sides(next_picture_, shown_.x, y);
}

}  // namespace gh::filter
