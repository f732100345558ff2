#!/usr/bin/env python3
"""Writes exact.csv beside itself: releases and launches from exact parameters, at the times of
tests/data/reference.csv, by mpmath.

    python3 exact.py

The reference there takes its parameters as rounded to f64; a macro sees them exactly. Columns: the kind (rest, launch),
the parameter as written in the tests, the bits of t (exact), then θ and θ̇, each as the bits of the nearest f64 and the
rest. The formulas are those of tests/data/reference.py: Jacobi's amplitude by descending Landen transformations. Only
every third time is taken, and all above 10¹² and the zero crossings.
"""
import os
import struct
import sys
from mpmath import mp, mpf, log

here = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(here, "..", "data"))
import reference  # noqa: E402
from swings import value  # noqa: E402

REST = """1e-9 1e-6 1e-4 1e-3 1e-2 1π/180 1π/18 1π/6 1π/4 1π/3 1π/2 2π/3 3π/4 4π/5 5π/6 7π/8 9π/10 19π/20 99π/100
999π/1000 1/2 1 3/2 2 3 π-1e-3 π-1e-4 π-1e-6 π-1e-9 π-1e-12""".split()
LAUNCH = """2+1e-12 2+1e-9 2+1e-6 2001/1000 201/100 21/10 5/2 3 4 10 100 1e6 2 2-1e-12 2-1e-9 1999/1000 1 1e-9""".split()


def main():
    mp.dps = 60
    names = {}
    for kind, texts in (("rest", REST), ("launch", LAUNCH)):
        for text in texts:
            names[kind, struct.pack(">d", float(value(text))).hex()] = text
    with open(os.path.join(here, "exact.csv"), "w", encoding="utf-8") as out:
        print("# Written by exact.py, which explains the columns.", file=out)
        for i, line in enumerate(open(os.path.join(here, "..", "data", "reference.csv"), encoding="utf-8")):
            if line.startswith("#"):
                continue
            kind, parameter, bits = line.split(",")[:3]
            t = reference.number(bits)
            crossing = abs(reference.number(line.split(",")[3])) < 1e-6 * abs(reference.number(parameter))
            if abs(t) > 1e17 or not (i % 3 == 0 or abs(t) > 1e12 or crossing):
                continue
            text = names.get((kind, parameter))
            if text is None:
                sys.exit(f"no exact parameter is known for {kind} {reference.number(parameter)!r}")
            mp.dps = 60 + (int(abs(log(abs(t), 10))) if t else 0)
            theta, speed = reference.motion(kind, mpf(value(text)), t)
            print(f"{kind},{text},{bits},{reference.words(theta)},{reference.words(speed)}", file=out)


if __name__ == "__main__":
    main()
