/* SPDX-License-Identifier: MIT */
#include "bodies/drum/lug_tension.h"

#include <math.h>

#include "definition/definition.h"
#include "math/portable_math.h"

static const double PI = 3.14159265358979323846;

/* Drawn deviations: their mean is 0, the largest is the spread. */
static void draw(const TaborHeadDef *head, double *deviation) {
  const uint32_t n = head->lug_count;
  double mean = 0.0, largest = 0.0;
  for (uint32_t j = 0; j < n; j++) {
    deviation[j] = tb_deviate(head->lug_seed, j);
    mean += deviation[j] / n;
  }
  for (uint32_t j = 0; j < n; j++) {
    deviation[j] -= mean;
    largest = fmax(largest, fabs(deviation[j]));
  }
  for (uint32_t j = 0; j < n; j++) deviation[j] *= head->lug_spread / largest;
}

void tb_lug_deviations(const TaborHeadDef *head, double *deviation) {
  draw(head, deviation);
  for (uint32_t j = 0; j < head->lug_count; j++) {
    if (!isnan(head->lug[j])) deviation[j] = head->lug[j];
  }
}

bool tb_lug_tension_prepare(TbLugTension *field, const TaborHeadDef *head, double turn) {
  const uint32_t n = head->lug_count;
  double deviation[TABOR_MAX_LUGS];
  tb_lug_deviations(head, deviation);
  *field = (TbLugTension){.harmonics = n / 2 + 1};
  bool even = true;
  for (uint32_t j = 0; j < n; j++) {
    const double angle = (j + 0.5) * 2.0 * PI / n - turn;
    even = even && deviation[j] == 0.0;
    for (uint32_t p = 0; p < field->harmonics; p++) {
      const double weight = (p == 0 || 2 * p == n ? 1.0 : 2.0) * deviation[j] / n;
      double sine, cosine;
      tb_sin_cos(p * angle, &sine, &cosine);
      field->c[p] += weight * cosine;
      field->s[p] += weight * sine;
    }
  }
  return !even;
}

/* Coefficients of one harmonic: what stands at cos p t, cos p t and sin p t, in this order. */
static TbTension harmonic(uint32_t p, double r) {
  if (p == 0) return (TbTension){.rr = 1.0, .tt = 1.0};
  if (p == 1) return (TbTension){.rr = r, .tt = 3.0 * r, .rt = r};
  const double inner = tb_whole_power(r, p - 2u), outer = inner * r * r;
  return (TbTension){.rr = 0.5 * (p * inner - (p - 2.0) * outer),
                     .tt = 0.5 * ((p + 2.0) * outer - p * inner),
                     .rt = 0.5 * p * (outer - inner)};
}

TbTension tb_lug_tension_at(const TbLugTension *field, double r, double angle) {
  TbTension sum = {0.0, 0.0, 0.0};
  for (uint32_t p = 0; p < field->harmonics; p++) {
    const TbTension n = harmonic(p, r);
    double sine, cosine;
    tb_sin_cos(p * angle, &sine, &cosine);
    const double along = field->c[p] * cosine + field->s[p] * sine;
    sum.rr += n.rr * along;
    sum.tt += n.tt * along;
    sum.rt += n.rt * (field->c[p] * sine - field->s[p] * cosine);
  }
  return sum;
}
