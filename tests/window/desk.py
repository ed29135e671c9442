"""A virtual X server with one program on it, and a person's hands and eyes at it, for the tests of the window.

Keys and mouse come from xdotool, pictures from ImageMagick's import; screenshots stay in the folder given, to be looked at.
"""

import glob
import os
import shutil
import subprocess
import sys
import time

TIMEOUT_S = 60


def fail(sentence):
    print(f"FAILED: {sentence}")
    sys.exit(1)


def program_and_folder():
    """The game's program and an empty folder for what is seen of it, as the command line names them."""
    glasshouse, out = sys.argv[1], sys.argv[2]
    shutil.rmtree(out, ignore_errors=True)
    os.makedirs(out)
    return glasshouse, out


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

    def share_of_processors(self):
        """(seconds that the game's threads ran, seconds that they stood ready but others ran) so far; zeros if nobody says."""
        ran = waited = 0
        for path in glob.glob(f"/proc/{self.game.pid}/task/*/schedstat"):
            try:
                with open(path) as schedstat:
                    ran_ns, waited_ns = schedstat.read().split()[:2]
            except OSError:  # a thread that has just ended
                continue
            ran, waited = ran + int(ran_ns) * 1e-9, waited + int(waited_ns) * 1e-9
        return ran, waited

    def let_pass(self, seconds):
        """So much time as the game has for itself: time goes slower where others take more than half of what it wants."""
        ran, waited = self.share_of_processors()
        while seconds > 0:
            time.sleep(min(seconds, 0.25))
            ran_by_now, waited_by_now = self.share_of_processors()
            wanted = (ran_by_now - ran) + (waited_by_now - waited)
            share = (ran_by_now - ran) / wanted if wanted > 0 else 1.0
            seconds -= 0.25 * min(1.0, max(2.0 * share, 0.1))
            ran, waited = ran_by_now, waited_by_now

    def hold(self, key, seconds):
        """A press that lasts longer than one slow frame."""
        self.xdotool("keydown", key)
        self.let_pass(seconds)
        self.xdotool("keyup", key)

    def pointer_can_leave(self):
        """Whether the pointer is the person's: a game that is played keeps it inside its window."""
        self.xdotool("mousemove", "1100", "700")
        self.let_pass(1.0)
        place = dict(line.split("=") for line in self.xdotool("getmouselocation", "--shell").stdout.split())
        return (int(place["X"]), int(place["Y"])) == (1100, 700)

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

    def measure(self, path, *convert_words):
        """The numbers that ImageMagick's convert prints for a picture."""
        done = subprocess.run(["convert", path, *convert_words, "info:"], check=True, capture_output=True, text=True)
        return [float(word) for word in done.stdout.split()]

    def figures(self, path, crop=None):
        """(mean, standard deviation) of the picture's luminance, 0..1."""
        cut = ["-crop", crop, "+repage"] if crop else []
        return self.measure(path, *cut, "-colorspace", "Gray", "-format", "%[fx:mean] %[fx:standard_deviation]")

    def difference(self, first, second):
        """Root mean square difference of two pictures, 0..1."""
        done = subprocess.run(["compare", "-metric", "RMSE", first, second, "null:"], env=self.env, capture_output=True, text=True)
        return float(done.stderr.split("(")[1].split(")")[0])

    def wait_until(self, name, look, is_wanted):
        """Takes screenshots until `is_wanted(look(path))`; slow machines draw late. Returns (path, what was seen)."""
        deadline = time.monotonic() + TIMEOUT_S
        while True:
            path = self.screenshot(name)
            seen = look(path)
            if is_wanted(seen):
                return path, seen
            if time.monotonic() > deadline:
                fail(f"{name}: {seen} after a minute")
            time.sleep(0.3)

    def wait_for_picture(self, name):
        """Until there is a window and something is drawn that is neither black nor flat."""
        if self.window is None:
            self.wait_for_window()
        path, (mean, deviation) = self.wait_until(name, self.figures, lambda seen: min(seen) > 0.01)
        print(f"{name}: mean {mean:.4f}, deviation {deviation:.4f}")
        return path

    def press(self, *keys):
        """One after the other, each long enough for a slow frame to see it and too short to repeat: after .58 s the menu
        takes a key that is down for a second press. One process holds it, so that a busy machine makes it no longer."""
        for key in keys:
            self.xdotool("keydown", key, "sleep", "0.35", "keyup", key)
            self.let_pass(0.4)

    def quit_by_menu(self):
        """Escape, then down to Quit: Resume, Settings, Controls, Restart, Quit."""
        self.xdotool("key", "Escape")
        self.let_pass(1.0)
        self.press("Down", "Down", "Down", "Down", "space")
        try:
            code = self.game.wait(TIMEOUT_S)
        except subprocess.TimeoutExpired:
            self.screenshot("still_open")
            fail("the menu's Quit does not end the game")
        if code != 0:
            fail(f"the game ended with {code}: {self.game.stderr.read()}")

    def __enter__(self):
        return self

    def __exit__(self, *what_went_wrong):
        if self.game.poll() is None:
            self.game.kill()
        self.server.terminate()
        self.server.wait()


def ticks_spent(glasshouse, recording):
    """What `inspect` says the player did in a recording, which has to verify first: {'walking': 120, ...}."""
    verified = subprocess.run([glasshouse, "replay", recording, "--verify"], capture_output=True, text=True)
    if verified.returncode != 0 or not verified.stdout.splitlines()[-1].startswith("verified "):
        fail(f"the recording does not verify: {verified.stdout}{verified.stderr}")
    print(verified.stdout.splitlines()[-1])
    told = subprocess.run([glasshouse, "inspect", recording], capture_output=True, text=True).stdout
    spent = told.split("ticks spent\n")[1].splitlines()
    return {" ".join(line.split()[:-1]): int(line.split()[-1]) for line in spent}
