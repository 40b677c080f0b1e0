/* SPDX-License-Identifier: MIT */
/* The head's modes: Bessel zeros in vacuo, losses, air loading against measurement and closed
 * forms, shapes and patches. */
#include "bodies/drum/drum_modes.h"
#include "math/arena.h"
#include "math/bessel.h"
#include "physics.h"

static const double PI = 3.14159265358979323846;

/* Zeros of J_0 .. J_3 from Abramowitz and Stegun, table 9.5. */
static const double ZEROS[4][3] = {{2.404825557695773, 5.520078110286311, 8.653727912911013},
                                   {3.831705970207512, 7.015586669815619, 10.17346813506272},
                                   {5.135622301840683, 8.417244140399864, 11.61984117214906},
                                   {6.380161895923984, 9.761023129981670, 13.01520072169843}};

static TaborDrumDef bare_head(void) {
  TaborDrumDef def = physics_membrane();
  def.batter.damping_0 = 20.0;
  def.batter.damping_1 = 5e-4;
  def.air.gravity = 0.0;
  return def;
}

static bool find_mode(const TaborModel *model, uint32_t m, uint32_t n, TaborModeInfo *mode) {
  for (uint32_t row = 0; tabor_model_mode(model, row, mode); row++) {
    if (mode->m == m && mode->n == n) return true;
  }
  return false;
}

static void in_vacuo_the_zeros_give_frequencies_and_losses(void **state) {
  (void)state;
  for (int stiff = 0; stiff < 2; stiff++) {
    TaborDrumDef def = bare_head();
    if (stiff) def.batter.bending_stiffness = 0.01;
    TaborModel *model = physics_model(&def, 48000.0, TABOR_QUALITY_LIVE);
    for (uint32_t m = 0; m < 4; m++) {
      for (uint32_t n = 1; n <= 3; n++) {
        TaborModeInfo mode;
        assert_true(find_mode(model, m, n, &mode));
        const double k = ZEROS[m][n - 1] / 0.2;
        const double d = def.batter.bending_stiffness;
        const double f = sqrt((3000.0 * k * k + d * k * k * k * k) / 0.26) / (2.0 * PI);
        assert_true(fabs(mode.frequency / f - 1.0) < 1e-9);
        assert_true(fabs(mode.decay_rate / (0.5 * (20.0 + 5e-4 * k * k)) - 1.0) < 1e-9);
        assert_true(mode.radiation_rate == 0.0);
        assert_int_equal(mode.multiplicity, m ? 2 : 1);
      }
    }
    TaborModeInfo fundamental;
    assert_true(tabor_model_mode(model, 0, &fundamental));
    if (!stiff) assert_true(fabs(fundamental.frequency - 205.57) < 0.01); /* design: 206 Hz */
    tabor_model_release(model);
  }
}

/* sigma_k alone gives every mode of a membrane the loss factor sigma_k/c. */
static void loss_in_proportion_to_wavenumber_is_a_constant_loss_factor(void **state) {
  (void)state;
  TaborDrumDef def = physics_membrane();
  def.batter.damping_k = 0.3;
  TaborModel *model = physics_model(&def, 48000.0, TABOR_QUALITY_LIVE);
  const double factor = 0.3 / sqrt(3000.0 / 0.26);
  TaborModeInfo mode;
  uint32_t rows = 0;
  for (; tabor_model_mode(model, rows, &mode); rows++) {
    assert_true(fabs(2.0 * mode.decay_rate / (2.0 * PI * mode.frequency) / factor - 1.0) < 1e-9);
  }
  assert_true(rows > 100);
  tabor_model_release(model);
}

/* The three terms of the loss add, also where the sheet is stiff. */
static void losses_of_a_head_add(void **state) {
  (void)state;
  TaborDrumDef def = bare_head();
  def.batter.damping_k = 0.2;
  def.batter.bending_stiffness = 0.01;
  TaborModel *model = physics_model(&def, 48000.0, TABOR_QUALITY_LIVE);
  for (uint32_t m = 0; m < 4; m++) {
    TaborModeInfo mode;
    assert_true(find_mode(model, m, 3, &mode));
    const double k = ZEROS[m][2] / 0.2;
    assert_true(fabs(mode.decay_rate / (0.5 * (20.0 + 0.2 * k + 5e-4 * k * k)) - 1.0) < 1e-9);
  }
  tabor_model_release(model);
}

