#include "audio/sound_id.h"

#include "base/contracts.h"

#include <array>

namespace gh::audio {

namespace {

// In the order of the enumeration. The reference levels are what sim says of a walker's step, a stone at
// 3 m/s, a spoken bark: a quieter noise of the same kind plays the same file more softly.
constexpr std::array<SoundTraits, kSoundCount> kTraits = {{
    {"step_marble", 4, false, 50.0f},   {"step_parquet", 4, false, 49.0f},
    {"step_carpet", 4, false, 34.0f},   {"step_metal", 4, false, 57.0f},
    {"step_glass", 4, false, 54.0f},    {"boot_marble", 4, false, 50.0f},
    {"boot_parquet", 4, false, 49.0f},  {"boot_carpet", 4, false, 34.0f},
    {"boot_metal", 4, false, 57.0f},    {"boot_glass", 4, false, 54.0f},
    {"stone_marble", 3, false, 72.0f},  {"stone_parquet", 3, false, 67.0f},
    {"stone_carpet", 2, false, 42.0f},  {"stone_metal", 3, false, 78.0f},
    {"stone_glass", 3, false, 76.0f},   {"land", 2, false, 60.0f},
    {"throw", 2, false, 26.0f},         {"door_open", 2, false, 52.0f},
    {"door_close", 2, false, 56.0f},    {"gate_open", 2, false, 55.0f},
    {"gate_close", 2, false, 60.0f},    {"vitrine_open", 1, false, 44.0f},
    {"vitrine_close", 1, false, 46.0f}, {"switch", 2, false, 42.0f},
    {"mirror_turn", 2, false, 44.0f},   {"lens_taken", 1, false, 38.0f},
    {"pick_up", 2, false, 24.0f},       {"voice_hm", 3, false, 66.0f},
    {"voice_who", 2, false, 66.0f},     {"voice_alarm", 2, false, 78.0f},
    {"voice_gave_up", 2, false, 66.0f}, {"voice_caught", 2, false, 66.0f},
    {"voice_whistle", 2, false, 56.0f}, {"lamp_hum", 1, true, 30.0f},
    {"room_tone", 1, true, 22.0f},      {"sting_caught", 1, false, 60.0f},
    {"sting_won", 1, false, 60.0f},
}};

constexpr std::array<std::size_t, kSoundCount + 1> first_indices() {
    std::array<std::size_t, kSoundCount + 1> first{};
    for (std::size_t i = 0; i < kSoundCount; ++i) first[i + 1] = first[i] + kTraits[i].variants;
    return first;
}
constexpr std::array<std::size_t, kSoundCount + 1> kFirst = first_indices();

}  // namespace

const SoundTraits& traits(Sound sound) {
    return kTraits[static_cast<std::size_t>(sound)];
}

std::size_t flat_index(SoundId id) {
    EXPECTS(id.variant < traits(id.sound).variants);
    return kFirst[static_cast<std::size_t>(id.sound)] + id.variant;
}

std::size_t flat_count() {
    return kFirst[kSoundCount];
}

std::string file_name(SoundId id) {
    return std::string(traits(id.sound).name) + '_' + std::to_string(id.variant + 1) + ".flac";
}

}  // namespace gh::audio
