// app/settings.h - what a player chose in the menu, kept between runs as JSON.
//
// Bad input a damaged file counts as none; a value out of range is brought into it; unknown keys are left alone.
#pragma once

#include "base/result.h"
#include "present/menu.h"

#include <filesystem>

namespace gh::app {

[[nodiscard]] std::filesystem::path settings_path();    // $XDG_CONFIG_HOME/glasshouse/settings.json
[[nodiscard]] std::filesystem::path recordings_path();  // $XDG_DATA_HOME/glasshouse/recordings

[[nodiscard]] present::MenuSettings load_settings(const std::filesystem::path& path);
[[nodiscard]] Result<void> save_settings(const std::filesystem::path& path,
                                         const present::MenuSettings& settings);

}  // namespace gh::app
