#include "present/theme.h"

#include <algorithm>

namespace gh::present {

ImU32 faded(ImU32 colour, float alpha) {
    const float opacity = static_cast<float>(colour >> IM_COL32_A_SHIFT) * std::clamp(alpha, 0.0f, 1.0f);
    return (colour & ~IM_COL32_A_MASK) | (static_cast<ImU32>(opacity) << IM_COL32_A_SHIFT);
}

// load_fonts adds text first and heading second: the atlas itself remembers them, so nothing global does.
ImFont* text_font() {
    return ImGui::GetIO().Fonts->Fonts[0];
}
ImFont* heading_font() {
    return ImGui::GetIO().Fonts->Fonts[ImGui::GetIO().Fonts->Fonts.Size - 1];
}

float ui_scale(float width, float height) {
    constexpr float kReadable = 0.65f;
    const float in_proportion = std::min(width / 1280.0f, height / 720.0f);
    const float at_most = std::min(width / 640.0f, height / 360.0f) * kReadable;
    return std::clamp(std::max(in_proportion, std::min(kReadable, at_most)), 0.2f, 6.0f);
}

void apply_theme(const Fonts& fonts, float scale) {
    ImGui::GetIO().FontDefault = fonts.text;
    ImGuiStyle& style = ImGui::GetStyle();
    style = ImGuiStyle();
    ImGui::StyleColorsDark();
    style.WindowRounding = 3.0f;
    style.FrameRounding = 2.0f;
    style.GrabRounding = 2.0f;
    style.WindowBorderSize = 0.0f;
    style.WindowPadding = ImVec2(22.0f, 18.0f);
    style.FramePadding = ImVec2(12.0f, 7.0f);
    style.ItemSpacing = ImVec2(10.0f, 9.0f);
    style.Colors[ImGuiCol_WindowBg] = ImVec4(0.035f, 0.05f, 0.09f, 0.93f);
    style.Colors[ImGuiCol_Text] = ImGui::ColorConvertU32ToFloat4(kIvory);
    style.Colors[ImGuiCol_Button] = ImVec4(0.10f, 0.13f, 0.20f, 1.0f);
    style.Colors[ImGuiCol_ButtonHovered] = ImVec4(0.42f, 0.34f, 0.19f, 1.0f);
    style.Colors[ImGuiCol_ButtonActive] = ImVec4(0.60f, 0.48f, 0.26f, 1.0f);
    style.Colors[ImGuiCol_FrameBg] = ImVec4(0.10f, 0.13f, 0.20f, 1.0f);
    style.Colors[ImGuiCol_FrameBgHovered] = ImVec4(0.16f, 0.19f, 0.27f, 1.0f);
    style.Colors[ImGuiCol_FrameBgActive] = ImVec4(0.22f, 0.24f, 0.30f, 1.0f);
    style.Colors[ImGuiCol_SliderGrab] = ImVec4(0.50f, 0.40f, 0.21f, 1.0f);  // its number is written across it
    style.Colors[ImGuiCol_SliderGrabActive] = ImVec4(0.60f, 0.48f, 0.26f, 1.0f);
    style.Colors[ImGuiCol_CheckMark] = ImGui::ColorConvertU32ToFloat4(kBrass);
    style.Colors[ImGuiCol_NavHighlight] = ImGui::ColorConvertU32ToFloat4(kBrass);
    style.ScaleAllSizes(scale);
}

}  // namespace gh::present
