/* SPDX-License-Identifier: MIT */
/* A drum being played: messages act at their frames whatever the device's blocks are. */
#include "platform/clock.h"
#include "player_script.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <string.h>
#include <time.h>

#include <cmocka.h>

enum { FRAMES = 24000, DRUM_TEXT = 65536 };

static const char PRESET[] = "tabor";

/* Something of everything, several of it at the same frame and at odd ones. */
static void write_script(Messages *messages) {
  *messages = (Messages){0};
  messages_add(messages, message_strike(3, 2, 0.03));
  messages_add(messages, message_strike(1001, 5, 0.08));
  messages_add(messages, (PlayerMessage){.frame = 1001, .type = PLAYER_GAIN, .value = 0.5});
  messages_add(messages, message_strike(1001, 1, 0.01));
  messages_add(messages, message_parameter(2500, "wires.strainer", 0.5));
  messages_add(messages, message_strike(4111, 3, 0.05));
  messages_add(messages, message_silence(7000));
  messages_add(messages, message_strike(7100, 3, 0.02)); /* within the silence's fade */
  messages_add(messages, (PlayerMessage){.frame = 9000, .type = PLAYER_GAIN, .value = 1});
  messages_add(messages, message_strike(9001, 4, 0.06));
  messages_add(messages, message_parameter(9500, "output.full_scale", 30));
  messages_add(messages, message_strike(16000, 6, 0.05));
}

/* Plays the script with two changes of the drum on the way, which the sound waits for. */
static Stage *perform(uint32_t size) {
  Messages messages;
  write_script(&messages);
  Stage *const stage = stage_open(PRESET, TABOR_QUALITY_DRAFT, true, FRAMES);
  assert_int_equal(model_builder_set(stage->builder, 5003, "set", "batter.tension", "3300"),
                   OUTCOME_OK);
  assert_int_equal(model_builder_preset(stage->builder, 12345, "frame-drum"), OUTCOME_OK);
  stage_play(stage, &messages, FRAMES, size);
  stage_end(stage);
  assert_int_equal(stage->recorded, FRAMES);
  return stage;
}

/* The sounds of both stages up to frame @p until. */
static void assert_same_sound(const Stage *stage, const Stage *expected, uint32_t until,
                              uint32_t size) {
  for (uint32_t frame = 0; frame < until; frame++) {
    if (memcmp(&stage->samples[frame], &expected->samples[frame], sizeof(double)) == 0) continue;
    fail_msg("blocks of %u: frame %u is %.17g, not %.17g", (unsigned)size, (unsigned)frame,
             stage->samples[frame], expected->samples[frame]);
  }
}

static void sound_does_not_depend_on_blocks(void **state) {
  (void)state;
  static const uint32_t sizes[] = {1, 16, 37, 64, 128, 256, 1000, 4096, 0};
  Stage *const expected = perform(300);
  assert_true(stage_peak(expected, 0, 1000) > 0.01);
  assert_true(stage_peak(expected, 20000, FRAMES) > 0.001);
  for (size_t i = 0; i < sizeof sizes / sizeof sizes[0]; i++) {
    Stage *const stage = perform(sizes[i]);
    assert_same_sound(stage, expected, FRAMES, sizes[i]);
    stage_close(stage);
  }
  stage_close(expected);
}

/* Three times as many events as a block takes, most of them at odd frames close together, and 300
   at one frame, of which the last 44 and the stroke act a frame later. */
static Stage *perform_crowd(uint32_t size) {
  enum { CROWD = 800, EACH = 37, AT_ONCE = 300, UNTIL = 4096 };
  static Messages messages;
  messages = (Messages){0};
  messages_add(&messages, message_strike(3, 2, 0.03));
  for (uint32_t i = 0; i < CROWD; i++) {
    messages_add(&messages, message_parameter(1001 + i / EACH, "mic.top.gain", 0.5 + 0.001 * i));
    if (i % 100 == 99) messages_add(&messages, message_strike(1001 + i / EACH, 3, 0.04));
  }
  for (uint32_t i = 0; i < AT_ONCE; i++) {
    messages_add(&messages, message_parameter(2002, "mic.top.gain", 0.001 * i));
  }
  messages_add(&messages, message_strike(2002, 3, 0.04));
  Stage *const stage = stage_open(PRESET, TABOR_QUALITY_DRAFT, true, UNTIL);
  stage_play(stage, &messages, UNTIL, size);
  stage_end(stage);
  return stage;
}

