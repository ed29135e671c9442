// app/hud_model.h - from the State to what the HUD shows: the gem, marks for guards, captions for what is heard.
//
// Reads what the simulation decided; decides nothing.
#pragma once

#include "app/hints.h"
#include "app/key_words.h"
#include "present/hud.h"
#include "render/camera.h"
#include "world/level.h"
#include "world/snapshot.h"

#include <optional>
#include <string>

namespace gh::app {

// What the player wants to read, and what his keys are called.
struct HudChoices {
    bool captions = true;
    bool hints = true;
    KeyWords keys = key_words(input::default_bindings());
};

class HudReader {
  public:
    // Once a tick: picks up this tick's noises and the room the player is in.
    void note_tick(const world::Level& level, const world::Snapshot& now);
    // Says something that is not a noise, and is read without captions too.
    void say(const std::string& words);

    // As it stands. `camera` and `aspect` place the throw's arc in the picture.
    [[nodiscard]] present::HudModel model(const world::Level& level, const world::Snapshot& now,
                                          const render::Camera& camera, float aspect,
                                          const HudChoices& choices) const;

  private:
    present::Captions captions_;
    Hints hints_;
    std::string room_;
    float room_age_ = 0.0f;
};

// Where a point of the world appears in the picture, 0..1 to the right and down; nullopt behind the camera.
[[nodiscard]] std::optional<glm::vec2> picture_point(const render::Camera& camera, float aspect,
                                                     const glm::vec3& point);

}  // namespace gh::app
