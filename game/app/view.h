// app/view.h - from a world to the bytes of a picture: camera, renderer, exposure, glare, tone map, in this order.
#pragma once

#include "app/film_denoiser.h"
#include "app/guided_picture.h"
#include "app/options.h"
#include "app/plane_view.h"
#include "app/reshading.h"
#include "base/image.h"
#include "base/jobs.h"
#include "base/result.h"
#include "filter/glare.h"
#include "render/camera.h"
#include "render/environment.h"
#include "render/film.h"
#include "render/path_tracer.h"
#include "render/whitted.h"
#include "world/level.h"
#include "world/snapshot.h"

#include <glm/vec2.hpp>

#include <cstdint>
#include <optional>
#include <string>

namespace gh::app {

inline constexpr float kPlayerFov = 1.2217305f;  // radians, vertical: 70 degrees

// What the player sees.
[[nodiscard]] render::Camera player_camera(const world::PlayerState& player, float fov_y = kPlayerFov);

// "": the level's first camera, else where the player starts. A name: that camera. Six numbers
// x,y,z,yaw,pitch,fov: metres and degrees.
[[nodiscard]] Result<render::Camera> camera_named(const world::Level& level, const world::Snapshot& snapshot,
                                                  const std::string& text);

// Which surfaces send paths on, of --renderer cook and path; none for whitted, which traces otherwise.
[[nodiscard]] std::optional<render::LightPaths> light_paths(const std::string& renderer);

// A picture's settings for pictures in a row, by those surfaces.
[[nodiscard]] render::PathSettings following(render::PathSettings settings, render::LightPaths lights);

// The lens that --aperture and --focus ask for, on a camera.
[[nodiscard]] render::Camera with_lens(render::Camera camera, const RendererOptions& options);

// Whitted's for a picture by itself. From four samples on, those of a pixel say more than its neighbours', which blur shadows.
[[nodiscard]] render::WhittedSettings whitted_settings(int samples_per_pixel, bool is_adaptive);
// What the command line asks of the path tracer, for an eye of this exposure: --clamp goes by what shows as white.
[[nodiscard]] render::PathSettings path_settings(const RendererOptions& options, int samples_per_pixel,
                                                 float exposure);
// The exposure an eye comes to there, by a small sketch.
[[nodiscard]] float sketched_exposure(const render::SceneView& scene, const render::Camera& camera,
                                      const Jobs& jobs);
// The picture that --sky names; nothing when it names none.
[[nodiscard]] Result<std::optional<render::Environment>> sky_named(const RendererOptions& options);

// One viewer's eye: remembers the exposure it has adapted to.
class View {
  public:
    View(int width, int height) : film_(width, height) {}
    void resize(int width, int height);

    // Fills the film.
    void expose(const render::SceneView& scene, const render::Camera& camera,
                const render::WhittedSettings& settings, std::uint32_t frame, const Jobs& jobs);
    // The same for one of many pictures in a row: lit in few pixels, shown in many, and added up. `forget` begins anew,
    // after a cut.
    void expose_next(const render::SceneView& scene, const render::Camera& camera,
                     render::WhittedSettings settings, std::uint32_t frame, const PictureShape& shape,
                     const Jobs& jobs);
    // By path tracing. Denoised if it fills planes.
    void expose(const render::SceneView& scene, const render::Camera& camera,
                const render::PathSettings& settings, std::uint32_t frame, const Jobs& jobs);
    // The next of many by path tracing, as fast and as clean as it can be: one sample a lit pixel, denoised over the
    // frames.
    void expose_next(const render::SceneView& scene, const render::Camera& camera,
                     render::PathSettings settings, std::uint32_t frame, const PictureShape& shape,
                     const Jobs& jobs);
    void forget() {
        reshading_.forget();
        guided_.forget();
        denoiser_.forget();
    }
    // What was exposed last as a screen shows it. `seconds` since the last picture: the eye adapts, the first time at once. `stops`
    // brightens.
    const Image8& develop(std::uint32_t frame, float seconds, float stops, const Jobs& jobs);

    // Instead of the picture, one of the planes that path tracing left beside it.
    const Image8& develop_plane(PlaneView plane, const Jobs& jobs);

    // The two halves of develop(): the eye adapts to the film; the film as it looks to an eye of this exposure.
    void adapt(float seconds);
    const Image8& develop_at(float exposure, std::uint32_t frame, float stops, const Jobs& jobs);
    [[nodiscard]] float exposure() const { return exposure_; }

    [[nodiscard]] const render::Film& film() const { return film_; }
    // What was exposed last: radiance, of as many pixels as are shown.
    [[nodiscard]] const Image& shown() const { return is_added_up_ ? guided_.picture() : film_.radiance; }
    [[nodiscard]] const Image8& picture() const { return picture_; }

  private:
    void trace(const render::SceneView& scene, const render::Camera& camera,
               const render::PathSettings& settings, std::uint32_t frame, bool adds_up, const Jobs& jobs);
    render::Film film_;
    GuidedPicture guided_;
    bool is_added_up_ = false;  // the last picture is there, not in the film
    FilmDenoiser denoiser_;
    Reshading reshading_;
    filter::Plane change_;
    filter::Pinhole lens_, lens_before_;  // of the last two path-traced pictures
    filter::Glare glare_;
    Image veiled_;
    Image8 picture_;
    float exposure_ = 0.0f;  // 0: none yet
};

}  // namespace gh::app
