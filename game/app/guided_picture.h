// app/guided_picture.h - pictures in a row, lit in few pixels and shown in many: what is seen is traced for every pixel
// here, the light of some by whoever has a renderer, and filter/temporal_upscale puts them together.
//
//   const glm::vec2 jitter = guided.begin(scene, camera, settings, frame, shape, jobs);
//   ... render a picture of shape.lit pixels with that jitter ...
//   guided.add(film.radiance, jobs);
//   ... show guided.picture(), of shape.made() pixels ...
//
// Cost, threads, same bits   as render/guide.h and filter/temporal_upscale.h.
#pragma once

#include "app/resolution.h"
#include "base/image.h"
#include "base/jobs.h"
#include "filter/jitter.h"
#include "filter/temporal_upscale.h"
#include "render/camera.h"
#include "render/film.h"
#include "render/whitted.h"

#include <cstdint>

namespace gh::app {

class GuidedPicture {
  public:
    // The next frame is the first: after a cut.
    void forget() {
        upscaler_.forget();
        has_picture_ = false;
    }

    // Of the settings those count that render_guide() names, but for the jitter. Returns where in their pixels the lit
    // picture's samples must lie.
    [[nodiscard]] glm::vec2 begin(const render::SceneView& scene, const render::Camera& camera,
                                  render::WhittedSettings settings, std::uint32_t frame,
                                  const PictureShape& shape, const Jobs& jobs);
    // Precondition: `radiance` has the size that begin() was told.
    void add(const Image& radiance, const Jobs& jobs);
    // Of shape.made() pixels; what was added last.
    [[nodiscard]] const Image& picture() const { return picture_; }

    // What pixels of the lit picture blur textures by, of their own size: as the guide's do, which are as sharp as what is
    // made of them.
    [[nodiscard]] static float texture_blur(const PictureShape& shape) {
        return (shape.doubles ? 0.5f : 1.0f) / static_cast<float>(shape.step);
    }

  private:
    filter::TemporalUpscaler upscaler_;
    render::GuidePlanes guide_, guide_before_;
    Image picture_;
    bool has_picture_ = false;  // that the next frame follows
    PictureShape shape_;
    glm::vec2 jitter_{0.0f};
    glm::ivec2 offset_{0};
};

}  // namespace gh::app
