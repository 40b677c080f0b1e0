/* SPDX-License-Identifier: MIT */
/* Plucked wires: the shape that a slow pull leaves, its work, and the energy of plucks on snare
 * drums. */
#include "drum/drum.h"
#include "physics.h"

static const double PI = 3.14159265358979323846;
enum { RATE = 48000 };

static bool brief; /* under sanitizers: a drum of few modes */

/* A string that hangs 2 cm above its head and touches nothing, without gravity. */
static TaborDrumDef free_string(double bending_stiffness) {
  TaborDrumDef def;
  tabor_drum_def_default(&def);
  def.wires.count = 1;
  def.wires.side = TABOR_SIDE_ABOVE;
  def.wires.length = 0.4;
  def.wires.mass_per_length = 1.9e-3;
  def.wires.tension = 5.0;
  def.wires.bending_stiffness = bending_stiffness;
  def.wires.damping_0 = 20.0;
  def.wires.rest_offset = 0.02;
  def.air.gravity = 0.0;
  def.quality.two_way_bandwidth = 1000.0;
  def.quality.wire_points = 100;
  return def;
}

static TaborEvent pluck(uint32_t wire, double place, double displacement, double time) {
  return (TaborEvent){.type = TABOR_EVENT_STRIKE,
                      .technique = TABOR_TECHNIQUE_PLUCK,
                      .striker = wire,
                      .radius = place,
                      .value = displacement,
                      .velocity = displacement / time};
}

/* A drum whose wire has been pulled for all but the last step of `time`. */
static TaborDrum *pulled(const TaborDrumDef *def, double place, double displacement, double time) {
  TaborModel *model = physics_model(def, RATE, TABOR_QUALITY_STUDIO);
  TaborDrum *drum = physics_drum(model);
  const TaborEvent event = pluck(0, place, displacement, time);
  tabor_drum_process(drum, &event, 1, NULL, (uint32_t)(time * RATE) - 1u);
  tabor_model_release(model);
  return drum;
}

/* After a second, a string of 50 ms is where the force holds it to some 1e-5; the force of the last
 * step but one is 1e-9 short of the whole. */
static const double SETTLED = 1e-4;

/* The limit EI -> 0: two straight lines from the ends to the finger, whose work is their energy. */
static void a_slow_pull_leaves_a_triangle(void **state) {
  (void)state;
  static const double PLACES[] = {0.5, 0.3, 0.137}, PULL = 2e-3;
  for (int k = 0; k < 3; k++) {
    const TaborDrumDef def = free_string(0.0);
    TaborDrum *drum = pulled(&def, PLACES[k], PULL, 1.0);
    const TbView view = tb_view(drum->state, drum->model);
    const TbWire *wire = &drum->model->wires.wires[0];
    const double *v = view.now.v + wire->first_node;
    for (uint32_t i = 0; i <= wire->cells; i++) {
      const double part = (double)i / wire->cells;
      const double side = part < PLACES[k] ? part / PLACES[k] : (1.0 - part) / (1.0 - PLACES[k]);
      /* Between two nodes the corner is cut, by a quarter of a cell at most. */
      const double corner = fabs(part - PLACES[k]) * wire->cells < 1.0 ? 0.02 : SETTLED;
      assert_true(fabs(v[i] / PULL - side) < corner);
    }
    TaborLedger ledger;
    tabor_drum_ledger(drum, &ledger);
    const double length = def.wires.length;
    const double energy = 0.5 * def.wires.tension * PULL * PULL *
                          (1.0 / (PLACES[k] * length) + 1.0 / ((1.0 - PLACES[k]) * length));
    const double node = PLACES[k] * wire->cells, share = node - floor(node);
    const double cut = share * (1.0 - share) / (wire->cells * PLACES[k] * (1.0 - PLACES[k]));
    print_message("at %g: work %.6g J, energy of the triangle with its corner cut %.6g J\n",
                  PLACES[k], ledger.injected, (1.0 - cut) * energy);
    assert_true(fabs(ledger.injected / energy - 1.0 + cut) < 1e-3);
    assert_true(fabs(ledger.stored / energy - 1.0 + cut) < 1e-3);
    tabor_drum_destroy(drum);
  }
}

