/* SPDX-License-Identifier: MIT */
/* One stick on one head without wires, during its first contact: contact force and the head's
 * height settle at second order as the sample rate rises. Modes and patch are the same at every
 * rate.
 *
 * The recursion knows rates only as omega k, so a drum that is slowed down `slow` times, at 192
 * kHz, is the drum itself at 192 slow kHz: T, D, K over slow^2, losses and speeds over slow, lambda
 * times slow. Forces then come out slow^2 times smaller. Below 88.2 kHz a model steps twice per
 * sample, so that rates here begin at 96 kHz. */
#include "physics.h"

static const double PI = 3.14159265358979323846;

/* Observed order: 2 is expected, from the gain of the modes and from the discrete gradient. */
static const double LEAST_ORDER = 1.5;
/* The slope limit of the engine is 10 over the compliance; the contact stays below a tenth of it.
 */
static const double MOST_STIFFNESS = 1.0;
/* Rounding and set-up by other numbers: the slowed drum is the same drum. */
static const double SIMILAR = 1e-7;

enum { ROWS = 60 }; /* at 12 kHz: 5 ms, inside the first contact */
static const double ROW_RATE = 12000.0;

typedef struct Run {
  double head[ROWS], force[ROWS];
  double modes; /* cosine and sine copies counted apart */
} Run;

static TaborDrumDef definition(double slow) {
  TaborDrumDef def = physics_preset("bodhran-d-string");
  const double square = slow * slow;
  def.wires.count = 0;
  def.batter.tension /= square;
  def.batter.bending_stiffness /= square;
  def.batter.damping_0 /= slow;
  def.batter.damping_1 /= slow;
  def.striker[0] = (TaborStrikerDef){.name = "stick",
                                     .kind = TABOR_STRIKER_STICK,
                                     .mass = 0.03,
                                     .contact_stiffness = 3e6 / square,
                                     .contact_exponent = 2.0,
                                     .contact_loss = 0.05 * slow,
                                     .contact_radius = 0.006,
                                     .bristles = 200,
                                     .spread = 0.04,
                                     .sweep_speed = 0.8};
  def.strike.velocity = 1.3 / slow;
  def.air.sound_speed /= slow;
  def.air.gravity /= square;
  def.quality.two_way_bandwidth = 2000.0 / slow;
  def.quality.newton_cap = 16;
  return def;
}

/* The probe's force acts midway between the steps before and after it: at the sample before the
 * newest, which is therefore one frame past the row's time. */
static Run run_at(double rate, double slow) {
  const TaborDrumDef def = definition(slow);
  TaborModel *model = physics_model(&def, rate, TABOR_QUALITY_STUDIO);
  TaborDrum *drum = physics_drum(model);
  TaborModelInfo info;
  tabor_model_info(model, &info);
  Run run = {.modes = info.mode_count};
  const TaborEvent strike = physics_strike(&def);
  const int stride = (int)lround(rate * slow / ROW_RATE);
  for (int i = 0; i <= ROWS * stride; i++) {
    tabor_drum_process(drum, &strike, i == 0 ? 1 : 0, NULL, 1);
    TaborProbe probe;
    tabor_drum_probe(drum, &probe);
    const int frames = i + 1;
    if (frames % stride == 0) run.head[frames / stride - 1] = probe.head;
    if (i > 0 && i % stride == 0) run.force[i / stride - 1] = probe.striker_force * slow * slow;
  }
  tabor_drum_destroy(drum);
  tabor_model_release(model);
  return run;
}

static double distance(const double *a, const double *b) {
  double sum = 0.0, size = 0.0;
  for (int i = 0; i < ROWS; i++) {
    sum += (a[i] - b[i]) * (a[i] - b[i]);
    size += b[i] * b[i];
  }
  return sqrt(sum / size);
}

/* K' times the compliance of stick and head over one step: the engine limits this to 10. A head of
 * N modes and mass m yields by about k^2 N/m. */
static double relative_stiffness(const Run *run, double rate) {
  const TaborDrumDef def = definition(1.0);
  const TaborStrikerDef *stick = &def.striker[0];
  double peak = 0.0;
  for (int i = 0; i < ROWS; i++) peak = fmax(peak, run->force[i]);
  const double dent = pow(peak / stick->contact_stiffness, 1.0 / stick->contact_exponent);
  const double slope =
    stick->contact_stiffness * stick->contact_exponent * pow(dent, stick->contact_exponent - 1.0);
  const double area = PI * def.shell.radius * def.shell.radius;
  const double head = run->modes / (def.batter.surface_density * area);
  return slope * (1.0 / stick->mass + head) / (rate * rate);
}

static void slowing_down_is_a_higher_rate(void **state) {
  (void)state;
  const Run direct = run_at(192000.0, 1.0), slowed = run_at(96000.0, 2.0);
  const double head = distance(slowed.head, direct.head);
  const double force = distance(slowed.force, direct.force);
  print_message("96 kHz slowed twice against 192 kHz: head %.1e, force %.1e\n", head, force);
  assert_true(slowed.modes == direct.modes);
  assert_true(head < SIMILAR && force < SIMILAR);
}

static void force_and_height_converge(void **state) {
  (void)state;
  static const double RATES[3] = {96000.0, 192000.0, 288000.0}, SLOW[3] = {1.0, 1.0, 1.5};
  const Run reference = run_at(192000.0, 3.0);
  double last_head = 0.0, last_force = 0.0;
  for (int i = 0; i < ROWS; i++) assert_true(reference.force[i] > 0.0); /* one contact, unbroken */
  for (int r = 0; r < 3; r++) {
    const Run run = run_at(RATES[r] / SLOW[r], SLOW[r]);
    const double head = distance(run.head, reference.head);
    const double force = distance(run.force, reference.force);
    const double stiffness = relative_stiffness(&run, RATES[r]);
    print_message("%6.0f Hz: head %.2e force %.2e off 576 kHz, relative stiffness %.3f\n", RATES[r],
                  head, force, stiffness);
    assert_true(run.modes == reference.modes);
    assert_true(stiffness < MOST_STIFFNESS);
    if (r > 0) {
      const double finer = log(RATES[r] / RATES[r - 1]);
      const double head_order = log(last_head / head) / finer;
      const double force_order = log(last_force / force) / finer;
      print_message("           observed order: head %.2f force %.2f\n", head_order, force_order);
      assert_true(head_order > LEAST_ORDER);
      assert_true(force_order > LEAST_ORDER);
    }
    last_head = head;
    last_force = force;
  }
}

int main(void) {
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(slowing_down_is_a_higher_rate),
    cmocka_unit_test(force_and_height_converge),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
