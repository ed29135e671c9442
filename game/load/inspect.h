// load/inspect.h - what is in a level, on a page: for people who build levels and for bug reports.
#pragma once

#include "base/result.h"

#include <cstddef>
#include <filesystem>
#include <string>

namespace gh::load {

struct LevelPage {
    std::string text;
    std::size_t errors = 0;  // told of in it: what keeps the level from being played fairly
};

// Loads the level, checks it (level_check.h) and describes it, errors and warnings last.
[[nodiscard]] Result<LevelPage> describe_level(const std::filesystem::path& path);

}  // namespace gh::load
