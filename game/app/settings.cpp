#include "app/settings.h"

#include "app/quality.h"
#include "base/file.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdlib>

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

struct SettingsFile {
    json content = json::object();
    bool is_there = false;
    bool is_damaged = false;
};

SettingsFile settings_file(const fs::path& path) {
    SettingsFile file;
    const auto bytes = read_file(path, kMaxSettingsBytes);
    std::error_code ignored;
    file.is_there = bytes.has_value() || fs::exists(path, ignored);
    if (!file.is_there) return file;
    json parsed;
    if (bytes) {
        const auto* text = reinterpret_cast<const char*>(bytes->data());
        parsed = json::parse(text, text + bytes->size(), nullptr, false);
    }
    file.is_damaged = !parsed.is_object();
    if (!file.is_damaged) file.content = std::move(parsed);
    return file;
}

// What a sentence can hold of it.
std::string shortened(const std::string& text) {
    constexpr std::size_t kMost = 40;
    return text.size() <= kMost ? text : text.substr(0, kMost) + "...";
}

// Reads a file's entries one by one, and notes which could not be followed.
class SettingsReader {
  public:
    SettingsReader(const fs::path& path, const json& from, std::vector<std::string>& complaints)
        : name_(path.filename().string()), from_(from), complaints_(complaints) {}

    void read(const char* key, float low, float high, float& value) {
        const json* found = entry(key);
        if (found == nullptr) return;
        if (!found->is_number()) return complain(key, "is not a number", fmt::format("{}", value));
        value = std::clamp(found->get<float>(), low, high);
    }

    void read(const char* key, bool& value) {
        const json* found = entry(key);
        if (found == nullptr) return;
        if (!found->is_boolean()) return complain(key, "is neither true nor false", value ? "true" : "false");
        value = found->get<bool>();
    }

    void read(const char* key, present::QualityName& value) {
        const json* found = entry(key);
        if (found == nullptr) return;
        const auto named = found->is_string() ? quality_named(found->get<std::string>()) : std::nullopt;
        if (!named)
            return complain(key, "is not one of low, medium, high, ultra",
                            present::kQualityWords[static_cast<std::size_t>(value)]);
        value = *named;
    }

    void read_keys(input::Bindings& bindings) {
        const json* found = entry("keys");
        if (found == nullptr) return;
        if (!found->is_object()) return complain("keys", "is not a list of actions", "each action's own");
        for (std::size_t i = 0; i < input::kActions; ++i) {
            const auto action = static_cast<input::Action>(i);
            const auto row = found->find(std::string(input::word_of(action)));
            if (row == found->end()) continue;
            if (!row->is_array() || row->size() > input::kKeysAnAction) {
                complain(key_of(action), "is not a list of at most two keys", "its own");
                continue;
            }
            for (std::size_t place = 0; place < input::kKeysAnAction; ++place)
                read_key({action, place}, place < row->size() ? (*row)[place] : json(""), bindings);
        }
    }

  private:
    [[nodiscard]] const json* entry(const char* key) const {
        const auto found = from_.find(key);
        return found != from_.end() ? &*found : nullptr;
    }

    [[nodiscard]] static std::string key_of(input::Action action) {
        return "keys." + std::string(input::word_of(action));
    }

    // Slots are filled one after the other, and whoever had the key gets the slot's in exchange: what the file says nothing
    // of makes room for what it says.
    void read_key(input::KeySlot slot, const json& word, input::Bindings& bindings) {
        const auto key = word.is_string() ? input::key_named(word.get<std::string>()) : std::nullopt;
        const bool is_emptied = word.is_string() && word.get<std::string>().empty();
        if (!key && !is_emptied)
            return complain(key_of(slot.action), "asks for " + shortened(word.dump()) + ", which is no key",
                            "its own");
        const auto owner = input::slot_of(bindings, key.value_or(input::Key{}));
        if (owner && std::find(filled_.begin(), filled_.end(), *owner) != filled_.end())
            return complain(key_of(slot.action),
                            "asks for " + word.dump() + ", which " + key_of(owner->action) + " has",
                            "its own");
        input::bind(bindings, slot, key.value_or(input::Key{}));
        filled_.push_back(slot);
    }

