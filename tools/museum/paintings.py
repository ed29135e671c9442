"""The pictures in the gilded frames: painted by formula, each from its own seed, all about light. Arrays are
[row from the bottom, column, rgb] in sRGB 0..1, 512 wide."""
import numpy as np

import textures
from textures import mix

WIDE, TALL = (384, 512), (640, 512)  # rows, columns


def _field(shape):
    rows, columns = shape
    return np.meshgrid((np.arange(columns) + 0.5) / columns, (np.arange(rows) + 0.5) / rows)


def _noise(shape, cells, seed, octaves=5):
    rows, columns = shape
    full = textures.noise(1024, cells, seed, octaves)
    return full[:rows, :columns]


def _varnish(picture, seed):
    """Brush strokes, an aged yellow varnish, and the dark that gathers in corners."""
    shape = picture.shape[:2]
    x, y = _field(shape)
    strokes = (_noise(shape, 96, seed, 3) - 0.5) * 0.16 + (_noise(shape, 24, seed + 1, 3) - 0.5) * 0.10
    corner = 1.0 - 0.45 * np.clip(np.hypot(x - 0.5, y - 0.5) * 1.5 - 0.25, 0, 1)
    return picture * (1.0 + strokes)[..., None] * corner[..., None] * np.array((1.0, 0.96, 0.86))


def _sky(x, y, low, high, seed, shape, cloud=(0.9, 0.85, 0.8), amount=0.7):
    picture = mix(low, high, y)
    billows = np.clip((_noise(shape, 6, seed, 6) - 0.48) * 4, 0, 1)
    return mix(picture, cloud, billows * amount * (0.4 + 0.6 * y))


def _mountains(seed, low, high, near):
    shape = WIDE
    x, y = _field(shape)
    picture = _sky(x, y, low, high, seed, shape)
    sun = np.hypot((x - 0.68) * 1.33, y - 0.56)
    picture = mix(picture, (1.0, 0.93, 0.70), np.clip(1.15 - sun * 14, 0, 1) + 0.5 * np.exp(-sun * 7))
    for layer in range(5):
        ridge = textures.noise(1024, 3 + layer * 2, seed + 20 + layer, 7)[layer, :512]
        top = 0.62 - layer * 0.13 + (ridge - 0.5) * (0.42 - layer * 0.05)
        tone = np.asarray(low) * (1 - layer / 4.5) * 0.75 + np.asarray(near) * layer / 4.0
        shade = 0.8 + 0.4 * _noise(shape, 20, seed + 40 + layer, 4)
        picture = np.where((y < top[None, :])[..., None], tone * shade[..., None], picture)
    return _varnish(picture, seed)


def _seascape(seed, night):
    shape = WIDE
    x, y = _field(shape)
    low, high = ((.10, .16, .26), (.03, .05, .12)) if night else ((.95, .62, .35), (.25, .38, .55))
    light = (0.86, 0.90, 1.0) if night else (1.0, 0.88, 0.6)
    picture = _sky(x, (y - 0.4) / 0.6, low, high, seed, shape, (.30, .34, .42) if night else (.95, .70, .55), 0.8)
    disc = np.hypot((x - 0.40) * 1.33, y - 0.70)
    picture = mix(picture, light, np.clip(1.0 - (disc - 0.045) * 60, 0, 1) + 0.5 * np.exp(-disc * 8))
    depth = np.clip((0.42 - y) / 0.42, 0.001, 1)
    swell = textures.noise(1024, 32, seed + 5, 4)  # seen at a slant: rows crowd together towards the horizon
    rows, columns = (150.0 / (depth + 0.03)).astype(int) % 1024, ((x - 0.4) * 90.0 / (depth + 0.12)).astype(int) % 1024
    waves = np.clip((swell[rows, columns] - 0.36) * 3.4, 0, 1)
    sea = mix((.02, .05, .09) if night else (.10, .20, .26), (.10, .17, .24) if night else (.45, .42, .38), waves * 0.6)
    path = np.exp(-((x - 0.40) / (0.03 + 0.16 * depth)) ** 2) * (waves > 0.45) * (0.9 - 0.5 * depth)
    sea = mix(sea, light, path)
    picture = np.where((y < 0.42)[..., None], sea, picture)
    hull = (np.abs(x - 0.70) < 0.075 - (0.43 - y) * 0.6) & (y > 0.385) & (y < 0.43)
    mast = (np.abs(x - 0.70) < 0.003) & (y >= 0.43) & (y < 0.66)
    sail = (x > 0.645 + (y - 0.45) * 0.20) & (x < 0.755 - (y - 0.45) * 0.20) & (y > 0.45) & (y < 0.63)
    picture = np.where(sail[..., None], (.42, .40, .38) if night else (.80, .70, .55), picture)
    return _varnish(np.where((hull | mast)[..., None], (.04, .03, .03), picture), seed)


