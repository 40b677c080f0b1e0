/* SPDX-License-Identifier: MIT */
/* Set-up of the grid under the bed of wires: shapes of all modes at the contact points, the
 * principal components of these shapes across and along, and the modes' tables on these
 * components. */
#include <math.h>
#include <string.h>

#include "math/eigen.h"
#include "model/projection.h"
#include "model/rim_waves.h"

/* Thinning along must leave at most this part of the lanes to be worth its two multiplications. */
static const double WORTH_THINNING = 0.75;

typedef struct Fit {
  TbProjection *projection;
  const TbModes *modes;
  const TbBody *body;
  const TbWires *wires;
  TbArena *arena, *scratch;
  double tolerance;
  uint32_t modes_coupled;
  double *shapes;  /* [coupled mode][wire][half lane] */
  double *lines;   /* [coupled mode][line of its class][half lane] */
  uint32_t stride; /* doubles of a mode in both */
} Fit;

/* ---- shapes --------------------------------------------------------------------------------- */

static bool shapes_at(const Fit *fit, uint32_t row, double *radial, double *shape) {
  const double x = fit->wires->row_x[row], y = fit->wires->row_y[row], r = sqrt(x * x + y * y);
  const bool beside = r >= fit->body->radius; /* the head: nothing moves, nothing touches */
  if (fit->wires->rims ? fit->wires->real[row] == 0.0 : beside) return false;
  tb_modes_shape_at(fit->modes, fit->body, fit->wires, row, radial, shape);
  return true;
}

static bool collect_shapes(Fit *fit) {
  const TbWireGrid *wire_grid = &fit->projection->wire_grid;
  double *radial = tb_arena_doubles(fit->scratch, fit->body->row_count);
  double *shape = tb_arena_doubles(fit->scratch, fit->modes->padded);
  fit->shapes = tb_arena_doubles(fit->scratch, (size_t)fit->modes_coupled * fit->stride);
  fit->lines = tb_arena_doubles(fit->scratch, (size_t)fit->modes_coupled * fit->stride);
  if (fit->scratch->failed) return false;
  const uint32_t lanes = wire_grid->halves == 2 ? wire_grid->middle + 1 : wire_grid->lanes;
  for (uint32_t w = 0; w < wire_grid->wires; w++) {
    const uint32_t image = wire_grid->wires - 1 - w;
    for (uint32_t j = 0; j < lanes; j++) {
      const double part = (w + (double)j / lanes) / wire_grid->wires;
      if (!tb_arena_go_on_at(fit->scratch, 0.3 * part)) return false;
      if (wire_grid->quarters == 2 && image < w) { /* the same bits as its image */
        for (uint32_t i = 0; i < fit->modes_coupled; i++) {
          double *at = fit->shapes + (size_t)i * fit->stride + j;
          const double sign = fit->modes->sine[i] ? -1.0 : 1.0;
          at[w * wire_grid->half] = sign * at[image * wire_grid->half];
        }
        continue;
      }
      if (!shapes_at(fit, w * wire_grid->lanes + j, radial, shape)) continue;
      for (uint32_t i = 0; i < fit->modes_coupled; i++) {
        fit->shapes[(size_t)i * fit->stride + w * wire_grid->half + j] = shape[i];
      }
    }
  }
  return true;
}

/* ---- principal components ------------------------------------------------------------------- */

/* Vectors of `length` at data[m * stride + v * step + k * spread], m < modes, v < vectors. */
typedef struct Samples {
  const double *data;
  uint32_t modes, vectors, length;
  size_t stride, step, spread;
} Samples;

static double sample(const Samples *s, uint32_t m, uint32_t v, uint32_t k) {
  return s->data[m * s->stride + v * s->step + k * s->spread];
}

static void gram(TbArena *watched, const Samples *s, const double *weight, double *matrix) {
  const uint32_t n = s->length;
  for (uint32_t m = 0; m < s->modes && tb_arena_go_on(watched); m++) {
    for (uint32_t v = 0; v < s->vectors; v++) {
      for (uint32_t i = 0; i < n; i++) {
        const double x = weight[i] * sample(s, m, v, i);
        for (uint32_t j = 0; j <= i; j++) matrix[i * n + j] += x * weight[j] * sample(s, m, v, j);
      }
    }
  }
  for (uint32_t i = 0; i < n; i++) {
    for (uint32_t j = 0; j < i; j++) matrix[j * n + i] = matrix[i * n + j];
  }
}

