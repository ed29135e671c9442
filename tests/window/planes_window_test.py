"""Goes through the planes that F4 shows, in the game's real window under Xvfb: each is another picture, and the last
press brings the game's own back.

    planes_window_test.py GLASSHOUSE OUT_FOLDER
"""

import os
import shutil
import subprocess
import sys
import time

from desk import Desk, fail

PLANES = ["albedo", "normals", "depth", "motion", "direct", "indirect", "specular", "variance", "history", "rays"]
LEAST = 0.01  # of white, root mean square: two planes that differ by less are one


def difference(desk, first, second):
    """Root mean square difference of two pictures, 0..1."""
    done = subprocess.run(["compare", "-metric", "RMSE", first, second, "null:"], env=desk.env, capture_output=True, text=True)
    return float(done.stderr.split("(")[1].split(")")[0])


def press(desk, key):
    desk.hold(key, 0.8)
    time.sleep(1.0)


def main():
    glasshouse, out = sys.argv[1], sys.argv[2]
    shutil.rmtree(out, ignore_errors=True)
    os.makedirs(out)
    recording = os.path.join(out, "planes.rec")
    desk = Desk([glasshouse, "foyer", "--size", "640x360", "--quality", "low", "--record", recording], out)
    try:
        desk.wait_for_window()
        before = picture = desk.wait_for_picture("picture")
        for plane in PLANES:
            press(desk, "F4")
            shown = desk.screenshot(plane)
            change = difference(desk, before, shown)
            print(f"{plane}: differs from the one before by {change:.4f}")
            if change < LEAST:
                fail(f"F4 does not show {plane}")
            before = shown
        press(desk, "F4")
        time.sleep(1.0)
        back = difference(desk, picture, desk.screenshot("picture_again"))
        print(f"the picture again: differs from the first by {back:.4f}")
        if back > 0.1:
            fail("F4 does not come back to the picture")
        desk.quit_by_menu()
    finally:
        desk.close()


main()
