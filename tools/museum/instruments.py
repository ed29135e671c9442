"""Landmarks of the back rooms and cloth: a telescope, a grinding wheel, a globe, a fireplace, curtains, a torchere."""
import math

import meshkit
import statues
from meshkit import Shape, ball, block, joined, lathe, slab, tube


def telescope():
    """A brass refractor on a wooden tripod, pointing up at 35 degrees towards -y; its eyepiece is 1.3 m high."""
    barrel = lathe([(0.0, -0.75), (0.03, -0.75), (0.03, -0.62), (0.045, -0.60), (0.045, -0.40), (0.062, -0.38), (0.062, 0.10), (0.085, 0.14),
                    (0.085, 0.80), (0.098, 0.82), (0.098, 0.95), (0.088, 0.95), (0.082, 0.84), (0.0, 0.84)], "brass", 20)
    bands = joined([lathe([(0.0862, z), (0.094, z + 0.01), (0.094, z + 0.03), (0.0862, z + 0.04)], "gilt", 20) for z in (0.16, 0.45, 0.74)])
    tube_up = joined([barrel, bands]).turned(55, "x").moved(0, 0, 1.55)
    head = joined([lathe([(0.0, 1.22), (0.07, 1.22), (0.07, 1.30), (0.035, 1.34), (0.03, 1.48), (0.0, 1.5)], "brass", 20),
                   tube([(-0.10, 0, 1.55), (0.10, 0, 1.55)], 0.03, "brass", 12)])
    legs = [tube([(0.05 * math.cos(a), 0.05 * math.sin(a), 1.26), (0.52 * math.cos(a), 0.52 * math.sin(a), 0.0)], [0.032, 0.02], "oak_dark", 8)
            for a in (math.pi / 2, math.pi * 7 / 6, math.pi * 11 / 6)]
    brace = [tube([(0.26 * math.cos(a), 0.26 * math.sin(a), 0.63), (0, 0, 0.58)], 0.010, "brass", 6) for a in (math.pi / 2, math.pi * 7 / 6, math.pi * 11 / 6)]
    return joined([tube_up, head] + legs + brace)


def grinder():
    """A treadle-driven wheel for grinding lenses: flywheel, frame, and the little bowl on its spindle."""
    rim = lathe([(0.50, -0.035), (0.57, -0.045), (0.57, 0.045), (0.50, 0.035), (0.50, -0.035)], "iron", 32)
    spokes = [tube([(0, 0, 0), (0.51 * math.cos(a), 0.51 * math.sin(a), 0)], [0.03, 0.018], "iron", 8) for a in (k * math.pi / 3 for k in range(6))]
    hub = lathe([(0.0, -0.09), (0.06, -0.09), (0.07, 0.0), (0.06, 0.09), (0.0, 0.09)], "brass", 18)
    wheel = joined([rim, hub] + spokes).turned(90, "x").moved(0, 0, 0.66)
    frame = []
    for y in (-0.14, 0.14):
        frame += [tube([(-0.5, y * 2, 0.0), (0, y, 0.66), (0.5, y * 2, 0.0)], 0.035, "iron", 8), tube([(0, y, 0.66), (0, y, 1.02)], 0.03, "iron", 8)]
    table = [slab(0.9, 0.5, 0.05, "oak", 0.01, 1.0), lathe([(0.0, 1.05), (0.03, 1.05), (0.03, 1.14), (0.16, 1.16), (0.20, 1.22), (0.19, 1.225), (0.15, 1.18), (0.0, 1.165)], "brass", 28)]
    return joined([wheel] + frame + table + [block(-0.3, -0.35, 0.05, 0.3, -0.2, 0.08, "oak", 0.01)])


def globe():
    legs = [tube([(0.30 * math.cos(a), 0.30 * math.sin(a), 0.0), (0.44 * math.cos(a), 0.44 * math.sin(a), 0.60), (0.50 * math.cos(a), 0.50 * math.sin(a), 0.90)], [0.025, 0.02, 0.03], "oak_dark", 8)
            for a in (math.pi / 4 + k * math.pi / 2 for k in range(4))]
    return joined(legs + [ball(0.44, "marble_green", 24, 14).moved(0, 0, 0.94), statues._ring(0.47, 0.012, 90, 20).moved(0, 0, 0.94),
                          lathe([(0.455, 0.90), (0.56, 0.90), (0.57, 0.93), (0.56, 0.95), (0.455, 0.95), (0.455, 0.90)], "oak_dark", 32),
                          tube([(0.3, 0, 0.12), (-0.3, 0, 0.12)], 0.018, "oak_dark", 6), tube([(0, 0.3, 0.12), (0, -0.3, 0.12)], 0.018, "oak_dark", 6)])


