"""What an optician's workshop and a cloakroom are full of: a bench with its vice, a board of tools, a great dish in its
cradle, umbrellas, hats, trunks. Things stand on z = 0 or hang on a wall behind them (y = 0), standing out to -y."""
import math
import random

import meshkit
from furniture import hung_coat
from meshkit import ball, block, joined, lathe, slab, tube


def workbench(length=2.4):
    """A heavy oak bench 0.9 m high with a shelf of boxes under it and an iron vice at its right end; front to -y."""
    half = length / 2
    parts = [slab(length, 0.72, 0.08, "oak", 0.012, 0.82), block(-half + 0.08, -0.28, 0.22, half - 0.08, 0.28, 0.26, "oak", 0.0),
             block(-half + 0.04, -0.33, 0.70, half - 0.04, -0.29, 0.82, "oak_dark", 0.0)]
    for x in (-half + 0.12, half - 0.12):
        for y in (-0.27, 0.27):
            parts.append(block(x - 0.05, y - 0.05, 0.0, x + 0.05, y + 0.05, 0.82, "oak_dark", 0.01))
    pick = random.Random(3)
    x = -half + 0.25
    while x < half - 0.5:
        w, h = pick.uniform(0.22, 0.42), pick.uniform(0.16, 0.34)
        wood = pick.choice(("oak", "iron_green", "oak_dark"))
        parts += [block(x, -0.2, 0.26, x + w, 0.18, 0.26 + h, wood, 0.0), block(x - 0.008, -0.208, 0.24 + h * 0.82, x + w + 0.008, 0.188, 0.27 + h, wood, 0.0),
                  block(x + w * 0.32, -0.214, 0.26 + h * 0.30, x + w * 0.68, -0.19, 0.26 + h * 0.58, "brass" if wood == "oak_dark" else "paper", 0.0)]
        x += w + pick.uniform(0.04, 0.16)
    return joined(parts + [vice().moved(half - 0.34, -0.30, 0.90)])


def vice():
    """Two jaws, the screw between them and its sliding handle, on a foot bolted to a bench's edge."""
    jaw = block(-0.09, -0.03, 0.02, 0.09, 0.03, 0.20, "iron", 0.01)
    return joined([block(-0.07, -0.06, 0.0, 0.07, 0.16, 0.05, "iron", 0.01), jaw.moved(0, 0.05, 0), jaw.moved(0, -0.10, -0.02),
                   tube([(0, 0.06, 0.09), (0, -0.30, 0.09)], 0.022, "steel", 8), tube([(-0.14, -0.29, 0.09), (0.14, -0.29, 0.09)], 0.012, "steel", 6),
                   ball(0.022, "steel", 8, 5).moved(-0.14, -0.29, 0.09), ball(0.022, "steel", 8, 5).moved(0.14, -0.29, 0.09)])


def tool_board(width=2.2, height=0.9):
    """Boards on a wall with what hangs from them: saws, hammers, callipers, a coil of wire."""
    parts = [block(-width / 2, -0.03, 0.0, width / 2, 0.0, height, "oak_dark", 0.0)]
    for i, (kind, x) in enumerate(zip(("saw", "hammer", "hammer", "file", "file", "calliper", "saw", "coil"), [-0.44, -0.29, -0.19, -0.09, -0.02, 0.12, 0.28, 0.42])):
        parts.append(_hung(kind, i).moved(x * width, -0.045, height * 0.5))
    return joined(parts)


def _hung(kind, i):
    if kind == "saw":
        blade = meshkit.extruded([(-0.03, -0.34), (0.05, -0.34), (0.09, 0.12), (-0.05, 0.12)], 0.0, 0.006, "steel")
        return joined([blade.mapped(lambda p: (p[0], -p[2], p[1])), block(-0.07, -0.025, 0.12, 0.11, 0.01, 0.26, "oak", 0.01)])
    if kind == "hammer":
        return joined([tube([(0, 0, -0.26), (0, 0, 0.16)], 0.016, "oak", 6), block(-0.09, -0.03, 0.12, 0.06, 0.03, 0.18, "iron", 0.01)])
    if kind == "file":
        return joined([block(-0.018, -0.008, -0.26 + 0.03 * i, 0.018, 0.008, 0.06, "steel", 0.0), tube([(0, 0, 0.06), (0, 0, 0.2)], 0.02, "oak", 6)])
    if kind == "calliper":
        bow = [(0.13 * math.sin(a), 0, -0.14 * math.cos(a)) for a in (0.2, 0.8, 1.4, 2.0, 2.6, 3.1)]
        return joined([tube(bow, 0.012, "brass", 5), tube([(-x, y, z) for x, y, z in bow], 0.012, "brass", 5), ball(0.025, "brass", 8, 5).moved(0, 0, 0.14)])
    return tube([(0.14 * math.cos(a), 0.01 * (a > 3), 0.14 * math.sin(a)) for a in (k * math.pi / 8 for k in range(16))], 0.022, "copper", 6, True)


