"""Portraits in oil: the sculptor's heads as distance fields, coloured, lit by one lamp from the upper left with its
shadow, and gone over with a brush. Arrays are [row from the bottom, column, rgb] in sRGB 0..1; y is away from the eye."""
import math

import numpy as np

import sculpture
import textures
from carve import Stone

ROWS, COLUMNS = 640, 512
FINE = 2           # pixels to a ray: a brush is wider than a pixel
LAMP = np.array((-0.60, -0.62, 0.52)) / math.sqrt(0.60 ** 2 + 0.62 ** 2 + 0.52 ** 2)
HEAD = (0.0, 0.0, 0.60)


class _Points(Stone):
    """A sculptor's block that is no grid: any points at all."""

    def __init__(self, points):
        self.x, self.y, self.z = points.T
        self.field = np.full(len(points), 10.0)


class Sitter:
    """Who is painted: the parts of which the distance is asked, and what each is coloured."""

    def __init__(self, turn_deg, coat, hair, skin, wears):
        self.turn, self.wears = math.radians(turn_deg), wears
        self.colours = {"skin": np.array(skin), "hair": np.array(hair), "coat": np.array(coat), "linen": np.array((.80, .76, .66)),
                        "cap": np.array((.13, .03, .04))}

    def _turned(self, points):
        """Into the head's own frame: it looks past the easel, the shoulders half as far."""
        c, s = math.cos(self.turn), math.sin(self.turn)
        share = np.clip((points[:, 2] - 0.36) / 0.12, 0, 1) * 0.5 + 0.5
        x, y = points[:, 0], points[:, 1]
        c, s = 1 + (c - 1) * share, s * share
        return np.stack([c * x + s * y, -s * x + c * y, points[:, 2]], -1)

    def parts(self, points):
        """The distance to every part, by its name."""
        own = self._turned(points)
        skin, hair, coat, linen, cap = (_Points(own) for _ in range(5))
        sculpture._face(skin, HEAD)
        skin.melt(skin.limb((0, 0.03, 0.50), (0, 0.02, 0.30), 0.044, 0.056), 0.03)
        coat.melt(coat.limb((-0.155, 0.03, 0.275), (0.155, 0.03, 0.275), 0.075, 0.075), 0.07)
        fold = 0.004 * np.sin(coat.z * 90 + 30 * coat.x) * np.clip((np.abs(coat.x) - 0.08) * 12, 0, 1)
        coat.melt(coat.egg((0, 0.0, 0.14), (0.215, 0.135, 0.22)) + fold, 0.05)
        coat.cut(np.maximum(np.abs(coat.x) - (0.012 + 0.42 * (coat.z - 0.20)), coat.y + 0.03), 0.01)   # open at the throat
        for side in (-1, 1):
            lapel = [(side * 0.060, -0.035, 0.375), (side * 0.088, -0.098, 0.28), (side * 0.014, -0.130, 0.17)]
            coat.chain(lapel, [0.022, 0.026, 0.008], 0.006)
        linen.melt(linen.egg((0, 0.0, 0.19), (0.10, 0.118, 0.19)) + 0.002 * np.sin(linen.z * 260), 0.0)
        linen.melt(linen.limb((-0.044, -0.030, 0.392), (0.044, -0.030, 0.392), 0.020), 0.02)
        linen.melt(linen.egg((0, -0.092, 0.352), (0.022, 0.022, 0.030)) + 0.002 * np.sin(linen.x * 240), 0.012)
        self._dress_hair(hair)
        if self.wears == "cap":
            cap.melt(cap.egg((0.012, 0.02, 0.700), (0.132, 0.135, 0.044)))
            cap.melt(cap.egg((0.0, 0.015, 0.668), (0.096, 0.116, 0.030)), 0.012)
        return {"skin": skin.field, "hair": hair.field, "coat": coat.field, "linen": linen.field, "cap": cap.field}

    def _dress_hair(self, hair):
        ridge = np.sin(46 * np.arctan2(hair.x, hair.z - 0.57) + 22 * hair.y + 5 * np.sin(40 * hair.z))
        scalp = hair.egg((0, 0.026, 0.642), (0.089, 0.112, 0.100)) + 0.0022 * ridge
        hair.melt(np.maximum(scalp, -(hair.y + 0.058 + (hair.z - 0.655) * 0.72)))
        if self.wears == "long":
            for side in (-1, 1):
                wave = 0.006 * np.sin(70 * hair.z + 3) + 0.003 * np.sin(150 * hair.x)
                hair.melt(hair.limb((side * 0.070, 0.03, 0.68), (side * 0.100, 0.030, 0.46), 0.034, 0.040) + wave, 0.02)
                hair.melt(hair.limb((side * 0.100, 0.030, 0.46), (side * 0.105, -0.045, 0.335), 0.040, 0.018) + wave, 0.02)
        else:
            for side in (-1, 1):  # about the ears
                hair.melt(hair.egg((side * 0.074, 0.020, 0.615), (0.016, 0.034, 0.050)) + 0.001 * ridge, 0.01)
        if self.wears == "beard":
            strand = 0.003 * np.sin(150 * hair.x + 8 * np.sin(60 * hair.z)) + 0.002 * np.sin(210 * hair.z)
            beard = hair.egg((0, -0.054, 0.478), (0.060, 0.052, 0.066)) + strand
            hair.melt(np.maximum(beard, hair.z - 0.522), 0.012)
            for side in (-1, 1):
                hair.melt(hair.limb((side * 0.006, -0.106, 0.540), (side * 0.046, -0.078, 0.520), 0.0095, 0.006) + strand * 0.5, 0.006)
                hair.melt(hair.limb((side * 0.070, -0.010, 0.575), (side * 0.052, -0.050, 0.500), 0.014, 0.024) + strand, 0.012)

    def distance(self, points):
        return np.minimum.reduce(list(self.parts(points).values()))

    def paint_of(self, points):
        """The colour of every point of the surface, and how much it shines."""
        parts = self.parts(points)
        names = list(parts)
        nearest = np.argmin([parts[n] for n in names], axis=0)
        colour = np.array([self.colours[n] for n in names])[nearest]
        own = self._turned(points)
        is_skin = nearest == names.index("skin")
        flush = sum(np.exp(-((own[:, 0] - s * 0.046) ** 2 + (own[:, 2] - 0.562) ** 2) / 0.0006) for s in (-1, 1))
        flush = flush + 0.8 * np.exp(-(own[:, 0] ** 2 + (own[:, 2] - 0.565) ** 2) / 0.0003)
        colour = np.where(is_skin[:, None], colour * (1 - 0.16 * np.clip(flush, 0, 1)[:, None] * np.array((0.0, 0.7, 0.8))), colour)
        lips = is_skin & (own[:, 1] < -0.085) & (((own[:, 0] / 0.027) ** 2 + ((own[:, 2] - 0.5205) / 0.0155) ** 2) < 1)
        colour = np.where(lips[:, None], colour * np.array((.80, .48, .45)), colour)
        gap = lips & (np.abs(own[:, 2] - 0.5205) < 0.0016)
        colour = np.where(gap[:, None], colour * 0.35, colour)
        for side in (-1, 1):
            across, up = own[:, 0] - side * 0.034, own[:, 2] - 0.598
            is_eye = is_skin & (np.hypot(np.hypot(across, up), own[:, 1] + 0.078) < 0.0162) & (np.abs(up) < 0.0085) & (own[:, 1] < -0.078)
            look = np.hypot(across - 0.0035 * np.sign(self.turn), up - 0.0005)
            eye = np.where((look < 0.0068)[:, None], (.20, .13, .07), (.80, .76, .70))
            eye = np.where((look < 0.0032)[:, None], (.015, .012, .01), eye)
            colour = np.where(is_eye[:, None], eye, colour)
            line = is_skin & (np.abs(across) < 0.018) & (np.abs(up - 0.0095) < 0.0022) & (own[:, 1] < -0.078)
            colour = np.where(line[:, None], colour * 0.35, colour)
            arch = own[:, 2] - 0.6265 + 9.0 * (np.abs(across) - 0.004) ** 2
            brow = is_skin & (np.abs(across) < 0.025) & (np.abs(arch) < 0.0034) & (own[:, 1] < -0.06)
            colour = np.where(brow[:, None], self.colours["hair"] * 0.8, colour)
        return colour, np.where(is_skin, 0.07, np.where(nearest == names.index("hair"), 0.05, 0.012))[:, None]


