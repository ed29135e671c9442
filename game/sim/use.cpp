#include "sim/use.h"

#include "sim/doors.h"
#include "sim/noises.h"

namespace gh::sim {

namespace {

constexpr float kSwitchDb = 42.0f;
constexpr float kLensDb = 38.0f;

void toggle_lamps(const world::Level& level, std::uint32_t index, world::State& state) {
    const world::Switch& it = level.switches[index];
    state.group_on[it.group] = state.group_on[it.group] != 0 ? 0 : 1;
    emit_by_player(state, {.position = it.position,
                           .loudness_db = kSwitchDb,
                           .kind = world::NoiseKind::Switch,
                           .surface = static_cast<std::uint8_t>(world::Surface::Metal)});
}

void take_lens(const world::Level& level, std::uint32_t index, world::State& state) {
    state.lens_taken[index] = 1;
    state.rules.lenses_taken_count += 1;
    emit_by_player(state, {.position = level.lenses[index].centre,
                           .loudness_db = kLensDb,
                           .kind = world::NoiseKind::LensTaken,
                           .surface = static_cast<std::uint8_t>(world::Surface::Glass)});
}

constexpr float kPickUpDb = 24.0f;

void note_pick_up(const world::PlayerState& player, world::Surface surface, world::State& state) {
    emit_by_player(state, {.position = player.position + glm::vec3(0.0f, 0.5f * player.height, 0.0f),
                           .loudness_db = kPickUpDb,
                           .kind = world::NoiseKind::PickUp,
                           .surface = static_cast<std::uint8_t>(surface)});
}

void take_mirror(world::State& state) {
    state.player.has_mirror = 1;
    note_pick_up(state.player, world::Surface::Metal, state);
}

void pick_up_stone(std::uint32_t index, world::State& state) {
    state.stones[index] = {};
    state.player.stones_left += 1;
    note_pick_up(state.player, world::Surface::Marble, state);
}

}  // namespace

void use(const world::Level& level, const UseTarget& target, world::State& state) {
    switch (target.kind) {
        case UseKind::Nothing: return;
        case UseKind::Door:
            state.doors[target.index].held_until_tick = 0;  // from now on it is the player's affair
            return toggle_door(level, state, target.index, kNobody);
        case UseKind::Mirror: return turn_mirror(level, state, target.index);
        case UseKind::Switch: return toggle_lamps(level, target.index, state);
        case UseKind::Lens: return take_lens(level, target.index, state);
        case UseKind::HandMirror: return take_mirror(state);
        case UseKind::Stone: return pick_up_stone(target.index, state);
    }
}

}  // namespace gh::sim
