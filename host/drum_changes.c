/* SPDX-License-Identifier: MIT */
#include "drum_changes.h"

#include <math.h>
#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "drum_source.h"
#include "live_headroom.h"

/* A swap on its way, with the model that it leaves. */
typedef struct Pending {
  TaborSwap *swap;
  TaborModel *old_model;
  struct Pending *next;
} Pending;

struct DrumChanges {
  TaborModelOptions options;
  uint32_t channels;
  uint32_t mics[TABOR_MAX_MICS]; /* as the user chose them, */
  TaborDrumDef first;            /* of this drum */
  bool waits;
  Player *player;
  TaborDrum *drum;

  /* under lock */
  pthread_mutex_t lock;
  pthread_cond_t changed;
  TaborDrumDef wanted;
  char preset[TABOR_TEXT_SIZE], built_preset[TABOR_TEXT_SIZE];
  uint64_t frame;              /* for the newest request */
  uint64_t requests, answered; /* numbers of the newest request, and of the newest that was built */
  uint64_t presets,
    built_presets; /* how many have been wished for, and how many by the newest that was built */
  bool stops, has_thread;

  /* the builder's; if sound waits, under lock */
  pthread_t thread;
  TaborModel *model; /* the newest, which the drum has or will have */
  Pending *pending;
};

/* ---- the drum to begin with ------------------------------------------------------------------ */

static Outcome build(const TaborModelOptions *options, const TaborDrumDef *def,
                     TaborModel **model) {
  TaborError error;
  if (tabor_model_create(def, options, model, &error) == TABOR_OK) return OUTCOME_OK;
  return report_engine_error(&error);
}

Outcome drum_changes_create(const DrumChangesSetup *setup, DrumChanges **created) {
  DrumChanges *const changes = calloc(1, sizeof *changes);
  TaborError error;
  *created = changes;
  if (!changes) return fail_memory();
  (void)pthread_mutex_init(&changes->lock, NULL);
  (void)pthread_cond_init(&changes->changed, NULL);
  changes->options = setup->options;
  changes->channels = setup->channels;
  memcpy(changes->mics, setup->mics, sizeof changes->mics);
  changes->first = changes->wanted = *setup->def;
  changes->waits = setup->waits;
  (void)snprintf(changes->preset, sizeof changes->preset, "%s", setup->preset);
  memcpy(changes->built_preset, changes->preset, sizeof changes->preset);
  const Outcome outcome = build(&changes->options, &changes->wanted, &changes->model);
  if (outcome != OUTCOME_OK) return outcome;
  if (tabor_drum_create(changes->model, &changes->drum, &error) == TABOR_OK) return OUTCOME_OK;
  return report_engine_error(&error);
}

TaborDrum *drum_changes_drum(const DrumChanges *changes) { return changes->drum; }

/* ---- live keys ------------------------------------------------------------------------------ */

static double number_of(const TaborDrumDef *def, const char *key) {
  static const NumberField any = {"value", -1e300, 1e300, false};
  char text[TABOR_NAME_SIZE];
  double value = 0;
  if (tabor_drum_def_get(def, key, text, sizeof text, NULL) != TABOR_OK) return NAN;
  return number_read(&any, text, &value) == OUTCOME_OK ? value : NAN;
}

/* "top" of "mic.top.gain"; the microphone's index, else 0. */
static uint32_t mic_of(const TaborDrumDef *def, const char *key) {
  char name[2 * TABOR_NAME_SIZE];
  if (sscanf(key, "mic.%127[^.]", name) != 1) return 0;
  const int mic = tabor_drum_def_find_mic(def, name);
  return mic > 0 ? (uint32_t)mic : 0;
}

/* Under lock: one thread at a time sends as SOURCE_CHANGES. */
static void send_live(DrumChanges *changes, uint64_t frame, const TaborParameter *parameter,
                      const char *key) {
  const PlayerMessage message = {
    .frame = frame,
    .type = PLAYER_EVENT,
    .event = {.type = TABOR_EVENT_PARAMETER,
              .parameter = parameter->id,
              .index = mic_of(&changes->wanted, key),
              .value = number_of(&changes->wanted, key)},
  };
  (void)player_send(changes->player, SOURCE_CHANGES, &message);
}

/* The wires' grid is made for values not far above those of its model. */
static bool outgrows(const DrumChanges *changes, const char *key) {
  if (strcmp(key, "wires.tension") != 0 && strcmp(key, "wires.damping_1") != 0) return false;
  const double built = number_of(tabor_model_definition(changes->model), key);
  return number_of(&changes->wanted, key) > LIVE_HEADROOM * built;
}

