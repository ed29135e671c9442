#include "bench_paths.h"

#include "app/view.h"
#include "base/jobs.h"
#include "figures.h"
#include "filter/jitter.h"
#include "filter/upscale.h"
#include "picture_hash.h"
#include "render/guide.h"
#include "render/path_tracer.h"
#include "spatial/stage.h"
#include "world/initial_state.h"

#include <algorithm>

namespace bench {
namespace {

using namespace gh;

constexpr std::size_t kPathCameras = 4;
constexpr std::uint32_t kFirstFrames = 4;  // that are not counted: nothing of the past is known yet

// One way to make a picture after the other, and what its stages take.
class Pictures {
  public:
    Pictures(const render::SceneView& scene, const render::Camera& camera, const app::PictureShape& shape,
             const Jobs& jobs)
        : scene_(scene),
          camera_(camera),
          shape_(shape),
          jobs_(jobs),
          view_(shape.lit.x, shape.lit.y),
          film_(shape.lit.x, shape.lit.y) {
        for (std::uint32_t i = 0; i < kFirstFrames; ++i) take();
        for (Samples* stage : {&traced_, &guided_, &exposed_, &developed_, &upscaled_}) stage->ms.clear();
    }
    void take() {
        render::PathSettings settings = render::realtime_path();
        settings.jitter = filter::halton_jitter(frame_);
        time(traced_, [&] { render::render_path(scene_, camera_, settings, frame_, jobs_, film_); });
        if (shape_.step > 1)
            time(guided_, [&] {
                render::render_guide(scene_, camera_, {.texture_taps = 4.0f}, shape_.shown(), jobs_, guide_);
            });
        time(exposed_,
             [&] { view_.expose_next(scene_, camera_, render::realtime_path(), frame_, shape_, jobs_); });
        time(developed_, [&] { view_.develop(frame_, 1.0f / 30.0f, 0.0f, jobs_); });
        if (shape_.step == 1) {
            time(upscaled_, [&] { filter::resample(view_.picture(), jobs_, large_); });
        }
        ++frame_;
    }
    void print(const std::string& name) const {
        print_row(name + ": paths alone, of every lit pixel", traced_, picture_hash(film_.radiance));
        if (shape_.step > 1) print_row("  what every shown pixel shows", guided_);
        print_row("  the picture: asked again, denoised, added up", exposed_, picture_hash(view_.shown()));
        print_row("  exposure, glare, tone map", developed_);
        if (shape_.step == 1) print_row("  to 1280x720", upscaled_);
    }

  private:
    template <class Work>
    static void time(Samples& stage, const Work& work) {
        const double start = cpu_ms();
        work();
        stage.ms.push_back(cpu_ms() - start);
    }

    const render::SceneView& scene_;
    render::Camera camera_;
    app::PictureShape shape_;
    const Jobs& jobs_;
    app::View view_;
    render::Film film_;
    Image8 large_{1280, 720};
    render::GuidePlanes guide_;
    Samples traced_, guided_, exposed_, developed_, upscaled_;
    std::uint32_t frame_ = 0;
};

}  // namespace

void bench_paths(const std::shared_ptr<const world::Level>& level, int threads, int rounds) {
    const Jobs jobs(threads);
    spatial::Stage stage(level);
    const world::Snapshot now = stage.commit(world::initial_state(*level, 1));
    const render::Prepared prepared = render::prepare(*level, now, jobs);
    const render::SceneView scene{*level, now, prepared};
    const std::size_t count = std::min(kPathCameras, level->viewpoints.size());
    for (const app::PictureShape& shape :
         {app::PictureShape{{640, 360}, 1}, app::PictureShape{{427, 240}, 3}}) {
        print_head(shape.step == 1 ? "path traced, 640x360, core time"
                                   : "path traced, 1281x720, one in nine lit");
        for (std::size_t i = 0; i < count; ++i) {
            const world::Viewpoint& viewpoint = level->viewpoints[i * level->viewpoints.size() / count];
            Pictures pictures(scene, render::camera_from(viewpoint), shape, jobs);
            for (int round = 0; round < rounds; ++round) pictures.take();
            pictures.print(viewpoint.name);
        }
    }
}

}  // namespace bench
