/* SPDX-License-Identifier: MIT */
#include "highband.h"

#include <math.h>

#include "bessel.h"
#include "highmodes.h"
#include "mics.h"
#include "model.h"

static void count_modes(TbHighBand *band, const TbHighModes *chosen) {
  for (uint32_t i = 0; i < chosen->count; i++) {
    band->size[chosen->modes[i].head] += chosen->modes[i].m ? 2 : 1;
  }
  for (uint32_t h = 0; h < TB_HEADS; h++) {
    band->begin[h + 1] = band->begin[h] + tb_pad(band->size[h]);
  }
  band->candidates = chosen->candidates;
  band->count = chosen->copies;
  band->padded = band->begin[TB_HEADS];
}

static bool allocate(TbHighBand *band, TbArena *arena, uint32_t mics) {
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
  return !arena->failed;
}

static void fill_mode(TbHighBand *band, uint32_t i, const TaborModel *model, const TbHighMode *c,
                      bool sine) {
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

/* Where the real contact points begin and end along the bed, and how far apart they are. */
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
}

static void drive_at(const TbHighBand *band, uint32_t head, double x, double y, double *drive) {
  const double r = hypot(x, y);
  tb_highband_drive(band, head, r, r > 0.0 ? y / r : 0.0, r > 0.0 ? x / r : 1.0, NULL, drive);
}

/* Groups along the bed, and what a force at their middles does. */
static bool prepare_groups(TbHighBand *band, TbArena *arena, TbArena *scratch,
                           const TbWires *wires) {
  double x[TB_HIGH_GROUPS] = {0.0}, y[TB_HIGH_GROUPS] = {0.0};
  uint32_t members[TB_HIGH_GROUPS] = {0};
  const uint32_t begin = band->begin[wires->head], size = band->begin[wires->head + 1] - begin;
  band->row_group = tb_arena_take(arena, wires->stride, sizeof *band->row_group);
  if (arena->failed) return false;
  assign_groups(band, wires);
  band->push = tb_arena_doubles(arena, (size_t)size * band->groups);
  double *drive = tb_arena_doubles(scratch, band->padded);
  if (arena->failed || scratch->failed) return false;
  for (uint32_t row = 0; row < wires->stride; row++) {
    if (wires->real[row] == 0.0) continue;
    const uint32_t group = band->row_group[row];
    x[group] += wires->row_x[row];
    y[group] += wires->row_y[row];
    members[group]++;
  }
  for (uint32_t group = 0; group < band->groups; group++) {
    if (members[group] == 0) continue;
    drive_at(band, wires->head, x[group] / members[group], y[group] / members[group], drive);
    for (uint32_t i = 0; i < size; i++) {
      band->push[((size_t)(i / 8) * band->groups + group) * 8 + i % 8] =
        wires->side * drive[begin + i];
    }
  }
  return true;
}

/* Mean squares of the shapes over a few wires stand for those over all. */
static const uint32_t HOLDING_WIRES = 4;

static bool prepare_hold(TbHighBand *band, TbArena *arena, TbArena *scratch, const TbWires *wires,
                         double time_step) {
  const uint32_t begin = band->begin[wires->head], size = band->begin[wires->head + 1] - begin;
  band->row_loss = tb_arena_doubles(arena, wires->stride);
  band->hold = tb_arena_doubles(arena, size);
  double *drive = tb_arena_doubles(scratch, band->padded);
  if (arena->failed || scratch->failed) return false;
  const uint32_t every = (wires->count + HOLDING_WIRES - 1u) / HOLDING_WIRES;
  uint32_t points = 0;
  for (uint32_t row = 0; row < wires->stride; row++) {
    if (wires->real[row] == 0.0) continue;
    band->row_loss[row] = wires->wires[wires->row_wire[row]].contact_loss;
    if (wires->row_wire[row] % every != every / 2) continue;
    drive_at(band, wires->head, wires->row_x[row], wires->row_y[row], drive);
    for (uint32_t i = 0; i < band->size[wires->head]; i++) {
      const double shape = drive[begin + i] / band->g[begin + i];
      band->hold[i] += 0.5 * time_step * shape * shape;
    }
    points++;
  }
  for (uint32_t i = 0; points && i < size; i++) band->hold[i] /= points;
  return true;
}

TaborStatus tb_highband_prepare(TbHighBand *band, TbArena *arena, const TaborModel *model,
                                double top) {
  *band = (TbHighBand){.radius = model->head.radius};
  if (top <= model->head.bandwidth || model->def.air.density == 0.0) return TABOR_OK;
  TbArena scratch;
  tb_arena_prepare(&scratch, &arena->allocator);
  TbHighModes chosen;
  const uint32_t most = model->quality <= TABOR_QUALITY_LIVE ? TB_HIGH_MOST / 2 : TB_HIGH_MOST;
  bool done = tb_high_modes_choose(&chosen, &scratch, model, top, most);
  if (done) {
    count_modes(band, &chosen);
    done = allocate(band, arena, model->def.mic_count);
  }
  uint32_t next[TB_HEADS] = {band->begin[0], band->begin[1]};
  for (uint32_t i = 0; done && i < chosen.count; i++) {
    const TbHighMode *mode = &chosen.modes[i];
    fill_mode(band, next[mode->head]++, model, mode, false);
    if (mode->m) fill_mode(band, next[mode->head]++, model, mode, true);
  }
  done = done && prepare_groups(band, arena, &scratch, &model->wires) &&
         prepare_hold(band, arena, &scratch, &model->wires, model->time_step);
  tb_arena_release(&scratch);
  return done ? TABOR_OK : TABOR_ERROR_MEMORY;
}

/* Half-way to `last` at most: towards it energy only falls. */
static const double MOST_HELD = 0.5;

void tb_highband_hold(const TbHighBand *band, uint32_t head, double loss, const double *last,
                      double *next) {
  const uint32_t size = band->begin[head + 1] - band->begin[head];
  for (uint32_t i = 0; i < size; i++) {
    const double part = band->hold[i] * loss;
    next[i] += (part < MOST_HELD ? part : MOST_HELD) * (last[i] - next[i]);
  }
}

void tb_highband_patch(const TbHighBand *band, double patch_radius, double *patch) {
  for (uint32_t i = 0; i < band->padded; i++) {
    const double ka = band->zero[i] * patch_radius / band->radius;
    patch[i] = ka > 1e-6 ? 2.0 * tb_bessel_j(1, ka) / ka : 1.0;
  }
}

/* Up to eight modes from `from` on, sine copies passed over; returns how many. */
static uint32_t next_eight(const TbHighBand *band, uint32_t *from, uint32_t end,
                           uint32_t index[8]) {
  uint32_t n = 0;
  for (; *from < end && n < 8; (*from)++) {
    if (!band->sine[*from]) index[n++] = *from;
  }
  return n;
}

void tb_highband_drive(const TbHighBand *band, uint32_t which, double radius, double sin_angle,
                       double cos_angle, const double *patch, double *drive) {
  double c[TB_MAX_ORDERS], s[TB_MAX_ORDERS];
  tb_angular_factors(band->orders, sin_angle, cos_angle, c, s);
  const uint32_t end = band->begin[which] + band->size[which];
  for (uint32_t i = end; i < band->begin[which + 1]; i++) drive[i] = 0.0;
  for (uint32_t from = band->begin[which]; from < end;) {
    uint32_t index[8], m[8] = {0};
    double x[8] = {0.0}, j[8];
    const uint32_t n = next_eight(band, &from, end, index);
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
}
