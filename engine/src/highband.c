/* SPDX-License-Identifier: MIT */
#include "highband.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "bessel.h"
#include "mics.h"
#include "model.h"
#include "power.h"

static const double PI = 3.14159265358979323846;
static const double KEPT = 0.999;     /* of each band's energy */
static const double TOP_ZERO = 240.0; /* orders stay below TB_MAX_ORDERS */

/* One Bessel function, cosine and sine copies together. */
typedef struct Candidate {
  uint32_t m, band;
  double zero, slope, omega, decay_rate, radiation_rate, scale;
  double loudness; /* the largest over microphones */
  double fields[2 * TABOR_MAX_MICS];
} Candidate;

/* What the edge and the coupling of modes by the air make of a Bessel function's baffled radiation:
 * pressure per microphone, and resistance. */
typedef struct EdgeFactors {
  double field[TABOR_MAX_MICS], resistance;
} EdgeFactors;

typedef struct Builder {
  const TaborModel *model;
  TbArena *scratch;
  EdgeFactors edge;
  TbAirPoint points[TABOR_MAX_MICS];
  double top; /* [rad/s] */
  Candidate *candidates;
  uint32_t count, room;
} Builder;

/* Mass per area of head and air, one fixed-point pass from the head alone. */
static double frequency(const TaborDrumDef *def, double wavenumber, double *mass) {
  const double k2 = wavenumber * wavenumber;
  const double stiffness = def->batter.tension * k2 + def->batter.bending_stiffness * k2 * k2;
  *mass = def->batter.surface_density;
  double omega = sqrt(stiffness / *mass);
  for (int pass = 0; pass < 3 && def->air.density > 0.0; pass++) {
    const double slowness = omega / (def->air.sound_speed * wavenumber);
    if (slowness >= 0.98) break; /* as fast as sound: no mass, all radiation */
    *mass = def->batter.surface_density +
            2.0 * def->air.density / (wavenumber * sqrt(1.0 - slowness * slowness));
    omega = sqrt(stiffness / *mass);
  }
  return omega;
}

/* True if no microphone is far enough from the axis to hear order m at all. */
static bool inaudible(const Builder *b, uint32_t m, double x, double zero) {
  for (uint32_t p = 0; p < b->model->def.mic_count; p++) {
    const double top = fmin(4.0 * fmax(x, zero), 10.0 / fabs(b->points[p].height));
    const double reach = sqrt(x * x + top * top) * b->points[p].radius;
    if ((double)m < reach + 2.5 * cbrt(reach) + 5.0) return false;
  }
  return true;
}

static TbAirOrder single(uint32_t m, const double *zero, double *slope) {
  *slope = tb_bessel_j(m + 1, *zero);
  return (TbAirOrder){.m = m, .count = 1, .zeros = zero, .slopes = slope};
}

/* A Bessel function with its baffled radiation: scale, fields and both parts of the decay rate. */
static bool radiate(const Builder *b, uint32_t m, double zero, Candidate *c) {
  const TaborDrumDef *def = &b->model->def;
  const double radius = def->shell.radius, wavenumber = zero / radius;
  double mass, resistance;
  *c = (Candidate){.m = m, .zero = zero, .omega = frequency(def, wavenumber, &mass)};
  const TbAirOrder order = single(m, &zero, &c->slope);
  TbArena scratch;
  tb_arena_prepare(&scratch, &b->scratch->allocator);
  const bool done = tb_air_slow(&order, &scratch, c->omega * radius / def->air.sound_speed,
                                b->points, def->mic_count, &resistance, c->fields);
  tb_arena_release(&scratch);
  if (!done) return false;
  const double norm = (m ? PI : 2.0 * PI) * radius * radius * 0.5 * c->slope * c->slope;
  c->scale = 1.0 / sqrt(mass * norm);
  for (uint32_t i = 0; i < 2 * def->mic_count; i++) c->fields[i] *= c->scale;
  c->decay_rate = 0.5 * def->batter.surface_density / mass *
                  (def->batter.damping_0 + def->batter.damping_1 * wavenumber * wavenumber);
  c->radiation_rate =
    def->air.density * def->air.sound_speed * resistance / (mass * c->slope * c->slope);
  return true;
}

