/* SPDX-License-Identifier: MIT */
/* The grid under the wires: its shapes against the exact ones, its limiting cases, the compliance.
 */
#include "physics.h"
#include "state/state.h"

/* Twenty wires under a thin head, as on a snare drum. */
static TaborDrumDef snares(uint32_t count) {
  TaborDrumDef def = physics_preset("tabor");
  def.shell.radius = 0.178;
  def.batter.surface_density = 0.1;
  def.wires.count = count;
  def.wires.side = TABOR_SIDE_BELOW;
  def.wires.spacing = 0.0034;
  def.wires.tension_spread = 0.05;
  def.wires.rest_offset = -0.0005;
  return def;
}

typedef struct Room {
  double *grid, *answer, *rows, *other, *scratch, *modal;
} Room;

static double *take(TbArena *arena, size_t count) {
  double *room = tb_arena_doubles(arena, count);
  assert_non_null(room);
  return room;
}

static Room make_room(TbArena *arena, const TaborModel *model) {
  const TbWireGrid *wire_grid = &model->projection.wire_grid;
  const TaborAllocator allocator = tb_allocator_resolve(NULL);
  tb_arena_prepare(arena, &allocator);
  return (Room){take(arena, wire_grid->size),
                take(arena, wire_grid->size),
                take(arena, model->wires.stride),
                take(arena, model->wires.stride),
                take(arena, tb_wire_grid_scratch(wire_grid)),
                take(arena, model->modes.padded)};
}

/* Exact shapes of all modes at a row. */
static void exact(const TaborModel *model, uint32_t row, double *radial, double *shape) {
  const double x = model->wires.row_x[row], y = model->wires.row_y[row], r = sqrt(x * x + y * y);
  tb_modes_shape(&model->modes, &model->body, 0, r, r > 0.0 ? y / r : 0.0, r > 0.0 ? x / r : 1.0,
                 NULL, radial, shape);
}

/* Largest error of a coupled mode's shape on the grid, in units of the largest shape. */
static double worst_shape(const TaborModel *model) {
  TbArena arena;
  const Room room = make_room(&arena, model);
  const TbWireGrid *wire_grid = &model->projection.wire_grid;
  const uint32_t modes = model->modes.group[model->modes.groups];
  double *radial = take(&arena, model->body.row_count), *shape = take(&arena, model->modes.padded);
  double *table = take(&arena, (size_t)model->wires.stride * modes);
  double worst = 0.0, most = 0.0;
  for (uint32_t i = 0; i < modes; i++) {
    room.modal[i] = 1.0;
    tb_project(&model->projection, model->kernels, room.modal, room.grid);
    room.modal[i] = 0.0;
    model->kernels->grid_to_rows(wire_grid, room.grid, room.scratch, room.rows);
    for (uint32_t row = 0; row < model->wires.stride; row++) {
      table[(size_t)row * modes + i] = room.rows[row];
    }
  }
  for (uint32_t row = 0; row < model->wires.stride; row++) {
    if (model->wires.real[row] == 0.0) continue;
    exact(model, row, radial, shape);
    for (uint32_t i = 0; i < modes; i++) {
      if (model->modes.row[i] == TB_NO_MODE) continue; /* it stands for missing modes */
      worst = fmax(worst, fabs(table[(size_t)row * modes + i] - shape[i]));
      most = fmax(most, fabs(shape[i]));
    }
  }
  print_message("%u wires: %u lines, %u + %u columns%s, %u points of the grid: worst %.1e\n",
                wire_grid->wires, wire_grid->lines, wire_grid->columns[0], wire_grid->columns[1],
                wire_grid->thinned ? ", thinned" : "", wire_grid->size, worst / most);
  tb_arena_release(&arena);
  return worst / most;
}

/* Errors across and along add up. */
static void shapes_on_the_grid_are_right(void **state) {
  (void)state;
  static const uint32_t counts[] = {1, 2, 3, 20, 40};
  static const uint32_t qualities[] = {TABOR_QUALITY_LIVE, TABOR_QUALITY_STUDIO};
  for (int c = 0; c < 5; c++) {
    for (int q = 0; q < 2; q++) {
      const TaborDrumDef def = snares(counts[c]);
      TaborModel *model = physics_model(&def, 48000.0, qualities[q]);
      assert_true(worst_shape(model) < 3.0 * model->grid_tolerance);
      tabor_model_release(model);
    }
  }
}

/* At the highest quality, and for wires that share no symmetry, the grid is exact. */
static void limiting_cases_are_exact(void **state) {
  (void)state;
  TaborDrumDef def = snares(3);
  def.quality.two_way_bandwidth = 3000.0;
  TaborModel *model = physics_model(&def, 48000.0, TABOR_QUALITY_REFERENCE);
  assert_true(worst_shape(model) < 1e-12);
  tabor_model_release(model);
  def.wire[0].angle = 10.0;
  def.wire[2].length = 0.2;
  model = physics_model(&def, 48000.0, TABOR_QUALITY_LIVE);
  assert_true(worst_shape(model) < 1e-7); /* single precision */
  tabor_model_release(model);
}

