/* SPDX-License-Identifier: MIT */
#include "stretch.h"

#include <string.h>

#include "bessel.h"

static const double PI = 3.14159265358979323846;

/* ---- set-up --------------------------------------------------------------------------------- */

/* Int |grad w|^2 dA of one mode on head `which`, of its cosine as of its sine copy:
 * Sum_i v_i^2 K_i^2 a_m R^2 J_{m+1}(z_i)^2/2. */
static double slope_square(const TbHead *head, uint32_t which, const TbHeadMode *mode) {
  const TbHeadOrder *order = &head->orders[mode->m];
  const double *v = order->vectors[which] + (size_t)mode->place * order->zero_count;
  const double azimuth = mode->m ? PI : 2.0 * PI;
  double sum = 0.0;
  for (uint32_t i = 0; i < order->zero_count; i++) {
    const double slope = order->zeros[i] * tb_bessel_j(mode->m + 1, order->zeros[i]);
    sum += v[i] * v[i] * slope * slope;
  }
  return 0.5 * azimuth * sum;
}

/* Modes up to this many times the lowest frequency count. Twice as many raise a tom's peak at 12 m/s by
 * 1.7 dB from 12 on, by 0.3 dB from 24 on. */
static double top_of(uint32_t quality) { return quality <= TABOR_QUALITY_LIVE ? 12.0 : 24.0; }

/* Each group lists its modes by frequency, so those that count stand at its beginning. */
static void prepare_ranges(TaborModel *model) {
  const TbModes *modes = &model->modes;
  TbStretch *stretch = &model->stretch;
  const double top = top_of(model->quality) * model->head.modes[0].omega;
  for (uint32_t group = 0; group <= modes->groups; group++) {
    const uint32_t end = group < modes->groups ? modes->group[group + 1] : modes->padded;
    uint32_t i = modes->group[group];
    stretch->from[group] = i;
    while (i < end && modes->row[i] != TB_NO_MODE && model->head.modes[modes->row[i]].omega < top) {
      i++;
    }
    stretch->size[group] = tb_pad(i - modes->group[group]);
  }
}

static void fill_gain(const TaborModel *model, uint32_t which, double *gain) {
  for (uint32_t group = 0; group <= model->modes.groups; group++) {
    const uint32_t from = model->stretch.from[group];
    for (uint32_t i = from; i < from + model->stretch.size[group]; i++) {
      const uint32_t row = model->modes.row[i];
      if (row != TB_NO_MODE) gain[i] = slope_square(&model->head, which, &model->head.modes[row]);
    }
  }
}

/* The part of a group's table that belongs to these modes, signed as penetrations are, in the same
 * precision. */
static bool copy_table(TaborModel *model, uint32_t g) {
  const TbProjectionGroup *group = &model->projection.group[g];
  TbProjectionGroup *part = &model->stretch.projection.group[g];
  *part = (TbProjectionGroup){.first = model->stretch.from[g],
                              .modes = model->stretch.size[g],
                              .first_point = group->first_point,
                              .points = group->points};
  const size_t count = (size_t)part->points * part->modes, row = 8u * (size_t)part->modes;
  if (group->gather_single) {
    part->gather_single = tb_arena_take(&model->arena, count, sizeof *part->gather_single);
  } else {
    part->gather = tb_arena_doubles(&model->arena, count);
  }
  if (model->arena.failed) return false;
  for (size_t i = 0; i < count; i++) {
    const double value = model->wires.side * group->gather[i / row * group->modes * 8u + i % row];
    if (part->gather_single) part->gather_single[i] = (float)value;
    if (part->gather) part->gather[i] = value;
  }
  return true;
}

static bool copy_tables(TaborModel *model) {
  model->stretch.projection.groups = model->projection.groups;
  for (uint32_t g = 0; g < model->projection.groups; g++) {
    if (!copy_table(model, g)) return false;
  }
  return true;
}

