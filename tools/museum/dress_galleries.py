"""The two long galleries: pictures in the west, sculpture in the east."""
import doors
import furniture as f
import lamps
import meshkit
import mouldings
import scene
import statues


def west():
    x = -13.0
    row = [(-4.9, "glen", 1.7), (-2.4, "lady", 1.1), (0.2, "forest", 1.15), (2.8, "spheres", 1.7), (5.6, "scholar", 1.1), (8.0, "dusk", 1.7)]
    for i, (y, art, width) in enumerate(row):
        f.hang_picture(f"west_{i}", art, (x, y, 2.15), 90, width)
    for i, (y, art, width) in enumerate([(12.1, "moonrise", 1.9), (14.9, "lady", 1.15), (17.0, "harbour", 1.5)]):
        f.hang_picture(f"west_n{i}", art, (x, y, 2.75), 90, width)
    for i, (y, art, width) in enumerate([(1.2, "prism", 1.7), (4.0, "alps", 1.5), (7.6, "optician", 1.1)]):
        f.hang_picture(f"west_e{i}", art, (-8.4, y, 2.15), -90, width)
    f.hang_picture("west_e3", "glen", (-8.4, 12.2, 2.75), -90, 1.6)
    bench = meshkit.to_mesh(f.bench(2.0), "gallery_bench")
    for i, y in enumerate((-3.6, 2.4, 6.6)):
        scene.mesh(f"west_bench_{i}", bench, (-10.7, y, 0.0), 90)
    scene.mesh("west_bench_n", bench, (-10.7, 13.2, 0.8), 90)
    scene.mesh("west_ropes", f.rope_posts([(-12.2, -5.6), (-12.2, -3.7), (-12.2, -1.6), (-12.2, 0.4), (-12.2, 2.4), (-12.2, 4.4)]))
    bust = meshkit.to_mesh(statues.bust("marble_rose"), "bust_rose", 60)
    tall = meshkit.to_mesh(statues.plinth(0.5, 1.15, "marble_white"), "west_plinth")
    for i, (px, py, pz, turn) in enumerate(((-8.85, -5.4, 0, -90), (-8.85, 2.6, 0, -90), (-8.85, 6.9, 0, -90), (-12.5, 16.0, 0.8, 90), (-8.85, 13.4, 0.8, -90))):
        scene.mesh(f"west_plinth_{i}", tall, (px, py, pz), turn)
        scene.mesh(f"west_bust_{i}", bust, (px, py, pz + 1.15), turn)
    lamps.pendant("west_south", (-10.7, -5.4, 3.0), 4.6, "west", 2.0, 3.0)
    lamps.sconce("west_arch", (-8.4, -3.4, 2.3), -90, "west", 0.9, 2.3)
    lamps.pendant("west_middle", (-10.7, 8.0, 3.1), 4.6, "west", 1.9, 3.1)
    lamps.sconce("west_hall", (-8.4, 16.9, 3.0), -90, "west_north", 0.9, 2.2)
    doors.switch("west", (-8.4, 0.2, 1.25), -90, "west", "Gallery lamps")


def east():
    figures = (("urn", lambda: statues.urn(1.0)), ("obelisk", lambda: statues.obelisk(1.7)), ("bust", lambda: statues.bust("bronze")))
    plinth = meshkit.to_mesh(statues.plinth(0.72, 0.9, "marble_white"), "east_plinth")
    made = {n: meshkit.to_mesh(make(), "east_" + n, 60) for n, make in figures}
    for i, (x, y, z, n) in enumerate(((12.2, -4.4, 0, "bust"), (12.2, -0.6, 0, "urn"), (12.2, 3.4, 0, "bust"), (9.3, 1.8, 0, "obelisk"), (9.3, -4.6, 0, "urn"),
                                      (12.2, 12.2, .8, "urn"), (12.2, 15.4, .8, "bust"), (9.3, 15.6, .8, "obelisk"))):
        scene.mesh(f"east_plinth_{i}", plinth, (x, y, z))
        scene.mesh(f"east_{n}_{i}", made[n], (x, y, z + 0.9), -90 if x > 11 else 90)
    glass, frame = statues.giant_lens(0.8)
    scene.mesh("giant_lens_frame", frame, (10.7, 1.3, 0), 20)
    scene.mesh("giant_lens_glass", glass, (10.7, 1.3, 0), 20)
    bench = meshkit.to_mesh(f.bench(1.8), "east_bench")
    scene.mesh("east_bench_0", bench, (10.7, -3.0, 0), 90)
    scene.mesh("east_bench_1", bench, (10.7, 13.8, 0.8), 90)
    lamps.sconce("east_south", (13.0, -2.5, 2.3), -90, "east", 1.1, 2.3)
    lamps.sconce("east_ramp", (8.4, 8.6, 2.6), 90, "east", 1.0, 2.3)
    lamps.pendant("east_north", (10.7, 16.8, 3.6), 4.6, "east_north", 1.8, 2.8)
    doors.switch("east", (8.4, -0.1, 1.25), 90, "east", "Sculpture lamps")
    doors.switch("east_north", (8.4, 11.1, 2.05), 90, "east_north", "North gallery lamp")


def dress():
    west()
    east()
