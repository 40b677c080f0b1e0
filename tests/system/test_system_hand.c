/* SPDX-License-Identifier: MIT */
/* A stick that a hand presses onto the head bounces: the harder, the faster. Its work is accounted
 * for. */
#include "event_script.h"

#include "model/model.h"

static const double RATE = 48000.0;

/* Makes a stroke of 1 m/s, presses it at once, and counts the contacts of `seconds`; times of the
 * first ones into at[]. */
static uint32_t count_hits(double pressure, double seconds, double *at, uint32_t room,
                           TaborLedger *ledger) {
  TaborDrumDef def = physics_preset("frame-drum");
  def.striker[0].mass = 0.0126; /* a rod of 50 g, 0.4 m, held 0.12 m from its butt */
  TaborModel *model = physics_model(&def, RATE, TABOR_QUALITY_DRAFT);
  TaborDrum *drum = physics_drum(model);
  const TaborEvent events[2] = {
    {.type = TABOR_EVENT_STRIKE, .id = 5, .velocity = 1.0, .radius = 0.08},
    {.type = TABOR_EVENT_PRESS, .id = 5, .value = pressure}};
  uint32_t hits = 0;
  bool touching = false;
  for (uint32_t i = 0; i < (uint32_t)(seconds * RATE); i++) {
    tabor_drum_process(drum, events, i == 0 ? 2 : 0, NULL, 1);
    TaborProbe probe;
    tabor_drum_probe(drum, &probe);
    const bool touches = probe.striker_force > 0.0;
    if (touches && !touching) {
      if (hits < room) at[hits] = i / RATE;
      hits++;
    }
    touching = touches;
  }
  tabor_drum_ledger(drum, ledger);
  tabor_drum_destroy(drum);
  tabor_model_release(model);
  return hits;
}

static void harder_pressure_bounces_faster(void **state) {
  (void)state;
  double last_gap = 1.0;
  for (double pressure = 0.0; pressure <= 0.7; pressure += 0.35) {
    double at[4] = {0.0};
    TaborLedger ledger;
    const uint32_t hits = count_hits(pressure, 0.6, at, 4, &ledger);
    const double gap = at[1] - at[0];
    print_message("pressure %.1f: %u contacts in 0.6 s, the first %.1f ms apart; hand %.3g J\n",
                  pressure, hits, 1e3 * gap, ledger.injected - 0.5 * 0.0126);
    assert_true(hits >= 2);
    assert_true(gap < last_gap);
    last_gap = gap;
    assert_true(fabs(ledger.residual) < 1e-9 * fabs(ledger.injected));
  }
}

/* In the limit of no hand at all, a flight of speed v under the force F0 lasts 2 M v/F0. */
static void a_light_press_brings_the_stick_back(void **state) {
  (void)state;
  double at[2] = {0.0};
  TaborLedger ledger;
  assert_true(count_hits(0.0, 0.3, at, 2, &ledger) >= 2);
  /* It leaves with at most the speed it came with: 84 ms at the longest, less by spring and loss.
   */
  assert_true(at[1] - at[0] > 0.01 && at[1] - at[0] < 2.0 * 0.0126 * 1.0 / 0.3);
}

static void a_released_stick_is_gone_and_the_drum_falls_silent(void **state) {
  (void)state;
  TaborDrumDef def = physics_preset("frame-drum");
  TaborModel *model = physics_model(&def, RATE, TABOR_QUALITY_DRAFT);
  TaborDrum *drum = physics_drum(model);
  const TaborEvent events[2] = {{.type = TABOR_EVENT_STRIKE, .id = 5, .velocity = 1.0},
                                {.type = TABOR_EVENT_PRESS, .id = 0, .value = 0.7}};
  const TaborEvent release = {.type = TABOR_EVENT_RELEASE, .id = 5};
  tabor_drum_process(drum, events, 2, NULL, 20000);
  TaborProbe probe;
  tabor_drum_probe(drum, &probe);
  assert_false(isnan(probe.striker));
  /* The hand lifts it: the head that it bent comes up with it, and does not snap back. */
  double last = probe.head, fastest = 0.0;
  for (int i = 0; i < 2880; i++) {
    tabor_drum_process(drum, &release, i == 0, NULL, 1);
    tabor_drum_probe(drum, &probe);
    fastest = fmax(fastest, fabs(probe.head - last) * RATE);
    last = probe.head;
  }
  print_message("lifted, the head moves at %.2g m/s at most\n", fastest);
  assert_true(fastest < 0.1); /* 1.8 where the stick vanished, 0.4 where it was lifted in 8 ms */
  assert_true(isnan(probe.striker));
  for (int i = 0; i < 40 && !tabor_drum_is_silent(drum); i++) {
    tabor_drum_process(drum, NULL, 0, NULL, 9600);
  }
  assert_true(tabor_drum_is_silent(drum));
  TaborLedger ledger;
  tabor_drum_ledger(drum, &ledger);
  assert_true(fabs(ledger.residual) < 1e-9 * ledger.injected);
  tabor_drum_destroy(drum);
  tabor_model_release(model);
}

