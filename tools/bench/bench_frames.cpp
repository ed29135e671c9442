#include "bench_frames.h"

#include "base/jobs.h"
#include "figures.h"
#include "picture_hash.h"
#include "render/whitted.h"
#include "spatial/stage.h"
#include "world/initial_state.h"

namespace bench {
namespace {

using namespace gh;

constexpr std::size_t kCameras = 4;

// One camera's picture, as often as asked for.
void bench_frame(const render::SceneView& view, const world::Viewpoint& viewpoint,
                 const render::WhittedSettings& settings, const Jobs& jobs, int rounds, render::Film& film) {
    const double core_start = cpu_ms();
    const Samples samples = measure(clock_ms, rounds, 1, [&](int) {
        render::render_whitted(view, render::camera_from(viewpoint), settings, 0, jobs, film);
    });
    print_row(viewpoint.name, samples, picture_hash(film.radiance));
    const auto rays = static_cast<double>(film.stats.total());
    std::printf("  (core time %.1f ms a frame; %.2f M rays, %.1f a pixel)\n",
                (cpu_ms() - core_start) / rounds, rays * 1e-6,
                rays / static_cast<double>(film.radiance.pixels.size()));
}

}  // namespace

void bench_frames(const std::shared_ptr<const world::Level>& level, int threads, int rounds) {
    const Jobs jobs(threads);
    spatial::Stage stage(level);
    const world::Snapshot now = stage.commit(world::initial_state(*level, 1));
    const double start = clock_ms();
    const render::Prepared prepared = render::prepare(*level, now, jobs);
    std::printf("\nrender, %d threads; preparing the level took %.0f ms", threads, clock_ms() - start);

    for (const auto& [width, height] : {std::pair(640, 360), std::pair(1280, 720)}) {
        const std::string size = std::to_string(width) + "x" + std::to_string(height);
        for (const bool is_adaptive : {false, true}) {
            const render::WhittedSettings settings{.is_adaptive = is_adaptive};
            print_head(("a Whitted frame, " + std::string(is_adaptive ? "adaptive, " : "every pixel, ") +
                        "wall time, " + size)
                           .c_str());
            const std::size_t count = std::min(kCameras, level->viewpoints.size());
            for (std::size_t i = 0; i < count; ++i) {
                const world::Viewpoint& viewpoint = level->viewpoints[i * level->viewpoints.size() / count];
                render::Film film(width, height);
                bench_frame({*level, now, prepared}, viewpoint, settings, jobs, rounds, film);
            }
        }
    }
}

}  // namespace bench
