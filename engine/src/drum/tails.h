/* SPDX-License-Identifier: MIT */
/* Tails: what a drum was before swaps, replacements and silences, while it is still heard.
 *
 * Each tail is a whole drum with a weight w(n) = min(1, left(n)/(length + 1)), which falls to 0. A
 * tail that *rings out* is added beside what came after it. A tail that *crosses* is the same drum
 * on its former model: it shares the weight of what came after it, w against 1 - w, and events act
 * on both. Audio-safe but for tb_tail_create() and tb_tail_destroy(). */
#ifndef TB_TAILS_H
#define TB_TAILS_H

#include <stdatomic.h>

#include "state/state.h"

/* Marks a microphone that the tail does not have. */
enum { TB_NO_MIC = 255 };

typedef struct TbTail {
  const TaborModel *model; /* of the state; kept alive by the owner, a drum or a swap */
  TbState *state;
  uint8_t mics[TABOR_MAX_MICS]; /* of each output, or TB_NO_MIC */
  atomic_bool sounds;           /* it is in the drum's list; until then its owner must keep it */
  bool crosses;
  uint32_t left;         /* samples that it is still heard */
  double slope;          /* w = min(1, left * slope) */
  struct TbTail *before; /* the next older tail, or NULL */
} TbTail;

/* A tail with memory for a state on `model`, or NULL. */
TbTail *tb_tail_create(TaborModel *model);
/* Ignores NULL. */
void tb_tail_destroy(const TaborAllocator *allocator, TbTail *tail);

/* Puts `tail`, whose state and microphones are set, in front of the drum's others. At most four
 * sound: a further one ends the oldest. It keeps its weight for `hold` samples, then fades over
 * `fade`. */
void tb_tails_begin(TaborDrum *drum, TbTail *tail, uint32_t hold, uint32_t fade);
/* Lets all tails end within `samples`. */
void tb_tails_shorten(TaborDrum *drum, uint32_t samples);
/* The drum's outputs change: mics[new] is the old one that each continues, or TB_NO_MIC. */
void tb_tails_redirect(TaborDrum *drum, const uint8_t *mics);
/* Mixes one sample of all tails into the outputs whose bit is set in `heard`. */
void tb_tails_play(TaborDrum *drum, uint32_t heard, double *outputs);
/* Ends the tail at *link and all older ones. */
void tb_tails_end(TbTail **link);

#endif