/* ---- buzz strokes ---------------------------------------------------------------------------- */

enum { MOST_HITS = 64 };

/* When contacts began, those apart that lie less than a millisecond from the last. */
typedef struct Hits {
  double at[MOST_HITS]; /* [s] */
  uint32_t count;
  bool touching;
  double apart; /* since when nothing touches [s] */
} Hits;

static void watch(Hits *hits, const TaborDrum *drum, double now) {
  TaborProbe probe;
  tabor_drum_probe(drum, &probe);
  const bool touches = probe.striker_force > 0.0;
  if (touches && !hits->touching && (hits->count == 0 || now - hits->apart > 1e-3)) {
    if (hits->count < MOST_HITS) hits->at[hits->count] = now;
    hits->count++;
  }
  if (!touches && hits->touching) hits->apart = now;
  hits->touching = touches;
}

static TaborDrumDef held_drum(double grip) {
  TaborDrumDef def = physics_preset("snare-14x5.5-off");
  def.striker[0].mass = 0.0126;
  def.hand.grip = grip;
  return def;
}

static const TaborEvent BUZZ = {.type = TABOR_EVENT_STRIKE,
                                .id = 1,
                                .velocity = 1.5,
                                .radius = 0.08,
                                .technique = TABOR_TECHNIQUE_BUZZ};

static Hits hits_of_buzz(double grip, double seconds, TaborLedger *ledger) {
  const TaborDrumDef def = held_drum(grip);
  TaborModel *model = physics_model(&def, RATE, TABOR_QUALITY_DRAFT);
  TaborDrum *drum = physics_drum(model);
  Hits hits = {.count = 0};
  for (uint32_t i = 0; i < (uint32_t)(seconds * RATE); i++) {
    tabor_drum_process(drum, &BUZZ, i == 0, NULL, 1);
    watch(&hits, drum, i / RATE);
  }
  tabor_drum_ledger(drum, ledger);
  tabor_drum_destroy(drum);
  tabor_model_release(model);
  return hits;
}

static void bounces_come_closer_and_closer_with_grip(void **state) {
  (void)state;
  double last_mean = 1.0;
  for (double grip = 0.25; grip <= 1.0; grip += 0.25) {
    TaborLedger ledger;
    const Hits hits = hits_of_buzz(grip, 0.6, &ledger);
    assert_true(hits.count >= 6 && hits.count <= MOST_HITS);
    const double mean = (hits.at[5] - hits.at[0]) / 5.0;
    print_message("grip %.2f: gaps of %.0f %.0f %.0f %.0f %.0f ms\n", grip,
                  1e3 * (hits.at[1] - hits.at[0]), 1e3 * (hits.at[2] - hits.at[1]),
                  1e3 * (hits.at[3] - hits.at[2]), 1e3 * (hits.at[4] - hits.at[3]),
                  1e3 * (hits.at[5] - hits.at[4]));
    assert_true(hits.at[4] - hits.at[3] < hits.at[1] - hits.at[0]);
    assert_true(mean < last_mean);
    last_mean = mean;
    if (grip == 0.5) { /* as buzz strokes are known to */
      print_message("grip %.2f: %.0f bounces a second\n", grip, 1.0 / mean);
      assert_true(1.0 / mean > 15.0 && 1.0 / mean < 30.0);
    }
    assert_true(ledger.damper_loss > 0.0);
    assert_true(fabs(ledger.residual) < physics_residual(TABOR_QUALITY_DRAFT) * ledger.injected);
  }
}

