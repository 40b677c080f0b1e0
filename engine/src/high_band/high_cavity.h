/* SPDX-License-Identifier: MIT */
/* Modes of the enclosed air above the two-way bandwidth, one angular order at a time.
 *
 * A mode c of a cavity with rigid walls (cavity.h) and a Bessel function i of a head, both of unit
 * modal mass, are coupled by the stiffness
 *   K_ci = -a_m R^2 omega_c c0 (rho0/N_c)^(1/2) W_i(z') q_i, times (-1)^l on the upper head,
 * q_i the function's amplitude at unit mass. Two that are coupled by themselves move together by
 *   t_i = -tan(theta_i), tan(2 theta_i) = 2 K_ci/d_i, d_i^2 = (omega_i^2 - omega_c^2)^2 + (2
 *   omega_c (s_i + s_c))^2,
 * d_i with the sign of omega_i^2 - omega_c^2. Without losses that is exact. With them, the energy
 * that one of the two has over time after a blow on the other is, for s_i = s_c, K^2/(s (d^2 + 4
 * K^2)) of it: they share no more than they can exchange before they die away, as in [Lyon1995]. To
 * first order a mode moves every function as if that were coupled to it alone: per unit of the
 * mode's mass
 *   u_c = 1/(1 + Sum t_i^2)^(1/2), a_i = t_i u_c, omega^2 = omega_c^2 + Sum K_ci t_i (omega_i^2 -
 *   omega_c^2)/d_i.
 * Functions that are slower than the air inside follow it as mass; those near omega_c are the free
 * wave that goes out from the edge, where a head cannot follow, and most of what a stroke meets.
 * Each function lacks the part Sum_c a_i^2 that all modes of the air take of it.
 *
 * A mode radiates from both heads, each in a baffle. A microphone hears the head that it faces.
 * (Against the two-way modes of four drums up to 16 kHz, sums over third octaves from 5 kHz on:
 * decay rates within 20 %, energies at six microphones within 3 dB, most within 1.5 dB.) Apart from
 * that it loses
 *   s = s_c u_c^2 + Sum s_i a_i^2, s_c of the air between its walls (cavity.h), s_i of the film.
 * A microphone inside hears the air itself: R I as in cavity_pressure.h.
 *
 * To a stroke, a mode's shape on a head is one wave J_m(K r) with the wavenumber that waves have at
 * omega, and the mean square of all its functions. Set-up only. */
#ifndef TB_HIGH_CAVITY_H
#define TB_HIGH_CAVITY_H

#include "bodies/body.h"
#include "bodies/drum/cavity_pressure.h"

/* The Bessel functions of one order on one head, at unit modal mass: [count]. */
typedef struct TbHeadWaves {
  double *omega, *amplitude; /* [rad/s]; q_i [kg^-1/2] */
  double *decay_rate;        /* of the film alone [1/s] */
  double *taken;             /* Sum_c a_i^2 of the modes that took */
  double *taken_rate;        /* Sum_c a_i^2 s_c [1/s] */
} TbHeadWaves;

/* One order of the air, and what it meets. */
typedef struct TbHighCavity {
  const TaborDrumDef *def;
  TbAirOrder functions; /* of either head */
  TbHeadWaves waves[TB_HEADS];
  const TbCavityOrder *order;
  const TbCavityMics *inside;
} TbHighCavity;

/* A mode, of unit modal mass. */
typedef struct TbAirMode {
  uint32_t radial, axial;
  double omega;              /* [rad/s] */
  double air_rate;           /* s_c [1/s] */
  double decay_rate;         /* [1/s] without what it radiates */
  double in_air;             /* u_c */
  double in_head[TB_HEADS];  /* Sum a_i^2 */
  double *outward[TB_HEADS]; /* [count] amplitudes a_i q_i */
} TbAirMode;

/* Prepares the Bessel functions of an order for the modes of that order, of which `order` has the
 * radial ones. Returns false if memory ran out. */
bool tb_high_cavity_prepare(TbHighCavity *cavity, TbArena *arena, const TaborDrumDef *def,
                            const TbAirOrder *functions, const TbCavityOrder *order,
                            const TbCavityMics *inside);

/* Frequency omega_c of a mode [rad/s]. */
double tb_high_cavity_omega(const TbHighCavity *cavity, uint32_t radial, uint32_t axial);

/* Computes the mode (mode->radial, mode->axial). */
void tb_high_cavity_mode(const TbHighCavity *cavity, TbAirMode *mode);

/* Adds what `count` of its kind take of the heads' functions. */
void tb_high_cavity_take(TbHighCavity *cavity, const TbAirMode *mode, uint32_t count);

/* The part that they take of a head's function, in the mean over its neighbours: which of them
 * meets a mode of the air is chance, as frequencies are right to 1 % here. Writes the mean of their
 * s_c [1/s], 0 if none took of it. */
double tb_high_cavity_taken(const TbHighCavity *cavity, uint32_t head, uint32_t function,
                            double *air_rate);

/* Adds what the mode radiates to mode->decay_rate, and writes its fields at all microphones, as
 * TbBodyMode has them. Returns false if memory ran out. */
bool tb_high_cavity_radiate(const TbHighCavity *cavity, TbArena *scratch, TbAirMode *mode,
                            double *fields);

/* The mode's wave on a head: its zero z = K R, and its amplitude. */
void tb_high_cavity_wave(const TbHighCavity *cavity, const TbAirMode *mode, uint32_t head,
                         double *zero, double *amplitude);

#endif
