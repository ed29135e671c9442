// render/fresnel.h - how much of the light a surface mirrors, and where the rest goes.
//
// Same bits pure; square roots only.
#pragma once

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>

namespace gh::render {

// What happens at the border of two clear media.
struct Interface {
    float reflectance =
        1.0f;  // of unpolarised light, exact (Fresnel 1823); 1 under total internal reflection
    float cos_transmitted = 0.0f;  // of the angle of the bent ray; 0 under total internal reflection
};

// `cos_incident` in [0, 1]; `eta` is the index behind the border over the index before it.
[[nodiscard]] inline Interface fresnel(float cos_incident, float eta) {
    const float sin2_transmitted = (1.0f - cos_incident * cos_incident) / (eta * eta);
    if (!(sin2_transmitted < 1.0f)) return {};
    const float cos_transmitted = std::sqrt(1.0f - sin2_transmitted);
    const float parallel = (eta * cos_incident - cos_transmitted) / (eta * cos_incident + cos_transmitted);
    const float perpendicular =
        (cos_incident - eta * cos_transmitted) / (cos_incident + eta * cos_transmitted);
    return {0.5f * (parallel * parallel + perpendicular * perpendicular), cos_transmitted};
}

// The bent direction. `direction` unit, `normal` unit and towards where the ray comes from.
[[nodiscard]] inline glm::vec3 refracted(const glm::vec3& direction, const glm::vec3& normal, float eta,
                                         float cos_incident, float cos_transmitted) {
    return glm::normalize(direction / eta + normal * (cos_incident / eta - cos_transmitted));
}

// Share that a sheet of glass too thin to bend light mirrors, all passes to and fro inside it added up.
[[nodiscard]] inline float thin_sheet_reflectance(float reflectance) {
    return 2.0f * reflectance / (1.0f + reflectance);
}

// Mirrored head on by a medium of this index, seen from air.
[[nodiscard]] inline float reflectance_head_on(float ior) {
    const float ratio = (ior - 1.0f) / (ior + 1.0f);
    return ratio * ratio;
}

// What grazing light is mirrored; an index of 1 mirrors nothing at any angle.
[[nodiscard]] inline float grazing_share(const glm::vec3& f0) {
    return std::min(1.0f, 50.0f * std::max({f0.x, f0.y, f0.z}));
}

// Schlick's approximation, as glTF asks for. `f90` is what grazing light sees.
[[nodiscard]] inline glm::vec3 schlick(const glm::vec3& f0, float f90, float cosine) {
    const float m = std::clamp(1.0f - cosine, 0.0f, 1.0f);
    const float m5 = m * m * m * m * m;
    return f0 + (glm::vec3(f90) - f0) * m5;
}

}  // namespace gh::render
