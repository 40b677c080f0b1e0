/* SPDX-License-Identifier: MIT */
/* The hoop: how its modes sound, against closed forms and against the power that leaves; how it yields, rings,
 * loses energy, and goes on in another model. */
#include "physics.h"

#include "math/bessel.h"
#include "model/hoop.h"
#include "model/model.h"
#include "step/state.h"

static const double PI = 3.14159265358979323846;
static const double RATE = 48000.0;
static const double RADIUS = 0.1778, DEPTH = 0.14; /* [m] */
static const TaborAirDef AIR = {.density = 1.205, .sound_speed = 343.0};

/* ---- sound ---------------------------------------------------------------------------------- */

static double sinc(double x) { return fabs(x) > 1e-9 ? sin(x) / x : 1.0; }

/* |I| far away: h/(2 r) |J_n(x sin t) sinc((k h/2) cos t)|. */
static void far_field_is_the_closed_form(void **state) {
  (void)state;
  const double away =
    200.0; /* the middle of the wall is the origin; the rest is (h/r)^2 and k R^2/r */
  for (uint32_t n = 2; n < 6; n++) {
    for (double frequency = 400.0; frequency < 4000.0; frequency *= 2.1) {
      const double k = 2.0 * PI * frequency / AIR.sound_speed;
      double worst = 0.0, largest = 0.0;
      for (double t = 0.1; t < PI; t += 0.2) {
        double field[2];
        tb_hoop_field(n, k, RADIUS, DEPTH, away * sin(t), away * cos(t) - 0.5 * DEPTH, field);
        const double expected = DEPTH / (2.0 * away) * fabs(tb_bessel_j(n, k * RADIUS * sin(t))) *
                                fabs(sinc(0.5 * k * DEPTH * cos(t)));
        worst = fmax(worst, fabs(hypot(field[0], field[1]) - expected));
        largest = fmax(largest, expected);
      }
      assert_true(worst < 0.01 * largest);
    }
  }
}

/* The wall's integral by the midpoint rule, with points 0.6 mm apart. */
static void field_by_sums(uint32_t n, double k, double r, double z, double field[2]) {
  enum { AROUND = 900, LEVELS = 240 };
  field[0] = field[1] = 0.0;
  for (int i = 0; i < AROUND; i++) {
    const double t = PI * (i + 0.5) / AROUND;
    const double across = r * r + RADIUS * RADIUS - 2.0 * r * RADIUS * cos(t);
    for (int l = 0; l < LEVELS; l++) {
      const double up = z + DEPTH * (l + 0.5) / LEVELS, distance = sqrt(across + up * up);
      const double size =
        cos(n * t) * DEPTH / (2.0 * distance) / AROUND / LEVELS; /* 2 pi R dt dz/(4 pi d R) */
      field[0] += size * cos(k * distance);
      field[1] -= size * sin(k * distance);
    }
  }
}

/* Few points far from the wall, many near it: in front of it 2 cm away, and on the axis. The midpoint rule is
 * right to (h/distance)^2/24, less than 1e-4. */
static void field_takes_points_enough(void **state) {
  (void)state;
  const double TOLERANCE = 1e-4;
  static const double DISTANCES[] = {0.0, 0.02, 0.1, RADIUS - 0.02, RADIUS + 0.02, 0.3, 1.1};
  for (uint32_t n = 2; n < 12; n += 3) {
    for (double k = 2.0; k < 200.0; k *= 3.1) {
      double worst = 0.0, largest = 0.0;
      for (size_t i = 0; i < sizeof DISTANCES / sizeof *DISTANCES; i++) {
        double field[2], expected[2];
        tb_hoop_field(n, k, RADIUS, DEPTH, DISTANCES[i], -0.6 * DEPTH, field);
        field_by_sums(n, k, DISTANCES[i], -0.6 * DEPTH, expected);
        worst = fmax(worst, hypot(field[0] - expected[0], field[1] - expected[1]));
        largest = fmax(largest, hypot(expected[0], expected[1]));
      }
      assert_true(worst < TOLERANCE * largest);
    }
  }
}

