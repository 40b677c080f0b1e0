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
#include "drums/model_build.h"
#include "kit/kit_build.h"

/* A swap on its way. */
typedef struct Pending {
  TaborSwap *swap;
  struct Pending *next;
} Pending;

struct ModelBuilder {
  TaborModelOptions options;
  TaborDrumDef first; /* whose microphones the outputs are */
  TaborKitDef *kit;   /* or NULL; the thread's, where drums are placed */
  uint32_t drum;      /* of the kit, else 0 */
  bool waits;
  Player *player;
  pthread_mutex_t *sending; /* or NULL */
  LogWriter *log;           /* or NULL */

  /* under lock */
  pthread_mutex_t lock;
  pthread_cond_t changed;
  TaborDrumDef wanted, built; /* in a kit before the drum is placed in it */
  DrumHistory history;        /* of wanted, since its preset was chosen */
  char preset[TABOR_TEXT_SIZE], built_preset[TABOR_TEXT_SIZE];
  uint64_t frame;              /* for the newest request */
  uint64_t requests, answered; /* numbers of the newest request, and of the newest that was built */
  uint64_t presets,
    built_presets; /* how many have been wished for, and how many by the newest that was built */
  bool is_listed;  /* what is wanted is a built-in preset; nothing was set since */
  bool stops, has_thread;

  /* the thread's; if sound waits, under lock */
  pthread_t thread;
  TaborModel *model; /* the newest, which the drum has or will have */
  Pending *pending;
};

/* ---- the drum to begin with ------------------------------------------------------------------ */

static Outcome copy_kit(ModelBuilder *builder, const TaborKitDef *kit) {
  if (!kit) return OUTCOME_OK;
  builder->kit = malloc(sizeof *builder->kit);
  if (!builder->kit) return fail_memory();
  *builder->kit = *kit;
  return OUTCOME_OK;
}

Outcome model_builder_create(const ModelBuilderSetup *setup, ModelBuilder **created) {
  ModelBuilder *const builder = calloc(1, sizeof *builder);
  *created = builder;
  if (!builder) return fail_memory();
  (void)pthread_mutex_init(&builder->lock, NULL);
  (void)pthread_cond_init(&builder->changed, NULL);
  builder->options = setup->options;
  builder->first = builder->wanted = builder->built = *setup->def;
  builder->drum = setup->drum;
  builder->sending = setup->sending;
  builder->waits = setup->waits;
  builder->is_listed = setup->is_listed;
  (void)snprintf(builder->preset, sizeof builder->preset, "%s", setup->preset);
  memcpy(builder->built_preset, builder->preset, sizeof builder->preset);
  builder->model = setup->model;
  tabor_model_retain(builder->model);
  return copy_kit(builder, setup->kit);
}

/* ---- messages -------------------------------------------------------------------------------- */

static void send(ModelBuilder *builder, PlayerSource source, const PlayerMessage *message) {
  if (builder->sending) (void)pthread_mutex_lock(builder->sending);
  (void)player_send(builder->player, source, message);
  if (builder->sending) (void)pthread_mutex_unlock(builder->sending);
}

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
static void send_live(ModelBuilder *builder, uint64_t frame, const TaborParameter *parameter,
                      const char *key) {
  const PlayerMessage message = {
    .frame = frame,
    .type = PLAYER_EVENT,
    .drum = builder->drum,
    .event = {.type = TABOR_EVENT_PARAMETER,
              .parameter = parameter->id,
              .index = mic_of(tabor_model_definition(builder->model), key),
              .value = number_of(&builder->wanted, key)},
  };
  send(builder, SOURCE_CHANGES, &message);
}

/* The wires' grid is made for values not far above those of its model. */
static bool outgrows(const ModelBuilder *builder, const char *key) {
  if (strcmp(key, "wires.tension") != 0 && strcmp(key, "wires.damping_1") != 0) return false;
  const double built = number_of(tabor_model_definition(builder->model), key);
  return number_of(&builder->wanted, key) > LIVE_HEADROOM * built;
}

/* What was moved while the model was being built is moved on the new one, too. */
static void resend_live(ModelBuilder *builder, const TaborDrumDef *built) {
  char key[2 * TABOR_NAME_SIZE];
  for (uint32_t i = 0; tabor_drum_def_key(&builder->wanted, i, key, sizeof key); i++) {
    const TaborParameter *const parameter = tabor_parameter_find(key);
    if (!parameter || !parameter->live) continue;
    if (number_of(&builder->wanted, key) == number_of(built, key)) continue;
    send_live(builder, PLAYER_NOW, parameter, key);
  }
}

