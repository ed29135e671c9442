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


def _portrait(seed, ground, turn, coat, hair, skin, wears):
    import portraits  # here, since the sculptor's stone is of the palette's materials, and pictures are materials, too
    return _varnish(portraits.paint(portraits.Sitter(turn, coat, hair, skin, wears), ground, seed), seed)


def _lighthouse(seed):
    """A tower on its rock, and the beam that goes round over a black sea."""
    shape = WIDE
    x, y = _field(shape)
    picture = _sky(x, (y - 0.3) / 0.7, (.09, .13, .20), (.02, .03, .07), seed, shape, (.16, .20, .27), 0.8)
    lamp = (0.735, 0.70)
    away, up = lamp[0] - x, y - lamp[1]
    beam = np.exp(-((up - 0.10 * away) / (0.010 + 0.16 * np.abs(away))) ** 2) * np.exp(-np.abs(away) * 1.5)
    picture = picture + (beam * (0.65 + 0.5 * (_noise(shape, 9, seed + 7, 4) - 0.5)))[..., None] * np.array((.95, .88, .62))
    depth = np.clip((0.30 - y) / 0.30, 0.001, 1)
    swell = textures.noise(1024, 32, seed + 5, 4)
    rows, columns = (150.0 / (depth + 0.03)).astype(int) % 1024, (x * 90.0 / (depth + 0.12)).astype(int) % 1024
    waves = np.clip((swell[rows, columns] - 0.40) * 3.4, 0, 1)
    sea = mix((.02, .04, .07), (.12, .17, .22), waves * 0.7) + (waves * np.exp(-((x - 0.45) * 3) ** 2) * 0.25)[..., None] * np.array((.9, .8, .5))
    picture = np.where((y < 0.30)[..., None], sea, picture)
    ridge = textures.noise(1024, 5, seed + 9, 6)[3, :512][None, :]
    rock = y < -0.04 + 0.48 * np.clip((x - 0.36) * 2.6, 0, 1) ** 0.7 + (ridge - 0.5) * 0.14
    picture = np.where(rock[..., None], mix((.05, .045, .05), (.17, .15, .14), _noise(shape, 18, seed + 11, 4)), picture)
    tower = (np.abs(x - lamp[0]) < 0.034 - 0.035 * (y - 0.40)) & (y > 0.36) & (y < 0.665)
    band = np.floor((y - 0.36) * 13).astype(int) % 2 == 0
    stone = np.where(band[..., None], (.62, .58, .52), (.42, .10, .08)) * np.clip(1.1 - (x - 0.70)[..., None] * 9, 0.25, 1)
    picture = np.where(tower[..., None], stone, picture)
    head = (np.abs(x - lamp[0]) < 0.030) & (y >= 0.665) & (y < 0.735)
    picture = np.where(head[..., None], (1.0, .93, .66), picture)
    roof = (np.abs(x - lamp[0]) < 0.036 - (y - 0.735) * 0.6) & (y >= 0.735) & (y < 0.79)
    rail = (np.abs(x - lamp[0]) < 0.044) & (np.abs(y - 0.664) < 0.007)
    picture = np.where((roof | rail)[..., None], (.06, .05, .06), picture)
    return _varnish(picture + np.exp(-np.hypot(x - lamp[0], (y - lamp[1]) * 0.75) * 16)[..., None] * np.array((.5, .42, .22)), seed)


def _eclipse(seed):
    """The black sun over a plain, its corona, the first stars, and evening all round the horizon."""
    shape = WIDE
    x, y = _field(shape)
    u, v = (x - 0.5) * 1.333, y - 0.66
    r, angle = np.hypot(u, v), np.arctan2(v, u)
    picture = mix((.62, .36, .20), (.04, .06, .14), np.clip((y - 0.22) * 2.4, 0, 1) ** 0.6)
    stars = (np.random.RandomState(seed).rand(*shape) > 0.9985) & (y > 0.45)
    picture = np.where(stars[..., None], (.9, .9, 1.0), picture)
    streamers = 0.060 + 0.028 * np.cos(2 * angle + 0.5) + 0.014 * np.cos(5 * angle + 1.0) + 0.006 * np.cos(17 * angle)
    corona = np.where(r > 0.105, np.exp(-np.maximum(r - 0.105, 0.0) / streamers), 0.0)
    picture = picture + corona[..., None] * np.array((.92, .94, 1.0))
    picture = np.where((r < 0.105)[..., None], (.015, .015, .02), picture)
    bead = np.exp(-np.hypot(u - 0.081, v - 0.068) * 60) * 1.6
    picture = picture + bead[..., None] * np.array((1.0, .96, .85))
    for layer in range(3):
        ridge = textures.noise(1024, 4 + 3 * layer, seed + layer, 7)[layer, :512][None, :]
        top = 0.26 - 0.08 * layer + (ridge - 0.5) * 0.10
        picture = np.where((y < top)[..., None], np.array((.16, .10, .09)) * (1 - 0.32 * layer), picture)
    return _varnish(picture, seed)


