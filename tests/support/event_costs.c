/* SPDX-License-Identifier: MIT */
/* event_costs PRESET QUALITY SEED MIX...: plays a block of 64 frames of a drum that rings for each
 * mix of events, and has callgrind dump what each cost under the mix's name. A mix is a number of
 * events and letters of kinds, which take turns: `1000sh` is 500 strokes and 500 silences. Kind `?`
 * is one of all kinds, by chance.
 *
 *     s b r c  strokes: plain, buzz, rimshot, cross-stick
 *     p d l m  press, damping hand, release, move
 *     X Y      swap, replacement by another model
 *     h R      silence, reset
 *     g t u    gain, wire tension, muffling */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <valgrind/callgrind.h>

#include "tabor/tabor.h"

enum { MOST = 1000, BLOCK = 64, LEAD = 10 };

static const char KINDS[] = "sbrcpdlmgtuhRXY";

static TaborModel
  *models[2]; /* of two tensions: a drum is swapped from one to the other and back */
static TaborSwap *swaps[MOST];
static uint32_t swap_count;

static void fail(const char *message) {
  fprintf(stderr, "event_costs: %s\n", message);
  exit(1);
}

static TaborModel *model_of(const char *preset, const char *quality, double tension) {
  TaborDrumDef def;
  TaborModelOptions options;
  TaborError error;
  TaborModel *model = NULL;
  tabor_model_options_default(&options);
  options.quality = strcmp(quality, "studio") == 0 ? TABOR_QUALITY_STUDIO : TABOR_QUALITY_LIVE;
  if (tabor_drum_def_preset(&def, preset, &error) != TABOR_OK) fail(error.message);
  def.batter.tension *= tension;
  if (tabor_model_create(&def, &options, &model, &error) != TABOR_OK) fail(error.message);
  return model;
}

static TaborEvent stroke(TaborTechnique technique) {
  return (TaborEvent){.type = TABOR_EVENT_STRIKE, .technique = technique};
}

static TaborEvent change(const char *key, double value) {
  const TaborParameter *parameter = tabor_parameter_find(key);
  return (TaborEvent){.type = TABOR_EVENT_PARAMETER, .parameter = parameter->id, .value = value};
}

/* Each leads from where the one before it leads to. */
static TaborEvent drum_change(uint32_t type) {
  TaborModel *from = models[swap_count % 2], *to = models[(swap_count + 1) % 2];
  TaborSwap *swap = NULL;
  if (tabor_swap_create(from, to, &swap, NULL) != TABOR_OK) fail("no memory for a swap");
  swaps[swap_count++] = swap;
  return (TaborEvent){.type = type, .swap = swap};
}

static TaborEvent event_of(char kind, uint32_t i) {
  switch (kind) {
  case 's': return stroke(TABOR_TECHNIQUE_NORMAL);
  case 'b': return stroke(TABOR_TECHNIQUE_BUZZ);
  case 'r': return stroke(TABOR_TECHNIQUE_RIMSHOT);
  case 'c': return stroke(TABOR_TECHNIQUE_CROSS_STICK);
  case 'p': return (TaborEvent){.type = TABOR_EVENT_PRESS, .value = 0.3};
  case 'd': return (TaborEvent){.type = TABOR_EVENT_DAMP, .id = 1 + i, .value = 20.0};
  case 'l': return (TaborEvent){.type = TABOR_EVENT_RELEASE};
  case 'm': return (TaborEvent){.type = TABOR_EVENT_MOVE};
  case 'g': return (TaborEvent){.type = TABOR_EVENT_GAIN, .value = 0.5 + i % 2};
  case 't': return change("wires.tension", 10.0 + i % 5);
  case 'u': return change("batter.muffle_strength", i % 5);
  case 'h': return (TaborEvent){.type = TABOR_EVENT_SILENCE};
  case 'R': return (TaborEvent){.type = TABOR_EVENT_RESET};
  case 'X': return drum_change(TABOR_EVENT_SWAP);
  case 'Y': return drum_change(TABOR_EVENT_REPLACE);
  default: fail("unknown kind of event");
  }
  return (TaborEvent){0};
}

