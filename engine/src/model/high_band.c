/* SPDX-License-Identifier: MIT */
#include "model/high_band.h"

#include <math.h>
#include <string.h>

#include "high_band/high_band_modes.h"
#include "math/bessel.h"
#include "math/portable_math.h"
#include "model/mics.h"
#include "model/model.h"

static const double PI = 3.14159265358979323846;

/* From a cosine copy to its sine copy. */
static uint32_t to_sine(const TbHighBand *band, uint32_t head) {
  return tb_pad(band->cosines[head]);
}

static void count_modes(TbHighBand *band, const TbHighModes *chosen) {
  uint32_t alone[TB_HEADS] = {0}, even[TB_HEADS] = {0};
  for (uint32_t i = 0; i < chosen->count; i++) {
    const TbHighMode *mode = &chosen->modes[i];
    uint32_t *const of = mode->m == 0 ? alone : mode->m % 2 ? band->odd : even;
    of[mode->head]++;
  }
  for (uint32_t h = 0; h < TB_HEADS; h++) {
    band->odd[h] = tb_pad(band->odd[h]);
    band->sines[h] = band->odd[h] + even[h];
    band->cosines[h] = band->sines[h] + alone[h];
    band->begin[h + 1] = band->begin[h] + to_sine(band, h) + tb_pad(band->sines[h]);
  }
  band->candidates = chosen->candidates;
  band->count = chosen->copies;
  band->padded = band->begin[TB_HEADS];
}

static bool allocate(TbHighBand *band, TbArena *arena, uint32_t mics) {
  band->order = tb_arena_take(arena, band->padded, sizeof *band->order);
  band->hold_band = tb_arena_take(arena, band->padded, sizeof *band->hold_band);
  band->of_air = tb_arena_take(arena, band->padded, sizeof *band->of_air);
  double **arrays[] = {&band->zero, &band->scale,     &band->ringing.a,   &band->ringing.b,
                       &band->g,    &band->stiffness, &band->ringing.walk};
  for (size_t i = 0; i < sizeof arrays / sizeof *arrays; i++) {
    *arrays[i] = tb_arena_doubles(arena, band->padded);
  }
  for (uint32_t p = 0; p < mics; p++) {
    band->ringing.ahead[p] = tb_arena_doubles(arena, band->padded);
    band->ringing.behind[p] = tb_arena_doubles(arena, band->padded);
  }
  return !arena->failed;
}

static void prepare_wire_hold(TbHighBand *band, const TaborModel *model, double top) {
  const TaborDrumDef *def = &model->def;
  tb_wire_hold_prepare(&band->wire_hold, &model->body.sheet[model->wires.head], &def->air,
                       &model->wires, model->body.radius, 2.0 * PI * model->body.bandwidth,
                       2.0 * PI * top);
}

/* Frequencies are drawn this often [Hz], for cost: 1,024 modes then take eight a step. In that time
 * modes turn by some 2 rad on heads as uneven as the presets'. */
static const double SCATTER_RATE = 375.0;
/* Parts of a turn per step by which scattering changes it at most, however uneven a head is. */
static const double MOST_SCATTERED = 0.1;

static void prepare_scattering(TbHighBand *band, const TaborModel *model) {
  const double steps = floor(model->step_rate / SCATTER_RATE + 0.5);
  const uint32_t blocks = band->padded / 8u;
  band->seed = (uint64_t)model->body.sheet[1].lug_seed << 32 | model->body.sheet[0].lug_seed;
  band->scatter_steps = blocks > (uint32_t)steps ? blocks : (uint32_t)steps;
  band->scatter_by_wires = 6.0f / (float)band->scatter_steps; /* 3 k D/n of D = 2 s, s k = taken */
}

/* A turn u d per step, u drawn from -1 to 1 every n steps, has the variance D n k after these: d^2
 * = 3 D k/n. */
static double walk_of(const TbHighBand *band, const TbHighMode *c, double time_step) {
  const double turn = c->omega * time_step, most = MOST_SCATTERED * fmin(turn, PI - turn);
  return fmin(3.0 * c->scattering * time_step / band->scatter_steps, most * most);
}

