#include "app/sound.h"

#include "app/assets.h"
#include "audio/acoustics.h"
#include "audio/ceiling.h"
#include "audio/mixer.h"
#include "audio/sound_bank.h"
#include "audio/soundscape.h"
#include "sim/carry.h"
#include "world/eye.h"

#include <glm/geometric.hpp>

#include <array>
#include <utility>
#include <vector>

namespace gh::app {

struct Sound::Data {
    audio::Mixer mixer;
    audio::Soundscape soundscape;
    bool is_loopback = false;
    std::vector<audio::Heard> heard;
    std::unique_ptr<sim::Navigation> ways;  // made for `level`
    const world::Level* level = nullptr;
    std::vector<audio::RoomSound> rooms;  // of `level`
    std::array<float, 2 * audio::kFramesPerTick> tick{};
};

namespace {

// At what a player sets as full volume. Sounds are made with room to spare: as they are, most of the bundled win lay 50 dB
// below full scale, steps near by 40, and its loudest moment 12, so that a game at the same setting of one's speakers
// seemed silent.
constexpr float kMakeUpGain = 2.5f;

audio::Ear ear_of(const world::PlayerState& player) {
    const glm::vec3 look = world::look_of(player);
    const glm::vec3 right = world::right_of_yaw(world::radians_from_turn(player.yaw));
    return {.position = world::eye_of(player), .forward = look, .up = glm::cross(right, look)};
}

Result<audio::SoundBank> bundled_sounds() {
    const auto assets = find_assets();
    if (!assets) return assets.error();
    return audio::SoundBank::load(*assets / "sounds");
}

}  // namespace

Sound::Sound(std::unique_ptr<Data> data) : data_(std::move(data)) {
    set_volume(1.0f);
}
Sound::~Sound() = default;

Result<std::unique_ptr<Sound>> Sound::open_device() {
    auto bank = bundled_sounds();
    if (!bank) return bank.error();
    auto mixer = audio::Mixer::open_device(*bank);
    if (!mixer) return mixer.error();
    return std::unique_ptr<Sound>(
        new Sound(std::make_unique<Data>(Data{.mixer = *std::move(mixer),
                                              .soundscape = audio::Soundscape(*bank),
                                              .is_loopback = false,
                                              .heard = {},
                                              .ways = nullptr,
                                              .rooms = {}})));
}

Result<std::unique_ptr<Sound>> Sound::open_loopback() {
    auto bank = bundled_sounds();
    if (!bank) return bank.error();
    auto mixer = audio::Mixer::open_loopback(*bank);
    if (!mixer) return mixer.error();
    return std::unique_ptr<Sound>(
        new Sound(std::make_unique<Data>(Data{.mixer = *std::move(mixer),
                                              .soundscape = audio::Soundscape(*bank),
                                              .is_loopback = true,
                                              .heard = {},
                                              .ways = nullptr,
                                              .rooms = {}})));
}

void Sound::note_tick(const world::Level& level, const world::Snapshot& now) {
    Data& d = *data_;
    const audio::Ear ear = ear_of(now.state.player);
    if (d.level != &level) {
        d.ways = std::make_unique<sim::Navigation>(level);
        d.level = &level;
        d.rooms = audio::room_sounds(level);
    }
    const std::uint32_t room = audio::room_at(level, ear.position);  // in a doorway: the room one comes from
    if (room != world::kNoIndex) d.mixer.set_room(d.rooms[room]);
    d.heard.clear();
    for (const audio::Source& source : d.soundscape.sources(level, now.state, ear.position)) {
        d.heard.push_back(
            source.is_everywhere
                ? audio::heard_everywhere(source, ear)
                : audio::heard_by(source, sim::carry_sound(level, *now.scene, *d.ways, source.position,
                                                           ear.position, now.state.player.position)));
    }
    d.mixer.tick(ear, d.heard);
    if (!d.is_loopback) return;  // a device's own limiter watches over what is heard there
    d.mixer.render(d.tick);
    for (float& sample : d.tick) sample = audio::under_ceiling(sample);
}

void Sound::set_volume(float volume) {
    data_->mixer.set_volume(kMakeUpGain * volume);
}
void Sound::set_paused(bool is_paused) {
    data_->mixer.set_paused(is_paused);
}
std::span<const float> Sound::rendered_tick() {
    return data_->tick;
}

}  // namespace gh::app
