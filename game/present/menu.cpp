#include "present/menu.h"

#include "present/theme.h"

#include <imgui.h>

#include <array>

namespace gh::present {

namespace {

struct Control {
    const char* keys;
    const char* what;
};

constexpr std::array kControls = {
    Control{"W A S D, mouse", "walk and look"},
    Control{"Shift", "run (loud)"},
    Control{"Ctrl or C", "crouch (quiet)"},
    Control{"Q / R", "lean left / right"},
    Control{"Space", "jump"},
    Control{"E", "doors, switches, mirrors, lenses"},
    Control{"F", "hold up the hand mirror; Q / R: round a corner"},
    Control{"Left mouse or G", "hold to aim a stone, let go to throw"},
    Control{"Right mouse", "put the stone back"},
    Control{"Backspace", "back to the checkpoint"},
    Control{"F3 / F4", "profiler / what the path tracer sees, plane by plane"},
    Control{"F11 / Esc", "full screen / this menu"},
};

bool wide_button(const char* label) {
    return ImGui::Button(label, ImVec2(ImGui::GetFontSize() * 16.0f, 0.0f));
}

void draw_settings(MenuSettings& settings) {
    ImGui::PushItemWidth(ImGui::GetFontSize() * 10.0f);
    ImGui::SliderFloat("mouse sensitivity", &settings.mouse_sensitivity, 0.1f, 4.0f, "%.2f");
    ImGui::SliderFloat("volume", &settings.volume, 0.0f, 1.0f, "%.2f");
    ImGui::SliderFloat("brightness", &settings.brightness, -2.0f, 2.0f, "%+.1f stops");
    ImGui::SliderFloat("field of view", &settings.field_of_view, 45.0f, 85.0f, "%.0f degrees upright");
    ImGui::SliderFloat("frames a second", &settings.frames_a_second, 10.0f, 60.0f, "%.0f");
    int quality = static_cast<int>(settings.quality);
    if (ImGui::Combo("quality", &quality, kQualityWords.data(), static_cast<int>(kQualityWords.size())))
        settings.quality = static_cast<QualityName>(quality);
    ImGui::PopItemWidth();
    ImGui::Checkbox("invert the mouse's up and down", &settings.inverts_y);
    ImGui::Checkbox("crouch stays until pressed again", &settings.toggles_crouch);
    ImGui::Checkbox("captions", &settings.shows_captions);
    ImGui::SameLine();
    ImGui::Checkbox("hints", &settings.shows_hints);
}

}  // namespace

void draw_controls() {
    if (!ImGui::BeginTable("controls", 2, ImGuiTableFlags_SizingFixedFit)) return;
    for (const Control& control : kControls) {
        ImGui::TableNextRow();
        ImGui::TableNextColumn();
        ImGui::TextColored(ImGui::ColorConvertU32ToFloat4(kBrass), "%s", control.keys);
        ImGui::TableNextColumn();
        ImGui::TextUnformatted(control.what);
    }
    ImGui::EndTable();
}

MenuAction draw_pause_menu(MenuSettings& settings, const std::string& note) {
    MenuAction action = MenuAction::None;
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    ImGui::GetBackgroundDrawList()->AddRectFilled(ImVec2(0.0f, 0.0f), screen, IM_COL32(4, 6, 12, 150));
    ImGui::SetNextWindowPos(ImVec2(screen.x * 0.5f, screen.y * 0.5f), ImGuiCond_Always, ImVec2(0.5f, 0.5f));
    ImGui::Begin(
        "pause", nullptr,
        ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoSavedSettings);
    ImGui::PushFont(heading_font());
    ImGui::TextColored(ImGui::ColorConvertU32ToFloat4(kBrass), "Glasshouse");
    ImGui::PopFont();
    if (ImGui::BeginTable("halves", 2, ImGuiTableFlags_SizingFixedFit)) {
        // As wide as the longest line of what keys do: a table within a table does not ask for room.
        ImGui::TableSetupColumn("play", ImGuiTableColumnFlags_WidthFixed, ImGui::GetFontSize() * 31.0f);
        ImGui::TableSetupColumn("settings", ImGuiTableColumnFlags_WidthFixed);
        ImGui::TableNextColumn();
        if (ImGui::IsWindowAppearing()) ImGui::SetKeyboardFocusHere();
        if (wide_button("Resume")) action = MenuAction::Resume;
        if (wide_button("Restart the level")) action = MenuAction::RestartLevel;
        if (wide_button("Quit")) action = MenuAction::Quit;
        ImGui::Dummy(ImVec2(0.0f, ImGui::GetFontSize() * 0.5f));
        draw_controls();
        ImGui::TableNextColumn();
        draw_settings(settings);
        ImGui::EndTable();
    }
    if (!note.empty()) ImGui::TextColored(ImGui::ColorConvertU32ToFloat4(kDim), "%s", note.c_str());
    ImGui::End();
    return action;
}

}  // namespace gh::present
