/* SPDX-License-Identifier: MIT */
/* What a view shows is what the drum's modes, wires, contacts and ledger say. */
#include "drum/drum.h"
#include "drum/view.h"
#include "physics.h"

static const double RATE = 48000.0;
/* Sums of the same products in another order: a thousand terms, rounded at 1e-16 of the largest. */
static const double ROUNDING = 1e-12;

typedef struct Scene {
  TaborModel *model;
  TaborDrum *drum;
  TaborView *view;
} Scene;

static Scene scene_of(const TaborDrumDef *def, uint32_t quality, TaborViewGrid grid) {
  Scene scene = {.model = physics_model(def, RATE, quality)};
  TaborError error = {0};
  scene.drum = physics_drum(scene.model);
  if (tabor_view_create(scene.model, &grid, &scene.view, &error) != TABOR_OK) {
    fail_msg("%s", error.message);
  }
  return scene;
}

static void scene_destroy(Scene *scene) {
  tabor_view_destroy(scene->view);
  tabor_drum_destroy(scene->drum);
  tabor_model_release(scene->model);
}

static void strike(Scene *scene, double velocity, double radius, double angle, uint32_t frames) {
  const TaborEvent event = {
    .type = TABOR_EVENT_STRIKE, .id = 7, .velocity = velocity, .radius = radius, .angle = angle};
  tabor_drum_process(scene->drum, &event, 1, NULL, frames);
}

static void look(Scene *scene) { assert_true(tabor_drum_view(scene->drum, scene->view)); }

static uint32_t places(const TaborView *view) { return view->radii * view->angles; }

static double largest(const TaborView *view, uint32_t head) {
  double most = 0.0;
  for (uint32_t i = 0; i < places(view); i++) {
    most = fmax(most, fabs(view->displacement[head][i]));
  }
  return most;
}

/* The sum over all modes up to `bandwidth` at one place, by their shapes there. */
static double head_at(const Scene *scene, uint32_t head, double radius, double angle,
                      double bandwidth) {
  const TaborModel *model = scene->model;
  const TbView state = tb_view(scene->drum->state, model);
  const double turn = (angle - model->axis) * 0.017453292519943295;
  double *radial = calloc(model->body.row_count, sizeof *radial), sum = 0.0;
  double *shape = calloc(model->modes.padded, sizeof *shape);
  assert_true(radial && shape);
  tb_modes_shape(&model->modes, &model->body, head, radius, sin(turn), cos(turn), NULL, radial,
                 shape);
  for (uint32_t i = 0; i < model->modes.padded; i++) {
    const uint32_t row = model->modes.row[i];
    if (row == TB_NO_MODE || model->body.modes[row].omega > 6.283185307179586 * bandwidth) continue;
    sum += shape[i] * (state.now.q[i] + model->rest.q[i]);
  }
  free(radial);
  free(shape);
  return sum;
}

static TaborDrumDef two_headed_tom(void) {
  TaborDrumDef def = physics_preset("tom-12");
  assert_true(def.two_headed);
  return def;
}

/* ---- heads ---------------------------------------------------------------------------------- */

/* But for its weight. */
static void a_silent_drum_is_flat(void **state) {
  (void)state;
  TaborDrumDef def = two_headed_tom();
  def.air.gravity = 0.0;
  Scene scene = scene_of(&def, TABOR_QUALITY_DRAFT, (TaborViewGrid){0});
  look(&scene);
  const TaborView *view = scene.view;
  assert_int_equal(view->heads, 2);
  assert_int_equal(view->radii, 16);
  assert_int_equal(view->angles, 48);
  assert_true(largest(view, 0) == 0.0 && largest(view, 1) == 0.0);
  assert_int_equal(view->wire_count, 0);
  assert_int_equal(view->wire_points, 0);
  assert_int_equal(view->stick_count, 0);
  assert_true(view->ledger.injected == 0.0 && view->ledger.stored == 0.0);
  scene_destroy(&scene);
}

