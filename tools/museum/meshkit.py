"""Shapes as plain lists, and the few ways a museum is made of them: blocks with bevelled edges, turned profiles,
mouldings swept along walls, tubes. Nothing here touches Blender except `to_mesh`, so the same numbers give the same
bytes. Metres, z up. A face's material is a name of palette.MATERIALS; a face without uv is mapped from the box
axis it faces most, one texture repeat every `tile` metres of its material.
"""
import math

import bpy

import palette


class Shape:
    def __init__(self):
        self.points = []  # (x, y, z)
        self.faces = []   # (corner indices, material, corner uvs or None)
        self.normals = {}  # of points whose true normal is known: index -> unit vector

    def face(self, corners, material, uvs=None):
        self.faces.append((tuple(corners), material, uvs))

    def add(self, *others):
        for other in others:
            base = len(self.points)
            self.points += other.points
            self.normals.update({i + base: n for i, n in other.normals.items()})
            self.faces += [(tuple(i + base for i in c), m, uv) for c, m, uv in other.faces]
        return self

    def mapped(self, change):
        assert not self.normals, "a shape with normals can only be moved"
        out = Shape()
        out.points = [change(p) for p in self.points]
        out.faces = list(self.faces)
        return out

    def moved(self, x=0.0, y=0.0, z=0.0):
        out = Shape()
        out.points = [(p[0] + x, p[1] + y, p[2] + z) for p in self.points]
        out.faces, out.normals = list(self.faces), dict(self.normals)
        return out

    def scaled(self, x, y=None, z=None):
        y, z = (x, x) if y is None else (y, z)
        return self.mapped(lambda p: (p[0] * x, p[1] * y, p[2] * z))

    def turned(self, degrees, axis="z"):
        c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
        if axis == "z":
            return self.mapped(lambda p: (c * p[0] - s * p[1], s * p[0] + c * p[1], p[2]))
        if axis == "x":
            return self.mapped(lambda p: (p[0], c * p[1] - s * p[2], s * p[1] + c * p[2]))
        return self.mapped(lambda p: (c * p[0] + s * p[2], p[1], c * p[2] - s * p[0]))


def joined(shapes):
    return Shape().add(*shapes)


def block(x0, y0, z0, x1, y1, z1, material, bevel=0.01):
    """A box whose twelve edges are cut off at 45 degrees: no edge in the museum is a knife's."""
    b = min(bevel, 0.45 * min(x1 - x0, y1 - y0, z1 - z0))
    b = 0.0 if b < 0.0085 else b  # finer than a pixel two metres off, and four times the triangles
    low, high = (x0, y0, z0), (x1, y1, z1)
    shape, index = Shape(), {}
    signs = [(i, j, k) for i in (0, 1) for j in (0, 1) for k in (0, 1)]
    for s in signs:  # every corner becomes three points, one on each face that met there
        for axis in range(3):
            p = [(high[a] - (0 if a == axis else b)) if s[a] else (low[a] + (0 if a == axis else b)) for a in range(3)]
            index[s, axis] = len(shape.points)
            shape.points.append(tuple(p))

    def at(axis, side, u, v):
        s = [0, 0, 0]
        s[axis], s[(axis + 1) % 3], s[(axis + 2) % 3] = side, u, v
        return tuple(s)

    for axis in range(3):
        ring = [(0, 0), (1, 0), (1, 1), (0, 1)]
        shape.face([index[at(axis, 1, u, v), axis] for u, v in ring], material)
        shape.face([index[at(axis, 0, u, v), axis] for u, v in reversed(ring)], material)
        if b == 0.0:
            continue
        second, third = (axis + 1) % 3, (axis + 2) % 3
        for u in (0, 1):  # the edge along `axis` where faces `second` (side u) and `third` (side v) met
            for v in (0, 1):
                quad = [index[at(axis, 0, u, v), second], index[at(axis, 1, u, v), second],
                        index[at(axis, 1, u, v), third], index[at(axis, 0, u, v), third]]
                shape.face(quad if u != v else quad[::-1], material)
    if b > 0.0:
        for s in signs:
            corner = [index[s, 0], index[s, 1], index[s, 2]]
            shape.face(corner if sum(s) % 2 == 1 else corner[::-1], material)
    return shape


