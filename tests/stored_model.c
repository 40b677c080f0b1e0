/* SPDX-License-Identifier: MIT */
/* Plays a model that another program has built, maybe on another processor, and prints hashes of what came
 * out. Building goes through libm and LAPACK, which round differently from machine to machine; playing must
 * not, so models are compared by storing them: all their memory, pointers included, at a fixed address.
 *
 *   stored_model store FILE PRESET QUALITY     quality 1 (draft) to 4 (reference)
 *   stored_model play FILE */
#define _GNU_SOURCE
#include <inttypes.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>

#include <cmocka.h>

#include "drum_script.h"
#include "model/model.h"

#define ADDRESS ((char *)0x100000000000) /* far from where programs and their libraries are put */
#define SIZE ((size_t)1 << 30)

/* At ADDRESS itself. */
typedef struct Store {
  size_t used, model_size;
  TaborModel *model;
} Store;

static _Noreturn void stop(const char *message) {
  fprintf(stderr, "stored_model: %s\n", message);
  exit(1);
}

static Store *reserve(void) {
  void *const at = mmap(ADDRESS, SIZE, PROT_READ | PROT_WRITE,
                        MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE | MAP_FIXED_NOREPLACE, -1, 0);
  if (at != ADDRESS) stop("the memory at the fixed address is taken");
  return at;
}

static void *allocate(size_t size, void *context) {
  Store *const store = context;
  const size_t from = (store->used + 63u) & ~(size_t)63u;
  if (size > SIZE - from) return NULL;
  store->used = from + size;
  return (char *)store + from;
}

static void keep(void *memory, void *context) { (void)memory, (void)context; }

static void build(Store *store, const char *preset, unsigned quality) {
  TaborDrumDef def;
  TaborError error;
  TaborModelOptions options;
  tabor_model_options_default(&options);
  options.quality = quality;
  options.allocator = (TaborAllocator){allocate, keep, store};
  if (tabor_drum_def_preset(&def, preset, &error) != TABOR_OK ||
      tabor_model_create(&def, &options, &store->model, &error) != TABOR_OK) {
    stop(error.message);
  }
}

static void store_model(const char *path, const char *preset, unsigned quality) {
  Store *const store = reserve();
  *store = (Store){.used = sizeof *store, .model_size = sizeof *store->model};
  build(store, preset, quality);
  FILE *const file = fopen(path, "wb");
  if (!file || fwrite(store, store->used, 1, file) != 1 || fclose(file) != 0) stop(path);
}

/* What points into the program is this program's own. */
static TaborModel *load_model(const char *path) {
  Store *const store = reserve();
  FILE *const file = fopen(path, "rb");
  if (!file || fread(store, sizeof *store, 1, file) != 1) stop(path);
  if (store->model_size != sizeof *store->model) stop("a model of another layout");
  if (fread(store + 1, store->used - sizeof *store, 1, file) != 1) stop(path);
  fclose(file);
  store->model->kernels = &tb_kernels_baseline;
  store->model->kernelsf = &tb_kernels_baselinef;
  store->model->arena.allocator = (TaborAllocator){allocate, keep, store};
  return store->model;
}

/* FNV-1a */
static uint64_t hash(const void *bytes, size_t size) {
  uint64_t value = 0xcbf29ce484222325u;
  for (size_t i = 0; i < size; i++) {
    value = (value ^ ((const unsigned char *)bytes)[i]) * 0x100000001b3u;
  }
  return value;
}

static void play(TaborModel *model) {
  Script script;
  script_everything(&script);
  Take take = take_create(model, SCRIPT_FRAMES);
  TaborDrum *const drum = script_drum(model);
  script_play_all(drum, &script, &take);

  const size_t state_size = tabor_drum_state_size(drum);
  void *const state = malloc(state_size);
  if (!state) stop("out of memory");
  tabor_drum_state_save(drum, state);
  printf("%s: peak %.3g, samples %016" PRIx64 ", ledger %016" PRIx64 ", state %016" PRIx64 "\n",
         model->def.name, take_peak(&take),
         hash(take.samples, (size_t)take.mics * take.frames * sizeof *take.samples),
         hash(&take.ledger, sizeof take.ledger), hash(state, state_size));
  free(state);
  tabor_drum_destroy(drum);
  take_destroy(&take);
}

int main(int count, char **words) {
  if (count == 5 && strcmp(words[1], "store") == 0) {
    store_model(words[2], words[3], (unsigned)atoi(words[4]));
  } else if (count == 3 && strcmp(words[1], "play") == 0) {
    play(load_model(words[2]));
  } else {
    fprintf(stderr, "usage: stored_model store FILE PRESET QUALITY | play FILE\n");
    return 2;
  }
  return 0;
}
