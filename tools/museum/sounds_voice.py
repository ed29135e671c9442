"""The watchman's voice, without words: a glottal source through a vocal tract of five moving formants.

Source: Rosenberg's pulse, its derivative taken for the lips, with jitter, shimmer and breath.  Tract: a cascade
of two-pole resonators (Klatt 1980) whose frequencies glide from vowel to vowel; a closed mouth hums through the
nose.  And a whistle, which is one formant blown.
"""
import numpy as np

from sounds_kit import RATE, TAU, band_noise, keyed, laid, random_of, seconds, settled

# First five formants in Hz of a man of 45
VOWELS = {"a": (730, 1190, 2440, 3300, 3850), "uh": (620, 1180, 2400, 3300, 3850), "e": (510, 1820, 2500, 3350, 3850),
          "i": (320, 2180, 2850, 3500, 3900), "o": (480, 860, 2380, 3250, 3800), "u": (340, 800, 2230, 3200, 3800),
          "schwa": (500, 1480, 2450, 3300, 3850), "m": (260, 1050, 2150, 3000, 3700), "oi": (560, 900, 2400, 3250, 3800)}
WIDTHS = (70, 90, 130, 220, 280)


def glottis(rng, pitch, open_share, jitter=.012, shimmer=.06):
    """Flow through the vocal folds for a pitch contour: rises, falls faster, stays shut."""
    flow = np.zeros(len(pitch))
    at = 0.0
    while at < len(flow) - 1:
        period = RATE / pitch[int(at)] * (1 + jitter * rng.standard_normal())
        level = 1 + shimmer * rng.standard_normal()
        opening, closing = period * open_share * .67, period * open_share * .33
        start = int(np.ceil(at))
        k = np.arange(start, min(len(flow), int(at + opening + closing) + 1)) - at
        rising = .5 - .5 * np.cos(np.pi * k / opening)
        falling = np.cos(np.pi / 2 * np.clip((k - opening) / closing, 0, 1))
        flow[start:start + len(k)] = np.where(k < opening, rising, falling) * level
        at += period
    return flow


def tract(source, formants, widths):
    """Cascade of resonators of unit gain at DC; `formants` has one row of frequencies a formant."""
    out = source
    for frequency, width in zip(formants, widths):
        r = np.exp(-np.pi * width / RATE)
        b = 2 * r * np.cos(TAU * frequency / RATE)
        c = -r * r
        a = 1 - b - c
        y1 = y2 = 0.0
        result = np.empty_like(out)
        for i in range(len(out)):
            y = a[i] * out[i] + b[i] * y1 + c * y2
            y2, y1 = y1, y
            result[i] = y
        out = result
    return out


def utterance(name, duration, vowels, pitch, voicing, breath, effort=.5, peak_db=-14, wide=1.0):
    """vowels: (time, vowel) keys; pitch, voicing, breath: (time, value) keys; effort presses the folds."""
    rng = random_of(name)
    scale = rng.uniform(.99, 1.01)
    curve = [keyed([t for t, _ in vowels], [VOWELS[v][i] * scale for _, v in vowels], duration) for i in range(5)]
    f0 = keyed(*zip(*pitch), duration) * rng.uniform(.97, 1.03)
    f0 = f0 * (1 + .006 * np.sin(TAU * 5.3 * seconds(duration)))
    flow = glottis(rng, f0, .72 - .22 * effort)
    buzz = np.diff(flow, prepend=0.0) * 14
    # Below full effort the folds close softly, and the source loses its highs.
    tilt = .62 - .55 * effort
    state, soft = 0.0, np.empty_like(buzz)
    for i, x in enumerate(buzz):
        state = (1 - tilt) * x + tilt * state
        soft[i] = state
    air = band_noise(rng, duration, 350, 7000, -1) * (.35 + .65 * np.clip(flow, 0, 1))
    voiced = keyed(*zip(*voicing), duration)
    blown = keyed(*zip(*breath), duration)
    out = tract(soft * voiced + air * blown * .10, curve, [w * wide for w in WIDTHS])
    out = out + 5.0 * effort ** 2 * np.diff(out, prepend=0.0)  # who presses, brightens
    return settled(out, peak_db)


def hm(name, rise):
    """Through the nose, mouth closed: something is not as it was."""
    return utterance(name, .52, [(0, "m"), (.52, "m")], [(0, 104), (.14, 98), (.52, 98 * rise)],
                     [(0, 0), (.05, 1), (.34, .9), (.50, 0), (.52, 0)], [(0, 0), (.05, .10), (.52, 0)], .35, -19, 1.5)


def huh(name):
    return utterance(name, .44, [(0, "uh"), (.30, "uh"), (.44, "schwa")], [(0, 150), (.14, 158), (.26, 140), (.44, 196)],
                     [(0, 0), (.09, 0), (.13, 1), (.30, .8), (.42, 0), (.44, 0)],
                     [(0, 0), (.04, 1.3), (.12, .5), (.40, .25), (.44, 0)], .55, -16)


