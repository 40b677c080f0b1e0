/* SPDX-License-Identifier: MIT */

#include "player_script.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "sound/player_state.h"

#define RATE 48000.0
#define WIDTH 2u
#define LARGEST 4096u

Stage *stage_open(const char *preset, TaborQuality quality, bool waits, uint32_t frames) {
  Stage *const stage = calloc(1, sizeof *stage);
  TaborDrumDef def;
  assert_non_null(stage);
  assert_int_equal(tabor_drum_def_preset(&def, preset, NULL), TABOR_OK);
  ModelBuilderSetup setup = {.preset = preset, .def = &def, .waits = waits};
  tabor_model_options_default(&setup.options);
  setup.options.quality = quality;
  assert_int_equal(tabor_model_create(&def, &setup.options, &setup.model, NULL), TABOR_OK);
  assert_int_equal(tabor_drum_create(setup.model, &stage->drum, NULL), TABOR_OK);
  assert_int_equal(model_builder_create(&setup, &stage->builder), OUTCOME_OK);
  tabor_model_release(setup.model);
  const PlayerSetup player = {.drum = stage->drum,
                              .def = &def,
                              .rate = RATE,
                              .channels = 1,
                              .width = WIDTH,
                              .gain = 1,
                              .records = true,
                              .logs = true};
  assert_int_equal(player_create(&player, &stage->player), OUTCOME_OK);
  assert_int_equal(model_builder_start(stage->builder, stage->player), OUTCOME_OK);
  stage->channels = 1;
  stage->room = frames + LARGEST;
  stage->samples = calloc(stage->room, sizeof *stage->samples);
  assert_non_null(stage->samples);
  return stage;
}

void stage_close(Stage *stage) {
  model_builder_stop(stage->builder);
  player_destroy(stage->player);
  tabor_drum_destroy(stage->drum);
  model_builder_destroy(stage->builder);
  free(stage->samples);
  free(stage);
}

static void take_recorded(Stage *stage) {
  const RecordingBlock *record;
  while ((record = recording_peek(player_recording(stage->player))) != NULL) {
    assert_int_equal(record->frame, stage->recorded);
    assert_true(stage->recorded + record->frames <= stage->room);
    memcpy(stage->samples + stage->recorded, record->samples,
           record->frames * sizeof *record->samples);
    stage->recorded += record->frames;
    recording_pop(player_recording(stage->player));
  }
}

void stage_block(Stage *stage, uint32_t frames) {
  float samples[LARGEST * WIDTH];
  assert_true(
    player_process(stage->player, samples, frames, (double)stage->position / RATE, false));
  stage->position += frames;
  take_recorded(stage);
}

void stage_play(Stage *stage, Messages *messages, uint64_t until, uint32_t size) {
  uint64_t random = 1;
  while (stage->position < until) {
    const uint32_t wish = size > 0 ? size : 1 + (uint32_t)(random_next(&random) * LARGEST);
    const uint64_t left = until - stage->position;
    const uint32_t frames = left < wish ? (uint32_t)left : wish;
    while (messages->next < messages->count &&
           messages->list[messages->next].frame < stage->position + frames) {
      assert_true(player_send(stage->player, SOURCE_SCORE, &messages->list[messages->next++]));
    }
    stage_block(stage, frames);
  }
}

void stage_end(Stage *stage) {
  assert_true(player_halt(stage->player, 1));
  take_recorded(stage);
}

const TaborModel *stage_model(const Stage *stage) {
  return tabor_drum_model(stage->player->core.drum);
}

double stage_peak(const Stage *stage, uint64_t from, uint64_t until) {
  double peak = 0;
  for (uint64_t i = from; i < until; i++) peak = fmax(peak, fabs(stage->samples[i]));
  return peak;
}

PlayerMessage message_strike(uint64_t frame, double velocity, double radius) {
  return (PlayerMessage){
    .frame = frame,
    .type = PLAYER_EVENT,
    .event = {.type = TABOR_EVENT_STRIKE, .velocity = velocity, .radius = radius}};
}

PlayerMessage message_silence(uint64_t frame) {
  return (PlayerMessage){
    .frame = frame, .type = PLAYER_EVENT, .event = {.type = TABOR_EVENT_SILENCE}};
}

PlayerMessage message_parameter(uint64_t frame, const char *key, double value) {
  const TaborParameter *const parameter = tabor_parameter_find(key);
  assert_non_null(parameter);
  return (PlayerMessage){
    .frame = frame,
    .type = PLAYER_EVENT,
    .event = {.type = TABOR_EVENT_PARAMETER, .parameter = parameter->id, .value = value}};
}

void messages_add(Messages *messages, PlayerMessage message) {
  assert_true(messages->count < PLAYER_SCRIPT_MOST);
  messages->list[messages->count++] = message;
}

double random_next(uint64_t *state) {
  *state = *state * 6364136223846793005u + 1442695040888963407u;
  return (double)(*state >> 11) / 9007199254740992.0;
}
