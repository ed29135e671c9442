"""Things people sit on, stand behind or must not touch: benches, desks, shelves, ropes, picture frames, vitrines."""
import math

import meshkit
import mirrors
import scene
import statues
from meshkit import Shape, ball, block, joined, lathe, slab, tube


def bench(length=1.6):
    """Upholstered, on turned legs: high enough to crouch behind."""
    legs = [lathe([(0.03, 0.0), (0.022, 0.06), (0.038, 0.14), (0.028, 0.30), (0.04, 0.36)], "oak_dark", 6).moved(x, y)
            for x in (-length / 2 + 0.1, length / 2 - 0.1) for y in (-0.17, 0.17)]
    return joined(legs + [slab(length, 0.48, 0.07, "oak_dark", 0.012, 0.34), slab(length - 0.02, 0.46, 0.11, "velvet_red", 0.04, 0.40)])


def settee():
    """The round settee of a great gallery: a velvet ring about a back that carries an urn."""
    seat = lathe([(0.0, 0.0), (1.05, 0.0), (1.08, 0.04), (1.05, 0.12), (1.02, 0.14), (1.06, 0.2), (1.06, 0.38), (1.00, 0.44), (0.6, 0.45), (0.0, 0.45)],
                 "velvet_blue", 32)
    back = lathe([(0.58, 0.45), (0.52, 0.55), (0.44, 0.95), (0.46, 1.0), (0.40, 1.05), (0.0, 1.05)], "velvet_blue", 32,
                 lambda a, k: 1.0 - 0.05 * abs(math.sin(8 * a)) * (1 if k in (1, 2) else 0))
    rim = lathe([(0.0, 1.04), (0.44, 1.04), (0.46, 1.07), (0.44, 1.10), (0.0, 1.10)], "gilt", 32)
    return joined([seat, back, rim, statues.urn(0.75).moved(0, 0, 1.10)])


def rope_posts(path, closed=False):
    """Brass posts joined by sagging velvet ropes."""
    shape = Shape()
    post = lathe([(0.0, 0.0), (0.16, 0.0), (0.16, 0.02), (0.05, 0.045), (0.028, 0.08), (0.028, 0.90), (0.05, 0.95), (0.03, 1.0), (0.0, 1.01)], "brass", 12)
    for x, y in path:
        shape.add(post.moved(x, y))
    ends = path + path[:1] if closed else path
    for (ax, ay), (bx, by) in zip(ends, ends[1:]):
        sag = []
        for i in range(10):
            t = i / 9
            sag.append((ax + (bx - ax) * t, ay + (by - ay) * t, 0.86 - 0.22 * (1 - (2 * t - 1) ** 2)))
        shape.add(tube(sag, 0.036, "velvet_red", 6))
    return shape


def desk(length=1.8):
    parts = [slab(length, 0.8, 0.045, "oak_dark", 0.012, 0.74), slab(length - 0.3, 0.5, 0.004, "leather_green", 0.0, 0.785)]
    for side in (-1, 1):
        x = side * (length / 2 - 0.26)
        parts.append(block(x - 0.22, -0.36, 0.0, x + 0.22, 0.36, 0.74, "oak_dark", 0.012))
        for k in range(3):
            z = 0.10 + k * 0.21
            parts += [block(x - 0.18, 0.355, z, x + 0.18, 0.375, z + 0.18, "oak_dark", 0.008), ball(0.014, "brass", 10, 6).moved(x, 0.385, z + 0.09)]
    parts.append(block(-length / 2 + 0.4, -0.34, 0.2, length / 2 - 0.4, -0.30, 0.74, "oak_dark", 0.006))
    return joined(parts)


def chair():
    legs = [tube([(x, y, 0.0), (x * 0.9, y * 0.9, 0.45)], 0.02, "oak_dark", 8) for x in (-0.2, 0.2) for y in (-0.2, 0.2)]
    back = [tube([(x, -0.19, 0.45), (x * 1.05, -0.26, 0.95)], 0.018, "oak_dark", 8) for x in (-0.19, 0.19)]
    return joined(legs + back + [slab(0.46, 0.44, 0.05, "leather", 0.02, 0.44), block(-0.22, -0.275, 0.66, 0.22, -0.235, 0.96, "leather", 0.015)])