/* The largest energy that a unit force brings to a microphone. */
static double loudness(const Builder *b, const Candidate *c) {
  const double turn = c->omega * b->model->time_step;
  double loudest = 0.0;
  for (uint32_t p = 0; p < b->model->def.mic_count; p++) {
    const double gain =
      c->omega * c->omega * sin(turn) / turn * hypot(c->fields[2 * p], c->fields[2 * p + 1]);
    loudest = fmax(loudest, gain * gain / (4.0 * fmax(c->decay_rate, 1e-3)));
  }
  return loudest;
}

static bool add_candidate(Builder *b, uint32_t m, double zero) {
  const TaborDrumDef *def = &b->model->def;
  double mass;
  const double omega = frequency(def, zero / def->shell.radius, &mass);
  const double x = omega * def->shell.radius / def->air.sound_speed;
  if (omega > b->top || b->count == b->room || inaudible(b, m, x, zero)) return true;
  Candidate *c = &b->candidates[b->count];
  if (!radiate(b, m, zero, c)) return false;
  b->count++;
  for (uint32_t p = 0; p < def->mic_count; p++) {
    c->fields[2 * p] *= b->edge.field[p];
    c->fields[2 * p + 1] *= b->edge.field[p];
  }
  c->decay_rate += b->edge.resistance * c->radiation_rate;
  if (!def->quality.losses) c->decay_rate = 0.0;
  c->loudness = loudness(b, c);
  c->band = (uint32_t)(6.0 * log2(omega / (2.0 * PI * 20.0)));
  return true;
}

static double square_of(const double *complex_number) {
  return complex_number[0] * complex_number[0] + complex_number[1] * complex_number[1];
}

/* The upper two-way modes of the low orders, as they radiate, against the same as Bessel functions. */
static bool measure_edge(Builder *b) {
  const TaborModel *model = b->model;
  const uint32_t mics = model->def.mic_count;
  double real[TABOR_MAX_MICS] = {0.0}, simple[TABOR_MAX_MICS] = {0.0};
  double real_rate = 0.0, simple_rate = 0.0;
  for (uint32_t m = 0; m < model->head.order_count && m < 6; m++) {
    const TbHeadOrder *order = &model->head.orders[m];
    for (uint32_t k = order->mode_count / 2; k < order->mode_count; k++) {
      const TbHeadMode *mode = &model->head.modes[order->rows[k]];
      Candidate c;
      if (!radiate(b, m, order->zeros[k], &c)) return false;
      for (uint32_t p = 0; p < mics; p++) {
        real[p] += square_of(mode->fields + 2 * p);
        simple[p] += square_of(c.fields + 2 * p);
      }
      real_rate += mode->radiation_rate;
      simple_rate += c.radiation_rate;
    }
  }
  b->edge.resistance = simple_rate > 0.0 ? real_rate / simple_rate : 1.0;
  for (uint32_t p = 0; p < mics; p++) {
    b->edge.field[p] = simple[p] > 0.0 ? sqrt(real[p] / simple[p]) : 1.0;
  }
  return true;
}

/* The zero at which modes reach the top of the band. */
static double top_zero(const Builder *b) {
  const TaborDrumDef *def = &b->model->def;
  double lo = 0.5, hi = TOP_ZERO, mass;
  for (int i = 0; i < 40; i++) {
    const double middle = 0.5 * (lo + hi);
    if (frequency(def, middle / def->shell.radius, &mass) < b->top) {
      lo = middle;
    } else {
      hi = middle;
    }
  }
  return hi;
}

/* All Bessel functions above the two-way modes of their order, up to the last order that is heard. */
static bool collect(Builder *b) {
  const TbHead *head = &b->model->head;
  const double top = top_zero(b);
  const double x = b->top * head->radius / b->model->def.air.sound_speed;
  double lists[2][96];
  uint32_t counts[2] = {0, 0};
  for (uint32_t m = 0; m < TB_MAX_ORDERS - 2 && !inaudible(b, m, x, top); m++) {
    const uint32_t here = m % 2, last = 1 - here;
    counts[here] = tb_bessel_zeros(m, top, lists[last], counts[last], lists[here], 96);
    const uint32_t taken = m < head->order_count ? head->orders[m].mode_count : 0;
    for (uint32_t n = taken; n < counts[here]; n++) {
      if (!add_candidate(b, m, lists[here][n])) return false;
    }
  }
  return true;
}