static void fill_mode(TbHighBand *band, uint32_t i, const TaborModel *model, const TbHighMode *c,
                      bool sine) {
  const TbPole pole = tb_pole(c->omega, c->decay_rate, model->time_step);
  band->order[i] = c->m;
  band->of_air[i] = c->of_air;
  if (c->m >= band->orders) band->orders = c->m + 1;
  band->zero[i] = c->zero;
  band->scale[i] = c->scale;
  band->ringing.a[i] = pole.a;
  band->ringing.b[i] = pole.b;
  band->g[i] = pole.g;
  band->ringing.walk[i] = walk_of(band, c, model->time_step);
  band->stiffness[i] = pole.stiffness;
  band->hold_band[i] = (uint8_t)tb_wire_hold_band(&band->wire_hold, c->omega);
  for (uint32_t p = 0; p < model->def.mic_count; p++) {
    tb_mic_weights(model, p, c->omega, &pole, c->m, sine, c->fields + 2 * p,
                   &band->ringing.ahead[p][i], &band->ringing.behind[p][i]);
  }
}

/* First odd orders, then even ones, then order 0, which has no sine copy. */
static uint32_t round_of(const TbHighMode *mode) { return mode->m == 0 ? 2 : mode->m % 2 ? 0 : 1; }

static void fill_modes(TbHighBand *band, const TaborModel *model, const TbHighModes *chosen) {
  uint32_t next[TB_HEADS];
  for (uint32_t round = 0; round < 3; round++) {
    for (uint32_t h = 0; h < TB_HEADS && round < 2; h++) {
      next[h] = band->begin[h] + (round == 1 ? band->odd[h] : 0u);
    }
    for (uint32_t i = 0; i < chosen->count; i++) {
      const TbHighMode *mode = &chosen->modes[i];
      if (round_of(mode) != round) continue;
      const uint32_t at = next[mode->head]++;
      fill_mode(band, at, model, mode, false);
      if (mode->m) fill_mode(band, at + to_sine(band, mode->head), model, mode, true);
    }
  }
}

/* First and last real contact point along the bed, and their distance. */
typedef struct Extent {
  double from, to, step;
} Extent;

static Extent extent_of(const TbWires *wires) {
  Extent extent = {INFINITY, -INFINITY, INFINITY};
  for (uint32_t row = 0; row < wires->stride; row++) {
    if (wires->real[row] == 0.0) continue;
    extent.from = fmin(extent.from, wires->row_x[row]);
    extent.to = fmax(extent.to, wires->row_x[row]);
  }
  for (uint32_t w = 0; w < wires->count; w++) {
    extent.step = fmin(extent.step, wires->wires[w].spacing);
  }
  return extent;
}

/* Assigns contact points to groups of whole steps. */
static void assign_groups(TbHighBand *band, const TbWires *wires) {
  const Extent extent = extent_of(wires);
  if (!(extent.to >= extent.from)) return;
  const double steps = floor((extent.to - extent.from) / extent.step + 0.5);
  const double each = ceil((steps + 1.0) / TB_HIGH_GROUPS);
  for (uint32_t row = 0; row < wires->stride; row++) {
    if (wires->real[row] == 0.0) continue;
    const double place = floor((wires->row_x[row] - extent.from) / extent.step + 0.5);
    band->row_group[row] = (uint8_t)(place / each);
    if (band->row_group[row] >= band->groups) band->groups = band->row_group[row] + 1u;
  }
  band->apart = true;
  for (uint32_t group = 0; group < band->groups && band->apart; group++) {
    band->apart = band->row_group[group] == group;
  }
}

/* A wire at a place on its head loses to the head's own waves, first, what it would
 * give the air. */
static void drive_by_wire(const TbHighBand *band, uint32_t head, double x, double y,
                          double *drive) {
  const double r = tb_hypot(x, y);
  tb_high_band_drive(band, head, r, r > 0.0 ? y / r : 0.0, r > 0.0 ? x / r : 1.0, NULL, drive);
  for (uint32_t i = band->begin[head]; i < band->begin[head + 1]; i++) {
    if (band->of_air[i]) drive[i] = 0.0;
  }
}

/* Rounding of a sum over mirror images, in radii. */
static const double ON_AXIS = 1e-9;

/* Middles of the groups. */
typedef struct Middles {
  double x[TB_HIGH_GROUPS], y[TB_HIGH_GROUPS];
} Middles;

static void find_middles(const TbHighBand *band, const TbWires *wires, Middles *middles) {
  uint32_t members[TB_HIGH_GROUPS] = {0};
  *middles = (Middles){.x = {0.0}};
  for (uint32_t row = 0; row < wires->stride; row++) {
    if (wires->real[row] == 0.0) continue;
    const uint32_t group = band->row_group[row];
    middles->x[group] += wires->row_x[row];
    middles->y[group] += wires->row_y[row];
    members[group]++;
  }
  for (uint32_t group = 0; group < band->groups; group++) {
    if (members[group] == 0) continue;
    middles->x[group] /= members[group];
    middles->y[group] /= members[group];
  }
}

