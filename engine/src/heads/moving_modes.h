/* SPDX-License-Identifier: MIT */
/* Modes that move: of each part of the modes (TbParts) the first ones. The others rest: they are
 * exactly 0, and nobody computes them. Every part is sorted by frequency, and high modes die away
 * first.
 *
 * Modes come to rest from a part's end on, while no striker is in play, where they hold less than
 * can be heard or felt (model/resting.h); what they held is booked as lost in the head. They move
 * again as soon as a striker, a hand or sound from outside is about to push them: the drum's own
 * stroke leaves whole parts at rest (modes.h). While a plate's large deflections couple modes, all
 * move. Modes that wires, uneven lugs or other drums may
 * push never rest (TbResting.floor). Audio-safe. */
#ifndef TB_MOVING_MODES_H
#define TB_MOVING_MODES_H

#include "state/state.h"

/* Call before something pushes the modes where shape[padded] is not 0; NULL: all. True if some of
 * them rested. */
bool tb_moving_wake(TbView *view, const double *shape);
/* Call now and then, between two steps. True if more modes rest than before: what is kept of sums
 * over modes is then outdated. */
bool tb_moving_rest(TbView *view);

#endif
