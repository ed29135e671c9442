// tests/filter/synthetic.h - a little room whose light is known in closed form, and the noisy frames a renderer with one
// sample a pixel would make of it: what filters are tried on.
//
//   floor (chequered, glossy), back wall, two side walls, a ball that may move, one lamp with a soft-edged shadow behind
//   the ball, sky above.  Camera looks along -z unless turned.
//
// Metres, radiance linear. Deterministic: a frame is a function of (room, size, seed).
#pragma once

#include "filter/gbuffer.h"

#include <glm/vec3.hpp>

#include <cstdint>

namespace gh::test {

struct Room {
    glm::vec3 eye{0.0f, 1.6f, 2.0f};
    float yaw = 0.0f;  // positive: to the left
    glm::vec3 ball{0.3f, 0.8f, -3.0f};
    glm::vec3 ball_before{0.3f, 0.8f, -3.0f};
    float lamp_power = 12.0f;  // 0: switched off
    float sky = 0.05f;
};

// Ids of its parts.
enum : std::uint32_t { kFloor = 1, kBackWall, kLeftWall, kRightWall, kBall };

struct Frame {
    filter::GBuffer surfaces;
    filter::Light truth;  // expected values
    filter::Light noisy;  // one sample a pixel
};

// The lens of a picture of this room.
[[nodiscard]] filter::Pinhole lens_of(const Room& room, int width, int height);

// `seed` differs from frame to frame; with `jitters` each frame's samples lie elsewhere in their pixels.
[[nodiscard]] Frame render(const Room& room, int width, int height, std::uint32_t seed, bool jitters = true);

// (direct + indirect) + specular + clean: what a filter is to get near.
[[nodiscard]] filter::Plane3 total(const filter::Light& light);

// Mean over pixels of |a - b|^2 / (|b|^2 + 0.01), the renderer's measure of error.
[[nodiscard]] double rel_mse(const filter::Plane3& picture, const filter::Plane3& truth);

}  // namespace gh::test
