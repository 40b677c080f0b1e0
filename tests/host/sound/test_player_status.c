/* SPDX-License-Identifier: MIT */
/* What a player tells of itself, what it writes for devices of several widths, and how it ends. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

#include "platform/clock.h"
#include "sound/player.h"

#include <cmocka.h>

#define RATE 48000.0

enum { MOST_WIDTH = 4, MOST_BLOCK = 2048 };

static TaborDrumDef def;
static TaborModel *model;

typedef struct Stage {
  Player *player;
  TaborDrum *drum;
  uint32_t width;
  uint64_t position;
  float samples[MOST_BLOCK * MOST_WIDTH];
} Stage;

/* With the setup's drum, definition and rate filled in. */
static Stage *open_stage(PlayerSetup setup) {
  Stage *const stage = calloc(1, sizeof *stage);
  assert_non_null(stage);
  assert_int_equal(tabor_drum_create(model, &stage->drum, NULL), TABOR_OK);
  setup.drum = stage->drum;
  setup.def = &def;
  setup.rate = RATE;
  if (setup.gain == 0) setup.gain = 1;
  if (setup.channels == 0) setup.channels = 1;
  assert_int_equal(player_create(&setup, &stage->player), OUTCOME_OK);
  stage->width = setup.width;
  return stage;
}

static void close_stage(Stage *stage) {
  player_destroy(stage->player);
  tabor_drum_destroy(stage->drum);
  free(stage);
}

/* Samples that are not written would be seen. */
static bool play(Stage *stage, uint32_t frames) {
  for (uint32_t i = 0; i < MOST_BLOCK * MOST_WIDTH; i++) stage->samples[i] = 77;
  const bool more =
    player_process(stage->player, stage->samples, frames, (double)stage->position / RATE, false);
  stage->position += frames;
  for (uint32_t i = frames * stage->width; i < MOST_BLOCK * MOST_WIDTH; i++) {
    assert_true(stage->samples[i] == 77);
  }
  return more;
}

static PlayStatus status_of(Stage *stage) {
  PlayStatus status = {0};
  player_status(stage->player, &status);
  return status;
}

static void send(Stage *stage, uint64_t frame, uint32_t type, TaborEvent event, double value) {
  const PlayerMessage message = {.frame = frame, .type = type, .event = event, .value = value};
  assert_true(player_send(stage->player, SOURCE_KEYS, &message));
}

static void strike(Stage *stage, uint64_t frame, double velocity) {
  const TaborEvent event = {
    .type = TABOR_EVENT_STRIKE, .velocity = velocity, .radius = 0.03, .angle = 20, .value = 0.6};
  send(stage, frame, PLAYER_EVENT, event, 0);
}

/* ---- meters --------------------------------------------------------------------------------- */

/* The drum's own counters, of this moment. */
static void meters_are_the_drums(void **state) {
  (void)state;
  Stage *const stage = open_stage((PlayerSetup){.width = 1});
  play(stage, 256);
  assert_true(status_of(stage).sleeping && status_of(stage).strikers == 0);
  strike(stage, 300, 4);
  send(stage, 300, PLAYER_EVENT,
       (TaborEvent){.type = TABOR_EVENT_DAMP, .id = 5, .radius = 0.05, .value = 2}, 0);
  send(stage, 301, PLAYER_EVENT, (TaborEvent){.type = 99}, 0); /* nothing can carry it out */
  send(stage, 301, PLAYER_GAIN, (TaborEvent){.type = TABOR_EVENT_STRIKE}, 0.25);
  send(stage, 301, PLAYER_EXPRESSION, (TaborEvent){.type = TABOR_EVENT_STRIKE}, 0.5);
  play(stage, 128); /* the stick is still there */
  PlayStatus status = status_of(stage);
  TaborStatistics drum;
  tabor_drum_statistics(stage->drum, &drum);
  assert_false(status.sleeping);
  assert_int_equal(status.strokes, 1);
  assert_int_equal(status.strikers, 2);
  assert_int_equal(status.dropped, 1);
  assert_int_equal(status.late, 0);
  assert_true(drum.solves > 0 && drum.newton_max > 0);
  assert_true(status.newton_mean == (double)drum.newton_iterations / (double)drum.solves);
  assert_int_equal(status.newton_max, drum.newton_max);
  assert_int_equal(status.newton_capped, drum.newton_capped);
  assert_int_equal(status.recovered, drum.recovered);
  assert_true(status.gain == 0.25); /* without the expression */
  assert_true(status.time == 384 / RATE && status.rate == RATE && status.channels == 1);
  close_stage(stage);
}

