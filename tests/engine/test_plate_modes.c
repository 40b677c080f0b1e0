/* SPDX-License-Identifier: MIT */
/* A flat plate as a body: its modes beside the literature, the air on a rigid disc, its energy
 * account. */
#include "bodies/plate/free_plate.h"
#include "bodies/plate/plate_modes.h"
#include "math/bessel.h"
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
  const double unit =
    sqrt(tb_plate_stiffness(&def.plate) / (def.plate.density * def.plate.thickness)) /
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

/* The same shape by its Bessel amplitudes, and its square by the rectangle rule. */
static void shapes_are_their_bessel_series(void **state) {
  (void)state;
  enum { POINTS = 2000, ZEROS = 64, MODES = 16 };
  for (uint32_t m = 0; m < 7; m++) {
    TbFreePlateMode modes[MODES];
    double zeros[ZEROS];
    const uint32_t count = tb_free_plate_modes(m, 0.3, 16.0, modes, MODES);
    const uint32_t terms = tb_bessel_zeros(m, 120.0, zeros, ZEROS);
    for (uint32_t k = 0; k < count; k++) {
      double worst = 0.0, square = 0.0;
      for (uint32_t i = 0; i < POINTS; i++) {
        const double x = (i + 0.5) / POINTS, l = modes[k].lambda;
        const double exact =
          l > 0.0 ? tb_bessel_j(m, l * x) + modes[k].c * modified(m, l, x) : pow(x, m);
        double sum = modes[k].edge * pow(x, m);
        for (uint32_t z = 0; z < terms; z++) {
          sum += tb_free_plate_amplitude(&modes[k], zeros[z], tb_bessel_j(m + 1, zeros[z])) *
                 tb_bessel_j(m, zeros[z] * x);
        }
        worst = fmax(worst, fabs(sum - exact));
        square += exact * exact * x / POINTS;
      }
      assert_true(worst < 2e-4);
      assert_true(fabs(square / modes[k].square - 1.0) < 1e-5);
    }
    assert_true(count >= 2);
  }
}

/* A light disc on its mount: the air adds 8/3 rho0 R^3 to its mass while sound is long [Lamb1932].
 */
static void a_heaving_disc_carries_the_air_of_a_rigid_one(void **state) {
  (void)state;
  TaborDrumDef def = plate_def();
  def.plate = (TaborPlateDef){.thickness = 0.02,
                              .youngs_modulus = 1e12,
                              .poisson_ratio = 0.3,
                              .density = 100.0,
                              .heave_frequency = 5.0,
                              .tilt_frequency = 1.0};
  def.quality.bandwidth = 2000.0;
  const double own = PI * def.shell.radius * def.shell.radius * 2.0;
  const double air = 8.0 / 3.0 * def.air.density * pow(def.shell.radius, 3.0);
  TaborModel *model = physics_model(&def, 48000.0, TABOR_QUALITY_LIVE);
  TaborModeInfo mode = {.m = 1};
  for (uint32_t row = 0; tabor_model_mode(model, row, &mode); row++) {
    if (mode.m == 0 && mode.n == 0) break;
  }
  const double ratio = mode.frequency / 5.0 * sqrt((own + air) / own);
  print_message("heave at %.4f Hz: %.5f of a rigid disc's\n", mode.frequency, ratio);
  assert_true(fabs(ratio - 1.0) < 1e-3);
  tabor_model_release(model);
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
    tb_body_add_lift(&model->body, r, radial);
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
    const TaborDrumDef def = plate_def();
    TaborModel *model = physics_model(&def, 48000.0, (TaborQuality)quality);
    TaborDrum *drum = physics_drum(model);
    TaborEvent strokes[7];
    for (uint32_t i = 0; i < 7; i++) {
      const bool sweeps = i == TABOR_TECHNIQUE_SWEEP || i == TABOR_TECHNIQUE_PLUCK;
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
  const TaborDrumDef plate = plate_def();
  double pitch;
  assert_int_equal(tabor_drum_def_pitch(&plate, TABOR_HEAD_BATTER, &pitch, NULL), TABOR_ERROR_NAME);
}

int main(void) {
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(eigenvalues_are_those_of_the_literature),
    cmocka_unit_test(shapes_are_their_bessel_series),
    cmocka_unit_test(a_heaving_disc_carries_the_air_of_a_rigid_one),
    cmocka_unit_test(modes_have_unit_mass_and_are_orthogonal),
    cmocka_unit_test(the_energy_account_closes),
    cmocka_unit_test(a_plate_has_no_high_band),
    cmocka_unit_test(a_swap_continues_plates_alone),
    cmocka_unit_test(what_a_plate_has_not_got_is_refused),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
