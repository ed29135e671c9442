"""Doors, switches, mirrors, the vitrine, the lens, a throw."""
import numpy as np

from sounds_kit import RATE, TAU, band_noise, convolved, fall, keyed, laid, modes, plate, pulse, random_of, seconds, settled


def click(rng, low, high, t60, contact=.0003, count=9):
    """Small hard metal on metal."""
    out = convolved(modes(.16, plate(rng, low, high, count, t60, t60 * .35, -1.5)), pulse(contact))
    return out / np.abs(out).max()


def stick_slip(rng, duration, rate, jitter, body):
    """A hinge or pivot: it sticks, slips, rings; `rate` (slips a second) is a curve over the sound."""
    out = np.zeros(len(seconds(duration)))
    at = 0.0
    while at < len(out):
        i = int(at)
        out[i] += rng.uniform(.55, 1.0)
        at += RATE / rate[i] * (1 + jitter * rng.uniform(-1, 1))
    out = convolved(out, body)[:len(out)]
    return out / np.abs(out).max()


def door_open(name):
    """Handle, latch drawn back, hinges complaining softly, the leaf moving air."""
    rng = random_of(name)
    duration = 1.25
    wood = modes(.14, [(196, .09, .8), (318, .08, 1), (517, .06, .9), (842, .045, .6), (1370, .03, .45),
                       (2240, .02, .25)])
    rate = keyed([0, .3, .55, .9], [58, 96, 74, 40], .9) * rng.uniform(.9, 1.12)
    hinge = stick_slip(rng, .9, rate, .13, wood) * keyed([0, .12, .3, .55, .9], [0, .75, .4, .8, 0], .9)
    air = band_noise(rng, duration, 60, 380, -5) * keyed([0, .4, .8, duration], [0, 1, .6, 0], duration)
    latch = click(rng, 900, 6500, .045)
    handle = click(rng, 500, 3200, .055, .0008)
    return settled(laid(duration, (.0, handle * .45), (.095, latch * .9), (.105, click(rng, 1500, 7500, .03) * .4),
                        (.16, hinge * .42), (.10, air * .09)), -16)


def door_close(name):
    """The leaf meets its frame: a low panel, then the latch falls in."""
    rng = random_of(name)
    pitch = rng.uniform(.93, 1.07)
    panel = modes(.7, [(61 * pitch, .30, 1.0), (104 * pitch, .26, .9), (167 * pitch, .19, .7), (243 * pitch, .14, .55),
                       (381 * pitch, .10, .4), (617 * pitch, .07, .3), (980 * pitch, .045, .2)])
    thud = convolved(panel, pulse(.0045))
    rattle = click(rng, 700, 5200, .06)
    air = band_noise(rng, .35, 70, 420, -4) * keyed([0, .26, .35], [0, 1, 0], .35)
    return settled(laid(1.0, (.0, air * .10), (.28, thud / np.abs(thud).max()), (.300, rattle * .28),
                        (.327, click(rng, 1100, 6800, .05) * .35), (.352, click(rng, 1800, 7500, .03) * .14)), -13)


def iron(rng, low, high, count, t60):
    """A riveted sheet: many plate modes, close together and slow to die, some of them loose against each other."""
    return modes(t60 * 1.3, plate(rng, low, high, count, t60, t60 * .22, -4))


def gate_open(name):
    """A bolt drawn through its staple, then a sheet of iron that shivers on dry pins."""
    rng = random_of(name)
    duration = 1.7
    sheet = iron(rng, 92, 3600, 30, 1.1)
    draw = band_noise(rng, .17, 1400, 6800, -3) * keyed([0, .04, .14, .17], [0, 1, .8, 0], .17)
    knock = convolved(sheet, pulse(.0011))
    rate = keyed([0, .25, .6, .95], [31, 52, 44, 22], .95) * rng.uniform(.92, 1.1)
    pins = stick_slip(rng, .95, rate, .16, iron(rng, 310, 4200, 14, .16)) * keyed([0, .1, .35, .6, .95], [0, .9, .45, .8, 0], .95)
    shiver = convolved(sheet, band_noise(rng, .5, 60, 420, -4) * keyed([0, .1, .5], [0, 1, 0], .5))
    return settled(laid(duration, (.0, draw * .22), (.15, click(rng, 700, 5200, .07, .0006) * .6),
                        (.15, knock / np.abs(knock).max() * .50), (.22, pins * .36),
                        (.24, shiver / np.abs(shiver).max() * .16)), -14)


def gate_close(name):
    """Iron on iron: the sheet booms, its rivets chatter, the bolt drops."""
    rng = random_of(name)
    duration = 1.9
    boom = convolved(iron(rng, 74, 2600, 34, 1.5), pulse(.0024))
    frame = convolved(modes(.5, [(119, .34, 1.0), (188, .27, .8), (333, .18, .5), (571, .12, .3)]), pulse(.003))
    chatter = laid(.3, *[(t, click(rng, 900, 6200, .05, .0005) * g) for t, g in ((.0, .6), (.031, .34), (.055, .2), (.074, .1))])
    pins = stick_slip(rng, .2, np.full(int(.2 * RATE), 40.0), .2, iron(rng, 310, 4200, 12, .12)) * keyed([0, .1, .2], [0, 1, 0], .2)
    return settled(laid(duration, (.0, pins * .16), (.2, boom / np.abs(boom).max() * .8), (.2, frame / np.abs(frame).max() * .6),
                        (.206, chatter * .42), (.40, click(rng, 600, 4600, .09, .0007) * .45)), -11)


