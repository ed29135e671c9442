#include "render/tile.h"

#include "base/contracts.h"
#include "base/det_math.h"
#include "render/sky.h"
#include "world/layers.h"

#include "raycore/query.h"

#include <glm/geometric.hpp>

#include <algorithm>

namespace gh::render {

namespace {

constexpr float kGlimmerTaps = 2.0f;
constexpr std::size_t kIndicesAhead = 32, kCornersAhead = 20;  // hits whose memory is asked for

}  // namespace

void TileTracer::begin(int tile_x, int tile_y) {
    x_ = tile_x * kTileSide;
    y_ = tile_y * kTileSide;
    columns_ = std::min(kTileSide, frame_.width - x_);
    rows_ = std::min(kTileSide, frame_.height - y_);
    pixels_.assign(static_cast<std::size_t>(columns_ * rows_), {});
    samplers_.clear();
    sample_ = 0;
}

std::size_t TileTracer::picture_index(std::uint16_t pixel) const {
    const int x = x_ + pixel % columns_, y = y_ + pixel / columns_;
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(frame_.width) + static_cast<std::size_t>(x);
}

void TileTracer::trace(int tile_x, int tile_y, std::vector<PixelLight>& pixels, FrameStats& stats) {
    begin(tile_x, tile_y);
    for (int i = 0; i < columns_ * rows_; ++i) {
        samplers_.push_back(pixel_sampler(x_ + i % columns_, y_ + i / columns_, frame_.number,
                                          frame_.settings.shares_samples));
    }
    looks_.begin(frame_.view.level.lamps.size());
    across_ = TileLattice(columns_);
    down_ = TileLattice(rows_);
    const int samples = frame_.settings.samples_per_pixel;
    for (sample_ = 0; sample_ < samples; ++sample_) trace_sample(stats);
    const float per_sample = 1.0f / static_cast<float>(samples);
    for (std::size_t i = 0; i < pixels_.size(); ++i) {
        PixelLight& light = pixels_[i];
        light.clean *= per_sample;
        light.shared.unshadowed *= per_sample;
        light.shared.arrived *= per_sample;
        pixels[picture_index(static_cast<std::uint16_t>(i))] = light;
    }
}

void TileTracer::look_at(int tile_x, int tile_y, const std::vector<std::uint16_t>& which,
                         const std::vector<rc::Hit>& hits) {
    EXPECTS(which.size() == hits.size());
    begin(tile_x, tile_y);
    now_.clear();
    for (const std::uint16_t pixel : which) add_primary_ray(pixel);
    hits_ = hits;
    FrameStats stats;
    shade_generation(stats);
    trace_all(stats);
    for (const std::uint16_t pixel : which)
        frame_.guide->clean.pixels[picture_index(pixel)] = pixels_[pixel].clean;
}

void TileTracer::trace_sample(FrameStats& stats) {
    main_.clear(pixels_.size());
    add_primary_rays();
    stats.primary_rays += now_.size();
    trace_all(stats);
    main_.begin_light();
    light_main_surfaces(stats);
    reflect_main_surfaces(stats);
    add_main_light();
}

// The rays of now_ and all that come of them.
void TileTracer::trace_all(FrameStats& stats) {
    while (!now_.empty()) {
        trace_generation();
        shade_generation(stats);
    }
}

// The first sample of one goes through the middle, so that a still world stands still; more spread over the pixel.
void TileTracer::add_primary_rays() {
    now_.clear();
    for (std::size_t i = 0; i < pixels_.size(); ++i) add_primary_ray(static_cast<std::uint16_t>(i));
}

void TileTracer::add_primary_ray(std::uint16_t pixel) {
    PathRay path;
    path.ray = frame_.lens.ray(pixel_point(x_ + pixel % columns_, y_ + pixel / columns_));
    path.from = path.ray.origin;
    path.cone_angle = frame_.lens.pixel_angle();
    path.pixel = pixel;
    now_.push_back(path);
}

// Where this sample's ray goes through the pixel.
glm::vec2 TileTracer::pixel_point(int x, int y) const {
    glm::vec2 at = glm::vec2(0.5f) + frame_.settings.jitter;
    if (frame_.settings.samples_per_pixel > 1) {
        at = sobol_point(static_cast<std::uint32_t>(sample_),
                         hash_u32(static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y),
                                  0xA11A5u + frame_.settings.places));
    }
    return glm::vec2(static_cast<float>(x), static_cast<float>(y)) + at;
}

void TileTracer::trace_generation() {
    rays_.clear();
    for (const PathRay& path : now_) rays_.push_back(path.ray);
    hits_.resize(rays_.size());
    rc::closest_hits(*frame_.view.snapshot.scene, rays_, world::Light, hits_);
}

// What rays of now_ met, and the shadows there; now_ is then what came of them.
void TileTracer::shade_generation(FrameStats& stats) {
    for (std::size_t i = 0; i < now_.size(); i += kPatches)
        shade_together(i, std::min(i + kPatches, now_.size()), stats);
    light_glimmers();
    trace_shadows(stats);
    now_.swap(next_);
    next_.clear();
    if (frame_.guide == nullptr) return;
    colors_.flush();
    std::erase_if(now_, [](const PathRay& path) { return !path.is_leading; });
}

