"""Picks up the hand mirror and holds it up with F, in the real window: what lies behind the player's back is to be seen.

    hand_mirror_window_test.py GLASSHOUSE OUT_FOLDER

The room is written here, so that no change of a level moves the mirror. The player looks at a grey wall; the wall behind
is red, the one to the left, from the elbow back, green; a mirror lies flat and edge-on where the eyes rest.

            -z   grey        So red and green are on the screen only while the mirror is up, and green only
       +-------------+       while the arm is held out to the left. Before it is picked up, F does nothing.
             --- mirror
    green |  ^ player
          |
       +-------------+
            +z   red
"""

import base64
import json
import os
import struct

from desk import Desk, fail, program_and_folder, ticks_spent

GREY, RED, GREEN, MIRROR = range(4)
EYES = 1.68  # metres: a standing player's


def quad(corner, along, across):
    """Four corners of a rectangle that faces along x across, as its positions."""
    add = lambda a, b: [x + y for x, y in zip(a, b)]
    return [corner, add(corner, along), add(add(corner, along), across), add(corner, across)]


def write_level(path):
    def glows(*colour):
        return {"pbrMetallicRoughness": {"baseColorFactor": [0, 0, 0, 1]}, "emissiveFactor": list(colour)}

    things = [  # name, material, rectangle, extras
        ("floor", GREY, quad([-6, 0, 6], [12, 0, 0], [0, 0, -12]), {}),
        ("ahead", GREY, quad([-6, 0, -6], [12, 0, 0], [0, 4, 0]), {}),
        ("behind", RED, quad([6, 0, 6], [-12, 0, 0], [0, 4, 0]), {}),
        ("left", GREEN, quad([-3, 0, 5], [0, 0, -6.5], [0, 4, 0]), {}),
        ("hand_mirror", MIRROR, quad([-0.07, EYES, -0.9], [0.14, 0, 0], [0, 0, -0.2]), {"kind": "mirror", "carry": True}),
    ]
    data, views, accessors, meshes = b"", [], [], []
    nodes = [{"name": "start", "extras": {"kind": "spawn"}}]

    def append(packed, count, kind, component, **more):
        nonlocal data
        accessors.append(dict(bufferView=len(views), componentType=component, count=count, type=kind, **more))
        views.append({"buffer": 0, "byteOffset": len(data), "byteLength": len(packed)})
        data += packed + bytes(-len(packed) % 4)
        return len(accessors) - 1

    for name, material, corners, extras in things:
        positions = append(struct.pack("<12f", *sum(corners, [])), 4, "VEC3", 5126,
                           min=[min(c[i] for c in corners) for i in range(3)], max=[max(c[i] for c in corners) for i in range(3)])
        indices = append(struct.pack("<6H", 0, 1, 2, 0, 2, 3), 6, "SCALAR", 5123)
        nodes.append({"name": name, "mesh": len(meshes), "extras": extras})
        meshes.append({"primitives": [{"attributes": {"POSITION": positions}, "indices": indices, "material": material}]})
    level = {
        "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": list(range(len(nodes)))}], "nodes": nodes, "meshes": meshes,
        "materials": [{"pbrMetallicRoughness": {"baseColorFactor": [0.4, 0.4, 0.4, 1], "metallicFactor": 0}},
                      glows(0.6, 0, 0), glows(0, 0.6, 0),
                      {"pbrMetallicRoughness": {"baseColorFactor": [0.9, 0.9, 0.9, 1], "metallicFactor": 1, "roughnessFactor": 0}}],
        "accessors": accessors, "bufferViews": views,
        "buffers": [{"byteLength": len(data), "uri": "data:application/octet-stream;base64," + base64.b64encode(data).decode()}],
    }
    with open(path, "w", encoding="utf-8") as file:
        json.dump(level, file)


def mirrored(desk):
    """Looks how much of the window shows the red wall itself, and how much the green one: [share, share]. What they only
    light is less bright."""
    window = ["-crop", "640x360+0+0", "+repage"]

    def look(path):
        return [desk.measure(path, *window, "-fx", f"u.{this}>0.75&&u.{that}<0.65", "-format", "%[fx:mean]")[0]
                for this, that in ("rg", "gr")]

    return look


def hold_mirror_up(desk):
    look = mirrored(desk)
    nothing = lambda seen: max(seen) < 0.001
    red = lambda seen: seen[0] > 0.01 and seen[1] < 0.001
    green = lambda seen: seen[1] > 0.004 and seen[0] < 0.001

    desk.wait_until("2_before", look, nothing)
    desk.xdotool("keydown", "f")
    desk.let_pass(1.5)
    if not nothing(look(desk.screenshot("3_f_without_mirror"))):
        fail("F shows a mirror that nobody has picked up")
    desk.xdotool("keyup", "f")

    desk.hold("e", 0.5)
    desk.wait_until("4_picked_up", look, nothing)
    desk.xdotool("keydown", "f")
    _, seen = desk.wait_until("5_behind", look, red)
    print(f"held up: the wall behind fills {seen[0]:.4f} of the window")
    desk.xdotool("keydown", "q")
    _, seen = desk.wait_until("6_to_the_left", look, green)
    print(f"held out to the left: the wall there fills {seen[1]:.4f}")
    desk.xdotool("keyup", "q")
    desk.wait_until("7_behind_again", look, red)
    desk.xdotool("keyup", "f")
    desk.wait_until("8_put_away", look, nothing)


def main():
    glasshouse, out = program_and_folder()
    level = os.path.join(out, "mirror_room.gltf")
    write_level(level)
    recording = os.path.join(out, "mirror.rec")
    with Desk([glasshouse, level, "--size", "640x360", "--record", recording], out) as desk:
        desk.wait_for_picture("1_opened")
        hold_mirror_up(desk)
        desk.quit_by_menu()

    spent = ticks_spent(glasshouse, recording)
    print(spent)
    for verb in ("using", "raising the mirror"):
        if spent[verb] == 0:
            fail(f"the key for {verb} never reached the recording")


main()
