/* SPDX-License-Identifier: MIT */
/* Large deflections of plates: potential and gradient beside their definitions, the energy account,
 * the spectrum of hard strokes, the hardening of a flat disc's lowest mode. */
#include "drum/drum.h"
#include "heads/von_karman.h"
#include "model/model.h"
#include "physics.h"
#include "step/state_check.h"
#include "windows_names.h"

static const double PI = 3.14159265358979323846;

static TaborDrumDef disc_def(void) {
  TaborDrumDef def;
  tabor_drum_def_default(&def);
  def.body.kind = TABOR_BODY_PLATE;
  def.shell.radius = 0.2;
  def.strike.radius = 0.19;
  def.plate.splitting = 0.004;
  def.mic[0].radius = 0.3;
  def.mic[0].height = 0.5;
  return def;
}

static TaborDrumDef crash_def(void) {
  TaborDrumDef def = disc_def();
  def.plate.taper = 0.65;
  def.plate.bow = 0.013;
  def.plate.bell_height = 0.014;
  def.striker[0].mass = 0.03;
  def.striker[0].contact_stiffness = 8e6;
  def.striker[0].contact_exponent = 1.5;
  def.striker[0].contact_radius = 0.005;
  return def;
}

/* Random displacements of the coupled pairs, none of sines of order 0; all together of some mm. */
static void draw(const TbPlateCoupling *plate, uint64_t *seed, float *q) {
  for (uint32_t i = 0; i < 2u * plate->tables.pairs; i++) {
    const double drawn = physics_uniform(seed, -1.0, 1.0);
    q[i] = plate->mode[i] == TB_NO_MODE ? 0.0f : (float)(2e-4 * drawn);
  }
}

typedef struct Workspace {
  float *q, *gradient, *scratch;
} Workspace;

static Workspace workspace_of(const TbPlateCoupling *plate) {
  const size_t pairs = tb_pad(2u * plate->tables.pairs) * sizeof(float);
  const size_t scratch = tb_von_karman_scratch(&plate->tables) * sizeof(float);
  return (Workspace){aligned_memory(64, pairs), aligned_memory(64, pairs),
                     aligned_memory(64, scratch)};
}

static void free_workspace(Workspace w) {
  free_aligned_memory(w.q);
  free_aligned_memory(w.gradient);
  free_aligned_memory(w.scratch);
}

/* V by the tables' own definition, in double and without any Fourier transform. */
static double direct_potential(const TbPlateCoupling *plate, const float *q) {
  const TbVonKarman *t = &plate->tables;
  enum { MOST = 256 };
  double y[2][MOST] = {{0.0}}, x[2][MOST] = {{0.0}}, sum = 0.0;
  for (uint32_t j = 0; j < t->angles; j++) {
    for (uint32_t p = 0; p < t->points; p++) {
      double a = 0.0, b = 0.0, c = 0.0;
      for (uint32_t m = 0; m < t->orders; m++) {
        const double turn = 2.0 * PI * m * j / t->angles;
        for (uint32_t i = t->first[m]; i < t->first[m + 1u]; i++) {
          const float *at = t->curvature + (size_t)3u * t->points * i + p;
          const double along = q[2u * i] * cos(turn) + q[2u * i + 1u] * sin(turn);
          const double across = q[2u * i + 1u] * cos(turn) - q[2u * i] * sin(turn);
          a += at[0] * along;
          b += at[t->points] * along;
          c += at[2u * t->points] * across;
        }
      }
      for (uint32_t m = 0; m < t->stress_orders; m++) {
        const double turn = 2.0 * PI * m * j / t->angles, s = t->ring[p] * (a * b - c * c);
        for (uint32_t f = t->first_stress[m]; f < t->first_stress[m + 1u]; f++) {
          y[0][f] += s * t->stress[(size_t)f * t->points + p] * cos(turn);
          y[1][f] += s * t->stress[(size_t)f * t->points + p] * sin(turn);
        }
      }
    }
  }
  const float *rise = t->rise;
  for (uint32_t m = 0; m < t->stress_orders; m++) {
    const uint32_t first = t->first[m], pairs = t->first[m + 1u] - first;
    for (uint32_t f = t->first_stress[m]; f < t->first_stress[m + 1u]; f++, rise += pairs) {
      for (uint32_t i = 0; i < 2u * pairs; i++) x[i % 2u][f] += rise[i / 2u] * q[2u * first + i];
      for (uint32_t copy = 0; copy < (m ? 2u : 1u); copy++)
        sum += y[copy][f] * (x[copy][f] + 0.5 * y[copy][f]);
    }
  }
  return sum;
}

