/* SPDX-License-Identifier: MIT */
/* The bending of sticks, against finite elements and an independent integration
 * (tools/make-reference.py): modes, a blow on a rigid support, the ringing of a stick that is
 * pressed onto one; the limit of a stiff stick; energy; and swaps. */
#include "physics.h"

#include "drum/drum.h"
#include "reference.h"
#include "strikers/stick.h"

static const double RATE = 48000.0, PI = 3.14159265358979323846;
static const char *const GRIPS[TB_GRIPS] = {"held", "free", "across"};

static TaborDrumDef frame_drum(void) {
  TaborDrumDef def = physics_membrane();
  def.striker[0].mass = 0.011;
  def.striker[0].bending_frequency = 395.0;
  return def;
}

/* ---- modes ----------------------------------------------------------------------------------- */

/* Sixteen polynomials have not quite converged: the kink at a fifth of the length and the point
 * mass bend them. */
static const double FREQUENCY_ERROR = 2e-3, SHAPE_ERROR = 1e-2;

static double frequency_of(const TbStickBody *body, uint32_t i, double rate) {
  const double decay = -0.5 * log(body->b[i]) * rate;
  const double turn = acos(0.5 * body->a[i] / sqrt(body->b[i])) * rate;
  return sqrt(turn * turn + decay * decay) / (2.0 * PI);
}

static void near_all(const json_t *expected, const double *values, double scale) {
  for (uint32_t i = 0; i < TB_BENDS; i++) {
    assert_true(fabs(values[i] - reference_number(expected, i)) < SHAPE_ERROR * scale);
  }
}

static void modes_are_those_of_finite_elements(void **state) {
  (void)state;
  json_t *root = reference_load("sticks.json");
  const TaborDrumDef def = frame_drum();
  TaborModel *model = physics_model(&def, RATE, TABOR_QUALITY_DRAFT);
  for (uint32_t grip = 0; grip < TB_GRIPS; grip++) {
    const json_t *expected = json_object_get(json_object_get(root, "grips"), GRIPS[grip]);
    const TbStickBody *body = &model->stick[0].grip[grip];
    double tip[TB_BENDS], shaft[TB_BENDS], both[3][TB_BENDS], most = 0.0;
    tb_stick_shape(body, 0.0, tip);
    tb_stick_shape(body, 0.15, shaft);
    for (uint32_t i = 0; i < TB_BENDS; i++) {
      const double hz = reference_number(json_object_get(expected, "hz"), i);
      const double error = frequency_of(body, i, RATE) / hz - 1.0;
      both[0][i] = tip[i] * tip[i];
      both[1][i] = tip[i] * shaft[i];
      both[2][i] = shaft[i] * shaft[i];
      most = fmax(most, fmax(both[0][i], both[2][i]));
      print_message("%s: %.1f Hz (%+.1e), %.2f g at the tip\n", GRIPS[grip], hz, error,
                    1e3 / both[0][i]);
      assert_true(fabs(error) < FREQUENCY_ERROR);
    }
    near_all(json_object_get(expected, "tip_tip"), both[0], most);
    near_all(json_object_get(expected, "tip_shaft"), both[1], most);
    near_all(json_object_get(expected, "shaft_shaft"), both[2], most);
  }
  tabor_model_release(model);
  json_decref(root);
}

static double rigid_part(const json_t *expected, size_t i, size_t j) {
  return reference_number(json_array_get(json_object_get(expected, "rigid"), i), j);
}

/* 0.15 m from the tip, at the height of the head: R - r = 0.15 m in a rimshot, R + r in a
 * cross-stick. */
