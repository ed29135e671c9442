"""The program as scripts and people meet it.

    command_line_test.py GLASSHOUSE SOURCE_FOLDER OUT_FOLDER ALTER_RECORDING
"""

import hashlib
import os
import random
import shutil
import struct
import subprocess
import sys
import wave
import zlib

GLASSHOUSE, SOURCE, OUT, ALTER_RECORDING = sys.argv[1:5]
ASSETS = os.path.join(SOURCE, "assets")
failures = 0


def check(claim, is_true, detail=""):
    global failures
    if not is_true:
        failures += 1
        print(f"FAILED: {claim}: {detail}")


def run(*words, timeout=120):
    blind = {k: v for k, v in os.environ.items() if k not in ("DISPLAY", "WAYLAND_DISPLAY")}
    return subprocess.run([GLASSHOUSE, *words], capture_output=True, text=True, env=blind, timeout=timeout, cwd=OUT)


def refuses(*words, naming=""):
    done = run(*words)
    lines = done.stderr.strip().splitlines()
    claim = "glasshouse " + " ".join(words)
    check(claim + " exits with 2", done.returncode == 2, f"{done.returncode} {done.stderr[-300:]}")
    check(claim + " says one sentence", len(lines) == 1, done.stderr[-400:])
    check(claim + " names " + naming, naming in done.stderr, done.stderr[-300:])


def digest(path):
    with open(path, "rb") as file:
        return hashlib.sha256(file.read()).hexdigest()


def png_pixels(path):
    """Width, height and the decoded bytes of an 8-bit PNG, filters undone by nobody: enough to see that it is not flat."""
    with open(path, "rb") as file:
        data = file.read()
    width, height = struct.unpack(">II", data[16:24])
    packed, at = b"", 8
    while at < len(data):
        size, kind = struct.unpack(">I4s", data[at:at + 8])
        if kind == b"IDAT":
            packed += data[at + 8:at + 8 + size]
        at += size + 12
    return width, height, zlib.decompress(packed)


def helps():
    for command in ([], ["replay"], ["render"], ["inspect"]):
        done = run(*command, "--help")
        check(f"{command} --help exits with 0", done.returncode == 0, done.stderr)
        check(f"{command} --help explains", "--help" in done.stdout or "OPTIONS" in done.stdout.upper(), done.stdout)


def bad_usage():
    refuses("--no-such-option", naming="--no-such-option")
    refuses("no_such_level", naming="no_such_level")
    refuses("--size", "640", naming="640")
    refuses("--size", "0x0", naming="0x0")
    refuses("render", naming="SCENE")
    refuses("render", "foyer", "-o", "picture.txt", naming="picture.txt")
    refuses("render", "missing.glb", "-o", "picture.png", naming="missing.glb")
    refuses("render", "foyer", "-o", "picture.png", "--camera", "nowhere", naming="nowhere")
    refuses("render", "foyer", "-o", "picture.png", "--camera", "1,2,3,0,0,180", naming="180")
    refuses("render", "foyer", "-o", "picture.png", "--isa", "mmx", naming="mmx")
    refuses("render", "foyer", "-o", "picture.png", "--renderer", "magic", naming="magic")
    refuses("render", "foyer", "-o", "picture.png", "--threads", "-1", naming="--threads")
    refuses("render", "foyer", "-o", "/proc/no/picture.png", "--size", "8x8", "--spp", "1", naming="/proc/no/picture.png")
    for option in ("--clamp", "--roughen", "--aperture", "--focus"):
        for number in ("nan", "-1", "inf", "much"):
            refuses("render", "foyer", "-o", "picture.png", option, number, naming=f"{option}: '{number}'")
    refuses("replay", "missing.rec", "--shutter", "nan", naming="--shutter: 'nan'")
    refuses("replay", "missing.rec", naming="missing.rec")
    refuses("inspect", "missing.glb", naming="missing.glb")
    refuses("inspect", "missing.rec", naming="missing.rec")


def pictures():
    small = ["--size", "96x54", "--spp", "1", "--camera", "cam_foyer"]
    for name, extra in (("one", ["--threads", "1"]), ("two", ["--threads", "2"]), ("eight", ["--threads", "8", "--isa", "scalar"])):
        done = run("render", "foyer", "-o", name + ".png", *small, *extra)
        check(f"render {extra} exits with 0", done.returncode == 0, done.stderr)
    check("one picture for any threads and any instructions",
          len({digest(os.path.join(OUT, n + ".png")) for n in ("one", "two", "eight")}) == 1)
    width, height, pixels = png_pixels(os.path.join(OUT, "one.png"))
    check("the picture has the size that was asked for", (width, height) == (96, 54), f"{width}x{height}")
    check("the picture shows something", len(set(pixels)) > 50, f"{len(set(pixels))} different bytes")
    done = run("render", "foyer", "-o", "deep/er/linear.exr", *small)
    check("render makes folders and writes EXR", done.returncode == 0 and os.path.getsize(os.path.join(OUT, "deep/er/linear.exr")) > 1000, done.stderr)
    check("no half-written file is left", not [f for f in os.listdir(OUT) if "tmp" in f or "part" in f], str(os.listdir(OUT)))


