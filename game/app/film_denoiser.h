// app/film_denoiser.h - lends the filters the planes that the path tracer leaves, and makes a picture of what they make of it.
//
// Threads   belongs to one caller; rows over all threads.
// Same bits as the filters'.
#pragma once

#include "base/jobs.h"
#include "filter/denoiser.h"
#include "render/film.h"

namespace gh::app {

class FilmDenoiser {
  public:
    // The next frame is the first: after a cut.
    void forget() { denoiser_.forget(); }
    // Replaces film.radiance. Precondition: film.planes are filled. `change_then`, if there is any, as filter::Light has it;
    // it is borrowed, as the film's planes are.
    void denoise(render::Film& film, const Jobs& jobs, const filter::DenoiseSettings& settings = {},
                 filter::Plane* change_then = nullptr);
    [[nodiscard]] const filter::Denoiser& denoiser() const { return denoiser_; }

  private:
    filter::Denoiser denoiser_;
    filter::GBuffer surfaces_;  // borrowed while they are filtered
    filter::Light light_;
    filter::Plane3 picture_;
};

}  // namespace gh::app
