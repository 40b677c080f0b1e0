/* SPDX-License-Identifier: MIT */
/* Any sequence of calls to a drum, over a pool of models: events with any fields, blocks of any
 * size, swaps, replacements, saves, loads, resets. The sound stays finite, time goes on, and what
 * was saved can be loaded. */
#include <math.h>
#include <stdlib.h>

#include "fuzz.h"

enum { MODELS = 4, MOST_EVENTS = 24, MOST_FRAMES = 96, MOST_CALLS = 64, MOST_SWAPS = 8 };

typedef struct Session {
  TaborDrum *drum;
  TaborSwap *swaps[MOST_SWAPS];
  uint32_t swap_count;
  void *saved;
  size_t saved_size;
  const TaborModel *saved_model;
} Session;

static TaborModel *models[MODELS];

/* Most fields are as players have them; some are any. */
static TaborEvent take_event(FuzzInput *input) {
  static const uint32_t LIVE[] = {308, 408, 508, 512, 513, 514, 803, 1103, 1400, 1700};
  TaborEvent event = {.frame = fuzz_byte(input) % (MOST_FRAMES + 8)};
  const uint8_t wild = fuzz_byte(input);
  event.type = fuzz_byte(input) % (TABOR_EVENT_REPLACE + (wild & 1u ? 4u : 1u));
  event.id = fuzz_byte(input) % 4;
  event.striker = wild & 2u ? fuzz_word(input) : fuzz_byte(input) % 4;
  event.technique = wild & 4u ? fuzz_word(input) : fuzz_byte(input) % 7;
  event.parameter =
    wild & 8u ? fuzz_word(input) : LIVE[fuzz_byte(input) % (sizeof LIVE / sizeof *LIVE)];
  event.index = wild & 16u ? fuzz_word(input) : fuzz_byte(input) % 3;
  event.velocity = 4.0 * fuzz_number(input);
  event.radius = 0.1 * fuzz_number(input);
  event.angle = 180.0 * fuzz_number(input);
  event.value = fuzz_number(input);
  return event;
}

static TaborSwap *new_swap(Session *session, FuzzInput *input) {
  TaborSwap *swap = NULL;
  if (session->swap_count == MOST_SWAPS) return NULL;
  TaborModel *const from = models[fuzz_byte(input) % MODELS], *const to =
                                                                models[fuzz_byte(input) % MODELS];
  fuzz_require(tabor_swap_create(from, to, &swap, NULL) == TABOR_OK, "a swap");
  session->swaps[session->swap_count++] = swap;
  return swap;
}

static void process(Session *session, FuzzInput *input) {
  TaborEvent events[MOST_EVENTS];
  float sound[2][MOST_FRAMES], *outputs[TABOR_MAX_MICS] = {sound[0], sound[1]};
  const uint32_t frames = fuzz_byte(input) % (MOST_FRAMES + 1),
                 count = fuzz_byte(input) % MOST_EVENTS;
  for (uint32_t i = 0; i < count; i++) {
    events[i] = take_event(input);
    const bool swaps = events[i].type == TABOR_EVENT_SWAP || events[i].type == TABOR_EVENT_REPLACE;
    if (swaps) events[i].swap = new_swap(session, input);
  }
  for (uint32_t i = 0; i < MOST_FRAMES; i++) sound[0][i] = sound[1][i] = 0.0f;
  tabor_drum_process(session->drum, events, count, fuzz_byte(input) % 8 ? outputs : NULL, frames);
  for (uint32_t i = 0; i < frames; i++) {
    fuzz_require(isfinite(sound[0][i]) && isfinite(sound[1][i]), "the sound is finite");
  }
}

static void save(Session *session) {
  free(session->saved);
  session->saved_model = tabor_drum_model(session->drum);
  session->saved_size = tabor_drum_state_size(session->drum);
  session->saved = malloc(session->saved_size);
  fuzz_require(session->saved != NULL, "memory");
  tabor_drum_state_save(session->drum, session->saved);
}

static void load(Session *session) {
  if (!session->saved) return;
  const TaborStatus status =
    tabor_drum_state_load(session->drum, session->saved, session->saved_size);
  const bool fits = tabor_drum_model(session->drum) == session->saved_model;
  fuzz_require(status == (fits ? TABOR_OK : TABOR_ERROR_STATE), "a saved state is loaded");
}

static void ask(const Session *session) {
  TaborLedger ledger;
  TaborProbe probe;
  TaborStatistics statistics;
  tabor_drum_ledger(session->drum, &ledger);
  tabor_drum_probe(session->drum, &probe);
  tabor_drum_statistics(session->drum, &statistics);
  fuzz_require(isfinite(ledger.stored) && isfinite(ledger.residual), "the ledger is finite");
  fuzz_require(statistics.recovered == 0, "no state was given up");
  fuzz_require(statistics.in_play <= TABOR_MAX_ACTIVE + 2, "strikers in play");
}

static void call(Session *session, FuzzInput *input) {
  switch (fuzz_byte(input) % 16) {
  case 0: save(session); break;
  case 1: load(session); break;
  case 2: tabor_drum_reset(session->drum); break;
  case 3: ask(session); break;
  default: process(session, input);
  }
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  FuzzInput input = {data, size};
  Session session = {.drum = NULL};
  for (uint32_t i = 0; i < MODELS; i++) {
    if (!models[i]) models[i] = fuzz_model(i);
  }
  fuzz_require(tabor_drum_create(models[fuzz_byte(&input) % MODELS], &session.drum, NULL) ==
                 TABOR_OK,
               "a drum");
  for (int i = 0; i < MOST_CALLS && input.left > 0; i++) call(&session, &input);
  ask(&session);
  tabor_drum_destroy(session.drum);
  for (uint32_t i = 0; i < session.swap_count; i++) tabor_swap_destroy(session.swaps[i]);
  free(session.saved);
  return 0;
}