def raised_panel(x0, z0, x1, z1, y, height, slope, material):
    """A field that stands out of a wall to -y from the plane `y`, its four edges sloped: no back, it lies on the wall."""
    shape, front = Shape(), y - height
    shape.points = [(x0, y, z0), (x1, y, z0), (x1, y, z1), (x0, y, z1),
                    (x0 + slope, front, z0 + slope), (x1 - slope, front, z0 + slope), (x1 - slope, front, z1 - slope), (x0 + slope, front, z1 - slope)]
    shape.face([4, 5, 6, 7], material)
    for i in range(4):
        j = (i + 1) % 4
        shape.face([i, j, 4 + j, 4 + i], material)
    return shape


def slab(width, depth, height, material, bevel=0.01, z=0.0):
    """A block centred in plan that stands on z."""
    return block(-width / 2, -depth / 2, z, width / 2, depth / 2, z + height, material, bevel)


def lathe(profile, material, segments=24, flutes=None):
    """The profile [(radius, z), ...] from the bottom up, turned about z. A radius of 0 closes an end.
    `flutes` maps an angle and a point's place in the profile to a factor of the radius."""
    shape, rings = Shape(), []
    tile = palette.tile_of(material)
    length, travelled = 0.0, [0.0]
    for (r0, z0), (r1, z1) in zip(profile, profile[1:]):
        length += math.hypot(r1 - r0, z1 - z0)
        travelled.append(length)
    widest = max(r for r, _ in profile)
    around = max(1.0, round(2 * math.pi * widest / tile)) if tile else 1.0
    for place, (r, z) in enumerate(profile):
        if r == 0.0:
            rings.append([len(shape.points)])
            shape.points.append((0.0, 0.0, z))
            continue
        rings.append([len(shape.points) + i for i in range(segments)])
        for i in range(segments):
            a = 2 * math.pi * i / segments
            radius = r * (flutes(a, place) if flutes else 1.0)
            shape.points.append((radius * math.cos(a), radius * math.sin(a), z))
    for k in range(len(profile) - 1):
        low, high = rings[k], rings[k + 1]
        v0, v1 = travelled[k] / (tile or 1.0), travelled[k + 1] / (tile or 1.0)
        for i in range(segments):
            j, u0, u1 = (i + 1) % segments, around * i / segments, around * (i + 1) / segments
            if len(low) == 1 and len(high) == 1:
                continue
            if len(low) == 1:
                shape.face([low[0], high[j], high[i]], material, [((u0 + u1) / 2, v0), (u1, v1), (u0, v1)])
            elif len(high) == 1:
                shape.face([low[i], low[j], high[0]], material, [(u0, v0), (u1, v0), ((u0 + u1) / 2, v1)])
            else:
                shape.face([low[i], low[j], high[j], high[i]], material, [(u0, v0), (u1, v0), (u1, v1), (u0, v1)])
    return shape


def ball(radius, material, segments=16, rings=10):
    return lathe([(radius * math.sin(math.pi * i / rings) if 0 < i < rings else 0.0,
                   -radius * math.cos(math.pi * i / rings)) for i in range(rings + 1)], material, segments)


def tube(path, radius, material, segments=10, closed=False):
    """A round bar along the points of `path`; its frame is carried along so that it does not twist."""
    shape, count = Shape(), len(path)

    def unit(v):
        n = math.sqrt(sum(c * c for c in v)) or 1.0
        return tuple(c / n for c in v)

    def cross(a, b):
        return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])

    def ahead(i):
        a = path[(i - 1) % count] if closed or i > 0 else path[i]
        b = path[(i + 1) % count] if closed or i < count - 1 else path[i]
        return unit([q - p for p, q in zip(a, b)])

    forward = ahead(0)
    side = unit(cross(forward, (0, 0, 1) if abs(forward[2]) < 0.9 else (1, 0, 0)))
    for i in range(count):
        forward = ahead(i)
        up = unit(cross(side, forward))
        side = unit(cross(forward, up))
        r = radius[i] if isinstance(radius, (list, tuple)) else radius
        for k in range(segments):
            a = 2 * math.pi * k / segments
            shape.points.append(tuple(p + r * (math.cos(a) * s + math.sin(a) * u)
                                      for p, s, u in zip(path[i], side, up)))
    for i in range(count if closed else count - 1):
        n = (i + 1) % count
        for k in range(segments):
            j = (k + 1) % segments
            shape.face([i * segments + j, i * segments + k, n * segments + k, n * segments + j], material)
    if not closed:
        shape.face(list(range(segments)), material)
        shape.face([(count - 1) * segments + k for k in reversed(range(segments))], material)
    return shape


