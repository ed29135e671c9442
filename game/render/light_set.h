// render/light_set.h - all that shines in one frame: lamps, emissive triangles, suns. Picks one of them for a point and
// a direction towards it, and says how likely it would have picked what a path ran into by itself.
//
// Lamps that are meshes shine by their triangles, so that what is seen, what is picked and what is run into are the
// same light; a rect or ball without a mesh (tests have them) is met by ray without being in anybody's way.
//
// Lamps that the level's lamp lists know to be in sight of a place are picked there by how much each would give; all
// else is picked by a light tree, less often, so that nothing is ever missed.
//
// Cost      made each frame: 1.0 to 1.3 us a light, most of it the light tree; picking .4 us over
//           the museum with its 3,710, as long as the tree takes where the lists know no lamp.
// Threads   immutable once made. Borrows all it is made from.
// Same bits pure.
#pragma once

#include "render/frame_light.h"
#include "render/gleams.h"
#include "render/lamp_weights.h"
#include "render/light_tree.h"
#include "render/scene_view.h"
#include "render/solid_angle.h"

#include "raycore/ray.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace gh::render {

struct LightSample {
    glm::vec3 direction{0.0f};  // unit
    // Radiance that arrives if nothing is in its way; of a lamp without extent, irradiance across the direction. With
    // a target it is 0 until the ray has been traced: emission_at() says.
    glm::vec3 light{0.0f};
    float density = 0.0f;  // over solid angle; of a lamp without extent, the probability of picking it
    bool is_delta = false;
    rc::Ray ray;         // up to the light, or to where the target may begin: what it meets is in its way
    float reach = 0.0f;  // along the ray, where the target ends
    std::uint32_t part = world::kNoIndex;              // whose light it is, if a part's
    std::uint32_t target_part = world::kNoIndex;       // what the ray has to meet next; kNoIndex: nothing
    std::uint32_t target_primitive = world::kNoIndex;  // kNoIndex: any emissive one of the part
};

class Environment;

class LightSet {
  public:
    // `environment` may be null. `kept` is the light tree of an earlier frame of this level, or null, and becomes this
    // frame's: the same one while no light has changed.
    LightSet(const SceneView& view, const FrameLight& frame, const Environment* environment,
             std::shared_ptr<const KeptLightTree>& kept);

    [[nodiscard]] std::optional<LightSample> sample(const rc::SurfacePoint& point, const LightQuery& query,
                                                    float u_light, const glm::vec2& u) const;

    // With which sample() would have given the direction from query.position to `position` on this triangle; 0 for what
    // it never picks.
    [[nodiscard]] float density(const LightQuery& query, std::uint32_t part, std::uint32_t primitive,
                                const glm::vec3& position) const;

    // Where light of lamps that are on comes off their shades.
    [[nodiscard]] GleamGuide gleams_at(const LightQuery& query) const {
        return {view_.prepared.gleams, gleam_on_, query.position, query.normal};
    }

    // The same for a direction into the environment.
    [[nodiscard]] float environment_density(const LightQuery& query, const glm::vec3& direction) const;

    // What a hit triangle sends towards where the ray came from: only its front shines, unless it is double-sided.
    [[nodiscard]] glm::vec3 emission_at(const rc::Hit& hit, const glm::vec3& direction) const;

    // Lamps without a mesh that the way from `from` along `direction`, up to `t_max`, goes through.
    struct BareHit {
        glm::vec3 light{0.0f};
        float density = 0.0f;  // that sample() would have had at query.position
    };
    template <class Visit>
    void visit_bare(const LightQuery& query, const glm::vec3& from, const glm::vec3& direction, float t_max,
                    Visit visit) const {
        for (const std::uint32_t light : bare_) {
            if (const auto hit = bare_hit(light, query, from, direction, t_max)) visit(*hit);
        }
    }

    [[nodiscard]] std::size_t size() const { return lights_.size() + suns_.size(); }