def great_dish(radius=0.95):
    """A telescope's mirror of speculum metal, a metre and a half across, tipped back in an oak cradle; faces -y."""
    bowl = lathe([(radius * r, 0.10 + 0.22 * r * r) for r in (0.02, 0.3, 0.55, 0.78, 1.0)][::-1], "speculum", 40)
    back = lathe([(0.0, 0.0), (radius * 0.9, 0.0), (radius * 1.04, 0.20), (radius * 1.04, 0.33), (radius, 0.325)], "iron", 40)
    dish = joined([bowl, back]).turned(68, "x").moved(0, 0.12, radius + 0.26)
    frame = []
    for side in (-1, 1):
        x = side * radius * 0.72
        frame += [block(x - 0.06, -0.55, 0.0, x + 0.06, 0.75, 0.12, "oak_dark", 0.012), tube([(x, 0.70, 0.08), (x * 0.9, 0.42, radius * 1.5)], 0.055, "oak_dark", 6),
                  block(x - 0.06, -0.36, 0.1, x + 0.06, -0.22, 0.34, "oak_dark", 0.012)]
    frame.append(block(-radius * 0.8, 0.46, 0.5, radius * 0.8, 0.56, 0.62, "oak_dark", 0.012))
    return joined([dish] + frame)


def stool():
    legs = [tube([(0.19 * math.cos(a), 0.19 * math.sin(a), 0.0), (0.12 * math.cos(a), 0.12 * math.sin(a), 0.62)], 0.022, "oak_dark", 6) for a in (0.5, 2.6, 4.7)]
    return joined(legs + [lathe([(0.0, 0.60), (0.17, 0.60), (0.18, 0.63), (0.16, 0.66), (0.0, 0.655)], "oak", 16)])


def shelf(width, loads, seed):
    """A wall shelf on two brackets carrying jars, boxes and rolls of drawings, no two alike."""
    pick = random.Random(seed)
    parts = [block(-width / 2, -0.30, 0.0, width / 2, 0.0, 0.035, "oak_dark", 0.0)]
    for x in (-width * 0.38, width * 0.38):
        parts.append(block(x - 0.02, -0.24, -0.20, x + 0.02, 0.0, 0.0, "iron", 0.0))
    x = -width / 2 + 0.12
    for _ in range(loads):
        kind, s = pick.choice(("jar", "jar", "box", "rolls")), pick.uniform(0.8, 1.25)
        if kind == "jar":
            parts.append(lathe([(0.0, 0.035), (0.06 * s, 0.035), (0.065 * s, 0.16 * s), (0.03 * s, 0.2 * s), (0.035 * s, 0.23 * s), (0.0, 0.23 * s)], pick.choice(("copper", "enamel_green", "limestone")), 12).moved(x + 0.06, -0.15))
        elif kind == "box":
            parts.append(block(x, -0.25, 0.035, x + 0.17 * s, -0.06, 0.035 + 0.16 * s, pick.choice(("oak", "leather", "iron_green")), 0.0))
        else:
            parts += [tube([(x + 0.03 + 0.05 * k, -0.28, 0.07 + 0.045 * (k % 2)), (x + 0.03 + 0.05 * k, -0.02, 0.07 + 0.045 * (k % 2))], 0.03, "paper", 7) for k in range(3)]
        x += 0.24 * s
        if x > width / 2 - 0.15:
            break
    return joined(parts)


