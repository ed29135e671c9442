// render/lamp_light.h - what one lamp does at sixteen surfaces side by side, if nothing stands in the way: lamp.h's
// irradiance and highlight, left out by lamp_bounds.h where neither is to be seen.
//
// Same bits a surface's answer depends on it and the lamp alone; for every instruction set what lamp.h gives.
// Threads   pure.
#pragma once

#include "render/lamp_bounds.h"

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include <cstddef>
#include <vector>

namespace gh::render {

inline constexpr std::size_t kLitTogether = 16;

// A lamp in plain numbers, since it crosses into code compiled for other instruction sets.
struct LampNumbers {
    int shape = 0;  // world::LampShape
    float position[3], direction[3], intensity[3];
    float half_u[3], half_v[3], length_u, length_v, length2_u, length2_v, area;
    float radius, range, cos_inner, cos_outer;
    // Its LampReach.
    float extent, strength, nothing_from, axis[3], bound_cos_outer;
};
[[nodiscard]] LampNumbers lamp_numbers(const world::Lamp& lamp, const LampReach& reach);

using LitLanes = float[kLitTogether];

// Surfaces that lamps shine on; of those that are not there anything.
struct LitSurfaces {
    std::size_t count = 0;
    alignas(64) LitLanes position[3] = {}, normal[3] = {}, geometric[3] = {}, to_eye[3] = {}, f0[3] = {};
    alignas(64) LitLanes f90 = {}, alpha = {};
    alignas(64) LitLanes diffuse[3] = {};  // share of the irradiance that the pixel shows
    alignas(64) LitLanes weight[3] = {};   // of highlights
};

// What one lamp brings.
struct LampLight {
    alignas(64) LitLanes asked = {};     // not 0: of these surfaces
    alignas(64) LitLanes light[3] = {};  // to the pixel
    alignas(64) LitLanes counts = {};    // 0: nothing to be seen; less than 1: it fades
    // Of the lamp alone, whether it counts or not.
    alignas(64) LitLanes to_lamp[3] = {}, share = {}, irradiance[3] = {}, shine[3] = {};
    alignas(64) LitLanes is_cut = {};  // 1: the horizon cuts it, and its irradiance is still to be found
};

// Sums over lamps, as SurfaceLight has them.
struct LampSums {
    alignas(64) LitLanes irradiance[3] = {}, shine[3] = {};
    alignas(64) LitLanes turns[3][3] = {};  // [column][row]

    [[nodiscard]] glm::mat3 turns_at(std::size_t i) const;
};

// What `lamp` brings those surfaces for which out.asked is not 0; added to the sums. False: to none of them.
bool add_lamp(const world::Lamp& lamp, const LampNumbers& numbers, const LitSurfaces& surfaces,
              LampLight& out, LampSums& sums);

[[nodiscard]] inline glm::vec3 lane(const LitLanes (&way)[3], std::size_t i) {
    return {way[0][i], way[1][i], way[2][i]};
}
inline void set_lane(LitLanes (&way)[3], std::size_t i, const glm::vec3& to) {
    way[0][i] = to.x;
    way[1][i] = to.y;
    way[2][i] = to.z;
}

}  // namespace gh::render
