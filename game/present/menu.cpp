#include "present/menu.h"

#include "present/theme.h"

#include <imgui.h>

#include <algorithm>

namespace gh::present {

namespace {

ImVec4 tint(ImU32 colour) {
    return ImGui::ColorConvertU32ToFloat4(colour);
}

bool menu_button(const char* label) {
    return ImGui::Button(label, ImVec2(ImGui::GetFontSize() * 16.0f, 0.0f));
}

// A window that is never larger than the screen. `place`: 0 at its left edge, .5 in its middle.
void begin_page(const char* name, const char* title, float place = 0.5f) {
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos(ImVec2(screen.x * place, screen.y * 0.5f), ImGuiCond_Always, ImVec2(place, 0.5f));
    ImGui::SetNextWindowSizeConstraints(ImVec2(0.0f, 0.0f), screen);
    ImGui::Begin(name, nullptr,
                 ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoCollapse |
                     ImGuiWindowFlags_NoMove | ImGuiWindowFlags_AlwaysAutoResize |
                     ImGuiWindowFlags_NoSavedSettings);
    ImGui::PushFont(heading_font());
    ImGui::TextColored(tint(kBrass), "%s", title);
    ImGui::PopFont();
}

void slide(const char* label, float& value, float low, float high, const char* format) {
    ImGui::SliderFloat(label, &value, low, high, format, ImGuiSliderFlags_NoInput);
}

// One key of one action. True: it was chosen.
bool key_button(const std::string& word, bool is_waiting, bool is_missed) {
    const ImVec2 size(ImGui::GetFontSize() * 6.6f, 0.0f);
    if (is_waiting) ImGui::PushStyleColor(ImGuiCol_Button, tint(faded(kBrass, 0.55f)));
    if (is_missed) ImGui::PushStyleColor(ImGuiCol_Text, tint(kAlarm));
    const bool is_chosen = ImGui::Button(is_waiting  ? "press a key"
                                         : is_missed ? "no key"
                                                     : word.c_str(),
                                         size);
    ImGui::PopStyleColor((is_waiting ? 1 : 0) + (is_missed ? 1 : 0));
    return is_chosen;
}

// `first`: the cell that the keyboard moves on from.
void draw_row(const ControlsPage& page, std::size_t row, const std::optional<KeyCell>& first,
              MenuReply& reply) {
    const KeyRow& shown = page.rows[row];
    ImGui::TableNextColumn();
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(shown.what.c_str());
    for (std::size_t place = 0; place < shown.keys.size(); ++place) {
        ImGui::TableNextColumn();
        ImGui::PushID(static_cast<int>(row * shown.keys.size() + place));
        const KeyCell cell{row, place};
        const bool is_waiting = page.waiting == cell;
        const bool is_missed = place == 0 && shown.keys[0].empty() && shown.keys[1].empty();
        if (first == cell) ImGui::SetKeyboardFocusHere();
        if (key_button(shown.keys[place], is_waiting, is_missed)) reply = {MenuAction::AskForKey, cell};
        const bool is_meant = ImGui::IsItemHovered() || ImGui::IsItemFocused();
        if (is_meant && !page.waiting && ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Delete), false))
            reply = {MenuAction::RemoveKey, cell};
        ImGui::PopID();
    }
}

// Two actions side by side, so that all fit on a screen without scrolling.
void draw_rows(const ControlsPage& page, const std::optional<KeyCell>& first, MenuReply& reply) {
    const ImVec2 padding = ImGui::GetStyle().FramePadding;
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(padding.x * 0.5f, padding.y * 0.6f));
    if (ImGui::BeginTable("keys", 7, ImGuiTableFlags_SizingFixedFit)) {
        for (int column = 0; column < 7; ++column)
            ImGui::TableSetupColumn(nullptr, ImGuiTableColumnFlags_WidthFixed,
                                    column == 3 ? ImGui::GetFontSize() : 0.0f);
        const std::size_t half = (page.rows.size() + 1) / 2;
        for (std::size_t i = 0; i < half; ++i) {
            ImGui::TableNextRow();
            draw_row(page, i, first, reply);
            ImGui::TableNextColumn();  // a gap
            if (half + i < page.rows.size()) draw_row(page, half + i, first, reply);
        }
        ImGui::EndTable();
    }
    ImGui::PopStyleVar();
}

}  // namespace