// What rays `begin` to `end` met: their textures are looked up side by side, each finds its memory on its way.
void TileTracer::shade_together(std::size_t begin, std::size_t end, FrameStats& stats) {
    std::array<PointAsked, kPatches> asked;
    std::array<ShadingPoint, kPatches> points;
    std::array<bool, kPatches> is_noted{};
    const float taps = frame_.settings.texture_taps;
    std::size_t count = 0;
    for (std::size_t i = begin; i < end; ++i) {
        if (i + kIndicesAhead < hits_.size()) fetch_indices(frame_.view, hits_[i + kIndicesAhead]);
        if (i + kCornersAhead < hits_.size()) fetch_corners(frame_.view, hits_[i + kCornersAhead]);
        PathRay& path = now_[i];
        const rc::Hit& hit = hits_[i];
        if (hit.is_miss()) continue;
        path.cone_width += path.cone_angle * hit.t;
        path.length += hit.t;
        is_noted[i - begin] = frame_.guide != nullptr && note_plain(path, hit);
        if (is_noted[i - begin]) continue;
        asked[count++] = {&path.ray, &hit, path.cone_width * frame_.settings.texture_blur,
                          path.is_leading ? taps : std::min(kGlimmerTaps, taps)};
    }
    shading_points(frame_.view, std::span(asked).first(count), std::span(points).first(count));
    for (std::size_t i = begin, met = 0; i < end; ++i) {
        if (hits_[i].is_miss()) {
            shade_miss(now_[i]);
        } else if (!is_noted[i - begin]) {
            shade(now_[i], hits_[i], points[met++], stats);
        }
    }
}

void TileTracer::trace_shadows(FrameStats& stats) {
    shares_.resize(shadow_rays_.size());
    batch_.answer(frame_.view, shadow_rays_, shares_);
    stats.shadow_rays += shadow_rays_.size();
    stats.glass_shadow_rays += batch_.looked_through();
    for (std::size_t i = 0; i < shadows_.size(); ++i) {
        const Shadow& shadow = shadows_[i];
        light_of(shadow.pixel, shadow.share) += shadow.light * shares_[i];
        if (shadow.share == Share::Neighbours && shadow.lamp != world::kNoIndex)
            looks_.note(shadow.lamp, shares_[i].y);
    }
    shadow_rays_.clear();
    shadows_.clear();
}

void TileTracer::shade_miss(const PathRay& path) {
    shine(path, path.weight * sky_radiance(frame_.light.sun, path.ray.direction));
}

void TileTracer::shade(PathRay& path, const rc::Hit& hit, const ShadingPoint& at, FrameStats& stats) {
    if (const world::Material* glass = path.media.top(); glass != nullptr) {
        path.weight *= absorbed(*glass, glm::distance(path.from, at.surface.position));
    }
    path.from = at.surface.position;
    if (pass_through_hole(path, at, stats)) return;

    if (frame_.light.emission_on[at.part] != 0) {
        const bool is_bulb = frame_.view.prepared.parts[at.part].lamp != world::kNoIndex;
        shine(path, path.weight * at.emission * (is_bulb ? path.bulb_share : 1.0f));
    }
    const float clear = at.transmission * (1.0f - at.metallic);
    if (clear > 0.0f) {
        PathRay part = path;
        part.weight *= clear;
        part.is_leading = path.is_leading && clear >= 0.5f;
        shade_glass(part, at, stats);
    }
    if (clear < 1.0f) {
        path.weight *= 1.0f - clear;
        path.is_leading = path.is_leading && clear < 0.5f;
        shade_opaque(path, at, hit, stats);
    }
}

// Cut-out and blended materials let the ray go on; true if that is all it does. Otherwise `path` keeps what is left.
bool TileTracer::pass_through_hole(PathRay& path, const ShadingPoint& at, FrameStats& stats) {
    float covered = 1.0f;
    if (at.material->alpha_mode == world::AlphaMode::Mask)
        covered = at.alpha < at.material->alpha_cutoff ? 0.0f : 1.0f;
    if (at.material->alpha_mode == world::AlphaMode::Blend) covered = std::clamp(at.alpha, 0.0f, 1.0f);
    if (covered == 1.0f) return false;
    if (path.passes < kMostPasses) {
        PathRay onward = path;
        onward.ray = rc::spawn_ray(at.surface, path.ray.direction);
        onward.weight *= 1.0f - covered;
        onward.passes = static_cast<std::uint8_t>(path.passes + 1);
        onward.is_leading = path.is_leading && covered < 0.5f;
        next_.push_back(onward);
        ++stats.refracted_rays;
    }
    path.weight *= covered;
    path.is_leading = path.is_leading && covered >= 0.5f;
    return covered == 0.0f;
}

glm::vec3& TileTracer::light_of(std::uint16_t pixel, Share share) {
    switch (share) {
        case Share::Neighbours:
            return main_.found_at(pixel).arrived;
        case Share::Reflection:
            return main_.reflections[main_.at_pixel[pixel]];
        case Share::Pixel:
            break;
    }
    return pixels_[pixel].clean;
}

}  // namespace gh::render
