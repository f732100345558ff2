#!/usr/bin/env python3
"""Prints the constants of src/kernel.rs, src/double.rs, src/double_trig.rs, src/angle.rs and src/rotation.rs (needs mpmath only).

usage: constants.py

Near-minimax polynomials are interpolations at Chebyshev nodes computed with 60 digits and rounded once to f64.
"""
from mpmath import mp, mpf, pi, sin, cos, sqrt, atan, expm1, log, chebyfit, factorial, floor, nstr

mp.dps = 60
TINY = mpf(10) ** -40


def fit(name, function, low, high, terms, weight):
    coefficients, error = chebyfit(function, [low, high], terms, error=True)
    print(f"{name}: error {nstr(error * weight, 3)}")
    for c in reversed(coefficients):
        print(f"    {float(c)!r},")


def sine(zeta):
    """(sin(2 pi z)/z - 2 pi)/z^2 with zeta = z^2."""
    if zeta < TINY:
        return -((2 * pi) ** 3) / 6
    z = sqrt(zeta)
    return (sin(2 * pi * z) / z - 2 * pi) / zeta


def cosine(zeta):
    """(cos(2 pi z) - 1)/z^2 with zeta = z^2."""
    if zeta < TINY:
        return -((2 * pi) ** 2) / 2
    return (cos(2 * pi * sqrt(zeta)) - 1) / zeta


def exponential(f):
    """(2^f - 1)/f."""
    return expm1(f * log(2)) / f if f else log(2)


def arctangent(zeta):
    """(atan(r)/r - 1)/r^2 with zeta = r^2."""
    if zeta < TINY:
        return mpf(-1) / 3
    r = sqrt(zeta)
    return (atan(r) / r - 1) / zeta


def words(x, count):
    out = []
    for _ in range(count):
        out.append(float(x))
        x -= mpf(out[-1])
    return ", ".join(repr(w) for w in out)


fit("SINE", sine, mpf(0), mpf(1) / 64, 7, mpf(1) / 512)
fit("COSINE", cosine, mpf(0), mpf(1) / 64, 7, mpf(1) / 64)
fit("EXPONENTIAL", exponential, mpf(-1) / 2, mpf(1) / 2, 11, 1)
r2 = mpf(1) / 64 * mpf("1.02")
fit("ARCTANGENT", arctangent, mpf(0), r2, 6, r2)
print("2 pi:", words(2 * pi, 2))
print("4 atan(j/4):")
for j in range(5):
    print("    (", words(4 * atan(mpf(j) / 4), 2), "),")
print("pi:", words(pi, 3))
print("ln 2:", words(log(2), 2))
print("pi/ln 2:", words(pi / log(2), 2))
print("1/(2 pi):", words(1 / (2 * pi), 2))
print("1/factorials:")
for n in range(2, 28):
    print("   ", n, words((-1) ** (n // 2) / factorial(n), 2))
mp.prec = 1500
x = 1 / (2 * pi)
print("1/(2 pi) in 64-bit words after the point:")
for _ in range(21):
    x *= mpf(2) ** 64
    print(f"    0x{int(floor(x)):016x},")
    x -= floor(x)