static void the_kernel_finds_the_potential(void **state) {
  (void)state;
  uint64_t seed = physics_seed();
  const TaborDrumDef def = crash_def();
  for (uint32_t quality = TABOR_QUALITY_DRAFT; quality <= TABOR_QUALITY_STUDIO; quality++) {
    TaborModel *model = physics_model(&def, 48000.0, quality);
    const TbPlateCoupling *plate = &model->plate;
    Workspace w = workspace_of(plate);
    draw(plate, &seed, w.q);
    const double found = model->kernelsf->von_karman(&plate->tables, w.q, w.gradient, w.scratch);
    const double direct = direct_potential(plate, w.q);
    print_message("quality %u, %u pairs on %u x %u: V %.8g J, directly %.8g J\n", quality,
                  plate->tables.pairs, plate->tables.points, plate->tables.angles, found, direct);
    assert_true(fabs(found / direct - 1.0) < 1e-5);
    free_workspace(w);
    tabor_model_release(model);
  }
}

/* Along a random direction, by differences. */
static void the_gradient_is_that_of_the_potential(void **state) {
  (void)state;
  uint64_t seed = physics_seed();
  const TaborDrumDef def = crash_def();
  TaborModel *model = physics_model(&def, 48000.0, TABOR_QUALITY_LIVE);
  const TbPlateCoupling *plate = &model->plate;
  const uint32_t size = 2u * plate->tables.pairs;
  Workspace w = workspace_of(plate), way = workspace_of(plate), near = workspace_of(plate);
  for (uint32_t trial = 0; trial < 4; trial++) {
    double values[2], slope = 0.0;
    draw(plate, &seed, w.q);
    draw(plate, &seed, way.q);
    (void)model->kernelsf->von_karman(&plate->tables, w.q, w.gradient, w.scratch);
    for (uint32_t i = 0; i < size; i++) slope += (double)w.gradient[i] * (double)way.q[i];
    for (uint32_t side = 0; side < 2; side++) {
      const float by = side ? 1e-3f : -1e-3f;
      for (uint32_t i = 0; i < size; i++) near.q[i] = w.q[i] + by * way.q[i];
      values[side] = direct_potential(plate, near.q);
    }
    const double difference = (values[1] - values[0]) / 2e-3;
    print_message("along a direction: gradient %.6g J, differences %.6g J\n", slope, difference);
    assert_true(fabs(slope / difference - 1.0) < 1e-3);
  }
  free_workspace(w);
  free_workspace(way);
  free_workspace(near);
  tabor_model_release(model);
}

/* ---- one mode of a flat disc ------------------------------------------------------------------ */

/* A free disc with nu = 0.33 that bends as its mode (2,0) alone stores V = c E q^4/(rho^2 h R^6), q
 * of unit modal mass: tools/plate_backbone.py integrates the stress. Its
 * frequency so rises by 3/2 of V's factor times a^2/w0^2. */
static const double QUARTIC = 0.47414;   /* c */
static const double HARDENING = 0.16014; /* of w: per square of edge deflection over thickness */

static TaborDrumDef ideal_disc(void) {
  TaborDrumDef def = disc_def();
  def.plate.poisson_ratio = 0.33;
  def.plate.splitting = def.plate.damping_0 = def.plate.loss = 0.0;
  def.plate.cascade = 0.0;
  def.air.density = 0.0;
  def.quality.losses = 0;
  return def;
}

/* The place of the mode (2,0) among the pairs' displacements, and its cosine among the modes. */
static uint32_t lowest_pair(const TaborModel *model, uint32_t *mode) {
  const TbPlateCoupling *plate = &model->plate;
  const uint32_t at = 2u * plate->tables.first[2];
  *mode = plate->mode[at];
  assert_int_equal(model->body.modes[model->modes.row[*mode]].m, 2);
  return at;
}

static void one_mode_stores_its_quartic(void **state) {
  (void)state;
  const TaborDrumDef def = ideal_disc();
  TaborModel *model = physics_model(&def, 48000.0, TABOR_QUALITY_STUDIO);
  Workspace w = workspace_of(&model->plate);
  uint32_t mode;
  const uint32_t at = lowest_pair(model, &mode);
  memset(w.q, 0, 2u * model->plate.tables.pairs * sizeof *w.q);
  w.q[at] = 1e-3f;
  const double found =
    model->kernelsf->von_karman(&model->plate.tables, w.q, w.gradient, w.scratch);
  const double expected =
    QUARTIC * def.plate.youngs_modulus * pow(1e-3, 4.0) /
    (pow(def.plate.density, 2.0) * def.plate.thickness * pow(def.shell.radius, 6.0));
  print_message("V %.6g J, by integration %.6g J\n", found, expected);
  assert_true(fabs(found / expected - 1.0) < 1e-2);
  free_workspace(w);
  tabor_model_release(model);
}