/* Largest element of what the components leave of one sample. */
static double remainder_of(const Samples *s, uint32_t m, uint32_t v, const double *weight,
                           const double *basis, uint32_t components) {
  const uint32_t n = s->length;
  double rest[1024], worst = 0.0;
  for (uint32_t i = 0; i < n; i++) rest[i] = weight[i] * sample(s, m, v, i);
  for (uint32_t c = 0; c < components; c++) {
    double part = 0.0;
    for (uint32_t i = 0; i < n; i++) part += basis[c * n + i] * rest[i];
    for (uint32_t i = 0; i < n; i++) rest[i] -= part * basis[c * n + i];
  }
  for (uint32_t i = 0; i < n; i++) worst = fmax(worst, fabs(rest[i]) / weight[i]);
  return worst;
}

/* Whether the components leave at most `error` of every sample. The last modes, which have the
 * finest shapes, are the first to fail. */
static bool suffice(TbArena *watched, const Samples *s, const double *weight, const double *basis,
                    uint32_t components, double error) {
  for (uint32_t m = s->modes; m-- > 0 && tb_arena_go_on(watched);) {
    for (uint32_t v = 0; v < s->vectors; v++) {
      if (!(remainder_of(s, m, v, weight, basis, components) <= error)) return false;
    }
  }
  return true;
}

/* All n orthonormal components, largest first, basis[component][n]. */
static bool all_components(TbArena *scratch, const Samples *s, const double *weight,
                           double *basis) {
  const uint32_t n = s->length;
  double *matrix = tb_arena_doubles(scratch, (size_t)n * n);
  double *values = tb_arena_doubles(scratch, n);
  double *vectors = tb_arena_doubles(scratch, (size_t)n * n);
  if (scratch->failed) return false;
  gram(scratch, s, weight, matrix);
  if (!tb_eigen_symmetric(scratch, n, matrix, NULL, values, vectors)) return false;
  for (uint32_t c = 0; c < n; c++) {
    memcpy(basis + (size_t)c * n, vectors + (size_t)(n - 1 - c) * n, n * sizeof *basis);
  }
  return true;
}

/* The fewest components that leave at most `error` of any sample; at most `most`. weight[] > 0. */
static bool principal_components(TbArena *scratch, const Samples *s, const double *weight,
                                 double error, uint32_t most, double *basis, uint32_t *components) {
  if (!all_components(scratch, s, weight, basis)) return false;
  uint32_t low = 0, high = most;
  while (low < high) { /* the remainder falls with their number */
    const uint32_t count = (low + high) / 2;
    if (suffice(scratch, s, weight, basis, count, error)) {
      high = count;
    } else {
      low = count + 1;
    }
  }
  *components = low;
  return !scratch->failed;
}

/* ---- across --------------------------------------------------------------------------------- */

static double largest_shape(const Fit *fit) {
  double most = 0.0;
  for (uint32_t mode = 0; mode < fit->modes_coupled && tb_arena_go_on(fit->scratch); mode++) {
    const double *shape = fit->shapes + (size_t)mode * fit->stride;
    for (uint32_t i = 0; i < fit->stride; i++) most = fmax(most, fabs(shape[i]));
  }
  return most;
}

/* Modes even or odd across, gathered from the groups into one run. */
static uint32_t gather_modes(const Fit *fit, const double *from, uint32_t across, uint32_t along,
                             double *to) {
  const TbModes *modes = fit->modes;
  const uint32_t quarters = modes->quarters;
  uint32_t count = 0;
  for (uint32_t g = 0; g < modes->groups; g++) {
    if (across < 2 && g % quarters != across) continue;
    if (along < 2 && g / quarters != along) continue;
    for (uint32_t i = modes->group[g]; i < modes->group[g + 1] && tb_arena_go_on(fit->scratch);
         i++) {
      memcpy(to + (size_t)count++ * fit->stride, from + (size_t)i * fit->stride,
             fit->stride * sizeof *to);
    }
  }
  return count;
}

