#include "bench_window.h"

#include "app/guided_picture.h"
#include "app/quality.h"
#include "base/jobs.h"
#include "figures.h"
#include "picture_hash.h"
#include "render/whitted.h"
#include "spatial/stage.h"
#include "world/initial_state.h"

#include <algorithm>
#include <string>

namespace bench {
namespace {

using namespace gh;

constexpr std::size_t kWindowCameras = 4;

struct WindowStages {
    Samples guide, light, put_together;
};

template <class Work>
void add_time(Samples& stage, const Work& work) {
    const double start = cpu_ms();
    work();
    stage.ms.push_back(cpu_ms() - start);
}

// One camera's pictures in a row: a round's answer depends on those before, so all start from none.
void bench_view(const render::SceneView& scene, const world::Viewpoint& viewpoint,
                const app::PictureShape& shape, const Jobs& jobs, int rounds) {
    const render::Camera camera = render::camera_from(viewpoint);
    const render::WhittedSettings quality = app::quality_of(present::QualityName::Medium).whitted;
    app::GuidedPicture pictures;
    render::Film film(shape.lit.x, shape.lit.y);
    WindowStages stages;
    for (int round = 0; round < rounds; ++round) {
        const auto frame = static_cast<std::uint32_t>(round);
        render::WhittedSettings settings = quality;
        settings.is_adaptive = false;
        add_time(stages.guide,
                 [&] { settings.jitter = pictures.begin(scene, camera, quality, frame, shape, jobs); });
        settings.texture_blur = app::GuidedPicture::texture_blur(shape);
        add_time(stages.light, [&] { render::render_whitted(scene, camera, settings, frame, jobs, film); });
        add_time(stages.put_together, [&] { pictures.add(film.radiance, jobs); });
    }
    print_row(viewpoint.name + ": what every pixel shows", stages.guide);
    print_row("  light", stages.light, picture_hash(film.radiance));
    print_row("  put together", stages.put_together, picture_hash(pictures.picture()));
}

}  // namespace

void bench_window(const std::shared_ptr<const world::Level>& level, int threads, int rounds) {
    const Jobs jobs(threads);
    spatial::Stage stage(level);
    const world::Snapshot now = stage.commit(world::initial_state(*level, 1));
    const render::Prepared prepared = render::prepare(*level, now, jobs);
    const std::size_t count = std::min(kWindowCameras, level->viewpoints.size());
    for (const app::PictureShape& shape :
         {app::PictureShape{{213, 120}, 3}, app::PictureShape{{120, 68}, 4}}) {
        const std::string size =
            std::to_string(shape.shown().x) + "x" + std::to_string(shape.shown().y) + ", one in ";
        print_head(
            ("the window's picture, " + size + std::to_string(shape.step * shape.step) + " lit").c_str());
        for (std::size_t i = 0; i < count; ++i) {
            bench_view({*level, now, prepared}, level->viewpoints[i * level->viewpoints.size() / count],
                       shape, jobs, rounds);
        }
    }
}

}  // namespace bench
