#include "audio/hall.h"

#include <AL/alc.h>
#include <AL/efx.h>

namespace gh::audio {

namespace {

template <class Function>
Function al_function(const char* name) {
    return reinterpret_cast<Function>(alGetProcAddress(name));
}

// Marble and plaster, ten metres across, furnished with little: early walls at 12 ms, then a long bright tail.
struct Setting {
    ALenum parameter;
    float value;
};
constexpr Setting kHall[] = {
    {AL_EAXREVERB_DENSITY, 1.0f},
    {AL_EAXREVERB_DIFFUSION, 0.92f},
    {AL_EAXREVERB_GAIN, 0.55f},
    {AL_EAXREVERB_GAINHF, 0.75f},
    {AL_EAXREVERB_GAINLF, 0.85f},
    {AL_EAXREVERB_DECAY_TIME, kHallDecay},
    {AL_EAXREVERB_DECAY_HFRATIO, 0.62f},
    {AL_EAXREVERB_DECAY_LFRATIO, 0.95f},
    {AL_EAXREVERB_REFLECTIONS_GAIN, 0.22f},
    {AL_EAXREVERB_REFLECTIONS_DELAY, 0.012f},
    {AL_EAXREVERB_LATE_REVERB_GAIN, 0.75f},
    {AL_EAXREVERB_LATE_REVERB_DELAY, 0.024f},
    {AL_EAXREVERB_ECHO_DEPTH, 0.0f},
    {AL_EAXREVERB_MODULATION_DEPTH, 0.0f},
    {AL_EAXREVERB_AIR_ABSORPTION_GAINHF, 0.994f},
    {AL_EAXREVERB_ROOM_ROLLOFF_FACTOR, 0.0f},
};

}  // namespace

ALuint make_hall() {
    if (alcIsExtensionPresent(alcGetContextsDevice(alcGetCurrentContext()), "ALC_EXT_EFX") != ALC_TRUE)
        return 0;
    const auto make_effects = al_function<LPALGENEFFECTS>("alGenEffects");
    const auto set_integer = al_function<LPALEFFECTI>("alEffecti");
    const auto set_float = al_function<LPALEFFECTF>("alEffectf");
    const auto make_slots = al_function<LPALGENAUXILIARYEFFECTSLOTS>("alGenAuxiliaryEffectSlots");
    const auto set_slot = al_function<LPALAUXILIARYEFFECTSLOTI>("alAuxiliaryEffectSloti");

    ALuint effect = 0;
    ALuint slot = 0;
    alGetError();
    make_effects(1, &effect);
    set_integer(effect, AL_EFFECT_TYPE, AL_EFFECT_EAXREVERB);
    for (const Setting& s : kHall) set_float(effect, s.parameter, s.value);
    make_slots(1, &slot);
    set_slot(slot, AL_EFFECTSLOT_EFFECT, static_cast<ALint>(effect));
    return alGetError() == AL_NO_ERROR ? slot : 0;
}

}  // namespace gh::audio
