#include "foyer_story.h"

namespace gh::tools {

namespace {

using world::Alert;

// The plan's own coordinates: metres east and north.
constexpr glm::vec3 floor_at(float east, float north, float height = 0.0f) {
    return {east, height, -north};
}
constexpr float kHall = 0.8f;  // metres: the Hall's floor

// In the dark, and only when the guard has turned his back.
void leave_the_cloakroom(Actor& thief) {
    thief.note("spawn");
    thief.go(floor_at(-11.2f, -9.5f), Pace::Walk);
    thief.take_hand_mirror();
    thief.note("mirror taken");
    thief.go(floor_at(-9.3f, -7.9f), Pace::Walk);
    thief.put_out("switch_cloak");
    thief.note("lamp out");
    thief.go(floor_at(-9.7f, -8.8f), Pace::Walk);
    thief.open("door_cloakroom");
    thief.note("door open");
    thief.go(floor_at(-8.7f, -8.4f), Pace::Creep, floor_at(-7.5f, -10.5f, 1.2f));
    thief.note("at the door");
    thief.watch_guard_in_mirror(
        5.0f, -1.0f, [&] { return thief.guard().position.x > -1.2f && thief.guard().wait_ticks == 0; });
    thief.note("he turns away");
}

// Into the far corner, so that he searches where the thief is not.
void send_the_guard_after_a_stone(Actor& thief, int take) {
    thief.go(floor_at(-7.2f, -8.0f), Pace::Creep, thief.switch_at("switch_foyer_west"));
    thief.put_out("switch_foyer_west");
    thief.note("aisle dark");
    thief.throw_stone(floor_at(7.0f, -10.0f), {.is_low = true});
    thief.note("thrown");
    constexpr float kCreepsUpTo = -5.6f, kTakesApart = 0.5f;  // metres north
    thief.go_watching_guard(floor_at(-7.2f, kCreepsUpTo + kTakesApart * static_cast<float>(take % 8)),
                            Pace::Creep);
    thief.note("heard");
    thief.go(floor_at(-7.2f, -3.0f), Pace::Walk);
    thief.go(floor_at(-9.0f, -1.4f), Pace::Walk);
    thief.note("in the gallery");
}

void ready_the_mirror(Actor& thief, int take) {
    constexpr float kRunsUpTo = 8.0f, kTakesApart = 2.0f;  // metres north
    const int shorter = take / 8;
    thief.go(floor_at(-10.7f, kRunsUpTo - kTakesApart * static_cast<float>(shorter)), Pace::Run);
    thief.go(floor_at(-10.7f, 12.0f, kHall), Pace::Walk);
    thief.note("up the gallery");
    thief.go(floor_at(-7.4f, 15.2f, kHall), Pace::Walk);
    thief.note("in the Hall");
    thief.go_for(floor_at(2.6f, 15.1f, kHall), Pace::Walk, floor_at(2.6f, 16.2f, 2.0f));
    thief.turn("mirror_turn_b", 2);
    thief.note("mirror turned");
}

void take_the_lens(Actor& thief) {
    thief.go_for(floor_at(-0.4f, 17.3f, kHall), Pace::Walk, thief.handle_of("door_cabinet_left"));
    thief.note("at the cabinet");
    thief.open("door_cabinet_left", 0.5f);
    thief.go(floor_at(-0.4f, 19.8f, kHall), Pace::Walk, floor_at(0.0f, 22.0f, 1.8f));
    thief.go(floor_at(0.9f, 20.6f, kHall), Pace::Walk, floor_at(0.0f, 22.0f, 1.8f));
    thief.go(floor_at(0.1f, 21.2f, kHall), Pace::Walk, floor_at(0.0f, 22.0f, 1.8f));
    thief.note("at the vitrine");
    thief.open("vitrine_lid");
    thief.note("lid open");
    thief.take("lens_of_the_hall");
    thief.note("taken");
}

// He has heard steps, and stands in the archway as the thief comes out.
void leave_by_the_stair(Actor& thief) {
    const auto is_seen = [&] { return thief.guard().suspicion > 20.0f; };
    thief.go(floor_at(-0.3f, 18.4f, kHall), Pace::Walk);
    thief.note("at the cabinet's door");
    thief.go_until(floor_at(-0.6f, 16.6f, kHall), Pace::Walk, is_seen);
    thief.note("in the Hall");
    thief.go_watching_guard(floor_at(0.4f, 11.2f, kHall), Pace::Walk, is_seen);
    thief.note("seen");
    thief.go(floor_at(0.0f, 10.0f, kHall), Pace::Run);
    thief.note("through the Hall");
    thief.go(floor_at(0.0f, 2.0f), Pace::Run);
    thief.note("down the stair");
}

// A last look back, at him.
void walk_out(Actor& thief) {
    thief.go_for(floor_at(0.6f, -10.0f), Pace::Run, thief.handle_of("door_vestibule_right"));
    thief.note("at the vestibule");
    thief.open("door_vestibule_right", 0.5f);
    thief.note("vestibule open");
    thief.go(floor_at(0.2f, -14.2f), Pace::Run);
    thief.watch_guard(1.7f);
    thief.note("out");
}

}  // namespace

void play_foyer(Actor& thief, int take) {
    leave_the_cloakroom(thief);
    send_the_guard_after_a_stone(thief, take);
    ready_the_mirror(thief, take);
    take_the_lens(thief);
    leave_by_the_stair(thief);
    walk_out(thief);
}

}  // namespace gh::tools