def who(name, first, second):
    """Two calls into the dark, the second rising: is anybody there?"""
    return utterance(name, .98, [(0, first), (.26, first), (.44, second), (.98, "u" if second == "o" else second)],
                     [(0, 138), (.16, 152), (.34, 128), (.60, 150), (.98, 215)],
                     [(0, 0), (.07, 1), (.27, .9), (.36, .12), (.46, 1), (.80, .9), (.96, 0), (.98, 0)],
                     [(0, .9), (.08, .2), (.34, .3), (.46, .15), (.95, .2), (.98, 0)], .72, -12)


def alarm(name, vowels, top):
    """Has seen you: short, pressed, high, falling."""
    return utterance(name, .62, vowels, [(0, top * .78), (.10, top), (.28, top * .98), (.62, top * .66)],
                     [(0, 0), (.035, 0), (.06, 1), (.40, 1), (.58, 0), (.62, 0)],
                     [(0, 0), (.02, 1.4), (.07, .25), (.45, .35), (.62, 0)], .98, -7)


def gave_up(name, length):
    """A sigh: breath in, then out with half a voice sinking in it."""
    return utterance(name, length, [(0, "i"), (.30, "schwa"), (.5, "a"), (length, "schwa")],
                     [(0, 118), (.42, 122), (length, 82)],
                     [(0, 0), (.40, 0), (.52, .40), (length * .66, .22), (length * .9, 0), (length, 0)],
                     [(0, 0), (.18, .55), (.32, .1), (.42, .6), (.60, 1.5), (length * .8, .55), (length, 0)], .2, -19)


def caught(name, top):
    """Ha-ha: got you."""
    return utterance(name, .86, [(0, "a"), (.30, "a"), (.42, "a"), (.86, "uh")],
                     [(0, top * .86), (.14, top * .92), (.30, top * .85), (.50, top * 1.15), (.86, top * .72)],
                     [(0, 0), (.07, 0), (.11, .9), (.22, .7), (.29, 0), (.38, 0), (.42, 1), (.66, .8), (.82, 0), (.86, 0)],
                     [(0, 0), (.05, 1.4), (.12, .3), (.29, .7), (.37, 1.5), (.43, .3), (.70, .4), (.86, 0)], .85, -10)


TUNES = (((0, 2.0, .34), (.36, 4.0, .16), (.54, 5.0, .40), (1.02, 4.0, .16), (1.20, 0.0, .22), (1.46, -3.0, .62)),
         ((0, 7.0, .22), (.24, 5.0, .20), (.46, 2.0, .46), (1.0, 0.0, .18), (1.20, 2.0, .18), (1.40, -1.0, .70)))


def whistle(name, tune):
    """Under his breath as he walks his round."""
    rng = random_of(name)
    duration = tune[-1][0] + tune[-1][2] + .25
    pitch, level = [(0, 1150 * 2 ** (tune[0][1] / 12))], [(0, 0.0)]
    for start, note, length in tune:
        f = 1150 * 2 ** (note / 12) * (1 + .006 * rng.uniform(-1, 1))
        pitch += [(start + .045, f), (start + length, f * .997)]
        level += [(start + .05, 1.0), (start + length * .8, .8), (start + length + .015, .08)]
    pitch.append((duration, pitch[-1][1]))
    level.append((duration, 0.0))
    f0 = keyed(*zip(*pitch), duration)
    t = seconds(duration)
    f0 = f0 * (1 + .007 * np.sin(TAU * 5.6 * t) + .0025 * band_noise(rng, duration, 2, 14))
    phase = TAU * np.cumsum(f0) / RATE
    env = keyed(*zip(*level), duration)
    breath = band_noise(rng, duration, 1200, 2600)
    out = (np.sin(phase) + .035 * np.sin(2 * phase)) * env * (1 + .05 * band_noise(rng, duration, 5, 40))
    return settled(out + breath * .035 * (.25 + env), -23)


def all_voices():
    yield "voice_hm_1", hm("voice_hm_1", 1.42), False
    yield "voice_hm_2", hm("voice_hm_2", 1.22), False
    yield "voice_hm_3", huh("voice_hm_3"), False
    yield "voice_who_1", who("voice_who_1", "e", "o"), False
    yield "voice_who_2", who("voice_who_2", "uh", "a"), False
    yield "voice_alarm_1", alarm("voice_alarm_1", [(0, "e"), (.18, "e"), (.40, "i"), (.62, "i")], 262), False
    yield "voice_alarm_2", alarm("voice_alarm_2", [(0, "oi"), (.20, "oi"), (.38, "i"), (.62, "i")], 244), False
    yield "voice_gave_up_1", gave_up("voice_gave_up_1", 1.45), False
    yield "voice_gave_up_2", gave_up("voice_gave_up_2", 1.70), False
    yield "voice_caught_1", caught("voice_caught_1", 190), False
    yield "voice_caught_2", caught("voice_caught_2", 172), False
    for i, tune in enumerate(TUNES, 1):
        yield f"voice_whistle_{i}", whistle(f"voice_whistle_{i}", tune), False
