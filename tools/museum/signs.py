"""Emergency exit signs: a box over a door whose face shows somebody running out, and under it a strip of light that no
switch turns off. They are what one sees by where every lamp is out, and less than moonlight: the dark still hides a thief."""
import light
import meshkit
import palette
import scene

GREEN = (0.45, 1.0, 0.62)
STRIP = 0.02  # W/m2 where its middle beam meets the floor


def exit_sign(name, at, turn, floor=0.0, width=0.40):
    """On a wall that faces -y when turned by 0; `at` is the middle of the face, on the wall. The strip is the box's lower
    front edge, cut off at 45 degrees: it lights the way there and what stands across the room."""
    w, h, depth, cut = width / 2, width / 4, 0.06, 0.045
    end = w + 0.012
    profile = [(0.0, h + 0.012), (-depth, h + 0.012), (-depth, -h - 0.006), (-depth + cut, -h - 0.006 - cut), (0.0, -h - 0.006 - cut)]
    box = meshkit.Shape()
    box.points = [(x, y, z) for x in (-end, end) for y, z in profile]
    for i in range(5):
        j = (i + 1) % 5
        box.face([i, j, 5 + j, 5 + i], "iron")
    box.face([4, 3, 2, 1, 0], "iron")
    box.face([5, 6, 7, 8, 9], "iron")

    face, strip = meshkit.Shape(), meshkit.Shape()
    face.points = [(-w, -depth - 0.001, -h), (w, -depth - 0.001, -h), (w, -depth - 0.001, h), (-w, -depth - 0.001, h)]
    face.face([0, 1, 2, 3], "exit_sign", [(0, 0), (1, 0), (1, 1), (0, 1)])
    front, back = (-depth - 0.001, -h - 0.008), (-depth + cut - 0.003, -h - 0.006 - cut)  # a millimetre before the box
    strip.points = [(-w, *back), (w, *back), (w, *front), (-w, *front)]
    distance = (at[2] - h - floor) * 2 ** 0.5
    radiance = light.rect_radiance(STRIP, distance, width * cut * 2 ** 0.5)
    strip.face([0, 1, 2, 3], palette.lamp_material("sign_light_" + name, GREEN, round(radiance, 3)))
    scene.mesh("sign_box_" + name, box, at, turn)
    scene.mesh("sign_" + name, face, at, turn, kind="glow")
    scene.mesh("sign_light_" + name, strip, at, turn, kind="lamp", shape="rect")
