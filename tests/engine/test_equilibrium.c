/* SPDX-License-Identifier: MIT */
/* Head and wires at rest: forces, places and shapes agree, for even wires and for the most uneven
 * ones. */
#include "physics.h"
#include "state/state.h"

/* Error of a penetration, in units of the greatest distance of a wire's ends and shape from the
 * head. The iteration ends where the potential falls no more, at 1e-16 of it, and so at 1e-8 of
 * displacements; a hundred points share it. */
static const double PLACE = 1e-6;
static const double SAG = 1e-5; /* [m]: wires lie as far from a straight line by gravity alone */

typedef struct Worst {
  double place,
    height; /* error, and the greatest distance of a wire's ends and shape from the head [m] */
  double force, most_force; /* error, and the largest force [N] */
  uint32_t touching;
} Worst;

static double height_of_row(const TaborModel *model, uint32_t row) {
  const TbWires *wires = &model->wires;
  return wires->shape[row] + model->rest.offset[wires->row_wire[row]];
}

static double error_of_row(const TaborModel *model, uint32_t row, double head) {
  const TbWires *wires = &model->wires;
  const double wire = model->rest.v[row + TB_WIRE_FRONT] + height_of_row(model, row);
  return fabs(model->rest.eta[row] - (wires->side * head - wire));
}

/* Penetrations against the places of head and wires, which follow from the forces. */
static Worst look_at(const TaborModel *model) {
  const TbWires *wires = &model->wires;
  const TbWireGrid *grid = &model->projection.wire_grid;
  const TaborAllocator allocator = tb_allocator_resolve(NULL);
  TbArena arena;
  tb_arena_prepare(&arena, &allocator);
  double *points = tb_arena_doubles(&arena, grid->size);
  double *scratch = tb_arena_doubles(&arena, tb_wire_grid_scratch(grid));
  double *head = tb_arena_doubles(&arena, wires->stride);
  assert_false(arena.failed);
  tb_project(&model->projection, model->kernels, model->rest.q, points);
  model->kernels->grid_to_rows(grid, points, scratch, head);
  Worst worst = {0};
  for (uint32_t row = 0; row < wires->stride; row++) {
    if (wires->real[row] == 0.0) continue;
    const TbContactLaw *law = &wires->laws[wires->row_wire[row]];
    const double force = model->rest.force[row];
    worst.place = fmax(worst.place, error_of_row(model, row, head[row]));
    worst.height = fmax(worst.height, fabs(height_of_row(model, row)));
    worst.force =
      fmax(worst.force, fabs(force - tb_contact_law_static_force(law, model->rest.eta[row])));
    worst.most_force = fmax(worst.most_force, force);
    worst.touching += force > 0.0;
  }
  tb_arena_release(&arena);
  return worst;
}

static Worst at_rest(const TaborDrumDef *preset, double unevenness, double length) {
  TaborDrumDef def = physics_small(preset);
  def.wires.rest_spread = def.wires.bend_height = 1e-3;
  def.wires.bend_length = length;
  def.wires.unevenness = unevenness;
  TaborModel *model = physics_model(&def, 48000.0, TABOR_QUALITY_STUDIO);
  const Worst worst = look_at(model);
  print_message(
    "%-20s seed %u, unevenness %g, L %g m: heights to %.2g m, %u points touch, up to %.2g N; "
    "errors %.1e m, %.1e N\n",
    def.name, def.wires.seed, unevenness, length, worst.height, worst.touching, worst.most_force,
    worst.place, worst.force);
  tabor_model_release(model);
  return worst;
}

/* From even wires to the ends of the ranges: some wires hang clear, others press. */
static void forces_and_places_agree(void **state) {
  (void)state;
  static const char *const names[] = {"snare-14x5.5", "snare-14x6.5-loose", "bodhran-d-string",
                                      "tabor"};
  static const double unevenness[] = {0.0, 0.3, 1.0, 3.0}, lengths[] = {0.005, 0.02, 1.0};
  uint64_t random = physics_seed();
  for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
    TaborDrumDef def = physics_preset(names[i]);
    for (size_t u = 0; u < 4; u++) {
      for (size_t l = 0; l < 3; l++) {
        def.wires.seed = (uint32_t)physics_random(&random);
        const Worst worst = at_rest(&def, unevenness[u], lengths[l]);
        assert_true(worst.place <= PLACE * fmax(worst.height, SAG));
        assert_true(worst.force <= 1e-13 * worst.most_force);
      }
    }
  }
}

int main(void) {
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(forces_and_places_agree),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
