#include "render/path_tracer.h"

#include "base/contracts.h"
#include "render/path_kernels.h"

namespace gh::render {

PathSettings realtime_path() {
    PathSettings settings;
    settings.max_depth = 8;
    settings.ends_in_bake = true;
    settings.ends_early = true;
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

PathSettings cook_path() {
    PathSettings settings;
    settings.max_depth = 8;
    settings.lights = LightPaths::Glossy;
    settings.filter = PixelFilter::Gaussian;
    settings.caustics = Caustics::Unbent;
    settings.seeks_gleams = false;
    return settings;
}

void render_path(const SceneView& scene, const Camera& camera, const PathSettings& settings,
                 std::uint32_t frame, const Jobs& jobs, Film& film) {
    EXPECTS(settings.samples_per_pixel >= 1 && settings.samples_per_pixel <= 65536);
    EXPECTS(settings.every >= 1);
    EXPECTS(settings.max_depth >= 0 && settings.max_depth < 200);
    const int width = film.radiance.width, height = film.radiance.height;
    film.stats = {};
    if (width == 0 || height == 0) return;
    const bool needs_bake = settings.ends_in_bake || settings.lights == LightPaths::Glossy;
    const FrameLight light = frame_light(scene, needs_bake);
    const LightSet lights(scene, light, settings.environment, film.light_tree);
    const PathFrame shared{
        .view = scene,
        .settings = settings,
        .light = light,
        .lights = lights,
        .lens = Lens(camera, width, height),
        .lens_before =
            Lens(settings.shutter_from != nullptr ? *settings.shutter_from : camera, width, height),
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
    unsigned features = kAllFeatures;
    if (!settings.uses_general_kernel) {
        const bool has_clear = scene.prepared.has_clear_parts;
        features = (has_clear ? kClearKernel : 0u) | (settings.fills_planes ? kPlanesKernel : 0u);
    }
    trace_tiles(shared, features, jobs, film);
}

}  // namespace gh::render