/* ---- swaps ------------------------------------------------------------------------ */

static void free_pending(Pending *pending) {
  tabor_swap_destroy(pending->swap);
  free(pending);
}

/* Frees what the audio thread has done with. */
static void reap(ModelBuilder *builder) {
  Pending **link = &builder->pending;
  while (*link) {
    Pending *const pending = *link;
    if (!tabor_swap_done(pending->swap)) {
      link = &pending->next;
      continue;
    }
    *link = pending->next;
    free_pending(pending);
  }
}

static Outcome prepare_swap(ModelBuilder *builder, TaborModel *model, TaborSwap **swap) {
  Pending *const pending = calloc(1, sizeof *pending);
  TaborError error;
  if (!pending) return fail_memory();
  if (tabor_swap_create(builder->model, model, &pending->swap, &error) != TABOR_OK) {
    free(pending);
    return report_engine_error(&error);
  }
  if (!builder->kit) drum_keep_mics(&builder->first, model, pending->swap);
  pending->next = builder->pending;
  builder->pending = pending;
  *swap = pending->swap;
  return OUTCOME_OK;
}

/* Sends the swap to @p model, which becomes the newest; takes @p model over. */
static Outcome send_model(ModelBuilder *builder, TaborModel *model, const char *preset,
                          uint64_t frame, bool begins_anew) {
  const TaborDrumDef *const def = tabor_model_definition(model);
  PlayerMessage message = {.frame = frame,
                           .type = PLAYER_MODEL,
                           .drum = builder->drum,
                           .strikers = def->striker_count,
                           .event = {.type = begins_anew ? TABOR_EVENT_REPLACE : TABOR_EVENT_SWAP}};
  const Outcome outcome = prepare_swap(builder, model, &message.event.swap);
  TaborModel *const unused = outcome == OUTCOME_OK ? builder->model : model;
  if (outcome == OUTCOME_OK) {
    builder->model = model;
    message.model = log_writer_add_model(builder->log, model, preset);
    send(builder, SOURCE_SWAPS, &message); /* few: there is always room */
  }
  tabor_model_release(unused); /* drum and swaps keep their own references */
  return outcome;
}

/* ---- the thread ----------------------------------------------------------------------------- */

static void pause_for_change(void) {
  const struct timespec moment = {.tv_nsec = 5000000};
  (void)nanosleep(&moment, NULL);
}

/* One change after the other: each waits until what was there before is done with. */
static void wait_for_change(ModelBuilder *builder) {
  bool stops = false;
  for (reap(builder); builder->pending && !stops; reap(builder)) {
    (void)pthread_mutex_unlock(&builder->lock);
    pause_for_change();
    (void)pthread_mutex_lock(&builder->lock);
    stops = builder->stops;
  }
}

/* What cannot be built is not wanted any more, unless something else is already. */
static void forget_request(ModelBuilder *builder, uint64_t request) {
  if (builder->requests != request) return;
  builder->wanted = builder->built;
  builder->is_listed = false;
  memcpy(builder->preset, builder->built_preset, sizeof builder->preset);
}

/* A kit's drum is built as it stands in the kit. */
static Outcome build(ModelBuilder *builder, const TaborDrumDef *def,
                     const TaborModelOptions *options, TaborModel **model) {
  TaborDrumDef placed = *def;
  TaborError error;
  if (builder->kit) {
    TaborKitDrumDef *const drum = &builder->kit->drum[builder->drum];
    const TaborKitDrumDef before = *drum;
    drum->def = *def;
    kit_fit_mic(drum);
    const TaborStatus status = tabor_kit_def_place(builder->kit, builder->drum, &placed, &error);
    *drum = before;
    if (status != TABOR_OK) return report_engine_error(&error);
  }
  return model_build_quietly(&placed, options, model);
}

/* Under lock, which is left while the model is built. */
static void answer(ModelBuilder *builder) {
  const TaborDrumDef def = builder->wanted;
  const TaborModelOptions options = builder->options;
  const uint64_t request = builder->requests, frame = builder->frame, presets = builder->presets;
  char preset[TABOR_TEXT_SIZE];
  TaborModel *model = NULL;
  memcpy(preset, builder->preset, sizeof preset);
  if (!builder->waits) (void)pthread_mutex_unlock(&builder->lock);
  Outcome outcome = build(builder, &def, &options, &model);
  if (!builder->waits) (void)pthread_mutex_lock(&builder->lock);
  const bool begins_anew = presets != builder->built_presets;
  if (outcome == OUTCOME_OK) outcome = send_model(builder, model, preset, frame, begins_anew);
  builder->answered = request;
  if (outcome != OUTCOME_OK) {
    forget_request(builder, request);
    return;
  }
  memcpy(builder->built_preset, preset, sizeof preset);
  builder->built = def;
  builder->built_presets = presets;
  if (builder->waits) return;
  wait_for_change(builder);
  if (builder->presets == presets)
    resend_live(builder, &def); /* not what another one begins with */
}