static int louder(const void *x, const void *y) {
  const Candidate *a = x, *b = y;
  if (a->band != b->band) return a->band < b->band ? -1 : 1;
  if (a->loudness != b->loudness) return a->loudness > b->loudness ? -1 : 1;
  return a->zero < b->zero ? -1 : a->zero > b->zero;
}

/* Keeps the loudest of each sixth of an octave, in place. */
static void thin(Builder *b) {
  qsort(b->candidates, b->count, sizeof *b->candidates, louder);
  uint32_t kept = 0, modes = 0;
  for (uint32_t from = 0, to; from < b->count; from = to) {
    double total = 0.0, sum = 0.0;
    for (to = from; to < b->count && b->candidates[to].band == b->candidates[from].band; to++) {
      total += b->candidates[to].loudness;
    }
    for (uint32_t i = from; i < to && sum < KEPT * total; i++) {
      const uint32_t copies = b->candidates[i].m ? 2 : 1;
      if (modes + copies > TB_HIGH_MOST) break;
      sum += b->candidates[i].loudness;
      modes += copies;
      b->candidates[kept++] = b->candidates[i];
    }
  }
  b->count = kept;
}

static bool allocate(TbHighBand *band, TbArena *arena, uint32_t mics) {
  band->padded = tb_pad(band->count);
  band->order = tb_arena_take(arena, band->padded, sizeof *band->order);
  band->sine = tb_arena_take(arena, band->padded, sizeof *band->sine);
  double **arrays[] = {&band->zero, &band->scale, &band->a, &band->b, &band->g, &band->stiffness};
  for (size_t i = 0; i < sizeof arrays / sizeof *arrays; i++) {
    *arrays[i] = tb_arena_doubles(arena, band->padded);
  }
  for (uint32_t p = 0; p < mics; p++) {
    band->mics[p].u = tb_arena_doubles(arena, band->padded);
    band->mics[p].v = tb_arena_doubles(arena, band->padded);
  }
  band->push = tb_arena_doubles(arena, (size_t)band->padded * TB_HIGH_GROUPS);
  return !arena->failed;
}

static void fill_mode(TbHighBand *band, uint32_t i, const Builder *b, const Candidate *c,
                      bool sine) {
  const TaborModel *model = b->model;
  const TbPole pole = tb_pole(c->omega, c->decay_rate, model->time_step);
  band->order[i] = c->m;
  if (c->m >= band->orders) band->orders = c->m + 1;
  band->sine[i] = sine;
  band->zero[i] = c->zero;
  band->scale[i] = c->scale;
  band->a[i] = pole.a;
  band->b[i] = pole.b;
  band->g[i] = pole.g;
  band->stiffness[i] = pole.stiffness;
  for (uint32_t p = 0; p < model->def.mic_count; p++) {
    tb_mic_weights(model, p, c->omega, &pole, c->m, sine, c->fields + 2 * p, &band->mics[p].u[i],
                   &band->mics[p].v[i]);
  }
}

/* Groups of about equal width along the bed, and what a force at their middles does. */
static bool prepare_groups(TbHighBand *band, TbArena *arena, TbArena *scratch,
                           const TbWires *wires) {
  double x[TB_HIGH_GROUPS] = {0.0}, y[TB_HIGH_GROUPS] = {0.0};
  uint32_t members[TB_HIGH_GROUPS] = {0};
  band->row_group = tb_arena_take(arena, wires->stride, sizeof *band->row_group);
  double *drive = tb_arena_doubles(scratch, band->padded);
  if (arena->failed || scratch->failed) return false;
  for (uint32_t row = 0; row < wires->stride; row++) {
    if (wires->real[row] == 0.0) continue;
    const double place = 0.5 + 0.5 * wires->row_x[row] / band->radius;
    const uint32_t group = (uint32_t)fmin(place * TB_HIGH_GROUPS, TB_HIGH_GROUPS - 1.0);
    band->row_group[row] = (uint8_t)group;
    x[group] += wires->row_x[row];
    y[group] += wires->row_y[row];
    members[group]++;
  }
  for (uint32_t group = 0; group < TB_HIGH_GROUPS; group++) {
    if (members[group] == 0) continue;
    const double mx = x[group] / members[group], my = y[group] / members[group];
    const double r = hypot(mx, my);
    tb_highband_drive(band, r, r > 0.0 ? my / r : 0.0, r > 0.0 ? mx / r : 1.0, NULL, drive);
    for (uint32_t i = 0; i < band->padded; i++) {
      band->push[((size_t)(i / 8) * TB_HIGH_GROUPS + group) * 8 + i % 8] = wires->side * drive[i];
    }
  }
  return true;
}