static void crowds_do_not_depend_on_blocks(void **state) {
  (void)state;
  static const uint32_t sizes[] = {16, 37, 64, 1000, 4096};
  Stage *const expected = perform_crowd(1);
  assert_true(stage_peak(expected, 2100, 4000) > 0.001);
  for (size_t i = 0; i < sizeof sizes / sizeof sizes[0]; i++) {
    Stage *const stage = perform_crowd(sizes[i]);
    assert_same_sound(stage, expected, 4096, sizes[i]);
    stage_close(stage);
  }
  stage_close(expected);
}

/* The same strokes given to the drum alone. */
static void sound_is_the_drums(void **state) {
  (void)state;
  Stage *const stage = stage_open(PRESET, TABOR_QUALITY_DRAFT, true, FRAMES);
  Messages messages = {0};
  messages_add(&messages, message_strike(77, 2, 0.03));
  messages_add(&messages, message_strike(5001, 4, 0.05));
  stage_play(stage, &messages, FRAMES, 128);
  stage_end(stage);

  TaborDrum *drum;
  static float samples[FRAMES];
  float *outputs[TABOR_MAX_MICS] = {samples};
  TaborEvent events[] = {messages.list[0].event, messages.list[1].event};
  events[0].frame = 77;
  events[1].frame = 5001;
  TaborModel *const model = (TaborModel *)stage_model(stage);
  assert_int_equal(tabor_drum_create(model, &drum, NULL), TABOR_OK);
  tabor_drum_process(drum, events, 2, outputs, FRAMES);
  for (uint32_t i = 0; i < FRAMES; i++) assert_true((double)samples[i] == stage->samples[i]);
  tabor_drum_destroy(drum);
  stage_close(stage);
}

static void the_first_block_tells_the_device(void **state) {
  (void)state;
  Stage *const stage = stage_open(PRESET, TABOR_QUALITY_DRAFT, true, FRAMES);
  assert_int_equal(player_frame_at(stage->player, 123.0), PLAYER_NOW);
  stage_block(stage, 480);
  assert_int_equal(player_buffer(stage->player), 480);
  assert_int_equal(player_frame_at(stage->player, 0.0), 480); /* always one block later */
  assert_int_equal(player_frame_at(stage->player, 0.005), 720);
  stage_block(stage, 480);
  assert_int_equal(player_frame_at(stage->player, 0.0125), 1080);
  stage_close(stage);
}

static void what_comes_too_late_acts_at_once(void **state) {
  (void)state;
  PlayStatus status;
  Stage *const stage = stage_open(PRESET, TABOR_QUALITY_DRAFT, true, FRAMES);
  stage_block(stage, 1024);
  const PlayerMessage late = message_strike(1000, 3, 0.03),
                      now = message_strike(PLAYER_NOW, 3, 0.05);
  assert_true(player_send(stage->player, SOURCE_KEYS, &late));
  assert_true(player_send(stage->player, SOURCE_MIDI, &now));
  stage_block(stage, 32);
  player_status(stage->player, &status);
  assert_int_equal(status.strokes, 2);
  assert_int_equal(status.late, 1);
  assert_int_equal(status.dropped, 0);
  assert_int_equal(status.last_event.type, TABOR_EVENT_STRIKE);
  assert_true(status.strikers >= 1);
  stage_close(stage);
}

static void a_full_ring_drops_and_counts(void **state) {
  (void)state;
  PlayStatus status;
  uint32_t sent = 0;
  const PlayerMessage message = message_strike(PLAYER_NOW, 1, 0.03);
  Stage *const stage = stage_open(PRESET, TABOR_QUALITY_DRAFT, true, FRAMES);
  while (player_send(stage->player, SOURCE_MIDI, &message)) sent++;
  for (int i = 0; i < 9; i++) assert_false(player_send(stage->player, SOURCE_MIDI, &message));
  assert_true(sent >= 1000);
  assert_int_equal(player_waiting(stage->player, SOURCE_MIDI), sent);
  assert_true(player_send(stage->player, SOURCE_KEYS, &message)); /* not theirs */
  stage_play(stage, &(Messages){0}, 2048, 256);
  player_status(stage->player, &status);
  assert_true(status.dropped >=
              10); /* the 10 that found no room, and strokes that found no striker */
  assert_int_equal(player_waiting(stage->player, SOURCE_MIDI), 0);
  stage_close(stage);
}

