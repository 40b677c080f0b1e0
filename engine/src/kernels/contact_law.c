/* SPDX-License-Identifier: MIT */
#include "kernels/contact_law.h"

#include <math.h>

#include "math/portable_math.h"

/* eta^a for eta >= 0. */
static double raise(const TbContactLaw *law, double eta) {
  switch (law->kind) {
  case TB_CONTACT_LAW_LINEAR: return eta;
  case TB_CONTACT_LAW_THREE_HALF: return eta * sqrt(eta);
  case TB_CONTACT_LAW_SQUARE: return eta * eta;
  default: return tb_power(eta, law->exponent);
  }
}

void tb_contact_law_prepare(TbContactLaw *law, double stiffness, double exponent, double lambda,
                            double time_step, double slope_limit) {
  TbContactLawKind kind = TB_CONTACT_LAW_GENERAL;
  if (exponent == 1.0) kind = TB_CONTACT_LAW_LINEAR;
  if (exponent == 1.5) kind = TB_CONTACT_LAW_THREE_HALF;
  if (exponent == 2.0) kind = TB_CONTACT_LAW_SQUARE;
  *law = (TbContactLaw){.kind = kind,
                        .stiffness = stiffness,
                        .exponent = exponent,
                        .loss = lambda / (2.0 * time_step),
                        .limit = 1e30,
                        .limit_slope = slope_limit};
  if (kind == TB_CONTACT_LAW_LINEAR) {
    law->stiffness = stiffness < slope_limit ? stiffness : slope_limit;
    return;
  }
  /* c = (G/(K a))^(1/(a-1)); the root by halving, since 1/(a-1) has no bound. */
  double lo = 1e-15, hi = 1.0;
  if (stiffness * exponent * tb_power(lo, exponent - 1.0) > slope_limit) {
    law->kind = TB_CONTACT_LAW_LINEAR; /* c is below any penetration that counts */
    law->exponent = 1.0;
    law->stiffness = slope_limit;
    return;
  }
  if (stiffness * exponent * tb_power(hi, exponent - 1.0) <= slope_limit) return;
  for (int i = 0; i < 100; i++) {
    const double middle = 0.5 * (lo + hi);
    if (stiffness * exponent * tb_power(middle, exponent - 1.0) > slope_limit) {
      hi = middle;
    } else {
      lo = middle;
    }
  }
  law->limit = lo;
  law->limit_force = stiffness * raise(law, lo);
  law->limit_potential = law->limit_force * lo / (exponent + 1.0);
}

void tb_contact_law_prepare_sum(TbContactLaw *law, double stiffness, double exponent, double lambda,
                                double time_step, double slope_limit) {
  tb_contact_law_prepare(law, stiffness * tb_power(0.5, exponent), exponent, lambda, time_step,
                         slope_limit);
}

void tb_contact_law_damper(TbContactLaw *law, double c, double time_step) {
  *law = (TbContactLaw){.kind = TB_CONTACT_LAW_DAMPER, .loss = c / (2.0 * time_step)};
}

double tb_contact_law_potential(const TbContactLaw *law, double eta) {
  if (law->kind == TB_CONTACT_LAW_DAMPER || eta <= 0.0) return 0.0;
  if (eta > law->limit) {
    const double over = eta - law->limit;
    return law->limit_potential + over * (law->limit_force + 0.5 * law->limit_slope * over);
  }
  return law->stiffness / (law->exponent + 1.0) * eta * raise(law, eta);
}

double tb_contact_law_static_force(const TbContactLaw *law, double eta) {
  if (law->kind == TB_CONTACT_LAW_DAMPER || eta <= 0.0) return 0.0;
  if (eta > law->limit) return law->limit_force + law->limit_slope * (eta - law->limit);
  return law->stiffness * raise(law, eta);
}

double tb_contact_law_curvature(const TbContactLaw *law, double eta) {
  if (law->kind == TB_CONTACT_LAW_DAMPER || eta <= 0.0) return 0.0;
  if (eta > law->limit) return law->limit_slope;
  if (law->kind == TB_CONTACT_LAW_LINEAR) return law->stiffness;
  return law->stiffness * law->exponent * tb_power(eta, law->exponent - 1.0);
}

/* Mean of K eta^a over (x, y), both in the power's range, for an exponent without closed form: the
 * exact integral where it does not cancel, else six Gauss points, whose error (h/y)^12 is nil
 * there. */
