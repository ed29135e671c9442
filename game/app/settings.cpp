#include "app/settings.h"

#include "app/quality.h"
#include "base/file.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdlib>
#include <string>

namespace gh::app {

namespace fs = std::filesystem;
using nlohmann::json;

namespace {

constexpr std::size_t kMaxSettingsBytes = 1 << 16;

fs::path folder_from(const char* variable, const char* below_home) {
    if (const char* set = std::getenv(variable); set != nullptr && *set == '/')
        return fs::path(set) / "glasshouse";
    const char* home = std::getenv("HOME");
    return fs::path(home != nullptr ? home : ".") / below_home / "glasshouse";
}

void read(const json& from, const char* key, float low, float high, float& value) {
    const auto found = from.find(key);
    if (found != from.end() && found->is_number()) value = std::clamp(found->get<float>(), low, high);
}

void read(const json& from, const char* key, bool& value) {
    const auto found = from.find(key);
    if (found != from.end() && found->is_boolean()) value = found->get<bool>();
}

void read(const json& from, const char* key, present::QualityName& value) {
    const auto found = from.find(key);
    if (found == from.end() || !found->is_string()) return;
    value = quality_named(found->get<std::string>()).value_or(value);
}

json parsed_file(const fs::path& path) {
    const auto bytes = read_file(path, kMaxSettingsBytes);
    if (!bytes) return json::object();
    const auto* text = reinterpret_cast<const char*>(bytes->data());
    json parsed = json::parse(text, text + bytes->size(), nullptr, false);
    return parsed.is_object() ? parsed : json::object();
}

}  // namespace

fs::path settings_path() {
    return folder_from("XDG_CONFIG_HOME", ".config") / "settings.json";
}
fs::path recordings_path() {
    return folder_from("XDG_DATA_HOME", ".local/share") / "recordings";
}

present::MenuSettings load_settings(const fs::path& path) {
    const json from = parsed_file(path);
    present::MenuSettings settings;
    read(from, "mouse_sensitivity", 0.1f, 4.0f, settings.mouse_sensitivity);
    read(from, "volume", 0.0f, 1.0f, settings.volume);
    read(from, "brightness", -2.0f, 2.0f, settings.brightness);
    read(from, "field_of_view", 45.0f, 85.0f, settings.field_of_view);
    read(from, "frames_a_second", 10.0f, 60.0f, settings.frames_a_second);
    read(from, "quality", settings.quality);
    read(from, "inverts_y", settings.inverts_y);
    read(from, "toggles_crouch", settings.toggles_crouch);
    read(from, "shows_captions", settings.shows_captions);
    read(from, "shows_hints", settings.shows_hints);
    return settings;
}

Result<void> save_settings(const fs::path& path, const present::MenuSettings& settings) {
    json to = parsed_file(path);
    to["mouse_sensitivity"] = settings.mouse_sensitivity;
    to["volume"] = settings.volume;
    to["brightness"] = settings.brightness;
    to["field_of_view"] = settings.field_of_view;
    to["frames_a_second"] = settings.frames_a_second;
    to["quality"] = present::kQualityWords[static_cast<std::size_t>(settings.quality)];
    to["inverts_y"] = settings.inverts_y;
    to["toggles_crouch"] = settings.toggles_crouch;
    to["shows_captions"] = settings.shows_captions;
    to["shows_hints"] = settings.shows_hints;
    return write_file_atomically(path, to.dump(2) + "\n");
}

}  // namespace gh::app
