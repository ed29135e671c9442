#include "audio/soundscape.h"

#include "audio/acoustics.h"
#include "audio/foley.h"
#include "base/random.h"

#include <glm/geometric.hpp>

#include <algorithm>

namespace gh::audio {

namespace {

// Keys: the kind in the top bits, then what makes it one of its kind. Two noises never share one while both
// ring, because a tick has at most kMaxNoises of them.
constexpr std::uint32_t kHumKeys = 1u << 30;
constexpr std::uint32_t kToneKey = 2u << 30;
constexpr std::uint32_t kRuleKeys = (2u << 30) + 1;
constexpr std::uint32_t kWhistleKeys = 3u << 30;

constexpr float kMouthHeight = 1.62f;  // metres over a guard's feet
constexpr float kHumGain = 1.0f;
// What falls or treads on a floor sounds from just above it, as guards hear it: half of all rounded feet are a hair
// below, and a floor takes 67 dB.
constexpr glm::vec3 kOffFloor{0.0f, 0.05f, 0.0f};  // metres
constexpr std::uint32_t kWhistlePeriod = 25 * world::kTicksPerSecond;

// Loudness is squeezed a little: 20 dB of the world are 15 dB in the headphones, or a crouched step would be lost.
constexpr float kDynamics = 0.75f;

float gain_of(const world::Noise& noise, SoundId sound) {
    return gain_from_db(kDynamics * (noise.loudness_db - traits(sound.sound).reference_db));
}

}  // namespace

Soundscape::Soundscape(const SoundBank& bank) {
    for (std::size_t family = 0; family < kSoundCount; ++family) {
        const auto sound = static_cast<Sound>(family);
        for (std::uint8_t variant = 0; variant < traits(sound).variants; ++variant) {
            lengths_.push_back(bank.ticks({sound, variant}));
        }
    }
}

std::span<const Source> Soundscape::sources(const world::Level& level, const world::State& state,
                                            const glm::vec3& ear) {
    if (state.tick != last_tick_ + 1) {
        ringing_.clear();
        last_outcome_ = state.rules.outcome;
        last_caught_ = state.rules.times_caught;
    }
    last_tick_ = state.tick;
    std::erase_if(ringing_, [&](const Ringing& r) { return r.ends_tick <= state.tick; });
    add_noises(level, state);
    add_rules(state);
    add_whistles(level, state);

    listed_.clear();
    for (Ringing& r : ringing_) {
        if (r.follows_guard < level.guards.size()) {
            r.source.position = state.guards[r.follows_guard].position + glm::vec3(0.0f, kMouthHeight, 0.0f);
        }
        listed_.push_back(r.source);
    }
    list_hums(level, state, ear);
    listed_.push_back({.sound = {Sound::RoomTone, 0}, .key = kToneKey, .loops = true, .is_everywhere = true});
    return listed_;
}

void Soundscape::ring(const Source& source, std::uint32_t tick, std::uint8_t guard) {
    if (ringing_.size() == kMaxRinging) ringing_.erase(ringing_.begin());
    ringing_.push_back({source, tick + lengths_[flat_index(source.sound)], guard});
}

void Soundscape::add_noises(const world::Level& level, const world::State& state) {
    for (std::uint32_t i = 0; i < state.noise_count; ++i) {
        const world::Noise& noise = state.noises[i];
        const bool is_door =
            noise.kind == world::NoiseKind::DoorOpen || noise.kind == world::NoiseKind::DoorClose;
        const bool is_lid = is_door && is_lid_at(level, noise.position);
        const std::optional<SoundId> sound = sound_of(noise, state.tick, i, is_lid);
        if (!sound) continue;
        const std::uint32_t key =
            (state.tick * static_cast<std::uint32_t>(world::kMaxNoises) + i) & (kHumKeys - 1);
        const bool is_voice = noise.kind == world::NoiseKind::Bark;
        ring({.sound = *sound, .key = key, .position = noise.position + kOffFloor, .gain = gain_of(noise, *sound)},
             state.tick, is_voice ? noise.by_guard : std::uint8_t{0xFF});
    }
}

// Stings: what has just become of the player.
void Soundscape::add_rules(const world::State& state) {
    const world::RulesState& rules = state.rules;
    const bool is_won = rules.outcome == world::Outcome::Won && last_outcome_ != world::Outcome::Won;
    const bool is_caught =
        (rules.outcome == world::Outcome::Caught && last_outcome_ != world::Outcome::Caught) ||
        (rules.times_caught > last_caught_ && last_outcome_ == world::Outcome::Playing);
    last_outcome_ = rules.outcome;
    last_caught_ = rules.times_caught;
    if (!is_won && !is_caught) return;
    const Sound sound = is_won ? Sound::StingWon : Sound::StingCaught;
    ring({.sound = {sound, 0}, .key = kRuleKeys + (state.tick & 0xFFFFu), .is_everywhere = true}, state.tick,
         0xFF);
}

// A guard who is at ease whistles now and then as he walks. Nobody in the game hears it but the player.
void Soundscape::add_whistles(const world::Level& level, const world::State& state) {
    for (std::uint32_t g = 0; g < level.guards.size(); ++g) {
        const world::GuardState& guard = state.guards[g];
        const std::uint32_t turn = hash_u32(g, 17) % kWhistlePeriod;
        if ((state.tick + turn) % kWhistlePeriod != 0) continue;
        if (guard.alert != world::Alert::Calm || guard.clip != world::ClipId::Walk) continue;
        ring({.sound = variant_of(Sound::VoiceWhistle, state.tick, g),
              .key = kWhistleKeys + g,
              .position = guard.position},
             state.tick, static_cast<std::uint8_t>(g));
    }
}

// The nearest lamps that shine; equally near: the earlier one.
void Soundscape::list_hums(const world::Level& level, const world::State& state, const glm::vec3& ear) {
    struct Near {
        float metres;
        std::uint32_t lamp;
    };
    std::vector<Near> near;
    for (std::uint32_t i = 0; i < level.lamps.size(); ++i) {
        if (level.lamps[i].shape == world::LampShape::Sun || !world::is_lamp_on(level, state, i)) continue;
        const float metres = glm::length(level.lamps[i].position - ear);
        if (metres < kHumRange) near.push_back({metres, i});
    }
    const std::size_t count = std::min(near.size(), kMaxHums);
    std::partial_sort(near.begin(), near.begin() + static_cast<std::ptrdiff_t>(count), near.end(),
                      [](const Near& a, const Near& b) {
                          return a.metres < b.metres || (a.metres == b.metres && a.lamp < b.lamp);
                      });
    for (std::size_t i = 0; i < count; ++i) {
        // Fades towards the edge of its range, so that lamps neither appear nor vanish.
        const float fade = std::min(1.0f, (kHumRange - near[i].metres) / 3.0f);
        listed_.push_back({.sound = {Sound::LampHum, 0},
                           .key = kHumKeys + near[i].lamp,
                           .position = level.lamps[near[i].lamp].position,
                           .gain = kHumGain * fade,
                           .loops = true});
    }
}

}  // namespace gh::audio
