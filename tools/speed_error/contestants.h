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

struct Contestant {
    std::string name;
    std::string family;  // those that differ by the number of samples alone: a line in the plot
    std::string truth;   // which reference it is judged by
    int samples_per_pixel = 1;
    // Fills the film; another seed gives an independent picture.
    std::function<void(const gh::render::SceneView&, const gh::render::Camera&, std::uint32_t seed,
                       const gh::Jobs&, gh::render::Film&)>
        render;
};

// The quick list holds those with few samples.
[[nodiscard]] std::vector<Contestant> contestants(bool is_quick);

// What a truth is made with: `part` numbers independent pictures whose mean it is.
[[nodiscard]] Contestant truth_of(const std::string& truth, int samples_per_pixel);

}  // namespace speed_error
