/* SPDX-License-Identifier: MIT */
/* Checks the bytes of a saved state before a drum goes on from them. A checksum tells damage, but a
 * forged state has a right one. So every index, count and flag must be one that the model allows,
 * and every number must be finite and below a bound far beyond what any drum reaches; then no step
 * reads or writes outside of its arrays, and a motion that grows without bound is found and reset
 * as any other (sleep.c). Audio-safe. */
#ifndef TB_STATE_CHECK_H
#define TB_STATE_CHECK_H

#include "state/state.h"

/* `bytes`: tb_state_bytes(model) of them, of any alignment. */
bool tb_state_check(const TaborModel *model, const void *bytes);

#endif
