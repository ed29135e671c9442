// app/quality.h - what a player may trade: four named sets of settings, and the bounds between which the resolution
// follows the time a picture takes.
#pragma once

#include "present/menu.h"
#include "render/path_tracer.h"
#include "render/whitted.h"

#include <optional>
#include <string_view>

namespace gh::app {

// A denoiser needs more lit pixels than what is not noisy to begin with.
inline constexpr int kMostPathStep = 3;

struct Quality {
    render::WhittedSettings whitted;
    render::PathSettings path;
    float fewest_shown;  // pixels: rather fewer frames than these
    float most_lit;
};

[[nodiscard]] Quality quality_of(present::QualityName name);
// One of present::kQualityWords.
[[nodiscard]] std::optional<present::QualityName> quality_named(std::string_view word);

}  // namespace gh::app
