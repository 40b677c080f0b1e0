/* SPDX-License-Identifier: MIT */
#include "drum_script.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

TaborModel *script_model_of(const TaborDrumDef *def, TaborQuality quality,
                            TaborInstructions instructions) {
  TaborError error;
  TaborModelOptions options;
  TaborModel *model = NULL;
  tabor_model_options_default(&options);
  options.quality = quality;
  options.instructions = instructions;
  if (tabor_model_create(def, &options, &model, &error) != TABOR_OK) {
    fail_msg("%s: %s", def->name, error.message);
  }
  return model;
}

static TaborDrumDef script_preset(const char *preset) {
  TaborDrumDef def;
  TaborError error;
  if (tabor_drum_def_preset(&def, preset, &error) != TABOR_OK) {
    fail_msg("%s: %s", preset, error.message);
  }
  return def;
}

TaborModel *script_model(const char *preset, TaborQuality quality, TaborInstructions instructions) {
  const TaborDrumDef def = script_preset(preset);
  return script_model_of(&def, quality, instructions);
}

void script_narrow(TaborDrumDef *def) {
  def->quality.two_way_bandwidth = 1000.0;
  def->quality.bandwidth = 3000.0;
  def->quality.wire_points = 16;
}

TaborModel *script_narrow_model(const char *preset, TaborQuality quality,
                                TaborInstructions instructions) {
  TaborDrumDef def = script_preset(preset);
  script_narrow(&def);
  return script_model_of(&def, quality, instructions);
}

TaborDrum *script_drum(TaborModel *model) {
  TaborDrum *drum = NULL;
  TaborError error;
  if (tabor_drum_create(model, &drum, &error) != TABOR_OK) fail_msg("%s", error.message);
  return drum;
}

TaborEvent script_strike(uint32_t frame, double velocity, double radius, double angle) {
  return (TaborEvent){.frame = frame,
                      .type = TABOR_EVENT_STRIKE,
                      .velocity = velocity,
                      .radius = radius,
                      .angle = angle};
}

TaborEvent script_parameter(uint32_t frame, const char *key, double value) {
  const TaborParameter *parameter = tabor_parameter_find(key);
  if (!parameter) fail_msg("no parameter %s", key);
  return (TaborEvent){
    .frame = frame, .type = TABOR_EVENT_PARAMETER, .parameter = parameter->id, .value = value};
}

void script_add(Script *script, TaborEvent event) {
  assert_true(script->count < SCRIPT_MAX_EVENTS);
  script->events[script->count++] = event;
}

void script_everything(Script *script) {
  memset(script, 0, sizeof *script);
  script_add(script, script_strike(3, 3.0, 0.031, 17.0));
  script_add(script, script_parameter(251, "wires.strainer", 0.4));
  script_add(script, script_parameter(387, "wires.tension", 7.5));
  TaborEvent stroke = script_strike(513, 8.0, 0.07, -120.0);
  stroke.id = 5;
  script_add(script, stroke);
  script_add(script, script_strike(513, 0.8, 0.0, 0.0));
  script_add(script, script_parameter(645, "output.full_scale", 35.0));
  script_add(script, (TaborEvent){.frame = 1025, .type = TABOR_EVENT_RELEASE, .id = 5});
  script_add(script, script_parameter(1155, "wires.damping_0", 20.0));
  script_add(script, script_parameter(1155, "wires.strainer", 0.95));
  script_add(script, script_strike(1667, 12.0, 0.04, 200.0));
  script_add(script, (TaborEvent){.frame = 1901,
                                  .type = TABOR_EVENT_DAMP,
                                  .id = 9,
                                  .radius = 0.06,
                                  .angle = 80.0,
                                  .value = 6.0});
  script_add(script, script_parameter(2121, "wires.damping_1", 0.003));
  script_add(script, script_strike(2303, 2.0, 0.05, 45.0));
  TaborEvent rimshot = script_strike(2411, 3.0, 0.05, 120.0);
  rimshot.technique = TABOR_TECHNIQUE_RIMSHOT;
  script_add(script, rimshot);
  TaborEvent across = script_strike(2533, 1.5, 0.06, 300.0);
  across.technique = TABOR_TECHNIQUE_CROSS_STICK;
  script_add(script, across);
  script_add(script, (TaborEvent){.frame = 2751, .type = TABOR_EVENT_RELEASE, .id = 9});
  script_add(script, script_parameter(2752, "wires.strainer", 1.0));
  script_add(script, script_strike(3201, 5.0, 0.09, 10.0));
  script_add(script, script_parameter(3400, "mic.top.gain", 0.5));
  script_add(script, (TaborEvent){.frame = 4095, .type = TABOR_EVENT_RELEASE});
}

