/* SPDX-License-Identifier: MIT */
/* The drawn shapes of bent wires: their statistics, and what seed and unevenness do. */
#include "model/wire_shape.h"

#include "model/model.h"
#include "physics.h"

enum { SEEDS = 1000, SHAPES = SEEDS * TABOR_MAX_WIRES };

static const double HEIGHT = 2.5e-4, LENGTH = 0.02;
/* Five standard errors of means over so many independent shapes: of z/A, with variance 1, of
 * (z/A)^2, with variance 2 at most, and of a product of two. */
#define BOUND (5.0 * sqrt(2.0 / SHAPES))

static TaborWiresDef bent(uint32_t seed) {
  TaborDrumDef def;
  tabor_drum_def_default(&def);
  def.wires.bend_height = HEIGHT;
  def.wires.bend_length = LENGTH;
  def.wires.seed = seed;
  return def.wires;
}

/* Mean, mean square, and mean product with the height at `distance` away, at the place s, in units
 * of A. */
static void moments(uint32_t first_seed, double s, double distance, double sum[3]) {
  sum[0] = sum[1] = sum[2] = 0.0;
  for (uint32_t i = 0; i < SHAPES; i++) {
    const TaborWiresDef wires = bent(first_seed + i / TABOR_MAX_WIRES);
    TbWireShape shape;
    tb_wire_shape_draw(&shape, &wires, i % TABOR_MAX_WIRES);
    const double here = tb_wire_shape_height(&shape, s) / HEIGHT;
    sum[0] += here / SHAPES;
    sum[1] += here * here / SHAPES;
    sum[2] += here * tb_wire_shape_height(&shape, s + distance) / HEIGHT / SHAPES;
  }
}

/* Root mean square A at every place, and the correlation of the header. */
static void heights_have_the_stated_statistics(void **state) {
  (void)state;
  uint64_t random = physics_seed();
  const uint32_t first_seed = (uint32_t)physics_random(&random);
  const double places[] = {-0.15, 0.0, 0.04}, distances[] = {0.25, 0.5, 1.0, 2.0};
  for (size_t p = 0; p < sizeof places / sizeof *places; p++) {
    for (size_t d = 0; d < sizeof distances / sizeof *distances; d++) {
      double sum[3];
      moments(first_seed, places[p], distances[d] * LENGTH, sum);
      const double expected = exp(-0.5 * distances[d] * distances[d]);
      print_message(
        "seeds from %u, s %g m, %g L apart: mean %.4f A, rms %.4f A, correlation %.4f (%.4f)\n",
        first_seed, places[p], distances[d], sum[0], sqrt(sum[1]), sum[2], expected);
      assert_true(fabs(sum[0]) < BOUND);
      assert_true(fabs(sum[1] - 1.0) < BOUND);
      assert_true(fabs(sum[2] - expected) < BOUND);
    }
  }
}

static bool same_shape(const TbWireShape *a, const TbWireShape *b) {
  return memcmp(a, b, sizeof *a) == 0;
}

/* Limiting cases: no height or no unevenness is straight, exactly. */
static void a_seed_draws_its_shapes_and_no_others(void **state) {
  (void)state;
  TaborWiresDef wires = bent(7), other = bent(8);
  TbWireShape a, b;
  tb_wire_shape_draw(&a, &wires, 3);
  tb_wire_shape_draw(&b, &wires, 3);
  assert_true(same_shape(&a, &b));
  tb_wire_shape_draw(&b, &wires, 4);
  assert_false(same_shape(&a, &b));
  tb_wire_shape_draw(&b, &other, 3);
  assert_false(same_shape(&a, &b));
  wires.unevenness = 2.0;
  tb_wire_shape_draw(&b, &wires, 3);
  assert_true(tb_wire_shape_height(&b, 0.01) == 2.0 * tb_wire_shape_height(&a, 0.01));
  wires.unevenness = 0.0;
  tb_wire_shape_draw(&b, &wires, 3);
  assert_true(tb_wire_shape_height(&b, 0.01) == 0.0);
}

/* All shapes of a snare drum's rows: of its own seed to the bit, the same at every rate where nodes
 * coincide. */
static void rows_lie_on_the_shape(void **state) {
  (void)state;
  TaborDrumDef def = physics_preset("snare-14x5.5");
  def.wires.bend_height = HEIGHT;
  def = physics_small(&def);
  TaborModel *model = physics_model(&def, 48000.0, TABOR_QUALITY_STUDIO);
  const TbWires *wires = &model->wires;
  for (uint32_t row = 0; row < wires->stride; row++) {
    if (wires->real[row] == 0.0) {
      assert_true(wires->shape[row] == 0.0);
      continue;
    }
    const TbWire *wire = &wires->wires[wires->row_wire[row]];
    TbWireShape shape;
    tb_wire_shape_draw(&shape, &def.wires, wires->row_wire[row]);
    const double s =
      (wires->row_x[row] - wire->x) * wire->dx + (wires->row_y[row] - wire->y) * wire->dy;
    const double expected = tb_wire_shape_height(&shape, s / wire->spacing);
    assert_true(fabs(wires->shape[row] - expected) < 1e-12 * HEIGHT / LENGTH); /* rounding of s */
  }
  tabor_model_release(model);
}

int main(void) {
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(heights_have_the_stated_statistics),
    cmocka_unit_test(a_seed_draws_its_shapes_and_no_others),
    cmocka_unit_test(rows_lie_on_the_shape),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
