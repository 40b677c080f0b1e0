/* SPDX-License-Identifier: MIT */
/* What stands for the head's truncated modes under a striker: against the modes themselves, in its
 * limits, and as a part of the drum's state and energy. */
#include "physics.h"

#include "math/bessel.h"
#include "model/truncated_modes.h"

static const double PI = 3.14159265358979323846;
static const double RATE = 48000.0;

/* ---- the physics ---------------------------------------------------------------------------- */

static TbSheetInAir in_air_of(const TaborDrumDef *def) {
  return (TbSheetInAir){&def->batter, &def->air, def->quality.losses != 0};
}

/* B = 2 J1(u)/u */
static double patch(double u) { return u > 0.0 ? 2.0 * tb_bessel_j(1, u) / u : 1.0; }

/* (1/(2 pi T)) Int_x^inf (2 J1(u)/u)^2 du/u, the integral by SciPy. */
static void compliance_is_the_integral(void **state) {
  (void)state;
  const TaborDrumDef def = physics_membrane();
  const TbSheetInAir in_air = in_air_of(&def);
  static const double FROM[] = {0.1, 1.0, 2.0};
  static const double INTEGRAL[] = {2.6697659578572583, 0.4846673079094604, 0.08314186405824218};
  for (int i = 0; i < 3; i++) {
    const double a = 0.006, expected = INTEGRAL[i] / (2.0 * PI * def.batter.tension);
    double compliance, inverse_mass;
    tb_truncated_modes_between(&in_air, a, FROM[i] / a, INFINITY, &compliance, &inverse_mass);
    print_message("from K a = %.1f: %.6g m/N, %.6g expected\n", FROM[i], compliance, expected);
    assert_true(fabs(compliance / expected - 1.0) < 1e-3);
  }
}

/* Static compliance at r of all modes of the whole head from z = bottom on, cosine and sine copies.
 */
static double modal_compliance(const TaborDrumDef *def, double a, double r, double bottom) {
  static double zeros[128];
  const double radius = def->shell.radius, top = 240.0;
  double sum = 0.0;
  for (uint32_t m = 0; m < 240; m++) {
    const uint32_t count = tb_bessel_zeros(m, top, zeros, 128);
    for (uint32_t n = 0; n < count; n++) {
      if (zeros[n] < bottom) continue;
      const double k = zeros[n] / radius, slope = tb_bessel_j(m + 1, zeros[n]);
      const double norm = (m ? PI : 2.0 * PI) * radius * radius * 0.5 * slope * slope;
      const double shape = tb_bessel_j(m, k * r) * patch(k * a);
      sum += shape * shape / (norm * def->batter.tension * k * k);
    }
  }
  return sum;
}

/* An infinite membrane for a finite one: right but for how many modes happen to lie just above the
 * limit. */
static void compliance_is_that_of_the_missing_modes(void **state) {
  (void)state;
  const TaborDrumDef def = physics_membrane();
  const TbSheetInAir in_air = in_air_of(&def);
  const double a = 0.02, radius = def.shell.radius;
  for (double bottom = 10.0; bottom < 45.0; bottom *= 2.0) {
    double mean = 0.0, compliance, inverse_mass;
    for (int i = 0; i < 6; i++)
      mean += modal_compliance(&def, a, (0.2 + 0.1 * i) * radius, bottom) / 6;
    tb_truncated_modes_between(&in_air, a, bottom / radius, INFINITY, &compliance, &inverse_mass);
    print_message("modes from z = %.0f: %.4g m/N, %.4g as an infinite membrane\n", bottom, mean,
                  compliance);
    assert_true(fabs(compliance / mean - 1.0) < 0.1);
  }
}

/* d/f of the oscillators at omega, as they are in time (not in steps). */
static void response(const TbTruncatedModes *m, double omega, double *re, double *im) {
  *re = *im = 0.0;
  for (uint32_t i = 0; i < TB_TRUNCATED; i++) {
    const double decay = -0.5 * log(m->b[i]) * RATE;
    const double turn = acos(0.5 * m->a[i] / sqrt(m->b[i])) * RATE;
    const double x = turn * turn + decay * decay - omega * omega, y = 2.0 * decay * omega;
    const double size = m->shape[i] * m->shape[i] / (x * x + y * y);
    *re += x * size;
    *im += y * size; /* of the loss: d lags behind f */
  }
}

