#include "present/profiler.h"

#include "present/theme.h"

#include <imgui.h>

#include <algorithm>

namespace gh::present {

namespace {

void rows(const char* title, float total_ms, const std::vector<ProfileRow>& list) {
    ImGui::TextColored(ImGui::ColorConvertU32ToFloat4(kBrass), "%s  %.2f ms", title,
                       static_cast<double>(total_ms));
    for (const ProfileRow& row : list) {
        const float share = total_ms > 0.0f ? row.ms / total_ms : 0.0f;
        ImGui::ProgressBar(share, ImVec2(ImGui::GetFontSize() * 4.0f, ImGui::GetFontSize() * 0.7f), "");
        ImGui::SameLine();
        ImGui::Text("%7.3f  %s", static_cast<double>(row.ms), row.name.c_str());
    }
}

}  // namespace

void draw_profiler(const ProfileModel& model) {
    constexpr float kMargin = 10.0f;
    ImGui::SetNextWindowPos(ImVec2(kMargin, kMargin), ImGuiCond_Always);
    ImGui::SetNextWindowBgAlpha(0.78f);
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(8.0f, 2.0f));
    ImGui::Begin("profiler", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_AlwaysAutoResize |
                     ImGuiWindowFlags_NoInputs | ImGuiWindowFlags_NoSavedSettings |
                     ImGuiWindowFlags_NoFocusOnAppearing);
    // All of it at once: whoever looks for a spike has no hand free to scroll.
    const std::size_t lines = model.frame_rooms.size() + model.tick_rooms.size() + model.rays.size() + 7;
    const ImGuiStyle& style = ImGui::GetStyle();
    const float room = ImGui::GetIO().DisplaySize.y - 2.0f * (kMargin + style.WindowPadding.y) -
                       static_cast<float>(lines) * style.ItemSpacing.y;
    const float wanted = static_cast<float>(lines) * ImGui::GetTextLineHeight();
    ImGui::SetWindowFontScale(std::clamp(room / wanted, 0.5f, 1.0f));
    ImGui::TextUnformatted(model.machine.c_str());
    if (!model.frame_history_ms.empty()) {
        ImGui::PlotLines("", model.frame_history_ms.data(), static_cast<int>(model.frame_history_ms.size()),
                         0, nullptr, 0.0f, 100.0f,
                         ImVec2(ImGui::GetFontSize() * 14.0f, ImGui::GetFontSize() * 2.0f));
    }
    rows("frame", model.frame_ms, model.frame_rooms);
    rows("tick", model.tick_ms, model.tick_rooms);
    ImGui::TextColored(ImGui::ColorConvertU32ToFloat4(kBrass), "rays");
    for (const ProfileModel::Rays& rays : model.rays) {
        ImGui::Text("%9llu  %s", static_cast<unsigned long long>(rays.count), rays.layer.c_str());
    }
    ImGui::End();
    ImGui::PopStyleVar();
}

}  // namespace gh::present