/* 100,000 strokes a second: each is played or counted, and a block's work stays bounded. */
static void a_flood_is_played_or_counted(void **state) {
  (void)state;
  enum { BLOCK = 128, BLOCKS = 375, EACH = 267 };
  PlayStatus status;
  uint64_t sent = 0;
  Stage *const stage = stage_open(PRESET, TABOR_QUALITY_DRAFT, true, BLOCK * BLOCKS);
  for (uint32_t block = 0; block < BLOCKS; block++) {
    for (uint32_t i = 0; i < EACH; i++) {
      const PlayerMessage message =
        message_strike(stage->position + i * BLOCK / EACH + 1, 1, 0.0003 * i);
      (void)player_send(stage->player, SOURCE_MIDI, &message);
      sent++;
    }
    stage_block(stage, BLOCK);
  }
  player_status(stage->player, &status);
  assert_int_equal(status.strokes + status.dropped + player_waiting(stage->player, SOURCE_MIDI),
                   sent);
  assert_int_equal(status.recovered, 0);
  for (uint64_t i = 0; i < stage->recorded; i++) assert_true(isfinite(stage->samples[i]));
  stage_close(stage);
}

/* Of two samples of single precision, 2^-24 each. */
static const double ROUNDING = 1.2e-7;

/* The gain glides over 5 ms: no step is larger than its share. */
static void gain_does_not_click(void **state) {
  (void)state;
  Stage *const loud = stage_open(PRESET, TABOR_QUALITY_DRAFT, true, FRAMES);
  Stage *const soft = stage_open(PRESET, TABOR_QUALITY_DRAFT, true, FRAMES);
  Messages strokes = {0}, both = {0};
  messages_add(&strokes, message_strike(0, 3, 0.03));
  messages_add(&both, message_strike(0, 3, 0.03));
  messages_add(&both, (PlayerMessage){.frame = 1000, .type = PLAYER_GAIN, .value = 0.25});
  stage_play(loud, &strokes, 4800, 128);
  stage_play(soft, &both, 4800, 128);
  stage_end(loud);
  stage_end(soft);
  for (uint32_t i = 0; i < 4800; i++) {
    const double passed = i < 1000 ? 0 : fmin((i - 999) / 241.0, 1);
    const double expected = (1 - 0.75 * passed) * loud->samples[i];
    assert_true(fabs(soft->samples[i] - expected) <= ROUNDING * fabs(expected) + 1e-40);
  }
  stage_close(loud);
  stage_close(soft);
}

static void full_scale_is_never_passed(void **state) {
  (void)state;
  PlayStatus status;
  float samples[2 * 1024];
  Stage *const stage = stage_open(PRESET, TABOR_QUALITY_DRAFT, true, FRAMES);
  const PlayerMessage gain = {.type = PLAYER_GAIN, .value = 1000};
  const PlayerMessage strike = message_strike(300, 12, 0.03);
  assert_true(player_send(stage->player, SOURCE_KEYS, &gain));
  assert_true(player_send(stage->player, SOURCE_KEYS, &strike));
  assert_true(player_process(stage->player, samples, 1024, 0, true));
  player_status(stage->player, &status);
  assert_true(status.clipped > 0 && status.peak[0] > 1 && status.loudest == status.peak[0]);
  assert_int_equal(status.xruns, 1);
  float largest = 0;
  for (uint32_t i = 0; i < 2 * 1024; i++) largest = fmaxf(largest, fabsf(samples[i]));
  assert_true(largest == 1.0f);
  for (uint32_t i = 0; i < 1024; i++) assert_true(samples[2 * i] == samples[2 * i + 1]);
  player_status(stage->player, &status);
  assert_true(status.peak[0] == 0); /* taken by the look before */
  stage_close(stage);
}

enum { SILENCE = 720 }; /* frames until what rang is gone */

