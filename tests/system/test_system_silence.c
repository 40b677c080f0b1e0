/* SPDX-License-Identifier: MIT */
/* What sounds fades within 15 ms, and the drum goes on from rest as what it was.
 *
 * usage: test_system_silence [brief]: of drums with few modes. */
#include "physics.h"

enum { BEFORE = 2000, FADE = 720, FRAMES = 9600 }; /* 720 samples are 15 ms, as the engine has it */

static bool brief;

static const double ROUNDING = 2e-7; /* of single precision, to which samples are rounded */

typedef float Sound[2][FRAMES];

static TaborDrumDef preset(const char *name) {
  TaborDrumDef def = physics_preset(name);
  if (brief) {
    def.quality.two_way_bandwidth = 1000.0;
    def.quality.bandwidth = 3000.0;
  }
  return def;
}

static void play(TaborDrum *drum, const TaborEvent *events, uint32_t count, uint32_t frames,
                 Sound sound) {
  float *outputs[TABOR_MAX_MICS] = {sound[0], sound[1]};
  tabor_drum_process(drum, events, count, outputs, frames);
}

static TaborEvent parameter(const char *key, double value) {
  return (TaborEvent){
    .type = TABOR_EVENT_PARAMETER, .parameter = tabor_parameter_find(key)->id, .value = value};
}

static double faded(float sample, uint32_t i) {
  return i < FADE ? (FADE - i) / (FADE + 1.0) * (double)sample : 0.0;
}

static void assert_sum(double value, double a, double b) {
  if (fabs(value - (a + b)) > ROUNDING * (fabs(a) + fabs(b))) {
    fail_msg("%.9g, not %.9g + %.9g", value, a, b);
  }
}

static double peak(Sound sound, uint32_t from, uint32_t until) {
  double most = 0;
  for (uint32_t i = from; i < until; i++) most = fmax(most, fabs((double)sound[0][i]));
  return most;
}

static const TaborEvent silence = {.type = TABOR_EVENT_SILENCE};

/* A stroke within the fade is the one of a drum at rest, beside the sound that fades. */
static void what_sounds_fades_and_the_next_stroke_is_whole(void **state) {
  (void)state;
  static Sound sound, ringing, fresh;
  const TaborDrumDef def = preset("tabor");
  TaborModel *model = physics_model(&def, 48000.0, TABOR_QUALITY_DRAFT);
  TaborDrum *drum = physics_drum(model), *alone = physics_drum(model),
            *rested = physics_drum(model);
  const TaborEvent strike = physics_strike(&def);
  TaborEvent second = strike;
  second.frame = 100;
  play(drum, &strike, 1, BEFORE, sound);
  play(alone, &strike, 1, BEFORE, ringing);
  assert_true(peak(sound, 0, BEFORE) > 1e-2);
  const TaborEvent events[] = {silence, second};
  play(drum, events, 2, FRAMES, sound);
  play(alone, NULL, 0, FRAMES, ringing);
  play(rested, &second, 1, FRAMES, fresh);
  for (uint32_t mic = 0; mic < 2; mic++) {
    for (uint32_t i = 0; i < FRAMES; i++) {
      assert_sum((double)sound[mic][i], (double)fresh[mic][i], faded(ringing[mic][i], i));
      if (i >= FADE) assert_true(sound[mic][i] == fresh[mic][i]);
    }
  }
  tabor_drum_destroy(rested);
  tabor_drum_destroy(alone);
  tabor_drum_destroy(drum);
  tabor_model_release(model);
}

static void counters_and_ledger_go_on(void **state) {
  (void)state;
  static Sound sound;
  const TaborDrumDef def = preset("tabor");
  TaborModel *model = physics_model(&def, 48000.0, TABOR_QUALITY_STUDIO);
  TaborDrum *drum = physics_drum(model);
  const TaborEvent strike = physics_strike(&def);
  TaborLedger before, after;
  TaborStatistics statistics;
  play(drum, &strike, 1, BEFORE, sound);
  tabor_drum_ledger(drum, &before);
  play(drum, &silence, 1, FADE, sound);
  tabor_drum_ledger(drum, &after);
  assert_true(tabor_drum_is_silent(drum));
  assert_true(after.stored == 0 && after.injected == before.injected);
  assert_true(fabs(after.residual) <= 1e-9 * (after.injected + fabs(after.control)));
  play(drum, &strike, 1, FRAMES, sound);
  tabor_drum_ledger(drum, &after);
  tabor_drum_statistics(drum, &statistics);
  assert_true(fabs(after.residual) <= 1e-9 * (after.injected + fabs(after.control)));
  assert_int_equal(statistics.strikes, 2);
  assert_int_equal(statistics.frames, BEFORE + FADE + FRAMES);
  tabor_drum_destroy(drum);
  tabor_model_release(model);
}

/* Where nothing sounds nothing happens, not even a tail. */
static void a_silent_drum_stays_as_it_is(void **state) {
  (void)state;
  static Sound sound, expected;
  const TaborDrumDef def = preset("tabor");
  TaborModel *model = physics_model(&def, 48000.0, TABOR_QUALITY_DRAFT);
  TaborDrum *drum = physics_drum(model), *other = physics_drum(model);
  const TaborEvent strike = physics_strike(&def), events[] = {silence, silence, strike};
  play(drum, events, 1, 0, sound);
  assert_true(tabor_drum_is_silent(drum));
  play(drum, events, 3, FRAMES, sound);
  play(other, &strike, 1, FRAMES, expected);
  assert_memory_equal(sound, expected, sizeof sound);
  tabor_drum_destroy(other);
  tabor_drum_destroy(drum);
  tabor_model_release(model);
}

