// sim/level_kit.h - small levels made by hand: rooms, boxes, ramps, doors, lamps, guards.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "world/layers.h"
#include "world/level.h"

namespace gh::test {

inline constexpr rc::LayerMask kWall = world::kEverything;

class LevelKit {
  public:
    LevelKit();

    // Everything added from now on is of this surface.
    LevelKit& surface(world::Surface surface);

    // A closed room, one mesh: floor at y = min.y.
    LevelKit& room(const glm::vec3& min, const glm::vec3& max);
    LevelKit& box(const glm::vec3& min, const glm::vec3& max, rc::LayerMask layers = kWall);
    // A floor that rises along +x from (x, 0, z_min) by `angle_deg` for `length` metres along the slope.
    LevelKit& ramp(float x, float z_min, float z_max, float angle_deg, float length);
    // A leaf in the x-y plane from `hinge` along +x, opening towards -z (positive angle) in 48 ticks.
    LevelKit& door(const glm::vec3& hinge, float width, float height, float open_angle = 1.6f);
    LevelKit& glass_lid(const glm::vec3& hinge, float width, float depth);  // towards -z; opens upwards about x
    LevelKit& mirror(const glm::vec3& centre, float half_width, float half_height, float yaw, float turn_step);
    LevelKit& lamp(const glm::vec3& position, float watts_per_sr, const std::string& group = "");
    LevelKit& light_switch(const glm::vec3& position, const std::string& group);
    LevelKit& lens(const glm::vec3& centre);
    LevelKit& exit(const glm::vec3& min, const glm::vec3& max);
    LevelKit& spawn(const glm::vec3& feet, float yaw);
    LevelKit& guard(const glm::vec3& feet, float yaw, std::vector<world::PatrolPoint> patrol = {});

    // With stones, bounds and, when wanted, a navmesh of the floor at y = 0 around the solid boxes.
    std::shared_ptr<const world::Level> finish(bool with_navmesh = false);

    world::Level level;

  private:
    std::uint32_t add_mesh(std::vector<glm::vec3> positions, std::vector<glm::uvec3> triangles);
    world::Part& add_part(std::uint32_t mesh, rc::LayerMask layers);
    std::uint32_t box_mesh(const glm::vec3& min, const glm::vec3& max);
    std::uint32_t group_named(const std::string& name);

    [[nodiscard]] bool is_walkable(float x, float z) const;

    std::uint32_t material_ = 0;
    world::Aabb room_;
    std::vector<world::Aabb> boxes_;
};

}  // namespace gh::test