/* A membrane in a vacuum hangs as a parabola, w = -rho g (R^2 - r^2)/(4 T). */
static void a_head_hangs_under_its_weight(void **state) {
  (void)state;
  const double truncated = 0.01; /* by the modes above the two-way bandwidth, of w at the centre */
  const TaborDrumDef def = physics_membrane();
  Scene scene = scene_of(&def, TABOR_QUALITY_LIVE, (TaborViewGrid){.bandwidth = INFINITY});
  look(&scene);
  const double sag = def.batter.surface_density * def.air.gravity * def.shell.radius *
                     def.shell.radius / (4.0 * def.batter.tension);
  for (uint32_t i = 0; i < places(scene.view); i++) {
    const double part = (double)(i / 48) / 15.0, expected = -sag * (1.0 - part * part);
    assert_true(fabs(scene.view->displacement[0][i] - expected) < truncated * sag);
  }
  scene_destroy(&scene);
}

static void heads_are_sums_over_their_modes(void **state) {
  (void)state;
  TaborDrumDef def = two_headed_tom();
  def.wires.angle = 20.0; /* modes count from there; the grid does not */
  const TaborViewGrid grid = {.radii = 7, .angles = 10, .bandwidth = 1000.0};
  Scene scene = scene_of(&def, TABOR_QUALITY_DRAFT, grid);
  strike(&scene, 3.0, 0.07, 50.0, 300);
  look(&scene);
  for (uint32_t h = 0; h < 2; h++) {
    const double most = largest(scene.view, h);
    assert_true(most > 1e-5);
    for (uint32_t i = 0; i < 7; i++) {
      for (uint32_t j = 0; j < 10; j++) {
        const double expected = head_at(&scene, h, def.shell.radius * i / 6.0, 36.0 * j, 1000.0);
        const double seen = scene.view->displacement[h][i * 10 + j];
        if (fabs(seen - expected) > ROUNDING * most) {
          fail_msg("head %u at %u, %u: %g, not %g", h, i, j, seen, expected);
        }
      }
    }
  }
  scene_destroy(&scene);
}

/* The probe's head is that with the wires, and counts all modes. */
static void the_centre_is_where_the_probe_says(void **state) {
  (void)state;
  const TaborDrumDef def = physics_preset("snare-14x5.5");
  const TaborViewGrid grid = {.radii = 3, .angles = 4, .bandwidth = INFINITY};
  Scene scene = scene_of(&def, TABOR_QUALITY_DRAFT, grid);
  TaborModelInfo info;
  tabor_model_info(scene.model, &info);
  assert_int_equal(scene.view->mode_count, info.mode_count);
  assert_true(scene.view->bandwidth == info.two_way_bandwidth);
  for (uint32_t n = 0; n < 3; n++) {
    TaborProbe probe;
    strike(&scene, 4.0, 0.04, 10.0, 200);
    look(&scene);
    tabor_drum_probe(scene.drum, &probe);
    const double most = largest(scene.view, def.wires.head);
    assert_true(fabs(probe.head) > 0.01 * most);
    for (uint32_t j = 0; j < 4; j++) {
      const double seen = scene.view->displacement[def.wires.head][j];
      assert_true(fabs(seen - probe.head) <= ROUNDING * most);
    }
  }
  scene_destroy(&scene);
}

static void the_edge_stays(void **state) {
  (void)state;
  const TaborDrumDef def = physics_preset("snare-14x5.5");
  Scene scene = scene_of(&def, TABOR_QUALITY_DRAFT, (TaborViewGrid){0});
  strike(&scene, 4.0, 0.04, 10.0, 200);
  look(&scene);
  const double *edge = scene.view->displacement[0] + 15 * 48;
  /* Zeros of Bessel functions, right to 1e-10 of the largest shape. */
  for (uint32_t j = 0; j < 48; j++) assert_true(fabs(edge[j]) < 1e-9 * largest(scene.view, 0));
  scene_destroy(&scene);
}

static void a_stroke_in_the_centre_is_seen_as_circles(void **state) {
  (void)state;
  TaborDrumDef def = physics_preset("tom-12");
  def.batter.lug_spread = def.resonant.lug_spread = 0.0;
  Scene scene = scene_of(&def, TABOR_QUALITY_DRAFT, (TaborViewGrid){.bandwidth = INFINITY});
  strike(&scene, 3.0, 0.0, 0.0, 150);
  look(&scene);
  for (uint32_t h = 0; h < 2; h++) {
    const double most = largest(scene.view, h);
    assert_true(most > 1e-6);
    for (uint32_t i = 0; i < places(scene.view); i++) {
      const double *circle = scene.view->displacement[h] + i / 48 * 48;
      assert_true(fabs(circle[i % 48] - circle[0]) <= ROUNDING * most);
    }
  }
  /* One beside it is not: this test sees something. */
  tabor_drum_reset(scene.drum);
  strike(&scene, 3.0, 0.06, 0.0, 150);
  look(&scene);
  const double *circle = scene.view->displacement[0] + 8 * 48;
  assert_true(fabs(circle[24] - circle[0]) > 0.1 * largest(scene.view, 0));
  scene_destroy(&scene);
}

