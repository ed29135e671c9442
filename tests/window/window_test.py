"""Plays the game through its real window under Xvfb: what a person's first minute needs to work.

    window_test.py GLASSHOUSE OUT_FOLDER
"""

import os
import subprocess

from desk import TIMEOUT_S, Desk, fail, program_and_folder, ticks_spent


def look_round(desk, first):
    desk.xdotool("mousemove_relative", "--", "120", "10")
    _, moved = desk.wait_until("2_looked", lambda path: desk.difference(first, path), lambda moved: moved > 0.02)
    print(f"looked round: the picture changed by {moved:.4f}")


def walk(desk):
    standing = desk.screenshot("2_standing")
    desk.hold("w", 2.0)
    moved = desk.difference(standing, desk.screenshot("2_walked"))
    print(f"walked: the picture changed by {moved:.4f}")
    if moved < 0.02:
        fail("holding W changed nothing to be seen")
    desk.hold("c", 1.5)
    desk.xdotool("key", "F3")
    desk.let_pass(1.0)
    desk.screenshot("3_profiler")


def resize(desk):
    desk.xdotool("windowsize", "--sync", desk.window, "960", "600")
    desk.let_pass(1.5)
    resized = desk.screenshot("4_resized")
    mean, deviation = desk.figures(resized, "960x600+0+0")
    print(f"resized: mean {mean:.4f}, deviation {deviation:.4f}")
    if deviation < 0.01:
        fail("nothing is drawn after resizing")
    desk.xdotool("windowsize", "--sync", desk.window, "640", "360")
    desk.let_pass(1.0)


def pause(desk):
    if desk.pointer_can_leave():
        fail("the pointer leaves the window while the game is played")
    desk.xdotool("key", "F3")  # the profiler's figures go on behind the menu, and they may
    desk.let_pass(0.5)
    before_menu = desk.screenshot("5_before_menu")
    desk.xdotool("key", "Escape")
    desk.let_pass(1.5)
    menu = desk.screenshot("6_menu")
    change = desk.difference(before_menu, menu)
    print(f"paused: the picture changed by {change:.4f}")
    if change < 0.01:
        fail("Escape shows no menu")
    still = desk.screenshot("7_menu_again")
    if desk.difference(menu, still) > change / 4:
        fail("the world goes on behind the menu")
    if not desk.pointer_can_leave():
        fail("Escape does not free the pointer")
    desk.xdotool("key", "Escape")
    desk.let_pass(1.0)


def main():
    glasshouse, out = program_and_folder()
    recording = os.path.join(out, "window.rec")
    with Desk([glasshouse, "foyer", "--size", "640x360", "--record", recording], out) as desk:
        first = desk.wait_for_picture("1_opened")
        look_round(desk, first)
        walk(desk)
        resize(desk)
        pause(desk)
        desk.quit_by_menu()

    # What was played is what was recorded: it verifies, and the keys are in it.
    spent = ticks_spent(glasshouse, recording)
    print(spent)
    for verb in ("walking", "crouching"):
        if spent[verb] == 0:
            fail(f"the key for {verb} never reached the recording")

    # Without a display: a sentence and exit 2.
    blind = {k: v for k, v in os.environ.items() if k not in ("DISPLAY", "WAYLAND_DISPLAY")}
    refused = subprocess.run([glasshouse, "foyer"], env=blind, capture_output=True, text=True, timeout=TIMEOUT_S)
    if refused.returncode != 2 or len(refused.stderr.strip().splitlines()) != 1:
        fail(f"without a display: exit {refused.returncode}, '{refused.stderr}'")
    print(refused.stderr.strip())


main()
