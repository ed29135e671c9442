// render/tile.h - one tile of a picture, ray by ray generation: all its rays are traced together, then all that came of
// them, then all shadows. What a tile makes depends on the tile alone.
#pragma once

#include "render/camera.h"
#include "render/film.h"
#include "render/frame_light.h"
#include "render/gloss.h"
#include "render/path_ray.h"
#include "render/pixel_light.h"
#include "render/sampler.h"
#include "render/shading_point.h"
#include "render/transmittance.h"
#include "render/whitted.h"

#include <glm/vec3.hpp>

#include <cstdint>
#include <optional>
#include <vector>

namespace gh::render {

inline constexpr int kTileSide = 16;

// What all tiles of a frame have in common.
struct Frame {
    const SceneView& view;
    const WhittedSettings& settings;
    const FrameLight& light;
    const GlossTable& gloss;
    Lens lens;
    std::uint32_t number = 0;
    int width = 0, height = 0;
};

// Scratch memory for one thread; trace() may be called for any number of tiles, one after the other.
class TileTracer {
  public:
    explicit TileTracer(const Frame& frame) : frame_(frame) {}

    // Fills the tile's pixels of `pixels` (the whole picture's).
    void trace(int tile_x, int tile_y, std::vector<PixelLight>& pixels, FrameStats& stats);

  private:
    struct Shadow {  // light that arrives if nothing stands in its way
        glm::vec3 light;
        std::uint16_t pixel;
        bool is_shared;
    };

    void add_primary_rays(int sample);
    void trace_generation(FrameStats& stats);
    void trace_shadows(FrameStats& stats);
    void shade_miss(const PathRay& path);
    void shade(PathRay path, const rc::Hit& hit, FrameStats& stats);
    [[nodiscard]] bool pass_through_hole(PathRay& path, const ShadingPoint& at, FrameStats& stats);
    void shade_glass(const PathRay& path, const ShadingPoint& at, FrameStats& stats);
    void shade_opaque(const PathRay& path, const ShadingPoint& at, FrameStats& stats);
    // Light that reaches a surface unless something is in its way: from a lamp, or, baked, from all around.
    struct Arrival {
        glm::vec3 light;
        std::uint32_t lamp;  // kNoIndex: ambient
    };
    void collect_lamps(const PathRay& path, const ShadingPoint& at, const glm::vec3& diffuse,
                       const Gloss& gloss);
    void collect_ambient(const PathRay& path, const ShadingPoint& at, const glm::vec3& diffuse,
                         const glm::vec3& mirrored);
    void ask_for_shadows(const PathRay& path, const ShadingPoint& at);
    void ask_one_below(const PathRay& path, const ShadingPoint& at, float least);
    void ask(const PathRay& path, const ShadingPoint& at, const Arrival& arrival, int count);
    void ask_lamp(const PathRay& path, const ShadingPoint& at, const Arrival& arrival, std::uint32_t number);
    void ask_around(const PathRay& path, const ShadingPoint& at, const glm::vec3& light,
                    std::uint32_t number);
    void settle(const PathRay& path, const std::optional<rc::Ray>& ray, const glm::vec3& light);
    void note_surface(const PathRay& path, const ShadingPoint& at);
    [[nodiscard]] PixelLight& pixel(const PathRay& path) { return pixels_[path.pixel]; }
    [[nodiscard]] bool is_shared(const PathRay& path) const {
        return path.is_leading && frame_.settings.shares_samples;
    }

    const Frame& frame_;
    int x_ = 0, y_ = 0, columns_ = 0, rows_ = 0;  // of the tile, pixels
    int sample_ = 0;
    std::vector<PixelLight> pixels_;
    std::vector<PixelSampler> samplers_;
    std::vector<PathRay> now_, next_;
    std::vector<rc::Ray> rays_;
    std::vector<rc::Hit> hits_;
    std::vector<Arrival> arrivals_;
    std::vector<rc::Ray> shadow_rays_;
    std::vector<Shadow> shadows_;
    std::vector<glm::vec3> shares_;
    ShadowBatch batch_;
};

}  // namespace gh::render