/* Frequency [Hz] at which a mode that was let go at `amplitude` swings, after 0.1 s. */
static double swing(const TaborModel *model, uint32_t mode, double amplitude) {
  TaborDrum *drum = physics_drum((TaborModel *)model);
  TbView view = tb_view(drum->state, model);
  drum->state->asleep = 0;
  view.now.q[mode] = view.last.q[mode] = amplitude;
  double before = 0.0, first = 0.0, last = 0.0;
  uint32_t crossings = 0;
  for (uint32_t frame = 0; frame < 96000; frame++) {
    tabor_drum_process(drum, NULL, 0, NULL, 1);
    view = tb_view(drum->state, model);
    const double q = view.now.q[mode];
    if (frame > 4800 && before < 0.0 && q >= 0.0) {
      last = frame - q / (q - before);
      if (crossings++ == 0) first = last;
    }
    before = q;
  }
  tabor_drum_destroy(drum);
  return 48000.0 * (crossings - 1u) / (last - first);
}

static void one_mode_hardens_along_its_backbone(void **state) {
  (void)state;
  const TaborDrumDef def = ideal_disc();
  TaborModel *model = physics_model(&def, 48000.0, TABOR_QUALITY_STUDIO);
  uint32_t mode;
  (void)lowest_pair(model, &mode);
  double *radial = calloc(model->body.row_count, sizeof *radial);
  tb_body_radial(&model->body, 0, def.shell.radius, NULL, radial);
  tb_body_add_lift(&model->body, 0, def.shell.radius, radial);
  const double edge = fabs(radial[model->modes.row[mode]]);
  const double still = swing(model, mode, 1e-6);
  for (double ratio = 0.05; ratio < 0.25; ratio *= 2.0) {
    const double rise = swing(model, mode, ratio * def.plate.thickness / edge) / still - 1.0;
    const double expected = HARDENING * ratio * ratio;
    print_message("edge %.2f h: frequency higher by %.6f, expected %.6f\n", ratio, rise, expected);
    assert_true(fabs(rise / expected - 1.0) < 0.005 + 0.4 * ratio * ratio); /* the next order */
  }
  free(radial);
  tabor_model_release(model);
}

/* ---- strokes --------------------------------------------------------------------------------- */

static double relative_residual(const TaborDrum *drum) {
  TaborLedger ledger;
  tabor_drum_ledger(drum, &ledger);
  return fabs(ledger.residual) / ledger.injected;
}

/* A roll of a hundred joules, a hand that stops it, and strokes at every cap. */
static void the_energy_account_closes(void **state) {
  (void)state;
  for (uint32_t cap = 1; cap <= 16; cap += 5) {
    TaborDrumDef def = crash_def();
    def.quality.newton_cap = cap;
    TaborModel *model = physics_model(&def, 48000.0, TABOR_QUALITY_LIVE);
    TaborDrum *drum = physics_drum(model);
    TaborEvent events[24] = {{.type = TABOR_EVENT_STRIKE}};
    for (uint32_t i = 0; i < 24; i++) {
      events[i] = (TaborEvent){.frame = 2000 * i,
                               .type = TABOR_EVENT_STRIKE,
                               .velocity = 15.0 + (i % 3),
                               .radius = 0.15 + 0.01 * (i % 5),
                               .angle = 37.0 * i};
    }
    events[23] =
      (TaborEvent){.frame = 47000, .type = TABOR_EVENT_DAMP, .radius = 0.19, .value = 20.0};
    double worst = 0.0;
    for (uint32_t block = 0; block < 60; block++) {
      TaborEvent now[24];
      uint32_t count = 0;
      for (uint32_t i = 0; i < 24; i++) {
        if (events[i].frame / 1000 != block) continue;
        now[count] = events[i];
        now[count++].frame %= 1000;
      }
      tabor_drum_process(drum, now, count, NULL, 1000);
      if (block > 0) worst = fmax(worst, relative_residual(drum));
    }
    TaborLedger ledger;
    tabor_drum_ledger(drum, &ledger);
    print_message("cap %u: %.1f J came in, residual %.2g of it\n", cap, ledger.injected, worst);
    assert_true(ledger.injected > 60.0);
    assert_true(worst < 1e-9);
    tabor_drum_destroy(drum);
    tabor_model_release(model);
  }
}

/* The forces may act in every step, or in one of n, and in none for a while: no energy is made. */
static void no_energy_is_made_however_seldom_forces_act(void **state) {
  (void)state;
  for (uint32_t n = 1; n <= 64; n *= 2) {
    const TaborDrumDef def = crash_def();
    TaborModel *model = physics_model(&def, 48000.0, TABOR_QUALITY_LIVE);
    TaborDrum *drum = physics_drum(model);
    double worst = 0.0;
    for (uint32_t i = 0; i < 8; i++) {
      const TaborEvent stroke = {.type = TABOR_EVENT_STRIKE,
                                 .velocity = 12.0,
                                 .radius = 0.15 + 0.005 * i,
                                 .angle = 50.0 * i};
      model->plate.every = i % 2 ? n : 1; /* it jumps, too */
      tabor_drum_process(drum, &stroke, 1, NULL, 3000);
      worst = fmax(worst, relative_residual(drum));
    }
    print_message("one step of %u: residual %.2g of what came in\n", n, worst);
    assert_true(worst < physics_residual(TABOR_QUALITY_LIVE));
    tabor_drum_destroy(drum);
    tabor_model_release(model);
  }
}

