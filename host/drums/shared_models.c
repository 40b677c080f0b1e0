/* SPDX-License-Identifier: MIT */
#include "drums/shared_models.h"

#include <string.h>

#include "drums/model_build.h"

void shared_models_begin(SharedModels *shared) {
  memset(shared, 0, sizeof *shared);
  (void)pthread_mutex_init(&shared->mutex, NULL);
  (void)pthread_cond_init(&shared->built, NULL);
}

void shared_models_end(SharedModels *shared) {
  for (int i = 0; i < SHARED_MODELS_MOST; i++) tabor_model_release(shared->models[i].model);
  (void)pthread_cond_destroy(&shared->built);
  (void)pthread_mutex_destroy(&shared->mutex);
}

/* Definitions are plain data, and those of one batch are read in the same way. */
static bool is_same(const SharedModel *kept, const TaborDrumDef *def,
                    const TaborModelOptions *options) {
  return kept->is_used && kept->sample_rate == options->sample_rate &&
         kept->quality == options->quality && memcmp(&kept->def, def, sizeof *def) == 0;
}

static SharedModel *find(SharedModels *shared, const TaborDrumDef *def,
                         const TaborModelOptions *options) {
  for (int i = 0; i < SHARED_MODELS_MOST; i++) {
    if (is_same(&shared->models[i], def, options)) return &shared->models[i];
  }
  return NULL;
}

/* A free place, or that of the oldest model; NULL if all are being built. */
static SharedModel *make_room(SharedModels *shared) {
  SharedModel *oldest = NULL;
  for (int i = 0; i < SHARED_MODELS_MOST; i++) {
    SharedModel *const kept = &shared->models[i];
    if (!kept->is_used) return kept;
    if (kept->model && (!oldest || kept->age < oldest->age)) oldest = kept;
  }
  if (!oldest) return NULL;
  tabor_model_release(oldest->model);
  *oldest = (SharedModel){.is_used = false};
  return oldest;
}

/* Builds while the mutex is free. A model that fails leaves its place; others then try for
 * themselves. */
static Outcome build_into(SharedModels *shared, SharedModel *place, const TaborDrumDef *def,
                          const TaborModelOptions *options, TaborModel **model) {
  *place = (SharedModel){.def = *def,
                         .sample_rate = options->sample_rate,
                         .quality = options->quality,
                         .is_used = true,
                         .age = ++shared->age};
  (void)pthread_mutex_unlock(&shared->mutex);
  const Outcome outcome = model_build(def, options, model);
  (void)pthread_mutex_lock(&shared->mutex);
  place->is_used = outcome == OUTCOME_OK;
  place->model = outcome == OUTCOME_OK ? tabor_model_retain(*model) : NULL;
  (void)pthread_cond_broadcast(&shared->built);
  return outcome;
}

Outcome shared_models_take(SharedModels *shared, const TaborDrumDef *def,
                           const TaborModelOptions *options, TaborModel **model) {
  *model = NULL;
  if (!shared) return model_build(def, options, model);
  (void)pthread_mutex_lock(&shared->mutex);
  SharedModel *kept;
  while ((kept = find(shared, def, options)) && !kept->model) {
    (void)pthread_cond_wait(&shared->built, &shared->mutex);
  }
  Outcome outcome = OUTCOME_OK;
  SharedModel *const place = kept ? NULL : make_room(shared);
  if (kept) *model = tabor_model_retain(kept->model);
  if (place) outcome = build_into(shared, place, def, options, model);
  (void)pthread_mutex_unlock(&shared->mutex);
  return kept || place ? outcome : model_build(def, options, model);
}
