#include "filter/temporal_upscale.h"

#include "base/contracts.h"
#include "filter/bordered.h"
#include "filter/lit_light.h"
#include "filter/picture_past.h"
#include "filter/rows.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace gh::filter {

namespace {

constexpr float kNearness = 2.5f;  // a sample d pixels away counts exp(-kNearness d^2)
constexpr float kReach = 2.0f;     // of a lit pixel's size: how far one surface leaves its own plane

bool is_finite(const glm::vec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

glm::mat3 picture_from_world(const Pinhole& lens) {
    return glm::inverse(glm::mat3(lens.right, lens.down, lens.corner));
}

const float* row_of(std::span<const glm::vec3> plane, std::size_t first) {
    return &plane[first].x;
}

void copy(const glm::vec3& from, float* to) {
    std::copy_n(glm::value_ptr(from), 3, to);
}

}  // namespace

LitPlanes TemporalUpscaler::lit_planes() const {
    LitPlanes planes{};
    planes.part = lit_.part.row(0);
    point_to(planes.normal, lit_.normal, 0);
    point_to(planes.position, lit_.position, 0);
    planes.distance = lit_.distance.row(0);
    point_to(planes.light, lit_.light, 0);
    planes.known = lit_.known.row(0);
    point_to(planes.low, lit_.low, 0);
    point_to(planes.high, lit_.high, 0);
    planes.stride = lit_.part.stride();
    planes.width = lit_.part.width();
    planes.height = lit_.part.height();
    return planes;
}

void TemporalUpscaler::demodulate_row(const GuidedFrame& frame, int v) {
    const Guide& guide = frame.guide;
    for (int u = 0; u < frame.radiance.width; ++u) {
        const glm::vec3& radiance = frame.radiance.pixels[frame.radiance.index(u, v)];
        const std::size_t at = frame.index_of_lit(u, v);
        const glm::vec3 light = light_of_lit(frame, {u, v}, reach_);
        const bool is_known = is_finite(light) && is_finite(radiance);
        const bool is_sky = guide.part[at] == kNoSurface;
        lit_.light.set(u, v, is_known ? light : glm::vec3(0.0f));
        lit_.known.at(u, v) = is_known ? 1.0f : 0.0f;
        lit_.part.at(u, v) = guide.part[at];
        lit_.normal.set(u, v, guide.geometric[at]);
        lit_.position.set(u, v, guide.position[at]);
        lit_.distance.at(u, v) = is_sky ? kToSky : glm::distance(guide.lens.eye, guide.position[at]);
    }
}

void TemporalUpscaler::find_range_row(int v) {
    RangeRow row{.lit = lit_planes(), .v = v, .reach = reach_, .low = {}, .high = {}};
    point_to(row.low, lit_.low, v);
    point_to(row.high, lit_.high, v);
    find_range(row);
}

void TemporalUpscaler::spread_row(const GuidedFrame& frame, int y) {
    const Guide& guide = frame.guide;
    const std::size_t first = guide.index(0, y);
    SpreadRow row{};
    row.y = y;
    row.width = guide.width;
    row.height = guide.height;
    row.position = row_of(guide.position, first);
    row.previous = row_of(guide.previous, first);
    row.normal = row_of(guide.geometric, first);
    row.albedo = row_of(guide.albedo, first);
    row.clean = row_of(guide.clean, first);
    row.part = &guide.part[first];
    copy(guide.lens.eye, row.eye);
    const float down = static_cast<float>(y) + 0.5f + guide.jitter.y;
    copy(guide.lens.corner + guide.lens.down * down, row.corner);
    copy(guide.lens.right, row.right);
    row.jitter[0] = guide.jitter.x;
    row.jitter[1] = guide.jitter.y;
    copy(before_.eye, row.eye_before);
    std::copy_n(glm::value_ptr(picture_before_), 9, row.picture_before);
    row.lit = lit_planes();
    const int below = y - frame.offset.y + frame.step;  // a step more, so that it is never negative
    row.v = below / frame.step - 1;
    row.share_y = static_cast<float>(below % frame.step) / static_cast<float>(frame.step);
    row.step = static_cast<float>(frame.step);
    const auto near = [&](float share) { return std::exp(-kNearness * share * share * row.step * row.step); };
    row.near_y[0] = near(row.share_y);
    row.near_y[1] = near(1.0f - row.share_y);
    row.u = between_.u.data();
    row.share_x = between_.share.data();
    row.near_x[0] = between_.near_left.data();
    row.near_x[1] = between_.near_right.data();
    row.reach = reach_;
    row.has_past = has_history_;
    point_to(row.then.light, kept_.light, 0);
    row.then.count = kept_.count.row(0);
    row.then.distance = kept_.distance.row(0);
    row.then.part = kept_.part.row(0);
    row.then.facing = kept_.facing.row(0);
    row.then.stride = kept_.part.stride();
    point_to(row.light, next_.light, y);
    row.count = next_.count.row(y);
    row.distance = next_.distance.row(y);
    row.kept_part = next_.part.row(y);
    row.kept_facing = next_.facing.row(y);
    row.motion[0] = motion_x_.row(y);
    row.motion[1] = motion_y_.row(y);
    row.moves = moves_.row(y);
    point_to_bordered(row.lighted, lighted_, y);
    spread_light(row);
    repeat_sides(lighted_, guide.width, y);
}

// What is kept has another size: begin with it stretched.
void TemporalUpscaler::stretch(glm::ivec2 size) {
    Kept stretched;
    stretched.fit(size);
    for (int y = 0; has_history_ && y < size.y; ++y) {
        for (int x = 0; x < size.x; ++x) {
            const int u = x * size_.x / size.x, v = y * size_.y / size.y;
            stretched.light.set(x, y, kept_.light.get(u, v));
            stretched.count.at(x, y) = std::min(kept_.count.at(u, v), 1.0f);
            stretched.distance.at(x, y) = kept_.distance.at(u, v);
            stretched.part.at(x, y) = kept_.part.at(u, v);
            stretched.facing.at(x, y) = kept_.facing.at(u, v);
        }
    }
    if (has_history_) {
        const glm::vec2 wider = glm::vec2(size_) / glm::vec2(size);
        before_.right *= wider.x;
        before_.down *= wider.y;
    }
    kept_ = std::move(stretched);
    size_ = size;
}

void TemporalUpscaler::fit(const GuidedFrame& frame) {
    const glm::ivec2 size(frame.guide.width, frame.guide.height),
        lit(frame.radiance.width, frame.radiance.height);
    if (size_ != size) stretch(size);
    for (Plane3* planes : {&lit_.normal, &lit_.position, &lit_.light, &lit_.low, &lit_.high})
        planes->fit(lit.x, lit.y);
    for (Plane* plane : {&lit_.distance, &lit_.known}) plane->fit(lit.x, lit.y);
    lit_.part.fit(lit.x, lit.y);
    next_.fit(size);
    fit_together(size.x, size.y, motion_x_, motion_y_, moves_);
    fit_bordered(lighted_, size);
    const glm::ivec2 shown = frame.doubles ? 2 * size : size;
    if (has_history_ && shown_ != shown) picture_ = stretched(picture_, shown_, shown);
    shown_ = shown;
    fit_bordered(next_picture_, shown);
}

void TemporalUpscaler::lay_out(const GuidedFrame& frame) {
    const auto step = static_cast<float>(frame.step);
    const std::size_t count = (static_cast<std::size_t>(frame.guide.width) + 15) / 16 * 16;
    between_.u.resize(count);
    for (auto* numbers : {&between_.share, &between_.near_left, &between_.near_right}) numbers->resize(count);
    for (std::size_t x = 0; x < count; ++x) {
        const int right = static_cast<int>(x) - frame.offset.x + frame.step;
        const float share = static_cast<float>(right % frame.step) / step;
        between_.u[x] = right / frame.step - 1;
        between_.share[x] = share;
        between_.near_left[x] = std::exp(-kNearness * share * share * step * step);
        between_.near_right[x] = std::exp(-kNearness * (1.0f - share) * (1.0f - share) * step * step);
    }
}

void TemporalUpscaler::add(const GuidedFrame& frame, const Jobs& jobs, Image& out) {
    const Guide& guide = frame.guide;
    const std::size_t pixels = guide.part.size();
    EXPECTS(frame.radiance.width >= 1 && frame.radiance.height >= 1 && frame.step >= 1);
    EXPECTS(0 <= frame.offset.x && frame.offset.x < frame.step && 0 <= frame.offset.y &&
            frame.offset.y < frame.step);
    EXPECTS(guide.width == frame.radiance.width * frame.step &&
            guide.height == frame.radiance.height * frame.step);
    EXPECTS(guide.position.size() == pixels && guide.previous.size() == pixels &&
            guide.albedo.size() == pixels);
    EXPECTS(guide.geometric.size() == pixels && guide.clean.size() == pixels);
    fit(frame);
    lay_out(frame);
    reach_ = kReach * static_cast<float>(frame.step) * glm::length(guide.lens.right);
    picture_before_ = picture_from_world(before_);
    if (out.width != shown_.x || out.height != shown_.y) out = Image(shown_.x, shown_.y);
    run_rows(frame.radiance.height, jobs, [&](int v) { demodulate_row(frame, v); });
    run_rows(frame.radiance.height, jobs, [&](int v) { find_range_row(v); });
    run_rows(guide.height, jobs, [&](int y) { spread_row(frame, y); });
    run_rows(shown_.y, jobs,
             [&](int y) { frame.doubles ? double_row(frame, y, out) : smooth_row(frame, y, out); });
    repeat_rows(next_picture_, shown_.y);
    std::swap(kept_, next_);
    std::swap(picture_, next_picture_);
    std::swap(moves_, moved_before_);
    before_ = guide.lens;
    has_history_ = true;
}

}  // namespace gh::filter
