// render/camera.h - where the eye is and which ray each point of the picture sees along.
//
// Frames    world, metres, radians, +y up. Yaw 0 looks along -z and positive yaw turns left, pitch is positive
//           upwards, roll is positive when the head tilts to its left.
// Same bits directions come from base/det_math: one camera is one set of rays on every machine.
#pragma once

#include "world/level.h"

#include "raycore/ray.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace gh::render {

struct Camera {
    glm::vec3 position{0.0f};
    float yaw = 0.0f;
    float pitch = 0.0f;
    float roll = 0.0f;    // leaning round a corner
    float fov_y = 1.15f;  // full vertical opening angle, in (0, pi)
    // A thin lens: what lies `focus` metres off, measured straight ahead, is sharp, all else blurred. A pinhole if the
    // aperture is 0; `focus` > 0 otherwise.
    float aperture = 0.0f;  // metres, radius
    float focus = 1.0f;     // metres
};

[[nodiscard]] Camera camera_from(const world::Viewpoint& viewpoint);

// One that looks down a little at the whole box from outside its corner: for scenes that bring no camera.
[[nodiscard]] Camera camera_around(const world::Aabb& box);

// A camera made ready for a picture of one size.
class Lens {
  public:
    // Width and height in pixels, >= 1.
    Lens(const Camera& camera, int width, int height);

    // Through picture point (x, y), in pixels from the top left corner: pixel (i, j) covers [i, i + 1) x [j, j + 1).
    // The direction is unit.
    [[nodiscard]] rc::Ray ray(const glm::vec2& point) const;

    // Through another place of the aperture, `u` in [0, 1)^2: all of them meet where the picture is sharp. Something at
    // depth z is spread over a disc of radius aperture * |1 / z - 1 / focus| / pixel_angle() pixels.
    [[nodiscard]] rc::Ray ray(const glm::vec2& point, const glm::vec2& u) const;
    [[nodiscard]] bool has_aperture() const { return aperture_ > 0.0f; }

    // One that stands between two, `share` of the way from `a` to `b`: as far as a camera goes and turns while its shutter
    // is open, its path is straight.
    friend Lens between(const Lens& a, const Lens& b, float share);

    // Opening of the cone that one pixel covers at the picture's centre, in radians: what textures are filtered by.
    [[nodiscard]] float pixel_angle() const { return pixel_angle_; }

    // ray() before it is made unit: from position() along corner() + x * right() + y * down().
    [[nodiscard]] const glm::vec3& position() const { return position_; }
    [[nodiscard]] const glm::vec3& corner() const { return corner_; }
    [[nodiscard]] const glm::vec3& right() const { return right_; }
    [[nodiscard]] const glm::vec3& down() const { return down_; }

  private:
    glm::vec3 position_;
    glm::vec3 corner_;  // direction to the top left corner of the picture plane at distance 1
    glm::vec3 right_;   // one pixel to the right on that plane
    glm::vec3 down_;    // one pixel down
    float pixel_angle_;
    float aperture_;
    float focus_;
};

[[nodiscard]] Lens between(const Lens& a, const Lens& b, float share);

}  // namespace gh::render
