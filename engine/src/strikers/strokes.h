/* SPDX-License-Identifier: MIT */
/* The player's hands: a stroke of any technique begins here, and so do pressing, damping and
 * releasing. striker_pool.h, brush.h and rimstroke.h describe the striker's motion from then on.
 * Audio-safe. */
#ifndef TB_STROKES_H
#define TB_STROKES_H

#include "strikers/striker_pool.h"

/* Places a stroke. Returns false if all strikers are in contact and none can be replaced. */
bool tb_strike(TbView *view, const TbStroke *stroke);
/* Lays a hand of `strength` [N s/m] on the head, or moves the hand with this id. */
bool tb_damp(TbView *view, uint32_t id, double strength, double radius, double angle);
/* Presses the strikers with this id (0: all), pressure 0 to 1. Returns false if none is in play. */
bool tb_press(TbView *view, uint32_t id, double pressure);
/* Draws the strikers with this id (0: all) that a hand moves over the head to `radius`, `angle`
 * within `seconds`. Returns false if there are none. */
bool tb_move(TbView *view, uint32_t id, double radius, double angle, double seconds);
/* Moves what hands move by one step. Call before the step. */
void tb_hands_step(TbView *view);
/* True if a hand moves something, or is about to. */
bool tb_hands_move(const TbState *state);
/* Continues what hands move on another drum, whose steps are `ratio` times as long. */
void tb_hands_carry(const TbView *from, TbView *to, double ratio);
/* True if a model has the striker of a slot, and as the same kind. */
bool tb_striker_is_known(const TaborModel *model, const TbSlot *slot);
/* Strikers and hands in play; a stick with two ends is one. */
uint32_t tb_strikers_in_play(const TbState *state);
/* Removes strikers and hands with this id (0: all); mufflers stay. */
void tb_release(TbView *view, uint32_t id);

#endif
