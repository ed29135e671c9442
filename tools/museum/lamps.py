"""Lamps one can see burn: a bulb, a brass shade whose white inside glows, and something that holds it. Every
fixture belongs to a switch's group; `pool` is the irradiance it gives at `reach` metres."""
import math

import light
import meshkit
import palette
import scene
from meshkit import ball, block, joined, lathe, tube


def _shade(r0, r1, height, outside="brass"):
    """An open cone of thin metal, its mouth (radius r1) at z = 0, and apart from it the lit inside."""
    t = 0.004
    metal = lathe([(r1, 0.0), (r1 + t, 0.002), ((r0 + r1) * 0.5 + t + 0.01, height * 0.6), (r0 + t, height), (0.0, height + 0.012)], outside, 18)
    inside = lathe([(0.0, height - 0.002), (r0, height - 0.006), ((r0 + r1) * 0.5 + 0.01, height * 0.6), (r1, 0.0)], "enamel_lit", 18)
    return metal, inside


_shared = {}


def begin():
    _shared.clear()


def _fixture(kind, make):
    if kind not in _shared:
        metal, inside = make()
        _shared[kind] = (meshkit.to_mesh(metal, "lamp_" + kind), meshkit.to_mesh(inside, "glow_" + kind) if inside else None)
    return _shared[kind]


def _place(kind, make, name, at, turn, group, on):
    metal, inside = _fixture(kind, make)
    scene.mesh(f"{kind}_{name}", metal, at, turn)
    if inside:
        scene.mesh(f"shade_{name}", inside, at, turn, kind="glow", group=group, **light.off_unless(on))


def pendant(name, at, ceiling, group, pool=2.5, reach=3.0, on=True):
    """Hangs from `ceiling` on a rod; `at` is the middle of its mouth."""
    drop = ceiling - at[2]

    def make():
        metal, inside = _shade(0.05, 0.24, 0.17)
        metal.add(tube([(0, 0, 0.17), (0, 0, drop - 0.02)], 0.012, "brass", 6), ball(0.03, "brass", 10, 6).moved(0, 0, 0.20),
                  lathe([(0.0, drop - 0.06), (0.03, drop - 0.055), (0.075, drop - 0.01), (0.075, drop), (0.0, drop)], "brass", 16),
                  lathe([(0.246, -0.004), (0.252, 0.0), (0.246, 0.008), (0.238, 0.004), (0.246, -0.004)], "brass", 18))
        return metal, inside

    _place(f"pendant{round(drop * 100)}", make, name, at, 0, group, on)
    light.bulb(name, (at[0], at[1], at[2] + 0.06), pool, reach, group, on=on)


# metres from the wall to the bulb: a wall is brighter by the square of its nearness, and burns out at half of this
SCONCE_ARM = 0.28


def sconce(name, at, turn, group, pool=1.2, reach=2.5, on=True):
    """On a wall that faces -y when turned by 0: a scrolled arm and a shade open downwards and a little upwards."""
    def make():
        arm = [(0, -0.02, 0.0), (0, -0.08, -0.06), (0, -0.19, -0.085), (0, -0.27, -0.03), (0, -SCONCE_ARM, 0.05), (0, -SCONCE_ARM, 0.10)]
        metal = joined([lathe([(0.0, 0.0), (0.06, 0.0), (0.055, 0.015), (0.03, 0.03), (0.0, 0.035)], "brass", 12).scaled(1, 1.6, 1).turned(90, "x"),
                        tube(arm, 0.012, "brass", 6)])
        cone, inside = _shade(0.045, 0.12, 0.15)
        metal.add(cone.moved(0, -SCONCE_ARM, -0.02))
        return metal, inside.moved(0, -SCONCE_ARM, -0.02)

    _place("sconce", make, name, at, turn, group, on)
    a = math.radians(turn)
    light.bulb(name, (at[0] + SCONCE_ARM * math.sin(a), at[1] - SCONCE_ARM * math.cos(a), at[2] + 0.03), pool, reach, group, 0.03, on=on)


