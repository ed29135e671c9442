// app/assets.h - where the game's own files are, on a developer's tree or installed.
#pragma once

#include "base/result.h"

#include <filesystem>
#include <string>

namespace gh::app {

// The assets folder: $GLASSHOUSE_ASSETS, else the nearest assets/levels above the program, else
// ../share/glasshouse/assets beside it.
[[nodiscard]] Result<std::filesystem::path> find_assets();

// A path as it is given when it has a glTF ending or a folder in it, else assets/levels/NAME.glb.
[[nodiscard]] Result<std::filesystem::path> resolve_level(const std::string& name_or_path);

}  // namespace gh::app
