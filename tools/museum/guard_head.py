"""Head and cap: a face sculpted by bumps on an egg, and a watchman's peaked cap on it."""
import numpy as np

from guard_shapes import Part, ball, interpolate, loft, ring, smoothstep, turned

MIDDLE = np.array((0.0, 0.006, 1.662))  # the egg's centre
COLUMNS = 35


def bump(x, z, at_x, at_z, size_x, size_z):
    return np.exp(-((x - at_x) / size_x) ** 2 - ((z - at_z) / size_z) ** 2)


def face_columns():
    """Angles round the head from the face (0), dense where nose, eyes and mouth need it."""
    u = np.arange(COLUMNS) / COLUMNS * 2 - 1
    return np.pi * (0.42 * u + 0.58 * np.sign(u) * np.abs(u) ** 2.2)


def sculpted(x, y, z):
    """Moves points of the egg into a face; heights are the world's, the face looks along +y."""
    front = smoothstep(0.0, 0.06, y - MIDDLE[1])
    side = np.abs(x)
    jaw = smoothstep(1.665, 1.555, z)
    x = x * (1 - 0.20 * jaw - 0.12 * smoothstep(1.60, 1.548, z) * front)
    y = y + 0.010 * jaw * front + 0.030 * smoothstep(1.64, 1.55, z) * (1 - front)
    side = np.abs(x)
    push = np.zeros_like(x)
    push += 0.0075 * bump(side, z, .027, 1.697, .020, .0085) + 0.004 * bump(x, z, 0, 1.694, .016, .010)
    push -= 0.0150 * bump(side, z, .0315, 1.6760, .0165, .0125)
    push -= 0.0030 * bump(side, z, .062, 1.690, .014, .030)
    push += 0.0060 * bump(side, z, .044, 1.648, .018, .013)
    push -= 0.0035 * bump(side, z, .046, 1.612, .014, .020)
    ridge = interpolate([(1.618, 0), (1.626, .010), (1.634, .0225), (1.640, .0250), (1.648, .0225),
                         (1.664, .0150), (1.680, .0075), (1.694, .001)], z)
    width = interpolate([(1.62, .0125), (1.636, .0120), (1.65, .0090), (1.672, .0072), (1.69, .010)], z)
    push += ridge * np.exp(-np.abs(x / width) ** 2.4)
    push += 0.0090 * bump(side, z, .0125, 1.6330, .0060, .0062)
    push -= 0.0045 * bump(side, z, .0215, 1.6300, .0050, .009)
    push += 0.0060 * bump(x, z, 0, 1.6020, .022, .0075) + 0.0065 * bump(x, z, 0, 1.5900, .019, .0062)
    push -= 0.0065 * bump(x, z, 0, 1.5960, .024, .0022)
    push -= 0.0035 * bump(x, z, 0, 1.5800, .020, .0050)
    push += 0.0095 * bump(x, z, 0, 1.5640, .019, .0120)
    push += 0.0030 * bump(side, z, .016, 1.608, .008, .012)
    return x, y + push * front, z


def skull():
    """The egg, its rows close together over the face."""
    angles = face_columns()
    heights = np.concatenate([[1.748, 1.735, 1.716], np.linspace(1.706, 1.556, 25),
                              [1.551, 1.5475, 1.546]])
    rings = []
    for z in heights:
        up = (z - MIDDLE[2]) / .1185
        level = np.sqrt(max(0.0, 1 - abs(up) ** 2.5)) ** 0.86
        x = np.sin(angles) * .0775 * level
        y = MIDDLE[1] - .004 + np.cos(angles) * np.where(np.cos(angles) > 0, .0940, .1000) * level
        rings.append(np.column_stack(sculpted(x, y, np.full(COLUMNS, z))))
    return loft(rings, "guard_skin", "head", True, True)


def neck():
    profile = [(1.600, .050, .052, -.006), (1.570, .052, .055, -.008), (1.540, .055, .058, -.012),
               (1.500, .064, .062, -.016), (1.470, .080, .060, -.016)]
    rings = [ring((0, y, z), (1, 0, 0), (0, 1, 0), hx, hy, 14) for z, hx, hy, y in profile]
    shares = [{"head": float(s), "neck": float(1 - s)} for s in (.75, .45, .1, 0, 0)]
    shares[-1] = {"neck": .4, "chest": .6}
    shirt = [ring((0, -.010, z), (1, 0, 0), (0, 1, 0), hx, hy, 16)
             for z, hx, hy in ((1.556, .057, .060), (1.560, .061, .064), (1.53, .064, .068), (1.49, .070, .074))]
    throat = [{"neck": 1.0}] * 3 + [{"neck": .5, "chest": .5}]
    knot = turned([(0, .0), (.010, .001), (.016, .02), (.019, .036), (.012, .046), (0, .048)],
                  (0, .060, 1.503), (0, .16, 1), "guard_tie", {"neck": .6, "chest": .4}, 10, (0, 1, 0))
    tie = [ring((0, .083 + s * .020, 1.505 - s * .155), (1, 0, 0), (0, 1, 0), .009 + .016 * s, .006, 10)
           for s in (0, .12, .4, .7, 1.0)]
    shape = loft(tie, "guard_tie", [{"neck": .4, "chest": .6}] + [{"chest": 1.0}] * 4, True, True)
    return [loft(rings, "guard_skin", shares), loft(shirt, "guard_shirt", throat), knot, shape]


