#include "app/rebinding.h"

#include <fmt/format.h>

namespace gh::app {

using input::Action;
using input::Bindings;
using input::Key;
using input::KeySlot;

namespace {

bool has_a_key(const Bindings& bindings, Action action) {
    for (const Key key : bindings.of(action)) {
        if (!key.is_none()) return true;
    }
    return false;
}

}  // namespace

void Rebinding::say(std::string words, bool is_warning) {
    said_ = std::move(words);
    is_warning_ = is_warning;
}

void Rebinding::ask_for(KeySlot slot) {
    waiting_ = slot;
    say(fmt::format("Press the key or mouse button for \"{}\"; Esc leaves it as it is.",
                    input::title_of(slot.action)),
        false);
}

void Rebinding::cancel() {
    waiting_.reset();
    said_.clear();
}

void Rebinding::take(Key key, Bindings& bindings, const KeyLabel& label) {
    if (!waiting_) return;
    const KeySlot slot = *waiting_;
    waiting_.reset();
    const Key before = bindings.of(slot.action)[slot.place];
    const auto loser = input::bind(bindings, slot, key);
    if (!loser || loser->action == slot.action)
        return say(fmt::format("{}: {}.", label(key), input::title_of(slot.action)), false);
    const std::string_view other = input::title_of(loser->action);
    if (!before.is_none())
        return say(fmt::format("{} was \"{}\", which has {} now.", label(key), other, label(before)), false);
    const bool is_left = has_a_key(bindings, loser->action);
    say(fmt::format("{} was \"{}\", which has {} now.", label(key), other, is_left ? "one key" : "no key"),
        !is_left);
}

void Rebinding::remove(KeySlot slot, Bindings& bindings, const KeyLabel& label) {
    const Key before = bindings.of(slot.action)[slot.place];
    if (before.is_none()) return;
    input::bind(bindings, slot, Key{});
    const bool is_left = has_a_key(bindings, slot.action);
    say(fmt::format("{} does nothing now{}.", label(before),
                    is_left ? "" : fmt::format(", and \"{}\" has no key", input::title_of(slot.action))),
        !is_left);
}

void Rebinding::restore_defaults(Bindings& bindings) {
    bindings = input::default_bindings();
    say("Every key is as it was at first.", false);
}

present::ControlsPage Rebinding::page(const Bindings& bindings, const KeyLabel& label) const {
    present::ControlsPage page;
    page.said = said_;
    page.is_warning = is_warning_;
    for (std::size_t i = 0; i < input::kActions; ++i) {
        present::KeyRow& row = page.rows.emplace_back();
        row.what = input::title_of(static_cast<Action>(i));
        for (std::size_t place = 0; place < row.keys.size(); ++place) {
            const Key key = bindings.keys[i][place];
            if (!key.is_none()) row.keys[place] = label(key);
        }
    }
    if (waiting_) page.waiting = present::KeyCell{input::index_of(waiting_->action), waiting_->place};
    return page;
}

}  // namespace gh::app