/* Energy of the modes in an octave around `centre` [Hz]. */
static double octave_energy(const TaborDrum *drum, double centre) {
  const TbView view = tb_view(drum->state, drum->model);
  const TaborModel *model = drum->model;
  double sum = 0.0;
  for (uint32_t i = 0; i < model->modes.padded; i++) {
    if (model->modes.row[i] == TB_NO_MODE) continue;
    const double frequency = model->body.modes[model->modes.row[i]].omega / (2.0 * PI);
    if (frequency < centre / sqrt(2.0) || frequency > centre * sqrt(2.0)) continue;
    sum += 0.5 * tb_pole_energy(model->step_rate, model->modes.stiffness[i], view.now.q[i],
                                view.last.q[i]);
  }
  return sum;
}

/* Of what the stroke left, how much is at 2 kHz after 10 and after 100 ms. */
static void stroke_spectrum(double velocity, double coupling, double share[2]) {
  TaborDrumDef def = crash_def();
  def.plate.large_deflections = coupling;
  TaborModel *model = physics_model(&def, 48000.0, TABOR_QUALITY_LIVE);
  TaborDrum *drum = physics_drum(model);
  const TaborEvent stroke = {
    .type = TABOR_EVENT_STRIKE, .velocity = velocity, .radius = def.strike.radius};
  tabor_drum_process(drum, &stroke, 1, NULL, 480);
  share[0] = octave_energy(drum, 2000.0) / (0.015 * velocity * velocity);
  tabor_drum_process(drum, NULL, 0, NULL, 4320);
  share[1] = octave_energy(drum, 2000.0) / (0.015 * velocity * velocity);
  tabor_drum_destroy(drum);
  tabor_model_release(model);
}

/* A linear plate's treble only falls and has the same share at every speed of a linear contact;
 * large deflections feed it, the more the harder the stroke. */
static void hard_strokes_bloom(void **state) {
  (void)state;
  double linear[2], soft[2], hard[2];
  stroke_spectrum(4.0, 0.0, linear);
  stroke_spectrum(1.0, 1.0, soft);
  stroke_spectrum(4.0, 1.0, hard);
  print_message("2 kHz after 10 and 100 ms: linear %.2g %.2g, 1 m/s %.2g %.2g, 4 m/s %.2g %.2g\n",
                linear[0], linear[1], soft[0], soft[1], hard[0], hard[1]);
  assert_true(linear[1] < linear[0]);
  assert_true(hard[1] > 3.0 * hard[0] && hard[1] > 10.0 * linear[1]);
  assert_true(hard[1] > 10.0 * soft[1]);
}

/* A saved state whose plate cannot be is refused. */
static void a_state_that_cannot_be_is_refused(void **state) {
  (void)state;
  const TaborDrumDef def = crash_def();
  TaborModel *model = physics_model(&def, 48000.0, TABOR_QUALITY_DRAFT);
  TaborDrum *drum = physics_drum(model);
  const TaborEvent stroke = {
    .type = TABOR_EVENT_STRIKE, .velocity = 4.0, .radius = def.strike.radius};
  tabor_drum_process(drum, &stroke, 1, NULL, 480);
  const TbPlateState sane = drum->state->plate;
  assert_true(tb_state_check(model, drum->state));
  drum->state->plate.part = 1.5;
  assert_false(tb_state_check(model, drum->state));
  drum->state->plate = sane;
  drum->state->plate.shift = -1.0;
  assert_false(tb_state_check(model, drum->state));
  drum->state->plate = sane;
  drum->state->plate.psi[1] = NAN;
  assert_false(tb_state_check(model, drum->state));
  tabor_drum_destroy(drum);
  tabor_model_release(model);
}

int main(void) {
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(the_kernel_finds_the_potential),
    cmocka_unit_test(the_gradient_is_that_of_the_potential),
    cmocka_unit_test(one_mode_stores_its_quartic),
    cmocka_unit_test(one_mode_hardens_along_its_backbone),
    cmocka_unit_test(the_energy_account_closes),
    cmocka_unit_test(no_energy_is_made_however_seldom_forces_act),
    cmocka_unit_test(hard_strokes_bloom),
    cmocka_unit_test(a_state_that_cannot_be_is_refused),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
