// An Actor's hands: switches, mirrors, lids, doors, and what is taken.
#include "actor.h"
#include "hands.h"
#include "sim/doors.h"
#include "sim/geometry.h"
#include "spatial/transforms.h"
#include "world/eye.h"

#include <fmt/format.h>

#include <cmath>

namespace gh::tools {

namespace {

using input::Button;
using input::Command;

constexpr int kMostUseTicks = 240;
constexpr int kMostDoorTicks = 150;

}  // namespace

void Actor::use(const glm::vec3& point, sim::UseKind kind, std::uint32_t index, std::string_view name) {
    for (int i = 0; i < kMostUseTicks && !trouble_; ++i) {
        const sim::UseTarget target = sim::use_target(*level_, *simulation_.snapshot(), state().player);
        const bool is_it = target.kind == kind && target.index == index;
        Command command = looking_at(point);
        if (is_it && std::abs(turn_speed_) < 0.02f) {
            press(state().player, Button::Use, command);
            return step(command, {});
        }
        step(command, {});
    }
    fail(fmt::format("{} is out of reach", name));
}

void Actor::put_out(std::string_view lamp_switch) {
    const auto index = named(level_->switches, lamp_switch);
    if (!index) return fail(fmt::format("there is no {}", lamp_switch));
    use(level_->switches[*index].position, sim::UseKind::Switch, *index, lamp_switch);
}

void Actor::turn(std::string_view mirror, int steps) {
    const auto index = named(level_->mirrors, mirror);
    if (!index) return fail(fmt::format("there is no {}", mirror));
    for (int i = 0; i < steps && !trouble_; ++i) {
        use(level_->mirrors[*index].pivot + glm::vec3(0.0f, 1.2f, 0.0f), sim::UseKind::Mirror, *index,
            mirror);
        watch(level_->mirrors[*index].pivot + glm::vec3(0.0f, 1.2f, 0.0f), 0.4f);
    }
}

void Actor::take(std::string_view lens) {
    const auto index = named(level_->lenses, lens);
    if (!index) return fail(fmt::format("there is no {}", lens));
    use(level_->lenses[*index].centre, sim::UseKind::Lens, *index, lens);
}

void Actor::take_hand_mirror() {
    if (level_->hand_mirror == world::kNoIndex) return fail("there is no hand mirror");
    const glm::vec3 at = simulation_.snapshot()->panes[level_->hand_mirror].centre;
    use(at, sim::UseKind::HandMirror, level_->hand_mirror, "the hand mirror");
}

void Actor::open(std::string_view door, float wide) {
    const auto index = named(level_->doors, door);
    if (!index) return fail(fmt::format("there is no {}", door));
    use(spatial::door_handle(*level_, state(), *index), sim::UseKind::Door, *index, door);
    const glm::vec3 handle = level_->doors[*index].handle;
    for (int i = 0; i < kMostDoorTicks && !trouble_; ++i) {
        if (sim::openness(*level_, state(), *index) > wide) return;
        const glm::vec3 away = sim::flat(state().player.position - handle);
        Command command = looking_along(world::look_of(state().player));
        // Room for the leaf, in case it swings this way.
        const glm::vec3 now_at =
            sim::flat(spatial::door_handle(*level_, state(), *index) - state().player.position);
        if (sim::length_of(now_at) < 0.75f) walk_along(sim::unit_or_zero(away), 0.7f, command);
        step(command, {});
    }
    fail(fmt::format("{} does not open", door));
}

void Actor::shut(std::string_view door) {
    const auto index = named(level_->doors, door);
    if (!index) return fail(fmt::format("there is no {}", door));
    use(spatial::door_handle(*level_, state(), *index), sim::UseKind::Door, *index, door);
}

glm::vec3 Actor::handle_of(std::string_view door) const {
    const auto index = named(level_->doors, door);
    return index ? spatial::door_handle(*level_, state(), *index) : state().player.position;
}

glm::vec3 Actor::switch_at(std::string_view lamp_switch) const {
    const auto index = named(level_->switches, lamp_switch);
    return index ? level_->switches[*index].position : state().player.position;
}

}  // namespace gh::tools