/* The first of two silences is cut; what was struck between them fades, too. */
static void a_second_silence_leaves_nothing(void **state) {
  (void)state;
  static Sound sound;
  const TaborDrumDef def = preset("tabor");
  TaborModel *model = physics_model(&def, 48000.0, TABOR_QUALITY_DRAFT);
  TaborDrum *drum = physics_drum(model);
  const TaborEvent strike = physics_strike(&def);
  const TaborEvent events[] = {silence, strike, {.type = TABOR_EVENT_SILENCE, .frame = 200}};
  play(drum, &strike, 1, BEFORE, sound);
  play(drum, events, 3, FRAMES, sound);
  assert_true(peak(sound, 0, 200 + FADE) > 1e-3);
  assert_true(peak(sound, 200 + FADE, FRAMES) == 0);
  tabor_drum_destroy(drum);
  tabor_model_release(model);
}

/* The snares stay off, and nobody hears how they leave the head again. */
static void live_values_go_on(void **state) {
  (void)state;
  static Sound still, again, off;
  TaborDrumDef def = preset("snare-14x5.5");
  def.batter.unevenness = def.resonant.unevenness =
    0.0; /* a drum that is awake goes on scattering */
  TaborModel *model = physics_model(&def, 48000.0, TABOR_QUALITY_DRAFT);
  TaborDrum *drum = physics_drum(model), *other = physics_drum(model);
  const TaborEvent strike = physics_strike(&def);
  const TaborEvent moves[] = {parameter("wires.strainer", 0),
                              parameter("output.full_scale", 0.5 * def.full_scale), strike};
  tabor_drum_process(other, moves, 2, NULL, 48000);
  play(other, &strike, 1, FRAMES, off);
  tabor_drum_process(drum, moves, 3, NULL, 24000);
  play(drum, &silence, 1, FRAMES, still);
  tabor_drum_process(drum, NULL, 0, NULL, 48000);
  play(drum, &strike, 1, FRAMES, again);
  assert_true(peak(still, 0, FADE) > 1e-4 && peak(still, FADE, FRAMES) == 0);
  for (uint32_t i = 0; i < FRAMES; i++) {
    if (fabs((double)again[0][i] - (double)off[0][i]) > 1e-3 * peak(off, 0, FRAMES)) {
      fail_msg("frame %u: %.9g, not %.9g", (unsigned)i, (double)again[0][i], (double)off[0][i]);
    }
  }
  tabor_drum_destroy(other);
  tabor_drum_destroy(drum);
  tabor_model_release(model);
}

/* A gain moves evenly over 5 ms and goes on through a silence; a reset brings it back to 1. */
static void a_gain_is_smooth_and_stays(void **state) {
  (void)state;
  enum { RAMP = 241, AT = 500 };
  static Sound sound, plain;
  const TaborDrumDef def = preset("tabor");
  TaborModel *model = physics_model(&def, 48000.0, TABOR_QUALITY_DRAFT);
  TaborDrum *drum = physics_drum(model), *other = physics_drum(model);
  const TaborEvent strike = physics_strike(&def), reset = {.type = TABOR_EVENT_RESET};
  const TaborEvent events[] = {strike, {.type = TABOR_EVENT_GAIN, .frame = AT, .value = 0.25}};
  play(drum, events, 2, FRAMES, sound);
  play(other, &strike, 1, FRAMES, plain);
  for (uint32_t i = 0; i < FRAMES; i++) {
    const double moved = i < AT ? 0 : fmin((i - AT + 1.0) / RAMP, 1);
    assert_sum((double)sound[0][i], (1 - 0.75 * moved) * (double)plain[0][i], 0);
  }
  const TaborEvent again[] = {silence, strike};
  tabor_drum_process(drum, &silence, 1, NULL, FADE);
  tabor_drum_reset(other);
  play(drum, again, 2, FRAMES, sound);
  play(other, &strike, 1, FRAMES, plain);
  for (uint32_t i = 0; i < FRAMES; i++)
    assert_sum((double)sound[0][i], 0.25 * (double)plain[0][i], 0);
  tabor_drum_process(drum, &reset, 1, NULL, 0);
  play(drum, &strike, 1, FRAMES, sound);
  assert_memory_equal(sound, plain, sizeof sound);
  tabor_drum_destroy(other);
  tabor_drum_destroy(drum);
  tabor_model_release(model);
}

int main(int argc, char **argv) {
  brief = argc > 1 && strcmp(argv[1], "brief") == 0;
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(what_sounds_fades_and_the_next_stroke_is_whole),
    cmocka_unit_test(counters_and_ledger_go_on),
    cmocka_unit_test(a_silent_drum_stays_as_it_is),
    cmocka_unit_test(a_second_silence_leaves_nothing),
    cmocka_unit_test(live_values_go_on),
    cmocka_unit_test(a_gain_is_smooth_and_stays),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
