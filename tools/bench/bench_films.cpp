#include "bench_films.h"

#include "app/film_denoiser.h"
#include "base/jobs.h"
#include "figures.h"
#include "filter/enlarge.h"
#include "filter/jitter.h"
#include "filter/tone_map.h"
#include "picture_hash.h"
#include "render/path_tracer.h"
#include "render/prepared.h"
#include "spatial/stage.h"
#include "world/initial_state.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace bench {
namespace {

using namespace gh;

constexpr int kFilmWidth = 640, kFilmHeight = 360;
constexpr std::uint32_t kSteps = 12;

// A brisk walk, turning a little, thirty pictures a second.
render::Camera walked(render::Camera camera, std::uint32_t step) {
    const auto t = static_cast<float>(step);
    const glm::vec3 ahead(-std::sin(camera.yaw), 0.0f, -std::cos(camera.yaw)), right(-ahead.z, 0.0f, ahead.x);
    camera.position += ahead * (0.03f * t) + right * (0.02f * t);
    camera.yaw += 0.006f * t;
    return camera;
}

std::vector<render::Film> walk(const render::SceneView& scene, const render::Camera& start,
                               const Jobs& jobs) {
    std::vector<render::Film> films;
    for (std::uint32_t step = 0; step < kSteps; ++step) {
        render::PathSettings settings = render::realtime_path();
        settings.jitter = filter::halton_jitter(step);
        render::Film film(kFilmWidth, kFilmHeight);
        render::render_path(scene, walked(start, step), settings, step, jobs, film);
        films.push_back(std::move(film));
    }
    return films;
}

// There and back again, so that history always fits.
std::size_t there_and_back(int round) {
    const std::size_t last = kSteps - 1, at = static_cast<std::size_t>(round) % (2 * last);
    return at <= last ? at : 2 * last - at;
}

void bench_denoiser(const char* name, bool halves, const Jobs& jobs, int rounds,
                    std::vector<render::Film>& films) {
    app::FilmDenoiser denoiser;
    filter::Plane unchanged(kFilmWidth, kFilmHeight);  // what paths asked again say of lamps that burn on
    const Samples samples = measure(cpu_ms, rounds, 1, [&](int round) {
        denoiser.denoise(films[there_and_back(round)], jobs,
                         {.halves_indirect = halves, .halves_specular = halves, .adds_up = true}, &unchanged);
    });
    print_row(name, samples, picture_hash(films[there_and_back(rounds - 1)].radiance));
}

}  // namespace

void bench_films(const std::shared_ptr<const world::Level>& level, int threads, int rounds) {
    EXPECTS(!level->viewpoints.empty());
    const Jobs jobs(threads);
    spatial::Stage stage(level);
    const world::Snapshot now = stage.commit(world::initial_state(*level, 1));
    const render::Prepared prepared = render::prepare(*level, now, jobs);
    std::vector<render::Film> films =
        walk({*level, now, prepared}, render::camera_from(level->viewpoints[0]), jobs);

    print_head("filters on path-traced films, 640x360, core-ms");
    bench_denoiser("denoised and added up", false, jobs, rounds, films);
    bench_denoiser("the same, soft light at half the sides", true, jobs, rounds, films);
    filter::Plane3 small, large(2 * kFilmWidth, 2 * kFilmHeight);
    filter::planes_from(films[0].radiance, small);
    print_row("enlarged to 1280x720",
              measure(cpu_ms, rounds, 1, [&](int) { filter::enlarge(small, jobs, large); }));
}

}  // namespace bench
