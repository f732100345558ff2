#!/usr/bin/env python3
"""Recomputes reference.csv from its first three columns (needs mpmath only; about a minute).

usage: reference.py [FILE]      exits with 1 if a stored value differs

The motion is θ̈ + sin θ = 0. Columns: kind, parameter and t as the bits of an f64 (taken as exact), then θ and θ̇ each
as the nearest f64 and the rest, good to about 30 digits.

  rest      released at rest from θ = parameter
  launch    θ(0) = 0, θ̇(0) = parameter; a swing below 2, the separatrix at 2, a rotation above

Here θ comes from the Jacobi amplitude by descending Landen transformations of the phase, with digits enough for |t|;
the runtime uses theta quotients, so the two have no formula in common.
"""
import struct
import sys
from mpmath import mp, mpf, pi, sin, cos, sqrt, atan, tanh, cosh, asin, nint, log


def number(bits):
    return struct.unpack(">d", bytes.fromhex(bits))[0]


def jacobi(u, k, kc):
    """(am, dn) of u for |u| <= K, by the AGM (Abramowitz and Stegun 16.4) with k' given."""
    a, b, c, chain = mpf(1), kc, k, []
    while abs(c) > mpf(10) ** (-mp.dps):
        a, b, c = (a + b) / 2, sqrt(a * b), (a - b) / 2
        chain.append((a, c))
    phi = mpf(2) ** len(chain) * a * u
    for a, c in reversed(chain):
        phi = (phi + asin(c / a * sin(phi))) / 2
    return phi, sqrt(kc * kc + (k * cos(phi)) ** 2)


def motion(kind, parameter, t):
    mp.dps = 60 + (int(abs(log(abs(t), 10))) if t else 0)  # digits for large t, and for θ̇ at small t
    p, t = mpf(parameter), mpf(t)
    if kind == "launch" and p == 2:
        return 4 * atan(tanh(t / 2)), 2 / cosh(t)
    if kind == "launch" and p > 2:
        k, kc = 2 / p, sqrt((p - 2) * (p + 2)) / p
        quarter = pi / 2 / mp.agm(1, kc)
        turns = nint(t * p / 4 / quarter)
        phi, dn = jacobi(t * p / 2 - 2 * turns * quarter, k, kc)
        return 2 * pi * turns + 2 * phi, p * dn
    if kind == "launch":
        k, kc, start = p / 2, sqrt((2 - p) * (2 + p)) / 2, mpf(0)
    else:
        k, kc, start = sin(p / 2), cos(p / 2), mpf(1)
    quarter = pi / 2 / mp.agm(1, kc)
    halves = nint(t / (2 * quarter) + start / 2)  # the nearest passage through zero
    u = t + (start - 2 * halves) * quarter
    phi, dn = jacobi(u, k, kc)
    sign = 1 - 2 * (int(halves) % 2)
    return sign * 2 * asin(k * sin(phi)), sign * 2 * k * cos(phi)


def words(x):
    high = float(x)
    return f"{struct.pack('>d', high).hex()},{float(x - mpf(high)):.3e}"


def main():
    path = sys.argv[1] if len(sys.argv) > 1 else __file__.replace("reference.py", "reference.csv")
    wrong = 0
    for line in open(path):
        if line.startswith("#"):
            continue
        kind, parameter, t, rest = line.strip().split(",", 3)
        theta, speed = motion(kind, number(parameter), number(t))
        computed = f"{words(theta)},{words(speed)}".split(",")
        stored = rest.split(",")
        # 30 digits were kept, so a value at rest may carry a rest of 1e-30; 1e-320 allows for rounding of subnormals.
        same = [
            number(stored[i]) == 0 and abs(number(computed[i])) < 1e-60  # cos of a rounded quarter turn
            or abs(number(stored[i]) - number(computed[i])) <= 1e-320
            and abs(float(stored[i + 1]) - float(computed[i + 1]))
            <= 2e-3 * abs(float(computed[i + 1])) + 1e-29 * abs(number(stored[i])) + 1e-320
            for i in (0, 2)
        ]
        if not all(same):
            wrong += 1
            print("differs:", line.strip(), computed)
    print("rows that differ:", wrong)
    sys.exit(wrong > 0)


if __name__ == "__main__":
    main()
