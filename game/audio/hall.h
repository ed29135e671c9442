// audio/hall.h - the room that every sound rings in: one EAX reverb, and while the listener goes from one room to
// another a second one, to which the first is faded over.
//
// OpenAL Soft clicks when an audible reverb changes, so none ever does: the next room is set up in the slot that is
// silent, and the two change places at equal power. (Its decay errs by 2 to 8 %.)
// Cost      one reverb, two during a fade of kFadeTicks. Private to the mixer; needs a current context.
#pragma once

#include "audio/room_sound.h"

#include <AL/al.h>

#include <array>
#include <cstdint>

namespace gh::audio {

inline constexpr int kHallFadeTicks = 30;

class Hall {
  public:
    // Dry where the library has no EFX.
    void open(const RoomSound& room);

    // From now on it is to ring like that. Another room named during a fade waits for its end; the last one named counts.
    void enter(const RoomSound& room);
    // One tick of a fade, if there is one.
    void tick();

    // Both effect slots: a source sends to either at all times. 0: dry.
    [[nodiscard]] const std::array<ALuint, 2>& slots() const { return slots_; }
    [[nodiscard]] bool is_fading() const { return fade_ > 0; }

  private:
    void furnish(std::size_t slot, const RoomSound& room);
    void clear(std::size_t slot);
    void set_gain(std::size_t slot, float gain);

    std::array<ALuint, 2> slots_{};
    std::array<ALuint, 2> effects_{};
    std::size_t current_ = 0;  // the slot that is heard, or fades in
    int fade_ = 0;             // ticks left
    RoomSound room_;           // of the current slot
    RoomSound wanted_;
};

}  // namespace gh::audio