static double mean_general(const TbContactLaw *law, double x, double y) {
  static const double NODE[3] = {0.2386191860831969, 0.6612093864662645, 0.9324695142031521};
  static const double WEIGHT[3] = {0.4679139345726910, 0.3607615730481386, 0.1713244923791704};
  const double middle = 0.5 * (x + y), half = 0.5 * (y - x);
  if (fabs(half) > 0.1 * middle) {
    return law->stiffness * (y * raise(law, y) - x * raise(law, x)) /
           ((law->exponent + 1.0) * (y - x));
  }
  double sum = 0.0;
  for (int i = 0; i < 3; i++) {
    sum += WEIGHT[i] * (raise(law, middle + half * NODE[i]) + raise(law, middle - half * NODE[i]));
  }
  return 0.5 * law->stiffness * sum;
}

/* Mean of V' over (x, y), 0 <= x, y <= limit: closed forms without cancellation. */
static double mean_power(const TbContactLaw *law, double x, double y) {
  switch (law->kind) {
  case TB_CONTACT_LAW_LINEAR: return 0.5 * law->stiffness * (x + y);
  case TB_CONTACT_LAW_SQUARE: return law->stiffness / 3.0 * (x * x + x * y + y * y);
  case TB_CONTACT_LAW_THREE_HALF: {
    const double p = sqrt(x), q = sqrt(y);
    if (p + q <= 0.0) return 0.0;
    const double quartic = x * x + p * q * (x + y) + x * y + y * y;
    return 0.4 * law->stiffness * quartic / (p + q);
  }
  default: return mean_general(law, x, y);
  }
}

/* Int of V' from y to y + s, in pieces that each have one sign of every term. */
static double work_of(const TbContactLaw *law, double y, double s) {
  const double x = y + s;
  const double lo = x < y ? x : y, hi = x < y ? y : x;
  const double from = lo > 0.0 ? lo : 0.0;
  double work = 0.0;
  const double top = hi < law->limit ? hi : law->limit;
  if (top > from) work += (top - from) * mean_power(law, from, top);
  const double start = from > law->limit ? from : law->limit;
  if (hi > start) {
    const double mean = law->limit_force + law->limit_slope * (0.5 * (start + hi) - law->limit);
    work += (hi - start) * mean;
  }
  return x < y ? -work : work;
}

double tb_contact_law_work(const TbContactLaw *law, double y, double s) {
  if (law->kind == TB_CONTACT_LAW_DAMPER || (y <= 0.0 && y + s <= 0.0)) return 0.0;
  return work_of(law, y, s);
}

/* DV/s: the mean itself where the interval is one piece, so that s = 0 needs no division. */
static double gradient(const TbContactLaw *law, double y, double s) {
  const double x = y + s;
  if (x >= 0.0 && y >= 0.0) {
    if (x <= law->limit && y <= law->limit) return mean_power(law, y, x);
    if (x >= law->limit && y >= law->limit) {
      return law->limit_force + law->limit_slope * (0.5 * (x + y) - law->limit);
    }
  }
  return work_of(law, y, s) / s;
}

/* d(DV/s)/ds = (V'(y+s) - DV/s)/s, which is V''/2 at two thirds of the way but for squares of s. */
static double gradient_slope(const TbContactLaw *law, double y, double s, double mean) {
  const double x = y + s;
  const double size = fabs(x) > fabs(y) ? fabs(x) : fabs(y);
  if (fabs(s) < 1e-5 * size) return 0.5 * tb_contact_law_curvature(law, y + 2.0 / 3.0 * s);
  const double slope = (tb_contact_law_static_force(law, x) - mean) / s;
  return slope > 0.0 ? slope : 0.0;
}

TbContactLawResult tb_contact_law_force(const TbContactLaw *law, double y, double s) {
  if (law->kind == TB_CONTACT_LAW_DAMPER)
    return (TbContactLawResult){law->loss * s, law->loss, 0.0};
  if (y <= 0.0 && y + s <= 0.0) return (TbContactLawResult){0.0, 0.0, 0.0};
  const double mean = gradient(law, y, s);
  const double factor = 1.0 + law->loss * s;
  if (factor <= 0.0) return (TbContactLawResult){0.0, 0.0, mean};
  return (TbContactLawResult){mean * factor,
                              gradient_slope(law, y, s, mean) * factor + mean * law->loss, mean};
}

double tb_contact_law_loss(const TbContactLaw *law, double y, double s) {
  if (law->kind == TB_CONTACT_LAW_DAMPER) return 0.5 * law->loss * s * s;
  if (law->loss == 0.0 || (y <= 0.0 && y + s <= 0.0)) return 0.0;
  const double factor = 1.0 + law->loss * s;
  return 0.5 * work_of(law, y, s) * (factor > 0.0 ? law->loss * s : -1.0);
}