/* A stick pushes the head down where it strikes, before waves reach the edge. */
static void a_stick_dents_the_head(void **state) {
  (void)state;
  const TaborDrumDef def = physics_preset("tom-12");
  Scene scene = scene_of(&def, TABOR_QUALITY_DRAFT, (TaborViewGrid){.bandwidth = INFINITY});
  strike(&scene, 3.0, def.shell.radius * 5.0 / 15.0, 90.0, 40);
  look(&scene);
  const TaborView *view = scene.view;
  TaborProbe probe;
  tabor_drum_probe(scene.drum, &probe);
  uint32_t lowest = 0;
  for (uint32_t i = 0; i < places(view); i++) {
    if (view->displacement[0][i] < view->displacement[0][lowest]) lowest = i;
  }
  assert_true(labs((long)(lowest / 48) - 5) <= 1);
  assert_true(labs((long)(lowest % 48) - 12) <= 2);
  assert_int_equal(view->stick_count, 1);
  const TaborViewStick *stick = &view->sticks[0];
  assert_int_equal(stick->id, 7);
  assert_int_equal(stick->on_hoop, 0);
  assert_true(stick->radius == def.shell.radius * 5.0 / 15.0 && stick->angle == 90.0);
  assert_true(stick->height == probe.striker && stick->force == probe.striker_force);
  assert_true(stick->force > 0.0 && stick->height < 0.0);
  scene_destroy(&scene);
}

static void a_rimshot_has_two_places(void **state) {
  (void)state;
  const TaborDrumDef def = physics_preset("snare-14x5.5");
  Scene scene = scene_of(&def, TABOR_QUALITY_DRAFT, (TaborViewGrid){0});
  const TaborEvent event = {.type = TABOR_EVENT_STRIKE,
                            .velocity = 4.0,
                            .radius = 0.03,
                            .angle = 200.0,
                            .technique = TABOR_TECHNIQUE_RIMSHOT};
  tabor_drum_process(scene.drum, &event, 1, NULL, 20);
  look(&scene);
  const TaborView *view = scene.view;
  assert_int_equal(view->stick_count, 2);
  assert_int_equal(view->sticks[0].on_hoop + view->sticks[1].on_hoop, 1);
  const TaborViewStick *shaft = &view->sticks[view->sticks[1].on_hoop];
  assert_true(fabs(shaft->height - def.hoop.height) < 0.005); /* 2 mm above, and sinking */
  scene_destroy(&scene);
}

/* ---- wires ---------------------------------------------------------------------------------- */

/* One point for each node, so that each contact has a point of its own. */
static Scene snare_scene(TaborDrumDef *def) {
  *def = physics_preset("snare-14x5.5");
  def->quality.wire_points = 32;
  const TaborViewGrid grid = {.wire_points = 33, .bandwidth = INFINITY};
  Scene scene = scene_of(def, TABOR_QUALITY_DRAFT, grid);
  for (uint32_t w = 0; w < def->wires.count; w++) {
    assert_int_equal(scene.model->wires.wires[w].cells, 32);
  }
  return scene;
}

/* Height of the head that carries the wires under a point of one. */
static double head_under(const Scene *scene, uint32_t w, uint32_t p) {
  const double *ends = scene->view->wire_place + 4 * (size_t)w;
  const double part = (double)p / (scene->view->wire_points - 1);
  const double x = ends[0] + part * (ends[2] - ends[0]), y = ends[1] + part * (ends[3] - ends[1]);
  return head_at(scene, scene->model->def.wires.head, hypot(x, y),
                 atan2(y, x) / 0.017453292519943295, INFINITY);
}

/* A wire touches where it is pressed into the head, by less than a tenth of a millimetre; elsewhere
 * it is off it. The head under the wires is known to the tolerance of their grid (projection.h) and
 * without what it yields by modes that are left out (wire_yield.h): a micrometre. */