static void *build_requests(void *context) {
  ModelBuilder *const builder = context;
  (void)pthread_mutex_lock(&builder->lock);
  while (!builder->stops) {
    if (builder->answered == builder->requests) {
      (void)pthread_cond_wait(&builder->changed, &builder->lock);
    } else {
      answer(builder);
    }
  }
  (void)pthread_mutex_unlock(&builder->lock);
  return NULL;
}

void model_builder_log(ModelBuilder *builder, LogWriter *log) { builder->log = log; }

Outcome model_builder_start(ModelBuilder *builder, Player *player) {
  builder->player = player;
  if (builder->waits) return OUTCOME_OK;
  builder->has_thread = pthread_create(&builder->thread, NULL, build_requests, builder) == 0;
  return builder->has_thread ? OUTCOME_OK : fail("cannot start a thread for changes of the drum");
}

void model_builder_stop(ModelBuilder *builder) {
  if (!builder) return;
  (void)pthread_mutex_lock(&builder->lock);
  builder->stops = true;
  (void)pthread_cond_signal(&builder->changed);
  (void)pthread_mutex_unlock(&builder->lock);
  if (builder->has_thread) (void)pthread_join(builder->thread, NULL);
  builder->has_thread = false;
}

void model_builder_destroy(ModelBuilder *builder) {
  if (!builder) return;
  while (builder->pending) {
    Pending *const pending = builder->pending;
    builder->pending = pending->next;
    free_pending(pending);
  }
  tabor_model_release(builder->model);
  free(builder->kit);
  (void)pthread_cond_destroy(&builder->changed);
  (void)pthread_mutex_destroy(&builder->lock);
  free(builder);
}

/* ---- requests ------------------------------------------------------------------------------- */

/* Under lock: the definition that is wanted has changed in more than live keys. */
static void request(ModelBuilder *builder, uint64_t frame) {
  builder->frame = frame;
  builder->requests++;
  if (builder->waits) {
    reap(builder);
    answer(builder);
  } else {
    (void)pthread_cond_signal(&builder->changed);
  }
}

Outcome model_builder_set(ModelBuilder *builder, uint64_t frame, const char *what, const char *key,
                          const char *value) {
  if (strncmp(key, "room.", 5) == 0) {
    return refuse(
      "%s '%.80s': the room stays while the drum is played; start with --set %.80s=%.80s", what,
      key, key, value);
  }
  (void)pthread_mutex_lock(&builder->lock);
  TaborDrumDef def = builder->wanted;
  const Outcome outcome = builder->stops ? OUTCOME_FAILED : drum_set(&def, what, key, value);
  if (outcome == OUTCOME_OK) {
    const TaborParameter *const parameter = tabor_parameter_find(key);
    const bool live = parameter && parameter->live;
    const DrumState before = {builder->wanted, builder->options.quality};
    drum_history_add(&builder->history, key, &before);
    builder->wanted = def;
    builder->is_listed = false;
    if (strcmp(key, "quality.level") == 0) builder->options.quality = def.quality.level;
    if (live) send_live(builder, frame, parameter, key);
    if (!live || outgrows(builder, key)) request(builder, frame);
  }
  (void)pthread_mutex_unlock(&builder->lock);
  return outcome;
}

/* ---- undoing -------------------------------------------------------------------------------- */

/* "" if @p def has no such key. */
static void read_value(const TaborDrumDef *def, const char *key, char value[TABOR_TEXT_SIZE]) {
  if (tabor_drum_def_get(def, key, value, TABOR_TEXT_SIZE, NULL) != TABOR_OK) *value = '\0';
}

static bool is_same(const TaborDrumDef *a, const TaborDrumDef *b, const char *key) {
  char values[2][TABOR_TEXT_SIZE];
  read_value(a, key, values[0]);
  read_value(b, key, values[1]);
  return strcmp(values[0], values[1]) == 0;
}

