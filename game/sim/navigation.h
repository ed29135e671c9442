// sim/navigation.h - ways through a level on its baked navmesh; the only file that knows Detour.
//
// Cost      a path 20-40 us, the others a few. Construction copies the tile.
// Threads   one Navigation belongs to one thread: its search keeps scratch nodes (which no answer depends on).
// Same bits the mesh is baked and hashed; Detour's search, its straight path and its border walk use no libm but
//           sqrt, and ties are settled by polygon order.
// Bad input a level without a navmesh, or with one that Detour refuses, has no ways: is_there() is false.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <span>

#include <glm/vec3.hpp>

#include "world/level.h"

namespace gh::sim {

struct Path {
    std::size_t corners = 0;
    bool arrives = false;  // otherwise it ends as near as one can get, or where `out` was full
};

class Navigation {
  public:
    explicit Navigation(const world::Level& level);
    ~Navigation();
    Navigation(const Navigation&) = delete;
    Navigation& operator=(const Navigation&) = delete;

    [[nodiscard]] bool is_there() const;

    // The place on the mesh nearest to `p`, if there is one within 1.5 m sideways and 2 m up or down.
    [[nodiscard]] std::optional<glm::vec3> nearest(const glm::vec3& p) const;

    // Corners to walk from one place to another, the goal last and the start left out.
    [[nodiscard]] Path find_path(const glm::vec3& from, const glm::vec3& to, std::span<glm::vec3> out) const;

    // Where one gets from `from` on the way to `to`, sliding along the mesh's border; the height is the mesh's.
    [[nodiscard]] glm::vec3 walk_along(const glm::vec3& from, const glm::vec3& to) const;

    // How far a straight walk gets: `to`, or the point at the border before it.
    [[nodiscard]] glm::vec3 straight(const glm::vec3& from, const glm::vec3& to) const;

    // Metres along the way, or nothing when there is none.
    [[nodiscard]] std::optional<float> distance(const glm::vec3& from, const glm::vec3& to) const;

  private:
    struct Detour;
    std::unique_ptr<Detour> detour_;
};

}  // namespace gh::sim
