/* SPDX-License-Identifier: MIT */
/* G of heads/stretch.h off its diagonal: Int grad w_i . grad w_j dA of two modes on one head.
 *
 * Modes of one order and copy mix: the air between two heads makes pairs of modes of one mode of
 * each head, the air outside mixes functions of one head. With amplitudes v of the Bessel functions
 * and u of the edge (rim.h),
 *   G_ij = a_m R^2 Sum_k v_ik v_jk K_k^2 J_{m+1}(z_k)^2/2 + a_m m u_i u_j.
 * Right after a stroke on the batter head both modes of a pair move it alike and cancel on the
 * other one: without the terms off the diagonal the batter's tension rises by half of what it
 * should, and the other head's rises, too. On the bass drum that is 9 to 12 dB in third octaves of
 * a hard stroke, on toms 4 to 7 dB.
 *
 * In each order the modes up to a limit take part that stretch one of the heads together with
 * another mode by more than a part of what the head's softest mode does alone, at equal energies:
 * all terms between these are kept, on both heads. Both copies have the same. Set-up only. */
#ifndef TB_STRETCH_MIXING_H
#define TB_STRETCH_MIXING_H

#include "kernels/kernels.h"
#include "math/arena.h"

/* Which modes take part. */
typedef struct TbMixingLimits {
  double
    least;    /* of |G_ij|/(omega_i omega_j), in units of the largest G_ii/omega_i^2 of the head */
  double top; /* highest frequency of a mode [rad/s] */
} TbMixingLimits;

struct TaborModel;

/* Limits of a quality: draft and live have single precision, studio and reference double. */
TbMixingLimits tb_mixing_limits(const struct TaborModel *model);

/* Fills model->stretch.mixing, after model->stretch.gain. */
TaborStatus tb_stretch_mixing_prepare(struct TaborModel *model, TbMixingLimits limits);

#endif
