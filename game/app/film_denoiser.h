// app/film_denoiser.h - from what the path tracer leaves to what the filters take, and back to a picture.
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
    // Replaces film.radiance. Precondition: film.planes are filled. `change_then` as filter::Light has it.
    void denoise(render::Film& film, const Jobs& jobs, const filter::DenoiseSettings& settings = {},
                 const filter::Plane& change_then = {});
    [[nodiscard]] const filter::Denoiser& denoiser() const { return denoiser_; }

  private:
    filter::Denoiser denoiser_;
    filter::GBuffer surfaces_;
    filter::Light light_;
    filter::Plane3 picture_;
};

}  // namespace gh::app