static void the_rigid_body_is_that_of_the_beam(void **state) {
  (void)state;
  json_t *root = reference_load("sticks.json");
  TaborDrumDef def = frame_drum();
  def.hoop.height = 0.0;
  def.shell.radius = 0.145;
  TaborModel *model = physics_model(&def, RATE, TABOR_QUALITY_DRAFT);
  TaborDrumDef wide = def;
  wide.shell.radius = 0.2;
  const TbStickContacts rods[] = {tb_stick_rimshot(&wide, &model->stick[0], 1.0, 0.05, 0.0),
                                  tb_stick_across(&def, &model->stick[0], 1.0, 0.005, 0.0)};
  for (int i = 0; i < 2; i++) {
    const json_t *expected = json_object_get(json_object_get(root, "grips"), GRIPS[1 + i]);
    assert_true(fabs(1.0 / rods[i].tip.mass / rigid_part(expected, 0, 0) - 1.0) < 1e-10);
    assert_true(fabs(rods[i].cross / rigid_part(expected, 0, 1) - 1.0) < 1e-10);
    assert_true(fabs(1.0 / rods[i].shaft.mass / rigid_part(expected, 1, 1) - 1.0) < 1e-10);
  }
  tabor_model_release(model);
  json_decref(root);
}

/* Too fast for the rate: no faster than 0.35 of it, yet as compliant as before. */
static void modes_too_fast_for_the_rate_keep_their_compliance(void **state) {
  (void)state;
  TaborDrumDef def = frame_drum();
  TaborModel *slow = physics_model(&def, RATE, TABOR_QUALITY_DRAFT);
  def.striker[0].bending_frequency = 39500.0 / 2.0;
  TaborModel *fast = physics_model(&def, RATE, TABOR_QUALITY_DRAFT);
  for (uint32_t i = 0; i < TB_BENDS; i++) {
    const TbStickBody *a = &slow->stick[0].grip[0], *b = &fast->stick[0].grip[0];
    const double w = frequency_of(a, i, RATE), v = frequency_of(b, i, RATE);
    const double ratio = (b->shape[i][0] / v) / (a->shape[i][0] / w);
    assert_true(fabs(v / (0.35 * RATE) - 1.0) < 1e-9);
    assert_true(fabs(ratio * 50.0 - 1.0) < 1e-9);
  }
  tabor_model_release(slow);
  tabor_model_release(fast);
}

/* ---- forces ---------------------------------------------------------------------------------- */

static double force_now(const TaborDrum *drum) {
  TaborProbe probe;
  tabor_drum_probe(drum, &probe);
  return isnan(probe.striker_force) ? 0.0 : probe.striker_force;
}

/* Largest error of the force of a stroke on a hoop without modes, as a part of its peak. The engine
 * runs at four times the reference's rate. */
static double blow_error(double stiffness, double velocity, const json_t *force) {
  TaborDrumDef def = frame_drum();
  def.hoop.contact_stiffness = stiffness;
  def.hoop.contact_loss = 0.0;
  TaborModel *model = physics_model(&def, 4.0 * RATE, TABOR_QUALITY_STUDIO);
  TaborDrum *drum = physics_drum(model);
  const TaborEvent stroke = {
    .type = TABOR_EVENT_STRIKE, .velocity = velocity, .technique = TABOR_TECHNIQUE_RIM};
  double worst = 0.0, most = 0.0;
  tabor_drum_process(drum, &stroke, 1, NULL, 1);
  for (size_t i = 0; i < json_array_size(force); i++) {
    worst = fmax(worst, fabs(force_now(drum) - reference_number(force, i)));
    most = fmax(most, reference_number(force, i));
    tabor_drum_process(drum, NULL, 0, NULL, 4);
  }
  print_message("%.0e N/m^1.5: force within %.4f of %.2f N\n", stiffness, worst, most);
  tabor_drum_destroy(drum);
  tabor_model_release(model);
  return worst / most;
}

static void blows_on_a_rigid_support_have_the_force_of_an_independent_integration(void **state) {
  (void)state;
  json_t *root = reference_load("sticks.json");
  const json_t *blows = json_object_get(root, "blows");
  const double velocity = json_number_value(json_object_get(root, "velocity"));
  assert_int_equal(json_array_size(blows), 2);
  for (size_t i = 0; i < json_array_size(blows); i++) {
    const json_t *blow = json_array_get(blows, i);
    const double stiffness = json_number_value(json_object_get(blow, "stiffness"));
    assert_true(blow_error(stiffness, velocity, json_object_get(blow, "force")) < 0.01);
  }
  json_decref(root);
}

enum { RINGING = 9600 };