def _spectrum(seed):
    """Newton's dark room: a white beam enters from the left, a prism, the seven colours on the wall."""
    shape = WIDE
    x, y = _field(shape)
    picture = mix((.05, .04, .04), (.11, .09, .07), _noise(shape, 5, seed))
    t = np.clip((x - 0.50) / 0.5, 0, 1)
    spread = (y - (0.50 - 0.22 * t)) / (0.02 + 0.34 * t)
    hue = np.clip(0.5 - spread, 0, 1)
    rainbow = np.stack([np.clip(1.6 - np.abs(hue - c) * 4.4, 0, 1) for c in (0.12, 0.48, 0.85)], -1)
    picture = np.where(((np.abs(spread) < 0.5) & (x > 0.50))[..., None], picture + rainbow * (0.95 - 0.4 * t)[..., None], picture)
    beam = np.exp(-((y - 0.58 + (x - 0.45) * 0.16) / 0.012) ** 2) * (x < 0.46)
    picture = picture + beam[..., None] * np.array((1.0, 0.96, 0.85))
    height = np.clip((y - 0.36) / 0.32, 0, 1)
    inside = (np.abs(x - 0.47) < 0.13 * (1 - height)) & (y > 0.36) & (y < 0.68)
    glassy = mix((.25, .30, .32), (.75, .82, .85), np.clip((x - 0.36) * 4 + _noise(shape, 9, seed) - 0.5, 0, 1))
    return _varnish(np.where(inside[..., None], 0.5 * picture + 0.6 * glassy, picture), seed)


