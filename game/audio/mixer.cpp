#include "audio/mixer.h"

#include "audio/al_device.h"
#include "audio/hall.h"
#include "audio/voice_choice.h"
#include "base/contracts.h"

#include <AL/efx.h>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace gh::audio {

namespace {

constexpr std::size_t kSlots = kMaxVoices + kMaxFading;
constexpr std::uint8_t kFadeTicks = 6;  // of loops that come and go: 0.1 s
constexpr std::uint8_t kStealTicks = 2;

enum class Phase : std::uint8_t { Free, Sounding, Fading };

}  // namespace

struct Mixer::Engine {
    // One voice: three sources, what they play, and how far it has faded in or out.
    struct Slot {
        std::array<ALuint, world::kBands> sources{};
        std::array<float, world::kBands> gains{};  // as last heard
        std::uint32_t key = 0;
        bool loops = false;
        std::uint8_t fade = 0;  // 0 silent .. fade_ticks full
        std::uint8_t fade_ticks = 1;
        Phase phase = Phase::Free;
    };

    AlDevice al;
    std::vector<std::array<ALuint, world::kBands>> buffers;  // by flat_index
    std::array<Slot, kSlots> slots;
    std::vector<std::uint32_t> ended;  // keys whose sound is over but which are still named
    std::vector<Heard> chosen;
    Hall hall;
    float volume = 1.0f;
    bool is_paused = false;

    explicit Engine(AlDevice device) : al(std::move(device)) {}

    void fill(const SoundBank& bank);
    void retire(std::span<const Heard> heard);
    Slot& free_slot();
    void start(const Heard& heard, const Ear& ear);
    void aim(Slot& slot, const Heard& heard, const Ear& ear);
    void apply_gains(const Slot& slot) const;
    static void stop(Slot& slot);
};

void Mixer::Engine::fill(const SoundBank& bank) {
    for (std::size_t family = 0; family < kSoundCount; ++family) {
        const auto sound = static_cast<Sound>(family);
        for (std::uint8_t variant = 0; variant < traits(sound).variants; ++variant) {
            const Recording& recording = bank[{sound, variant}];
            std::array<ALuint, world::kBands> ids{};
            alGenBuffers(static_cast<ALsizei>(ids.size()), ids.data());
            for (std::size_t b = 0; b < ids.size(); ++b) {
                const std::vector<float>& band = recording.bands[b];
                alBufferData(ids[b], AL_FORMAT_MONO_FLOAT32, band.data(),
                             static_cast<ALsizei>(band.size() * sizeof(float)), kSampleRate);
            }
            buffers.push_back(ids);
        }
    }
    for (Slot& slot : slots) alGenSources(static_cast<ALsizei>(slot.sources.size()), slot.sources.data());
}

void Mixer::Engine::stop(Slot& slot) {
    alSourceStopv(static_cast<ALsizei>(slot.sources.size()), slot.sources.data());
    for (const ALuint source : slot.sources) alSourcei(source, AL_BUFFER, 0);
    slot.phase = Phase::Free;
}

// Gains are a tenth of what is meant, because OpenAL caps a source at 1; the listener gives the tenfold back.
void Mixer::Engine::apply_gains(const Slot& slot) const {
    const float fade = static_cast<float>(slot.fade) / static_cast<float>(slot.fade_ticks);
    for (std::size_t b = 0; b < slot.sources.size(); ++b) {
        alSourcef(slot.sources[b], AL_GAIN, std::min(slot.gains[b] * fade / kMaxGain, 1.0f));
    }
}

// The listener stays at OpenAL's origin, so that a level far from its own origin loses no direction.
void Mixer::Engine::aim(Slot& slot, const Heard& heard, const Ear& ear) {
    const glm::vec3 offset = heard.position - ear.position;
    const float metres = glm::length(offset);
    const glm::vec3 way = metres > 1e-4f ? offset / metres : glm::vec3(0.0f);
    for (std::size_t b = 0; b < slot.sources.size(); ++b) {
        slot.gains[b] = heard.gain * heard.band_gain[b];
        alSource3f(slot.sources[b], AL_POSITION, way.x, way.y, way.z);
    }
}

// A voice that is no longer chosen fades if it loops or was pushed out, and otherwise rings on. A step that was
// pushed out, or found no voice at first, is over: it must not start late.
void Mixer::Engine::retire(std::span<const Heard> heard) {
    const auto names = [](std::span<const Heard> list, std::uint32_t key) {
        return std::any_of(list.begin(), list.end(), [&](const Heard& h) { return h.voice_key == key; });
    };
    std::erase_if(ended, [&](std::uint32_t key) { return !names(heard, key); });
    const auto end_key = [&](std::uint32_t key) {
        if (names(heard, key) && std::find(ended.begin(), ended.end(), key) == ended.end())
            ended.push_back(key);
    };
    for (const Heard& h : heard) {
        if (!h.loop && !names(chosen, h.voice_key)) end_key(h.voice_key);
    }
    for (Slot& slot : slots) {
        if (slot.phase == Phase::Free) continue;
        ALint state = AL_STOPPED;
        alGetSourcei(slot.sources[0], AL_SOURCE_STATE, &state);
        if (state == AL_STOPPED || (slot.phase == Phase::Fading && slot.fade == 0)) {
            if (state == AL_STOPPED) end_key(slot.key);
            stop(slot);
            continue;
        }
        const bool is_chosen = names(chosen, slot.key);
        if (slot.phase == Phase::Fading) {
            --slot.fade;
        } else if (!is_chosen && (slot.loops || names(heard, slot.key))) {
            slot.phase = Phase::Fading;
            slot.fade_ticks = slot.loops ? kFadeTicks : kStealTicks;
            slot.fade = static_cast<std::uint8_t>(slot.fade_ticks - 1);
        } else if (slot.fade < slot.fade_ticks) {
            ++slot.fade;
        }
    }
}

