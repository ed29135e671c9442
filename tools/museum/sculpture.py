"""The carved figures: two busts and the standing Lady of Light. They face -y; metres."""
import math

import numpy as np

import meshkit
import statues
from carve import Stone
from meshkit import joined, lathe


def _face(s, at, k=1.0, beard=False):
    """Skull, jaw, brow, nose, eyes, lips and ears about the head's middle `at`; k scales an adult's head."""
    def p(x, y, z):
        return (at[0] + x * k, at[1] + y * k, at[2] + z * k)

    def r(*radii):
        return tuple(v * k for v in radii)

    s.melt(s.egg(p(0, 0.012, 0.03), r(0.078, 0.098, 0.100)), 0.02 * k)
    s.melt(s.egg(p(0, -0.022, -0.055), r(0.058, 0.070, 0.078)), 0.03 * k)
    s.melt(s.egg(p(0, -0.068, -0.112), r(0.026, 0.022, 0.020)), 0.025 * k)      # chin
    s.melt(s.limb(p(-0.040, -0.074, 0.022), p(0.040, -0.074, 0.022), 0.014 * k), 0.016 * k)  # brow
    for side in (-1, 1):
        s.cut(s.ball(p(side * 0.034, -0.100, -0.002), 0.019 * k), 0.014 * k)     # the orbit
        s.melt(s.ball(p(side * 0.034, -0.078, -0.002), 0.0145 * k), 0.004 * k)   # the eye
        s.melt(s.limb(p(side * 0.020, -0.090, 0.008), p(side * 0.048, -0.084, 0.006), 0.0045 * k), 0.004 * k)  # lid
        s.melt(s.egg(p(side * 0.048, -0.055, -0.042), r(0.022, 0.024, 0.020)), 0.03 * k)  # cheek
        s.melt(s.egg(p(side * 0.079, 0.014, -0.012), r(0.010, 0.022, 0.032)), 0.006 * k)  # ear
    s.melt(s.limb(p(0, -0.092, 0.014), p(0, -0.118, -0.038), 0.008 * k, 0.013 * k), 0.010 * k)  # nose
    for side in (-1, 1):
        s.melt(s.ball(p(side * 0.012, -0.104, -0.042), 0.0085 * k), 0.006 * k)
    s.melt(s.egg(p(0, -0.088, -0.072), r(0.025, 0.014, 0.0075)), 0.008 * k)      # lips
    s.melt(s.egg(p(0, -0.084, -0.087), r(0.021, 0.014, 0.0085)), 0.008 * k)
    if beard:
        for i in range(20):
            a, row = -1.25 + 2.5 * (i % 8) / 7, i // 8
            s.melt(s.ball(p(0.062 * math.sin(a) * (1 - 0.18 * row), -0.015 - 0.068 * math.cos(a), -0.104 - 0.032 * row - 0.02 * math.cos(a)), 0.020 * k), 0.003 * k)


def _curls(s, at, k, count, radius, low, high, behind):
    """Locks of hair as a spiral of small balls over the skull, none on the face."""
    golden = math.pi * (3 - math.sqrt(5))
    for i in range(count):
        h = low + (high - low) * (i + 0.5) / count
        ring = math.sqrt(max(0.0, 1 - h * h))
        a = golden * i
        x, y, z = ring * math.cos(a), ring * math.sin(a), h
        if y < behind and z < 0.62:
            continue
        s.melt(s.ball((at[0] + 0.084 * k * x, at[1] + 0.012 + 0.106 * k * y, at[2] + (0.035 + 0.108 * z) * k), radius * k), 0.003)


def _shoulders(s, drape):
    s.melt(s.limb((0, 0.02, 0.46), (0, 0.005, 0.30), 0.058, 0.066), 0.03)
    s.melt(s.limb((-0.15, 0.025, 0.285), (0.15, 0.025, 0.285), 0.072), 0.07)
    s.melt(s.egg((0, -0.015, 0.235), (0.165, 0.115, 0.12)), 0.05)
    s.cut(s.z - 0.17, 0.02)
    if drape:
        t = s.x * 0.9 + (s.z - 0.28) * 1.5
        fold = 0.010 * np.sin(t * 62 + 9 * s.y)
        cloth = s.egg((0.01, 0.0, 0.245), (0.225, 0.135, 0.115)) + fold
        s.melt(np.maximum(cloth, (s.x * -0.55 + s.z - 0.335)), 0.010)