/* What passes a sphere 100 m away, Int |p|^2/(2 rho0 c0) dA, by the field itself. */
static double power_through_sphere(uint32_t n, double omega) {
  const double away = 100.0, k = omega / AIR.sound_speed;
  double sum = 0.0;
  enum { RINGS = 400 };
  for (int i = 0; i < RINGS; i++) {
    const double t = PI * (i + 0.5) / RINGS;
    double field[2];
    tb_hoop_field(n, k, RADIUS, DEPTH, away * sin(t), away * cos(t) - 0.5 * DEPTH, field);
    const double p = omega * omega * AIR.density * RADIUS * hypot(field[0], field[1]);
    sum += p * p / (2.0 * AIR.density * AIR.sound_speed) * PI * away * away * sin(t) * PI / RINGS;
  }
  return sum;
}

static void what_leaves_is_what_the_mode_loses(void **state) {
  (void)state;
  static const uint32_t ORDER[] = {2, 3, 6};
  static const double FREQUENCY[] = {420.0, 1310.0, 3060.0};
  for (int i = 0; i < 3; i++) {
    const double omega = 2.0 * PI * FREQUENCY[i];
    const double power = power_through_sphere(ORDER[i], omega);
    /* A rate s takes 2 s (m omega^2/2) from an amplitude of 1. */
    const double lost = tb_hoop_radiation(ORDER[i], omega, &AIR, RADIUS, DEPTH) * omega * omega;
    print_message("order %u: %.5g W leave, %.5g W are lost\n", ORDER[i], power, lost);
    assert_true(fabs(power / lost - 1.0) < 0.01);
  }
}

static void long_waves_take_nothing(void **state) {
  (void)state;
  for (uint32_t n = 2; n < 5; n++) {
    const double low = tb_hoop_radiation(n, 100.0, &AIR, RADIUS, DEPTH);
    const double high = tb_hoop_radiation(n, 200.0, &AIR, RADIUS, DEPTH);
    assert_true(fabs(high / low / (4.0 * pow(4.0, n)) - 1.0) < 0.01);
  }
}

/* ---- what yields and rings ------------------------------------------------------------------- */

static TaborDrumDef drum_with_mode(double frequency, double decay) {
  const TaborDrumDef preset = physics_preset("snare-14x5.5-off");
  TaborDrumDef def = physics_small(&preset);
  memset(def.hoop.frequency, 0, sizeof def.hoop.frequency);
  def.hoop.frequency[1] = frequency;
  def.hoop.decay[1] = decay;
  return def;
}

/* Wherever it is struck, an impulse moves it by Sum 2/(m (1 + 1/n^2)), and elsewhere by that times cos n t. */
static void an_impulse_finds_the_same_mass_everywhere(void **state) {
  (void)state;
  const TaborDrumDef def = drum_with_mode(780.0, 0.0);
  TaborModel *model = physics_model(&def, RATE, TABOR_QUALITY_STUDIO);
  const double k2 = 1.0 / (RATE * RATE), mass = 0.5 * def.hoop.mass * (1.0 + 1.0 / 9.0);
  for (double angle = 0.0; angle < 6.0; angle += 0.7) {
    double here[TB_HOOP_MODES], there[TB_HOOP_MODES];
    tb_hoop_shape(&model->hoop, sin(angle), cos(angle), here);
    tb_hoop_shape(&model->hoop, sin(angle + 0.3), cos(angle + 0.3), there);
    const double own = tb_hoop_compliance(&model->hoop, here, here) * mass / k2;
    const double across = tb_hoop_compliance(&model->hoop, here, there) * mass / k2;
    /* g = k^2/(1 + tanh(sk)), where the air's part of s k is 1e-4 */
    assert_true(fabs(own - 1.0) < 1e-3);
    assert_true(fabs(across / own - cos(3.0 * 0.3)) < 1e-9);
  }
  tabor_model_release(model);
}

