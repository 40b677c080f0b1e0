/* SPDX-License-Identifier: MIT */
/*
 * Random playing is logged while another thread changes the drum, and then replayed: both sounds
 * are the same, to the bit. The device's blocks are random, too, and sometimes more messages come
 * at once than a block takes.
 *
 * test_replay [SECONDS of sound]
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
#include <unistd.h>

#include <cmocka.h>

#include "base/command.h"
#include "render/offline_player.h"
#include "render/render_options.h"

enum { LARGEST_BLOCK = 2048, CROWD = 400, CROWD_EVERY = 60 };

static const double ENOUGH = 10; /* [s] in which everything is played that can be */

static const char *const presets[] = {"tabor", "snare-14x5.5", "tom-12", "frame-drum"};
enum { PRESETS = sizeof presets / sizeof presets[0] };

static double seconds = 10;
static char name[] = "/tmp/tabor-test-replay-XXXXXX";

/* ---- playing at random ---------------------------------------------------------------------- */

static uint32_t below(uint64_t *random, uint32_t count) {
  return (uint32_t)(count * random_next(random));
}

static TaborEvent random_stroke(uint64_t *random) {
  return (TaborEvent){.type = TABOR_EVENT_STRIKE,
                      .id = below(random, 4),
                      .striker = below(random, 5),
                      .technique = below(random, TABOR_TECHNIQUE_SWEEP + 1),
                      .velocity = 0.1 * exp(4 * random_next(random)),
                      .radius = 0.2 * random_next(random),
                      .angle = 360 * random_next(random) - 90,
                      .value = random_next(random)};
}

static TaborEvent random_event(uint64_t *random) {
  static const uint32_t types[] = {TABOR_EVENT_PRESS, TABOR_EVENT_DAMP, TABOR_EVENT_RELEASE,
                                   TABOR_EVENT_MOVE};
  if (random_next(random) < 0.8) return random_stroke(random);
  TaborEvent event = random_stroke(random);
  event.type = types[below(random, 4)];
  return event;
}

static TaborEvent random_parameter(uint64_t *random) {
  static const char *const keys[] = {"wires.strainer", "batter.muffle_strength", "mic.top.gain",
                                     "hand.grip", "wires.tension"};
  const uint32_t key = below(random, 5);
  const double value = (key == 4 ? 20 : 1.2) * random_next(random);
  return message_parameter(0, keys[key], value).event;
}

static PlayerMessage random_message(uint64_t *random) {
  const double dice = random_next(random);
  PlayerMessage message = {.type = PLAYER_EVENT};
  if (dice < 0.75) {
    message.event = random_event(random);
  } else if (dice < 0.9) {
    message.event = random_parameter(random);
  } else if (dice < 0.97) {
    message.type = dice < 0.94 ? PLAYER_GAIN : PLAYER_EXPRESSION;
    message.value = random_next(random);
  } else {
    message.event.type = TABOR_EVENT_SILENCE;
  }
  return message;
}

/* Late ones, ones of now, and ones of later; a source's in order of their frames. */
static void send_random(Stage *stage, uint32_t frames, uint64_t *random) {
  PlayerMessage message = random_message(random);
  const bool comes_late = random_next(random) < 0.2 && stage->position > 100;
  message.frame = comes_late ? stage->position - 100 : PLAYER_NOW;
  (void)player_send(stage->player, SOURCE_KEYS, &message);
  message = random_message(random);
  message.frame = stage->position + below(random, frames);
  (void)player_send(stage->player, SOURCE_MIDI, &message);
}

/* More at once than a block takes, and than the drum carries out. */
static void send_crowd(Stage *stage, uint64_t *random) {
  for (int i = 0; i < CROWD; i++) {
    PlayerMessage message = {.frame = stage->position + 7 + (uint64_t)(i / 150),
                             .type = PLAYER_EVENT};
    message.event = i % 10 == 0 ? random_event(random) : random_parameter(random);
    (void)player_send(stage->player, SOURCE_SCORE, &message);
  }
}

/* Other presets, tensions that let it ring on, another size, and damping beyond what the model is
 * made for. */
static void change_random(Stage *stage, uint64_t *random) {
  static const char *const keys[] = {"batter.tension", "shell.radius", "wires.tension",
                                     "batter.damping_0"};
  static const double least[] = {2500, 0.12, 5, 10};
  if (random_next(random) < 0.4) {
    (void)model_builder_preset(stage->builder, PLAYER_NOW, presets[below(random, PRESETS)]);
    return;
  }
  char value[32], said[256];
  const uint32_t key = below(random, 4);
  (void)snprintf(value, sizeof value, "%.17g", least[key] * (1 + random_next(random)));
  const MessageCapture before = message_capture(said, sizeof said); /* it may not suit the drum */
  (void)model_builder_set(stage->builder, PLAYER_NOW, "set", keys[key], value);
  message_release(before);
}

static void play_at_random(Stage *stage, uint64_t until) {
  const struct timespec moment = {.tv_nsec = 1000000};
  uint64_t random = 12;
  uint32_t blocks = 0;
  PlayStatus status;
  while (stage->position < until) {
    const uint32_t frames = 1 + below(&random, LARGEST_BLOCK);
    if (random_next(&random) < 0.3) send_random(stage, frames, &random);
    if (++blocks % CROWD_EVERY == 0) send_crowd(stage, &random);
    model_builder_status(stage->builder, &status);
    if (!status.building && random_next(&random) < 0.03) change_random(stage, &random);
    if (status.building) (void)nanosleep(&moment, NULL); /* it is built while the drum plays */
    stage_block(stage, frames);
  }
}

