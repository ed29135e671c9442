"""Gives actions other keys in the real menu, plays with them, and plays again with what was kept.

    rebinding_window_test.py GLASSHOUSE OUT_FOLDER

Walking forward goes from W to I, crouching to the middle mouse button. The recordings hold what was done and not by which
key: they verify for somebody who has other keys, and none at all.
"""

import json
import os
import time

from desk import Desk, fail, program_and_folder, ticks_spent

DOWN_TO_CONTROLS = ("Down", "Down", "Return")


def hold_button(desk, button, seconds):
    desk.xdotool("mousedown", button)
    desk.let_pass(seconds)
    desk.xdotool("mouseup", button)


def bind_keys(desk):
    desk.press("Escape", *DOWN_TO_CONTROLS, "Return")
    desk.screenshot("2_asks_for_a_key")
    desk.press("i")
    desk.screenshot("3_has_it")
    desk.press("Return", "Escape")  # asks again, and is not answered
    desk.screenshot("4_kept_it")
    desk.press("Down", "Down", "Down", "Down", "Down", "Return")
    hold_button(desk, "2", 0.6)
    desk.let_pass(0.5)
    desk.screenshot("5_crouches_by_mouse")
    desk.press("Escape", "Escape")  # to the first page, and out


def keys_of(out):
    with open(os.path.join(out, "home/config/glasshouse/settings.json"), encoding="utf-8") as file:
        return json.load(file)["keys"]


def play(glasshouse, out, name, before=None):
    """Walks by I and crouches by the mouse; returns the recording, and for how many seconds I was down."""
    recording = os.path.join(out, name + ".rec")
    with Desk([glasshouse, "foyer", "--size", "640x360", "--quality", "low", "--record", recording], out) as desk:
        desk.wait_for_picture(name)
        if before:
            before(desk)
        desk.hold("w", 3.0)  # nobody's any more
        down = time.monotonic()
        desk.hold("i", 0.8)
        seconds = time.monotonic() - down
        hold_button(desk, "2", 1.5)
        desk.xdotool("key", "e")  # a tap that is over before the game looks
        desk.let_pass(1.0)
        desk.quit_by_menu()
    return recording, seconds


def check(glasshouse, recording, seconds):
    spent = ticks_spent(glasshouse, recording)
    print(spent)
    for verb in ("walking", "crouching", "using"):
        if spent[verb] == 0:
            fail(f"{os.path.basename(recording)}: the key for {verb} never reached it")
    if spent["walking"] > 60 * (seconds + 1.0):  # W was down for three seconds or more
        fail(f"W still walks: {spent['walking']} ticks")


def main():
    glasshouse, out = program_and_folder()
    first = play(glasshouse, out, "1_bound_in_the_menu", bind_keys)
    keys = keys_of(out)
    if keys["walk_forward"][0] != "I" or keys["crouch"][0] != "middle mouse":
        fail(f"the settings file holds {keys['walk_forward']} and {keys['crouch']}")
    second = play(glasshouse, out, "6_kept_for_the_next_run")
    for recording, seconds in (first, second):
        check(glasshouse, recording, seconds)


main()
