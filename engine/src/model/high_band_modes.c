/* SPDX-License-Identifier: MIT */
#include "model/high_band_modes.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "acoustics/cavity_eigen.h"
#include "acoustics/cavity_pressure.h"
#include "acoustics/closed_drum_modes.h"
#include "acoustics/single_head.h"
#include "definition/definition.h"
#include "math/bessel.h"
#include "math/portable_math.h"
#include "model/head_waves.h"
#include "model/model.h"

static const double PI = 3.14159265358979323846;
static const double TOP_ZERO = 240.0; /* orders stay below TB_MAX_ORDERS */
static const double AIR_REACH =
  2.0; /* the air's integrals end below this many times the top zero */
enum { MOST_ZEROS = 96, MOST_CANDIDATES = 16384 };
/* Orders below this, of a single head, radiate each mode by itself: near the centre they sound alone, a few in
 * a third of an octave, and what the edge and their coupling make of each is 4 dB more or less. */
enum { WHOLE_ORDERS = 4 };

/* What the edge and the coupling of modes by the air make of a Bessel function's baffled radiation:
 * pressure per microphone, and resistance. */
typedef struct EdgeFactors {
  double field[TABOR_MAX_MICS], resistance;
} EdgeFactors;

/* One head and what lies around it. */
typedef struct Side {
  const TaborHeadDef *head;
  EdgeFactors edge;
  TbAirPoint points[TABOR_MAX_MICS]; /* heights outward */
  double top_zero;                   /* where its modes reach the top of the band */
} Side;

/* All Bessel functions of one order. */
typedef struct Functions {
  uint32_t count;
  double zeros[MOST_ZEROS], slopes[MOST_ZEROS]; /* z, J_{m+1}(z) */
} Functions;

/* The air inside, as the modes of one order drive it; no microphones without a cavity. */
typedef struct Inside {
  TbCavityOrder order;
  TbCavityMics mics;
} Inside;

typedef struct Builder {
  const TaborModel *model;
  TbArena *scratch;
  Side sides[TB_HEADS];
  uint32_t outside[TABOR_MAX_MICS], outside_count; /* microphones outside the shell */
  Functions functions;                             /* of the order at hand */
  Inside inside;
  bool both_sides; /* a single head, with air outside on both */
  TbBesselTable table;
  double top; /* [rad/s] */
  TbHighMode *candidates;
  uint32_t count;
} Builder;

/* Of a wave with this Bessel zero, and its mass per area. */
static double frequency(const Builder *b, const Side *side, double zero, double *mass) {
  return tb_head_wave_frequency(side->head, &b->model->def.air, zero / b->model->head.radius, mass);
}

static double x_at(const Builder *b, double omega) {
  return omega * b->model->head.radius / b->model->def.air.sound_speed;
}

/* The microphones that choose the modes: those inside the shell only where there are no others. So a
 * microphone inside changes nothing that the others hear. */
static uint32_t choosers(const Builder *b, uint32_t *mics) {
  if (b->outside_count > 0) {
    memcpy(mics, b->outside, sizeof b->outside);
    return b->outside_count;
  }
  for (uint32_t p = 0; p < b->model->def.mic_count; p++) mics[p] = p;
  return b->model->def.mic_count;
}

/* True if no microphone hears order m at all: J_m is nothing at the wavenumbers that come there. */
static bool inaudible(const Builder *b, const Side *side, uint32_t m, double x, double zero) {
  uint32_t mics[TABOR_MAX_MICS];
  const uint32_t count = choosers(b, mics);
  for (uint32_t p = 0; p < count; p++) {
    const TbAirPoint *point = &side->points[mics[p]];
    const double top = fmin(1.5 * fmax(x, zero) + 10.0, 10.0 / fabs(point->height));
    const double reach = tb_hypot(x, top) * fmin(1.0, point->radius);
    if ((double)m < reach + 2.5 * tb_cbrt(reach) + 5.0) return false;
  }
  return true;
}

/* Baffled radiation to the microphones outside: fields, for unit amplitude, and resistance. */
static bool radiate_outside(const Builder *b, const Side *side, const TbAirOrder *order,
                            TbHighMode *c, double *resistance) {
  TbAirPoint points[TABOR_MAX_MICS];
  double fields[2 * TABOR_MAX_MICS];
  for (uint32_t p = 0; p < b->outside_count; p++) points[p] = side->points[b->outside[p]];
  TbArena scratch;
  tb_arena_beside(&scratch, b->scratch);
  const bool done = tb_air_slow(order, &scratch, b->both_sides, x_at(b, c->omega), points,
                                b->outside_count, resistance, fields);
  tb_arena_release(&scratch);
  for (uint32_t p = 0; done && p < b->outside_count; p++) {
    c->fields[2 * b->outside[p]] = fields[2 * p];
    c->fields[2 * b->outside[p] + 1] = fields[2 * p + 1];
  }
  return done;
}

