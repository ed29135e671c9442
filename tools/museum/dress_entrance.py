"""What stands in the entrance: cloakroom, lodge, vestibule, foyer, stair and lamp store."""
import math

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
import sculpture
import signs
import statues
import workshop_things as things
from meshkit import joined, lathe


def foyer():
    column = meshkit.to_mesh(mouldings.column(6.34, 0.34, fluted=True), "column")
    for n, (x, y) in enumerate((x, y) for x in (-4.9, 4.9) for y in (-9.0, -6.2, 0.2)):
        scene.mesh(f"column_{n}", column, (x, y, 0.0))
    _sphere_on_its_dais()
    scene.mesh("reception", f.counter(3.0), (6.0, -6.1, 0), -90)
    scene.mesh("reception_bell", lathe([(0.0, 0.0), (0.06, 0.0), (0.06, 0.01), (0.05, 0.045), (0.01, 0.06), (0.008, 0.075), (0.0, 0.08)], "brass", 18), (5.95, -5.6, 1.06))
    lamps.table_lamp("reception", (6.0, -6.6, 1.06), 90, "foyer", 3.0, 1.2)
    bench = meshkit.to_mesh(f.bench(1.8), "bench")
    for i, (x, y, turn) in enumerate(((-7.3, -4.6, 90), (-7.3, 1.3, 90), (-2.6, -10.4, 0), (7.3, 1.3, 90))):
        scene.mesh(f"bench_{i}", bench, (x, y, 0), turn)
    stone, glass = sculpture.lady()
    stone, glass = meshkit.to_mesh(stone, "lady", 70), meshkit.to_mesh(glass, "lady_lens")
    base = meshkit.to_mesh(statues.plinth(0.74, 0.75, "marble_rose"), "lady_plinth")
    for side, x, turn in (("w", -2.7, -12), ("e", 2.7, 12)):
        scene.mesh("lady_plinth_" + side, base, (x, 2.25, 0))
        scene.mesh("lady_" + side, stone, (x, 2.25, 0.75), turn)
        scene.mesh("lady_lens_" + side, glass, (x, 2.25, 0.75), turn)
    tall = meshkit.to_mesh(statues.plinth(0.5, 1.2, "marble_green"), "bust_plinth")
    for i, (x, y, turn, who) in enumerate(((-7.45, -6.2, 90, "sage"), (-7.45, -3.1, 90, "muse"), (7.45, -3.4, -90, "muse"), (7.45, 0.2, -90, "sage"))):
        scene.mesh(f"bust_plinth_{i}", tall, (x, y, 0), turn)
        scene.mesh(f"bust_{i}", BUSTS[who](), (x, y, 1.2), turn)
    _foyer_walls()
    scene.mesh("foyer_runner", meshkit.slab(1.9, 4.1, 0.012, "carpet", 0.0, 0.001), (0, -8.4, 0))
    palm = meshkit.to_mesh(f.palm(), "palm")
    for i, (x, y, z) in enumerate(((-7.4, 2.4, 0), (7.4, 2.4, 0), (7.4, -10.35, 0), (-12.5, 17.7, 0.8), (8.95, -6.0, 0), (-2.45, -15.0, 0))):
        scene.mesh(f"palm_{i}", palm, (x, y, z), 50 * i)
    lamps.pendant("foyer_ne", (5.9, -1.5, 3.4), 6.36, "foyer", 2.2, 3.4)
    lamps.pendant("foyer_se", (5.9, -7.6, 3.2), 6.36, "foyer", 1.8, 3.2)
    lamps.sconce("foyer_w", (-8.0, -7.4, 2.3), 90, "foyer_west", 1.3, 2.3)
    doors.switch("foyer", (2.15, 3.0, 1.25), 0, "foyer", "Foyer lamps")
    doors.switch("foyer_west", (-8.0, -7.8, 1.25), 90, "foyer_west", "West aisle lamp")


BUSTS = {}


