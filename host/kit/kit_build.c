/* SPDX-License-Identifier: MIT */
#include "kit/kit_build.h"

#include <pthread.h>
#include <stdatomic.h>

#include "drums/model_build.h"

/* Models while they are being built. */
typedef struct Builds {
  const TaborKitDef *def;
  const TaborModelOptions *options;
  atomic_uint next; /* drum to begin with */
  TaborModel *models[TABOR_KIT_DRUMS];
  Outcome outcomes[TABOR_KIT_DRUMS];
} Builds;

static Outcome build(Builds *builds, uint32_t drum) {
  TaborDrumDef placed;
  TaborError error;
  if (tabor_kit_def_place(builds->def, drum, &placed, &error) != TABOR_OK) {
    return report_engine_error(&error);
  }
  return model_build(&placed, builds->options, &builds->models[drum]);
}

static void *work(void *context) {
  Builds *const builds = context;
  for (;;) {
    const uint32_t drum = atomic_fetch_add(&builds->next, 1u);
    if (drum >= builds->def->drum_count) return NULL;
    message_subject(builds->def->drum[drum].name);
    builds->outcomes[drum] = build(builds, drum);
    message_subject(NULL);
  }
}

/* If the system refuses further threads, those that run do all the work, or this thread does. */
static void build_all(Builds *builds, uint32_t most) {
  pthread_t threads[TABOR_KIT_DRUMS];
  uint32_t count = 0;
  if (most > builds->def->drum_count) most = builds->def->drum_count;
  while (count + 1 < most && pthread_create(&threads[count], NULL, work, builds) == 0) count++;
  (void)work(builds);
  for (uint32_t i = 0; i < count; i++) (void)pthread_join(threads[i], NULL);
}

Outcome kit_models_build(const TaborKitDef *def, const TaborModelOptions *options, uint32_t threads,
                         TaborModel *models[TABOR_KIT_DRUMS]) {
  Builds builds = {.def = def, .options = options};
  Outcome outcome = OUTCOME_OK;
  build_all(&builds, threads);
  for (uint32_t i = 0; i < TABOR_KIT_DRUMS; i++) {
    if (builds.outcomes[i] > outcome) outcome = builds.outcomes[i];
    models[i] = builds.models[i];
  }
  if (outcome != OUTCOME_OK) kit_models_release(models);
  return outcome;
}

void kit_fit_mic(TaborKitDrumDef *drum) {
  if (*drum->mic && tabor_drum_def_find_mic(&drum->def, drum->mic) < 0) *drum->mic = '\0';
}

void kit_models_release(TaborModel *models[TABOR_KIT_DRUMS]) {
  for (uint32_t i = 0; i < TABOR_KIT_DRUMS; i++) {
    tabor_model_release(models[i]);
    models[i] = NULL;
  }
}
