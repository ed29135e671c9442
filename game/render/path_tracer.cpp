#include "render/path_tracer.h"

#include "base/contracts.h"
#include "render/path_tile.h"

#include <memory>

namespace gh::render {

PathSettings realtime_path() {
    PathSettings settings;
    settings.max_depth = 8;
    settings.ends_in_bake = true;
    settings.sampler = SampleKind::BlueNoise;
    settings.jitters = false;  // frames are added up: each lies elsewhere in its pixels
    settings.caustics = Caustics::Unbent;
    settings.splits_glass = true;
    settings.fills_planes = true;
    settings.most_indirect = 10.0f;
    settings.least_indirect_roughness = 0.4f;
    settings.texture_taps = 4.0f;
    return settings;
}

void render_path(const SceneView& scene, const Camera& camera, const PathSettings& settings,
                 std::uint32_t frame, const Jobs& jobs, Film& film) {
    EXPECTS(settings.samples_per_pixel >= 1 && settings.samples_per_pixel <= 65536);
    EXPECTS(settings.max_depth >= 0 && settings.max_depth < 200);
    const int width = film.radiance.width, height = film.radiance.height;
    film.stats = {};
    if (width == 0 || height == 0) return;
    const FrameLight light = frame_light(scene, settings.ends_in_bake);
    const LightSet lights(scene, light, settings.environment);
    const PathFrame shared{.view = scene,
                           .settings = settings,
                           .light = light,
                           .lights = lights,
                           .lens = Lens(camera, width, height),
                           .number = frame,
                           .width = width,
                           .height = height};
    if (settings.fills_planes) {
        film.planes.resize(width, height);
        film.planes.eye = shared.lens.position();
        film.planes.corner = shared.lens.corner();
        film.planes.right = shared.lens.right();
        film.planes.down = shared.lens.down();
    }
    const int across = (width + kPathTileSide - 1) / kPathTileSide;
    const int down = (height + kPathTileSide - 1) / kPathTileSide;
    const auto tiles = static_cast<std::size_t>(across) * static_cast<std::size_t>(down);
    std::vector<FrameStats> stats(tiles);
    std::vector<std::unique_ptr<PathTile>> tracers(static_cast<std::size_t>(jobs.threads()));
    jobs.run(tiles, [&](std::size_t tile, int worker) {
        std::unique_ptr<PathTile>& tracer = tracers[static_cast<std::size_t>(worker)];
        if (tracer == nullptr) tracer = std::make_unique<PathTile>(shared);
        tracer->trace(static_cast<int>(tile) % across, static_cast<int>(tile) / across, film, stats[tile]);
    });
    for (const FrameStats& tile : stats) film.stats += tile;
}

}  // namespace gh::render
