#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Independent reference for the sound of a drum: a rigid cylinder whose ends move, in free space.

The drum has the radius 1 and the depth d. Its shell is rigid. Its upper or its lower head moves outwards with the velocity
J_m(z_n r) cos(m theta), J_m(z_n) = 0, at the wavenumber k, as e^{i k c t}. Outside, the velocity is grad f, where
lap f + k^2 f = 0 and f radiates.

Method: fundamental solutions. f is a sum over rings of sources inside the drum, of azimuthal order m. Least squares on the
surface give their strengths. Near the edge f has the singularity rho^(2/3) of a wedge, so the rings follow head and
shell below the surface, and their spacing and depth shrink in proportion to the distance from the edge. A few
rings deeper inside keep the strengths unique where the space between the others resonates. Motion of the heads outwards
alike and against each other is solved apart, with mirrored rings. The angular integral of a ring is taken by Gauss's rule
in u, angle = a sinh u, a the distance at the angle 0.

With a_0 = 2 pi, else a_m = pi, and F the far field, f -> F e^{-iks}/s, the impedance between motions i and j is
    Z = a_m rho0 c0 R^2 (resistance + i k mass), mass = -Int Re f_j J_m(z_i r) r dr over the head,
    resistance = k^2 Int Re(F_i F_j*) sin t dt over all polar angles t.
