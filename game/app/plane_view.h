// app/plane_view.h - what F4 cycles through: the planes that stand between a ray and the picture, each made visible.
//
// Threads   rows over all threads.
// Same bits pure functions of their arguments.
#pragma once

#include "base/image.h"
#include "base/jobs.h"
#include "filter/gbuffer.h"
#include "filter/plane.h"
#include "render/film.h"

#include <cstdint>

namespace gh::app {

enum class PlaneView : std::uint8_t {
    Picture,
    Albedo,
    Normal,
    Depth,
    Motion,
    Direct,
    Indirect,
    Specular,
    Variance,
    History,
    Rays
};
inline constexpr int kPlaneViews = 11;

// The one after it; the picture again after the last.
[[nodiscard]] PlaneView next_of(PlaneView view);
// What is seen and how to read it, for a line on the screen.
[[nodiscard]] const char* words_of(PlaneView view);

// What a path-traced frame left, of one size all.
struct SeenPlanes {
    const render::FilmPlanes& film;
    const filter::Plane& variance;  // of the direct light's mean
    const filter::Plane& history;   // frames in that mean
    filter::Pinhole before;         // the lens of the last frame
};

// `out` is made to fit. Light is shown for an eye of this exposure.
void paint_plane(PlaneView view, const SeenPlanes& seen, float exposure, const Jobs& jobs, Image8& out);

}  // namespace gh::app