static void without_grip_the_stick_rebounds_as_if_it_were_free(void **state) {
  (void)state;
  static float held[9600], free_one[9600];
  double lost[2]; /* by bending, which a hand damps at any grip */
  for (int buzz = 0; buzz < 2; buzz++) {
    const TaborDrumDef def = held_drum(0.0);
    TaborModel *model = physics_model(&def, RATE, TABOR_QUALITY_DRAFT);
    model->stretch.hold = UINT32_MAX; /* or the head stretches for as long as the stick is there */
    TaborDrum *drum = physics_drum(model);
    TaborEvent stroke = BUZZ;
    if (!buzz) stroke.technique = TABOR_TECHNIQUE_NORMAL;
    float *outputs[TABOR_MAX_MICS] = {buzz ? held : free_one};
    tabor_drum_process(drum, &stroke, 1, outputs, 9600);
    TaborLedger ledger;
    tabor_drum_ledger(drum, &ledger);
    assert_true(ledger.removed > 0.0); /* it has flown off */
    lost[buzz] = ledger.damper_loss;
    tabor_drum_destroy(drum);
    tabor_model_release(model);
  }
  for (int i = 0; i < 9600; i++) assert_true(fabsf(held[i] - free_one[i]) < 1e-6f);
  print_message("bending loses %.3g J free, %.3g J held\n", lost[0], lost[1]);
  assert_true(lost[0] > 0.0 && lost[1] >= lost[0]); /* out of a hand it is taken away later */
}

static void a_buzz_is_a_stroke_that_is_pressed(void **state) {
  (void)state;
  static float sound[2][9600];
  for (int buzz = 0; buzz < 2; buzz++) {
    const TaborDrumDef def = held_drum(0.5);
    TaborModel *model = physics_model(&def, RATE, TABOR_QUALITY_DRAFT);
    TaborDrum *drum = physics_drum(model);
    TaborEvent events[2] = {BUZZ, {.type = TABOR_EVENT_PRESS, .id = 1, .value = 0.3}};
    events[0].value = 0.3;
    if (!buzz) events[0].technique = TABOR_TECHNIQUE_NORMAL;
    float *outputs[TABOR_MAX_MICS] = {sound[buzz]};
    tabor_drum_process(drum, events, buzz ? 1 : 2, outputs, 9600);
    tabor_drum_destroy(drum);
    tabor_model_release(model);
  }
  assert_memory_equal(sound[0], sound[1], sizeof sound[0]);
}

/* What the lift of the hardest press adds to the sound is 30 dB below the stroke: 20 where it took
 * 8 ms, and was heard as a stroke. */
static void a_stick_is_lifted_without_a_second_stroke(void **state) {
  (void)state;
  enum { LIFTED = 19200, FRAMES = 28800 };
  static float sound[2][FRAMES];
  const TaborDrumDef def = physics_preset("snare-14x5.5-off");
  TaborModel *model = physics_model(&def, RATE, TABOR_QUALITY_LIVE);
  const TaborEvent events[2] = {{.type = TABOR_EVENT_STRIKE,
                                 .technique = TABOR_TECHNIQUE_BUZZ,
                                 .id = 1,
                                 .velocity = 2.0,
                                 .value = 1.0},
                                {.type = TABOR_EVENT_RELEASE, .id = 1, .frame = LIFTED}};
  for (uint32_t lifts = 0; lifts < 2; lifts++) {
    TaborDrum *drum = physics_drum(model);
    float *outputs[TABOR_MAX_MICS] = {sound[lifts]};
    tabor_drum_process(drum, events, 1 + lifts, outputs, FRAMES);
    tabor_drum_destroy(drum);
  }
  double stroke = 0.0, lift = 0.0;
  for (int i = 0; i < FRAMES; i++) {
    stroke = fmax(stroke, fabs((double)sound[0][i]));
    lift = fmax(lift, fabs((double)sound[1][i] - (double)sound[0][i]));
  }
  print_message("lifted, %.1f dB below the stroke\n", 20.0 * log10(lift / stroke));
  assert_true(lift > 0.0 && lift < stroke * pow(10.0, -30.0 / 20.0));
  tabor_model_release(model);
}