  private:
    enum class Kind : std::uint8_t { Point, Rect, Ball, Triangle };
    struct Light {
        Kind kind = Kind::Point;
        bool is_double_sided = false;
        std::uint32_t lamp = world::kNoIndex;  // without a mesh
        std::uint32_t part = world::kNoIndex;
        std::uint32_t primitive = world::kNoIndex;
        glm::vec3 radiance{0.0f};  // of a lamp without a mesh, and of a panel
        float power = 0.0f;        // irradiance times distance squared, face on, mean of the colours
        std::uint32_t listed_as = world::kNoIndex;  // lamp, in lamp lists
        RectShape rect;
        BallShape ball;
        TriangleShape triangle;
    };

    void add_lamps(const FrameLight& frame, std::vector<LightBounds>& bounds);
    void add_emitter(const Emitter& emitter, std::vector<LightBounds>& bounds);
    void add_triangle(const Emitter& emitter, std::uint32_t primitive, std::vector<LightBounds>& bounds);
    // What lamps of a list may give there.
    void weigh_listed(const LightQuery& query, std::span<const std::uint32_t> list,
                      LampWeights::Weights& weights) const;
    [[nodiscard]] float listed_weight(std::uint32_t lamp, const LightQuery& query) const;
    struct Listed {
        float weight = 0.0f;           // of all of them
        float share = 0.0f;            // of picks
        LampWeights::Weights first{};  // of the list's first lamps
    };
    [[nodiscard]] Listed listed_at(const LightQuery& query) const;
    [[nodiscard]] bool is_listed(const Light& light, const LightQuery& query) const;
    [[nodiscard]] LightTree::Pick pick_listed(const LightQuery& query, const Listed& listed, float u) const;
    [[nodiscard]] std::optional<LightTree::Pick> pick_near(const LightQuery& query, float u) const;
    // With which a light is picked among those that are near.
    [[nodiscard]] float near_probability(const LightQuery& query, std::uint32_t light) const;
    void note_listed(std::uint32_t lamp, std::uint32_t light);
    void weigh_lamps();
    // Suns and environment together: how much light they may give, how often one of them is picked.
    [[nodiscard]] float far_weight(const LightQuery& query) const;
    [[nodiscard]] float far_share(const LightQuery& query) const;
    [[nodiscard]] float sun_weight(std::uint32_t sun, const LightQuery& query) const;
    [[nodiscard]] float environment_weight() const;
    [[nodiscard]] std::optional<LightSample> sample_far(const rc::SurfacePoint& point,
                                                        const LightQuery& query, float u_light,
                                                        const glm::vec2& u, float share) const;
    static void limit(const Light& light, float distance, LightSample& sample);
    [[nodiscard]] LightSample sample_light(const Light& light, const rc::SurfacePoint& point,
                                           const glm::vec2& u) const;
    [[nodiscard]] float density_of(const Light& light, const glm::vec3& from, const glm::vec3& at) const;
    [[nodiscard]] std::optional<BareHit> bare_hit(std::uint32_t light, const LightQuery& query,
                                                  const glm::vec3& from, const glm::vec3& direction,
                                                  float t_max) const;

    const SceneView& view_;
    const Environment* environment_;
    std::vector<Light> lights_;
    std::vector<std::uint32_t> suns_;  // lamps
    std::vector<std::uint32_t> bare_;  // lights
    std::vector<std::uint32_t>
        first_of_part_;  // light; kNoIndex: none. Triangles follow in their emitter's order
    std::vector<const Emitter*> emitter_of_part_;
    std::vector<std::uint32_t> light_of_lamp_;  // kNoIndex: not picked by list
    std::vector<std::uint8_t> is_beam_;         // one a lamp
    LampWeights lamp_weights_;
    std::vector<std::uint8_t> gleam_on_;
    std::shared_ptr<const KeptLightTree> tree_;
};

}  // namespace gh::render
