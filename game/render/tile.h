// render/tile.h - one tile of a picture, ray by ray generation: all its rays are traced together, then all that came of
// them, then all shadows. What a tile makes depends on the tile alone.
#pragma once

#include "render/camera.h"
#include "render/film.h"
#include "render/frame_light.h"
#include "render/gloss.h"
#include "render/guide_colors.h"
#include "render/guide_point.h"
#include "render/lamp_looks.h"
#include "render/lamps_together.h"
#include "render/lattice.h"
#include "render/main_surfaces.h"
#include "render/path_ray.h"
#include "render/pixel_light.h"
#include "render/sampler.h"
#include "render/shading_point.h"
#include "render/transmittance.h"
#include "render/whitted.h"

#include <glm/vec3.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
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
    GuidePlanes* guide = nullptr;  // to be filled: only what is seen is of interest, not its light
};

// Scratch memory for one thread; trace() may be called for any number of tiles, one after the other.
class TileTracer {
  public:
    explicit TileTracer(const Frame& frame) : frame_(frame), colors_(frame.settings.texture_taps) {}

    // Fills the tile's pixels of `pixels` (the whole picture's).
    void trace(int tile_x, int tile_y, std::vector<PixelLight>& pixels, FrameStats& stats);

    // Fills frame.guide for those pixels of the tile, counted along its rows, whose rays meet `hits`.
    void look_at(int tile_x, int tile_y, const std::vector<std::uint16_t>& which,
                 const std::vector<rc::Hit>& hits);

  private:
    using TileLattice = Lattice<kTileSide>;
    // Where light goes: to the pixel, to what its main surface mirrors, or to what neighbours share.
    enum class Share : std::uint8_t { Pixel, Reflection, Neighbours };
    struct Shadow {  // light that arrives if nothing stands in its way
        glm::vec3 light;
        std::uint32_t lamp;  // kNoIndex: ambient
        std::uint16_t pixel;
        Share share;
    };
    // Light that reaches a surface unless something is in its way: from a lamp, or, baked, from all around.
    struct Arrival {
        glm::vec3 light;
        std::uint32_t lamp;  // kNoIndex: ambient
        float open;          // about the share of it that gets here
        // What it is expected to bring.
        [[nodiscard]] float expected() const;
    };
    // Light that is seen as it is.
    struct Glow {
        glm::vec3 light;
        std::uint16_t pixel;
        Share share;
        std::size_t after;  // so many surfaces of glimmers_
    };
    // The main surfaces of the pixels around one that were visited in earlier passes and are of its kind.
    struct Corners {
        std::uint16_t centre = 0;
        std::uint8_t count = 0;
        std::array<std::uint16_t, 4> surface{};
        std::array<float, 4> weight{};  // sum 1
    };

