"""The nodes that are not to be seen: named rooms, spawn and exit, the guard's round, the stone, and the cameras."""
import math

import meshkit
import plan
import scene

FLOORS = (plan.LOW, plan.HIGH)

# the guard's round goes through open arches only: stair, Hall, west gallery, foyer and back. (x, y, z, turn, wait, look)
ROUND = [
    ("patrol_foyer_desk", 3.2, -8.6, 0.0, -30, 1.0, False), ("patrol_foyer_east", 6.6, -1.5, 0.0, -90, 2.0, True),
    ("patrol_stair", 0.0, 4.6, 0.0, 0, 0.2, False), ("patrol_hall_south", 0.0, 9.6, 0.8, 0, 1.5, True),
    ("patrol_hall_east", 6.2, 13.0, 0.8, 20, 0.5, False), ("patrol_hall_north", 0.0, 17.2, 0.8, 180, 2.0, True),
    ("patrol_hall_west", -6.6, 15.2, 0.8, 90, 0.2, False), ("patrol_west_north", -10.7, 15.2, 0.8, 180, 1.0, False),
    ("patrol_west_middle", -10.7, 4.6, 0.0, 180, 0.2, False), ("patrol_west_south", -10.7, -1.5, 0.0, -90, 1.0, True),
    ("patrol_foyer_west", -6.2, -1.5, 0.0, -90, 0.2, False), ("patrol_foyer_south", -2.6, -7.7, 0.0, 0, 1.5, True),
]

# name: (from, to, horizontal field of view in degrees)
CAMERAS = {
    "cam_foyer": ((-3.3, -10.4, 1.7), (0.7, -2.4, 2.7), 80), "cam_armillary": ((3.6, -8.3, 1.5), (-0.6, -3.2, 2.6), 70),
    "cam_stair": ((0.9, -0.6, 1.65), (-0.1, 9.0, 2.6), 70), "cam_mirrors": ((6.9, 9.4, 2.5), (-2.6, 15.0, 2.5), 80),
    "cam_mirrors_north": ((-6.4, 16.9, 2.45), (2.2, 11.0, 2.3), 78), "cam_vitrine": ((1.35, 20.3, 2.35), (-0.5, 22.6, 1.65), 72),
    "cam_gallery": ((-9.5, -6.0, 1.65), (-11.2, 6.0, 2.0), 74), "cam_sculpture": ((10.3, -6.1, 1.65), (10.9, 6.0, 1.8), 74),
    "cam_library": ((-4.7, 19.3, 2.45), (-10.5, 23.6, 2.0), 78), "cam_workshop": ((10.9, 18.9, 2.4), (6.6, 23.6, 1.8), 78),
    "cam_vestibule": ((2.4, -11.9, 1.65), (-0.6, -15.4, 1.7), 78), "cam_cloakroom": ((-8.9, -7.6, 1.7), (-13.2, -10.2, 1.0), 84),
    "cam_lodge": ((8.9, -10.5, 1.65), (13.2, -7.8, 1.1), 84), "cam_store": ((3.5, 4.3, 1.5), (7.4, 7.6, 1.0), 84),
    "cam_plan": ((0.0, 4.8, 60.0), (0.0, 4.801, 0.0), 50),
}


def rooms():
    """One empty per titled room; a gallery of two levels is one room."""
    merged = {}
    for name, (x0, y0, z0, x1, y1, z1, *_, title) in plan.ROOMS.items():
        key = name.replace("_north", "")
        if key in merged:
            a = merged[key]
            merged[key] = (min(a[0], x0), min(a[1], y0), min(a[2], z0), max(a[3], x1), max(a[4], y1), max(a[5], z1), a[6])
        else:
            merged[key] = (x0, y0, z0, x1, y1, z1, title)
    for name, (x0, y0, z0, x1, y1, z1, title) in merged.items():
        scene.empty("room_" + name, ((x0 + x1) / 2, (y0 + y1) / 2, (z0 + z1) / 2), kind="room",
                    size=[x1 - x0, z1 - z0, y1 - y0], title=title)


def stone():
    """A pebble: a ball dented by three slow waves, 4 cm across."""
    pebble = meshkit.ball(1.0, "pebble", 10, 6)

    def dent(p):
        s = 0.020 * (1.0 + 0.10 * math.sin(3.1 * p[0] + 1.0) + 0.08 * math.sin(4.3 * p[1] + 2.0 * p[2]) - 0.06 * math.cos(5.0 * p[2]))
        return (p[0] * s * 1.15, p[1] * s * 0.95, p[2] * s * 0.8)

    scene.mesh("stone", pebble.mapped(dent), (-9.0, -7.3, 0.02), smooth_deg=180.0, kind="stone_model")


def place():
    rooms()
    stone()
    scene.empty("spawn", (-12.6, -10.1, 0.0), -65, kind="spawn")
    scene.empty("exit", (0.0, -14.5, 1.2), kind="exit", size=[4.0, 2.4, 1.5])
    for name, x, y, z, turn, wait, look in ROUND:
        scene.empty(name, (x, y, z), turn, kind="patrol", wait_s=wait, look=look)
    scene.empty("guard_1", (-6.2, -1.5, 0.0), -160, kind="guard", patrol=",".join(r[0] for r in ROUND[11:] + ROUND[:11]),
                model="guard", title="Night guard")
    for name, (at, target, fov) in CAMERAS.items():
        scene.camera(name, at, target, fov)