def counter(length):
    """A long panelled counter with a marble top, its public side to -y."""
    parts = [slab(length, 0.62, 0.06, "marble_black", 0.015, 1.0), slab(length - 0.1, 0.5, 0.9, "oak", 0.01, 0.1), slab(length - 0.06, 0.46, 0.1, "oak_dark", 0.01)]
    count = max(1, int(length / 0.7))
    for i in range(count):
        x = -length / 2 + 0.1 + (length - 0.2) * i / count
        parts.append(block(x + 0.05, -0.27, 0.2, x + (length - 0.2) / count - 0.05, -0.245, 0.92, "oak", 0.012))
    return joined(parts)


def bookcase(width, height, seed):
    """Shelves full of books; no two of a row alike, the same in every build."""
    import random
    pick = random.Random(seed)
    parts = [block(-width / 2, -0.02, 0, width / 2, 0.0, height, "oak_dark", 0.004), block(-width / 2 - 0.05, -0.40, 0, width / 2 + 0.05, 0, 0.12, "oak_dark", 0.015),
             block(-width / 2 - 0.08, -0.44, height - 0.1, width / 2 + 0.08, 0, height + 0.04, "oak_dark", 0.03)]
    for x in (-width / 2, width / 2 - 0.04):
        parts.append(block(x, -0.36, 0.1, x + 0.04, 0, height - 0.05, "oak_dark", 0.006))
    z = 0.12
    while z + 0.3 < height - 0.1:
        parts.append(block(-width / 2, -0.35, z, width / 2, 0, z + 0.03, "oak_dark", 0.005))
        x, row = -width / 2 + 0.06, []
        while x < width / 2 - 0.12:
            thick, tall = pick.uniform(0.034, 0.085), pick.uniform(0.20, 0.29)
            if pick.random() < 0.07:
                x += pick.uniform(0.05, 0.18)
                row.append(None)
                continue
            colour = pick.choice(["book_red", "book_green", "book_blue", "book_tan", "leather", "book_tan"])
            depth = pick.uniform(0.18, 0.23)
            row.append((x, x + thick - 0.003, -0.30, -0.30 + depth, z + 0.03, z + 0.03 + tall, colour))
            x += thick
        for before, book, after in zip([None] + row, row, row[1:] + [None]):
            if book:
                parts.append(_book(book, before[5] if before else 0.0, after[5] if after else 0.0))
        z += 0.36
    return joined(parts)


_TALLEST_EYES = 1.9  # metres


def _book(book, left, right):
    """Spine, boards and top edge: on a shelf nobody sees the rest, nor the board that a neighbour as tall hides (whose
    tops are at `left` and `right`), nor the top of a book above everybody's eyes."""
    x0, x1, y0, y1, z0, z1, colour = book
    shape = Shape()
    shape.points = [(x0, y0, z0), (x1, y0, z0), (x1, y0, z1), (x0, y0, z1), (x0, y1, z0), (x1, y1, z0), (x1, y1, z1), (x0, y1, z1)]
    for corners, material, seen in (((0, 1, 2, 3), colour, True), ((4, 0, 3, 7), colour, left < z1), ((1, 5, 6, 2), colour, right < z1),
                                    ((3, 2, 6, 7), "paper", z1 < _TALLEST_EYES)):
        if seen:
            shape.face(corners, material)
    return shape


def armchair():
    """A winged leather chair to read in by a fire, its front to -y."""
    parts = [block(-0.34, -0.36, 0.16, 0.34, 0.34, 0.32, "leather", 0.02), block(-0.27, -0.38, 0.32, 0.27, 0.22, 0.45, "leather", 0.05)]
    back = block(-0.30, 0.20, 0.30, 0.30, 0.36, 1.12, "leather", 0.06).mapped(lambda p: (p[0] * (1.0 - 0.12 * max(0.0, p[2] - 0.95)), p[1] + 0.16 * (p[2] - 0.3), p[2]))
    parts.append(back)
    for side in (-1, 1):
        x = side * 0.32
        parts += [block(x - 0.06, -0.34, 0.30, x + 0.06, 0.26, 0.62, "leather", 0.05), block(x - 0.045, 0.06, 0.60, x + 0.045, 0.36, 1.02, "leather", 0.04)]
        parts += [block(side * 0.28 - 0.025, y - 0.025, 0.0, side * 0.28 + 0.025, y + 0.025, 0.17, "oak_dark", 0.0) for y in (-0.29, 0.29)]
    return joined(parts)


