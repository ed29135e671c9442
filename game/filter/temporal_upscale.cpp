#include "filter/temporal_upscale.h"

#include "base/contracts.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>

namespace gh::filter {

namespace {

constexpr float kStillCount = 10.0f;  // samples a mean of light goes over where nothing moves ...
constexpr float kMovingCount =
    2.0f;                          // ... and where each frame moves it: it blurs, and what is mirrored lags
constexpr float kNearness = 2.5f;  // a sample d pixels away counts exp(-kNearness d^2) ...
constexpr float kLeastCount = 0.02f;    // ... at least this,
constexpr float kMovingLeast = 0.5f;    // or this where things move: what is mirrored slides along
constexpr float kSlack = 0.5f;          // of the range of samples around, beyond which nothing is believed
constexpr float kReach = 2.0f;          // of a lit pixel's size: how far one surface leaves its own plane
constexpr float kSameFacing = 0.8f;     // least cosine between the normals of one surface
constexpr float kSameDistance = 0.03f;  // of a distance from the eye
constexpr float kFar = 1e4f;            // metres to the sky

bool is_finite(const glm::vec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

glm::mat3 picture_from_world(const Pinhole& lens) {
    return glm::inverse(glm::mat3(lens.right, lens.down, lens.corner));
}

}  // namespace

void TemporalUpscaler::demodulate_row(const GuidedFrame& frame, int v) {
    for (int u = 0; u < frame.radiance.width; ++u) {
        const std::size_t i = frame.radiance.index(u, v);
        const std::size_t at = frame.index_of_lit(u, v);
        const glm::vec3 light =
            glm::max((frame.radiance.pixels[i] - frame.guide.clean[at]) / frame.guide.albedo[at], 0.0f);
        Lit& lit = lit_[i];
        lit.is_known = is_finite(light) && is_finite(frame.radiance.pixels[i]);
        lit.light = lit.is_known ? light : glm::vec3(0.0f);
    }
}

// Whether two pixels show one surface, that goes on between them. `distance`: of the first, from the eye.
bool TemporalUpscaler::are_one(const Guide& guide, std::size_t a, std::size_t b, float distance) const {
    if (guide.part[a] != guide.part[b]) return false;
    if (guide.part[a] == kNoSurface) return true;
    if (glm::dot(guide.geometric[a], guide.geometric[b]) < kSameFacing) return false;
    const glm::vec3 offset = guide.position[b] - guide.position[a];
    const float reach = reach_ * distance;
    return std::abs(glm::dot(offset, guide.geometric[a])) < reach &&
           std::abs(glm::dot(offset, guide.geometric[b])) < reach;
}

void TemporalUpscaler::find_range_row(const GuidedFrame& frame, int v) {
    const int width = frame.radiance.width, height = frame.radiance.height;
    for (int u = 0; u < width; ++u) {
        Lit& lit = lit_[frame.radiance.index(u, v)];
        lit.low = lit.high = lit.light;
        const std::size_t here = frame.index_of_lit(u, v);
        const float distance = motion_[here].distance;
        for (int y = std::max(0, v - 1); y <= std::min(height - 1, v + 1); ++y) {
            for (int x = std::max(0, u - 1); x <= std::min(width - 1, u + 1); ++x) {
                const Lit& other = lit_[frame.radiance.index(x, y)];
                if (!other.is_known || !are_one(frame.guide, here, frame.index_of_lit(x, y), distance))
                    continue;
                lit.low = glm::min(lit.low, other.light);
                lit.high = glm::max(lit.high, other.light);
            }
        }
    }
}

TemporalUpscaler::Motion TemporalUpscaler::motion_of(const Guide& guide, int x, int y, std::size_t i) const {
    Motion motion;
    const glm::vec2 at = glm::vec2(x, y) + 0.5f + guide.jitter;
    glm::vec3 was = guide.previous[i];
    motion.distance = glm::distance(guide.lens.eye, guide.position[i]);
    if (guide.part[i] == kNoSurface) {
        const glm::vec3 way = guide.lens.corner + guide.lens.right * at.x + guide.lens.down * at.y;
        was = guide.lens.eye + glm::normalize(way) * kFar;
        motion.distance = kFar;
    }
    motion.was_distance = glm::distance(before_.eye, was);
    if (!has_history_) return motion;
    const glm::vec3 then = picture_before_ * (was - before_.eye);
    motion.by = then.z > 0.0f ? glm::vec2(then) / then.z - at : glm::vec2(-1e6f);
    if (!(std::abs(motion.by.x) < 1e6f) || !(std::abs(motion.by.y) < 1e6f)) motion.by = glm::vec2(-1e6f);
    return motion;
}

// This frame's light on a pixel's surface, by the lit pixels around it; `count`: what it is worth.
TemporalUpscaler::Lit TemporalUpscaler::fresh_light(const GuidedFrame& frame, int x, int y, float distance,
                                                    float& count) const {
    const int width = frame.radiance.width, height = frame.radiance.height;
    const std::size_t here = frame.guide.index(x, y);
    const auto step = static_cast<float>(frame.step);
    const glm::vec2 at = glm::vec2(x - frame.offset.x, y - frame.offset.y) / step;
    const glm::ivec2 low(glm::floor(at));
    Lit result;
    result.low = glm::vec3(1e30f);
    result.high = glm::vec3(-1e30f);
    float total = 0.0f;
    const Lit* nearest = nullptr;
    float nearest_off = 1e30f;
    count = 0.0f;
    for (int corner = 0; corner < 4; ++corner) {
        const int u = low.x + (corner & 1), v = low.y + (corner >> 1);
        if (u < 0 || v < 0 || u >= width || v >= height) continue;
        const glm::vec2 off = at - glm::vec2(u, v);
        const float weight = (1.0f - std::abs(off.x)) * (1.0f - std::abs(off.y));
        if (!(weight > 0.0f)) continue;
        const Lit& lit = lit_[frame.radiance.index(u, v)];
        if (!lit.is_known) continue;
        const float off2 = glm::dot(off, off) * step * step;
        if (off2 < nearest_off) {
            nearest_off = off2;
            nearest = &lit;
        }
        const std::size_t there = frame.index_of_lit(u, v);
        if (there != here && !are_one(frame.guide, here, there, distance)) continue;
        result.light += lit.light * weight;
        result.low = glm::min(result.low, lit.low);
        result.high = glm::max(result.high, lit.high);
        total += weight;
        count = std::max(count, std::exp(-kNearness * off2));
    }
    if (total > 0.0f) {
        result.light /= total;
        result.is_known = true;
        count = std::max(count, kLeastCount);
    } else if (nearest != nullptr) {
        result.light = nearest->light;  // of something else, but near
        count = 0.0f;
    }
    return result;
}

TemporalUpscaler::Kept TemporalUpscaler::kept_light(const Guide& guide, int x, int y, const Motion& motion,
                                                    std::uint32_t part) const {
    Kept result;
    const glm::vec2 at = glm::vec2(x, y) + motion.by;
    if (!(at.x > -1.0f) || !(at.y > -1.0f) || !(at.x < static_cast<float>(guide.width)) ||
        !(at.y < static_cast<float>(guide.height)))
        return result;
    const glm::vec2 floor = glm::floor(at);
    const glm::ivec2 low(floor);
    const glm::vec2 share = at - floor;
    float total = 0.0f;
    const auto take = [&](int u, int v, float weight) {
        if (u < 0 || v < 0 || u >= guide.width || v >= guide.height) return;
        const Kept& kept = kept_[guide.index(u, v)];
        if (kept.part != part || !(kept.count > 0.0f) ||
            std::abs(kept.distance - motion.was_distance) > kSameDistance * motion.was_distance)
            return;
        result.light += kept.light * weight;
        result.count += kept.count * weight;
        total += weight;
    };
    constexpr float kLeast = 1e-3f;
    for (int corner = 0; corner < 4; ++corner) {
        const bool right = (corner & 1) != 0, below = (corner & 2) != 0;
        const float weight = (right ? share.x : 1.0f - share.x) * (below ? share.y : 1.0f - share.y);
        if (weight > kLeast) take(low.x + (right ? 1 : 0), low.y + (below ? 1 : 0), weight);
    }
    if (!(total > 0.0f)) {  // an edge that one frame saw on this side and the other on that
        const glm::ivec2 near(glm::floor(at + 0.5f));
        for (int v = near.y - 1; v <= near.y + 1; ++v)
            for (int u = near.x - 1; u <= near.x + 1; ++u) take(u, v, 1.0f);
    }
    if (!(total > 0.0f)) return {};
    result.light /= total;
    result.count /= total;
    return result;
}

void TemporalUpscaler::light_row(const GuidedFrame& frame, int y) {
    const Guide& guide = frame.guide;
    for (int x = 0; x < guide.width; ++x) {
        const std::size_t i = guide.index(x, y);
        const Motion& motion = motion_[i];
        float count = 0.0f;
        const Lit fresh = fresh_light(frame, x, y, motion.distance, count);
        Kept kept = has_history_ ? kept_light(guide, x, y, motion, guide.part[i]) : Kept{};
        if (kept.count > 0.0f && fresh.is_known) {
            const glm::vec3 slack = (fresh.high - fresh.low) * kSlack;
            glm::vec3 believed = glm::clamp(kept.light, fresh.low - slack, fresh.high + slack);
            // What is proved wrong is given no slack: a lamp's last tenth would linger in it.
            if (believed != kept.light) believed = glm::clamp(kept.light, fresh.low, fresh.high);
            // The further it had to be brought back, the less its past is worth.
            const float off = glm::length(believed - kept.light), size = glm::length(kept.light) + 1e-6f;
            kept.count *= 1.0f - std::min(1.0f, off / size);
            kept.light = believed;
        }
        if (kept.count < 1.0f && fresh.is_known) count = std::max(count, 0.2f);
        const float moved = std::min(1.0f, 2.0f * glm::length(motion.by));
        if (fresh.is_known) count = std::max(count, kMovingLeast * moved);
        const float total = kept.count + count;
        const float most = kStillCount + (kMovingCount - kStillCount) * moved;
        Kept& next = next_[i];
        next.light = total > 0.0f ? kept.light + (fresh.light - kept.light) * (count / total) : fresh.light;
        next.count = std::min(total, most);
        next.distance = motion.distance;
        next.part = guide.part[i];
        const glm::vec3 color = next.light * guide.albedo[i] + guide.clean[i];
        lighted_[i] = is_finite(color) ? color : glm::vec3(0.0f);
    }
}

// What is kept has another size: begin with it stretched.
void TemporalUpscaler::stretch(const Guide& guide) {
    const glm::ivec2 size(guide.width, guide.height);
    std::vector<Kept> stretched(guide.part.size());
    std::vector<glm::vec3> picture(guide.part.size());
    for (int y = 0; has_history_ && y < size.y; ++y) {
        for (int x = 0; x < size.x; ++x) {
            const int u = x * size_.x / size.x, v = y * size_.y / size.y;
            const std::size_t from =
                static_cast<std::size_t>(v) * static_cast<std::size_t>(size_.x) + static_cast<std::size_t>(u);
            const std::size_t to = guide.index(x, y);
            stretched[to] = kept_[from];
            stretched[to].count = std::min(stretched[to].count, 1.0f);
            picture[to] = picture_[from];
        }
    }
    if (has_history_) {
        const glm::vec2 wider = glm::vec2(size_) / glm::vec2(size);
        before_.right *= wider.x;
        before_.down *= wider.y;
    }
    kept_ = std::move(stretched);
    picture_ = std::move(picture);
    size_ = size;
}

void TemporalUpscaler::add(const GuidedFrame& frame, const Jobs& jobs, Image& out) {
    const Guide& guide = frame.guide;
    const std::size_t pixels = guide.part.size();
    EXPECTS(frame.radiance.width >= 1 && frame.radiance.height >= 1 && frame.step >= 1);
    EXPECTS(guide.width == frame.radiance.width * frame.step &&
            guide.height == frame.radiance.height * frame.step);
    EXPECTS(guide.position.size() == pixels && guide.previous.size() == pixels &&
            guide.albedo.size() == pixels);
    EXPECTS(guide.geometric.size() == pixels && guide.clean.size() == pixels);
    if (size_ != glm::ivec2(guide.width, guide.height)) stretch(guide);
    reach_ = kReach * static_cast<float>(frame.step) * glm::length(guide.lens.right);
    picture_before_ = picture_from_world(before_);
    lit_.resize(frame.radiance.pixels.size());
    next_.resize(pixels);
    motion_.resize(pixels);
    lighted_.resize(pixels);
    if (out.width != guide.width || out.height != guide.height) out = Image(guide.width, guide.height);
    const auto rows = static_cast<std::size_t>(guide.height);
    const auto lit_rows = static_cast<std::size_t>(frame.radiance.height);
    jobs.run(rows, [&](std::size_t row, int) {
        const int y = static_cast<int>(row);
        for (int x = 0; x < guide.width; ++x)
            motion_[guide.index(x, y)] = motion_of(guide, x, y, guide.index(x, y));
    });
    jobs.run(lit_rows, [&](std::size_t v, int) { demodulate_row(frame, static_cast<int>(v)); });
    jobs.run(lit_rows, [&](std::size_t v, int) { find_range_row(frame, static_cast<int>(v)); });
    jobs.run(rows, [&](std::size_t y, int) { light_row(frame, static_cast<int>(y)); });
    jobs.run(rows, [&](std::size_t y, int) { smooth_row(guide, static_cast<int>(y), out); });
    picture_ = out.pixels;
    kept_.swap(next_);
    before_ = guide.lens;
    has_history_ = true;
}

}  // namespace gh::filter
