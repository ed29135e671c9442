#include "app/pause_menu.h"

namespace gh::app {

PauseMenu::PauseMenu(input::Devices& devices, std::filesystem::path file)
    : devices_(devices), file_(std::move(file)) {
    LoadedSettings loaded = load_settings(file_);
    settings_ = loaded.settings;
    complaints_ = std::move(loaded.complaints);
    words_ = key_words(settings_.keys, input::Devices::label);
}

void PauseMenu::open() {
    menu_.open();
    rebinding_.cancel();
}

bool PauseMenu::go_back() {
    if (rebinding_.is_waiting()) {
        rebinding_.cancel();
        return true;
    }
    rebinding_.forget_words();
    return menu_.go_back();
}

present::MenuAction PauseMenu::draw(const std::string& note) {
    const present::ControlsPage page = rebinding_.page(settings_.keys, input::Devices::label);
    const present::MenuReply reply = menu_.draw(settings_.menu, page, note);
    // After the drawing: what is pressed now was pressed on a page that took no notice.
    if (rebinding_.is_waiting()) {
        const input::Key key = devices_.asked_key();
        if (!key.is_none()) {
            rebinding_.take(key, settings_.keys, input::Devices::label);
            static_cast<void>(devices_.program_keys(settings_.keys));  // bound, not pressed
        }
    }
    obey(reply);
    words_ = key_words(settings_.keys, input::Devices::label);
    return reply.action;
}

void PauseMenu::obey(const present::MenuReply& reply) {
    const input::KeySlot slot{static_cast<input::Action>(reply.cell.row), reply.cell.place};
    switch (reply.action) {
        case present::MenuAction::AskForKey:
            rebinding_.ask_for(slot);
            devices_.begin_asking();
            return;
        case present::MenuAction::RemoveKey:
            return rebinding_.remove(slot, settings_.keys, input::Devices::label);
        case present::MenuAction::DefaultKeys:
            return rebinding_.restore_defaults(settings_.keys);
        default:
            return;  // the game's
    }
}

}  // namespace gh::app
