/* SPDX-License-Identifier: MIT */
/* Sound from outside, which drives the heads: a microphone used backwards.
 *
 * Microphone i hears p = Sum_j W_ij(w) a_j of the modes' accelerations a_j. By reciprocity a point
 * source of volume acceleration Q at its place pushes mode j by the force F_j = -W_ij(w) Q:
 * diffraction around the shell and the air between the heads are in W [MorseIngard] sec. 7.1. The
 * source is given by the pressure p0 that it would cause alone at the centre of the batter head, at
 * the distance r: Q = 4 pi r p0/rho0. A force acts at each instant n:
 *
 *   F_j(n) = now_j p0(n) + before_j p0(n - 1),
 *
 * whose two real weights have size and phase of W_ij at the mode's frequency (model/mics.h). The
 * way to the nearest point of a head is left out: p0 is that of sound which arrives there at its
 * instant. The force does the work F_j (q_j(n + 1) - q_j(n - 1))/2, which the ledger counts as
 * injected.
 *
 * Limits: the modes of the high band, hoop and sticks do not hear; sound louder than
 * TB_INCIDENT_MOST is clipped. Audio-safe. */
#ifndef TB_INCIDENT_SOUND_H
#define TB_INCIDENT_SOUND_H

#include "state/state.h"

/* Pressure that counts as silence [Pa]: the threshold of hearing. */
#define TB_INCIDENT_LEAST 2e-5

/* The loudest [Pa]: the air's own pressure, below which no sound can take it. Up to here created
 * energy stays within a ten millionth of what came in (tests/system/test_system_incident_sound.c);
 * far beyond, heads stretch so much in a step that it does not. */
#define TB_INCIDENT_MOST 1e5

/* True if it acts in this step. */
bool tb_incident_pushes(const TbView *view);
/* True if it pushes more than the low modes. */
bool tb_incident_pushes_all(const TbView *view);
/* Adds what the sound does to the modes' free motion in view->next. */
void tb_incident_push(TbView *view);
/* Sum F_j x_j over the modes, x[padded]. */
double tb_incident_product(const TbView *view, const double *x);
/* Work that it does in this step [J]. Call after view->next is filled. */
double tb_incident_work(const TbView *view);

#endif