def _aurora(seed):
    """Curtains of green light over snow and firs."""
    shape = WIDE
    x, y = _field(shape)
    picture = mix((.05, .10, .16), (.02, .03, .09), y)
    stars = np.random.RandomState(seed).rand(*shape) > 0.9975
    picture = np.where(stars[..., None], (.75, .8, .9), picture)
    rays = textures.noise(1024, 48, seed + 1, 4)[5, :512][None, :]
    for k, (low, sway, colour) in enumerate(((0.42, 0.10, (.20, .85, .45)), (0.55, 0.07, (.18, .70, .60)), (0.66, 0.05, (.45, .35, .75)))):
        foot = low + sway * np.sin(x * 7 + 2.1 * k) + 0.03 * np.sin(x * 23 + k)
        height = np.where(y > foot, np.exp(-(y - foot) * 6.5), np.exp((y - foot) * 60))
        picture = picture + (height * (0.35 + 0.9 * rays) * (0.55 + 0.45 * np.sin(x * 5 + k * 1.7)))[..., None] * np.array(colour) * 0.75
    ridge = textures.noise(1024, 4, seed + 3, 6)[7, :512][None, :]
    snow = y < 0.26 + (ridge - 0.5) * 0.16
    picture = np.where(snow[..., None], mix((.10, .17, .20), (.36, .52, .52), np.clip(y * 3.2 + (_noise(shape, 10, seed + 4, 4) - 0.5) * 0.5, 0, 1)), picture)
    random = np.random.RandomState(seed + 6)
    for _ in range(34):
        cx, base, tall = random.rand(), 0.05 + 0.22 * random.rand(), 0.10 + 0.16 * random.rand()
        up = (y - base) / tall
        saw = 0.8 + 0.35 * np.abs(np.sin(up * 22))
        fir = (up > 0) & (up < 1) & (np.abs(x - cx) < 0.16 * tall * (1 - up) * saw)
        picture = np.where(fir[..., None], np.array((.015, .035, .035)) * (1.4 - 2 * base), picture)
    return _varnish(picture, seed)


def _rainbow(seed):
    """After the rain: both bows over a wet hill, Alexander's dark band between them."""
    shape = WIDE
    x, y = _field(shape)
    picture = _sky(x, y, (.55, .58, .60), (.24, .30, .38), seed, shape, (.70, .70, .70), 0.5)
    u, v = (x - 0.40) * 1.333, y - 0.12
    r = np.hypot(u, v)
    picture = picture * (1.0 + 0.16 * (r < 0.50) - 0.10 * ((r > 0.56) & (r < 0.70)))[..., None]
    for low, wide, strength, turn in ((0.50, 0.060, 0.42, 1), (0.70, 0.075, 0.16, -1)):
        hue = (r - low) / wide if turn > 0 else 1.0 - (r - low) / wide
        bow = np.stack([np.clip(1.0 - np.abs(hue - c) * 2.6, 0, 1) for c in (0.82, 0.48, 0.18)], -1)
        picture = picture + bow * strength * (0.6 + 0.4 * _noise(shape, 7, seed + 2, 3))[..., None]
    for layer, tone in enumerate(((.22, .30, .16), (.15, .23, .09), (.08, .13, .05))):
        ridge = textures.noise(1024, 3 + 2 * layer, seed + 20 + layer, 6)[layer, :512][None, :]
        top = 0.34 - 0.10 * layer + (ridge - 0.5) * 0.18
        lit = 0.7 + 0.7 * _noise(shape, 24, seed + 30 + layer, 4) + 0.35 * np.exp(-((x - 0.28) * 4) ** 2)
        picture = np.where((y < top)[..., None], np.asarray(tone) * lit[..., None], picture)
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
    "lighthouse": lambda: _lighthouse(191), "eclipse": lambda: _eclipse(192), "aurora": lambda: _aurora(193), "rainbow": lambda: _rainbow(194),
    "lady": lambda: _portrait(181, (.34, .25, .16), 24, (.42, .07, .08), (.30, .15, .06), (.88, .67, .54), "long"),
    "scholar": lambda: _portrait(182, (.27, .25, .20), -22, (.10, .10, .13), (.62, .60, .56), (.84, .64, .52), "beard"),
    "founder": lambda: _portrait(183, (.36, .20, .12), 18, (.07, .17, .13), (.16, .09, .05), (.80, .58, .44), "cap"),
    "optician": lambda: _portrait(184, (.20, .24, .26), -26, (.17, .12, .27), (.42, .23, .09), (.86, .66, .54), "beard"),
}
NAMES = sorted(_RECIPES)
TALL_NAMES = ["forest", "founder", "lady", "optician", "scholar"]
WIDE_NAMES = [n for n in NAMES if n not in TALL_NAMES]


def paint(name):
    return _RECIPES[name]()
