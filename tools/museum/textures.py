"""Pictures of surfaces, synthesised: every one repeats without a seam and comes from a fixed seed. Colours are
written as sRGB bytes in 0..1; arrays are [row from the bottom, column, rgb], as Blender keeps them."""
import os

import bpy
import numpy as np

import pictograms


def noise(size, cells, seed, octaves=5, gain=0.5):
    """Periodic value noise in 0..1: `cells` lattice cells across, each octave twice as fine."""
    total, weight, amplitude = np.zeros((size, size)), 0.0, 1.0
    for octave in range(octaves):
        n = cells * 2 ** octave
        if n > size // 2:
            break
        lattice = np.random.RandomState(seed * 101 + octave).rand(n, n)
        t = np.arange(size) * n / size
        i, f = np.floor(t).astype(int), t - np.floor(t)
        f = f * f * (3.0 - 2.0 * f)
        a, b = lattice[np.ix_(i % n, i % n)], lattice[np.ix_(i % n, (i + 1) % n)]
        c, d = lattice[np.ix_((i + 1) % n, i % n)], lattice[np.ix_((i + 1) % n, (i + 1) % n)]
        fx, fy = f[None, :], f[:, None]
        total += amplitude * ((a * (1 - fx) + b * fx) * (1 - fy) + (c * (1 - fx) + d * fx) * fy)
        weight += amplitude
        amplitude *= gain
    return total / weight


def mix(a, b, t):
    t = np.clip(t, 0.0, 1.0)[..., None]
    return np.asarray(a) * (1.0 - t) + np.asarray(b) * t


def grid(size):
    """Columns and rows as 0..1 across the picture."""
    x = (np.arange(size) + 0.5) / size
    return np.meshgrid(x, x)


def warped(image, amount, seed):
    """The picture pulled about by noise, by up to `amount` of its width: veins and grain that no ruler drew."""
    size = image.shape[0]
    dx = (noise(size, 4, seed) - 0.5) * 2 * amount * size
    dy = (noise(size, 4, seed + 1) - 0.5) * 2 * amount * size
    yy, xx = np.mgrid[0:size, 0:size]
    return image[(yy + dy).astype(int) % size, (xx + dx).astype(int) % size]


def marble(size, ground, vein, seed, strength=0.9):
    veins = np.abs(noise(size, 3, seed, 6, 0.55) - 0.5) * 2
    fine = np.abs(noise(size, 7, seed + 9, 5) - 0.5) * 2
    broad = np.abs(warped(noise(size, 2, seed + 17, 4), 0.06, seed + 21) - 0.5) * 2  # few, long and soft-edged
    lines = np.clip(1.0 - veins * 14, 0, 1) * 0.8 + np.clip(1.0 - fine * 18, 0, 1) * 0.35 + np.clip(1.0 - broad * 9, 0, 1) ** 2 * 0.45
    clouds = noise(size, 2, seed + 3)
    return mix(mix(ground, vein, (clouds - 0.35) * 0.45), vein, lines * strength)


def plaster(size, colour, seed, roughness=0.10):
    light = 1.0 + (noise(size, 2, seed) - 0.5) * roughness * 1.4 + (noise(size, 32, seed + 1, 3) - 0.5) * roughness
    light += (noise(size, 128, seed + 2, 2) - 0.5) * roughness * 0.5
    return np.asarray(colour) * light[..., None]