def bust(kind):
    """'sage' with a beard and a cloak, 'muse' with her hair tied; on a turned socle, 0.75 m high."""
    s = Stone((-0.28, -0.20, 0.12), (0.28, 0.22, 0.80), 0.0115)
    head = (0.0, 0.0, 0.60)
    _shoulders(s, kind == "sage")
    _face(s, head, 1.0, kind == "sage")
    if kind == "sage":
        _curls(s, head, 1.0, 84, 0.024, -0.5, 1.0, -0.25)
    else:
        t = np.arctan2(s.x, s.z - 0.60)
        waves = 0.004 * np.sin(26 * t + 30 * s.y)
        hair = np.maximum(s.egg((0, 0.028, 0.645), (0.094, 0.112, 0.104)) + waves, -(s.y + 0.050 + (s.z - 0.66) * 0.5))
        s.melt(hair, 0.008)
        s.melt(s.egg((0, 0.135, 0.64), (0.048, 0.046, 0.048)) + 0.004 * np.sin(s.z * 210), 0.012)
        s.melt(s.egg((0, -0.045, 0.245), (0.13, 0.10, 0.085)), 0.05)
    carved = s.hewn("bust_" + kind, "statuary", 1700 if kind == "sage" else 1300)
    socle = lathe([(0.0, 0.0), (0.125, 0.0), (0.125, 0.025), (0.11, 0.035), (0.07, 0.055), (0.058, 0.085), (0.062, 0.115), (0.095, 0.15),
                   (0.10, 0.17), (0.0, 0.18)], "marble_black", 14)
    return joined([carved, socle])


def lady(triangles=2650):
    """The Lady of Light, 2 m tall: a robed figure that lifts a lens over her head. Returns her stone and the glass."""
    s = Stone((-0.48, -0.42, -0.02), (0.56, 0.42, 2.42), 0.018)
    angle, r = np.arctan2(s.y, s.x), np.hypot(s.x - 0.01 * np.sin(3 * s.z), s.y)
    down = np.clip((1.08 - s.z) / 1.08, 0, 1)
    girth = 0.150 + 0.13 * down ** 1.3 + 0.012 * np.sin(2.2 * s.z)
    fold = np.sin(11 * angle + 2.5 * np.sin(2 * s.z) + 1.3 * np.sin(3 * angle)) * (0.004 + 0.026 * down)
    robe = np.maximum((r - girth - fold) * 0.8, np.maximum(s.z - 1.10, -s.z))
    s.melt(robe)
    s.melt(s.limb((0.10, -0.10, 0.02), (0.07, -0.13, 0.55), 0.12, 0.10) + fold * 0.4, 0.08)  # the knee that steps forward
    s.melt(s.egg((0, 0.0, 1.12), (0.165, 0.125, 0.16)) + 0.006 * np.sin(60 * (s.z + 0.4 * s.x)), 0.06)
    s.melt(s.egg((0, -0.01, 1.36), (0.158, 0.118, 0.16)) + 0.006 * np.sin(55 * (s.x + 0.5 * s.z)), 0.06)
    s.melt(s.limb((-0.155, 0.01, 1.50), (0.155, 0.01, 1.51), 0.062), 0.05)
    s.melt(s.limb((0, 0.01, 1.52), (0.0, 0.0, 1.64), 0.052, 0.048), 0.03)
    head = (0.0, -0.01, 1.755)
    _face(s, head, 0.92)
    hair = np.maximum(s.egg((0, 0.022, 1.80), (0.090, 0.106, 0.096)) + 0.004 * np.sin(26 * np.arctan2(s.x, s.z - 1.75)), -(s.y + 0.055 + (s.z - 1.81) * 0.5))
    s.melt(hair, 0.008)
    s.melt(s.egg((0, 0.125, 1.80), (0.045, 0.042, 0.045)), 0.012)
    s.chain([(0.17, 0.01, 1.51), (0.315, -0.03, 1.66), (0.30, -0.12, 1.92), (0.285, -0.13, 2.0)], [0.058, 0.046, 0.034, 0.036], 0.03)
    s.melt(s.egg((0.17, 0.01, 1.50), (0.09, 0.085, 0.10)) + 0.006 * np.sin(70 * s.x), 0.04)     # the sleeve
    s.chain([(-0.17, 0.01, 1.50), (-0.245, 0.0, 1.26), (-0.15, -0.15, 1.10), (-0.11, -0.17, 1.08)], [0.058, 0.046, 0.034, 0.032], 0.03)
    fall = s.limb((-0.19, -0.13, 1.10), (-0.24, -0.10, 0.45), 0.055, 0.085) + 0.016 * np.sin(10 * np.arctan2(s.y + 0.12, s.x + 0.21) + 3 * s.z)
    s.melt(fall, 0.03)  # the cloth over her arm
    stone = s.hewn("lady", "statuary", triangles)
    centre = (0.285, -0.135, 2.20)
    glass = statues.biconvex(0.155, 0.06, 0.012, "lens_glass", 28, 4).turned(90, "x").moved(*centre)
    ring = joined([lathe([(0.156, -0.014), (0.176, -0.014), (0.180, 0.0), (0.176, 0.014), (0.156, 0.014), (0.156, -0.014)], "gilt", 28).turned(90, "x"),
                   meshkit.tube([(0, 0, -0.26), (0, 0, -0.175)], 0.014, "gilt", 10)]).moved(*centre)
    base = joined([lathe([(0.0, -0.10), (0.36, -0.10), (0.36, -0.03), (0.33, 0.0), (0.30, 0.03), (0.0, 0.03)], "marble_black", 28)])
    return joined([stone, ring, base]).moved(0, 0, 0.10), glass.moved(0, 0, 0.10)
