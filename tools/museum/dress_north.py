"""The Hall of Mirrors, the Lens Cabinet with its vitrine, the reading room and the workshop."""
import bpy

import doors
import furniture as f
import instruments
import lamps
import light
import meshkit
import mirrors
import mouldings
import plan
import scene
import signs
import statues
import workshop_things as things
from meshkit import joined, lathe, slab, sweep, tube

Z = plan.HIGH


def hall():
    mirrors.hang()
    scene.mesh("settee", f.settee(), (0, 13.2, Z))
    pilaster = meshkit.to_mesh(mouldings.pilaster(4.95, 0.5, "marble_rose", "marble_black"), "pilaster")
    n = 0
    for y, turn in ((8.4, 180), (18.2, 0)):
        for x in (-7.2, -4.4, -1.85, 1.85, 4.4, 7.2) if turn == 0 else (-7.2, -6.0, -3.1, -1.9, 1.9, 3.1, 6.0, 7.2):
            n += 1
            scene.mesh(f"pilaster_{n}", pilaster, (x, y, Z), turn)
    for x, turn in ((-8.0, 90), (8.0, -90)):
        for y in (9.8, 13.2, 17.2) if x < 0 else (9.9, 14.2, 17.5):
            n += 1
            scene.mesh(f"pilaster_{n}", pilaster, (x, y, Z), turn)
    _gilt_panels()
    stand = meshkit.to_mesh(instruments.torchere(), "torchere")
    for name, x in (("hall_nw", -1.55), ("hall_ne", 1.55)):
        scene.mesh("torchere_" + name, stand, (x, 17.75, Z))
        light.bulb(name, (x, 17.75, Z + 2.03), 0.8, 2.0, "hall_sconces", 0.11)
    lamps.chandelier("hall", (0, 13.2, 4.4), 6.8, "hall", 1.5, 3.6)
    for name, x, y, turn in (("hall_sw", -1.85, 8.5, 180), ("hall_e", 7.9, 14.2, -90)):
        lamps.sconce(name, (x, y, Z + 2.2), turn, "hall_sconces", 0.9, 2.3)
    doors.switch("hall", (2.5, 8.4, Z + 1.25), 180, "hall", "Chandelier")
    doors.switch("hall_sconces", (-2.5, 8.4, Z + 1.25), 180, "hall_sconces", "Hall sconces")
    mouldings.coffers("hall", [-7.86, -5.2, -2.64, 2.64, 5.2, 7.86], [8.54, 11.06, 15.34, 18.06], 6.2, plan.SKYLIGHTS["hall"])
    bench = meshkit.to_mesh(f.bench(1.6), "hall_bench")
    scene.mesh("hall_bench_e", bench, (6.0, 9.6, Z), 0)
    scene.mesh("hall_bench_w", bench, (-7.3, 12.9, Z), 90)


def _gilt_panels():
    """Thin gilded mouldings on the silk between the pilasters and over the mirrors."""
    bead = [(0.0, 0.0), (0.0, 0.014), (0.04, 0.034), (0.08, 0.014), (0.08, 0.0)]
    for i, (x, y, turn, w, z0, z1) in enumerate(((-6.6, 8.4, 180, 0.7, 1.0, 4.6), (6.6, 8.4, 180, 0.7, 1.0, 4.6), (8.0, 10.75, -90, 0.9, 1.0, 4.6))):
        frame = sweep(bead, [(-w / 2, z0), (w / 2, z0), (w / 2, z1), (-w / 2, z1)], "gilt", True).mapped(lambda p: (p[0], -p[2], p[1]))
        scene.mesh(f"gilt_panel_{i}", frame, (x, y, Z), turn)


