/* SPDX-License-Identifier: MIT */
/* The drum's response to contact forces depends on which slots (places in the striker pool) are in
 * play, and on the hands that hold their strikers. Audio-safe. */
#ifndef TB_COUPLING_H
#define TB_COUPLING_H

#include "state/state.h"

/* Recomputes the response to the rest load and to the last step's forces. Call after a slot was
 * filled, freed or held otherwise, or after the wires have changed. */
void tb_coupling_renew(TbView *view);

#endif
