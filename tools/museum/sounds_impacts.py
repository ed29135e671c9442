"""Steps, boots, stones and bodies on five kinds of ground.

One model for all: a force pulse, as short as the things are hard, strikes the ground's modes and its noise, and
the striker's own modes ring along.  A step is two such strikes, heel and ball, with a scuff between.
"""
import numpy as np

from sounds_kit import band_noise, convolved, fall, keyed, laid, modes, plate, pulse, random_of, seconds, settled

GROUNDS = ("marble", "parquet", "carpet", "metal", "glass")


def ground_response(rng, ground, duration=.9):
    """What one unit of impulse does to the ground near it."""
    if ground == "marble":  # a slab on sand: a short dull body and a hard, very short surface
        out = modes(duration, [(92 * rng.uniform(.93, 1.07), .085, .30), (171 * rng.uniform(.95, 1.05), .060, .24),
                               (405 * rng.uniform(.9, 1.1), .038, .22)])
        out += 2.4 * modes(duration, plate(rng, 700, 6500, 18, .048, .014, -2))
        return out + .50 * band_noise(rng, duration, 1200, 7500, -2) * fall(duration, .030)
    if ground == "parquet":  # boards over joists: low, warm, each board with its own pitch
        pitch = rng.uniform(.9, 1.12)
        out = modes(duration, [(84 * pitch, .16, .40), (139 * pitch, .14, .55), (227 * pitch, .11, .55),
                               (338 * pitch, .085, .60), (521 * pitch, .060, .55), (790 * pitch, .042, .45)])
        out += 1.8 * modes(duration, plate(rng, 900, 3800, 12, .045, .016, -4))
        return out + .12 * band_noise(rng, duration, 700, 4200, -4) * fall(duration, .030)
    if ground == "carpet":  # pile swallows everything above the thump
        out = modes(duration, [(71 * rng.uniform(.94, 1.06), .090, .9), (118 * rng.uniform(.94, 1.06), .070, .5)])
        return out + .20 * band_noise(rng, duration, 180, 900, -5) * fall(duration, .060, .004)
    if ground == "metal":  # a plate on a frame: dense and long
        out = modes(duration, [(118 * rng.uniform(.96, 1.04), .20, .20), (207 * rng.uniform(.96, 1.04), .24, .24)])
        out += 2.2 * modes(duration, plate(rng, 310, 6800, 34, .42, .12, -2.2))
        return out + .12 * band_noise(rng, duration, 1500, 8000, -2) * fall(duration, .028)
    out = modes(duration, [(148 * rng.uniform(.95, 1.05), .060, .18)])  # glass: light, bright, quick
    out += 2.0 * modes(duration, plate(rng, 780, 9500, 26, .19, .045, -1.2))
    return out + .14 * band_noise(rng, duration, 2500, 10500, 0) * fall(duration, .020)


# contact in ms of a soft-soled shoe and of a boot's heel; share of scuff; peak dBFS at 1 m of shoe and boot
STEP = {"marble": (1.9, .60, .045, -19, -13), "parquet": (2.6, 1.0, .04, -18, -12), "carpet": (10., 7.0, .17, -25, -19),
        "metal": (1.5, .50, .035, -17, -11), "glass": (1.4, .50, .03, -18, -12)}


def struck(response, contact, grit):
    """A sole is not one spring: a share of its force comes and goes much faster, where hard grains touch."""
    slow, fast = convolved(response, pulse(contact)), convolved(response, pulse(contact * .14))
    fast = np.pad(fast, (0, max(0, len(slow) - len(fast))))[:len(slow)]
    return slow / np.abs(slow).max() * (1 - grit) + fast / np.abs(fast).max() * grit


def step(name, ground, boot):
    """Heel, scuff, ball.  A thief's soft sole rolls; a guard's nailed heel strikes, and its leather creaks."""
    rng = random_of(name)
    soft_ms, boot_ms, scuff, soft_db, boot_db = STEP[ground]
    contact = (boot_ms if boot else soft_ms) * rng.uniform(.88, 1.14) * 1e-3
    response = ground_response(rng, ground)
    grit = .05 if ground == "carpet" else .44 if boot else .40
    heel = struck(response, contact, grit)
    ball = struck(ground_response(rng, ground), contact * (1.9 if boot else 1.35), grit * .7)
    gap = rng.uniform(.085, .110) if boot else rng.uniform(.055, .080)
    heel, ball = heel / np.abs(heel).max(), ball / np.abs(ball).max()
    drag = band_noise(rng, .09, 900 if ground != "carpet" else 350, 5200 if ground != "carpet" else 2200, -3)
    drag *= keyed([0, .02, .055, .09], [0, 1, .4, 0], .09) * scuff * (.8 if boot else 1.1)
    pieces = [(.002, heel), (.012, drag), (.002 + gap, ball * (rng.uniform(.42, .58) if boot else rng.uniform(.6, .8)))]
    weight = modes(.3, [(52 * rng.uniform(.95, 1.05), .11, 1.0)]) * (.15 if boot else .06)
    pieces.append((.004, weight))
    if boot:
        pieces.append((.05 + gap, creak(rng, .11) * .035))
        if ground != "carpet":
            nail = modes(.08, [(3150 * rng.uniform(.94, 1.06), .020, 1), (5240 * rng.uniform(.94, 1.06), .013, .7)])
            pieces.append((.002, nail * .16))
    length = {"metal": .80, "glass": .50, "parquet": .48}.get(ground, .40)
    return settled(laid(length, *pieces), (boot_db if boot else soft_db) + rng.uniform(-1, 1))


