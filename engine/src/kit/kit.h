/* SPDX-License-Identifier: MIT */
/* A sounding kit. It is computed in pieces that are shorter than the shortest way of sound between
 * two drums (kit_create.c), so that the drums of a piece do not depend on each other. tabor/kit.h
 * has the equations.
 *
 * Low-pass. A mode's weight in the air is that at its own frequency. Far above it the weights of
 * all modes do not add up to what a drum radiates there, which directivity keeps small, but rise
 * with the square of the frequency. So drums hear of each other what passes a Butterworth filter of
 * second order, -3 dB at TB_KIT_HIGHEST; it adds sqrt(2)/w to the way. Higher notes move heads too
 * little to matter.
 *
 * Bound. Drums that feed each other must not grow louder for ever. Let S be the energy of all
 * strokes, R what all drums have radiated and I the work of the air on them; drums lose, so R <= S
 * + I. The air is silent while I > R TB_KIT_CAUGHT, judged every TB_KIT_PIECE frames: then R <= (S
 * + D)/(1 - TB_KIT_CAUGHT), D what the air can do in this time; for that the pressure that a drum
 * hears is limited to TB_KIT_LOUDEST. Between neighbours in a kit I/R is below a hundredth, and the
 * pressure some 20 Pa. */
#ifndef TB_KIT_H
#define TB_KIT_H

#include "drum/drum.h"
#include "kit/kit_samples.h"
#include "tabor/kit.h"

#define TB_KIT_PIECE 64u      /* frames at once at most */
#define TB_KIT_HIGHEST 1000.0 /* [Hz] */
#define TB_KIT_CAUGHT 0.25
#define TB_KIT_SWAPS 6u
#define TB_KIT_LOUDEST 200.0f /* [Pa]: 140 dB */

/* One drum, and what it is in the mix. */
typedef struct TbKitVoice {
  TaborDrum *drum;
  const TaborModel *model;          /* for which the next six are */
  uint32_t left, right, air, close; /* microphones, or TB_NO_MIC */
  double full_scale; /* of the drum [Pa]: with the kit's, a factor of left and right */
  double wake;       /* [Pa]; infinite without wires */
  double pan[2];     /* factors of the close microphone */
  uint32_t choke;    /* group, or 0 */
  uint32_t delay[TABOR_KIT_DRUMS];  /* of each other drum's sound [frames] */
  double strength[TABOR_KIT_DRUMS]; /* factor on it */
  bool gone;        /* until a reset: its drum goes on in another kit, and hears there */
  float *said;      /* [ring] pressure at its microphone of the air, by frames */
  double passed[2]; /* memory of the low-pass on it */
  uint32_t quiet;   /* frames since it was not 0, up to the ring's length */
  uint8_t before;   /* drum of the kit that is followed, or TABOR_KIT_NEW */
  /* Swaps of the drum, or NULL: the one with which it goes on, then those of before that still
   * sound (drum/tails.h: four). */
  TaborSwap *swaps[TB_KIT_SWAPS];
  float sound[TABOR_MAX_MICS][TB_KIT_PIECE], heard[TB_KIT_PIECE];
} TbKitVoice;

/* Frames of a block that are computed at once. */
typedef struct TbKitPiece {
  const TaborKitEvent *events; /* [count] of the block; those before `next` have acted */
  uint32_t count, next;
  uint32_t start, frames; /* of the block */
  bool last;              /* of the block's pieces */
  const TaborKitOutputs *outputs;
  double overheads[TB_KIT_PIECE]; /* factors of each frame */
  float coupling[TB_KIT_PIECE], sounds[TB_KIT_PIECE];
} TbKitPiece;

struct TaborKit {
  TaborAllocator allocator;
  TaborKitDef def;
  TbKitVoice *voices; /* [def.drum_count] */
  TaborRoom *room;
  uint32_t piece;   /* frames at once */
  double low[3];    /* the low-pass of the air: gain, and two feedbacks */
  bool muffled;     /* the air is silent: see air_is_passive() */
  TbAirEnergy left; /* what drums have taken out of its account that are left behind */
  TbKitSamples samples;
  bool has_sounds;         /* of the kit that it follows */
  const TaborKit *follows; /* until tabor_kit_take_over() */
  /* Factors of the overheads, and of the coupling beside the definition's. */
  TbLiveParam overheads, coupling;
  uint32_t ramp;    /* frames that they take to move */
  uint32_t ring;    /* length of each ring, a power of 2 */
  uint64_t frame;   /* since the last reset */
  uint64_t dropped; /* events for drums that are not there */
  TaborKitRun *run; /* or NULL */
  void *run_context;
  TbKitPiece now; /* for the drums */
};

/* Factor of a gain in decibels; -120 dB is silence. Audio-safe. */
double tb_kit_factor(double decibels);
/* Finds the kit's microphones in the drum's model, which a swap has changed. Audio-safe. */
void tb_kit_voice_bind(const TaborKit *kit, uint32_t drum);

#endif
