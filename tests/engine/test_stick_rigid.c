/* SPDX-License-Identifier: MIT */
/* The stick as a body: what its two ends weigh, what a stroke brings, and the limit of a plain striker. */
#include "physics.h"

#include "drum/drum.h"
#include "strikers/stick_rigid.h"

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

/* Int mu x^n dx for mu = 1 where the beam is thickest: it is half as thick at the tip and tapers over a fifth.
 * By Simpson's rule, exact for these cubics and quartics within its steps. */
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

/* A rimshot's tip weighs M. A push at the centre of percussion does not move the tip, so
 * fingers there or at the tip do not matter. */
static void places_along_the_stick_weigh_what_mechanics_says(void **state) {
  (void)state;
  const TbStick stick = stick_of(MASS);
  TaborDrumDef def = drum_of_radius(0.3);
  const double m0 = moment(0), m1 = moment(1), m2 = moment(2);
  const double whole = MASS * m0 * m2 / (m0 * m2 - m1 * m1);
  const TbRigidStick rimshot = tb_rigid_stick_rimshot(&def, &stick, 1.0, 0.2, 0.0);
  assert_true(fabs(rimshot.tip.mass / MASS - 1.0) < 1e-9);
  print_message("a stick of %.1f g has %.1f g at its tip\n", 1e3 * whole, 1e3 * MASS);
  def.shell.radius = 0.2;
  const TbRigidStick percussion =
    tb_rigid_stick_across(&def, &stick, 1.0, 0.4 * m2 / m1 - 0.2, 0.0);
  assert_true(fabs(percussion.cross) < 1e-9 / MASS);
  assert_true(fabs(percussion.shaft.mass / (whole * m1 * m1 / (m0 * m2)) - 1.0) < 1e-9);
  assert_true(fabs(percussion.tip.mass / (MASS + 0.2) - 1.0) < 1e-9);
}

static void geometry_is_that_of_the_drum(void **state) {
  (void)state;
  TaborDrumDef def = drum_of_radius(0.1778);
  const TbStick stick = stick_of(MASS);
  const TbRigidStick near_side = tb_rigid_stick_rimshot(&def, &stick, 2.5, 0.05, 30.0);
  assert_true(near(near_side.tip.radius, 0.05) && near_side.tip.angle == 30.0);
  assert_true(near_side.shaft.angle == 30.0);
  assert_true(near(near_side.shaft.gap, 2.5 * 0.8e-3));
  const TbRigidStick across = tb_rigid_stick_across(&def, &stick, 2.5, 0.1, 30.0);
  assert_true(near(across.tip.radius, 0.1) && across.tip.angle == 30.0);
  assert_true(across.shaft.angle == 210.0 && across.tip.velocity == 0.0);
  /* The hoop's height counts along the stick. */
  def.hoop.height = 0.03;
  const TbRigidStick tilted = tb_rigid_stick_rimshot(&def, &stick, 2.5, 0.1378, 30.0);
  assert_true(near(tilted.shaft.along, 0.05)); /* 3, 4 and 5 cm */
}

/* Drums too wide or too narrow for a stick. */
static void a_stick_reaches_no_farther_than_it_is_long(void **state) {
  (void)state;
  const TbStick stick = stick_of(MASS);
  for (double radius = 0.05; radius <= 0.6; radius += 0.05) {
    const TaborDrumDef def = drum_of_radius(radius);
    for (double place = 0.0; place < 0.99 * radius; place += 0.01) {
      const TbRigidStick rods[] = {tb_rigid_stick_rimshot(&def, &stick, 1.0, place, 10.0),
                                   tb_rigid_stick_across(&def, &stick, 1.0, place, 10.0)};
      for (int i = 0; i < 2; i++) {
        const TbRigidStick *rod = &rods[i];
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
  const double across = plain * m2 * m2 / part * turn * turn;
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
      if (s->kind != TB_SLOT_STRIKER) continue;
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

int main(void) {
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(places_along_the_stick_weigh_what_mechanics_says),
    cmocka_unit_test(geometry_is_that_of_the_drum),
    cmocka_unit_test(a_stick_reaches_no_farther_than_it_is_long),
    cmocka_unit_test(strokes_bring_the_energy_of_their_motion),
    cmocka_unit_test(a_stiff_rod_on_the_head_alone_is_the_plain_striker),
    cmocka_unit_test(a_rimshot_meets_head_and_hoop_within_a_millisecond),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
