/* SPDX-License-Identifier: MIT */
#include "high_band/scattering.h"

#include <math.h>

#include "bodies/sheet_waves.h"
#include "high_band/high_band_choice.h"

static const double PI = 3.14159265358979323846;
static const double PATCH = 0.03; /* l [m] */
static const double OVERLAP =
  2.0; /* lines that are twice as wide as their distance leave no gaps */
static const double WIDEST = 0.25; /* W against B */

static double group_velocity(const TaborHeadDef *head, const TaborAirDef *air, double k) {
  const double part = 0.01;
  double mass;
  return (tb_sheet_wave_frequency(head, air, (1.0 + part) * k, &mass) -
          tb_sheet_wave_frequency(head, air, (1.0 - part) * k, &mass)) /
         (2.0 * part * k);
}

static double rate_at(const TaborHeadDef *head, double omega, double velocity) {
  const double phase = omega * head->unevenness;
  return sqrt(PI) * PATCH * phase * phase / (4.0 * velocity);
}

double tb_scattering_rate(const TaborHeadDef *head, const TaborAirDef *air, double omega) {
  return rate_at(head, omega, group_velocity(head, air, tb_sheet_wave_number(head, air, omega)));
}

/* D of a mode whose neighbours that are kept are `width` apart, W. */
static double walk(const TbHighDrum *drum, const TbHighMode *mode, double width) {
  const TaborHeadDef *head = &drum->body->sheet[mode->head];
  if (head->unevenness == 0.0) return 0.0;
  const double k = tb_sheet_wave_number(head, &drum->def->air, mode->omega);
  const double velocity = group_velocity(head, &drum->def->air, k);
  const double rate = rate_at(head, mode->omega, velocity);
  const double area = PI * drum->body->radius * drum->body->radius;
  return rate + width * rate / (rate + 2.0 * PI * velocity / (area * k));
}

/* Modes that count, by loudness, from `from` on; the end of their band. */
static double effective_number(const TbHighModes *modes, uint32_t from, uint32_t *end) {
  double sum = 0.0, squares = 0.0;
  uint32_t to = from;
  for (; to < modes->count && tb_high_modes_same_band(&modes->modes[to], &modes->modes[from]);
       to++) {
    const double loudness = modes->modes[to].loudness;
    sum += loudness;
    squares += loudness * loudness;
  }
  *end = to;
  return squares > 0.0 ? sum * sum / squares : 1.0;
}

void tb_scattering_prepare(const TbHighDrum *drum, TbHighModes *modes) {
  for (uint32_t from = 0, to; from < modes->count; from = to) {
    const double number = effective_number(modes, from, &to);
    const uint32_t sixth = modes->modes[from].band;
    const double band = tb_sixth_from(sixth + 1) - tb_sixth_from(sixth);
    const double width = fmin(OVERLAP * band / number, WIDEST * band);
    for (uint32_t i = from; i < to; i++) {
      modes->modes[i].scattering = walk(drum, &modes->modes[i], width);
    }
  }
}
