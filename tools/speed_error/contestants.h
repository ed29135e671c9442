// speed_error/contestants.h - the ways of making a picture that are compared, each against the truth it aims at.
#pragma once

#include "base/jobs.h"
#include "render/camera.h"
#include "render/film.h"
#include "render/scene_view.h"

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace speed_error {

// One picture that is asked for. Frames of a run come in order; another seed is another, independent run.
struct Shot {
    const gh::render::SceneView& scene;
    const gh::render::Camera& camera;
    std::uint32_t seed = 0;
    std::uint32_t frame = 0;
    const gh::Jobs& jobs;
};

// Core time of a picture by stage.
struct StageTimes {
    double render_ms = 0.0;
    double filter_ms = 0.0;

    [[nodiscard]] double total() const { return render_ms + filter_ms; }
};

// Fills film.radiance, of the size it has, and film.stats. What one run remembers from frame to frame is its own.
using Run = std::function<StageTimes(const Shot&, gh::render::Film&)>;

struct Contestant {
    std::string name;
    std::string family;  // those that differ by the number of samples alone: a line in the plot
    std::string truth;   // which reference it is judged by
    int samples_per_pixel = 1;
    int frames = 1;  // the last one of so many in a row is judged, and what one frame costs is what it costs
    std::function<Run()> begin;
};

// Of single pictures and of pictures in a row. The quick list holds those with few samples.
[[nodiscard]] std::vector<Contestant> contestants(bool is_quick);

// What the game may show in a row, for how it behaves over time; `frames` is not used.
[[nodiscard]] std::vector<Contestant> moving_contestants();

// What a truth is made with: `part` numbers independent pictures whose mean it is.
[[nodiscard]] Contestant truth_of(const std::string& truth, int samples_per_pixel);

}  // namespace speed_error
