/* SPDX-License-Identifier: MIT */
/* A drum that nobody hears sleeps: nothing audible is cut, no rattle either, the ledger has what it
 * held, and what holds it away from its rest holds it on. */
#include "physics.h"

#include "drum/drum.h"

enum { LENGTH = 192000, BLOCK = 96, WINDOW = 960 };

static const double UNHEARD = 3.1623e-6; /* -110 dBFS */

typedef struct Take {
  float sound[TABOR_MAX_MICS][LENGTH];
  uint32_t asleep; /* the first frame of the block in which the drum falls asleep */
  TaborLedger ledger;
} Take;

/* Events of a drum that sleeps as soon as nobody hears it, or not until it is still. */
static void play(TaborModel *model, const TaborEvent *events, uint32_t count, bool sleeps,
                 Take *take) {
  model->resting.sounds = sleeps;
  TaborDrum *drum = physics_drum(model);
  take->asleep = LENGTH;
  for (uint32_t frame = 0, next = 0; frame < LENGTH; frame += BLOCK) {
    float *outputs[TABOR_MAX_MICS];
    TaborEvent now[4];
    uint32_t due = 0;
    for (; next < count && events[next].frame < frame + BLOCK; next++) {
      now[due] = events[next];
      now[due++].frame -= frame;
    }
    for (uint32_t mic = 0; mic < TABOR_MAX_MICS; mic++) outputs[mic] = take->sound[mic] + frame;
    tabor_drum_process(drum, now, due, outputs, BLOCK);
    if (next == count && take->asleep == LENGTH && tabor_drum_is_silent(drum)) take->asleep = frame;
  }
  tabor_drum_ledger(drum, &take->ledger);
  tabor_drum_destroy(drum);
}

/* The loudest 20 ms, as their root mean square, of what the second take has and the first one
 * lacks. */
static double most_away(const TaborModel *model, const Take *cut, const Take *whole) {
  double most = 0.0;
  for (uint32_t mic = 0; mic < model->def.mic_count; mic++) {
    for (uint32_t from = 0; from < LENGTH; from += WINDOW) {
      double sum = 0.0;
      for (uint32_t i = from; i < from + WINDOW; i++) {
        const double away = (double)whole->sound[mic][i] - (double)cut->sound[mic][i];
        sum += away * away;
      }
      most = fmax(most, sqrt(sum / WINDOW));
    }
  }
  return most;
}

static void check_ledger(const TaborLedger *ledger) {
  const double wires = 2e-12 * LENGTH / 48000.0;
  assert_true(fabs(ledger->residual) <=
              physics_residual(TABOR_QUALITY_LIVE) * ledger->injected + wires);
}

/* Returns the energy that the drum holds asleep. */
static double check_sleep(const TaborDrumDef *def, const TaborEvent *events, uint32_t count) {
  static Take cut, whole;
  TaborModel *model = physics_model(def, 48000.0, TABOR_QUALITY_LIVE);
  play(model, events, count, true, &cut);
  play(model, events, count, false, &whole);
  const double away = most_away(model, &cut, &whole);
  print_message("%s: asleep after %.2f s, otherwise after %.2f s; %.1f dBFS cut; residual %.2g J\n",
                def->name, cut.asleep / 48000.0, whole.asleep / 48000.0, 20.0 * log10(away),
                cut.ledger.residual);
  assert_true(cut.asleep < LENGTH && cut.asleep < whole.asleep);
  assert_true(away < UNHEARD);
  check_ledger(&cut.ledger);
  check_ledger(&whole.ledger);
  tabor_model_release(model);
  return cut.ledger.stored;
}

static void nobody_hears_that_a_drum_sleeps(void **state) {
  (void)state;
  static const char *const presets[] = {"snare-14x5.5",     "snare-14x6.5-loose",
                                        "snare-14x5.5-off", "tom-12",
                                        "bass-drum-22",     "bodhran-piano-string"};
  for (size_t i = 0; i < sizeof presets / sizeof *presets; i++) {
    const TaborDrumDef def = physics_preset(presets[i]);
    const TaborEvent stroke = physics_strike(&def);
    assert_true(check_sleep(&def, &stroke, 1) == 0.0);
  }
}

/* A soft buzz: a stick is pressed onto the head and lifted while the wires still rattle. */
static void the_last_rattle_of_a_buzz_is_heard(void **state) {
  (void)state;
  static const char *const presets[] = {"snare-14x5.5", "snare-14x6.5-loose", "snare-jazz-open"};
  for (size_t i = 0; i < sizeof presets / sizeof *presets; i++) {
    const TaborDrumDef def = physics_preset(presets[i]);
    TaborEvent events[] = {physics_strike(&def),
                           {.type = TABOR_EVENT_PRESS, .value = 0.2},
                           {.type = TABOR_EVENT_RELEASE, .frame = 14400}};
    for (double speed = 0.1; speed < 1.0; speed *= 3.0) {
      events[0].velocity = speed;
      assert_true(check_sleep(&def, events, 3) == 0.0);
    }
  }
}

