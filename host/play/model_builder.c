/* SPDX-License-Identifier: MIT */
#include "play/model_builder.h"

#include <math.h>
#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "drums/drum_args.h"
#include "drums/live_headroom.h"

/* A swap on its way. */
typedef struct Pending {
  TaborSwap *swap;
  struct Pending *next;
} Pending;

/* A drum that the player has, will have, or lets ring out. */
typedef struct SentDrum {
  TaborDrum *drum;
  struct SentDrum *next;
} SentDrum;

struct DrumChanges {
  TaborModelOptions options;
  uint32_t channels;
  uint32_t mics[TABOR_MAX_MICS]; /* as the user chose them, */
  TaborDrumDef first;            /* of this drum */
  bool waits;
  Player *player;

  /* under lock */
  pthread_mutex_t lock;
  pthread_cond_t changed;
  TaborDrumDef wanted;
  char preset[TABOR_TEXT_SIZE], built_preset[TABOR_TEXT_SIZE];
  uint64_t frame;              /* for the newest request */
  uint64_t requests, answered; /* numbers of the newest request, and of the newest that was built */
  uint64_t presets,
    built_presets; /* how many have been wished for, and how many by the newest that was built */
  bool is_listed;  /* what is wanted is a built-in preset; nothing was set since */
  bool stops, has_thread;

  /* the builder's; if sound waits, under lock */
  pthread_t thread;
  TaborModel *model; /* the newest, which the newest drum has or will have */
  SentDrum *drums;   /* the newest first */
  Pending *pending;
};

/* ---- the drum to begin with ------------------------------------------------------------------ */

static Outcome build(const TaborModelOptions *options, const TaborDrumDef *def,
                     TaborModel **model) {
  TaborError error;
  if (tabor_model_create(def, options, model, &error) == TABOR_OK) return OUTCOME_OK;
  return report_engine_error(&error);
}

static Outcome create_drum(DrumChanges *changes, TaborModel *model) {
  SentDrum *const sent = calloc(1, sizeof *sent);
  TaborError error;
  if (!sent) return fail_memory();
  if (tabor_drum_create(model, &sent->drum, &error) != TABOR_OK) {
    free(sent);
    return report_engine_error(&error);
  }
  sent->next = changes->drums;
  changes->drums = sent;
  return OUTCOME_OK;
}

Outcome drum_changes_create(const DrumChangesSetup *setup, DrumChanges **created) {
  DrumChanges *const changes = calloc(1, sizeof *changes);
  *created = changes;
  if (!changes) return fail_memory();
  (void)pthread_mutex_init(&changes->lock, NULL);
  (void)pthread_cond_init(&changes->changed, NULL);
  changes->options = setup->options;
  changes->channels = setup->channels;
  memcpy(changes->mics, setup->mics, sizeof changes->mics);
  changes->first = changes->wanted = *setup->def;
  changes->waits = setup->waits;
  changes->is_listed = setup->is_listed;
  (void)snprintf(changes->preset, sizeof changes->preset, "%s", setup->preset);
  memcpy(changes->built_preset, changes->preset, sizeof changes->preset);
  const Outcome outcome = build(&changes->options, &changes->wanted, &changes->model);
  return outcome == OUTCOME_OK ? create_drum(changes, changes->model) : outcome;
}

TaborDrum *drum_changes_drum(const DrumChanges *changes) { return changes->drums->drum; }

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

/* ---- swaps and drums ------------------------------------------------------------------------ */

static void free_pending(Pending *pending) {
  tabor_swap_destroy(pending->swap);
  free(pending);
}

static void free_drum(DrumChanges *changes, const TaborDrum *drum) {
  SentDrum **link = &changes->drums;
  while ((*link)->drum != drum) link = &(*link)->next;
  SentDrum *const sent = *link;
  *link = sent->next;
  tabor_drum_destroy(sent->drum);
  free(sent);
}