/* What moved stays where it is; what rang does not ring on. */
static void silence_is_silent_and_keeps_the_drum(void **state) {
  (void)state;
  Messages messages = {0};
  Stage *const stage = stage_open(PRESET, TABOR_QUALITY_DRAFT, true, FRAMES);
  messages_add(&messages, message_strike(0, 5, 0.03));
  messages_add(&messages, message_parameter(100, "mic.top.gain", 0));
  messages_add(&messages, message_silence(2000));
  messages_add(&messages, message_strike(2001, 5, 0.03));
  messages_add(&messages, message_parameter(6000, "mic.top.gain", 1));
  messages_add(&messages, message_strike(6001, 5, 0.03));
  stage_play(stage, &messages, FRAMES, 128);
  stage_end(stage);
  assert_true(stage_peak(stage, 0, 100) > 1e-3);
  assert_true(stage_peak(stage, 2000 + SILENCE, 6000) == 0); /* its gain has outlived the silence */
  assert_true(stage_peak(stage, 6000, 9000) > 1e-2);
  stage_close(stage);
}

/* A heavy change of the drum leaves what moved where it is, and so does a silence after it; another
 * preset begins anew. */
static void silence_after_a_change_keeps_what_moved(void **state) {
  (void)state;
  Messages messages = {0};
  Stage *const stage = stage_open(PRESET, TABOR_QUALITY_DRAFT, true, FRAMES);
  assert_int_equal(model_builder_set(stage->builder, 1000, "set", "batter.tension", "4321"),
                   OUTCOME_OK);
  assert_int_equal(model_builder_preset(stage->builder, 6000, "frame-drum"), OUTCOME_OK);
  messages_add(&messages, message_parameter(0, "mic.top.gain", 0));
  messages_add(&messages, message_strike(500, 5, 0.03));
  messages_add(&messages, message_silence(2000));
  messages_add(&messages, message_strike(2001, 5, 0.03));
  messages_add(&messages, message_silence(6500));
  messages_add(&messages, message_strike(6501, 5, 0.03));
  stage_play(stage, &messages, FRAMES, 128);
  stage_end(stage);
  assert_true(stage_peak(stage, 500, 2000) == 0);
  assert_true(stage_peak(stage, 2000, 6000) == 0);
  assert_true(stage_peak(stage, 6500, 9000) > 1e-2);
  stage_close(stage);
}

/* A stage on which these have been played to the end; to be closed. */
static Stage *played(Messages *messages) {
  Stage *const stage = stage_open(PRESET, TABOR_QUALITY_DRAFT, true, FRAMES);
  stage_play(stage, messages, FRAMES, 128);
  stage_end(stage);
  return stage;
}

/* It is played at its own frame. */
static void a_stroke_during_silencing_is_not_lost(void **state) {
  (void)state;
  Messages messages = {0}, alone = {0};
  messages_add(&messages, message_strike(0, 5, 0.03));
  messages_add(&messages, message_silence(2000));
  messages_add(&messages, message_strike(2001, 5, 0.03));
  messages_add(&alone, message_strike(2001, 5, 0.03));
  Stage *const stage = played(&messages), *const other = played(&alone);
  assert_true(stage_peak(stage, 2001, 2001 + SILENCE) > 1e-2);
  for (uint32_t i = 2000 + SILENCE; i < FRAMES; i++) {
    assert_true(stage->samples[i] == other->samples[i]);
  }
  stage_close(stage);
  stage_close(other);
}

/* With something else between them, too. */
static void silences_at_once_are_one(void **state) {
  (void)state;
  Messages messages = {0}, single = {0};
  messages_add(&messages, message_strike(0, 5, 0.03));
  messages_add(&single, message_strike(0, 5, 0.03));
  messages_add(&single, message_silence(2000));
  for (uint32_t i = 0; i < 60; i++) {
    messages_add(&messages, message_silence(2000));
    messages_add(&messages, (PlayerMessage){.frame = 2000, .type = PLAYER_GAIN, .value = 1});
  }
  messages_add(&messages, message_strike(2001, 5, 0.03));
  messages_add(&single, message_strike(2001, 5, 0.03));
  Stage *const stage = played(&messages), *const other = played(&single);
  for (uint32_t i = 0; i < FRAMES; i++) assert_true(stage->samples[i] == other->samples[i]);
  stage_close(stage);
  stage_close(other);
}

static void a_stroke_before_another_silence_is_silent(void **state) {
  (void)state;
  Messages messages = {0};
  messages_add(&messages, message_strike(0, 5, 0.03));
  messages_add(&messages, message_silence(2000));
  messages_add(&messages, message_strike(2001, 5, 0.03));
  messages_add(&messages, message_silence(2002));
  Stage *const stage = played(&messages);
  assert_true(stage_peak(stage, 2002 + SILENCE, 9000) == 0);
  stage_close(stage);
}

