// present/hud.h - what the player reads while playing. Plain data in, drawing out; it decides nothing.
#pragma once

#include "present/captions.h"

#include <glm/vec2.hpp>

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace gh::present {

class Window;

enum class Mood : std::uint8_t { Calm, Suspicious, Searching, Chasing };

// What one guard knows, as a mark round the middle of the picture.
struct GuardMark {
    float bearing = 0.0f;    // radians from straight ahead, positive to the right
    float suspicion = 0.0f;  // share of the way to the next mood, 0..1
    float distance = 0.0f;   // metres
    Mood mood = Mood::Calm;
    std::string cue;  // "saw you in a mirror", "heard you": why it rose
};

struct HudModel {
    float exposure = 0.0f;  // the very number the guards weigh, 0..1
    float noise = 0.0f;     // 0 silent .. 1 loud
    bool is_crouched = false;
    bool is_running = false;
    bool is_walking = false;
    int stones_left = 0;
    int lenses_taken = 0;
    int lenses_total = 0;
    float aim = 0.0f;                  // how far the throw is drawn, 0: not aiming
    std::vector<glm::vec2> throw_arc;  // picture coordinates 0..1, x right, y down
    std::string mirror;                // "F  hand mirror"; empty: none is carried
    std::string prompt_key;            // "E"
    std::string prompt;                // "open: Cloakroom door"; empty: nothing in reach
    std::string hint;                  // one line for somebody new to the game; empty: none
    float hint_strength = 0.0f;        // 0 gone .. 1 fully there
    std::string room;                  // title of where the player is
    float room_age = 0.0f;             // seconds since entering it
    std::vector<GuardMark> guards;
    std::vector<Caption> captions;
    std::string headline;  // "Caught", "The lens is yours"; empty while playing
    std::string subline;
};

// Between Window::begin_frame and end_frame.
void draw_hud(const Window& window, const HudModel& model);

// A line at the top of the picture: what is shown instead of it.
void draw_title(const Window& window, const std::string& words);

}  // namespace gh::present
