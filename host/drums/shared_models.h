/* SPDX-License-Identifier: MIT */
/**
 * @file shared_models.h
 * Models that several sounds of a batch need: each is built once, by the thread that asks first;
 * others that ask for it meanwhile wait. Any thread.
 */
#ifndef TABOR_HOST_SHARED_MODELS_H
#define TABOR_HOST_SHARED_MODELS_H

#include <pthread.h>

#include "base/message.h"

#define SHARED_MODELS_MOST                                                                         \
  4 /**< models kept at once; a further one takes the place of the oldest */

typedef struct SharedModel {
  TaborDrumDef def;
  double sample_rate;
  uint32_t quality;
  TaborModel *model; /**< NULL while it is being built */
  bool is_used;      /**< the place is taken */
  unsigned age;
} SharedModel;

typedef struct SharedModels {
  pthread_mutex_t mutex;
  pthread_cond_t built;
  SharedModel models[SHARED_MODELS_MOST];
  unsigned age; /**< of the newest */
} SharedModels;

void shared_models_begin(SharedModels *shared);
/** Finds or builds the model of @p def; the caller owns one reference to it. On an error *model is
 * NULL. @p shared may be NULL: the model is built. */
Outcome shared_models_take(SharedModels *shared, const TaborDrumDef *def,
                           const TaborModelOptions *options, TaborModel **model);
/** Releases what is kept; no thread may ask any more. */
void shared_models_end(SharedModels *shared);

#endif
