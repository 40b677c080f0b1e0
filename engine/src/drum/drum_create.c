/* SPDX-License-Identifier: MIT */
#include "drum/drum_create.h"

#include <math.h>
#include <string.h>

#include "definition/error.h"
#include "step/reset.h"

static TaborStatus memory_error(TaborError *error, const char *what) {
  return tb_error_set(error, TABOR_ERROR_MEMORY, NULL, NULL, NAN, NAN,
                      "out of memory while creating a %s", what);
}

TaborStatus tabor_drum_create(TaborModel *model, TaborDrum **out, TaborError *error) {
  if (!out) return tb_error_null(error, "place for the drum");
  *out = NULL;
  if (!model) return tb_error_null(error, "model");
  const TaborAllocator allocator = model->arena.allocator;
  TaborDrum *drum = allocator.allocate(sizeof *drum, allocator.context);
  if (!drum) return memory_error(error, "drum");
  *drum = (TaborDrum){.allocator = allocator,
                      .model = tabor_model_retain(model),
                      .route = tb_route_plain(model),
                      .at_rest = true};
  drum->state = allocator.allocate(tb_state_bytes(model), allocator.context);
  drum->spare = tb_tail_create(model);
  if (!drum->state || !drum->spare) {
    tabor_drum_destroy(drum);
    return memory_error(error, "drum");
  }
  tb_step_reset(drum->state, model);
  *out = drum;
  return TABOR_OK;
}

void tabor_drum_destroy(TaborDrum *drum) {
  if (!drum) return;
  tb_tails_end(&drum->tails);
  const TaborAllocator allocator = drum->allocator;
  allocator.release(drum->state, allocator.context);
  tb_tail_destroy(&allocator, drum->spare);
  tabor_model_release(drum->model);
  allocator.release(drum, allocator.context);
}

/* The drum frees its state with its own allocator, so both models must use the same. */
static bool same_allocator(const TaborModel *a, const TaborModel *b) {
  const TaborAllocator *x = &a->arena.allocator, *y = &b->arena.allocator;
  return x->allocate == y->allocate && x->release == y->release && x->context == y->context;
}

static TaborStatus check_models(const TaborModel *old_model, const TaborModel *new_model,
                                TaborError *error) {
  if (!old_model) return tb_error_null(error, "old model");
  if (!new_model) return tb_error_null(error, "new model");
  if (old_model->sample_rate != new_model->sample_rate) {
    return tb_error_set(error, TABOR_ERROR_RANGE, "sample_rate", NULL, old_model->sample_rate,
                        old_model->sample_rate, "a drum at %g Hz cannot continue at %g Hz",
                        old_model->sample_rate, new_model->sample_rate);
  }
  if (!same_allocator(old_model, new_model)) {
    return tb_error_set(error, TABOR_ERROR_ARGUMENT, NULL, NULL, NAN, NAN,
                        "the two models come from different allocators");
  }
  return TABOR_OK;
}

TaborStatus tabor_swap_create(TaborModel *old_model, TaborModel *new_model, TaborSwap **out,
                              TaborError *error) {
  if (!out) return tb_error_null(error, "place for the swap");
  *out = NULL;
  const TaborStatus status = check_models(old_model, new_model, error);
  if (status != TABOR_OK) return status;
  const TaborAllocator allocator = new_model->arena.allocator;
  TaborSwap *swap = allocator.allocate(sizeof *swap, allocator.context);
  if (!swap) return memory_error(error, "swap");
  memset(swap, 0, sizeof *swap);
  swap->allocator = allocator;
  swap->old_model = swap->held[0] = tabor_model_retain(old_model);
  swap->new_model = swap->held[1] = tabor_model_retain(new_model);
  swap->route = tb_route_plain(new_model);
  atomic_init(&swap->used, false);
  atomic_init(&swap->acted, false);
  tb_arena_prepare(&swap->arena, &allocator);
  swap->tail = tb_tail_create(new_model);
  swap->spare = tb_tail_create(new_model);
  if (!swap->tail || !swap->spare || !tb_swap_map(swap)) {
    tabor_swap_destroy(swap);
    return memory_error(error, "swap");
  }
  tb_step_reset(swap->tail->state, new_model);
  *out = swap;
  return TABOR_OK;
}

void tabor_swap_destroy(TaborSwap *swap) {
  if (!swap) return;
  const TaborAllocator allocator = swap->allocator;
  tb_tail_destroy(&allocator, swap->tail);
  tb_tail_destroy(&allocator, swap->spare);
  tabor_model_release(swap->held[0]);
  tabor_model_release(swap->held[1]);
  tb_arena_release(&swap->arena);
  allocator.release(swap, allocator.context);
}
