/* SPDX-License-Identifier: MIT */
/* The pedal of a hi-hat: its speed, its work, where it comes to rest; strokes and the foot, in the
 * ledger. */
#include "heads/pedal.h"

#include "drum/drum.h"
#include "physics.h"

static const double RATE = 48000.0;

static TaborDrumDef hat_def(void) { return physics_preset("hihat-14"); }

static double opening(const TaborDrum *drum) {
  return drum->state->live.values[TB_LIVE_OPENING].now;
}

static TaborEvent move_to(double value) {
  return (TaborEvent){.type = TABOR_EVENT_PARAMETER,
                      .parameter = tabor_parameter_find("hihat.opening")->id,
                      .value = value};
}

static TaborEvent stamp(double speed) {
  return (TaborEvent){
    .type = TABOR_EVENT_STRIKE, .technique = TABOR_TECHNIQUE_PEDAL, .velocity = speed};
}

static void play(TaborDrum *drum, TaborEvent event, uint32_t frames) {
  tabor_drum_process(drum, &event, 1, NULL, frames);
}

static double edges_force(const TaborDrum *drum) {
  TaborProbe probe;
  tabor_drum_probe(drum, &probe);
  return probe.wire_force;
}

/* The rod takes the way over its speed, no less. */
static void the_rod_is_no_faster_than_its_speed(void **state) {
  (void)state;
  TaborDrumDef def = hat_def();
  def.hihat.speed = 0.5;
  TaborModel *model = physics_model(&def, RATE, TABOR_QUALITY_DRAFT);
  TaborDrum *drum = physics_drum(model);
  const double way = 8e-3 - def.hihat.opening;
  const uint32_t frames = (uint32_t)(way / 0.5 * RATE);
  play(drum, move_to(8e-3), frames - 5);
  assert_true(opening(drum) < 8e-3);
  tabor_drum_process(drum, NULL, 0, NULL, 10);
  assert_true(opening(drum) == 8e-3);
  tabor_drum_destroy(drum);
  tabor_model_release(model);
}

/* Slowly and far: the edges come apart, and together again as they were. */
static void a_pedal_comes_back(void **state) {
  (void)state;
  const TaborDrumDef def = hat_def();
  TaborModel *model = physics_model(&def, RATE, TABOR_QUALITY_LIVE);
  TaborDrum *drum = physics_drum(model);
  const double closed = edges_force(drum);
  assert_true(closed > 1.0);
  play(drum, move_to(8e-3), 96000);
  assert_true(edges_force(drum) == 0.0);
  play(drum, move_to(def.hihat.opening), 192000);
  print_message("%.4f N at rest, %.4f N when closed again\n", closed, edges_force(drum));
  assert_true(fabs(edges_force(drum) / closed - 1.0) < 1e-3);
  tabor_drum_destroy(drum);
  tabor_model_release(model);
}

/* Both the closed and the open hi-hat sleep in the end, and sound when they are woken. */
static void a_held_hihat_sleeps(void **state) {
  (void)state;
  const TaborDrumDef def = hat_def();
  TaborModel *model = physics_model(&def, RATE, TABOR_QUALITY_LIVE);
  TaborDrum *drum = physics_drum(model);
  for (int open = 0; open < 2; open++) {
    play(drum, move_to(open ? 8e-3 : def.hihat.opening), 480);
    play(drum,
         (TaborEvent){.type = TABOR_EVENT_STRIKE, .velocity = 2.0, .radius = def.strike.radius},
         480);
    assert_false(drum->state->asleep);
    uint32_t seconds = 0;
    while (!drum->state->asleep && seconds++ < 30) tabor_drum_process(drum, NULL, 0, NULL, 48000);
    print_message("%s: asleep after %u s\n", open ? "open" : "closed", seconds);
    assert_true(drum->state->asleep);
  }
  assert_true(edges_force(drum) == 0.0);
  tabor_drum_destroy(drum);
  tabor_model_release(model);
}

/* Energy of what is heard of the modes 0.2 s after a stroke: the plates swing longer. */
static double left_after_a_stroke(double opening_at) {
  TaborDrumDef def = hat_def();
  def.hihat.opening = opening_at;
  TaborModel *model = physics_model(&def, RATE, TABOR_QUALITY_LIVE);
  TaborDrum *drum = physics_drum(model);
  play(drum, (TaborEvent){.type = TABOR_EVENT_STRIKE, .velocity = 4.0, .radius = def.strike.radius},
       9600);
  const TbView view = tb_view(drum->state, model);
  double sum = 0.0;
  for (uint32_t i = 0; i < model->modes.padded; i++) {
    const uint32_t row = model->modes.row[i];
    if (row != TB_NO_MODE && model->body.modes[row].omega > 2000.0) sum += tb_mode_energy(&view, i);
  }
  tabor_drum_destroy(drum);
  tabor_model_release(model);
  return sum;
}

/* The farther the pedal is down, the sooner a stroke has died away. */
static void the_pedal_damps(void **state) {
  (void)state;
  static const double openings[] = {-3e-3, -1.3e-3, -1.1e-3, -0.9e-3, -0.6e-3};
  double before = 0.0;
  for (uint32_t i = 0; i < sizeof openings / sizeof *openings; i++) {
    const double left = left_after_a_stroke(openings[i]);
    print_message("%.1f mm: %.3g J left after 0.2 s\n", 1e3 * openings[i], left);
    assert_true(left > 1.5 * before);
    before = left;
  }
  assert_true(left_after_a_stroke(8e-3) > before);
}

