// render/frame_light.h - which of the level's lights are on in this frame.
#pragma once

#include "render/ambient.h"
#include "render/lamp_bounds.h"
#include "render/lamp_light.h"
#include "render/scene_view.h"

#include <glm/vec3.hpp>

#include <cstdint>
#include <vector>

namespace gh::render {

struct FrameLight {
    std::vector<std::uint8_t> lamp_on;      // one a lamp
    std::vector<std::uint8_t> emission_on;  // one a part
    glm::vec3 sun{0.0f};  // all suns that are on, W/m2 across their directions: what lights the sky
    std::vector<LampReach> reaches;  // one a lamp
    std::vector<LampNumbers> lamps;  // one a lamp
    AmbientLight ambient;
};

// Cost: the ambient light of all groups that are on is summed, under a millisecond for a museum.
[[nodiscard]] FrameLight frame_light(const SceneView& view, bool uses_ambient);

}  // namespace gh::render
