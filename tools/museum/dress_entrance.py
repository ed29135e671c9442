"""What stands in the entrance: cloakroom, lodge, vestibule, foyer, stair and lamp store."""
import doors
import furniture as f
import lamps
import meshkit
import mouldings
import scene
import statues
from meshkit import joined, lathe


def foyer():
    column = meshkit.to_mesh(mouldings.column(6.34, 0.34, fluted=True), "column")
    n = 0
    for x in (-4.9, 4.9):
        for y in (-8.9, -5.9, 0.1, 2.25):
            if y == 2.25:
                continue
            n += 1
            scene.mesh(f"column_{n}", column, (x, y, 0.0))
    dais = joined([lathe([(0.0, 0.0), (1.9, 0.0), (1.9, 0.10), (1.86, 0.14), (0.0, 0.14)], "marble_black", 64),
                   lathe([(0.0, 0.14), (1.35, 0.14), (1.35, 0.26), (1.31, 0.30), (0.0, 0.30)], "marble_white", 56)])
    scene.mesh("dais", dais, (0, -4.0, 0))
    scene.mesh("armillary", statues.armillary(1.25), (0, -4.0, 0.30))
    ring = [(2.35 * c, 2.35 * s) for c, s in ((1, 0), (.7071, .7071), (0, 1), (-.7071, .7071), (-1, 0), (-.7071, -.7071), (0, -1), (.7071, -.7071))]
    scene.mesh("dais_ropes", f.rope_posts(ring[1:4] and [ring[7], ring[0], ring[1]]), (0, -4.0, 0))
    scene.mesh("dais_ropes_west", f.rope_posts([ring[3], ring[4], ring[5]]), (0, -4.0, 0))
    desk = joined([f.counter(3.0)])
    scene.mesh("reception", desk, (6.0, -6.1, 0), -90)
    lamps.table_lamp("reception", (6.0, -6.6, 1.06), 90, "foyer", 2.4, 1.2)
    bench = meshkit.to_mesh(f.bench(1.8), "bench")
    for i, (x, y, turn) in enumerate(((-7.2, -5.6, 90), (-7.2, 1.2, 90), (-2.6, -10.4, 0), (7.2, 1.2, 90))):
        scene.mesh(f"bench_{i}", bench, (x, y, 0), turn)
    obelisk = meshkit.to_mesh(statues.obelisk(2.1), "obelisk")
    for x in (-2.6, 2.6):
        scene.mesh(f"plinth_obelisk_{'w' if x < 0 else 'e'}", statues.plinth(0.62, 0.8), (x, 2.3, 0))
        scene.mesh(f"obelisk_{'w' if x < 0 else 'e'}", obelisk, (x, 2.3, 0.8))
    bust = meshkit.to_mesh(statues.bust(), "bust", 60)
    tall = meshkit.to_mesh(statues.plinth(0.5, 1.2, "marble_green"), "bust_plinth")
    for i, (x, y, turn) in enumerate(((-7.45, -3.6, 90), (-7.45, -7.6, 90), (7.45, -3.6, -90), (-4.4, 2.5, 0), (4.4, 2.5, 0))):
        scene.mesh(f"bust_plinth_{i}", tall, (x, y, 0), turn)
        scene.mesh(f"bust_{i}", bust, (x, y, 1.2), turn)
    f.hang_picture("founder", "founder", (-5.6, 3.0, 2.9), 0, 1.3)
    f.hang_picture("optician", "optician", (5.6, 3.0, 2.9), 0, 1.3)
    f.hang_picture("alps", "alps", (-8.0, -5.6, 2.7), 90, 2.2)
    f.hang_picture("dusk", "dusk", (8.0, -5.6, 2.7), -90, 2.2)
    f.hang_picture("harbour", "harbour", (-5.0, -11.0, 2.6), 180, 2.0)
    f.hang_picture("moonrise", "moonrise", (5.0, -11.0, 2.6), 180, 2.0)
    lamps.pendant("foyer_ne", (5.9, -1.5, 3.4), 6.36, "foyer", 2.6, 3.4)
    lamps.pendant("foyer_se", (5.9, -7.6, 3.2), 6.36, "foyer", 2.2, 3.2)
    lamps.sconce("foyer_w", (-8.0, -8.0, 2.3), 90, "foyer_west", 1.0, 2.3)
    doors.switch("foyer", (2.15, 3.0, 1.25), 0, "foyer", "Foyer lamps")
    doors.switch("foyer_west", (-8.0, -7.9, 1.25), 90, "foyer_west", "West aisle lamp")