def cabinet():
    top = f.vitrine("vitrine", (0.0, 22.0, Z), 0.0)
    ring = lathe([(0.112, -0.016), (0.122, -0.016), (0.126, 0.0), (0.122, 0.016), (0.112, 0.016), (0.112, -0.016)], "gilt", 40)
    glass = statues.biconvex(0.1115, 0.045, 0.012, "lens_glass", 40, 6)
    scene.mesh("lens_of_the_hall", joined([glass, ring]).turned(-38, "x"), (0.0, 22.0, top + 0.105), kind="lens", title="The Founder's Lens")
    stand = joined([tube([(-0.126, 0, 0.0), (-0.10, 0, -0.06), (0, 0, -0.085), (0.10, 0, -0.06), (0.126, 0, 0.0)], 0.006, "brass", 8),
                    lathe([(0.0, -0.105), (0.06, -0.105), (0.05, -0.095), (0.012, -0.088), (0.0, -0.08)], "brass", 20)])
    scene.mesh("lens_stand", stand, (0.0, 22.0, top + 0.105))
    scene.mesh("vitrine_ropes", f.rope_posts([(-1.5, 20.9), (-1.5, 23.2), (1.5, 23.2), (1.5, 20.9)]), (0, 0, Z))
    scene.mesh("cabinet_rug", slab(3.6, 3.2, 0.012, "carpet", 0.004, 0.001), (0, 22.0, Z))
    lamps.spot_can("vitrine", (0.0, 20.1, 4.55), (0.0, 22.0, 1.75), "cabinet", 14.0, 24)
    lamps.lantern("cabinet", (0.0, 24.1, 4.0), 4.93, "cabinet", 1.2, 2.6)
    lamps.sconce("cabinet_w", (-3.6, 23.6, Z + 2.1), 90, "cabinet", 1.8, 2.3)
    doors.switch("cabinet", (-1.95, 18.6, Z + 1.25), 180, "cabinet", "Cabinet lamps")
    plinth, urn = meshkit.to_mesh(statues.plinth(0.5, 1.0, "marble_green"), "cabinet_plinth"), meshkit.to_mesh(statues.urn(0.75, "marble_rose"), "cabinet_urn")
    for i, (x, y) in enumerate(((-2.9, 24.3), (2.9, 24.3), (-2.9, 19.3))):
        scene.mesh(f"cabinet_plinth_{i}", plinth, (x, y, Z))
        scene.mesh(f"cabinet_urn_{i}", urn, (x, y, Z + 1.0))
    size = f.hang_picture("cabinet", "prism", (0.0, 25.0, Z + 2.0), 0, 2.0)
    lamps.picture_light("cabinet", (0.0, 25.0, Z + 2.0), 0, *size, "cabinet", 1.8)
    mouldings.coffers("cabinet", [-3.46, -1.34, 1.34, 3.46], [18.74, 20.46, 23.14, 24.86], 5.2, plan.SKYLIGHTS["cabinet"])
    scene.mesh("cabinet_telescope", meshkit.to_mesh(instruments.telescope(), "telescope"), (2.5, 19.5, Z), 150)


def library():
    for i, (x, w) in enumerate(((-11.6, 2.4), (-9.0, 2.4), (-6.4, 2.4))):
        scene.mesh(f"bookcase_n{i}", f.bookcase(w, 2.9, 20 + i), (x, 25.0, Z), 0)
    mantel, embers = instruments.fireplace()
    scene.mesh("fireplace", mantel, (-13.0, 22.6, Z), 90)
    scene.mesh("embers", embers, (-13.0, 22.6, Z), 90, kind="glow")
    light.bulb("embers", (-12.72, 22.6, Z + 0.2), 0.22, 1.5, "", 0.05, (1.0, 0.28, 0.06))
    f.hang_picture("library", "scholar", (-13.0, 22.6, Z + 2.55), 90, 1.0)
    scene.mesh("library_rug", slab(3.4, 2.6, 0.012, "carpet", 0.004, 0.001), (-8.4, 21.9, Z))
    scene.mesh("bookcase_w1", f.bookcase(2.4, 2.9, 31), (-13.0, 20.1, Z), 90)
    scene.mesh("bookcase_s", f.bookcase(2.4, 2.9, 32), (-6.8, 18.6, Z), 180)
    scene.mesh("library_table", f.desk(2.2), (-8.4, 21.9, Z), 0)
    for i, (x, y, turn) in enumerate(((-8.9, 22.6, 180), (-7.8, 21.0, 0))):
        scene.mesh(f"library_chair_{i}", f.chair(), (x, y, Z), turn)
    for i, (x, y, turn) in enumerate(((-11.35, 23.75, -118), (-11.35, 21.45, -62))):
        scene.mesh(f"library_armchair_{i}", f.armchair(), (x, y, Z), turn)
    scene.mesh("library_ladder", f.ladder(), (-7.75, 24.62, Z))
    scene.mesh("library_papers", f.papers(5), (-8.0, 21.95, Z + 0.789), 8)
    lamps.table_lamp("library_desk", (-8.9, 21.9, Z + 0.785), 90, "library", 4.5, 1.1)
    lamps.pendant("library", (-10.3, 20.4, 3.25), 4.6, "library", 3.0, 2.5)
    scene.mesh("globe", instruments.globe(), (-5.3, 23.4, Z))
    signs.exit_sign("library", (-4.0, 21.8, 3.44), -90, Z)
    doors.switch("library", (-9.4, 18.6, Z + 1.25), 180, "library", "Reading room lamps")