/* The last event that acted or was passed on, with the frame at which it did: its own, or the next
 * one. */
static void the_last_event_is_told(void **state) {
  (void)state;
  Stage *const stage = open_stage((PlayerSetup){.width = 1});
  assert_int_equal(status_of(stage).last_event.type, 0);
  strike(stage, 100, 3.5);
  play(stage, 256);
  PlayStatus status = status_of(stage);
  assert_int_equal(status.last_event.type, TABOR_EVENT_STRIKE);
  assert_true(status.last_event.velocity == 3.5 && status.last_event.radius == 0.03);
  assert_true(status.last_event.angle == 20 && status.last_event.value == 0.6);
  assert_true(status.last_time == 100 / RATE);
  strike(stage, 20, 1); /* late: it acts at once */
  send(stage, 400, PLAYER_GAIN, (TaborEvent){.type = TABOR_EVENT_DAMP}, 1);
  play(stage, 256);
  status = status_of(stage);
  assert_int_equal(status.last_event.type, TABOR_EVENT_STRIKE); /* a gain is no event */
  assert_true(status.last_event.velocity == 1 && status.last_time == 256 / RATE);
  close_stage(stage);
}

/* What is sent without a frame is never late, nor is a model, which takes time to build. */
static void late_ones_are_counted(void **state) {
  (void)state;
  TaborSwap *swap;
  Stage *const stage = open_stage((PlayerSetup){.width = 1});
  assert_int_equal(tabor_swap_create(model, model, &swap, NULL), TABOR_OK);
  strike(stage, 0, 1);
  play(stage, 512);
  assert_int_equal(status_of(stage).late, 0);
  strike(stage, 512, 1); /* just in time */
  strike(stage, PLAYER_NOW, 1);
  play(stage, 256);
  assert_int_equal(status_of(stage).late, 0);
  send(stage, 700, PLAYER_MODEL, (TaborEvent){.type = TABOR_EVENT_SWAP, .swap = swap}, 0);
  play(stage, 256);
  assert_int_equal(status_of(stage).late, 0);
  assert_int_equal(status_of(stage).last_event.type, TABOR_EVENT_SWAP);
  strike(stage, 1000, 1);
  send(stage, 1001, PLAYER_GAIN, (TaborEvent){0}, 1);
  play(stage, 256);
  assert_int_equal(status_of(stage).late, 2);
  close_stage(stage);
  tabor_swap_destroy(swap);
}

/* Parts of the time that a block has: each block counts once, the worst since the last look, and of
 * all. */
static void loads_are_measured(void **state) {
  (void)state;
  Stage *const stage = open_stage((PlayerSetup){.width = 1});
  double median, worst, later;
  player_load(stage->player, &median, &worst);
  assert_true(median == 0 && worst == 0);
  for (int i = 0; i < 20; i++) play(stage, 256);
  player_load(stage->player, &median, &worst);
  assert_true(median > 0 && worst > 0 && isfinite(worst));
  PlayStatus status = status_of(stage);
  assert_true(status.load_worst == worst && status.load_median == median);
  status = status_of(stage);
  assert_true(status.load_worst == 0 && status.load_median == 0); /* nothing since */
  play(stage, 1); /* the fixed costs of a block weigh most in a short one */
  player_load(stage->player, &median, &later);
  assert_true(later >= worst);
  status = status_of(stage);
  assert_true(status.load_worst > 0 && status.load_worst <= later);
  const double bin = status.load_median - 0.005;
  assert_true(bin <= status.load_worst && (status.load_worst < bin + 0.01 || bin > 2.54));
  close_stage(stage);
}

/* The time that the block took, over the time that it plays. Somebody else may have had the
 * processor between the two clocks: then it is tried again. */
