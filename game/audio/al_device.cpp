#include "audio/al_device.h"

#include "audio/bands.h"
#include "base/contracts.h"

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <utility>

namespace gh::audio {

namespace {

constexpr ALCint kSources = 96;  // three for each of the mixer's slots

template <class Function>
Function alc_function(ALCdevice* device, const char* name) {
    return reinterpret_cast<Function>(alcGetProcAddress(device, name));
}

// Sends stderr nowhere while it lives: without a sound card ALSA writes ten lines of its own, where the game has
// one sentence to say.
class QuietStderr {
  public:
    QuietStderr() : kept_(dup(STDERR_FILENO)) {
        const int nowhere = kept_ < 0 ? -1 : open("/dev/null", O_WRONLY | O_CLOEXEC);
        if (nowhere < 0) return;
        dup2(nowhere, STDERR_FILENO);
        close(nowhere);
    }
    QuietStderr(const QuietStderr&) = delete;
    QuietStderr& operator=(const QuietStderr&) = delete;
    ~QuietStderr() {
        if (kept_ < 0) return;
        dup2(kept_, STDERR_FILENO);
        close(kept_);
    }

  private:
    int kept_;
};

ALCdevice* open_default_device() {
    const QuietStderr quiet;
    return alcOpenDevice(nullptr);
}

}  // namespace

Result<AlDevice> AlDevice::open_speakers() {
    AlDevice device;
    device.device_ = open_default_device();
    if (device.device_ == nullptr) return Error{"no sound device can be opened: the game plays silently"};
    if (alcIsExtensionPresent(device.device_, "ALC_SOFT_pause_device") == ALC_TRUE) {
        device.pause_device_ = alc_function<LPALCDEVICEPAUSESOFT>(device.device_, "alcDevicePauseSOFT");
        device.resume_device_ = alc_function<LPALCDEVICERESUMESOFT>(device.device_, "alcDeviceResumeSOFT");
    }
    const std::array<ALCint, 7> attributes = {
        ALC_FREQUENCY, kSampleRate, ALC_HRTF_SOFT, ALC_TRUE, ALC_MONO_SOURCES, kSources, 0};
    if (const Result<void> started = device.start(attributes); !started) return started.error();
    return device;
}

Result<AlDevice> AlDevice::open_loopback(bool hrtf) {
    if (alcIsExtensionPresent(nullptr, "ALC_SOFT_loopback") != ALC_TRUE) {
        return Error{"this OpenAL library can not render to memory (ALC_SOFT_loopback is missing)"};
    }
    AlDevice device;
    const auto open = alc_function<LPALCLOOPBACKOPENDEVICESOFT>(nullptr, "alcLoopbackOpenDeviceSOFT");
    device.device_ = open(nullptr);
    if (device.device_ == nullptr) return Error{"OpenAL can not open a device that renders to memory"};
    device.render_samples_ = alc_function<LPALCRENDERSAMPLESSOFT>(device.device_, "alcRenderSamplesSOFT");
    const std::array<ALCint, 11> attributes = {ALC_FREQUENCY,
                                               kSampleRate,
                                               ALC_FORMAT_CHANNELS_SOFT,
                                               ALC_STEREO_SOFT,
                                               ALC_FORMAT_TYPE_SOFT,
                                               ALC_FLOAT_SOFT,
                                               ALC_HRTF_SOFT,
                                               hrtf ? ALC_TRUE : ALC_FALSE,
                                               ALC_MONO_SOURCES,
                                               kSources,
                                               0};
    if (const Result<void> started = device.start(attributes); !started) return started.error();
    return device;
}

Result<void> AlDevice::start(std::span<const ALCint> attributes) {
    context_ = alcCreateContext(device_, attributes.data());
    if (context_ == nullptr) return Error{"the sound device refuses a context: the game plays silently"};
    make_current();
    if (alIsExtensionPresent("AL_EXT_FLOAT32") != AL_TRUE) {
        return Error{
            "this OpenAL library plays no float samples (AL_EXT_FLOAT32 is missing): the game plays "
            "silently"};
    }
    alDistanceModel(AL_NONE);
    return {};
}

AlDevice::AlDevice(AlDevice&& other) noexcept {
    *this = std::move(other);
}

AlDevice& AlDevice::operator=(AlDevice&& other) noexcept {
    if (this == &other) return *this;
    close();
    device_ = std::exchange(other.device_, nullptr);
    context_ = std::exchange(other.context_, nullptr);
    render_samples_ = other.render_samples_;
    pause_device_ = other.pause_device_;
    resume_device_ = other.resume_device_;
    return *this;
}

AlDevice::~AlDevice() {
    close();
}

// Sources and buffers go with their context and device.
void AlDevice::close() {
    if (context_ != nullptr) {
        if (alcGetCurrentContext() == context_) alcMakeContextCurrent(nullptr);
        alcDestroyContext(context_);
        context_ = nullptr;
    }
    if (device_ != nullptr) {
        alcCloseDevice(device_);
        device_ = nullptr;
    }
}

void AlDevice::make_current() const {
    if (alcGetCurrentContext() != context_) alcMakeContextCurrent(context_);
}

void AlDevice::hold_changes() const {
    alcSuspendContext(context_);
}
void AlDevice::apply_changes() const {
    alcProcessContext(context_);
}

void AlDevice::render(std::span<float> stereo) const {
    EXPECTS(render_samples_ != nullptr);
    render_samples_(device_, stereo.data(), static_cast<ALCsizei>(stereo.size() / 2));
}

void AlDevice::pause(bool is_paused) const {
    const auto change = is_paused ? pause_device_ : resume_device_;
    if (change != nullptr) change(device_);
}

}  // namespace gh::audio