/* A Bessel function with its baffled radiation: scale, fields and both parts of the decay rate. `slope`:
 * J_{m+1}(zero) */
static bool radiate(const Builder *b, uint32_t head, uint32_t m, double zero, double slope,
                    TbHighMode *c) {
  const TaborDrumDef *def = &b->model->def;
  const Side *side = &b->sides[head];
  const double radius = b->model->head.radius, wavenumber = zero / radius;
  double mass, resistance;
  *c = (TbHighMode){.head = head, .m = m, .zero = zero, .slope = slope};
  c->omega = frequency(b, side, zero, &mass);
  const TbAirOrder order = {
    .m = m, .count = 1, .zeros = &c->zero, .slopes = &c->slope, .table = &b->table};
  if (!radiate_outside(b, side, &order, c, &resistance)) return false;
  const double norm = (m ? PI : 2.0 * PI) * radius * radius * 0.5 * c->slope * c->slope;
  c->scale = 1.0 / sqrt(mass * norm);
  const double upward = head ? -1.0 : 1.0; /* shapes are upward, fields of outward motion */
  for (uint32_t i = 0; i < 2 * def->mic_count; i++) c->fields[i] *= upward * c->scale;
  c->decay_rate = 0.5 * side->head->surface_density / mass *
                  (side->head->damping_0 + tb_head_film_loss(side->head, wavenumber));
  c->radiation_rate =
    def->air.density * def->air.sound_speed * resistance / (mass * c->slope * c->slope);
  return true;
}

/* Fields of a mode at the microphones inside. */
static void fill_inside(const Builder *b, TbHighMode *c) {
  const Inside *inside = &b->inside;
  const TbAirOrder air = {.m = c->m, .count = 1, .zeros = &c->zero, .slopes = &c->slope};
  double outward[TB_HEADS] = {0.0};
  outward[c->head] = c->head ? -c->scale : c->scale;
  const TbCavity cavity = tb_closed_drum_cavity(&b->model->def, c->m, c->omega);
  tb_cavity_fields(&inside->mics, &inside->order, &cavity, &air, outward, NULL, c->omega,
                   c->decay_rate, c->fields);
}

/* The energy that a unit force brings to a microphone. */
static double energy_at(const Builder *b, const TbHighMode *c, uint32_t mic) {
  const double turn = c->omega * b->model->time_step;
  const double gain = c->omega * c->omega * tb_sin(turn) / turn *
                      tb_hypot(c->fields[2 * mic], c->fields[2 * mic + 1]);
  return gain * gain / (4.0 * fmax(c->decay_rate, 1e-3));
}

static double loudness(const Builder *b, const TbHighMode *c) {
  double loudest = 0.0;
  uint32_t mics[TABOR_MAX_MICS];
  const uint32_t count = choosers(b, mics);
  for (uint32_t p = 0; p < count; p++) loudest = fmax(loudest, energy_at(b, c, mics[p]));
  return loudest;
}

/* Takes the next candidate, which knows what it is and how it radiates. */
static void take_candidate(Builder *b) {
  TbHighMode *c = &b->candidates[b->count++];
  if (!b->model->def.quality.losses) c->decay_rate = 0.0;
  c->loudness = loudness(b, c);
  c->band = (uint32_t)fmax(0.0, 6.0 * tb_log(c->omega / (2.0 * PI * 20.0)) / tb_log(2.0));
}

static bool add_candidate(Builder *b, uint32_t head, uint32_t m, uint32_t n) {
  const TaborDrumDef *def = &b->model->def;
  const Side *side = &b->sides[head];
  const double zero = b->functions.zeros[n];
  double mass;
  const double omega = frequency(b, side, zero, &mass);
  if (omega > b->top || b->count == MOST_CANDIDATES ||
      inaudible(b, side, m, x_at(b, omega), zero)) {
    return true;
  }
  TbHighMode *c = &b->candidates[b->count];
  if (!radiate(b, head, m, zero, b->functions.slopes[n], c)) return false;
  for (uint32_t p = 0; p < def->mic_count; p++) {
    c->fields[2 * p] *= side->edge.field[p];
    c->fields[2 * p + 1] *= side->edge.field[p];
  }
  c->decay_rate += side->edge.resistance * c->radiation_rate;
  if (b->inside.mics.count > 0) fill_inside(b, c);
  take_candidate(b);
  return true;
}

