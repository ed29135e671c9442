#include "audio/hall.h"

#include <AL/alc.h>
#include <AL/efx.h>

#include <algorithm>
#include <cmath>

namespace gh::audio {

namespace {


template <class Function>
Function al_function(const char* name) {
    return reinterpret_cast<Function>(alGetProcAddress(name));
}

struct Setting {
    ALenum parameter;
    float value;
};

// What no room changes: dense, smooth, without echoes, and no distance law of its own.
constexpr Setting kEverywhere[] = {
    {AL_EAXREVERB_DENSITY, 1.0f},
    {AL_EAXREVERB_DIFFUSION, 0.92f},
    {AL_EAXREVERB_GAINHF, 0.75f},
    {AL_EAXREVERB_GAINLF, 0.85f},
    {AL_EAXREVERB_REFLECTIONS_GAIN, 0.22f},
    {AL_EAXREVERB_LATE_REVERB_GAIN, 0.75f},
    {AL_EAXREVERB_HFREFERENCE, 4000.0f},
    {AL_EAXREVERB_LFREFERENCE, 250.0f},
    {AL_EAXREVERB_ECHO_DEPTH, 0.0f},
    {AL_EAXREVERB_MODULATION_DEPTH, 0.0f},
    {AL_EAXREVERB_AIR_ABSORPTION_GAINHF, 0.994f},
    {AL_EAXREVERB_ROOM_ROLLOFF_FACTOR, 0.0f},
};

}  // namespace

void Hall::open(const RoomSound& room) {
    if (alcIsExtensionPresent(alcGetContextsDevice(alcGetCurrentContext()), "ALC_EXT_EFX") != ALC_TRUE) return;
    alGetError();
    al_function<LPALGENEFFECTS>("alGenEffects")(2, effects_.data());
    al_function<LPALGENAUXILIARYEFFECTSLOTS>("alGenAuxiliaryEffectSlots")(2, slots_.data());
    if (alGetError() != AL_NO_ERROR) {
        slots_ = {};
        return;
    }
    room_ = wanted_ = room;
    furnish(current_, room);
    clear(1 - current_);
}

void Hall::furnish(std::size_t slot, const RoomSound& room) {
    const auto set_float = al_function<LPALEFFECTF>("alEffectf");
    const ALuint effect = effects_[slot];
    al_function<LPALEFFECTI>("alEffecti")(effect, AL_EFFECT_TYPE, AL_EFFECT_EAXREVERB);
    for (const Setting& s : kEverywhere) set_float(effect, s.parameter, s.value);
    const float crossing = room.mean_free_path / world::kSpeedOfSound;  // seconds from wall to wall
    const Setting own[] = {
        {AL_EAXREVERB_GAIN, std::clamp(0.55f * room.level, 0.0f, 1.0f)},
        {AL_EAXREVERB_DECAY_TIME, std::clamp(room.decay[1], 0.1f, 20.0f)},
        {AL_EAXREVERB_DECAY_HFRATIO, std::clamp(room.decay[2] / room.decay[1], 0.1f, 2.0f)},
        {AL_EAXREVERB_DECAY_LFRATIO, std::clamp(room.decay[0] / room.decay[1], 0.1f, 2.0f)},
        {AL_EAXREVERB_REFLECTIONS_DELAY, std::clamp(crossing, 0.001f, 0.3f)},
        {AL_EAXREVERB_LATE_REVERB_DELAY, std::clamp(crossing, 0.001f, 0.1f)},
    };
    for (const Setting& s : own) set_float(effect, s.parameter, s.value);
    al_function<LPALAUXILIARYEFFECTSLOTI>("alAuxiliaryEffectSloti")(slots_[slot], AL_EFFECTSLOT_EFFECT,
                                                                    static_cast<ALint>(effect));
}

// An effect slot without an effect costs nothing.
void Hall::clear(std::size_t slot) {
    set_gain(slot, 0.0f);
    al_function<LPALAUXILIARYEFFECTSLOTI>("alAuxiliaryEffectSloti")(slots_[slot], AL_EFFECTSLOT_EFFECT, AL_EFFECT_NULL);
}

void Hall::set_gain(std::size_t slot, float gain) {
    al_function<LPALAUXILIARYEFFECTSLOTF>("alAuxiliaryEffectSlotf")(slots_[slot], AL_EFFECTSLOT_GAIN,
                                                                    std::clamp(gain, 0.0f, 1.0f));
}

void Hall::enter(const RoomSound& room) { wanted_ = room; }

void Hall::tick() {
    if (slots_[0] == 0) return;
    if (fade_ == 0) {
        if (wanted_ == room_) return;
        current_ = 1 - current_;  // silent till now
        room_ = wanted_;
        furnish(current_, room_);
        fade_ = kHallFadeTicks;
    }
    --fade_;
    const float share = 1.0f - static_cast<float>(fade_) / static_cast<float>(kHallFadeTicks);
    constexpr float kQuarterTurn = 1.5707964f;
    set_gain(current_, std::sin(share * kQuarterTurn));
    set_gain(1 - current_, std::cos(share * kQuarterTurn));
    if (fade_ == 0) clear(1 - current_);
}

}  // namespace gh::audio