def recordings():
    winning = os.path.join(ASSETS, "replays", "foyer_win.rec")
    for name, ending in (("foyer_win.rec", " s), won, 1 of 1 lenses"), ("foyer_caught.rec", "caught 1 time,")):
        done = run("replay", os.path.join(ASSETS, "replays", name))
        check(f"{name} tells its end", done.returncode == 0 and ending in done.stdout, done.stdout + done.stderr)
    done = run("inspect", winning)
    check("inspect tells of a recording", done.returncode == 0 and "ticks" in done.stdout, done.stderr)

    with open(winning, "rb") as file:
        whole = file.read()
    short = os.path.join(OUT, "short.rec")
    with open(short, "wb") as file:
        file.write(whole[:int(len(whole) * 0.3)])
    done = run("replay", short)
    check("a truncated recording plays to its last whole second, says so and exits with 2",
          done.returncode == 2 and "short.rec: is cut short" in done.stderr, done.stdout + done.stderr)
    done = run("replay", short, "--verify")
    check("but it is not verified", done.returncode == 2 and "verified" not in done.stdout, done.stdout + done.stderr)
    check("and how much of it is true is said", "ticks that are whole are true" in done.stderr, done.stderr)
    for name, data in (("empty", b""), ("head", whole[:20]), ("header", whole[:1000]), ("other", b"RIFF" + whole[4:]), ("zeros", bytes(4096))):
        path = os.path.join(OUT, name + ".rec")
        with open(path, "wb") as file:
            file.write(data)
        refuses("replay", path, naming=name + ".rec")

    done = run("replay", short, "--frames", "frames", "--every", "120", "--size", "64x36", "--audio", "sound.wav")
    check("replay writes frames and sound of what is whole", done.returncode == 2, done.stderr)
    frames = os.listdir(os.path.join(OUT, "frames"))
    check("there is a frame for every 120 ticks", len(frames) >= 2 and all(f.endswith(".png") for f in frames), str(frames))
    with wave.open(os.path.join(OUT, "sound.wav")) as sound:
        ticks = sound.getnframes() / 800
        check("sound is 48 kHz stereo, 800 frames a tick", sound.getframerate() == 48000 and sound.getnchannels() == 2 and ticks == int(ticks) and ticks > 60,
              f"{sound.getframerate()} {sound.getnchannels()} {ticks}")
        samples = sound.readframes(sound.getnframes())
    check("the sound is not silence", len(set(samples[100000:200000])) > 20)
    first = digest(os.path.join(OUT, "sound.wav"))
    run("replay", short, "--audio", "again.wav")
    check("the same sound again", digest(os.path.join(OUT, "again.wav")) == first)


def untrue_recordings():
    caught = os.path.join(ASSETS, "replays", "foyer_caught.rec")
    turned = os.path.join(OUT, "turned.rec")
    subprocess.run([ALTER_RECORDING, caught, turned, "yaw", "90"], check=True)
    done = run("replay", turned, "--verify")
    last = done.stderr.strip().splitlines()[-1]
    check("a recording that diverges exits with 3", done.returncode == 3, f"{done.returncode} {done.stderr[-300:]}")
    check("file, tick and room are named where it parts", all(word in last for word in ("turned.rec", "tick 90 ", "player")), last)
    check("and nothing is said to be verified", "verified" not in done.stdout, done.stdout)

    newer = os.path.join(OUT, "newer.rec")
    subprocess.run([ALTER_RECORDING, caught, newer, "version"], check=True)
    refuses("replay", newer, "--verify", naming="newer.rec")


def broken_levels():
    with open(os.path.join(ASSETS, "levels", "foyer.glb"), "rb") as file:
        whole = file.read()
    path = os.path.join(OUT, "no_way_out.glb")
    with open(path, "wb") as file:
        file.write(whole.replace(b'"kind":"exit"', b'"kinD":"exit"'))
    done = run("inspect", path)
    check("a level with an error is shown", "ERROR" in done.stdout and "guard" in done.stdout, done.stdout)
    check("and refused, in a sentence", done.returncode == 2 and "no_way_out.glb: 1 error" in done.stderr, f"{done.returncode} {done.stderr}")
    os.remove(path)
    rng = random.Random(1)
    for i in range(12):
        data = bytearray(whole)
        if i % 3 == 0:
            data = data[:rng.randrange(len(data))]
        else:  # the JSON comes first: there every bit means something
            json_end = 20 + struct.unpack("<I", whole[12:16])[0]
            for _ in range(3):
                data[rng.randrange(json_end)] ^= 1 << rng.randrange(8)
        path = os.path.join(OUT, f"broken_{i}.glb")
        with open(path, "wb") as file:
            file.write(data)
        done = run("inspect", path)
        check(f"broken_{i}.glb: read or refused", done.returncode in (0, 2), f"{done.returncode} {done.stderr[-300:]}")
        if done.returncode == 2:
            check(f"broken_{i}.glb is named in one sentence", len(done.stderr.strip().splitlines()) == 1 and f"broken_{i}.glb" in done.stderr, done.stderr[-300:])
        os.remove(path)


def main():
    shutil.rmtree(OUT, ignore_errors=True)
    os.makedirs(OUT)
    helps()
    bad_usage()
    done = run("inspect", "foyer")
    check("inspect tells of a level", done.returncode == 0 and "triangles" in done.stdout and "guard" in done.stdout, done.stderr + done.stdout)
    pictures()
    recordings()
    untrue_recordings()
    broken_levels()
    print("all claims hold" if failures == 0 else f"{failures} claims failed")
    sys.exit(1 if failures else 0)


main()