/* ---- the edge ------------------------------------------------------------------------------- */

static double square_of(const double *complex_number) {
  return complex_number[0] * complex_number[0] + complex_number[1] * complex_number[1];
}

/* Which head a two-way mode moves; TB_HEADS if both or neither. */
static uint32_t head_of(const TbHeadMode *mode) {
  if (mode->part == TABOR_PART_BATTER) return 0;
  return mode->part == TABOR_PART_RESONANT ? 1 : TB_HEADS;
}

/* Upper two-way modes of one low order, as they radiate, against the same as Bessel functions. */
static bool add_order_edge(const Builder *b, uint32_t head, const TbHeadOrder *order,
                           EdgeFactors *real, EdgeFactors *simple) {
  const TaborModel *model = b->model;
  for (uint32_t k = order->mode_count / 2; k < order->mode_count; k++) {
    const TbHeadMode *mode = &model->head.modes[order->rows[k]];
    if (head_of(mode) != head) continue;
    const double zero = order->zeros[mode->n - 1], slope = tb_bessel_j(order->m + 1, zero);
    TbHighMode c;
    if (!radiate(b, head, order->m, zero, slope, &c)) return false;
    for (uint32_t p = 0; p < model->def.mic_count; p++) {
      real->field[p] += square_of(mode->fields + 2 * p);
      simple->field[p] += square_of(c.fields + 2 * p);
    }
    real->resistance += mode->radiation_rate;
    simple->resistance += c.radiation_rate;
  }
  return true;
}

static bool measure_edge(Builder *b, uint32_t head) {
  const TbHead *modes = &b->model->head;
  EdgeFactors real = {{0.0}, 0.0}, simple = {{0.0}, 0.0}, *edge = &b->sides[head].edge;
  for (uint32_t m = 0; m < modes->order_count && m < 6; m++) {
    if (!add_order_edge(b, head, &modes->orders[m], &real, &simple)) return false;
  }
  edge->resistance = simple.resistance > 0.0 ? real.resistance / simple.resistance : 1.0;
  for (uint32_t p = 0; p < b->model->def.mic_count; p++) {
    edge->field[p] = simple.field[p] > 0.0 ? sqrt(real.field[p] / simple.field[p]) : 1.0;
  }
  return true;
}

/* ---- all candidates ------------------------------------------------------------------------- */

static double top_zero(const Builder *b, const Side *side) {
  double lo = 0.5, hi = TOP_ZERO, mass;
  for (int i = 0; i < 40; i++) {
    const double middle = 0.5 * (lo + hi);
    if (frequency(b, side, middle, &mass) < b->top) {
      lo = middle;
    } else {
      hi = middle;
    }
  }
  return hi;
}

/* How many of a head's Bessel functions of order m are two-way modes already. */
static uint32_t taken(const Builder *b, uint32_t head, uint32_t m, const double *zeros,
                      uint32_t count) {
  const TbHead *modes = &b->model->head;
  if (m >= modes->order_count) return 0;
  const TbHeadOrder *order = &modes->orders[m];
  uint32_t there = 0;
  if (b->both_sides) {
    for (uint32_t k = 0; k < order->mode_count; k++) {
      there += modes->modes[order->rows[k]].part != TABOR_PART_RIM;
    }
    return there;
  }
  double mass;
  const double bandwidth = 2.0 * PI * modes->bandwidth;
  while (there < count && frequency(b, &b->sides[head], zeros[there], &mass) < bandwidth) there++;
  for (uint32_t k = 0; k < order->mode_count; k++) {
    const TbHeadMode *mode = &modes->modes[order->rows[k]];
    if (head_of(mode) == head && mode->n > there) there = mode->n;
  }
  return there;
}

/* Modes of one order of a single head above the two-way ones, with the air that those have. */
static bool collect_whole(Builder *b, TbArena *scratch, uint32_t m) {
  TbHeadOrder order = {.m = m, .zeros = tb_arena_doubles(scratch, MOST_ZEROS)};
  TbHeadMode *modes = tb_arena_take(scratch, MOST_ZEROS, sizeof *modes);
  TbAirOrder air;
  if (scratch->failed) return false;
  order.zero_count = tb_bessel_zeros(m, b->sides[0].top_zero + 2.0 * PI, order.zeros, MOST_ZEROS);
  if (!tb_air_order_prepare(&air, scratch, m, order.zeros, order.zero_count)) return false;
  air.table = &b->table;
  const TbRim at_rest = {.count = 0};
  if (tb_single_head_order(&b->model->def, scratch, scratch, &air, &at_rest,
                           (TbModeLimits){b->top, b->top}, &order, modes, MOST_ZEROS) != TABOR_OK) {
    return false;
  }
  for (uint32_t n = taken(b, 0, m, order.zeros, order.zero_count); n < order.mode_count; n++) {
    if (b->count == MOST_CANDIDATES) break;
    TbHighMode *c = &b->candidates[b->count];
    *c = (TbHighMode){.m = m,
                      .zero = order.zeros[n],
                      .slope = tb_bessel_j(m + 1, order.zeros[n]),
                      .scale = order.vectors[0][(size_t)n * order.zero_count + n],
                      .omega = modes[n].omega,
                      .decay_rate = modes[n].decay_rate,
                      .radiation_rate = modes[n].radiation_rate};
    memcpy(c->fields, modes[n].fields, sizeof c->fields);
    take_candidate(b);
  }
  return true;
}