def lamp_shelves(width, height, seed):
    """An oak rack of the museum's spare lamps: opal globes, brass shades, lanterns, no two boards alike."""
    pick = random.Random(seed)
    parts = [block(x - 0.02, -0.36, 0.0, x + 0.02, 0.0, height, "oak_dark", 0.0) for x in (-width / 2, 0.0, width / 2)]
    rows = int(height / 0.5)
    for row in range(rows):
        z = 0.10 + row * 0.5
        parts.append(block(-width / 2, -0.36, z, width / 2, 0.0, z + 0.03, "oak_dark", 0.0))
        x = -width / 2 + 0.18
        while x < width / 2 - 0.12:
            kind = pick.choice(("globe", "shade", "shade", "lantern"))
            if abs(x) > 0.14:
                parts.append(_spare(kind, pick.uniform(0.8, 1.15)).moved(x, -0.18 + pick.uniform(-0.03, 0.03), z + 0.03))
            x += pick.uniform(0.30, 0.42)
    return joined(parts)


def _spare(kind, s):
    if kind == "globe":
        return ball(0.11 * s, "marble_white", 10, 6).moved(0, 0, 0.11 * s)
    if kind == "shade":  # upside down in each other, as shades are stored
        cone = lathe([(0.0, 0.0), (0.035, 0.004), (0.13, 0.11), (0.03, 0.014), (0.0, 0.014)], "brass" if s < 1.0 else "copper", 9)
        return joined([cone, cone.moved(0, 0, 0.045)])
    return joined([lathe([(0.0, 0.0), (0.08, 0.0), (0.08, 0.04), (0.05, 0.06), (0.055, 0.19), (0.085, 0.21), (0.03, 0.27), (0.0, 0.28)], "iron", 8),
                   tube([(-0.06, 0, 0.22), (-0.04, 0, 0.33), (0.04, 0, 0.33), (0.06, 0, 0.22)], 0.006, "iron", 4)])


def pinned_drawing(width, art):
    """A sheet pinned to a wall, without a frame."""
    height = width * 0.75
    return joined([meshkit.picture(width, height, "art_" + art).moved(0, -0.012, 0), block(-width / 2 - 0.04, -0.010, -height / 2 - 0.04, width / 2 + 0.04, 0.0, height / 2 + 0.04, "paper", 0.0)])


def umbrella(colour="dark_cloth"):
    """Furled, standing upright on its tip."""
    crook = [(0, 0, 0.78), (0, 0, 0.90), (0.02, 0, 0.95), (0.06, 0, 0.96), (0.09, 0, 0.92)]
    return joined([lathe([(0.008, 0.0), (0.012, 0.10), (0.05, 0.22), (0.045, 0.45), (0.022, 0.72), (0.0, 0.78)], colour, 10, lambda a, k: 1.0 + 0.18 * math.sin(4 * a) * (k in (2, 3))),
                   tube(crook, 0.014, "oak", 6)])


def umbrella_stand():
    body = lathe([(0.0, 0.02), (0.15, 0.02), (0.17, 0.0), (0.17, 0.05), (0.14, 0.09), (0.16, 0.50), (0.18, 0.54), (0.15, 0.53), (0.12, 0.10), (0.0, 0.10)], "copper", 20)
    return joined([body] + [umbrella(c).turned(tilt, "x").turned(turn).moved(0.05 * math.cos(turn), 0.05 * math.sin(turn), 0.09)
                            for c, tilt, turn in (("dark_cloth", 6, 20), ("velvet_blue", 8, 150), ("coat", 7, 265))])


def hat(brim=0.17, tall=0.13, colour="coat"):
    return lathe([(0.0, 0.012), (brim, 0.0), (brim + 0.006, 0.012), (0.105, 0.02), (0.10, tall), (0.085, tall + 0.015), (0.0, tall)], colour, 12).scaled(1.0, 1.15, 1.0)


def trunk(width=0.9, seed=1):
    """A leather travelling trunk with brass corners and straps."""
    w, d, h = width, 0.46, 0.44
    parts = [slab(w, d, h, "leather", 0.02), slab(w + 0.012, d + 0.012, 0.03, "oak_dark", 0.0, h * 0.66)]
    for x in (-w * 0.28, w * 0.28):
        parts.append(block(x - 0.025, -d / 2 - 0.008, 0.0, x + 0.025, d / 2 + 0.008, h + 0.008, "oak_dark", 0.0))
    parts.append(block(-0.05, -d / 2 - 0.02, h * 0.58, 0.05, -d / 2, h * 0.76, "brass", 0.0))
    return joined(parts)