/* Which modes the groups push, and whether by sums and differences of two groups each. */
static void choose_pushes(TbHighBand *band, const TbWires *wires, const Middles *middles) {
  const uint32_t head = wires->head, begin = band->begin[head], groups = band->groups;
  double aside = 0.0, uneven = 0.0;
  for (uint32_t group = 0; group < groups; group++) {
    aside = fmax(aside, fabs(middles->y[group]));
    uneven = fmax(uneven, fabs(middles->x[group] + middles->x[groups - 1u - group]));
  }
  const bool on_axis = aside <= ON_AXIS * band->radius;
  band->driven = on_axis ? to_sine(band, head) : band->begin[head + 1] - begin;
  band->folded = on_axis && uneven <= ON_AXIS * band->radius;
  band->push[0] = (TbHighPush){.from = begin, .size = band->driven, .rows = groups};
  if (!band->folded) return;
  const uint32_t pairs = (groups + 1u) / 2u, odd = band->odd[head];
  band->push[0] = (TbHighPush){.from = begin, .size = odd, .rows = pairs};
  band->push[1] = (TbHighPush){.from = begin + odd, .size = band->driven - odd, .rows = pairs};
}

/* Groups along the bed, and what a force at their middles does. */
static bool prepare_groups(TbHighBand *band, TbArena *arena, TbArena *scratch,
                           const TbWires *wires) {
  band->row_group = tb_arena_take(arena, wires->stride, sizeof *band->row_group);
  if (arena->failed) return false;
  assign_groups(band, wires);
  Middles middles;
  find_middles(band, wires, &middles);
  choose_pushes(band, wires, &middles);
  double *drive = tb_arena_doubles(scratch, band->padded);
  for (uint32_t p = 0; p < 2; p++) {
    TbHighPush *push = &band->push[p];
    push->table = tb_arena_take(arena, (size_t)push->size * push->rows, sizeof *push->table);
    if (arena->failed || scratch->failed) return false;
    for (uint32_t row = 0; row < push->rows; row++) {
      drive_by_wire(band, wires->head, middles.x[row], middles.y[row], drive);
      for (uint32_t i = 0; i < push->size; i++) {
        push->table[(size_t)row * push->size + i] = (float)(wires->side * drive[push->from + i]);
      }
    }
  }
  return true;
}

/* Sums over the points of each group. */
static void group_forces(const TbHighBand *band, uint32_t points, const double *forces,
                         double *groups) {
  for (uint32_t group = 0; group < band->groups; group++) groups[group] = 0.0;
  for (uint32_t point = 0; point < points; point++) groups[band->row_group[point]] += forces[point];
}

/* Forces, and the rows of a table that they push by. */
typedef struct Pushers {
  uint32_t count;
  float values[TB_HIGH_GROUPS];
  const float *rows[TB_HIGH_GROUPS];
} Pushers;

/* At the end of `count`, which is returned; one of nothing gives its place to the next. */
static inline uint32_t append(Pushers *to, uint32_t count, double value, const float *row) {
  to->values[count] = (float)value;
  to->rows[count] = row;
  return count + (value != 0.0);
}

/* The groups that push each part of the modes: those of odd and of even order by differences and
 * sums of mirror images, or else all by themselves. */
static void fold_groups(const TbHighBand *band, const double *groups, Pushers to[2]) {
  const TbHighPush *odd = &band->push[0], *even = &band->push[1];
  const uint32_t all = band->groups, pairs = band->folded ? all / 2u : 0u;
  const float *odd_row = odd->table, *even_row = even->table;
  uint32_t odds = 0, evens = 0;
  for (uint32_t row = 0; row < pairs; row++) {
    const double own = groups[row], image = groups[all - 1u - row];
    odds = append(&to[0], odds, own - image, odd_row);
    evens = append(&to[1], evens, own + image, even_row);
    odd_row += odd->size;
    even_row += even->size;
  }
  if (band->folded && all % 2u) evens = append(&to[1], evens, groups[pairs], even_row);
  for (uint32_t row = 0; !band->folded && row < all; row++) {
    odds = append(&to[0], odds, groups[row], odd_row);
    odd_row += odd->size;
  }
  to[0].count = odds;
  to[1].count = evens;
}

static const double STEADY = 200.0;  /* [Hz] */
static const double VANISHED = 16.0; /* 140 dB, as a logarithm */

