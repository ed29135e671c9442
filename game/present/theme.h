// present/theme.h - the museum's colours: ivory on night blue, brass for what matters, red for alarm.
#pragma once

#include "present/fonts.h"

#include <imgui.h>

namespace gh::present {

inline constexpr ImU32 kIvory = IM_COL32(238, 230, 211, 255);
inline constexpr ImU32 kBrass = IM_COL32(214, 173, 96, 255);
inline constexpr ImU32 kAlarm = IM_COL32(226, 84, 66, 255);
inline constexpr ImU32 kNight = IM_COL32(10, 14, 26, 170);
inline constexpr ImU32 kDim = IM_COL32(150, 152, 160, 255);

// The same colour, `alpha` in [0, 1] times as opaque.
[[nodiscard]] ImU32 faded(ImU32 colour, float alpha);

// How large letters and all that goes with them are in a window: 1 at 1280x720, and in proportion, but never so small that
// they can not be read while there is room for larger ones (.65 at 640x360, letters of 11 pixels).
[[nodiscard]] float ui_scale(float width, float height);

// Colours, and distances for letters `scale` times as large as at 1280x720.
void apply_theme(const Fonts& fonts, float scale);
[[nodiscard]] ImFont* text_font();
[[nodiscard]] ImFont* heading_font();

}  // namespace gh::present