def ladder(height=2.75, lean=0.62):
    """Leans on shelves behind it (at y = 0 on top) for those who read what stands high."""
    parts = [tube([(x, -lean, 0.0), (x, 0.0, height)], 0.026, "oak_dark", 6) for x in (-0.21, 0.21)]
    for i in range(8):
        t = 0.1 + 0.11 * i
        parts.append(block(-0.21, -lean * (1 - t) - 0.05, t * height, 0.21, -lean * (1 - t) + 0.03, t * height + 0.024, "oak_dark", 0.0))
    return joined(parts)


def papers(seed):
    """What somebody was working on until the museum closed: sheets, an open book, an inkwell with its pen."""
    import random
    pick = random.Random(seed)
    parts = [slab(0.21, 0.297, 0.002, "paper", 0.0, 0.0015 * i).turned(pick.uniform(-40, 40)).moved(pick.uniform(-0.32, 0.05), pick.uniform(-0.10, 0.12), 0) for i in range(4)]
    leaves = Shape()
    leaves.points = [(x, y, z) for y in (-0.13, 0.13) for x, z in ((-0.19, 0.012), (-0.10, 0.030), (0.0, 0.012), (0.10, 0.030), (0.19, 0.012))]
    for i in range(4):
        leaves.face([i, i + 1, i + 6, i + 5], "paper")
    cover = block(-0.20, -0.138, 0.0, 0.20, 0.138, 0.011, "leather", 0.0)
    parts.append(joined([cover, leaves]).turned(-14).moved(0.30, -0.04, 0.0))
    parts.append(lathe([(0.0, 0.0), (0.035, 0.0), (0.036, 0.03), (0.018, 0.045), (0.02, 0.055), (0.0, 0.05)], "marble_black", 10).moved(-0.05, 0.20, 0))
    parts.append(tube([(-0.05, 0.20, 0.04), (0.02, 0.26, 0.20)], [0.003, 0.007], "paper", 4))
    return joined(parts)


def hung_coat(cloth, hem=0.75):
    """An overcoat on a hook at the origin's 1.74 m: sloping shoulders, falling sleeves, its front to -y and buttoned."""
    body = lathe([(0.02, hem), (0.18, hem + 0.02), (0.14, 1.18), (0.165, 1.44), (0.185, 1.56), (0.12, 1.645), (0.045, 1.69), (0.0, 1.70)], cloth, 12,
                 lambda a, k: 1.0 + 0.12 * math.sin(5 * a + 1.0) * (k < 3)).scaled(1, 0.5, 1)
    parts = [body]
    for side in (-1, 1):
        parts.append(tube([(side * 0.155, 0.0, 1.585), (side * 0.205, -0.01, 1.34), (side * 0.185, -0.035, 1.02)], [0.055, 0.052, 0.046], cloth, 6))
        lapel = Shape()
        lapel.points = [(side * 0.035, -0.062, 1.685), (side * 0.105, -0.088, 1.50), (side * 0.012, -0.092, 1.34), (side * 0.010, -0.070, 1.60)]
        lapel.face([0, 1, 2, 3] if side < 0 else [3, 2, 1, 0], "velvet_blue")
        parts.append(lapel)
    return joined(parts)


def coat_rack(length):
    parts = [block(-length / 2, -0.04, 1.70, length / 2, 0, 1.84, "oak_dark", 0.01), block(-length / 2, -0.30, 1.98, length / 2, 0, 2.02, "oak_dark", 0.01)]
    for i in range(int(length / 0.3)):
        x = -length / 2 + 0.15 + 0.3 * i
        parts.append(tube([(x, -0.04, 1.74), (x, -0.12, 1.72), (x, -0.15, 1.78)], 0.009, "brass", 8))
        if i % 4 in (1, 2):
            parts.append(hung_coat("coat" if i % 3 else "dark_cloth", 0.75 + 0.05 * (i % 3)).moved(x, -0.14))
    return joined(parts)


def crates(seed):
    import random
    pick = random.Random(seed)
    parts = []
    for x, y, z, s, turn in ((0, 0, 0, 0.8, 8), (0.95, 0.1, 0, 0.62, -14), (0.1, 0.05, 0.8, 0.55, 20)):
        h = s / 2
        box = [block(-h, -h, 0.02, h, h, s, "oak", 0.004)]
        for e in (-1, 1):
            for f in (-1, 1):
                box += [block(e * h - 0.05, f * h - 0.05, 0, e * h + 0.05, f * h + 0.05, s + 0.02, "oak_dark", 0.006)]
            box += [block(-h, e * h - 0.03, s - 0.07, h, e * h + 0.03, s + 0.02, "oak_dark", 0.006), block(e * h - 0.03, -h, s - 0.07, e * h + 0.03, h, s + 0.02, "oak_dark", 0.006)]
        parts.append(joined(box).turned(turn + pick.uniform(-3, 3)).moved(x, y, z))
    return joined(parts)


