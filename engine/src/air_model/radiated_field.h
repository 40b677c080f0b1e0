/* SPDX-License-Identifier: MIT */
/* The field of one moving head at points around the head.
 *
 * Within two radii of the head's centre, the field is computed from the integrals over the
 * wavenumber,
 *   I_baffled = Int W(k) J_m(k r) e^{-gamma |h|} (k/gamma) dk,
 *   I_open = sgn(h) Int P(k) J_m(k r) e^{-gamma |h|} k dk, gamma = i sqrt(x^2 - k^2) below x.
 * Beyond two radii, where the number of nodes would grow with the distance, outgoing spherical
 * waves about the centre are used,
 *   I = -i x Sum_n c_n L_n(cos theta) h_n(x s), s the distance, h_n of the second kind,
 * L_n the Legendre functions of order m with Int_{-1}^1 L_n^2 = 2. By the addition theorem [DLMF]
 * 10.60.2
 *   n - m even (baffled): c_n = L_n(0) Int_0^1 w(r) j_n(x r) r dr, w the shape,
 *   n - m odd (open): c_n = L_n'(0) Int_0^1 p(r) j_n(x r) dr, p the pressure jump, P its transform,
 * right for every x. For large x, projection of the far field, W and i x cos t P at k = x sin t,
 * gives the same,
 *   c_n = (-1)^{(n-m)/2} Int_0^{pi/2} W L_n(cos t) sin t dt,
 *   c_n = (-1)^{(n-m-1)/2} Int_0^{pi/2} x cos t P L_n(cos t) sin t dt,
 * from nodes that the resistance needs anyway. (For small x the projection is lost in rounding: h_n
 * grows as fast as c_n falls.) Set-up only. */
#ifndef TB_RADIATED_FIELD_H
#define TB_RADIATED_FIELD_H

#include "air_model/wavenumber_quadrature.h"

/* Accuracy of the fields in decimal digits, and the phase [rad] that a panel of nodes may cover. */
typedef struct TbAirPrecision {
  double digits, panel;
} TbAirPrecision;

/* A head that moves at one frequency. */
typedef struct TbAirSource {
  const double *v;      /* amplitudes of its Bessel functions */
  double plane, up;     /* height of its plane; +1 where outward is upward, else -1 */
  double *w;            /* W at the nodes */
  double *a, *p;        /* expansion of the jump, and P at the nodes; NULL without an open part */
  double baffled, open; /* weights of its two fields */
  bool mirrored;        /* the baffled field is -I on the far side: both sides are baffled */
} TbAirSource;

/* Data for the fields of all points, planned before the nodes are made. */
typedef struct TbAirPlan {
  const TbAirOrder *order;
  const TbAirPoint *points;
  uint32_t point_count;
  double x, zero; /* zero: the highest Bessel zero in use */
  uint32_t terms; /* of the open expansion */
  TbAirPrecision precision;
  double stretch, top; /* nearest points' integrands: radians per unit of k; upper limit */
  uint32_t degrees;    /* spherical waves up to here; 0: no point is far */
} TbAirPlan;

/* Orders m from this value on are negligible to this many digits, if J_m's argument ends at
 * `reach`. */
double tb_air_heard_to(double reach, double digits);

/* Plans the fields. Points where this order is negligible are left out. */
void tb_air_plan_fields(TbAirPlan *plan, const TbAirSource *sources, uint32_t source_count);

/* Phase [rad] that the nodes below x must resolve. */
double tb_air_plan_turns(const TbAirPlan *plan);

/* fields[2 p], fields[2 p + 1]: the sum over all sources at every point. */
bool tb_air_fields(const TbAirPlan *plan, TbArena *scratch, const TbWavenumberNodes *nodes,
                   const TbAirSource *sources, uint32_t source_count, double *fields);

#endif