static void a_load_is_a_part_of_real_time(void **state) {
  (void)state;
  Stage *const stage = open_stage((PlayerSetup){.width = 1});
  bool agrees = false;
  for (int trial = 0; trial < 100 && !agrees; trial++) {
    strike(stage, PLAYER_NOW, 3);
    (void)status_of(stage);
    const double start = stopwatch_seconds(CLOCK_MONOTONIC);
    player_process(stage->player, stage->samples, MOST_BLOCK, 0, false);
    const double passed = stopwatch_seconds(CLOCK_MONOTONIC) - start;
    const double took = status_of(stage).load_worst * MOST_BLOCK / RATE;
    assert_true(took > 0 && took <= passed);
    agrees = took > 0.7 * passed;
  }
  assert_true(agrees);
  close_stage(stage);
}

/* ---- devices -------------------------------------------------------------------------------- */

/* One channel feeds all of the device's; of several each has its own, and what is left is silent.
 */
static void channels_go_to_the_device(void **state) {
  (void)state;
  Stage *const mono = open_stage((PlayerSetup){.width = 3, .channels = 1, .mics = {1}}),
               *const pair = open_stage((PlayerSetup){.width = 3, .channels = 2, .mics = {1, 0}}),
               *const none = open_stage((PlayerSetup){.width = 0, .channels = 1, .mics = {1}});
  Stage *const stages[] = {mono, pair, none};
  for (int i = 0; i < 3; i++) {
    strike(stages[i], 5, 3);
    play(stages[i], 1000);
  }
  double first = 0, second = 0;
  for (uint32_t i = 0; i < 1000; i++) {
    const float *const one = mono->samples + 3 * i, *const two = pair->samples + 3 * i;
    assert_true(one[0] == one[1] && one[1] == one[2] && one[0] == two[0] && two[2] == 0);
    first = fmax(first, fabs((double)two[0]));
    second = fmax(second, fabs((double)two[1]));
  }
  assert_true(first > 1e-3 && second > 1e-3 && first != second);
  const PlayStatus status = status_of(pair);
  assert_int_equal(status.channels, 2);
  assert_true((float)status.peak[0] == (float)first && (float)status.peak[1] == (float)second);
  assert_true(status.loudest == fmax(status.peak[0], status.peak[1]) && status.clipped == 0);
  assert_true(status_of(none).peak[0] == status.peak[0]);
  for (int i = 0; i < 3; i++) close_stage(stages[i]);
}

/* Both ways, and each sample counts. */
static void clipping_is_symmetric(void **state) {
  (void)state;
  Stage *const stage = open_stage((PlayerSetup){.width = 1, .gain = 300}), *const plain =
                                                                             open_stage(
                                                                               (PlayerSetup){
                                                                                 .width = 1});
  uint64_t beyond = 0;
  strike(stage, 0, 6);
  strike(plain, 0, 6);
  play(stage, 2000);
  play(plain, 2000);
  float least = 0, most = 0;
  for (uint32_t i = 0; i < 2000; i++) {
    const double whole = 300 * (double)plain->samples[i], got = (double)stage->samples[i];
    least = fminf(least, stage->samples[i]);
    most = fmaxf(most, stage->samples[i]);
    beyond += fabs(whole) > 1;
    assert_true(fabs(got - fmax(-1, fmin(whole, 1))) < 1e-6);
  }
  assert_true(least == -1.0f && most == 1.0f);
  assert_true(fabs((double)status_of(stage).clipped - (double)beyond) <= 1);
  const double loudest = status_of(stage).loudest;
  play(stage, 200);
  assert_true(loudest > 1 && status_of(stage).loudest == loudest); /* of the whole time */
  close_stage(stage);
  close_stage(plain);
}

static void gaps_are_counted(void **state) {
  (void)state;
  float samples[64];
  Stage *const stage = open_stage((PlayerSetup){.width = 1});
  for (int i = 0; i < 5; i++) player_process(stage->player, samples, 64, 0, i % 2 == 1);
  assert_int_equal(status_of(stage).xruns, 2);
  close_stage(stage);
}

/* ---- the recording and the log -------------------------------------------------------------- */