def hang_picture(name, art, at, turn, width):
    """A gilded frame whose picture faces -y when turned by 0; `at` is its middle, on the wall."""
    import paintings
    height = width * (1.25 if art in paintings.TALL_NAMES else 0.75)
    shape = mirrors.framed(width, height, "art_" + art, [(0.0, 0.0), (0.0, 0.025), (0.06, 0.075), (0.10, 0.06), (0.14, 0.02), (0.14, 0.0)])
    shape.add(block(-width / 2, 0.0, -height / 2, width / 2, 0.012, height / 2, "oak_dark", 0.0))
    shape.add(block(-0.14, -0.035, -height / 2 - 0.115, 0.14, -0.02, -height / 2 - 0.06, "brass", 0.004))
    a = math.radians(turn)
    scene.mesh("picture_" + name, shape, (at[0] + 0.02 * math.sin(a), at[1] - 0.02 * math.cos(a), at[2]), turn)
    return width + 0.28, height + 0.28


def glass_box(w, d, z0, z1, t=0.008):
    """Four upright panes, mitred by a hair's gap so that no two touch."""
    g = t + 0.0006
    return joined([block(-w / 2, -d / 2, z0, w / 2, -d / 2 + t, z1, "glass", 0.0), block(-w / 2, d / 2 - t, z0, w / 2, d / 2, z1, "glass", 0.0),
                   block(-w / 2, -d / 2 + g, z0, -w / 2 + t, d / 2 - g, z1, "glass", 0.0), block(w / 2 - t, -d / 2 + g, z0, w / 2, d / 2 - g, z1, "glass", 0.0)])


def vitrine(name, at, turn=0.0, width=0.72, top=1.18):
    """The lens's vitrine: a marble-footed table, glass walls, and a brass-edged glass lid hinged at the back (+y)."""
    w, z0 = width, 0.86
    table = joined([slab(w + 0.14, w + 0.14, 0.10, "marble_black", 0.02), slab(w + 0.02, w + 0.02, z0 - 0.16, "oak_dark", 0.015, 0.10),
                    slab(w + 0.10, w + 0.10, 0.06, "oak_dark", 0.02, z0 - 0.06), slab(w - 0.03, w - 0.03, 0.02, "velvet_blue", 0.008, z0)])
    for x in (-1, 1):
        for y in (-1, 1):
            table.add(block(x * w / 2 - 0.012, y * w / 2 - 0.012, z0, x * w / 2 + 0.012, y * w / 2 + 0.012, top, "brass", 0.003))
            table.add(lathe([(0.0, 0.10), (0.05, 0.10), (0.035, 0.16), (0.045, 0.3), (0.035, 0.7), (0.05, 0.78), (0.0, 0.8)], "gilt", 12).moved(x * w / 2, y * w / 2))
    for a in (0, 90, 180, 270):
        table.add(block(-w / 2 + 0.08, -w / 2 - 0.022, 0.22, w / 2 - 0.08, -w / 2, z0 - 0.16, "oak_dark", 0.012).turned(a))
    scene.mesh(name, table, at, turn)
    scene.mesh(name + "_glass", glass_box(w - 0.03, w - 0.03, z0 + 0.001, top), at, turn)
    hinge = w / 2 + 0.012
    lid = joined([block(-w / 2 + 0.016, -w - 0.008, 0.004, w / 2 - 0.016, -0.016, 0.012, "glass", 0.0)])
    for x0, y0, x1, y1 in ((-w / 2 - 0.012, -w - 0.024, w / 2 + 0.012, -w - 0.009), (-w / 2 - 0.012, -0.015, w / 2 + 0.012, 0.0),
                           (-w / 2 - 0.012, -w - 0.009, -w / 2 + 0.015, -0.015), (w / 2 - 0.015, -w - 0.009, w / 2 + 0.012, -0.015)):
        lid.add(block(x0, y0, 0.0, x1, y1, 0.018, "brass", 0.003))
    lid.add(ball(0.018, "brass", 12, 8).moved(0, -w - 0.03, 0.012))
    a = math.radians(turn)
    where = (at[0] - hinge * math.sin(a), at[1] + hinge * math.cos(a), at[2] + top + 0.002)
    scene.mesh(name + "_lid", lid, where, turn, kind="door", axis="x", open_angle_deg=-78.0, open_time_s=1.1, title="Vitrine lid")
    return at[2] + z0 + 0.02


