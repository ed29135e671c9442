"""What keeps the rooms from being boxes: skirtings, dado rails, cornices, door surrounds, steps and the ramp,
coffered ceilings, skylights with their moons, columns and pilasters. All of it stands free of the shell."""
import math

import light
import meshkit
import plan
import scene
from meshkit import Shape, block, extruded, joined, lathe, sweep

# (out of the wall, up); they begin 4 mm inside the wall, floor or ceiling they lie on, so that no two faces share a plane
# Few and broad: a step of a centimetre is less than a pixel across a room, and glitters.
SKIRTING = [(-0.004, -0.004), (-0.004, 0.22), (0.012, 0.22), (0.034, 0.18), (0.034, -0.004)]
DADO = [(-0.004, -0.06), (-0.004, 0.05), (0.03, 0.05), (0.055, 0.02), (0.05, -0.015), (0.008, -0.06)]
PICTURE_RAIL = [(-0.004, -0.05), (-0.004, 0.035), (0.02, 0.035), (0.04, 0.0), (0.008, -0.05)]
CORNICE = [(-0.004, -0.42), (-0.004, 0.004), (0.38, 0.004), (0.28, -0.07), (0.19, -0.13), (0.15, -0.24), (0.08, -0.28), (0.05, -0.34), (0.03, -0.42)]
SMALL_CORNICE = [(out * 0.6, up * 0.6) for out, up in CORNICE if out not in (0.28, 0.08)]
ARCHITRAVE = [(0.0, -0.004), (0.16, -0.004), (0.16, 0.05), (0.125, 0.055), (0.10, 0.032), (0.0, 0.022)]

# room: (skirting, dado height or 0 with its panels' material, picture rail height or 0, cornice)
TRIM = {
    "vestibule": ("marble_green", 1.0, "stucco", 3.0, CORNICE), "foyer": ("marble_green", 1.05, "stucco", 0, CORNICE),
    "stair": ("marble_green", 0, "", 0, CORNICE), "cloakroom": ("oak_dark", 1.1, "oak", 2.56, SMALL_CORNICE),
    "lodge": ("oak_dark", 1.1, "oak", 2.56, SMALL_CORNICE), "west_gallery": ("oak_dark", 0.9, "oak_dark", 3.6, CORNICE),
    "west_gallery_north": ("oak_dark", 0.9, "oak_dark", 2.8, CORNICE),
    "east_gallery": ("marble_black", 0.9, "oak_dark", 3.6, CORNICE),
    "east_gallery_north": ("marble_black", 0.9, "oak_dark", 2.8, CORNICE),
    "hall": ("marble_black", 0, "", 0, CORNICE), "cabinet": ("marble_black", 0.9, "oak_dark", 0, CORNICE),
    "library": ("oak_dark", 0, "", 3.06, CORNICE), "workshop": ("oak_dark", 1.0, "oak", 2.62, SMALL_CORNICE),
    "store": ("oak_dark", 0, "", 0, SMALL_CORNICE),
}


def _run(profile, path, material, z, closed):
    return sweep([(out, up + z) for out, up in profile[::-1]], path, material, closed)


def _panels(path, z0, height, closed, material):
    """Raised panels on the wall under the dado rail, as many as fit each straight piece."""
    shape = Shape()
    ends = path + path[:1] if closed else path
    for (ax, ay), (bx, by) in zip(ends, ends[1:]):
        length = math.hypot(bx - ax, by - ay)
        count = int((length - 0.3) / 0.95)
        if count < 1:
            continue
        turn = math.degrees(math.atan2(by - ay, bx - ax))
        step = (length - 0.2) / count
        for i in range(count):
            u = 0.1 + step * i + 0.08
            raised = meshkit.raised_panel(-u - step + 0.16, z0 + 0.34, -u, z0 + height - 0.14, 0.0, 0.022, 0.03, material)
            shape.add(raised.turned(turn + 180).moved(ax, ay))
    return shape


