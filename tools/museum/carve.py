"""Sculpture: solids given by distance fields, melted together, and skinned by surface nets (one point in every cell
the surface crosses, at the mean of its crossings; Gibson 1998). numpy only, so the same numbers give the same stone."""
import bpy
import numpy as np

import meshkit


class Stone:
    """A block of cells to carve in: coordinates x, y, z and the distance so far (positive outside)."""

    def __init__(self, low, high, cell):
        self.low, self.cell = np.array(low, float), cell
        counts = np.ceil((np.array(high) - self.low) / cell).astype(int) + 1
        axes = [self.low[a] + cell * np.arange(counts[a]) for a in range(3)]
        self.x, self.y, self.z = np.meshgrid(*axes, indexing="ij")
        self.field = np.full(self.x.shape, 10.0)

    def melt(self, distance, radius=0.0):
        """Adds a solid; the joint is filled to a fillet of `radius`."""
        if radius <= 0.0:
            self.field = np.minimum(self.field, distance)
        else:
            h = np.clip(0.5 + 0.5 * (self.field - distance) / radius, 0, 1)
            self.field = self.field * (1 - h) + distance * h - radius * h * (1 - h)

    def cut(self, distance, radius=0.0):
        """Takes a solid away, the edge rounded."""
        self.field = -self.field
        self.melt(distance, radius)
        self.field = -self.field

    def ball(self, at, r):
        return np.sqrt((self.x - at[0]) ** 2 + (self.y - at[1]) ** 2 + (self.z - at[2]) ** 2) - r

    def egg(self, at, radii):
        """An ellipsoid; the distance is near enough close to its skin."""
        u, v, w = (self.x - at[0]) / radii[0], (self.y - at[1]) / radii[1], (self.z - at[2]) / radii[2]
        k0 = np.sqrt(u * u + v * v + w * w)
        k1 = np.sqrt((u / radii[0]) ** 2 + (v / radii[1]) ** 2 + (w / radii[2]) ** 2) + 1e-9
        return k0 * (k0 - 1.0) / k1

    def limb(self, a, b, ra, rb=None):
        """A capsule from a to b that may taper."""
        rb = ra if rb is None else rb
        a, b = np.array(a, float), np.array(b, float)
        d = b - a
        t = ((self.x - a[0]) * d[0] + (self.y - a[1]) * d[1] + (self.z - a[2]) * d[2]) / (d @ d)
        t = np.clip(t, 0, 1)
        return np.sqrt((self.x - a[0] - t * d[0]) ** 2 + (self.y - a[1] - t * d[1]) ** 2 +
                       (self.z - a[2] - t * d[2]) ** 2) - (ra + (rb - ra) * t)

    def chain(self, points, radii, melt):
        for a, b, ra, rb in zip(points, points[1:], radii, radii[1:]):
            self.melt(self.limb(a, b, ra, rb), melt)

    def skin(self):
        """(points, quads) of the surface, quads counter-clockwise from outside."""
        f = self.field
        inside = f < 0
        corners = [(i, j, k) for i in (0, 1) for j in (0, 1) for k in (0, 1)]
        shape = tuple(n - 1 for n in f.shape)

        def at(array, c):
            return array[c[0]:c[0] + shape[0], c[1]:c[1] + shape[1], c[2]:c[2] + shape[2]]

        count = sum(at(inside, c).astype(int) for c in corners)
        crossed = (count > 0) & (count < 8)
        cells = np.argwhere(crossed)
        number = np.full(shape, -1)
        number[crossed] = np.arange(len(cells))
        total, hits = np.zeros((len(cells), 3)), np.zeros(len(cells))
        i, j, k = cells.T
        for a in corners:
            for axis in range(3):
                if a[axis]:
                    continue
                b = list(a)
                b[axis] = 1
                fa, fb = f[i + a[0], j + a[1], k + a[2]], f[i + b[0], j + b[1], k + b[2]]
                cross = (fa < 0) != (fb < 0)
                t = np.where(cross, fa / np.where(cross, fa - fb, 1.0), 0.0)
                point = np.tile(np.array(a, float), (len(cells), 1))
                point[:, axis] += t
                total += np.where(cross[:, None], point, 0.0)
                hits += cross
        points = self.low + (cells + total / hits[:, None]) * self.cell
        quads = []
        for axis in range(3):
            u, v = (axis + 1) % 3, (axis + 2) % 3
            step = [0, 0, 0]
            step[axis] = 1
            n = [slice(0, f.shape[a] - step[a]) for a in range(3)]
            m = [slice(step[a], f.shape[a]) for a in range(3)]
            change = inside[tuple(n)].astype(int) - inside[tuple(m)].astype(int)
            for sign in (1, -1):
                edges = np.argwhere(change == sign)
                edges = edges[(edges[:, u] > 0) & (edges[:, v] > 0) & (edges[:, u] < f.shape[u] - 1) & (edges[:, v] < f.shape[v] - 1)]
                ring = []
                for du, dv in ((-1, -1), (0, -1), (0, 0), (-1, 0)):
                    c = edges.copy()
                    c[:, u] += du
                    c[:, v] += dv
                    ring.append(number[tuple(c.T)])
                ring = np.stack(ring if sign > 0 else ring[::-1], axis=1)
                quads.append(ring)
        return points, np.concatenate(quads)

    def normals_at(self, points):
        """The stone's own normals: the field's gradient, so that a thinned skin is shaded like the full one."""
        at = np.clip((points - self.low) / self.cell, 1, np.array(self.field.shape) - 2.001)
        cell = np.floor(at).astype(int)
        share = at - cell
        total = np.zeros((len(points), 3))
        for c in [(i, j, k) for i in (0, 1) for j in (0, 1) for k in (0, 1)]:
            weight = np.prod(np.where(np.array(c) == 1, share, 1 - share), axis=1)
            for axis in range(3):
                low, high = cell + c, cell + c
                low[:, axis] -= 1
                high[:, axis] = np.minimum(high[:, axis] + 1, self.field.shape[axis] - 1)
                total[:, axis] += weight * (self.field[tuple(high.T)] - self.field[tuple(low.T)])
        return total / (np.linalg.norm(total, axis=1, keepdims=True) + 1e-12)

    def hewn(self, name, material, triangles):
        """The finished Blender mesh, its points thinned to about `triangles`."""
        points, quads = self.skin()
        rough = bpy.data.meshes.new(name + "_rough")
        rough.from_pydata([tuple(p) for p in points], [], [tuple(int(i) for i in q) for q in quads])
        node = bpy.data.objects.new(name + "_rough", rough)
        bpy.context.scene.collection.objects.link(node)
        smooth = node.modifiers.new("smooth", "SMOOTH")
        smooth.factor, smooth.iterations = 0.4, 2
        thin = node.modifiers.new("thin", "DECIMATE")
        thin.ratio = min(1.0, triangles / (2.0 * len(quads)))
        done = bpy.data.meshes.new_from_object(node.evaluated_get(bpy.context.evaluated_depsgraph_get()))
        shape = meshkit.Shape()
        shape.points = [tuple(v.co) for v in done.vertices]
        shape.normals = {i: tuple(n) for i, n in enumerate(self.normals_at(np.array(shape.points)))}
        for polygon in done.polygons:
            shape.face(list(polygon.vertices), material)
        bpy.data.objects.remove(node)
        bpy.data.meshes.remove(rough)
        bpy.data.meshes.remove(done)
        return shape
