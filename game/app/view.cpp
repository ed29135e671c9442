#include "app/view.h"

#include "filter/jitter.h"
#include "filter/tone_map.h"
#include "record/picture.h"
#include "world/eye.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <utility>

namespace gh::app {

namespace {

constexpr float kClamp = 2.0f;         // multiples of white, as RendererOptions has it
constexpr float kMostVeiling = 40.0f;  // multiples of white
constexpr std::size_t kFine =
    640 * 360;  // pixels: soft light of such pictures in a row is filtered at half their sides
constexpr float kDegree = 0.017453293f;
constexpr float kLeanRoll = 0.06f;  // radians at a full lean

// Exactly six numbers with commas between them.
bool read_numbers(const std::string& text, std::array<float, 6>& numbers) {
    const char* at = text.data();
    const char* const end = at + text.size();
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        const auto [rest, error] = std::from_chars(at, end, numbers[i]);
        if (error != std::errc() || !std::isfinite(numbers[i])) return false;
        const bool is_last = i + 1 == numbers.size();
        if (is_last ? rest != end : rest == end || *rest != ',') return false;
        at = rest + 1;
    }
    return true;
}

bool switches_lamps(const render::SceneView& scene) {
    return scene.before != nullptr && scene.before->state.group_on != scene.snapshot.state.group_on;
}

}  // namespace

render::Camera player_camera(const world::PlayerState& player, float fov_y) {
    return {.position = world::eye_of(player),
            .yaw = world::radians_from_turn(player.yaw),
            .pitch = world::radians_from_turn(player.pitch),
            .roll = -player.lean * kLeanRoll,
            .fov_y = fov_y};
}

Result<render::Camera> camera_named(const world::Level& level, const world::Snapshot& snapshot,
                                    const std::string& text) {
    if (text.empty()) {
        return level.viewpoints.empty() ? player_camera(snapshot.state.player)
                                        : render::camera_from(level.viewpoints[0]);
    }
    for (const world::Viewpoint& viewpoint : level.viewpoints) {
        if (viewpoint.name == text) return render::camera_from(viewpoint);
    }
    std::array<float, 6> n{};
    if (read_numbers(text, n)) {
        if (!(n[5] > 0.0f && n[5] < 179.0f))
            return Error{"--camera: the field of view " + text + " ends in is not between 0 and 179 degrees"};
        return render::Camera{.position = {n[0], n[1], n[2]},
                              .yaw = n[3] * kDegree,
                              .pitch = n[4] * kDegree,
                              .fov_y = n[5] * kDegree};
    }
    std::string known;
    for (const world::Viewpoint& viewpoint : level.viewpoints)
        known += (known.empty() ? "" : ", ") + viewpoint.name;
    return Error{level.name + ": there is no camera '" + text + "'" +
                 (known.empty() ? "; it has none" : "; it has " + known) +
                 ", and it is not x,y,z,yaw,pitch,fov"};
}

std::optional<render::LightPaths> light_paths(const std::string& renderer) {
    if (renderer == "path") return render::LightPaths::All;
    if (renderer == "cook") return render::LightPaths::Glossy;
    return std::nullopt;
}

render::PathSettings following(render::PathSettings settings, render::LightPaths lights) {
    settings.lights = lights;
    if (lights == render::LightPaths::Glossy) settings.ends_in_bake = settings.seeks_gleams = false;
    return settings;
}

render::Camera with_lens(render::Camera camera, const RendererOptions& options) {
    camera.aperture = options.aperture;
    camera.focus = options.focus;
    return camera;
}

render::WhittedSettings whitted_settings(int samples_per_pixel, bool is_adaptive) {
    constexpr int kEnough = 4;
    return {.samples_per_pixel = samples_per_pixel,
            .shares_samples = is_adaptive || samples_per_pixel < kEnough,
            .is_adaptive = is_adaptive};
}

render::PathSettings path_settings(const RendererOptions& options, int samples_per_pixel, float exposure) {
    const bool is_cook = light_paths(options.renderer) == render::LightPaths::Glossy;
    render::PathSettings settings = is_cook ? render::cook_path() : render::PathSettings();
    settings.samples_per_pixel = samples_per_pixel;
    if (!is_cook) settings.max_depth = options.max_depth;
    settings.seed = options.seed;
    settings.sampler = options.sampler == "iid"         ? render::SampleKind::Iid
                       : options.sampler == "jittered"  ? render::SampleKind::Jittered
                       : options.sampler == "bluenoise" ? render::SampleKind::BlueNoise
                                                        : render::SampleKind::Sobol;
    if (options.filter == "box") settings.filter = render::PixelFilter::Box;
    if (options.filter == "tent") settings.filter = render::PixelFilter::Tent;
    if (options.filter == "gaussian") settings.filter = render::PixelFilter::Gaussian;
    if (!options.bends_light) settings.caustics = render::Caustics::Unbent;
    if (!options.is_unbiased) {
        if (options.clamp > 0.0f) settings.most_indirect = options.clamp / exposure;
        settings.least_indirect_roughness = options.least_indirect_roughness;
    }
    settings.fills_planes = settings.splits_glass = options.is_denoised;
    return settings;
}