Take take_create(const TaborModel *model, uint32_t frames) {
  TaborModelInfo info;
  tabor_model_info(model, &info);
  Take take = {.mics = info.mic_count, .frames = frames};
  take.samples = calloc((size_t)take.mics * frames, sizeof *take.samples);
  assert_non_null(take.samples);
  return take;
}

void take_destroy(Take *take) { free(take->samples); }

double take_peak(const Take *take) {
  double peak = 0.0;
  for (size_t i = 0; i < (size_t)take->mics * take->frames; i++) {
    assert_true(isfinite(take->samples[i]));
    peak = fmax(peak, fabs((double)take->samples[i]));
  }
  return peak;
}

void take_assert_same(const Take *a, const Take *b, const char *what) {
  assert_int_equal(a->mics, b->mics);
  assert_int_equal(a->frames, b->frames);
  for (uint32_t mic = 0; mic < a->mics; mic++) {
    for (uint32_t frame = 0; frame < a->frames; frame++) {
      const size_t i = (size_t)mic * a->frames + frame;
      if (memcmp(&a->samples[i], &b->samples[i], sizeof(float)) != 0) {
        fail_msg("%s: microphone %u, frame %u: %.9g and %.9g", what, mic, frame,
                 (double)a->samples[i], (double)b->samples[i]);
      }
    }
  }
  if (memcmp(&a->ledger, &b->ledger, sizeof a->ledger) != 0) {
    fail_msg("%s: the ledgers differ: residual %.17g and %.17g, stored %.17g and %.17g", what,
             a->ledger.residual, b->ledger.residual, a->ledger.stored, b->ledger.stored);
  }
}

/* Events of the block at absolute frame start, with offsets into it. */
static uint32_t events_of_block(const Script *script, uint32_t start, uint32_t size,
                                TaborEvent *events) {
  uint32_t count = 0;
  for (uint32_t i = 0; i < script->count; i++) {
    const uint32_t frame = script->events[i].frame;
    if (frame < start || frame >= start + size) continue;
    events[count] = script->events[i];
    events[count++].frame = frame - start;
  }
  return count;
}

void script_play(TaborDrum *drum, const Script *script, uint32_t from, uint32_t to, BlockSize *size,
                 void *context, Take *take) {
  assert_true(to <= take->frames);
  for (uint32_t start = from; start < to;) {
    const uint32_t wish = size(context);
    const uint32_t frames = wish < to - start ? wish : to - start;
    TaborEvent events[SCRIPT_MAX_EVENTS];
    float *outputs[TABOR_MAX_MICS] = {NULL};
    for (uint32_t mic = 0; mic < take->mics; mic++) {
      outputs[mic] = take->samples + (size_t)mic * take->frames + start;
    }
    const uint32_t count = events_of_block(script, start, frames, events);
    tabor_drum_process(drum, events, count, outputs, frames);
    start += frames;
  }
  tabor_drum_ledger(drum, &take->ledger);
  tabor_drum_statistics(drum, &take->statistics);
}

void script_play_all(TaborDrum *drum, const Script *script, Take *take) {
  script_play(drum, script, 0, take->frames, blocks_of_64, NULL, take);
}

uint32_t blocks_of_64(void *context) {
  (void)context;
  return 64;
}

uint32_t blocks_of(void *context) { return *(const uint32_t *)context; }
