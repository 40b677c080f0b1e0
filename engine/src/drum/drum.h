/* SPDX-License-Identifier: MIT */
/* The handle of a drum, and the swap that moves the drum from one model to another. */
#ifndef TB_DRUM_H
#define TB_DRUM_H

#include <stdatomic.h>

#include "step/state.h"

struct TaborDrum {
  TaborAllocator allocator;
  TaborModel *model; /* one reference is the drum's */
  TbState *state;    /* tb_state_bytes(model) */
  TaborSwap *fading; /* newest swap whose old drum still rings out, or NULL */
};

/* Marks a microphone that the new drum does not have. */
enum { TB_NO_MIC = 255 };

/* Mapping from the modes of an old model to those of a new one. */
typedef struct TbMapping {
  bool continues; /* false: another instrument; the old drum rings out under a fade */
  uint32_t *mode; /* [padded of new]: old mode, or TB_NO_MODE */
  double *scale;  /* c of swap.c; 0 copies both instants as they are */
  double *cos_old, *sin_old, *cos_new, *sin_new;
} TbMapping;

struct TaborSwap {
  TaborAllocator allocator;
  TbArena arena;
  TaborModel *old_model, *new_model; /* as requested */
  TaborModel *held[2];               /* references to give back at the end */
  TbMapping mapping;
  TbState *state; /* memory for the new drum; after the event, the old drum's memory */
  uint8_t
    mics[TABOR_MAX_MICS]; /* new drum's microphone with the name of each old one, or TB_NO_MIC */
  TaborSwap *before;      /* the next older swap that fades, or NULL */
  uint32_t fade_left, fade_length; /* [samples] */
  atomic_bool used, done;
};

/* Carries out a swap event. Returns false if it does not apply. Audio-safe. */
bool tb_swap_act(TaborDrum *drum, TaborSwap *swap);
/* Adds one sample of the drums that ring out to pressure[]. Audio-safe. */
void tb_swap_fade(TaborDrum *drum, uint32_t heard, double *pressure);
/* Cuts the fades short. Audio-safe. */
void tb_swap_finish(TaborDrum *drum);

#endif