/* A preset with fewer strikers and microphones gets strokes that were meant for another. */
static void presets_with_less_are_played_all_the_same(void **state) {
  (void)state;
  PlayStatus status;
  Messages messages = {0};
  Stage *const stage = stage_open("frame-drum", TABOR_QUALITY_DRAFT, true, FRAMES);
  PlayerMessage mallet = message_strike(3000, 3, 0.03);
  mallet.event.striker = 1;
  messages_add(&messages, mallet);
  assert_int_equal(model_builder_preset(stage->builder, 1000, PRESET), OUTCOME_OK);
  stage_play(stage, &messages, 6000, 128);
  player_status(stage->player, &status);
  assert_int_equal(status.dropped, 0);
  assert_true(stage_peak(stage, 3000, stage->recorded) > 1e-2);
  stage_close(stage);
}

static const char *write_drum(const TaborDrumDef *def, char text[DRUM_TEXT]) {
  assert_int_equal(tabor_drum_def_write(def, TABOR_TEXT_EDIT, text, DRUM_TEXT, NULL, NULL),
                   TABOR_OK);
  return text;
}

/* Whatever a change has replaced comes back: a pitch replaces a tension, a wire's own value none.
 */
static void changes_are_undone_and_redone(void **state) {
  (void)state;
  static const struct {
    const char *key, *value;
  } changes[] = {{"batter.tension", "3100"}, {"batter.pitch", "A3"},
                 {"wires.strainer", "0.25"}, {"wire.3.tension", "7"},
                 {"wires.head", "batter"},   {"quality.level", "live"},
                 {"mic.top.gain", "0.5"},    {"striker.stick.mass", "0.06"}};
  enum { CHANGES = sizeof changes / sizeof *changes };
  static TaborDrumDef defs[CHANGES + 1];
  static char texts[2][DRUM_TEXT];
  TaborDrumDef def;
  char key[DRUM_KEY_SIZE];
  Stage *const stage = stage_open("snare-14x5.5", TABOR_QUALITY_DRAFT, true, 48000);
  ModelBuilder *const builder = stage->builder;
  model_builder_definition(builder, &defs[0]);
  for (int i = 0; i < CHANGES; i++) {
    assert_int_equal(model_builder_set(builder, 0, "set", changes[i].key, changes[i].value),
                     OUTCOME_OK);
    model_builder_definition(builder, &defs[i + 1]);
  }
  for (int i = CHANGES; i-- > 0;) {
    assert_int_equal(model_builder_undo(builder, 0, key), OUTCOME_OK);
    assert_string_equal(key, changes[i].key);
    model_builder_definition(builder, &def);
    assert_string_equal(write_drum(&def, texts[0]), write_drum(&defs[i], texts[1]));
  }
  assert_int_equal(model_builder_undo(builder, 0, key), OUTCOME_REFUSED);
  for (int i = 0; i < CHANGES; i++) {
    assert_int_equal(model_builder_redo(builder, 0, key), OUTCOME_OK);
    assert_string_equal(key, changes[i].key);
    model_builder_definition(builder, &def);
    assert_string_equal(write_drum(&def, texts[0]), write_drum(&defs[i + 1], texts[1]));
  }
  assert_int_equal(model_builder_redo(builder, 0, key), OUTCOME_REFUSED);
  assert_true(strcmp(write_drum(&def, texts[0]), write_drum(&defs[0], texts[1])) != 0);
  /* a change takes what was undone away, and another drum everything */
  assert_int_equal(model_builder_undo(builder, 0, key), OUTCOME_OK);
  assert_int_equal(model_builder_set(builder, 0, "set", "batter.tension", "3200"), OUTCOME_OK);
  assert_int_equal(model_builder_redo(builder, 0, key), OUTCOME_REFUSED);
  assert_int_equal(model_builder_program(builder, 0, "frame-drum"), OUTCOME_OK);
  assert_int_equal(model_builder_undo(builder, 0, key), OUTCOME_REFUSED);
  stage_close(stage);
}