static bool fit_across_class(Fit *fit, uint32_t across, double *work, double *basis) {
  TbWireGrid *wire_grid = &fit->projection->wire_grid;
  double weight[TABOR_MAX_WIRES];
  for (uint32_t w = 0; w < wire_grid->wires; w++) weight[w] = 1.0;
  const Samples samples = {.data = work,
                           .modes = gather_modes(fit, fit->shapes, across, 2, work),
                           .vectors = wire_grid->half,
                           .length = wire_grid->wires,
                           .stride = fit->stride,
                           .step = 1,
                           .spread = wire_grid->half};
  uint32_t most = wire_grid->wires;
  if (wire_grid->quarters == 2) most = across ? wire_grid->wires / 2 : (wire_grid->wires + 1) / 2;
  uint32_t count;
  if (!principal_components(fit->scratch, &samples, weight, fit->tolerance * largest_shape(fit),
                            most, basis + (size_t)wire_grid->lines * wire_grid->wires, &count)) {
    return false;
  }
  wire_grid->lines += count;
  wire_grid->first_line[across + 1] = wire_grid->lines;
  return true;
}

static void each_wire_its_line(TbWireGrid *wire_grid, double *basis) {
  memset(basis, 0, (size_t)wire_grid->wires * wire_grid->wires * sizeof *basis);
  for (uint32_t w = 0; w < wire_grid->wires; w++) basis[w * wire_grid->wires + w] = 1.0;
  wire_grid->lines = wire_grid->first_line[1] = wire_grid->first_line[2] = wire_grid->wires;
}

static bool fit_across(Fit *fit) {
  TbWireGrid *wire_grid = &fit->projection->wire_grid;
  const uint32_t n = wire_grid->wires;
  if (n == 0) return true;
  double *basis = tb_arena_doubles(fit->scratch, (size_t)3 * n * n);
  double *work = tb_arena_doubles(fit->scratch, (size_t)fit->modes_coupled * fit->stride);
  if (fit->scratch->failed) return false;
  if (fit->wires->aligned && n > 1) {
    for (uint32_t across = 0; across < wire_grid->quarters; across++) {
      if (!fit_across_class(fit, across, work, basis)) return false;
    }
  }
  if (wire_grid->quarters == 1 && (wire_grid->lines == 0 || wire_grid->lines == n))
    each_wire_its_line(wire_grid, basis);
  wire_grid->across = tb_arena_doubles(fit->arena, (size_t)n * wire_grid->lines);
  if (fit->arena->failed) return false;
  for (uint32_t w = 0; w < n; w++) {
    for (uint32_t l = 0; l < wire_grid->lines; l++) {
      /* Images to the bit: what the eigenvectors are up to rounding. */
      const double image =
        l < wire_grid->first_line[1] ? basis[l * n + n - 1 - w] : -basis[l * n + n - 1 - w];
      const double own = basis[l * n + w];
      wire_grid->across[w * wire_grid->lines + l] =
        wire_grid->quarters == 2 ? 0.5 * (own + image) : own;
    }
  }
  return true;
}

static uint32_t lines_of_class(const TbWireGrid *wire_grid, uint32_t across) {
  return wire_grid->first_line[across + 1] - wire_grid->first_line[across];
}

/* Every mode's amplitudes on the lines of its class. */
static void shapes_on_lines(Fit *fit) {
  const TbWireGrid *wire_grid = &fit->projection->wire_grid;
  for (uint32_t g = 0; g < fit->modes->groups; g++) {
    const uint32_t across = g % wire_grid->quarters;
    for (uint32_t i = fit->modes->group[g]; i < fit->modes->group[g + 1]; i++) {
      if (!tb_arena_go_on(fit->scratch)) return;
      double *to = fit->lines + (size_t)i * fit->stride;
      const double *from = fit->shapes + (size_t)i * fit->stride;
      for (uint32_t l = 0; l < lines_of_class(wire_grid, across); l++) {
        for (uint32_t w = 0; w < wire_grid->wires; w++) {
          const double part =
            wire_grid->across[w * wire_grid->lines + wire_grid->first_line[across] + l];
          for (uint32_t j = 0; j < wire_grid->half; j++) {
            to[l * wire_grid->half + j] += part * from[w * wire_grid->half + j];
          }
        }
      }
    }
  }
}

