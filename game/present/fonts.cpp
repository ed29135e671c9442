#include "present/fonts.h"

#include <imgui.h>

#include <array>
#include <filesystem>
#include <string>

namespace gh::present {

namespace {

// Latin, and the punctuation that captions use.
constexpr std::array<ImWchar, 5> kGlyphs = {0x0020, 0x017F, 0x2010, 0x203F, 0};

ImFont* first_that_exists(std::initializer_list<const char*> names, float size_px) {
    ImGuiIO& io = ImGui::GetIO();
    for (const char* name : names) {
        const std::string path = std::string("/usr/share/fonts/") + name;
        std::error_code ignored;
        if (!std::filesystem::exists(path, ignored)) continue;
        if (ImFont* font = io.Fonts->AddFontFromFileTTF(path.c_str(), size_px, nullptr, kGlyphs.data()))
            return font;
    }
    ImFontConfig config;
    config.SizePixels = size_px;
    return io.Fonts->AddFontDefault(&config);
}

}  // namespace

Fonts load_fonts(float scale) {
    ImGui::GetIO().Fonts->Clear();
    Fonts fonts;
    fonts.text = first_that_exists({"truetype/dejavu/DejaVuSans.ttf",
                                    "truetype/liberation/LiberationSans-Regular.ttf", "TTF/DejaVuSans.ttf"},
                                   17.0f * scale);
    fonts.heading = first_that_exists({"opentype/ebgaramond/EBGaramond12-Regular.otf",
                                       "truetype/dejavu/DejaVuSerif.ttf", "TTF/DejaVuSerif.ttf"},
                                      54.0f * scale);
    return fonts;
}

}  // namespace gh::present