/* The static compliance of a hinged stiff string as a sum over its modes. */
static double compliance(const TaborWiresDef *wires, double tension, double place) {
  double sum = 0.0;
  for (int n = 1; n <= 20000; n++) {
    const double k = n * PI / wires->length, shape = sin(n * PI * place);
    sum += 2.0 * shape * shape /
           (wires->length * (tension * k * k + wires->bending_stiffness * k * k * k * k));
  }
  return sum;
}

/* From a string to a beam, the force is the one that holds the wire at the displacement. */
static void the_displacement_is_reached_whatever_the_stiffness(void **state) {
  (void)state;
  static const double BENDING[] = {1e-5, 4e-4, 0.02};
  for (int k = 0; k < 3; k++) {
    const TaborDrumDef def = free_string(BENDING[k]);
    TaborDrum *drum = pulled(&def, 0.3, 1e-3, 1.0);
    const TbView view = tb_view(drum->state, drum->model);
    const TbWire *wire = &drum->model->wires.wires[0];
    const TbPluck *finger = &drum->state->wires.plucks[0];
    const double *v = view.now.v + wire->first_node + finger->node;
    const double reached = (1.0 - finger->share) * v[0] + finger->share * v[1];
    const double force = finger->force;
    const double expected = 1e-3 / compliance(&def.wires, def.wires.tension, 0.3);
    print_message("EI %g, %u cells: %.5g mm, force %.6g N, sum over modes %.6g N\n", BENDING[k],
                  wire->cells, 1e3 * reached, force, expected);
    assert_true(fabs(force / expected - 1.0) < 1e-4);
    assert_true(fabs(reached / 1e-3 - 1.0) <
                0.01); /* the grid is as fine as its stability allows */
    tabor_drum_destroy(drum);
  }
}

/* Afterwards the string sounds at the frequency sqrt(T/mu)/(2L). */
static void a_plucked_string_swings_at_its_own_frequency(void **state) {
  (void)state;
  TaborDrumDef def = free_string(0.0);
  def.wires.damping_0 = 0.0;
  TaborDrum *drum = pulled(&def, 0.5, 1e-3, 0.2);
  const TbWire *wire = &drum->model->wires.wires[0];
  const double period =
    2.0 * def.wires.length * sqrt(def.wires.mass_per_length / def.wires.tension);
  uint32_t crossings = 0, last = 0, first = 0;
  double before = 1.0;
  for (uint32_t frame = 0; frame < RATE / 2; frame++) {
    tabor_drum_process(drum, NULL, 0, NULL, 1);
    const TbView view = tb_view(drum->state, drum->model);
    const double now = view.now.v[wire->first_node + wire->cells / 2];
    if (before < 0.0 && now >= 0.0) {
      last = frame;
      if (crossings++ == 0) first = frame;
    }
    before = now;
  }
  const double measured = (double)(last - first) / (crossings - 1) / RATE;
  print_message("period %.6g s, sqrt(mu/T) 2 L %.6g s\n", measured, period);
  assert_true(fabs(measured / period - 1.0) < 2e-3);
  tabor_drum_destroy(drum);
}

static TaborDrumDef snare(const char *name) {
  const TaborDrumDef def = physics_preset(name);
  return brief ? physics_small(&def) : def;
}

