/* SPDX-License-Identifier: MIT */
/* Tables of a view. Set-up only. */
#include <math.h>

#include "definition/def_text.h"
#include "definition/error.h"
#include "drum/view.h"
#include "math/portable_math.h"

static const double TURN_DEGREES = 360.0, TWO_PI = 6.283185307179586;

/* ---- the grid ------------------------------------------------------------------------------- */

static TaborStatus check_count(uint32_t *value, uint32_t fallback, uint32_t least, uint32_t most,
                               const char *key, TaborError *error) {
  char text[TB_NUMBER_SIZE];
  if (*value == 0) *value = fallback;
  if (*value >= least && *value <= most) return TABOR_OK;
  tb_number_print(*value, text);
  return tb_error_set(error, TABOR_ERROR_RANGE, key, text, least, most,
                      "%s of a view: %u is outside %u to %u", key, (unsigned)*value,
                      (unsigned)least, (unsigned)most);
}

static TaborStatus check_bandwidth(double *value, TaborError *error) {
  if (*value == 0.0) *value = 1500.0;
  if (*value > 0.0) return TABOR_OK;
  return tb_error_set(error, TABOR_ERROR_RANGE, "bandwidth", NULL, 0.0, INFINITY,
                      "the bandwidth of a view is not positive");
}

static TaborStatus resolve(const TaborViewGrid *asked, TaborViewGrid *grid, TaborError *error) {
  *grid = asked ? *asked : (TaborViewGrid){0};
  TaborStatus status = check_count(&grid->radii, 16, 2, TABOR_VIEW_RADII, "radii", error);
  if (status == TABOR_OK) {
    status = check_count(&grid->angles, 48, 1, TABOR_VIEW_ANGLES, "angles", error);
  }
  if (status == TABOR_OK) {
    status = check_count(&grid->wire_points, 33, 2, TABOR_VIEW_WIRE_POINTS, "wire_points", error);
  }
  return status == TABOR_OK ? check_bandwidth(&grid->bandwidth, error) : status;
}

/* ---- heads ---------------------------------------------------------------------------------- */

static bool moves(const double *radial, uint32_t radii) {
  for (uint32_t i = 0; i < radii; i++) {
    if (radial[i] != 0.0) return true;
  }
  return false;
}

/* R of all rows of modes over the radii: table[row][radii]. */
static double *radial_table(TbViewTables *view, uint32_t which) {
  const TbBody *body = &view->model->body;
  const uint32_t radii = view->seen.radii;
  double *table = tb_arena_doubles(&view->arena, (size_t)body->row_count * radii);
  double *radial = tb_arena_doubles(&view->arena, body->row_count);
  if (view->arena.failed) return NULL;
  for (uint32_t i = 0; i < radii; i++) {
    const double r = body->radius * i / (radii - 1);
    tb_body_radial(body, which, r, NULL, radial);
    if (body->free_edge) tb_body_add_lift(body, which, r, radial);
    for (uint32_t row = 0; row < body->row_count; row++) table[row * radii + i] = radial[row];
  }
  return table;
}

static bool is_shown(const TbViewTables *view, uint32_t mode) {
  const TaborModel *model = view->model;
  const uint32_t row = model->modes.row[mode];
  return row != TB_NO_MODE && model->body.modes[row].omega <= TWO_PI * view->bandwidth;
}

/* Keeps the modes that move the head. */
static bool prepare_head(TbViewTables *view, uint32_t which) {
  const TbModes *modes = &view->model->modes;
  TbViewHead *head = &view->heads[which];
  const double *table = radial_table(view, which);
  head->modes = tb_arena_take(&view->arena, modes->count, sizeof *head->modes);
  head->displacement = tb_arena_doubles(&view->arena, (size_t)view->seen.radii * view->seen.angles);
  if (view->arena.failed) return false;
  for (uint32_t i = 0; i < modes->padded; i++) {
    if (!is_shown(view, i)) continue;
    const double *radial = table + (size_t)modes->row[i] * view->seen.radii;
    if (!moves(radial, view->seen.radii)) continue;
    const uint32_t m = view->model->body.modes[modes->row[i]].m;
    head->modes[head->count++] =
      (TbViewMode){.mode = i, .sum = 2 * m + modes->sine[i], .radial = radial};
    if (m >= view->orders) view->orders = m + 1;
  }
  view->seen.displacement[which] = head->displacement;
  return true;
}