/* A head's Bessel functions of an order above its two-way modes. */
static bool add_order(Builder *b, uint32_t head, uint32_t m) {
  const Functions *functions = &b->functions;
  uint32_t n = taken(b, head, m, functions->zeros, functions->count);
  for (; n < functions->count && functions->zeros[n] < b->sides[head].top_zero; n++) {
    if (!add_candidate(b, head, m, n)) return false;
  }
  return true;
}

static void find_functions(Builder *b, uint32_t m) {
  Functions *functions = &b->functions;
  const double top = fmax(b->sides[0].top_zero, b->sides[1].top_zero);
  functions->count = tb_bessel_zeros(m, top, functions->zeros, MOST_ZEROS);
  for (uint32_t n = 0; n < functions->count; n++) {
    functions->slopes[n] = tb_bessel_j(m + 1, functions->zeros[n]);
  }
}

/* Radial orders that come as far as a microphone inside: those faster than sound, and slower ones up
 * to where e^-(z' d/R), d the distance from the nearest head, is 1e-3. */
static double inside_zero(const Builder *b) {
  const TaborDrumDef *def = &b->model->def;
  double nearest = INFINITY;
  for (uint32_t p = 0; p < def->mic_count; p++) {
    if (!tb_mic_is_inside(def, &def->mic[p])) continue;
    nearest = fmin(nearest, fmin(-def->mic[p].height, def->shell.depth + def->mic[p].height));
  }
  return fmin(x_at(b, b->top) + 7.0 * def->shell.radius / nearest, 2.0 * TOP_ZERO);
}

static bool add_heads(Builder *b, const bool *heard, uint32_t m) {
  for (uint32_t h = 0; h < TB_HEADS; h++) {
    if (heard[h] && !add_order(b, h, m)) return false;
  }
  return true;
}

/* The Bessel functions of one order, on the heads that are heard. */
static bool collect_order(Builder *b, const bool *heard, uint32_t m) {
  find_functions(b, m);
  b->inside.mics.count = 0;
  if (b->outside_count == b->model->def.mic_count) return add_heads(b, heard, m);
  TbArena scratch;
  tb_arena_beside(&scratch, b->scratch);
  Inside *inside = &b->inside;
  const TbCavity cavity = tb_closed_drum_cavity(&b->model->def, m, b->top);
  const bool done =
    tb_cavity_order_prepare(&inside->order, &scratch, &cavity, m, inside_zero(b), 0.0) &&
    tb_cavity_mics_prepare(&inside->mics, &scratch, &b->model->def, &inside->order) &&
    add_heads(b, heard, m);
  tb_arena_release(&scratch);
  return done;
}

/* Every order of each head up to the last one that is heard. */
static bool collect(Builder *b, uint32_t heads) {
  bool heard[TB_HEADS] = {true, heads > 1};
  for (uint32_t m = 0; m < TB_MAX_ORDERS - 2; m++) {
    for (uint32_t h = 0; h < heads; h++) {
      const Side *side = &b->sides[h];
      heard[h] = heard[h] && !inaudible(b, side, m, x_at(b, b->top), side->top_zero);
    }
    if (!heard[0] && !heard[1]) break;
    if (!b->both_sides || m >= WHOLE_ORDERS) {
      if (!collect_order(b, heard, m)) return false;
      continue;
    }
    TbArena scratch;
    tb_arena_beside(&scratch, b->scratch);
    const bool done = collect_whole(b, &scratch, m);
    tb_arena_release(&scratch);
    if (!done) return false;
  }
  return true;
}

/* ---- the choice ----------------------------------------------------------------------------- */

static int louder(const void *x, const void *y) {
  const TbHighMode *a = x, *b = y;
  if (a->band != b->band) return a->band < b->band ? -1 : 1;
  if (a->head != b->head) return a->head < b->head ? -1 : 1;
  if (a->loudness != b->loudness) return a->loudness > b->loudness ? -1 : 1;
  return a->zero < b->zero ? -1 : a->zero > b->zero;
}

