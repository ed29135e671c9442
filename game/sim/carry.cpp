#include "sim/carry.h"

#include <array>
#include <span>

namespace gh::sim {

sense::Transmission carry_sound(const world::Level& level, const rc::Scene& scene, const Navigation& navigation,
                                const glm::vec3& source, const glm::vec3& ear, const glm::vec3& feet) {
    constexpr float kCarriedAt = 1.2f;  // metres above the floor, along corridors
    std::array<glm::vec3, 12> corners;
    const Path path = navigation.find_path(source, feet, corners);
    const std::size_t bends = path.arrives && path.corners > 1 ? path.corners - 1 : 0;  // the last is the listener
    for (std::size_t i = 0; i < bends; ++i) corners[i].y += kCarriedAt;
    return sense::hear(level, scene, source, ear, std::span<const glm::vec3>(corners).first(bends));
}

}  // namespace gh::sim
