/* SPDX-License-Identifier: MIT */
#include "high_band/high_band_modes.h"

#include <math.h>
#include <string.h>

#include "bodies/drum/closed_drum_modes.h"
#include "bodies/drum/single_head.h"
#include "bodies/sheet_waves.h"
#include "definition/definition.h"
#include "high_band/high_air_choice.h"
#include "high_band/scattering.h"
#include "math/bessel.h"
#include "math/portable_math.h"

static const double PI = 3.14159265358979323846;
static const double TOP_ZERO = 240.0; /* orders stay below TB_MAX_ORDERS */
static const double AIR_REACH =
  2.0; /* the air's integrals end below this many times the top zero */
enum { MOST_ZEROS = 96, MOST_CANDIDATES = 16384 };
/* Orders below this, of a single head, radiate each mode by itself: near the centre they sound
 * alone, a few in a third of an octave, and what the edge and their coupling make of each is 4 dB
 * more or less. */
enum { WHOLE_ORDERS = 4 };

/* The factor on a Bessel function's baffled radiation by the edge and by the air's coupling of
 * modes: pressure per microphone, and resistance. */
typedef struct EdgeFactors {
  double field[TABOR_MAX_MICS], resistance;
  double in_head; /* part that the head has of a mode */
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

/* The air inside, as the modes of one order meet it; no microphones without a cavity. */
typedef struct Inside {
  TbCavityOrder order;
  TbCavityMics mics;
  TbHighCavity modes;
} Inside;

typedef struct Builder {
  const TbHighDrum *drum;
  TbArena *scratch;
  Side sides[TB_HEADS];
  uint32_t outside[TABOR_MAX_MICS], outside_count; /* microphones outside the shell */
  Functions functions;                             /* of the order at hand */
  Inside inside;
  TbHighAirPlan air; /* empty without a cavity */
  bool both_sides;   /* a single head, with air outside on both */
  TbBesselTable table;
  double top; /* [rad/s] */
  TbHighMode *candidates;
  uint32_t count;
} Builder;

/* Frequency of a wave with this Bessel zero, and its mass per area. */
static double frequency(const Builder *b, const Side *side, double zero, double *mass) {
  return tb_sheet_wave_frequency(side->head, &b->drum->def->air, zero / b->drum->body->radius,
                                 mass);
}

static double x_at(const Builder *b, double omega) {
  return omega * b->drum->body->radius / b->drum->def->air.sound_speed;
}

/* The microphones that choose the modes: those inside the shell only where there are no others. So
 * a microphone inside changes nothing that the others hear. */
static uint32_t choosers(const Builder *b, uint32_t *mics) {
  if (b->outside_count > 0) {
    memcpy(mics, b->outside, sizeof b->outside);
    return b->outside_count;
  }
  for (uint32_t p = 0; p < b->drum->def->mic_count; p++) mics[p] = p;
  return b->drum->def->mic_count;
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
  const double one = 1.0;
  const bool done = tb_air_baffled(order, &scratch, b->both_sides, &one, x_at(b, c->omega), points,
                                   b->outside_count, resistance, fields);
  tb_arena_release(&scratch);
  for (uint32_t p = 0; done && p < b->outside_count; p++) {
    c->fields[2 * b->outside[p]] = fields[2 * p];
    c->fields[2 * b->outside[p] + 1] = fields[2 * p + 1];
  }
  return done;
}

/* A Bessel function with its baffled radiation: scale, fields and both parts of the decay rate.
 * `slope`: J_{m+1}(zero) */
static bool radiate(const Builder *b, uint32_t head, uint32_t m, double zero, double slope,
                    TbHighMode *c) {
  const TaborDrumDef *def = b->drum->def;
  const Side *side = &b->sides[head];
  const double radius = b->drum->body->radius;
  double mass, resistance;
  *c = (TbHighMode){.head = head, .m = m, .zero = zero, .slope = slope, .in_head = 1.0};
  c->omega = frequency(b, side, zero, &mass);
  const TbAirOrder order = {
    .m = m, .count = 1, .zeros = &c->zero, .slopes = &c->slope, .table = &b->table};
  if (!radiate_outside(b, side, &order, c, &resistance)) return false;
  const double norm = (m ? PI : 2.0 * PI) * radius * radius * 0.5 * c->slope * c->slope;
  c->scale = 1.0 / sqrt(mass * norm);
  const double upward = head ? -1.0 : 1.0; /* shapes are upward, fields of outward motion */
  for (uint32_t i = 0; i < 2 * def->mic_count; i++) c->fields[i] *= upward * c->scale;
  c->decay_rate = tb_sheet_wave_decay_rate(side->head, radius, m, zero, slope, mass);
  c->radiation_rate =
    def->air.density * def->air.sound_speed * resistance / (mass * c->slope * c->slope);
  return true;
}

/* True if the high band has modes of the enclosed air. */
static bool has_air_modes(const Builder *b) { return b->air.to > b->air.from; }

/* Fields of a function at the microphones inside: `in_head` is the part that its head has of it in
 * the mean. Sound of the air that rings on by itself comes from its own modes, or else from this
 * one. */
static void fill_inside(const Builder *b, double in_head, TbHighMode *c) {
  const Inside *inside = &b->inside;
  const bool rings = has_air_modes(b) && c->omega < b->air.to;
  const double late_decay_rate = rings ? 0.0 : c->decay_rate;
  const TbAirOrder air = {.m = c->m, .count = 1, .zeros = &c->zero, .slopes = &c->slope};
  double outward[TB_HEADS] = {0.0};
  outward[c->head] = (c->head ? -in_head : in_head) * c->scale;
  const TbCavity cavity = tb_closed_drum_cavity(b->drum->def, c->m, c->omega);
  tb_cavity_fields(&inside->mics, &inside->order, &cavity, &air, outward, NULL, c->omega,
                   late_decay_rate, c->fields);
}

static double loudness(const Builder *b, const TbHighMode *c) {
  double loudest = 0.0;
  uint32_t mics[TABOR_MAX_MICS];
  const uint32_t count = choosers(b, mics);
  for (uint32_t p = 0; p < count; p++)
    loudest = fmax(loudest, tb_high_mode_energy(b->drum, c, mics[p]));
  return loudest;
}

/* Takes the next candidate, which knows what it is and how it radiates. */
static void take_candidate(Builder *b) {
  TbHighMode *c = &b->candidates[b->count++];
  if (!b->drum->def->quality.losses) c->decay_rate = 0.0;
  c->loudness = loudness(b, c);
  c->band = tb_sixth_of(c->omega);
}

/* Functions that wires damp pass nothing on to the air: they lose it to the wires first. */
static bool meets_air(const Builder *b, uint32_t head) {
  return has_air_modes(b) && b->drum->wired_head != head;
}

/* The part that modes of the air take from Bessel function n. The factors of the edge have what
 * they take in the mean. */
static void leave_to_air(const TbHighCavity *air, const EdgeFactors *edge, uint32_t n,
                         TbHighMode *c) {
  double air_rate;
  const double left = fmax(0.0, 1.0 - tb_high_cavity_taken(air, c->head, n, &air_rate));
  const double against_mean = left / edge->in_head;
  c->decay_rate = left * c->decay_rate + (1.0 - left) * air_rate;
  c->in_head = against_mean;
  c->scale *= sqrt(against_mean);
  for (uint32_t i = 0; i < 2 * TABOR_MAX_MICS; i++) c->fields[i] *= sqrt(against_mean);
}

static bool add_candidate(Builder *b, uint32_t head, uint32_t m, uint32_t n) {
  const TaborDrumDef *def = b->drum->def;
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
  if (meets_air(b, head)) leave_to_air(&b->inside.modes, &side->edge, n, c);
  if (b->inside.mics.count > 0) fill_inside(b, side->edge.in_head, c);
  take_candidate(b);
  return true;
}

/* ---- the edge ------------------------------------------------------------------------------- */

static double square_of(const double *complex_number) {
  return complex_number[0] * complex_number[0] + complex_number[1] * complex_number[1];
}

/* Which head a two-way mode moves; TB_HEADS if both or neither. */
static uint32_t head_of(const TbBodyMode *mode) {
  if (mode->part == TABOR_PART_BATTER) return 0;
  return mode->part == TABOR_PART_RESONANT ? 1 : TB_HEADS;
}

/* The mean part of a two-way mode that a force on a head finds: against a Bessel
 * function by itself, of unit modal mass with this slope at the edge. */
static double part_in_head(const TbBodyOrder *order, uint32_t k, uint32_t head, double slope) {
  const double *v = order->vectors[head] + (size_t)k * order->zero_count;
  double square = 0.0;
  for (uint32_t i = 0; i < order->zero_count; i++) {
    const double own = v[i] * tb_bessel_j(order->m + 1, order->zeros[i]);
    square += own * own;
  }
  return square / (slope * slope);
}

/* Upper two-way modes of one low order, as they radiate, against the same as Bessel functions. */
static bool add_order_edge(const Builder *b, uint32_t head, const TbBodyOrder *order,
                           EdgeFactors *real, EdgeFactors *simple) {
  for (uint32_t k = order->mode_count / 2; k < order->mode_count; k++) {
    const TbBodyMode *mode = &b->drum->body->modes[order->rows[k]];
    if (head_of(mode) != head) continue;
    const double zero = order->zeros[mode->n - 1], slope = tb_bessel_j(order->m + 1, zero);
    TbHighMode c;
    if (!radiate(b, head, order->m, zero, slope, &c)) return false;
    const double in_head = part_in_head(order, k, head, c.scale * slope);
    for (uint32_t p = 0; p < b->drum->def->mic_count; p++) {
      real->field[p] += in_head * square_of(mode->fields + 2 * p);
      simple->field[p] += square_of(c.fields + 2 * p);
    }
    real->in_head += in_head;
    simple->in_head += 1.0;
    real->resistance += mode->radiation_rate;
    simple->resistance += c.radiation_rate;
  }
  return true;
}

static double ratio(double real, double simple) { return simple > 0.0 ? real / simple : 1.0; }

/* Orders on which the edge is measured. */
enum { EDGE_ORDERS = 10 };

static bool measure_edge(Builder *b, uint32_t head) {
  const TbBody *modes = b->drum->body;
  EdgeFactors real = {{0.0}, 0.0, 0.0}, simple = {{0.0}, 0.0, 0.0}, *edge = &b->sides[head].edge;
  for (uint32_t m = 0; m < modes->order_count && m < EDGE_ORDERS; m++) {
    if (!add_order_edge(b, head, &modes->orders[m], &real, &simple)) return false;
  }
  edge->in_head = ratio(real.in_head, simple.in_head);
  edge->resistance = ratio(real.resistance, simple.resistance);
  for (uint32_t p = 0; p < b->drum->def->mic_count; p++) {
    edge->field[p] = sqrt(ratio(real.field[p], simple.field[p]));
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
  const TbBody *modes = b->drum->body;
  if (m >= modes->order_count) return 0;
  const TbBodyOrder *order = &modes->orders[m];
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
    const TbBodyMode *mode = &modes->modes[order->rows[k]];
    if (head_of(mode) == head && mode->n > there) there = mode->n;
  }
  return there;
}

/* Modes of one order of a single head above the two-way ones, with the air that those have. */
static bool collect_whole(Builder *b, TbArena *scratch, uint32_t m) {
  TbBodyOrder order = {.m = m, .zeros = tb_arena_doubles(scratch, MOST_ZEROS)};
  TbBodyMode *modes = tb_arena_take(scratch, MOST_ZEROS, sizeof *modes);
  TbAirOrder air;
  if (scratch->failed) return false;
  order.zero_count = tb_bessel_zeros(m, b->sides[0].top_zero + 2.0 * PI, order.zeros, MOST_ZEROS);
  if (!tb_air_order_prepare(&air, scratch, m, order.zeros, order.zero_count)) return false;
  air.table = &b->table;
  const TbRim at_rest = {.count = 0};
  if (tb_single_head_order(b->drum->def, scratch, scratch, &air, &at_rest,
                           (TbModeLimits){b->top, b->top}, &order, modes, MOST_ZEROS) != TABOR_OK) {
    return false;
  }
  for (uint32_t n = taken(b, 0, m, order.zeros, order.zero_count); n < order.mode_count; n++) {
    if (b->count == MOST_CANDIDATES) break;
    TbHighMode *c = &b->candidates[b->count];
    *c = (TbHighMode){.m = m,
                      .zero = order.zeros[n],
                      .slope = tb_bessel_j(m + 1, order.zeros[n]),
                      .in_head = 1.0,
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

/* Beyond the fastest wave of the air, whose radial order is then among those prepared. */
static const double SPARE_ZEROS = 4.0;

/* Radial orders that the air's modes have or that come as far as a microphone inside: those faster
 * than sound, and slower ones up to where e^-(z' d/R), d the distance from the nearest head, is
 * 1e-3. */
static double inside_zero(const Builder *b) {
  const TaborDrumDef *def = b->drum->def;
  double nearest = INFINITY;
  for (uint32_t p = 0; p < def->mic_count; p++) {
    if (!tb_mic_is_inside(def, &def->mic[p])) continue;
    nearest = fmin(nearest, fmin(-def->mic[p].height, def->shell.depth + def->mic[p].height));
  }
  const double slower = fmax(SPARE_ZEROS, 7.0 * def->shell.radius / nearest);
  return fmin(x_at(b, b->top) + slower, 2.0 * TOP_ZERO);
}

/* ---- the enclosed air ------------------------------------------------------------------------ */

/* The wave of a mode of the air on the batter head, which strikers strike. It is as loud as `count`
 * of its kind. */
static void add_air_wave(Builder *b, const TbAirMode *mode, double count, const double *fields) {
  if (b->count == MOST_CANDIDATES) return;
  TbHighMode *c = &b->candidates[b->count];
  const TbHighCavity *air = &b->inside.modes;
  *c = (TbHighMode){.head = TABOR_HEAD_BATTER,
                    .m = air->order->m,
                    .of_air = true,
                    .omega = mode->omega,
                    .decay_rate = mode->decay_rate,
                    .in_head = mode->in_head[TABOR_HEAD_BATTER]};
  tb_high_cavity_wave(air, mode, TABOR_HEAD_BATTER, &c->zero, &c->scale);
  for (uint32_t i = 0; i < 2 * TABOR_MAX_MICS; i++) c->fields[i] = fields[i] * sqrt(count);
  take_candidate(b);
}

/* Modes that the coupling moves below the band are two-way modes. */
static bool add_air_mode(Builder *b, const TbAirChoice *choice, TbAirMode *mode) {
  double fields[2 * TABOR_MAX_MICS];
  TbHighCavity *air = &b->inside.modes;
  mode->radial = choice->radial;
  mode->axial = choice->axial;
  tb_high_cavity_mode(air, mode);
  if (mode->omega <= b->air.from || mode->omega > b->top) return true;
  TbArena scratch;
  tb_arena_beside(&scratch, b->scratch);
  const bool done = tb_high_cavity_radiate(air, &scratch, mode, fields);
  tb_arena_release(&scratch);
  if (done) add_air_wave(b, mode, choice->count, fields);
  return done;
}

/* The air's modes of one order, before the heads' functions, of which they take a part. */
static bool add_air(Builder *b, TbArena *scratch, uint32_t m) {
  Functions *functions = &b->functions;
  TbHighCavity *air = &b->inside.modes;
  const TbAirOrder order = {.m = m,
                            .count = functions->count,
                            .zeros = functions->zeros,
                            .slopes = functions->slopes,
                            .table = &b->table};
  TbAirMode mode = {.radial = 0};
  for (uint32_t h = 0; h < TB_HEADS; h++) mode.outward[h] = tb_arena_doubles(scratch, order.count);
  TbAirChoices chosen;
  if (!tb_high_cavity_prepare(air, scratch, b->drum->def, &order, &b->inside.order,
                              &b->inside.mics) ||
      !tb_air_choose(&b->air, scratch, air, &mode, &chosen)) {
    return false;
  }
  for (uint32_t i = 0; i < chosen.count; i++) {
    if (!add_air_mode(b, &chosen.choices[i], &mode)) return false;
  }
  return true;
}

static bool add_heads(Builder *b, const bool *heard, uint32_t m) {
  for (uint32_t h = 0; h < TB_HEADS; h++) {
    if (heard[h] && !add_order(b, h, m)) return false;
  }
  return true;
}

/* The air inside, if there is any, as one order meets it. */
static bool prepare_inside(Builder *b, TbArena *scratch, uint32_t m) {
  Inside *inside = &b->inside;
  if (b->both_sides) return true;
  const TbCavity cavity = tb_closed_drum_cavity(b->drum->def, m, b->top);
  return tb_cavity_order_prepare(&inside->order, scratch, &cavity, m, inside_zero(b), 0.0) &&
         tb_cavity_mics_prepare(&inside->mics, scratch, b->drum->def, &inside->order) &&
         (!has_air_modes(b) || add_air(b, scratch, m));
}

/* The modes of one order, on the heads that are heard. */
static bool collect_order(Builder *b, const bool *heard, uint32_t m) {
  TbArena scratch;
  tb_arena_beside(&scratch, b->scratch);
  find_functions(b, m);
  b->inside.mics.count = 0;
  const bool done = prepare_inside(b, &scratch, m) && add_heads(b, heard, m);
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

/* ---- all of them ---------------------------------------------------------------------------- */

static void prepare_side(Builder *b, uint32_t head) {
  const TaborDrumDef *def = b->drum->def;
  Side *side = &b->sides[head];
  const double radius = b->drum->body->radius;
  side->head = &b->drum->body->sheet[head];
  for (uint32_t p = 0; p < def->mic_count; p++) {
    const double height = def->mic[p].height;
    side->points[p] = (TbAirPoint){def->mic[p].radius / radius,
                                   (head ? -(height + def->shell.depth) : height) / radius};
  }
  side->top_zero = top_zero(b, side);
}

bool tb_high_modes_choose(TbHighModes *chosen, TbArena *scratch, const TbHighDrum *drum, double top,
                          uint32_t most) {
  const uint32_t heads = drum->body->surfaces;
  Builder b = {.drum = drum,
               .scratch = scratch,
               .both_sides = !tb_has_cavity(drum->def),
               .top = 2.0 * PI * top};
  if (!b.both_sides) {
    const double to = tb_closed_drum_air_top(drum->def, b.top);
    tb_high_air_plan(&b.air, drum->def, 2.0 * PI * drum->body->bandwidth, to);
  }
  b.outside_count = tb_mics_outside(drum->def, b.outside);
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
  *chosen = tb_high_modes_thin(drum, b.candidates, b.count, most);
  tb_scattering_prepare(drum, chosen);
  return true;
}
