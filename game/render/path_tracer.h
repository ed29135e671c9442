// render/path_tracer.h - a picture by path tracing (Kajiya 1986): all light there is, by chance, without bias.
//
//   render::Film film(640, 360);
//   render::render_path({level, snapshot, prepared}, camera, {.samples_per_pixel = 64}, frame, jobs, film);
//
// Every surface asks one of the lamps, chosen by how much it may give (light_tree.h), and sends its path on by what it
// scatters; what both find is weighed by the power heuristic (Veach 1995). Emissive triangles are lamps like others.
//
// Units     metres, linear radiance.
// Cost      two to three rays a bounce; tiles over all threads.
// Threads   reads its arguments only; any number of pictures may be made at a time.
// Same bits a picture is a function of (scene, camera, settings, frame number): the same for any number of threads
//           and any raycore ISA.
// Bad input a Level that level_check passed, and the Snapshot of that very Level; materials with NaN or infinite numbers
//           give some colour, never a NaN pixel.
#pragma once

#include "base/jobs.h"
#include "render/camera.h"
#include "render/film.h"
#include "render/pixel_filter.h"
#include "render/sample_sequence.h"
#include "render/scene_view.h"

#include "raycore/ray.h"

#include <glm/vec2.hpp>

#include <cstdint>

namespace gh::render {

class Environment;

// How lamps are found. All give the same picture, at different noise; one alone is for tests. Lamps without extent
// can be asked only.
enum class LampFinding : std::uint8_t { Both, AskOnly, MeetOnly };

// Whether mirrors and glass may focus lamps onto other surfaces. Traced: as light does, noisy; a lamp without extent
// then cannot be seen through a solid piece of glass. Unbent: shadow rays run straight through clear glass, which
// takes its share by Fresnel and its colour, and focused light is left out: little noise, not the truth.
enum class Caustics : std::uint8_t { Traced, Unbent };

// Which surfaces send paths on. All: every one, by whatever it scatters (Kajiya 1986). Glossy: mirrors, glass and gloss
// only, spread as far as they are rough, while all else gives back what lamps send it and the light that was baked about
// it: distributed ray tracing (Cook, Porter and Carpenter 1984).
enum class LightPaths : std::uint8_t { All, Glossy };

struct PathSettings {
    int samples_per_pixel = 1;
    int max_depth = 24;  // scatterings after the eye; 0: only what shines by itself
    SampleKind sampler = SampleKind::Sobol;
    std::uint32_t seed = 0;  // another one is another, independent picture
    LampFinding lamps = LampFinding::Both;
    Caustics caustics = Caustics::Traced;
    bool seeks_gleams =
        true;  // sends some paths to the insides of lamp shades (gleams.h): less noise, no bias
    bool uses_roulette = true;  // ends faint paths by chance, the others count for them ...
    bool ends_early = false;    // ... from the first scattering on: less time and more noise, no bias
    LightPaths lights = LightPaths::All;
    bool jitters = true;  // spreads samples over the pixel; otherwise all go through its middle ...
    glm::vec2 jitter{
        0.0f};  // ... or so far from it, in pixels: frames that are added up choose it by themselves
    PixelFilter filter = PixelFilter::Box;  // in what shape they are spread
    // Where the eye was when the shutter opened; it closes where it is now. Null: it stands. What moves by itself is where
    // it is when the shutter closes: blur is of the eye's own motion.
    const Camera* shutter_from = nullptr;
    // Whether the eye's path is split in two at smooth glass, so that each pixel's surfaces do not depend on chance.
    bool splits_glass = false;
    bool fills_planes = false;  // of the film, for filters
    // Ends paths after that many scatterings off anything but mirrors and smooth glass, in the light that was baked for
    // where they are (ambient.h): a bounce's noise and cost less, and the bake's error instead: corners it cannot see.
    bool ends_in_bake = false;
    int max_scatters = 1;
    // Two ways to trade fireflies for a bounded error; neither touches what the eye sees directly, in mirrors or through
    // glass, nor the first light on it. Clamping takes what one path brings by one bounce or more down to this radiance:
    // dims by what is above it. Roughening makes gloss (never glass) at least that rough once a path has been scattered
    // by something rough (Kaplanyan and Dachsbacher 2013): blurs the patterns that metal focuses, keeps their energy.
    float most_indirect = rc::kInfinity;
    float least_indirect_roughness = 0.0f;
    float texture_blur = 1.0f;  // as WhittedSettings has it
    float texture_taps = 8.0f;
    // Paths start in every n-th pixel of every n-th row only, the others stay black: a picture to compare with another.
    int every = 1;
    glm::ivec2 first{0};                       // of them, in [0, every)
    const Environment* environment = nullptr;  // instead of the sky
    // Uses the kernel that can do everything, whatever the scene needs: for tests and measurements.
    bool uses_general_kernel = false;
};

// What filters and pictures at 30 a second like best.
[[nodiscard]] PathSettings realtime_path();

// Cook's pictures: soft shadows, spread reflections, smooth edges, depth of field if the camera has an aperture.
[[nodiscard]] PathSettings cook_path();

// Fills film.radiance (of the size it has), film.stats and, if asked for, film.planes.
void render_path(const SceneView& scene, const Camera& camera, const PathSettings& settings,
                 std::uint32_t frame, const Jobs& jobs, Film& film);

}  // namespace gh::render
