// render/path_tile.h - one tile of a path-traced picture: the paths of all its pixels go on bounce by bounce together,
// so that their rays can be traced in batches. What a tile makes depends on the tile alone.
//
// A kernel is made for what a scene needs (scene_needs.h) and a picture is asked for: one without kClearKernel has no
// code for glass, holes and what a path is inside of, one without kPlanesKernel none for what filters want to know.
//
// Threads   scratch memory for one thread; trace() may be called for any number of tiles, one after the other.
// Same bits a kernel gives what the one with everything gives, wherever it may be used.
#pragma once

#include "render/bsdf.h"
#include "render/camera.h"
#include "render/film.h"
#include "render/frame_light.h"
#include "render/light_set.h"
#include "render/path_ray.h"
#include "render/path_tracer.h"
#include "render/shading_point.h"
#include "render/tile_samples.h"

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include <cstdint>
#include <type_traits>
#include <vector>

namespace gh::render {

inline constexpr int kPathTileSide = TileSamples::kSide;

enum KernelFeature : unsigned { kClearKernel = 1, kPlanesKernel = 2 };
inline constexpr unsigned kAllFeatures = kClearKernel | kPlanesKernel;

// What all tiles of a frame have in common.
struct PathFrame {
    const SceneView& view;
    const PathSettings& settings;
    const FrameLight& light;
    const LightSet& lights;
    Lens lens;
    Lens lens_before;  // when the shutter opened; the same where nothing moves
    std::uint32_t number = 0;
    int width = 0, height = 0;
};

template <unsigned kFeatures>
class PathTile {
  public:
    explicit PathTile(const PathFrame& frame) : frame_(frame) {}

    // Fills the tile's pixels of the film.
    void trace(int tile_x, int tile_y, Film& film, FrameStats& stats);

  private:
    // Where light goes in filter/gbuffer.h's terms. Mirrored: by panes on the way, beside what is seen through them.
    enum class Channel : std::uint8_t { Direct, Indirect, Specular, Mirrored, Clean };
    static constexpr std::size_t kChannels = 5;
    static constexpr bool kHasClear = (kFeatures & kClearKernel) != 0;
    static constexpr bool kHasPlanes = (kFeatures & kPlanesKernel) != 0;
    using Media = std::conditional_t<kHasClear, MediumStack, NoMedia>;

    struct Path {
        rc::Ray ray;
        glm::vec3 start{0.0f};   // where the ray starts, exactly
        glm::vec3 weight{1.0f};  // what its light counts in the pixel
        LightQuery from;         // the last place that asked lamps
        float density = 0.0f;    // with which it sent the path here; 0: nobody asked, all that shines counts
        float survival = 1.0f;   // what roulette goes by: the weight, were no path sent anywhere on purpose
        [[no_unique_address]] Media media;
        float cone_width = 0.0f, cone_angle = 0.0f;
        std::uint32_t sample = 0;
        std::uint32_t branch = 0;   // of paths split at glass
        std::uint16_t pixel = 0;    // of the tile
        std::uint8_t depth = 0;     // scatterings so far
        std::uint8_t passes = 0;    // holes and sheets so far
        std::uint8_t scatters = 0;  // off anything but mirrors and smooth glass so far
        std::uint8_t splits = 0;    // at panes so far
        Channel channel = Channel::Clean;
        bool is_eye = true;         // met mirrors and smooth glass only
        bool is_leading = true;     // its surface speaks for the pixel
        bool has_bent = false;      // mirrored or bent by something smooth since `from`
        bool is_rough = false;      // scattered by something rough
        bool is_first_leg = false;  // the way from the main surface to the next
        bool is_beside = false;     // shows another thing than the planes tell of
    };
    struct Shadow {  // light that arrives if nothing stands in its way
        glm::vec3 diffuse;
        glm::vec3 gloss;
        glm::vec3 start;
        float reach;
        const world::Material* inside;
        std::uint32_t target_part, target_primitive;
        std::uint16_t pixel;
        Channel diffuse_channel, gloss_channel;
        bool is_indirect, is_beside;
    };
    struct Sum {
        glm::dvec3 light[kChannels] =
            {};  // double: thousands of equal samples would else be rounded the same way
    };
    // What the leading path has gone through so far, for the planes.
    struct Unfolding {
        glm::mat3 turned{1.0f};                     // from what is seen to what is there, as mirrors turn it
        float length = 0.0f;                        // metres from the eye
        glm::vec3 position{0.0f}, geometric{0.0f};  // where that meets the first thing, as it is there
        std::uint32_t shown = 0;  // samples that saw what the planes tell of, the first among them
    };

