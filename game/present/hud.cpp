#include "present/hud.h"

#include "present/theme.h"
#include "present/window.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>

namespace gh::present {

namespace {

struct Canvas {
    ImDrawList* list;
    ImVec2 origin;
    ImVec2 size;
    float unit;     // pixels in a 720 pixel high picture's pixel
    float letters;  // the same for words, which must not become too small to read

    [[nodiscard]] ImVec2 at(float x, float y) const { return {origin.x + x, origin.y + y}; }
};

struct Lettering {
    ImFont* font;
    float size;  // in pixels of a 720 pixel high picture
};

void text(const Canvas& canvas, const Lettering& lettering, ImVec2 at, ImU32 colour, const std::string& words,
          float align) {
    ImFont* const font = lettering.font;
    const float px = lettering.size * canvas.letters;
    const ImVec2 extent = font->CalcTextSizeA(px, 1e9f, 0.0f, words.c_str());
    const ImVec2 from(at.x - extent.x * align, at.y);
    // Dark all round: under a lamp the picture is as light as the letters.
    const float opacity = static_cast<float>(colour >> IM_COL32_A_SHIFT) / 255.0f;
    const ImU32 shade = faded(IM_COL32(0, 0, 0, 255), opacity * opacity * 0.5f);
    const float edge = std::max(1.0f, 0.9f * canvas.letters);
    for (const ImVec2 side :
         {ImVec2(-edge, 0.0f), ImVec2(edge, 0.0f), ImVec2(0.0f, -edge), ImVec2(0.0f, edge)})
        canvas.list->AddText(font, px, ImVec2(from.x + side.x, from.y + side.y), shade, words.c_str());
    canvas.list->AddText(font, px, from, colour, words.c_str());
}

// What of a diamond lies below `share` of its height.
void fill_diamond(ImDrawList* list, ImVec2 c, float half_width, float half_height, float share,
                  ImU32 colour) {
    if (share <= 0.0f) return;
    const float y = c.y + half_height * (1.0f - 2.0f * share);
    const float half = half_width * (1.0f - std::abs(2.0f * share - 1.0f));
    list->PathLineTo(ImVec2(c.x, c.y + half_height));
    if (share > 0.5f) list->PathLineTo(ImVec2(c.x - half_width, c.y));
    list->PathLineTo(ImVec2(c.x - half, y));
    if (share < 1.0f) list->PathLineTo(ImVec2(c.x + half, y));
    if (share > 0.5f) list->PathLineTo(ImVec2(c.x + half_width, c.y));
    list->PathFillConvex(colour);
}

// The light gem: a diamond that fills with light from below.
void draw_gem(const Canvas& canvas, const HudModel& model) {
    const float r = 26.0f * canvas.unit;
    const ImVec2 c = canvas.at(canvas.size.x * 0.5f, canvas.size.y - 46.0f * canvas.unit);
    const ImVec2 top(c.x, c.y - r), right(c.x + r * 0.72f, c.y), bottom(c.x, c.y + r),
        left(c.x - r * 0.72f, c.y);
    canvas.list->AddQuadFilled(top, right, bottom, left, IM_COL32(8, 10, 18, 225));
    const float lit = std::clamp(model.exposure, 0.0f, 1.0f);
    const ImU32 glow =
        IM_COL32(255, 190 + static_cast<int>(50.0f * lit), 90 + static_cast<int>(120.0f * lit), 255);
    fill_diamond(canvas.list, c, r * 0.72f, r, lit, faded(glow, 0.55f + 0.45f * lit));
    canvas.list->AddQuad(top, right, bottom, left, faded(kBrass, 0.9f), 1.6f * canvas.unit);
    canvas.list->AddLine(top, bottom, faded(kBrass, 0.35f), canvas.unit);
    canvas.list->AddLine(left, right, faded(kBrass, 0.35f), canvas.unit);

    // Noise: bars to both sides, as far as it carries.
    constexpr int kBars = 7;
    for (int i = 0; i < kBars; ++i) {
        const float share = (static_cast<float>(i) + 0.5f) / kBars;
        const float height = (4.0f + 9.0f * share) * canvas.unit;
        const ImU32 colour = model.noise > share ? (share > 0.7f ? kAlarm : kIvory) : faded(kIvory, 0.30f);
        for (const float side : {-1.0f, 1.0f}) {
            const float x = c.x + side * (34.0f + 7.0f * static_cast<float>(i)) * canvas.unit;
            canvas.list->AddRectFilled(ImVec2(x - 1.6f * canvas.unit, c.y - height),
                                       ImVec2(x + 1.6f * canvas.unit, c.y + height), colour);
        }
    }
}

void draw_stance(const Canvas& canvas, const HudModel& model) {
    const char* stance = model.is_crouched  ? "crouching"
                         : model.is_running ? "running"
                         : model.is_walking ? "walking"
                                            : "standing";
    const ImVec2 at =
        canvas.at(canvas.size.x * 0.5f - 112.0f * canvas.unit, canvas.size.y - 56.0f * canvas.unit);
    text(canvas, {text_font(), 15.0f}, at, faded(kIvory, 0.9f), stance, 1.0f);
    char stones[48];
    std::snprintf(stones, sizeof stones, "%d %s", model.stones_left,
                  model.stones_left == 1 ? "stone" : "stones");
    const ImVec2 right =
        canvas.at(canvas.size.x * 0.5f + 112.0f * canvas.unit, canvas.size.y - 56.0f * canvas.unit);
    text(canvas, {text_font(), 15.0f}, right, faded(kIvory, model.stones_left > 0 ? 0.9f : 0.4f), stones,
         0.0f);
    if (!model.mirror.empty()) {
        const ImVec2 under =
            canvas.at(canvas.size.x * 0.5f + 112.0f * canvas.unit, canvas.size.y - 36.0f * canvas.unit);
        text(canvas, {text_font(), 15.0f}, under, faded(kIvory, 0.9f), model.mirror, 0.0f);
    }
    if (model.lenses_total == 0) return;
    char lenses[64];
    std::snprintf(lenses, sizeof lenses, "lenses %d / %d", model.lenses_taken, model.lenses_total);
    const ImU32 colour = model.lenses_taken == model.lenses_total ? kBrass : faded(kIvory, 0.9f);
    text(canvas, {text_font(), 15.0f}, canvas.at(canvas.size.x - 24.0f * canvas.unit, 20.0f * canvas.unit),
         colour, lenses, 1.0f);
}

ImU32 colour_of(Mood mood) {
    switch (mood) {
        case Mood::Calm:
            return kIvory;
        case Mood::Suspicious:
            return IM_COL32(240, 214, 110, 255);
        case Mood::Searching:
            return IM_COL32(240, 150, 70, 255);
        case Mood::Chasing:
            return kAlarm;
    }
    return kIvory;
}

// Arcs round the middle: where each guard is that knows something, and how much.
void draw_guards(const Canvas& canvas, const HudModel& model) {
    const ImVec2 centre = canvas.at(canvas.size.x * 0.5f, canvas.size.y * 0.5f);
    const float radius = 118.0f * canvas.unit;
    for (const GuardMark& guard : model.guards) {
        if (guard.mood == Mood::Calm && guard.suspicion < 0.04f) continue;
        const float angle = guard.bearing - 1.5707963f;
        const float half = 0.10f + 0.20f * std::clamp(guard.suspicion, 0.0f, 1.0f);
        const float alpha = guard.mood == Mood::Calm ? 0.25f + 0.5f * guard.suspicion : 0.9f;
        canvas.list->PathArcTo(centre, radius, angle - 0.31f, angle + 0.31f, 24);
        canvas.list->PathStroke(IM_COL32(0, 0, 0, 90), 0, 5.0f * canvas.unit);
        canvas.list->PathArcTo(centre, radius, angle - half, angle + half, 24);
        canvas.list->PathStroke(faded(colour_of(guard.mood), alpha), 0, 4.0f * canvas.unit);
        if (guard.mood == Mood::Calm) continue;
        const ImVec2 at(centre.x + std::cos(angle) * (radius + 22.0f * canvas.unit),
                        centre.y + std::sin(angle) * (radius + 22.0f * canvas.unit) - 9.0f * canvas.unit);
        const char* mark = guard.mood == Mood::Suspicious ? "?" : guard.mood == Mood::Searching ? "??" : "!";
        text(canvas, {text_font(), 20.0f}, at, colour_of(guard.mood),
             mark + (guard.cue.empty() ? "" : "  " + guard.cue), 0.5f);
    }
}

void draw_aim(const Canvas& canvas, const HudModel& model) {
    const ImVec2 centre = canvas.at(canvas.size.x * 0.5f, canvas.size.y * 0.5f);
    if (model.aim <= 0.0f) {
        canvas.list->AddCircleFilled(centre, 1.8f * canvas.unit, faded(kIvory, 0.6f), 12);
        return;
    }
    for (std::size_t i = 0; i < model.throw_arc.size(); ++i) {
        const glm::vec2 p = model.throw_arc[i];
        const bool is_last = i + 1 == model.throw_arc.size();
        const ImVec2 at = canvas.at(p.x * canvas.size.x, p.y * canvas.size.y);
        if (is_last) {
            canvas.list->AddCircle(at, 7.0f * canvas.unit, kBrass, 20, 2.0f * canvas.unit);
        } else {
            canvas.list->AddCircleFilled(at, 2.2f * canvas.unit, faded(kBrass, 0.8f), 8);
        }
    }
}

// A line on a dark band, under where rooms say their names; in smaller letters where the picture is narrow.
void draw_hint(const Canvas& canvas, const HudModel& model) {
    if (model.hint.empty() || model.hint_strength <= 0.0f) return;
    constexpr float kSize = 19.0f, kMargin = 22.0f;
    const float full_width =
        text_font()->CalcTextSizeA(kSize * canvas.letters, 1e9f, 0.0f, model.hint.c_str()).x +
        2.0f * kMargin * canvas.letters;
    const float narrowed = std::min(1.0f, canvas.size.x * 0.98f / full_width);
    const float unit = canvas.letters * narrowed;
    const float half = full_width * narrowed * 0.5f;
    const float middle = canvas.size.x * 0.5f, top = canvas.size.y * 0.225f;
    const ImVec2 from = canvas.at(middle - half, top), to = canvas.at(middle + half, top + 36.0f * unit);
    canvas.list->AddRectFilled(from, to, faded(kNight, model.hint_strength * 0.85f), 4.0f * unit);
    canvas.list->AddRectFilled(from, ImVec2(from.x + 3.0f * unit, to.y), faded(kBrass, model.hint_strength),
                               2.0f * unit);
    text(canvas, {text_font(), kSize * narrowed}, canvas.at(middle, top + 7.0f * unit),
         faded(kIvory, model.hint_strength), model.hint, 0.5f);
}

// What can be done here, behind the key that does it.
void draw_prompt(const Canvas& canvas, const HudModel& model) {
    if (model.prompt.empty()) return;
    constexpr float kSize = 18.0f;
    const float unit = canvas.letters, px = kSize * unit;
    const float key = text_font()->CalcTextSizeA(px, 1e9f, 0.0f, model.prompt_key.c_str()).x + 14.0f * unit;
    const float words = text_font()->CalcTextSizeA(px, 1e9f, 0.0f, model.prompt.c_str()).x;
    const float gap = 9.0f * unit, height = 28.0f * unit;
    const ImVec2 from = canvas.at((canvas.size.x - key - gap - words) * 0.5f, canvas.size.y * 0.575f);
    canvas.list->AddRectFilled(ImVec2(from.x - gap, from.y - 4.0f * unit),
                               ImVec2(from.x + key + words + 2.0f * gap, from.y + height + 4.0f * unit),
                               kNight, 4.0f * unit);
    canvas.list->AddRect(from, ImVec2(from.x + key, from.y + height), kBrass, 4.0f * unit, 0, 1.5f * unit);
    const float y = from.y + (height - px) * 0.5f;
    text(canvas, {text_font(), kSize}, ImVec2(from.x + key * 0.5f, y), kBrass, model.prompt_key, 0.5f);
    text(canvas, {text_font(), kSize}, ImVec2(from.x + key + gap, y), kIvory, model.prompt, 0.0f);
}

// Parted where words end, and where there is no end within the width.
std::vector<std::string> lines_of(const std::string& words, const ImFont& font, float px, float width) {
    std::vector<std::string> lines;
    const char* const end = words.c_str() + words.size();
    for (const char* from = words.c_str(); from < end;) {
        const char* const to =
            std::max(from + 1, font.CalcWordWrapPositionA(px / font.FontSize, from, end, width));
        lines.emplace_back(from, to);
        for (from = to; from < end && *from == ' ';) ++from;
    }
    return lines;
}

// The newest lowest.
void draw_captions(const Canvas& canvas, const std::vector<Caption>& captions) {
    constexpr float kSize = 16.0f;
    float y = canvas.size.y - 116.0f * canvas.unit;
    for (auto caption = captions.rbegin(); caption != captions.rend(); ++caption) {
        std::string words = "[" + caption->text + "]";
        if (caption->has_bearing && std::abs(caption->bearing) > 0.5f && std::abs(caption->bearing) < 2.64f) {
            if (caption->bearing < 0.0f) {
                words.insert(0, "\xE2\x80\xB9 ");
            } else {
                words += " \xE2\x80\xBA";
            }
        }
        const ImU32 colour = faded(kIvory, std::min(1.0f, seconds_left(*caption)));
        const std::vector<std::string> lines =
            lines_of(words, *text_font(), kSize * canvas.letters, canvas.size.x * 0.9f);
        for (auto line = lines.rbegin(); line != lines.rend(); ++line) {
            text(canvas, {text_font(), kSize}, canvas.at(canvas.size.x * 0.5f, y), colour, *line, 0.5f);
            y -= 21.0f * canvas.letters;
        }
    }
}

void draw_words(const Canvas& canvas, const HudModel& model) {
    const float middle = canvas.size.x * 0.5f;
    if (!model.room.empty() && model.room_age < 4.0f) {
        const float alpha = std::min({1.0f, model.room_age * 2.0f, 4.0f - model.room_age});
        text(canvas, {heading_font(), 40.0f}, canvas.at(middle, canvas.size.y * 0.13f),
             faded(kIvory, alpha * 0.9f), model.room, 0.5f);
    }
    draw_captions(canvas, model.captions);
}

// Under the middle: whoever is caught should see by whom.
void draw_headline(const Canvas& canvas, const HudModel& model) {
    const float middle = canvas.size.x * 0.5f;
    canvas.list->AddRectFilled(canvas.at(0.0f, canvas.size.y * 0.66f),
                               canvas.at(canvas.size.x, canvas.size.y * 0.90f), kNight);
    text(canvas, {heading_font(), 72.0f}, canvas.at(middle, canvas.size.y * 0.67f), kBrass, model.headline,
         0.5f);
    text(canvas, {text_font(), 18.0f}, canvas.at(middle, canvas.size.y * 0.82f), kIvory, model.subline, 0.5f);
}

// Over the picture; none while the window has no area.
std::optional<Canvas> canvas_of(const Window& window) {
    // ImGui counts in screen units, the window in pixels.
    const ImVec2 scale = ImGui::GetIO().DisplayFramebufferScale;
    if (scale.x <= 0.0f || scale.y <= 0.0f) return std::nullopt;
    const ImVec2 origin(window.picture_offset().x / scale.x, window.picture_offset().y / scale.y);
    const ImVec2 size(window.picture_size().x / scale.x, window.picture_size().y / scale.y);
    return Canvas{ImGui::GetBackgroundDrawList(), origin, size, size.y / 720.0f,
                  ui_scale(size.x * scale.x, size.y * scale.y) / scale.y};
}

}  // namespace

void draw_hud(const Window& window, const HudModel& model) {
    const std::optional<Canvas> canvas = canvas_of(window);
    if (!canvas) return;
    if (!model.headline.empty()) return draw_headline(*canvas, model);
    draw_aim(*canvas, model);
    draw_guards(*canvas, model);
    draw_gem(*canvas, model);
    draw_stance(*canvas, model);
    draw_hint(*canvas, model);
    draw_prompt(*canvas, model);
    draw_words(*canvas, model);
}

void draw_title(const Window& window, const std::string& words) {
    const std::optional<Canvas> canvas = canvas_of(window);
    if (!canvas) return;
    const float u = canvas->letters;
    canvas->list->AddRectFilled(canvas->at(0.0f, 0.0f), canvas->at(canvas->size.x, 30.0f * u), kNight);
    text(*canvas, {text_font(), 18.0f}, canvas->at(canvas->size.x * 0.5f, 5.0f * u), kIvory, words, 0.5f);
}

}  // namespace gh::present
