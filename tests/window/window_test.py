"""Plays the game through its real window under Xvfb: what a person's first minute needs to work.

    window_test.py GLASSHOUSE OUT_FOLDER

Keys and mouse come from xdotool, pictures from ImageMagick's import; screenshots stay in OUT_FOLDER to be looked at.
"""

import os
import shutil
import subprocess
import sys
import time

TIMEOUT_S = 60


def fail(sentence):
    print(f"FAILED: {sentence}")
    sys.exit(1)


def start_x_server():
    """An X server on a display of its own choosing; returns (process, ':N')."""
    read_end, write_end = os.pipe()
    server = subprocess.Popen(
        ["Xvfb", "-displayfd", str(write_end), "-screen", "0", "1280x800x24", "-nolisten", "tcp"],
        pass_fds=[write_end], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    os.close(write_end)
    with os.fdopen(read_end) as pipe:
        number = pipe.readline().strip()
    if not number:
        fail("Xvfb did not start")
    return server, ":" + number


class Desk:
    """One display with one program on it."""

    def __init__(self, program, out):
        self.out = out
        self.server, display = start_x_server()
        home = os.path.join(out, "home")
        self.env = dict(os.environ, DISPLAY=display, HOME=home, XDG_CONFIG_HOME=home + "/config",
                        XDG_DATA_HOME=home + "/data", LIBGL_ALWAYS_SOFTWARE="1")
        self.env.pop("WAYLAND_DISPLAY", None)
        self.game = subprocess.Popen(program, env=self.env, stderr=subprocess.PIPE, text=True)
        self.window = None

    def xdotool(self, *words):
        return subprocess.run(["xdotool", *words], env=self.env, capture_output=True, text=True)

    def hold(self, key, seconds):
        """A press that lasts longer than one slow frame."""
        self.xdotool("keydown", key)
        time.sleep(seconds)
        self.xdotool("keyup", key)

    def wait_for_window(self):
        deadline = time.monotonic() + TIMEOUT_S
        while time.monotonic() < deadline:
            if self.game.poll() is not None:
                fail(f"the game ended with {self.game.returncode}: {self.game.stderr.read()}")
            found = self.xdotool("search", "--name", "^Glasshouse").stdout.split()
            if found:
                self.window = found[0]
                self.xdotool("windowfocus", self.window)
                return
            time.sleep(0.2)
        fail("no window within a minute")

    def screenshot(self, name):
        path = os.path.join(self.out, name + ".png")
        subprocess.run(["import", "-window", "root", path], env=self.env, check=True)
        return path

    def figures(self, path, crop=None):
        """(mean, standard deviation) of the picture's luminance, 0..1."""
        command = ["convert", path] + (["-crop", crop, "+repage"] if crop else [])
        command += ["-colorspace", "Gray", "-format", "%[fx:mean] %[fx:standard_deviation]", "info:"]
        words = subprocess.run(command, check=True, capture_output=True, text=True).stdout.split()
        return float(words[0]), float(words[1])

    def wait_for_picture(self, name, wanted):
        """Takes screenshots until `wanted(mean, deviation)`; slow machines draw their first frame late."""
        deadline = time.monotonic() + TIMEOUT_S
        while time.monotonic() < deadline:
            path = self.screenshot(name)
            mean, deviation = self.figures(path)
            if wanted(mean, deviation):
                return path, mean, deviation
            time.sleep(0.3)
        fail(f"{name}: mean {mean:.4f}, deviation {deviation:.4f} after a minute")

    def close(self):
        if self.game.poll() is None:
            self.game.kill()
        self.server.terminate()
        self.server.wait()


def difference(desk, first, second):
    """Root mean square difference of two pictures, 0..1."""
    done = subprocess.run(["compare", "-metric", "RMSE", first, second, "null:"], env=desk.env, capture_output=True, text=True)
    return float(done.stderr.split("(")[1].split(")")[0])


def play_through(glasshouse, out):
    recording = os.path.join(out, "window.rec")
    desk = Desk([glasshouse, "foyer", "--size", "640x360", "--record", recording], out)
    try:
        desk.wait_for_window()
        first, mean, deviation = desk.wait_for_picture("1_opened", lambda m, d: m > 0.01 and d > 0.01)
        print(f"opened and drawn: mean {mean:.4f}, deviation {deviation:.4f}")

        desk.xdotool("keydown", "w")
        desk.xdotool("mousemove_relative", "--", "120", "10")
        time.sleep(2.0)
        desk.xdotool("keyup", "w")
        walked = desk.screenshot("2_walked")
        moved = difference(desk, first, walked)
        print(f"walked: the picture changed by {moved:.4f}")
        if moved < 0.005:
            fail("holding W and moving the mouse changed nothing to be seen")

        desk.xdotool("key", "F3")
        time.sleep(1.0)
        desk.screenshot("3_profiler")
        desk.xdotool("windowsize", "--sync", desk.window, "960", "600")
        time.sleep(1.5)
        resized = desk.screenshot("4_resized")
        mean, deviation = desk.figures(resized, "960x600+0+0")
        print(f"resized: mean {mean:.4f}, deviation {deviation:.4f}")
        if deviation < 0.01:
            fail("nothing is drawn after resizing")
        desk.xdotool("windowsize", "--sync", desk.window, "640", "360")
        time.sleep(1.0)

        before_menu = desk.screenshot("5_before_menu")
        desk.xdotool("key", "Escape")
        time.sleep(1.5)
        menu = desk.screenshot("6_menu")
        change = difference(desk, before_menu, menu)
        print(f"paused: the picture changed by {change:.4f}")
        if change < 0.01:
            fail("Escape shows no menu")
        still = desk.screenshot("7_menu_again")
        if difference(desk, menu, still) > change / 4:
            fail("the world goes on behind the menu")
        desk.xdotool("key", "Escape")
        time.sleep(1.0)
        desk.xdotool("key", "Escape")
        time.sleep(1.0)

        for key in ("Down", "Down", "space"):  # Resume, Restart, Quit
            desk.hold(key, 0.4)
            time.sleep(0.4)
        try:
            code = desk.game.wait(TIMEOUT_S)
        except subprocess.TimeoutExpired:
            desk.screenshot("8_still_open")
            fail("the menu's Quit does not end the game")
        if code != 0:
            fail(f"the game ended with {code}: {desk.game.stderr.read()}")
    finally:
        desk.close()
    return recording


def main():
    glasshouse, out = sys.argv[1], sys.argv[2]
    shutil.rmtree(out, ignore_errors=True)
    os.makedirs(out)
    recording = play_through(glasshouse, out)

    # What was played is what was recorded: it verifies, and the W key is in it.
    verified = subprocess.run([glasshouse, "replay", recording, "--verify"], capture_output=True, text=True)
    if verified.returncode != 0 or not verified.stdout.splitlines()[-1].startswith("verified "):
        fail(f"the recording does not verify: {verified.stdout}{verified.stderr}")
    print(verified.stdout.splitlines()[-1])
    told = subprocess.run([glasshouse, "inspect", recording], capture_output=True, text=True).stdout
    walked = [line for line in told.splitlines() if "walking" in line]
    if not walked or walked[0].split()[-1] == "0":
        fail(f"the W key never reached the recording:\n{told}")
    print(walked[0].strip())

    # Without a display: a sentence and exit 2.
    blind = {k: v for k, v in os.environ.items() if k not in ("DISPLAY", "WAYLAND_DISPLAY")}
    refused = subprocess.run([glasshouse, "foyer"], env=blind, capture_output=True, text=True, timeout=TIMEOUT_S)
    if refused.returncode != 2 or len(refused.stderr.strip().splitlines()) != 1:
        fail(f"without a display: exit {refused.returncode}, '{refused.stderr}'")
    print(refused.stderr.strip())


main()
