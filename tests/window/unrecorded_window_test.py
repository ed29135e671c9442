"""A run that can not be recorded is played all the same, and says so; one whose recording was asked for is not begun.

    unrecorded_window_test.py GLASSHOUSE OUT_FOLDER
"""

import os
import subprocess

from desk import TIMEOUT_S, Desk, fail, program_and_folder


def plays_without_a_folder(glasshouse, out):
    """Where recordings go there is a file, as somebody has put it there or a disk that is not mounted leaves it."""
    with Desk([glasshouse, "foyer", "--size", "640x360"], out) as desk:
        first = desk.wait_for_picture("1_opened")
        desk.screenshot("1_says_so")
        desk.xdotool("mousemove_relative", "--", "120", "10")
        desk.wait_until("2_looked", lambda path: desk.difference(first, path), lambda moved: moved > 0.02)
        desk.xdotool("key", "Escape")
        desk.let_pass(1.0)
        desk.screenshot("3_menu")
        desk.xdotool("key", "Escape")
        desk.let_pass(1.0)
        desk.quit_by_menu()
        return desk.game.stderr.read()


def refuses_what_was_asked_for(glasshouse, out):
    with Desk([glasshouse, "foyer", "--size", "320x180", "--record", os.path.join(out, "home", "data", "run.rec")], out) as desk:
        try:
            code = desk.game.wait(TIMEOUT_S)
        except subprocess.TimeoutExpired:
            fail("a recording that was asked for and can not be written: the game is played")
        return code, desk.game.stderr.read()


def main():
    glasshouse, out = program_and_folder()
    os.makedirs(os.path.join(out, "home"))
    with open(os.path.join(out, "home", "data"), "w") as in_the_way:
        in_the_way.write("not a folder")

    said = [line for line in plays_without_a_folder(glasshouse, out).splitlines() if "recorded" in line]
    print(said)
    if len(said) != 1 or "not recorded" not in said[0] or ".rec" not in said[0]:
        fail("who is not recorded is not told so in one sentence")

    code, said = refuses_what_was_asked_for(glasshouse, out)
    print(code, said)
    if code != 2 or said.count("run.rec") != 1:
        fail("a recording that was asked for and can not be written is to be exit 2 and one sentence")


main()