/* MINSTD [Park1988]: the same everywhere. */
static char random_kind(uint32_t *seed) {
  *seed = (uint32_t)((uint64_t)*seed * 48271u % 2147483647u);
  return KINDS[*seed % (sizeof KINDS - 1)];
}

static uint32_t fill(const char *mix, uint32_t *seed, TaborEvent *events) {
  char *kinds;
  const uint32_t count = (uint32_t)strtoul(mix, &kinds, 10);
  if (count > MOST || *kinds == '\0') fail("a mix is a number up to 1000 and kinds");
  for (uint32_t i = 0; i < count; i++) {
    const char kind = kinds[i % strlen(kinds)];
    events[i] = event_of(kind == '?' ? random_kind(seed) : kind, i);
    events[i].frame = i * BLOCK / count;
    events[i].velocity = 1.0 + i % 7;
    events[i].radius = 0.01 * (i % 15);
    events[i].angle = 37.0 * i;
  }
  return count;
}

static float *outputs[TABOR_MAX_MICS];
static void *ringing; /* the state of a drum that was struck */
static size_t ringing_bytes;

static TaborDrum *new_drum(void) {
  TaborDrum *drum = NULL;
  if (tabor_drum_create(models[0], &drum, NULL) != TABOR_OK) fail("no memory for a drum");
  return drum;
}

static void keep_ringing_drum(void) {
  static float sound[TABOR_MAX_MICS][BLOCK];
  const TaborEvent first = {.type = TABOR_EVENT_STRIKE, .velocity = 4.5, .radius = 0.05};
  TaborDrum *drum = new_drum();
  for (uint32_t i = 0; i < TABOR_MAX_MICS; i++) outputs[i] = sound[i];
  for (uint32_t block = 0; block < LEAD; block++) {
    tabor_drum_process(drum, &first, block == 0, outputs, BLOCK);
  }
  ringing_bytes = tabor_drum_state_size(drum);
  ringing = malloc(ringing_bytes);
  if (!ringing) fail("no memory for a state");
  tabor_drum_state_save(drum, ringing);
  tabor_drum_destroy(drum);
}

static void play(const char *mix, uint32_t *seed) {
  TaborEvent events[MOST];
  TaborDrum *drum = new_drum();
  TaborStatistics statistics;
  swap_count = 0;
  if (tabor_drum_state_load(drum, ringing, ringing_bytes) != TABOR_OK) fail("the state is refused");
  const uint32_t count = fill(mix, seed, events);
  CALLGRIND_START_INSTRUMENTATION;
  CALLGRIND_ZERO_STATS;
  tabor_drum_process(drum, events, count, outputs, BLOCK);
  CALLGRIND_DUMP_STATS_AT(mix);
  CALLGRIND_STOP_INSTRUMENTATION;
  tabor_drum_statistics(drum, &statistics);
  printf("%s: %llu events dropped\n", mix, (unsigned long long)statistics.dropped_events);
  tabor_drum_destroy(drum);
  for (uint32_t i = 0; i < swap_count; i++) tabor_swap_destroy(swaps[i]);
}

int main(int argc, char **argv) {
  if (argc < 5) fail("usage: event_costs PRESET QUALITY SEED MIX...");
  models[0] = model_of(argv[1], argv[2], 1.0);
  models[1] = model_of(argv[1], argv[2], 1.1);
  uint32_t seed = 1u + (uint32_t)strtoul(argv[3], NULL, 10) % 2147483645u;
  keep_ringing_drum();
  for (int i = 4; i < argc; i++) play(argv[i], &seed);
  free(ringing);
  tabor_model_release(models[0]);
  tabor_model_release(models[1]);
  return 0;
}
