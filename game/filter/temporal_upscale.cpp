#include "filter/temporal_upscale.h"

#include "base/contracts.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace gh::filter {

namespace {

constexpr float kStillWeight = 10.0f;   // samples a mean goes over where nothing moves ...
constexpr float kMovingWeight = 2.0f;   // ... and where each frame moves it, which blurs it a little
constexpr float kNearness = 1.2f;       // a sample d large pixels away counts exp(-kNearness d^2) ...
constexpr float kLeastCount = 0.03f;    // ... at least this
constexpr float kSlack = 0.5f;          // of the range of colours around, beyond which nothing is believed
constexpr float kSlides = 0.3f;         // large pixels a frame by which one thing slides along another
constexpr float kSameDistance = 0.05f;  // of a distance from the eye
constexpr float kFar = 1e4f;            // metres to the sky
constexpr float kStays = 1e-4f;         // of a distance from the eye: rounding moves things by less

bool is_finite(const glm::vec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

// Where a picture point that shows `p` lies, in widths and heights of the picture; far outside behind the eye.
glm::vec2 place_of(const glm::vec3& p, const glm::vec3& eye, const glm::mat3& picture_from_world,
                   const glm::ivec2& size) {
    const glm::vec3 at = picture_from_world * (p - eye);
    if (!(at.z > 0.0f)) return glm::vec2(-10.0f);
    return glm::vec2(at.x, at.y) / (at.z * glm::vec2(size));
}

glm::mat3 picture_from_world(const Pinhole& lens) {
    return glm::inverse(glm::mat3(lens.right, lens.down, lens.corner));
}

// Weights of the four numbers around a place `t` after the second.
std::array<float, 4> catmull_rom(float t) {
    const float t2 = t * t, t3 = t2 * t;
    return {0.5f * (2.0f * t2 - t3 - t), 0.5f * (3.0f * t3 - 5.0f * t2 + 2.0f),
            0.5f * (4.0f * t2 - 3.0f * t3 + t), 0.5f * (t3 - t2)};
}

float radical_inverse(std::uint32_t i, std::uint32_t base) {
    float result = 0.0f, digit = 1.0f / static_cast<float>(base);
    for (; i > 0; i /= base, digit /= static_cast<float>(base))
        result += static_cast<float>(i % base) * digit;
    return result;
}

}  // namespace

glm::vec2 halton_jitter(std::uint32_t i) {
    constexpr std::uint32_t kPeriod = 32;
    const std::uint32_t n = i % kPeriod + 1;
    return glm::vec2(radical_inverse(n, 2), radical_inverse(n, 3)) - 0.5f;
}

void TemporalUpscaler::gather_row(const JitteredFrame& frame, int y) {
    const int width = frame.radiance.width, height = frame.radiance.height;
    const glm::ivec2 size(width, height);
    const glm::mat3 to_before = picture_from_world(before_);
    for (int x = 0; x < width; ++x) {
        const std::size_t i = frame.radiance.index(x, y);
        Sample& sample = samples_[i];
        sample.color = frame.radiance.pixels[i];
        if (!is_finite(sample.color)) sample.color = glm::vec3(0.0f);
        sample.low = sample.high = sample.color;
        for (int v = std::max(0, y - 1); v <= std::min(height - 1, y + 1); ++v) {
            for (int u = std::max(0, x - 1); u <= std::min(width - 1, x + 1); ++u) {
                const glm::vec3& color = frame.radiance.pixels[frame.radiance.index(u, v)];
                sample.low = glm::min(sample.low, color);
                sample.high = glm::max(sample.high, color);
            }
        }
        sample.part = frame.part[i];
        const glm::vec2 at = (glm::vec2(x, y) + 0.5f + frame.jitter);
        glm::vec3 was = frame.previous[i];
        sample.distance = glm::distance(frame.lens.eye, frame.position[i]);
        if (sample.part == kNoSurface) {
            const glm::vec3 way = frame.lens.corner + frame.lens.right * at.x + frame.lens.down * at.y;
            was = frame.lens.eye + glm::normalize(way) * kFar;
            sample.distance = kFar;
        }
        sample.stays =
            sample.part == kNoSurface || glm::distance(was, frame.position[i]) < kStays * sample.distance;
        sample.was_distance = sample.part == kNoSurface ? kFar : glm::distance(before_.eye, was);
        sample.motion = has_history_
                            ? place_of(was, before_.eye, to_before, before_size_) - at / glm::vec2(size)
                            : glm::vec2(0.0f);
    }
}

// What is kept around a place: the colour by a sharp filter, since a mean is moved in every frame and a bilinear one
// would blur it each time; weight 0 outside the picture.
TemporalUpscaler::Kept TemporalUpscaler::kept_at(const glm::vec2& place) const {
    const glm::vec2 at = place * glm::vec2(size_) - 0.5f;
    if (!(at.x > -1.0f) || !(at.y > -1.0f) || !(at.x < static_cast<float>(size_.x)) ||
        !(at.y < static_cast<float>(size_.y)))
        return {};
    const glm::vec2 floor = glm::floor(at);
    const glm::ivec2 low(floor);
    const auto kept = [&](int x, int y) -> const Kept& {
        return kept_[static_cast<std::size_t>(std::clamp(y, 0, size_.y - 1)) *
                         static_cast<std::size_t>(size_.x) +
                     static_cast<std::size_t>(std::clamp(x, 0, size_.x - 1))];
    };
    const glm::vec2 share = at - floor;
    const Kept& nearest = kept(low.x + (share.x < 0.5f ? 0 : 1), low.y + (share.y < 0.5f ? 0 : 1));
    if (share == glm::vec2(0.0f)) return nearest;
    const std::array<float, 4> across = catmull_rom(share.x), down = catmull_rom(share.y);
    Kept result = nearest;
    result.color = glm::vec3(0.0f);
    for (int y = 0; y < 4; ++y) {
        glm::vec3 row(0.0f);
        for (int x = 0; x < 4; ++x)
            row += kept(low.x + x - 1, low.y + y - 1).color * across[static_cast<std::size_t>(x)];
        result.color += row * down[static_cast<std::size_t>(y)];
    }
    // Beside a bulb a sharp filter swings below nothing.
    const glm::vec3 darkest =
        glm::min(glm::min(kept(low.x, low.y).color, kept(low.x + 1, low.y).color),
                 glm::min(kept(low.x, low.y + 1).color, kept(low.x + 1, low.y + 1).color));
    result.color = glm::max(result.color, darkest * 0.5f);
    return result;
}

// Bilinear between those of the four samples around a place in the small picture that show what `nearest` shows.
glm::vec3 TemporalUpscaler::smooth(const JitteredFrame& frame, const glm::vec2& place,
                                   const Sample& nearest) const {
    const int width = frame.radiance.width, height = frame.radiance.height;
    const glm::vec2 at = glm::clamp(place - 0.5f, glm::vec2(0.0f), glm::vec2(width - 1, height - 1));
    const glm::ivec2 low(glm::min(at, glm::vec2(std::max(0, width - 2), std::max(0, height - 2))));
    const glm::vec2 share = at - glm::vec2(low);
    glm::vec3 sum(0.0f);
    float total = 0.0f;
    for (int corner = 0; corner < 4; ++corner) {
        const bool is_right = (corner & 1) != 0, is_below = (corner & 2) != 0;
        const Sample& sample =
            samples_[frame.radiance.index(std::min(low.x + (is_right ? 1 : 0), width - 1),
                                          std::min(low.y + (is_below ? 1 : 0), height - 1))];
        const float apart = std::abs(sample.distance - nearest.distance);
        if (sample.part != nearest.part || apart > 2.0f * kSameDistance * nearest.distance) continue;
        const float weight = (is_right ? share.x : 1.0f - share.x) * (is_below ? share.y : 1.0f - share.y);
        sum += sample.color * weight;
        total += weight;
    }
    return total > 0.0f ? sum / total : nearest.color;
}

// Whether what is kept can be what the sample shows. What stands still may be one part, so distance tells things apart.
bool TemporalUpscaler::is_same(const Kept& kept, const Sample& sample) {
    return kept.part == sample.part &&
           std::abs(kept.distance - sample.was_distance) <= kSameDistance * sample.was_distance;
}

// At an edge now one side is seen, now the other: both are right unless one slides along the other.
bool TemporalUpscaler::is_known(const Kept& kept, const std::array<const Sample*, 5>& around) const {
    const Sample& nearest = *around[0];
    if (is_same(kept, nearest)) return true;
    const float parallax = parallax_ * std::abs(1.0f / kept.distance - 1.0f / nearest.was_distance);
    if ((kept.part == nearest.part || (kept.stays && nearest.stays)) && parallax < kSlides) return true;
    return std::any_of(around.begin() + 1, around.end(), [&](const Sample* other) {
        const glm::vec2 slides = (other->motion - nearest.motion) * glm::vec2(size_);
        return is_same(kept, *other) && glm::dot(slides, slides) < kSlides * kSlides;
    });
}

TemporalUpscaler::Kept TemporalUpscaler::renewed(const JitteredFrame& frame, int x, int y) const {
    const int width = frame.radiance.width, height = frame.radiance.height;
    const glm::vec2 place = (glm::vec2(x, y) + 0.5f) / glm::vec2(size_);
    const glm::vec2 small = place * glm::vec2(width, height) - frame.jitter;
    const int u = std::clamp(static_cast<int>(std::floor(small.x)), 0, width - 1);
    const int v = std::clamp(static_cast<int>(std::floor(small.y)), 0, height - 1);
    const Sample& nearest = samples_[frame.radiance.index(u, v)];

    const std::array<const Sample*, 5> around = {
        &nearest,  //
        &samples_[frame.radiance.index(std::max(u - 1, 0), v)],
        &samples_[frame.radiance.index(std::min(u + 1, width - 1), v)],
        &samples_[frame.radiance.index(u, std::max(v - 1, 0))],
        &samples_[frame.radiance.index(u, std::min(v + 1, height - 1))]};

    const float moved = std::min(1.0f, 2.0f * glm::length(nearest.motion * glm::vec2(size_)));
    Kept kept = has_history_ ? kept_at(place + nearest.motion) : Kept{};
    if (kept.weight > 0.0f) {
        if (!is_known(kept, around))
            kept.weight = parallax_ < kSlides * nearest.distance ? std::min(kept.weight, 1.0f) : 0.0f;
        const glm::vec3 slack = (nearest.high - nearest.low) * kSlack;
        glm::vec3 believed = glm::clamp(kept.color, nearest.low - slack, nearest.high + slack);
        // What is proved wrong is given no slack: a lamp's last tenth would linger in it.
        if (believed != kept.color) believed = glm::clamp(kept.color, nearest.low, nearest.high);
        // The further it had to be brought back, the less its past is worth.
        const float off = glm::length(believed - kept.color), size = glm::length(kept.color) + 1e-6f;
        kept.weight *= 1.0f - std::min(1.0f, off / size);
        kept.color = believed;
    }
    const glm::vec2 large_per_small = glm::vec2(size_) / glm::vec2(width, height);
    const glm::vec2 off = (glm::vec2(u, v) + 0.5f - small) * large_per_small;
    glm::vec3 color = nearest.color;
    float count = std::max(kLeastCount, std::exp(-kNearness * glm::dot(off, off)));
    if (kept.weight < 1.0f) {
        // Nothing to build on: a smooth picture first, which a better sample soon replaces.
        color = smooth(frame, small, nearest);
        count = std::max(count, 0.2f);
    }
    const float total = kept.weight + count;
    const float most = kStillWeight + (kMovingWeight - kStillWeight) * moved;
    return {kept.color + (color - kept.color) * (count / total), std::min(total, most), nearest.distance,
            nearest.part, nearest.stays};
}

void TemporalUpscaler::stretch(glm::ivec2 size) {
    std::vector<Kept> stretched(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y));
    for (int y = 0; has_history_ && y < size.y; ++y) {
        for (int x = 0; x < size.x; ++x) {
            Kept kept = kept_at((glm::vec2(x, y) + 0.5f) / glm::vec2(size));
            kept.weight = std::min(kept.weight, 1.0f);
            stretched[static_cast<std::size_t>(y) * static_cast<std::size_t>(size.x) +
                      static_cast<std::size_t>(x)] = kept;
        }
    }
    kept_ = std::move(stretched);
    size_ = size;
}

