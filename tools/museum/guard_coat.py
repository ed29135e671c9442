"""The watchman's coat: one garment from collar to hem with set-in sleeves, and all that is sewn onto it."""
import numpy as np

from guard_bones import REST
from guard_shapes import Part, ball, interpolate, loft, ring, slab, smoothstep, subdivided

AROUND = 12          # points of the cage's rings; subdivision doubles them
SIDE = AROUND // 4   # the ring's point at the right side
# height, half width, half depth, middle's y
TORSO = [(1.528, .068, .066, -.014), (1.502, .096, .078, -.016), (1.482, .146, .092, -.016),
         (1.456, .178, .104, -.014), (1.410, .190, .116, -.010), (1.360, .188, .124, -.006),
         (1.305, .184, .126, -.004), (1.215, .174, .123, -.002), (1.130, .162, .118, .000),
         (1.080, .158, .114, .002), (1.030, .158, .114, .002), (0.985, .170, .122, .000),
         (0.920, .188, .136, -.002), (0.810, .204, .152, -.005),
         (0.690, .216, .166, -.008), (0.662, .218, .168, -.008)]
ARM_ROWS = (3, 6)    # the sleeve is set in between these rings


def torso_weights(x, z):
    """Shares of the trunk's bones, and below the belt of the thighs that push the skirt."""
    shares = {}
    skirt = float(smoothstep(0.97, 0.74, z)) * 0.82
    chest = float(smoothstep(1.12, 1.27, z))
    spine = float(smoothstep(0.97, 1.09, z)) * (1 - chest)
    neck = float(smoothstep(1.49, 1.54, z)) * 0.35
    shoulder = float(smoothstep(0.07, 0.17, abs(x)) * smoothstep(1.36, 1.46, z)) * 0.6
    right = float(smoothstep(-0.085, 0.085, x))
    shares["hips"] = (1 - chest - spine) * (1 - skirt)
    shares["spine"], shares["chest"] = spine, chest * (1 - neck) * (1 - shoulder)
    shares["neck"] = chest * neck * (1 - shoulder)
    shares["clavicle.R" if x > 0 else "clavicle.L"] = chest * shoulder
    shares["thigh.R"], shares["thigh.L"] = skirt * right, skirt * (1 - right)
    return shares


def arm_point(t):
    """A point `t` metres from the shoulder down the arm at rest, and the arm's direction there."""
    a, b, c = (REST[bone][1] for bone in ("upper_arm.R", "forearm.R", "hand.R"))
    upper, lower = np.linalg.norm(b - a), np.linalg.norm(c - b)
    first, second = (b - a) / upper, (c - b) / lower
    blend = smoothstep(upper - 0.05, upper + 0.05, t)
    direction = first * (1 - blend) + second * blend
    return (a + first * t if t < upper else b + second * (t - upper)), direction / np.linalg.norm(direction)


def arm_weights(t):
    elbow = float(smoothstep(0.235, 0.340, t))
    root = float(smoothstep(0.0, 0.11, t))
    return {"clavicle.R": (1 - root) * 0.6, "chest": (1 - root) * 0.4, "upper_arm.R": root * (1 - elbow),
            "forearm.R": elbow}


SLEEVE = [(.068, .076, .072), (.120, .072, .068), (.190, .066, .064), (.250, .062, .060), (.287, .061, .060),
          (.325, .060, .058), (.390, .055, .053), (.446, .051, .050), (.453, .061, .059), (.516, .062, .060),
          (.524, .057, .055), (.490, .044, .042)]


