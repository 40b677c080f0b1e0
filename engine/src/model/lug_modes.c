/* SPDX-License-Identifier: MIT */
#include "model/lug_modes.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "bodies/drum/lug_tension.h"
#include "definition/error.h"
#include "math/eigen.h"
#include "math/portable_math.h"
#include "model/lug_matrix.h"

static const double PI = 3.14159265358979323846;

/* Copies that are coupled; padding to 8 in five groups must fit too. */
static const uint32_t MOST_COUPLED = TB_LUG_MODES - 5u * 7u;

/* Below this part of the even heads' lowest w^2 a head is slack. */
static const double SLACK = 0.2;

/* ---- which modes ---------------------------------------------------------------------------- */

/* The first rows of head.modes, all copies of which are coupled. */
static uint32_t coupled_rows(const TaborModel *model) {
  uint32_t row = 0, copies = 0;
  for (; row < model->body.row_count; row++) {
    copies += model->body.modes[row].m ? 2 : 1;
    if (copies > MOST_COUPLED) break;
  }
  return row;
}

/* Each group lists its modes by frequency, so those that are coupled stand at its beginning. */
static void prepare_ranges(TbLugs *lugs, const TbModes *modes, uint32_t rows) {
  for (uint32_t group = 0; group <= modes->groups; group++) {
    const uint32_t end = group < modes->groups ? modes->group[group + 1] : modes->padded;
    uint32_t i = modes->group[group];
    lugs->from[group] = i;
    while (i < end && modes->row[i] < rows) i++;
    lugs->size[group] = tb_pad(i - modes->group[group]);
    lugs->count += lugs->size[group];
  }
}

/* mode[]: places of the coupled modes in TbModes; place[]: the place of each in a gathered vector.
 */
static uint32_t list_coupled(const TbLugs *lugs, const TbModes *modes, uint32_t rows,
                             uint32_t *mode, uint32_t *place) {
  uint32_t count = 0, first = 0;
  for (uint32_t group = 0; group <= modes->groups; group++) {
    for (uint32_t i = 0; i < lugs->size[group]; i++) {
      if (modes->row[lugs->from[group] + i] >= rows) continue; /* also TB_NO_MODE */
      mode[count] = lugs->from[group] + i;
      place[count++] = first + i;
    }
    first += lugs->size[group];
  }
  return count;
}

/* ---- what becomes of them ------------------------------------------------------------------- */

static double omega_of(const TaborModel *model, uint32_t mode) {
  return model->body.modes[model->modes.row[mode]].omega;
}

/* A mode of the uneven head: named after the even mode that has most of it. */
static TaborModeInfo mixed_row(const TaborModel *model, const uint32_t *mode, uint32_t n,
                               double square, const double *v) {
  TaborModeInfo row = {.frequency = sqrt(square) / (2.0 * PI), .multiplicity = 1};
  double most = 0.0;
  for (uint32_t i = 0; i < n; i++) {
    const TbBodyMode *even = &model->body.modes[model->modes.row[mode[i]]];
    const double part = v[i] * v[i];
    row.decay_rate += part * even->decay_rate;
    row.radiation_rate += part * even->radiation_rate;
    if (part <= most) continue;
    most = part;
    row.m = even->m;
    row.n = even->n;
    row.part = (TaborModePart)even->part;
    row.phase = even->phase;
  }
  return row;
}

/* Rows of one frequency get an order, too: C libraries sort equal ones differently. */
static int compare_rows(const void *a, const void *b) {
  const TaborModeInfo *x = a, *y = b;
  if (x->frequency != y->frequency) return x->frequency < y->frequency ? -1 : 1;
  if (x->m != y->m) return x->m < y->m ? -1 : 1;
  return x->n < y->n ? -1 : x->n > y->n;
}

