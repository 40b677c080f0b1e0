/* SPDX-License-Identifier: MIT */
/*
 * A minute of random playing, while the drum is changed by another thread: what the audio thread
 * runs allocates nothing, locks nothing, sleeps nowhere and touches no file, inside
 * player_process().
 *
 * test_player_realtime [SECONDS of sound]
 */
#include "player_script.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include <cmocka.h>

#include "counted_calls.h"

static long calls_of_block(Stage *stage, uint32_t frames) {
  static float samples[2 * 4096];
  count_calls_begin();
  const bool more =
    player_process(stage->player, samples, frames, (double)stage->position / 48000, false);
  const long calls = count_calls_end();
  assert_true(more);
  stage->position += frames;
  for (uint32_t i = 0; i < 2 * frames; i++) assert_true(isfinite(samples[i]));
  while (recording_peek(player_recording(stage->player)))
    recording_pop(player_recording(stage->player));
  return calls;
}

static void send(Stage *stage, PlayerMessage message) {
  (void)player_send(stage->player, SOURCE_KEYS, &message);
}

static void send_random(Stage *stage, uint64_t *random) {
  static const char *const live[] = {"wires.strainer", "batter.muffle_strength", "mic.top.gain"};
  const double dice = random_next(random);
  if (dice < 0.8) {
    PlayerMessage strike =
      message_strike(PLAYER_NOW, 12 * random_next(random), 0.2 * random_next(random));
    strike.event.striker = (uint32_t)(4 * random_next(random));
    strike.frame = stage->position + (uint64_t)(300 * random_next(random)) + 1;
    send(stage, strike);
  } else if (dice < 0.92) {
    const uint32_t which = (uint32_t)(3 * random_next(random));
    send(stage, message_parameter(PLAYER_NOW, live[which], random_next(random)));
  } else if (dice < 0.98) {
    send(stage, (PlayerMessage){.type = PLAYER_GAIN, .value = 4 * random_next(random)});
  } else {
    send(stage, message_silence(PLAYER_NOW));
  }
}

/* Presets that continue nothing of one another, and keys that carry the state over. */
static void change_random(Stage *stage, uint64_t *random) {
  static const char *const presets[] = {"tabor", "frame-drum", "snare-14x5.5-off", "tom-12"};
  if (random_next(random) < 0.5) {
    const uint32_t which = (uint32_t)(4 * random_next(random));
    assert_int_equal(model_builder_preset(stage->builder, PLAYER_NOW, presets[which]), OUTCOME_OK);
  } else {
    char value[32];
    (void)snprintf(value, sizeof value, "%.3f", 2500 + 500 * random_next(random));
    assert_int_equal(model_builder_set(stage->builder, PLAYER_NOW, "set", "batter.tension", value),
                     OUTCOME_OK);
  }
}

static double seconds = 60;

static void playing_calls_nothing_that_waits(void **state) {
  (void)state;
  enum { LEAST_CHANGES = 5, MOST = 100 };
  const struct timespec moment = {.tv_nsec = 1000000};
  const uint64_t least = (uint64_t)(seconds * 48000);
  uint64_t random = 11;
  uint32_t builder = 0;
  PlayStatus status = {0};
  Stage *const stage = stage_open("tabor", TABOR_QUALITY_DRAFT, false, 0);
  const TaborModel *model = stage_model(stage);
  while (stage->position < least || (builder < LEAST_CHANGES && stage->position < MOST * least)) {
    const uint32_t frames = 16 + (uint32_t)(1000 * random_next(&random));
    for (int i = 0; i < 3; i++) send_random(stage, &random);
    const long counted = calls_of_block(stage, frames);
    if (counted > 0)
      fail_msg("%ld calls at frame %llu", counted, (unsigned long long)stage->position);
    const TaborModel *const now = stage_model(stage);
    builder += now != model;
    model = now;
    model_builder_status(stage->builder, &status);
    if (!status.building && random_next(&random) < 0.02) change_random(stage, &random);
    if (status.building)
      (void)nanosleep(&moment, NULL); /* sound must not be over before it is built */
  }
  player_status(stage->player, &status);
  printf("%.0f s, %llu strokes, %u changes of the model\n", status.time,
         (unsigned long long)status.strokes, (unsigned)builder);
  assert_true(builder >= LEAST_CHANGES);
  assert_true(status.strokes > least / 48000);
  assert_int_equal(status.recovered, 0);
  stage_close(stage);
}

int main(int argc, char **argv) {
  if (argc > 1) seconds = atof(argv[1]);
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(the_counters_count),
    cmocka_unit_test(playing_calls_nothing_that_waits),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
