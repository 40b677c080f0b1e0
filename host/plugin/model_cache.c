/* SPDX-License-Identifier: MIT */
#include "plugin/model_cache.h"

#include <pthread.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#define GLANCE 20000000 /* [ns] between two looks at whether a model is still wanted */

typedef struct Entry {
  TaborDrumDef def;
  TaborModelOptions options;
  TaborModel *model; /* NULL while it is being built, or if that failed */
  TaborStatus status;
  TaborError error; /* why that failed */
  bool building;
  uint32_t users;
  struct Entry *next;
} Entry;

static pthread_mutex_t lock = PTHREAD_MUTEX_INITIALIZER;
static pthread_cond_t built = PTHREAD_COND_INITIALIZER;
static Entry *first;

/* ---- equal sounds --------------------------------------------------------------------------- */

/* What a model is not computed from: its names, the usual stroke, the room. */
static bool is_heard(const char *key) {
  return strncmp(key, "drum.", 5) != 0 && strncmp(key, "strike.", 7) != 0 &&
         strncmp(key, "room.", 5) != 0;
}

static bool same_value(const TaborDrumDef *a, const TaborDrumDef *b, const char *key) {
  char one[TABOR_TEXT_SIZE], other[TABOR_TEXT_SIZE];
  return tabor_drum_def_get(a, key, one, sizeof one, NULL) == TABOR_OK &&
         tabor_drum_def_get(b, key, other, sizeof other, NULL) == TABOR_OK &&
         strcmp(one, other) == 0;
}

/* Key by key: what lies between the fields of a struct, or behind the end of a name, is no
 * difference. */
static bool same_sound(const TaborDrumDef *a, const TaborDrumDef *b) {
  char key[2 * TABOR_NAME_SIZE], other[2 * TABOR_NAME_SIZE];
  uint32_t i = 0;
  if (memcmp(a, b, sizeof *a) == 0) return true;
  for (; tabor_drum_def_key(a, i, key, sizeof key); i++) {
    if (!tabor_drum_def_key(b, i, other, sizeof other) || strcmp(key, other) != 0) return false;
    if (is_heard(key) && !same_value(a, b, key)) return false;
  }
  return !tabor_drum_def_key(b, i, other, sizeof other);
}

static Entry *find(const TaborDrumDef *def, const TaborModelOptions *options) {
  for (Entry *entry = first; entry; entry = entry->next) {
    if (entry->options.sample_rate == options->sample_rate &&
        entry->options.quality == options->quality && same_sound(&entry->def, def)) {
      return entry;
    }
  }
  return NULL;
}

/* ---- entries, under lock -------------------------------------------------------------------- */

static void leave(Entry *entry) {
  if (--entry->users > 0) return;
  Entry **link = &first;
  while (*link != entry) link = &(*link)->next;
  *link = entry->next;
  tabor_model_release(entry->model);
  free(entry);
}

static Entry *add(const TaborDrumDef *def, const TaborModelOptions *options) {
  Entry *const entry = calloc(1, sizeof *entry);
  if (!entry) return NULL;
  entry->def = *def;
  entry->options = *options;
  entry->next = first;
  return first = entry;
}

/* Leaves the lock meanwhile; others look at the entry's model all along. */
static void build(Entry *entry, const TaborModelOptions *options) {
  TaborModel *model = NULL;
  entry->building = true;
  (void)pthread_mutex_unlock(&lock);
  const TaborStatus status = tabor_model_create(&entry->def, options, &model, &entry->error);
  (void)pthread_mutex_lock(&lock);
  entry->model = model;
  entry->status = status;
  entry->building = false;
  (void)pthread_cond_broadcast(&built);
}

static bool goes_on(const TaborModelOptions *options) {
  return !options->progress || options->progress(0.0, options->progress_context);
}

/* While another thread builds: false if this one does not want the model any more. */
static bool wait_for(const Entry *entry, const TaborModelOptions *options) {
  while (entry->building) {
    struct timespec until;
    if (!goes_on(options)) return false;
    (void)clock_gettime(CLOCK_REALTIME, &until);
    until.tv_nsec += GLANCE;
    until.tv_sec += until.tv_nsec / 1000000000;
    until.tv_nsec %= 1000000000;
    (void)pthread_cond_timedwait(&built, &lock, &until);
  }
  return true;
}

/* What another thread has cancelled is built by the next one that wants it. */
static TaborStatus use(Entry *entry, bool is_new, const TaborModelOptions *options,
                       TaborModel **model, TaborError *error) {
  bool waits = true;
  entry->users++;
  if (is_new) build(entry, options);
  for (;;) {
    waits = wait_for(entry, options);
    if (!waits || entry->status != TABOR_ERROR_CANCELLED || !goes_on(options)) break;
    build(entry, options);
  }
  const TaborStatus status = waits ? entry->status : TABOR_ERROR_CANCELLED;
  if (status == TABOR_OK) *model = entry->model;
  *error = entry->error;
  if (status != TABOR_OK) leave(entry);
  return status;
}

/* ---- all threads ---------------------------------------------------------------------------- */

TaborStatus model_cache_take(const TaborDrumDef *def, const TaborModelOptions *options,
                             TaborModel **model, TaborError *error) {
  *model = NULL;
  (void)pthread_mutex_lock(&lock);
  Entry *entry = find(def, options);
  const bool is_new = !entry;
  if (is_new) entry = add(def, options);
  TaborStatus status = TABOR_ERROR_MEMORY;
  if (entry) {
    status = use(entry, is_new, options, model, error);
  } else {
    *error = (TaborError){.status = status, .message = "out of memory"};
  }
  (void)pthread_mutex_unlock(&lock);
  return status;
}

void model_cache_give_back(TaborModel *model) {
  if (!model) return;
  (void)pthread_mutex_lock(&lock);
  Entry *entry = first;
  while (entry->model != model) entry = entry->next;
  leave(entry);
  (void)pthread_mutex_unlock(&lock);
}

uint32_t model_cache_count(void) {
  uint32_t count = 0;
  (void)pthread_mutex_lock(&lock);
  for (const Entry *entry = first; entry; entry = entry->next) count += entry->model != NULL;
  (void)pthread_mutex_unlock(&lock);
  return count;
}
