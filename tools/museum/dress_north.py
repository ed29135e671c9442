"""The Hall of Mirrors, the Lens Cabinet with its vitrine, the reading room and the workshop."""
import doors
import furniture as f
import lamps
import meshkit
import mirrors
import mouldings
import plan
import scene
import statues
from meshkit import ball, block, joined, lathe, slab, tube

Z = plan.HIGH


def hall():
    mirrors.hang()
    scene.mesh("settee", f.settee(), (0, 13.2, Z))
    pilaster = meshkit.to_mesh(mouldings.pilaster(4.95, 0.5, "marble_rose"), "pilaster")
    n = 0
    for y, turn in ((8.4, 180), (18.2, 0)):
        for x in (-7.2, -4.4, -1.85, 1.85, 4.4, 7.2) if turn == 0 else (-7.2, -6.0, -3.1, -1.9, 1.9, 3.1, 6.0, 7.2):
            n += 1
            scene.mesh(f"pilaster_{n}", pilaster, (x, y, Z), turn)
    for x, turn in ((-8.0, 90), (8.0, -90)):
        for y in (9.8, 13.2, 17.2) if x < 0 else (9.9, 14.2, 17.5):
            n += 1
            scene.mesh(f"pilaster_{n}", pilaster, (x, y, Z), turn)
    lamps.chandelier("hall", (0, 13.2, 4.4), 6.8, "hall", 1.5, 3.6)
    for name, x, y, turn in (("hall_sw", -1.85, 8.5, 180), ("hall_ne", 1.85, 18.1, 0), ("hall_e", 7.9, 14.2, -90)):
        lamps.sconce(name, (x, y, Z + 2.2), turn, "hall_sconces", 0.9, 2.3)
    doors.switch("hall", (1.45, 8.4, Z + 1.25), 180, "hall", "Chandelier")
    doors.switch("hall_sconces", (-1.45, 18.2, Z + 1.25), 0, "hall_sconces", "Hall sconces")
    mouldings.coffers("hall", [-7.86, -5.2, -2.64, 2.64, 5.2, 7.86], [8.54, 11.06, 15.34, 18.06], 6.2, plan.SKYLIGHTS["hall"])
    bench = meshkit.to_mesh(f.bench(1.6), "hall_bench")
    scene.mesh("hall_bench_e", bench, (6.0, 9.6, Z), 0)
    scene.mesh("hall_bench_w", bench, (-7.3, 12.9, Z), 90)


def cabinet():
    top = f.vitrine("vitrine", (0.0, 22.0, Z), 0.0)
    ring = lathe([(0.112, -0.016), (0.122, -0.016), (0.126, 0.0), (0.122, 0.016), (0.112, 0.016), (0.112, -0.016)], "gilt", 48)
    glass = statues.biconvex(0.1115, 0.045, 0.012, "lens_glass", 48, 10)
    scene.mesh("lens_of_the_hall", joined([glass, ring]).turned(-38, "x"), (0.0, 22.0, top + 0.105), kind="lens", title="The Founder's Lens")
    stand = joined([tube([(-0.126, 0, 0.0), (-0.10, 0, -0.06), (0, 0, -0.085), (0.10, 0, -0.06), (0.126, 0, 0.0)], 0.006, "brass", 8),
                    lathe([(0.0, -0.105), (0.06, -0.105), (0.05, -0.095), (0.012, -0.088), (0.0, -0.08)], "brass", 20)])
    scene.mesh("lens_stand", stand, (0.0, 22.0, top + 0.105))
    scene.mesh("vitrine_ropes", f.rope_posts([(-1.5, 20.9), (-1.5, 23.2), (1.5, 23.2), (1.5, 20.9)]), (0, 0, Z))
    scene.mesh("cabinet_rug", slab(3.6, 3.2, 0.012, "carpet", 0.004, 0.001), (0, 22.0, Z))
    lamps.spot_can("vitrine", (0.0, 19.9, 4.55), (0.0, 22.0, 1.75), "cabinet", 4.0, 26)
    lamps.sconce("cabinet_w", (-3.6, 24.0, Z + 2.1), 90, "cabinet", 0.7, 2.3)
    doors.switch("cabinet", (1.35, 18.6, Z + 1.25), 180, "cabinet", "Cabinet lamps")
    for i, (x, y) in enumerate(((-2.9, 24.3), (2.9, 24.3), (-2.9, 19.3), (2.9, 19.3))):
        scene.mesh(f"cabinet_plinth_{i}", statues.plinth(0.5, 1.0, "marble_green"), (x, y, Z))
        scene.mesh(f"cabinet_urn_{i}", statues.urn(0.75, "marble_rose"), (x, y, Z + 1.0))
    f.hang_picture("cabinet", "spheres", (0.0, 25.0, Z + 2.0), 0, 2.0)