def creak(rng, duration):
    """Leather or wood that sticks and slips: small clicks at an uneven rate through a few resonances."""
    out = np.zeros(len(seconds(duration)))
    at = 0.0
    while at < duration:
        i = int(at * len(out) / duration)
        out[i] += rng.uniform(.4, 1.0)
        at += rng.uniform(.006, .013)
    body = modes(.05, [(640, .035, 1), (1180, .025, .7), (2050, .016, .5)])
    out = convolved(out, body)[:len(out)] * keyed([0, duration * .3, duration], [0, 1, 0], duration)
    return out / np.abs(out).max()


# contact ms, peak dBFS at 1 m
STONE = {"marble": (.28, -9), "parquet": (.55, -12), "carpet": (4.0, -24), "metal": (.25, -8), "glass": (.24, -9)}


def stone(name, ground):
    """A pebble of 60 g: its own hard click and what it strikes out of the ground."""
    rng = random_of(name)
    contact_ms, peak_db = STONE[ground]
    contact = contact_ms * rng.uniform(.85, 1.2) * 1e-3
    own = modes(.12, [(3650 * rng.uniform(.9, 1.1), .030, .8), (5900 * rng.uniform(.9, 1.1), .022, .7),
                      (8700 * rng.uniform(.9, 1.1), .014, .5)])
    ground_part = stone_ground(rng, ground)
    out = convolved(ground_part, pulse(contact))
    own = convolved(own, pulse(contact)) * (.05 if ground == "carpet" else .45)
    out = out / np.abs(out).max()
    length = {"metal": 1.5, "glass": 1.0, "parquet": .45}.get(ground, .35)
    return settled(laid(length, (.002, out), (.002, own / np.abs(own).max() * (.05 if ground == "carpet" else .5))),
                   peak_db + rng.uniform(-.8, .8))


def stone_ground(rng, ground):
    if ground == "marble":
        return (modes(.3, plate(rng, 1350, 9500, 18, .075, .018, -.8)) * 1.6
                + modes(.3, [(240 * rng.uniform(.9, 1.1), .045, .25), (610 * rng.uniform(.9, 1.1), .05, .25)])
                + .16 * band_noise(rng, .3, 2500, 11000) * fall(.3, .014))
    if ground == "parquet":
        pitch = rng.uniform(.9, 1.12)
        return (modes(.4, [(232 * pitch, .11, .9), (418 * pitch, .10, 1.0), (655 * pitch, .075, .8),
                           (1040 * pitch, .05, .5), (1630 * pitch, .035, .35)])
                + .10 * band_noise(rng, .4, 1200, 5000, -3) * fall(.4, .016))
    if ground == "carpet":
        return modes(.3, [(96 * rng.uniform(.94, 1.06), .07, 1)]) + .4 * band_noise(rng, .3, 200, 1100, -4) * fall(
            .3, .05, .003)
    if ground == "metal":
        return (1.7 * modes(1.6, plate(rng, 240, 8800, 46, 1.35, .35, -1.6))
                + .08 * band_noise(rng, 1.6, 2500, 11000) * fall(1.6, .015))
    return (1.7 * modes(1.1, plate(rng, 980, 11500, 34, .62, .13, -.6))
            + .10 * band_noise(rng, 1.1, 3500, 13000) * fall(1.1, .010))


def land(name):
    """Two feet and a body's weight from a height, cloth and a grunt of the floor."""
    rng = random_of(name)
    thump = convolved(modes(.6, [(48, .20, 1), (83 * rng.uniform(.95, 1.05), .15, .8), (132, .10, .5)]), pulse(.009))
    slap = convolved(ground_response(rng, "marble"), pulse(.0032))
    cloth = band_noise(rng, .3, 500, 3500, -3) * keyed([0, .03, .12, .3], [0, 1, .35, 0], .3)
    return settled(laid(.65, (.002, thump / np.abs(thump).max()), (.003, slap / np.abs(slap).max() * .55),
                        (.022, slap / np.abs(slap).max() * .35), (.0, cloth * .06)), -11)


def all_impacts():
    for ground in GROUNDS:
        for i in range(1, 5):
            yield f"step_{ground}_{i}", step(f"step_{ground}_{i}", ground, False), False
            yield f"boot_{ground}_{i}", step(f"boot_{ground}_{i}", ground, True), False
        for i in range(1, (2 if ground == "carpet" else 3) + 1):
            yield f"stone_{ground}_{i}", stone(f"stone_{ground}_{i}", ground), False
    for i in (1, 2):
        yield f"land_{i}", land(f"land_{i}"), False
