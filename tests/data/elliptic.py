#!/usr/bin/env python3
"""Writes elliptic.csv beside itself: elliptic integrals and functions by modulus and by complement (needs mpmath only).

usage: elliptic.py

Columns: `k` or `kc`, then the modulus (complement), u and the angle phi of F as the bits of f64s taken as exact, then
K, K', q, sn, cn, dn, am and F(phi) as the bits of the nearest f64s.
"""
import random
import struct
from pathlib import Path
from mpmath import mp, mpf, pi, sin, cos, sqrt, nint, ellipf, exp, log
from reference import jacobi


def bits(x):
    return struct.pack(">d", float(x)).hex()


def row(name, value, u):
    mp.dps = 60 + int(abs(log(abs(mpf(value)), 10)) * 2.2) + int(abs(log(abs(mpf(u)), 10)))
    x = mpf(value)
    other = sqrt((1 - x) * (1 + x))
    k, kc = (x, other) if name == "k" else (other, x)
    quarter, quarter1 = pi / 2 / mp.agm(1, kc), pi / 2 / mp.agm(1, k)
    halves = nint(mpf(u) / (2 * quarter))
    phi, dn = jacobi(mpf(u) - 2 * halves * quarter, k, kc)
    am = phi + pi * halves
    angle = mpf(float(min(0.9 * u, 1.5)))
    incomplete = ellipf(angle, k * k)
    values = quarter, quarter1, exp(-pi * quarter1 / quarter), sin(am), cos(am), dn, am, incomplete
    return f"{name},{bits(value)},{bits(u)},{bits(angle)}," + ",".join(map(bits, values))


def rows():
    rng = random.Random(7)
    for value in [1e-30, 1e-5, 0.1, 0.3, 0.5, 0.6, 0.8, 0.87, 0.9, 0.95, 0.99, 0.999, 0.9999999]:
        for name in ("k", "kc"):
            for u in (1e-6, rng.uniform(0, 1.5), rng.uniform(1.5, 4), rng.uniform(4, 30), rng.uniform(1e3, 1e6)):
                yield row(name, value, u)
    for value in (1e-8, 1e-12, 1e-100):
        for u in (1e-6, 0.7, 1.9, 14.0, 3e2):
            yield row("kc", value, u)


def main():
    with Path(__file__).with_suffix(".csv").open("w", encoding="utf-8") as out:
        print("# Elliptic functions; written by elliptic.py, which explains the columns.", file=out)
        for text in rows():
            print(text, file=out)


if __name__ == "__main__":
    main()