def table_lamp(name, at, turn, group, pool=2.0, reach=1.0, on=True):
    """A banker's lamp standing on `at`: brass foot, green enamel trough."""
    def make():
        metal = joined([lathe([(0.0, 0.0), (0.10, 0.0), (0.10, 0.015), (0.06, 0.03), (0.015, 0.045), (0.012, 0.30), (0.02, 0.32), (0.0, 0.34)], "brass", 16),
                        tube([(-0.15, 0, 0.34), (0.15, 0, 0.34)], 0.007, "brass", 8), ball(0.016, "brass", 8, 5).moved(0, 0, 0.40)])
        outer, inner = [], []
        for i in range(9):
            a = math.pi * (i / 8.0)
            outer.append((0.085 * math.cos(a), 0.30 + 0.09 * math.sin(a)))
        for (y0, z0), (y1, z1) in zip(outer, outer[1:]):
            inner.append(((y0 * 0.96, z0), (y1 * 0.96, z1)))
        trough, lit = meshkit.Shape(), meshkit.Shape()
        for i, (y, z) in enumerate(outer):
            trough.points += [(-0.17, y, z), (0.17, y, z)]
            lit.points += [(-0.168, y * 0.96, z * 1.0 - 0.003 * (z > 0.31)), (0.168, y * 0.96, z * 1.0 - 0.003 * (z > 0.31))]
        for i in range(8):
            trough.face([2 * i, 2 * i + 2, 2 * i + 3, 2 * i + 1], "enamel_green")
            lit.face([2 * i, 2 * i + 1, 2 * i + 3, 2 * i + 2], "enamel_lit")
        for end in (0, 1):
            trough.face([2 * i + end for i in (range(9) if end else reversed(range(9)))], "enamel_green")
        return metal.add(trough), lit

    _place("table_lamp", make, name, at, turn, group, on)
    light.bulb(name, (at[0], at[1], at[2] + 0.335), pool, reach, group, 0.025, on=on)


def lantern(name, at, ceiling, group, pool=1.2, reach=3.0, on=True):
    """An opal globe in a brass cage: it lights the ceiling too."""
    drop = ceiling - at[2]

    def make():
        ring = [(0.155 * math.cos(i * math.pi / 12), 0.155 * math.sin(i * math.pi / 12), 0) for i in range(24)]
        metal = joined([tube(ring, 0.012, "brass", 6, True), tube([(0, 0, 0.19), (0, 0, drop)], 0.010, "brass", 8),
                        lathe([(0.0, 0.12), (0.08, 0.125), (0.06, 0.16), (0.02, 0.19), (0.0, 0.2)], "brass", 16),
                        lathe([(0.0, -0.21), (0.012, -0.20), (0.02, -0.17), (0.05, -0.14), (0.0, -0.135)], "brass", 12),
                        lathe([(0.0, drop - 0.06), (0.03, drop - 0.055), (0.075, drop - 0.01), (0.075, drop), (0.0, drop)], "brass", 16)])
        for k in range(4):
            a = math.pi / 2 * k
            bow = [(0.16 * math.sin(t) * math.cos(a), 0.16 * math.sin(t) * math.sin(a), 0.16 * math.cos(t)) for t in [math.pi * j / 8 for j in range(1, 8)]]
            metal.add(tube(bow, 0.010, "brass", 5))
        return metal, None

    _place(f"lantern{round(drop * 100)}", make, name, at, 0, group, on)
    light.bulb(name, at, pool, reach, group, 0.13, on=on)