/* A rod of 0.4 m: held at its middle 1/3 of it counts at the tip, at a third from its end a
 * quarter. */
static void where_the_stick_is_held_decides_what_it_weighs(void **state) {
  (void)state;
  static const double PIVOT[] = {0.2, 0.4 / 3.0}, PART[] = {1.0 / 3.0, 0.25};
  double mass[2];
  for (int i = 0; i < 2; i++) {
    TaborDrumDef def = held_drum(0.5);
    def.hand.pivot = PIVOT[i];
    TaborModel *model = physics_model(&def, RATE, TABOR_QUALITY_DRAFT);
    TaborDrum *drum = physics_drum(model);
    tabor_drum_process(drum, &BUZZ, 1, NULL, 0);
    TaborLedger ledger;
    tabor_drum_ledger(drum, &ledger);
    mass[i] = 2.0 * ledger.injected / (1.5 * 1.5);
    tabor_drum_destroy(drum);
    tabor_model_release(model);
  }
  assert_true(fabs(mass[0] / mass[1] - PART[0] / PART[1]) < 1e-9);
  assert_true(fabs(mass[1] - 0.05 * PART[1]) < 2e-5); /* 50 g */
}

/* ---- while it bounces ------------------------------------------------------------------------ */

/* Presses, lets go, grips and strikes again, mostly while sticks touch the head. */
static uint32_t hands_at_work(uint32_t frame, TaborEvent *event) {
  const TaborParameter *grip = tabor_parameter_find("hand.grip");
  const uint32_t turn = frame / 317;
  if (frame % 317 != 40) return 0;
  *event = (TaborEvent){.type = TABOR_EVENT_PRESS, .id = turn % 3, .value = (turn * 7 % 10) / 9.0};
  if (turn % 5 == 0) {
    *event = BUZZ;
    event->id = 1 + turn % 2;
    event->velocity = 0.5 + 0.1 * (turn % 30);
    event->value = 0.1 * (turn % 7);
  } else if (turn % 5 == 2) {
    *event = (TaborEvent){
      .type = TABOR_EVENT_PARAMETER, .parameter = grip->id, .value = (turn * 3 % 8) / 7.0};
  } else if (turn % 11 == 4) {
    *event = (TaborEvent){.type = TABOR_EVENT_RELEASE, .id = 1};
  }
  return 1;
}

enum { FRAMES = 12000, SWAPPED_AT = 6000 };

static void changes_while_it_bounces_are_accounted_for_at_every_cap(void **state) {
  (void)state;
  static float out[FRAMES];
  for (uint32_t cap = 1; cap <= 4; cap++) {
    for (uint32_t losses = 0; losses < 2; losses++) {
      TaborDrumDef def = physics_preset(cap % 2 ? "frame-drum" : "snare-14x5.5");
      def.quality.newton_cap = cap;
      def.quality.losses = losses;
      def.quality.two_way_bandwidth = 2000.0;
      def = physics_small(&def);
      TaborModel *model = physics_model(&def, RATE, TABOR_QUALITY_STUDIO);
      TaborDrum *drum = physics_drum(model);
      event_script_play(hands_at_work, drum, 0, FRAMES, 64, out);
      TaborLedger ledger;
      TaborStatistics statistics;
      tabor_drum_ledger(drum, &ledger);
      tabor_drum_statistics(drum, &statistics);
      print_message("%s, cap %u, losses %u: residual %.1e of %.2g J, dampers %.2g J, %llu capped\n",
                    def.name, cap, losses, ledger.residual / ledger.injected, ledger.injected,
                    ledger.damper_loss, (unsigned long long)statistics.newton_capped);
      assert_true(ledger.residual >= -1e-9 * ledger.injected);
      if (statistics.newton_capped == 0) assert_true(ledger.residual < 1e-9 * ledger.injected);
      assert_true(losses ? ledger.damper_loss > 0.0 : ledger.damper_loss == 0.0);
      tabor_drum_destroy(drum);
      tabor_model_release(model);
    }
  }
}

static void blocks_saves_and_resets_keep_every_bit(void **state) {
  (void)state;
  static float whole[FRAMES], parts[FRAMES];
  const TaborDrumDef def = held_drum(0.5);
  TaborModel *model = physics_model(&def, RATE, TABOR_QUALITY_DRAFT);
  event_script_keeps_every_bit(hands_at_work, model, FRAMES, whole, parts);
  tabor_model_release(model);
}

