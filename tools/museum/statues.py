"""The landmarks: an armillary sphere, a giant lens on its stand, obelisks, urns and plinths."""
import math

import meshkit
from meshkit import Shape, ball, block, joined, lathe, slab, tube


def plinth(width, height, stone="marble_white", band="marble_black"):
    w = width
    return joined([slab(w + 0.14, w + 0.14, 0.12, band, 0.02), slab(w + 0.06, w + 0.06, 0.06, stone, 0.02, 0.12),
                   slab(w, w, height - 0.30, stone, 0.0, 0.18), slab(w + 0.05, w + 0.05, 0.05, stone, 0.015, height - 0.12),
                   slab(w + 0.12, w + 0.12, 0.07, band, 0.02, height - 0.07)])


def _ring(radius, thickness, tilt=0.0, heading=0.0, material="brass", count=44, flat=2.2):
    """A flat hoop in a plane tilted from level."""
    half, shape = thickness * flat, Shape()
    profile = [(radius - thickness, -half), (radius + thickness, -half), (radius + thickness, half), (radius - thickness, half), (radius - thickness, -half)]
    return lathe(profile, material, count).turned(tilt, "x").turned(heading)


def armillary(radius):
    """A sphere of brass hoops about a gilded sun, held by a turned foot; its centre is at radius + 0.75."""
    centre = radius + 0.75
    hoops = [_ring(radius, 0.026), _ring(radius, 0.026, 90), _ring(radius * 0.97, 0.024, 90, 90), _ring(radius * 0.9, 0.022, 23.5, 30),
             _ring(radius * 0.93, 0.018, 66.5, 30)]
    for height in (0.40, -0.40):
        hoops.append(_ring(radius * math.sqrt(1 - height ** 2) * 0.97, 0.018).moved(0, 0, radius * height * 0.97))
    hoops = [joined(hoops[3:]).turned(23.5, "y"), joined(hoops[:3])]
    axis = tube([(0, 0, -radius * 1.16), (0, 0, radius * 1.16)], 0.014, "brass", 10).turned(23.5, "y")
    sun = ball(radius * 0.17, "gilt", 20, 12)
    planets = joined([ball(0.06, m, 12, 7).moved(radius * r * math.cos(a), radius * r * math.sin(a), 0)
                      for r, a, m in ((0.36, 0.7, "bronze"), (0.52, 2.9, "marble_rose"), (0.70, 4.6, "marble_green"))])
    orbits = joined([_ring(radius * r, 0.009, count=32, flat=1.0) for r in (0.36, 0.52, 0.70)])
    sphere = joined(hoops + [axis, sun, planets, orbits]).moved(0, 0, centre)
    foot = lathe([(0.0, 0.0), (0.42, 0.0), (0.42, 0.05), (0.30, 0.09), (0.12, 0.16), (0.08, 0.28), (0.12, 0.36), (0.07, 0.44), (0.055, 0.6),
                  (0.10, 0.68), (0.0, 0.72)], "bronze", 24)
    cradle = [tube([(0.06 * math.cos(a), 0.06 * math.sin(a), 0.62)] +
                   [(radius * 1.04 * math.sin(t) * math.cos(a), radius * 1.04 * math.sin(t) * math.sin(a), centre - radius * 1.04 * math.cos(t))
                    for t in (0.35, 0.7, 1.05, 1.35, 1.55)], 0.024, "bronze", 8) for a in (math.pi / 4 + k * math.pi / 2 for k in range(4))]
    return joined([foot, sphere] + cradle)


def biconvex(radius, thickness, rim, material, segments=40, rings=6):
    """A lens, closed: two spherical caps and a cylinder of width `rim` between; its axis is z."""
    sag = (thickness - rim) / 2
    curve = (radius ** 2 + sag ** 2) / (2 * sag)
    cap = []
    for i in range(rings + 1):
        r = radius * i / rings
        cap.append((r, rim / 2 + math.sqrt(curve ** 2 - r ** 2) - (curve - sag)))
    bottom = [(r, -z) for r, z in cap]
    return lathe(bottom + cap[::-1], material, segments)


def giant_lens(radius):
    """A burning-glass on a mahogany stand: the glass apart from its frame, both centred on the same foot."""
    centre = radius + 0.55
    glass = biconvex(radius, 0.26 * radius, 0.03, "lens_glass").turned(90, "x").moved(0, 0, centre)
    ring = lathe([(radius + 0.002, -0.05), (radius + 0.05, -0.05), (radius + 0.065, 0.0), (radius + 0.05, 0.05), (radius + 0.002, 0.05),
                  (radius + 0.002, -0.05)], "brass", 44).turned(90, "x").moved(0, 0, centre)
    parts = [ring, slab(radius * 1.5, 0.55, 0.08, "oak_dark", 0.02), slab(radius * 1.2, 0.4, 0.06, "oak_dark", 0.02, 0.08)]
    for side in (-1, 1):
        x = side * (radius + 0.11)
        parts += [block(x - 0.05, -0.07, 0.10, x + 0.05, 0.07, centre + 0.1, "oak_dark", 0.02), ball(0.07, "brass", 12, 7).moved(x, 0, centre + 0.14),
                  tube([(x, 0, centre), (side * (radius + 0.04), 0, centre)], 0.03, "brass", 12),
                  tube([(x, 0, 0.3), (side * radius * 0.4, 0, 0.12)], 0.025, "oak_dark", 8)]
    parts.append(block(-radius - 0.16, -0.11, 0.06, radius + 0.16, 0.11, 0.16, "oak_dark", 0.02))
    return glass, joined(parts)


def obelisk(height, stone="marble_black"):
    w = height * 0.11
    shaft = Shape()
    for z, s in ((0.0, w), (height * 0.86, w * 0.62), (height, 0.0)):
        shaft.points += [(-s, -s, z), (s, -s, z), (s, s, z), (-s, s, z)] if s else [(0, 0, z)]
    for i in range(4):
        j = (i + 1) % 4
        shaft.face([i, j, 4 + j, 4 + i], stone)
        shaft.face([4 + i, 4 + j, 8], "gilt")
    shaft.face([3, 2, 1, 0], stone)
    feet = [ball(0.05, "gilt", 10, 6).moved(x, y, 0.05) for x in (-w * 0.8, w * 0.8) for y in (-w * 0.8, w * 0.8)]
    return joined(feet + [shaft.moved(0, 0, 0.09)])


def urn(height, stone="marble_green"):
    h = height
    body = lathe([(r * h, z * h) for r, z in ((0.0, 0.0), (0.17, 0.0), (0.17, 0.05), (0.10, 0.08), (0.07, 0.14), (0.09, 0.18), (0.20, 0.30), (0.27, 0.46),
                  (0.28, 0.58), (0.24, 0.68), (0.15, 0.76), (0.13, 0.82), (0.17, 0.87), (0.20, 0.90), (0.18, 0.93), (0.08, 0.97), (0.03, 0.99),
                  (0.045, 1.03), (0.0, 1.07))], stone, 20)
    handles = [tube([(s * h * x, 0, h * z) for x, z in ((0.15, 0.78), (0.26, 0.84), (0.34, 0.76), (0.33, 0.64), (0.26, 0.58))], 0.024 * h, "gilt", 6)
               for s in (-1, 1)]
    return joined([body] + handles)

