// present/fonts.h - the typefaces of menus and HUD, from the system's fonts; ImGui's own where there are none.
#pragma once

struct ImFont;

namespace gh::present {

struct Fonts {
    ImFont* text = nullptr;     // captions, prompts, profiler
    ImFont* heading = nullptr;  // titles
};

// After ImGui::CreateContext, instead of those there were. `scale`: 1 where letters are 17 pixels high.
[[nodiscard]] Fonts load_fonts(float scale);

}  // namespace gh::present