static double power_at(const double *force, double frequency) {
  double re = 0.0, im = 0.0;
  for (int i = 0; i < RINGING; i++) {
    const double window = 0.5 - 0.5 * cos(2.0 * PI * i / RINGING);
    re += window * force[i] * cos(2.0 * PI * frequency * i / RATE);
    im += window * force[i] * sin(2.0 * PI * frequency * i / RATE);
  }
  return re * re + im * im;
}

/* 1/K + the tip's receptance: 0 where the stick rings on a spring K. */
static double yields(const json_t *held, double mass, double stiffness, double hz) {
  const double square = 4.0 * PI * PI * hz * hz;
  double sum = 1.0 / stiffness - 1.0 / (mass * square);
  for (uint32_t i = 0; i < TB_BENDS; i++) {
    const double mode = 2.0 * PI * reference_number(json_object_get(held, "hz"), i);
    sum += reference_number(json_object_get(held, "tip_tip"), i) / (mode * mode - square);
  }
  return sum;
}

/* The n-th frequency of a stick on a spring; there is one below each of its free modes, and one
 * above all. */
static double resonance(const json_t *held, double mass, double stiffness, uint32_t n) {
  double lo = n ? reference_number(json_object_get(held, "hz"), n - 1) : 0.0;
  double hi = n < TB_BENDS ? reference_number(json_object_get(held, "hz"), n) : 20000.0;
  for (int i = 0; i < 100; i++) {
    const double middle = 0.5 * (lo + hi);
    if (yields(held, mass, stiffness, middle) < 0.0) {
      lo = middle;
    } else {
      hi = middle;
    }
  }
  return lo;
}

static double loudest_near(const double *force, double hz) {
  double best = 0.0, most = 0.0;
  for (double f = 0.9 * hz; f < 1.1 * hz; f += 0.002 * hz) {
    const double power = power_at(force, f);
    if (power <= most) continue;
    most = power;
    best = f;
  }
  return best;
}

/* The head is as heavy and tense as it can be, but not quite rigid. */
static const double HEAD_MOVES = 0.05;

/* A hand presses the stick onto a heavy head. A linear contact holds it, so its force rings at the
 * four frequencies of stick and spring. */
static void the_force_of_a_pressed_stick_rings_at_its_frequencies(void **state) {
  (void)state;
  static double force[RINGING];
  json_t *root = reference_load("sticks.json");
  const json_t *held = json_object_get(json_object_get(root, "grips"), "held");
  TaborDrumDef def = frame_drum();
  def.batter.surface_density = 5.0;
  def.batter.tension = 20000.0;
  def.striker[0].contact_exponent = 1.0;
  def.striker[0].contact_stiffness = 1e5;
  def.striker[0].contact_loss = 0.0;
  def.hand.damping = def.hand.stiffness = 0.0;
  TaborModel *model = physics_model(&def, RATE, TABOR_QUALITY_STUDIO);
  TaborDrum *drum = physics_drum(model);
  const TaborEvent stroke = {.type = TABOR_EVENT_STRIKE,
                             .velocity = 0.03,
                             .radius = 0.05,
                             .value = 1.0,
                             .technique = TABOR_TECHNIQUE_BUZZ};
  for (int i = 0; i < RINGING; i++) {
    tabor_drum_process(drum, &stroke, i == 0, NULL, 1);
    force[i] = force_now(drum);
  }
  for (uint32_t n = 0; n <= TB_BENDS; n++) {
    const double expected = resonance(held, def.striker[0].mass, 1e5, n);
    const double measured = loudest_near(force, expected);
    print_message("%.0f Hz expected, %.0f Hz measured, %.0f dB\n", expected, measured,
                  10.0 * log10(power_at(force, measured)));
    assert_true(fabs(measured / expected - 1.0) < HEAD_MOVES);
    assert_true(power_at(force, measured) > 4.0 * power_at(force, 0.9 * expected));
    assert_true(power_at(force, measured) > 4.0 * power_at(force, 1.1 * expected));
  }
  tabor_drum_destroy(drum);
  tabor_model_release(model);
  json_decref(root);
}

/* ---- limits ---------------------------------------------------------------------------------- */

enum { STROKE = 480 };