/* Under lock. Moves what is live; true if the rest needs another model. */
static bool move_to(ModelBuilder *builder, uint64_t frame, const TaborDrumDef *def) {
  const TaborDrumDef before = builder->wanted;
  char key[DRUM_KEY_SIZE];
  bool rebuilds = false;
  builder->wanted = *def;
  for (uint32_t i = 0; tabor_drum_def_key(def, i, key, sizeof key); i++) {
    if (is_same(&before, def, key)) continue;
    const TaborParameter *const parameter = tabor_parameter_find(key);
    const bool live = parameter && parameter->live;
    if (live) send_live(builder, frame, parameter, key);
    if (!live || outgrows(builder, key)) rebuilds = true;
  }
  for (uint32_t i = 0; !rebuilds && tabor_drum_def_key(&before, i, key, sizeof key); i++) {
    rebuilds = !is_same(&before, def, key); /* it has gone */
  }
  return rebuilds;
}

/* Goes one step through the history, if there is one. */
static bool travel(ModelBuilder *builder, uint64_t frame, char key[DRUM_KEY_SIZE],
                   bool (*step)(DrumHistory *, DrumState *, char *)) {
  (void)pthread_mutex_lock(&builder->lock);
  DrumState state = {builder->wanted, builder->options.quality};
  const bool travels = !builder->stops && step(&builder->history, &state, key);
  if (travels) {
    const bool rebuilds = move_to(builder, frame, &state.def);
    const bool is_other_quality = builder->options.quality != state.quality;
    builder->is_listed = false;
    builder->options.quality = state.quality;
    if (rebuilds || is_other_quality) request(builder, frame);
  }
  (void)pthread_mutex_unlock(&builder->lock);
  return travels;
}

Outcome model_builder_undo(ModelBuilder *builder, uint64_t frame, char key[DRUM_KEY_SIZE]) {
  if (travel(builder, frame, key, drum_history_undo)) return OUTCOME_OK;
  return refuse("undo: nothing was set since this drum was chosen");
}

Outcome model_builder_redo(ModelBuilder *builder, uint64_t frame, char key[DRUM_KEY_SIZE]) {
  if (travel(builder, frame, key, drum_history_redo)) return OUTCOME_OK;
  return refuse("redo: nothing was undone since the last change");
}

/* ---- presets -------------------------------------------------------------------------------- */

/* A program change to the preset that is there already does nothing. */
static Outcome choose_preset(ModelBuilder *builder, uint64_t frame, const char *preset,
                             bool by_program) {
  TaborDrumDef def;
  Outcome outcome = drum_load_preset(preset, &def);
  if (outcome == OUTCOME_OK && def.mic_count == 0) {
    outcome = refuse("'%s' has no microphone", preset);
  }
  if (outcome != OUTCOME_OK) return outcome;
  (void)pthread_mutex_lock(&builder->lock);
  if (!(by_program && builder->is_listed && strcmp(builder->preset, preset) == 0)) {
    builder->wanted = def;
    builder->is_listed = preset_place(preset) >= 0;
    builder->presets++;
    drum_history_clear(&builder->history);
    (void)snprintf(builder->preset, sizeof builder->preset, "%s", preset);
    if (!builder->stops) request(builder, frame);
  }
  (void)pthread_mutex_unlock(&builder->lock);
  return outcome;
}

Outcome model_builder_preset(ModelBuilder *builder, uint64_t frame, const char *preset) {
  return choose_preset(builder, frame, preset, false);
}

Outcome model_builder_program(ModelBuilder *builder, uint64_t frame, const char *preset) {
  return choose_preset(builder, frame, preset, true);
}

Outcome model_builder_step_preset(ModelBuilder *builder, uint64_t frame, int step) {
  const int count = (int)tabor_preset_count();
  (void)pthread_mutex_lock(&builder->lock);
  const int place = preset_place(builder->preset);
  (void)pthread_mutex_unlock(&builder->lock);
  const int from = place < 0 && step < 0 ? 0 : place;
  const int next = ((from + step) % count + count) % count;
  return model_builder_preset(builder, frame, tabor_preset((uint32_t)next)->name);
}

void model_builder_definition(ModelBuilder *builder, TaborDrumDef *def) {
  (void)pthread_mutex_lock(&builder->lock);
  *def = builder->wanted;
  (void)pthread_mutex_unlock(&builder->lock);
}

void model_builder_status(ModelBuilder *builder, PlayStatus *status) {
  (void)pthread_mutex_lock(&builder->lock);
  (void)snprintf(status->preset, sizeof status->preset, "%s", builder->preset);
  status->building = builder->answered != builder->requests;
  status->quality = builder->options.quality;
  (void)pthread_mutex_unlock(&builder->lock);
}