TaborStatus tb_stretch_prepare(TaborModel *model) {
  const TaborHeadDef *const heads[TB_HEADS] = {&model->def.batter, &model->def.resonant};
  const double area = PI * model->head.radius * model->head.radius;
  TbStretch *stretch = &model->stretch;
  prepare_ranges(model);
  for (uint32_t h = 0; h < model->head.heads; h++) {
    if (heads[h]->stretch_stiffness == 0.0) continue;
    double *gain = tb_arena_doubles(&model->arena, model->modes.padded);
    double *pull = tb_arena_doubles(&model->arena, model->modes.padded);
    if (!gain || !pull) return TABOR_ERROR_MEMORY;
    fill_gain(model, h, gain);
    for (uint32_t i = 0; i < model->modes.padded; i++) pull[i] = model->modes.g[i] * gain[i];
    stretch->gain[stretch->count] = gain;
    stretch->pull[stretch->count] = pull;
    stretch->factor[stretch->count++] = 0.5 * heads[h]->stretch_stiffness / area;
  }
  if (stretch->count > 0 && !copy_tables(model)) return TABOR_ERROR_MEMORY;
  return TABOR_OK;
}

/* ---- step ----------------------------------------------------------------------------------- */

/* S2 = (1 + A P/2)^-1 for symmetric A = Y^T g Y. */
static void invert(uint32_t count, double a[2][2], const double *factor, double s2[2][2]) {
  double n[2][2] = {{1.0, 0.0}, {0.0, 1.0}};
  for (uint32_t h = 0; h < count; h++) {
    for (uint32_t l = 0; l < count; l++) n[h][l] += 0.5 * a[h][l] * factor[l];
  }
  const double determinant = n[0][0] * n[1][1] - n[0][1] * n[1][0];
  s2[0][0] = n[1][1] / determinant;
  s2[0][1] = -n[0][1] / determinant;
  s2[1][0] = -n[1][0] / determinant;
  s2[1][1] = n[0][0] / determinant;
}

/* Sum x y over the modes that count. */
static double dot(const TaborModel *model, const double *x, const double *y) {
  double sum = 0.0;
  for (uint32_t group = 0; group <= model->modes.groups; group++) {
    const uint32_t from = model->stretch.from[group];
    sum += model->kernels->dot(model->stretch.size[group], x + from, y + from);
  }
  return sum;
}

/* y = G q, and what it pulls at the modes, g y. */
static void prepare_shapes(TbView *view) {
  const TbStretch *stretch = &view->model->stretch;
  const TbKernels *kernels = view->model->kernels;
  for (uint32_t group = 0; group <= view->model->modes.groups; group++) {
    const uint32_t from = stretch->from[group], size = stretch->size[group];
    const double *q = view->now.q + from;
    for (uint32_t h = 0; h < stretch->count; h++) {
      kernels->product(size, view->stretch_y[h] + from, stretch->gain[h] + from, q);
      kernels->product(size, view->stretch_pull[h] + from, stretch->pull[h] + from, q);
    }
  }
}

/* theta = S2 t/2; takes what it pulls from next.q. */
static void apply(TbView *view, const double t[2]) {
  const TaborModel *model = view->model;
  const TbStretch *stretch = &model->stretch;
  for (uint32_t h = 0; h < stretch->count; h++) {
    const double theta = 0.5 * (view->stretch_s2[h][0] * t[0] + view->stretch_s2[h][1] * t[1]);
    for (uint32_t group = 0; group <= model->modes.groups; group++) {
      const uint32_t from = stretch->from[group];
      model->kernels->add_scaled(stretch->size[group], view->next.q + from,
                                 -theta * stretch->factor[h], view->stretch_pull[h] + from);
    }
  }
}

/* r = Y^T g Phi, Phi signed as penetrations are: on the grid under the wires, and at the slots. */
static void prepare_rows(TbView *view) {
  const TaborModel *model = view->model;
  for (uint32_t h = 0; h < model->stretch.count; h++) {
    if (!view->state->lifted) {
      tb_project(&model->stretch.projection, model->kernels, view->stretch_pull[h],
                 view->solve.stretch_grid[h]);
    }
    for (uint32_t slot = 0; slot < TB_SLOTS; slot++) {
      double *r = &view->solve.stretch_slots[h][slot];
      *r = 0.0;
      if (view->state->slots[slot].kind == TB_SLOT_FREE) continue;
      *r = dot(model, tb_slot_drive(view, slot), view->stretch_y[h]);
    }
  }
}

