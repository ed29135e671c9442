#include "app/film_strip.h"

#include "base/det_math.h"
#include "record/picture.h"
#include "world/state.h"

#include <fmt/format.h>
#include <glm/geometric.hpp>

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
    const bool is_path = light_paths(options_.renderer.renderer).has_value();
    if (!options_.writes_exr || (is_path && !options_.renderer.is_unbiased)) {
        const render::Camera camera = player_camera(scene.snapshot.state.player);
        sketch_.expose(scene, camera, render::WhittedSettings{}, frame, jobs);
        sketch_.adapt(seconds);
    }
    const render::Camera camera = with_lens(player_camera(scene.snapshot.state.player), options_.renderer);
    const render::Camera opened = shutter_opens(camera);
    last_ = camera;
    std::error_code error;
    if (std::filesystem::exists(path, error)) return {};
    expose(scene, camera, opened, frame, jobs);
    if (options_.writes_exr) return record::write_exr(path, view_.film().radiance);
    return record::write_png(path, view_.develop_at(sketch_.exposure(), frame, 0.0f, jobs));
}

// Where the eye is when the shutter opens, on the straight way from where it was a picture ago. A leap to a checkpoint is
// a cut.
render::Camera FilmStrip::shutter_opens(const render::Camera& camera) const {
    constexpr float kLeap = 2.0f;  // metres
    render::Camera opened = camera;
    if (!last_ || glm::distance(last_->position, camera.position) > kLeap) return opened;
    const float back = options_.renderer.shutter;
    opened.position += (last_->position - camera.position) * back;
    opened.yaw += wrap_angle(last_->yaw - camera.yaw) * back;
    opened.pitch += (last_->pitch - camera.pitch) * back;
    opened.roll += (last_->roll - camera.roll) * back;
    return opened;
}

void FilmStrip::expose(const render::SceneView& scene, const render::Camera& camera,
                       const render::Camera& opened, std::uint32_t frame, const Jobs& jobs) {
    if (!light_paths(options_.renderer.renderer)) {
        const render::WhittedSettings settings = whitted_settings(options_.samples_per_pixel, false);
        const bool is_even = options_.size.width % 2 == 0 && options_.size.height % 2 == 0;
        if (options_.samples_per_pixel == 1 && is_even && !options_.writes_exr)
            return look_four_times(scene, camera, settings, frame, jobs);
        view_.expose(scene, camera, settings, frame, jobs);
        return;
    }
    render::PathSettings settings =
        path_settings(options_.renderer, options_.samples_per_pixel, sketch_.exposure());
    if (sky_) settings.environment = &*sky_;
    if (options_.renderer.shutter > 0.0f) settings.shutter_from = &opened;
    view_.forget();  // a picture that hangs on the ones before could not be made alone
    view_.expose(scene, camera, settings, frame, jobs);
}

// As the window shows a world at rest: four looks through each pixel, one of which is lit.
void FilmStrip::look_four_times(const render::SceneView& scene, const render::Camera& camera,
                                const render::WhittedSettings& settings, std::uint32_t frame,
                                const Jobs& jobs) {
    const PictureShape half{{options_.size.width / 2, options_.size.height / 2}, 2};
    view_.forget();
    for (std::uint32_t look = 0; look < 4; ++look)
        view_.expose_next(scene, camera, settings, 4 * frame + look, half, jobs);
}

}  // namespace gh::app
