#include "render/whitted.h"

#include "base/contracts.h"
#include "render/frame_light.h"
#include "render/pixel_light.h"
#include "render/tile.h"

#include <memory>

namespace gh::render {

void render_whitted(const SceneView& scene, const Camera& camera, const WhittedSettings& settings,
                    std::uint32_t frame, const Jobs& jobs, Film& film) {
    EXPECTS(settings.samples_per_pixel >= 1 && settings.shadow_samples >= 1);
    EXPECTS(settings.ambient_samples >= 0 && settings.max_depth >= 0 && settings.max_depth < 200);
    const int width = film.radiance.width, height = film.radiance.height;
    film.stats = {};
    if (width == 0 || height == 0) return;

    const FrameLight light = frame_light(scene, settings.uses_ambient);
    const Frame shared{.view = scene,
                       .settings = settings,
                       .light = light,
                       .gloss = scene.prepared.gloss,
                       .lens = Lens(camera, width, height),
                       .number = frame,
                       .width = width,
                       .height = height};
    const int across = (width + kTileSide - 1) / kTileSide, down = (height + kTileSide - 1) / kTileSide;
    const auto tiles = static_cast<std::size_t>(across) * static_cast<std::size_t>(down);

    std::vector<PixelLight> pixels(film.radiance.pixels.size());
    std::vector<FrameStats> stats(tiles);
    std::vector<std::unique_ptr<TileTracer>> tracers(static_cast<std::size_t>(jobs.threads()));
    jobs.run(tiles, [&](std::size_t tile, int worker) {
        std::unique_ptr<TileTracer>& tracer = tracers[static_cast<std::size_t>(worker)];
        if (tracer == nullptr) tracer = std::make_unique<TileTracer>(shared);
        tracer->trace(static_cast<int>(tile) % across, static_cast<int>(tile) / across, pixels, stats[tile]);
    });
    for (const FrameStats& tile : stats) film.stats += tile;
    develop(pixels, settings.shares_samples, jobs, film.radiance);
}

}  // namespace gh::render
