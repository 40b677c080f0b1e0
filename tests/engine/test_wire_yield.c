/* SPDX-License-Identifier: MIT */
/* What stands for the head's missing modes under the wires, against the modes themselves. */
#include "physics.h"

#include "drum/drum.h"
#include "model/model.h"

static const double RATE = 192000.0; /* the recursion is that of the oscillator, to 1 % at 6 kHz */
static const double LIMIT = 2000.0, TOP = 6000.0; /* [Hz] */

static TaborModel *drum_with_wires(double two_way, double top, uint32_t wires, bool losses) {
  TaborDrumDef def = physics_membrane();
  def.wires.count = wires;
  def.wire[0].angle = 10.0; /* without symmetry each point of the wires is one of the grid */
  def.quality.wire_points = 24;
  def.quality.two_way_bandwidth = two_way;
  def.quality.bandwidth = top;
  def.quality.losses = losses;
  return physics_model(&def, RATE, TABOR_QUALITY_REFERENCE);
}

/* Displacement of the head at row `to` under a unit force at `from`, with the displacement of each
 * mode under a unit force. */
static double response(const TaborModel *model, const double *gain, uint32_t from, uint32_t to) {
  const TbWireGrid *grid = &model->projection.wire_grid;
  TbArena arena;
  const TaborAllocator system = tb_allocator_resolve(NULL);
  tb_arena_prepare(&arena, &system);
  double *rows = tb_arena_doubles(&arena, model->wires.stride);
  double *points = tb_arena_doubles(&arena, grid->size);
  double *fold = tb_arena_doubles(&arena, tb_wire_grid_scratch(grid));
  double *q = tb_arena_doubles(&arena, model->modes.padded);
  assert_false(arena.failed);
  rows[from] = 1.0;
  model->kernels->rows_to_grid(grid, rows, fold, points);
  tb_project_forces(&model->projection, model->kernels, points, q);
  for (uint32_t i = 0; i < model->modes.padded; i++) q[i] *= gain[i];
  tb_project(&model->projection, model->kernels, q, points);
  model->kernels->grid_to_rows(grid, points, fold, rows);
  const double moved = rows[to];
  tb_arena_release(&arena);
  return moved;
}

/* Under a static force, and per impulse. */
static void responses(const TaborModel *model, uint32_t from, uint32_t to, double *compliance,
                      double *inverse_mass) {
  double *gain = calloc(model->modes.padded, sizeof *gain);
  for (uint32_t i = 0; i < model->modes.padded; i++) {
    gain[i] = model->modes.stiffness[i] > 0.0 ? 1.0 / model->modes.stiffness[i] : 0.0;
  }
  *compliance = response(model, gain, from, to);
  for (uint32_t i = 0; i < model->modes.padded; i++) gain[i] = 1.0;
  *inverse_mass = response(model, gain, from, to);
  free(gain);
}

/* At one place, and between neighbours on one wire. */
static void the_head_yields_as_with_all_modes(void **state) {
  (void)state;
  static const double SAME = 0.02; /* of the value at one place */
  TaborModel *whole = drum_with_wires(TOP, TOP, 1, false);
  TaborModel *cut = drum_with_wires(LIMIT, LIMIT, 1, false);
  TaborModel *model = drum_with_wires(LIMIT, TOP, 1, false);
  const uint32_t row = model->wires.middle - 4u;
  double own_compliance = 0.0, own_mass = 0.0;
  for (uint32_t away = 0; away < 3; away++) {
    double expected[2], without[2], got[2];
    responses(whole, row, row + away, &expected[0], &expected[1]);
    responses(cut, row, row + away, &without[0], &without[1]);
    responses(model, row, row + away, &got[0], &got[1]);
    print_message("%u points away: %.4g m/N of %.4g, %.4g 1/kg of %.4g; without %.4g, %.4g\n", away,
                  got[0], expected[0], got[1], expected[1], without[0], without[1]);
    if (away == 0) {
      own_compliance = expected[0];
      own_mass = expected[1];
      assert_true(without[1] < 0.3 * expected[1]);
    }
    assert_true(fabs(got[0] - expected[0]) < SAME * own_compliance);
    assert_true(fabs(got[1] - expected[1]) < SAME * own_mass);
  }
  tabor_model_release(whole);
  tabor_model_release(cut);
  tabor_model_release(model);
}

static uint32_t spare_modes(const TaborModel *model) {
  uint32_t count = 0;
  for (uint32_t i = 0; i < model->modes.padded; i++) {
    count += model->modes.row[i] == TB_NO_MODE && model->modes.g[i] > 0.0;
  }
  return count;
}

/* They lose energy where the head does, and none is there where nothing is missing. */
static void nothing_stands_for_nothing(void **state) {
  (void)state;
  TaborModel *all = drum_with_wires(TOP, TOP, 8, true);
  TaborModel *lossy = drum_with_wires(LIMIT, TOP, 8, true);
  TaborModel *lossless = drum_with_wires(LIMIT, TOP, 8, false);
  assert_int_equal(spare_modes(all), 0);
  assert_true(spare_modes(lossy) > 0);
  for (uint32_t i = 0; i < lossy->modes.padded; i++) {
    if (lossy->modes.row[i] != TB_NO_MODE || lossy->modes.g[i] == 0.0) continue;
    assert_true(lossy->modes.loss_head[i] > 0.0);
    assert_true(lossy->mics[0].ahead[i] == 0.0 && lossy->mics[0].behind[i] == 0.0);
  }
  for (uint32_t i = 0; i < lossless->modes.padded; i++) {
    assert_true(lossless->modes.loss_head[i] == 0.0);
  }
  tabor_model_release(all);
  tabor_model_release(lossy);
  tabor_model_release(lossless);
}

int main(void) {
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(the_head_yields_as_with_all_modes),
    cmocka_unit_test(nothing_stands_for_nothing),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
