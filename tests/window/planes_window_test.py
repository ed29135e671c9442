"""Goes through the planes that F4 shows, in the game's real window under Xvfb: each is another picture, and the last
press brings the game's own back.

    planes_window_test.py GLASSHOUSE OUT_FOLDER
"""

import os

from desk import Desk, fail, program_and_folder

PLANES = ["albedo", "normals", "depth", "motion", "direct", "indirect", "specular", "variance", "history", "rays"]
LEAST = 0.01  # of white, root mean square: two planes that differ by less are one


def press(desk, key):
    desk.hold(key, 0.8)
    desk.let_pass(1.0)


def main():
    glasshouse, out = program_and_folder()
    recording = os.path.join(out, "planes.rec")
    with Desk([glasshouse, "foyer", "--size", "640x360", "--quality", "low", "--record", recording], out) as desk:
        before = picture = desk.wait_for_picture("picture")
        for plane in PLANES:
            press(desk, "F4")
            shown = desk.screenshot(plane)
            change = desk.difference(before, shown)
            print(f"{plane}: differs from the one before by {change:.4f}")
            if change < LEAST:
                fail(f"F4 does not show {plane}")
            before = shown
        press(desk, "F4")
        desk.let_pass(1.0)
        back = desk.difference(picture, desk.screenshot("picture_again"))
        print(f"the picture again: differs from the first by {back:.4f}")
        if back > 0.1:
            fail("F4 does not come back to the picture")
        desk.quit_by_menu()


main()