/* ---- along ---------------------------------------------------------------------------------- */

/* A folded lane off the middle stands for two. */
static double lane_weight(const TbWireGrid *wire_grid, uint32_t j) {
  return wire_grid->halves == 1 || j == wire_grid->middle ? 1.0 : sqrt(2.0);
}

static void lane_weights(const TbWireGrid *wire_grid, double *weight) {
  for (uint32_t j = 0; j < wire_grid->half; j++) weight[j] = lane_weight(wire_grid, j);
}

/* A wire's row of `across` has norm 1 at most, so an error on the lines grows no larger on the
 * wires. */
static bool fit_along_class(Fit *fit, uint32_t along, double *work, double *basis) {
  TbWireGrid *wire_grid = &fit->projection->wire_grid;
  double weight[1024];
  lane_weights(wire_grid, weight);
  const Samples samples = {.data = work,
                           .modes = gather_modes(fit, fit->lines, 2, along, work),
                           .vectors = wire_grid->lines < wire_grid->wires ? wire_grid->lines
                                                                          : wire_grid->wires,
                           .length = wire_grid->half,
                           .stride = fit->stride,
                           .step = wire_grid->half,
                           .spread = 1};
  return principal_components(fit->scratch, &samples, weight, fit->tolerance * largest_shape(fit),
                              wire_grid->half, basis, &wire_grid->columns[along]);
}

static bool fill_along(Fit *fit, uint32_t along, const double *basis) {
  TbWireGrid *wire_grid = &fit->projection->wire_grid;
  const uint32_t columns = wire_grid->columns[along], half = wire_grid->half;
  double weight[1024];
  lane_weights(wire_grid, weight);
  const uint32_t padded = tb_pad(columns);
  double *contract = tb_arena_doubles(fit->arena, (size_t)half * padded);
  double *expand = tb_arena_doubles(fit->arena, (size_t)columns * half);
  if (fit->arena->failed) return false;
  for (uint32_t a = 0; a < columns; a++) {
    for (uint32_t j = 0; j < half; j++) {
      const double value = basis[a * half + j] / weight[j];
      contract[(size_t)j * padded + a] = value;
      expand[(size_t)a * half + j] = value;
    }
  }
  wire_grid->padded[along] = padded;
  wire_grid->contract[along] = contract;
  wire_grid->expand[along] = expand;
  return true;
}

static void leave_lanes_alone(TbWireGrid *wire_grid) {
  const uint32_t lanes = wire_grid->halves == 2 ? wire_grid->middle + 1 : wire_grid->lanes;
  wire_grid->columns[0] = wire_grid->columns[1] = lanes;
  wire_grid->thinned = false;
}

/* The edges of a hi-hat have waves around them (rim_waves.h). */
static bool take_waves(Fit *fit, double *basis[2]) {
  TbWireGrid *wire_grid = &fit->projection->wire_grid;
  const uint32_t points = fit->wires->contact_points, half = wire_grid->half;
  basis[0] = tb_arena_doubles(fit->scratch, (size_t)points * half);
  if (!basis[0]) return false;
  for (uint32_t wave = 0; wave < points; wave++) {
    for (uint32_t j = 0; j < points; j++)
      basis[0][wave * half + j] = tb_rim_wave_at(points, wave, j);
  }
  wire_grid->thinned = true;
  wire_grid->columns[0] = points;
  return fill_along(fit, 0, basis[0]);
}

