/* SPDX-License-Identifier: MIT */
/* The hoop and the shell under it: a few damped modes, struck on the rim and heard from the wall.
 *
 * Mode i has n = i + 1 nodal diameters, as a ring that bends without stretching. Where the stick
 * meets the hoop, the hoop yields by w = q cos(n theta), and moves along its circumference by q
 * sin(n theta)/n [Rayleigh1877]. So its mass is m_n = (m/2) (1 + 1/n^2), m the mass of the hoop and
 * of the part of the shell that moves along. The definition gives the frequency and the material's
 * loss. Each mode has a sine copy, so the hoop answers alike at every angle. The wall below moves
 * outward as far as the hoop yields, the same from top to bottom. This one ratio is chosen (shells
 * that bend without stretching have 0.3 to 0.6 of axial motion to radial at the rim, n = 3 and 2).
 *
 * The wall, radius R, from z = 0 down to -h, radiates as a layer of sources of strength w_tt per
 * area in free space; the drum's body is no obstacle to them:
 *   p = -omega^2 rho0 R I cos(n theta) q,
 *     I = Int_-h^0 Int_0^2pi cos(n t) e^{-i k r}/(4 pi r) dt dz
 * [MorseIngard] chapter 7. The far field takes from the mode the power
 *   P = omega^4 rho0 R^2 h^2 pi |q|^2/(8 c0)
 *     Int_0^pi [J_n(x sin t) sinc((k h/2) cos t)]^2 sin t dt,  x = k R,
 * hence a decay rate P/(m_n omega^2 |q|^2). An open drum's wall has air on both sides and shifts
 * air from one side to the other. So only the wall above the head counts, h = height of the hoop.
 *
 * A microphone inside the shell hears the air that the wall pushes there (cavity_pressure.h),
 * between heads that are held.
 *
 * Limits: for k -> 0, P vanishes with (k R)^(2n); r >> R gives I -> e^{-ikr} h/(2 r) i^n
 * J_n(x sin t) sinc(...), up to a phase. The recursion is that of modes.h, so energy is as
 * exact. */
#ifndef TB_HOOP_H
#define TB_HOOP_H

#include "definition/params.h"

/* Cosine and sine copies of every mode. */
#define TB_HOOP_MODES (2u * TABOR_HOOP_MODES)

typedef struct TbHoop {
  uint32_t count;                /* modes, copies counted; 0: a rim that does not yield */
  uint32_t order[TB_HOOP_MODES]; /* n, 0 for an unused mode; copies are neighbours, cosine first */
  double a[TB_HOOP_MODES], b[TB_HOOP_MODES], g[TB_HOOP_MODES]; /* the recursion: see modes.h */
  double stiffness[TB_HOOP_MODES];                             /* K' [1/s2] */
  double loss_shell[TB_HOOP_MODES], loss_air[TB_HOOP_MODES]; /* tanh(sk)/(2k^2) by origin [1/s2] */
  double scale[TB_HOOP_MODES];                               /* m_n^(-1/2) [kg^-1/2] */
  double ahead[TABOR_MAX_MICS][TB_HOOP_MODES],
    behind[TABOR_MAX_MICS][TB_HOOP_MODES]; /* see TbMic */
} TbHoop;

struct TaborModel;
struct TbView;

/* Set-up. Call after the microphones' delays are known. */
void tb_hoop_prepare(struct TaborModel *model);
/* The factor I [1] of a wall of `radius` and `depth` [m], at r, z [m] from the axis and the rim's
 * plane. Wavenumber in [1/m]. */
void tb_hoop_field(uint32_t n, double wavenumber, double radius, double depth, double r, double z,
                   double field[2]);
/* m_n times the decay rate due to radiation [kg/s]. */
double tb_hoop_radiation(uint32_t n, double omega, const TaborAirDef *air, double radius,
                         double depth);

/* All below is audio-safe; arrays are [TB_HOOP_MODES]. */

/* Computes shape[] at an angle from the wires' direction. */
void tb_hoop_shape(const TbHoop *hoop, double sin_angle, double cos_angle, double *shape);
/* Displacement of the place of `shape`, one step after a unit force at the place of `other`
 * [m/N]. */
double tb_hoop_compliance(const TbHoop *hoop, const double *shape, const double *other);
double tb_hoop_displacement(const double *shape, const double *q);
/* tb_hoop_step() computes `next` without forces. tb_hoop_press() adds a force that presses the
 * place of `shape` down. */
void tb_hoop_step(const TbHoop *hoop, double *next, const double *now, const double *last);
void tb_hoop_press(const TbHoop *hoop, const double *shape, double force, double *next);
/* Energy stored between two instants [J]. */
double tb_hoop_energy(const TbHoop *hoop, double rate, const double *next, const double *now);
/* Energy lost in a step [J]. */
typedef struct TbHoopLosses {
  double shell, radiated;
} TbHoopLosses;
TbHoopLosses tb_hoop_losses(const TbHoop *hoop, const double *next, const double *last);
/* Pressure of the hoop at a microphone [Pa]. */
double tb_hoop_pressure(const TbHoop *hoop, uint32_t mic, const double *next, const double *now,
                        const double *last);
/* Converts the two instants of a motion from the coefficients of `from` to those of `to`, keeping
 * phase and action (swap.c). */
void tb_hoop_carry(const TbHoop *from, const TbHoop *to, double *now, double *last);

#endif