/* Blocks follow each other without a gap, whatever the device's are; the last is short. */
static void a_recording_has_every_frame(void **state) {
  (void)state;
  enum { FRAMES = 1000 };
  Stage *const stage =
    open_stage((PlayerSetup){.width = 2, .channels = 2, .mics = {0, 1}, .records = true});
  static float heard[2 * FRAMES];
  strike(stage, 3, 3);
  for (uint32_t at = 0, frames; at < FRAMES; at += frames) {
    frames = FRAMES - at < 77 ? FRAMES - at : 77;
    play(stage, frames);
    memcpy(heard + (size_t)2 * at, stage->samples, 2 * frames * sizeof(float));
  }
  assert_true(player_halt(stage->player, 1));
  assert_true(status_of(stage).recording && status_of(stage).lost_frames == 0);
  uint64_t at = 0;
  const RecordingBlock *record;
  while ((record = recording_peek(player_recording(stage->player))) != NULL) {
    assert_int_equal(record->frame, at);
    assert_int_equal(record->frames, FRAMES - at < 256 ? FRAMES - at : 256);
    for (uint32_t i = 0; i < 2 * record->frames; i++) {
      assert_true((float)record->samples[i] == heard[2 * at + i]);
    }
    at += record->frames;
    recording_pop(player_recording(stage->player));
  }
  assert_int_equal(at, FRAMES);
  assert_true(player_halt(stage->player, 1)); /* nothing is handed over twice */
  assert_null(recording_peek(player_recording(stage->player)));
  close_stage(stage);
}

/* What a slow disk leaves no room for is counted, frame by frame. */
static void lost_frames_are_counted(void **state) {
  (void)state;
  enum { SECONDS = 12 };
  Stage *const stage = open_stage((PlayerSetup){.width = 1, .records = true});
  for (int i = 0; i < SECONDS * 48000 / 1024; i++) play(stage, 1024);
  assert_true(player_halt(stage->player, 1));
  uint64_t kept = 0;
  const RecordingBlock *record;
  while ((record = recording_peek(player_recording(stage->player))) != NULL) {
    kept += record->frames;
    recording_pop(player_recording(stage->player));
  }
  assert_true(kept >= 9 * 48000 && kept < stage->position);
  assert_int_equal(kept + status_of(stage).lost_frames, stage->position);
  close_stage(stage);
}

/* Every message that acted, with its frame, in the order in which they did. */
static void the_log_tells_what_acted(void **state) {
  (void)state;
  for (int logs = 0; logs < 2; logs++) {
    Stage *const stage = open_stage((PlayerSetup){.width = 1, .logs = logs});
    play(stage, 100);
    strike(stage, 40, 2); /* late */
    strike(stage, 150, 3);
    send(stage, 170, PLAYER_GAIN, (TaborEvent){0}, 0.5);
    const PlayerMessage score = {
      .frame = 160,
      .type = PLAYER_EVENT,
      .event = {.type = TABOR_EVENT_STRIKE, .velocity = 4, .radius = 0.02}};
    assert_true(player_send(stage->player, SOURCE_SCORE, &score));
    play(stage, 200);
    static const uint64_t frames[] = {100, 150, 160, 170};
    for (int i = 0; logs && i < 4; i++) {
      const PlayerMessage *const message = player_log(stage->player);
      assert_non_null(message);
      assert_int_equal(message->frame, frames[i]);
      assert_int_equal(message->type, i == 3 ? PLAYER_GAIN : PLAYER_EVENT);
      if (i == 2) assert_true(message->event.velocity == 4);
      player_log_next(stage->player);
    }
    assert_null(player_log(stage->player));
    close_stage(stage);
  }
}

/* At one frame the order of the sources is that of execution. */
static void sources_take_turns(void **state) {
  (void)state;
  Stage *const stage = open_stage((PlayerSetup){.width = 1, .logs = true});
  for (int source = SOURCE_COUNT - 1; source >= 0; source--) {
    for (uint64_t frame = 50; frame < 70; frame += 10) {
      const PlayerMessage message = {.frame = frame, .type = PLAYER_GAIN, .value = source};
      assert_true(player_send(stage->player, (PlayerSource)source, &message));
    }
  }
  play(stage, 200);
  for (int i = 0; i < 2 * SOURCE_COUNT; i++) {
    const PlayerMessage *const message = player_log(stage->player);
    assert_non_null(message);
    assert_true(message->value == i % SOURCE_COUNT);
    assert_int_equal(message->frame, i < SOURCE_COUNT ? 50 : 60);
    player_log_next(stage->player);
  }
  close_stage(stage);
}

