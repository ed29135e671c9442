// present/menu.h - the title and pause menus.
#pragma once

#include <array>
#include <cstdint>
#include <string>

namespace gh::present {

enum class QualityName : std::uint8_t { Low, Medium, High, Ultra };
inline constexpr std::array kQualityWords = {"low", "medium", "high", "ultra"};

struct MenuSettings {
    float mouse_sensitivity = 1.0f;
    float volume = 0.8f;            // 0..1
    float brightness = 0.0f;        // stops
    float field_of_view = 70.0f;    // degrees from the picture's bottom to its top
    float frames_a_second = 24.0f;  // what the resolution is traded for
    QualityName quality = QualityName::Medium;
    bool inverts_y = false;
    bool toggles_crouch = false;
    bool shows_captions = true;
    bool shows_hints = true;
};

enum class MenuAction { None, Resume, RestartLevel, Quit };

// Draws the menu and lets it change `settings`. `note` is a line about where the run is recorded.
[[nodiscard]] MenuAction draw_pause_menu(MenuSettings& settings, const std::string& note);

// How to play, one line each; shown in the menu and for the first seconds of a run.
void draw_controls();

}  // namespace gh::present
