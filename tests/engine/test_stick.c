/* SPDX-License-Identifier: MIT */
/* The stick as a body: what its two ends weigh, what a stroke brings, and the limit of a plain
 * striker. */
#include "physics.h"

#include "drum/drum.h"
#include "strikers/stick.h"

static const double RATE = 48000.0;
static const double MASS = 0.011; /* [kg] */
static const double EXACT = 1e-12;

static TaborDrumDef drum_of_radius(double radius) {
  const TaborDrumDef preset = physics_preset("snare-14x5.5-off");
  TaborDrumDef def = physics_small(&preset);
  def.shell.radius = radius;
  def.hoop.height = 0.0;
  return def;
}

static bool near(double value, double expected) {
  return fabs(value - expected) < EXACT * fabs(expected);
}

/* ---- the body -------------------------------------------------------------------------------- */

static TbStick stick_of(double mass) {
  TaborDrumDef def = drum_of_radius(0.2);
  def.striker[0].mass = mass;
  TaborModel *model = physics_model(&def, RATE, TABOR_QUALITY_DRAFT);
  const TbStick stick = model->stick[0];
  tabor_model_release(model);
  return stick;
}

/* Int mu x^n dx for mu = 1 where the beam is thickest: it is half as thick at the tip and tapers
 * over a fifth. By Simpson's rule, exact for these cubics and quartics within its steps. */
static double moment(int n) {
  enum { STEPS = 1000 };
  double sum = 0.0;
  for (int i = 0; i < STEPS; i++) {
    for (int k = 0; k < 3; k++) {
      const double x = (i + 0.5 * k) / STEPS, d = fmin(1.0, 0.5 + 2.5 * x);
      sum += (k == 1 ? 4.0 : 1.0) / (6.0 * STEPS) * d * d * pow(x, n);
    }
  }
  return sum;
}

/* A rimshot's tip weighs M. A cross-stick's ends weigh what the moments of the stick and of 1 kg of
 * hand 75 mm from the tip say. */
static void places_along_the_stick_weigh_what_mechanics_says(void **state) {
  (void)state;
  const TbStick stick = stick_of(MASS);
  TaborDrumDef def = drum_of_radius(0.3);
  const double m0 = moment(0), m1 = moment(1), m2 = moment(2);
  const double whole = MASS * m0 * m2 / (m0 * m2 - m1 * m1);
  const TbStickContacts rimshot = tb_stick_rimshot(&def, &stick, 1.0, 0.2, 0.0);
  assert_true(fabs(rimshot.tip.mass / MASS - 1.0) < 1e-9);
  print_message("a stick of %.1f g has %.1f g at its tip\n", 1e3 * whole, 1e3 * MASS);
  def.shell.radius = 0.2;
  const double s0 = whole + 1.0, s1 = whole * m1 / m0 * 0.4 + 0.075,
               s2 = whole * m2 / m0 * 0.16 + 0.075 * 0.075;
  const TbStickContacts across = tb_stick_across(&def, &stick, 1.0, 0.25 - 0.2, 0.0);
  const double x = 0.25, one = s0 * s2 - s1 * s1;
  const double at_shaft = one / (s2 - 2.0 * s1 * x + s0 * x * x);
  assert_true(fabs(across.cross / ((s2 - s1 * x) / one) - 1.0) < 1e-9);
  assert_true(fabs(across.shaft.mass / at_shaft - 1.0) < 1e-9);
  assert_true(fabs(across.tip.mass / (one / s2) - 1.0) < 1e-9);
}

static void geometry_is_that_of_the_drum(void **state) {
  (void)state;
  TaborDrumDef def = drum_of_radius(0.1778);
  const TbStick stick = stick_of(MASS);
  const TbStickContacts near_side = tb_stick_rimshot(&def, &stick, 2.5, 0.05, 30.0);
  assert_true(near(near_side.tip.radius, 0.05) && near_side.tip.angle == 30.0);
  assert_true(near_side.shaft.angle == 30.0);
  assert_true(near(near_side.shaft.gap, 2.5 * 0.8e-3));
  const TbStickContacts across = tb_stick_across(&def, &stick, 2.5, 0.1, 30.0);
  assert_true(near(across.tip.radius, 0.1) && across.tip.angle == 30.0);
  assert_true(across.shaft.angle == 210.0 && across.tip.velocity == 0.0);
  /* The hoop's height counts along the stick. */
  def.hoop.height = 0.03;
  const TbStickContacts tilted = tb_stick_rimshot(&def, &stick, 2.5, 0.1378, 30.0);
  assert_true(near(tilted.shaft.along, 0.05)); /* 3, 4 and 5 cm */
}