def _view():
    """One ray a canvas place: where it starts and which way it looks."""
    rows, columns = ROWS // FINE, COLUMNS // FINE
    u, v = np.meshgrid((np.arange(columns) + 0.5) / columns - 0.5, (np.arange(rows) + 0.5) / rows - 0.5)
    eye, high = np.array((0.0, -1.7, 0.57)), 0.68
    target = np.stack([u * high * 0.8, np.zeros_like(u), 0.495 + v * high], -1).reshape(-1, 3)
    way = target - eye
    return np.broadcast_to(eye, way.shape), way / np.linalg.norm(way, axis=1, keepdims=True)


def _marched(sitter, start, way, from_t, to_t, steps):
    """How far each ray gets: the distance of what it meets, or infinity."""
    t, met = np.full(len(start), from_t), np.full(len(start), np.inf)
    alive = np.arange(len(start))
    for _ in range(steps):
        d = sitter.distance(start[alive] + way[alive] * t[alive, None])
        met[alive[d < 0.0006]] = t[alive[d < 0.0006]]
        t[alive] += d * 0.75
        alive = alive[(d >= 0.0006) & (t[alive] < to_t)]
        if len(alive) == 0:
            break
    return met


def _lit(sitter, points):
    """What the lamp and the dim room leave of a white surface at each point."""
    e = 0.0012
    normal = np.stack([sitter.distance(points + d) - sitter.distance(points - d) for d in np.eye(3) * e], -1)
    normal /= np.linalg.norm(normal, axis=1, keepdims=True) + 1e-9
    facing = normal @ LAMP
    start = points + normal * 0.004
    shade, t = np.ones(len(points)), np.full(len(points), 0.004)
    for _ in range(22):  # the nearer a ray passes something, the darker: a lamp as wide as a hand
        d = sitter.distance(start + LAMP * t[:, None])
        shade = np.minimum(shade, np.clip(0.5 + 6.0 * d / t, 0, 1))
        t += np.clip(d, 0.005, 0.04)
    hollow = sum(np.clip(sitter.distance(points + normal * h) / h, 0, 1) * w for h, w in ((0.008, 0.4), (0.03, 0.35), (0.08, 0.25)))
    wrapped = np.clip((facing + 0.18) / 1.18, 0, 1)
    shine = np.clip(normal @ ((LAMP + np.array((0, -1, 0))) / np.linalg.norm(LAMP + np.array((0, -1, 0)))), 0, 1) ** 24
    warm = np.array((1.0, 0.90, 0.74))
    direct = (wrapped * shade)[:, None] * np.array((1.0, 0.97, 0.94)) + np.clip(wrapped - facing, 0, 1)[:, None] * np.array((.10, .03, .02))
    back = np.clip(normal @ np.array((0.85, 0.25, 0.35)), 0, 1) * 0.12
    return (direct * 1.25 * warm + (hollow * 0.13 + back * hollow)[:, None] * np.array((0.86, 0.92, 1.0)), (shine * shade)[:, None] * warm)