def palm(seed=2):
    """A kentia palm in a glazed pot: arching fronds of folded blades, for corners."""
    import random
    pick = random.Random(seed)
    pot = lathe([(0.0, 0.0), (0.17, 0.0), (0.18, 0.04), (0.24, 0.30), (0.27, 0.40), (0.27, 0.45), (0.23, 0.45), (0.22, 0.40)], "marble_green", 10)
    parts = [pot, lathe([(0.225, 0.40), (0.0, 0.42)], "earth", 10)]
    for i in range(8):
        a, length, rise = 2.4 * i + pick.uniform(-0.3, 0.3), pick.uniform(0.55, 0.85), pick.uniform(0.7, 1.25)
        out = [(length * t * math.cos(a), length * t * math.sin(a), 0.41 + rise * (1.9 * t - 1.05 * t * t)) for t in (0.0, 0.35, 0.7, 1.0)]
        parts.append(tube(out, [0.014, 0.010, 0.007, 0.003], "leaf", 3))
        for t in range(1, 4):
            x, y, z = out[t]
            for side in (-1, 1):
                for back in (0.0, 0.5):
                    bx, by, bz = (p + (q - p) * back for p, q in zip(out[t], out[t - 1]))
                    reach = 0.28 - 0.04 * t
                    blade = Shape()
                    blade.points = [(bx, by, bz), (bx - side * reach * 0.5 * math.sin(a + side * 0.5), by + side * reach * 0.5 * math.cos(a + side * 0.5), bz + 0.02),
                                    (bx - side * reach * math.sin(a) + 0.14 * math.cos(a), by + side * reach * math.cos(a) + 0.14 * math.sin(a), bz - 0.10),
                                    (bx + 0.05 * math.cos(a), by + 0.05 * math.sin(a), bz + 0.01)]
                    blade.face([0, 1, 2, 3], "leaf")
                    parts.append(blade)
    return joined(parts)


def longcase_clock():
    """A clock as tall as a man, against a wall behind it (y = 0), with a paper dial and a brass pendulum behind its door."""
    parts = [block(-0.26, -0.30, 0.0, 0.26, 0, 0.14, "oak_dark", 0.015), block(-0.23, -0.27, 0.14, 0.23, 0, 0.55, "oak_dark", 0.01), block(-0.18, -0.22, 0.55, 0.18, 0, 1.50, "oak_dark", 0.01),
             block(-0.24, -0.28, 1.50, 0.24, 0, 1.56, "oak_dark", 0.015), block(-0.22, -0.26, 1.56, 0.22, 0, 2.02, "oak_dark", 0.01), block(-0.26, -0.30, 2.02, 0.26, 0, 2.08, "oak_dark", 0.02),
             block(-0.10, -0.232, 0.66, 0.10, -0.219, 1.40, "marble_black", 0.004)]
    dial = lathe([(0.175, 0.0), (0.165, 0.014), (0.15, 0.016), (0.148, 0.006), (0.0, 0.006)], "paper", 24).turned(90, "x").moved(0, -0.26, 1.79)
    ring = lathe([(0.175, 0.0), (0.180, 0.018), (0.152, 0.022), (0.150, 0.0)], "brass", 24).turned(90, "x").moved(0, -0.262, 1.79)
    hands = [tube([(0, -0.275, 1.79), (-0.05, -0.275, 1.85)], 0.006, "iron", 4), tube([(0, -0.277, 1.79), (0.11, -0.277, 1.81)], 0.005, "iron", 4)]
    swing = [tube([(0.0, -0.238, 1.36), (0.03, -0.238, 0.86)], 0.006, "brass", 4), lathe([(0.0, 0.012), (0.055, 0.006), (0.055, -0.004), (0.0, -0.004)], "brass", 14).turned(90, "x").moved(0.034, -0.238, 0.82)]
    return joined(parts + [dial, ring] + hands + swing + [ball(0.035, "gilt", 10, 6).moved(x, -0.15, 2.11 + 0.06 * (x == 0)) for x in (-0.2, 0.0, 0.2)])