/* What was moved while the model was being built is moved on the new one, too. */
static void resend_live(DrumChanges *changes, const TaborDrumDef *built) {
  char key[2 * TABOR_NAME_SIZE];
  for (uint32_t i = 0; tabor_drum_def_key(&changes->wanted, i, key, sizeof key); i++) {
    const TaborParameter *const parameter = tabor_parameter_find(key);
    if (!parameter || !parameter->live) continue;
    if (number_of(&changes->wanted, key) == number_of(built, key)) continue;
    send_live(changes, PLAYER_NOW, parameter, key);
  }
}

/* ---- swaps ---------------------------------------------------------------------------------- */

static void free_pending(Pending *pending) {
  tabor_swap_destroy(pending->swap);
  tabor_model_release(pending->old_model);
  free(pending);
}

/* Frees what the audio thread has done with; those at the list's end are the oldest. */
static void reap(DrumChanges *changes) {
  Pending **link = &changes->pending;
  while (*link && !tabor_swap_done((*link)->swap)) link = &(*link)->next;
  while (*link) {
    Pending *const done = *link;
    *link = done->next;
    free_pending(done);
  }
}

/* As the user chose them, on this drum. */
static void choose_mics(const DrumChanges *changes, const TaborDrumDef *def, uint8_t *mics) {
  for (uint32_t i = 0; i < changes->channels; i++) {
    mics[i] = (uint8_t)drum_same_mic(&changes->first, changes->mics[i], def);
  }
}

/* Sends the swap to @p model, which becomes the newest; takes @p model over. */
static Outcome send_swap(DrumChanges *changes, TaborModel *model, uint64_t frame,
                         bool begins_anew) {
  PlayerMessage message = {.frame = frame,
                           .type = PLAYER_SWAP,
                           .begins_anew = begins_anew,
                           .event = {.type = TABOR_EVENT_SWAP}};
  Pending *const pending = calloc(1, sizeof *pending);
  TaborError error = {.status = TABOR_ERROR_MEMORY, .message = "out of memory"};
  if (!pending || tabor_swap_create(changes->model, model, &pending->swap, &error) != TABOR_OK) {
    free(pending);
    tabor_model_release(model);
    return report_engine_error(&error);
  }
  *pending = (Pending){pending->swap, changes->model, changes->pending};
  changes->pending = pending;
  changes->model = model;
  message.event.swap = pending->swap;
  message.strikers = tabor_model_definition(model)->striker_count;
  choose_mics(changes, tabor_model_definition(model), message.mics);
  (void)player_send(changes->player, SOURCE_SWAPS, &message); /* few: there is always room */
  return OUTCOME_OK;
}

/* ---- the builder ---------------------------------------------------------------------------- */

static void pause_for_swap(void) {
  const struct timespec moment = {.tv_nsec = 5000000};
  (void)nanosleep(&moment, NULL);
}

/* A swap acts on the drum of the model that it was made for, so each waits for the one before. */
static void wait_for_swap(DrumChanges *changes) {
  bool stops = false;
  for (reap(changes); changes->pending && !stops; reap(changes)) {
    (void)pthread_mutex_unlock(&changes->lock);
    pause_for_swap();
    (void)pthread_mutex_lock(&changes->lock);
    stops = changes->stops;
  }
}

/* What cannot be built is not wanted any more, unless something else is already. */
static void forget_request(DrumChanges *changes, uint64_t request) {
  if (changes->requests != request) return;
  changes->wanted = *tabor_model_definition(changes->model);
  memcpy(changes->preset, changes->built_preset, sizeof changes->preset);
}

/* Under lock, which is left while the model is built. */
static void answer(DrumChanges *changes) {
  const TaborDrumDef def = changes->wanted;
  const TaborModelOptions options = changes->options;
  const uint64_t request = changes->requests, frame = changes->frame, presets = changes->presets;
  char preset[TABOR_TEXT_SIZE];
  TaborModel *model = NULL;
  memcpy(preset, changes->preset, sizeof preset);
  if (!changes->waits) (void)pthread_mutex_unlock(&changes->lock);
  Outcome outcome = build(&options, &def, &model);
  if (!changes->waits) (void)pthread_mutex_lock(&changes->lock);
  const bool begins_anew = presets != changes->built_presets;
  if (outcome == OUTCOME_OK) outcome = send_swap(changes, model, frame, begins_anew);
  changes->answered = request;
  if (outcome != OUTCOME_OK) {
    forget_request(changes, request);
    return;
  }
  memcpy(changes->built_preset, preset, sizeof preset);
  changes->built_presets = presets;
  if (changes->waits) return;
  wait_for_swap(changes);
  if (changes->presets == presets)
    resend_live(changes, &def); /* not what another one begins with */
}