static void assert_wires_touch_where_they_press(const Scene *scene) {
  const TaborView *view = scene->view;
  const double side = scene->model->wires.side, radius = view->radius;
  uint32_t touching = 0;
  for (uint32_t i = 0; i < view->wire_count * view->wire_points; i++) {
    const uint32_t w = i / view->wire_points, p = i % view->wire_points;
    if (p == 0 || p + 1 == view->wire_points) continue;
    const double *ends = view->wire_place + 4 * (size_t)w;
    if (hypot(ends[0], ends[1]) > radius && (p < 4 || p > 28)) continue; /* beyond the head */
    const double depth = side * (head_under(scene, w, p) - view->wires[i]);
    touching += view->wire_force[i] > 0.0;
    if (depth > 1e-4 || (view->wire_force[i] > 0.01 && depth < -1e-6) ||
        (view->wire_force[i] == 0.0 && depth > 1e-6)) {
      fail_msg("wire %u at point %u: %g m in the head, %g N", w, p, depth, view->wire_force[i]);
    }
  }
  assert_true(touching > view->wire_count);
}

static void wires_lie_on_the_head_at_rest(void **state) {
  (void)state;
  TaborDrumDef def;
  Scene scene = snare_scene(&def);
  look(&scene);
  assert_wires_touch_where_they_press(&scene);
  scene_destroy(&scene);
}

static void wires_and_their_forces_are_the_probes(void **state) {
  (void)state;
  TaborDrumDef def;
  Scene scene = snare_scene(&def);
  strike(&scene, 2.0, 0.03, 0.0, 0);
  for (uint32_t n = 0; n < 50; n++) {
    TaborProbe probe;
    double force = 0.0;
    tabor_drum_process(scene.drum, NULL, 0, NULL, 10);
    look(&scene);
    tabor_drum_probe(scene.drum, &probe);
    assert_true(fabs(scene.view->wires[16] - probe.wire) <= 1e-15);
    for (uint32_t i = 0; i < scene.view->wire_count * 33; i++) force += scene.view->wire_force[i];
    assert_true(fabs(force - probe.wire_force) <= ROUNDING * probe.wire_force);
  }
  scene_destroy(&scene);
}

/* The ends lie as far apart as the wire is long, in the direction of the wires, and rise with the
 * strainer. */
static void wires_lie_where_they_are_defined(void **state) {
  (void)state;
  TaborDrumDef def = physics_preset("snare-14x5.5");
  def.wires.angle = 30.0;
  def.wires.rest_spread = 0.0;
  Scene scene = scene_of(&def, TABOR_QUALITY_DRAFT, (TaborViewGrid){.wire_points = 5});
  look(&scene);
  const double side = scene.model->wires.side, on = scene.view->wires[0];
  assert_true(fabs(on - side * def.wires.rest_offset) < 1e-15);
  double middle = 0.0;
  for (uint32_t w = 0; w < def.wires.count; w++) {
    const double *ends = scene.view->wire_place + 4 * (size_t)w;
    const double x = ends[2] - ends[0], y = ends[3] - ends[1];
    assert_true(fabs(hypot(x, y) - def.wires.length) < 1e-12);
    assert_true(fabs(atan2(y, x) - 3.14159265358979323846 / 6.0) < 1e-12);
    middle += ends[0] + ends[2];
  }
  assert_true(fabs(middle) < 1e-12 * def.wires.count);
  const TaborEvent off = {.type = TABOR_EVENT_PARAMETER,
                          .parameter = tabor_parameter_find("wires.strainer")->id,
                          .value = 0.0};
  tabor_drum_process(scene.drum, &off, 1, NULL, 24000);
  look(&scene);
  assert_true(side * (scene.view->wires[0] - on) >= def.wires.strainer_travel - 1e-12);
  scene_destroy(&scene);
}

/* ---- the rest ------------------------------------------------------------------------------- */

static void energies_are_the_ledgers(void **state) {
  (void)state;
  const TaborDrumDef def = physics_preset("snare-14x5.5");
  Scene scene = scene_of(&def, TABOR_QUALITY_DRAFT, (TaborViewGrid){0});
  strike(&scene, 2.0, 0.03, 0.0, 500);
  TaborLedger ledger;
  look(&scene);
  tabor_drum_ledger(scene.drum, &ledger);
  assert_memory_equal(&scene.view->ledger, &ledger, sizeof ledger);
  assert_true(ledger.injected > 0.0);
  scene_destroy(&scene);
}