def _brushed(picture, seed):
    """The canvas seen through strokes: every place takes its colour from somewhere near, along the stroke it lies in."""
    rows, columns = picture.shape[:2]
    angle = (textures.noise(1024, 5, seed, 2)[:rows, :columns] * 4.0 + 0.6) * np.pi
    push = (textures.noise(1024, 128, seed + 1, 2)[:rows, :columns] - 0.5) * 5.0
    yy, xx = np.mgrid[0:rows, 0:columns]
    i = np.clip(np.rint(yy + push * np.sin(angle)), 0, rows - 1).astype(int)
    j = np.clip(np.rint(xx + push * np.cos(angle)), 0, columns - 1).astype(int)
    return picture[i, j]


def paint(sitter, ground, seed):
    start, way = _view()
    t = _marched(sitter, start, way, 1.30, 2.2, 60)
    x, y = np.meshgrid((np.arange(COLUMNS // FINE) + 0.5) / (COLUMNS // FINE), (np.arange(ROWS // FINE) + 0.5) / (ROWS // FINE))
    cloud = textures.noise(1024, 5, seed, 4)[:ROWS // FINE, :COLUMNS // FINE] - 0.5
    glow = np.exp(-((x - 0.70) ** 2 * 5 + (y - 0.55) ** 2 * 4)) + cloud * 0.5  # the wall behind, lit past the far shoulder
    picture = np.asarray(ground) * (0.25 + 1.1 * np.clip(glow, 0, 2))[..., None]
    picture = (picture ** 2.2).reshape(-1, 3)
    met = np.isfinite(t)
    points = start[met] + way[met] * t[met, None]
    light, shine = _lit(sitter, points)
    colour, gloss = sitter.paint_of(points)
    picture[met] = colour ** 2.2 * light + shine * gloss
    picture = np.clip(picture, 0, 1).reshape(ROWS // FINE, COLUMNS // FINE, 3) ** (1 / 2.2)
    large = picture.repeat(FINE, 0).repeat(FINE, 1)
    large = sum(np.roll(large, (i, j), (0, 1)) for i in (-1, 0, 1) for j in (-1, 0, 1)) / 9.0
    return _brushed(large, seed)
