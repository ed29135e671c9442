// render/whitted.h - a picture by recursive ray tracing (Whitted 1980): lamps with soft shadows, mirrors, glass, gloss,
// and an ambient light that knows which lamps are on.
//
//   const render::Prepared prepared = render::prepare(level, snapshot, jobs);         // once a level
//   render::Film film(640, 360);
//   render::render_whitted({level, snapshot, prepared}, camera, {}, frame, jobs, film);
//   // film.radiance -> filter::tone_map -> present or record
//
// Cost      about five to ten rays a pixel and sample in a museum room; tiles over all threads.
// Threads   reads its arguments only; any number of pictures may be made at a time.
// Same bits a picture is a function of (scene, camera, settings, frame number): the same for any number of threads
//           and any raycore ISA.
// Bad input a Level that level_check passed, and the Snapshot of that very Level.
#pragma once

#include "base/jobs.h"
#include "render/camera.h"
#include "render/film.h"
#include "render/prepared.h"
#include "render/scene_view.h"

#include <glm/vec2.hpp>

#include <cstdint>

namespace gh::render {

struct WhittedSettings {
    int samples_per_pixel = 1;
    int max_depth = 8;  // mirrors and panes of glass one after the other
    int shadow_samples =
        1;  // rays to an area lamp per sample; pixels next to each other share theirs (see below)
    int ambient_samples = 1;           // short rays that darken corners, per sample; 0: none
    float min_weight = 1.0f / 256.0f;  // rays that would count less are not followed
    float texture_taps = 8.0f;         // at most, along the long side of a pixel's footprint
    // Of a pixel, what textures are blurred to: less than 1 for frames that are added up to a larger picture.
    float texture_blur = 1.0f;
    // Of a guide alone: lamps in what polished surfaces mirror, bulbs and highlights (guide_gleams.h). Not for light that is
    // found by chance, of which they would be taken off where it has them blurred, or not yet.
    bool guides_lamps = true;
    bool uses_ambient = true;  // the baked indirect light
    // Neighbours in a 4x4 block look at different parts of a lamp and share what they saw where the surface goes on
    // (interleaved sampling with a discontinuity buffer; Keller and Heidrich 2001). Off: every pixel for itself.
    bool shares_samples = true;
    // Works out the light of every fifth pixel first, and of those between only where their neighbours are of another
    // surface or differ by more than `contrast` of themselves (Heaven7's adaptive subsampling; needs shares_samples).
    // What is seen and its texture are exact in every pixel. What is smaller than five pixels and shows in the light
    // alone, a thin shadow or a small highlight, may be missed.
    bool is_adaptive = false;
    float contrast = 0.25f;
    // Where in its pixel the only sample lies, from the middle, in [-0.5, 0.5): turned from frame to frame by what adds
    // frames up.
    glm::vec2 jitter{0.0f};
    // Which places in their pixels several samples take. No frame changes them, so that edges stand still in films; means of
    // many pictures want others in each.
    std::uint32_t places = 0;
};

// Fills film.radiance (of the size it has) and film.stats. `frame` turns the sampling pattern; a still uses 0.
void render_whitted(const SceneView& scene, const Camera& camera, const WhittedSettings& settings,
                    std::uint32_t frame, const Jobs& jobs, Film& film);

}  // namespace gh::render