    // tile.cpp: where rays go.
    void trace_sample(FrameStats& stats);
    void begin(int tile_x, int tile_y);
    void add_primary_rays();
    void add_primary_ray(std::uint16_t pixel);
    [[nodiscard]] glm::vec2 pixel_point(int x, int y) const;
    void trace_all(FrameStats& stats);
    void trace_generation();
    void shade_generation(FrameStats& stats);
    void trace_shadows(FrameStats& stats);
    void shade_miss(const PathRay& path);
    void shade_together(std::size_t begin, std::size_t end, FrameStats& stats);
    void shade(PathRay& path, const rc::Hit& hit, const ShadingPoint& at, FrameStats& stats);
    [[nodiscard]] bool pass_through_hole(PathRay& path, const ShadingPoint& at, FrameStats& stats);
    // tile_glass.cpp, tile_opaque.cpp: what becomes of one at a surface.
    void shade_glass(const PathRay& path, const ShadingPoint& at, FrameStats& stats);
    void shade_opaque(const PathRay& path, const ShadingPoint& at, const rc::Hit& hit, FrameStats& stats);
    // tile_light.cpp: what reaches a surface, into arrivals_.
    [[nodiscard]] SurfaceLight collect_light(const SeenSurface& surface, std::size_t i);
    // Of the surfaces of lit_: visit(number, i), when it is the i-th that lamps_ was asked for.
    template <class Visit>
    void visit_lit(Visit visit);
    void light_glimmers();
    void shine(const PathRay& path, const glm::vec3& light);
    void collect_ambient(const SeenSurface& surface, SurfaceLight& light);
    // tile_shadow.cpp: which of it is worth a shadow ray.
    void ask_for_all(const SeenSurface& surface);
    void ask_for_brightest(const SeenSurface& surface);
    void ask_for_shares(const SeenSurface& surface, bool speaks_for_many);
    void estimate_below(const SeenSurface& surface, float least);
    void ask(const SeenSurface& surface, const Arrival& arrival, int count);
    void ask_lamp(const SeenSurface& surface, const Arrival& arrival, std::uint32_t number);
    void ask_around(const SeenSurface& surface, const glm::vec3& light, std::uint32_t number);
    void arrive(const PathRay& path, const glm::vec3& light);
    void look(const PathRay& path, const rc::Ray& ray, const glm::vec3& light, std::uint32_t lamp);
    // tile_adaptive.cpp: for which pixels all this is done, and how the others come by their light.
    void light_main_surfaces(FrameStats& stats);
    void light_pass(int pass, FrameStats& stats);
    [[nodiscard]] bool is_blended(const Corners& corners);
    // tile_reflection.cpp: the same for what polished floors mirror.
    void reflect_main_surfaces(FrameStats& stats);
    void reflect_pass(int pass, FrameStats& stats);
    [[nodiscard]] bool is_reflection_blended(const Corners& corners);
    [[nodiscard]] PathRay mirrored_ray(const SeenSurface& surface) const;

    // Whether there are enough of them to blend.
    [[nodiscard]] bool finds_corners(int x, int y, int pass, Corners& corners) const;
    // The main surfaces of a pass for which `blend` does not find an answer in those around them, into not_blended_.
    template <class Blend>
    void visit_pass(int pass, Blend blend);

    void note_surface(const PathRay& path, const ShadingPoint& at);
    [[nodiscard]] bool note_plain(const PathRay& path, const rc::Hit& hit);
    void note_thing(const PathRay& path, GuidePoint point) const;
    [[nodiscard]] std::size_t picture_index(std::uint16_t pixel) const;
    void add_main_light();
    [[nodiscard]] float light_so_far(std::uint16_t surface) const;
    [[nodiscard]] glm::vec3& light_of(std::uint16_t pixel, Share share);
    // Of light that comes along a ray without having to be asked for.
    [[nodiscard]] static Share visible_share(const PathRay& path) {
        return path.is_glimmer ? Share::Reflection : Share::Pixel;
    }
    [[nodiscard]] Share share_of(const PathRay& path) const {
        if (path.is_leading && frame_.settings.shares_samples) return Share::Neighbours;
        return visible_share(path);
    }

    const Frame& frame_;
    int x_ = 0, y_ = 0, columns_ = 0, rows_ = 0;  // of the tile, pixels
    int sample_ = 0;
    std::vector<PixelLight> pixels_;
    std::vector<PixelSampler> samplers_;
    std::vector<PathRay> now_, next_;
    std::vector<rc::Ray> rays_;
    std::vector<rc::Hit> hits_;
    std::vector<SeenSurface> glimmers_;  // of this generation: surfaces beside the main ones
    std::vector<Glow> glows_;
    std::vector<const SeenSurface*> lit_;
    LampsTogether lamps_;
    std::vector<Arrival> arrivals_;
    std::vector<rc::Ray> shadow_rays_;
    std::vector<Shadow> shadows_;
    std::vector<glm::vec3> shares_;
    LampLooks looks_;
    ShadowBatch batch_;
    MainSurfaces main_;  // of this sample
    std::vector<std::uint16_t> not_blended_;
    TileLattice across_, down_;
    GuideTriangles triangles_;
    GuideColors colors_;  // of the guide's surfaces
};

}  // namespace gh::render