def carve_busts():
    """Carved on first use and shared by all rooms; to be called once for every building of the level."""
    made = {}

    def carved(kind):
        if kind not in made:
            made[kind] = meshkit.to_mesh(sculpture.bust(kind), "bust_" + kind, 70)
        return made[kind]

    BUSTS["sage"], BUSTS["muse"] = (lambda: carved("sage")), (lambda: carved("muse"))


def _sphere_on_its_dais():
    dais = joined([lathe([(0.0, 0.0), (1.9, 0.0), (1.9, 0.10), (1.86, 0.14), (0.0, 0.14)], "marble_black", 64),
                   lathe([(0.0, 0.14), (1.35, 0.14), (1.35, 0.26), (1.31, 0.30), (0.0, 0.30)], "marble_white", 56)])
    scene.mesh("dais", dais, (0, -4.0, 0))
    scene.mesh("armillary", statues.armillary(1.25), (0, -4.0, 0.30))
    side = [(2.35 * math.cos(a), 2.35 * math.sin(a)) for a in (-math.pi / 4, 0.0, math.pi / 4)]
    scene.mesh("dais_ropes_east", f.rope_posts(side), (0, -4.0, 0))
    scene.mesh("dais_ropes_west", f.rope_posts([(-x, -y) for x, y in side]), (0, -4.0, 0))


def _foyer_walls():
    strip = meshkit.to_mesh(mouldings.pilaster(6.2, 0.62, "limestone", "marble_green"), "foyer_pilaster")
    places = [(-8.0, y, 90) for y in (-10.4, -6.2, -3.1, 0.2, 2.5)] + [(8.0, y, -90) for y in (-10.4, -6.9, -3.4, 0.2, 2.5)]
    places += [(x, 3.0, 0) for x in (-6.6, -3.9, 3.9, 6.6)] + [(x, -11.0, 180) for x in (-6.6, -2.2, 2.2, 6.6)]
    for i, (x, y, turn) in enumerate(places):
        scene.mesh(f"foyer_pilaster_{i}", strip, (x, y, 0), turn)
    course = joined([mouldings._run([(0.0, -0.10), (0.0, 0.10), (0.09, 0.10), (0.11, 0.06), (0.06, 0.0), (0.03, -0.10)], path, "stucco", 4.15, closed)
                     for path, closed in plan.wall_runs("foyer", 4.15)])
    scene.mesh("foyer_course", course)
    round_relief = meshkit.to_mesh(instruments.tondo(0.55), "tondo")
    for i, (x, y, turn) in enumerate(((-8.0, -4.65, 90), (-8.0, -1.5, 90), (8.0, -1.5, -90), (8.0, -5.1, -90), (-5.25, 3.0, 0), (5.25, 3.0, 0), (0.0, 3.0, 0), (-4.4, -11.0, 180),
                                      (4.4, -11.0, 180), (0.0, -11.0, 180), (-8.0, -8.3, 90), (8.0, -8.6, -90))):
        scene.mesh(f"tondo_{i}", round_relief, (x, y, 5.12), turn)
    f.hang_picture("founder", "founder", (-5.25, 3.0, 2.75), 0, 1.25)
    size = f.hang_picture("optician", "optician", (5.25, 3.0, 2.75), 0, 1.25)
    lamps.picture_light("optician", (5.25, 3.0, 2.75), 0, *size, "foyer", 1.5)
    f.hang_picture("alps", "alps", (-8.0, -4.65, 2.6), 90, 1.9)
    f.hang_picture("aurora", "aurora", (8.0, -5.1, 2.7), -90, 2.0)
    f.hang_picture("harbour", "harbour", (-4.4, -11.0, 2.6), 180, 2.4)
    f.hang_picture("lighthouse", "lighthouse", (4.4, -11.0, 2.6), 180, 2.4)


