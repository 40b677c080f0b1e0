/* SPDX-License-Identifier: MIT */
/* The coupling of a plate's modes by the stress in its middle surface, where deflections are as
 * large as the thickness. With Airy's function F of that stress (Marguerre's equations, after von
 * Karman) [ThomasTouzeChaigne2005],
 *   rho h w_tt + L_D w = L(w0 + w, F),   U'[F] = -L(w0, w) - L(w, w)/2,
 * L, U and w0 as in bodies/plate/plate_forms.h. F is expanded in functions Psi_j with
 * U[Psi_j] = 1/2, each orthogonal to the others. With
 *   y_j = Int Psi_j (A B - C^2) dA,   x_j = Sum_k b_jk q_k,
 * A = w_rr, B = w_r/r + w_tt/r^2, C = (w_t/r)_r, the middle surface stores
 *   V = Sum_j (x_j + y_j)^2/2.
 * The term x^2/2 is in the modes' own stiffness; the others couple them, with the force
 *   -dV/dq_k = -Sum_j [b_jk y_j + (x_j + y_j) dy_j/dq_k].
 *
 * A body has tables of all this at Gauss's points along the radius, per unit amplitude of its modes
 * in air. Set-up only. */
#ifndef TB_MEMBRANE_H
#define TB_MEMBRANE_H

#include <stdint.h>

/* One angular order: its first modes, and its functions Psi. */
typedef struct TbMembraneOrder {
  uint32_t modes, stresses;
  double *curvature; /* [modes][3][points]: A, B, C of w(r) cos(m t), C the factor of -sin(m t) */
  double *stress;    /* [stresses][points]: Psi(r) */
  double *rise;      /* [stresses][modes]: b, the same for both copies */
} TbMembraneOrder;

typedef struct TbMembrane {
  double top;      /* modes below take part [rad/s] */
  uint32_t points; /* 0: modes are not coupled */
  uint32_t order_count;
  double *r, *ring; /* [points]: [m], r dr [m2] */
  TbMembraneOrder *orders;
} TbMembrane;

#endif
