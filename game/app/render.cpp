// glasshouse render: one picture of any glTF scene.
#include "app/assets.h"
#include "app/commands.h"
#include "app/profile.h"
#include "app/view.h"
#include "load/level_loader.h"
#include "record/picture.h"
#include "render/prepared.h"
#include "spatial/stage.h"
#include "world/initial_state.h"

#include <fmt/format.h>

#include <chrono>
#include <iostream>
#include <memory>

namespace gh::app {

namespace {

Result<void> write_picture(const std::filesystem::path& path, View& view, const Jobs& jobs) {
    if (path.extension() == ".exr") return record::write_exr(path, view.film().radiance);
    return record::write_png(path, view.develop(0, 0.0f, 0.0f, jobs));
}

}  // namespace

int render(const RenderOptions& options) {
    const std::string ending = options.output.extension().string();
    if (ending != ".png" && ending != ".exr") {
        return refuse({options.output.string() + ": a picture's name ends in .png or .exr"});
    }
    apply(options.machine);
    const Jobs jobs(options.machine.threads);

    const auto path = resolve_level(options.scene);
    if (!path) return refuse(path.error());
    // Who brings a sky needs no sun.
    const bool has_sky = light_paths(options.renderer.renderer) && !options.renderer.sky.empty();
    auto loaded = load::load_level(*path, {.finds_ways = false, .hangs_sun = !has_sky});
    if (!loaded) return refuse(loaded.error());
    const auto level = std::make_shared<const world::Level>(*std::move(loaded));
    tell(*level);

    std::unique_ptr<spatial::Stage> stage;
    jobs.run_in([&] { stage = std::make_unique<spatial::Stage>(level); });
    const world::Snapshot snapshot = stage->commit(world::initial_state(*level, 0), jobs);
    const auto camera = camera_named(*level, snapshot, options.camera);
    if (!camera) return refuse(camera.error());
    const render::Prepared prepared = render::prepare(*level, snapshot, jobs);

    const auto sky = sky_named(options.renderer);
    if (!sky) return refuse(sky.error());
    View view(options.size.width, options.size.height);
    const Clock::time_point start = Clock::now();
    if (light_paths(options.renderer.renderer)) {
        const render::SceneView scene{*level, snapshot, prepared};
        const float exposure = sketched_exposure(scene, *camera, jobs);
        render::PathSettings settings = path_settings(options.renderer, options.samples_per_pixel, exposure);
        if (*sky) settings.environment = &**sky;
        view.expose(scene, with_lens(*camera, options.renderer), settings, 0, jobs);
    } else {
        view.expose({*level, snapshot, prepared}, *camera,
                    whitted_settings(options.samples_per_pixel, options.is_adaptive), 0, jobs);
    }
    const float ms = milliseconds_since(start);
    if (const auto written = write_picture(options.output, view, jobs); !written)
        return refuse(written.error());
    const double rays = static_cast<double>(view.film().stats.total());
    std::cout << fmt::format(
        "{}: {}x{}, {} spp, {:.0f} ms, {:.2f} Mrays, {:.2f} Mrays/s, {} threads, {}\n",
        options.output.string(), options.size.width, options.size.height, options.samples_per_pixel, ms,
        rays * 1e-6, rays * 1e-3 / static_cast<double>(ms), jobs.threads(), rc::isa_name(rc::active_isa()));
    return kExitFine;
}

}  // namespace gh::app
