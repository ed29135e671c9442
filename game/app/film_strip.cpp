#include "app/film_strip.h"

#include "record/picture.h"
#include "world/state.h"

#include <fmt/format.h>

#include <utility>

namespace gh::app {

namespace {

constexpr int kSketchWidth = 64, kSketchHeight = 36;

}  // namespace

FilmStrip::FilmStrip(const ReplayOptions& options, std::optional<render::Environment> sky)
    : options_(options),
      sky_(std::move(sky)),
      view_(options.size.width, options.size.height),
      sketch_(kSketchWidth, kSketchHeight) {}

Result<void> FilmStrip::shoot(const render::SceneView& scene, std::size_t tick, const Jobs& jobs) {
    const std::uint32_t frame = pictures_++;
    const char* const ending = options_.writes_exr ? "exr" : "png";
    const std::filesystem::path path = options_.frames / fmt::format("frame_{:06}.{}", tick, ending);
    const float seconds = static_cast<float>(options_.every) * world::kTickSeconds;
    const bool is_path = options_.renderer.renderer == "path";
    if (!options_.writes_exr || (is_path && !options_.renderer.is_unbiased)) {
        const render::Camera camera = player_camera(scene.snapshot.state.player);
        sketch_.expose(scene, camera, render::WhittedSettings{}, frame, jobs);
        sketch_.adapt(seconds);
    }
    std::error_code error;
    if (std::filesystem::exists(path, error)) return {};
    expose(scene, frame, jobs);
    if (options_.writes_exr) return record::write_exr(path, view_.film().radiance);
    return record::write_png(path, view_.develop_at(sketch_.exposure(), frame, 0.0f, jobs));
}

void FilmStrip::expose(const render::SceneView& scene, std::uint32_t frame, const Jobs& jobs) {
    const render::Camera camera = player_camera(scene.snapshot.state.player);
    if (options_.renderer.renderer != "path") {
        const render::WhittedSettings settings{.samples_per_pixel = options_.samples_per_pixel};
        view_.expose(scene, camera, settings, frame, jobs);
        return;
    }
    render::PathSettings settings =
        path_settings(options_.renderer, options_.samples_per_pixel, sketch_.exposure());
    if (sky_) settings.environment = &*sky_;
    view_.forget();  // a picture that hangs on the ones before could not be made alone
    view_.expose(scene, camera, settings, frame, jobs);
}

}  // namespace gh::app