def pick_up(name):
    """A small hard thing lifted off a table: a scrape, a tick, a sleeve."""
    rng = random_of(name)
    sleeve = band_noise(rng, .26, 700, 4200, -4) * keyed([0, .07, .16, .26], [0, 1, .4, 0], .26)
    scrape = band_noise(rng, .08, 2200, 7800, -2) * keyed([0, .02, .08], [0, 1, 0], .08)
    return settled(laid(.42, (.0, scrape * .20), (.05, click(rng, 1500, 7000, .03, .0004) * .5), (.08, sleeve * .30)), -25)


def vitrine_open(name):
    """A small brass hinge and a glass lid that hums as a fingertip lifts it."""
    rng = random_of(name)
    pane = plate(rng, 870, 7200, 12, .75, .22, -3)
    touch = convolved(modes(.9, pane), pulse(.0012))
    slide = band_noise(rng, .7, 2300, 7800, -3) * keyed([0, .15, .45, .7], [0, .8, .5, 0], .7)
    hinge = stick_slip(rng, .55, np.full(int(.55 * RATE), 128.0), .2, modes(.05, [(1450, .03, 1), (2630, .02, .7)]))
    return settled(laid(1.2, (.0, click(rng, 2200, 9000, .025) * .5), (.06, touch / np.abs(touch).max() * .30),
                        (.08, slide * .035), (.12, hinge * keyed([0, .2, .55], [0, 1, 0], .55) * .10)), -20)


def vitrine_close(name):
    """Glass laid on felt: a soft thump, a short ring, a tiny lock."""
    rng = random_of(name)
    ring = convolved(modes(.8, plate(rng, 820, 7600, 14, .38, .12, -2.5)), pulse(.0010))
    thump = modes(.4, [(128, .09, 1), (214, .07, .6)])
    return settled(laid(.85, (.003, thump * .5), (.003, ring / np.abs(ring).max() * .55),
                        (.14, click(rng, 2600, 9500, .022) * .35)), -19)


def switch(name):
    """A toggle with a spring: the tick of letting go and the tock of arriving, on a brass plate."""
    rng = random_of(name)
    box = modes(.15, [(310 * rng.uniform(.95, 1.05), .045, .8), (585, .035, .6)])
    return settled(laid(.22, (.0, click(rng, 1900, 8200, .016) * .45), (.019, click(rng, 1200, 6900, .024)),
                        (.019, box * .35), (.031, click(rng, 2500, 9000, .012) * .18)), -17)


def mirror_turn(name):
    """Bronze on a dry pivot: rumble, a groan that climbs, and the notch it falls into."""
    rng = random_of(name)
    duration = 1.25
    bronze = modes(.3, [(173, .20, .8), (287, .22, 1.0), (431, .17, .8), (668, .13, .6), (1015, .09, .4),
                        (1540, .06, .25)])
    rate = keyed([0, .25, .7, 1.05], [19, 33, 41, 24], 1.05) * rng.uniform(.92, 1.1)
    groan = stick_slip(rng, 1.05, rate, .10, bronze) * keyed([0, .15, .5, .85, 1.05], [0, .8, 1, .7, 0], 1.05)
    rumble = band_noise(rng, 1.05, 55, 260, -3) * keyed([0, .2, .8, 1.05], [0, 1, .8, 0], 1.05)
    grit = band_noise(rng, 1.05, 1500, 5200, -4) * keyed([0, .3, .8, 1.05], [0, 1, .7, 0], 1.05)
    grit *= .5 + .5 * np.abs(np.sin(np.cumsum(rate) * np.pi / RATE))
    notch = convolved(modes(.4, plate(rng, 260, 4200, 14, .26, .06, -3)), pulse(.0012))
    return settled(laid(duration + .25, (.0, groan * .60), (.0, rumble * .13), (.0, grit * .035),
                        (1.06, notch / np.abs(notch).max() * .75)), -15)


def lens_taken(name):
    """Light caught in glass: bowed edges of a crystal bowl, a rising open chord, slow beats."""
    rng = random_of(name)
    duration = 2.6
    out = np.zeros(int(duration * RATE))
    for i, (note, start, level) in enumerate(((659.26, .0, .55), (987.77, .075, .6), (1318.5, .15, .7), (1975.5, .235, .55),
                                              (2637.0, .33, .38))):
        tone = np.zeros(int((duration - start) * RATE))
        t = np.arange(len(tone)) / RATE
        for ratio, gain, t60 in ((1, 1, 2.3), (1.0021, .55, 2.1), (2.756, .20, .8), (5.40, .07, .35)):
            tone += gain * np.sin(TAU * note * ratio * t + rng.uniform(0, TAU)) * np.exp(-6.908 * t / t60)
        tone *= 1 - np.exp(-t / (.004 + .002 * i))
        out += laid(duration, (start, tone * level))
    air = band_noise(rng, duration, 5200, 11500) * keyed([0, .25, .9, duration], [0, .02, .006, 0], duration)
    return settled(out + air, -15)


def throw(name):
    """Sleeve and air: a whoosh whose pitch rises and falls."""
    rng = random_of(name)
    duration = .34
    low = band_noise(rng, duration, 250, 900, -3) * keyed([0, .12, .22, duration], [0, 1, .5, 0], duration)
    high = band_noise(rng, duration, 1100, 4200, -4) * keyed([0, .08, .15, .24, duration], [0, .1, 1, .2, 0], duration)
    return settled(low * .6 + high * .5, -27)


def all_things():
    for make, count in ((door_open, 2), (door_close, 2), (gate_open, 2), (gate_close, 2), (pick_up, 2), (vitrine_open, 1), (vitrine_close, 1), (switch, 2),
                        (mirror_turn, 2), (lens_taken, 1), (throw, 2)):
        for i in range(1, count + 1):
            name = f"{make.__name__}_{i}"
            yield name, make(name), False
