// app/settings.h - what a player chose in the menu, kept between runs as JSON.
//
// Bad input whatever cannot be meant stays as it is by default and gets a sentence; numbers out of range are brought into it;
//           unknown keys are left alone. A file that is no JSON at all is put aside under another name before the
//           next saving.
#pragma once

#include "base/result.h"
#include "input/bindings.h"
#include "present/menu.h"

#include <filesystem>
#include <string>
#include <vector>

namespace gh::app {

inline constexpr int kSettingsVersion = 1;

struct Settings {
    present::MenuSettings menu;
    input::Bindings keys = input::default_bindings();
};

struct LoadedSettings {
    Settings settings;
    std::vector<std::string> complaints;  // a sentence for each thing in the file that was not followed
};

[[nodiscard]] std::filesystem::path settings_path();    // $XDG_CONFIG_HOME/glasshouse/settings.json
[[nodiscard]] std::filesystem::path recordings_path();  // $XDG_DATA_HOME/glasshouse/recordings

// A file that is not there is the defaults, without complaint.
[[nodiscard]] LoadedSettings load_settings(const std::filesystem::path& path);
[[nodiscard]] Result<void> save_settings(const std::filesystem::path& path, const Settings& settings);

}  // namespace gh::app