/* Force of a plain stroke; returns its largest value. */
static double strike(const TaborDrumDef *def, double *force) {
  TaborModel *model = physics_model(def, RATE, TABOR_QUALITY_STUDIO);
  TaborDrum *drum = physics_drum(model);
  const TaborEvent stroke = {.type = TABOR_EVENT_STRIKE, .velocity = 2.0, .radius = 0.05};
  double most = 0.0;
  for (int i = 0; i < STROKE; i++) {
    tabor_drum_process(drum, &stroke, i == 0, NULL, 1);
    force[i] = force_now(drum);
    most = fmax(most, force[i]);
  }
  tabor_drum_destroy(drum);
  tabor_model_release(model);
  return most;
}

static double largest_difference(const double *a, const double *b) {
  double most = 0.0;
  for (int i = 0; i < STROKE; i++) most = fmax(most, fabs(a[i] - b[i]));
  return most;
}

/* A mallet does not bend. */
static void a_stiff_stick_is_the_plain_striker(void **state) {
  (void)state;
  static double bent[STROKE], stiff[STROKE], mallet[STROKE], hard[STROKE];
  TaborDrumDef def = frame_drum();
  const double most = strike(&def, bent);
  def.striker[0].bending_frequency = 0.0;
  strike(&def, stiff);
  def.striker[0].kind = TABOR_STRIKER_MALLET;
  def.striker[0].bending_frequency = 395.0;
  strike(&def, mallet);
  def.striker[0].kind = TABOR_STRIKER_STICK;
  def.striker[0].bending_frequency = 20000.0;
  strike(&def, hard);
  assert_true(largest_difference(stiff, mallet) == 0.0);
  assert_true(largest_difference(bent, stiff) > 0.1 * most);
  assert_true(largest_difference(hard, stiff) < 0.05 * most);
}

/* ---- energy and swaps ------------------------------------------------------------------------ */

static TaborLedger ledger_of(const TaborDrum *drum) {
  TaborLedger ledger;
  tabor_drum_ledger(drum, &ledger);
  return ledger;
}

static void assert_balanced(const TaborLedger *ledger) {
  assert_true(fabs(ledger->residual) <
              physics_residual(TABOR_QUALITY_STUDIO) * (ledger->injected + fabs(ledger->control)));
}

/* Of a drum that loses nothing itself, only the hand in which the stick bends takes energy. */
static void energy_of_bending_is_stored_or_lost_in_the_hand(void **state) {
  (void)state;
  for (uint32_t losses = 0; losses < 2; losses++) {
    TaborDrumDef def = frame_drum();
    def.quality.losses = losses;
    def.striker[0].contact_loss = 0.0;
    TaborModel *model = physics_model(&def, RATE, TABOR_QUALITY_STUDIO);
    TaborDrum *drum = physics_drum(model);
    const TaborEvent stroke = {.type = TABOR_EVENT_STRIKE, .velocity = 3.0, .radius = 0.05};
    double most = 0.0;
    for (int i = 0; i < STROKE; i++) {
      tabor_drum_process(drum, &stroke, i == 0, NULL, 1);
      const TbView view = tb_view(drum->state, drum->model);
      most = fmax(most, tb_stick_bending(&view, 0, &view.now, &view.last));
      const TaborLedger ledger = ledger_of(drum);
      assert_balanced(&ledger);
      assert_true(losses ? ledger.damper_loss >= 0.0 : ledger.damper_loss == 0.0);
    }
    const TaborLedger ledger = ledger_of(drum);
    print_message("of %.3g J, bending has %.3g J at most; the hand took %.3g J\n", ledger.injected,
                  most, ledger.damper_loss);
    assert_true(most > 0.02 * ledger.injected && most < ledger.injected);
    assert_true(!losses || ledger.damper_loss > 1e-3 * ledger.injected);
    tabor_drum_destroy(drum);
    tabor_model_release(model);
  }
}