/* Replaces force[n] by its part that does not stay, if `share` of steady[n] is left. */
static void leave_steady(uint32_t n, float follow, float share, float *force, float *steady) {
  for (uint32_t i = 0; i < n; i++) {
    const float before = share * steady[i];
    force[i] -= before;
    steady[i] = before + follow * force[i];
  }
}

TbWireContacts tb_high_band_push(const TaborModel *model, const double *force, const double *s,
                                 TbWirePush *push, double *sums, float *out, float *steady) {
  const TbHighBand *band = &model->high;
  const TbWires *wires = &model->wires;
  const uint32_t count = wires->aligned ? wires->count : 1u, each = wires->stride / count;
  const TbWireContacts contacts = model->kernels->gather_wires(count, each, force, s, sums);
  double groups[TB_HIGH_GROUPS];
  Pushers pushers[2];
  if (!band->apart) group_forces(band, each, sums, groups);
  fold_groups(band, band->apart ? sums : groups, pushers);
  for (uint32_t p = 0; p < 2; p++) {
    const TbHighPush *part = &band->push[p];
    model->kernelsf->sum_scaled(part->size, pushers[p].count, pushers[p].values, pushers[p].rows,
                                out + part->from);
  }
  const uint32_t from = band->push[0].from;
  if (!push->known) memcpy(steady + from, out + from, band->driven * sizeof *out);
  leave_steady(band->driven, band->follow, push->known ? (float)push->share : 1.0f, out + from,
               steady + from);
  *push = (TbWirePush){.known = 1, .left = band->vanishes, .share = 1.0};
  return contacts;
}

void tb_high_band_push_nothing(const TaborModel *model, TbWirePush *push) {
  push->share = push->left > 1 ? push->share * (1.0 - (double)model->high.follow) : 0.0;
  push->left -= push->left > 0;
}

/* Mean squares of the shapes over a few wires stand for those over all. */
static const uint32_t HOLDING_WIRES = 4;

static bool prepare_hold(TbHighBand *band, TbArena *arena, TbArena *scratch,
                         const TaborModel *model) {
  const TbWires *wires = &model->wires;
  const uint32_t begin = band->begin[wires->head], size = band->begin[wires->head + 1] - begin;
  band->ringing.hold = tb_arena_doubles(arena, band->padded);
  double *drive = tb_arena_doubles(scratch, band->padded);
  if (arena->failed || scratch->failed) return false;
  const uint32_t every = (wires->count + HOLDING_WIRES - 1u) / HOLDING_WIRES;
  uint32_t points = 0;
  for (uint32_t row = 0; row < wires->stride; row++) {
    if (wires->real[row] == 0.0) continue;
    if (wires->row_wire[row] % every != every / 2) continue;
    drive_by_wire(band, wires->head, wires->row_x[row], wires->row_y[row], drive);
    for (uint32_t i = 0; i < size; i++) {
      if (band->g[begin + i] == 0.0) continue; /* padding */
      const double shape = drive[begin + i] / band->g[begin + i];
      band->ringing.hold[begin + i] += 0.5 * model->time_step * shape * shape;
    }
    points++;
  }
  for (uint32_t i = 0; points && i < size; i++) band->ringing.hold[begin + i] /= points;
  return true;
}

static float *rounded(TbArena *arena, uint32_t n, const double *x) {
  float *out = tb_arena_take(arena, n, sizeof *out);
  for (uint32_t i = 0; out && i < n; i++) out[i] = (float)x[i];
  return out;
}

static bool keep_ringing(TbHighBand *band, TbArena *arena, uint32_t mics) {
  (void)band, (void)arena, (void)mics;
  return true;
}

static bool round_ringing(TbHighBand *band, TbArena *arena, uint32_t mics) {
  const TbRinging *exact = &band->ringing;
  TbRingingF *to = &band->ringingf;
  const uint32_t n = band->padded;
  to->a = rounded(arena, n, exact->a);
  to->b = rounded(arena, n, exact->b);
  to->walk = rounded(arena, n, exact->walk);
  to->hold = rounded(arena, n, exact->hold);
  for (uint32_t p = 0; p < mics; p++) {
    to->ahead[p] = rounded(arena, n, exact->ahead[p]);
    to->behind[p] = rounded(arena, n, exact->behind[p]);
  }
  return !arena->failed;
}

