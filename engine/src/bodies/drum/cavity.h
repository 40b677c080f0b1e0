/* SPDX-License-Identifier: MIT */
/* The air enclosed by a rigid cylindrical shell, between two heads or a head and a rigid bottom.
 *
 * The cavity's modes are J_m(z' r/R) cos(l pi h/L), J_m'(z') = 0 (for m = 0 starting with z' = 0),
 * with the frequency omega_c^2 = c0^2 ((z'/R)^2 + (l pi/L)^2) and the integral over the volume
 *   N_c = a_m L e_l n_p, e_0 = 1, else 1/2,
 *   n_p = (R^2/2)(1 - m^2/z'^2) J_m(z')^2 (R^2/2 for z' = 0).
 * A head that moves outward as w_i J_m(z_i r/R) opens the mode by S_ci w_i,
 *   S_ci = a_m R^2 W_i(z'), times (-1)^l on the upper head (W: air.h).
 * With a coordinate X_c per mode the energy is, symmetric and positive [FletcherRossing,
 * Morse1948],
 *   1/2 (N_c/(rho0 c0^2 omega_c^2)) X_c'^2 + 1/2 (N_c/(rho0 c0^2)) (X_c - (rho0 c0^2/N_c) S_c.w)^2;
 * (m, l, z') = (0, 0, 0) is a pure spring. Here X_c = sqrt(rho0 c0^2 omega_c^2/N_c) u_c, so that
 * u_c has unit mass [m kg^1/2].
 *
 * Modes far above the accurate range follow the heads as mass. Summed over all l, per radial order
 * with kappa = z'/R, times S_i S_j/(a_m n_p), this mass is (rho0/kappa) coth(kappa L) for the same
 * head and (rho0/kappa)/sinh(kappa L) across; for z' = 0 rho0 L/3 and -rho0 L/6. Each mode kept as
 * a coordinate subtracts rho0/(e_l L (kappa^2 + (l pi/L)^2)) from these terms, times (-1)^l
 * across.
 *
 * Walls absorb energy from the air by the boundary layers of Kirchhoff and by the side's material
 * [MorseIngard ch. 6, Kuttruff ch. 2]. At pressure amplitude p the power is
 *   P = (1/(2 rho0 c0)) Int beta |p|^2 + (delta_v/(2 k)) |grad_t p|^2 dS, k = omega/c0,
 *   beta = (k/2)(gamma - 1) delta_t + beta_m,
 *   delta_v = sqrt(2 nu/omega), delta_t = delta_v/sqrt(Pr),
 * beta_m on the side only: a wall of small real specific admittance beta_m absorbs the fraction 8
 * beta_m of sound from all directions. In a long tube the decay rate is Kirchhoff's
 *   s = sqrt(nu omega/2) (1 + (gamma - 1)/sqrt(Pr))/R,
 * over many modes Sabine's s = c0 S alpha/(8 V). A vent of 10 mm would add less than a hundredth of
 * beta_m to beta_m in the treble, and 1/s at 100 Hz. Set-up only. */
#ifndef TB_CAVITY_H
#define TB_CAVITY_H

#include "air_model/air.h"

#define TB_KINEMATIC_VISCOSITY 1.5e-5 /* nu of air [m2/s] */
#define TB_PRANDTL 0.71               /* Pr of air */
#define TB_HEAT_RATIO 1.4             /* gamma of air */
/* Coordinates of an order at most. A tom's lowest orders have 220 below 16 kHz, a deep shell under
 * a tense head would have thousands. If this limit acts, the lowest orders end first and the
 * highest not at all, so that together they fade out. */
#define TB_CAVITY_COORDINATES 640u
#define TB_CAVITY_OPENINGS 128u /* more than an order of a head has zeros: see head.c */

typedef struct TbCavity {
  double radius, depth;        /* R, L [m] */
  double density, sound_speed; /* rho0 [kg/m3], c0 [m/s] */
  uint32_t heads;              /* 2, or 1 over a rigid bottom */
  double admittance;           /* beta_m of the side [1] */
  double head_density[2];      /* mass of each head per area [kg/m2]; 0: no sound goes through */
} TbCavity;

/* A mode kept as a coordinate. */
typedef struct TbCavityMode {
  uint32_t radial, axial; /* index of z' among the order's, and l */
  double omega;           /* [rad/s] */
} TbCavityMode;

typedef struct TbCavityOrder {
  uint32_t m, radial_count, mode_count;
  double *zeros;  /* [radial_count] z', ascending */
  double *edges;  /* [radial_count] J_m(z') */
  double *norms;  /* [radial_count] n_p/R^2 */
  uint32_t *kept; /* [radial_count] number of l, from 0 on, kept as coordinates (or the spring) */
  TbCavityMode *modes; /* [mode_count] */
} TbCavityOrder;

/* Prepares radial orders up to `top_zero` and coordinates up to `top` [rad/s]. Returns false if
 * memory ran out. */
bool tb_cavity_order_prepare(TbCavityOrder *order, TbArena *arena, const TbCavity *cavity,
                             uint32_t m, double top_zero, double top);

/* a_m */
double tb_cavity_azimuth(uint32_t m);

/* Frequency [rad/s] of the mode with the zero z' and axial order l. */
double tb_cavity_mode_omega(const TbCavity *cavity, double zero, uint32_t axial);

/* S_i/(a_m R^2) = W_i(z') of radial order `p` for every Bessel function of a head: s[air->count].
 * z' never equals a z_i. */
void tb_cavity_openings(const TbCavityOrder *order, const TbAirOrder *air, uint32_t p, double *s);

/* N_c of the mode with radial order `p` and axial order `l` [m3]. */
double tb_cavity_mode_norm(const TbCavityOrder *order, const TbCavity *cavity, uint32_t p,
                           uint32_t l);

/* Adds the enclosed air to mass [kg] and stiffness [N/m], both [size][size] with size = heads
 * count + mode_count. The coordinates are the outward Bessel amplitudes of the upper head, those of
 * the lower head, then u_c. */
void tb_cavity_assemble(const TbCavityOrder *order, const TbCavity *cavity, const TbAirOrder *air,
                        uint32_t size, double *mass, double *stiffness);

/* Power [W] that the walls absorb at `omega` from a motion with these amplitudes. `heads`: outward
 * Bessel amplitudes of the upper head, then of the lower head [m]; u[mode_count]: u_c. */
double tb_cavity_wall_power(const TbCavityOrder *order, const TbCavity *cavity,
                            const TbAirOrder *air, const double *heads, const double *u,
                            double omega);

/* Decay rate s_c = P/(2E) [1/s] of a mode of the air by itself, with rigid ends, by that power. Not
 * for (0,0,0). */
double tb_cavity_mode_decay_rate(const TbCavityOrder *order, const TbCavity *cavity, uint32_t p,
                                 uint32_t l);

#endif