/* ---- the end -------------------------------------------------------------------------------- */

static void assert_silence_from(const Stage *stage, uint32_t from, uint32_t until) {
  for (uint32_t i = from * stage->width; i < until * stage->width; i++) {
    assert_true(stage->samples[i] == 0);
  }
}

/* After the last frame there is silence, and nothing is played any more. */
static void a_number_of_frames_ends(void **state) {
  (void)state;
  static const uint32_t lengths[] = {300, 512, 1000};
  for (int k = 0; k < 3; k++) {
    Stage *const stage =
      open_stage((PlayerSetup){.width = 2, .frames = lengths[k], .records = true});
    uint32_t at = 0;
    strike(stage, lengths[k] - 150, 5);
    assert_int_equal(player_most_frames(stage->player), lengths[k]);
    for (; at + 200 < lengths[k]; at += 200) assert_true(play(stage, 200));
    assert_false(player_is_over(stage->player));
    assert_false(play(stage, 200));
    assert_true(player_is_over(stage->player));
    assert_true(stage->samples[2 * (lengths[k] - at - 1)] != 0);
    assert_silence_from(stage, lengths[k] - at, 200);
    assert_int_equal(player_position(stage->player), lengths[k]);
    assert_false(play(stage, 200));
    assert_silence_from(stage, 0, 200);
    assert_int_equal(player_position(stage->player), lengths[k]);
    close_stage(stage);
  }
}

/* It dies away at the same frame for blocks of any size, not before half a second after the last
 * stroke. */
static void an_end_does_not_depend_on_blocks(void **state) {
  (void)state;
  static const uint32_t blocks[] = {64, 250, 256, 1000};
  uint64_t end = 0;
  for (int k = 0; k < 4; k++) {
    Stage *const stage =
      open_stage((PlayerSetup){.width = 1, .dies_away = true, .last_event = 1000});
    strike(stage, 1000, 2);
    while (play(stage, blocks[k])) assert_true(stage->position < 30 * 48000);
    const uint64_t over = player_position(stage->player);
    assert_true(over >= 1000 + 24000 && over % 256 == 0);
    assert_true(k == 0 || over == end);
    end = over;
    close_stage(stage);
  }
}

static void a_halted_player_is_silent(void **state) {
  (void)state;
  Stage *const stage = open_stage((PlayerSetup){.width = 2});
  strike(stage, 0, 5);
  assert_true(play(stage, 300));
  assert_true(player_halt(stage->player, 1));
  assert_false(play(stage, 300));
  assert_silence_from(stage, 0, 300);
  assert_int_equal(player_position(stage->player), 300);
  close_stage(stage);
}

static int set_up(void **state) {
  (void)state;
  TaborModelOptions options;
  assert_int_equal(tabor_drum_def_preset(&def, "tabor", NULL), TABOR_OK);
  def.quality.two_way_bandwidth = 600;
  def.quality.bandwidth = 1200;
  def.quality.wire_points = 8;
  tabor_model_options_default(&options);
  options.sample_rate = RATE;
  options.quality = TABOR_QUALITY_DRAFT;
  assert_int_equal(tabor_model_create(&def, &options, &model, NULL), TABOR_OK);
  return 0;
}

static int tear_down(void **state) {
  (void)state;
  tabor_model_release(model);
  return 0;
}

int main(void) {
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(meters_are_the_drums),
    cmocka_unit_test(the_last_event_is_told),
    cmocka_unit_test(late_ones_are_counted),
    cmocka_unit_test(loads_are_measured),
    cmocka_unit_test(a_load_is_a_part_of_real_time),
    cmocka_unit_test(channels_go_to_the_device),
    cmocka_unit_test(clipping_is_symmetric),
    cmocka_unit_test(gaps_are_counted),
    cmocka_unit_test(a_recording_has_every_frame),
    cmocka_unit_test(lost_frames_are_counted),
    cmocka_unit_test(the_log_tells_what_acted),
    cmocka_unit_test(sources_take_turns),
    cmocka_unit_test(a_number_of_frames_ends),
    cmocka_unit_test(an_end_does_not_depend_on_blocks),
    cmocka_unit_test(a_halted_player_is_silent),
  };
  return cmocka_run_group_tests(tests, set_up, tear_down);
}
