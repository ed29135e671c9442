// The part of a tile that sends rays and gathers what comes of them.
#include "base/random.h"
#include "render/clear_way.h"
#include "render/path_choices.h"
#include "render/path_tile.h"
#include "world/layers.h"

#include "raycore/query.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

namespace gh::render {

namespace {

// Hits that are made ready for shading side by side, while memory of those that follow is asked for.
constexpr std::size_t kTogether = 16;
constexpr float kIndirectTaps = 1.0f;  // of textures, where they are seen by scattered light
constexpr std::uint32_t kPathsTogether =
    1024;  // at least, where there are that many samples: what rays in a batch share

}  // namespace

template <unsigned kFeatures>
void PathTile<kFeatures>::trace(int tile_x, int tile_y, Film& film, FrameStats& stats) {
    film_ = &film;
    x_ = tile_x * kPathTileSide;
    y_ = tile_y * kPathTileSide;
    columns_ = std::min(kPathTileSide, frame_.width - x_);
    rows_ = std::min(kPathTileSide, frame_.height - y_);
    const auto pixels = static_cast<std::uint32_t>(columns_ * rows_);
    sums_.assign(pixels, {});
    begin_planes();
    const auto samples = static_cast<std::uint32_t>(frame_.settings.samples_per_pixel);
    samples_.begin({frame_.settings.sampler, samples, frame_.settings.seed}, x_, y_, columns_, rows_,
                   frame_.number);

    const std::uint32_t most = std::max(1u, kPathsTogether / pixels);
    std::uint32_t together = 0;
    for (std::uint32_t sample = 0; sample < samples; sample += together) {
        // The planes tell of what the first sample sees: the others are compared with that.
        together = kHasPlanes && sample == 0 ? 1u : std::min(most, samples - sample);
        add_eye_paths(sample, together);
        stats.primary_rays += now_.size();
        while (!now_.empty()) {
            trace_generation(stats);
            trace_shadows(stats);
            now_.swap(next_);
            next_.clear();
        }
    }
    for (std::uint16_t i = 0; i < pixels; ++i) {
        const auto channel = [&](Channel which) {
            return glm::vec3(sums_[i].light[static_cast<std::size_t>(which)] / static_cast<double>(samples));
        };
        const glm::vec3 direct = channel(Channel::Direct), indirect = channel(Channel::Indirect);
        const glm::vec3 specular = channel(Channel::Specular) + channel(Channel::Mirrored);
        const glm::ivec2 at = film_pixel(i);
        film.radiance.at(at.x, at.y) = direct + indirect + specular + channel(Channel::Clean);
        if (!kHasPlanes || !frame_.settings.fills_planes) continue;
        note_light(i, samples);
    }
}

template <unsigned kFeatures>
bool PathTile<kFeatures>::is_asked(int pixel) const {
    const glm::ivec2& first = frame_.settings.first;
    const int every = frame_.settings.every;
    return (x_ + pixel % columns_) % every == first.x && (y_ + pixel / columns_) % every == first.y;
}

template <unsigned kFeatures>
void PathTile<kFeatures>::add_eye_paths(std::uint32_t first_sample, std::uint32_t count) {
    now_.clear();
    for (std::uint32_t sample = first_sample; sample < first_sample + count; ++sample) {
        for (int i = 0; i < columns_ * rows_; ++i) {
            if (!is_asked(i)) continue;
            Path path;
            path.sample = sample;
            path.pixel = static_cast<std::uint16_t>(i);
            path.ray = eye_ray(path);
            path.start = path.ray.origin;
            path.cone_angle = frame_.lens.pixel_angle();
            now_.push_back(path);
        }
    }
}

// Where in the picture the sample lies: by the reconstruction filter's shape, which weighs every sample alike (Ernst et
// al. 2006).
template <unsigned kFeatures>
glm::vec2 PathTile<kFeatures>::picture_point(const Path& path) {
    const glm::vec2 pixel(glm::ivec2(x_ + path.pixel % columns_, y_ + path.pixel / columns_));
    if (!frame_.settings.jitters) return pixel + frame_.settings.jitter + glm::vec2(0.5f);
    return pixel +
           filter_point(frame_.settings.filter, samples_.two(path.pixel, path.sample, kPixelDimension));
}

template <unsigned kFeatures>
rc::Ray PathTile<kFeatures>::eye_ray(const Path& path) {
    const glm::vec2 point = picture_point(path);
    if (frame_.settings.shutter_from == nullptr) {
        if (!frame_.lens.has_aperture()) return frame_.lens.ray(point);
        return frame_.lens.ray(point, samples_.two(path.pixel, path.sample, kApertureDimension));
    }
    const float time = samples_.one(path.pixel, path.sample, kShutterDimension);
    return between(frame_.lens_before, frame_.lens, time)
        .ray(point, samples_.two(path.pixel, path.sample, kApertureDimension));
}

template <unsigned kFeatures>
void PathTile<kFeatures>::trace_generation(FrameStats& stats) {
    rays_.clear();
    for (const Path& path : now_) {
        rays_.push_back(path.ray);
        note_ray(path.pixel);
    }
    hits_.resize(rays_.size());
    rc::closest_hits(*frame_.view.snapshot.scene, rays_, world::Light, hits_);
    for (std::size_t i = 0; i < now_.size(); i += kTogether) {
        const std::size_t end = std::min(i + kTogether, now_.size());
        const std::size_t far = std::min(end + kTogether, now_.size());
        for (std::size_t k = far; k < std::min(far + kTogether, now_.size()); ++k)
            fetch_indices(frame_.view, hits_[k]);
        for (std::size_t k = end; k < far; ++k) fetch_corners(frame_.view, hits_[k]);
        meet_together(i, end, stats);
    }
}

template <unsigned kFeatures>
void PathTile<kFeatures>::meet_together(std::size_t begin, std::size_t end, FrameStats& stats) {
    std::array<PointAsked, kTogether> asked;
    std::array<ShadingPoint, kTogether> points;
    std::size_t count = 0;
    for (std::size_t i = begin; i < end; ++i) {
        if (hits_[i].is_miss()) continue;
        Path& path = now_[i];
        path.cone_width += path.cone_angle * hits_[i].t;
        const float taps = path.is_eye ? frame_.settings.texture_taps
                                       : std::min(kIndirectTaps, frame_.settings.texture_taps);
        asked[count++] = {&path.ray, &hits_[i], path.cone_width * frame_.settings.texture_blur, taps};
    }
    shading_points(frame_.view, std::span(asked).first(count), std::span(points).first(count));
    for (std::size_t i = begin, met = 0; i < end; ++i) {
        add_bare_lamps(now_[i], hits_[i].is_miss() ? rc::kInfinity : hits_[i].t);
        if (hits_[i].is_miss()) {
            meet_nothing(now_[i]);
        } else {
            meet(now_[i], hits_[i], points[met++], stats);
        }
    }
}

// Half to three quarters of all rays meet something opaque on their way, and need not know what. The others ask what they
// meet of what is clear, and then of the lamp.
template <unsigned kFeatures>
void PathTile<kFeatures>::trace_shadows(FrameStats& stats) {
    stats.shadow_rays += shadow_rays_.size();
    for (const Shadow& shadow : shadows_) note_ray(shadow.pixel);
    is_blocked_.resize(shadow_rays_.size());
    rc::any_hits(*frame_.view.snapshot.scene, shadow_rays_, frame_.view.prepared.blocking_layers,
                 is_blocked_);
    in_the_way_.assign(shadow_rays_.size(), {});
    if constexpr (kHasClear) look_through(stats);
    look_for_targets();
    for (std::size_t i = 0; i < shadows_.size(); ++i) {
        if (is_blocked_[i] == 0) settle(shadows_[i], shadow_rays_[i], in_the_way_[i], stats);
    }
    shadow_rays_.clear();
    shadows_.clear();
}

// Of the rays that nothing opaque blocks, which meet something clear; of a level that does not say which parts are opaque,
// whatever blocks them.
template <unsigned kFeatures>
void PathTile<kFeatures>::look_through(FrameStats& stats) {
    if (!frame_.view.prepared.has_clear_parts) return;
    const bool is_split = frame_.view.prepared.blocking_layers == world::Blocker;
    left_.clear();
    left_index_.clear();
    for (std::size_t i = 0; i < shadow_rays_.size(); ++i) {
        if ((is_blocked_[i] != 0) == is_split) continue;
        left_.push_back(shadow_rays_[i]);
        left_index_.push_back(i);
        is_blocked_[i] = 0;
    }
    stats.glass_shadow_rays += left_.size();
    ask_left(is_split ? world::Clear : world::Light);
}

// The rays that have nothing in their way go on to what they look for.
template <unsigned kFeatures>
void PathTile<kFeatures>::look_for_targets() {
    left_.clear();
    left_index_.clear();
    for (std::size_t i = 0; i < shadow_rays_.size(); ++i) {
        if (shadows_[i].target_part == world::kNoIndex) continue;
        rc::Ray& ray = shadow_rays_[i];
        if (is_blocked_[i] == 0 && in_the_way_[i].is_miss()) {
            left_.push_back(ray);
            left_.back().t_min = ray.t_max;
            left_.back().t_max = shadows_[i].reach;
            left_index_.push_back(i);
        }
        ray.t_max = rc::kInfinity;
    }
    ask_left(world::Light);
}

template <unsigned kFeatures>
void PathTile<kFeatures>::ask_left(rc::LayerMask layers) {
    hits_.resize(left_.size());
    rc::closest_hits(*frame_.view.snapshot.scene, left_, layers, hits_);
    for (std::size_t i = 0; i < left_.size(); ++i) in_the_way_[left_index_[i]] = hits_[i];
}

template <unsigned kFeatures>
void PathTile<kFeatures>::settle(const Shadow& shadow, const rc::Ray& ray, const rc::Hit& hit,
                                 FrameStats& stats) {
    rc::Hit end = hit;
    glm::vec3 light(1.0f);
    const bool has_target = shadow.target_part != world::kNoIndex;
    const bool is_clear = kHasClear && !hit.is_miss() && frame_.view.prepared.parts[hit.instance].is_clear;
    if ((is_clear && hit.instance != shadow.target_part) || shadow.inside != nullptr) {
        if (has_target) ++stats.glass_shadow_rays;
        const ClearWay way = follow(frame_.view, ray, hit,
                                    {.passes_solid_glass = frame_.settings.caustics == Caustics::Unbent,
                                     .target = shadow.target_part,
                                     .inside = shadow.inside,
                                     .start = shadow.start});
        light = way.share;
        end = way.end;
    }
    if (has_target) {
        const bool is_it =
            !end.is_miss() && end.instance == shadow.target_part &&
            (shadow.target_primitive == world::kNoIndex || shadow.target_primitive == end.primitive);
        if (!is_it) return;
        light *= frame_.lights.emission_at(end, ray.direction);
    } else if (!end.is_miss()) {
        return;
    }
    add(shadow.pixel, shadow.diffuse_channel, shadow.diffuse * light, shadow.is_indirect, shadow.is_beside);
    add(shadow.pixel, shadow.gloss_channel, shadow.gloss * light, shadow.is_indirect, shadow.is_beside);
}

// What is not a number is nobody's light: it would spoil the pixel for good.
template <unsigned kFeatures>
void PathTile<kFeatures>::add(std::uint16_t pixel, Channel channel, const glm::vec3& light, bool is_indirect,
                              bool is_beside) {
    const float most = std::max({light.x, light.y, light.z});
    if (!(most > 0.0f) || !(light.x + light.y + light.z < rc::kInfinity)) return;
    float scale = 1.0f;
    if (is_indirect && most > frame_.settings.most_indirect) scale = frame_.settings.most_indirect / most;
    sums_[pixel].light[static_cast<std::size_t>(channel)] += glm::dvec3(light * scale);
    if (kHasPlanes && is_beside)
        beside_[pixel].light[static_cast<std::size_t>(channel)] += glm::dvec3(light * scale);
}

template <unsigned kFeatures>
glm::ivec2 PathTile<kFeatures>::film_pixel(std::uint16_t pixel) const {
    return {x_ + pixel % columns_, y_ + pixel / columns_};
}

template <unsigned kFeatures>
std::uint32_t PathTile<kFeatures>::dimension(const Path& path, std::uint32_t purpose) const {
    return purpose + 16u * (path.depth + 1u) + (std::uint32_t{path.passes} << 12) + (path.branch << 20);
}

}  // namespace gh::render