def coat():
    """The cage of trunk, skirt and both sleeves in one surface, smoothed once."""
    rings = [ring((0, cy, z), (1, 0, 0), (0, 1, 0), hx, hy, AROUND, 2.25) for z, hx, hy, cy in TORSO]
    for z, hx, hy, inset in ((.664, .218, .168, .007), (.72, .213, .162, .012)):
        rings.append(ring((0, -.008, z), (1, 0, 0), (0, 1, 0), hx - inset, hy - inset, AROUND, 2.25))
    body = loft(rings, "guard_coat", [{}] * len(rings))
    vertices = list(body.vertices)
    weights = [torso_weights(x, z) for x, _, z in vertices]
    first, last = ARM_ROWS
    open_columns = {SIDE - 1, SIDE, 3 * SIDE - 1, 3 * SIDE}
    faces = [f for i, f in enumerate(body.faces)
             if not (first <= i // AROUND < last and i % AROUND in open_columns)]
    for sign in (1, -1):
        column = SIDE if sign > 0 else 3 * SIDE
        back, front = column + sign, column - sign
        rows = range(first, last + 1)
        loop = ([first * AROUND + column] + [r * AROUND + back for r in rows]
                + [last * AROUND + column] + [r * AROUND + front for r in reversed(rows)])
        for v in loop:
            low = float(smoothstep(1.46, 1.31, vertices[v][2]))
            name = "R" if sign > 0 else "L"
            share = 0.42 - 0.14 * low
            weights[v] = {bone: w * (1 - share) for bone, w in weights[v].items()}
            weights[v]["upper_arm." + name] = share
        for t, half_up, half_across in SLEEVE:
            at, direction = arm_point(t)
            up = np.cross(direction, (0, 1.0, 0))
            up /= np.linalg.norm(up)
            points = ring(at, np.cross(direction, up), up, half_across, half_up, len(loop))
            shares = arm_weights(t)
            if sign < 0:
                points = points * (-1, 1, 1)
                shares = {b.replace(".R", ".L"): w for b, w in shares.items()}
            start = len(vertices)
            vertices += list(points)
            weights += [shares] * len(points)
            new = list(range(start, len(vertices)))
            for k in range(len(loop)):
                n = (k + 1) % len(loop)
                quad = (loop[k], loop[n], new[n], new[k])
                faces.append(quad if sign > 0 else quad[::-1])
            loop = new
    used = sorted({v for f in faces for v in f})
    index = {v: i for i, v in enumerate(used)}
    cage = Part([vertices[v] for v in used], [tuple(index[v] for v in f) for f in faces], "guard_coat",
                [weights[v] for v in used])
    return subdivided(cage)


def project(part, origins, direction):
    """Where rays first meet a part: point, normal and weights of each; misses are None."""
    direction = np.asarray(direction, dtype=float)
    triangles = np.array([(f[0], f[i], f[i + 1]) for f in part.faces for i in range(1, len(f) - 1)])
    a, b, c = (part.vertices[triangles[:, i]] for i in range(3))
    normal = np.cross(b - a, c - a)
    facing = normal @ direction
    keep = facing < -1e-12
    a, b, c, normal, facing, triangles = (v[keep] for v in (a, b, c, normal, facing, triangles))
    found = []
    for origin in np.asarray(origins, dtype=float):
        t = np.einsum("ij,ij->i", a - origin, normal) / facing
        p = origin + t[:, None] * direction
        area = np.einsum("ij,ij->i", normal, normal)
        u = np.einsum("ij,ij->i", np.cross(b - a, p - a), normal) / area
        v = np.einsum("ij,ij->i", np.cross(c - b, p - b), normal) / area
        inside = (u > -1e-6) & (v > -1e-6) & (u + v < 1 + 1e-6) & (t > 0)
        if not inside.any():
            found.append(None)
            continue
        i = int(np.argmin(np.where(inside, t, np.inf)))
        share = np.array([v[i], 1 - u[i] - v[i], u[i]])
        weights = {bone: float(column[triangles[i]] @ share) for bone, column in part.weights.items()}
        found.append((p[i], normal[i] / np.linalg.norm(normal[i]), weights))
    return found


def layer(part, grid, direction, thickness, material):
    """A cloth patch that lies on `part`: `grid` is rows x columns x 3 ray origins; its rim sinks in."""
    grid = np.asarray(grid, dtype=float)
    rows, columns = grid.shape[:2]
    hits = project(part, grid.reshape(-1, 3), direction)
    vertices, weights = [], []
    for i, hit in enumerate(hits):
        if hit is None:
            raise ValueError("a cloth patch reaches beyond the coat")
        row, column = divmod(i, columns)
        rim = row in (0, rows - 1) or column in (0, columns - 1)
        vertices.append(hit[0] + hit[1] * (-0.003 if rim else thickness))
        weights.append(hit[2])
    faces = [(r * columns + c, r * columns + c + 1, (r + 1) * columns + c + 1, (r + 1) * columns + c)
             for r in range(rows - 1) for c in range(columns - 1)]
    first = faces[len(faces) // 2]
    a, b, c = (vertices[i] for i in first[:3])
    if np.dot(np.cross(b - a, c - a), direction) > 0:
        faces = [f[::-1] for f in faces]
    return Part(vertices, faces, material, weights)


def rimmed(values, edge):
    """Repeats the ends a little inwards, so that a patch has a rim to sink."""
    values = list(values)
    return [values[0], values[0] + edge, *values[1:-1], values[-1] - edge, values[-1]]


def front_patch(part, outline, heights, thickness, material, columns=4):
    """A patch on the coat's front between outline(z) = (left x, right x)."""
    grid = []
    for z in heights:
        low, high = outline(z)
        xs = rimmed(np.linspace(low, high, columns), 0.004)
        grid.append([(x, 0.6, z) for x in xs])
    return layer(part, grid, (0, -1, 0), thickness, material)


def trimmings(cloth):
    """Facing, shirt, lapels, pocket flaps, shoulder straps, back pleat, belt with buckle, buttons, collar."""
    parts = []
    heights = rimmed(np.linspace(0.675, 1.350, 12), 0.005)
    parts.append(front_patch(cloth, lambda z: (-0.058 - 0.02 * max(0, 1.0 - z), 0.070 + 0.02 * max(0, 1.0 - z)),
                             heights, 0.006, "guard_coat", 5))
    throat = [(1.30, .008), (1.49, .060)]  # half width of the shirt that shows, by height
    parts.append(front_patch(cloth, lambda z: (-float(interpolate(throat, z)), float(interpolate(throat, z))),
                             rimmed(np.linspace(1.320, 1.490, 6), 0.004), 0.005, "guard_shirt", 4))
    for sign in (1, -1):
        def edge(z, s=sign):
            inner = interpolate([(1.30, .006), (1.40, .022), (1.49, .052)], z)
            outer = interpolate([(1.30, .020), (1.42, .098), (1.445, .104), (1.455, .084), (1.49, .078)], z)
            return tuple(sorted((s * float(inner), s * float(outer))))
        parts.append(front_patch(cloth, edge, rimmed(np.linspace(1.30, 1.485, 9), 0.004), 0.011, "guard_collar"))
        parts.append(front_patch(cloth, lambda z, s=sign: tuple(sorted((s * 0.080, s * 0.155))),
                                 rimmed(np.linspace(0.895, 0.940, 3), 0.004), 0.006, "guard_coat"))
        grid = [[(x, y, 1.8) for y in rimmed(np.linspace(0.012, -0.036, 3), -0.003)]
                for x in rimmed(sign * np.linspace(0.092, 0.180, 5), sign * 0.004)]
        strap = layer(cloth, grid, (0, 0, -1), 0.006, "guard_collar")
        parts.append(strap)
        hit = project(cloth, [(sign * 0.105, -0.012, 1.8)], (0, 0, -1))[0]
        parts.append(button(hit, 0.006, 0.008))
    for z in (1.275, 1.185, 1.105, 0.965, 0.875):
        for x in (-0.044, 0.052):
            parts.append(button(project(cloth, [(x, 0.6, z)], (0, -1, 0))[0], 0.0105, 0.0045))
    pleat = [[(x, -0.6, z) for x in rimmed((0.011, -0.011), -0.003)] for z in rimmed(np.linspace(0.675, 1.43, 10), 0.004)]
    parts.append(layer(cloth, pleat, (0, 1, 0), 0.005, "guard_coat"))
    return parts + belt() + collar()


def button(hit, radius, lift):
    point, normal, weights = hit
    disc = ball((0, 0, 0), (radius, radius, radius * 0.5), "guard_brass", weights, 8, 4)
    side = np.cross((0, 0, 1.0) if abs(normal[2]) < 0.8 else (0, 1.0, 0), normal)
    side /= np.linalg.norm(side)
    return disc.moved(np.column_stack([side, np.cross(normal, side), normal]), point + normal * lift)


def belt():
    """Leather round the waist, its section rounded, and a brass buckle."""
    rings = []
    for z, out in ((1.072, .0), (1.073, .007), (1.066, .010), (1.034, .010), (1.027, .007), (1.028, .0)):
        rings.append(ring((0, .002, z), (1, 0, 0), (0, 1, 0), .158 + out, .114 + out, 28, 2.25))
    shares = [torso_weights(0.0, 1.05)] * len(rings)
    parts = [loft(rings, "guard_leather", shares)]
    frame = slab((.027, .026, .004), (0, 0, 0), np.eye(3), "guard_brass", torso_weights(0.0, 1.05), 0.5)
    plate = slab((.017, .015, .004), (0, 0, 0.002), np.eye(3), "guard_leather", torso_weights(0.0, 1.05), 0.5)
    upright = np.column_stack([(-1, 0, 0), (0, 0, 1), (0, 1, 0)])
    for part in (frame, plate):
        parts.append(part.moved(upright, (0.004, 0.128, 1.05)))
    pouch = slab((.036, .034, .016), (0, 0, 0), np.eye(3), "guard_leather", torso_weights(-0.14, 1.03), 0.6)
    turned = np.column_stack([(-.62, -.785, 0), (0, 0, 1), (-.785, .62, 0)])
    parts.append(pouch.moved(turned, (-0.130, 0.098, 1.035)))
    return parts


def collar():
    """A stand-and-fall collar, open at the throat."""
    profile = [(1.512, .074, .072), (1.548, .069, .070), (1.566, .071, .073), (1.560, .080, .082),
               (1.528, .092, .094), (1.505, .103, .100), (1.502, .099, .096)]
    count, rows = 19, []
    for z, hx, hy in profile:
        opening = 0.28 + 1.6 * (1.566 - z) * 3.2
        angle = np.linspace(opening, 2 * np.pi - opening, count)
        dip = 0.022 * smoothstep(0.2, 1.0, np.cos(angle))
        rows.append(np.column_stack([np.sin(angle) * hx, np.cos(angle) * hy - .014, z - dip]))
    vertices = np.vstack(rows)
    faces = [(r * count + k, (r + 1) * count + k, (r + 1) * count + k + 1, r * count + k + 1)
             for r in range(len(rows) - 1) for k in range(count - 1)]
    share = smoothstep(1.50, 1.56, vertices[:, 2]) * 0.5
    return [Part(vertices, faces, "guard_collar", {"neck": share, "chest": 1 - share})]