typedef struct SpscQueue {
  double frequency, rate, stored[2];
  TaborLedger ledger;
} SpscQueue;

/* Strokes on the rim; what is stored, and by zero crossings the pitch, between 20 and 60 ms. */
static SpscQueue ring(const TaborDrumDef *def) {
  static float sound[4800];
  float *outputs[TABOR_MAX_MICS] = {sound};
  TaborModel *model = physics_model(def, RATE, TABOR_QUALITY_STUDIO);
  TaborDrum *drum = physics_drum(model);
  const TaborEvent rim = {
    .type = TABOR_EVENT_STRIKE, .velocity = 1.0, .technique = TABOR_TECHNIQUE_RIM};
  SpscQueue found = {0};
  tabor_drum_process(drum, &rim, 1, outputs, 960);
  tabor_drum_ledger(drum, &found.ledger);
  found.stored[0] = found.ledger.stored;
  tabor_drum_process(drum, NULL, 0, outputs, 1920);
  tabor_drum_ledger(drum, &found.ledger);
  found.stored[1] = found.ledger.stored;
  double first = 0.0, last = 0.0;
  int count = 0;
  for (int i = 1; i < 1920; i++) {
    if (!(sound[i - 1] < 0.0f && sound[i] >= 0.0f)) continue;
    last = i - sound[i] / (double)(sound[i] - sound[i - 1]);
    if (count++ == 0) first = last;
  }
  found.frequency = count > 1 ? (count - 1) * RATE / (last - first) : 0.0;
  found.rate = 0.5 * log(found.stored[0] / found.stored[1]) / 0.04;
  tabor_drum_destroy(drum);
  tabor_model_release(model);
  return found;
}

static void a_struck_rim_rings_at_its_pitch_and_dies_away_at_its_rate(void **state) {
  (void)state;
  const TaborDrumDef def = drum_with_mode(1000.0, 30.0);
  const SpscQueue found = ring(&def);
  const double mass = 0.5 * def.hoop.mass * (1.0 + 1.0 / 9.0), omega = 2.0 * PI * 1000.0;
  const double air =
    tb_hoop_radiation(3, omega, &def.air, def.shell.radius, def.shell.depth) / mass;
  print_message("%.3f Hz; decays by %.3f 1/s, of these %.3f by its sound\n", found.frequency,
                found.rate, air);
  assert_true(fabs(found.frequency - 1000.0) < 0.1);
  /* The energy sways a little within each period. */
  assert_true(fabs(found.rate / (30.0 + air) - 1.0) < 0.01);
  assert_true(fabs(found.ledger.radiated / found.ledger.shell_loss / (air / 30.0) - 1.0) < 1e-9);
  assert_true(found.ledger.head_loss == 0.0 && found.ledger.wire_loss == 0.0);
  assert_true(fabs(found.ledger.residual) < 1e-12 * found.ledger.injected);
}

static void without_losses_or_air_nothing_is_lost(void **state) {
  (void)state;
  TaborDrumDef def = drum_with_mode(1000.0, 30.0);
  def.quality.losses = 0;
  const SpscQueue lossless = ring(&def);
  assert_true(lossless.ledger.shell_loss == 0.0 && lossless.ledger.radiated == 0.0);
  assert_true(fabs(lossless.stored[1] / lossless.stored[0] - 1.0) < 1e-10);
  def = drum_with_mode(1000.0, 30.0);
  def.air.density = 0.0;
  const SpscQueue silent = ring(&def);
  assert_true(silent.ledger.radiated == 0.0 && silent.ledger.shell_loss > 0.0);
  assert_true(fabs(silent.rate / 30.0 - 1.0) < 0.01);
}

