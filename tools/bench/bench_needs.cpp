#include "bench_needs.h"

#include "base/hash.h"
#include "base/jobs.h"
#include "figures.h"
#include "render/path_tracer.h"
#include "spatial/stage.h"
#include "world/clear_parts.h"
#include "world/initial_state.h"

#include <memory>
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

// A level made ready, and how it is to be shown.
struct Shown {
    std::shared_ptr<const world::Level> level;
    std::unique_ptr<spatial::Stage> stage;
    world::Snapshot now;
    render::Prepared prepared;
    render::Camera camera;
    render::PathSettings settings;
};

Shown made_ready(const std::shared_ptr<const world::Level>& level) {
    Shown shown;
    shown.level = level;
    shown.stage = std::make_unique<spatial::Stage>(level);
    shown.now = shown.stage->commit(world::initial_state(*level, 1));
    shown.prepared = render::prepare(*level, shown.now, Jobs(1), {.bakes_ambient = false});
    shown.camera = level->viewpoints.empty() ? render::camera_around(level->bounds)
                                             : render::camera_from(level->viewpoints[0]);
    shown.settings.samples_per_pixel = kSamples;
    return shown;
}

struct Shot {
    double ms = 0.0, rays = 0.0;
    std::uint64_t digest = 0;
};

Shot shoot(const Shown& shown, render::Film& film) {
    const double start = thread_ms();
    render::render_path({*shown.level, shown.now, shown.prepared}, shown.camera, shown.settings, 0, Jobs(1),
                        film);
    Shot shot{.ms = thread_ms() - start, .rays = static_cast<double>(film.stats.total())};
    Hasher hash;
    for (const glm::vec3& pixel : film.radiance.pixels) hash.add(pixel);
    shot.digest = hash.digest();
    return shot;
}

// By the kernel it needs, and by the one that can do everything.
void bench_level(const char* name, const std::shared_ptr<const world::Level>& level, int rounds) {
    Shown shown = made_ready(level);
    Samples picked, ratios;
    std::uint64_t digest = 0;
    bool is_same = true;
    render::Film film(kWidth, kHeight);
    for (int round = 0; round <= rounds; ++round) {
        Shot shots[2];
        for (const int general : {round % 2, 1 - round % 2}) {
            shown.settings.uses_general_kernel = general != 0;
            shots[general] = shoot(shown, film);
        }
        is_same = is_same && shots[0].digest == shots[1].digest;
        digest = shots[0].digest;
        if (round == 0) continue;  // warms up
        picked.ms.push_back(shots[0].ms);
        ratios.ms.push_back(shots[1].ms / shots[0].ms);
    }
    std::printf("  %-28s %8.1f  %5.3f [%5.3f %5.3f]  %s  %016llx\n", name, picked.at(0.5), ratios.at(0.5),
                ratios.at(0.25), ratios.at(0.75), is_same ? "same bits" : "OTHER BITS",
                static_cast<unsigned long long>(digest));
}

// A picture with a feature against one without it, in turn.
void bench_feature(const char* name, const Shown& with, const Shown& without, int rounds) {
    render::Film films[2] = {render::Film(kWidth, kHeight), render::Film(kWidth, kHeight)};
    Samples times, by_ray, ratios;
    bool is_seen = false;
    double rays = 0.0;
    for (int round = 0; round <= rounds; ++round) {
        Shot shots[2];
        for (const int has : {round % 2, 1 - round % 2})
            shots[has] = shoot(has != 0 ? with : without, films[has]);
        is_seen = shots[0].digest != shots[1].digest;
        rays = shots[1].rays / shots[0].rays;
        if (round == 0) continue;  // warms up
        times.ms.push_back(shots[1].ms);
        ratios.ms.push_back(shots[1].ms / shots[0].ms);
        by_ray.ms.push_back(shots[1].ms / shots[0].ms / rays);
    }
    std::printf("  %-28s %8.1f  %5.3f [%5.3f %5.3f]  %5.3f  %5.3f  %s\n", name, times.at(0.5), ratios.at(0.5),
                ratios.at(0.25), ratios.at(0.75), rays, by_ray.at(0.5),
                is_seen ? "" : "(not to be seen here)");
    std::fflush(stdout);
}

template <class Take>
void bench_material(const char* name, const Shown& with, Take take, int rounds) {
    bench_feature(name, with, made_ready(without(*with.level, take)), rounds);
}

// The same level shown in another way.
template <class Change>
void bench_setting(const char* name, const std::shared_ptr<const world::Level>& level, const Shown& without,
                   Change change, int rounds) {
    Shown with = made_ready(level);
    change(with);
    bench_feature(name, with, without, rounds);
}

void bench_features(const std::shared_ptr<const world::Level>& level, int rounds) {
    std::printf(
        "\nwhat is used: core ms with it, how many times as long, as many rays, and as long by the ray, as "
        "without "
        "it\n");
    const Shown whole = made_ready(level);
    bench_material(
        "colour textures", whole, [](world::Material& m) { m.base_color_texture = world::kNoIndex; }, rounds);
    bench_material(
        "roughness textures", whole,
        [](world::Material& m) { m.metallic_roughness_texture = world::kNoIndex; }, rounds);
    bench_material(
        "normal maps", whole, [](world::Material& m) { m.normal_texture = world::kNoIndex; }, rounds);
    bench_material(
        "varnish, cloth, anisotropy", whole,
        [](world::Material& m) {
            m.layers = {};
            m.has_layers = false;
        },
        rounds);
    bench_material(
        "gloss and metal", whole,
        [](world::Material& m) {
            m.metallic = 0.0f;
            m.specular = 0.0f;
            m.roughness = 1.0f;
            m.metallic_roughness_texture = world::kNoIndex;
        },
        rounds);
    bench_material(
        "holes", whole, [](world::Material& m) { m.alpha_mode = world::AlphaMode::Opaque; }, rounds);
    bench_material(
        "glass", whole, [](world::Material& m) { m.transmission = 0.0f; }, rounds);
    bench_material(
        "emissive triangles", whole, [](world::Material& m) { m.emission = glm::vec3(0.0f); }, rounds);
    bench_setting(
        "planes for filters", level, whole, [](Shown& s) { s.settings.fills_planes = true; }, rounds);
    bench_setting(
        "depth of field", level, whole,
        [](Shown& s) {
            s.camera.aperture = 0.02f;
            s.camera.focus = 4.0f;
        },
        rounds);
    render::Camera opened = whole.camera;
    opened.yaw += 0.02f;
    bench_setting(
        "motion blur", level, whole, [&](Shown& s) { s.settings.shutter_from = &opened; }, rounds);
    Shown unsought = made_ready(level);
    unsought.settings.seeks_gleams = false;
    bench_feature("seeking gleams", whole, unsought, rounds);
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
    bench_features(level, rounds);
}

}  // namespace bench