def _portrait(seed, coat, hair, ground, wears):
    """A sitter lit from the left by one lamp: ellipsoids shaded as a painter of candlelight would."""
    shape = TALL
    x, y = _field(shape)
    x, y = (x - 0.5) * 1.0, (y - 0.5) * 1.25
    random = np.random.RandomState(seed)
    lamp = np.array((-0.62, 0.50, 0.60))
    coat, hair, ground = np.asarray(coat) * 1.5 + 0.02, np.asarray(hair) * 1.2, np.asarray(ground)
    halo = np.exp(-((x - 0.12) ** 2 * 5 + (y - 0.10) ** 2 * 3.5))  # the wall behind, lit past the far shoulder
    picture = mix(ground * 0.45, ground * 2.0, halo * 0.8 + (_noise(shape, 5, seed) - 0.5) * 0.35)
    w, lean = 0.140 + 0.022 * random.rand(), 0.03 * (random.rand() - 0.5)
    skin, lip, dark = np.array((.84, .62, .48)) * (0.92 + 0.1 * random.rand()), (.62, .27, .23), (.07, .05, .04)
    parts = [((0, -0.58, -0.1), (0.43, 0.42, 0.25), coat), ((0, -0.12, 0.0), (0.072, 0.17, 0.09), skin * 0.86),
             ((lean, 0.17, -0.06), (w * 1.14, 0.235, 0.2), hair), ((lean, 0.12, 0.03), (w, 0.205, 0.17), skin),
             ((lean - 0.014, 0.092, 0.165), (0.017, 0.058, 0.045), skin), ((lean - 0.014, 0.048, 0.175), (0.026, 0.018, 0.045), skin * 0.97),
             ((lean, -0.065, 0.12), (0.045, 0.032, 0.05), skin)]
    for side in (-1, 1):
        x0 = lean - 0.008 + side * 0.056
        parts += [((x0, 0.142, 0.150), (0.030, 0.0125, 0.03), (.88, .85, .80)), ((x0 - 0.004, 0.142, 0.170), (0.0115, 0.0120, 0.02), dark),
                  ((x0, 0.153, 0.168), (0.032, 0.005, 0.02), dark), ((x0, 0.180, 0.150), (0.037, 0.007, 0.03), np.asarray(hair) * 0.7),
                  ((side * 0.115, -0.40, 0.10), (0.075, 0.20, 0.07), coat * 1.35)]
    parts += [((0.0, -0.265, 0.10), (0.062, 0.075, 0.05), (.80, .77, .70)), ((0.004, -0.345, 0.11), (0.040, 0.085, 0.04), (.74, .71, .64))]  # a cravat
    parts += [((lean - 0.008, 0.010, 0.165), (0.042, 0.0075, 0.03), np.asarray(lip) * 0.7), ((lean - 0.008, -0.001, 0.163), (0.034, 0.012, 0.03), lip)]
    if wears == "beard":
        parts += [((lean, -0.075, 0.06), (0.115, 0.105, 0.13), hair), ((lean - 0.05, 0.030, 0.165), (0.055, 0.014, 0.03), hair), ((lean + 0.035, 0.030, 0.165), (0.055, 0.014, 0.03), hair),
                  ((lean - 0.008, 0.006, 0.172), (0.035, 0.010, 0.03), lip)]
    if wears == "long":
        parts += [((lean - w, 0.02, 0.0), (0.07, 0.24, 0.1), hair), ((lean + w, 0.02, 0.0), (0.07, 0.24, 0.1), hair), ((lean - 0.06, 0.275, 0.06), (0.11, 0.055, 0.13), hair), ((lean + 0.06, 0.275, 0.06), (0.11, 0.055, 0.13), hair)]
    if wears == "cap":
        parts += [((lean, 0.315, 0.03), (w * 1.45, 0.075, 0.2), (.10, .03, .04)), ((lean, 0.265, 0.06), (w * 1.12, 0.045, 0.2), (.16, .05, .06))]
    nearest = np.full(shape, -9.0)
    for centre, radius, colour in parts:
        u, v = (x - centre[0]) / radius[0], (y - centre[1]) / radius[1]
        inside = 1 - u * u - v * v
        depth = np.where(inside > 0, centre[2] + radius[2] * np.sqrt(np.maximum(inside, 0)), -9.0)
        normal = np.stack([u / radius[0], v / radius[1], np.sqrt(np.maximum(inside, 0)) / radius[2]], -1)
        normal /= np.linalg.norm(normal, axis=-1, keepdims=True) + 1e-9
        light = 0.10 + 0.95 * np.clip((normal * lamp / np.linalg.norm(lamp)).sum(-1), 0, 1)
        front = depth > nearest
        picture = np.where(front[..., None], np.asarray(colour) * light[..., None], picture)
        nearest = np.maximum(nearest, depth)
    for _ in range(2):  # a brush has no edges
        picture = sum(np.roll(picture, (i, j), (0, 1)) for i in (-1, 0, 1) for j in (-1, 0, 1)) / 9.0
    return _varnish(picture, seed)