bool Menu::go_back() {
    if (page_ == Page::Main) return false;
    page_ = Page::Main;
    return true;
}

MenuAction Menu::draw_main(const std::string& note) {
    MenuAction action = MenuAction::None;
    begin_page("pause", "Glasshouse");
    if (ImGui::IsWindowAppearing()) ImGui::SetKeyboardFocusHere();
    if (menu_button("Resume")) action = MenuAction::Resume;
    if (menu_button("Settings")) page_ = Page::Settings;
    if (menu_button("Controls")) page_ = Page::Controls;
    if (menu_button("Restart the level")) action = MenuAction::RestartLevel;
    if (menu_button("Quit")) action = MenuAction::Quit;
    if (!note.empty()) {
        ImGui::PushTextWrapPos(ImGui::GetCursorPosX() + ImGui::GetFontSize() * 24.0f);
        ImGui::TextColored(tint(kDim), "%s", note.c_str());
        ImGui::PopTextWrapPos();
    }
    ImGui::End();
    return action;
}

void Menu::draw_settings(MenuSettings& settings) {
    begin_page("settings", "Settings", 0.06f);  // they are judged by the picture beside them
    ImGui::PushItemWidth(ImGui::GetFontSize() * 14.0f);
    if (ImGui::IsWindowAppearing()) ImGui::SetKeyboardFocusHere();
    slide("mouse sensitivity", settings.mouse_sensitivity, 0.1f, 4.0f, "%.2f");
    slide("volume", settings.volume, 0.0f, 1.0f, "%.2f");
    slide("brightness", settings.brightness, -2.0f, 2.0f, "%+.1f stops");
    slide("field of view", settings.field_of_view, 45.0f, 85.0f, "%.0f degrees upright");
    slide("frames a second", settings.frames_a_second, 10.0f, 60.0f, "%.0f");
    int quality = static_cast<int>(settings.quality);
    if (ImGui::Combo("quality", &quality, kQualityWords.data(), static_cast<int>(kQualityWords.size())))
        settings.quality = static_cast<QualityName>(quality);
    ImGui::PopItemWidth();
    ImGui::Checkbox("invert the mouse's up and down", &settings.inverts_y);
    ImGui::Checkbox("crouch stays until pressed again", &settings.toggles_crouch);
    ImGui::Checkbox("captions", &settings.shows_captions);
    ImGui::SameLine();
    ImGui::Checkbox("hints", &settings.shows_hints);
    if (menu_button("Back")) go_back();
    ImGui::End();
}

MenuReply Menu::draw_controls(const ControlsPage& controls) {
    MenuReply reply;
    begin_page("controls", "Controls");
    // What cannot be chosen for a while loses the keyboard's attention: it goes back to where it was.
    std::optional<KeyCell> first;
    if (ImGui::IsWindowAppearing()) first = KeyCell{};
    if (was_waiting_ && !controls.waiting) first = was_waiting_;
    was_waiting_ = controls.waiting;
    ImGui::BeginDisabled(controls.waiting.has_value());
    draw_rows(controls, first, reply);
    ImGui::EndDisabled();
    const bool has_word = !controls.said.empty();
    ImGui::TextColored(
        tint(controls.is_warning ? kAlarm
             : has_word          ? kBrass
                                 : kDim),
        "%s",
        has_word ? controls.said.c_str()
                 : "Enter or click, then the new key. Delete removes one. Esc always opens this menu.");
    ImGui::BeginDisabled(controls.waiting.has_value());
    if (menu_button("Back")) go_back();
    ImGui::SameLine();
    if (menu_button("Defaults")) reply.action = MenuAction::DefaultKeys;
    ImGui::EndDisabled();
    ImGui::End();
    return reply;
}

MenuReply Menu::draw(MenuSettings& settings, const ControlsPage& controls, const std::string& note) {
    const int shade = page_ == Page::Settings ? 0 : 150;
    ImGui::GetBackgroundDrawList()->AddRectFilled(ImVec2(0.0f, 0.0f), ImGui::GetIO().DisplaySize,
                                                  IM_COL32(4, 6, 12, shade));
    switch (page_) {
        case Page::Main:
            return {draw_main(note), {}};
        case Page::Settings:
            draw_settings(settings);
            return {};
        case Page::Controls:
            return draw_controls(controls);
    }
    return {};
}

}  // namespace gh::present