static void a_swap_keeps_the_stick_in_the_hand(void **state) {
  (void)state;
  static float straight[FRAMES], out[FRAMES];
  TaborDrumDef def = held_drum(0.5);
  TaborModel *model = physics_model(&def, RATE, TABOR_QUALITY_DRAFT);
  TaborModel *twin = physics_model(&def, RATE, TABOR_QUALITY_DRAFT);
  def.batter.tension *= 1.05;
  TaborModel *tighter = physics_model(&def, RATE, TABOR_QUALITY_DRAFT);
  TaborDrum *drum = physics_drum(model);
  event_script_play(hands_at_work, drum, 0, FRAMES, 100, straight);
  tabor_drum_destroy(drum);
  drum = event_script_swapped(hands_at_work, model, twin, SWAPPED_AT, FRAMES, out);
  assert_memory_equal(straight, out, sizeof out);
  tabor_drum_destroy(drum);
  drum = event_script_swapped(hands_at_work, model, tighter, SWAPPED_AT, FRAMES, out);
  TaborProbe probe;
  TaborLedger ledger;
  TaborStatistics statistics;
  tabor_drum_probe(drum, &probe);
  tabor_drum_ledger(drum, &ledger);
  tabor_drum_statistics(drum, &statistics);
  assert_false(isnan(probe.striker));
  assert_true(fabs(ledger.residual) < physics_residual(TABOR_QUALITY_DRAFT) * ledger.injected);
  tabor_drum_destroy(drum);
  tabor_model_release(model);
  tabor_model_release(twin);
  tabor_model_release(tighter);
}

/* Two hands in turn, 7 strokes a second: what one leaves silent the other fills. */
static void a_press_roll_has_no_gaps(void **state) {
  (void)state;
  const TaborDrumDef def = held_drum(0.5);
  TaborModel *model = physics_model(&def, RATE, TABOR_QUALITY_DRAFT);
  TaborDrum *drum = physics_drum(model);
  Hits hits = {.count = 0};
  double longest = 0.0;
  const uint32_t stroke = (uint32_t)(RATE / 7.0), frames = (uint32_t)(2.0 * RATE);
  for (uint32_t i = 0; i < frames; i++) {
    TaborEvent buzz = BUZZ;
    buzz.id = 1 + i / stroke % 2;
    buzz.angle = buzz.id * 20.0;
    buzz.value = 0.1;
    tabor_drum_process(drum, &buzz, i % stroke == 0, NULL, 1);
    watch(&hits, drum, i / RATE);
    if (!hits.touching) longest = fmax(longest, i / RATE - hits.apart);
  }
  TaborStatistics statistics;
  tabor_drum_statistics(drum, &statistics);
  print_message("roll: %llu strokes, %.0f bounces a second, silent for %.0f ms at the longest\n",
                (unsigned long long)statistics.strikes, hits.count / 2.0, 1e3 * longest);
  assert_int_equal(statistics.dropped_events, 0);
  assert_int_equal(statistics.strikes, (frames + stroke - 1) / stroke);
  assert_true(longest < 0.05);
  assert_true(hits.count / 2.0 > 25.0);
  tabor_drum_destroy(drum);
  tabor_model_release(model);
}

int main(void) {
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(harder_pressure_bounces_faster),
    cmocka_unit_test(a_light_press_brings_the_stick_back),
    cmocka_unit_test(a_released_stick_is_gone_and_the_drum_falls_silent),
    cmocka_unit_test(bounces_come_closer_and_closer_with_grip),
    cmocka_unit_test(without_grip_the_stick_rebounds_as_if_it_were_free),
    cmocka_unit_test(a_buzz_is_a_stroke_that_is_pressed),
    cmocka_unit_test(a_stick_is_lifted_without_a_second_stroke),
    cmocka_unit_test(where_the_stick_is_held_decides_what_it_weighs),
    cmocka_unit_test(changes_while_it_bounces_are_accounted_for_at_every_cap),
    cmocka_unit_test(blocks_saves_and_resets_keep_every_bit),
    cmocka_unit_test(a_swap_keeps_the_stick_in_the_hand),
    cmocka_unit_test(a_press_roll_has_no_gaps),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
