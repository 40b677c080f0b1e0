/* SPDX-License-Identifier: MIT */
/* The handle of a drum, and the swap that moves the drum from one model to another. */
#ifndef TB_DRUM_H
#define TB_DRUM_H

#include "drum/tails.h"

/* The microphone of each output, or TB_NO_MIC. */
typedef struct TbRoute {
  uint8_t mics[TABOR_MAX_MICS];
  uint32_t count; /* outputs */
} TbRoute;

/* Energy that a drum gives to the air and takes from it, as its ledger sums it [J]. */
typedef struct TbAirEnergy {
  double radiated; /* below the two-way bandwidth */
  double work;     /* of sound from outside */
} TbAirEnergy;

struct TaborDrum {
  TaborAllocator allocator;
  TaborModel *model; /* one reference is the drum's */
  TbState *state;    /* tb_state_bytes(model) */
  TbTail *spare;     /* for the next silence; of the same model */
  TbTail *tails;     /* what is still heard of before, the newest first */
  TbRoute route;
  bool at_rest;          /* the state is that after a reset, but for counters, gain and debt */
  TbAirEnergy forgotten; /* what reset events have taken out of the ledger */
};

/* Mapping from the modes of an old model to those of a new one. */
typedef struct TbMapping {
  bool continues; /* false: another instrument; the old drum rings out beside it */
  double step_from, step_to, ratio; /* k0, k1 [s], k1/k0 */
  uint32_t *mode;                   /* [padded of new]: old mode, or TB_NO_MODE */
  uint32_t
    *twin; /* [padded of new]: the old mode's other copy where the axes differ, or TB_NO_MODE */
  double *of_mode, *of_twin; /* parts of both that make the new mode */
  double *scale;             /* c of swap.c; 0 keeps place and velocity */
  double *cos_old, *sin_old, *cos_new, *sin_new;
} TbMapping;

struct TaborSwap {
  TaborAllocator allocator;
  TbArena arena;
  TaborModel *old_model, *new_model; /* as requested */
  TaborModel *held[2];               /* references to give back at the end */
  TbMapping mapping;
  TbTail *tail;  /* memory for the new drum; after the event the old drum, and its memory */
  TbTail *spare; /* the new drum's; after the event the old drum's */
  uint8_t mics[TABOR_MAX_MICS]; /* old microphone that each new one continues, or TB_NO_MIC */
  TbRoute route;                /* outputs after the event */
  bool routed;                  /* the caller has chosen them: former sounds stay at theirs */
  atomic_bool used, acted;      /* the event has come; nothing is left to be done but to ring out */
};

/* Sound from outside during a block, and the drum's own before it travels; any pointer may be NULL.
 */
typedef struct TbDrumAir {
  uint32_t mic;          /* at whose place the sound's source is */
  bool low;              /* the low modes alone hear it (model.h) */
  const float *incident; /* [frames] [Pa]: see air/incident_sound.h */
  double wake;           /* a drum that sleeps does not hear what is less [Pa] */
  uint32_t tap;          /* microphone whose signal is wanted before its delay */
  float *tapped;         /* [frames], out [Pa] */
} TbDrumAir;

/* Returns event `index` as the drum is to carry it out, or NULL if it is not for this drum. */
typedef const TaborEvent *TbEventAddress(const void *context, uint32_t index);

/* Events of a block of which a drum plays a piece. A list for several drums holds others' events,
 * too. */
typedef struct TbEventList {
  const TaborEvent *first;
  size_t stride;           /* from one event to the next [bytes] */
  uint32_t next, count;    /* those before `next` have acted */
  uint32_t start;          /* frame of the block at which the piece begins */
  bool last;               /* of the block's pieces: later events act at its last frame */
  TbEventAddress *address; /* NULL: all events are for the drum */
  const void *context;     /* for `address` */
} TbEventList;

/* tabor_drum_process() in other sound; `air` may be NULL. Audio-safe. */
void tb_drum_process(TaborDrum *drum, TbEventList events, const TbDrumAir *air,
                     float *const *outputs, uint32_t frames);
/* Energies since tabor_drum_reset(), whatever reset events there were. Audio-safe. */
TbAirEnergy tb_drum_air_energy(const TaborDrum *drum);
/* An output for each microphone. */
TbRoute tb_route_plain(const TaborModel *model);
/* Outputs as a caller has chosen them. */
TbRoute tb_route_chosen(const TaborModel *model, const uint8_t *mics, uint32_t count);
/* Carries out a swap event; `anew` if the drum is replaced. Returns false if it does not apply.
 * Audio-safe. */
bool tb_swap_act(TaborDrum *drum, TaborSwap *swap, bool anew);
/* Carries out a silence event. Returns false if the drum was at rest or silenced already.
 * Audio-safe. */
bool tb_silence(TaborDrum *drum);

#endif