def trim_rooms():
    for name, (skirting, dado, panel, rail, cornice) in TRIM.items():
        z0, z1 = plan.ROOMS[name][2], plan.ROOMS[name][5]
        shape = Shape()
        wood = "oak_dark" if skirting == "oak_dark" else "stucco" if panel in ("", "stucco") else panel
        for path, closed in plan.wall_runs(name, z0 + 0.1, 0.15):
            shape.add(_run(SKIRTING, path, skirting, z0, closed))
        for path, closed in plan.wall_runs(name, z0 + dado - 0.02, 0.15) if dado else ():  # none over a flight of steps
            shape.add(_run(DADO, path, panel, z0 + dado, closed))
            shape.add(_panels(path, z0, dado, closed, panel))
        if rail:
            for path, closed in plan.wall_runs(name, z0 + rail):
                shape.add(_run(PICTURE_RAIL, path, wood, z0 + rail, closed))
        for path, closed in plan.wall_runs(name, z1 - 0.05):
            shape.add(_run(cornice, path, "stucco", z1, closed))
        scene.mesh("trim_" + name, shape)


def surround_openings():
    """An architrave on both faces of every opening a person walks through upright, and a lining in its thickness."""
    for name, (x0, y0, z0, x1, y1, z1) in plan.OPENINGS.items():
        if z1 - z0 < 1.5:
            continue
        across_x = (x1 - x0) > (y1 - y0)  # the opening is as wide as x, its wall runs along x
        width = (x1 - x0) if across_x else (y1 - y0)
        grand = width > 1.5
        material = {"foyer": "marble_green", "stair": "marble_green", "hall": "gilt", "vestibule": "marble_green"}.get(
            name.split("_")[0], "oak_dark") if grand else "oak_dark"
        shape, height = Shape(), z1 - z0
        path = [(-width / 2, 0.0), (-width / 2, height), (width / 2, height), (width / 2, 0.0)]
        band = sweep(ARCHITRAVE, path, material)
        # the sweep lies flat: stand it up, its thickness to -y, 0.2 m before the wall's middle
        outer = band.mapped(lambda p: (p[0], -0.2 - p[2], p[1]))
        outer = _flip_if_inside_out(outer)
        inner = outer.turned(180)
        shape.add(outer, inner)
        shape.add(_lining(width / 2 - 0.003, height - 0.003, material))
        if grand:
            shape.add(_pediment(width, height, material), _pediment(width, height, material).turned(180))
        shape = shape if across_x else shape.turned(90)
        scene.mesh("surround_" + name, shape, ((x0 + x1) / 2, (y0 + y1) / 2, z0))


def _lining(half, height, material):
    """The jambs and the head of an opening, as deep as its wall."""
    shape = Shape()
    shape.points = [(x, y, z) for y in (-0.2, 0.2) for x, z in ((-half, 0.0), (-half, height), (half, height), (half, 0.0))]
    for i in range(3):
        shape.face([i, i + 4, i + 5, i + 1], material)
    return shape


def _pediment(width, height, material):
    half = width / 2 + 0.24
    ledge = block(-half, -0.34, height + 0.16, half, -0.2, height + 0.24, material, 0.02)
    key = block(-0.11, -0.31, height - 0.02, 0.11, -0.2, height + 0.17, "marble_white" if material != "gilt" else "gilt", 0.02)
    return joined([ledge, key])


def _flip_if_inside_out(shape):
    if signed_volume(shape) < 0:
        shape.faces = [(c[::-1], m, uv[::-1] if uv else None) for c, m, uv in shape.faces]
    return shape


def signed_volume(shape):
    total = 0.0
    for corners, _, _ in shape.faces:
        a = shape.points[corners[0]]
        for i in range(1, len(corners) - 1):
            b, c = shape.points[corners[i]], shape.points[corners[i + 1]]
            total += (a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0]))
    return total / 6.0


