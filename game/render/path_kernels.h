// render/path_kernels.h - which of the path tracer's kernels a picture is made by.
#pragma once

#include "base/jobs.h"
#include "render/path_tile.h"

namespace gh::render {

// All tiles of a film, over all threads, by the kernel of these features (KernelFeature).
void trace_tiles(const PathFrame& frame, unsigned features, const Jobs& jobs, Film& film);

}  // namespace gh::render
