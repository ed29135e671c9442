"""The guard's skeleton, and how poses are computed on it.

A pose gives each bone a turn in the *armature's* axes, as if every bone's rest frame were the identity: turning
"thigh.R" about x swings the leg forwards and back, whatever the bone's own roll.  Two-bone limbs are solved from
where hand or foot should be, which is what keeps feet from sliding.
"""
import numpy as np

RIGHT = {  # head of each bone at rest, metres; the left side is the mirror image
    "clavicle": (0.030, -0.005, 1.440), "upper_arm": (0.176, -0.012, 1.436),
    "forearm": (0.353, -0.022, 1.210), "hand": (0.503, 0.025, 1.011),
    "thigh": (0.095, 0.000, 0.915), "shin": (0.100, 0.016, 0.500),
    "foot": (0.102, -0.015, 0.105), "toe": (0.112, 0.118, 0.032)}
RIGHT_TAIL = {"hand": (0.551, 0.043, 0.948), "toe": (0.116, 0.200, 0.030)}
MIDDLE = {"hips": (0, 0, 0.950), "spine": (0, -0.010, 1.060), "chest": (0, -0.012, 1.220),
          "neck": (0, -0.012, 1.490), "head": (0, 0.004, 1.570)}
CHAIN = {"spine": "hips", "chest": "spine", "neck": "chest", "head": "neck", "clavicle": "chest",
         "upper_arm": "clavicle", "forearm": "upper_arm", "hand": "forearm", "thigh": "hips", "shin": "thigh",
         "foot": "shin", "toe": "foot"}


def build_rest():
    """Bones in order, parents first: name -> (parent or None, head, tail)."""
    bones = {}
    tails = {"hips": MIDDLE["spine"], "spine": MIDDLE["chest"], "chest": MIDDLE["neck"],
             "neck": MIDDLE["head"], "head": (0, 0.004, 1.790)}
    for name, head in MIDDLE.items():
        bones[name] = (CHAIN.get(name), np.array(head, dtype=float), np.array(tails[name], dtype=float))
    children = {"clavicle": "upper_arm", "upper_arm": "forearm", "forearm": "hand", "thigh": "shin",
                "shin": "foot", "foot": "toe"}
    for side, sign in ((".R", 1.0), (".L", -1.0)):
        flip = np.array((sign, 1.0, 1.0))
        for name, head in RIGHT.items():
            tail = RIGHT[children[name]] if name in children else RIGHT_TAIL[name]
            parent = CHAIN[name]
            bones[name + side] = (parent + side if parent in RIGHT else parent,
                                  np.array(head) * flip, np.array(tail) * flip)
    # Knuckles of the free hand, and the torch: a level may hang a light on the latter.
    hand, tip = bones["hand.L"][1], bones["hand.L"][2]
    along = (tip - hand) / np.linalg.norm(tip - hand)
    bones["fingers.L"] = ("hand.L", tip.copy(), tip + along * 0.09)
    grip = bones["hand.R"][2]
    forward = hand_frame(".R")[:, 0]
    bones["torch"] = ("hand.R", grip, grip + forward * 0.16)
    return bones


def hand_frame(side):
    """Columns: towards the thumb, along the fingers, out of the back of the hand (armature axes, at rest).
    For a right hand these are left-handed."""
    sign = 1.0 if side == ".R" else -1.0
    flip = np.array((sign, 1.0, 1.0))
    along = (np.array(RIGHT_TAIL["hand"]) - np.array(RIGHT["hand"])) * flip
    along /= np.linalg.norm(along)
    thumb = np.array((0.0, 1.0, 0.0)) - along * along[1]
    thumb /= np.linalg.norm(thumb)
    return np.column_stack([thumb, along, -np.cross(thumb, along) * sign])


REST = build_rest()


def turn(axis, angle_deg):
    """Rotation matrix about x, y or z, right-handed."""
    a = np.radians(angle_deg)
    c, s = np.cos(a), np.sin(a)
    return {"x": np.array([[1, 0, 0], [0, c, -s], [0, s, c]]),
            "y": np.array([[c, 0, s], [0, 1, 0], [-s, 0, c]]),
            "z": np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]])}[axis]


def frame(direction, hint):
    """Orthonormal columns: direction, the part of hint across it, and their cross product."""
    d = direction / np.linalg.norm(direction)
    h = hint - d * np.dot(d, hint)
    h /= np.linalg.norm(h)
    return np.column_stack([d, h, np.cross(d, h)])


class Pose:
    """World turns and joint positions, filled from the hips outwards."""

    def __init__(self, hips_shift=(0, 0, 0), hips_turn=np.eye(3)):
        self.shift = np.asarray(hips_shift, dtype=float)
        self.world = {"hips": np.asarray(hips_turn)}
        self.joint = {"hips": REST["hips"][1] + self.shift}
        self.stretch = 0.0  # metres by which a limb's target was out of reach

    def set(self, bone, world_turn):
        """Gives a bone its turn in the armature's axes; its parent must have one already."""
        self.place(bone)
        self.world[bone] = world_turn

    def bend(self, bone, local_turn):
        """Turns a bone relative to its parent."""
        self.set(bone, self.world[REST[bone][0]] @ local_turn)

    def place(self, bone):
        parent = REST[bone][0]
        self.joint[bone] = self.joint[parent] + self.world[parent] @ (REST[bone][1] - REST[parent][1])

    def reach(self, upper, lower, end, target, hint):
        """Turns two bones so that the joint `end` comes to `target`, the middle joint leaning to `hint`."""
        a, b, c = REST[upper][1], REST[lower][1], REST[end][1]
        self.place(upper)
        start, target = self.joint[upper], np.asarray(target, dtype=float)
        long_a, long_b = np.linalg.norm(b - a), np.linalg.norm(c - b)
        away = target - start
        far = np.linalg.norm(away)
        limit = (long_a + long_b) * 0.9985
        self.stretch = max(self.stretch, far - limit)
        reachable = np.clip(far, abs(long_a - long_b) + 1e-3, limit)
        away = away / far
        cosine = (long_a**2 + reachable**2 - long_b**2) / (2 * long_a * reachable)
        side = np.asarray(hint, dtype=float) - away * np.dot(away, hint)
        side /= np.linalg.norm(side)
        middle = start + away * (long_a * cosine) + side * (long_a * np.sqrt(max(0.0, 1 - cosine**2)))
        end_at = start + away * reachable
        rest_side = (b - a) - (c - a) * np.dot(b - a, c - a) / np.dot(c - a, c - a)
        self.set(upper, frame(middle - start, side) @ frame(b - a, rest_side).T)
        self.set(lower, frame(end_at - middle, side) @ frame(c - b, rest_side).T)

    def local_turns(self):
        """Each bone's turn relative to its parent, bones that were never set keeping their rest."""
        turns = {}
        for bone, (parent, _, _) in REST.items():
            if bone not in self.world:
                self.bend(bone, np.eye(3))
            turns[bone] = self.world[bone] if parent is None else self.world[parent].T @ self.world[bone]
        return turns