/* From a lifted rod, which the foot lifts by itself. */
static void a_stamp_lifts_and_falls(void **state) {
  (void)state;
  const TaborDrumDef def = hat_def();
  TaborModel *model = physics_model(&def, RATE, TABOR_QUALITY_LIVE);
  TaborDrum *drum = physics_drum(model);
  double highest = -1.0, last = opening(drum), fastest = 0.0;
  play(drum, stamp(0.4), 1);
  for (uint32_t i = 0; i < 4800; i++) {
    tabor_drum_process(drum, NULL, 0, NULL, 1);
    highest = fmax(highest, opening(drum));
    fastest = fmax(fastest, (last - opening(drum)) * RATE);
    last = opening(drum);
  }
  print_message("lifted to %.4f m, down at %.4f m/s\n", highest, fastest);
  assert_true(highest == def.hihat.lift && last == def.hihat.closed);
  assert_true(fabs(fastest - 0.4) < 1e-9);
  TaborLedger ledger;
  tabor_drum_ledger(drum, &ledger);
  assert_true(ledger.control > 1e-3 && ledger.contact_loss > 1e-3);
  tabor_drum_destroy(drum);
  tabor_model_release(model);
}

/* The peak of a stamp from this opening, of full scale. */
static double peak_of_a_stamp(double from, double speed) {
  enum { FRAMES = 9600 };
  TaborDrumDef def = hat_def();
  def.hihat.opening = from;
  TaborModel *model = physics_model(&def, RATE, TABOR_QUALITY_LIVE);
  TaborDrum *drum = physics_drum(model);
  static float sound[FRAMES];
  float *outputs[TABOR_MAX_MICS] = {sound};
  const TaborEvent event = stamp(speed);
  double peak = 0.0;
  tabor_drum_process(drum, &event, 1, outputs, FRAMES);
  for (uint32_t i = 0; i < FRAMES; i++) peak = fmax(peak, fabs((double)sound[i]));
  tabor_drum_destroy(drum);
  tabor_model_release(model);
  return peak;
}

/* The air between the plates stops them before their edges clash: without it, a foot's stroke
 * passed full scale. Recorded ones are softer than a firm stroke of a stick. */
static void the_air_cushions_a_stamp(void **state) {
  (void)state;
  static const double speeds[] = {0.3, 0.5, 1.0, 1.5, 2.5};
  const double closed = hat_def().hihat.closed;
  for (uint32_t i = 0; i < sizeof speeds / sizeof *speeds; i++) {
    const double from_closed = peak_of_a_stamp(closed, speeds[i]);
    const double from_open = peak_of_a_stamp(8e-3, speeds[i]);
    print_message("%.1f m/s: %.3f of full scale from closed, %.3f from open\n", speeds[i],
                  from_closed, from_open);
    assert_true(from_closed < 0.25 && from_open < 0.25);
  }
}

/* Strokes, stamps and a foot that wanders, at every quality and cap: nothing is made. Steps that do
 * not settle, as a low cap leaves them, lose energy that the account lacks (contact/majorant.h,
 * step/energy_guard.h). */
static void the_energy_account_closes(void **state) {
  (void)state;
  static const uint32_t caps[] = {1, 3, 16};
  uint64_t seed = physics_seed();
  for (uint32_t quality = TABOR_QUALITY_DRAFT; quality <= TABOR_QUALITY_STUDIO; quality++) {
    for (uint32_t c = 0; c < 3; c++) {
      TaborDrumDef def = hat_def();
      def.quality.newton_cap = caps[c];
      TaborModel *model = physics_model(&def, RATE, quality);
      TaborDrum *drum = physics_drum(model);
      double made = 0.0, lost = 0.0, came = 0.0;
      for (uint32_t i = 0; i < 40; i++) {
        const double drawn = physics_uniform(&seed, 0.0, 1.0);
        const TaborEvent stroke = {.type = TABOR_EVENT_STRIKE,
                                   .velocity = 1.0 + 11.0 * drawn,
                                   .radius = def.shell.radius * physics_uniform(&seed, 0.1, 1.0),
                                   .striker = i % 2,
                                   .angle = 360.0 * drawn};
        TaborEvent event = stroke;
        if (i % 4 == 1) event = stamp(0.1 + 2.0 * drawn);
        if (i % 4 == 3) event = move_to(-4e-3 + 0.012 * drawn);
        play(drum, event, 1200);
        TaborLedger ledger;
        tabor_drum_ledger(drum, &ledger);
        came = ledger.injected + fabs(ledger.control);
        made = fmax(made, -ledger.residual / came);
        lost = fmax(lost, ledger.residual / came);
      }
      TaborStatistics statistics;
      tabor_drum_statistics(drum, &statistics);
      print_message("quality %u, cap %u: %.1f J, %.2g of it made, %.2g lost, %u steps unsettled\n",
                    quality, caps[c], came, made, lost,
                    (uint32_t)(statistics.guarded + statistics.fallbacks));
      assert_true(made < physics_residual(quality));
      assert_true(lost < (caps[c] < 16 ? 1e-2 : physics_residual(quality)));
      tabor_drum_destroy(drum);
      tabor_model_release(model);
    }
  }
}

int main(void) {
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(the_rod_is_no_faster_than_its_speed),
    cmocka_unit_test(a_pedal_comes_back),
    cmocka_unit_test(a_held_hihat_sleeps),
    cmocka_unit_test(the_pedal_damps),
    cmocka_unit_test(a_stamp_lifts_and_falls),
    cmocka_unit_test(the_air_cushions_a_stamp),
    cmocka_unit_test(the_energy_account_closes),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
