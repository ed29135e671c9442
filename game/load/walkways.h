// load/walkways.h - questions to a navmesh tile: is there a floor here, and can one get from here to there?
// (The game's own paths are sim/navigation's.)
#pragma once

#include <glm/vec3.hpp>

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

namespace gh::load {

class Walkways {
  public:
    // A tile made by bake_navmesh; empty: there is no floor anywhere.
    explicit Walkways(std::span<const std::byte> tile);
    ~Walkways();
    Walkways(const Walkways&) = delete;
    Walkways& operator=(const Walkways&) = delete;

    // Which polygons can be walked to from any of these places, by their number in the tile.
    [[nodiscard]] std::vector<bool> reached_polygons(std::span<const glm::vec3> places) const;

    // Whether there is a floor within a stride of the place, and one of `reached`.
    [[nodiscard]] bool is_on_floor(const glm::vec3& place) const;
    [[nodiscard]] bool is_reached(const glm::vec3& place, const std::vector<bool>& reached) const;
    // Whether any floor of `reached` comes within `reach` metres across and `up` metres above or below.
    [[nodiscard]] bool is_in_reach(const glm::vec3& thing, float reach, float up,
                                   const std::vector<bool>& reached) const;

    [[nodiscard]] std::size_t polygon_count() const;

  private:
    struct Detour;
    std::unique_ptr<Detour> detour_;  // null: no floor
};

}  // namespace gh::load