static bool same_band(const TbHighMode *a, const TbHighMode *b) {
  return a->band == b->band && a->head == b->head;
}

/* How many of the sorted band that begins at `from` hold this part of its energy; its end. */
static uint32_t enough(const Builder *b, uint32_t from, double part, uint32_t *end) {
  double total = 0.0, sum = 0.0;
  uint32_t to = from, count = 0;
  for (; to < b->count && same_band(&b->candidates[to], &b->candidates[from]); to++) {
    total += b->candidates[to].loudness;
  }
  while (from + count < to && sum < part * total) sum += b->candidates[from + count++].loudness;
  *end = to;
  return count;
}

static uint32_t copies_for(const Builder *b, double part) {
  uint32_t copies = 0;
  for (uint32_t from = 0, to; from < b->count; from = to) {
    const uint32_t count = enough(b, from, part, &to);
    for (uint32_t i = from; i < from + count; i++) copies += b->candidates[i].m ? 2 : 1;
  }
  return copies;
}

/* A microphone that hardly hears the modes kept for the others goes without: they would sound out of all
 * proportion there, and random trials found one where they were infinite. */
static const double LEAST_KEPT = 1e-3;

/* Makes `count` modes from `from` on as loud at each microphone as the whole band up to `end`. */
static void carry_band(const Builder *b, uint32_t from, uint32_t count, uint32_t end) {
  for (uint32_t p = 0; p < b->model->def.mic_count; p++) {
    double total = 0.0, kept = 0.0;
    for (uint32_t i = from; i < end; i++) {
      const double energy = energy_at(b, &b->candidates[i], p);
      total += energy;
      if (i < from + count) kept += energy;
    }
    if (!(kept > LEAST_KEPT * total)) continue;
    const double gain = sqrt(total / kept);
    for (uint32_t i = from; i < from + count; i++) {
      b->candidates[i].fields[2 * p] *= gain;
      b->candidates[i].fields[2 * p + 1] *= gain;
    }
  }
}

/* Keeps the loudest of each band, in place: 99.9 % of its energy, less if those were too many; they carry
 * what is left out. */
static void thin(Builder *b, uint32_t most, TbHighModes *chosen) {
  qsort(b->candidates, b->count, sizeof *b->candidates, louder);
  double lost = 0.001;
  while (copies_for(b, 1.0 - lost) > most) lost *= 1.1;
  *chosen = (TbHighModes){
    .modes = b->candidates, .candidates = b->count, .copies = copies_for(b, 1.0 - lost)};
  for (uint32_t from = 0, to; from < b->count; from = to) {
    const uint32_t count = enough(b, from, 1.0 - lost, &to);
    carry_band(b, from, count, to);
    for (uint32_t i = from; i < from + count; i++) {
      b->candidates[chosen->count++] = b->candidates[i];
    }
  }
}

static void prepare_side(Builder *b, uint32_t head) {
  const TaborDrumDef *def = &b->model->def;
  Side *side = &b->sides[head];
  const double radius = b->model->head.radius;
  side->head = head ? &def->resonant : &def->batter;
  for (uint32_t p = 0; p < def->mic_count; p++) {
    const double height = def->mic[p].height;
    side->points[p] = (TbAirPoint){def->mic[p].radius / radius,
                                   (head ? -(height + def->shell.depth) : height) / radius};
  }
  side->top_zero = top_zero(b, side);
}

bool tb_high_modes_choose(TbHighModes *chosen, TbArena *scratch, const TaborModel *model,
                          double top, uint32_t most) {
  const uint32_t heads = model->head.heads;
  Builder b = {.model = model,
               .scratch = scratch,
               .both_sides = !tb_has_cavity(&model->def),
               .top = 2.0 * PI * top};
  b.outside_count = tb_mics_outside(&model->def, b.outside);
  double zero = 0.0;
  for (uint32_t h = 0; h < heads; h++) {
    prepare_side(&b, h);
    zero = fmax(zero, b.sides[h].top_zero);
  }
  b.candidates = tb_arena_take(scratch, MOST_CANDIDATES, sizeof *b.candidates);
  if (scratch->failed ||
      !tb_bessel_table_prepare(&b.table, scratch, (uint32_t)zero + 1u, AIR_REACH * zero)) {
    return false;
  }
  for (uint32_t h = 0; h < heads; h++) {
    if (!measure_edge(&b, h)) return false;
  }
  if (!collect(&b, heads)) return false;
  thin(&b, most, chosen);
  return true;
}