def features():
    """Eyes with lids, brows, moustache, ears, sideburns and the hair below the cap."""
    parts = []
    for sign in (1, -1):
        eye = np.array((sign * .0315, .0800, 1.6755))
        parts.append(ball(eye, (.0118, .0118, .0118), "guard_eye", "head", 10, 6))
        iris = turned([(0, .0122), (.0035, .0118), (.0052, .0107), (.0054, .0098)][::-1], eye,
                      (sign * .05, 1, -.04), "guard_iris", "head", 10)
        parts.append(iris)
        for up, lift, tilt in ((1, .0006, .46), (-1, .0004, .62)):
            parts.append(lid(eye, .0128 + lift, up, tilt))
        parts.append(strand([(.008, .1015, 1.6935), (.022, .1040, 1.6985), (.036, .0965, 1.6985), (.047, .0850, 1.6930)],
                            [.0030, .0048, .0042, .0018], sign, .0040, "guard_hair"))
        parts.append(strand([(.0, .1080, 1.6165), (.012, .1075, 1.6140), (.026, .1000, 1.6085), (.038, .0905, 1.6045),
                             (.044, .0840, 1.6070)], [.0072, .0082, .0070, .0044, .0012], sign, .0060, "guard_hair"))
        parts += ear(sign)
    return parts + [hair()]


def lid(eye, radius, up, edge):
    """A shell over the upper or lower part of an eyeball; `edge` is how far from its equator it ends."""
    rows = []
    for polar in np.linspace(0.2, np.pi / 2 - edge * .78, 4):
        angle = np.linspace(-1.45, 1.45, 8)
        z = np.cos(polar) * up
        rows.append(np.column_stack([np.sin(angle) * np.sin(polar), np.cos(angle) * np.sin(polar),
                                     np.full(8, z)]) * radius + eye)
    vertices = np.vstack(rows)
    faces = [(r * 8 + k, (r + 1) * 8 + k, (r + 1) * 8 + k + 1, r * 8 + k + 1) for r in range(3) for k in range(7)]
    return Part(vertices, faces if up > 0 else [f[::-1] for f in faces], "guard_skin", "head")


def strand(path, radii, sign, depth, material):
    """A tapering lock along a path on the right half of the face, mirrored for sign -1."""
    path = np.array(path)
    rings = []
    for i, (p, r) in enumerate(zip(path, radii)):
        tangent = path[min(i + 1, len(path) - 1)] - path[max(i - 1, 0)]
        tangent /= np.linalg.norm(tangent)
        up = np.array((0, 0, 1.0)) - tangent * tangent[2]
        up /= np.linalg.norm(up)
        rings.append(ring(p, np.cross(tangent, up), up, min(depth, r), r, 8)[::-1])
    part = loft(rings, material, "head", True, True)
    if np.einsum("ij,ij->i", part.vertices - part.vertices.mean(axis=0), outward(part)).sum() < 0:
        part.faces = [f[::-1] for f in part.faces]
    if sign < 0:
        part = part.mirrored()
    return part


def outward(part):
    """Area-weighted vertex normals."""
    normals = np.zeros_like(part.vertices)
    for f in part.faces:
        n = np.cross(part.vertices[f[1]] - part.vertices[f[0]], part.vertices[f[2]] - part.vertices[f[0]])
        for v in f:
            normals[v] += n
    return normals


def ear(sign):
    """A shell with a rolled rim and a hollow, leaning back a little."""
    rings = []
    for scale, lift in ((.55, -.004), (1.0, -.001), (1.06, .006), (.98, .0105), (.80, .0085), (.55, .0035), (.2, .0025)):
        angle = np.arange(13) * (2 * np.pi / 13)
        reach = .0155 + .0035 * np.sin(angle) * (np.sin(angle) > 0)
        points = np.column_stack([np.full(13, lift), np.cos(angle) * reach * scale,
                                  np.sin(angle) * (.0310 - .004 * (np.sin(angle) < 0)) * scale])
        points[:, 0] += .009 * smoothstep(.005, -.018, points[:, 1]) - .001
        points[:, 1] += .096 * points[:, 2]
        rings.append(points)
    part = loft(rings, "guard_skin", "head", True, True)
    lobe = part.moved(np.eye(3), (.0745, -.006, 1.662))
    if np.einsum("ij,ij->i", lobe.vertices - lobe.vertices.mean(axis=0), outward(lobe)).sum() < 0:
        lobe.faces = [f[::-1] for f in lobe.faces]
    return [lobe if sign > 0 else lobe.mirrored()]


