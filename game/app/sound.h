// app/sound.h - what the player hears in a tick: the State's noises, the guards and the hum of lamps, as they arrive
// through the walls between, handed to the mixer.
//
// Without an audio device the game goes on in silence.
#pragma once

#include "base/result.h"
#include "world/level.h"
#include "world/snapshot.h"

#include <memory>
#include <span>
#include <string>

namespace gh::app {

class Sound {
  public:
    // For the ears of a person. On error: why there is no sound.
    [[nodiscard]] static Result<std::unique_ptr<Sound>> open_device();
    // For a file: every tick gives exactly 800 stereo frames, the same bits every time.
    [[nodiscard]] static Result<std::unique_ptr<Sound>> open_loopback();
    ~Sound();

    void note_tick(const world::Level& level, const world::Snapshot& now);
    void set_volume(float volume);  // 0..1
    void set_paused(bool is_paused);

    // Loopback only: the tick just noted, left and right in turn.
    [[nodiscard]] std::span<const float> rendered_tick();

  private:
    struct Data;
    explicit Sound(std::unique_ptr<Data> data);
    std::unique_ptr<Data> data_;
};

}  // namespace gh::app