/* The coupled modes' own frequencies, then the modes above as they are. */
static TaborStatus find_rows(TaborModel *model, TbArena *scratch, const uint32_t *mode, uint32_t n,
                             uint32_t rows, const double *coupling, double *lowest) {
  TbLugs *lugs = &model->lugs;
  double *stiffness = tb_arena_doubles(scratch, (size_t)n * n);
  double *squares = tb_arena_doubles(scratch, n);
  double *vectors = tb_arena_doubles(scratch, (size_t)n * n);
  lugs->row_count = n + model->body.row_count - rows;
  lugs->rows = tb_arena_take(&model->arena, lugs->row_count, sizeof *lugs->rows);
  if (scratch->failed || model->arena.failed) return TABOR_ERROR_MEMORY;
  for (uint32_t i = 0; i < n * n; i++) stiffness[i] = coupling[i];
  for (uint32_t i = 0; i < n; i++) {
    const double omega = omega_of(model, mode[i]);
    stiffness[(size_t)i * n + i] += omega * omega;
  }
  if (!tb_eigen_symmetric(scratch, n, stiffness, NULL, squares, vectors)) {
    return scratch->failed ? TABOR_ERROR_MEMORY : TABOR_ERROR_NUMERICS;
  }
  *lowest = squares[0];
  for (uint32_t i = 0; i < n; i++) {
    lugs->rows[i] = mixed_row(model, mode, n, fmax(0.0, squares[i]), vectors + (size_t)i * n);
  }
  for (uint32_t row = rows; row < model->body.row_count; row++) {
    lugs->rows[n + row - rows] = tb_body_mode_info(&model->body.modes[row]);
  }
  qsort(lugs->rows, lugs->row_count, sizeof *lugs->rows, compare_rows);
  return TABOR_OK;
}

/* The head whose lugs differ most is named. */
static TaborStatus refuse_slack(const TbBody *body, TaborError *error) {
  double most[TB_HEADS] = {0.0};
  for (uint32_t h = 0; h < body->surfaces; h++) {
    double deviation[TABOR_MAX_LUGS];
    tb_lug_deviations(&body->sheet[h], deviation);
    for (uint32_t j = 0; j < body->sheet[h].lug_count; j++)
      most[h] = fmax(most[h], fabs(deviation[j]));
  }
  const char *const name = most[1] > most[0] ? "resonant" : "batter";
  char key[TABOR_NAME_SIZE];
  (void)snprintf(key, sizeof key, "%s.lug_spread", name);
  return tb_error_set(error, TABOR_ERROR_RANGE, key, NULL, NAN, NAN,
                      "the tensions at the lugs differ so much that the %s head goes slack", name);
}

/* ---- the table ------------------------------------------------------------------------------ */

/* The recursion's answer to a force is too large by w k/sin(w k). */
static double softness(const TaborModel *model, uint32_t mode) {
  const double turn = omega_of(model, mode) * model->time_step;
  return sqrt(tb_sin(turn) / turn);
}

static bool fill_table(TaborModel *model, const uint32_t *mode, const uint32_t *place, uint32_t n,
                       const double *coupling) {
  TbLugs *lugs = &model->lugs;
  lugs->pull = tb_arena_take(&model->arena, (size_t)lugs->count * lugs->count, sizeof *lugs->pull);
  if (model->arena.failed) return false;
  for (uint32_t i = 0; i < n; i++) {
    for (uint32_t j = 0; j < n; j++) {
      const double soft = softness(model, mode[i]) * softness(model, mode[j]);
      const size_t block = place[i] / 8, lane = place[i] % 8;
      lugs->pull[(block * lugs->count + place[j]) * 8 + lane] =
        (float)(soft * coupling[(size_t)i * n + j]);
    }
  }
  return true;
}

static TaborStatus prepare(TaborModel *model, TbArena *scratch, TaborError *error) {
  const uint32_t rows = coupled_rows(model);
  uint32_t mode[TB_LUG_MODES], place[TB_LUG_MODES];
  prepare_ranges(&model->lugs, &model->modes, rows);
  const uint32_t n = list_coupled(&model->lugs, &model->modes, rows, mode, place);
  double *coupling = tb_arena_doubles(scratch, (size_t)n * n);
  if (!coupling || !tb_lug_matrix(model, scratch, mode, n, coupling)) return TABOR_ERROR_MEMORY;
  double lowest;
  const TaborStatus status = find_rows(model, scratch, mode, n, rows, coupling, &lowest);
  if (status != TABOR_OK) return status;
  const double even = model->body.modes[0].omega;
  if (!(lowest > SLACK * even * even)) return refuse_slack(&model->body, error);
  return fill_table(model, mode, place, n, coupling) ? TABOR_OK : TABOR_ERROR_MEMORY;
}

TaborStatus tb_lug_modes_prepare(TaborModel *model, TaborError *error) {
  if (!tb_lugs_uneven(&model->body)) return TABOR_OK;
  TbArena scratch;
  tb_arena_beside(&scratch, &model->arena);
  const TaborStatus status = prepare(model, &scratch, error);
  tb_arena_release(&scratch);
  return status;
}
