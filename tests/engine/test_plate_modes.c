/* SPDX-License-Identifier: MIT */
/* A plate as a body: its modes beside the literature, flat and bowed, the air on a rigid disc, its
 * energy account. */
#include "bodies/plate/disc_modes.h"
#include "bodies/plate/plate_modes.h"
#include "math/bessel.h"
#include "math/quadrature.h"
#include "model/model.h"
#include "physics.h"

static const double PI = 3.14159265358979323846;

/* lambda^2 of a free disc with nu = 0.33 [Leissa1969] table 2.5, [Amabili1995]. */
typedef struct Known {
  uint32_t m, n;
  double square;
} Known;
static const Known KNOWN[] = {{2, 0, 5.262},  {0, 1, 9.069}, {3, 0, 12.244}, {1, 1, 20.513},
                              {4, 0, 21.527}, {5, 0, 33.06}, {2, 1, 35.24},  {0, 2, 38.51}};
enum { KNOWN_COUNT = sizeof KNOWN / sizeof *KNOWN };

/* Half of the last digit that is printed. */
static double grain(double square) { return square > 30.0 ? 0.005001 : 0.0005001; }

static TaborDrumDef plate_def(void) {
  TaborDrumDef def;
  tabor_drum_def_default(&def);
  def.body.kind = TABOR_BODY_PLATE;
  def.shell.radius = 0.2;
  def.strike.radius = 0.15;
  def.plate.poisson_ratio = 0.33;
  def.mic[0].height = 0.3;
  return def;
}

static void eigenvalues_are_those_of_the_literature(void **state) {
  (void)state;
  TaborDrumDef def = plate_def();
  def.air.density = 0.0;
  TaborModel *model = physics_model(&def, 48000.0, TABOR_QUALITY_LIVE);
  const double unit = sqrt(tb_plate_stiffness(&def.plate, def.plate.thickness) /
                           (def.plate.density * def.plate.thickness)) /
                      (def.shell.radius * def.shell.radius);
  for (uint32_t i = 0; i < KNOWN_COUNT; i++) {
    TaborModeInfo mode = {.m = UINT32_MAX};
    for (uint32_t row = 0; tabor_model_mode(model, row, &mode); row++) {
      if (mode.m == KNOWN[i].m && mode.n == KNOWN[i].n) break;
    }
    const double square = 2.0 * PI * mode.frequency / unit;
    print_message("(%u,%u): %.4f, %.3f in the literature\n", mode.m, mode.n, square,
                  KNOWN[i].square);
    assert_int_equal(mode.part, TABOR_PART_PLATE);
    assert_true(fabs(square - KNOWN[i].square) < grain(KNOWN[i].square));
  }
  tabor_model_release(model);
}

/* (c/I_m(l)) I_m(l x), by the series in (l x/2)^2. */
static double modified(uint32_t m, double l, double x) {
  double above = 0.0, below = 0.0, a = 1.0, b = 1.0;
  for (uint32_t q = 0; q < 200; q++) {
    above += a;
    below += b;
    const double next = (q + 1.0) * (q + 1.0 + m);
    a *= 0.25 * l * l * x * x / next;
    b *= 0.25 * l * l / next;
  }
  return pow(x, m) * above / below;
}

/* The same shape by its Bessel amplitudes. */
static void shapes_are_their_bessel_series(void **state) {
  (void)state;
  enum { POINTS = 2000, ZEROS = 64, MODES = 16 };
  for (uint32_t m = 0; m < 7; m++) {
    TbDiscMode modes[MODES];
    double zeros[ZEROS];
    const uint32_t count = tb_disc_modes(TB_DISC_FREE, m, 0.3, 16.0, modes, MODES);
    const uint32_t terms = tb_bessel_zeros(m, 120.0, zeros, ZEROS);
    for (uint32_t k = 0; k < count; k++) {
      double worst = 0.0;
      for (uint32_t i = 0; i < POINTS; i++) {
        const double x = (i + 0.5) / POINTS, l = modes[k].lambda;
        const double exact =
          l > 0.0 ? tb_bessel_j(m, l * x) + modes[k].c * modified(m, l, x) : pow(x, m);
        double sum = modes[k].edge * pow(x, m);
        for (uint32_t z = 0; z < terms; z++) {
          sum += tb_disc_amplitude(&modes[k], zeros[z], tb_bessel_j(m + 1, zeros[z])) *
                 tb_bessel_j(m, zeros[z] * x);
        }
        worst = fmax(worst, fabs(sum - exact));
      }
      assert_true(worst < 2e-4);
    }
    assert_true(count >= 2);
  }
}

