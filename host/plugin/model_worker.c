/* SPDX-License-Identifier: MIT */
#include "plugin/model_worker.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "plugin/model_cache.h"
#include "plugin/stick_choice.h"

/* ---- beginning and end ---------------------------------------------------------------------- */

bool model_worker_begin(ModelWorker *worker, double rate, bool stereo, BuilderSayFn *say,
                        void *context) {
  builder_begin(&worker->builder, rate, say, context);
  worker->stereo = stereo;
  worker->program = worker->composed_program = MODEL_WORKER_NO_PROGRAM;
  for (uint32_t i = 0; i < KNOB_SEEN; i++) worker->base_seen[i] = NAN;
  memcpy(worker->composed_seen, worker->base_seen, sizeof worker->base_seen);
  midi_map_default(&worker->map);
  if (tabor_drum_def_preset(&worker->base, DEFAULT_PRESET, NULL) != TABOR_OK) return false;
  worker->composed = worker->base;
  return pthread_mutex_init(&worker->lock, NULL) == 0;
}

/* The ones that no player needs, or all. */
static void free_rooms(ModelWorker *worker, bool all) {
  for (WorkerRoom **link = &worker->rooms; *link;) {
    WorkerRoom *const room = *link;
    if (!all && !atomic_load(&room->mix.is_left)) {
      link = &room->next;
      continue;
    }
    *link = room->next;
    room_mix_free(&room->mix);
    free(room);
  }
}

/* A reply that was not taken. */
static void destroy_offer(ModelWorker *worker) {
  if (!builder_is(&worker->builder, BUILDER_ANSWERED) || !worker->reply.is_news) return;
  tabor_drum_destroy(worker->reply.drum);
}

void model_worker_end(ModelWorker *worker) {
  destroy_offer(worker);
  free_rooms(worker, true);
  for (uint32_t i = 0; i < worker->swap_count; i++) tabor_swap_destroy(worker->swaps[i]);
  free(worker->swaps);
  model_cache_give_back(worker->model);
  (void)pthread_mutex_destroy(&worker->lock);
}

/* ---- saving and restoring ------------------------------------------------------------------- */

void model_worker_restore(ModelWorker *worker, const SavedState *saved) {
  (void)pthread_mutex_lock(&worker->lock);
  worker->base = saved->def;
  memcpy(worker->base_seen, saved->seen, sizeof worker->base_seen);
  atomic_fetch_add(&worker->restoration, 1);
  (void)pthread_mutex_unlock(&worker->lock);
}

static void forget_ports(float *seen) {
  for (uint32_t i = 0; i < KNOB_SEEN; i++) seen[i] = NAN;
}

/* What was restored, or chosen by MIDI, and is not built yet, counts as much as what is. */
void model_worker_save(ModelWorker *worker, SavedState *saved) {
  (void)pthread_mutex_lock(&worker->lock);
  const int program = atomic_load(&worker->program);
  if (worker->composed_restoration != atomic_load(&worker->restoration)) {
    saved->def = worker->base;
    memcpy(saved->seen, worker->base_seen, sizeof saved->seen);
  } else if (program >= 0 && program != worker->composed_program) {
    (void)tabor_drum_def_preset(&saved->def, tabor_preset((uint32_t)program)->name, NULL);
    forget_ports(saved->seen);
  } else {
    saved->def = worker->composed;
    memcpy(saved->seen, worker->composed_seen, sizeof saved->seen);
  }
  (void)pthread_mutex_unlock(&worker->lock);
}

/* ---- what is asked for --------------------------------------------------------------------- */

static void turn_knobs(const Request *request, TaborDrumDef *def) {
  for (uint32_t i = 0; i < KNOB_KEYS; i++)
    if (request->turns[i].is_turned) knob_give(def, (KnobId)i, request->turns[i].value);
}

/* Under lock. A restoration that the request does not know of yet takes the place of all it says.
 */
static void compose(ModelWorker *worker, Reply *reply) {
  const Request *const request = &worker->request;
  TaborDrumDef *const def = &worker->composed;
  reply->restoration = atomic_load(&worker->restoration);
  reply->program = request->program;
  memcpy(reply->seen, request->seen, sizeof reply->seen);
  *def = worker->base;
  if (reply->restoration != request->restoration) {
    reply->program = MODEL_WORKER_NO_PROGRAM;
    memcpy(reply->seen, worker->base_seen, sizeof reply->seen);
  } else {
    if (request->program >= 0) {
      (void)tabor_drum_def_preset(def, tabor_preset((uint32_t)request->program)->name, NULL);
    }
    turn_knobs(request, def);
  }
  worker->composed_restoration = reply->restoration;
  worker->composed_program = reply->program;
  memcpy(worker->composed_seen, reply->seen, sizeof reply->seen);
}

/* A pitch that was turned where the head cannot follow becomes the nearest that it can have. One
 * that the drum was saved with is passed over, as ever. */