static void rows_are_sorted_and_complete(void **state) {
  (void)state;
  const TaborDrumDef def = bare_head();
  TaborModel *model = physics_model(&def, 48000.0, TABOR_QUALITY_LIVE);
  TaborModelInfo info;
  tabor_model_info(model, &info);
  double last = 0.0;
  uint32_t copies = 0, rows = 0;
  TaborModeInfo mode;
  for (; tabor_model_mode(model, rows, &mode); rows++) {
    assert_true(mode.frequency >= last);
    last = mode.frequency;
    copies += mode.multiplicity;
  }
  assert_int_equal(rows, info.mode_rows);
  assert_int_equal(copies, info.mode_count);
  assert_true(last <= info.two_way_bandwidth);
  /* Weyl's count with the fixed edge's correction: z^2/4 - z/2, z = 2 pi f R/c. */
  const double z = 2.0 * PI * info.two_way_bandwidth * 0.2 / sqrt(3000.0 / 0.26);
  print_message("%u modes, expected about %.0f\n", copies, z * z / 4.0 - z / 2.0);
  assert_true(fabs(copies / (z * z / 4.0 - z / 2.0) - 1.0) < 0.02);
  tabor_model_release(model);
}

/* Rossing measured 1 : 1.48 : 1.92 : 2.36 : 2.78 on a timpani head without kettle
 * [FletcherRossing]; the membrane alone would give 1 : 1.34 : 1.67 : 1.98 : 2.29. */
static void timpani_head_without_kettle_is_nearly_harmonic(void **state) {
  (void)state;
  static const double MEASURED[5] = {1.0, 1.48, 1.92, 2.36, 2.78};
  static const double BARE[5] = {1.0, 1.34, 1.67, 1.98, 2.29};
  for (int variant = 0; variant < 3; variant++) {
    TaborDrumDef def = bare_head();
    def.shell.radius = 0.328;
    def.batter.surface_density = 0.2653;
    def.batter.tension = 3990.0;
    def.shell.boundary = variant == 1 ? TABOR_BOUNDARY_BAFFLED : TABOR_BOUNDARY_OPEN;
    if (variant < 2) def.air.density = 1.205;
    TaborModel *model = physics_model(&def, 48000.0, TABOR_QUALITY_DRAFT);
    double first = 0.0;
    print_message("%s:", variant == 0 ? "open" : variant == 1 ? "baffled" : "in vacuo");
    for (uint32_t m = 1; m <= 5; m++) {
      TaborModeInfo mode;
      assert_true(find_mode(model, m, 1, &mode));
      if (m == 1) first = mode.frequency;
      const double ratio = mode.frequency / first;
      print_message(" %.3f", ratio);
      const double expected = variant < 2 ? MEASURED[m - 1] : BARE[m - 1];
      assert_true(fabs(ratio / expected - 1.0) < (variant < 2 ? 0.05 : 0.005));
    }
    print_message("  (1,1) at %.1f Hz\n", first);
    tabor_model_release(model);
  }
}

/* With so little air that nothing moves, radiation is the load at the vacuum frequency. */
static void radiation_follows_from_the_finite_frequency_resistance(void **state) {
  (void)state;
  for (int boundary = 0; boundary < 2; boundary++) {
    TaborDrumDef def = bare_head();
    def.shell.boundary = (uint32_t)boundary;
    def.air.density = 1e-6;
    TaborModel *model = physics_model(&def, 48000.0, TABOR_QUALITY_DRAFT);
    for (uint32_t m = 0; m < 2; m++) {
      TaborModeInfo mode;
      assert_true(find_mode(model, m, 1, &mode));
      const TaborAllocator system = tb_allocator_resolve(NULL);
      TbArena arena;
      tb_arena_prepare(&arena, &system);
      const double zeros[3] = {ZEROS[m][0], ZEROS[m][1], ZEROS[m][2]}, v[3] = {1.0, 0.0, 0.0};
      TbAirOrder order;
      assert_true(tb_air_order_prepare(&order, &arena, m, zeros, 3));
      TbAirLoad load;
      const double x = 2.0 * PI * mode.frequency * 0.2 / def.air.sound_speed;
      assert_true(
        tb_air_load(&order, &arena, (TaborBoundary)boundary, true, v, x, NULL, 0, &load, NULL));
      const double slope = tb_bessel_j(m + 1, zeros[0]);
      /* rate = R/(2 M): a_m rho0 c0 R^2 r/(2 rho a_m R^2 J^2/2) */
      const double expected =
        def.air.density * def.air.sound_speed * load.resistance / (0.26 * slope * slope);
      assert_true(fabs(mode.radiation_rate / expected - 1.0) < 1e-5);
      tb_arena_release(&arena);
    }
    tabor_model_release(model);
  }
}