    void complain(const std::string& key, const std::string& what, const std::string& otherwise) {
        complaints_.push_back(name_ + ": " + key + " " + what + "; used is " + otherwise);
    }

    std::string name_;
    const json& from_;
    std::vector<std::string>& complaints_;
    std::vector<input::KeySlot> filled_;
};

json keys_to_json(const input::Bindings& bindings) {
    json keys = json::object();
    for (std::size_t i = 0; i < input::kActions; ++i) {
        const auto action = static_cast<input::Action>(i);
        json& row = keys[std::string(input::word_of(action))] = json::array();
        for (const input::Key key : bindings.of(action)) row.push_back(std::string(input::word_of(key)));
    }
    return keys;
}

}  // namespace

fs::path settings_path() {
    return folder_from("XDG_CONFIG_HOME", ".config") / "settings.json";
}
fs::path recordings_path() {
    return folder_from("XDG_DATA_HOME", ".local/share") / "recordings";
}

LoadedSettings load_settings(const fs::path& path) {
    LoadedSettings loaded;
    const SettingsFile file = settings_file(path);
    const std::string name = path.filename().string();
    if (file.is_damaged) loaded.complaints.push_back(name + ": is no JSON object; everything is as at first");
    if (const auto version = file.content.find("version"); version != file.content.end()) {
        if (!version->is_number_integer() || version->get<double>() > kSettingsVersion)
            loaded.complaints.push_back(name + ": is of version " + shortened(version->dump()) +
                                        ", and this game knows " + std::to_string(kSettingsVersion) +
                                        "; what it knows of it is used");
    }
    SettingsReader reader(path, file.content, loaded.complaints);
    present::MenuSettings& menu = loaded.settings.menu;
    reader.read("mouse_sensitivity", 0.1f, 4.0f, menu.mouse_sensitivity);
    reader.read("volume", 0.0f, 1.0f, menu.volume);
    reader.read("brightness", -2.0f, 2.0f, menu.brightness);
    reader.read("field_of_view", 45.0f, 85.0f, menu.field_of_view);
    reader.read("frames_a_second", 10.0f, 60.0f, menu.frames_a_second);
    reader.read("quality", menu.quality);
    reader.read("inverts_y", menu.inverts_y);
    reader.read("toggles_crouch", menu.toggles_crouch);
    reader.read("shows_captions", menu.shows_captions);
    reader.read("shows_hints", menu.shows_hints);
    reader.read_keys(loaded.settings.keys);
    return loaded;
}

Result<void> save_settings(const fs::path& path, const Settings& settings) {
    SettingsFile file = settings_file(path);
    if (file.is_damaged) {
        std::error_code ignored;  // what cannot be put aside cannot be written over either
        fs::rename(path, path.string() + ".damaged", ignored);
    }
    json& to = file.content;
    const present::MenuSettings& menu = settings.menu;
    to["version"] = kSettingsVersion;
    to["mouse_sensitivity"] = menu.mouse_sensitivity;
    to["volume"] = menu.volume;
    to["brightness"] = menu.brightness;
    to["field_of_view"] = menu.field_of_view;
    to["frames_a_second"] = menu.frames_a_second;
    to["quality"] = present::kQualityWords[static_cast<std::size_t>(menu.quality)];
    to["inverts_y"] = menu.inverts_y;
    to["toggles_crouch"] = menu.toggles_crouch;
    to["shows_captions"] = menu.shows_captions;
    to["shows_hints"] = menu.shows_hints;
    to["keys"] = keys_to_json(settings.keys);
    return write_file_atomically(path, to.dump(2, ' ', false, json::error_handler_t::replace) + "\n");
}

}  // namespace gh::app