def library():
    for i, (x, w) in enumerate(((-11.6, 2.4), (-9.0, 2.4), (-6.4, 2.4))):
        scene.mesh(f"bookcase_n{i}", f.bookcase(w, 2.9, 20 + i), (x, 25.0, Z), 0)
    scene.mesh("bookcase_w0", f.bookcase(2.4, 2.9, 30), (-13.0, 22.8, Z), 90)
    scene.mesh("bookcase_w1", f.bookcase(2.4, 2.9, 31), (-13.0, 20.1, Z), 90)
    scene.mesh("bookcase_s", f.bookcase(2.4, 2.9, 32), (-6.8, 18.6, Z), 180)
    scene.mesh("library_table", f.desk(2.2), (-8.4, 21.9, Z), 0)
    for i, (x, y, turn) in enumerate(((-8.9, 22.6, 180), (-7.8, 21.0, 0))):
        scene.mesh(f"library_chair_{i}", f.chair(), (x, y, Z), turn)
    lamps.table_lamp("library_desk", (-8.9, 21.9, Z + 0.785), 90, "library", 2.4, 1.1)
    lamps.pendant("library", (-10.6, 20.2, 3.3), 4.6, "library", 1.6, 2.5)
    scene.mesh("globe", joined([ball(0.42, "marble_green", 32, 20).moved(0, 0, 0.92), statues._ring(0.46, 0.012, 90).moved(0, 0, 0.92), statues._ring(0.47, 0.014).moved(0, 0, 0.92),
                                lathe([(0.0, 0.0), (0.34, 0.0), (0.32, 0.05), (0.06, 0.10), (0.05, 0.40), (0.0, 0.47)], "oak_dark", 24)]), (-5.4, 23.6, Z))
    doors.switch("library", (-9.4, 18.6, Z + 1.25), 180, "library", "Reading room lamps")


def workshop():
    for i, (x, y, turn) in enumerate(((6.4, 24.4, 180), (9.6, 24.4, 180), (8.4, 21.4, 0))):
        scene.mesh(f"workbench_{i}", f.counter(2.4), (x, y, Z), turn + 180)
    scene.mesh("workshop_shelves", f.bookcase(2.2, 2.6, 40), (13.0, 22.4, Z), -90)
    scene.mesh("workshop_crates", f.crates(7), (12.0, 24.2, Z), 30)
    for i, (x, y, r, tilt) in enumerate(((6.0, 24.3, 0.13, 70), (6.7, 24.4, 0.09, 90), (8.0, 21.4, 0.16, 80), (9.9, 24.4, 0.11, 60))):
        glass = statues.biconvex(r, r * 0.4, 0.01, "lens_glass" if i % 2 == 0 else "amber_glass", 32, 7).turned(tilt, "x").moved(0, 0, 0.06 + r)
        frame = joined([lathe([(r + 0.001, -0.01), (r + 0.012, -0.01), (r + 0.012, 0.01), (r + 0.001, 0.01), (r + 0.001, -0.01)], "brass", 36).turned(tilt, "x").moved(0, 0, 0.06 + r),
                        lathe([(0.0, 0.0), (0.06, 0.0), (0.05, 0.015), (0.012, 0.03), (0.01, 0.05), (0.0, 0.055)], "brass", 16)])
        scene.mesh(f"bench_lens_{i}", glass, (x, y, Z + 1.06), 20 * i)
        scene.mesh(f"bench_lens_frame_{i}", frame, (x, y, Z + 1.06), 20 * i)
    lamps.pendant("workshop", (8.4, 21.4, 3.0), 4.6, "workshop", 2.4, 2.0)
    lamps.table_lamp("workshop_bench", (9.2, 24.4, Z + 1.06), 0, "workshop", 2.0, 1.0)
    doors.switch("workshop", (9.7, 18.6, Z + 1.25), 180, "workshop", "Workshop lamps")


def dress():
    hall()
    cabinet()
    library()
    workshop()
