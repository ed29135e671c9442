"""The Hall's mirrors. Each node holds one flat silvered pane and the gilded frame about it; the pane faces -y when
turned by 0. Fixed ones hang on walls, stand across corners or make screens; two turn on brass feet."""
import math

import meshkit
import plan
import scene
from meshkit import ball, block, joined, lathe, picture, sweep, tube

FRAME = [(0.0, 0.0), (0.0, 0.035), (0.045, 0.07), (0.09, 0.055), (0.13, 0.02), (0.13, 0.0)]


def framed(width, height, material, profile=FRAME, frame="gilt", scale=1.0):
    """A pane of width x height centred on the origin, facing -y, in a mitred frame standing out of it."""
    x, z = width / 2, height / 2
    border = sweep([(-out * scale, up * scale) for out, up in profile], [(-x, -z), (x, -z), (x, z), (-x, z)], frame, True)
    border = border.mapped(lambda p: (p[0], -p[2], p[1]))
    return joined([picture(width, height, material).moved(0, -0.004 * scale), border])


def _crest(width):
    """A small gilded crown for the top of a frame."""
    return joined([block(-0.22, -0.05, 0, 0.22, 0, 0.05, "gilt", 0.015), ball(0.10, "gilt", 12, 6).scaled(1, 0.4, 1).moved(0, -0.02, 0.11),
                   ball(0.06, "gilt", 10, 6).scaled(1.4, 0.4, 0.8).moved(-0.15, -0.02, 0.08), ball(0.06, "gilt", 10, 6).scaled(1.4, 0.4, 0.8).moved(0.15, -0.02, 0.08)])


def hand_mirror(at, turn):
    """One to carry: modelled upright, its pane facing -y, and laid on its back at `at`, its top towards `turn`."""
    width, height = 0.20, 0.22
    body = framed(width, height, "mirror", scale=0.16, frame="brass")
    body.add(block(-width / 2 - 0.016, 0.0, -height / 2 - 0.016, width / 2 + 0.016, 0.010, height / 2 + 0.016, "oak_dark", 0.003),
             lathe([(0.0, -0.27), (0.012, -0.266), (0.015, -0.25), (0.009, -0.235), (0.012, -0.19), (0.014, -0.15), (0.010, -0.118), (0.0, -0.105)], "oak_dark", 14).moved(0, 0.004, 0),
             ball(0.012, "brass", 10, 6).moved(0, 0.0, height / 2 + 0.03))
    node = scene.mesh("hand_mirror", body, at, kind="mirror", carry=True, title="Hand mirror")
    node.rotation_euler = (math.radians(-90.0), 0.0, math.radians(turn))


def hang():
    floor = plan.HIGH
    wall = joined([framed(1.7, 2.9, "mirror"), _crest(1.7).moved(0, 0, 1.57)])
    wall = meshkit.to_mesh(wall, "wall_mirror")
    south, north, west, east = 8.4, 18.2, -8.0, 8.0
    spots = [("south_west", (-4.6, south), 180), ("south_east", (4.6, south), 180),
             ("north_west", (-3.1, north), 0), ("north_far_west", (-5.7, north), 0), ("north_east", (3.1, north), 0), ("north_far_east", (5.7, north), 0),
             ("west", (west, 11.6), 90), ("east", (east, 15.9), -90)]
    for name, (x, y), turn in spots:
        scene.mesh("mirror_" + name, wall, (x, y, floor + 1.85), turn, kind="mirror", title="Mirror")
    corner = meshkit.to_mesh(joined([framed(1.3, 2.6, "mirror"), block(-0.75, -0.02, -1.75, 0.75, 0.06, -1.40, "marble_black", 0.02)]), "corner_mirror")
    for name, x, y, turn in (("sw", west + 0.62, south + 0.62, 135), ("se", east - 0.62, south + 0.62, -135),
                             ("nw", west + 0.62, north - 0.62, 45), ("ne", east - 0.62, north - 0.62, -45)):
        scene.mesh("mirror_corner_" + name, corner, (x, y, floor + 1.75), turn, kind="mirror", title="Corner mirror")
    _screens(floor)
    _turning(floor)


def _screens(floor):
    pane = framed(1.5, 1.9, "mirror", scale=0.8)
    pane.add(block(-0.86, 0.0, -1.05, 0.86, 0.03, 1.05, "oak_dark", 0.005))
    leaf = meshkit.to_mesh(pane, "screen_leaf")
    foot = joined([block(-0.86, -0.16, 0.0, 0.86, 0.16, 0.08, "oak_dark", 0.02), block(-0.9, -0.05, 0.05, -0.84, 0.05, 2.25, "gilt", 0.015),
                   block(0.84, -0.05, 0.05, 0.9, 0.05, 2.25, "gilt", 0.015), ball(0.06, "gilt", 10, 6).moved(-0.87, 0, 2.30), ball(0.06, "gilt", 10, 6).moved(0.87, 0, 2.30)])
    foot = meshkit.to_mesh(foot, "screen_foot")
    for name, x, y, turn in (("a", -4.6, 14.0, 30), ("b", 4.4, 11.2, 35), ("c", -4.2, 10.6, -50)):
        scene.mesh(f"screen_{name}", foot, (x, y, floor), turn)
        scene.mesh(f"mirror_screen_{name}_front", leaf, *_set_off(x, y, floor + 1.16, turn), kind="mirror", title="Mirror screen")
        scene.mesh(f"mirror_screen_{name}_back", leaf, *_set_off(x, y, floor + 1.16, turn + 180), kind="mirror", title="Mirror screen")


def _set_off(x, y, z, turn):
    """The place and turn of a leaf that faces the direction of `turn`, just clear of its twin's back."""
    a = math.radians(turn)
    return (x + math.sin(a) * 0.031, y - math.cos(a) * 0.031, z), turn


def _turning(floor):
    pane = framed(0.95, 1.7, "mirror", scale=0.7, frame="brass").moved(0, 0, 1.22)
    pane.add(block(-0.53, 0.002, 0.32, 0.53, 0.03, 2.12, "oak_dark", 0.008),
             lathe([(0.0, 0.0), (0.36, 0.0), (0.36, 0.03), (0.22, 0.07), (0.06, 0.12), (0.045, 0.22), (0.07, 0.26), (0.05, 0.34), (0.0, 0.34)], "brass", 24),
             ball(0.05, "brass", 14, 8).moved(0, 0.015, 2.17))
    pane.add(tube([(-0.52, 0.02, 0.9), (-0.62, 0.02, 0.9), (-0.62, 0.02, 1.2), (-0.52, 0.02, 1.2)], 0.016, "brass", 6))
    mesh = meshkit.to_mesh(pane, "turning_mirror")
    scene.mesh("mirror_turn_a", mesh, (-2.3, 9.9, floor), -135, kind="mirror", turn_step_deg=22.5, title="Turning mirror")
    scene.mesh("mirror_turn_b", mesh, (2.6, 16.2, floor), 45, kind="mirror", turn_step_deg=22.5, title="Turning mirror")
