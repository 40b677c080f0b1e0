/* SPDX-License-Identifier: MIT */
/* The air around one head: added mass, radiation resistance, pressure at a point.
 *
 * A head of radius R moves as w = q J_m(z r) cos(m theta), r in units of R, J_m(z) = 0. Lengths
 * below are in units of R, wavenumbers in 1/R, x = (omega/c0) R. The Hankel transform of the shape
 * on the unit disc is W(kappa) = z J_{m+1}(z) J_m(kappa)/(z^2 - kappa^2).
 *
 * Baffled (each side in an infinite rigid baffle): the field above is the Rayleigh integral, so
 *   M = a_m rho0 R^3 Int_x^inf W^2 kappa/sqrt(kappa^2 - x^2) dkappa             per side,
 *   r = a_m rho0 c0 R^2 x^2 Int_0^{pi/2} W(x sin t)^2 sin t dt                  per side,
 * a_0 = 2 pi, a_m = pi [FletcherRossing, NSS].
 *
 * Open (no baffle, air on both sides): the pressure jump is expanded in
 *   P(kappa) = Sum_n a_n kappa^{-3/2} J_{mu_n}(kappa), mu_n = m + 2 n + 3/2.
 * Each term vanishes outside the disc with the right edge behaviour [Bouwkamp1941]. With
 * b_n = z^{-3/2} J_{mu_n}(z) and
 *   C = diag(1/(2 mu_n)) + Int_0^inf k^-2 (sqrt(k^2 - x^2) - k) J_{mu_n} J_{mu_n'} dk,
 * sqrt = +i sqrt(x^2 - k^2) below x, the impedance is Z = i omega 2 a_m rho0 R^3 b^T C^-1 b, both
 * sides together. Limits: a rigid disc has mass 8/3 rho0 R^3 and resistance (16/27 pi) x^4 rho0 c0
 * R^2.
 *
 * Drum (the heads of a closed shell, or one head over a rigid bottom, in free space): between the
 * baffled and the open head, each head in its own outward direction. With k = x sin t, W and P of
 * both heads:
 *   field: I = (I_baffled + I_open)/2 of each head at its own outward height, summed;
 *   I_baffled is even in that height, I_open odd;
 *   resistance, from the power of the far field, W +- i x cos t P of a head above and below, over
 *   all directions:
 *   r = (x^2/2) Int_0^{pi/2} [W_1^2 + W_2^2 + 2 W_1 W_2 cos(x d cos t)
 *       + x^2 cos^2 t (|P_1|^2 + |P_2|^2 - 2 Re(P_1 P_2*) cos(x d cos t))
 *       - 2 x cos t (W_1 Re P_2 + W_2 Re P_1) sin(x d cos t)] sin t dt, d the depth.
 * It is never negative. At depth 0 it is (r_b + r_o/2)/2 of each head and (r_b - r_o/2)/2 between
 * them. The last product, of one head's W and the other's P, grows with the depth; without it two
 * heads that move together would radiate half of what a listener hears.
 * Limits: two heads at the same place that move outwards alike cancel as dipoles and give both
 * sides of a baffled head. A single slow head gives a quarter of both sides of a baffled head, the
 * monopole of free space.
 *
 * (Low modes of a drum do better, see shell_radiation.h; this is for the others.)
 *
 * All results are dimensionless: multiply masses by a_m rho0 R^3 [kg], resistances by a_m rho0 c0
 * R^2 [kg/s]. Set-up only. */
#ifndef TB_AIR_H
#define TB_AIR_H

#include "math/bessel_table.h"

/* The radial modes of one angular order, with the data that the integrals need. */
typedef struct TbAirOrder {
  uint32_t m, count, terms;   /* terms of the open head's expansion */
  const double *zeros;        /* z_i, ascending */
  double *slopes;             /* J_{m+1}(z_i) */
  double *expansion;          /* [count][terms]: z_i^{-3/2} J_{mu_n}(z_i) */
  const TbBesselTable *table; /* NULL: every value is computed, which is slower */
} TbAirOrder;

/* A point of the field: distance from the axis and height above the head's plane, in units of R. */
typedef struct TbAirPoint {
  double radius, height;
} TbAirPoint;

typedef struct TbAirLoad {
  double mass, resistance; /* both sides together */
} TbAirLoad;

/* Returns false if memory ran out. */
bool tb_air_order_prepare(TbAirOrder *order, TbArena *arena, uint32_t m, const double *zeros,
                          uint32_t count);

/* Mass matrices at low frequency, [count][count] row-major. */
bool tb_air_mass_baffled(const TbAirOrder *order, TbArena *scratch, double *mass); /* one side */
void tb_air_mass_open(const TbAirOrder *order, double *mass);                      /* both sides */

/* Resistance matrix of one baffled side at x, [count][count] row-major. */
bool tb_air_resistance_baffled(const TbAirOrder *order, TbArena *scratch, double x,
                               double *resistance);

/* Load and field of the shape Sum_i v_i J_m(z_i r) at x > 0, on a head with this boundary. fields[2
 * p], fields[2 p + 1]: real and imaginary part of I at point p; the pressure is -omega^2 rho0 R I
 * cos(m theta) per unit amplitude. `points` may be empty. Accurate to ten digits and a half if
 * `exact`, otherwise to four and a half. */
bool tb_air_load(const TbAirOrder *order, TbArena *scratch, TaborBoundary boundary, bool exact,
                 const double *v, double x, const TbAirPoint *points, uint32_t point_count,
                 TbAirLoad *load, double *fields);

/* Resistance and fields of a drum at x > 0. `upper` and `lower` are the heads' outward amplitudes.
 * The lower head lies `depth` below the upper one; the points' heights count from the upper head's
 * plane. `lower` may be NULL: a rigid bottom. */
bool tb_air_drum_load(const TbAirOrder *order, TbArena *scratch, const double *upper,
                      const double *lower, double depth, double x, const TbAirPoint *points,
                      uint32_t point_count, double *resistance, double *fields);

/* Half the baffled fields of both heads of a drum, arguments as for tb_air_drum_load(): what their
 * motion would give without the shell. */
bool tb_air_half_baffled(const TbAirOrder *order, TbArena *scratch, const double *upper,
                         const double *lower, double depth, double x, const TbAirPoint *points,
                         uint32_t point_count, double *fields);

/* Resistance and fields of the shape Sum_i v_i J_m(z_i r) in a baffle, to four digits. With air on
 * `both_sides`, the result is that of tb_air_load(); otherwise one side's resistance and a field
 * that is even in the height. `order` needs no expansion. */
bool tb_air_baffled(const TbAirOrder *order, TbArena *scratch, bool both_sides, const double *v,
                    double x, const TbAirPoint *points, uint32_t point_count, double *resistance,
                    double *fields);

#endif
