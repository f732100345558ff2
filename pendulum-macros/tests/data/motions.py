#!/usr/bin/env python3
"""Writes amplitudes.csv and launches.csv beside itself: elliptic constants and launch phases to 60 digits, by mpmath.

    python3 motions.py

The working precision of 1000 digits outlasts the cancellation in 1 - k^2 at pi - 1e-300, so that the textbook formulas
(parameter m = k^2, incomplete integrals by quadrature-free ellipf) serve as truth, unlike those under test.
"""
import re
from pathlib import Path
from mpmath import mp, mpf, pi, sin, sqrt, exp, asin, ellipk, ellipf, nstr, atanh, fabs, sign

mp.dps = 1000
DIGITS = 60


def value(text):
    """The value of an expression in the macro's syntax."""
    text = re.sub(r"(\d[\d.]*(?:e-?\d+)?)deg", r"(\1*pi/180)", text)
    text = re.sub(r"(\d[\d.]*(?:e-?\d+)?)π", r"(\1*pi)", text)
    text = re.sub(r"π|PI", "pi", text)
    text = re.sub(r"(?<![\w.])(\d[\d.]*(?:e-?\d+)?)", r"mpf('\1')", text)
    return eval(text)


def digits(x):
    return nstr(x, DIGITS, strip_zeros=False, min_fixed=0, max_fixed=0)


def coefficient(n, k, quarter, q):
    return 2 * pi / (k * quarter) * q ** (n - mpf(1) / 2) / (1 - q ** (2 * n - 1))


AMPLITUDES = """
1e-300 1e-100 1e-9 3e-9 1e-8 1e-6 1e-4 0.001 0.01 0.1 1/3 0.5 1 π/6 π/4 π/3 1.2345678901234567890123456789 π/2
90.5deg 2 2π/3 3*PI/4-0.01 4π/5 2.5 7π/8 157.5deg 0.9π 0.95π 0.96π 3 0.97π 0.99π 3.14 0.999π 0.9999π 3.14159
π-1e-6 π-1e-8 3.141592653589 π-1e-12 3.1415926535897932384626433832795 π-1e-100 π-1e-300
""".split()

# theta0, velocity0, omega
LAUNCHES = """
1 1 1; 1 -1 1; -1 1 1; -1 -1 1; 0 1 1; 0 -1 1; 0 1.999999999999 1; 0 2.000000000001 1; 0 2.5 1; 0 -2.5 1
1e-9 1 1; 1 1e-9 1; 1 1e-30 1; 2π/3 0.9999999 1; 2π/3 1.0000001 1; -2π/3 1.0000001 1; 2π/3 -1.0000001 1
3 0.1 2.5; 3 0.35 2.5; 3 0.36 2.5; π-1e-12 1e-12 1; π-1e-12 2e-12 1; -3 1e-6 1; 0.5 100 1; -0.5 -1e9 1; 1e-20 1e-20 1
1e-20 -1e-25 7; 2.9 0.01 sqrt(9.81/0.994); 2 -3 10; 2 30 10; 1e-15 2.5 1; 1.5 -2.7 1
0 2 1; 2π/3 1 1; 2π/3 -1 1; -2π/3 1 1; π/2 sqrt(2) 1; 60deg 3.5*sqrt(3) 3.5
"""


def launch(theta0, velocity0, omega):
    """Regime, whether mirrored, phase at t = 0, amplitude (fastest velocity of a rotation), period."""
    s, w = sin(theta0 / 2), velocity0 / (2 * omega)
    m = s * s + w * w
    if fabs(m - 1) < mpf(10) ** -900:
        return "separatrix", velocity0 < 0, atanh(s * sign(velocity0)), 0, 0
    if m > 1:
        fastest = 2 * omega * sqrt(m)
        quarter = ellipk(1 / m)
        phase = ellipf(theta0 / 2 * sign(velocity0), 1 / m) / (2 * quarter)
        return "rotation", velocity0 < 0, phase, fastest, 4 * quarter / fastest
    quarter = ellipk(m)
    mirrored = theta0 < 0 or theta0 == 0 and velocity0 < 0
    since_bottom = ellipf(asin(fabs(s) / sqrt(m)), m) / (2 * quarter)
    rising = theta0 * velocity0 >= 0
    phase = since_bottom - mpf(1) / 2 if rising else mpf(1) / 2 - since_bottom
    return "swing", mirrored, phase, 2 * asin(sqrt(m)), 4 * quarter / omega


HEADER = "# mpmath %s, %d digits, written by motions.py\n" % (__import__("mpmath").__version__, DIGITS)

with Path(__file__).with_name("amplitudes.csv").open("w", encoding="utf-8") as out:
    out.write(HEADER + "theta0,k,K,K',q,T,b1,b3,b5,b7,b15\n")
    for text in AMPLITUDES:
        k = sin(value(text) / 2)
        quarter, complementary = ellipk(k * k), ellipk(1 - k * k)
        q = exp(-pi * complementary / quarter)
        terms = [coefficient(n, k, quarter, q) for n in (1, 2, 3, 4, 8)]
        row = [k, quarter, complementary, q, 4 * quarter] + terms
        out.write(",".join([text] + [digits(x) for x in row]) + "\n")

with Path(__file__).with_name("launches.csv").open("w", encoding="utf-8") as out:
    out.write(HEADER + "theta0,velocity0,omega,regime,mirrored,launch,amplitude or fastest,period\n")
    for text in LAUNCHES.replace("\n", ";").split(";"):
        if text := text.split():
            regime, mirrored, *row = launch(*map(value, text))
            out.write(",".join(text + [regime, str(mirrored).lower()] + [digits(mpf(x)) for x in row]) + "\n")