def vestibule():
    doors.front_door()
    lamps.lantern("vestibule", (0, -13.3, 3.0), 3.9, "vestibule", 1.6, 3.0)
    doors.switch("vestibule", (-1.5, -11.4, 1.25), 0, "vestibule", "Vestibule lantern")
    strip = meshkit.to_mesh(mouldings.pilaster(3.46, 0.5, "limestone", "marble_green"), "vestibule_pilaster")
    for i, (x, y, turn) in enumerate(((-2.45, -11.4, 0), (2.45, -11.4, 0), (-3.0, -14.35, 90), (3.0, -14.35, -90))):
        scene.mesh(f"vestibule_pilaster_{i}", strip, (x, y, 0), turn)
    f.hang_picture("vestibule_w", "glen", (-3.0, -12.9, 1.95), 90, 1.3)
    f.hang_picture("vestibule_e", "rainbow", (3.0, -12.9, 1.95), -90, 1.3)
    scene.mesh("vestibule_mat", meshkit.block(-1.2, -14.9, 0.001, 1.2, -12.0, 0.012, "carpet", 0.004))
    bench = f.bench(1.5)
    scene.mesh("vestibule_bench", bench, (-2.55, -12.6, 0), 90)


def stair():
    lamps.lantern("stair", (0, 5.4, 3.7), 5.4, "stair", 1.8, 3.6)
    doors.switch("stair", (-2.6, 3.9, 1.25), 90, "stair", "Stair lantern")
    rail = []
    for side in (-1, 1):
        x = side * 2.3
        rail.append(meshkit.tube([(x, 5.2, 0.95), (x, 5.7, 0.98), (x, 7.4, 1.75), (x, 7.95, 1.75)], 0.03, "brass", 10))
        for y, z in ((5.3, 0.0), (6.1, 0.16), (6.8, 0.48), (7.45, 0.8)):
            rail.append(meshkit.tube([(x, y, z), (x, y, z + 0.95)], 0.016, "brass", 8))
    scene.mesh("stair_rails", joined(rail))
    f.hang_picture("stair", "prism", (2.6, 4.2, 2.6), -90, 1.1)
    f.hang_picture("stair_west", "eclipse", (-2.6, 4.9, 2.75), 90, 1.5)
    f.hang_picture("stair_north", "forest", (2.6, 6.6, 3.1), -90, 0.95)
    drape = instruments.curtain(0.75, 3.5)
    scene.mesh("curtain_stair_w", drape, (-1.55, 3.55, 0), 0, layers="light,sight,sound")
    scene.mesh("curtain_stair_e", instruments.curtain(0.75, 3.5, pull=1), (0.80, 3.55, 0), 0, layers="light,sight,sound")
    scene.mesh("curtain_rod", meshkit.tube([(-1.9, 3.55, 3.52), (1.9, 3.55, 3.52)], 0.025, "brass", 10))


def cloakroom():
    scene.mesh("cloak_rack", f.coat_rack(3.2), (-14.0, -9.0, 0), 90)
    scene.mesh("cloak_rack_south", f.coat_rack(2.4), (-12.2, -11.0, 0), 180)
    scene.mesh("cloak_hats", joined([things.hat(r, t, c).moved(x, y, 2.02) for x, y, r, t, c in (
        (-13.84, -7.9, 0.17, 0.13, "coat"), (-13.83, -8.45, 0.14, 0.17, "dark_cloth"), (-13.85, -9.7, 0.19, 0.12, "velvet_blue"), (-12.7, -10.85, 0.16, 0.16, "coat"))]))
    scene.mesh("cloak_counter", f.counter(2.2), (-10.3, -9.6, 0), 90)
    scene.mesh("cloak_ledger", joined([meshkit.block(-0.20, -0.28, 0.0, 0.20, 0.0, 0.05, "leather", 0.0), meshkit.block(-0.19, -0.27, 0.05, 0.19, -0.01, 0.056, "paper", 0.0)]), (-10.2, -9.0, 1.06), 80)
    mirrors.hand_mirror((-10.42, -9.42, 1.073), 60)
    scene.mesh("cloak_bench", f.bench(1.4), (-9.5, -10.65, 0), 0)
    scene.mesh("ticket_board", things.ticket_board(), (-9.6, -11.0, 1.2), 180)
    scene.mesh("umbrella_stand", things.umbrella_stand(), (-8.75, -7.2, 0))
    scene.mesh("hat_stand", things.hat_stand(), (-12.75, -7.35, 0), 15)
    for i, (y, z, width, turn) in enumerate(((-8.1, 0, 0.95, 90), (-8.15, 0.448, 0.62, 82), (-9.35, 0, 0.75, 93))):
        scene.mesh(f"trunk_{i}", things.trunk(width), (-13.62, y, z), turn)
    scene.mesh("cloak_rug", meshkit.slab(2.6, 1.7, 0.012, "carpet", 0.0, 0.001), (-11.9, -8.75, 0))
    f.hang_picture("cloak", "glen", (-9.5, -6.9, 1.95), 0, 0.9)
    f.hang_picture("cloak_east", "lighthouse", (-8.4, -10.25, 1.95), -90, 0.95)
    scene.mesh("cloak_clock", f.longcase_clock(), (-13.55, -6.95, 0), 0)
    lamps.pendant("cloak", (-9.4, -7.9, 2.3), 3.2, "cloak", 2.4, 2.3)
    lamps.table_lamp("cloak_desk", (-10.3, -10.25, 1.06), 90, "cloak", 2.4, 1.0)
    signs.exit_sign("cloak", (-8.4, -8.8, 2.62), -90)
    doors.switch("cloak", (-8.4, -7.8, 1.25), -90, "cloak", "Cloakroom lamp")


