#!/usr/bin/env python3
"""Writes truth.csv: the motion of a pendulum released at rest with omega = 1, by mpmath's elliptic functions.

    python3 benches/data/truth.py > benches/data/truth.csv      (mpmath 1.3.0)

theta = 2 asin(k sn(t + K; k)) and d theta/dt = 2 k cn(t + K; k), each printed as a sum of two doubles. The benchmark's
own truth takes the Fourier series of theta instead, so an error in either shows.
"""
import random
from mpmath import mp, mpf, pi, sin, asin, ellipk, ellipfun

mp.dps = 80
AMPLITUDES = [("pi_3", 1, 3), ("7pi_8", 7, 8), ("0.999pi", 999, 1000)]


def words(value):
    high = float(value)
    return f"{high!r},{float(value - mpf(high))!r}"


def main():
    random.seed(2019)
    print("# Written by truth.py")
    print("amplitude,given,t,theta_high,theta_low,velocity_high,velocity_low")
    for slug, numerator, denominator in AMPLITUDES:
        for given in ("exact", "f64"):
            theta0 = pi * numerator / denominator
            if given == "f64":
                theta0 = mpf(float(numerator) * float(pi) / float(denominator))
            k = sin(theta0 / 2)
            quarter = ellipk(k * k)
            times = [0.0, 1e-3] + [random.uniform(0, 400 * float(quarter)) for _ in range(8)]
            times += [random.uniform(1, 2) * 4 * float(quarter) * 10.0**e for e in (6, 12)]
            for t in times:
                # Whole periods are taken off first: ellipfun is slow for large arguments.
                u = mpf(t) - 4 * quarter * mp.nint(mpf(t) / (4 * quarter)) + quarter
                theta = 2 * asin(k * ellipfun("sn", u, k=k))
                velocity = 2 * k * ellipfun("cn", u, k=k)
                print(f"{slug},{given},{t!r},{words(theta.real)},{words(velocity.real)}")


main()