    [[nodiscard]] bool is_asked(int pixel) const;
    void add_eye_paths(std::uint32_t first_sample, std::uint32_t count);
    void trace_generation(FrameStats& stats);
    void meet_together(std::size_t begin, std::size_t end, FrameStats& stats);
    void trace_shadows(FrameStats& stats);
    void look_through(FrameStats& stats);
    void look_for_targets();
    void ask_left(rc::LayerMask layers);
    void settle(const Shadow& shadow, const rc::Ray& ray, const rc::Hit& hit, FrameStats& stats);

    // path_tile_shade.inl
    void meet_nothing(const Path& path);
    void meet(Path path, const rc::Hit& hit, ShadingPoint& at, FrameStats& stats);
    [[nodiscard]] bool passes_hole(Path& path, const ShadingPoint& at, FrameStats& stats);
    void add_emission(const Path& path, const ShadingPoint& at, const rc::Hit& hit);
    void add_bare_lamps(const Path& path, float t_max);
    void add_met_light(const Path& path, const glm::vec3& light, float lamp_density);
    // One place that scatters, and where it might send paths on purpose.
    struct Scatterer {
        const ShadingPoint& at;
        const Bsdf& bsdf;
        const Media& beyond;  // what a path is in that goes through
        float gap = 0.0f;     // metres behind the surface in which other skins of glass lie
        GleamGuide guide;
    };
    // A place on the skin of a body of glass.
    struct Crossing {
        Media beyond;
        Border border;
        float gap = 0.0f;
        bool is_seen = true;  // otherwise light goes on as if nothing was there
    };
    void split(const Path& path, const Scatterer& here, FrameStats& stats);
    void ask_lamp(const Path& path, const Scatterer& here, bool is_last);
    void end_in_bake(const Path& path, const Scatterer& here);
    void add_baked_light(const Path& path, const Scatterer& here);
    struct Onward : BsdfSample {
        float survival = 1.0f;  // brightest weight, were it not sent on purpose
    };
    [[nodiscard]] Onward pick_onward(const Path& path, const Scatterer& here);
    void send_on(const Path& path, const Scatterer& here, const Onward& sample, FrameStats& stats);
    [[nodiscard]] Crossing crossing_at(const Path& path, const ShadingPoint& at) const;
    void go_straight_on(Path& path, const ShadingPoint& at, FrameStats& stats);
    [[nodiscard]] bool survives(Path& path);
    void add(std::uint16_t pixel, Channel channel, const glm::vec3& light, bool is_indirect, bool is_beside);

    // path_tile_planes.inl
    void begin_planes();
    void note_mirror(const Path& path, const ShadingPoint& at, bool passes);
    void note_ray(std::uint16_t pixel);
    void note_surface(const Path& path, const ShadingPoint& at, const rc::Hit& hit, const Bsdf& bsdf);
    [[nodiscard]] bool shows_another(const Path& path, const ShadingPoint& at, const Bsdf& bsdf);
    void note_reflection(const Path& path, float t);
    void note_light(std::uint16_t pixel, std::uint32_t samples);
    [[nodiscard]] glm::vec3 position_before(const ShadingPoint& at, const rc::Hit& hit) const;
    [[nodiscard]] glm::ivec2 film_pixel(std::uint16_t pixel) const;

    [[nodiscard]] rc::Ray eye_ray(const Path& path);
    [[nodiscard]] glm::vec2 picture_point(const Path& path);
    [[nodiscard]] std::uint32_t dimension(const Path& path, std::uint32_t purpose) const;
    // Random numbers of a path, for a purpose of this bounce.
    [[nodiscard]] float one(const Path& path, std::uint32_t purpose) {
        return samples_.one(path.pixel, path.sample, dimension(path, purpose));
    }
    [[nodiscard]] glm::vec2 two(const Path& path, std::uint32_t purpose) {
        return samples_.two(path.pixel, path.sample, dimension(path, purpose));
    }
    [[nodiscard]] bool fills_planes(const Path& path) const {
        return kHasPlanes && frame_.settings.fills_planes && path.is_leading && path.sample == 0;
    }

    const PathFrame& frame_;
    Film* film_ = nullptr;
    int x_ = 0, y_ = 0, columns_ = 0, rows_ = 0;  // of the tile, pixels
    TileSamples samples_;
    std::vector<Sum> sums_;
    std::vector<Unfolding> unfolding_;
    std::vector<Sum> beside_;  // of sums_, what is none of the surface that planes tell of
    std::vector<Path> now_, next_;
    std::vector<rc::Ray> rays_;
    std::vector<rc::Hit> hits_;
    std::vector<rc::Ray> shadow_rays_;
    std::vector<Shadow> shadows_;
    std::vector<std::uint8_t> is_blocked_;
    std::vector<rc::Hit> in_the_way_;  // one a shadow
    std::vector<rc::Ray> left_;
    std::vector<std::size_t> left_index_;
};

}  // namespace gh::render
