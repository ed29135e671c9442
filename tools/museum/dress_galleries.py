"""The two long galleries: pictures in the west, sculpture in the east."""
import bpy

import doors
import furniture as f
import lamps
import meshkit
import mouldings
import scene
import statues
from dress_entrance import BUSTS


SOUTH_RIBS, NORTH_RIBS = [(y, 0.0) for y in (-5.3, 0.3, 2.6, 6.9, 9.0)], [(y, 0.8) for y in (11.6, 16.8)]


def west():
    x = -13.0
    row = [(-3.95, "glen", 1.7), (-1.2, "lady", 1.15), (1.45, "forest", 1.15), (3.65, "scholar", 1.1), (5.6, "spheres", 1.7), (7.95, "founder", 1.05)]
    for i, (y, art, width) in enumerate(row):
        size = f.hang_picture(f"west_{i}", art, (x, y, 2.15), 90, width)
        if i in (1, 4):
            lamps.picture_light(f"west_{i}", (x, y, 2.15), 90, *size, "west", 2.8)
    for i, (y, art, width) in enumerate([(12.9, "moonrise", 1.9), (15.4, "rainbow", 1.6)]):
        size = f.hang_picture(f"west_n{i}", art, (x, y, 2.7), 90, width)
        if i == 0:
            lamps.picture_light("west_n0", (x, y, 2.7), 90, *size, "west_north", 2.8)
    for i, (y, art, width, z) in enumerate([(1.45, "prism", 1.6, 2.15), (3.8, "alps", 1.5, 2.2), (7.95, "optician", 1.05, 2.15), (13.0, "dusk", 1.5, 2.7)]):
        f.hang_picture(f"west_e{i}", art, (-8.4, y, z), -90, width)
    bench = meshkit.to_mesh(f.bench(2.0), "gallery_bench")
    for i, y in enumerate((-3.6, 2.0, 6.6)):
        scene.mesh(f"west_bench_{i}", bench, (-10.7, y, 0.0), 90)
    scene.mesh("west_bench_n", bench, (-10.7, 13.2, 0.8), 90)
    scene.mesh("west_ropes", f.rope_posts([(-12.1, -4.9), (-12.1, -3.0), (-12.1, -1.2), (-12.1, 0.6)]))
    scene.mesh("west_ropes_mid", f.rope_posts([(-12.1, 4.6), (-12.1, 6.4)]))
    tall = meshkit.to_mesh(statues.plinth(0.5, 1.15, "marble_white"), "west_plinth")
    for i, (px, py, pz, turn, who) in enumerate(((-8.97, -5.3, 0, -90, "sage"), (-8.97, 2.6, 0, -90, "muse"), (-12.43, 9.0, 0, 90, "muse"),
                                                 (-12.43, 16.8, 0.8, 90, "muse"), (-8.97, 11.6, 0.8, -90, "sage"))):
        scene.mesh(f"west_plinth_{i}", tall, (px, py, pz), turn)
        scene.mesh(f"west_bust_{i}", BUSTS[who](), (px, py, pz + 1.15), turn)
    mouldings.ribs("west_gallery", SOUTH_RIBS + NORTH_RIBS, 3.75, 4.38)
    lamps.pendant("west_south", (-10.7, -5.9, 3.0), 4.6, "west", 2.4, 3.0)
    lamps.sconce("west_arch", (-8.4, -3.4, 2.3), -90, "west", 1.6, 2.3)
    lamps.pendant("west_middle", (-10.7, 7.9, 3.1), 4.6, "west", 3.0, 3.1)
    lamps.sconce("west_hall", (-8.4, 17.5, 3.0), -90, "west_north", 1.8, 2.2)
    doors.switch("west", (-8.4, 0.0, 1.25), -90, "west", "Gallery lamps")
    doors.switch("west_north", (-8.4, 13.75, 2.05), -90, "west_north", "North gallery lamps")


def east():
    plinth = meshkit.to_mesh(statues.plinth(0.72, 0.9, "marble_white"), "east_plinth")
    made = {"urn": meshkit.to_mesh(statues.urn(1.0), "east_urn", 60), "obelisk": meshkit.to_mesh(statues.obelisk(1.7), "east_obelisk"),
            "sage": BUSTS["sage"](), "muse": BUSTS["muse"]()}
    for i, (x, y, z, n) in enumerate(((12.3, -3.6, 0, "sage"), (12.3, -0.9, 0, "urn"), (12.3, 4.6, 0, "muse"), (9.2, 1.8, 0, "obelisk"), (9.2, -4.0, 0, "urn"),
                                      (12.3, 13.2, .8, "urn"), (12.3, 15.4, .8, "sage"), (9.2, 15.4, .8, "obelisk"))):
        scene.mesh(f"east_plinth_{i}", plinth, (x, y, z))
        scene.mesh(f"east_{n}_{i}", made[n], (x, y, z + 0.9), -90 if x > 11 else 90)
    scene.mesh("lady_plinth_north", bpy.data.meshes["lady_plinth"], (12.2, 17.45, 0.8))
    scene.mesh("lady_north", bpy.data.meshes["lady"], (12.2, 17.45, 1.55), -30)
    scene.mesh("lady_lens_north", bpy.data.meshes["lady_lens"], (12.2, 17.45, 1.55), -30)
    glass, frame = statues.giant_lens(0.8)
    scene.mesh("giant_lens_frame", frame, (10.7, 1.3, 0), 20)
    scene.mesh("giant_lens_glass", glass, (10.7, 1.3, 0), 20)
    bench = meshkit.to_mesh(f.bench(1.8), "east_bench")
    scene.mesh("east_bench_0", bench, (10.7, -3.0, 0), 90)
    scene.mesh("east_bench_1", bench, (10.7, 13.8, 0.8), 90)
    mouldings.ribs("east_gallery", [r for r in SOUTH_RIBS if r[0] < 6.0] + [(9.0, 0.0)] + NORTH_RIBS, 3.75, 4.38)
    f.hang_picture("east_0", "lighthouse", (13.0, 7.6, 2.5), -90, 1.9)
    lamps.sconce("east_south", (13.0, -2.3, 2.3), -90, "east", 2.2, 2.3)
    lamps.sconce("east_ramp", (8.4, 7.9, 2.6), 90, "east", 2.2, 2.3)
    # a statue is its shadows: one beam from high on one side for each landmark
    for name, at, target, pool, cone, group in (("sage", (9.9, -5.0, 4.0), (12.3, -3.6, 1.35), 5.0, 28, "east"), ("muse", (9.9, 3.4, 4.0), (12.3, 4.6, 1.35), 5.0, 28, "east"),
                                                ("lens", (9.2, -1.2, 4.1), (10.5, 1.4, 1.2), 4.0, 36, "east"), ("lady_north", (10.4, 15.6, 4.2), (12.2, 17.45, 2.5), 5.0, 36, "east_north")):
        lamps.spot_can(name, at, target, group, pool, cone)
    lamps.pendant("east_north", (10.7, 16.0, 3.6), 4.6, "east_north", 3.4, 2.8)
    doors.switch("east", (8.4, -0.1, 1.25), 90, "east", "Sculpture lamps")
    doors.switch("east_north", (8.4, 14.0, 2.05), 90, "east_north", "North gallery lamp")


def dress():
    west()
    east()