/* Forces go in through the transposed table: f . expand(c) = contract(f) . c. */
static void work_is_the_same_on_both_sides(void **state) {
  (void)state;
  const TaborDrumDef def = snares(7);
  TaborModel *model = physics_model(&def, 48000.0, TABOR_QUALITY_LIVE);
  const TbWireGrid *wire_grid = &model->projection.wire_grid;
  const uint32_t n = model->wires.stride;
  TbArena arena;
  const Room room = make_room(&arena, model);
  uint64_t seed = 5;
  for (int trial = 0; trial < 20; trial++) {
    for (uint32_t i = 0; i < n; i++) {
      room.rows[i] = model->wires.real[i] * physics_uniform(&seed, -1.0, 1.0);
    }
    for (uint32_t i = 0; i < model->modes.group[model->modes.groups]; i++) {
      room.modal[i] = physics_uniform(&seed, -1.0, 1.0);
    }
    tb_project(&model->projection, model->kernels, room.modal, room.answer);
    model->kernels->grid_to_rows(wire_grid, room.answer, room.scratch, room.other);
    model->kernels->rows_to_grid(wire_grid, room.rows, room.scratch, room.grid);
    double rows = 0.0, grid = 0.0, scale = 0.0;
    for (uint32_t i = 0; i < n; i++) {
      rows += room.rows[i] * room.other[i];
      scale += fabs(room.rows[i] * room.other[i]);
    }
    for (uint32_t i = 0; i < wire_grid->size; i++) grid += room.grid[i] * room.answer[i];
    assert_true(fabs(rows - grid) < 1e-13 * scale);
  }
  tb_arena_release(&arena);
  tabor_model_release(model);
}

/* The operator between rows against the sum over the exact modes. */
static void compliance_agrees_with_the_modes(void **state) {
  (void)state;
  TaborDrumDef def = snares(5);
  def.quality.bandwidth = def.quality.two_way_bandwidth = 6000.0; /* no modes are missing */
  TaborModel *model = physics_model(&def, 48000.0, TABOR_QUALITY_STUDIO);
  const TbWireGrid *wire_grid = &model->projection.wire_grid;
  const uint32_t modes = model->modes.group[model->modes.groups];
  TbArena arena;
  const Room room = make_room(&arena, model);
  double *radial = take(&arena, model->body.row_count);
  double *here = take(&arena, model->modes.padded), *there = take(&arena, model->modes.padded);
  double worst = 0.0, most = 0.0;
  for (uint32_t a = 20; a < model->wires.stride; a += 53) {
    if (model->wires.real[a] == 0.0) continue;
    memset(room.rows, 0, model->wires.stride * sizeof(double));
    room.rows[a] = 1.0;
    model->kernels->rows_to_grid(wire_grid, room.rows, room.scratch, room.grid);
    model->kernels->apply_compliance(&model->compliance, room.grid, room.answer);
    model->kernels->grid_to_rows(wire_grid, room.answer, room.scratch, room.other);
    exact(model, a, radial, here);
    for (uint32_t b = 0; b < model->wires.stride; b += 7) {
      if (model->wires.real[b] == 0.0) continue;
      exact(model, b, radial, there);
      double sum = 0.0;
      for (uint32_t i = 0; i < modes; i++) sum += here[i] * model->modes.g[i] * there[i];
      worst = fmax(worst, fabs(sum - room.other[b]));
      most = fmax(most, fabs(sum));
    }
  }
  print_message("compliance off by %.1e of the largest\n", worst / most);
  assert_true(worst < 10.0 * model->grid_tolerance * most);
  for (uint32_t g = 0; g < model->compliance.classes; g++) {
    const uint32_t n = model->compliance.first[g + 1] - model->compliance.first[g];
    const double *matrix = model->compliance.matrix[g];
    for (uint32_t a = 0; a < n; a++) {
      for (uint32_t b = 0; b < a; b++) {
        assert_true(matrix[((size_t)(a / 8) * n + b) * 8 + a % 8] ==
                    matrix[((size_t)(b / 8) * n + a) * 8 + b % 8]);
      }
    }
  }
  tb_arena_release(&arena);
  tabor_model_release(model);
}

/* Twenty wires at every quality of playing: each joule is accounted for, and nothing is created. */
static void twenty_wires_keep_their_ledger(void **state) {
  (void)state;
  for (uint32_t losses = 0; losses < 2; losses++) {
    for (uint32_t quality = TABOR_QUALITY_DRAFT; quality <= TABOR_QUALITY_STUDIO; quality++) {
      TaborDrumDef def = snares(20);
      if (quality == TABOR_QUALITY_STUDIO) def = physics_small(&def);
      def.quality.losses = losses;
      TaborModel *model = physics_model(&def, 48000.0, quality);
      TaborDrum *drum = physics_drum(model);
      const TaborEvent strike = physics_strike(&def);
      tabor_drum_process(drum, &strike, 1, NULL, 4800);
      TaborLedger ledger;
      TaborStatistics statistics;
      tabor_drum_ledger(drum, &ledger);
      tabor_drum_statistics(drum, &statistics);
      print_message("quality %u, losses %u: residual %.1e of %.2g J, %llu of %llu solves capped\n",
                    quality, losses, ledger.residual / ledger.injected, ledger.injected,
                    (unsigned long long)statistics.newton_capped,
                    (unsigned long long)statistics.solves);
      assert_true(fabs(ledger.residual) < physics_residual(quality) * ledger.injected);
      assert_true(losses || fabs(ledger.contact_loss) < 1e-4 * ledger.injected);
      assert_true(statistics.contact_max > 100);
      tabor_drum_destroy(drum);
      tabor_model_release(model);
    }
  }
}

int main(void) {
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(shapes_on_the_grid_are_right),
    cmocka_unit_test(limiting_cases_are_exact),
    cmocka_unit_test(work_is_the_same_on_both_sides),
    cmocka_unit_test(compliance_agrees_with_the_modes),
    cmocka_unit_test(twenty_wires_keep_their_ledger),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
