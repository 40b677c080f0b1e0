/* SPDX-License-Identifier: MIT */
#include "model/stretch_mixing.h"

#include <math.h>
#include <string.h>

#include "math/bessel.h"
#include "model/model.h"

static const double PI = 3.14159265358979323846;

/* Third octaves of hard strokes are then within 0.8 dB of those of the whole matrix at live, up to
 * 2 kHz, where they are within 25 dB of the loudest (test_system_stretch), and within 0.5 dB at
 * studio and reference. At live twice the part, or 1500 Hz, leaves 2 to 6 dB. */
static const TbMixingLimits LIMITS[] = {
  [TB_IN_FLOAT] = {.least = 0.02, .top = 14451.0},  /* 2300 Hz */
  [TB_IN_DOUBLE] = {.least = 0.01, .top = 16336.0}, /* 2600 Hz */
};

TbMixingLimits tb_mixing_limits(const TaborModel *model) { return LIMITS[model->precision]; }

/* The heads' terms of one order. */
typedef struct Order {
  const TaborModel *model;
  const TbBodyOrder *order;
  uint32_t *at[2];        /* index of each mode's copies, or TB_NO_MODE */
  double *stretch;        /* [zero_count] a_m R^2 K^2 J^2/2 */
  double least[TB_HEADS]; /* of |G_ij|/(omega_i omega_j) */
  uint32_t count;         /* of modes below the limit */
} Order;

static double omega_of(const Order *o, uint32_t place) {
  return o->model->body.modes[o->order->rows[place]].omega;
}

/* Whether both copies of a mode stretch the head, by the part of the modes where they stand. */
static bool stretches(const Order *o, uint32_t h, uint32_t place) {
  const TbParts *parts = &o->model->stretch.parts;
  const uint32_t last = o->order->m ? 1 : 0;
  bool found[2] = {false, false};
  for (uint32_t part = 0; part < parts->count; part++) {
    for (uint32_t copy = 0; copy <= last; copy++) {
      const uint32_t at = o->at[copy][place] - parts->from[part];
      if (at < parts->size[part] && parts->heads[part] >> h & 1u) found[copy] = true;
    }
  }
  return found[0] && found[last];
}

/* G_ij on stretching head h. */
static double term(const Order *o, uint32_t h, uint32_t i, uint32_t j) {
  const TbBodyOrder *order = o->order;
  const uint32_t head = o->model->stretch.head[h];
  const double *vectors = order->vectors[head], *edge = order->edge[head];
  const double *v = vectors + (size_t)i * order->zero_count;
  const double *w = vectors + (size_t)j * order->zero_count;
  const double azimuth = order->m ? PI : 2.0 * PI;
  double sum = 0.0;
  for (uint32_t k = 0; k < order->zero_count; k++) sum += v[k] * w[k] * o->stretch[k];
  return sum + (edge ? azimuth * order->m * edge[i] * edge[j] : 0.0);
}

/* Whether a mode mixes with another one on head h. */
static bool mixes(const Order *o, uint32_t h, uint32_t i) {
  if (!stretches(o, h, i)) return false;
  for (uint32_t j = 0; j < o->count; j++) {
    const double least = o->least[h] * omega_of(o, i) * omega_of(o, j);
    if (i != j && fabs(term(o, h, i, j)) > least && stretches(o, h, j)) return true;
  }
  return false;
}

/* Lists the modes that mix on some head, the lowest at most; returns how many. */
static uint32_t find_mixed(const Order *o, TbArena *arena, uint32_t places[TB_MIXING_MOST]) {
  uint32_t count = 0;
  for (uint32_t i = 0; i < o->count && count < TB_MIXING_MOST && tb_arena_go_on(arena); i++) {
    bool found = false;
    for (uint32_t h = 0; h < o->model->stretch.count; h++) found = found || mixes(o, h, i);
    if (found) places[count++] = i;
  }
  return count;
}

/* The terms of head h. */
static void fill_rows(const Order *o, uint32_t h, const uint32_t *places, uint32_t count,
                      double *matrix) {
  for (uint32_t i = 0; i < count; i++) {
    const uint32_t row = h * count + i;
    for (uint32_t j = 0; j < count; j++) {
      const size_t at = ((size_t)(row / 8u) * count + j) * 8u + row % 8u;
      const bool both = i != j && stretches(o, h, places[i]) && stretches(o, h, places[j]);
      matrix[at] = both ? term(o, h, places[i], places[j]) : 0.0;
    }
  }
}

static void keep_double(TbMixingBlock *block, TbArena *arena, const double *matrix, size_t count) {
  double *kept = tb_arena_doubles(arena, count);
  if (kept) memcpy(kept, matrix, count * sizeof *kept);
  block->matrix = kept;
}

static void keep_float(TbMixingBlock *block, TbArena *arena, const double *matrix, size_t count) {
  float *rounded = tb_arena_take(arena, count, sizeof *rounded);
  for (size_t i = 0; rounded && i < count; i++) rounded[i] = (float)matrix[i];
  block->rounded = rounded;
}

/* G is symmetric in either precision. */
static void (*const KEEP[])(TbMixingBlock *block, TbArena *arena, const double *matrix,
                            size_t count) = {
  [TB_IN_DOUBLE] = keep_double,
  [TB_IN_FLOAT] = keep_float,
};

