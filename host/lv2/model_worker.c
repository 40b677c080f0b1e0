/* SPDX-License-Identifier: MIT */
#include "lv2/model_worker.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "lv2/model_cache.h"

/* ---- beginning and end ---------------------------------------------------------------------- */

bool workshop_begin(Workshop *workshop, double rate) {
  tabor_model_options_default(&workshop->options);
  workshop->options.sample_rate = rate;
  workshop->program = workshop->composed_program = WORKSHOP_NO_PROGRAM;
  for (uint32_t i = 0; i < KNOB_KEYS; i++) workshop->base_seen[i] = NAN;
  memcpy(workshop->composed_seen, workshop->base_seen, sizeof workshop->base_seen);
  midi_map_default(&workshop->map);
  if (tabor_drum_def_preset(&workshop->base, DEFAULT_PRESET, NULL) != TABOR_OK) return false;
  workshop->composed = workshop->base;
  return pthread_mutex_init(&workshop->lock, NULL) == 0;
}

static void destroy_drums(TaborDrum **drums) {
  for (uint32_t i = 0; i < WORKSHOP_TRASH; i++) {
    tabor_drum_destroy(drums[i]);
    drums[i] = NULL;
  }
}

/* What was offered and not taken. */
static void destroy_offer(Workshop *workshop) {
  if (atomic_load(&workshop->phase) != PHASE_OFFERED || !workshop->offer.is_news) return;
  tabor_drum_destroy(workshop->offer.drum);
  tabor_drum_destroy(workshop->offer.spare);
}

void workshop_end(Workshop *workshop) {
  destroy_offer(workshop);
  destroy_drums(workshop->wish.trash);
  free(workshop->offer.state);
  for (uint32_t i = 0; i < workshop->swap_count; i++) tabor_swap_destroy(workshop->swaps[i]);
  free(workshop->swaps);
  model_cache_give_back(workshop->model);
  (void)pthread_mutex_destroy(&workshop->lock);
}

/* ---- saving and restoring ------------------------------------------------------------------- */

void workshop_restore(Workshop *workshop, const Keepsake *keepsake) {
  (void)pthread_mutex_lock(&workshop->lock);
  workshop->base = keepsake->def;
  memcpy(workshop->base_seen, keepsake->seen, sizeof workshop->base_seen);
  atomic_fetch_add(&workshop->restoration, 1);
  (void)pthread_mutex_unlock(&workshop->lock);
}

static void forget_ports(float *seen) {
  for (uint32_t i = 0; i < KNOB_KEYS; i++) seen[i] = NAN;
}

/* What was restored, or chosen by MIDI, and is not built yet, counts as much as what is. */
void workshop_save(Workshop *workshop, Keepsake *keepsake) {
  (void)pthread_mutex_lock(&workshop->lock);
  const int program = atomic_load(&workshop->program);
  if (workshop->composed_restoration != atomic_load(&workshop->restoration)) {
    keepsake->def = workshop->base;
    memcpy(keepsake->seen, workshop->base_seen, sizeof keepsake->seen);
  } else if (program >= 0 && program != workshop->composed_program) {
    (void)tabor_drum_def_preset(&keepsake->def, tabor_preset((uint32_t)program)->name, NULL);
    forget_ports(keepsake->seen);
  } else {
    keepsake->def = workshop->composed;
    memcpy(keepsake->seen, workshop->composed_seen, sizeof keepsake->seen);
  }
  (void)pthread_mutex_unlock(&workshop->lock);
}

/* ---- what is wished for --------------------------------------------------------------------- */

/* A value that this drum does not allow is passed over: it was meant for another one. */
static void set_field(TaborDrumDef *def, double *field, double value) {
  if (!field || isnan(value)) return;
  const double before = *field;
  *field = value;
  if (tabor_drum_def_validate(def, NULL) != TABOR_OK) *field = before;
}