def fireplace():
    """A chimney piece against a wall behind it (y = 0): white marble jambs, a black hearth, a mantel clock."""
    parts = [block(-1.05, -0.36, 0, -0.72, 0, 1.15, "statuary", 0.02), block(0.72, -0.36, 0, 1.05, 0, 1.15, "statuary", 0.02),
             block(-1.05, -0.34, 0.98, 1.05, 0, 1.20, "statuary", 0.02), block(-1.2, -0.46, 1.20, 1.2, 0, 1.27, "statuary", 0.025),
             block(-0.72, -0.04, 0, 0.72, 0, 0.98, "marble_black", 0.005), block(-1.1, -0.8, 0.0, 1.1, 0, 0.03, "marble_black", 0.01)]
    for x in (-0.885, 0.885):
        parts += [block(x - 0.10, -0.385, 0.2, x + 0.10, -0.355, 0.9, "marble_green", 0.012), ball(0.09, "gilt", 16, 8).scaled(1, 0.3, 1).moved(x, -0.36, 1.06)]
    parts.append(block(-0.4, -0.365, 1.03, 0.4, -0.335, 1.15, "marble_green", 0.012))
    for i in range(7):
        x = -0.36 + 0.12 * i
        parts.append(tube([(x, -0.30, 0.06), (x, -0.10, 0.10)], 0.012, "iron", 6))
    for i, (x, z, t) in enumerate(((-0.2, 0.16, 12), (0.15, 0.17, -9), (0.0, 0.26, 30))):
        parts.append(tube([(x - 0.24, -0.2, z - 0.02), (x + 0.24, -0.17 - 0.05 * i, z + 0.03)], 0.05, "iron", 10).turned(0))
    clock = [block(-0.16, -0.26, 1.27, 0.16, -0.10, 1.36, "marble_black", 0.015), lathe([(0.0, -0.05), (0.13, -0.05), (0.14, 0.0), (0.13, 0.05), (0.11, 0.06), (0.0, 0.06)], "gilt", 28).turned(90, "x").moved(0, -0.18, 1.49),
             lathe([(0.0, 0.0), (0.105, 0.0)], "paper", 24).turned(90, "x").moved(0, -0.243, 1.49), tube([(0, -0.248, 1.49), (0.0, -0.248, 1.565)], 0.005, "iron", 6), tube([(0, -0.248, 1.49), (0.05, -0.248, 1.47)], 0.006, "iron", 6)]
    embers = joined([ball(0.06, "ember", 8, 4).scaled(1.4, 1, 0.5).moved(-0.18 + 0.12 * i, -0.19 + 0.02 * (i % 2), 0.115) for i in range(4)])
    return joined(parts + clock), embers


def curtain(width, height, material="velvet_red", pull=-1):
    """A drape hanging along x from a brass rod, gathered at two fifths of its height towards one side."""
    shape, columns, rows = Shape(), 35, 10
    for j in range(rows + 1):
        t = j / rows                      # 0 at the floor
        z = 0.02 + (height - 0.02) * t
        gather = math.exp(-((t - 0.42) / 0.16) ** 2)
        share = 1.0 - 0.62 * gather - (0.30 * (1 - t) if t < 0.42 else 0.0)
        for i in range(columns + 1):
            s = i / columns
            x = width * (s * share if pull < 0 else 1.0 - (1.0 - s) * share)
            wave = 0.055 * math.sin(2 * math.pi * s * 7 + 0.4 * math.sin(5 * t)) * (1.0 - 0.45 * gather)
            shape.points.append((x, wave, z))
    for j in range(rows):
        for i in range(columns):
            a = j * (columns + 1) + i
            shape.face([a, a + 1, a + columns + 2, a + columns + 1], material)
    tie_x = width * 0.19 if pull < 0 else width * 0.81
    band = [(tie_x + 0.24 * width * math.cos(a), 0.075 * math.sin(a), 0.42 * height + 0.03 * math.cos(a)) for a in (k * math.pi / 8 for k in range(16))]
    return joined([shape, tube(band, 0.018, "gilt", 6, True)])


def torchere():
    """A gilded stand as tall as a man, for an opal globe at 2.05 m."""
    return joined([lathe([(0.0, 0.0), (0.24, 0.0), (0.24, 0.05), (0.16, 0.09), (0.06, 0.16), (0.045, 0.30), (0.08, 0.36), (0.05, 0.44), (0.035, 1.0),
                          (0.05, 1.30), (0.09, 1.36), (0.05, 1.42), (0.04, 1.70), (0.13, 1.86), (0.14, 1.90), (0.03, 1.91), (0.0, 1.92)], "gilt", 16,
                         lambda a, k: 1.0 + (0.06 * math.cos(8 * a) if k in (8, 9, 10) else 0.0))])


def tondo(radius):
    """A round relief for a high wall behind it: a laurel moulding and a star of gilt rays on green marble."""
    ring = lathe([(radius + 0.16, -0.004), (radius + 0.12, 0.05), (radius + 0.03, 0.06), (radius, -0.004)], "stucco", 24)
    disc = lathe([(radius + 0.01, 0.012), (0.0, 0.012)], "marble_green", 24)
    rays = []
    for i in range(12):
        a, r = i * math.pi / 6, radius * (0.86 if i % 2 == 0 else 0.6)
        ray = Shape()
        ray.points = [(0.16 * radius, -0.05, 0.012), (r, 0, 0.014), (0.16 * radius, 0.05, 0.012), (0.3 * radius, 0, 0.05)]
        for c in ((0, 1, 3), (1, 2, 3), (2, 0, 3)):
            ray.face(list(c), "gilt")
        rays.append(ray.turned(math.degrees(a)))
    heart = ball(0.17 * radius, "gilt", 10, 4).scaled(1, 1, 0.5).moved(0, 0, 0.02)
    return joined([ring, disc, heart] + rays).turned(90, "x")
