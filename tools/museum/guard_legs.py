"""Trousers and boots."""
import numpy as np

from guard_shapes import Part, interpolate, loft, ring, smoothstep


def legs():
    right = [trouser(), *boot()]
    return right + [part.mirrored() for part in right]


def trouser():
    profile = [(.965, .078, .074, .060, -.006), (.90, .084, .082, .076, -.006), (.82, .090, .086, .082, -.004),
               (.74, .096, .085, .083, .000), (.66, .099, .081, .080, .004), (.60, .100, .075, .074, .008),
               (.555, .100, .071, .071, .012), (.49, .100, .067, .067, .015),
               (.46, .101, .066, .066, .012), (.375, .102, .065, .067, .000),
               (.345, .102, .052, .054, -.004)]
    rings, weights = [], []
    for z, x, half_x, half_y, y in profile:
        rings.append(ring((x, y, z), (1, 0, 0), (0, 1, 0), half_x, half_y, 14))
        knee = float(smoothstep(0.58, 0.42, z))
        root = float(smoothstep(0.84, 0.96, z)) * 0.75
        weights.append({"hips": root, "thigh.R": (1 - root) * (1 - knee), "shin.R": knee})
    return loft(rings, "guard_trousers", weights)


def boot():
    """Shaft, then rings that fan round the instep until they stand upright and run on to the toe."""
    x_axis = np.array((1.0, 0, 0))
    rings, weights = [], []

    def add(centre, along, half_x, half_along, shares, power=2.0):
        rings.append(ring(centre, x_axis, along, half_x, half_along, 12, power))
        weights.append(shares)

    for z, half_x, half_y, y in ((.372, .050, .052, -.004), (.392, .062, .066, -.002), (.402, .068, .072, -.002),
                                 (.396, .071, .076, -.002), (.30, .065, .072, -.011),
                                 (.21, .054, .060, -.014), (.165, .049, .056, -.012)):
        add((.102, y, z), (0, 1.0, 0), half_x, half_y, {"shin.R": 1.0})
    pivot = np.array((.103, .052, .128))
    for angle, far, near, half_x in ((0, .116, .004, .047), (20, .128, .004, .046), (42, .158, .006, .046),
                                     (60, .138, .008, .046), (76, .118, .010, .046), (90, .112, .014, .047)):
        a = np.radians(angle)
        away = np.array((0, -np.cos(a), -np.sin(a)))
        start, end = pivot + away * (near - .004), pivot + away * far
        end[2] = max(end[2], .018)
        foot = float(smoothstep(-10, 40, angle))
        add((start + end) / 2, -away, half_x, np.linalg.norm(end - start) / 2, {"shin.R": 1 - foot, "foot.R": foot},
            2.3)
    for y, top, half_x, x in ((.085, .104, .049, .105), (.115, .088, .051, .107), (.145, .080, .051, .108),
                              (.172, .074, .048, .108), (.192, .066, .041, .107), (.204, .052, .028, .106),
                              (.208, .042, .014, .106)):
        toe = float(smoothstep(.09, .15, y))
        low = .018 if y < .2 else .024
        add((x, y, (top + low) / 2), (0, 0, 1.0), half_x, (top - low) / 2, {"foot.R": 1 - toe, "toe.R": toe}, 2.6)
    upper = loft(rings, "guard_leather", weights, False, True)
    return [upper, sole()]


def sole():
    """Outline of the foot, a heel behind the arch, edges rounded."""
    count = 18
    angle = np.arange(count) * (2 * np.pi / count)
    y = .064 + .150 * np.cos(angle)
    width = interpolate([(-.086, .0), (-.076, .026), (-.05, .037), (-.01, .037), (.04, .036), (.09, .046),
                         (.13, .052), (.165, .049), (.195, .033), (.214, .0)], y)
    centre = interpolate([(-.086, .102), (.0, .102), (.1, .107), (.214, .107)], y)
    x = centre + np.sign(np.sin(angle)) * np.maximum(width, .004)
    outline = np.column_stack([x, y, np.zeros(count)])
    middle = np.array((.104, .064, 0))
    arch = smoothstep(.0, .012, y) * smoothstep(.075, .05, y) * .012
    rings = []
    for scale, z, follow in ((.93, .031, 0), (1.0, .026, 0), (1.02, .020, 0), (1.02, .006, 1), (.97, .0, 1)):
        points = middle + (outline - middle) * scale
        points[:, 2] = z + arch * follow
        rings.append(points)
    part = loft(rings, "guard_sole", [{}] * len(rings), True, True)
    toe = smoothstep(.085, .145, part.vertices[:, 1])
    part.weights = {"foot.R": 1 - toe, "toe.R": toe}
    return part
