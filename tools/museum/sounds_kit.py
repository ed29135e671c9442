"""Modes, noises, envelopes and files: what the museum's sounds are synthesised from.

Everything is mono at 48 kHz in float64 and follows from the sound's name alone: noise is drawn from a Mersenne
twister seeded by it, whose numbers numpy has promised never to change.
"""
import os
import subprocess
import tempfile
import wave
import zlib

import numpy as np

RATE = 48000
TAU = 2 * np.pi


def random_of(name):
    return np.random.RandomState(zlib.crc32(name.encode()))


def seconds(duration):
    return np.arange(int(round(duration * RATE))) / RATE


def modes(duration, partials):
    """Damped sines that ring from t = 0: (frequency Hz, seconds to fall by 60 dB, amplitude)."""
    t = seconds(duration)
    out = np.zeros_like(t)
    for frequency, t60, amplitude in partials:
        if frequency < RATE * .45:
            out += amplitude * np.sin(TAU * frequency * t) * np.exp(-6.908 * t / t60)
    return out


def plate(rng, low, high, count, t60_low, t60_high, tilt_db=-3.0):
    """`count` modes of a stiff plate: spread evenly in the square root of frequency, the higher the shorter."""
    u = (np.arange(count) + .5 + .35 * rng.uniform(-1, 1, count)) / count
    frequency = (np.sqrt(low) + u * (np.sqrt(high) - np.sqrt(low))) ** 2
    octave = np.log2(frequency / low)
    amplitude = 10 ** (tilt_db * octave / 20) * rng.uniform(.35, 1.0, count) * rng.choice([-1, 1], count)
    t60 = t60_low * (t60_high / t60_low) ** u
    return list(zip(frequency, t60, amplitude / np.sqrt(count)))


def pulse(contact_s):
    """The force of a short contact: a raised cosine of unit area; soft things touch longer and sound duller."""
    n = max(3, int(contact_s * RATE))
    shape = .5 - .5 * np.cos(TAU * (np.arange(n) + .5) / n)
    return shape / shape.sum()


def convolved(a, b):
    n = len(a) + len(b) - 1
    size = 1 << (n - 1).bit_length()
    return np.fft.irfft(np.fft.rfft(a, size) * np.fft.rfft(b, size), size)[:n]


def band_noise(rng, duration, low, high, slope_db=0.0):
    """Noise between two frequencies with soft edges, `slope_db` an octave, of RMS 1; periodic in its length."""
    n = int(round(duration * RATE))
    spectrum = np.fft.rfft(rng.standard_normal(n))
    f = np.fft.rfftfreq(n, 1 / RATE)
    safe = np.maximum(f, 1.0)
    gain = 1 / np.sqrt((1 + (low / safe) ** 6) * (1 + (safe / high) ** 6)) * 10 ** (slope_db * np.log2(safe / low) / 20)
    gain[0] = 0
    noise = np.fft.irfft(spectrum * gain, n)
    return noise / np.sqrt(np.mean(noise ** 2))


def fall(duration, t60, attack=.0008):
    t = seconds(duration)
    return (1 - np.exp(-t / attack)) * np.exp(-6.908 * t / t60)


def keyed(times, values, duration):
    """Piecewise smooth curve over a sound, from (time, value) keys."""
    t = seconds(duration)
    i = np.clip(np.searchsorted(times, t, side="right") - 1, 0, len(times) - 2)
    times, values = np.asarray(times, dtype=float), np.asarray(values, dtype=float)
    u = np.clip((t - times[i]) / (times[i + 1] - times[i]), 0, 1)
    u = u * u * (3 - 2 * u)
    return values[i] + (values[i + 1] - values[i]) * u


def laid(total_s, *pieces):
    """Sum of (start in seconds, samples) in a silence of the given length."""
    out = np.zeros(int(round(total_s * RATE)))
    for start, samples in pieces:
        at = int(round(start * RATE))
        n = min(len(samples), len(out) - at)
        out[at:at + n] += samples[:n]
    return out


def settled(samples, peak_db, is_loop=False):
    """No DC, ends that meet zero (unless it loops), and the given peak."""
    samples = samples - samples.mean()
    if not is_loop:
        f = np.fft.rfftfreq(len(samples), 1 / RATE)
        samples = np.fft.irfft(np.fft.rfft(samples) * (f / 28) ** 4 / (1 + (f / 28) ** 4), len(samples))
        n = min(int(.02 * RATE), len(samples) // 4)
        samples[:48] *= np.linspace(0, 1, 48)
        samples[-n:] *= .5 + .5 * np.cos(np.pi * np.arange(n) / n)
        # What the fades leave of DC goes out with the same fades, so that both ends stay at zero.
        window = np.ones(len(samples))
        window[:48] = np.linspace(0, 1, 48)
        window[-n:] = .5 + .5 * np.cos(np.pi * np.arange(n) / n)
        samples -= window * samples.sum() / window.sum()
    return samples * (10 ** (peak_db / 20) / np.abs(samples).max())


def write(folder, name, samples):
    """16-bit FLAC by sox, without dither or comments, so that its bytes follow from the samples."""
    quantised = np.round(np.clip(samples, -1, 1) * 32767).astype("<i2")
    with tempfile.TemporaryDirectory() as scratch:
        plain = os.path.join(scratch, "plain.wav")
        with wave.open(plain, "wb") as file:
            file.setnchannels(1)
            file.setsampwidth(2)
            file.setframerate(RATE)
            file.writeframes(quantised.tobytes())
        subprocess.run(["sox", "-D", plain, "-C", "8", "--comment", "", os.path.join(folder, name + ".flac")],
                       check=True)
    return quantised / 32767
