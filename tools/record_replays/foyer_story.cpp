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
void send_the_guard_after_a_stone(Actor& thief) {
    thief.go(floor_at(-7.2f, -8.0f), Pace::Creep, floor_at(-7.9f, -7.8f, 1.25f));
    thief.put_out("switch_foyer_west");
    thief.note("aisle dark");
    thief.throw_stone(floor_at(7.0f, -10.0f), {.is_low = true});
    thief.note("thrown");
    thief.watch_guard(3.0f, {.is_low = true}, [&] { return thief.guard().alert >= Alert::Searching; });
    thief.note("heard");
    thief.go(floor_at(-7.2f, -3.0f), Pace::Creep);
    thief.go(floor_at(-9.0f, -1.4f), Pace::Creep);
    thief.note("in the gallery");
}

void ready_the_mirror(Actor& thief) {
    thief.go(floor_at(-10.7f, 12.0f, kHall), Pace::Walk);
    thief.note("up the gallery");
    thief.go(floor_at(-7.4f, 15.2f, kHall), Pace::Walk);
    thief.note("in the Hall");
    thief.go(floor_at(1.9f, 16.9f, kHall), Pace::Walk);
    thief.turn("mirror_turn_b", 1);
    thief.note("mirror turned");
}

void take_the_lens(Actor& thief) {
    thief.go(floor_at(-0.4f, 17.3f, kHall), Pace::Walk);
    thief.note("at the cabinet");
    thief.open("door_cabinet_left");
    thief.go(floor_at(0.3f, 21.2f, kHall), Pace::Walk, floor_at(0.0f, 22.0f, 1.8f));
    thief.note("at the vitrine");
    thief.open("vitrine_lid");
    thief.note("lid open");
    thief.take("lens_of_the_hall");
    thief.note("taken");
}

void leave_by_the_workshop(Actor& thief) {
    thief.go(floor_at(3.0f, 21.7f, kHall), Pace::Walk);
    thief.open("door_cabinet_workshop");
    thief.note("workshop door open");
    thief.go(floor_at(5.2f, 21.6f, kHall), Pace::Walk);
    thief.shut("door_cabinet_workshop");
    thief.note("shut");
    thief.go(floor_at(10.6f, 19.4f, kHall), Pace::Walk);
    thief.open("door_workshop_east");
    thief.note("gallery door open");
    thief.go(floor_at(10.7f, 14.0f, kHall), Pace::Walk);
    thief.note("in the sculpture gallery");
    // On his round the guard looks in from the foyer. Not before he is up the stair or in the west aisle.
    thief.go(floor_at(9.9f, 9.4f), Pace::Walk);
    thief.watch(floor_at(10.7f, -2.0f, 1.4f), 14.0f, {.is_low = true},
                [&] { return thief.guard().position.z < -3.2f || thief.guard().position.x < -3.0f; });
    thief.note("he is gone");
    thief.go(floor_at(10.4f, 0.5f), Pace::Run);
    thief.note("down the sculpture gallery");
}

void walk_out(Actor& thief) {
    thief.go(floor_at(7.2f, -1.6f), Pace::Walk);
    thief.note("in the foyer");
    thief.go(floor_at(0.6f, -10.0f), Pace::Run);
    thief.open("door_vestibule_right");
    thief.note("vestibule open");
    thief.go(floor_at(0.2f, -14.2f), Pace::Walk);
    thief.watch(floor_at(0.0f, -15.4f, 1.5f), 1.5f);
    thief.note("out");
}

}  // namespace

void play_foyer(Actor& thief) {
    leave_the_cloakroom(thief);
    send_the_guard_after_a_stone(thief);
    ready_the_mirror(thief);
    take_the_lens(thief);
    leave_by_the_workshop(thief);
    walk_out(thief);
}

}  // namespace gh::tools
