#include "app/settings.h"

#include "app/key_words.h"
#include "base/file.h"

#include <gtest/gtest.h>

#include <fstream>
#include <string_view>

namespace gh::app {
namespace {

namespace fs = std::filesystem;
using input::Action;

class SettingsTest : public ::testing::Test {
  protected:
    fs::path folder_ = fs::temp_directory_path() / ("glasshouse_settings_" + std::to_string(::getpid()));
    fs::path file_ = folder_ / "settings.json";
    void TearDown() override { fs::remove_all(folder_); }

    void write(std::string_view text) { ASSERT_TRUE(write_file_atomically(file_, text)); }
    static std::string text_of(const fs::path& path) {
        const auto bytes = read_file(path, 1 << 16);
        return bytes ? std::string(reinterpret_cast<const char*>(bytes->data()), bytes->size()) : "no file";
    }
    static std::string words(const LoadedSettings& loaded, Action action) {
        return key_words(loaded.settings.keys).one(action);
    }
};

TEST_F(SettingsTest, ComeBackAsTheyWereSaved) {
    Settings saved;
    saved.menu.mouse_sensitivity = 2.25f;
    saved.menu.volume = 0.125f;
    saved.menu.quality = present::QualityName::Ultra;
    saved.menu.inverts_y = true;
    saved.menu.shows_captions = false;
    saved.menu.shows_hints = false;
    saved.menu.field_of_view = 58.0f;
    bind(saved.keys, {Action::Use, 0}, *input::key_named("mouse 4"));
    bind(saved.keys, {Action::Crouch, 1}, input::Key{});
    bind(saved.keys, {Action::WalkLeft, 0}, *input::key_named("\\"));
    ASSERT_TRUE(save_settings(file_, saved));
    const LoadedSettings loaded = load_settings(file_);
    EXPECT_TRUE(loaded.complaints.empty()) << loaded.complaints.front();
    const present::MenuSettings& menu = loaded.settings.menu;
    EXPECT_EQ(menu.mouse_sensitivity, 2.25f);
    EXPECT_EQ(menu.volume, 0.125f);
    EXPECT_EQ(menu.quality, present::QualityName::Ultra);
    EXPECT_TRUE(menu.inverts_y);
    EXPECT_FALSE(menu.shows_captions);
    EXPECT_FALSE(menu.shows_hints);
    EXPECT_EQ(menu.field_of_view, 58.0f);
    EXPECT_FALSE(menu.toggles_crouch);
    EXPECT_EQ(loaded.settings.keys, saved.keys);
}

TEST_F(SettingsTest, NoFileAndFilesOfBeforeKeysCouldBeBoundAreNoCauseForComplaint) {
    EXPECT_TRUE(load_settings(file_).complaints.empty());
    write("{\"volume\": 0.5, \"quality\": \"high\"}");
    const LoadedSettings loaded = load_settings(file_);
    EXPECT_TRUE(loaded.complaints.empty());
    EXPECT_EQ(loaded.settings.menu.volume, 0.5f);
    EXPECT_EQ(loaded.settings.keys, input::default_bindings());
}

TEST_F(SettingsTest, DamagedFilesGiveTheDefaultsAndOneSentence) {
    const present::MenuSettings defaults;
    for (const char* text : {"", "{", "[1,2]", "null", "\xFF\xFE", "{\"volume\": 0.25,}"}) {
        write(text);
        const LoadedSettings loaded = load_settings(file_);
        EXPECT_EQ(loaded.settings.menu.volume, defaults.volume) << text;
        ASSERT_EQ(loaded.complaints.size(), 1u) << text;
        EXPECT_NE(loaded.complaints[0].find("settings.json"), std::string::npos) << loaded.complaints[0];
    }
}

TEST_F(SettingsTest, ADamagedFileIsPutAsideBeforeAnotherTakesItsPlace) {
    write("{\"volume\": 0.25,}");
    ASSERT_TRUE(save_settings(file_, Settings()));
    EXPECT_TRUE(load_settings(file_).complaints.empty());
    EXPECT_EQ(text_of(file_.string() + ".damaged"), "{\"volume\": 0.25,}");
}

TEST_F(SettingsTest, EveryEntryThatCannotBeMeantGetsASentenceAndItsDefaultAndTheRestCounts) {
    write("{\"volume\": \"loud\", \"inverts_y\": 3, \"quality\": \"best\", \"field_of_view\": 60}");
    const LoadedSettings loaded = load_settings(file_);
    const present::MenuSettings defaults;
    EXPECT_EQ(loaded.settings.menu.volume, defaults.volume);
    EXPECT_EQ(loaded.settings.menu.inverts_y, defaults.inverts_y);
    EXPECT_EQ(loaded.settings.menu.quality, defaults.quality);
    EXPECT_EQ(loaded.settings.menu.field_of_view, 60.0f);
    ASSERT_EQ(loaded.complaints.size(), 3u);
    EXPECT_NE(loaded.complaints[0].find("volume"), std::string::npos) << loaded.complaints[0];
}

TEST_F(SettingsTest, AKeyThatDoesNotExistGetsASentenceAndTheOneThatWas) {
    write(
        "{\"version\": 1, \"keys\": {\"use\": [\"Hyper\"], \"jump\": [\"J\"], \"run\": 7, \"fly\": "
        "[\"X\"]}}");
    const LoadedSettings loaded = load_settings(file_);
    ASSERT_EQ(loaded.complaints.size(), 2u);
    EXPECT_NE(loaded.complaints[0].find("keys.run"), std::string::npos) << loaded.complaints[0];
    EXPECT_NE(loaded.complaints[1].find("Hyper"), std::string::npos) << loaded.complaints[1];
    EXPECT_EQ(words(loaded, Action::Use), "E");
    EXPECT_EQ(words(loaded, Action::Jump), "J");
    EXPECT_EQ(words(loaded, Action::Run), "Shift");
}

// Who writes one line by hand need not know what else lies on that key.
TEST_F(SettingsTest, AKeyThatAnotherActionHasByDefaultIsExchanged) {
    write("{\"keys\": {\"use\": [\"F\"]}}");
    const LoadedSettings loaded = load_settings(file_);
    EXPECT_TRUE(loaded.complaints.empty());
    EXPECT_EQ(words(loaded, Action::Use), "F");
    EXPECT_EQ(words(loaded, Action::HandMirror), "E");
}

TEST_F(SettingsTest, AKeyThatTheFileGivesTwiceStaysWithTheFirst) {
    write("{\"keys\": {\"use\": [\"X\"], \"jump\": [\"x\"]}}");
    const LoadedSettings loaded = load_settings(file_);
    ASSERT_EQ(loaded.complaints.size(), 1u);
    EXPECT_EQ(words(loaded, Action::Jump), "X") << "jumping comes first in the menu";
    EXPECT_EQ(words(loaded, Action::Use), "E");
}

TEST_F(SettingsTest, ANewerVersionIsReadAsFarAsItIsKnown) {
    write("{\"version\": 9, \"volume\": 0.5}");
    const LoadedSettings loaded = load_settings(file_);
    EXPECT_EQ(loaded.complaints.size(), 1u);
    EXPECT_EQ(loaded.settings.menu.volume, 0.5f);
}

TEST_F(SettingsTest, ValuesOutOfRangeAreBroughtIntoItAndStrangersAreKept) {
    write("{\"volume\": 99, \"mouse_sensitivity\": -1, \"field_of_view\": 170, \"mods\": [\"x\"]}");
    const Settings loaded = load_settings(file_).settings;
    EXPECT_EQ(loaded.menu.volume, 1.0f);
    EXPECT_EQ(loaded.menu.mouse_sensitivity, 0.1f);
    EXPECT_EQ(loaded.menu.field_of_view, 85.0f);
    ASSERT_TRUE(save_settings(file_, loaded));
    EXPECT_NE(text_of(file_).find("\"mods\""), std::string::npos);
}

}  // namespace
}  // namespace gh::app
