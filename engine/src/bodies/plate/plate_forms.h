/* SPDX-License-Identifier: MIT */
/* Mass and stiffness of a plate with a profile, a shallow shell of revolution, in vacuo.
 *
 * With w the deflection over the plate's rise w0 and F Airy's function of the stress in its middle
 * surface (Marguerre's equations, linear) [ThomasTouzeChaigne2005],
 *   rho h w_tt + L_D w = L(w0, F),   U'[F] = -L(w0, w),
 *   L(a, b) = a_rr (b_r/r + b_tt/r^2) + (a_r/r + a_tt/r^2) b_rr - 2 (a_t/r)_r (b_t/r)_r.
 * In angular order m the deflections are sums of the flat, even disc's free modes f_k, and F is a
 * sum of clamped ones g_j, for which F = F_r = 0 at the free edge. With A = w_rr, B = w_r/r -
 * m^2 w/r^2, C = m (w_r/r - w/r^2) of each (disc_modes.h), and dA = a_m r dr, a_0 = 2 pi, a_m = pi,
 *   M_kl = Int rho h f_k f_l dA
 *   K_kl = Int D [(A + B)_k (A + B)_l - (1 - nu)(A_k B_l + B_k A_l - 2 C_k C_l)] dA   bending
 *        + E^T G^-1 E                                                                  membrane
 *   G_ij = Int [(A + B)_i (A + B)_j - (1 + nu)(A_i B_j + B_i A_j - 2 C_i C_j)]/(E h) dA
 *   E_jk = Int g_j (w0'' B_k + (w0'/r) A_k) dA.
 * Thickness, bow, bell and flange are exact in this; shear, rotary inertia and the middle surface's
 * own inertia are left out. Integrals by Gauss's rule on panels that end where bell and flange do.
 *
 * Limits: the flat, even disc has K diagonal, omega^2 M; on a spherical cap the axisymmetric modes
 * move to omega^2 + E/(rho R_s^2), R_s its radius of curvature [ThomasTouzeChaigne2005]. Set-up
 * only. */
#ifndef TB_PLATE_FORMS_H
#define TB_PLATE_FORMS_H

#include "bodies/plate/disc_modes.h"
#include "math/arena.h"

/* Places along a radius, with what a plate is there. */
typedef struct TbPlatePoints {
  uint32_t count;
  double *r, *ring;        /* [m]; r dr [m2] */
  double *bending, *areal; /* D [N m], rho h [kg/m2] */
  double *compliance;      /* 1/(E h) [m/N] */
  double *turn, *bow;      /* w0'/r, w0'' [1/m] */
} TbPlatePoints;

/* Places for modes up to lambda = `top`. Returns false if memory ran out. */
bool tb_plate_points(const TaborDrumDef *def, double top, TbArena *arena, TbPlatePoints *points);

/* Matrices of one order, row-major: of its deflections M and K, and of its functions of stress G,
 * Int g_i g_j dA, and E. */
typedef struct TbPlateForms {
  uint32_t count, stress_count;
  TbDiscMode *modes, *stresses; /* free ones, clamped ones */
  double *mass, *stiffness;     /* [count][count] [kg, N/m] */
  double *compliance, *area;    /* [stress_count][stress_count] */
  double *rise;                 /* [count][stress_count] E */
} TbPlateForms;

/* Finds them for deflections up to lambda = `top` and functions of stress up to `stress_top`, at
 * most `room` of either. Returns TABOR_ERROR_MEMORY or TABOR_ERROR_NUMERICS on failure. */
TaborStatus tb_plate_forms(const TaborDrumDef *def, const TbPlatePoints *points,
                           const TbBesselTable *table, uint32_t m, double top, double stress_top,
                           uint32_t room, TbArena *scratch, TbPlateForms *forms);

/* Waves of several modes of order m at r[count]: one TbDiscWave each, or NULL if memory ran out. */
TbDiscWave *tb_plate_waves(const TaborDrumDef *def, const TbBesselTable *table, uint32_t m,
                           const TbDiscMode *modes, uint32_t mode_count, uint32_t count,
                           const double *r, TbArena *scratch);

#endif
