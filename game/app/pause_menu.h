// app/pause_menu.h - the menu with all it changes: the settings, the keys, and the file that keeps them.
#pragma once

#include "app/rebinding.h"
#include "app/settings.h"
#include "input/devices.h"

#include <filesystem>

namespace gh::app {

class PauseMenu {
  public:
    // Borrows the devices. Settings are those of the file.
    PauseMenu(input::Devices& devices, std::filesystem::path file);

    void open();
    // Esc: takes back a question for a key, or leaves a page. False: there is nothing left to leave but the menu.
    bool go_back();
    // While it is, keys are to be bound and nothing else.
    [[nodiscard]] bool asks_for_key() const { return rebinding_.is_waiting(); }

    // Between Window::begin_frame and end_frame. Resume, RestartLevel, Quit, or None.
    [[nodiscard]] present::MenuAction draw(const std::string& note);

    [[nodiscard]] Result<void> save() const { return save_settings(file_, settings_); }
    [[nodiscard]] present::MenuSettings& settings() { return settings_.menu; }
    [[nodiscard]] const input::Bindings& keys() const { return settings_.keys; }
    [[nodiscard]] const KeyWords& words() const { return words_; }
    // What in the file could not be followed, a sentence each.
    [[nodiscard]] const std::vector<std::string>& complaints() const { return complaints_; }

  private:
    void obey(const present::MenuReply& reply);

    input::Devices& devices_;
    std::filesystem::path file_;
    Settings settings_;
    std::vector<std::string> complaints_;
    KeyWords words_;
    Rebinding rebinding_;
    present::Menu menu_;
};

}  // namespace gh::app