static LogWriter *open_log(const Stage *stage, OutputFile *output) {
  LogWriter *log;
  const LogWriterSetup setup = {.player = stage->player,
                                .start = {.rate = 48000, .gain = 1, .channels = 1},
                                .model = stage_model(stage),
                                .preset = presets[0]};
  assert_int_equal(output_plan(output, name, false), OUTCOME_OK);
  assert_int_equal(log_writer_start(&setup, output, &log), OUTCOME_OK);
  return log;
}

static Stage *perform(PlayStatus *status) {
  OutputFile output = OUTPUT_FILE_NONE;
  const uint64_t until = (uint64_t)(seconds * 48000);
  Stage *const stage =
    stage_open(presets[0], TABOR_QUALITY_LIVE, false, (uint32_t)until + LARGEST_BLOCK);
  LogWriter *const log = open_log(stage, &output);
  model_builder_log(stage->builder, log);
  play_at_random(stage, until);
  stage_end(stage);
  model_builder_stop(stage->builder);
  assert_int_equal(log_writer_finish(log), OUTCOME_OK);
  output_discard(&output);
  player_status(stage->player, status);
  return stage;
}

/* ---- the replay ----------------------------------------------------------------------------- */

static void read_request(Arguments *arguments, RenderRequest *request) {
  char output[] = "--output=/dev/null", replay[64];
  (void)snprintf(replay, sizeof replay, "--replay=%s", name);
  char *const argv[] = {(char[]){"render"}, output, replay, NULL};
  assert_int_equal(arguments_read(&render_command, 3, argv, arguments), OUTCOME_OK);
  assert_int_equal(render_request_read(arguments, request), OUTCOME_OK);
}

/* As play does. */
static double clip(double sample) { return fmin(fmax(sample, -1), 1); }

static void compare_block(const Stage *stage, const OfflinePlayer *player, uint64_t at,
                          uint32_t frames) {
  for (uint32_t i = 0; i < frames; i++) {
    const double expected = stage->samples[at + i], sample = clip(player->interleaved[i]);
    if (memcmp(&expected, &sample, sizeof expected) == 0) continue;
    fail_msg("frame %llu is %.17g, not %.17g", (unsigned long long)at + i, sample, expected);
  }
}

static void compare(const Stage *stage, OfflinePlayer *player) {
  for (uint64_t at = 0; at < stage->recorded;) {
    const uint64_t left = stage->recorded - at;
    const uint32_t frames = left < OFFLINE_BLOCK ? (uint32_t)left : OFFLINE_BLOCK;
    assert_int_equal(offline_player_play(player, frames), OUTCOME_OK);
    compare_block(stage, player, at, frames);
    at += frames;
  }
}

/* A long performance has something of everything; what a short one has depends on when its models
 * are built. */
static void check_variety(const Replay *replay, const PlayStatus *status) {
  unsigned events[TABOR_EVENT_REPLACE + 1] = {0}, gains = 0;
  for (size_t i = 0; i < replay->count; i++) {
    events[replay->messages[i].event.type]++;
    gains += replay->messages[i].type == PLAYER_GAIN;
  }
  printf("%.0f s, %zu messages, %llu strokes, %u swaps, %u replacements, %u silences, %u late\n",
         status->time, replay->count, (unsigned long long)status->strokes, events[TABOR_EVENT_SWAP],
         events[TABOR_EVENT_REPLACE], events[TABOR_EVENT_SILENCE], (unsigned)status->late);
  assert_int_equal(replay->lost, 0);
  assert_true(events[TABOR_EVENT_STRIKE] > 0 && status->strokes > 0);
  if (seconds < ENOUGH) return;
  assert_true(events[TABOR_EVENT_STRIKE] > 2 * seconds && status->strokes > 2 * seconds);
  assert_true(events[TABOR_EVENT_PARAMETER] > seconds);
  assert_true(events[TABOR_EVENT_PRESS] > 0 && events[TABOR_EVENT_MOVE] > 0);
  assert_true(events[TABOR_EVENT_DAMP] > 0 && events[TABOR_EVENT_RELEASE] > 0);
  assert_true(events[TABOR_EVENT_SWAP] > 0 && events[TABOR_EVENT_REPLACE] > 0);
  assert_true(gains > 0 && status->late > 0);
}

static void a_performance_is_replayed_to_the_bit(void **state) {
  (void)state;
  static RenderRequest request;
  static OfflinePlayer player;
  Arguments arguments;
  PlayStatus status;
  Stage *const stage = perform(&status);
  read_request(&arguments, &request);
  assert_int_equal(request.frames, stage->recorded);
  check_variety(&request.replay, &status);
  assert_int_equal(offline_player_open(&player, &request), OUTCOME_OK);
  compare(stage, &player);
  TaborStatistics statistics;
  tabor_drum_statistics(player.drum, &statistics);
  assert_int_equal(statistics.strikes, status.strokes);
  offline_player_free(&player);
  render_request_free(&request);
  arguments_free(&arguments);
  stage_close(stage);
}

int main(int argc, char **argv) {
  if (argc > 1) seconds = atof(argv[1]);
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(a_performance_is_replayed_to_the_bit),
  };
  const int descriptor = mkstemp(name);
  if (descriptor < 0) return 1;
  (void)close(descriptor);
  const int failed = cmocka_run_group_tests(tests, NULL, NULL);
  (void)unlink(name);
  return failed;
}
