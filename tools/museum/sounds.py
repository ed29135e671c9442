"""Synthesises every sound of the museum into assets/sounds, the same bytes every time.

    /usr/bin/python3 tools/museum/sounds.py [FOLDER] [PATTERN]

needs python3-numpy and sox.  Prints for each sound its length, peak, RMS, spectral centroid and DC, and refuses
one that clips or has DC.  game/audio/sound_id.cpp names the same files.
"""
import fnmatch
import os
import sys

import numpy as np

sys.dont_write_bytecode = True
sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))

from sounds_ambient import all_ambient  # noqa: E402
from sounds_impacts import all_impacts  # noqa: E402
from sounds_kit import RATE, write  # noqa: E402
from sounds_things import all_things  # noqa: E402
from sounds_voice import all_voices  # noqa: E402


def decibels(amplitude):
    return 20 * np.log10(max(float(amplitude), 1e-9))


def report(name, samples, is_loop):
    """One line of figures; raises where a sound is not fit to be played."""
    power = np.abs(np.fft.rfft(samples)) ** 2
    centroid = float((np.fft.rfftfreq(len(samples), 1 / RATE) * power).sum() / power.sum())
    peak, dc = np.abs(samples).max(), abs(samples.mean())
    print(f"{name:20s} {len(samples) / RATE:5.2f} s  peak {decibels(peak):6.1f}  rms {decibels(np.sqrt(np.mean(samples ** 2))):6.1f}"
          f"  centroid {centroid:6.0f} Hz  dc {decibels(dc):6.1f}")
    if peak >= .999 or dc > 3e-5:
        raise ValueError(f"{name} clips or has DC")
    steps = np.abs(np.diff(samples))
    if is_loop and abs(samples[0] - samples[-1]) > steps.max() + 1 / 32767:
        raise ValueError(f"{name} has a seam")
    if not is_loop and max(abs(samples[0]), abs(samples[-1])) > 2 / 32767:
        raise ValueError(f"{name} begins or ends with a click")


def main(folder, pattern):
    os.makedirs(folder, exist_ok=True)
    for make in (all_impacts, all_things, all_voices, all_ambient):
        for name, samples, is_loop in make():
            if fnmatch.fnmatch(name, pattern):
                report(name, write(folder, name, samples), is_loop)


if __name__ == "__main__":
    here = os.path.dirname(os.path.abspath(__file__))
    main(sys.argv[1] if len(sys.argv) > 1 else os.path.join(here, "../../assets/sounds"),
         sys.argv[2] if len(sys.argv) > 2 else "*")
