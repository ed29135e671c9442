// bench_placed.h - the museum as the game commits it, beside the same triangles in one tree.
#pragma once

#include "bench_queries.h"

#include <string>

namespace bench {

// What it costs that a level is many trees under one. False when the level can not be read; the sentence is on stderr.
[[nodiscard]] bool bench_placed(Report& report, const std::string& level_file, const QueryOptions& options);

}  // namespace bench
