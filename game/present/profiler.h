// present/profiler.h - the F3 overlay: where the milliseconds of tick and frame go, and what was asked of raycore.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace gh::present {

struct ProfileRow {
    std::string name;
    float ms = 0.0f;  // mean over the last second
};

struct ProfileModel {
    float frame_ms = 0.0f;
    float tick_ms = 0.0f;
    std::vector<ProfileRow> tick_rooms;   // phases of one tick
    std::vector<ProfileRow> frame_rooms;  // render, filter, present
    struct Rays {
        std::string layer;
        std::uint64_t count = 0;  // a frame, or a tick
    };
    std::vector<Rays> rays;
    std::vector<float> frame_history_ms;  // oldest first
    std::string machine;                  // "2 threads, avx2, 640x360 -> 1280x720"
};

void draw_profiler(const ProfileModel& model);

}  // namespace gh::present