/* The swap is to be destroyed after the drum, which sounds on with its former model. */
static TaborSwap *swap_to(TaborDrum *drum, TaborModel *from, TaborModel *to) {
  TaborSwap *swap = NULL;
  TaborError error = {0};
  assert_int_equal(tabor_swap_create(from, to, &swap, &error), TABOR_OK);
  const TaborEvent event = {.type = TABOR_EVENT_SWAP, .swap = swap};
  tabor_drum_process(drum, &event, 1, NULL, 1);
  assert_ptr_equal(tabor_drum_model(drum), to);
  return swap;
}

/* To and fro between two sticks is no pump; on a stiff one, nothing is left of the bending. */
static void a_swap_carries_the_bending_to_another_stick(void **state) {
  (void)state;
  enum { TIMES = 40 };
  TaborDrumDef def = frame_drum();
  TaborModel *models[3];
  TaborSwap *swaps[TIMES + 1];
  for (int i = 0; i < 3; i++) {
    def.striker[0].bending_frequency = i == 0 ? 395.0 : i == 1 ? 430.0 : 0.0;
    models[i] = physics_model(&def, RATE, TABOR_QUALITY_STUDIO);
  }
  TaborDrum *drum = physics_drum(models[0]);
  const TaborEvent stroke = {.type = TABOR_EVENT_STRIKE, .velocity = 3.0, .radius = 0.05};
  tabor_drum_process(drum, &stroke, 1, NULL, 100);
  const double before = ledger_of(drum).stored;
  for (int i = 0; i < TIMES; i++) {
    swaps[i] = swap_to(drum, models[i % 2], models[(i + 1) % 2]);
    tabor_drum_process(drum, NULL, 0, NULL, 2);
    const TaborLedger ledger = ledger_of(drum);
    assert_balanced(&ledger);
    assert_true(ledger.stored < 1.2 * before);
  }
  swaps[TIMES] = swap_to(drum, models[0], models[2]);
  TbView view = tb_view(drum->state, drum->model);
  assert_true(tb_stick_bending(&view, 0, &view.now, &view.last) == 0.0);
  tabor_drum_destroy(drum);
  for (int i = 0; i <= TIMES; i++) tabor_swap_destroy(swaps[i]);
  for (int i = 0; i < 3; i++) tabor_model_release(models[i]);
}

/* A reset, and the removal of a stick, leave no bending for the next one. */
static void a_new_stick_is_straight(void **state) {
  (void)state;
  const TaborDrumDef def = frame_drum();
  TaborModel *model = physics_model(&def, RATE, TABOR_QUALITY_STUDIO);
  TaborDrum *drum = physics_drum(model);
  const TaborEvent stroke = {.type = TABOR_EVENT_STRIKE, .velocity = 3.0, .radius = 0.05};
  const TaborEvent release = {.type = TABOR_EVENT_RELEASE};
  for (int i = 0; i < 2; i++) {
    tabor_drum_process(drum, &stroke, 1, NULL, 100);
    TbView view = tb_view(drum->state, drum->model);
    assert_true(tb_stick_bending(&view, 0, &view.now, &view.last) > 0.0);
    if (i == 0) {
      tabor_drum_reset(drum);
    } else {
      tabor_drum_process(drum, &release, 1, NULL, 0);
    }
    view = tb_view(drum->state, drum->model);
    for (uint32_t n = 0; n < TB_BENDS; n++) {
      assert_true(view.now.bow[0][n] == 0.0 && view.last.bow[0][n] == 0.0);
    }
  }
  const TaborLedger ledger = ledger_of(drum);
  assert_balanced(&ledger);
  tabor_drum_destroy(drum);
  tabor_model_release(model);
}

int main(void) {
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(modes_are_those_of_finite_elements),
    cmocka_unit_test(the_rigid_body_is_that_of_the_beam),
    cmocka_unit_test(modes_too_fast_for_the_rate_keep_their_compliance),
    cmocka_unit_test(blows_on_a_rigid_support_have_the_force_of_an_independent_integration),
    cmocka_unit_test(the_force_of_a_pressed_stick_rings_at_its_frequencies),
    cmocka_unit_test(a_stiff_stick_is_the_plain_striker),
    cmocka_unit_test(energy_of_bending_is_stored_or_lost_in_the_hand),
    cmocka_unit_test(a_swap_carries_the_bending_to_another_stick),
    cmocka_unit_test(a_new_stick_is_straight),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