def steps_and_ramp():
    rise = plan.HIGH - plan.LOW
    count, tread = 5, 0.34
    for name, x0, x1, top, material in (("stair", -2.6, 2.6, 8.0, "marble_white"), ("west", -13.0, -8.4, 10.6, "oak")):
        shape = Shape()
        landing = 0.6 if name == "stair" else 0.0
        for i in range(count):
            y = top - landing - (count - 1 - i) * tread - (0.0 if landing else tread * 0)
            end = top if i == count - 1 else y + tread
            z = plan.LOW + rise * (i + 1) / count
            if i == count - 1 and not landing:
                continue  # the last riser is the shell's own upper floor
            shape.add(block(x0, y, plan.LOW, x1, end, z, material, 0.018))
        if name == "stair":
            shape.add(block(-0.75, top - landing - (count - 1) * tread - 0.004, 0, 0.75, top, 0.004, "carpet", 0.0))
            for i in range(count):  # the runner
                y = top - landing - (count - 1 - i) * tread
                z = rise * (i + 1) / count
                shape.add(block(-0.75, y - 0.012, z - rise / count, 0.75, y + 0.002, z + 0.008, "carpet", 0.004))
                shape.add(block(-0.75, y - 0.012, z - 0.004, 0.75, top if i == count - 1 else y + tread, z + 0.008, "carpet", 0.004))
        scene.mesh("steps_" + name, shape)
    ramp = Shape()
    y0, y1, x0, x1 = 5.8, 10.6, 8.4, 13.0
    wedge = extruded([(y0, 0.0), (y1, 0.0), (y1, rise)], x0, x1, "oak").mapped(lambda p: (p[2], p[0], p[1]))
    ramp.add(_flip_if_inside_out(wedge))
    for k in range(8):  # laths across, so that a foot (and an eye) feels the slope
        y = y0 + 0.5 + k * 0.55
        z = rise * (y - y0) / (y1 - y0)
        ramp.add(block(x0 + 0.1, y, z - 0.02, x1 - 0.1, y + 0.05, z + 0.014, "brass", 0.005))
    scene.mesh("ramp_east", ramp)


def _beam(path, z, depth, material="stucco"):
    """A beam under a ceiling along a straight plan path, its lower edges cut off."""
    return sweep([(-0.14, z + 0.002), (-0.14, z - depth + 0.05), (-0.09, z - depth), (0.09, z - depth), (0.14, z - depth + 0.05), (0.14, z + 0.002)], path, material)


def joists(name, places, along_x, wood="oak_dark", depth=0.2):
    """Timber beams under a plain ceiling, across the room at each of `places`, which keep it from being a lid."""
    x0, y0, _, x1, y1, z = plan.ROOMS[name][:6]
    paths = [[(x0 + 0.01, p), (x1 - 0.01, p)] if along_x else [(p, y0 + 0.01), (p, y1 - 0.01)] for p in places]
    feet = []
    for (ax, ay), (bx, by) in paths:  # a corbel under either end: beams rest on something
        for (px, py), way in (((ax, ay), 1), ((bx, by), -1)):
            corbel = block(0.0, -0.09, 0.0, 0.24, 0.09, 0.20, wood, 0.0).mapped(lambda p: (p[0] * (0.55 if p[2] < 0.1 else 1.0), p[1], p[2]))
            feet.append(corbel.turned((0 if way > 0 else 180) if along_x else 90 * way).moved(px, py, z - depth - 0.19))
    scene.mesh("joists_" + name, joined([_beam(path, z, depth, wood) for path in paths] + feet))


