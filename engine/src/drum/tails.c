/* SPDX-License-Identifier: MIT */
#include "drum/tails.h"

#include "drum/drum.h"
#include "drum/frame.h"

enum { MOST_TAILS = 4 };

/* ---- set-up --------------------------------------------------------------------------------- */

TbTail *tb_tail_create(TaborModel *model) {
  const TaborAllocator *allocator = &model->arena.allocator;
  TbTail *tail = allocator->allocate(sizeof *tail, allocator->context);
  if (!tail) return NULL;
  *tail = (TbTail){.model = model};
  atomic_init(&tail->sounds, false);
  tail->state = allocator->allocate(tb_state_bytes(model), allocator->context);
  if (tail->state) return tail;
  allocator->release(tail, allocator->context);
  return NULL;
}

void tb_tail_destroy(const TaborAllocator *allocator, TbTail *tail) {
  if (!tail) return;
  allocator->release(tail->state, allocator->context);
  allocator->release(tail, allocator->context);
}

/* ---- the list ------------------------------------------------------------------------------- */

/* Once it does not sound, its owner may free it. */
static void end_one(TbTail **link) {
  TbTail *tail = *link;
  *link = tail->before;
  atomic_store(&tail->sounds, false);
}

void tb_tails_end(TbTail **link) {
  while (*link) end_one(link);
}

void tb_tails_begin(TaborDrum *drum, TbTail *tail, uint32_t hold, uint32_t fade) {
  TbTail **link = &drum->tails;
  for (int i = 1; *link && i < MOST_TAILS; i++) link = &(*link)->before;
  tb_tails_end(link);
  atomic_store(&tail->sounds, true);
  tail->crosses = hold > 0;
  tail->left = hold + fade;
  tail->slope = 1.0 / (fade + 1.0);
  tail->before = drum->tails;
  drum->tails = tail;
}

static double weight_of(const TbTail *tail) {
  const double weight = tail->left * tail->slope;
  return weight < 1.0 ? weight : 1.0;
}

void tb_tails_shorten(TaborDrum *drum, uint32_t samples) {
  for (TbTail *tail = drum->tails; tail; tail = tail->before) {
    if (tail->left <= samples) continue;
    const double slope = weight_of(tail) / samples;
    if (slope > tail->slope) tail->slope = slope;
    tail->left = samples;
  }
}

void tb_tails_redirect(TaborDrum *drum, const uint8_t *mics) {
  for (TbTail *tail = drum->tails; tail; tail = tail->before) {
    uint8_t before[TABOR_MAX_MICS];
    for (uint32_t i = 0; i < TABOR_MAX_MICS; i++) before[i] = tail->mics[i];
    for (uint32_t i = 0; i < TABOR_MAX_MICS; i++) {
      tail->mics[i] = mics[i] == TB_NO_MIC ? (uint8_t)TB_NO_MIC : before[mics[i]];
    }
  }
}

/* ---- sound ---------------------------------------------------------------------------------- */

/* Bits of the tail's microphones that anybody hears. */
static uint32_t heard_of(const TbTail *tail, uint32_t heard) {
  uint32_t own = 0;
  for (uint32_t i = 0; i < TABOR_MAX_MICS; i++) {
    if (tail->mics[i] != TB_NO_MIC) own |= (heard >> i & 1u) << tail->mics[i];
  }
  return own;
}

static void play(TbTail *tail, double weight, uint32_t heard, double *outputs) {
  TbView view = tb_view(tail->state, tail->model);
  double own[TABOR_MAX_MICS] = {0.0};
  tb_frame(&view, heard_of(tail, heard), NULL, own);
  for (uint32_t i = 0; i < TABOR_MAX_MICS; i++) {
    if (heard >> i & 1u && tail->mics[i] != TB_NO_MIC) outputs[i] += weight * own[tail->mics[i]];
  }
}

/* The part that is left to what came after a tail, or to the drum itself. */
static double rest_beside(const TbTail *tail) {
  return tail && tail->crosses ? 1.0 - weight_of(tail) : 1.0;
}

/* A microphone that the former model lacks has nobody to share its weight with. */
static void make_room(const TbTail *newest, uint32_t heard, double *outputs) {
  const double rest = rest_beside(newest);
  if (rest == 1.0) return;
  for (uint32_t i = 0; i < TABOR_MAX_MICS; i++) {
    if (heard >> i & 1u && newest->mics[i] != TB_NO_MIC) outputs[i] *= rest;
  }
}

void tb_tails_play(TaborDrum *drum, uint32_t heard, double *outputs) {
  double shared = 1.0; /* by the tail and the crossing ones before it */
  make_room(drum->tails, heard, outputs);
  for (TbTail *tail = drum->tails; tail; tail = tail->before) {
    shared = tail->crosses ? shared * weight_of(tail) : weight_of(tail);
    play(tail, shared * rest_beside(tail->before), heard, outputs);
  }
  for (TbTail **link = &drum->tails; *link;) {
    if (--(*link)->left == 0) {
      end_one(link);
    } else {
      link = &(*link)->before;
    }
  }
}