void tb_stretch_free(TbView *view) {
  const TaborModel *model = view->model;
  const TbStretch *stretch = &model->stretch;
  view->solve.stretch_count = stretch->count;
  if (stretch->count == 0) return;
  prepare_shapes(view);
  double a[2][2] = {{0.0}}, t[2] = {0.0};
  for (uint32_t h = 0; h < stretch->count; h++) {
    for (uint32_t l = 0; l < stretch->count; l++) {
      a[h][l] = dot(model, view->stretch_y[h], view->stretch_pull[l]);
    }
    t[h] =
      dot(model, view->stretch_y[h], view->next.q) + dot(model, view->stretch_y[h], view->last.q);
  }
  invert(stretch->count, a, stretch->factor, view->stretch_s2);
  for (uint32_t h = 0; h < stretch->count; h++) {
    for (uint32_t l = 0; l < stretch->count; l++) {
      view->solve.stretch_weight[h][l] = 0.5 * stretch->factor[h] * view->stretch_s2[h][l];
    }
  }
  apply(view, t);
  for (uint32_t h = 0; h < stretch->count; h++) {
    view->stretch_free[h] = dot(model, view->stretch_y[h], view->next.q);
  }
  prepare_rows(view);
}

void tb_stretch_rest_load(TbView *view, double *slots) {
  static const _Alignas(64) double none[TB_SLOTS] = {0.0};
  const TaborModel *model = view->model;
  TbSolve *solve = &view->solve;
  for (uint32_t i = 0; i < TB_SLOTS; i++) slots[i] = 0.0;
  if (solve->stretch_count == 0 || model->wires.count == 0 || view->state->lifted) return;
  const uint32_t size = model->projection.bed.size;
  for (uint32_t i = 0; i < size; i++) solve->answer[i] = 0.0;
  tb_solve_stretch(solve, model->rest.grid, none, solve->answer, slots);
  model->kernels->add_scaled(size, view->change, model->wires.side, solve->answer);
}

static void take_stretch(TbView *view, double *carry) {
  const TbSolve *solve = &view->solve;
  tb_solve_stretch(solve, solve->grid, solve->force + solve->stride, carry,
                   carry + solve->bed->size);
}

void tb_stretch_renew(TbView *view) {
  TbSolve *solve = &view->solve;
  if (solve->stretch_count == 0 || view->state->airborne) return;
  const uint32_t size = solve->bed->size;
  double *carry = view->stretch_carry, *rows = solve->work;
  take_stretch(view, carry);
  if (!view->state->lifted) {
    tb_bed_expand(solve->bed, solve->kernels, carry, solve->scratch, rows);
    solve->kernels->add_scaled(solve->stride, solve->product, 1.0, rows);
  }
  solve->kernels->add_scaled(TB_SLOTS, solve->product + solve->stride, 1.0, carry + size);
}

void tb_stretch_respond(TbView *view) {
  const TaborModel *model = view->model;
  if (model->stretch.count == 0) return;
  double t[2] = {0.0};
  for (uint32_t h = 0; h < model->stretch.count; h++) {
    t[h] = dot(model, view->stretch_y[h], view->next.q) - view->stretch_free[h];
  }
  apply(view, t);
  tb_stretch_clear(view);
  take_stretch(view, view->stretch_carry);
  const uint32_t size = model->projection.bed.size + TB_SLOTS;
  for (uint32_t i = 0; i < size; i++) view->stretch_carry[i] = -view->stretch_carry[i];
  view->solve.stretch_count = 0; /* it belongs to this sample alone */
}

void tb_stretch_clear(TbView *view) {
  memset(view->stretch_carry, 0,
         (view->model->projection.bed.size + TB_SLOTS) * sizeof *view->stretch_carry);
}

double tb_stretch_energy(const TbView *view, const double *next, const double *now) {
  const TbStretch *stretch = &view->model->stretch;
  double sum = 0.0;
  for (uint32_t h = 0; h < stretch->count; h++) {
    double square = 0.0;
    for (uint32_t group = 0; group <= view->model->modes.groups; group++) {
      const uint32_t from = stretch->from[group], to = from + stretch->size[group];
      for (uint32_t i = from; i < to; i++) square += stretch->gain[h][i] * next[i] * now[i];
    }
    sum += 0.25 * stretch->factor[h] * square * square;
  }
  return sum;
}
