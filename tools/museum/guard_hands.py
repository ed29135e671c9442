"""Gloves and the torch.

A hand is modelled in its own frame, x towards the thumb, y along the fingers, z out of the back, the knuckles at
the origin, and then laid onto the rest pose's hand.
"""
import numpy as np

from guard_bones import REST, hand_frame
from guard_shapes import Part, interpolate, loft, ring, smoothstep, turned

#          knuckle x, y, z      lengths of the three limbs      radius
FINGERS = ((.0300, .000, .002, .042, .025, .021, .0098), (.0105, .006, .004, .046, .029, .023, .0102),
           (-.0095, .003, .003, .043, .027, .022, .0098), (-.0285, -.005, .000, .034, .021, .019, .0088))


def finger(base, direction, bends_deg, lengths, radius, weights):
    """A tube of three limbs that bends towards -z of the hand at each joint."""
    direction = np.asarray(direction, dtype=float)
    direction /= np.linalg.norm(direction)
    axis = np.cross((0, 0, 1.0), direction)
    axis /= np.linalg.norm(axis)

    def swung(v, degrees):
        a = np.radians(degrees)
        return v * np.cos(a) + np.cross(axis, v) * np.sin(a) + axis * np.dot(axis, v) * (1 - np.cos(a))

    rings, point, heading = [], np.asarray(base, dtype=float), direction
    across = axis

    def add(at, way, r):
        up = np.cross(way, across)
        rings.append(ring(at, across, up, r, r, 6))

    add(point - heading * .012, heading, radius * .9)
    for bend, length, r in zip(bends_deg, lengths, (radius * 1.04, radius, radius * .93)):
        middle = swung(heading, bend / 2)
        add(point, middle, r * 1.03)
        heading = swung(heading, bend)
        add(point + heading * length * .5, heading, r * .96)
        point = point + heading * length
    tip = radius * .9
    add(point - heading * tip * .55, heading, tip * .93)
    add(point - heading * tip * .15, heading, tip * .62)
    part = loft(rings, "guard_glove", weights, True, True)
    part.vertices[-1] += heading * tip * .22
    return part


def palm(hand):
    """Back and palm from the wrist to the knuckles, the ball of the thumb included."""
    sections = [(-.112, .000, .026, .021, 0), (-.090, .000, .027, .021, 0), (-.074, .001, .029, .021, 0),
                (-.055, .003, .037, .021, -.001), (-.032, .003, .042, .019, -.001), (-.012, .001, .0425, .0165, 0),
                (.002, .001, .0405, .0135, .001), (.011, .001, .034, .0085, .001)]
    rings = [ring((x, y, z), (1, 0, 0), (0, 0, 1), hx, hz, 12, 2.6) for y, x, hx, hz, z in sections]
    return loft(rings, "guard_glove", hand, False, True)


def glove_cuff(hand):
    """A flared gauntlet over the coat's sleeve end."""
    profile = [(-.060, .033, .0245), (-.066, .0355, .0270), (-.080, .0345, .0275), (-.100, .0400, .034),
               (-.118, .0450, .0400), (-.122, .0440, .0390), (-.116, .0400, .0350)]
    rings = [ring((0, y, 0), (1, 0, 0), (0, 0, 1), hx, hz, 14, 2.2) for y, hx, hz in profile]
    return loft(rings[::-1], "guard_glove", hand)


def open_hand():
    """The free hand: loosely bent fingers that follow the bone of the knuckles."""
    parts = [palm("hand.R"), glove_cuff("hand.R")]
    for i, (x, y, z, a, b, c, r) in enumerate(FINGERS):
        bends = (16 + 3 * i, 24 + 3 * i, 16)
        parts.append(finger((x, y, z), (.10 - .075 * i, 1, 0), bends, (a, b, c), r, "fingers.R"))
        parts[-1].weights = {"fingers.R": np.repeat([.0, .55] + [1.0] * 7, 6), "hand.R": None}
        soft = np.concatenate([parts[-1].weights["fingers.R"], [0.0, 1.0]])
        parts[-1].weights = {"fingers.R": soft, "hand.R": 1 - soft}
    parts.append(finger((.030, -.052, -.006), (.62, .80, -.30), (8, 18, 20), (.040, .032, .026), .0118, "hand.R"))
    return parts


def fist():
    """Fingers closed round the torch's barrel, which runs through the hand along x."""
    parts = [palm("hand.R"), glove_cuff("hand.R")]
    for x, y, z, a, b, c, r in FINGERS:
        parts.append(finger((x * .96, y - .002, z), (0, 1, -.12), (60, 75, 45), (a * .98, b * 1.05, c), r, "hand.R"))
    parts.append(finger((.026, -.052, -.014), (.86, .26, -.44), (0, 14, 22), (.036, .028, .020), .0112, "hand.R"))
    return parts


def torch():
    """A night watchman's torch: knurled barrel, flared head, glowing lens."""
    at, axis = (.014, -.010, -.0345), (.97, .24, 0)
    barrel = [(0, -.105), (.015, -.105), (.0185, -.102), (.0190, -.088), (.0170, -.084), (.0168, -.02), (.0168, .05),
              (.0175, .058), (.0185, .062), (.0185, .072), (.0260, .092), (.0300, .108), (.0305, .124), (.0290, .127),
              (.0255, .126), (.0245, .121)]
    lens = [(.0250, .1212), (.0235, .1228), (.0160, .1245), (0, .1252)]
    body = turned(barrel, at, axis, "guard_steel", "torch", 13)
    glow = turned(lens, at, axis, "guard_torch_glow", "torch", 13)
    switch = turned([(.006, .0), (.006, .004), (.004, .006), (0, .0062)], (.067, .004, -.0190), (0, 0, 1.0),
                    "guard_brass", "torch", 8, (1, 0, 0))
    return [body, glow, switch]


def hands():
    """Both hands and the torch where the rest pose has them."""
    frame, at = hand_frame(".R"), REST["hand.R"][2]
    left = [part.moved(frame, at).mirrored() for part in open_hand()]
    return left + [part.moved(frame, at) for part in fist() + torch()]