/* A resonance's slow tails take that much from where the mobility is and leave it where it is not.
 */
static const double SMEARED = 0.25;

/* Above the limit, but for the edge of the first cell, waves carry away what an infinite membrane's
 * do, omega B^2/(4 T) of mobility; well below, there is a spring. */
static void oscillators_answer_like_the_membrane(void **state) {
  (void)state;
  const TaborDrumDef def = physics_membrane();
  const TbSheetInAir in_air = in_air_of(&def);
  const double a = 0.006, limit = 2.0 * PI * 4000.0;
  const double speed = sqrt(def.batter.tension / def.batter.surface_density);
  TbTruncatedModes m;
  tb_truncated_modes_prepare(&m, &in_air, 4000.0, a, 1.0 / RATE);
  double re, im, worst = 0.0;
  for (double omega = 1.25 * limit; omega < 2.0 * limit; omega *= 1.02) {
    response(&m, omega, &re, &im);
    const double b = patch(omega / speed * a),
                 expected = omega * b * b / (4.0 * def.batter.tension);
    worst = fmax(worst, fabs(omega * im / expected - 1.0));
  }
  double compliance, inverse_mass;
  tb_truncated_modes_between(&in_air, a, limit / speed, INFINITY, &compliance, &inverse_mass);
  response(&m, 0.1 * limit, &re, &im);
  print_message("mobility above the limit within %.1f %%; below it %.3f of the static compliance\n",
                100.0 * worst, re / compliance);
  assert_true(worst < SMEARED);
  assert_true(fabs(re / compliance - 1.0) < 0.03);
  assert_true(im < 0.03 * re);
}

static double static_compliance(const TbTruncatedModes *m) {
  double sum = 0.0;
  for (uint32_t i = 0; i < TB_TRUNCATED; i++) {
    if (m->stiffness[i] > 0.0) sum += m->shape[i] * m->shape[i] / m->stiffness[i];
  }
  return sum;
}

static void nothing_is_left_in_the_limits(void **state) {
  (void)state;
  const TaborDrumDef def = physics_membrane();
  const TbSheetInAir in_air = in_air_of(&def);
  TbTruncatedModes m;
  double last = INFINITY;
  for (double limit = 500.0; limit <= 8000.0; limit *= 2.0) {
    tb_truncated_modes_prepare(&m, &in_air, limit, 0.006, 1.0 / RATE);
    const double compliance = static_compliance(&m);
    assert_true(compliance > 0.0 && compliance < 0.7 * last);
    last = compliance;
  }
  const TbTruncatedModes none = {0};
  tb_truncated_modes_prepare(&m, &in_air, 9000.0, 0.05, 1.0 / RATE);
  assert_true(static_compliance(&m) < 1e-2 * last);
  tb_truncated_modes_prepare(&m, &in_air, 4000.0, 0.0, 1.0 / RATE);
  assert_memory_equal(&m, &none, sizeof m);
}

/* A band that ends where the cells would end leaves one cell, with all the compliance above, that
 * loses energy. */
static void one_cell_is_left_above_a_wide_band(void **state) {
  (void)state;
  const TaborDrumDef def = physics_membrane();
  const TbSheetInAir in_air = in_air_of(&def);
  const double a = 0.006, bandwidth = 17000.0,
               speed = sqrt(def.batter.tension / def.batter.surface_density);
  double compliance, inverse_mass;
  TbTruncatedModes m;
  tb_truncated_modes_between(&in_air, a, 2.0 * PI * bandwidth / speed, INFINITY, &compliance,
                             &inverse_mass);
  tb_truncated_modes_prepare(&m, &in_air, bandwidth, a, 1.0 / RATE);
  for (uint32_t i = 0; i + 1 < TB_TRUNCATED; i++) assert_true(m.shape[i] == 0.0);
  assert_true(m.loss[TB_TRUNCATED - 1] > 0.0);
  assert_true(fabs(static_compliance(&m) / compliance - 1.0) < 1e-6);
}

