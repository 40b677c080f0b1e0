/* SPDX-License-Identifier: MIT */
#include "high_band/high_band_choice.h"

#include <math.h>
#include <stdlib.h>

#include "math/portable_math.h"

static const double FIRST_SIXTH = 2.0 * 3.14159265358979323846 * 20.0; /* [rad/s] */

uint32_t tb_sixth_of(double omega) {
  const double sixths = 6.0 * tb_log(omega / FIRST_SIXTH) / tb_log(2.0);
  return (uint32_t)fmin(fmax(sixths, 0.0), TB_SIXTHS - 1u);
}

double tb_sixth_from(uint32_t sixth) {
  return FIRST_SIXTH * tb_exp((double)sixth * tb_log(2.0) / 6.0);
}

typedef struct Candidates {
  const TbHighDrum *drum;
  TbHighMode *modes;
  uint32_t count;
} Candidates;

double tb_high_mode_energy(const TbHighDrum *drum, const TbHighMode *c, uint32_t mic) {
  const double turn = c->omega * drum->time_step;
  const double gain = c->omega * c->omega * tb_sin(turn) / turn *
                      tb_hypot(c->fields[2 * mic], c->fields[2 * mic + 1]);
  return c->in_head * gain * gain / (4.0 * fmax(c->decay_rate, 1e-3));
}

static int louder(const void *x, const void *y) {
  const TbHighMode *a = x, *b = y;
  if (a->band != b->band) return a->band < b->band ? -1 : 1;
  if (a->head != b->head) return a->head < b->head ? -1 : 1;
  if (a->of_air != b->of_air) return a->of_air ? 1 : -1;
  if (a->loudness != b->loudness) return a->loudness > b->loudness ? -1 : 1;
  return a->zero < b->zero ? -1 : a->zero > b->zero;
}

bool tb_high_modes_same_band(const TbHighMode *a, const TbHighMode *b) {
  return a->band == b->band && a->head == b->head && a->of_air == b->of_air;
}

/* How many of the sorted band that begins at `from` hold this part of its energy; its end. */
static uint32_t enough(const Candidates *all, uint32_t from, double part, uint32_t *end) {
  double total = 0.0, sum = 0.0;
  uint32_t to = from, count = 0;
  for (; to < all->count && tb_high_modes_same_band(&all->modes[to], &all->modes[from]); to++) {
    total += all->modes[to].loudness;
  }
  while (from + count < to && sum < part * total) sum += all->modes[from + count++].loudness;
  *end = to;
  return count;
}

static uint32_t copies_for(const Candidates *all, double part) {
  uint32_t copies = 0;
  for (uint32_t from = 0, to; from < all->count; from = to) {
    const uint32_t count = enough(all, from, part, &to);
    for (uint32_t i = from; i < from + count; i++) copies += all->modes[i].m ? 2 : 1;
  }
  return copies;
}

/* A microphone that hardly hears the modes kept for the others goes without: they would sound out
 * of all proportion there, and random trials found one where they were infinite. */
static const double LEAST_KEPT = 1e-3;

/* Makes `count` modes from `from` on as loud at each microphone as the whole band up to `end`. */
static void carry_band(const Candidates *all, uint32_t from, uint32_t count, uint32_t end) {
  for (uint32_t p = 0; p < all->drum->def->mic_count; p++) {
    double total = 0.0, kept = 0.0;
    for (uint32_t i = from; i < end; i++) {
      const double energy = tb_high_mode_energy(all->drum, &all->modes[i], p);
      total += energy;
      if (i < from + count) kept += energy;
    }
    if (!(kept > LEAST_KEPT * total)) continue;
    const double gain = sqrt(total / kept);
    for (uint32_t i = from; i < from + count; i++) {
      all->modes[i].fields[2 * p] *= gain;
      all->modes[i].fields[2 * p + 1] *= gain;
    }
  }
}

TbHighModes tb_high_modes_thin(const TbHighDrum *drum, TbHighMode *candidates, uint32_t count,
                               uint32_t most) {
  const Candidates all = {drum, candidates, count};
  qsort(candidates, count, sizeof *candidates, louder);
  double lost = 0.001;
  while (copies_for(&all, 1.0 - lost) > most) lost *= 1.1;
  TbHighModes chosen = {
    .modes = candidates, .candidates = count, .copies = copies_for(&all, 1.0 - lost)};
  for (uint32_t from = 0, to; from < count; from = to) {
    const uint32_t kept = enough(&all, from, 1.0 - lost, &to);
    carry_band(&all, from, kept, to);
    for (uint32_t i = from; i < from + kept; i++) candidates[chosen.count++] = candidates[i];
  }
  return chosen;
}