static void turn_knobs(const Wish *wish, TaborDrumDef *def) {
  for (uint32_t i = 0; i < KNOB_KEYS; i++) {
    double value = wish->values[i];
    if (i == KNOB_STRIKE_RADIUS) value = fmin(value, def->shell.radius);
    if (!isnan(wish->values[i])) set_field(def, knob_field(def, (KnobId)i), value);
  }
}

/* Under lock. A restoration that the wish does not know of yet takes the place of all it says. */
static void compose(Workshop *workshop, Offer *offer) {
  const Wish *const wish = &workshop->wish;
  TaborDrumDef *const def = &workshop->composed;
  offer->restoration = atomic_load(&workshop->restoration);
  offer->program = wish->program;
  memcpy(offer->seen, wish->seen, sizeof offer->seen);
  *def = workshop->base;
  if (offer->restoration != wish->restoration) {
    offer->program = WORKSHOP_NO_PROGRAM;
    memcpy(offer->seen, workshop->base_seen, sizeof offer->seen);
  } else {
    if (wish->program >= 0) {
      (void)tabor_drum_def_preset(def, tabor_preset((uint32_t)wish->program)->name, NULL);
    }
    turn_knobs(wish, def);
  }
  workshop->composed_restoration = offer->restoration;
  workshop->composed_program = offer->program;
  memcpy(workshop->composed_seen, offer->seen, sizeof offer->seen);
}

/* What the model is built from: where MIDI has moved it, too. */
static void compose_model(const Wish *wish, Offer *offer) {
  TaborDrumDef *const def = &offer->def;
  if (offer->restoration != wish->restoration) return;
  set_field(def, knob_field(def, KNOB_STRAINER), wish->strainer);
  set_field(def, &def->hand.grip, wish->grip);
}

static const char *const mic_names[WORKSHOP_MICS] = {"top", "bottom", "near",
                                                     "far", "left",   "right"};

/* What the audio thread has to know of the model. */
static void describe(Offer *offer) {
  for (uint32_t i = 0; i < WORKSHOP_MICS; i++) {
    const int mic = tabor_drum_def_find_mic(&offer->def, mic_names[i]);
    offer->mics[i] = mic >= 0 ? (uint32_t)mic : WORKSHOP_NO_MIC;
  }
  for (uint32_t i = 0; i < KNOB_KEYS; i++) {
    const double *const field = knob_field(&offer->def, (KnobId)i);
    offer->built[i] = field ? *field : NAN;
  }
}

/* ---- models --------------------------------------------------------------------------------- */

/* Those that the drum is done with make room. */
static void discard_done(Workshop *workshop) {
  uint32_t kept = 0;
  for (uint32_t i = 0; i < workshop->swap_count; i++) {
    TaborSwap *const swap = workshop->swaps[i];
    if (tabor_swap_done(swap)) {
      tabor_swap_destroy(swap);
    } else {
      workshop->swaps[kept++] = swap;
    }
  }
  workshop->swap_count = kept;
}

static TaborStatus keep(Workshop *workshop, TaborSwap *swap) {
  if (workshop->swap_count == workshop->swap_room) {
    const uint32_t room = workshop->swap_room + 4;
    TaborSwap **const grown = realloc(workshop->swaps, room * sizeof(TaborSwap *));
    if (!grown) return TABOR_ERROR_MEMORY;
    workshop->swaps = grown;
    workshop->swap_room = room;
  }
  workshop->swaps[workshop->swap_count++] = swap;
  return TABOR_OK;
}

static bool was_chosen(const Workshop *workshop) {
  return workshop->wish.choice != workshop->built_choice;
}

static bool begins_anew(const Workshop *workshop, const Offer *offer) {
  return !workshop->model || offer->restoration != workshop->built_restoration ||
         was_chosen(workshop);
}

/* Without memory for it, the change may be heard. */
static void prepare_spare(Workshop *workshop, Offer *offer) {
  if (tabor_drum_create(workshop->model, &offer->spare, NULL) != TABOR_OK) return;
  offer->state = malloc(tabor_drum_state_size(offer->spare));
  if (offer->state) return;
  tabor_drum_destroy(offer->spare);
  offer->spare = NULL;
}

