// app/film_strip.h - a replay's pictures on disk, one file a tick that is shown. What is there already is left as it is,
// so that a film can be broken off and gone on with: every picture depends on the recording and the options alone.
//
// Exposure  of each picture by a small sketch of it, which is made for pictures that are skipped as well: the eye adapts
//           the same way whether or not the film was made in one go.
// Whitted   with one sample a pixel goes the window's way at rest: smooth edges for less than a second sample costs.
#pragma once

#include "app/options.h"
#include "app/view.h"
#include "base/result.h"

#include <cstdint>
#include <optional>

namespace gh::app {

class FilmStrip {
  public:
    FilmStrip(const ReplayOptions& options, std::optional<render::Environment> sky);

    // Writes the picture of this tick, unless it is there.
    [[nodiscard]] Result<void> shoot(const render::SceneView& scene, std::size_t tick, const Jobs& jobs);

    [[nodiscard]] std::uint32_t pictures() const { return pictures_; }

  private:
    void expose(const render::SceneView& scene, const render::Camera& camera, const render::Camera& opened,
                std::uint32_t frame, const Jobs& jobs);
    void look_four_times(const render::SceneView& scene, const render::Camera& camera,
                         const render::WhittedSettings& settings, std::uint32_t frame, const Jobs& jobs);
    [[nodiscard]] render::Camera shutter_opens(const render::Camera& camera) const;

    ReplayOptions options_;
    std::optional<render::Environment> sky_;
    View view_;
    View sketch_;
    std::optional<render::Camera> last_;  // of the picture before
    std::uint32_t pictures_ = 0;
};

}  // namespace gh::app