def vestibule():
    doors.front_door()
    lamps.lantern("vestibule", (0, -13.3, 3.0), 3.9, "vestibule", 1.3, 3.0)
    doors.switch("vestibule", (-1.5, -11.4, 1.25), 0, "vestibule", "Vestibule lantern")
    scene.mesh("vestibule_urn_w", joined([statues.plinth(0.5, 0.9), statues.urn(0.7).moved(0, 0, 0.9)]), (-2.5, -14.6, 0))
    scene.mesh("vestibule_urn_e", joined([statues.plinth(0.5, 0.9), statues.urn(0.7).moved(0, 0, 0.9)]), (2.5, -14.6, 0))
    scene.mesh("vestibule_mat", meshkit.block(-1.2, -14.9, 0.001, 1.2, -12.0, 0.012, "carpet", 0.004))
    bench = f.bench(1.5)
    scene.mesh("vestibule_bench", bench, (-2.55, -12.6, 0), 90)


def stair():
    lamps.lantern("stair", (0, 5.4, 3.7), 5.4, "stair", 1.6, 3.6)
    doors.switch("stair", (-2.6, 3.9, 1.25), 90, "stair", "Stair lantern")
    rail = []
    for side in (-1, 1):
        x = side * 2.3
        rail.append(meshkit.tube([(x, 5.2, 0.95), (x, 5.7, 0.98), (x, 7.4, 1.75), (x, 7.95, 1.75)], 0.03, "brass", 10))
        for y, z in ((5.3, 0.0), (6.1, 0.16), (6.8, 0.48), (7.45, 0.8)):
            rail.append(meshkit.tube([(x, y, z), (x, y, z + 0.95)], 0.016, "brass", 8))
    scene.mesh("stair_rails", joined(rail))
    f.hang_picture("stair", "prism", (2.6, 4.2, 2.4), -90, 1.1)


def cloakroom():
    scene.mesh("cloak_rack", f.coat_rack(3.2), (-14.0, -9.0, 0), 90)
    scene.mesh("cloak_rack_south", f.coat_rack(2.4), (-12.2, -11.0, 0), 180)
    scene.mesh("cloak_counter", f.counter(2.2), (-10.3, -9.6, 0), 90)
    scene.mesh("cloak_bench", f.bench(1.4), (-9.6, -10.6, 0), 0)
    lamps.pendant("cloak", (-9.4, -7.9, 2.3), 3.2, "cloak", 1.4, 2.3)
    doors.switch("cloak", (-8.4, -7.8, 1.25), -90, "cloak", "Cloakroom lamp")


def lodge():
    scene.mesh("lodge_desk", f.desk(1.7), (12.2, -9.9, 0), 0)
    scene.mesh("lodge_chair", f.chair(), (12.2, -9.2, 0), 180)
    lamps.table_lamp("lodge", (12.6, -10.0, 0.785), 0, "lodge", 2.2, 1.0)
    scene.mesh("lodge_shelves", f.bookcase(1.6, 2.1, 5), (14.0, -8.2, 0), -90)
    scene.mesh("lodge_coats", f.coat_rack(1.5), (9.6, -11.0, 0), 180)
    doors.switch("lodge", (8.4, -7.9, 1.25), 90, "lodge", "Lodge lamp")


def store():
    scene.mesh("store_crates", f.crates(3), (4.4, 7.1, 0), 0)
    scene.mesh("store_crates_south", f.crates(4), (6.4, 4.6, 0), 90)
    scene.mesh("store_shelves", f.bookcase(1.8, 2.2, 9), (6.2, 8.0, 0), 0)
    lamps.sconce("store", (8.0, 6.6, 1.9), -90, "store", 0.7, 2.0)
    doors.switch("store", (8.0, 6.1, 1.25), -90, "store", "Store lamp")


def dress():
    foyer()
    vestibule()
    stair()
    cloakroom()
    lodge()
    store()