/* What is live is moved at once, and the drum plays at the quality of before. */
static void what_is_undone_is_heard(void **state) {
  (void)state;
  char key[DRUM_KEY_SIZE];
  PlayStatus status;
  Stage *const stage = stage_open("snare-14x5.5", TABOR_QUALITY_DRAFT, true, 48000);
  ModelBuilder *const builder = stage->builder;
  const double tension = tabor_model_definition(stage_model(stage))->batter.tension;
  assert_int_equal(model_builder_set(builder, 0, "set", "batter.pitch", "A3"), OUTCOME_OK);
  assert_int_equal(model_builder_set(builder, 0, "set", "quality.level", "live"), OUTCOME_OK);
  stage_block(stage, 2000);
  assert_true(tabor_model_definition(stage_model(stage))->batter.tension != tension);
  assert_int_equal(model_builder_undo(builder, 2000, key), OUTCOME_OK);
  model_builder_status(builder, &status);
  assert_int_equal(status.quality, TABOR_QUALITY_DRAFT);
  assert_int_equal(model_builder_undo(builder, 2000, key), OUTCOME_OK);
  stage_block(stage, 4000);
  assert_true(tabor_model_definition(stage_model(stage))->batter.tension == tension);
  stage_close(stage);
}

/* A change is built by another thread while the drum is played; what moved meanwhile is not lost.
 */
static void changes_come_while_it_rings(void **state) {
  (void)state;
  PlayStatus status = {0};
  TaborDrumDef def;
  Stage *const stage = stage_open(PRESET, TABOR_QUALITY_DRAFT, false, 48000 * 60);
  const PlayerMessage strike = message_strike(PLAYER_NOW, 3, 0.03);
  assert_int_equal(model_builder_set(stage->builder, PLAYER_NOW, "set", "batter.tension", "3100"),
                   OUTCOME_OK);
  assert_int_equal(model_builder_preset(stage->builder, PLAYER_NOW, "frame-drum"), OUTCOME_OK);
  assert_int_equal(
    model_builder_set(stage->builder, PLAYER_NOW, "set", "batter.muffle_strength", "3"),
    OUTCOME_OK);
  const TaborModel *model = NULL;
  const struct timespec moment = {.tv_nsec = 2000000};
  for (int i = 0; i < 9000; i++) {
    if (i % 50 == 0) assert_true(player_send(stage->player, SOURCE_KEYS, &strike));
    stage_block(stage, 128);
    model_builder_status(stage->builder, &status);
    model = stage_model(stage);
    if (!status.building && strcmp(tabor_model_definition(model)->name, status.preset) == 0) break;
    (void)nanosleep(&moment, NULL);
  }
  assert_string_equal(status.preset, "frame-drum");
  assert_false(status.building);
  model_builder_definition(stage->builder, &def);
  assert_true(def.batter.muffle_strength == 3);
  stage_close(stage);
}

/* One preset after another, each wished for before the last is there: what the next is to begin
 * with does not move the one that comes, and nobody hears a drum that nobody struck. */
static void presets_passed_over_are_silent(void **state) {
  (void)state;
  PlayStatus status = {0};
  Stage *const stage = stage_open("snare-14x5.5", TABOR_QUALITY_DRAFT, false, 48000 * 60);
  static const char *const presets[] = {"snare-14x6.5-loose", "marching-14x12", "snare-14x5.5-off"};
  const struct timespec moment = {.tv_nsec = 2000000};
  uint32_t wished = 0;
  for (int i = 0; i < 9000; i++) {
    model_builder_status(stage->builder, &status);
    const bool comes = i == 0 || (status.building && i % 20 == 0);
    if (wished < 3 && comes) {
      assert_int_equal(model_builder_preset(stage->builder, PLAYER_NOW, presets[wished++]),
                       OUTCOME_OK);
    }
    stage_block(stage, 128);
    if (wished == 3 && !status.building) break;
    if (!status.building && i > 0 && wished < 3) {
      assert_int_equal(model_builder_preset(stage->builder, PLAYER_NOW, presets[wished++]),
                       OUTCOME_OK);
    }
    (void)nanosleep(&moment, NULL);
  }
  for (int i = 0; i < 400; i++) stage_block(stage, 128);
  stage_end(stage);
  player_status(stage->player, &status);
  assert_int_equal(wished, 3);
  assert_int_equal(status.dropped, 0);
  assert_int_equal(status.late, 0);
  assert_true(stage_peak(stage, 0, stage->recorded) == 0);
  stage_close(stage);
}

/* To what is there already it does nothing; to the same preset with something set, it begins anew.
 */
