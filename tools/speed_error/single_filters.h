// speed_error/single_filters.h - one picture, one sample, one filter: what each blur of game/filter is worth by itself.
#pragma once

#include "contestants.h"
#include "render/path_tracer.h"

#include <vector>

namespace speed_error {

// By Gaussian and bilateral, which see light alone, and by cross-bilateral, which sees surfaces; all after mend().
[[nodiscard]] std::vector<Contestant> single_filters(const gh::render::PathSettings& settings,
                                                     const char* truth);

}  // namespace speed_error