/* Drums too wide or too narrow for a stick. */
static void a_stick_reaches_no_farther_than_it_is_long(void **state) {
  (void)state;
  const TbStick stick = stick_of(MASS);
  for (double radius = 0.05; radius <= 0.6; radius += 0.05) {
    const TaborDrumDef def = drum_of_radius(radius);
    for (double place = 0.0; place < 0.99 * radius; place += 0.01) {
      const TbStickContacts rods[] = {tb_stick_rimshot(&def, &stick, 1.0, place, 10.0),
                                      tb_stick_across(&def, &stick, 1.0, place, 10.0)};
      for (int i = 0; i < 2; i++) {
        const TbStickContacts *rod = &rods[i];
        const double one = rod->tip.mass * rod->shaft.mass * rod->cross * rod->cross;
        assert_true(rod->tip.radius >= 0.0 && rod->tip.radius < radius);
        assert_true(one < 1.0); /* C is positive definite */
      }
    }
  }
}

/* ---- strokes --------------------------------------------------------------------------------- */

static double injected_by(const TaborDrumDef *def, TaborTechnique technique) {
  TaborModel *model = physics_model(def, RATE, TABOR_QUALITY_DRAFT);
  TaborDrum *drum = physics_drum(model);
  const TaborEvent stroke = {.type = TABOR_EVENT_STRIKE,
                             .velocity = 2.0,
                             .radius = 0.1,
                             .angle = 40.0,
                             .technique = technique};
  TaborLedger ledger;
  TaborStatistics statistics;
  tabor_drum_process(drum, &stroke, 1, NULL, 0);
  tabor_drum_ledger(drum, &ledger);
  tabor_drum_statistics(drum, &statistics);
  assert_int_equal(statistics.strikes, 1);
  assert_true(fabs(ledger.residual) < EXACT * ledger.injected);
  tabor_drum_destroy(drum);
  tabor_model_release(model);
  return ledger.injected;
}

static void strokes_bring_the_energy_of_their_motion(void **state) {
  (void)state;
  const TaborDrumDef def = drum_of_radius(0.1778);
  const double mass = def.striker[0].mass, plain = 0.5 * mass * 4.0, turn = 0.4 / 0.2778;
  const double m0 = moment(0), m1 = moment(1), m2 = moment(2), part = m0 * m2 - m1 * m1;
  /* Heights of some 1e-5 m a sample are rounded. */
  assert_true(fabs(injected_by(&def, TABOR_TECHNIQUE_NORMAL) / plain - 1.0) < 1e-9);
  assert_true(fabs(injected_by(&def, TABOR_TECHNIQUE_RIM) / plain - 1.0) < 1e-9);
  assert_true(fabs(injected_by(&def, TABOR_TECHNIQUE_RIMSHOT) / (plain * m0 * m2 / part) - 1.0) <
              1e-9);
  const double whole = mass * m0 * m2 / part, hand = 0.075 * 0.075;
  const double across =
    0.5 * (whole * m2 / m0 * 0.16 + hand) * 4.0 * turn * turn / 0.16; /* S2 (v/d)^2/2 */
  assert_true(fabs(injected_by(&def, TABOR_TECHNIQUE_CROSS_STICK) / across - 1.0) < 1e-9);
}

/* Until the shaft touches the hoop, a rimshot with a stick that does not bend is a plain stroke. */
static void a_stiff_rod_on_the_head_alone_is_the_plain_striker(void **state) {
  (void)state;
  TaborDrumDef def = drum_of_radius(0.1778);
  def.striker[0].bending_frequency = 0.0;
  TaborModel *model = physics_model(&def, RATE, TABOR_QUALITY_STUDIO);
  TaborDrum *plain = physics_drum(model), *rod = physics_drum(model);
  TaborEvent stroke = {.type = TABOR_EVENT_STRIKE, .velocity = 2.0, .radius = 0.1, .angle = 40.0};
  double most = 0.0;
  for (int i = 0; i < 38; i++) { /* 0.8 ms */
    TaborProbe a, b;
    stroke.technique = TABOR_TECHNIQUE_NORMAL;
    tabor_drum_process(plain, &stroke, i == 0, NULL, 1);
    stroke.technique = TABOR_TECHNIQUE_RIMSHOT;
    tabor_drum_process(rod, &stroke, i == 0, NULL, 1);
    tabor_drum_probe(plain, &a);
    tabor_drum_probe(rod, &b);
    most = fmax(most, a.striker_force);
    assert_true(fabs(a.striker_force - b.striker_force) < 1e-9 * most);
    assert_true(fabs(a.head - b.head) < 1e-15);
  }
  assert_true(most > 1.0);
  tabor_drum_destroy(plain);
  tabor_drum_destroy(rod);
  tabor_model_release(model);
}

/* When the head, and when the hoop is first touched [samples], 0: never. */
typedef struct Touched {
  int head, hoop;
} Touched;