def hat_stand():
    """A bentwood stand with a coat and a hat on it."""
    hooks = [tube([(0, 0, 1.62), (0.14 * math.cos(a), 0.14 * math.sin(a), 1.66), (0.20 * math.cos(a), 0.20 * math.sin(a), 1.78)], 0.018, "oak_dark", 6) for a in (0.4, 1.97, 3.54, 5.11)]
    feet = [tube([(0, 0, 0.30), (0.16 * math.cos(a), 0.16 * math.sin(a), 0.16), (0.30 * math.cos(a), 0.30 * math.sin(a), 0.0)], 0.02, "oak_dark", 6) for a in (0.4, 1.97, 3.54, 5.11)]
    return joined(hooks + feet + [tube([(0, 0, 0.1), (0, 0, 1.86)], 0.025, "oak_dark", 8), hung_coat("coat", 0.64).moved(0.10, -0.08, 0.02), hat().moved(0, 0, 1.80)])


def stove(ceiling):
    """A porter's iron stove on its plate, its pipe to the ceiling, the door to -y ajar upon the fire. Returns it and the fire."""
    body = lathe([(0.0, 0.10), (0.24, 0.10), (0.25, 0.14), (0.22, 0.17), (0.21, 0.78), (0.25, 0.82), (0.25, 0.86), (0.16, 0.93), (0.0, 0.95)], "iron", 16)
    legs = [block(x - 0.025, y - 0.025, 0.0, x + 0.025, y + 0.025, 0.12, "iron", 0.0) for x in (-0.15, 0.15) for y in (-0.15, 0.15)]
    pipe = [tube([(0, 0.06, 0.90), (0, 0.06, ceiling)], 0.055, "iron", 8), lathe([(0.056, ceiling - 0.04), (0.10, ceiling - 0.01), (0.10, ceiling)], "iron", 10).moved(0, 0.06, 0)]
    frame = [block(-0.13, -0.235, 0.34, 0.13, -0.19, 0.38, "iron", 0.0), block(-0.13, -0.235, 0.56, 0.13, -0.19, 0.60, "iron", 0.0),
             block(-0.13, -0.235, 0.34, -0.09, -0.19, 0.60, "iron", 0.0), block(0.09, -0.235, 0.34, 0.13, -0.19, 0.60, "iron", 0.0)]
    frame += [block(x - 0.008, -0.232, 0.38, x + 0.008, -0.215, 0.56, "iron", 0.0) for x in (-0.045, 0.0, 0.045)]
    kettle = lathe([(0.0, 0.95), (0.10, 0.955), (0.115, 1.0), (0.09, 1.07), (0.03, 1.10), (0.02, 1.12), (0.0, 1.125)], "copper", 14).moved(0.03, -0.03, 0)
    spout = tube([(0.12, -0.03, 1.0), (0.19, -0.03, 1.07)], [0.018, 0.010], "copper", 6)
    plate = slab(0.8, 0.8, 0.012, "iron", 0.0)
    return joined([body, kettle, spout, plate] + legs + pipe + frame), block(-0.09, -0.212, 0.38, 0.09, -0.208, 0.56, "ember", 0.0)


def ticket_board(width=1.5, height=0.9):
    """The cloakroom's board of numbered brass tags, some hooks empty."""
    pick = random.Random(21)
    parts = [block(-width / 2, -0.03, 0.0, width / 2, 0.0, height, "oak_dark", 0.0), block(-width / 2 + 0.06, -0.034, 0.06, width / 2 - 0.06, -0.028, height - 0.06, "leather_green", 0.0)]
    for r in range(4):
        for c in range(8):
            if pick.random() < 0.3:
                continue
            x, z = -width / 2 + 0.15 + c * (width - 0.3) / 7, 0.15 + r * (height - 0.28) / 3
            parts.append(lathe([(0.0, 0.012), (0.045, 0.010), (0.045, 0.0)], "brass", 8).turned(90, "x").moved(x, -0.036, z))
    return joined(parts)