static void *build_requests(void *context) {
  DrumChanges *const changes = context;
  (void)pthread_mutex_lock(&changes->lock);
  while (!changes->stops) {
    if (changes->answered == changes->requests) {
      (void)pthread_cond_wait(&changes->changed, &changes->lock);
    } else {
      answer(changes);
    }
  }
  (void)pthread_mutex_unlock(&changes->lock);
  return NULL;
}

Outcome drum_changes_start(DrumChanges *changes, Player *player) {
  changes->player = player;
  if (changes->waits) return OUTCOME_OK;
  changes->has_thread = pthread_create(&changes->thread, NULL, build_requests, changes) == 0;
  return changes->has_thread ? OUTCOME_OK : fail("cannot start a thread for changes of the drum");
}

void drum_changes_stop(DrumChanges *changes) {
  if (!changes) return;
  (void)pthread_mutex_lock(&changes->lock);
  changes->stops = true;
  (void)pthread_cond_signal(&changes->changed);
  (void)pthread_mutex_unlock(&changes->lock);
  if (changes->has_thread) (void)pthread_join(changes->thread, NULL);
  changes->has_thread = false;
}

void drum_changes_destroy(DrumChanges *changes) {
  if (!changes) return;
  tabor_drum_destroy(changes->drum); /* before a swap that may still fade in it */
  while (changes->pending) {
    Pending *const pending = changes->pending;
    changes->pending = pending->next;
    free_pending(pending);
  }
  tabor_model_release(changes->model);
  (void)pthread_cond_destroy(&changes->changed);
  (void)pthread_mutex_destroy(&changes->lock);
  free(changes);
}

/* ---- requests ------------------------------------------------------------------------------- */

/* Under lock: the definition that is wanted has changed in more than live keys. */
static void request(DrumChanges *changes, uint64_t frame) {
  changes->frame = frame;
  changes->requests++;
  if (changes->waits) {
    reap(changes);
    answer(changes);
  } else {
    (void)pthread_cond_signal(&changes->changed);
  }
}

Outcome drum_changes_set(DrumChanges *changes, uint64_t frame, const char *what, const char *key,
                         const char *value) {
  (void)pthread_mutex_lock(&changes->lock);
  TaborDrumDef def = changes->wanted;
  const Outcome outcome = changes->stops ? OUTCOME_FAILED : drum_set(&def, what, key, value);
  if (outcome == OUTCOME_OK) {
    const TaborParameter *const parameter = tabor_parameter_find(key);
    const bool live = parameter && parameter->live;
    changes->wanted = def;
    if (strcmp(key, "quality.level") == 0) changes->options.quality = def.quality.level;
    if (live) send_live(changes, frame, parameter, key);
    if (!live || outgrows(changes, key)) request(changes, frame);
  }
  (void)pthread_mutex_unlock(&changes->lock);
  return outcome;
}

Outcome drum_changes_preset(DrumChanges *changes, uint64_t frame, const char *preset) {
  TaborDrumDef def;
  Outcome outcome = drum_load_preset(preset, &def);
  if (outcome == OUTCOME_OK && def.mic_count == 0) {
    outcome = refuse("'%s' has no microphone", preset);
  }
  if (outcome != OUTCOME_OK) return outcome;
  (void)pthread_mutex_lock(&changes->lock);
  changes->wanted = def;
  changes->presets++;
  (void)snprintf(changes->preset, sizeof changes->preset, "%s", preset);
  if (!changes->stops) request(changes, frame);
  (void)pthread_mutex_unlock(&changes->lock);
  return outcome;
}

/* Place of a preset in the list; -1 for a file. */
static int place_of(const char *name) {
  for (uint32_t i = 0; i < tabor_preset_count(); i++) {
    if (strcmp(tabor_preset(i)->name, name) == 0) return (int)i;
  }
  return -1;
}

Outcome drum_changes_step_preset(DrumChanges *changes, uint64_t frame, int step) {
  const int count = (int)tabor_preset_count();
  (void)pthread_mutex_lock(&changes->lock);
  const int place = place_of(changes->preset);
  (void)pthread_mutex_unlock(&changes->lock);
  const int from = place < 0 && step < 0 ? 0 : place;
  const int next = ((from + step) % count + count) % count;
  return drum_changes_preset(changes, frame, tabor_preset((uint32_t)next)->name);
}

void drum_changes_definition(DrumChanges *changes, TaborDrumDef *def) {
  (void)pthread_mutex_lock(&changes->lock);
  *def = changes->wanted;
  (void)pthread_mutex_unlock(&changes->lock);
}

void drum_changes_status(DrumChanges *changes, PlayStatus *status) {
  (void)pthread_mutex_lock(&changes->lock);
  (void)snprintf(status->preset, sizeof status->preset, "%s", changes->preset);
  status->building = changes->answered != changes->requests;
  status->quality = changes->options.quality;
  (void)pthread_mutex_unlock(&changes->lock);
}
