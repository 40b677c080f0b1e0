#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""How a flat disc with a free edge hardens as it bends as its mode (2,0): the numbers of test_von_karman.

Airy's function of the stress obeys lap^2 F = -E h S, S = w_rr (w_r/r + w_tt/r^2) - ((w_t/r)_r)^2, with F = F_r = 0 at the
edge [ThomasTouzeChaigne2005]. Of w = f(r) cos 2t, S has a part that is the same all round, S_0, and one with cos 4t, whose
energy is a 100,000th of that. For S_0 the equation is integrated twice along the radius: G = lap F from (r G')' = -r S_0, with a constant
for which Int r G dr = 0. The disc then stores V = 1/2 Int G^2 dA/(E h); R = E h = rho h = 1 below.
"""
import argparse
from python_packages import require

argparse.ArgumentParser(description="Prints how a flat disc with a free edge hardens as its mode (2,0).").parse_args()
require("plate_backbone.py", "numpy", "scipy")
import numpy as np
from scipy.integrate import cumulative_trapezoid, trapezoid
from scipy.optimize import brentq
from scipy.special import iv, ivp, jv, jvp

NU, M = 0.33, 2


def edge(l):
    """Moment and shear of J and I at the edge."""
    j, dj = jv(M, l), 0.5 * (jv(M - 1, l) - jv(M + 1, l))
    i, di = iv(M, l), 0.5 * (iv(M - 1, l) + iv(M + 1, l))
    part = (1 - NU) * M * M
    moment = l * l * j + (1 - NU) * l * dj - part * j, l * l * i - (1 - NU) * l * di + part * i
    shear = l**3 * dj + part * (l * dj - j), l**3 * di - part * (l * di - i)
    return moment, shear


l = brentq(lambda x: np.linalg.det(np.array(edge(x))), 2.0, 2.5)
c = edge(l)[0][0] / edge(l)[0][1]
r = np.linspace(1e-6, 1.0, 200001)
f = jv(M, l * r) + c * iv(M, l * r)
df = l * (jvp(M, l * r) + c * ivp(M, l * r))
ddf = l * l * (jvp(M, l * r, 2) + c * ivp(M, l * r, 2))
a, b, twist = ddf, df / r - M * M * f / r**2, M * (df / r - f / r**2)
s0, s4 = (a * b - twist**2) / 2, (a * b + twist**2) / 2
slope = -cumulative_trapezoid(r * s0, r, initial=0.0) / r
g = cumulative_trapezoid(slope, r, initial=0.0)
g -= 2.0 * trapezoid(r * g, r)
stored = 0.5 * 2.0 * np.pi * trapezoid(r * g * g, r)
mass = np.pi * trapezoid(r * f * f, r)
quartic = stored / mass**2
print(f"lambda^2 {l * l:.4f}; part with cos 4t {np.abs(s4).max() / np.abs(s0).max():.1e} of the even one")
print(f"V = {quartic:.5f} E q^4/(rho^2 h R^6)")
print(f"frequency higher by {1.5 * quartic * mass / f[-1] ** 2 * 12 * (1 - NU**2) / l**4:.5f} (edge deflection/h)^2")
