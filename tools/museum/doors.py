"""Doors: panelled oak leaves that turn about their hinges, with handles on both faces, and the lamp switches beside
them. A leaf is modelled from its hinge along +x; it stands 1 cm off the floor."""
import meshkit
import plan
import scene
import signs
from meshkit import ball, block, joined, lathe, tube

THICK = 0.05

# a right angle and no more: hinged in the middle of the wall, a leaf turned further would sink into the jamb
# node: (opening, hinge's end "low" or "high" along the wall, share of the width, open angle, wood, title)
LEAVES = {
    "door_cloakroom": ("cloakroom_foyer", "low", 1.0, -90, "oak", "Cloakroom door"),
    "door_cloakroom_west": ("cloakroom_west", "low", 1.0, 90, "oak", "Gallery of Painters"),
    "door_lodge": ("lodge_foyer", "low", 1.0, 90, "oak", "Porter's lodge"),
    "door_lodge_east": ("lodge_east", "high", 1.0, -90, "oak", "Sculpture Gallery"),
    "door_vestibule_left": ("vestibule_foyer", "low", 0.5, 90, "oak_dark", "Vestibule"),
    "door_vestibule_right": ("vestibule_foyer", "high", 0.5, -90, "oak_dark", "Vestibule"),
    "door_store": ("store_east", "low", 1.0, 90, "iron_green", "Lamp store"),
    "door_hall_east_left": ("hall_east", "low", 0.5, -90, "oak_dark", "Hall of Mirrors"),
    "door_hall_east_right": ("hall_east", "high", 0.5, 90, "oak_dark", "Hall of Mirrors"),
    "door_cabinet_left": ("hall_cabinet", "low", 0.5, 90, "oak_dark", "Lens Cabinet"),
    "door_cabinet_right": ("hall_cabinet", "high", 0.5, -90, "oak_dark", "Lens Cabinet"),
    "door_cabinet_library": ("cabinet_library", "high", 1.0, -90, "oak_dark", "Reading Room"),
    "door_cabinet_workshop": ("cabinet_workshop", "low", 1.0, -90, "oak_dark", "Workshop"),
    "door_workshop_east": ("workshop_east", "high", 1.0, 90, "oak", "Workshop"),
}


def leaf(width, height, wood, handed):
    """`handed` +1: hinge at x = 0 and the leaf along +x; -1: along -x."""
    w, h, t = width - 0.012, height - 0.02, THICK / 2
    core = block(0.006, -t + 0.012, 0.01, w, t - 0.012, h, wood, 0.004)
    parts = [core]
    for x0, x1, z0, z1 in ((0.006, 0.14, 0.01, h), (w - 0.134, w, 0.01, h), (0.14, w - 0.134, 0.01, 0.26),
                           (0.14, w - 0.134, h - 0.16, h), (0.14, w - 0.134, 0.94, 1.10)):
        parts.append(block(x0, -t, z0, x1, t, z1, wood, 0.007))
    for z0, z1 in ((0.30, 0.90), (1.14, h - 0.20)):
        face = meshkit.raised_panel(0.18, z0, w - 0.174, z1, -t + 0.012, 0.010, 0.03, wood)
        parts += [face, face.mapped(lambda p: (w + 0.006 - p[0], -p[1], p[2]))]
    knob_x = w - 0.068
    for side in (-1, 1):
        rose = lathe([(0.032, 0.0), (0.026, 0.010), (0.011, 0.014), (0.012, 0.042), (0.031, 0.062), (0.024, 0.082), (0.0, 0.088)], "brass", 8).turned(-90 * side, "x")
        parts.append(rose.moved(knob_x, side * t, 1.02))
        parts.append(block(knob_x - 0.035, side * t - 0.004, 0.86, knob_x + 0.035, side * t + 0.004, 1.12, "brass", 0.003))
        parts.append(block(0.10, side * t - 0.003, 0.03, w - 0.10, side * t + 0.003, 0.20, "brass", 0.002))
    for z in (0.25, 1.05, h - 0.25):
        parts.append(lathe([(0.0, z - 0.05), (0.012, z - 0.05), (0.012, z + 0.05), (0.0, z + 0.05)], "brass", 6))
    shape = joined(parts)
    return shape if handed > 0 else shape.turned(180)


def hang():
    made = {}
    for node, (opening, end, share, angle, wood, title) in LEAVES.items():
        x0, y0, z0, x1, y1, z1 = plan.OPENINGS[opening]
        along_x = (x1 - x0) > (y1 - y0)
        length = (x1 - x0) if along_x else (y1 - y0)
        handed = 1 if end == "low" else -1
        key = (round(length * share, 3), round(z1 - z0, 3), wood, handed)
        if key not in made:
            made[key] = meshkit.to_mesh(leaf(*key), node)
        if along_x:
            at, turn = ((x0 if end == "low" else x1), (y0 + y1) / 2, z0), 0
        else:
            at, turn = ((x0 + x1) / 2, (y0 if end == "low" else y1), z0), 90
        scene.mesh(node, made[key], at, turn, kind="door", open_angle_deg=float(angle), open_time_s=0.9, title=title)


def switch(name, at, turn_deg, group, title):
    """A brass plate with a porcelain-tipped lever, on a wall that faces -y when turned by 0."""
    plate = block(-0.045, -0.012, -0.07, 0.045, 0.0, 0.07, "brass", 0.006)
    collar = lathe([(0.0, 0.0), (0.022, 0.0), (0.020, 0.012), (0.0, 0.014)], "brass", 14).turned(90, "x").moved(0, -0.012, 0)
    lever = tube([(0, -0.02, 0.0), (0, -0.05, 0.018)], 0.006, "brass", 8)
    tip = ball(0.011, "marble_white", 6, 4).moved(0, -0.055, 0.021)
    scene.mesh("switch_" + name, joined([plate, collar, lever, tip]), at, turn_deg, kind="switch", group=group, title=title)


def front_door():
    """The museum's closed street door behind the exit, with a lit sign over it."""
    x, y, h = 1.3, -15.4, 3.0
    shape = joined([block(-x - 0.2, y, 0, -x, y + 0.16, h + 0.2, "marble_green", 0.02), block(x, y, 0, x + 0.2, y + 0.16, h + 0.2, "marble_green", 0.02),
                    block(-x - 0.3, y, h, x + 0.3, y + 0.22, h + 0.24, "marble_green", 0.03)])
    for side in (-1, 1):
        door = leaf(1.3, h, "oak_dark", 1).moved(0, y + 0.06, 0)
        shape.add(door.moved(-1.3) if side < 0 else leaf(1.3, h, "oak_dark", -1).moved(1.3, y + 0.06, 0))
    for z in (0.6, 1.6, 2.5):
        shape.add(block(-x + 0.05, y + 0.085, z, x - 0.05, y + 0.1, z + 0.05, "iron", 0.004))
    scene.mesh("street_door", shape)
    signs.exit_sign("street", (0.0, y + 0.2, h + 0.43), 180, width=0.6)