The resistance is not taken from the pressure on the head, where at small k rounding would bury it.
"""
import argparse, json, os
from python_packages import require

PARSER = argparse.ArgumentParser(description="Writes tests/reference/shell_radiation.json anew, in some minutes.")
PARSER.add_argument("--check", action="store_true", help="only check the method on problems with known solutions")
if __name__ == "__main__": ARGUMENTS = PARSER.parse_args()
require("radiation_reference.py", "numpy", "scipy")
import numpy as np, scipy.linalg as la, scipy.special as sp

OUT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "tests", "reference", "shell_radiation.json")

def gauss(edges, nodes):
    """Gauss-Legendre nodes and weights on each panel between neighbouring edges."""
    x, w = np.polynomial.legendre.leggauss(nodes)
    edges = np.asarray(edges, float)
    half = np.diff(edges)[:, None] / 2
    return (edges[:-1, None] + half * (x + 1)).ravel(), (half * w).ravel()

# ---- rings ---------------------------------------------------------------------------------------

PANELS = ((0.0, 0.6, 32), (0.6, np.pi, 44)) # angles from, to [rad], and nodes

def ring_angles(a):
    """Angles in (0, pi) and their weights for each distance a, which is in units of sqrt(r r')."""
    angles, weights = [], []
    for low, high, count in PANELS:
        x, w = np.polynomial.legendre.leggauss(count)
        u0, u1 = np.arcsinh(low / a)[..., None], np.arcsinh(high / a)[..., None]
        u = u0 + 0.5 * (u1 - u0) * (x + 1)
        angles.append(a[..., None] * np.sinh(u))
        weights.append(a[..., None] * np.cosh(u) * 0.5 * (u1 - u0) * w)
    return np.concatenate(angles, axis=-1), np.concatenate(weights, axis=-1)

def rings(k, orders, r, z, source_r, source_z):
    """f, df/dr and df/dz at the points (r, z) of rings at (source_r, source_z): arrays [order][point][ring]."""
    f, fr, fz = (np.empty((len(orders), len(r), len(source_r)), complex) for _ in range(3))
    for i in range(0, len(r), 40): # so many points at a time, for the memory's sake
        here = slice(i, i + 40)
        dr, dz, product = r[here, None] - source_r, z[here, None] - source_z, r[here, None] * source_r
        least = dr * dr + dz * dz
        angle, weight = ring_angles(np.sqrt(least / np.maximum(product, 1e-12)))
        versine = 2 * np.sin(angle / 2) ** 2
        square = least[..., None] + 2 * product[..., None] * versine
        distance = np.sqrt(square)
        g = weight * np.exp(-1j * k * distance) / (2 * np.pi * distance) # both halves of the ring
        slope = -g * (1 + 1j * k * distance) / square
        slope_r = slope * (dr[..., None] + source_r[:, None] * versine)
        for o, m in enumerate(orders):
            c = np.cos(m * angle)
            f[o, here] = np.einsum("prq,prq->pr", c, g)
            fr[o, here] = np.einsum("prq,prq->pr", c, slope_r)
            fz[o, here] = np.einsum("prq,prq->pr", c, slope) * dz
    return f, fr, fz

def ring_far(k, m, cosines, source_r, source_z):
    """F of rings: [direction][ring]."""
    sines = np.sqrt(1 - cosines**2)
    return 0.5 * 1j**m * sp.jv(m, k * sines[:, None] * source_r) * np.exp(1j * k * cosines[:, None] * source_z)

# ---- the drum ------------------------------------------------------------------------------------

class Level:
    """Spacing of the rings: this ratio of the distance to the edge, at most `widest`, from the distance `closest` on."""
    def __init__(self, ratio, widest, closest):
        self.ratio, self.widest, self.closest = ratio, widest, closest

COARSE, FINE = Level(0.36, 0.085, 1e-6), Level(0.30, 0.07, 1e-7)
BELOW = 1.6 # depth of a ring below the surface, in spacings
ALIKE, OPPOSED = 1, -1 # the heads move outwards alike, or against each other

def graded(length, level, widest):
    """Distances from the edge, and spacings there; the last one lies half a spacing before `length`."""
    s, places, steps = level.closest, [], []
    while s < length:
        places.append(s)
        steps.append(min(level.ratio * s, widest))
        s += steps[-1]
    stretch = length / (places[-1] + 0.5 * steps[-1])
    return stretch * np.array(places), stretch * np.array(steps)

class Drum:
    """The upper half of a drum: rings, and points of the surface with weights. z counts from the middle."""

    def __init__(self, k, depth, level):
        self.k, self.half = k, depth / 2
        widest = level.widest * min(1.0, 3.8 * self.half, 12.0 / k)
        head, head_step = graded(1.0, level, widest)
        shell, shell_step = graded(self.half, level, widest)
        deep, _ = gauss([0.0, 0.6 * self.half], 4 + int(k * self.half))
        self.source_r = np.concatenate([1 - head, 1 - BELOW * shell_step, np.full(len(deep), 0.45)])
        self.source_z = np.concatenate([self.half - BELOW * head_step, self.half - shell, deep])
        (s, head_weights), (t, shell_weights) = (gauss(np.concatenate([[0], places[::2], [length]]), 5)
                                                 for places, length in ((head, 1.0), (shell, self.half)))
        self.r, self.z = np.concatenate([1 - s, np.ones(len(t))]), np.concatenate([np.full(len(s), self.half), self.half - t])
        self.edge = np.concatenate([s, t])
        self.weights = np.concatenate([head_weights, shell_weights]) * self.r
        self.on_head = np.arange(len(self.r)) < len(s)

    def mirrored(self, function, parity):
        """function(z of the rings), even or odd in z."""
        return function(self.source_z) + parity * function(-self.source_z)

    def prepare(self, orders):
        """Potential and normal velocity of every ring on the surface, for both parities."""
        self.orders, self.surface = list(orders), {}
        parts = [rings(self.k, self.orders, self.r, self.z, self.source_r, sign * self.source_z) for sign in (1, -1)]
        for parity in (ALIKE, OPPOSED):
            f, fr, fz = (upper + parity * lower for upper, lower in zip(*parts))
            self.surface[parity] = f, np.where(self.on_head[:, None], fz, fr)
        return self

    def strengths(self, m, parity, velocity):
        """Strengths of the rings that make these normal velocities [point][case], and the largest relative error left.

        Weights that vanish at the edge keep the least squares from caring about the last ring's neighbourhood alone.
        """
        weights = np.sqrt(self.weights * np.minimum(1.0, self.edge / 0.3))[:, None]
        a = weights * self.surface[parity][1][self.orders.index(m)]
        scale = np.linalg.norm(a, axis=0)
        x = la.lstsq(a / scale, weights * velocity, cond=1e-13)[0] / scale[:, None]
        left = np.linalg.norm(a @ x - weights * velocity, axis=0) / np.linalg.norm(weights * velocity, axis=0)
        return x, left.max()

    def potential(self, m, parity, x):
        """f on the surface."""
        return self.surface[parity][0][self.orders.index(m)] @ x

    def far(self, m, parity, x, cosines):
        return self.mirrored(lambda z: ring_far(self.k, m, cosines, self.source_r, z), parity) @ x

    def near(self, m, parity, x, r, z):
        return self.mirrored(lambda s: rings(self.k, [m], r, z, self.source_r, s)[0][0], parity) @ x

COSINES, COSINE_WEIGHTS = gauss(np.linspace(-1, 1, 5), 16)

def of_each_head(alike, opposed):
    """What acts on one head if it moves itself, and if the other moves."""
    return (alike + opposed) / 2, (alike - opposed) / 2

class Order:
    """The motions of one order m: Z, and the field at points."""

    def __init__(self, drum, m, count):
        self.drum, self.m = drum, m
        shapes = np.where(drum.on_head[:, None], sp.jv(m, sp.jn_zeros(m, count) * drum.r[:, None]), 0.0)
        self.x, mass, resistance, self.left = {}, {}, {}, 0.0
        for parity in (ALIKE, OPPOSED):
            self.x[parity], left = drum.strengths(m, parity, shapes)
            self.left = max(self.left, left)
            mass[parity] = -((shapes * drum.weights[:, None]).T @ drum.potential(m, parity, self.x[parity])).real
            far = drum.far(m, parity, self.x[parity], COSINES)
            resistance[parity] = 0.5 * drum.k**2 * ((far * COSINE_WEIGHTS[:, None]).T @ far.conj()).real
        self.mass, self.resistance = of_each_head(*mass.values()), of_each_head(*resistance.values())

    def field(self, r, height):
        """-f of the moving upper head, [point][motion]; heights count from this head."""
        z = np.asarray(height) + self.drum.half
        alike, opposed = (self.drum.near(self.m, parity, self.x[parity], np.asarray(r), z) for parity in (ALIKE, OPPOSED))
        return -(alike + opposed) / 2

# ---- checks --------------------------------------------------------------------------------------

def check_sources():
    """Sources of order m inside the drum: their field at the surface and far away, from their velocity at the surface."""
    worst = 0.0
    for k, depth in ((0.05, 1.333), (2.0, 0.25), (4.0, 0.8), (12.0, 4.0)):
        drum = Drum(k, depth, FINE).prepare(range(4))
        r, z = np.array([0.53, 0.2, 0.6]), np.array([0.1, 0.35, 0.2]) * drum.half
        for m in drum.orders:
            for parity in (ALIKE, OPPOSED):
                def known(function):
                    return function(z) + parity * function(-z)
                f, fr, fz = (known(lambda s: rings(k, [m], drum.r, drum.z, r, s)[i][0]) for i in range(3))
                x, _ = drum.strengths(m, parity, np.where(drum.on_head[:, None], fz, fr))
                error = drum.potential(m, parity, x) - f
                far = known(lambda s: ring_far(k, m, COSINES, r, s))
                worst = max(worst, np.abs(error).max() / np.abs(f).max(),
                            np.abs(drum.far(m, parity, x, COSINES) - far).max() / np.abs(far).max())
    return worst

def check_sphere():
    """The rings themselves: a pulsating and an oscillating sphere, f = h_n(k s) P_n(cos t)/(k h_n'(k))."""
    worst = 0.0
    cosines, _ = gauss([-1, 1], 60)
    source, _ = gauss([-1, 1], 30)
    sines, source_sines = np.sqrt(1 - cosines**2), np.sqrt(1 - source**2)
    for k in (0.05, 1.0, 6.0):
        f, fr, fz = rings(k, [0, 1, 2], sines, cosines, 0.7 * source_sines, 0.7 * source)
        for m in range(3):
            for n in range(m, 4):
                h = sp.spherical_jn(n, k) - 1j * sp.spherical_yn(n, k)
                slope = sp.spherical_jn(n, k, True) - 1j * sp.spherical_yn(n, k, True)
                velocity = sp.lpmv(m, n, cosines)
                x = la.lstsq(sines[:, None] * fr[m] + cosines[:, None] * fz[m], velocity, cond=1e-12)[0]
                worst = max(worst, np.abs(f[m] @ x - h / (k * slope) * velocity).max() / np.abs(h / (k * slope) * velocity).max())
    return worst

def check_power_and_reciprocity():
    """Z is symmetric, and the power that the head gives is the power in the far field."""
    worst = 0.0
    for k, depth in ((2.0, 0.25), (1.0, 1.333), (8.0, 0.5), (12.0, 4.0)):
        drum = Drum(k, depth, FINE).prepare(range(3))
        for m in drum.orders:
            shapes = np.where(drum.on_head[:, None], sp.jv(m, sp.jn_zeros(m, 4) * drum.r[:, None]), 0.0)
            for parity in (ALIKE, OPPOSED):
                x, _ = drum.strengths(m, parity, shapes)
                z = (shapes * drum.weights[:, None]).T @ drum.potential(m, parity, x)
                far = drum.far(m, parity, x, COSINES)
                resistance = 0.5 * k * (far * COSINE_WEIGHTS[:, None]).T @ far.conj()
                size = np.sqrt(np.outer(np.abs(np.diag(z)), np.abs(np.diag(z))))
                worst = max(worst, (np.abs(z - z.T) / size).max(), (np.abs(z.imag - resistance) / size).max())
    return worst

def check():
    print(f"sources inside the drum: {check_sources():.1e}")
    print(f"sphere: {check_sphere():.1e}")
    print(f"reciprocity, power: {check_power_and_reciprocity():.1e}")

# ---- the table -----------------------------------------------------------------------------------

ORDERS = {0: 4, 1: 4, 2: 4, 3: 4, 4: 2, 5: 2, 6: 2} # radial motions of each
WAVENUMBERS = (0.05, 0.5, 1.0, 2.0, 4.0, 8.0, 12.0)
DEPTHS = (0.25, 0.5, 0.8, 1.333, 2.0, 4.0)
FIELD_ORDERS, FIELD_WAVENUMBERS, FIELD_DEPTHS, FIELD_MOTIONS = (0, 1, 2, 4), (0.5, 2.0, 8.0), (0.25, 0.8, 2.0), 2

def field_points(depth):
    """Radius, height above the upper head: close above it, above its edge, beside the shell, close below the lower head, and
    five radii away above and below."""
    return ((0.3, 0.5), (0.7, 0.34), (1.05, 0.2), (1.5, -depth / 2), (0.3, -depth - 0.5), (3.0, 4.0), (4.0, -3.0))

def numbers(array):
    return [float(f"{value:.6g}") for value in np.asarray(array).ravel()]

def triangle(matrix):
    return numbers(matrix[np.triu_indices(len(matrix))])

def change(fine, coarse):
    """Largest change of an impedance matrix, relative to the motions' own impedances."""
    worst = 0.0
    for which in (0, 1):
        k = fine.drum.k
        z = [order.resistance[which] + 1j * k * order.mass[which] for order in (coarse, fine)]
        own = np.sqrt(np.abs(np.diag(fine.resistance[0] + 1j * k * fine.mass[0])))
        worst = max(worst, (np.abs(z[1] - z[0]) / np.outer(own, own)).max())
    return worst

def change_of_resistance(fine, coarse):
    own = np.sqrt(np.diag(fine.resistance[0]))
    return max((np.abs(a - b) / np.outer(own, own)).max() for a, b in zip(fine.resistance, coarse.resistance))

def table():
    impedances, fields, changes = [], [], np.zeros(3)
    for depth in DEPTHS:
        for k in WAVENUMBERS:
            fine_drum, coarse_drum = (Drum(k, depth, level).prepare(ORDERS) for level in (FINE, COARSE))
            for m, count in ORDERS.items():
                fine, coarse = Order(fine_drum, m, count), Order(coarse_drum, m, count)
                changes[:2] = np.maximum(changes[:2], [change(fine, coarse), change_of_resistance(fine, coarse)])
                impedances.append({"depth": depth, "k": k, "m": m,
                                   "own_mass": triangle(fine.mass[0]), "own_resistance": triangle(fine.resistance[0]),
                                   "mutual_mass": triangle(fine.mass[1]), "mutual_resistance": triangle(fine.resistance[1])})
                if m in FIELD_ORDERS and k in FIELD_WAVENUMBERS and depth in FIELD_DEPTHS:
                    r, height = np.array(field_points(depth)).T
                    values, rough = fine.field(r, height), coarse.field(r, height)
                    changes[2] = max(changes[2], (np.abs(values - rough) / np.abs(values).max(axis=0)).max())
                    values = values[:, :FIELD_MOTIONS].T
                    fields.append({"depth": depth, "k": k, "m": m,
                                   "re": [numbers(v.real) for v in values], "im": [numbers(v.imag) for v in values]})
            print(f"depth {depth}, k {k}: largest changes {changes}", flush=True)
    return impedances, fields, changes

WHAT = ("Outside of a finite rigid cylinder in free space, radius 1, both ends heads. A head moves outwards with the velocity J_m(z_n r) cos(m theta). "
        "Method of fundamental solutions (tools/radiation_reference.py), not boundary elements.")
UNITS = ("Lengths in radii R, k in 1/R. Multiply masses by a_m rho0 R^3 [kg], resistances by a_m rho0 c0 R^2 [kg/s], a_0 = 2 pi, else a_m = pi. "
         "own: a head's pressure on itself; mutual: the pressure of the outward motion of the other head. Matrices are symmetric; rows of the upper triangle: "
         "(1,1), (1,2) .. (2,2) .., with 4 motions for m < 4 and 2 beyond. Fields of the upper head alone: I at each point of `points`, for n = 1 and 2; "
         "the pressure is -omega^2 rho0 R I cos(m theta) per amplitude, with e^{i omega t}. Points: radius, height above the upper head; d is the depth.")
POINTS = [[0.3, 0.5], [0.7, 0.34], [1.05, 0.2], [1.5, "-d/2"], [0.3, "-d-0.5"], [3, 4], [4, -3]]

def save(impedances, fields, changes):
    """One line a case."""
    convergence = {"impedance, relative to the own impedances of both motions": float(f"{changes[0]:.1e}"),
                   "resistance, relative to the own resistances of both motions": float(f"{changes[1]:.1e}"),
                   "field, relative to the largest at these points": float(f"{changes[2]:.1e}")}
    head = {"what": WHAT, "units": UNITS, "largest change from a coarser set of sources": convergence, "points": POINTS}
    with open(OUT, "w") as file:
        file.write("{\n" + ",\n".join(f" {json.dumps(key)}: {json.dumps(value)}" for key, value in head.items()))
        for name, rows in (("impedances", impedances), ("fields", fields)):
            file.write(f',\n "{name}": [\n' + ",\n".join(json.dumps(row, separators=(",", ":")) for row in rows) + "\n ]")
        file.write("\n}\n")

if __name__ == "__main__":
    check()
    if not ARGUMENTS.check: save(*table())
