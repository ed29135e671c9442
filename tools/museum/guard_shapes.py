"""Rings, lofts and subdivision: the small geometry kit that the guard is modelled with.

A part is positions, faces, one material name and, for every vertex, its share in each bone.  All frames are
Blender's: metres, +z up, the guard faces +y and his right hand is at +x.  Everything here is plain numpy in a
fixed order, so that a model built twice has the same bytes.
"""
import numpy as np


class Part:
    """A piece of the body: vertices, polygons (wound outwards), a material and skin weights by bone name."""

    def __init__(self, vertices, faces, material, weights):
        self.vertices = np.asarray(vertices, dtype=float)
        self.faces = [tuple(f) for f in faces]
        self.material = material
        self.weights = weights_matrix(weights, len(self.vertices))

    def mirrored(self):
        """The same part on the other side of the body, its bones' .R and .L exchanged."""
        flipped = Part(self.vertices * (-1, 1, 1), [f[::-1] for f in self.faces], self.material, {})
        flipped.weights = {other_side(bone): column.copy() for bone, column in self.weights.items()}
        return flipped

    def moved(self, matrix, offset):
        """Turns by a 3x3 matrix, then shifts; a matrix that mirrors turns the faces round as well."""
        if np.linalg.det(matrix) < 0:
            self.faces = [f[::-1] for f in self.faces]
        self.vertices = self.vertices @ np.asarray(matrix).T + np.asarray(offset)
        return self


def other_side(bone):
    return bone[:-2] + {".R": ".L", ".L": ".R"}[bone[-2:]] if bone[-2:] in (".R", ".L") else bone


def weights_matrix(weights, count):
    """A bone's name, a dict of shares, or a list of dicts (one a vertex) as a dict of columns."""
    if isinstance(weights, str):
        return {weights: np.ones(count)}
    if isinstance(weights, dict):
        return {bone: np.broadcast_to(np.asarray(share, dtype=float), (count,)).copy()
                for bone, share in weights.items()}
    columns = {}
    for i, shares in enumerate(weights):
        for bone, share in shares.items():
            columns.setdefault(bone, np.zeros(count))[i] = share
    return columns


def smoothstep(low, high, x):
    t = np.clip((np.asarray(x, dtype=float) - low) / (high - low), 0.0, 1.0)
    return t * t * (3.0 - 2.0 * t)


def interpolate(keys, x):
    """Smooth curve through sorted (x, y) keys: monotone in between, so profiles do not overshoot."""
    keys = np.asarray(keys, dtype=float)
    kx, ky = keys[:, 0], keys[:, 1]
    slopes = np.diff(ky) / np.diff(kx)
    tangents = np.concatenate([[slopes[0]], np.where(slopes[1:] * slopes[:-1] <= 0, 0.0,
                               2 * slopes[1:] * slopes[:-1] / (slopes[1:] + slopes[:-1] + 1e-30)), [slopes[-1]]])
    x = np.clip(np.asarray(x, dtype=float), kx[0], kx[-1])
    i = np.clip(np.searchsorted(kx, x, side="right") - 1, 0, len(kx) - 2)
    h = kx[i + 1] - kx[i]
    t = (x - kx[i]) / h
    return ((2 * t**3 - 3 * t**2 + 1) * ky[i] + (t**3 - 2 * t**2 + t) * h * tangents[i]
            + (3 * t**2 - 2 * t**3) * ky[i + 1] + (t**3 - t**2) * h * tangents[i + 1])


def ring(centre, across, along, half_across, half_along, count, power=2.0):
    """A closed superellipse; the first point lies at +along, the second towards +across."""
    angle = np.arange(count) * (2 * np.pi / count)
    s, c = np.sin(angle), np.cos(angle)
    s = np.sign(s) * np.abs(s) ** (2 / power)
    c = np.sign(c) * np.abs(c) ** (2 / power)
    return (np.asarray(centre, dtype=float) + np.outer(s * half_across, across) + np.outer(c * half_along, along))


def loft(rings, material, weights, cap_first=False, cap_last=False):
    """A tube through rings of equal count.  `weights` is one bone, a dict, or a list with one dict a ring.
    Winding: outwards when rings run against across x along (right-hand rule: downwards for x, y)."""
    count = len(rings[0])
    vertices = [p for r in rings for p in r]
    faces = []
    for i in range(len(rings) - 1):
        for k in range(count):
            n = (k + 1) % count
            faces.append((i * count + k, i * count + n, (i + 1) * count + n, (i + 1) * count + k))
    per_vertex = weights
    if isinstance(weights, list):
        per_vertex = [w for w in weights for _ in range(count)]
    for wanted, index in ((cap_first, 0), (cap_last, len(rings) - 1)):
        if not wanted:
            continue
        middle = len(vertices)
        vertices.append(np.mean(rings[index], axis=0))
        if isinstance(per_vertex, list):
            per_vertex = per_vertex + [weights[index]]
        for k in range(count):
            a, b = index * count + k, index * count + (k + 1) % count
            faces.append((middle, b, a) if index == 0 else (middle, a, b))
    return Part(vertices, faces, material, per_vertex)