static Touched first_touches(TaborModel *model, double velocity, double radius) {
  TaborDrum *drum = physics_drum(model);
  const TaborEvent stroke = {.type = TABOR_EVENT_STRIKE,
                             .velocity = velocity,
                             .radius = radius,
                             .technique = TABOR_TECHNIQUE_RIMSHOT};
  Touched first = {0, 0};
  for (int i = 1; i < 200; i++) {
    tabor_drum_process(drum, &stroke, i == 1, NULL, 1);
    const TbView view = tb_view(drum->state, drum->model);
    for (uint32_t slot = 0; slot < TB_SLOTS; slot++) {
      const TbSlot *s = &drum->state->strikers.slots[slot];
      if (!tb_slot_strikes(s)) continue;
      if (view.solve.warm.force[model->wires.stride + slot] == 0.0) continue;
      int *touched = s->on_hoop ? &first.hoop : &first.head;
      if (*touched == 0) *touched = i;
    }
  }
  tabor_drum_destroy(drum);
  return first;
}

static void a_rimshot_meets_head_and_hoop_within_a_millisecond(void **state) {
  (void)state;
  const TaborDrumDef def = physics_preset("snare-14x5.5-off");
  TaborModel *model = physics_model(&def, RATE, TABOR_QUALITY_DRAFT);
  for (double velocity = 0.3; velocity <= 12.0; velocity *= 2.5) {
    for (double radius = 0.0; radius < 0.16; radius += 0.05) {
      const Touched first = first_touches(model, velocity, radius);
      print_message("%.2f m/s at %.2f m: hoop %.2f ms after head\n", velocity, radius,
                    (first.hoop - first.head) / RATE * 1e3);
      assert_int_equal(first.head, 1);
      /* A millisecond, and the sample in which a touch is first seen. */
      assert_true(first.hoop > first.head && first.hoop <= first.head + 48 + 1);
    }
  }
  tabor_model_release(model);
}

/* ---- the hand of a cross-stick --------------------------------------------------------------- */

static const TaborEvent CROSS_STICK = {.type = TABOR_EVENT_STRIKE,
                                       .id = 5,
                                       .velocity = 2.0,
                                       .radius = 0.1,
                                       .technique = TABOR_TECHNIQUE_CROSS_STICK};

static uint32_t shaft_slot(const TbState *state) {
  for (uint32_t i = 0; i < TB_SLOTS; i++) {
    if (state->strikers.slots[i].kind == TB_SLOT_END && state->strikers.slots[i].on_hoop) return i;
  }
  return TB_SLOTS;
}

static double shaft_force(TaborDrum *drum) {
  const uint32_t shaft = shaft_slot(drum->state);
  if (shaft == TB_SLOTS) return 0.0;
  const TbView view = tb_view(drum->state, drum->model);
  return view.solve.warm.force[drum->model->wires.stride + shaft];
}

/* One step of C^-1 (z+ - 2 z + z-)/k^2 = f - (F0 + c (s+ - s-)/(2k)) e, s the shaft, by Cramer's
 * rule: the compliance, and the way without contacts. */
static void a_hand_is_a_force_and_a_centred_damper_on_the_shaft(void **state) {
  (void)state;
  const TaborDrumDef def = physics_preset("snare-14x5.5-off");
  TaborModel *model = physics_model(&def, RATE, TABOR_QUALITY_STUDIO);
  TaborDrum *drum = physics_drum(model);
  tabor_drum_process(drum, &CROSS_STICK, 1, NULL, 20);
  const uint32_t s = shaft_slot(drum->state);
  const TbSlot *shaft = &drum->state->strikers.slots[s];
  const uint32_t t = shaft->end.other;
  const TbSlot *tip = &drum->state->strikers.slots[t];
  const TbView view = tb_view(drum->state, model);
  const double k = model->time_step, c = shaft->hold.resistance;
  assert_true(c > 0.0 && shaft->hold.press > 0.0);
  const double one =
    1.0 / (tip->striker.mass * shaft->striker.mass) - shaft->end.cross * shaft->end.cross;
  const double a = 1.0 / shaft->striker.mass / one / (k * k), b = -shaft->end.cross / one / (k * k);
  const double d = 1.0 / tip->striker.mass / one / (k * k) + 0.5 * c / k, whole = a * d - b * b;
  assert_true(near(tb_stick_compliance(&view, t, t), d / whole));
  assert_true(near(tb_stick_compliance(&view, s, s), a / whole));
  assert_true(near(tb_stick_compliance(&view, t, s), -b / whole));
  /* By how much the hand bends the ways 2 z - z-: it pushes with F0 + c (s - s-)/k there. */
  const double speed = (view.now.z[s] - view.last.z[s]) / k, push = -shaft->hold.press - c * speed;
  const double ways[] = {2.0 * view.now.z[t] - view.last.z[t],
                         2.0 * view.now.z[s] - view.last.z[s]};
  const double bent[] = {tb_stick_free_height(&view, t) - ways[0],
                         tb_stick_free_height(&view, s) - ways[1]};
  assert_true(fabs(bent[0] / (-b / whole * push) - 1.0) < 1e-6); /* of 1e-2 m, rounded */
  assert_true(fabs(bent[1] / (a / whole * push) - 1.0) < 1e-6);
  tabor_drum_destroy(drum);
  tabor_model_release(model);
}