def hair():
    """A close-cropped cap of hair from temple to nape, hugging the skull outside the face."""
    angle = np.linspace(0.42 * np.pi, 1.58 * np.pi, 17)
    rows = []
    for u, lift in ((0, .001), (.08, .0065), (.4, .0085), (.75, .008), (.95, .0065), (1.0, -.002)):
        behind = smoothstep(0.46 * np.pi, 0.74 * np.pi, np.minimum(angle, 2 * np.pi - angle))
        bottom = 1.668 - .098 * behind
        z = 1.745 + (bottom - 1.745) * u
        level = np.sqrt(np.maximum(0, 1 - (np.abs(z - MIDDLE[2]) / .1185) ** 2.5)) ** .86
        x = np.sin(angle) * (.0775 * level)
        y = MIDDLE[1] - .004 + np.cos(angle) * np.where(np.cos(angle) > 0, .094, .100) * level
        x, y, z = sculpted(x, y, z)
        out = np.column_stack([np.sin(angle), np.cos(angle), 0 * angle])
        rows.append(np.column_stack([x, y, z]) + out * lift)
    vertices = np.vstack(rows)
    n = len(angle)
    faces = [(r * n + k, r * n + k + 1, (r + 1) * n + k + 1, (r + 1) * n + k) for r in range(5) for k in range(n - 1)]
    return Part(vertices, faces, "guard_hair", "head")


def cap():
    """Band, swelling crown with a piped seam, glossy peak, strap and badge; tipped slightly forwards."""
    def tilted(part):
        a = np.radians(-5.0)
        matrix = np.array([(1, 0, 0), (0, np.cos(a), -np.sin(a)), (0, np.sin(a), np.cos(a))])
        centre = np.array((0, 0, 1.72))
        part.vertices = (part.vertices - centre) @ matrix.T + centre - (0, 0, .0029)
        return part

    def rings(profile):
        return [ring((0, y, z), (1, 0, 0), (0, 1, 0), hx, hy, 25, 2.1) for z, hx, hy, y in profile]

    crown = rings([(1.8165, .020, .022, -.006), (1.8170, .060, .068, -.004), (1.8130, .098, .108, -.002),
                   (1.8040, .1170, .1260, .000), (1.7960, .1225, .1310, .000), (1.7900, .1215, .1300, .000),
                   (1.7780, .1080, .1180, .001), (1.7560, .0875, .1060, .001),
                   (1.7540, .0840, .1030, .001)])
    parts = [loft(crown, "guard_cap", "head", True, False)]
    piping = rings([(1.7995, .1205, .1292, 0), (1.7985, .1245, .1330, 0), (1.7950, .1250, .1338, 0),
                    (1.7925, .1210, .1296, 0)])
    parts.append(loft(piping, "guard_collar", "head"))
    band = rings([(1.7620, .0880, .1060, .001), (1.7600, .0905, .1085, .001), (1.7240, .0865, .1065, .001),
                  (1.7180, .0850, .1050, .001), (1.7190, .0800, .1000, .001), (1.7350, .0780, .0980, .001)])
    parts.append(loft(band, "guard_capband", "head"))
    parts.append(peak())
    strap = [ring((0, .001, z), (1, 0, 0), (0, 1, 0), hx, hy, 26, 2.1) for z, hx, hy in
             ((1.7330, .0878, .1072), (1.7325, .0900, .1095), (1.7245, .0892, .1090), (1.7240, .0868, .1066))]
    parts.append(loft(strap, "guard_leather", "head"))
    for sign in (1, -1):
        parts.append(ball((sign * .0845, .036, 1.729), (.0075, .0075, .0075), "guard_brass", "head", 8, 5))
    parts.append(ball((0, .1100, 1.7500), (.0130, .0050, .0160), "guard_brass", "head", 10, 6))
    parts.append(ball((0, .1150, 1.7500), (.0060, .0040, .0075), "guard_brass", "head", 8, 5))
    return [tilted(part) for part in parts]


def peak():
    """The visor: a curved leaf that leaves the band all along its front, with a thickness."""
    around = np.linspace(-1.12, 1.12, 17)
    rows = []
    for u, lift in ((0, .003), (.35, .0035), (.7, .003), (.93, .0022), (1.0, .0), (.97, -.0020), (.6, -.0024), (0, -.0024)):
        length = .060 * (1 - (np.abs(around) / 1.12) ** 2.6)
        hx, hy = .0845, .1045
        base = np.column_stack([np.sin(around) * hx, np.cos(around) * hy + .001, np.full(17, 1.7215)])
        out = np.column_stack([np.sin(around) * .62, np.cos(around) ** .7 * 1.0, -.47 + .22 * np.abs(np.sin(around)) ** 2])
        points = base + out * (length * u)[:, None]
        points[:, 2] += lift - .030 * (np.sin(around) ** 2) * u * .5
        rows.append(points)
    vertices = np.vstack(rows)
    faces = [(r * 17 + k, r * 17 + k + 1, (r + 1) * 17 + k + 1, (r + 1) * 17 + k) for r in range(7) for k in range(16)]
    return Part(vertices, faces, "guard_peak", "head")


def head():
    return [skull(), *neck(), *features(), *cap()]