/* ---- the drum ------------------------------------------------------------------------------- */

enum { CONTACT = 384 }; /* 8 ms at 48 kHz: a stick's first contact lasts longer */

static TaborDrumDef bodhran(double two_way) {
  TaborDrumDef def = physics_preset("bodhran-d-string");
  def.wires.count = 0;
  def.quality.two_way_bandwidth = two_way;
  return def;
}

static void strike(TaborDrum *drum, const TaborDrumDef *def, uint32_t frames) {
  TaborEvent event = physics_strike(def);
  event.id = 1;
  event.velocity = 4.0;
  tabor_drum_process(drum, &event, 1, NULL, frames);
}

/* Level [dB] of the contact force from f/sqrt(2) to sqrt(2) f. */
static double force_level(const TaborDrumDef *def, double f) {
  TaborModel *model = physics_model(def, RATE, TABOR_QUALITY_STUDIO);
  TaborDrum *drum = physics_drum(model);
  double force[2 * CONTACT] = {0.0}, power = 0.0;
  for (int i = 0; i < 2 * CONTACT; i++) {
    if (i == 0) {
      strike(drum, def, 1);
    } else {
      tabor_drum_process(drum, NULL, 0, NULL, 1);
    }
    TaborProbe probe;
    tabor_drum_probe(drum, &probe);
    force[i] = isnan(probe.striker_force) ? 0.0 : probe.striker_force;
  }
  for (double at = f / sqrt(2.0); at < f * sqrt(2.0); at += 20.0) {
    double re = 0.0, im = 0.0;
    for (int i = 0; i < 2 * CONTACT; i++) {
      re += force[i] * cos(2.0 * PI * at / RATE * i);
      im += force[i] * sin(2.0 * PI * at / RATE * i);
    }
    power += re * re + im * im;
  }
  tabor_drum_destroy(drum);
  tabor_model_release(model);
  return 10.0 * log10(power);
}

/* The same head with all modes to 9 kHz, and with modes to 3 kHz, with what stands for the others
 * and without. */
static void a_stick_finds_the_head_as_soft_as_it_is(void **state) {
  (void)state;
  const TaborDrumDef all = bodhran(9000.0), some = bodhran(3000.0);
  TaborDrumDef bare = some;
  bare.quality.bandwidth = 3000.0; /* the head has no others */
  const double whole = force_level(&all, 4000.0);
  const double with = force_level(&some, 4000.0) - whole;
  const double without = force_level(&bare, 4000.0) - whole;
  print_message("force around 4 kHz: %+.1f dB, %+.1f dB without the truncated modes\n", with,
                without);
  /* Where mobility limits the force, it is wrong by as much as this: 2.0 dB at any rate. */
  assert_true(fabs(with) < -20.0 * log10(1.0 - SMEARED));
  assert_true(without > 5.0);
}

static TaborLedger ledger_of(const TaborDrum *drum) {
  TaborLedger ledger;
  tabor_drum_ledger(drum, &ledger);
  return ledger;
}

/* A stick taken away in mid-contact takes along what the truncated modes hold. */
static void a_retired_striker_leaves_no_energy_behind(void **state) {
  (void)state;
  for (int losses = 0; losses < 2; losses++) {
    TaborDrumDef def = bodhran(3000.0);
    def.quality.losses = losses;
    TaborModel *model = physics_model(&def, RATE, TABOR_QUALITY_STUDIO);
    TaborDrum *drum = physics_drum(model);
    strike(drum, &def, 20);
    const TaborEvent release = {.type = TABOR_EVENT_RELEASE, .id = 1};
    tabor_drum_process(drum, &release, 1, NULL, 2000);
    const TaborLedger ledger = ledger_of(drum);
    assert_true(ledger.removed > 0.0);
    assert_true(fabs(ledger.residual) < 1e-11 * ledger.injected);
    tabor_drum_destroy(drum);
    tabor_model_release(model);
  }
}

