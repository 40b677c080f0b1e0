/* SPDX-License-Identifier: MIT */
/* Quadrature nodes in the wavenumber kappa, and the transforms W and P (air.h) at these nodes.
 *
 * Below x: kappa = x sin t, so that `weights` carry dkappa/cos t = x dt. Above x:
 * kappa = sqrt(x^2 + t^2), and `weights` carry dt. Both substitutions remove the edge at kappa = x.
 * Set-up only. */
#ifndef TB_WAVENUMBER_QUADRATURE_H
#define TB_WAVENUMBER_QUADRATURE_H

#include "air_model/air.h"

typedef struct TbWavenumberNodes {
  double x;
  uint32_t count, below; /* the first `below` lie below x; both are multiples of 8 */
  double panel;          /* width in t of a panel above x */
  double *kappa, *root;  /* root = sqrt|kappa^2 - x^2| */
  double *weights;
  double *j; /* J_m(kappa) */
} TbWavenumberNodes;

/* Phase of the integrand: `low` radians in all below x, `high` radians per unit of kappa above x,
 * where the nodes reach `top` in t. A panel of 16 nodes covers `panel` radians. */
typedef struct TbAirTurns {
  double low, high, top, panel;
} TbAirTurns;

bool tb_wavenumber_nodes_prepare(TbWavenumberNodes *nodes, TbArena *scratch,
                                 const TbAirOrder *order, double x, TbAirTurns turns);

/* W(kappa) of one Bessel function from J_m(kappa). */
double tb_air_hankel(uint32_t m, double z, double slope, double kappa, double j);

/* w[q] = Sum_i v_i W_i(kappa_q) at every node. */
void tb_air_transform(const TbAirOrder *order, const TbWavenumberNodes *nodes, const double *v,
                      double *w);

/* rows[q][n] = J_{mu_n}(kappa_q), n < terms, at every node: the open head's expansion. */
bool tb_air_half_orders(uint32_t m, uint32_t terms, TbArena *scratch,
                        const TbWavenumberNodes *nodes, double *rows);

/* P(kappa) = kappa^{-3/2} Sum_n a_n J_{mu_n}(kappa) at every node; a and p as (re, im) pairs. */
void tb_air_jump_transform(const TbWavenumberNodes *nodes, uint32_t terms, const double *rows,
                           const double *a, double *p);

#endif
