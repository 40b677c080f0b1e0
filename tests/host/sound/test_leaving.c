/* SPDX-License-Identifier: MIT */
/* Drums that ring out beside another one, and what they have counted. */
#include "sound/leaving.h"

#include "physics.h"
#include "sound/tally.h"

enum { FADE = 1440, MICS = 3 }; /* frames of 30 ms at 48 kHz; of the frame drum */

static TaborModel *model;
static TaborEvent strike;

static int create_model(void **state) {
  (void)state;
  const TaborDrumDef def = physics_preset("frame-drum");
  model = physics_model(&def, 48000, TABOR_QUALITY_DRAFT);
  strike = physics_strike(&def);
  return 0;
}

static int release_model(void **state) {
  (void)state;
  tabor_model_release(model);
  return 0;
}

static TaborDrum *ringing_drum(void) {
  TaborDrum *const drum = physics_drum(model);
  tabor_drum_process(drum, &strike, 1, NULL, 300);
  return drum;
}

static const uint32_t straight[MICS] = {0, 1, 2};

/* Two channels hear one microphone, one hears none, and nobody listens to the last. */
static void each_channel_keeps_its_microphone(void **state) {
  (void)state;
  enum { CHANNELS = 5 };
  static const uint32_t mics[CHANNELS] = {2, 0, LEAVING_NO_MIC, 2, 1};
  static double sound[CHANNELS][2 * FADE];
  static float alone[MICS][2 * FADE];
  Leaving leaving;
  TaborDrum *const drum = ringing_drum(), *const twin = ringing_drum();
  float *outputs[TABOR_MAX_MICS] = {alone[0], alone[1], alone[2]};
  tabor_drum_process(twin, NULL, 0, outputs, 2 * FADE);
  leaving_begin(&leaving, 48000);
  assert_null(leaving_add(&leaving, drum, mics, CHANNELS));
  for (uint32_t at = 0, size = 1; at < 2 * FADE; at += size, size = size % LEAVING_PIECE + 1) {
    double *channels[CHANNELS] = {sound[0] + at, sound[1] + at, sound[2] + at, sound[3] + at, NULL};
    if (size > 2 * FADE - at) size = 2 * FADE - at;
    leaving_play(&leaving, channels, CHANNELS, size);
  }
  for (uint32_t i = 0; i < 2 * FADE; i++) {
    const double part = i < FADE ? (FADE - i) / (FADE + 1.0) : 0;
    assert_true(sound[0][i] == part * (double)alone[2][i]);
    assert_true(sound[1][i] == part * (double)alone[0][i]);
    assert_true(sound[2][i] == 0 && sound[4][i] == 0);
    assert_true(sound[3][i] == sound[0][i]);
  }
  assert_ptr_equal(leaving_take(&leaving), drum);
  assert_null(leaving_take(&leaving));
  tabor_drum_destroy(drum);
  tabor_drum_destroy(twin);
}

static void sounds_add_up(void **state) {
  (void)state;
  static double both[FADE], one[FADE];
  Leaving leaving;
  TaborDrum *const drums[] = {ringing_drum(), ringing_drum(), ringing_drum()};
  double *channel[MICS] = {both};
  leaving_begin(&leaving, 48000);
  for (int i = 0; i < 2; i++) assert_null(leaving_add(&leaving, drums[i], straight, MICS));
  leaving_play(&leaving, channel, MICS, LEAVING_PIECE);
  leaving_cut(&leaving);
  for (int i = 0; i < 2; i++) assert_ptr_equal(leaving_take(&leaving), drums[i]);
  assert_null(leaving_add(&leaving, drums[2], straight, MICS));
  channel[0] = one;
  leaving_play(&leaving, channel, MICS, LEAVING_PIECE);
  for (int i = 0; i < LEAVING_PIECE; i++) assert_true(both[i] == 2 * one[i]);
  for (int i = 0; i < 3; i++) tabor_drum_destroy(drums[i]);
}

static void a_silent_drum_has_left_at_once(void **state) {
  (void)state;
  Leaving leaving;
  TaborDrum *const drum = physics_drum(model);
  leaving_begin(&leaving, 48000);
  assert_ptr_equal(leaving_add(&leaving, drum, straight, MICS), drum);
  assert_int_equal(leaving.count, 0);
  tabor_drum_destroy(drum);
}

static void the_oldest_gives_way(void **state) {
  (void)state;
  Leaving leaving;
  TaborDrum *drums[LEAVING_MOST + 1];
  leaving_begin(&leaving, 48000);
  for (int i = 0; i <= LEAVING_MOST; i++) {
    drums[i] = ringing_drum();
    assert_ptr_equal(leaving_add(&leaving, drums[i], straight, MICS),
                     i == LEAVING_MOST ? drums[0] : NULL);
  }
  assert_null(leaving_take(&leaving));
  leaving_cut(&leaving);
  for (int i = 1; i <= LEAVING_MOST; i++) assert_ptr_equal(leaving_take(&leaving), drums[i]);
  assert_null(leaving_take(&leaving));
  for (int i = 0; i <= LEAVING_MOST; i++) tabor_drum_destroy(drums[i]);
}

/* The energy of a drum that goes has gone as work of control, so that the account still closes. */
static void counters_outlive_their_drums(void **state) {
  (void)state;
  Tally tally = {0};
  TaborStatistics each, sum;
  TaborLedger ledger, first;
  TaborDrum *const drum = ringing_drum(), *const next = ringing_drum();
  tabor_drum_statistics(drum, &each);
  tabor_drum_ledger(drum, &first);
  assert_true(first.stored > 0);
  tally_keep(&tally, drum);
  tally_statistics(&tally, next, &sum);
  assert_int_equal(sum.strikes, 2);
  assert_int_equal(sum.frames, 2 * each.frames);
  assert_int_equal(sum.newton_iterations, 2 * each.newton_iterations);
  assert_int_equal(sum.newton_max, each.newton_max);
  assert_int_equal(sum.in_play, each.in_play); /* of the one that is played */
  tally_ledger(&tally, next, &ledger);
  assert_true(ledger.injected == 2 * first.injected);
  assert_true(ledger.stored == first.stored);
  assert_true(ledger.control == first.control - first.stored + first.control);
  const double out = ledger.stored + ledger.head_loss + ledger.wire_loss + ledger.contact_loss +
                     ledger.damper_loss + ledger.shell_loss + ledger.radiated + ledger.removed +
                     ledger.residual;
  assert_true(fabs(ledger.injected + ledger.control - out) < 1e-12 * ledger.injected);
  tally_keep(&tally, next);
  tabor_drum_reset(next);
  tally_statistics(&tally, next, &sum);
  assert_int_equal(sum.strikes, 2);
  tabor_drum_destroy(drum);
  tabor_drum_destroy(next);
}

int main(void) {
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(each_channel_keeps_its_microphone), cmocka_unit_test(sounds_add_up),
    cmocka_unit_test(a_silent_drum_has_left_at_once),    cmocka_unit_test(the_oldest_gives_way),
    cmocka_unit_test(counters_outlive_their_drums),
  };
  return cmocka_run_group_tests(tests, create_model, release_model);
}