def chandelier(name, at, ceiling, group, pool=2.0, reach=4.0):
    """A great ring of brass arms with candle bulbs round one opal globe. The globe is the lamp, the candles glow."""
    drop = ceiling - at[2]
    big = [(0.95 * math.cos(i * math.pi / 18), 0.95 * math.sin(i * math.pi / 18), -0.05) for i in range(36)]
    small = [(0.5 * math.cos(i * math.pi / 12), 0.5 * math.sin(i * math.pi / 12), 0.35) for i in range(24)]
    metal = joined([tube(big, 0.030, "brass", 8, True), tube(small, 0.022, "brass", 6, True), tube([(0, 0, 0.2), (0, 0, drop)], 0.018, "brass", 8),
                    lathe([(0.0, 0.19), (0.09, 0.2), (0.12, 0.26), (0.05, 0.34), (0.04, 0.5), (0.09, 0.56), (0.03, 0.66), (0.0, 0.66)], "brass", 20),
                    lathe([(0.0, drop - 0.12), (0.06, drop - 0.11), (0.2, drop - 0.02), (0.2, drop), (0.0, drop)], "brass", 20)])
    candles = meshkit.Shape()
    for ring, count, z in ((0.95, 12, -0.05), (0.5, 6, 0.35)):
        for i in range(count):
            a = 2 * math.pi * i / count
            x, y = ring * math.cos(a), ring * math.sin(a)
            metal.add(tube([(0.07 * math.cos(a), 0.07 * math.sin(a), 0.28 if ring > 0.6 else 0.5), (x * 0.5, y * 0.5, z - 0.02 if ring > 0.6 else z + 0.02), (x, y, z)], 0.015, "brass", 5),
                      lathe([(0.0, z + 0.02), (0.06, z + 0.045), (0.018, z + 0.055), (0.016, z + 0.16), (0.0, z + 0.16)], "gilt", 8).moved(x, y))
            candles.add(lathe([(0.0, z + 0.16), (0.018, z + 0.185), (0.014, z + 0.22), (0.0, z + 0.255)], "candle", 6).moved(x, y))
    palette.MATERIALS["candle"] = palette._m("glass", (0, 0, 0), 1.0, glow=(palette.WARM, 9.0))
    scene.mesh("chandelier_" + name, metal, at)
    scene.mesh("candles_" + name, candles, at, kind="glow", group=group)
    light.bulb(name, at, pool, reach, group, 0.17)


def picture_light(name, at, turn, width, height, group, pool=1.6):
    """A brass tube on two arms over a picture (its middle `at`, on the wall), and the beam that falls down its face."""
    top, half = height / 2 + 0.20, width * 0.28
    metal = joined([tube([(-half, -0.26, top), (half, -0.26, top)], 0.030, "brass", 12)] +
                   [tube([(x, 0.0, top - 0.16), (x, -0.16, top - 0.02), (x, -0.26, top)], 0.008, "brass", 6) for x in (-half * 0.6, half * 0.6)])
    lit = block(-half * 0.92, -0.262, top - 0.034, half * 0.92, -0.242, top - 0.0285, "enamel_lit", 0.0)
    scene.mesh("picture_light_" + name, metal, at, turn)
    scene.mesh("shade_picture_" + name, lit, at, turn, kind="glow", group=group)
    a = math.radians(turn)

    def out(distance, z):
        return (at[0] + distance * math.sin(a), at[1] - distance * math.cos(a), at[2] + z)

    # from further out than the tube, as if through its reflector: a point so near the wall would burn a hole in the picture
    scene.spot("spot_picture_" + name, out(1.3, top + 0.75), out(0.0, -0.10), light.spot_intensity(pool, 1.9), palette.WARM,
               math.degrees(2 * math.atan(0.62 * max(width, height) / 1.9)), 0.5, kind="lamp", group=group)


def spot_can(name, at, target, group, pool, cone_deg):
    """A small brass theatre lamp on a ceiling track, whose beam is a spot."""
    can = joined([lathe([(0.0, 0.12), (0.05, 0.12), (0.065, 0.09), (0.065, -0.08), (0.07, -0.085), (0.07, -0.10), (0.062, -0.10)], "brass", 20),
                  tube([(0, 0, 0.1), (0, 0, 0.32)], 0.012, "brass", 8)])
    face = lathe([(0.0, -0.07), (0.06, -0.07)], "enamel_lit", 20)
    d = [t - a for t, a in zip(target, at)]
    tilt = math.degrees(math.atan2(math.hypot(d[0], d[1]), -d[2]))
    heading = math.degrees(math.atan2(-d[0], d[1]))
    turned = can.turned(tilt, "x").turned(heading)
    scene.mesh("can_" + name, turned, at)
    scene.mesh("shade_" + name, face.turned(tilt, "x").turned(heading), at, kind="glow", group=group)
    length = math.sqrt(sum(c * c for c in d))
    start = tuple(a + c / length * 0.11 for a, c in zip(at, d))
    scene.spot("spot_" + name, start, target, light.spot_intensity(pool, length), palette.WARM, cone_deg, 0.3,
               kind="lamp", group=group)