def lodge():
    scene.mesh("lodge_desk", f.desk(1.7), (12.2, -9.9, 0), 0)
    scene.mesh("lodge_chair", f.chair(), (12.2, -9.2, 0), 180)
    lamps.table_lamp("lodge", (12.6, -10.0, 0.785), 0, "lodge", 3.6, 1.0)
    scene.mesh("lodge_shelves", f.bookcase(1.6, 2.1, 5), (14.0, -8.2, 0), -90)
    scene.mesh("lodge_coats", f.coat_rack(1.5), (9.6, -11.0, 0), 180)
    scene.mesh("lodge_keys", things.ticket_board(), (12.3, -11.0, 1.35), 180)
    scene.mesh("lodge_rug", meshkit.slab(2.4, 1.7, 0.012, "carpet", 0.0, 0.001), (11.2, -9.3, 0))
    f.hang_picture("lodge", "dusk", (14.0, -9.9, 1.95), -90, 0.9)
    scene.mesh("lodge_trunk", things.trunk(0.8), (13.55, -7.2, 0), 0)
    stove, fire = things.stove(3.2)
    scene.mesh("lodge_stove", stove, (9.05, -7.35, 0), -25)
    scene.mesh("lodge_stove_fire", fire, (9.05, -7.35, 0), -25, kind="glow")
    light.bulb("lodge_stove", (9.05 - 0.34 * math.sin(math.radians(-25)) * -1.0, -7.35 - 0.34 * math.cos(math.radians(25)), 0.46), 0.5, 1.5, "", 0.03, (1.0, 0.34, 0.08))
    lamps.sconce("lodge_wall", (10.1, -11.0, 2.1), 180, "lodge", 1.1, 2.0)
    signs.exit_sign("lodge", (8.4, -8.8, 2.62), 90)
    doors.switch("lodge", (8.4, -7.9, 1.25), 90, "lodge", "Lodge lamp")


def store():
    scene.mesh("store_crates", f.crates(3), (4.4, 7.1, 0), 0)
    scene.mesh("store_crates_south", f.crates(4), (6.4, 4.6, 0), 90)
    scene.mesh("store_shelves", things.lamp_shelves(1.9, 2.1, 9), (6.2, 8.0, 0), 0, smooth_deg=50.0)
    lamps.sconce("store", (8.0, 6.6, 1.9), -90, "store", 1.8, 2.0)
    signs.exit_sign("store", (8.0, 5.0, 2.515), -90)
    doors.switch("store", (8.0, 6.1, 1.25), -90, "store", "Store lamp")


def dress():
    foyer()
    vestibule()
    stair()
    cloakroom()
    lodge()
    store()
