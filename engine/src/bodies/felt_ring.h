/* SPDX-License-Identifier: MIT */
/* A ring of felt or film that drummers lay on a head. It brakes what it covers by the force -C w_t
 * per area, C = c/A, c its strength [N s/m], A its area [m2]. A mode w of unit mass then decays
 * faster by
 *   s = 1/2 v^T C v,  C_ik = C a_m R^2 Int J_m(z_i x) J_m(z_k x) x dx over the ring, x = r/R
 * (v: amplitudes of the Bessel functions, a_0 = 2 pi, a_m = pi), with [DLMF] 10.22.4 and 10.22.5
 *   Int J_m(a x) J_m(b x) x dx = x (a J_{m+1}(a x) J_m(b x) - b J_m(a x) J_{m+1}(b x))/(a^2 - b^2),
 *   Int J_m(a x)^2 x dx = (x^2/2) (J_m^2 - (2 m/(a x)) J_m J_{m+1} + J_{m+1}^2).
 * This is right to first order in c [Rayleigh1877, vol. I, 102]: that the ring couples modes of one
 * order is left out. Its mass, a few grams, is so, too. Unlike a damper in one place it brakes both
 * modes of a pair. Limits: a ring that covers all of the head has the loss sigma0 = c/(rho A); a
 * narrow one at r brakes the mode phi by c phi(r)^2/2 in the mean over the angle. Set-up only. */
#ifndef TB_FELT_RING_H
#define TB_FELT_RING_H

#include "air_model/air.h"
#include "definition/params.h"
#include "math/arena.h"

/* Loss matrix C of one order [kg/s], [count][count] in *matrix; NULL if there is no ring. Returns
 * false if memory ran out. */
bool tb_felt_ring_matrix(const TaborHeadDef *head, double radius, TbArena *arena,
                         const TbAirOrder *order, const double **matrix);

/* v^T C v [kg/s]; 0 without a matrix. */
double tb_felt_ring_loss(const double *matrix, uint32_t count, const double *v);

/* Loss of one Bessel function by itself to the ring [1/s], in units of sigma0; `slope`:
 * J_{m+1}(zero). */
double tb_felt_ring_sigma(const TaborHeadDef *head, double radius, uint32_t m, double zero,
                          double slope);

#endif