/* lambda^2 of a clamped disc [Leissa1969] table 2.1. */
static void clamped_modes_are_those_of_the_literature(void **state) {
  (void)state;
  static const double SQUARES[4][3] = {{10.2158, 39.771, 89.104},
                                       {21.26, 60.82, 120.08},
                                       {34.88, 84.58, 153.81},
                                       {51.04, 111.01, 190.30}};
  for (uint32_t m = 0; m < 4; m++) {
    TbDiscMode modes[3];
    assert_int_equal(tb_disc_modes(TB_DISC_CLAMPED, m, 0.0, 20.0, modes, 3), 3);
    for (uint32_t n = 0; n < 3; n++) {
      const double square = modes[n].lambda * modes[n].lambda;
      print_message("(%u,%u): %.4f\n", m, n, square);
      assert_true(fabs(square / SQUARES[m][n] - 1.0) < 2e-4);
    }
  }
}

/* Curvatures by differences of the values. */
static void waves_are_derivatives_of_their_values(void **state) {
  (void)state;
  const double radius = 0.2, step = 1e-5;
  for (uint32_t edge = TB_DISC_FREE; edge <= TB_DISC_CLAMPED; edge++) {
    for (uint32_t m = 0; m < 40; m += 3) {
      TbDiscMode modes[8];
      const uint32_t count = tb_disc_modes((TbDiscEdge)edge, m, 0.3, 60.0, modes, 8);
      for (uint32_t k = 0; k < count; k++) {
        double values[4][3];
        const TbDiscWave wave = {values[0], values[1], values[2], values[3]};
        const double at = 0.17, r[3] = {at - step, at, at + step};
        tb_disc_wave(&modes[k], NULL, m, radius, 3, r, &wave);
        const double *w = values[0], slope = (w[2] - w[0]) / (2.0 * step);
        const double bend = (w[2] - 2.0 * w[1] + w[0]) / (step * step);
        const double scale = 1e-4 * (1.0 + modes[k].lambda * modes[k].lambda) / (radius * radius);
        assert_true(fabs(values[1][1] - bend) < scale);
        assert_true(fabs(values[2][1] - slope / at + m * m * w[1] / (at * at)) < scale);
        assert_true(fabs(values[3][1] - m * (slope / at - w[1] / (at * at))) < scale);
      }
    }
  }
}

/* The frequencies [rad/s] of one order in vacuo without a mount's stiffness, ascending. */
static uint32_t frequencies(const TaborDrumDef *def, uint32_t m, double *omega, uint32_t room) {
  TaborModel *model = physics_model(def, 48000.0, TABOR_QUALITY_LIVE);
  TaborModeInfo mode;
  uint32_t count = 0;
  for (uint32_t row = 0; count < room && tabor_model_mode(model, row, &mode); row++) {
    if (mode.m == m) omega[count++] = 2.0 * PI * mode.frequency;
  }
  tabor_model_release(model);
  return count;
}

/* A bow has the curvature 1/R_s = 2 b/R^2 nearly everywhere alike. Axisymmetric modes of a spherical
 * cap move to omega^2 + E/(rho R_s^2), others hardly where they have no nodal circle
 * [ThomasTouzeChaigne2005]. */
static void a_cap_is_stiffer_by_its_curvature(void **state) {
  (void)state;
  enum { MODES = 12 };
  TaborDrumDef flat = plate_def();
  flat.air.density = 0.0;
  flat.plate.heave_frequency = 5.0;
  for (double bow = 0.002; bow < 0.011; bow += 0.004) {
    TaborDrumDef cap = flat;
    cap.plate.bow = bow;
    const double curvature = 2.0 * bow / (cap.shell.radius * cap.shell.radius);
    const double more = cap.plate.youngs_modulus / cap.plate.density * curvature * curvature;
    double before[MODES], after[MODES];
    assert_int_equal(frequencies(&flat, 0, before, MODES), MODES);
    assert_int_equal(frequencies(&cap, 0, after, MODES), MODES);
    assert_true(fabs(after[0] / before[0] - 1.0) < 1e-6); /* it heaves as before */
    for (uint32_t n = 1; n < MODES; n++) {
      const double ratio = (after[n] * after[n] - before[n] * before[n]) / more;
      print_message("bow %.0f mm, (0,%u): %.6f of the excess\n", 1e3 * bow, n, ratio);
      assert_true(fabs(ratio - 1.0) < 1e-3);
    }
    for (uint32_t m = 2; m < 8; m++) {
      assert_int_equal(frequencies(&flat, m, before, 1), 1);
      assert_int_equal(frequencies(&cap, m, after, 1), 1);
      assert_true(after[0] > before[0] && after[0] < 1.05 * before[0]);
    }
  }
}