def coffers(name, xs, ys, z, hole=None):
    """Beams along the plan lines xs and ys under a ceiling, a rosette in every coffer; none over the skylight `hole`."""
    shape = Shape()

    def in_hole(x, y):
        return hole and hole[0] < x < hole[3] and hole[1] < y < hole[4]

    rosette = lathe([(0.0, -0.10), (0.06, -0.09), (0.17, -0.05), (0.21, 0.0)], "gilt", 12,
                    lambda a, k: 1.0 + (0.18 * math.cos(6 * a) if k >= 2 else 0.0))
    for i, x in enumerate(xs):
        for y0, y1 in zip(ys, ys[1:]):
            if not in_hole(x, (y0 + y1) / 2):
                shape.add(_beam([(x, y0 + 0.1), (x, y1 - 0.1)], z, 0.26))
    for j, y in enumerate(ys):
        for x0, x1 in zip(xs, xs[1:]):
            if not in_hole((x0 + x1) / 2, y):
                shape.add(_beam([(x0 - 0.14, y), (x1 + 0.14, y)], z, 0.27))
    for x0, x1 in zip(xs, xs[1:]):
        for y0, y1 in zip(ys, ys[1:]):
            if in_hole((x0 + x1) / 2, (y0 + y1) / 2):
                continue
            inner = [(x0 + 0.14, y0 + 0.14), (x1 - 0.14, y0 + 0.14), (x1 - 0.14, y1 - 0.14), (x0 + 0.14, y1 - 0.14)]
            shape.add(_run([(0.0, -0.20), (0.0, 0.0), (0.16, 0.0), (0.10, -0.10), (0.04, -0.14)], inner, "stucco", z, True))
            shape.add(rosette.moved((x0 + x1) / 2, (y0 + y1) / 2, z - 0.01))
    scene.mesh("coffers_" + name, shape)


def skylights():
    """Glazing bars, panes and, in the closed night above, a dim sky and a moon that throws the bars' shadows."""
    for name, (x0, y0, z0, x1, y1, z1) in plan.SKYLIGHTS.items():
        w, d, z = x1 - x0, y1 - y0, z0 + 0.30
        bars = Shape()
        for i in range(round(w / 0.8) + 1):
            x = x0 + w * i / round(w / 0.8)
            bars.add(block(x - 0.025, y0, z - 0.05, x + 0.025, y1, z - 0.001, "iron", 0.008))
        for j in range(round(d / 0.8) + 1):
            y = y0 + d * j / round(d / 0.8)
            bars.add(block(x0, y - 0.025, z - 0.05, x1, y + 0.025, z - 0.001, "iron", 0.008))
        rim = [(x0, y0), (x1, y0), (x1, y1), (x0, y1)]
        bars.add(sweep([(-0.22, z0 - 0.001), (-0.22, z0 - 0.03), (-0.05, z0 - 0.12), (0.03, z0 - 0.12), (0.03, z0 + 0.1), (0.0, z0 + 0.1),
                        (0.0, z0 - 0.001)], rim, "stucco", True))
        scene.mesh("skylight_" + name, bars)
        scene.mesh("skylight_glass_" + name, block(x0 + 0.005, y0 + 0.005, z, x1 - 0.005, y1 - 0.005, z + 0.012, "pane", 0.0))
        light.moon(name, (x0, y0, z0, x1, y1, z1))


def column(height, radius, shaft="marble_rose", fluted=False):
    """A column with an Attic base, a swelling shaft and a gilded bell capital."""
    base = joined([meshkit.slab(radius * 2.9, radius * 2.9, 0.16, "marble_white", 0.02),
                   lathe([(0.0, 0.16), (radius * 1.38, 0.16), (radius * 1.42, 0.21), (radius * 1.36, 0.26), (radius * 1.18, 0.28),
                          (radius * 1.14, 0.33), (radius * 1.24, 0.38), (radius * 1.02, 0.44), (0.0, 0.44)],
                         "marble_white", 18)])
    top = height - 0.55
    levels = 4
    profile = [(radius * (1.0 + 0.03 * math.sin(math.pi * t) - 0.14 * t * t), 0.44 + (top - 0.44) * t)
               for t in [i / levels for i in range(levels + 1)]]
    grooves = (lambda a, k: 1.0 - 0.055 * abs(math.sin(10 * a))) if fluted else None
    body = lathe(profile, shaft, 40 if fluted else 24, grooves)
    r = radius * 0.86
    bell = lathe([(r, top), (r * 1.10, top + 0.02), (r * 1.10, top + 0.05), (r * 1.0, top + 0.07), (r * 1.04, top + 0.25),
                  (r * 1.25, top + 0.36), (r * 1.55, top + 0.42), (0.0, top + 0.42)], "gilt", 16,
                 lambda a, k: 1.0 + (0.10 * math.cos(8 * a) if 4 <= k <= 6 else 0.0))
    abacus = meshkit.slab(r * 3.1, r * 3.1, 0.13, "marble_white", 0.02, top + 0.42)
    return joined([base, body, bell, abacus])


