// render/guide_gleams.h - what polished floors, columns and metals mirror, in every pixel of a guide: what the last picture
// showed of it, what shines by itself, and lamps' highlights.
//
// It is added to what a guide calls clean. Whoever lights few pixels takes that off their light, and what is left is smooth
// enough to be spread: the guide need not be right, only sharp. Pixels whose mirrored ray met what the last picture did
// not show are marked by another part number, so that none of these lends its light to one of the others. Metals show nothing
// else, and are thin and bent: neighbours have little to lend, so what was out of sight is guessed there, and not marked.
// Highlights that outshine what else is there are marked as well, each pixel by itself.
//
// Cost      a mirrored ray and, where a highlight lies, a shadow ray a polished pixel.
// Same bits pure; what is added depends on the pixel alone.
#pragma once

#include "render/film.h"
#include "render/frame_light.h"
#include "render/gloss.h"
#include "render/guide_colors.h"
#include "render/guide_point.h"
#include "render/last_picture.h"
#include "render/transmittance.h"

#include "raycore/ray.h"

#include <cstddef>
#include <vector>

namespace gh::render {

class GleamTracer {
  public:
    struct World {
        const SceneView& view;
        const FrameLight& light;
        const GlossTable& gloss;
        bool guides_lamps;  // as WhittedSettings has it
    };
    explicit GleamTracer(const World& world) : world_(world) {}

    // A pixel that shows a polished triangle. The ray's direction is unit.
    void add(const GuideTriangle& triangle, const rc::Ray& ray, const rc::Hit& hit, std::size_t pixel,
             GuidePlanes& planes);

    // For all that were added since the last time.
    void trace(GuidePlanes& planes);

  private:
    struct Gleam {
        glm::vec3 weight;  // of what the mirrored ray brings
        float bulb_share;  // of lamps' bulbs, that it shows
        std::size_t pixel;
        bool is_of_metal;
    };
    struct Guess {
        glm::vec3 light;  // times this colour
        glm::vec3 albedo;
        std::size_t pixel;
    };
    struct Highlight {
        glm::vec3 light;
        std::size_t pixel;
    };
    void add_highlights(std::size_t pixel, const rc::SurfacePoint& at, const glm::vec3& mirrored,
                        const Gloss& gloss, std::uint8_t& outshone);
    // What is known of it; what is not is guessed or marks the pixel.
    void add_mirrored(const Gleam& gleam, const rc::Ray& ray, const rc::Hit& hit, GuidePlanes& planes);
    // If it shines by itself, that.
    [[nodiscard]] bool add_shining(const Gleam& gleam, const rc::Ray& ray, const rc::Hit& hit,
                                   GuidePlanes& planes);

    // About what is there: its own colour, under the light that was baked.
    void guess(const Gleam& gleam, const rc::Ray& ray, const rc::Hit& hit);

    GuideColors colors_{1.0f};
    World world_;
    std::vector<rc::Ray> rays_, shadow_rays_;
    std::vector<rc::Hit> hits_;
    std::vector<Gleam> gleams_;
    std::vector<Guess> guesses_;
    std::vector<Highlight> highlights_;
    std::vector<glm::vec3> shares_;
    ShadowBatch shadows_;
    GuideTriangles triangles_;
    glm::vec3 unused_{0.0f};  // colour of what is mirrored
};

}  // namespace gh::render