/* A rim without modes is a wall: an elastic stick that does not bend comes back as fast as it came. */
static void a_rim_without_modes_does_not_yield(void **state) {
  (void)state;
  TaborDrumDef def = drum_with_mode(0.0, 0.0);
  def.hoop.contact_loss = 0.0;
  def.striker[0].bending_frequency = 0.0;
  const SpscQueue found = ring(&def);
  assert_true(found.stored[1] == 0.0 && found.ledger.contact_loss == 0.0);
  assert_true(fabs(found.ledger.removed / found.ledger.injected - 1.0) < 1e-12);
}

/* Hertz: a mass M at speed v against a rigid rim presses it with K (5 M v^2/(4 K))^(3/5) at most. */
static void a_hard_rim_is_met_as_hertz_says(void **state) {
  (void)state;
  TaborDrumDef def = drum_with_mode(0.0, 0.0);
  def.hoop.contact_loss = 0.0;
  def.striker[0].bending_frequency = 0.0;
  TaborModel *model = physics_model(&def, 192000.0, TABOR_QUALITY_STUDIO);
  TaborDrum *drum = physics_drum(model);
  const TaborEvent rim = {
    .type = TABOR_EVENT_STRIKE, .velocity = 2.0, .technique = TABOR_TECHNIQUE_RIM};
  double most = 0.0;
  for (int i = 0; i < 200; i++) {
    TaborProbe probe;
    tabor_drum_process(drum, &rim, i == 0, NULL, 1);
    tabor_drum_probe(drum, &probe);
    most = fmax(most, probe.striker_force);
  }
  const double k = def.hoop.contact_stiffness;
  const double expected = k * pow(1.25 * def.striker[0].mass * 4.0 / k, 0.6);
  print_message("%.1f N, %.1f N expected\n", most, expected);
  assert_true(fabs(most / expected - 1.0) < 0.005);
  tabor_drum_destroy(drum);
  tabor_model_release(model);
}

/* ---- in another model ------------------------------------------------------------------------ */

static void a_swap_keeps_phase_and_action(void **state) {
  (void)state;
  TaborDrumDef def = drum_with_mode(1000.0, 0.0);
  def.quality.losses = 0;
  TaborModel *from = physics_model(&def, RATE, TABOR_QUALITY_STUDIO);
  def.hoop.frequency[1] = 1200.0;
  TaborModel *to = physics_model(&def, RATE, TABOR_QUALITY_STUDIO);
  double now[TB_HOOP_MODES] = {0.3, -0.2}, last[TB_HOOP_MODES] = {0.28, -0.21};
  const double before = tb_hoop_energy(&from->hoop, RATE, now, last);
  tb_hoop_carry(&from->hoop, &to->hoop, now, last);
  const double after = tb_hoop_energy(&to->hoop, RATE, now, last);
  /* Actions are equal for energies in the ratio of sin(w k/2)^2/sin(w k),. */
  const double t0 = 2.0 * PI * 1000.0 / RATE, t1 = 2.0 * PI * 1200.0 / RATE;
  print_message("energy changes by %.6f, frequency by 1.2\n", after / before);
  assert_true(fabs(after / before / (sin(t1) / sin(t0)) - 1.0) < 1e-9);
  tb_hoop_carry(&to->hoop, &to->hoop, now, last);
  assert_true(tb_hoop_energy(&to->hoop, RATE, now, last) == after);
  tabor_model_release(from);
  tabor_model_release(to);
}

int main(void) {
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(far_field_is_the_closed_form),
    cmocka_unit_test(field_takes_points_enough),
    cmocka_unit_test(what_leaves_is_what_the_mode_loses),
    cmocka_unit_test(long_waves_take_nothing),
    cmocka_unit_test(an_impulse_finds_the_same_mass_everywhere),
    cmocka_unit_test(a_struck_rim_rings_at_its_pitch_and_dies_away_at_its_rate),
    cmocka_unit_test(without_losses_or_air_nothing_is_lost),
    cmocka_unit_test(a_rim_without_modes_does_not_yield),
    cmocka_unit_test(a_hard_rim_is_met_as_hertz_says),
    cmocka_unit_test(a_swap_keeps_phase_and_action),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