// An unused slot, or else the one whose loss is least heard.
Mixer::Engine::Slot& Mixer::Engine::free_slot() {
    const auto cost = [this](const Slot& slot) {
        if (slot.phase == Phase::Free) return -2.0f;
        const bool is_wanted = slot.phase == Phase::Sounding &&
                               std::any_of(chosen.begin(), chosen.end(),
                                           [&](const Heard& h) { return h.voice_key == slot.key; });
        const float loudness = *std::max_element(slot.gains.begin(), slot.gains.end());
        return (is_wanted ? 1e6f : 0.0f) +
               loudness * static_cast<float>(slot.fade) / static_cast<float>(slot.fade_ticks);
    };
    Slot& least = *std::min_element(slots.begin(), slots.end(),
                                    [&](const Slot& a, const Slot& b) { return cost(a) < cost(b); });
    if (least.phase != Phase::Free) stop(least);
    return least;
}

void Mixer::Engine::start(const Heard& heard, const Ear& ear) {
    Slot& slot = free_slot();
    slot.key = heard.voice_key;
    slot.loops = heard.loop;
    slot.phase = Phase::Sounding;
    slot.fade_ticks = heard.loop ? kFadeTicks : 1;
    slot.fade = 1;
    const std::array<ALuint, world::kBands>& bands = buffers[flat_index(heard.sound)];
    const bool is_placed = heard.position != ear.position;  // the room's own tone does not ring in the room
    for (std::size_t b = 0; b < bands.size(); ++b) {
        alSourcei(slot.sources[b], AL_BUFFER, static_cast<ALint>(bands[b]));
        alSourcei(slot.sources[b], AL_LOOPING, heard.loop ? AL_TRUE : AL_FALSE);
        alSourcef(slot.sources[b], AL_ROLLOFF_FACTOR, 0.0f);
        for (std::size_t send = 0; send < hall.slots().size(); ++send) {
            alSource3i(slot.sources[b], AL_AUXILIARY_SEND_FILTER,
                       is_placed ? static_cast<ALint>(hall.slots()[send]) : AL_EFFECTSLOT_NULL,
                       static_cast<ALint>(send), AL_FILTER_NULL);
        }
    }
    aim(slot, heard, ear);
    apply_gains(slot);
    alSourcePlayv(static_cast<ALsizei>(slot.sources.size()), slot.sources.data());
}

Mixer::Mixer(std::unique_ptr<Engine> engine) : engine_(std::move(engine)) {}
Mixer::Mixer(Mixer&&) noexcept = default;
Mixer& Mixer::operator=(Mixer&&) noexcept = default;
Mixer::~Mixer() = default;

Result<Mixer> Mixer::open_device(const SoundBank& bank) {
    Result<AlDevice> device = AlDevice::open_speakers();
    if (!device) return device.error();
    auto engine = std::make_unique<Engine>(std::move(*device));
    engine->fill(bank);
    engine->hall.open(RoomSound{});
    return Mixer(std::move(engine));
}

Result<Mixer> Mixer::open_loopback(const SoundBank& bank, bool hrtf) {
    Result<AlDevice> device = AlDevice::open_loopback(hrtf);
    if (!device) return device.error();
    auto engine = std::make_unique<Engine>(std::move(*device));
    engine->fill(bank);
    if (hrtf) engine->hall.open(RoomSound{});
    return Mixer(std::move(engine));
}

void Mixer::tick(const Ear& ear, std::span<const Heard> heard) {
    Engine& engine = *engine_;
    engine.al.make_current();
    engine.al.hold_changes();
    const std::array<float, 6> axes = {ear.forward.x, ear.forward.y, ear.forward.z,
                                       ear.up.x,      ear.up.y,      ear.up.z};
    alListenerfv(AL_ORIENTATION, axes.data());
    alListenerf(AL_GAIN, kMaxGain * engine.volume);

    choose_voices(heard, kMaxVoices, engine.chosen);
    engine.retire(heard);
    for (const Heard& h : engine.chosen) {
        const auto slot = std::find_if(engine.slots.begin(), engine.slots.end(), [&](const Engine::Slot& s) {
            return s.phase == Phase::Sounding && s.key == h.voice_key;
        });
        if (slot != engine.slots.end()) {
            engine.aim(*slot, h, ear);
        } else if (std::find(engine.ended.begin(), engine.ended.end(), h.voice_key) == engine.ended.end()) {
            engine.start(h, ear);
        }
    }
    for (const Engine::Slot& slot : engine.slots) {
        if (slot.phase != Phase::Free) engine.apply_gains(slot);
    }
    engine.hall.tick();
    engine.al.apply_changes();
}

void Mixer::set_room(const RoomSound& room) {
    engine_->hall.enter(room);
}

void Mixer::render(std::span<float> stereo) {
    EXPECTS(stereo.size() == 2 * kFramesPerTick);
    if (engine_->is_paused) {
        std::fill(stereo.begin(), stereo.end(), 0.0f);
        return;
    }
    engine_->al.render(stereo);
}

void Mixer::set_volume(float volume) {
    engine_->volume = volume > 0.0f ? std::min(volume, kMostVolume) : 0.0f;
}

void Mixer::set_paused(bool is_paused) {
    if (engine_->is_paused == is_paused) return;
    engine_->is_paused = is_paused;
    engine_->al.pause(is_paused);
}

std::size_t Mixer::voices() const {
    const auto& slots = engine_->slots;
    return static_cast<std::size_t>(std::count_if(
        slots.begin(), slots.end(), [](const Engine::Slot& s) { return s.phase != Phase::Free; }));
}

}  // namespace gh::audio