void TemporalUpscaler::add(const JitteredFrame& frame, glm::ivec2 size, const Jobs& jobs, Image& out) {
    const std::size_t pixels = frame.radiance.pixels.size();
    EXPECTS(size.x >= 1 && size.y >= 1 && pixels > 0);
    EXPECTS(frame.part.size() == pixels && frame.position.size() == pixels &&
            frame.previous.size() == pixels);
    if (size != size_) stretch(size);
    next_.resize(kept_.size());
    const float pixels_a_radian =
        static_cast<float>(size.x) / static_cast<float>(frame.radiance.width) / glm::length(frame.lens.right);
    parallax_ = has_history_ ? pixels_a_radian * glm::distance(frame.lens.eye, before_.eye) : 0.0f;
    samples_.resize(pixels);
    if (out.width != size.x || out.height != size.y) out = Image(size.x, size.y);
    jobs.run(static_cast<std::size_t>(frame.radiance.height),
             [&](std::size_t y, int) { gather_row(frame, static_cast<int>(y)); });
    jobs.run(static_cast<std::size_t>(size.y), [&](std::size_t y, int) {
        for (int x = 0; x < size.x; ++x) {
            const std::size_t i = y * static_cast<std::size_t>(size.x) + static_cast<std::size_t>(x);
            next_[i] = renewed(frame, x, static_cast<int>(y));
            out.pixels[i] = next_[i].color;
        }
    });
    kept_.swap(next_);
    before_ = frame.lens;
    before_size_ = {frame.radiance.width, frame.radiance.height};
    has_history_ = true;
}

}  // namespace gh::filter
