"""What is always there, and what ends a night: lamp hum and room tone (loops), and two stings.

The loops are periodic by construction: tones with a whole number of turns, noise made in the frequency domain of
the loop's own length.  There is no seam to hide.
"""
import numpy as np

from sounds_kit import RATE, TAU, band_noise, fall, keyed, laid, modes, plate, random_of, seconds, settled


def lamp_hum(name):
    """Filament and ballast at twice the mains' 50 Hz, breathing slowly."""
    rng = random_of(name)
    duration = 4.0
    t = seconds(duration)
    out = np.zeros_like(t)
    for k, level in ((1, 1.0), (2, .50), (3, .30), (4, .22), (6, .12), (8, .055), (12, .028), (18, .014), (27, .007)):
        sway = 1 + .12 * np.sin(TAU * t * rng.randint(1, 4) / duration + rng.uniform(0, TAU))
        out += level * sway * np.sin(TAU * 100 * k * t + rng.uniform(0, TAU))
    buzz = band_noise(rng, duration, 1800, 5200, -4) * (.5 + .5 * np.cos(TAU * 100 * t)) ** 3
    return settled(out + .05 * buzz, -34, True)


def room_tone(name):
    """A large stone house by night: air in ducts, the town far off, a little wind at the skylights."""
    rng = random_of(name)
    duration = 12.0
    t = seconds(duration)

    def slow(turns, depth, phase):
        return 1 + depth * np.sin(TAU * t * turns / duration + phase)

    rumble = band_noise(rng, duration, 32, 130, -4) * slow(1, .25, .3) * slow(3, .12, 1.7)
    ducts = band_noise(rng, duration, 140, 900, -5) * slow(2, .15, 4.0)
    wind = band_noise(rng, duration, 380, 640, -2) * (slow(2, .6, 2.2) * slow(5, .35, .9)) ** 1.5
    whisper = band_noise(rng, duration, 1400, 6500, -5) * slow(1, .3, 5.1)
    tone = .05 * np.sin(TAU * 100 * t) * slow(1, .3, 1.0) + .02 * np.sin(TAU * 150 * t)
    return settled(rumble + .40 * ducts + .13 * wind + .05 * whisper + tone, -35, True)


def sting_caught(name):
    """A hand on the shoulder: a low strike, a cluster that bends down."""
    rng = random_of(name)
    duration = 2.6
    t = seconds(duration)
    out = laid(duration, (.0, modes(1.6, [(49, .9, 1.2), (73.4, .7, .8), (98, .5, .5), (155, .3, .3)])),
               (.0, band_noise(rng, .4, 90, 1600, -5) * fall(.4, .16, .002) * .30))
    for note, level in ((110.0, .5), (116.5, .45), (155.6, .34), (164.8, .30), (233.1, .16)):
        bend = note * 2 ** (-(t / duration) ** 1.4 * 1.1 / 12)
        phase = TAU * np.cumsum(bend) / RATE
        tone = sum(np.sin(k * phase + rng.uniform(0, TAU)) / k ** 1.05 * np.exp(-t * k * .16) for k in range(1, 11))
        out += tone * level * .62 * (1 - np.exp(-t / .018)) * np.exp(-t / .85)
    return settled(out, -9)


def sting_won(name):
    """Out into the night with the light in one's pocket: a glass arpeggio over a warm open chord."""
    rng = random_of(name)
    duration = 3.6
    t = seconds(duration)
    out = np.zeros_like(t)
    for note, level in ((164.81, .35), (246.94, .30), (329.63, .30), (415.30, .22), (493.88, .18)):
        for cents in (-4, 3):
            phase = TAU * note * 2 ** (cents / 1200) * t + rng.uniform(0, TAU)
            tone = sum(np.sin(k * phase) / k ** 2 for k in range(1, 6))
            out += .20 * level * tone * keyed([0, .35, 1.4, 3.6], [0, 1, .8, 0], duration)
    for i, note in enumerate((659.26, 830.61, 987.77, 1318.5, 1661.2, 1975.5, 2637.0)):
        bell = modes(2.4, [(note, 1.9, 1), (note * 1.002, 1.7, .5), (note * 2.756, .6, .2), (note * 5.40, .25, .07)])
        out += laid(duration, (.10 + i * .115, bell * (.42 - .03 * i)))
    return settled(out, -10)


def all_ambient():
    yield "lamp_hum_1", lamp_hum("lamp_hum_1"), True
    yield "room_tone_1", room_tone("room_tone_1"), True
    yield "sting_caught_1", sting_caught("sting_caught_1"), False
    yield "sting_won_1", sting_won("sting_won_1"), False
