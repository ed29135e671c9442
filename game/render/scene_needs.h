// render/scene_needs.h - what of all that the renderer can do a scene asks for: nothing is modelled that nobody would see.
//
// Who goes by it: path_tracer picks a kernel without code for clear things where there are none, and one without code for
// planes where no filter wants them; a path asks what touches only where bodies of glass do; shading_point looks up no uv
// where a material has no texture; the table of cloth is made where there is cloth. The rest are branches that are never
// taken. README.md has what it costs.
//
// Cost      finding: once a level, 1.4 ms for a museum; most of it asks which glass closes a volume.
// Same bits a function of the level. A kernel made for a scene's needs gives the bits of the one made for all.
#pragma once

#include "world/level.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace gh::render {

enum class Need : std::uint8_t {
    Textures,
    NormalMaps,
    Gloss,        // something mirrors, however dull: not all is Lambert's
    Mirrors,      // so smoothly that rays do not spread
    Holes,        // cut-out or blended
    Sheets,       // of glass without a thickness
    SolidGlass,   // light bends
    NestedGlass,  // bodies of glass that touch, overlap or lie in each other
    RoughGlass,
    Absorption,
    Varnish,
    Cloth,
    Anisotropy,
    Emitters,   // meshes that shine
    BareLamps,  // lamps that are none
    Suns,
    ManyLights,  // so many that a light tree is worth it
    Deforming,   // bodies that bend
    Moving       // parts that go from place to place
};
inline constexpr std::size_t kNeeds = 19;

class SceneNeeds {
  public:
    [[nodiscard]] bool has(Need need) const { return (bits_ & bit(need)) != 0; }
    void add(Need need, bool is_needed = true) { bits_ |= is_needed ? bit(need) : 0u; }
    [[nodiscard]] bool has_clear() const {
        return has(Need::Holes) || has(Need::Sheets) || has(Need::SolidGlass);
    }

    friend bool operator==(const SceneNeeds&, const SceneNeeds&) = default;

  private:
    [[nodiscard]] static constexpr std::uint32_t bit(Need need) {
        return std::uint32_t{1} << static_cast<unsigned>(need);
    }
    std::uint32_t bits_ = 0;
};

// `is_solid`: one a part, whether its glass closes a volume. Materials that no triangle has count for nothing.
[[nodiscard]] SceneNeeds scene_needs(const world::Level& level, const std::vector<std::uint8_t>& is_solid);
// The same for who has not asked about the glass yet.
[[nodiscard]] SceneNeeds scene_needs(const world::Level& level);

// "textures, gloss, solid glass"; "nothing" for none.
[[nodiscard]] std::string sentence_of(const SceneNeeds& needs);

}  // namespace gh::render