/* Wires that are thrown off swing after a stroke, and touch nothing. The high band does not lean by
 * the load that they took from the head: scattering would make hiss of that for good. */
static void wires_that_are_off_let_a_drum_sleep(void **state) {
  (void)state;
  const TaborDrumDef def = physics_preset("snare-14x5.5");
  TaborEvent events[] = {{.type = TABOR_EVENT_PARAMETER,
                          .parameter = tabor_parameter_find("wires.strainer")->id,
                          .value = 0.0},
                         physics_strike(&def)};
  events[1].frame = 9600;
  (void)check_sleep(&def, events, 2);
}

/* ---- when a drum does not sleep -------------------------------------------------------------- */

static uint32_t time_to_sleep(const TaborDrumDef *def, uint32_t quality) {
  TaborModel *model = physics_model(def, 48000.0, quality);
  TaborDrum *drum = physics_drum(model);
  const TaborEvent stroke = physics_strike(def);
  tabor_drum_process(drum, &stroke, 1, NULL, BLOCK);
  uint32_t frames = BLOCK;
  for (; frames < LENGTH && !tabor_drum_is_silent(drum); frames += BLOCK)
    tabor_drum_process(drum, NULL, 0, NULL, BLOCK);
  tabor_drum_destroy(drum);
  tabor_model_release(model);
  return frames;
}

/* A microphone that is turned off may be turned on. */
static void a_gain_of_nothing_puts_no_drum_to_sleep(void **state) {
  (void)state;
  TaborDrumDef def = physics_preset("tom-12");
  const uint32_t usual = time_to_sleep(&def, TABOR_QUALITY_LIVE);
  for (uint32_t mic = 0; mic < def.mic_count; mic++) def.mic[mic].gain = 0.0;
  assert_int_equal(time_to_sleep(&def, TABOR_QUALITY_LIVE), usual);
}

/* Nobody hears a drum in a vacuum, ever. */
static void a_drum_in_a_vacuum_rings_until_it_is_still(void **state) {
  (void)state;
  TaborDrumDef def = physics_membrane();
  def.batter.damping_0 = 20.0;
  const uint32_t frames = time_to_sleep(&def, TABOR_QUALITY_LIVE);
  print_message("asleep after %.2f s\n", frames / 48000.0);
  assert_true(frames > 24000 && frames < LENGTH);
}

static void studio_rings_until_it_is_still(void **state) {
  (void)state;
  TaborDrumDef def = physics_preset("tom-12");
  def.quality.two_way_bandwidth = 1500.0;
  const uint32_t live = time_to_sleep(&def, TABOR_QUALITY_LIVE);
  const uint32_t studio = time_to_sleep(&def, TABOR_QUALITY_STUDIO);
  print_message("asleep after %.2f s at live, %.2f s at studio\n", live / 48000.0,
                studio / 48000.0);
  assert_true(live < LENGTH && studio > 3u * live / 2u);
}

/* A stick that lies on the head pushes it down, asleep and awake. */
static void what_is_held_stays(void **state) {
  (void)state;
  const TaborDrumDef def = physics_preset("tom-12");
  TaborModel *model = physics_model(&def, 48000.0, TABOR_QUALITY_LIVE);
  TaborDrum *drum = physics_drum(model);
  TaborEvent events[] = {physics_strike(&def), {.type = TABOR_EVENT_PRESS, .value = 0.2}};
  events[0].velocity = 1.0;
  tabor_drum_process(drum, events, 2, NULL, 4 * LENGTH);
  TaborProbe before, after;
  TaborLedger ledger;
  tabor_drum_ledger(drum, &ledger);
  tabor_drum_probe(drum, &before);
  assert_true(tabor_drum_is_silent(drum));
  const TaborEvent change = {.type = TABOR_EVENT_PARAMETER,
                             .parameter = tabor_parameter_find("output.full_scale")->id,
                             .value = def.full_scale};
  tabor_drum_process(drum, &change, 1, NULL, 48000);
  tabor_drum_probe(drum, &after);
  print_message("head at %.6f mm, %.6f mm after a second awake; stored %.2g J, residual %.2g J\n",
                1e3 * before.head, 1e3 * after.head, ledger.stored, ledger.residual);
  assert_true(before.head < -1e-5 && fabs(after.head - before.head) < 1e-3 * fabs(before.head));
  assert_true(ledger.stored > 1e-9);
  check_ledger(&ledger);
  tabor_drum_destroy(drum);
  tabor_model_release(model);
}

int main(void) {
  const struct CMUnitTest tests[] = {cmocka_unit_test(nobody_hears_that_a_drum_sleeps),
                                     cmocka_unit_test(the_last_rattle_of_a_buzz_is_heard),
                                     cmocka_unit_test(wires_that_are_off_let_a_drum_sleep),
                                     cmocka_unit_test(a_gain_of_nothing_puts_no_drum_to_sleep),
                                     cmocka_unit_test(a_drum_in_a_vacuum_rings_until_it_is_still),
                                     cmocka_unit_test(studio_rings_until_it_is_still),
                                     cmocka_unit_test(what_is_held_stays)};
  return cmocka_run_group_tests(tests, NULL, NULL);
}
