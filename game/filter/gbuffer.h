// filter/gbuffer.h - what a renderer leaves beside its noisy light, so that filters know which pixels belong together
// and where each was a frame ago.
//
// Units     metres, world frame, +y up; radiance linear and scene-referred; picture points in pixels from the top left
//           corner, pixel (i, j) covering [i, i + 1) x [j, j + 1).
// Empty     a plane that a scene does not need may stay empty (0 x 0); each says what then holds. The others all have
//           the size of `part`.
// Mirrors   a pixel that looks into a perfect mirror or through clear glass describes what is seen there, unfolded: its
//           position lies on the straight line through the pixel at the whole length of the path (behind a plane
//           mirror: the mirror image), its normals are reflected likewise, its albedo is the surface's (the mirror's
//           tint belongs to the light, not to the albedo). Reprojection by virtual depth then is reprojection.
// Bad input a NaN or infinity in a plane makes that pixel one without history and without neighbours; it never spreads.
#pragma once

#include "filter/plane.h"

#include <glm/vec3.hpp>

#include <cstdint>

namespace gh::filter {

// The part of a pixel that meets no surface: sky. All its other planes are ignored; 0 will do.
inline constexpr std::uint32_t kNoSurface = 0xFFFFFFFFu;

// A camera and its picture's size in one: the direction through picture point (x, y) is corner + x * right + y * down,
// of any length. `render::Lens` holds these.
struct Pinhole {
    glm::vec3 eye{0.0f};
    glm::vec3 corner{-1.0f, 1.0f, -1.0f};
    glm::vec3 right{2.0f, 0.0f, 0.0f};  // one pixel to the right
    glm::vec3 down{0.0f, -2.0f, 0.0f};  // one pixel down

    [[nodiscard]] bool operator==(const Pinhole&) const = default;
};

struct GBuffer {
    Pinhole lens;

    PlaneU32 part;    // which thing: any number that stays its own from frame to frame; kNoSurface: sky
    Plane3 position;  // of the point that was shaded, at its own (jittered) place in the pixel
    Plane3
        previous;  // where that point of that thing was in the frame before. Empty: nothing moves but the camera
    Plane3 normal;     // unit, smooth (interpolated), towards the eye; without the normal map
    Plane3 geometric;  // unit, of the triangle itself, towards the eye. Empty: `normal` does
    Plane3 albedo;     // what direct and indirect light were multiplied by. Empty: 1, light comes demodulated
    Plane3 gloss;      // what specular light was multiplied by, about. Empty: 1
    Plane roughness;   // glTF's, 0 ... 1. Empty: 1
    Plane
        reflected;  // metres from `position` to what `specular` shows; 0: not known. Empty: reflections stick to
                    // their surface

    [[nodiscard]] int width() const { return part.width(); }
    [[nodiscard]] int height() const { return part.height(); }

    // Gives the three planes every frame needs this size, and `part` that of sky. The others only if they have one.
    void fit(int width, int height);
};

// One frame's light by how it behaves. An empty one is black.
struct Light {
    Plane3 direct;    // from lamps to a diffuse surface, times albedo
    Plane3 indirect;  // to a diffuse surface by way of others, times albedo
    Plane3 specular;  // off gloss. What perfect mirrors show is split like anything else
    Plane3 clean;     // without noise: sky, lamps themselves, light that needs no chance. Passes unfiltered

    // Share of the light that is known to have changed since the last frame, 0 (none) ... 1 (all): from lamp_change() in
    // anti_lag.h. Empty: 0. `direct_change` is taken for specular as well.
    Plane direct_change;
    Plane indirect_change;
    // The same of all light, in the pixels of the last frame, from gradients(): found where each pixel was. Empty: 0.
    // Goes before the other two.
    Plane change_then;
};

}  // namespace gh::filter
