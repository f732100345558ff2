#!/usr/bin/env python3
"""Writes states.csv beside itself: motions from arbitrary states, by other formulas than the runtime's (mpmath only).

usage: states.py      (seconds; the same rows every time)

Columns: θ(0), θ̇(0), ω and t as the bits of f64s taken as exact, then θ(t) and θ̇(t), each as the nearest f64 and the
rest. The phase of the initial state is Legendre's F by mpmath's `ellipf`, continued by descending Landen
transformations (`jacobi` of reference.py).
"""
import random
import struct
from pathlib import Path
from mpmath import mp, mpf, pi, sin, cos, sqrt, asin, ellipf, nint, log
from reference import jacobi, words

HEADER = "# Motions of theta'' + omega^2 sin(theta) = 0 from arbitrary states; states.py writes and explains it."


def motion(theta, velocity, omega, t):
    mp.dps = 80 + sum(int(abs(log(abs(mpf(x)), 10))) for x in (theta, t, omega) if x)
    theta, velocity, omega, t = mpf(theta), mpf(velocity), mpf(omega), mpf(t)
    direction = -1 if velocity < 0 else 1
    base = 2 * pi * nint(theta / (2 * pi))
    s, c = sin((theta - base) / 2) * direction, cos((theta - base) / 2)
    a = abs(velocity) / (2 * omega)
    k = sqrt(a * a + s * s)
    if k < 1:
        kc = sqrt((c - a) * (c + a))
        quarter = pi / 2 / mp.agm(1, kc)
        u = omega * t + ellipf(asin(s / k), k * k)
        halves = nint(u / (2 * quarter))
        phi, _ = jacobi(u - 2 * halves * quarter, k, kc)
        sign = direction * (1 - 2 * (int(halves) % 2))
        return base + sign * 2 * asin(k * sin(phi)), sign * 2 * omega * k * cos(phi)
    kappa, kc = 1 / k, sqrt((a - c) * (a + c)) / k
    quarter = pi / 2 / mp.agm(1, kc)
    u = omega * k * t + ellipf(asin(s), kappa * kappa)
    turns = nint(u / (2 * quarter))
    phi, dn = jacobi(u - 2 * turns * quarter, kappa, kc)
    return base + direction * 2 * (pi * turns + phi), direction * 2 * omega * k * dn


def bits(x):
    return struct.pack(">d", x).hex()


def states(rng):
    for _ in range(60):  # anything
        yield rng.uniform(-3.1, 3.1), rng.uniform(-3, 3), 1.0
    for _ in range(30):  # turns to be kept, other units of time
        yield rng.uniform(-1, 1) * 10 ** rng.uniform(0, 6), rng.gauss(0, 1.5), 2.0 ** rng.uniform(-20, 20)
    for _ in range(25):  # about the separatrix, away from the bottom
        theta = rng.uniform(-3, 3)
        yield theta, 2 * float(cos(mpf(theta) / 2)) * (1 + rng.choice((-1, 1)) * 10 ** rng.uniform(-9, -2)), 1.0
    for _ in range(15):  # small
        yield rng.gauss(0, 1) * 10 ** rng.uniform(-9, -3), rng.gauss(0, 1) * 10 ** rng.uniform(-9, -3), 1.0
    for _ in range(10):  # fast
        yield rng.uniform(-3, 3), rng.gauss(0, 1) * 10 ** rng.uniform(1, 8), 1.0


def main():
    rng = random.Random(20191)
    with Path(__file__).with_suffix(".csv").open("w", encoding="utf-8") as out:
        print(HEADER, file=out)
        for theta, velocity, omega in states(rng):
            for decade in (0, 2, 6, 12):
                t = rng.uniform(-8, 8) * 10**decade / max(omega, abs(velocity))
                angle, speed = motion(theta, velocity, omega, t)
                print(*map(bits, (theta, velocity, omega, t)), words(angle), words(speed), sep=",", file=out)


if __name__ == "__main__":
    main()
