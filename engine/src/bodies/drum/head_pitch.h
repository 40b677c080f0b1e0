/* SPDX-License-Identifier: MIT */
/* The pitch of a head, as a tuner reads it at a lug, and the tension that gives it.
 *
 * The pitch is the frequency of the head's lowest mode with one nodal diameter, (1,1), in air, with
 * even lugs, while the other head is held. A held head is a rigid bottom: the head stands alone
 * over the air in the shell, and its modes are those of drum_modes.h. Limit: in vacuo and without
 * bending stiffness
 *   f = 3.8317/(2 pi R) sqrt(T/rho).
 * f^2 is nearly linear in T, so the secant rule on f^2 finds the tension, within a bracket. Far up
 * the pitch rises ever more slowly with the tension: the mode turns into that of the enclosed air
 * with one nodal diameter, at c0 1.841/(2 pi R). Set-up only. */
#ifndef TB_HEAD_PITCH_H
#define TB_HEAD_PITCH_H

#include "air_model/shell_radiation.h"
#include "bodies/body.h"

enum { TB_PITCH_ZEROS = 16 };
/* Bessel functions with zeros up to here make up the mode: more of them change the pitch by less
 * than 0.1 cents. */
#define TB_PITCH_TOP 40.0

/* Data that does not depend on the heads: the air around the shell of one drum. */
typedef struct TbPitchAir {
  TbArena arena;
  double zeros[TB_PITCH_ZEROS];
  TbAirOrder order;
  TbShellMesh shell;
} TbPitchAir;

/* Prepares the air of the valid definition `def`, with the allocator and the watch of `beside`.
 * Returns false if memory ran out or the watch has ended it. */
bool tb_pitch_air_prepare(TbPitchAir *air, const TaborDrumDef *def, const TbArena *beside);
void tb_pitch_air_release(TbPitchAir *air);

/* Sets *pitch [Hz] of head `which` of the same drum at this tension [N/m] in place of its own.
 * Returns TABOR_ERROR_MEMORY or TABOR_ERROR_NUMERICS on failure. */
TaborStatus tb_head_pitch(const TbPitchAir *air, const TaborDrumDef *def, TaborHead which,
                          double tension, double *pitch);

/* About how many coordinates tb_head_pitch() solves for. */
double tb_head_pitch_size(const TaborDrumDef *def, TaborHead which, double tension);

/* Sets *tension, from `least` to `most` [N/m], to the one with this pitch. Returns
 * TABOR_ERROR_RANGE if there is none. */
TaborStatus tb_head_tension(const TbPitchAir *air, const TaborDrumDef *def, TaborHead which,
                            double pitch, double least, double most, double *tension);

#endif
