// present/fonts.h - the typefaces of menus and HUD, from the system's fonts; ImGui's own where there are none.
#pragma once

struct ImFont;

namespace gh::present {

struct Fonts {
    ImFont* text = nullptr;     // captions, prompts, profiler
    ImFont* heading = nullptr;  // titles
};

// Once, after ImGui::CreateContext. `scale`: framebuffer pixels per screen unit.
[[nodiscard]] Fonts load_fonts(float scale);

}  // namespace gh::present
