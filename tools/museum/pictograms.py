"""Figures drawn from a few bars, for signs."""
import numpy as np

_BARS = [  # of the runner, who is 1 high: from, to, radius
    ((0.93, 0.66), (0.81, 0.43), 0.085),                                          # trunk
    ((0.84, 0.42), (1.05, 0.33), 0.060), ((1.05, 0.33), (1.00, 0.10), 0.050),     # the leg before
    ((0.80, 0.40), (0.68, 0.23), 0.060), ((0.68, 0.23), (0.43, 0.21), 0.050),     # the leg behind
    ((0.97, 0.68), (1.13, 0.53), 0.042), ((1.13, 0.53), (1.29, 0.60), 0.038),     # arms
    ((0.89, 0.69), (0.70, 0.64), 0.042), ((0.70, 0.64), (0.63, 0.47), 0.038),
]


def _bar(x, y, a, b, radius):
    dx, dy = b[0] - a[0], b[1] - a[1]
    t = np.clip(((x - a[0]) * dx + (y - a[1]) * dy) / (dx * dx + dy * dy), 0.0, 1.0)
    return np.hypot(x - a[0] - t * dx, y - a[1] - t * dy) < radius


def exit_sign():
    """Twice as wide as high, white on green: an arrow down, a runner, and the doorway that takes him in; where they
    cross, the figure is green. Rows from the bottom, as textures.py keeps them."""
    fine = 4
    x, y = np.meshgrid((np.arange(256 * fine) + 0.5) / (128 * fine), (np.arange(128 * fine) + 0.5) / (128 * fine))
    runner = np.hypot(x - 1.02, y - 0.82) < 0.085
    for bar in _BARS:
        runner |= _bar(x, y, *bar)
    door = (x > 1.30) & (x < 1.84) & (y > 0.07) & (y < 0.93)
    arrow = (np.abs(x - 0.24) < 0.045) & (y > 0.3) & (y < 0.82) | (y > 0.14) & (np.abs(x - 0.24) < (y - 0.14) * 0.62) & (y < 0.42)
    white = (door ^ runner | arrow).astype(float).reshape(128, fine, 256, fine).mean((1, 3))
    return np.array((0.02, 0.36, 0.16)) * (1 - white[..., None]) + np.array((0.86, 1.0, 0.90)) * white[..., None]