/* Frees what the audio thread has done with; swaps at the list's end are the oldest. */
static void reap(DrumChanges *changes) {
  const TaborDrum *gone;
  while ((gone = player_gone(changes->player)) != NULL) free_drum(changes, gone);
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

static Outcome prepare_swap(DrumChanges *changes, TaborModel *model, PlayerMessage *message) {
  Pending *const pending = calloc(1, sizeof *pending);
  TaborError error;
  if (!pending) return fail_memory();
  if (tabor_swap_create(changes->model, model, &pending->swap, &error) != TABOR_OK) {
    free(pending);
    return report_engine_error(&error);
  }
  pending->next = changes->pending;
  changes->pending = pending;
  message->type = PLAYER_SWAP;
  message->event.swap = pending->swap;
  return OUTCOME_OK;
}

static Outcome prepare_drum(DrumChanges *changes, TaborModel *model, PlayerMessage *message) {
  const Outcome outcome = create_drum(changes, model);
  message->type = PLAYER_DRUM;
  message->drum = changes->drums->drum;
  return outcome;
}

/* Sends a drum of @p model, or the swap to it, which becomes the newest; takes @p model over. */
static Outcome send_model(DrumChanges *changes, TaborModel *model, uint64_t frame,
                          bool begins_anew) {
  const TaborDrumDef *const def = tabor_model_definition(model);
  PlayerMessage message = {
    .frame = frame, .strikers = def->striker_count, .event = {.type = TABOR_EVENT_SWAP}};
  choose_mics(changes, def, message.mics);
  const Outcome outcome =
    begins_anew ? prepare_drum(changes, model, &message) : prepare_swap(changes, model, &message);
  TaborModel *const unused = outcome == OUTCOME_OK ? changes->model : model;
  if (outcome == OUTCOME_OK) {
    changes->model = model;
    (void)player_send(changes->player, SOURCE_SWAPS, &message); /* few: there is always room */
  }
  tabor_model_release(unused); /* drums and swaps keep their own references */
  return outcome;
}

/* ---- the builder ---------------------------------------------------------------------------- */

static void pause_for_change(void) {
  const struct timespec moment = {.tv_nsec = 5000000};
  (void)nanosleep(&moment, NULL);
}

static bool is_under_way(const DrumChanges *changes) {
  return changes->pending || changes->drums->next;
}

/* One change after the other: each waits until what was there before is done with. */
static void wait_for_change(DrumChanges *changes) {
  bool stops = false;
  for (reap(changes); is_under_way(changes) && !stops; reap(changes)) {
    (void)pthread_mutex_unlock(&changes->lock);
    pause_for_change();
    (void)pthread_mutex_lock(&changes->lock);
    stops = changes->stops;
  }
}

/* What cannot be built is not wanted any more, unless something else is already. */
static void forget_request(DrumChanges *changes, uint64_t request) {
  if (changes->requests != request) return;
  changes->wanted = *tabor_model_definition(changes->model);
  changes->is_listed = false;
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
  if (outcome == OUTCOME_OK) outcome = send_model(changes, model, frame, begins_anew);
  changes->answered = request;
  if (outcome != OUTCOME_OK) {
    forget_request(changes, request);
    return;
  }
  memcpy(changes->built_preset, preset, sizeof preset);
  changes->built_presets = presets;
  if (changes->waits) return;
  wait_for_change(changes);
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
  while (changes->drums)
    free_drum(changes, changes->drums->drum); /* before swaps that may still fade in them */
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
    changes->is_listed = false;
    if (strcmp(key, "quality.level") == 0) changes->options.quality = def.quality.level;
    if (live) send_live(changes, frame, parameter, key);
    if (!live || outgrows(changes, key)) request(changes, frame);
  }
  (void)pthread_mutex_unlock(&changes->lock);
  return outcome;
}

/* A program change to the preset that is there already does nothing. */
static Outcome choose_preset(DrumChanges *changes, uint64_t frame, const char *preset,
                             bool by_program) {
  TaborDrumDef def;
  Outcome outcome = drum_load_preset(preset, &def);
  if (outcome == OUTCOME_OK && def.mic_count == 0) {
    outcome = refuse("'%s' has no microphone", preset);
  }
  if (outcome != OUTCOME_OK) return outcome;
  (void)pthread_mutex_lock(&changes->lock);
  if (!(by_program && changes->is_listed && strcmp(changes->preset, preset) == 0)) {
    changes->wanted = def;
    changes->is_listed = preset_place(preset) >= 0;
    changes->presets++;
    (void)snprintf(changes->preset, sizeof changes->preset, "%s", preset);
    if (!changes->stops) request(changes, frame);
  }
  (void)pthread_mutex_unlock(&changes->lock);
  return outcome;
}

Outcome drum_changes_preset(DrumChanges *changes, uint64_t frame, const char *preset) {
  return choose_preset(changes, frame, preset, false);
}

Outcome drum_changes_program(DrumChanges *changes, uint64_t frame, const char *preset) {
  return choose_preset(changes, frame, preset, true);
}

Outcome drum_changes_step_preset(DrumChanges *changes, uint64_t frame, int step) {
  const int count = (int)tabor_preset_count();
  (void)pthread_mutex_lock(&changes->lock);
  const int place = preset_place(changes->preset);
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