TaborStatus tb_high_band_prepare(TbHighBand *band, TbArena *arena, const TaborModel *model,
                                 double top) {
  static bool (*const ROUND[])(TbHighBand *, TbArena *, uint32_t) = {
    [TB_IN_DOUBLE] = keep_ringing, [TB_IN_FLOAT] = round_ringing};
  const double turn = 2.0 * PI * STEADY * model->time_step;
  *band = (TbHighBand){.radius = model->body.radius,
                       .precision = model->precision,
                       .follow = (float)(turn / (1.0 + turn)),
                       .vanishes = (uint32_t)(VANISHED * (1.0 + turn) / turn)};
  if (top <= model->body.bandwidth || model->def.air.density == 0.0) return TABOR_OK;
  TbArena scratch;
  tb_arena_beside(&scratch, arena);
  TbHighModes chosen;
  const uint32_t most = model->quality <= TABOR_QUALITY_LIVE ? TB_HIGH_MOST_LIVE : TB_HIGH_MOST;
  const TbWires *wires = &model->wires;
  const TbHighDrum drum = {.def = &model->def,
                           .body = &model->body,
                           .time_step = model->time_step,
                           .wired_head = wires->count > 0 ? wires->head : TB_HEADS};
  bool done = tb_high_modes_choose(&chosen, &scratch, &drum, top, most);
  if (done) {
    count_modes(band, &chosen);
    prepare_wire_hold(band, model, top);
    done = allocate(band, arena, model->def.mic_count);
  }
  if (done) prepare_scattering(band, model);
  if (done) fill_modes(band, model, &chosen);
  done = done && prepare_groups(band, arena, &scratch, wires) &&
         prepare_hold(band, arena, &scratch, model) &&
         ROUND[band->precision](band, arena, model->def.mic_count);
  tb_arena_release(&scratch);
  return done ? TABOR_OK : TABOR_ERROR_MEMORY;
}

void tb_high_band_patch(const TbHighBand *band, double patch_radius, double *patch) {
  for (uint32_t i = 0; i < band->padded; i++) {
    const double ka = band->zero[i] * patch_radius / band->radius;
    patch[i] = ka > 1e-6 ? 2.0 * tb_bessel_j(1, ka) / ka : 1.0;
  }
}

/* Sums over the eight modes from `from` on. */
static void eight_waves(const TbHighBand *band, uint32_t from, double radius, const double *patch,
                        double waves[8]) {
  double x[8]; /* padding follows the last cosine */
  for (uint32_t l = 0; l < 8; l++) x[l] = band->zero[from + l] * radius / band->radius;
  tb_bessel_j8(band->order + from, x, waves);
  for (uint32_t l = 0; l < 8; l++) {
    const uint32_t i = from + l;
    waves[l] = -band->g[i] * band->scale[i] * waves[l] * (patch ? patch[i] : 1.0);
  }
}

/* Eight cosines from `from` on, and their sines. */
static void turn_eight(const TbHighBand *band, uint32_t which, uint32_t from, const double *waves,
                       const double *c, const double *s, double *drive) {
  const uint32_t end = band->begin[which] + band->cosines[which], sine = to_sine(band, which);
  for (uint32_t i = from; i < end && i < from + 8; i++) {
    const uint32_t m = band->order[i];
    drive[i] = waves[i - from] * c[m];
    if (m) drive[i + sine] = waves[i - from] * s[m];
  }
}

void tb_high_band_turn(const TbHighBand *band, uint32_t which, const double *waves,
                       double sin_angle, double cos_angle, double *drive) {
  double c[TB_MAX_ORDERS], s[TB_MAX_ORDERS];
  tb_angular_factors(band->orders, sin_angle, cos_angle, c, s);
  const uint32_t begin = band->begin[which], end = begin + band->cosines[which];
  for (uint32_t i = begin; i < band->begin[which + 1]; i++) drive[i] = 0.0;
  for (uint32_t from = begin; from < end; from += 8) {
    turn_eight(band, which, from, waves + (from - begin), c, s, drive);
  }
}

void tb_high_band_drive(const TbHighBand *band, uint32_t which, double radius, double sin_angle,
                        double cos_angle, const double *patch, double *drive) {
  double c[TB_MAX_ORDERS], s[TB_MAX_ORDERS];
  tb_angular_factors(band->orders, sin_angle, cos_angle, c, s);
  const uint32_t begin = band->begin[which], end = begin + band->cosines[which];
  for (uint32_t i = begin; i < band->begin[which + 1]; i++) drive[i] = 0.0;
  for (uint32_t from = begin; from < end; from += 8) {
    double waves[8];
    eight_waves(band, from, radius, patch, waves);
    turn_eight(band, which, from, waves, c, s, drive);
  }
}