def pilaster(height, width, material="marble_green", panel="marble_white"):
    """Flat against a wall behind it (at y = 0), standing out to -y."""
    w = width / 2
    return joined([block(-w - 0.05, -0.16, 0, w + 0.05, 0, 0.3, "marble_black", 0.02), block(-w, -0.1, 0.3, w, 0, height - 0.4, material, 0.0),
                   meshkit.raised_panel(-w + 0.07, 0.5, w - 0.07, height - 0.6, -0.1, 0.018, 0.025, panel),
                   block(-w - 0.04, -0.15, height - 0.4, w + 0.04, 0, height - 0.3, "gilt", 0.02),
                   block(-w - 0.08, -0.19, height - 0.3, w + 0.08, 0, height, "gilt", 0.03)])


def ribs(name, places, spring, crown):
    """Flat arches across a long room at each (y, floor) of `places`, on pilaster strips: they break it into bays."""
    x0, _, _, x1, _, z1 = plan.ROOMS[name][:6]
    shape, half, count = Shape(), 0.15, 14
    for y, floor in places:
        arc = []
        for i in range(count + 1):
            t = i / count
            arc.append((x0 + 0.10 + (x1 - x0 - 0.20) * t, spring + (crown - spring) * (1 - (2 * t - 1) ** 2) ** 0.6))
        outline = [(x1 - 0.001, z1 - 0.001), (x0 + 0.001, z1 - 0.001)] + [(x0 + 0.001, spring)] + arc + [(x1 - 0.001, spring)]
        band = extruded(outline, -half, half, "stucco").mapped(lambda p: (p[0], -p[2], p[1])).moved(0, y)
        shape.add(_flip_if_inside_out(band))
        for x, side in ((x0, 1), (x1, -1)):
            a, b = sorted((x, x + side * 0.10))
            c, d = sorted((x, x + side * 0.16))
            shape.add(block(a, y - 0.17, floor, b, y + 0.17, spring, "stucco", 0.0), block(c, y - 0.21, floor, d, y + 0.21, floor + 0.28, "marble_black", 0.02),
                      block(c, y - 0.21, spring - 0.10, d, y + 0.21, spring, "stucco", 0.025), block(c, y - 0.19, spring - 0.20, d - 0.02 * (side > 0), y + 0.19, spring - 0.17, "gilt", 0.0))
    scene.mesh("ribs_" + name, shape)


def low_doorway():
    """Oak round the flue's two mouths, with an iron grille that somebody left leaning beside one."""
    x0, y0, z0, x1, y1, z1 = plan.ROOMS["flue"][:6]
    for x, turn in ((x0, 90), (x1, -90)):
        band = sweep([(out * 0.5, up * 0.6) for out, up in ARCHITRAVE], [(-0.6, 0.0), (-0.6, z1), (0.6, z1), (0.6, 0.0)], "oak_dark")
        band = _flip_if_inside_out(band.mapped(lambda p: (p[0], p[2], p[1])))
        scene.mesh("flue_mouth_" + ("west" if x == x0 else "east"), band, (x, (y0 + y1) / 2, z0), -turn)
    bars = [block(-0.56, -0.012, 0.0, 0.56, 0.012, 0.04, "iron", 0.005), block(-0.56, -0.012, 1.06, 0.56, 0.012, 1.10, "iron", 0.005)]
    bars += [block(-0.56 + 0.14 * i - 0.012, -0.010, 0.03, -0.56 + 0.14 * i + 0.012, 0.010, 1.07, "iron", 0.004) for i in range(9)]
    scene.mesh("flue_grille", joined(bars).turned(-12, "x"), (x0 - 0.27, y1 + 0.75, z0), 90)
