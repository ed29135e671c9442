#include "sim/stone_flight.h"

#include <array>
#include <optional>
#include <span>

#include "raycore/query.h"

#include "sim/body_cast.h"
#include "sim/geometry.h"
#include "sim/noises.h"
#include "sim/planes.h"
#include "world/layers.h"

namespace gh::sim {

namespace {

using world::kSurfaceCount;
using world::Surface;

constexpr int kMaxBounces = 16;          // a tick; a stone that bounces more often waits for the next one
constexpr std::size_t kMaxContacts = 4;  // surfaces it rolls along at once
constexpr float kRestSpeed = 0.0626f;    // m/s: sqrt(2 g kStoneSkin), the bounce that does not leave the skin
constexpr float kStopSpeed = 0.05f;      // m/s: a stone rolling slower lies still
constexpr float kHoldingPull = 3.0f;     // m/s2 along the slope that rest resists: 18 degrees
constexpr float kRollingDrag = 0.16f;    // deceleration of a rolling stone over its weight
constexpr float kFeltSpeed = 0.5f;       // m/s into a guard: what only rolls against a boot is not felt
constexpr Surface kCoat = Surface::Carpet;  // what a guard is to a stone: heavy cloth

const glm::vec3 kFall{0.0f, -kGravity, 0.0f};

// In the order of world::Surface: marble concrete parquet plaster stud glass pane oak metal curtain ceiling carpet.
constexpr std::array<float, kSurfaceCount> kRestitution = {0.6f,  0.5f,  0.45f, 0.35f, 0.35f, 0.55f,
                                                           0.55f, 0.42f, 0.5f,  0.05f, 0.25f, 0.15f};
constexpr std::array<float, kSurfaceCount> kFriction = {0.15f, 0.3f, 0.2f, 0.3f, 0.3f, 0.1f,
                                                        0.1f,  0.2f, 0.2f, 0.6f, 0.4f, 0.6f};

// When a body `gap` above a plane, moving at `speed` away from it under `pull` away from it, comes down to it.
std::optional<float> time_to_plane(float gap, float speed, float pull) {
    const float root_square = speed * speed - 2.0f * pull * gap;
    if (!(root_square >= 0.0f)) return std::nullopt;
    const float root = std::sqrt(root_square);
    if (speed > 0.0f) {
        if (!(pull < 0.0f)) return std::nullopt;
        return (speed + root) / -pull;
    }
    if (gap <= 0.0f) return 0.0f;
    const float closing = root - speed;
    if (!(closing > 0.0f)) return std::nullopt;
    return 2.0f * gap / closing;
}

// What a stone meets: a triangle of the scene, or a guard's coat.
struct Contact {
    rc::CastHit hit;
    std::uint32_t guard = world::kNoIndex;
};

// One stone through one tick. A class because the steps share what they change.
class Flight {
  public:
    Flight(const world::Level& level, const rc::Scene& scene, std::span<const Body> guards, world::StoneState& stone)
        : level_(level), scene_(scene), guards_(guards), stone_(stone) {}

    Impact run() {
        for (int i = 0; i < kMaxBounces && left_ > 0.0f; ++i) {
            const glm::vec3 pull = along_planes(contacts(), kFall);
            const auto contact = cast(reach(pull, left_));
            if (!contact) {
                advance(pull, left_, reach(pull, left_));
                break;
            }
            if (contact->hit.depth > 0.0f) leave_overlap(contact->hit);
            fly_to(*contact, pull);
        }
        rest_when_slow();
        hardest_.guard = guard_;
        return hardest_;
    }

  private:
    [[nodiscard]] std::span<const glm::vec3> contacts() const { return std::span(contacts_).first(contact_count_); }

    [[nodiscard]] std::optional<Contact> cast(const glm::vec3& displacement) const {
        std::optional<Contact> first;
        const auto hit = rc::sphere_cast(scene_, stone_.position, level_.stone_radius, displacement, world::Solid);
        if (hit) first = Contact{.hit = *hit};
        for (std::size_t g = 0; g < guards_.size(); ++g) {
            const auto met = cast_at_body(guards_[g], stone_.position, level_.stone_radius, displacement);
            if (!met || (first && first->hit.t <= met->t)) continue;
            first = Contact{.hit = {.t = met->t, .point = met->point, .normal = met->normal},
                            .guard = static_cast<std::uint32_t>(g)};
        }
        return first;
    }

    [[nodiscard]] glm::vec3 reach(const glm::vec3& pull, float seconds) const {
        return stone_.velocity * seconds + pull * (0.5f * seconds * seconds);
    }