static void prepare_turn(TbViewTables *view) {
  double c[TB_MAX_ORDERS], s[TB_MAX_ORDERS], sine, cosine;
  const uint32_t angles = view->seen.angles;
  for (uint32_t j = 0; j < angles; j++) {
    tb_sin_cos_degrees(TURN_DEGREES * j / angles - view->model->axis, &sine, &cosine);
    tb_angular_factors(view->orders, sine, cosine, c, s);
    for (uint32_t m = 0; m < view->orders; m++) {
      view->turn[(2 * m) * angles + j] = c[m];
      view->turn[(2 * m + 1) * angles + j] = s[m];
    }
  }
}

static bool prepare_heads(TbViewTables *view) {
  const TaborModel *model = view->model;
  for (uint32_t h = 0; h < model->body.surfaces; h++) {
    if (!prepare_head(view, h)) return false;
  }
  for (uint32_t i = 0; i < model->modes.padded; i++) view->seen.mode_count += is_shown(view, i);
  view->turn = tb_arena_doubles(&view->arena, 2 * (size_t)view->orders * view->seen.angles);
  view->sums = tb_arena_doubles(&view->arena, 2 * (size_t)view->orders * view->seen.radii);
  if (view->arena.failed) return false;
  if (view->orders > 0) prepare_turn(view);
  return true;
}

/* ---- wires ---------------------------------------------------------------------------------- */

/* A wire's middle and steps count from the direction of the wires. */
static void place_wire(TbViewTables *view, uint32_t w) {
  const TbWire *wire = &view->model->wires.wires[w];
  double *ends = view->wire_ends + 4 * (size_t)w, sine, cosine;
  tb_sin_cos_degrees(view->model->def.wires.angle, &sine, &cosine);
  for (uint32_t end = 0; end < 2; end++) {
    const double steps = (end == 0 ? -0.5 : 0.5) * wire->cells;
    const double x = wire->x + steps * wire->dx, y = wire->y + steps * wire->dy;
    ends[2 * end] = x * cosine - y * sine;
    ends[2 * end + 1] = x * sine + y * cosine;
  }
}

static bool prepare_wires(TbViewTables *view) {
  const size_t count = view->seen.wire_count, points = view->seen.wire_points;
  view->wires = tb_arena_doubles(&view->arena, count * points);
  view->contact = tb_arena_doubles(&view->arena, count * points);
  view->wire_ends = tb_arena_doubles(&view->arena, 4 * count);
  if (view->arena.failed) return false;
  for (uint32_t w = 0; w < count; w++) place_wire(view, w);
  view->seen.wires = view->wires;
  view->seen.wire_force = view->contact;
  view->seen.wire_place = view->wire_ends;
  return true;
}

/* ---- public --------------------------------------------------------------------------------- */

static TaborStatus memory_error(TaborError *error) {
  return tb_error_set(error, TABOR_ERROR_MEMORY, NULL, NULL, NAN, NAN,
                      "out of memory while creating a view");
}

TaborStatus tabor_view_create(TaborModel *model, const TaborViewGrid *asked, TaborView **out,
                              TaborError *error) {
  TaborViewGrid grid;
  if (!out) return tb_error_null(error, "place for the view");
  *out = NULL;
  if (!model) return tb_error_null(error, "model");
  const TaborStatus status = resolve(asked, &grid, error);
  if (status != TABOR_OK) return status;
  const TaborAllocator allocator = model->arena.allocator;
  TbViewTables *view = allocator.allocate(sizeof *view, allocator.context);
  if (!view) return memory_error(error);
  *view = (TbViewTables){.model = tabor_model_retain(model),
                         .bandwidth = grid.bandwidth,
                         .seen = {.heads = model->body.surfaces,
                                  .radii = grid.radii,
                                  .angles = grid.angles,
                                  .wire_count = model->def.wires.count,
                                  .wire_points = model->def.wires.count ? grid.wire_points : 0,
                                  .radius = model->body.radius,
                                  .bandwidth = fmin(grid.bandwidth, model->body.bandwidth)}};
  tb_arena_prepare(&view->arena, &allocator);
  if (!prepare_heads(view) || !prepare_wires(view)) {
    tabor_view_destroy(&view->seen);
    return memory_error(error);
  }
  *out = &view->seen;
  return TABOR_OK;
}

void tabor_view_destroy(TaborView *seen) {
  if (!seen) return;
  TbViewTables *view = (TbViewTables *)seen;
  const TaborAllocator allocator = view->arena.allocator;
  tb_arena_release(&view->arena);
  tabor_model_release(view->model);
  allocator.release(view, allocator.context);
}