/* omega^2 rho h Int w^2 dA = Int D (w'' + w'/r)^2 - 2 (1 - nu) D w'' w'/r dA of any deflection, if
 * it is a mode, and is more than the lowest one's otherwise: tapered discs by Rayleigh's quotient
 * of w = 1 - a r^2 lie above the lowest mode that bends, and close to it. */
static void a_taper_moves_modes_as_rayleighs_quotient_says(void **state) {
  (void)state;
  TaborDrumDef def = plate_def();
  def.air.density = 0.0;
  def.plate.taper = 0.6;
  def.plate.heave_frequency = 5.0;
  const double radius = def.shell.radius, nu = def.plate.poisson_ratio;
  double nodes[TB_PANEL], weights[TB_PANEL], mass[3] = {0.0}, stiffness = 0.0, omega[2];
  tb_quadrature(0.0, radius, 1, nodes, weights);
  for (uint32_t i = 0; i < TB_PANEL; i++) { /* of 1 and r^2 */
    const double x2 = nodes[i] * nodes[i] / (radius * radius), ring = nodes[i] * weights[i];
    const double h = def.plate.thickness * (1.0 - 0.4 * nodes[i] / radius);
    for (uint32_t p = 0; p < 3; p++) mass[p] += ring * def.plate.density * h * pow(x2, p);
    stiffness += ring * tb_plate_stiffness(&def.plate, h) * 8.0 * (1.0 + nu) / pow(radius, 4.0);
  }
  const double quotient = stiffness / (mass[2] - mass[1] * mass[1] / mass[0]);
  assert_int_equal(frequencies(&def, 0, omega, 2), 2);
  print_message("(0,1): omega^2 %.5g, Rayleigh's quotient %.5g\n", omega[1] * omega[1], quotient);
  assert_true(omega[1] * omega[1] < quotient && omega[1] * omega[1] > 0.8 * quotient);
}

/* A light disc that bounces on its mount at this frequency in vacuo [Hz]. */
static TaborDrumDef light_disc(double frequency) {
  TaborDrumDef def = plate_def();
  def.plate = (TaborPlateDef){.thickness = 0.02,
                              .taper = 1.0,
                              .bell_radius = 0.05,
                              .flange_width = 0.05,
                              .youngs_modulus = 1e12,
                              .poisson_ratio = 0.3,
                              .density = 100.0,
                              .heave_frequency = frequency,
                              .tilt_frequency = 1.0};
  def.quality.bandwidth = 2000.0;
  return def;
}

static TaborModeInfo heave_of(const TaborDrumDef *def) {
  TaborModel *model = physics_model(def, 48000.0, TABOR_QUALITY_LIVE);
  TaborModeInfo mode = {.m = 1};
  for (uint32_t row = 0; tabor_model_mode(model, row, &mode); row++) {
    if (mode.m == 0 && mode.n == 0) break;
  }
  tabor_model_release(model);
  return mode;
}

/* The air adds 8/3 rho0 R^3 to the mass while sound is long [Lamb1932]. */
static void a_heaving_disc_carries_the_air_of_a_rigid_one(void **state) {
  (void)state;
  const TaborDrumDef def = light_disc(5.0);
  const double own = PI * def.shell.radius * def.shell.radius * 2.0;
  const double air = 8.0 / 3.0 * def.air.density * pow(def.shell.radius, 3.0);
  const TaborModeInfo mode = heave_of(&def);
  const double ratio = mode.frequency / 5.0 * sqrt((own + air) / own);
  print_message("heave at %.4f Hz: %.5f of a rigid disc's\n", mode.frequency, ratio);
  assert_true(fabs(ratio - 1.0) < 1e-3);
}

/* And it radiates as that force of the air does, a dipole of sound: the resistance of a free disc is
 * 16/(27 pi) rho0 c0 R^2 (k R)^4 while sound is long [Lamb1932]. */