    // Time passes; rolling is braked by what the contacts carry.
    void advance(const glm::vec3& pull, float seconds, const glm::vec3& displacement) {
        stone_.position += displacement;
        stone_.velocity += pull * seconds;
        left_ -= seconds;
        if (contact_count_ == 0) return;
        const float carried = length_of(kFall - pull);
        const float speed = length_of(stone_.velocity);
        const float kept = std::max(speed - kRollingDrag * carried * seconds, 0.0f);
        if (speed > 0.0f) stone_.velocity *= kept / speed;
    }

    // A surface that has moved into the stone (a door) lets it out, if nothing else is in the way.
    void leave_overlap(const rc::CastHit& hit) {
        const glm::vec3 out = hit.normal * (std::min(hit.depth, level_.stone_radius) + kStoneSkin);
        const rc::Ray way{.origin = stone_.position, .direction = out, .t_max = 1.0f};
        if (!rc::any_hit(scene_, way, world::Solid)) stone_.position += out;
    }

    // Flies until the parabola meets the surface that the straight cast has found, and bounces there.
    void fly_to(Contact contact, const glm::vec3& pull) {
        const rc::CastHit& hit = contact.hit;
        const float gap = glm::dot(stone_.position - hit.point, hit.normal) - (level_.stone_radius + kStoneSkin);
        const float speed = glm::dot(stone_.velocity, hit.normal);
        const std::optional<float> solved = time_to_plane(gap, speed, glm::dot(pull, hit.normal));
        float seconds = std::min(solved.value_or(hit.t * left_), left_);
        glm::vec3 displacement = reach(pull, seconds);

        // The parabola is not the chord, and an edge is not its plane: what is flown is cast itself.
        const auto nearer = cast(displacement);
        if (nearer) {
            contact = *nearer;
            const float length = length_of(displacement);
            const float share = length > 0.0f ? std::max(hit.t - kStoneSkin / length, 0.0f) : 0.0f;
            displacement *= share;
            seconds *= share;
        }
        advance(pull, seconds, displacement);
        bounce(contact);
    }

    void bounce(const Contact& contact) {
        const rc::CastHit& hit = contact.hit;
        const bool is_guard = contact.guard != world::kNoIndex;
        const Surface surface = is_guard ? kCoat : surface_at(level_, hit.instance, hit.primitive);
        const float speed_in = -glm::dot(stone_.velocity, hit.normal);
        if (speed_in < 0.0f) return;  // on its way out already
        if (is_guard && speed_in >= kFeltSpeed) guard_ = contact.guard;
        if (!hardest_.is_there || speed_in > hardest_.speed) {
            hardest_ = {true, stone_.position, speed_in, surface, world::kNoIndex};
        }
        const float bounciness = restitution(surface);
        glm::vec3 sliding = stone_.velocity + hit.normal * speed_in;
        const float sliding_speed = length_of(sliding);
        const float lost = kFriction[index_of(surface)] * (1.0f + bounciness) * speed_in;
        sliding *= sliding_speed > lost ? 1.0f - lost / sliding_speed : 0.0f;

        float speed_out = bounciness * speed_in;
        if (speed_out < kRestSpeed) {
            speed_out = 0.0f;
            if (contact_count_ < kMaxContacts) contacts_[contact_count_++] = hit.normal;
            sliding = along_planes(contacts(), sliding);
        }
        stone_.velocity = sliding + hit.normal * speed_out;
    }

    void rest_when_slow() {
        if (contact_count_ == 0 || length_of(stone_.velocity) > kStopSpeed) return;
        if (length_of(along_planes(contacts(), kFall)) > kHoldingPull) return;
        stone_.velocity = glm::vec3(0.0f);
        stone_.is_resting = 1;
    }

    const world::Level& level_;
    const rc::Scene& scene_;
    std::span<const Body> guards_;
    world::StoneState& stone_;
    float left_ = world::kTickSeconds;
    std::array<glm::vec3, kMaxContacts> contacts_;
    std::size_t contact_count_ = 0;
    Impact hardest_;
    std::uint32_t guard_ = world::kNoIndex;
};

// Whether what a stone lay on is still there, and has not moved into it.
bool still_lies(const world::Level& level, const rc::Scene& scene, const world::StoneState& stone) {
    const glm::vec3 down{0.0f, -4.0f * kStoneSkin, 0.0f};
    const auto hit = rc::sphere_cast(scene, stone.position, level.stone_radius, down, world::Solid);
    return hit && hit->depth <= kStoneSkin;
}

}  // namespace

float restitution(Surface surface) { return kRestitution[index_of(surface)]; }

Impact fly(const world::Level& level, const rc::Scene& scene, world::StoneState& stone, std::span<const Body> guards) {
    if (stone.is_resting != 0) {
        if (still_lies(level, scene, stone)) return {};
        stone.is_resting = 0;
    }
    return Flight(level, scene, guards, stone).run();
}

}  // namespace gh::sim
