/* SPDX-License-Identifier: MIT */
#include "model/stretch_gain.h"

#include <math.h>

static const double PI = 3.14159265358979323846;

/* Modes up to this many times the lowest frequency count, at every quality: at live these are all
 * of a drum's two-way modes. Half as many change third octaves of a bass drum by up to 6 dB, of
 * toms by up to 0.8 dB. */
static const double TOP = 96.0;

/* How many modes from `from` on, before `end`, hold all that count. */
static uint32_t below(const TaborModel *model, double top, uint32_t from, uint32_t end) {
  const uint32_t *row = model->modes.row;
  uint32_t size = 0;
  for (uint32_t i = from; i < end; i++) {
    if (row[i] != TB_NO_MODE && model->body.modes[row[i]].omega < top) size = i - from + 1u;
  }
  return tb_pad(size);
}

static void add_part(TaborModel *model, double top, double top_mixed, uint32_t from, uint32_t end,
                     uint32_t heads, uint32_t kin) {
  TbParts *parts = &model->stretch.parts;
  const uint32_t size = heads ? below(model, top, from, end) : 0u;
  const uint32_t mixed = below(model, top_mixed, from, end);
  parts->from[parts->count] = from;
  parts->size[parts->count] = size;
  parts->end[parts->count] = end;
  parts->mixed[parts->count] = mixed < size ? mixed : size;
  parts->kin[parts->count] = kin;
  parts->heads[parts->count++] = heads;
}

/* Bits of the heads that stretch, of the heads that modes move. */
static uint32_t stretching(const TaborModel *model, bool batter, bool resonant) {
  const bool moves[TB_HEADS] = {batter, resonant};
  uint32_t bits = 0;
  for (uint32_t i = 0; i < model->stretch.count; i++) {
    if (moves[model->stretch.head[i]]) bits |= 1u << i;
  }
  return bits;
}

/* The groups that wires feel, then the sections of the others. */
static void prepare_parts(TaborModel *model, TbStretchExtent extent) {
  const double top = extent.times * tb_body_lowest(&model->body), mixed = extent.mixing.top;
  const TbModes *modes = &model->modes;
  const uint32_t all = stretching(model, true, true);
  const uint32_t heads[TB_MODE_RUNS] = {all, stretching(model, true, false),
                                        stretching(model, false, true)};
  model->stretch.parts.count = 0;
  for (uint32_t group = 0; group < modes->groups; group++) {
    add_part(model, top, mixed, modes->group[group], modes->group[group + 1], all, 0);
  }
  for (uint32_t section = 0; section < TB_MODE_SECTIONS; section++) {
    const uint32_t from = modes->section[section], end = modes->section[section + 1];
    if (end > from) add_part(model, top, mixed, from, end, heads[section / 3u], section % 3u);
  }
}

/* Leaves out what lies in the run of the other head alone. */
static void list_felt(TbStretch *stretch, const TbModes *modes, uint32_t head) {
  const TbParts *all = &stretch->parts;
  const uint32_t other = head == 0 ? 2 : 1;
  TbParts *felt = &stretch->felt[head];
  felt->count = 0;
  for (uint32_t part = 0; part < all->count; part++) {
    const uint32_t from = all->from[part];
    if (from >= modes->run[other] && from < modes->run[other + 1u]) continue;
    felt->from[felt->count] = from;
    felt->size[felt->count] = all->size[part];
    felt->mixed[felt->count] = all->mixed[part];
    felt->end[felt->count] = all->end[part];
    felt->kin[felt->count] = all->kin[part];
    felt->heads[felt->count++] = all->heads[part];
  }
}

/* Padding of a part counts no more than what lies behind it. */
static void fill_gain(const TaborModel *model, uint32_t which, double top, double *gain) {
  const TbStretch *stretch = &model->stretch;
  for (uint32_t part = 0; part < stretch->parts.count; part++) {
    const uint32_t from = stretch->parts.from[part];
    if (!(stretch->parts.heads[part] >> which & 1u)) continue;
    for (uint32_t i = from; i < from + stretch->parts.size[part]; i++) {
      const uint32_t row = model->modes.row[i];
      if (row == TB_NO_MODE || model->body.modes[row].omega >= top) continue;
      gain[i] = tb_body_slope_square(&model->body, stretch->head[which], &model->body.modes[row]);
    }
  }
}

/* A tension that is higher by this part raises the pitch by 0.4 cents, which nobody hears: of tones
 * of 100 to 1,000 Hz listeners tell 3 to 5 cents apart [Moore1973]. */
static const double LEAST_RISE = 5e-4;
/* More than half a period of any head, within which its rise vanishes once [s]. */
static const double HOLD[] = {[TB_IN_DOUBLE] = INFINITY, [TB_IN_FLOAT] = 0.02};

static void prepare_hold(TaborModel *model) {
  TbStretch *stretch = &model->stretch;
  const TaborHeadDef *const sheet = model->body.sheet;
  const double steps = HOLD[model->precision] * model->step_rate;
  stretch->hold = steps < UINT32_MAX ? (uint32_t)steps : UINT32_MAX;
  for (uint32_t i = 0; i < stretch->count; i++) {
    stretch->least[i] = LEAST_RISE * sheet[stretch->head[i]].tension;
  }
}

/* Large deflections of a plate are a coupling as the stretch of a head is, W = 1/(4 + Y^T g Y) of
 * heads/stretch.h, without a diagonal G. */
static TaborStatus prepare_plate(TaborModel *model) {
  const double top = model->body.membrane.top;
  const TbStretchExtent all = {top / tb_body_lowest(&model->body), {.least = 0.0, .top = top}};
  TbStretch *stretch = &model->stretch;
  stretch->count = 1;
  stretch->factor[0] = 0.5;
  stretch->hold = UINT32_MAX;
  prepare_parts(model, all);
  for (uint32_t h = 0; h < TB_HEADS; h++) list_felt(stretch, &model->modes, h);
  stretch->gain[0] = tb_arena_doubles(&model->arena, model->modes.padded);
  return stretch->gain[0] ? TABOR_OK : TABOR_ERROR_MEMORY;
}

TaborStatus tb_stretch_prepare(TaborModel *model) {
  if (model->plate.tables.pairs > 0) return prepare_plate(model);
  const TbStretchExtent usual = {TOP, tb_mixing_limits(model)};
  return tb_stretch_prepare_to(model, usual);
}

TaborStatus tb_stretch_prepare_to(TaborModel *model, TbStretchExtent extent) {
  const TaborHeadDef *const sheet = model->body.sheet;
  const double area = PI * model->body.radius * model->body.radius;
  TbStretch *stretch = &model->stretch;
  stretch->count = 0;
  for (uint32_t h = 0; h < model->body.surfaces; h++) {
    if (sheet[h].stretch_stiffness == 0.0) continue;
    stretch->head[stretch->count] = h;
    stretch->factor[stretch->count++] = 0.5 * sheet[h].stretch_stiffness / area;
  }
  prepare_parts(model, extent);
  for (uint32_t h = 0; h < TB_HEADS; h++) list_felt(stretch, &model->modes, h);
  prepare_hold(model);
  for (uint32_t i = 0; i < stretch->count; i++) {
    stretch->gain[i] = tb_arena_doubles(&model->arena, model->modes.padded);
    if (!stretch->gain[i]) return TABOR_ERROR_MEMORY;
    fill_gain(model, i, extent.times * tb_body_lowest(&model->body), stretch->gain[i]);
  }
  return tb_stretch_mixing_prepare(model, extent.mixing);
}
