#!/usr/bin/env python3
"""Writes paper.csv beside itself: the paper's theta-hat (Eq. 22) and its derivative, by mpmath.

    python3 paper.py

Columns: theta0 as written in the tests, n, the bits of t (an f64, exact), then the function and its derivative, each as
the bits of the nearest f64 and the rest. omega = 1. The phases keep 1/16 of a period from the turning points, where the
arcsine magnifies every rounding; a third of the times are in the first period, a third within 10^6, a third within 10^15.
"""
import random
import struct
from pathlib import Path
from mpmath import mp, mpf, pi, sin, cos, sqrt, exp, agm, asin, floor
from swings import value

mp.dps = 80

CASES = """
0.1;2 1;1 1;3 1π/3;1 1π/3;2 1π/3;6 1π/2;2 1π/2;5 100deg;3 4π/5;3 4π/5;8 7π/8;4 7π/8;12 0.9π;5 0.95π;6 0.95π;20
""".split()


def hat(theta0, n, t):
    k, kc = sin(theta0 / 2), cos(theta0 / 2)
    K, Kp = pi / 2 / agm(1, kc), pi / 2 / agm(1, k)
    q = exp(-pi * Kp / K)
    x, c = pi * (t + K) / (2 * K), pi / (2 * K)
    terms = [(2 * pi / (k * K) * q ** (j - mpf(1) / 2) / (1 - q ** (2 * j - 1)), 2 * j - 1) for j in range(1, n + 1)]
    sn = sum(b * sin(m * x) for b, m in terms)
    slope = sum(b * m * c * cos(m * x) for b, m in terms)
    return 2 * asin(k * sn), 2 * k * slope / sqrt(1 - (k * sn) ** 2)


def words(x):
    high = float(x)
    return f"{struct.pack('>d', high).hex()},{float(x - mpf(high)):.3e}"


if __name__ == "__main__":
    dice = random.Random(2019)
    with Path(__file__).with_suffix(".csv").open("w", encoding="utf-8") as out:
        print("# Written by paper.py, which explains the columns.", file=out)
        for case in CASES:
            text, n = case.split(";")
            theta0 = mpf(value(text))
            period = 2 * pi / agm(1, cos(theta0 / 2))
            for i in range(24):
                while True:
                    t = float(dice.uniform(-1, 1) * period * (1, 1e6, 1e15)[i % 3])
                    phase = 2 * mpf(t) / period
                    phase -= floor(phase)
                    if 0.125 < phase < 0.875:
                        break
                f, slope = hat(theta0, int(n), mpf(t))
                print(f"{text},{n},{struct.pack('>d', t).hex()},{words(f)},{words(slope)}", file=out)