static double nearest_pitch(const ModelWorker *worker, const Reply *reply, KnobId id,
                            const TaborError *error) {
  const KnobTurn turn = worker->request.turns[id];
  const bool is_turned = reply->restoration == worker->request.restoration && turn.is_turned;
  if (!is_turned || !isnan(reply->given[id])) return 0;
  return fmin(fmax(turn.value, error->minimum), error->maximum);
}

/* Tensions for pitches. */
static void tune(const ModelWorker *worker, Reply *reply) {
  TaborError error;
  while (tabor_drum_def_tune(&reply->def, &error) != TABOR_OK) {
    const KnobId id = knob_of_refused_pitch(&error);
    if (id == KNOB_COUNT) return; /* building the model refuses it */
    const double pitch = nearest_pitch(worker, reply, id, &error);
    *knob_field(&reply->def, id) = pitch;
    if (pitch > 0) reply->given[id] = (float)pitch;
    builder_say(&worker->builder,
                pitch > 0 ? "the nearest pitch plays" : "the head keeps its tension", &error);
  }
}

/* What the model is built from: where MIDI has moved it, too, with the stick that was chosen, and
 * with tensions for pitches. What is saved has the drum's own stick, and its pitches, so that these
 * are there when a choice is taken back. */
static void compose_model(const ModelWorker *worker, Reply *reply) {
  const Request *const request = &worker->request;
  TaborDrumDef *const def = &reply->def;
  if (reply->restoration == request->restoration) {
    const KnobTurn strainer = request->strainer, grip = request->grip;
    if (strainer.is_turned) knob_give(def, KNOB_STRAINER, strainer.value);
    if (grip.is_turned) def->hand.grip = fmin(fmax(grip.value, 0), 1);
  }
  stick_choice_take(request->stick, def);
  for (uint32_t i = 0; i < KNOB_KEYS; i++) reply->given[i] = NAN;
  tune(worker, reply);
}

/* What the audio thread has to know of the model. */
static void describe(Reply *reply) {
  for (uint32_t i = 0; i < KNOB_KEYS; i++) {
    const double *const field = knob_field(&reply->def, (KnobId)i);
    reply->built[i] = field ? *field : NAN;
  }
}

/* ---- models --------------------------------------------------------------------------------- */

/* Those that the drum is done with make room. */
static void discard_done(ModelWorker *worker) {
  uint32_t kept = 0;
  for (uint32_t i = 0; i < worker->swap_count; i++) {
    TaborSwap *const swap = worker->swaps[i];
    if (tabor_swap_done(swap)) {
      tabor_swap_destroy(swap);
    } else {
      worker->swaps[kept++] = swap;
    }
  }
  worker->swap_count = kept;
}

static TaborStatus keep(ModelWorker *worker, TaborSwap *swap) {
  if (worker->swap_count == worker->swap_room) {
    const uint32_t room = worker->swap_room + 4;
    TaborSwap **const grown = realloc(worker->swaps, room * sizeof(TaborSwap *));
    if (!grown) return TABOR_ERROR_MEMORY;
    worker->swaps = grown;
    worker->swap_room = room;
  }
  worker->swaps[worker->swap_count++] = swap;
  return TABOR_OK;
}

static bool was_chosen(const ModelWorker *worker) {
  return worker->request.choice != worker->built_choice;
}

static bool begins_anew(const ModelWorker *worker, const Reply *reply) {
  return !worker->model || reply->restoration != worker->built_restoration || was_chosen(worker);
}

/* The model's microphone for each of the plugins', by name. */
static void choose_mics(const ModelWorker *worker, const TaborDrumDef *def, uint8_t *mics) {
  static const struct {
    const char *name;
    bool of_pair;
  } wanted[MODEL_WORKER_MICS] = {{"top", false},   {"bottom", false}, {"near", false},
                                 {"far", false},   {"left", true},    {"right", true},
                                 {"inside", false}};
  for (uint32_t i = 0; i < MODEL_WORKER_MICS; i++) {
    const int mic = tabor_drum_def_find_mic(def, wanted[i].name);
    const bool may_replace = worker->stereo && wanted[i].of_pair;
    mics[i] = mic >= 0 ? (uint8_t)mic : may_replace ? 0 : (uint8_t)UINT8_MAX; /* it has none */
  }
}

/* The drum, or the way from the model before. */
static TaborStatus prepare(ModelWorker *worker, TaborModel *model, Reply *reply,
                           TaborError *error) {
  if (worker->model == model && !was_chosen(worker)) return TABOR_OK; /* though restored */
  uint8_t mics[MODEL_WORKER_MICS];
  choose_mics(worker, &reply->def, mics);
  if (!worker->model) {
    const TaborStatus status = tabor_drum_create(model, &reply->drum, error);
    if (status == TABOR_OK) tabor_drum_route(reply->drum, mics, MODEL_WORKER_MICS);
    return status;
  }
  const TaborStatus status = tabor_swap_create(worker->model, model, &reply->swap, error);
  if (status != TABOR_OK) return status;
  tabor_swap_route(reply->swap, mics, MODEL_WORKER_MICS);
  if (keep(worker, reply->swap) == TABOR_OK) return TABOR_OK;
  tabor_swap_destroy(reply->swap);
  return builder_out_of_memory(error);
}

