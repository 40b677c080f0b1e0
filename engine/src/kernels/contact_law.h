/* SPDX-License-Identifier: MIT */
/* The contact law of one point, [Torin2014] section 3.2, with a loss term that the paper lacks.
 *
 * Potential V(eta) = K/(a+1) [eta]_+^(a+1), 1 <= a <= 3. Beyond the penetration c where K a
 * c^(a-1) = G, it continues as a parabola of curvature G ("slope limit"). Without this limit,
 * contacts too stiff for one sample to resolve would need more Newton iterations than the cap
 * allows. For a = 1, K = min(K, G).
 *
 * Over two steps, y = eta(n-1), s = eta(n+1) - y, the force is the discrete gradient
 * [BilbaoTorin2015] with a Hunt-Crossley factor [HuntCrossley1975],
 *   f = (DV/s) max(0, 1 + lambda s/(2k)),  DV = V(y+s) - V(y).
 * This force never pulls, grows with s, and loses (f s - DV)/2 >= 0 per step. DV/s is never formed
 * as a difference quotient: it is the mean of V' over the interval, piece by piece.
 *
 * Limits: s -> 0 gives f = V'(y); lambda = 0 gives f s = DV exactly. A damper (a hand) is the
 * linear contact f = c s/(2k), V = 0.
 *
 * The force above is the mean of the true one over 2k: a linear contact has the stiffness K
 * cos(omega k), which is none at a quarter of the rate and negative beyond. Strikers' contacts
 * store V at the mean of two instants instead, in terms of their sum: Y(n) = eta(n) + eta(n-1),
 * W(Y) = 2 V(Y/2), f = (W(Y+s) - W(Y))/s, with the same s. A linear contact then has K cos(omega
 * k/2)^2. W is V with K/2^a, so that the formulas above stay, with y = Y; contacts store W(Y)/2.
 * Audio-safe. */
#ifndef TB_CONTACT_LAW_H
#define TB_CONTACT_LAW_H

#include <stdint.h>

#include "math/arithmetic.h"

typedef enum TbContactLawKind {
  TB_CONTACT_LAW_GENERAL,
  TB_CONTACT_LAW_LINEAR,     /* a = 1 */
  TB_CONTACT_LAW_THREE_HALF, /* a = 3/2 */
  TB_CONTACT_LAW_SQUARE,     /* a = 2 */
  TB_CONTACT_LAW_DAMPER
} TbContactLawKind;

typedef struct TbContactLaw {
  TbContactLawKind kind;
  double stiffness;                    /* K [N/m^a] */
  double exponent;                     /* a */
  double loss;                         /* lambda/(2k) [1/m]; for a damper c/(2k) [N/m] */
  double limit;                        /* c [m], where the parabola begins */
  double limit_force, limit_potential; /* V'(c) [N], V(c) [J] */
  double limit_slope;                  /* G [N/m] */
} TbContactLaw;

typedef struct TbContactLawResult {
  double force, slope; /* f [N], df/ds [N/m] */
  double mean;         /* DV/s [N]: the force without loss; 0 for a damper */
} TbContactLawResult;

/* Twice the exponent if the kernels have a formula for it, otherwise 0. */
static inline uint32_t tb_contact_law_power(const TbContactLaw *law) {
  switch (law->kind) {
  case TB_CONTACT_LAW_LINEAR: return 2;
  case TB_CONTACT_LAW_THREE_HALF: return 3;
  case TB_CONTACT_LAW_SQUARE: return 4;
  default: return 0;
  }
}

/* lambda [s/m], time_step k [s], slope_limit G [N/m] (infinite for none). Set-up or audio. */
void tb_contact_law_prepare(TbContactLaw *law, double stiffness, double exponent, double lambda,
                            double time_step, double slope_limit);
/* The same for the law W of the sum of two instants' penetrations. The limit is that of W''. */
void tb_contact_law_prepare_sum(TbContactLaw *law, double stiffness, double exponent, double lambda,
                                double time_step, double slope_limit);
/* A linear damper of c [N s/m]. */
void tb_contact_law_damper(TbContactLaw *law, double c, double time_step);

/* f and its slope at s, from y. */
TbContactLawResult tb_contact_law_force(const TbContactLaw *law, double y, double s);
/* DV = V(y + s) - V(y) [J]. */
double tb_contact_law_work(const TbContactLaw *law, double y, double s);
/* The energy lost per step by the law itself at s: (f s - DV)/2 [J]. */
double tb_contact_law_loss(const TbContactLaw *law, double y, double s);
/* V(eta), V'(eta), V''(eta). */
double tb_contact_law_potential(const TbContactLaw *law, double eta);
double tb_contact_law_static_force(const TbContactLaw *law, double eta);
double tb_contact_law_curvature(const TbContactLaw *law, double eta);

#endif