float sketched_exposure(const render::SceneView& scene, const render::Camera& camera, const Jobs& jobs) {
    View sketch(64, 36);
    sketch.expose(scene, camera, render::WhittedSettings{}, 0, jobs);
    sketch.adapt(0.0f);
    return sketch.exposure();
}

Result<std::optional<render::Environment>> sky_named(const RendererOptions& options) {
    if (options.sky.empty()) return std::optional<render::Environment>();
    auto picture = record::read_picture(options.sky);
    if (!picture) return picture.error();
    return std::optional<render::Environment>(std::in_place, *std::move(picture));
}

void View::resize(int width, int height) {
    if (film_.radiance.width != width || film_.radiance.height != height) film_ = render::Film(width, height);
}

void View::expose(const render::SceneView& scene, const render::Camera& camera,
                  const render::WhittedSettings& settings, std::uint32_t frame, const Jobs& jobs) {
    render::render_whitted(scene, camera, settings, frame, jobs, film_);
    is_added_up_ = false;
}

void View::expose_next(const render::SceneView& scene, const render::Camera& camera,
                       render::WhittedSettings settings, std::uint32_t frame, const PictureShape& shape,
                       const Jobs& jobs) {
    resize(shape.lit.x, shape.lit.y);
    if (switches_lamps(scene)) guided_.forget();  // found out by samples alone, it takes five pictures
    settings.jitter = guided_.begin(scene, camera, settings, frame, shape, jobs);
    settings.texture_blur = GuidedPicture::texture_blur(shape);
    settings.is_adaptive = settings.is_adaptive && shape.step == 1;  // few pixels have little between them
    expose(scene, camera, settings, frame, jobs);
    guided_.add(film_.radiance, jobs);
    is_added_up_ = true;
}

void View::expose(const render::SceneView& scene, const render::Camera& camera,
                  const render::PathSettings& settings, std::uint32_t frame, const Jobs& jobs) {
    trace(scene, camera, settings, frame, false, jobs);
}

void View::trace(const render::SceneView& scene, const render::Camera& camera,
                 const render::PathSettings& settings, std::uint32_t frame, bool adds_up, const Jobs& jobs) {
    if (settings.fills_planes) reshading_.ask_again(scene, jobs, change_);
    render::render_path(scene, camera, settings, frame, jobs, film_);
    is_added_up_ = false;
    if (!settings.fills_planes) return;
    reshading_.note(camera, settings, frame, film_);
    lens_before_ = lens_;
    lens_ = {film_.planes.eye, film_.planes.corner, film_.planes.right, film_.planes.down};
    const bool is_fine = adds_up && film_.radiance.pixels.size() >= kFine;
    filter::DenoiseSettings filtering{
        .halves_indirect = is_fine, .halves_specular = is_fine, .adds_up = adds_up};
    // A firefly is what stands out and is brighter than four times white.
    filtering.mend.floor = std::min(filtering.mend.floor, 4.0f / kClamp * settings.most_indirect);
    denoiser_.denoise(film_, jobs, filtering, &change_);
}

void View::expose_next(const render::SceneView& scene, const render::Camera& camera,
                       render::PathSettings settings, std::uint32_t frame, const PictureShape& shape,
                       const Jobs& jobs) {
    resize(shape.lit.x, shape.lit.y);
    if (exposure_ > 0.0f) settings.most_indirect = kClamp / exposure_;
    if (shape.step == 1) {  // every pixel brings along what a guide would say
        guided_.forget();
        settings.jitter = filter::halton_jitter(frame);
        trace(scene, camera, settings, frame, true, jobs);
        return;
    }
    const render::WhittedSettings looks{.texture_taps = settings.texture_taps, .guides_lamps = false};
    settings.jitter = guided_.begin(scene, camera, looks, frame, shape, jobs);
    settings.texture_blur = GuidedPicture::texture_blur(shape);
    trace(scene, camera, settings, frame, false, jobs);
    guided_.add(film_.radiance, jobs);
    is_added_up_ = true;
}

const Image8& View::develop(std::uint32_t frame, float seconds, float stops, const Jobs& jobs) {
    adapt(seconds);
    return develop_at(exposure_, frame, stops, jobs);
}

const Image8& View::develop_plane(PlaneView plane, const Jobs& jobs) {
    const filter::Denoiser& denoiser = denoiser_.denoiser();
    paint_plane(plane, {film_.planes, denoiser.variance(), denoiser.history_length(), lens_before_},
                exposure_, jobs, picture_);
    return picture_;
}

void View::adapt(float seconds) {
    exposure_ = exposure_ == 0.0f ? filter::metered_exposure(shown())
                                  : filter::adapted_exposure(shown(), exposure_, seconds);
}

const Image8& View::develop_at(float exposure, std::uint32_t frame, float stops, const Jobs& jobs) {
    const float brightened = exposure * std::exp2(stops);
    glare_.veil(shown(), {.most = kMostVeiling / brightened}, jobs, veiled_);
    filter::tone_map(veiled_, brightened, frame, jobs, picture_);
    return picture_;
}

}  // namespace gh::app