static void a_heaving_disc_radiates_as_a_dipole(void **state) {
  (void)state;
  static const double frequencies[] = {10.0, 20.0, 40.0};
  for (uint32_t i = 0; i < 3; i++) {
    const TaborDrumDef def = light_disc(frequencies[i]);
    const double radius = def.shell.radius;
    const double mass = PI * radius * radius * 2.0 + 8.0 / 3.0 * def.air.density * pow(radius, 3.0);
    const TaborModeInfo mode = heave_of(&def);
    const double kr = 2.0 * PI * mode.frequency * radius / def.air.sound_speed;
    const double expected =
      16.0 / (27.0 * PI) * def.air.density * def.air.sound_speed * radius * radius * pow(kr, 4.0);
    const double ratio = 2.0 * mode.radiation_rate * mass / expected;
    print_message("k R = %.4f: resistance %.4g N s/m, %.5f of a free disc's\n", kr,
                  2.0 * mode.radiation_rate * mass, ratio);
    assert_true(fabs(ratio - 1.0) < 1e-2 + kr * kr); /* 1 %, as all of the air's integrals */
  }
}

/* Shapes at every place have unit modal mass: rho h Int w^2 dA = 1 in vacuo. */
static void modes_have_unit_mass_and_are_orthogonal(void **state) {
  (void)state;
  enum { POINTS = 400 };
  TaborDrumDef def = plate_def();
  def.air.density = 0.0;
  def.quality.bandwidth = 2000.0;
  TaborModel *model = physics_model(&def, 48000.0, TABOR_QUALITY_LIVE);
  const uint32_t rows = model->body.row_count;
  double *radial = calloc(rows, sizeof *radial), *sums = calloc((size_t)rows * rows, sizeof *sums);
  for (uint32_t i = 0; i < POINTS; i++) {
    const double r = def.shell.radius * (i + 0.5) / POINTS;
    const double ring = def.plate.density * def.plate.thickness * r * def.shell.radius / POINTS;
    tb_body_radial(&model->body, 0, r, NULL, radial);
    tb_body_add_lift(&model->body, 0, r, radial);
    for (uint32_t a = 0; a < rows; a++) {
      for (uint32_t b = 0; b < rows; b++) sums[a * rows + b] += ring * radial[a] * radial[b];
    }
  }
  for (uint32_t a = 0; a < rows; a++) {
    for (uint32_t b = 0; b < rows; b++) {
      if (model->body.modes[a].m != model->body.modes[b].m) continue;
      const double unit = model->body.modes[a].m ? PI : 2.0 * PI;
      assert_true(fabs(unit * sums[a * rows + b] - (a == b)) < 5e-3);
    }
  }
  assert_true(rows > 50);
  free(radial);
  free(sums);
  tabor_model_release(model);
}

/* A stroke's energy ends in losses and sound, at every quality, for a wide stroke at the edge and
 * at every technique. */
static void the_energy_account_closes(void **state) {
  (void)state;
  static const double MOST[] = {[TABOR_QUALITY_DRAFT] = 1e-6,
                                [TABOR_QUALITY_LIVE] = 1e-6,
                                [TABOR_QUALITY_STUDIO] = 1e-9,
                                [TABOR_QUALITY_REFERENCE] = 1e-9};
  for (uint32_t quality = TABOR_QUALITY_DRAFT; quality <= TABOR_QUALITY_REFERENCE; quality++) {
    TaborDrumDef def = plate_def();
    if (quality % 2) {
      def.plate.taper = 0.6;
      def.plate.bow = 0.01;
      def.plate.bell_height = 0.012;
      def.plate.flange_slope = 0.3;
    }
    TaborModel *model = physics_model(&def, 48000.0, (TaborQuality)quality);
    TaborDrum *drum = physics_drum(model);
    TaborEvent strokes[7];
    for (uint32_t i = 0; i < 7; i++) {
      const bool sweeps = i == TABOR_TECHNIQUE_SWEEP || i == TABOR_TECHNIQUE_PEDAL;
      strokes[i] = (TaborEvent){.frame = 1000 * i,
                                .type = TABOR_EVENT_STRIKE,
                                .technique = sweeps ? TABOR_TECHNIQUE_NORMAL : (TaborTechnique)i,
                                .velocity = 3.0,
                                .radius = i == 0 ? def.shell.radius : 0.02 * i,
                                .angle = 30.0 * i};
    }
    tabor_drum_process(drum, strokes, 7, NULL, 12000);
    TaborLedger ledger;
    tabor_drum_ledger(drum, &ledger);
    TaborStatistics statistics;
    tabor_drum_statistics(drum, &statistics);
    const double residual = fabs(ledger.residual) / ledger.injected;
    print_message("quality %u: residual %.2g of what came in\n", quality, residual);
    assert_true(statistics.strikes == 7);
    assert_true(ledger.radiated > 0.0 && ledger.head_loss > 0.0);
    assert_true(residual < MOST[quality]);
    tabor_drum_destroy(drum);
    tabor_model_release(model);
  }
}

