#include "sim/use_target.h"

#include <optional>

#include "raycore/query.h"

#include "sim/geometry.h"
#include "spatial/transforms.h"
#include "world/eye.h"
#include "world/layers.h"

namespace gh::sim {

namespace {

constexpr float kAimSlack = 0.14f;  // metres a small thing may lie beside the line of sight

struct Aim {
    glm::vec3 eye;
    glm::vec3 look;
};

// How far beside the line of sight a point lies, or nothing when it is behind or beyond reach.
std::optional<float> distance_beside(const Aim& aim, const glm::vec3& point, float reach) {
    const glm::vec3 to_point = point - aim.eye;
    const float along = glm::dot(to_point, aim.look);
    if (!(along > 0.0f) || length_of(to_point) > reach) return std::nullopt;
    const float beside = length_of(to_point - aim.look * along);
    if (!(beside <= kAimSlack)) return std::nullopt;
    return beside;
}

bool is_same_mover(const world::Part& part, world::Mover mover, std::uint32_t index) {
    return part.mover == mover && part.mover_index == index;
}

// Whether a hand gets there: the first solid thing on the way, if any, is the thing itself or what it is set in.
bool is_in_the_open(const world::Level& level, const world::Snapshot& snapshot, const Aim& aim,
                    const glm::vec3& point, world::Mover mover, std::uint32_t index) {
    constexpr float kSetIn = 0.06f;  // metres: a switch sits in its wall, a stone lies on its floor
    const rc::Ray ray{.origin = aim.eye, .direction = point - aim.eye, .t_max = 1.0f};
    const std::optional<rc::Hit> hit = rc::closest_hit(*snapshot.scene, ray, world::Solid);
    if (!hit || is_same_mover(level.parts[hit->instance], mover, index)) return true;
    return (1.0f - hit->t) * length_of(ray.direction) <= kSetIn;
}

class Nearest {
  public:
    void offer(UseKind kind, std::uint32_t index, const glm::vec3& point, float beside) {
        if (target_.kind != UseKind::Nothing && beside >= beside_) return;
        target_ = {kind, index, point};
        beside_ = beside;
    }
    [[nodiscard]] const UseTarget& target() const { return target_; }

  private:
    UseTarget target_;
    float beside_ = 0.0f;
};

UseTarget small_thing(const world::Level& level, const world::Snapshot& snapshot, const Aim& aim) {
    Nearest nearest;
    const auto consider = [&](UseKind kind, world::Mover mover, std::uint32_t i, const glm::vec3& point,
                              float reach) {
        const std::optional<float> beside = distance_beside(aim, point, reach);
        if (beside && is_in_the_open(level, snapshot, aim, point, mover, i)) nearest.offer(kind, i, point, *beside);
    };
    const world::State& state = snapshot.state;
    for (std::uint32_t i = 0; i < level.lenses.size(); ++i) {
        if (state.lens_taken[i] != 0) continue;
        consider(UseKind::Lens, world::Mover::Lens, i, level.lenses[i].centre, kTakeReach);
    }
    for (std::uint32_t i = 0; i < level.switches.size(); ++i) {
        consider(UseKind::Switch, world::Mover::None, i, level.switches[i].position, kUseReach);
    }
    if (level.hand_mirror != world::kNoIndex && state.player.has_mirror == 0) {
        const world::MirrorPane& pane = snapshot.panes[level.hand_mirror];
        consider(UseKind::HandMirror, world::Mover::Mirror, level.hand_mirror, pane.centre, kTakeReach);
    }
    for (std::uint32_t i = 0; i < world::kMaxStones; ++i) {
        const world::StoneState& stone = state.stones[i];
        if (stone.is_present == 0 || stone.is_resting == 0) continue;
        consider(UseKind::Stone, world::Mover::Stone, i, stone.position, kUseReach);
    }
    return nearest.target();
}

UseTarget big_thing(const world::Level& level, const world::Snapshot& snapshot, const Aim& aim) {
    const rc::Ray ray{.origin = aim.eye, .direction = aim.look, .t_max = kUseReach};
    const std::optional<rc::Hit> hit = rc::closest_hit(*snapshot.scene, ray, world::kEverything);
    if (!hit) return {};
    const world::Part& part = level.parts[hit->instance];
    if (part.mover == world::Mover::Door) {
        return {UseKind::Door, part.mover_index, spatial::door_handle(level, snapshot.state, part.mover_index)};
    }
    if (part.mover == world::Mover::Mirror && level.mirrors[part.mover_index].turn_step != 0.0f) {
        return {UseKind::Mirror, part.mover_index, aim.eye + aim.look * hit->t};
    }
    return {};
}

}  // namespace

UseTarget use_target(const world::Level& level, const world::Snapshot& snapshot, const world::PlayerState& player) {
    const Aim aim{world::eye_of(player), world::look_of(player)};
    const UseTarget small = small_thing(level, snapshot, aim);
    return small.kind != UseKind::Nothing ? small : big_thing(level, snapshot, aim);
}

}  // namespace gh::sim
