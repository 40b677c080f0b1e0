/* SPDX-License-Identifier: MIT */
/* The handle of a drum, and the swap that moves it from one model to another. */
#ifndef TB_DRUM_H
#define TB_DRUM_H

#include <stdatomic.h>

#include "step/state.h"

struct TaborDrum {
  TaborAllocator allocator;
  TaborModel *model; /* one reference is the drum's */
  TbState *state;    /* tb_state_bytes(model) */
  TaborSwap *fading; /* the newest whose old drum still rings out, or NULL */
};

/* How the modes and wires of an old model continue as those of a new one. */
enum { TB_NO_MIC = 255 };

typedef struct TbMapping {
  bool continues; /* false: another instrument; the old one rings out under a fade */
  uint32_t *mode; /* [padded of new]: old mode, or TB_NO_MODE */
  double *scale;  /* c of swap.c; 0 copies both instants as they are */
  double *cos_old, *sin_old, *cos_new, *sin_new;
} TbMapping;

struct TaborSwap {
  TaborAllocator allocator;
  TbArena arena;
  TaborModel *old_model, *new_model; /* as asked for */
  TaborModel *held[2];               /* references to give back at the end */
  TbMapping mapping;
  TbState *state; /* memory for the new drum; after the event, the old drum's */
  uint8_t
    mics[TABOR_MAX_MICS]; /* where what the old drum's are called is heard now, or TB_NO_MIC */
  TaborSwap *before;      /* the next older one that fades, or NULL */
  uint32_t fade_left, fade_length; /* [samples] */
  atomic_bool used, done;
};

/* Carries out a swap event; false if it does not apply. Audio-safe. */
bool tb_swap_act(TaborDrum *drum, TaborSwap *swap);
/* One sample of the drums that ring out, added to pressure[]. Audio-safe. */
void tb_swap_fade(TaborDrum *drum, uint32_t heard, double *pressure);
/* Cuts the fades short. Audio-safe. */
void tb_swap_finish(TaborDrum *drum);

#endif
