#include "world/state_hash.h"

#include "base/hash.h"

namespace gh::world {

namespace {

template <class E>
std::uint8_t number(E value) {
    return static_cast<std::uint8_t>(value);
}

void add(Hasher& hasher, const PlayerState& player) {
    hasher.add(player.position);
    hasher.add(player.velocity);
    hasher.add(player.yaw);
    hasher.add(player.pitch);
    hasher.add(player.height);
    hasher.add(player.lean);
    hasher.add(player.stride);
    hasher.add(player.exposure);
    hasher.add(player.noise_db);
    hasher.add(player.mirror_raise);
    hasher.add(player.mirror_side);
    hasher.add(player.mirror_reach);
    hasher.add(number(player.stance));
    hasher.add(player.is_grounded);
    hasher.add(player.ground_surface);
    hasher.add(player.stones_left);
    hasher.add(player.buttons_before);
    hasher.add(player.aim_ticks);
    hasher.add(player.has_mirror);
}

void add(Hasher& hasher, const RulesState& rules) {
    hasher.add(number(rules.outcome));
    hasher.add(rules.lenses_taken_count);
    hasher.add(rules.outcome_tick);
    hasher.add(rules.times_caught);
}

void add(Hasher& hasher, const DoorState& door) {
    hasher.add(door.angle);
    hasher.add(door.wants_open);
    hasher.add(door.held_until_tick);
}

void add(Hasher& hasher, const MirrorState& mirror) {
    hasher.add(mirror.angle);
    hasher.add(mirror.target);
}

void add(Hasher& hasher, const StoneState& stone) {
    hasher.add(stone.position);
    hasher.add(stone.velocity);
    hasher.add(stone.thrown_tick);
    hasher.add(stone.is_present);
    hasher.add(stone.is_resting);
}

void add(Hasher& hasher, const Percept& percept) {
    hasher.add(percept.seen_at);
    hasher.add(percept.heard_at);
    hasher.add(percept.struck_from);
    hasher.add(percept.sight);
    hasher.add(percept.mirror_sight);
    hasher.add(percept.sight_metres);
    hasher.add(percept.mirror_metres);
    hasher.add(percept.heard_db);
    hasher.add(percept.is_fresh);
    hasher.add(percept.is_struck);
}

void add(Hasher& hasher, const GuardState& guard) {
    hasher.add(guard.position);
    hasher.add(guard.velocity);
    hasher.add(guard.yaw);
    hasher.add(guard.head_yaw);
    hasher.add(guard.suspicion);
    add(hasher, guard.percept);
    hasher.add(guard.target);
    hasher.add(guard.last_known);
    for (const glm::vec3& corner : guard.path) hasher.add(corner);
    hasher.add(guard.path_count);
    hasher.add(guard.path_next);
    hasher.add(guard.patrol_next);
    hasher.add(guard.wait_ticks);
    hasher.add(guard.state_ticks);
    hasher.add(guard.clip_time);
    hasher.add(guard.clip_blend);
    hasher.add(guard.clip_before_time);
    hasher.add(guard.stride);
    hasher.add(guard.seen_ticks);
    hasher.add(guard.quiet_ticks);
    hasher.add(guard.searched);
    hasher.add(guard.stuck_ticks);
    hasher.add(number(guard.alert));
    hasher.add(number(guard.raised_by));
    hasher.add(number(guard.clip));
    hasher.add(number(guard.clip_before));
}

void add(Hasher& hasher, const Noise& noise) {
    hasher.add(noise.position);
    hasher.add(noise.loudness_db);
    hasher.add(number(noise.kind));
    hasher.add(noise.surface);
    hasher.add(number(noise.bark));
    hasher.add(noise.by_guard);
}

template <class Range>
std::uint64_t hash_all(const Range& things) {
    Hasher hasher;
    for (const auto& thing : things) add(hasher, thing);
    return hasher.digest();
}

std::uint64_t hash_flags(std::span<const std::uint8_t> flags) { return hash_bytes(std::as_bytes(flags)); }

std::uint64_t hash_noises(const State& state) {
    Hasher hasher;
    hasher.add(state.noise_count);
    for (const Noise& noise : state.noises) add(hasher, noise);
    return hasher.digest();
}

std::uint64_t hash_player(const State& state) {
    Hasher hasher;
    add(hasher, state.player);
    return hasher.digest();
}

std::uint64_t hash_rules(const State& state) {
    Hasher hasher;
    hasher.add(state.tick);
    hasher.add(state.seed);
    add(hasher, state.rules);
    return hasher.digest();
}

}  // namespace

StateHash state_hash(const State& state) {
    StateHash hash;
    hash.part = {hash_player(state),           hash_rules(state),            hash_all(state.doors),
                 hash_all(state.mirrors),      hash_flags(state.group_on),   hash_flags(state.lens_taken),
                 hash_all(state.stones),       hash_all(state.guards),       hash_noises(state)};
    Hasher total;
    for (const std::uint64_t part : hash.part) total.add(part);
    hash.total = total.digest();
    return hash;
}

std::string_view hash_part_name(HashPart part) {
    constexpr std::array<std::string_view, kHashParts> kNames = {
        "player", "rules", "doors", "mirrors", "lamps", "lenses", "stones", "guards", "noises"};
    return kNames[static_cast<std::size_t>(part)];
}

}  // namespace gh::world
