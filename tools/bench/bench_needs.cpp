#include "bench_needs.h"

#include "base/hash.h"
#include "base/jobs.h"
#include "figures.h"
#include "render/path_tracer.h"
#include "spatial/stage.h"
#include "world/clear_parts.h"
#include "world/initial_state.h"

#include <utility>

namespace bench {
namespace {

using namespace gh;

constexpr int kWidth = 160, kHeight = 90, kSamples = 4;

void take_glass(world::Material& material) {
    material.transmission = 0.0f;
    material.alpha_mode = world::AlphaMode::Opaque;
}

void take_textures(world::Material& material) {
    for (std::uint32_t* texture : {&material.base_color_texture, &material.metallic_roughness_texture,
                                   &material.normal_texture, &material.emission_texture})
        *texture = world::kNoIndex;
    material.layers = {};
    material.has_layers = false;
}

// The level with something taken from each of its materials.
template <class Take>
std::shared_ptr<const world::Level> without(const world::Level& level, Take take) {
    auto less = std::make_shared<world::Level>(level);
    for (world::Material& material : less->materials) take(material);
    world::mark_clear_parts(*less);
    return less;
}

void bench_level(const char* name, const std::shared_ptr<const world::Level>& level, int rounds) {
    const Jobs jobs(1);
    spatial::Stage stage(level);
    const world::Snapshot now = stage.commit(world::initial_state(*level, 1));
    const render::Prepared prepared = render::prepare(*level, now, jobs, {.bakes_ambient = false});
    const render::Camera camera = level->viewpoints.empty() ? render::camera_around(level->bounds)
                                                            : render::camera_from(level->viewpoints[0]);
    render::PathSettings settings;
    settings.samples_per_pixel = kSamples;
    Samples picked, ratios;
    std::uint64_t digest = 0;
    bool is_same = true;
    render::Film film(kWidth, kHeight);
    for (int round = 0; round <= rounds; ++round) {
        double ms[2] = {};
        std::uint64_t digests[2] = {};
        for (const int general : {round % 2, 1 - round % 2}) {
            settings.uses_general_kernel = general != 0;
            const double start = thread_ms();
            render::render_path({*level, now, prepared}, camera, settings, 0, jobs, film);
            ms[general] = thread_ms() - start;
            Hasher hash;
            for (const glm::vec3& pixel : film.radiance.pixels) hash.add(pixel);
            digests[general] = hash.digest();
        }
        is_same = is_same && digests[0] == digests[1];
        digest = digests[0];
        if (round == 0) continue;  // warms up
        picked.ms.push_back(ms[0]);
        ratios.ms.push_back(ms[1] / ms[0]);
    }
    std::printf("  %-28s %8.1f  %5.3f [%5.3f %5.3f]  %s  %016llx\n", name, picked.at(0.5), ratios.at(0.5),
                ratios.at(0.25), ratios.at(0.75), is_same ? "same bits" : "OTHER BITS",
                static_cast<unsigned long long>(digest));
}

}  // namespace

void bench_needs(const std::shared_ptr<const world::Level>& level, int rounds) {
    std::printf(
        "\npath tracing, %dx%d, %d samples, one thread: core ms by the kernel that is needed, and how many "
        "times as long the one that can do everything takes\n",
        kWidth, kHeight, kSamples);
    bench_level("as it is", level, rounds);
    bench_level("without glass and holes", without(*level, take_glass), rounds);
    bench_level("without textures and layers", without(*level, take_textures), rounds);
    const auto bare = without(*level, [](world::Material& material) {
        take_glass(material);
        take_textures(material);
    });
    bench_level("without either", bare, rounds);
}

}  // namespace bench