def workshop():
    bench = meshkit.to_mesh(things.workbench(), "workbench")
    for i, (x, y, turn) in enumerate(((6.4, 24.6, 0), (9.6, 24.6, 0), (8.4, 21.4, 180))):
        scene.mesh(f"workbench_{i}", bench, (x, y, Z), turn)
    scene.mesh("tool_board", things.tool_board(), (6.4, 25.0, Z + 1.22))
    scene.mesh("workshop_shelf_low", things.shelf(2.2, 9, 5), (9.6, 25.0, Z + 1.42))
    scene.mesh("workshop_shelf_high", things.shelf(2.2, 9, 8), (9.6, 25.0, Z + 1.92))
    for i, (x, y, turn, art) in enumerate(((8.0, 25.0, 0, "spheres"), (4.0, 23.7, 90, "prism"), (4.0, 20.3, 90, "spheres"))):
        scene.mesh(f"drawing_{i}", things.pinned_drawing(0.62, art), (x, y, Z + 1.75), turn)
    scene.mesh("workshop_papers", f.papers(8), (8.9, 21.35, Z + 0.9), 175)
    stool = meshkit.to_mesh(things.stool(), "stool")
    for i, (x, y) in enumerate(((7.3, 23.6), (9.4, 23.7), (8.0, 20.5))):
        scene.mesh(f"stool_{i}", stool, (x, y, Z), 50 * i)
    scene.mesh("great_dish", things.great_dish(), (11.7, 23.7, Z), -38)
    scene.mesh("grinder", instruments.grinder(), (5.6, 21.0, Z), 40)
    scene.mesh("workshop_telescope", bpy.data.meshes["telescope"], (11.9, 20.0, Z), -140)
    scene.mesh("workshop_shelves", f.bookcase(1.8, 2.6, 40), (13.0, 21.7, Z), -90)
    scene.mesh("workshop_crates", f.crates(7), (4.8, 19.4, Z), 20)
    top = Z + 0.90
    for i, (x, y, r, tilt) in enumerate(((6.0, 24.5, 0.13, 70), (6.7, 24.6, 0.09, 90), (8.0, 21.4, 0.16, 80), (9.9, 24.6, 0.11, 60))):
        glass = statues.biconvex(r, r * 0.4, 0.01, "lens_glass" if i % 2 == 0 else "amber_glass", 24, 4).turned(tilt, "x").moved(0, 0, 0.06 + r)
        frame = joined([lathe([(r + 0.001, -0.012), (r + 0.018, -0.012), (r + 0.018, 0.012), (r + 0.001, 0.012), (r + 0.001, -0.012)], "brass", 24).turned(tilt, "x").moved(0, 0, 0.06 + r),
                        lathe([(0.0, 0.0), (0.06, 0.0), (0.05, 0.02), (0.014, 0.035), (0.012, 0.05), (0.0, 0.055)], "brass", 12)])
        scene.mesh(f"bench_lens_{i}", glass, (x, y, top), 20 * i)
        scene.mesh(f"bench_lens_frame_{i}", frame, (x, y, top), 20 * i)
    lamps.pendant("workshop", (8.4, 21.4, 3.0), 4.6, "workshop", 4.0, 2.0)
    lamps.table_lamp("workshop_bench", (9.2, 24.6, top), 0, "workshop", 3.5, 1.0)
    signs.exit_sign("workshop", (4.0, 21.8, 3.64), 90, Z)
    doors.switch("workshop", (9.7, 18.6, Z + 1.25), 180, "workshop", "Workshop lamps")


def dress():
    hall()
    cabinet()
    library()
    workshop()
