/* SPDX-License-Identifier: MIT */
/* Parameters that move while the drum rings. A change of the wires acts on the unchanged state; the
 * energy that it adds or takes is booked to `control`. Audio-safe. */
#ifndef TB_LIVE_PARAMS_H
#define TB_LIVE_PARAMS_H

#include "state/state.h"

/* The values that the definition gives: live[TB_LIVE_COUNT]. */
void tb_live_params_definition(const TaborModel *model, TbLiveParam *live);
/* Resets all values to the definition's. */
void tb_live_params_reset(TbView *view);
/* Starts a move of the live parameter `parameter` (a TbParamId). Returns false if it is not live or
 * is absent. */
bool tb_live_params_set(TbView *view, uint32_t parameter, uint32_t index, double value);
/* Starts a move of the gain of all outputs; `at_once` where nothing sounds. */
void tb_live_params_gain(TbView *view, double value, bool at_once);
/* Advances that move by one sample; returns the gain. */
double tb_live_params_gain_step(TbState *state);
/* Copies the values `live` to a drum at rest. Values of wires are not copied but approached,
 * because the wires lie on the head; returns true if one of them has to move. */
bool tb_live_params_keep(TbView *view, const TbLiveParam *live);
/* True if all live values and the gain are in their ranges. */
bool tb_live_params_in_range(const TbState *state);
/* Advances all running moves by one sample. */
void tb_live_params_step(TbView *view);
/* Recomputes the quantities that depend on the live values. */
void tb_live_params_apply(TbView *view);

#endif