static void a_pressed_shaft_bounces_and_comes_to_rest(void **state) {
  (void)state;
  const TaborDrumDef def = physics_preset("snare-14x5.5-off");
  TaborModel *model = physics_model(&def, RATE, TABOR_QUALITY_LIVE);
  TaborDrum *drum = physics_drum(model);
  int bounces = 0, last = 0;
  double resting = 0.0, before = 0.0;
  for (int i = 1; i <= 9600; i++) { /* 0.2 s */
    tabor_drum_process(drum, &CROSS_STICK, i == 1, NULL, 1);
    const double force = shaft_force(drum);
    bounces += force > 0.0 && before == 0.0;
    if (force == 0.0) last = i;
    if (i > 4800) resting += force / 4800.0;
    before = force;
  }
  TaborLedger ledger;
  TaborStatistics statistics;
  tabor_drum_ledger(drum, &ledger);
  print_message(
    "%d bounces, in touch from %.0f ms on, with %.2f N in the second tenth; residual %.1e\n",
    bounces, 1e3 * last / RATE, resting, ledger.residual / ledger.injected);
  assert_true(bounces >= 2 && last < 4800);
  /* F0 falls from 12 N to nothing in 0.3 s: 6 N in the mean from 0.1 to 0.2 s. */
  assert_true(fabs(resting / 6.0 - 1.0) < 0.05);
  assert_true(fabs(ledger.residual) < physics_residual(TABOR_QUALITY_LIVE) * ledger.injected);
  tabor_drum_process(drum, NULL, 0, NULL, 4900);
  tabor_drum_statistics(drum, &statistics);
  assert_int_equal(statistics.in_play, 0);
  tabor_drum_destroy(drum);
  tabor_model_release(model);
}

/* A release fades the hand's force in 30 ms; the next cross-stick takes the stick of the last
 * along. */
static void a_hand_has_one_stick_and_lets_go_of_it_softly(void **state) {
  (void)state;
  const TaborDrumDef def = physics_preset("snare-14x5.5-off");
  TaborModel *model = physics_model(&def, RATE, TABOR_QUALITY_LIVE);
  TaborDrum *drum = physics_drum(model);
  TaborStatistics statistics;
  for (int i = 0; i < 10; i++) {
    tabor_drum_process(drum, &CROSS_STICK, 1, NULL, 2400);
    tabor_drum_statistics(drum, &statistics);
    assert_int_equal(statistics.in_play, 2); /* stick and palm */
  }
  assert_int_equal(statistics.strikes, 10);
  tabor_drum_process(drum, NULL, 0, NULL, 4800);
  const double force = shaft_force(drum);
  assert_true(force > 5.0);
  const TaborEvent release = {.type = TABOR_EVENT_RELEASE, .id = 5};
  tabor_drum_process(drum, &release, 1, NULL, 720); /* 15 ms */
  const double half = shaft_force(drum);
  tabor_drum_process(drum, NULL, 0, NULL, 730);
  tabor_drum_statistics(drum, &statistics);
  print_message("%.2f N, 15 ms after the release %.2f N\n", force, half);
  assert_true(half < 0.6 * force && half > 0.4 * force);
  assert_int_equal(statistics.in_play, 0);
  tabor_drum_destroy(drum);
  tabor_model_release(model);
}

int main(void) {
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(places_along_the_stick_weigh_what_mechanics_says),
    cmocka_unit_test(geometry_is_that_of_the_drum),
    cmocka_unit_test(a_stick_reaches_no_farther_than_it_is_long),
    cmocka_unit_test(strokes_bring_the_energy_of_their_motion),
    cmocka_unit_test(a_stiff_rod_on_the_head_alone_is_the_plain_striker),
    cmocka_unit_test(a_rimshot_meets_head_and_hoop_within_a_millisecond),
    cmocka_unit_test(a_hand_is_a_force_and_a_centred_damper_on_the_shaft),
    cmocka_unit_test(a_pressed_shaft_bounces_and_comes_to_rest),
    cmocka_unit_test(a_hand_has_one_stick_and_lets_go_of_it_softly),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
