"""How bright a lamp must be. The renderer takes radiance for bulbs and skies (W/m2/sr) and candela for spots; what a
designer knows is how bright a pool on the floor should be. E is irradiance in W/m2: a warm pool is 1.5 to 4,
a patch of moonlight 0.35 to 0.75
(a night's true moon is a thousand times less; this is what the eye makes of it)."""
import math

import meshkit
import palette
import plan
import scene


def ball_radiance(irradiance, distance, radius):
    """A ball of `radius` seen from `distance` lights a facing surface with pi L (radius/distance)^2."""
    return irradiance * distance ** 2 / (math.pi * radius ** 2)


def rect_radiance(irradiance, distance, area):
    """A far rectangle facing the surface: E = L area / distance^2."""
    return irradiance * distance ** 2 / area


def spot_intensity(irradiance, distance):
    """W/sr of a point that lights a facing surface with `irradiance` at `distance`."""
    return irradiance * distance ** 2


def bulb(name, at, irradiance, distance, group, radius=0.04, colour=palette.WARM, on=True):
    """A glowing ball whose light at `distance` is `irradiance`; without a `group` no switch turns it off."""
    material = palette.lamp_material("bulb_" + name, colour, round(ball_radiance(irradiance, distance, radius), 3))
    segments = (12, 8) if radius > 0.06 else (8, 6)  # even numbers: the lamp is the ball that fits its bounds
    return scene.mesh("bulb_" + name, meshkit.ball(radius, material, *segments), at, kind="lamp", shape="sphere",
                      **({"group": group} if group else {}), **off_unless(on))


def off_unless(on):
    """`on` is only written for a lamp that is off to begin with: Blender's exporter makes 1 and 0 of truths."""
    return {} if on else {"on": False}


# where each skylight's moon stands, from the middle of the glass: its patch falls on the other side. The last
# number is E on the floor.
MOONS = {
    "foyer": ((-2.8, -2.0, 6.2), 0.75), "hall": ((2.4, -2.4, 5.8), 0.35), "cabinet": ((-1.6, 1.2, 4.6), 0.35),
    "west_south": ((-1.4, 1.0, 5.4), 0.45), "west_mid": ((-1.6, -1.2, 5.4), 0.45), "west_north": ((-1.6, 1.2, 5.4), 0.45),
    "east_south": ((1.4, 1.0, 5.4), 0.45), "east_mid": ((1.6, -1.2, 5.4), 0.45), "east_north": ((1.6, 1.2, 5.4), 0.45),
}


def moon(name, hole):
    x0, y0, z0, x1, y1, z1 = hole
    middle = ((x0 + x1) / 2, (y0 + y1) / 2, z0 + 0.3)
    (dx, dy, dz), irradiance = MOONS[name]
    at = (middle[0] + dx, middle[1] + dy, middle[2] + dz)
    distance = math.sqrt(dx * dx + dy * dy + (dz + z0 + 0.3) ** 2)
    wide = 2 * math.degrees(math.atan(0.62 * math.hypot(x1 - x0, y1 - y0) / dz)) + 4
    scene.spot("moon_" + name, at, middle, spot_intensity(irradiance, distance), palette.MOON, wide, 0.1)


def sky(name, box, irradiance, floor):
    """A piece of glowing night at the top of the closed space over a skylight, shining down."""
    x0, y0, x1, y1, z = box
    area = (x1 - x0) * (y1 - y0)
    material = palette.lamp_material("sky_" + name, (0.20, 0.40, 1.0), round(rect_radiance(irradiance, z - floor, area), 4))
    shape = meshkit.Shape()
    shape.points = [(x0, y0, z), (x0, y1, z), (x1, y1, z), (x1, y0, z)]
    shape.face([0, 1, 2, 3], material)
    scene.mesh("sky_" + name, shape, kind="lamp", shape="rect")


def skies():
    sky("foyer", (-5.0, -9.0, 5.0, 1.0, 13.9), 0.06, plan.LOW)
    sky("hall", (-5.0, 9.2, 5.0, 17.4, 12.9), 0.05, plan.HIGH)
    sky("cabinet", (-3.0, 19.6, 3.0, 24.4, 10.9), 0.05, plan.HIGH)
    sky("west", (-14.0, -5.5, -8.8, 17.5, 10.9), 0.10, plan.LOW)
    sky("east", (8.8, -5.5, 14.0, 17.5, 10.9), 0.10, plan.LOW)


def stars():
    """A few hundred small glints on the walls and the top of every closed night, the same in every build."""
    import random
    pick = random.Random(9)
    shape = meshkit.Shape()
    for x0, y0, z0, x1, y1, z1 in plan.NIGHTS.values():
        for _ in range(int((x1 - x0) * (y1 - y0) * 0.7) + 24):
            side, r = pick.randrange(4), pick.uniform(0.008, 0.022)
            u, z = pick.random(), z0 + (z1 - z0) * (1 - pick.random() ** 2) * 0.95
            x, y = ((x0 + 0.03, y0 + (y1 - y0) * u), (x1 - 0.03, y0 + (y1 - y0) * u), (x0 + (x1 - x0) * u, y0 + 0.03), (x0 + (x1 - x0) * u, y1 - 0.03))[side]
            a, base = (0, 1, 0) if side < 2 else (1, 0, 0), len(shape.points)
            for du, dz in ((-r, 0), (0, -r), (r, 0), (0, r)):
                shape.points.append((x + a[0] * du, y + a[1] * du, z + dz))
            shape.face([base, base + 1, base + 2, base + 3], "star")
    scene.mesh("stars", shape, kind="glow", layers="light")