def subdivided(part):
    """One Catmull-Clark step over positions and weights alike; open edges become smooth curves."""
    bones = sorted(part.weights)
    data = np.column_stack([part.vertices] + [part.weights[b] for b in bones])
    face_points = np.array([data[list(f)].mean(axis=0) for f in part.faces])
    edges, around = {}, [[] for _ in data]
    for index, face in enumerate(part.faces):
        for a, b in zip(face, face[1:] + face[:1]):
            edges.setdefault((min(a, b), max(a, b)), []).append(index)
            around[a].append(index)
    count = len(data)
    edge_index = {edge: count + len(part.faces) + i for i, edge in enumerate(edges)}
    edge_points, middles, rims = [], [[] for _ in data], [[] for _ in data]
    for (a, b), faces in edges.items():
        middle = (data[a] + data[b]) / 2
        middles[a].append(middle)
        middles[b].append(middle)
        if len(faces) == 1:
            rims[a].append(b)
            rims[b].append(a)
        edge_points.append(middle if len(faces) == 1 else (middle + face_points[faces].mean(axis=0)) / 2)
    moved = np.empty_like(data)
    for v in range(count):
        n = len(around[v])
        if rims[v]:
            moved[v] = data[v] * 0.75 + sum(data[r] for r in rims[v]) * (0.25 / len(rims[v]))
        else:
            moved[v] = (face_points[around[v]].mean(axis=0) + 2 * np.mean(middles[v], axis=0)
                        + (n - 3) * data[v]) / n
    faces = []
    for index, face in enumerate(part.faces):
        for before, here, after in zip(face[-1:] + face[:-1], face, face[1:] + face[:1]):
            faces.append((here, edge_index[min(here, after), max(here, after)], count + index,
                          edge_index[min(before, here), max(before, here)]))
    data = np.vstack([moved, face_points, np.array(edge_points)])
    fine = Part(data[:, :3], faces, part.material, {})
    fine.weights = {bone: data[:, 3 + i] for i, bone in enumerate(bones)}
    return fine


def ball(centre, radii, material, weights, around=12, rows=6):
    """An ellipsoid with axes along x, y, z."""
    centre, radii = np.asarray(centre, dtype=float), np.asarray(radii, dtype=float)
    rings = []
    for i in range(1, rows):
        polar = np.pi * i / rows
        r = np.sin(polar)
        rings.append(ring(centre + (0, 0, radii[2] * np.cos(polar)), (1, 0, 0), (0, 1, 0),
                          radii[0] * r, radii[1] * r, around))
    part = loft(rings, material, weights, True, True)
    part.vertices[-2] = centre + (0, 0, radii[2])
    part.vertices[-1] = centre - (0, 0, radii[2])
    return part


def turned(profile, centre, axis, material, weights, around=16, up=(0, 0, 1)):
    """A lathe: profile is (radius, distance along the axis); a radius of 0 closes an end."""
    axis = np.asarray(axis, dtype=float) / np.linalg.norm(axis)
    across = np.cross(np.asarray(up, dtype=float), axis)
    across /= np.linalg.norm(across)
    along = np.cross(axis, across)
    centre = np.asarray(centre, dtype=float)
    rings = [ring(centre + axis * d, across, along, max(r, 1e-5), max(r, 1e-5), around) for r, d in profile]
    return loft(rings[::-1], material, weights, profile[-1][0] == 0, profile[0][0] == 0)


def slab(half, centre, matrix, material, weights, bevel=0.25):
    """A soft-edged block: a box whose edges are bevelled by `bevel` of its least half size."""
    half = np.asarray(half, dtype=float)
    b = half.min() * bevel
    rings = []
    for inset, z in ((b, half[2]), (0, half[2] - b), (0, -half[2] + b), (b, -half[2])):
        x, y = half[0] - inset, half[1] - inset
        c = b
        rings.append(np.array([(x, -y + c, z), (x, y - c, z), (x - c, y, z), (-x + c, y, z),
                               (-x, y - c, z), (-x, -y + c, z), (-x + c, -y, z), (x - c, -y, z)][::-1]))
    return loft(rings, material, weights, True, True).moved(matrix, centre)


def stacked(parts):
    """All parts in one: vertices, faces, material name a face, and the bones' columns."""
    vertices, faces, materials, start = [], [], [], 0
    bones = sorted({bone for part in parts for bone in part.weights})
    weights = {bone: [] for bone in bones}
    for part in parts:
        vertices.append(part.vertices)
        faces += [tuple(v + start for v in face) for face in part.faces]
        materials += [part.material] * len(part.faces)
        for bone in bones:
            weights[bone].append(part.weights.get(bone, np.zeros(len(part.vertices))))
        start += len(part.vertices)
    return np.vstack(vertices), faces, materials, {b: np.concatenate(w) for b, w in weights.items()}
