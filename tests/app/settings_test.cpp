#include "app/settings.h"

#include "base/file.h"

#include <gtest/gtest.h>

#include <fstream>

namespace gh::app {
namespace {

namespace fs = std::filesystem;

class Settings : public ::testing::Test {
  protected:
    fs::path folder_ = fs::temp_directory_path() / ("glasshouse_settings_" + std::to_string(::getpid()));
    fs::path file_ = folder_ / "settings.json";
    void TearDown() override { fs::remove_all(folder_); }
};

TEST_F(Settings, ComeBackAsTheyWereSaved) {
    present::MenuSettings saved;
    saved.mouse_sensitivity = 2.25f;
    saved.volume = 0.125f;
    saved.quality = present::QualityName::Ultra;
    saved.inverts_y = true;
    saved.shows_captions = false;
    saved.shows_hints = false;
    saved.field_of_view = 58.0f;
    ASSERT_TRUE(save_settings(file_, saved));
    const present::MenuSettings loaded = load_settings(file_);
    EXPECT_EQ(loaded.mouse_sensitivity, 2.25f);
    EXPECT_EQ(loaded.volume, 0.125f);
    EXPECT_EQ(loaded.quality, present::QualityName::Ultra);
    EXPECT_TRUE(loaded.inverts_y);
    EXPECT_FALSE(loaded.shows_captions);
    EXPECT_FALSE(loaded.shows_hints);
    EXPECT_EQ(loaded.field_of_view, 58.0f);
    EXPECT_FALSE(loaded.toggles_crouch);
}

TEST_F(Settings, DamagedOrMissingFilesGiveTheDefaults) {
    const present::MenuSettings defaults;
    EXPECT_EQ(load_settings(file_).volume, defaults.volume);
    for (const char* text : {"", "{", "[1,2]", "null",
                             "{\"volume\": \"loud\", \"inverts_y\": 3, \"quality\": \"best\"}", "\xFF\xFE"}) {
        ASSERT_TRUE(write_file_atomically(file_, std::string_view(text)));
        EXPECT_EQ(load_settings(file_).volume, defaults.volume) << text;
        EXPECT_FALSE(load_settings(file_).inverts_y) << text;
        EXPECT_EQ(load_settings(file_).quality, defaults.quality) << text;
    }
}

TEST_F(Settings, ValuesOutOfRangeAreBroughtIntoItAndStrangersAreKept) {
    ASSERT_TRUE(write_file_atomically(
        file_,
        std::string_view(
            "{\"volume\": 99, \"mouse_sensitivity\": -1, \"field_of_view\": 170, \"mods\": [\"x\"]}")));
    const present::MenuSettings loaded = load_settings(file_);
    EXPECT_EQ(loaded.volume, 1.0f);
    EXPECT_EQ(loaded.mouse_sensitivity, 0.1f);
    EXPECT_EQ(loaded.field_of_view, 85.0f);
    ASSERT_TRUE(save_settings(file_, loaded));
    const auto bytes = read_file(file_, 1 << 16);
    ASSERT_TRUE(bytes);
    const std::string text(reinterpret_cast<const char*>(bytes->data()), bytes->size());
    EXPECT_NE(text.find("\"mods\""), std::string::npos);
}

}  // namespace
}  // namespace gh::app