static void a_program_change_once_more_does_nothing(void **state) {
  (void)state;
  TaborDrumDef def;
  Stage *const stage = stage_open(PRESET, TABOR_QUALITY_DRAFT, true, FRAMES);
  const PlayerMessage strike = message_strike(0, 5, 0.03);
  assert_int_equal(model_builder_program(stage->builder, 0, "frame-drum"), OUTCOME_OK);
  assert_true(player_send(stage->player, SOURCE_KEYS, &strike));
  stage_block(stage, 1000);
  const TaborModel *const model = stage_model(stage);
  assert_string_equal(tabor_model_definition(model)->name, "frame-drum");
  assert_int_equal(model_builder_program(stage->builder, 1000, "frame-drum"), OUTCOME_OK);
  stage_block(stage, 1000);
  assert_ptr_equal(stage_model(stage), model);
  assert_true(stage_peak(stage, 1500, stage->recorded) > 1e-4);
  assert_int_equal(model_builder_set(stage->builder, 2000, "set", "batter.tension", "3100"),
                   OUTCOME_OK);
  assert_int_equal(model_builder_program(stage->builder, 2000, "frame-drum"), OUTCOME_OK);
  model_builder_definition(stage->builder, &def);
  assert_true(def.batter.tension != 3100);
  stage_block(stage, 3000);
  assert_true(stage_peak(stage, 2000, 2100) > 1e-5);
  assert_true(stage_peak(stage, 2000 + 1440, stage->recorded) == 0); /* the new one is at rest */
  PlayStatus status;
  player_status(stage->player, &status);
  assert_int_equal(status.strokes, 1); /* of the drums before, too */
  stage_close(stage);
}

/* The quality is a key like others, and a heavy one. */
static void quality_can_be_set(void **state) {
  (void)state;
  PlayStatus status = {0};
  Stage *const stage = stage_open(PRESET, TABOR_QUALITY_DRAFT, true, FRAMES);
  assert_int_equal(model_builder_set(stage->builder, PLAYER_NOW, "set", "quality.level", "live"),
                   OUTCOME_OK);
  stage_block(stage, 128);
  model_builder_status(stage->builder, &status);
  TaborModelInfo info;
  tabor_model_info(stage_model(stage), &info);
  assert_int_equal(info.quality, TABOR_QUALITY_LIVE);
  assert_int_equal(status.quality, TABOR_QUALITY_LIVE);
  stage_close(stage);
}

static void wrong_changes_are_refused(void **state) {
  (void)state;
  char said[200];
  TaborDrumDef before, after;
  Stage *const stage = stage_open(PRESET, TABOR_QUALITY_DRAFT, true, FRAMES);
  model_builder_definition(stage->builder, &before);
  const MessageCapture capture = message_capture(said, sizeof said);
  assert_int_equal(model_builder_set(stage->builder, 0, "set", "batter.tensoin", "1"),
                   OUTCOME_REFUSED);
  assert_non_null(strstr(said, "batter.tension"));
  assert_int_equal(model_builder_set(stage->builder, 0, "set", "batter.tension", "1e9"),
                   OUTCOME_REFUSED);
  assert_int_equal(model_builder_set(stage->builder, 0, "set", "mic.new.gain", "1"),
                   OUTCOME_REFUSED);
  assert_int_equal(model_builder_preset(stage->builder, 0, "snare"), OUTCOME_REFUSED);
  message_release(capture);
  model_builder_definition(stage->builder, &after);
  assert_memory_equal(&before, &after, sizeof before);
  stage_block(stage, 256);
  stage_close(stage);
}

static void presets_step_round(void **state) {
  (void)state;
  PlayStatus status;
  Stage *const stage = stage_open("frame-drum", TABOR_QUALITY_DRAFT, true, FRAMES);
  assert_int_equal(model_builder_step_preset(stage->builder, 0, 1), OUTCOME_OK);
  model_builder_status(stage->builder, &status);
  assert_string_not_equal(status.preset, "frame-drum");
  assert_int_equal(model_builder_step_preset(stage->builder, 0, -1), OUTCOME_OK);
  model_builder_status(stage->builder, &status);
  assert_string_equal(status.preset, "frame-drum");
  stage_close(stage);
}

/* ---- load ----------------------------------------------------------------------------------- */

enum { LOAD_BLOCK = 256, LOAD_SECONDS = 20, LOAD_BLOCKS = LOAD_SECONDS * 48000 / LOAD_BLOCK };

