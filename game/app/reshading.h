// app/reshading.h - what of the light has changed since the last frame, by asking some of its paths again.
//
// One pixel in nine of the last frame is traced once more, with the camera and the random numbers it had, in the world as
// it is now: where nothing changed the very same light comes back, and what differs is change and nothing else. (Schied et
// al. 2018, "Gradient estimation for real-time adaptive temporal filtering".) Lamps and doors need to tell nobody. A path
// that meets something else first now, or the same elsewhere, says nothing of the light on what it met: a guard who walks
// keeps his past, and so does the wall beside him.
//
// Cost      a ninth of a frame's rays.
// Threads   belongs to one caller; tiles and rows over all threads.
// Same bits for any number of threads.
#pragma once

#include "base/jobs.h"
#include "filter/anti_lag.h"
#include "render/film.h"
#include "render/path_tracer.h"

#include <glm/vec3.hpp>

#include <cstdint>
#include <vector>

namespace gh::app {

class Reshading {
  public:
    // Nothing is known of any frame before.
    void forget() { is_known_ = false; }

    // The share of the light that is new in each pixel of the frame that was noted last; empty if none was.
    void ask_again(const render::SceneView& scene, const Jobs& jobs, filter::Plane& change);

    // What ask_again() compares with: a frame as it was traced, before any filter, with its planes.
    void note(const render::Camera& camera, const render::PathSettings& settings, std::uint32_t frame,
              const render::Film& film);

  private:
    // What a path met first.
    struct Seen {
        std::uint32_t part;
        glm::vec3 position;
    };
    [[nodiscard]] bool is_at(const Seen& seen, std::uint32_t part, const glm::vec3& position) const;

    bool is_known_ = false;
    render::Camera camera_;
    render::PathSettings settings_;
    std::uint32_t frame_ = 0;
    render::Film again_;
    filter::Reshaded samples_;
    std::vector<Seen> seen_;  // by the paths that are asked again, row by row
};

}  // namespace gh::app