def grain(size, light, dark, seed):
    """Wood whose fibres run along the columns' axis (u)."""
    rows = warped(np.repeat(noise(size, 24, seed, 4)[:, :1], size, axis=1), 0.05, seed + 5)
    pores = np.repeat(np.random.RandomState(seed).rand(size, size // 32), 32, axis=1) ** 3
    rings = 0.5 + 0.5 * np.sin(rows * 26.0)
    return mix(light, dark, rings * 0.55 + pores * 0.3 + noise(size, 3, seed + 7) * 0.2)


def _checker(size):
    x, y = grid(size)
    n = 8  # tiles across, 0.5 m each
    ix, iy = np.floor(x * n).astype(int), np.floor(y * n).astype(int)
    white, black = marble(size, (.80, .78, .74), (.52, .50, .49), 11), marble(size, (.10, .10, .11), (.42, .41, .40), 12, .7)
    tone = 0.94 + 0.12 * np.random.RandomState(3).rand(n, n)[iy, ix]
    picture = np.where(((ix + iy) % 2 == 0)[..., None], white, black) * tone[..., None]
    return _jointed(picture, x * n, y * n, 0.012, (.16, .15, .14))


def _jointed(picture, u, v, width, colour):
    """Darkens the joints where u or v is near a whole number."""
    near = np.minimum(np.abs(u - np.round(u)), np.abs(v - np.round(v)))
    return np.where((near < width)[..., None], np.asarray(colour), picture)


def _star(size):
    """The Hall's floor: eight-pointed stars of dark marble, rose at the heart, in white squares."""
    x, y = grid(size)
    n = 2
    u, v = (x * n) % 1 - 0.5, (y * n) % 1 - 0.5
    r = np.maximum(np.abs(u), np.abs(v))
    diamond = np.abs(u) + np.abs(v)
    white, grey = marble(size, (.82, .80, .77), (.55, .53, .52), 21), marble(size, (.34, .36, .40), (.62, .62, .62), 22)
    rose, black = marble(size, (.55, .30, .26), (.80, .66, .60), 23), marble(size, (.09, .09, .10), (.40, .40, .40), 24, .6)
    star = np.minimum(np.maximum(r, 0), diamond * 0.70711)
    picture = np.where((r > 0.46)[..., None], black, white)
    picture = np.where((star < 0.25)[..., None], grey, picture)
    picture = np.where((star < 0.14)[..., None], rose, picture)
    edge = (np.abs(star - 0.25) < 0.006) | (np.abs(star - 0.14) < 0.005) | (np.abs(r - 0.46) < 0.005)
    return np.where(edge[..., None], np.array((.70, .55, .25)), picture)


def _herringbone(size):
    x, y = grid(size)
    light, dark = (.52, .34, .18), (.33, .19, .09)
    bands = 6
    band = np.floor(x * bands).astype(int)
    slant = np.where(band % 2 == 0, y + (x * bands % 1) / bands, y - (x * bands % 1) / bands)
    blocks = 16
    piece = np.floor(slant * blocks).astype(int) % blocks
    tone = np.random.RandomState(31).rand(blocks, bands)[piece, band]
    along = noise(size, 48, 32, 3)
    picture = mix(light, dark, tone * 0.75 + (along - 0.5) * 0.7)
    return _jointed(picture, slant * blocks, x * bands, 0.022, (.10, .06, .03))


def _squares(size):
    x, y = grid(size)
    n, strips = 4, 6
    ix, iy = np.floor(x * n).astype(int), np.floor(y * n).astype(int)
    flip = (ix + iy) % 2 == 0
    along = np.where(flip, y * n % 1, x * n % 1) * strips
    tone = np.random.RandomState(41).rand(n, n, strips)[iy, ix, np.floor(along).astype(int)]
    picture = mix((.45, .24, .12), (.22, .10, .05), tone * 0.7 + (noise(size, 40, 42, 3) - 0.5) * 0.6)
    picture = _jointed(picture, along, along, 0.03, (.08, .04, .02))
    return _jointed(picture, x * n, y * n, 0.012, (.08, .04, .02))


def _flagstones(size):
    x, y = grid(size)
    rows = 4
    row = np.floor(y * rows).astype(int)
    u = x * 3 + np.array([0.0, 0.5, 0.2, 0.7])[row]
    tone = np.random.RandomState(51).rand(rows, 3)[row, np.floor(u).astype(int) % 3]
    picture = plaster(size, (.40, .38, .35), 52, 0.35) * (0.85 + 0.3 * tone)[..., None]
    return _jointed(picture, u, y * rows, 0.02, (.14, .13, .12))


def _damask(size, ground, figure, seed):
    """A pointed lattice with a flower in every field, woven in two tones of one silk."""
    x, y = grid(size)
    a, b = x * 3 + y * 2, x * 3 - y * 2  # whole numbers of either are the lattice's lines
    a, b = a % 1 - 0.5, b % 1 - 0.5
    u, w = (a + b) / 2, (a - b) / 2
    angle, r = np.arctan2(w, u), np.hypot(u * 1.1, w)
    petals = 0.20 + 0.085 * np.cos(angle * 6) + 0.035 * np.cos(angle * 2 + np.pi)
    flower = np.clip((petals - r) * 40, 0, 1) - np.clip((petals * 0.55 - r) * 40, 0, 1) * 0.7 + np.clip((0.045 - r) * 50, 0, 1)
    edge = 0.5 - np.maximum(np.abs(a), np.abs(b))
    lattice = np.clip(1.3 - np.abs(edge - 0.03) * 60, 0, 1)
    thread = 1.0 + 0.05 * np.sin(y * size * np.pi * 0.5) + (noise(size, 64, seed, 2) - 0.5) * 0.12
    return mix(ground, figure, flower * 0.8 + lattice * 0.9) * thread[..., None]


def _carpet(size):
    x, y = grid(size)
    a, b = np.sin(x * 2 * np.pi * 4), np.sin(y * 2 * np.pi * 4)
    field = mix((.28, .03, .04), (.42, .08, .06), (a * b > 0.35).astype(float))
    field = mix(field, (.62, .45, .18), ((np.abs(a * b) > 0.80) | (np.abs(np.abs(a) - np.abs(b)) < 0.05)).astype(float) * 0.8)
    return field * (0.86 + 0.28 * noise(size, 128, 61, 2))[..., None]


def _ashlar(size):
    """Dressed stone in courses of 0.6 m, every block of its own tone."""
    x, y = grid(size)
    rows = 4
    row = np.floor(y * rows).astype(int)
    u = x * 2 + 0.5 * (row % 2)
    tone = np.random.RandomState(55).rand(rows, 2)[row, np.floor(u).astype(int) % 2]
    picture = plaster(size, (.70, .66, .57), 56, 0.16) * (0.93 + 0.12 * tone)[..., None]
    return _jointed(picture, u, y * rows, 0.012, (.42, .39, .34))


def _paper_stripe(size):
    """Wallpaper: broad stripes of two greens, a thin gold line at their edges, a sprig in every other one."""
    x, y = grid(size)
    stripe = (np.floor(x * 6) % 2).astype(float)
    picture = mix((.24, .31, .26), (.31, .37, .30), stripe)
    edge = np.abs(x * 6 - np.round(x * 6))
    picture = mix(picture, (.62, .52, .28), np.clip(1.2 - np.abs(edge - 0.05) * 60, 0, 1) * 0.8)
    u, w = (x * 6) % 1 - 0.5, ((y * 4 + 0.5 * np.floor(x * 3)) % 1 - 0.5) * 1.5
    angle, r = np.arctan2(w, u), np.hypot(u, w)
    leaf = np.clip((0.16 + 0.10 * np.cos(angle * 4 + np.pi / 2) - r) * 30, 0, 1) * stripe
    picture = mix(picture, (.17, .23, .17), leaf * 0.8)
    picture = mix(picture, (.66, .56, .32), np.clip((0.045 - r) * 60, 0, 1) * stripe)
    return picture * (0.94 + 0.12 * noise(size, 3, 57, 4))[..., None]


def _spine(size, colour, seed):
    """Leather backs of books, one repeat a shelf's pitch from bottom to top: raised bands, a gold-tooled label, rubbed edges."""
    x, y = grid(size)
    tone = 0.75 + 0.5 * noise(size, 6, seed, 4)
    picture = np.asarray(colour) * tone[..., None]
    up = (y * 0.36 - 0.15) % 0.36  # metres above the shelf
    for at in (0.03, 0.075, 0.12, 0.165):
        near = np.abs(up - at)
        picture = mix(picture, np.asarray(colour) * 1.7, np.clip(1.3 - near * 300, 0, 1) * 0.6)
        picture = mix(picture, (.70, .52, .22), np.clip(1.2 - np.abs(near - 0.006) * 900, 0, 1) * 0.8)
    label = (up > 0.128) & (up < 0.158)
    dark = np.asarray((.16, .05, .03)) if seed % 2 else np.asarray((.05, .08, .06))
    picture = np.where(label[..., None], dark, picture)
    letters = label & (np.abs(up - 0.143) < 0.005) & (np.random.RandomState(seed).rand(size // 4).repeat(4)[None, :] > 0.35)
    return np.where(letters[..., None], (.74, .56, .26), picture)


def _boards(size):
    """Broad oak planks along u, each of its own tone, nailed at their ends."""
    x, y = grid(size)
    rows = 8
    row = np.floor(y * rows).astype(int)
    u = x + np.array([0.0, 0.45, 0.2, 0.7, 0.1, 0.55, 0.3, 0.8])[row]
    tone = np.random.RandomState(58).rand(rows, 2)[row, np.floor(u).astype(int) % 2]
    wood = grain(size, (.36, .22, .115), (.20, .115, .06), 59)
    picture = wood * (0.72 + 0.5 * tone)[..., None]
    picture = _jointed(picture, y * rows, y * rows, 0.018, (.07, .04, .02))
    end = np.abs(u - np.round(u))  # of a plank's length: two nails to either side of a joint as thin as the others
    nails = (np.abs(end - 0.016) < 0.0035) & (np.minimum(np.abs(y * rows % 1 - 0.22), np.abs(y * rows % 1 - 0.78)) < 0.028)
    picture = np.where((end < 0.0022)[..., None], np.asarray((.07, .04, .02)), picture)
    return np.where(nails[..., None], np.asarray((.10, .07, .05)), picture)


# how deep, in metres across one repeat of the picture, its darks lie below its lights
DEPTHS = {"ashlar": 0.004, "parquet_herringbone": 0.0012, "parquet_squares": 0.0012, "flagstones": 0.006, "damask_red": 0.0008, "damask_green": 0.0008,
          "damask_blue": 0.0008, "damask_violet": 0.0007, "oak": 0.0010, "oak_dark": 0.0012, "plaster_lime": 0.006, "paper_stripe": 0.0005, "boards": 0.0015, "plaster_cream": 0.003}


def relief(name):
    """A normal map from the picture's own brightness, gently blurred; green is up (+v)."""
    light = weave(name).mean(axis=-1)
    size = light.shape[0]
    spread = light.max() - light.min()
    height = sum(np.roll(light, (i, j), (0, 1)) for i in (-1, 0, 1) for j in (-1, 0, 1)) / 9.0 / spread * DEPTHS[name] * size
    dx = (np.roll(height, -1, 1) - np.roll(height, 1, 1)) * 0.5
    dy = (np.roll(height, -1, 0) - np.roll(height, 1, 0)) * 0.5
    normal = np.stack([-dx, -dy, np.ones_like(dx)], -1)
    normal /= np.linalg.norm(normal, axis=-1, keepdims=True)
    return normal[:: size // 512, :: size // 512] * 0.5 + 0.5


RECIPES = {
    "ashlar": lambda: _ashlar(512),
    "marble_checker": lambda: _checker(1024), "marble_star": lambda: _star(1024),
    "parquet_herringbone": lambda: _herringbone(1024), "parquet_squares": lambda: _squares(1024),
    "flagstones": lambda: _flagstones(512), "carpet": lambda: _carpet(512),
    "marble_white": lambda: marble(512, (.84, .82, .79), (.60, .58, .57), 71, .6),
    "marble_green": lambda: marble(512, (.07, .17, .13), (.45, .58, .50), 72),
    "marble_rose": lambda: marble(512, (.60, .38, .33), (.85, .74, .68), 73),
    "marble_black": lambda: marble(512, (.06, .06, .07), (.55, .50, .42), 74, .7),
    "paper_stripe": lambda: _paper_stripe(512), "boards": lambda: _boards(512),
    "spine_red": lambda: _spine(256, (.30, .06, .05), 63), "spine_green": lambda: _spine(256, (.08, .18, .10), 64),
    "spine_blue": lambda: _spine(256, (.09, .11, .24), 65), "spine_tan": lambda: _spine(256, (.42, .27, .13), 66),
    "exit_sign": pictograms.exit_sign,
    "oak": lambda: grain(512, (.55, .37, .20), (.34, .20, .10), 81),
    "oak_dark": lambda: grain(512, (.33, .19, .10), (.16, .085, .045), 82),
    "plaster_cream": lambda: plaster(512, (.78, .72, .60), 91),
    "plaster_white": lambda: plaster(512, (.82, .81, .78), 92, 0.06),
    "plaster_stone": lambda: plaster(512, (.70, .66, .58), 93, 0.16),
    "plaster_lime": lambda: plaster(512, (.58, .60, .57), 94, 0.22),
    "damask_red": lambda: _damask(512, (.36, .06, .07), (.52, .13, .11), 95),
    "damask_green": lambda: _damask(512, (.08, .22, .15), (.16, .34, .22), 96),
    "damask_blue": lambda: _damask(512, (.10, .14, .28), (.30, .34, .44), 97),
    "damask_violet": lambda: _damask(512, (.20, .10, .24), (.40, .26, .38), 98),
}


def weave(name):
    return RECIPES[name]()


def save(pixels, name, folder):
    """Writes an opaque JPEG; returns its path."""
    height, width, _ = pixels.shape
    image = bpy.data.images.new(name + "_raw", width, height)
    image.colorspace_settings.name = "Non-Color" if name.endswith("_normal") else "sRGB"
    rgba = np.ones((height, width, 4), dtype=np.float32)
    rgba[..., :3] = np.clip(pixels, 0.0, 1.0)
    image.pixels.foreach_set(rgba.ravel())
    path = os.path.join(folder, name + ".jpg")
    image.filepath_raw, image.file_format = path, "JPEG"
    image.save()
    bpy.data.images.remove(image)
    return path