static bool is_brief; /* under sanitizers and wine: a tenth of it, whose time says nothing */

/* Random strokes, 9 a second, and live changes. */
static void write_random(Messages *messages, uint64_t random) {
  uint64_t frame = 0;
  *messages = (Messages){0};
  while (frame < LOAD_SECONDS * 48000u) {
    const double velocity = 0.3 * pow(40, random_next(&random));
    messages_add(messages, message_strike(frame, velocity, 0.15 * random_next(&random)));
    if (messages->count % 10 == 0) {
      messages_add(messages, message_parameter(frame, "wires.strainer", random_next(&random)));
    }
    frame += 1 + (uint64_t)(2 * 48000 / 9.0 * random_next(&random));
  }
}

/* Processor time of every block, the least of the runs so far: others use this machine, too. */
static double measure(const char *preset, uint32_t blocks, double *least) {
  static Messages messages;
  double worst = 0;
  Stage *const stage = stage_open(preset, TABOR_QUALITY_LIVE, true, LOAD_SECONDS * 48000);
  write_random(&messages, 7);
  for (uint32_t block = 0; block < blocks; block++) {
    const double start = stopwatch_seconds(CLOCK_THREAD_CPUTIME_ID);
    stage_play(stage, &messages, (uint64_t)(block + 1) * LOAD_BLOCK, LOAD_BLOCK);
    least[block] = fmin(least[block], stopwatch_seconds(CLOCK_THREAD_CPUTIME_ID) - start);
    worst = fmax(worst, least[block]);
  }
  stage_end(stage);
  for (uint64_t i = 0; i < stage->recorded; i++) assert_true(isfinite(stage->samples[i]));
  PlayStatus status;
  player_status(stage->player, &status);
  assert_int_equal(status.recovered, 0);
  assert_int_equal(status.dropped, 0);
  assert_true(status.strokes > 4 * blocks * LOAD_BLOCK / 48000);
  stage_close(stage);
  return worst;
}

static void blocks_are_computed_in_time(void **state) {
  (void)state;
  static double least[LOAD_BLOCKS];
  const double deadline = LOAD_BLOCK / 48000.0;
  double worst = INFINITY;
  for (uint32_t i = 0; i < LOAD_BLOCKS; i++) least[i] = INFINITY;
  if (is_brief) {
    (void)measure(PRESET, LOAD_BLOCKS / 10, least);
    return;
  }
  for (int run = 0; run < 3 && worst > deadline; run++) worst = measure(PRESET, LOAD_BLOCKS, least);
  printf("the worst block of %s took %.0f %% of its time\n", PRESET, 100 * worst / deadline);
  assert_true(worst < deadline);
}

int main(int argc, char **argv) {
  is_brief = argc > 1 && strcmp(argv[1], "brief") == 0;
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(sound_does_not_depend_on_blocks),
    cmocka_unit_test(crowds_do_not_depend_on_blocks),
    cmocka_unit_test(sound_is_the_drums),
    cmocka_unit_test(the_first_block_tells_the_device),
    cmocka_unit_test(what_comes_too_late_acts_at_once),
    cmocka_unit_test(a_full_ring_drops_and_counts),
    cmocka_unit_test(a_flood_is_played_or_counted),
    cmocka_unit_test(gain_does_not_click),
    cmocka_unit_test(full_scale_is_never_passed),
    cmocka_unit_test(silence_is_silent_and_keeps_the_drum),
    cmocka_unit_test(silence_after_a_change_keeps_what_moved),
    cmocka_unit_test(a_stroke_during_silencing_is_not_lost),
    cmocka_unit_test(silences_at_once_are_one),
    cmocka_unit_test(a_stroke_before_another_silence_is_silent),
    cmocka_unit_test(presets_with_less_are_played_all_the_same),
    cmocka_unit_test(changes_are_undone_and_redone),
    cmocka_unit_test(what_is_undone_is_heard),
    cmocka_unit_test(changes_come_while_it_rings),
    cmocka_unit_test(presets_passed_over_are_silent),
    cmocka_unit_test(a_program_change_once_more_does_nothing),
    cmocka_unit_test(quality_can_be_set),
    cmocka_unit_test(wrong_changes_are_refused),
    cmocka_unit_test(presets_step_round),
    cmocka_unit_test(blocks_are_computed_in_time),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