def sweep(profile, path, material, closed=False):
    """A moulding: the profile [(out, up), ...] carried along the plan path [(x, y), ...], mitred at its corners.
    `out` points to the left of the path's direction. Profiles run so that their outside is on the right of out->up
    turned counter-clockwise, that is clockwise seen along the path."""
    shape, count = Shape(), len(path)

    def left(a, b):
        d = math.hypot(b[0] - a[0], b[1] - a[1])
        return (-(b[1] - a[1]) / d, (b[0] - a[0]) / d)

    for i in range(count):
        before = left(path[i - 1], path[i]) if closed or i > 0 else None
        after = left(path[i], path[(i + 1) % count]) if closed or i < count - 1 else None
        before, after = before or after, after or before
        scale = 1.0 + before[0] * after[0] + before[1] * after[1]
        mitre = ((before[0] + after[0]) / scale, (before[1] + after[1]) / scale)
        for out, up in profile:
            shape.points.append((path[i][0] + mitre[0] * out, path[i][1] + mitre[1] * out, up))
    ring = len(profile)
    for i in range(count if closed else count - 1):
        n = (i + 1) % count
        for k in range(ring):
            j = (k + 1) % ring
            shape.face([i * ring + k, i * ring + j, n * ring + j, n * ring + k], material)
    if not closed:
        shape.face(list(reversed(range(ring))), material)
        shape.face([(count - 1) * ring + k for k in range(ring)], material)
    return shape


def extruded(outline, z0, z1, material):
    """The plan outline [(x, y), ...], counter-clockwise, standing from z0 to z1."""
    shape, n = Shape(), len(outline)
    shape.points = [(x, y, z0) for x, y in outline] + [(x, y, z1) for x, y in outline]
    shape.face(list(reversed(range(n))), material)
    shape.face([n + i for i in range(n)], material)
    for i in range(n):
        j = (i + 1) % n
        shape.face([i, j, n + j, n + i], material)
    return shape


def picture(width, height, material):
    """A flat upright pane in the xz plane, centred, facing -y, carrying one whole picture."""
    shape = Shape()
    w, h = width / 2, height / 2
    shape.points = [(-w, 0, -h), (w, 0, -h), (w, 0, h), (-w, 0, h)]
    shape.face([0, 1, 2, 3], material, [(0, 0), (1, 0), (1, 1), (0, 1)])
    return shape


def _box_uv(points, normal, material):
    tile = palette.tile_of(material) or 1.0
    axis = max(range(3), key=lambda a: abs(normal[a]))
    u, v = [(1, 2), (0, 2), (0, 1)][axis]
    if palette.has_grain(material):
        spread = [max(p[a] for p in points) - min(p[a] for p in points) for a in (u, v)]
        if spread[1] > spread[0]:
            u, v = v, u
    return [(p[u] / tile, p[v] / tile) for p in points]


def to_mesh(shape, name, smooth_deg=35.0):
    """A Blender mesh with normals that are smooth up to `smooth_deg` between faces."""
    mesh = bpy.data.meshes.new(name)
    mesh.from_pydata(shape.points, [], [list(c) for c, _, _ in shape.faces])
    names = list(dict.fromkeys(m for _, m, _ in shape.faces))
    for material in names:
        mesh.materials.append(palette.material(material))
    slot = {material: i for i, material in enumerate(names)}
    layer = mesh.uv_layers.new(name="UVMap")
    for polygon, (corners, material, uvs) in zip(mesh.polygons, shape.faces):
        polygon.material_index = slot[material]
        polygon.use_smooth = True
        if uvs is None:
            uvs = _box_uv([shape.points[i] for i in corners], polygon.normal, material)
        for loop, uv in zip(polygon.loop_indices, uvs):
            layer.data[loop].uv = uv
    mesh.use_auto_smooth = True
    mesh.auto_smooth_angle = math.radians(smooth_deg)
    mesh.validate()
    if shape.normals:  # a zero leaves a corner its own
        mesh.normals_split_custom_set([shape.normals.get(loop.vertex_index, (0.0, 0.0, 0.0)) for loop in mesh.loops])
    return mesh
