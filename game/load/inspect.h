// load/inspect.h - what is in a level, on a page: for people who build levels and for bug reports.
#pragma once

#include "base/result.h"

#include <filesystem>
#include <string>

namespace gh::load {

// Loads the level, checks it (level_check.h) and describes it, errors and warnings last.
[[nodiscard]] Result<std::string> describe_level(const std::filesystem::path& path);

}  // namespace gh::load
