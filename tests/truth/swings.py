#!/usr/bin/env python3
"""Writes swings.csv beside itself: what tests/truth/mod.rs needs of each swing, by mpmath.

    python3 swings.py

A swing starts from (theta0, velocity0) with the rate omega, all of them exact reals. Columns:

  start       theta0;velocity0;omega as written in the tests, without spaces
  rate        1/T in three words
  frequency   pi/(2K) in two words: the rate of x = 2 pi t/T per unit of omega t
  dual        1 where the sums run over the dual variable y = pi u/(2K') instead of x = pi u/(2K)
  base        h of the sums, exp(-pi K'/(2K)) or, dual, exp(-pi K/(2K')), in two words
  stretch     y/x or 1, in two words
  launch      the phase at t = 0 in periods after the release at the positive turning point, in two words
"""
import re
import struct
from pathlib import Path
from mpmath import mp, mpf, pi, sin, cos, sqrt, exp, agm, asin, ellipf, fabs

mp.dps = 120

STARTS = """
1e-9;0;1 1e-6;0;1 0.01;0;1 0.1;0;1 1π/6;0;1 1;0;1 1π/3;0;1 1π/2;0;1 100deg;0;1 2;0;1 2π/3;0;1 3π/4;0;1 4π/5;0;1
2.5;0;1 7π/8;0;1 0.9π;0;1 0.95π;0;1 0.96π;0;1 0.97π;0;1 3;0;1 0.98π;0;1 0.99π;0;1 0.999π;0;1 0.9999π;0;1 1π-1e-6;0;1
1π-1e-9;0;1 -2;0;1 2.3587;0;1 2.6901;0;1 2.7604;0;1 -7π/8;0;1 7π/8;0;3 157.5deg;0;sqrt(9.81/0.994) 1.2345678901234567890123456789;0;2
1;1;1 -1;1;1 1;-1;1 0;1;1 0;-1.9;1 0.3;2;1.25 2.9;0.1;2 -2.5;-0.25;0.5
1;1.755;1 0;1.9999;1 -1;-3.5;2
""".split()


def value(text):
    text = re.sub(r"(\d[\d.]*(?:e-?\d+)?)deg", r"(\1*pi/180)", text)
    text = re.sub(r"(\d[\d.]*(?:e-?\d+)?)π", r"(\1*pi)", text)
    text = re.sub(r"π", "pi", text)
    text = re.sub(r"(?<![\w.])(\d[\d.]*(?:e-?\d+)?)", r"mpf('\1')", text)
    return mpf(eval(text))


def words(x, count):
    found = []
    for _ in range(count):
        found.append(float(x))
        x -= mpf(found[-1])
    return ",".join(struct.pack(">d", word).hex() for word in found)


def row(start):
    theta0, velocity0, omega = (mpf(value(part)) for part in start.split(";"))
    s, w = sin(theta0 / 2), velocity0 / (2 * omega)
    if w == 0:
        k, kc = fabs(s), cos(theta0 / 2)
        launch = mpf(0) if theta0 > 0 else mpf(1) / 2
    else:
        k = sqrt(s * s + w * w)
        kc = sqrt(cos(theta0 / 2) ** 2 - w * w)
    K, Kp = pi / 2 / agm(1, kc), pi / 2 / agm(1, k)
    if w != 0:
        # sin(theta/2) = k sn(u + K); rising for velocity0 > 0.
        rising = ellipf(asin(s / k), k * k) / (4 * K) - mpf(1) / 4
        launch = rising if w > 0 else -rising
    dual = K > Kp
    base = exp(-pi * K / Kp / 2) if dual else exp(-pi * Kp / K / 2)
    stretch = K / Kp if dual else mpf(1)
    parts = [words(omega / (4 * K), 3), words(pi / (2 * K), 2), str(int(dual))]
    return ",".join([start, *parts, words(base, 2), words(stretch, 2), words(launch, 2)])


if __name__ == "__main__":
    with Path(__file__).with_suffix(".csv").open("w", encoding="utf-8") as out:
        print("# Written by swings.py, which explains the columns.", file=out)
        for start in STARTS:
            print(row(start), file=out)
