/* SPDX-License-Identifier: MIT */
/* The field of one moving head at points around it.
 *
 * Within two radii of the head's centre: the integrals over the wavenumber,
 *   I_baffled = Int W(k) J_m(k r) e^{-gamma |h|} (k/gamma) dk,
 *   I_open = sgn(h) Int P(k) J_m(k r) e^{-gamma |h|} k dk, gamma = i sqrt(x^2 - k^2) below x.
 * Beyond, where their nodes would grow with the distance: outgoing spherical waves about the centre,
 *   I = -i x Sum_n c_n L_n(cos theta) h_n(x s), s the distance, h_n of the second kind,
 * L_n the Legendre functions of order m with Int_{-1}^1 L_n^2 = 2. By the addition theorem [DLMF] 10.60.2
 *   n - m even (baffled): c_n = L_n(0) Int_0^1 w(r) j_n(x r) r dr, w the shape,
 *   n - m odd (open): c_n = L_n'(0) Int_0^1 p(r) j_n(x r) dr, p the pressure jump, P its transform,
 * right for every x; where x is large the same by projection of the far field, W and i x cos t P at k = x sin t,
 *   c_n = (-1)^{(n-m)/2} Int_0^{pi/2} W L_n(cos t) sin t dt,
 *   c_n = (-1)^{(n-m-1)/2} Int_0^{pi/2} x cos t P L_n(cos t) sin t dt,
 * from nodes that the resistance needs anyway. (For small x these drown in rounding: h_n grows as fast as
 * c_n falls.) Set-up only. */
#ifndef TB_RADIATED_FIELD_H
#define TB_RADIATED_FIELD_H

#include "acoustics/wavenumber_quadrature.h"

/* How exact the fields are, in decimal digits, and the radians that a panel of nodes may turn. */
typedef struct TbAirPrecision {
  double digits, panel;
} TbAirPrecision;

/* A head that moves at one frequency. */
typedef struct TbAirSource {
  const double *v;      /* amplitudes of its Bessel functions */
  double plane, up;     /* height of its plane; +1 where outward is upward, else -1 */
  double *w;            /* W at the nodes */
  double *a, *p;        /* expansion of the jump, and P at the nodes; NULL without an open part */
  double baffled, open; /* parts of the two fields in its own */
  bool mirrored;        /* the baffled field counts as -I on the far side: both sides are baffled */
} TbAirSource;

/* What the fields of all points need, planned before the nodes are made. */
typedef struct TbAirPlan {
  const TbAirOrder *order;
  const TbAirPoint *points;
  uint32_t point_count;
  double x, zero; /* zero: the highest Bessel zero that takes part */
  uint32_t terms; /* of the open expansion */
  TbAirPrecision precision;
  double stretch, top; /* of the nearest points' integrands: radians per unit of k; where to stop */
  uint32_t degrees;    /* spherical waves up to here; 0: no point is far */
} TbAirPlan;

/* Orders m above this are nothing to these digits where J_m's argument ends at `reach`. */
double tb_air_heard_to(double reach, double digits);

/* Points that hear nothing of this order are left out. */
void tb_air_plan_fields(TbAirPlan *plan, const TbAirSource *sources, uint32_t source_count);

/* Radians that the nodes below x must resolve. */
double tb_air_plan_turns(const TbAirPlan *plan);

/* fields[2 p], fields[2 p + 1]: the sum over all sources at every point. */
bool tb_air_fields(const TbAirPlan *plan, TbArena *scratch, const TbWavenumberNodes *nodes,
                   const TbAirSource *sources, uint32_t source_count, double *fields);

#endif