static bool fit_along(Fit *fit, double *basis[2]) {
  TbWireGrid *wire_grid = &fit->projection->wire_grid;
  if (fit->wires->rims) return take_waves(fit, basis);
  leave_lanes_alone(wire_grid);
  if (wire_grid->wires == 0 || wire_grid->halves == 1 || !fit->wires->aligned ||
      wire_grid->half > 1024)
    return true;
  double *work = tb_arena_doubles(fit->scratch, (size_t)fit->modes_coupled * fit->stride);
  for (uint32_t along = 0; along < 2; along++) {
    basis[along] = tb_arena_doubles(fit->scratch, (size_t)wire_grid->half * wire_grid->half);
    if (fit->scratch->failed || !fit_along_class(fit, along, work, basis[along])) return false;
  }
  wire_grid->thinned = wire_grid->columns[0] + wire_grid->columns[1] <=
                       (uint32_t)(WORTH_THINNING * 2.0 * (wire_grid->middle + 1));
  if (!wire_grid->thinned) {
    leave_lanes_alone(wire_grid);
    return true;
  }
  return fill_along(fit, 0, basis[0]) && fill_along(fit, 1, basis[1]);
}

/* ---- tables --------------------------------------------------------------------------------- */

static bool fill_places(TbWireGrid *wire_grid, TbArena *arena, uint32_t along) {
  uint32_t *place =
    tb_arena_take(arena, (size_t)wire_grid->lines * wire_grid->columns[along], sizeof *place);
  wire_grid->place[along] = place;
  for (uint32_t line = 0; place && line < wire_grid->lines; line++) {
    const uint32_t across = wire_grid->quarters == 2 && line >= wire_grid->first_line[1] ? 1 : 0;
    const uint32_t first = wire_grid->first[tb_wire_grid_class(wire_grid, along, across)] +
                           (line - wire_grid->first_line[across]) * wire_grid->columns[along];
    for (uint32_t a = 0; a < wire_grid->columns[along]; a++) *place++ = first + a;
  }
  return !arena->failed;
}

static bool place_classes(TbProjection *p, TbArena *arena) {
  TbWireGrid *wire_grid = &p->wire_grid;
  for (uint32_t along = 0; along < wire_grid->halves; along++) {
    for (uint32_t across = 0; across < wire_grid->quarters; across++) {
      const uint32_t c = tb_wire_grid_class(wire_grid, along, across);
      wire_grid->first[c] = wire_grid->size;
      wire_grid->size += tb_pad(lines_of_class(wire_grid, across) * wire_grid->columns[along]);
    }
  }
  wire_grid->first[p->groups] = wire_grid->size;
  for (uint32_t along = 0; along < wire_grid->halves; along++) {
    if (!fill_places(wire_grid, arena, along)) return false;
  }
  return true;
}

/* Amplitude of mode i at one point of its class. */
static double amplitude(const Fit *fit, double *const basis[2], uint32_t i, uint32_t along,
                        uint32_t line, uint32_t column) {
  const TbWireGrid *wire_grid = &fit->projection->wire_grid;
  const double *values = fit->lines + (size_t)i * fit->stride + line * wire_grid->half;
  if (!wire_grid->thinned) return values[column];
  double sum = 0.0;
  for (uint32_t j = 0; j < wire_grid->half; j++) {
    sum += basis[along][column * wire_grid->half + j] * lane_weight(wire_grid, j) * values[j];
  }
  return sum;
}

/* The only point that a mode moves. */
static uint32_t point_of(const TbProjectionGroup *group, uint32_t i) {
  uint32_t most = 0;
  double size = 0.0;
  for (uint32_t p = 0; p < group->points; p++) {
    const double value = fabs(group->gather[((size_t)(p / 8) * group->modes + i) * 8 + p % 8]);
    if (value > size) most = p;
    size = fmax(size, value);
  }
  return most;
}

/* Clears what rounding leaves at the other points, and lists the runs of modes of one point. */
static bool find_runs(TbProjectionGroup *group, TbArena *arena) {
  const uint32_t blocks = group->modes / 8u;
  group->run = tb_arena_take(arena, blocks, sizeof *group->run);
  group->along = tb_arena_doubles(arena, group->modes);
  if (arena->failed) return false;
  for (uint32_t i = 0; i < group->modes; i++) {
    const uint32_t point = point_of(group, i & ~7u);
    for (uint32_t p = 0; p < group->points; p++) {
      double *to = &group->gather[((size_t)(p / 8) * group->modes + i) * 8 + p % 8];
      double *from = &group->scatter[((size_t)(i / 8) * group->points + p) * 8 + i % 8];
      if (p == point) group->along[i] = *to;
      if (p != point) *to = *from = 0.0;
    }
    if (i % 8u != 0) continue;
    const bool goes_on = group->runs > 0 && group->run[group->runs - 1u].point == point;
    if (!goes_on) group->run[group->runs++] = (TbProjectionRun){.first = i, .point = point};
    group->run[group->runs - 1u].modes += 8u;
  }
  return true;
}