/* The drum, or the way from the model before. */
static TaborStatus prepare(Workshop *workshop, TaborModel *model, Offer *offer, TaborError *error) {
  if (workshop->model == model && !was_chosen(workshop)) return TABOR_OK; /* though restored */
  if (offer->begins_anew) return tabor_drum_create(model, &offer->drum, error);
  prepare_spare(workshop, offer);
  const TaborStatus status = tabor_swap_create(workshop->model, model, &offer->swap, error);
  if (status != TABOR_OK) return status;
  if (keep(workshop, offer->swap) == TABOR_OK) return TABOR_OK;
  tabor_swap_destroy(offer->swap);
  *error = (TaborError){.status = TABOR_ERROR_MEMORY, .message = "out of memory"};
  return TABOR_ERROR_MEMORY;
}

static TaborStatus build(Workshop *workshop, Offer *offer, TaborError *error) {
  TaborModelOptions options = workshop->options;
  TaborModel *model = NULL;
  options.quality = workshop->wish.quality;
  TaborStatus status = model_cache_take(&offer->def, &options, &model, error);
  if (status != TABOR_OK) return status;
  offer->begins_anew = begins_anew(workshop, offer);
  status = prepare(workshop, model, offer, error);
  TaborModel *const unused = status == TABOR_OK ? workshop->model : model;
  if (status == TABOR_OK) {
    workshop->model = model;
    workshop->built_restoration = offer->restoration;
    workshop->built_choice = workshop->wish.choice;
  }
  model_cache_give_back(unused);
  return status;
}

static void say(const Workshop *workshop, const TaborError *error) {
  char line[2 * TABOR_TEXT_SIZE];
  (void)snprintf(line, sizeof line, "the drum stays as it is: %s", error->message);
  if (workshop->say) workshop->say(workshop->context, line);
}

/* Composes anew in any case, so that what is saved is not much older than the knobs. */
static void answer(Workshop *workshop) {
  Offer *const offer = &workshop->offer;
  TaborError error;
  const uint32_t number = offer->number, restoration = offer->restoration;
  discard_done(workshop);
  destroy_drums(workshop->wish.trash);
  free(offer->state);
  offer->drum = offer->spare = NULL;
  offer->swap = NULL;
  offer->state = NULL;
  offer->number = workshop->wish.number;
  TaborDrumDef composed;
  (void)pthread_mutex_lock(&workshop->lock);
  compose(workshop, offer);
  composed = workshop->composed;
  (void)pthread_mutex_unlock(&workshop->lock);
  offer->is_news = offer->number != number || offer->restoration != restoration;
  if (!offer->is_news) return;
  offer->def = composed;
  midi_binding_make(&workshop->map, &offer->def, &offer->binding);
  compose_model(&workshop->wish, offer);
  describe(offer);
  offer->failed = build(workshop, offer, &error) != TABOR_OK;
  if (!offer->failed) return;
  tabor_drum_destroy(offer->spare);
  offer->drum = offer->spare = NULL;
  say(workshop, &error);
}

void workshop_work(Workshop *workshop) {
  unsigned asked = PHASE_ASKED;
  if (!atomic_compare_exchange_strong(&workshop->phase, &asked, PHASE_BUILDING)) return;
  answer(workshop);
  atomic_store(&workshop->phase, PHASE_OFFERED);
}

/* ---- the audio thread's --------------------------------------------------------------------- */

bool workshop_is_idle(const Workshop *workshop) {
  return atomic_load(&workshop->phase) == PHASE_IDLE;
}

void workshop_ask(Workshop *workshop, const Wish *wish) {
  workshop->wish = *wish;
  atomic_store(&workshop->phase, PHASE_ASKED);
}

const Offer *workshop_offer(const Workshop *workshop) {
  return atomic_load(&workshop->phase) == PHASE_OFFERED ? &workshop->offer : NULL;
}

void workshop_accept(Workshop *workshop) { atomic_store(&workshop->phase, PHASE_IDLE); }