def _still_life(seed):
    """Three glass balls and a flame on a table."""
    shape = WIDE
    x, y = _field(shape)
    picture = mix((.10, .07, .05), (.24, .17, .10), np.exp(-((x - 0.5) ** 2 * 8 + (y - 0.55) ** 2 * 6)))
    picture = np.where((y < 0.30)[..., None], mix((.16, .09, .05), (.36, .21, .11), np.exp(-(x - 0.5) ** 2 * 7) * (y / 0.3)), picture)
    picture = np.where(((np.abs(x - 0.5) < 0.022) & (y > 0.25) & (y < 0.56))[..., None], mix((.55, .50, .40), (.95, .88, .70), y * 1.4), picture)
    flame = np.hypot((x - 0.5) * 2.6, (y - 0.62) * 0.9)
    picture = picture + (np.exp(-flame * 26) * 2.0)[..., None] * np.array((1.0, 0.72, 0.32)) + np.exp(-flame * 5)[..., None] * np.array((.30, .17, .06))
    for cx, cy, r, tint in ((0.24, 0.32, 0.14, (.5, .75, .85)), (0.70, 0.29, 0.11, (.9, .55, .3)), (0.86, 0.24, 0.07, (.6, .85, .5))):
        u, v = (x - cx) / r * 1.333, (y - cy) / r * 1.0
        d = u * u + v * v
        rim = np.clip(d, 0, 1) ** 3
        side = np.clip(0.5 + 0.5 * (u * (cx - 0.5) * 2.2 - v * 0.5), 0, 1)
        glass = mix((.05, .04, .04), tint, rim * 0.6 + side * 0.5)
        spark = np.exp(-((u - (0.5 - cx) * 1.2) ** 2 + (v - 0.5) ** 2) * 60)
        picture = np.where((d < 1)[..., None], glass + spark[..., None] * np.array((1.0, .9, .7)), picture)
    return _varnish(picture, seed)


def _forest(seed):
    shape = TALL
    x, y = _field(shape)
    glow = np.exp(-((x - 0.5) ** 2 * 7 + (y - 0.45) ** 2 * 5))
    picture = mix((.05, .09, .07), (.80, .74, .46), glow)
    random = np.random.RandomState(seed)
    for k in range(46):
        depth = k / 46.0
        cx, width = random.rand(), 0.006 + 0.035 * depth ** 2
        if depth > 0.6 and abs(cx - 0.5) < 0.16:
            continue
        bend = (textures.noise(1024, 3, seed + k, 4)[:shape[0], k] - 0.5)[:, None] * 0.10
        trunk = np.abs(x - cx - bend) < width
        tone = np.asarray((.42, .40, .26)) * (1 - depth) + np.asarray((.05, .035, .025)) * depth
        picture = np.where((trunk & (y > 0.10 - 0.1 * depth))[..., None], tone, picture)
    leaves = np.clip((_noise(shape, 16, seed + 3, 5) - 0.62 + np.clip(y - 0.55, 0, 1) * 0.5) * 9, 0, 1)
    picture = mix(picture, mix((.03, .07, .03), (.42, .46, .14), _noise(shape, 64, seed + 4, 3) * glow * 1.6), leaves * 0.9)
    return _varnish(picture, seed)


_RECIPES = {
    "alps": lambda: _mountains(101, (.92, .62, .42), (.28, .36, .55), (.10, .10, .09)),
    "glen": lambda: _mountains(111, (.70, .74, .70), (.30, .44, .58), (.09, .13, .05)),
    "dusk": lambda: _mountains(121, (.62, .28, .24), (.10, .12, .26), (.06, .04, .05)),
    "harbour": lambda: _seascape(131, False), "moonrise": lambda: _seascape(141, True),
    "prism": lambda: _spectrum(151), "spheres": lambda: _still_life(161), "forest": lambda: _forest(171),
    "lady": lambda: _portrait(181, (.30, .05, .06), (.22, .11, .05), (.20, .14, .09), "long"),
    "scholar": lambda: _portrait(182, (.08, .08, .10), (.55, .53, .50), (.16, .15, .11), "beard"),
    "founder": lambda: _portrait(183, (.06, .12, .10), (.10, .06, .04), (.22, .12, .07), "cap"),
    "optician": lambda: _portrait(184, (.14, .10, .22), (.34, .20, .08), (.12, .14, .15), "beard"),
}
NAMES = sorted(_RECIPES)
TALL_NAMES = ["forest", "founder", "lady", "optician", "scholar"]
WIDE_NAMES = [n for n in NAMES if n not in TALL_NAMES]


def paint(name):
    return _RECIPES[name]()
