/* SPDX-License-Identifier: MIT */
/* Pressure inside the shell, at microphones that stand there.
 *
 * A mode moves the heads outward by w_a(r) (a: upper or lower head) and the cavity's coordinates by
 * u_c. With n' = n_p/R^2, e_l and N_c as in cavity.h, and with S_a the projection of w_a on
 * J_m(z' r/R), the pressure is -omega^2 rho0 R I cos(m theta),
 *   R I = - Sum_c (c0/omega_c) (rho0 N_c)^(-1/2) u_c J_m(z' r/R) cos(l pi z/L)
 *         + (c0/omega)^2 (S_upper + S_lower)/(n' L), for (m, l, z') = (0, 0, 0)
 *         - Sum_z' J_m(z' r/R)/n' [S_upper G(z) + S_lower G(L - z)],
 * z the height above the lower end. G stands for all other axial modes of a radial order,
 *   G(d) = cosh(g d)/(g sinh(g L)) - Sum_{l kept} (-1)^l cos(l pi d/L)/(e_l L (g^2 + (l pi/L)^2)),
 *   g^2 = (z'/R)^2 - k^2, k^2 = (omega^2 - 2 i s omega)/c0^2:
 * the heads drive these modes, which have no coordinates. For omega -> 0 they follow the heads as
 * the mass in cavity.h does. So the pressure is that of the heads' motion however many
 * coordinates are kept. Without any, the sum is what a head drives in a cavity of rigid walls,
 * the field of the high band's modes (high_band.h). The damping s keeps the sum finite at
 * resonance.
 *
 * s = hypot(s_d + s_w, 2 g). The energy that a driven mode takes up while its driver decays has the
 * sum s_d + s_w of both decay rates as its bandwidth. s_w is that of the mode itself, s_d that of a
 * diffuse field,
 *   s_d = (2 c0/R) beta_m + c0 (2/R + 2/L) beta + Sum_heads c0 tau/(8 L),
 *   beta = (k delta_v) ((gamma - 1)/(2 sqrt(Pr)) + 1/3), the boundary layers (cavity.h) averaged
 *     over all directions,
 *   tau = ln(1 + a^2)/a^2, a = omega rho/(2 rho0 c0), transmission through a head by mass law.
 * g is half the difference of the frequencies into which cavity and heads split where they
 * coincide. Modes without coordinates below omega also ring on by themselves, and nothing here
 * does so for them. There the part of G that differs from its value at k = 0 is increased by
 * sqrt(1 + s_w/s_d), which makes up for their energy.
 *
 * Limits: p = -rho0 c0^2 dV/V for omega -> 0, and in a long tube
 * p = -rho0 c0 omega w cos(k z)/sin(k L).
 * Set-up only. */
#ifndef TB_CAVITY_PRESSURE_H
#define TB_CAVITY_PRESSURE_H

#include "bodies/drum/cavity.h"

/* The microphones inside a shell, as one angular order hears them. */
typedef struct TbCavityMics {
  uint32_t count;
  uint32_t index[TABOR_MAX_MICS]; /* in the definition */
  double height[TABOR_MAX_MICS];  /* above the lower end [m] */
  double *shapes[TABOR_MAX_MICS]; /* [radial_count] J_m(z' r/R) */
} TbCavityMics;

/* Lists the microphones inside the shell. Returns false if memory ran out. */
bool tb_cavity_mics_prepare(TbCavityMics *mics, TbArena *arena, const TaborDrumDef *def,
                            const TbCavityOrder *order);

/* Computes the real and imaginary part of I, fields[2 index], for every microphone inside. `heads`:
 * outward Bessel amplitudes of the upper head, then of the lower head; u[mode_count]: u_c;
 * `decay_rate`: of the mode [1/s]. */
void tb_cavity_fields(const TbCavityMics *mics, const TbCavityOrder *order, const TbCavity *cavity,
                      const TbAirOrder *air, const double *heads, const double *u, double omega,
                      double decay_rate, double *fields);

/* Decay rate of a diffuse field at omega [1/s]. */
double tb_cavity_decay_rate(const TbCavity *cavity, double omega);

#endif