static bool fill_table(Fit *fit, double *const basis[2], uint32_t g) {
  const TbWireGrid *wire_grid = &fit->projection->wire_grid;
  TbProjectionGroup *group = &fit->projection->group[g];
  const uint32_t along = g / wire_grid->quarters, across = g % wire_grid->quarters;
  *group =
    (TbProjectionGroup){.first = fit->modes->group[g],
                        .modes = fit->modes->group[g + 1] - fit->modes->group[g],
                        .first_point = wire_grid->first[g],
                        .points = wire_grid->first[g + 1] - wire_grid->first[g],
                        .used = lines_of_class(wire_grid, across) * wire_grid->columns[along]};
  group->gather = tb_arena_doubles(fit->arena, (size_t)group->points * group->modes);
  group->scatter = tb_arena_doubles(fit->arena, (size_t)group->points * group->modes);
  if (fit->arena->failed) return false;
  for (uint32_t i = 0; i < group->modes; i++) {
    const double part = (g + (double)i / group->modes) / fit->projection->groups;
    if (!tb_arena_go_on_at(fit->scratch, 0.5 + 0.5 * part)) return false;
    for (uint32_t l = 0; l < lines_of_class(wire_grid, across); l++) {
      for (uint32_t a = 0; a < wire_grid->columns[along]; a++) {
        const double value = amplitude(fit, basis, group->first + i, along, l, a);
        const uint32_t point = l * wire_grid->columns[along] + a;
        group->gather[((size_t)(point / 8) * group->modes + i) * 8 + point % 8] = value;
        group->scatter[((size_t)(i / 8) * group->points + point) * 8 + i % 8] = value;
      }
    }
  }
  if (fit->wires->rims && !find_runs(group, fit->arena)) return false;
  return !fit->scratch->failed;
}

static void start_bed(TbWireGrid *wire_grid, const TbModes *modes, const TbWires *wires) {
  *wire_grid = (TbWireGrid){.wires = wires->count,
                            .lanes = wires->lanes,
                            .middle = wires->middle,
                            .halves = modes->halves,
                            .quarters = modes->quarters};
  wire_grid->half = wire_grid->halves == 2 ? tb_pad(wire_grid->middle + 1) : wire_grid->lanes;
  if (wires->count == 0) wire_grid->half = 0;
}

TaborStatus tb_projection_prepare(TbProjection *p, TbArena *arena, const TbModes *modes,
                                  const TbBody *body, const TbWires *wires, double tolerance) {
  TbArena scratch;
  tb_arena_beside(&scratch, arena);
  *p = (TbProjection){.precision = p->precision, .groups = modes->groups};
  start_bed(&p->wire_grid, modes, wires);
  Fit fit = {.projection = p,
             .modes = modes,
             .body = body,
             .wires = wires,
             .arena = arena,
             .scratch = &scratch,
             .tolerance = tolerance,
             .modes_coupled = modes->group[modes->groups],
             .stride = wires->count * p->wire_grid.half};
  double *basis[2] = {NULL, NULL};
  bool done = collect_shapes(&fit) && fit_across(&fit);
  if (done) shapes_on_lines(&fit);
  done = done && fit_along(&fit, basis);
  done = done && place_classes(p, arena);
  for (uint32_t g = 0; done && g < p->groups; g++) done = fill_table(&fit, basis, g);
  const bool starved = arena->failed || scratch.failed;
  tb_arena_release(&scratch);
  if (done) return TABOR_OK;
  return starved ? TABOR_ERROR_MEMORY : TABOR_ERROR_NUMERICS;
}