/* ---- the room ------------------------------------------------------------------------------- */

/* Padding that differs costs a fade from one room to another one like it. */
static bool same_room(const TaborDrumDef *a, const TaborDrumDef *b) {
  return memcmp(&a->room, &b->room, sizeof a->room) == 0 &&
         memcmp(&a->air, &b->air, sizeof a->air) == 0 &&
         memcmp(&a->shell, &b->shell, sizeof a->shell) == 0 && a->mic_count == b->mic_count &&
         memcmp(a->mic, b->mic, a->mic_count * sizeof a->mic[0]) == 0;
}

/* A preset chosen by MIDI comes into the room that is there, as in a rendering. */
static TaborStatus build_room(ModelWorker *worker, Reply *reply, bool chosen, TaborError *error) {
  uint8_t mics[MODEL_WORKER_MICS];
  TaborDrumDef def = reply->def;
  if (worker->stereo) def.room.kind = worker->request.room;
  const bool keeps = chosen && worker->request.keeps_room;
  if (worker->rooms && (keeps || same_room(&worker->rooms->def, &def))) return TABOR_OK;
  WorkerRoom *const room = calloc(1, sizeof *room);
  if (!room) return builder_out_of_memory(error);
  choose_mics(worker, &def, mics);
  room->def = def;
  const TaborStatus status = room_mix_create(&room->mix, &def, worker->builder.options.sample_rate,
                                             mics, MODEL_WORKER_MICS, error);
  if (status != TABOR_OK) {
    room_mix_free(&room->mix);
    free(room);
    return status;
  }
  room->next = worker->rooms;
  worker->rooms = room;
  reply->room = &room->mix;
  return TABOR_OK;
}

static void set_model(ModelWorker *worker, TaborModel *model) {
  (void)pthread_mutex_lock(&worker->lock);
  worker->model = model;
  (void)pthread_mutex_unlock(&worker->lock);
}

TaborModel *model_worker_model(ModelWorker *worker) {
  (void)pthread_mutex_lock(&worker->lock);
  TaborModel *const model = worker->model ? tabor_model_retain(worker->model) : NULL;
  (void)pthread_mutex_unlock(&worker->lock);
  return model;
}

static TaborStatus build(ModelWorker *worker, Reply *reply, TaborError *error) {
  TaborModel *model = NULL;
  TaborStatus status =
    builder_model(&worker->builder, &reply->def, worker->request.quality, &model, error);
  if (status != TABOR_OK) return status;
  reply->begins_anew = begins_anew(worker, reply);
  status = prepare(worker, model, reply, error);
  TaborModel *const unused = status == TABOR_OK ? worker->model : model;
  if (status == TABOR_OK) {
    set_model(worker, model);
    worker->built_restoration = reply->restoration;
    worker->built_choice = worker->request.choice;
  }
  model_cache_give_back(unused);
  return status;
}

/* Composes anew in any case, so that what is saved is not much older than the knobs. */
static void answer(ModelWorker *worker) {
  Reply *const reply = &worker->reply;
  TaborError error;
  const uint32_t number = reply->number, restoration = reply->restoration;
  discard_done(worker);
  free_rooms(worker, false);
  reply->drum = NULL;
  reply->swap = NULL;
  reply->room = NULL;
  reply->cancelled = false;
  reply->number = worker->request.number;
  TaborDrumDef composed;
  (void)pthread_mutex_lock(&worker->lock);
  compose(worker, reply);
  composed = worker->composed;
  (void)pthread_mutex_unlock(&worker->lock);
  reply->is_news = reply->number != number || reply->restoration != restoration;
  if (!reply->is_news) return;
  if (worker->request.is_held) builder_say_held(&worker->builder);
  reply->def = composed;
  midi_binding_make(&worker->map, &reply->def, &reply->binding);
  compose_model(worker, reply);
  describe(reply);
  const bool chosen = was_chosen(worker);
  const TaborStatus status = build(worker, reply, &error);
  reply->failed = status != TABOR_OK;
  reply->cancelled = status == TABOR_ERROR_CANCELLED;
  if (reply->cancelled) { /* it will be news again */
    reply->number = number;
    reply->restoration = restoration;
    return;
  }
  if (reply->failed) builder_say(&worker->builder, "the drum stays as it is", &error);
  if (!reply->failed && build_room(worker, reply, chosen, &error) != TABOR_OK) {
    builder_say(&worker->builder, "the room stays as it is", &error);
  }
}

void model_worker_work(ModelWorker *worker) {
  if (!builder_take(&worker->builder)) return;
  answer(worker);
  builder_answer(&worker->builder);
}

/* ---- the audio thread's --------------------------------------------------------------------- */

void model_worker_ask(ModelWorker *worker, const Request *request) {
  worker->request = *request;
  builder_ask(&worker->builder);
}

const Reply *model_worker_reply(const ModelWorker *worker) {
  return builder_is(&worker->builder, BUILDER_ANSWERED) ? &worker->reply : NULL;
}
