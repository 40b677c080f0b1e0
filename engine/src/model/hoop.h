/* SPDX-License-Identifier: MIT */
/* The hoop and the shell under it: a few damped modes, struck on the rim and heard from the wall.
 *
 * Mode i has n = i + 1 nodal diameters, as a ring that bends without stretching: where the stick meets it, it
 * yields by w = q cos(n theta), and moves along itself by q sin(n theta)/n [Rayleigh1877]. So its
 * mass is m_n = (m/2) (1 + 1/n^2), m that of the hoop with what moves along of the shell; its frequency and
 * what the material takes are the definition's. It has a sine copy: struck anywhere, it answers alike there.
 * The wall below moves out by as much, the same from top to bottom: this one ratio is chosen (shells that bend
 * without stretching have 0.3 to 0.6 of axial motion to radial at the rim, n = 3 and 2).
 *
 * The wall, radius R, from z = 0 down to -h, is heard as a layer of sources of strength w_tt per area in free
 * space, the drum's body being no obstacle to them:
 *   p = -omega^2 rho0 R I cos(n theta) q,  I = Int_-h^0 Int_0^2pi cos(n t) e^{-i k r}/(4 pi r) dt dz
 * [MorseIngard] chapter 7; its far field takes from the mode the power
 *   P = omega^4 rho0 R^2 h^2 pi |q|^2/(8 c0) Int_0^pi [J_n(x sin t) sinc((k h/2) cos t)]^2 sin t dt,  x = k R,
 * hence a rate of decay P/(m_n omega^2 |q|^2). An open drum's wall has air on both sides, which it shifts from the one
 * to the other: only what stands above the head counts, h = height of the hoop.
 *
 * Limits: k -> 0 leaves nothing of P, with (k R)^(2n); r >> R gives I -> e^{-ikr} h/(2 r) i^n J_n(x sin t)
 * sinc(...), up to a phase. Two steps as in modes.h, so energy is as exact. */
#ifndef TB_HOOP_H
#define TB_HOOP_H

#include "definition/params.h"

/* Cosine and sine copies of every mode. */
#define TB_HOOP_MODES (2u * TABOR_HOOP_MODES)

typedef struct TbHoop {
  uint32_t count; /* modes that there are, copies counted; 0: a rim that does not yield */
  uint32_t order[TB_HOOP_MODES]; /* n, 0 for none; copies are neighbours, cosine first */
  double a[TB_HOOP_MODES], b[TB_HOOP_MODES], g[TB_HOOP_MODES]; /* the recursion: see modes.h */
  double stiffness[TB_HOOP_MODES];                             /* K' [1/s2] */
  double loss_shell[TB_HOOP_MODES], loss_air[TB_HOOP_MODES]; /* tanh(sk)/(2k^2) by origin [1/s2] */
  double scale[TB_HOOP_MODES];                               /* m_n^(-1/2) [kg^-1/2] */
  double ahead[TABOR_MAX_MICS][TB_HOOP_MODES],
    behind[TABOR_MAX_MICS][TB_HOOP_MODES]; /* see TbMic */
} TbHoop;

struct TaborModel;
struct TbView;

/* Set-up. After the microphones' delays are known. */
void tb_hoop_prepare(struct TaborModel *model);
/* The factor I [1] of a wall of `radius` and `depth` [m] at r, z [m] from the axis and the rim's plane, k [1/m]. */
void tb_hoop_field(uint32_t n, double wavenumber, double radius, double depth, double r, double z,
                   double field[2]);
/* m_n times the rate at which it decays by its sound [kg/s]. */
double tb_hoop_radiation(uint32_t n, double omega, const TaborAirDef *air, double radius,
                         double depth);

/* All below is audio-safe; arrays are [TB_HOOP_MODES]. */

/* shape[] at an angle from the wires' direction. */
void tb_hoop_shape(const TbHoop *hoop, double sin_angle, double cos_angle, double *shape);
/* How far a place of `shape` moves one step after a unit force at another [m/N]. */
double tb_hoop_compliance(const TbHoop *hoop, const double *shape, const double *other);
double tb_hoop_displacement(const double *shape, const double *q);
/* next, without forces; then with a force that presses the place of `shape` down. */
void tb_hoop_step(const TbHoop *hoop, double *next, const double *now, const double *last);
void tb_hoop_press(const TbHoop *hoop, const double *shape, double force, double *next);
/* Stored between two instants [J]. */
double tb_hoop_energy(const TbHoop *hoop, double rate, const double *next, const double *now);
/* Lost in a step [J]. */
typedef struct TbHoopLosses {
  double shell, radiated;
} TbHoopLosses;
TbHoopLosses tb_hoop_losses(const TbHoop *hoop, const double *next, const double *last);
/* What a microphone hears [Pa]. */
double tb_hoop_pressure(const TbHoop *hoop, uint32_t mic, const double *next, const double *now,
                        const double *last);
/* The two instants of a motion under `from` as it goes on under `to`, phase and action kept (swap.c). */
void tb_hoop_carry(const TbHoop *from, const TbHoop *to, double *now, double *last);

#endif
