// audio/al_device.h - an OpenAL device and its context, to speakers or to memory. Private to the mixer: it is
// the one header that shows OpenAL.
//
// Threads   one at a time; a context is current for the whole process, so each use begins with make_current().
#pragma once

#include "base/result.h"

#include <AL/al.h>
#include <AL/alc.h>
#include <AL/alext.h>

#include <span>

namespace gh::audio {

class AlDevice {
  public:
    [[nodiscard]] static Result<AlDevice> open_speakers();
    [[nodiscard]] static Result<AlDevice> open_loopback(bool hrtf);

    AlDevice(AlDevice&& other) noexcept;
    AlDevice& operator=(AlDevice&& other) noexcept;
    ~AlDevice();

    void make_current() const;
    // Everything set between the two takes effect at one instant.
    void hold_changes() const;
    void apply_changes() const;

    void render(std::span<float> stereo) const;  // loopback only
    void pause(bool is_paused) const;            // speakers only; a loopback is paused by not rendering it

  private:
    AlDevice() = default;
    void close();
    // Creates the context and checks what the mixer relies on; one sentence when something is missing.
    [[nodiscard]] Result<void> start(std::span<const ALCint> attributes);

    ALCdevice* device_ = nullptr;
    ALCcontext* context_ = nullptr;
    LPALCRENDERSAMPLESSOFT render_samples_ = nullptr;
    LPALCDEVICEPAUSESOFT pause_device_ = nullptr;
    LPALCDEVICERESUMESOFT resume_device_ = nullptr;
};

}  // namespace gh::audio