/* A look changes nothing of the drum, and the same instant looks the same twice. */
static void looking_is_all_that_it_does(void **state) {
  (void)state;
  const TaborDrumDef def = physics_preset("snare-14x5.5");
  Scene scene = scene_of(&def, TABOR_QUALITY_DRAFT, (TaborViewGrid){0});
  strike(&scene, 2.0, 0.03, 0.0, 500);
  const size_t size = tabor_drum_state_size(scene.drum);
  char *before = malloc(2 * size), *after = before + size;
  assert_non_null(before);
  tabor_drum_state_save(scene.drum, before);
  look(&scene);
  const double first = largest(scene.view, 0);
  look(&scene);
  assert_true(largest(scene.view, 0) == first);
  tabor_drum_state_save(scene.drum, after);
  assert_memory_equal(before, after, size);
  free(before);
  scene_destroy(&scene);
}

static void a_drum_on_another_model_is_not_seen(void **state) {
  (void)state;
  const TaborDrumDef def = physics_membrane();
  Scene scene = scene_of(&def, TABOR_QUALITY_DRAFT, (TaborViewGrid){0});
  TaborModel *other = physics_model(&def, RATE, TABOR_QUALITY_DRAFT);
  TaborDrum *drum = physics_drum(other);
  strike(&scene, 2.0, 0.03, 0.0, 100);
  look(&scene);
  const double seen = largest(scene.view, 0);
  assert_false(tabor_drum_view(drum, scene.view));
  assert_true(largest(scene.view, 0) == seen && seen > 0.0);
  tabor_drum_destroy(drum);
  tabor_model_release(other);
  scene_destroy(&scene);
}

static void a_grid_out_of_range_is_refused(void **state) {
  (void)state;
  const TaborDrumDef def = physics_membrane();
  TaborModel *model = physics_model(&def, RATE, TABOR_QUALITY_DRAFT);
  const struct {
    TaborViewGrid grid;
    const char *key;
  } cases[] = {{{.radii = 1}, "radii"},
               {{.radii = TABOR_VIEW_RADII + 1}, "radii"},
               {{.angles = TABOR_VIEW_ANGLES + 1}, "angles"},
               {{.wire_points = 1}, "wire_points"},
               {{.wire_points = TABOR_VIEW_WIRE_POINTS + 1}, "wire_points"},
               {{.bandwidth = -1.0}, "bandwidth"},
               {{.bandwidth = NAN}, "bandwidth"}};
  for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
    TaborView *view = (TaborView *)model;
    TaborError error;
    assert_int_equal(tabor_view_create(model, &cases[i].grid, &view, &error), TABOR_ERROR_RANGE);
    assert_string_equal(error.key, cases[i].key);
    assert_null(view);
  }
  TaborView *view;
  assert_int_equal(tabor_view_create(NULL, NULL, &view, NULL), TABOR_ERROR_ARGUMENT);
  assert_int_equal(tabor_view_create(model, NULL, NULL, NULL), TABOR_ERROR_ARGUMENT);
  tabor_view_destroy(NULL);
  tabor_model_release(model);
}

int main(void) {
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(a_silent_drum_is_flat),
    cmocka_unit_test(a_head_hangs_under_its_weight),
    cmocka_unit_test(heads_are_sums_over_their_modes),
    cmocka_unit_test(the_centre_is_where_the_probe_says),
    cmocka_unit_test(the_edge_stays),
    cmocka_unit_test(a_stroke_in_the_centre_is_seen_as_circles),
    cmocka_unit_test(a_stick_dents_the_head),
    cmocka_unit_test(a_rimshot_has_two_places),
    cmocka_unit_test(wires_lie_on_the_head_at_rest),
    cmocka_unit_test(wires_and_their_forces_are_the_probes),
    cmocka_unit_test(wires_lie_where_they_are_defined),
    cmocka_unit_test(energies_are_the_ledgers),
    cmocka_unit_test(looking_is_all_that_it_does),
    cmocka_unit_test(a_drum_on_another_model_is_not_seen),
    cmocka_unit_test(a_grid_out_of_range_is_refused),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