TaborStatus tb_highband_prepare(TbHighBand *band, TbArena *arena, const TaborModel *model,
                                double top) {
  *band = (TbHighBand){.radius = model->head.radius};
  if (top <= model->head.bandwidth || model->def.air.density == 0.0) return TABOR_OK;
  TbArena scratch;
  tb_arena_prepare(&scratch, &arena->allocator);
  Builder b = {.model = model, .scratch = &scratch, .top = 2.0 * PI * top, .room = 16384};
  for (uint32_t p = 0; p < model->def.mic_count; p++) {
    b.points[p] = (TbAirPoint){model->def.mic[p].radius / model->head.radius,
                               model->def.mic[p].height / model->head.radius};
  }
  b.candidates = tb_arena_take(&scratch, b.room, sizeof *b.candidates);
  bool done = !scratch.failed && measure_edge(&b) && collect(&b);
  if (done) {
    band->candidates = b.count;
    thin(&b);
    for (uint32_t i = 0; i < b.count; i++) band->count += b.candidates[i].m ? 2 : 1;
    done = allocate(band, arena, model->def.mic_count);
  }
  for (uint32_t i = 0, next = 0; done && i < b.count; i++) {
    fill_mode(band, next++, &b, &b.candidates[i], false);
    if (b.candidates[i].m) fill_mode(band, next++, &b, &b.candidates[i], true);
  }
  done = done && prepare_groups(band, arena, &scratch, &model->wires);
  tb_arena_release(&scratch);
  return done ? TABOR_OK : TABOR_ERROR_MEMORY;
}

void tb_highband_patch(const TbHighBand *band, double patch_radius, double *patch) {
  for (uint32_t i = 0; i < band->padded; i++) {
    const double ka = band->zero[i] * patch_radius / band->radius;
    patch[i] = ka > 1e-6 ? 2.0 * tb_bessel_j(1, ka) / ka : 1.0;
  }
}

/* Up to eight modes from `from` on, sine copies passed over; returns how many. */
static uint32_t next_eight(const TbHighBand *band, uint32_t *from, uint32_t index[8]) {
  uint32_t n = 0;
  for (; *from < band->count && n < 8; (*from)++) {
    if (!band->sine[*from]) index[n++] = *from;
  }
  return n;
}

void tb_highband_drive(const TbHighBand *band, double radius, double sin_angle, double cos_angle,
                       const double *patch, double *drive) {
  double c[TB_MAX_ORDERS], s[TB_MAX_ORDERS];
  tb_angular_factors(band->orders, sin_angle, cos_angle, c, s);
  for (uint32_t from = 0; from < band->count;) {
    uint32_t index[8], m[8] = {0};
    double x[8] = {0.0}, j[8];
    const uint32_t n = next_eight(band, &from, index);
    for (uint32_t l = 0; l < n; l++) {
      m[l] = band->order[index[l]];
      x[l] = band->zero[index[l]] * radius / band->radius;
    }
    tb_bessel_j8(m, x, j);
    for (uint32_t l = 0; l < n; l++) {
      const uint32_t i = index[l];
      const double shape = -band->g[i] * band->scale[i] * j[l] * (patch ? patch[i] : 1.0);
      drive[i] = shape * c[m[l]];
      if (m[l]) drive[i + 1] = shape * s[m[l]];
    }
  }
  for (uint32_t i = band->count; i < band->padded; i++) drive[i] = 0.0;
}
