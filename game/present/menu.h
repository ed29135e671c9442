// present/menu.h - the pause menu: its pages, and what is asked of the program on them.
//
// Fits      every page lies within the window from 640x360 up, in letters of at least eleven pixels; smaller windows get
//           smaller letters.
// Threads   the window's thread, between Window::begin_frame and end_frame.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

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

// One action and its keys, as the menu shows them.
struct KeyRow {
    std::string what;
    std::array<std::string, 2> keys;  // empty: none
};

struct KeyCell {
    std::size_t row = 0;
    std::size_t place = 0;

    bool operator==(const KeyCell&) const = default;
};

struct ControlsPage {
    std::vector<KeyRow> rows;
    std::optional<KeyCell> waiting;  // the one that takes the next key; nothing else can be touched meanwhile
    std::string said;                // about what was done last
    bool is_warning = false;         // what is said
};

enum class MenuAction : std::uint8_t { None, Resume, RestartLevel, Quit, AskForKey, RemoveKey, DefaultKeys };

struct MenuReply {
    MenuAction action = MenuAction::None;
    KeyCell cell;  // of AskForKey and RemoveKey
};

class Menu {
  public:
    // On its first page.
    void open() { page_ = Page::Main; }
    // Towards the first page. False: it is shown already.
    bool go_back();
    // Draws the page and lets it change `settings`. `note` is a line about where the run is recorded.
    [[nodiscard]] MenuReply draw(MenuSettings& settings, const ControlsPage& controls,
                                 const std::string& note);

  private:
    enum class Page : std::uint8_t { Main, Settings, Controls };
    [[nodiscard]] MenuAction draw_main(const std::string& note);
    void draw_settings(MenuSettings& settings);
    [[nodiscard]] MenuReply draw_controls(const ControlsPage& controls);

    Page page_ = Page::Main;
    std::optional<KeyCell> was_waiting_;  // a frame ago
};

}  // namespace gh::present