/* Orthogonality over the disc in vacuo: unit modal mass, no coupling. */
static void shapes_have_unit_modal_mass(void **state) {
  (void)state;
  const TaborDrumDef def = bare_head();
  const TaborAllocator system = tb_allocator_resolve(NULL);
  TbArena arena;
  tb_arena_prepare(&arena, &system);
  TbBody head;
  assert_int_equal(
    tb_body_drum.prepare(&head, &arena, &def, 2000.0, (TbBodyLimits){4096, 91.0, 0.0, 0.0}),
    TABOR_OK);
  enum { STEPS = 4000, MOST = 12 };
  double mass[MOST][MOST] = {{0.0}}, *radial = tb_arena_doubles(&arena, head.row_count);
  for (int i = 0; i < STEPS; i++) {
    const double r = 0.2 * (i + 0.5) / STEPS;
    tb_body_radial(&head, 0, r, NULL, radial);
    for (int a = 0; a < MOST; a++) {
      for (int b = 0; b < MOST; b++) {
        if (head.modes[a].m != head.modes[b].m) continue;
        const double azimuth = head.modes[a].m ? PI : 2.0 * PI;
        mass[a][b] += 0.26 * azimuth * radial[a] * radial[b] * r * 0.2 / STEPS;
      }
    }
  }
  for (int a = 0; a < MOST; a++) {
    for (int b = 0; b < MOST; b++) assert_true(fabs(mass[a][b] - (a == b)) < 1e-5);
  }
  /* A patch is the mean over its disc: 2 J_1(Ka)/(Ka), 1 for a point. */
  double *patch = tb_arena_doubles(&arena, head.zero_count);
  double *patched = tb_arena_doubles(&arena, head.row_count);
  tb_body_patch(&head, 0.0, patch);
  for (uint32_t i = 0; i < head.zero_count; i++) assert_true(patch[i] == 1.0);
  tb_body_patch(&head, 0.03, patch);
  tb_body_radial(&head, 0, 0.0, patch, patched);
  for (int a = 0; a < MOST; a++) {
    double mean = 0.0;
    for (int i = 0; i < STEPS && head.modes[a].m == 0; i++) {
      const double r = 0.03 * (i + 0.5) / STEPS;
      tb_body_radial(&head, 0, r, NULL, radial);
      mean += radial[a] * 2.0 * r * 0.03 / STEPS / (0.03 * 0.03);
    }
    assert_true(fabs(patched[a] - mean) < 1e-6);
  }
  tb_arena_release(&arena);
}

/* Each Bessel function of a table is right to 3e-11; a shape sums a few of them. */
static void shapes_from_a_table_are_the_same(void **state) {
  (void)state;
  const double TOLERANCE = 1e-9;
  TaborDrumDef def;
  tabor_drum_def_default(&def);
  TbArena arena;
  const TaborAllocator allocator = tb_allocator_resolve(NULL);
  tb_arena_prepare(&arena, &allocator);
  TbBody head;
  TbBesselTable table;
  assert_int_equal(
    tb_body_drum.prepare(&head, &arena, &def, 3000.0, (TbBodyLimits){4096, 91.0, 0.0, 0.0}),
    TABOR_OK);
  assert_true(tb_bessel_table_prepare(&table, &arena, head.order_count, 60.0));
  double *patch = tb_arena_doubles(&arena, head.zero_count);
  double *exact = tb_arena_doubles(&arena, head.row_count);
  double *tabled = tb_arena_doubles(&arena, head.row_count);
  tb_body_patch(&head, 0.01, patch);
  for (double r = 0.0; r <= head.radius; r += 0.11 * head.radius) {
    double largest = 0.0;
    tb_body_radial(&head, 0, r, patch, exact);
    tb_body_radial_tabled(&head, &table, 0, r, patch, tabled);
    for (uint32_t i = 0; i < head.row_count; i++) largest = fmax(largest, fabs(exact[i]));
    for (uint32_t i = 0; i < head.row_count; i++) {
      assert_true(fabs(tabled[i] - exact[i]) < TOLERANCE * largest);
    }
  }
  tb_arena_release(&arena);
}

int main(void) {
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(in_vacuo_the_zeros_give_frequencies_and_losses),
    cmocka_unit_test(loss_in_proportion_to_wavenumber_is_a_constant_loss_factor),
    cmocka_unit_test(losses_of_a_head_add),
    cmocka_unit_test(rows_are_sorted_and_complete),
    cmocka_unit_test(timpani_head_without_kettle_is_nearly_harmonic),
    cmocka_unit_test(radiation_follows_from_the_finite_frequency_resistance),
    cmocka_unit_test(shapes_have_unit_modal_mass),
    cmocka_unit_test(shapes_from_a_table_are_the_same),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