/* The account closes, and blocks change no bit. */
static void plucked_snares_keep_the_account(void **state) {
  (void)state;
  enum { LENGTH = RATE / 4 };
  static const char *const PRESETS[] = {"snare-14x5.5", "snare-14x5.5-off", "bodhran-d-string"};
  static float whole[LENGTH], parts[LENGTH];
  for (int k = 0; k < 3; k++) {
    const TaborDrumDef def = snare(PRESETS[k]);
    TaborModel *model = physics_model(&def, RATE, TABOR_QUALITY_LIVE);
    TaborDrum *drum = physics_drum(model), *other = physics_drum(model);
    TaborEvent events[] = {pluck(0, 0.3, 3e-3, 5e-3), pluck(0, 0.5, 1e-3, 1e-3)};
    events[1].frame = 3000;
    float *outputs[TABOR_MAX_MICS] = {whole};
    tabor_drum_process(drum, events, 2, outputs, LENGTH);
    for (uint32_t at = 0; at < LENGTH; at += 100) {
      TaborEvent part[2];
      uint32_t count = 0;
      for (int i = 0; i < 2; i++) {
        if (events[i].frame < at || events[i].frame >= at + 100) continue;
        part[count] = events[i];
        part[count++].frame -= at;
      }
      float *out[TABOR_MAX_MICS] = {parts + at};
      tabor_drum_process(other, part, count, out, 100);
    }
    assert_memory_equal(whole, parts, sizeof whole);
    TaborLedger ledger;
    TaborStatistics statistics;
    tabor_drum_ledger(drum, &ledger);
    tabor_drum_statistics(drum, &statistics);
    double peak = 0.0;
    for (int i = 0; i < LENGTH; i++) peak = fmax(peak, fabs((double)whole[i]));
    print_message("%s: injected %.3g J, residual %.2g J, peak %.3g\n", PRESETS[k], ledger.injected,
                  ledger.residual, peak);
    assert_true(ledger.injected > 0.0);
    assert_true(peak > 0.0 || k == 1); /* wires that hang off their head move nothing else */
    assert_true(statistics.newton_capped > 0 ||
                fabs(ledger.residual) < 1e-6 * ledger.injected + 1e-12);
    assert_true(ledger.residual > -1e-6 * ledger.injected - 1e-12);
    assert_int_equal(statistics.strikes, 2);
    tabor_drum_destroy(drum);
    tabor_drum_destroy(other);
    tabor_model_release(model);
  }
}

/* A state that is saved while a finger pulls goes on; without wires there is nothing to pluck. */
static void a_pull_is_part_of_the_state(void **state) {
  (void)state;
  const TaborDrumDef def = snare("snare-14x5.5"), tom = physics_preset("tom-12");
  TaborModel *model = physics_model(&def, RATE, TABOR_QUALITY_DRAFT);
  TaborDrum *drum = physics_drum(model), *other = physics_drum(model);
  const TaborEvent event = pluck(3, 0.6, 2e-3, 0.02);
  float here[2000], there[2000], *outputs[TABOR_MAX_MICS] = {here},
                                 *others[TABOR_MAX_MICS] = {there};
  tabor_drum_process(drum, &event, 1, NULL, 400);
  const size_t size = tabor_drum_state_size(drum);
  void *bytes = malloc(size);
  tabor_drum_state_save(drum, bytes);
  assert_int_equal(tabor_drum_state_load(other, bytes, size), TABOR_OK);
  tabor_drum_process(drum, NULL, 0, outputs, 2000);
  tabor_drum_process(other, NULL, 0, others, 2000);
  assert_memory_equal(here, there, sizeof here);
  const TaborEvent nowhere = pluck(def.wires.count, 0.5, 1e-3, 1e-3);
  tabor_drum_process(drum, &nowhere, 1, NULL, 1);
  TaborStatistics statistics;
  tabor_drum_statistics(drum, &statistics);
  assert_int_equal(statistics.dropped_events, 1);
  free(bytes);
  tabor_drum_destroy(drum);
  tabor_drum_destroy(other);
  tabor_model_release(model);
  TaborModel *wireless = physics_model(&tom, RATE, TABOR_QUALITY_DRAFT);
  drum = physics_drum(wireless);
  const TaborEvent first = pluck(0, 0.5, 1e-3, 1e-3);
  tabor_drum_process(drum, &first, 1, NULL, 1);
  tabor_drum_statistics(drum, &statistics);
  assert_int_equal(statistics.dropped_events, 1);
  assert_true(tabor_drum_is_silent(drum));
  tabor_drum_destroy(drum);
  tabor_model_release(wireless);
}

int main(int argc, char **argv) {
  const struct CMUnitTest physics[] = {
    cmocka_unit_test(a_slow_pull_leaves_a_triangle),
    cmocka_unit_test(the_displacement_is_reached_whatever_the_stiffness),
    cmocka_unit_test(a_plucked_string_swings_at_its_own_frequency),
  };
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(plucked_snares_keep_the_account),
    cmocka_unit_test(a_pull_is_part_of_the_state),
  };
  brief = argc > 1 && strcmp(argv[1], "brief") == 0;
  const int failed = brief ? 0 : cmocka_run_group_tests(physics, NULL, NULL);
  return failed + cmocka_run_group_tests(tests, NULL, NULL);
}