static bool fill_matrix(const Order *o, TbArena *arena, const uint32_t *places,
                        TbMixingBlock *block) {
  const uint32_t heads = o->model->stretch.count;
  const size_t count = (size_t)tb_pad(heads * block->count) * block->count;
  TbArena scratch;
  tb_arena_beside(&scratch, arena);
  double *matrix = tb_arena_doubles(&scratch, count);
  for (uint32_t h = 0; matrix && h < heads && tb_arena_go_on(arena); h++) {
    fill_rows(o, h, places, block->count, matrix);
  }
  if (matrix) KEEP[o->model->precision](block, arena, matrix, count);
  tb_arena_release(&scratch);
  return !arena->failed && matrix;
}

static uint8_t part_of(const TbParts *parts, uint32_t mode) {
  uint8_t part = 0;
  while (mode >= parts->end[part]) part++; /* parts tile all modes */
  return part;
}

/* The blocks of an order, one for each copy. */
static bool add_blocks(const Order *o, TbArena *arena, TbMixing *mixing) {
  uint32_t places[TB_MIXING_MOST];
  TbMixingBlock block = {.count = find_mixed(o, arena, places)};
  if (block.count == 0) return !arena->failed;
  if (!fill_matrix(o, arena, places, &block)) return false;
  for (uint32_t copy = 0; copy < (o->order->m ? 2u : 1u); copy++) {
    uint32_t *mode = tb_arena_take(arena, block.count, sizeof *mode);
    uint8_t *part = tb_arena_take(arena, block.count, sizeof *part);
    if (!mode || !part) return false;
    for (uint32_t i = 0; i < block.count; i++) {
      mode[i] = o->at[copy][places[i]];
      part[i] = part_of(&o->model->stretch.parts, mode[i]);
    }
    block.mode = mode;
    block.part = part;
    mixing->block[mixing->count++] = block;
  }
  return !arena->failed;
}

static void find_copies(Order *o) {
  const TbModes *modes = &o->model->modes;
  for (uint32_t i = 0; i < o->order->mode_count; i++) o->at[0][i] = o->at[1][i] = TB_NO_MODE;
  for (uint32_t i = 0; i < modes->padded; i++) {
    if (modes->row[i] == TB_NO_MODE) continue;
    const TbBodyMode *mode = &o->model->body.modes[modes->row[i]];
    if (mode->m == o->order->m) o->at[modes->sine[i]][mode->place] = i;
  }
}

/* Modes of an order are sorted by frequency but for what the air outside changes: up to the first
 * that is too high, or whose copies the model has not. */
static void count_modes(Order *o, double top) {
  const uint32_t last = o->order->m ? 1 : 0;
  while (o->count < o->order->mode_count && omega_of(o, o->count) < top &&
         o->at[0][o->count] != TB_NO_MODE && o->at[last][o->count] != TB_NO_MODE) {
    o->count++;
  }
}

static bool prepare_order(Order *o, TbArena *scratch, double top) {
  const TbBodyOrder *order = o->order;
  const double azimuth = order->m ? PI : 2.0 * PI;
  for (int copy = 0; copy < 2; copy++) {
    o->at[copy] = tb_arena_take(scratch, order->mode_count + 1u, sizeof *o->at[copy]);
  }
  o->stretch = tb_arena_doubles(scratch, order->zero_count);
  if (scratch->failed) return false;
  for (uint32_t k = 0; k < order->zero_count; k++) {
    const double slope = order->zeros[k] * tb_bessel_j(order->m + 1, order->zeros[k]);
    o->stretch[k] = 0.5 * azimuth * slope * slope;
  }
  find_copies(o);
  count_modes(o, top);
  return true;
}

/* The largest G_ii/omega_i^2. */
static double softest(const TaborModel *model, const double *gain) {
  double most = 0.0;
  for (uint32_t i = 0; i < model->modes.padded; i++) {
    if (model->modes.row[i] == TB_NO_MODE) continue;
    const double omega = model->body.modes[model->modes.row[i]].omega;
    most = fmax(most, gain[i] / (omega * omega));
  }
  return most;
}

static bool prepare_orders(const TaborModel *model, TbArena *scratch, TbMixingLimits limits,
                           Order *orders) {
  const TbStretch *stretch = &model->stretch;
  double least[TB_HEADS] = {0.0};
  for (uint32_t h = 0; h < stretch->count; h++) {
    least[h] = limits.least * softest(model, stretch->gain[h]);
  }
  for (uint32_t m = 0; m < model->body.order_count; m++) {
    orders[m] =
      (Order){.model = model, .order = &model->body.orders[m], .least = {least[0], least[1]}};
    if (!prepare_order(&orders[m], scratch, limits.top)) return false;
  }
  return true;
}

static bool fill(TaborModel *model, const Order *orders) {
  const uint32_t count = model->body.order_count;
  TbMixing *mixing = &model->stretch.mixing;
  *mixing = (TbMixing){.heads = model->stretch.count};
  mixing->block = tb_arena_take(&model->arena, 2u * count + 1u, sizeof *mixing->block);
  for (uint32_t m = 0; mixing->block && m < count && mixing->heads > 0; m++) {
    if (!add_blocks(&orders[m], &model->arena, mixing)) return false;
  }
  return !model->arena.failed;
}

TaborStatus tb_stretch_mixing_prepare(TaborModel *model, TbMixingLimits limits) {
  TbArena scratch;
  tb_arena_beside(&scratch, &model->arena);
  Order *orders = tb_arena_take(&scratch, model->body.order_count + 1u, sizeof *orders);
  const bool done =
    orders && prepare_orders(model, &scratch, limits, orders) && fill(model, orders);
  tb_arena_release(&scratch);
  return done ? TABOR_OK : TABOR_ERROR_MEMORY;
}