/* Ringing goes on if the plate becomes thicker; a head's does not go on as a plate's. Either way
 * the account closes. */
static void a_swap_continues_plates_alone(void **state) {
  (void)state;
  TaborDrumDef thin = plate_def(), thick = plate_def(), head = plate_def();
  thick.plate.thickness *= 1.1;
  head.body.kind = TABOR_BODY_DRUM;
  const struct {
    const TaborDrumDef *from, *to;
    bool continues;
  } cases[] = {{&thin, &thick, true}, {&head, &thin, false}, {&thin, &head, false}};
  for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
    TaborModel *from = physics_model(cases[i].from, 48000.0, TABOR_QUALITY_STUDIO);
    TaborModel *to = physics_model(cases[i].to, 48000.0, TABOR_QUALITY_STUDIO);
    TaborSwap *swap;
    assert_int_equal(tabor_swap_create(from, to, &swap, NULL), TABOR_OK);
    TaborDrum *drum = physics_drum(from);
    const TaborEvent events[] = {{.type = TABOR_EVENT_STRIKE, .velocity = 3.0, .radius = 0.15},
                                 {.frame = 4000, .type = TABOR_EVENT_SWAP, .swap = swap}};
    tabor_drum_process(drum, events, 2, NULL, 8000);
    TaborLedger ledger;
    tabor_drum_ledger(drum, &ledger);
    assert_true((ledger.stored > 1e-3) == cases[i].continues);
    assert_true(fabs(ledger.residual) < 1e-9 * ledger.injected);
    tabor_swap_destroy(swap);
    tabor_drum_destroy(drum);
    tabor_model_release(from);
    tabor_model_release(to);
  }
}

/* The bandwidth that a basis reaches may lie a rounding below the one that is asked for: no mode of
 * a head may fill it. */
static void a_plate_has_no_high_band(void **state) {
  (void)state;
  for (int density = 7000; density < 7100; density++) {
    TaborDrumDef def = plate_def();
    def.shell.radius = 0.15;
    def.plate.thickness = density % 2 ? 0.003 : 1e-4; /* thin ones end below 17 kHz */
    def.plate.density = density;
    def.strike.radius = 0.1;
    def.quality.bandwidth = 2000.0;
    TaborModel *model = physics_model(&def, 48000.0, TABOR_QUALITY_LIVE);
    assert_int_equal(model->high.count, 0);
    tabor_model_release(model);
  }
}

static void refuses(TaborDrumDef def, const char *key) {
  TaborError error;
  assert_int_equal(tabor_drum_def_validate(&def, &error), TABOR_ERROR_RANGE);
  assert_string_equal(error.key, key);
}

static void what_a_plate_has_not_got_is_refused(void **state) {
  (void)state;
  TaborDrumDef two = plate_def(), closed = plate_def(), wired = plate_def();
  two.two_headed = 1;
  closed.shell.boundary = TABOR_BOUNDARY_CLOSED;
  wired.wires.count = 3;
  refuses(two, "resonant");
  refuses(closed, "shell.boundary");
  refuses(wired, "wires.count");
  TaborDrumDef wide = plate_def();
  wide.plate.flange_slope = 0.3;
  wide.plate.flange_width = 0.3;
  refuses(wide, "plate.flange_width");
  const TaborDrumDef plate = plate_def();
  double pitch;
  assert_int_equal(tabor_drum_def_pitch(&plate, TABOR_HEAD_BATTER, &pitch, NULL), TABOR_ERROR_NAME);
}

int main(void) {
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(eigenvalues_are_those_of_the_literature),
    cmocka_unit_test(shapes_are_their_bessel_series),
    cmocka_unit_test(clamped_modes_are_those_of_the_literature),
    cmocka_unit_test(waves_are_derivatives_of_their_values),
    cmocka_unit_test(a_cap_is_stiffer_by_its_curvature),
    cmocka_unit_test(a_taper_moves_modes_as_rayleighs_quotient_says),
    cmocka_unit_test(a_heaving_disc_carries_the_air_of_a_rigid_one),
    cmocka_unit_test(a_heaving_disc_radiates_as_a_dipole),
    cmocka_unit_test(modes_have_unit_mass_and_are_orthogonal),
    cmocka_unit_test(the_energy_account_closes),
    cmocka_unit_test(a_plate_has_no_high_band),
    cmocka_unit_test(a_swap_continues_plates_alone),
    cmocka_unit_test(what_a_plate_has_not_got_is_refused),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