/* The swap is to be destroyed after the drum, which sounds on with its former model. */
static TaborSwap *exchange(TaborDrum *drum, TaborModel *from, TaborModel *to) {
  TaborSwap *swap;
  TaborError error;
  assert_int_equal(tabor_swap_create(from, to, &swap, &error), TABOR_OK);
  const TaborEvent event = {.type = TABOR_EVENT_SWAP, .swap = swap};
  tabor_drum_process(drum, &event, 1, NULL, 0);
  assert_ptr_equal(tabor_drum_model(drum), to);
  return swap;
}

/* In mid-contact: what the new model makes of the truncated modes is work of the player's. */
static void a_swap_in_contact_is_accounted_for(void **state) {
  (void)state;
  TaborDrumDef def = bodhran(3000.0), other = bodhran(4000.0);
  other.batter.tension *= 1.1;
  TaborModel *models[2] = {physics_model(&def, RATE, TABOR_QUALITY_STUDIO),
                           physics_model(&other, RATE, TABOR_QUALITY_STUDIO)};
  TaborDrum *drum = physics_drum(models[0]);
  TaborSwap *swaps[4];
  strike(drum, &def, 40);
  for (int i = 0; i < 4; i++) {
    swaps[i] = exchange(drum, models[i % 2], models[1 - i % 2]);
    tabor_drum_process(drum, NULL, 0, NULL, 30);
  }
  const TaborLedger ledger = ledger_of(drum);
  assert_true(ledger.control != 0.0);
  assert_true(fabs(ledger.residual) < 1e-9 * (ledger.injected + fabs(ledger.control)));
  tabor_drum_destroy(drum);
  for (int i = 0; i < 4; i++) tabor_swap_destroy(swaps[i]);
  for (int i = 0; i < 2; i++) tabor_model_release(models[i]);
}

static void assert_same_future(TaborDrum *a, TaborDrum *b) {
  for (int i = 0; i < CONTACT; i++) {
    TaborProbe x, y;
    tabor_drum_process(a, NULL, 0, NULL, 1);
    tabor_drum_process(b, NULL, 0, NULL, 1);
    tabor_drum_probe(a, &x);
    tabor_drum_probe(b, &y);
    assert_true(x.head == y.head && x.striker == y.striker && x.striker_force == y.striker_force);
  }
}

static void contact_goes_on_to_the_bit(void **state) {
  (void)state;
  const TaborDrumDef def = bodhran(3000.0);
  TaborModel *models[2] = {physics_model(&def, RATE, TABOR_QUALITY_STUDIO),
                           physics_model(&def, RATE, TABOR_QUALITY_STUDIO)};
  TaborDrum *drum = physics_drum(models[0]), *loaded = physics_drum(models[0]);
  strike(drum, &def, 40);
  const size_t size = tabor_drum_state_size(drum);
  void *bytes = malloc(size);
  assert_non_null(bytes);
  tabor_drum_state_save(drum, bytes);
  assert_int_equal(tabor_drum_state_load(loaded, bytes, size), TABOR_OK);
  assert_same_future(drum, loaded);
  assert_int_equal(tabor_drum_state_load(loaded, bytes, size), TABOR_OK);
  assert_int_equal(tabor_drum_state_load(drum, bytes, size), TABOR_OK);
  TaborSwap *const swap = exchange(loaded, models[0], models[1]);
  assert_same_future(drum, loaded);
  free(bytes);
  tabor_drum_destroy(loaded);
  tabor_swap_destroy(swap);
  tabor_drum_destroy(drum);
  for (int i = 0; i < 2; i++) tabor_model_release(models[i]);
}

int main(void) {
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(compliance_is_the_integral),
    cmocka_unit_test(compliance_is_that_of_the_missing_modes),
    cmocka_unit_test(oscillators_answer_like_the_membrane),
    cmocka_unit_test(nothing_is_left_in_the_limits),
    cmocka_unit_test(one_cell_is_left_above_a_wide_band),
    cmocka_unit_test(a_stick_finds_the_head_as_soft_as_it_is),
    cmocka_unit_test(a_retired_striker_leaves_no_energy_behind),
    cmocka_unit_test(a_swap_in_contact_is_accounted_for),
    cmocka_unit_test(contact_goes_on_to_the_bit),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
