/* SPDX-License-Identifier: MIT */
/* The air outside a closed rigid shell whose caps are heads: mass, radiation resistance, pressure at
 * a point. Units as in air.h, h half the depth.
 *
 * The pressure is -omega^2 rho0 R I cos(m theta) per unit amplitude. I satisfies Helmholtz' equation
 * outside, dI/dn = -w on the heads (w the outward displacement) and dI/dn = 0 on the side. Then on
 * the surface, outside it and inside the shell, in this order,
 *   {1/2, 1, 0} I(s) = Int I dG/dn' dS' + 1/2 (I_upper(s) + I_lower(s)),
 * where I_upper and I_lower are the fields of the heads in infinite baffles (radiated_field.h), taken
 * even in their height [Schenck1968]. shell_mesh.h turns the integral into rows. The equations on the
 * surface alone fail at the resonances of a soft cylinder filled with air; those of a few points
 * inside join them, and all are solved by least squares.
 *
 * On a head I = I_own + I_c: I_own, its own baffled field, oscillates as quickly as the head does,
 * and its load is known in wavenumbers; I_c is what the finite shell and the other head add, smooth.
 * In the equations I_own is restricted to the wavenumbers that the nodes resolve; what a head does
 * beyond those does not reach round the edge. With e and o the parts of the motion that are even and
 * odd in z, and I_e and I_o what they give,
 *   Int p w dS = own of both heads + 2 (Int I_ce e r dr + Int I_co o r dr),
 * of which the real part is the mass and -x times the imaginary part the resistance.
 * Set-up only. */
#ifndef TB_SHELL_RADIATION_H
#define TB_SHELL_RADIATION_H

#include "acoustics/air.h"
#include "acoustics/shell_mesh.h"

typedef struct TbShell {
  TbShellMesh mesh;
  uint32_t inner; /* points inside, the targets after the nodes */
  double top;     /* the largest x */
} TbShell;

/* One angular order. Matrices are [count][count], row-major. */
typedef struct TbShellOrder {
  const TbShell *shell;
  const TbAirOrder *air;
  double *moments;  /* [count][cap] Int (node's polynomial) J_m(z_i r) r dr */
  double *baffled;  /* mass of a baffled head's outer side at low frequency */
  double *still[2]; /* what I_c adds to it at low frequency, even and odd */
} TbShellOrder;

/* Prepares the shell of this depth and the points where fields are wanted. Returns false if memory
 * ran out. */
bool tb_shell_prepare(TbShell *shell, TbArena *arena, double depth, const TbAirPoint *points,
                      uint32_t point_count);

/* Prepares an order below shell->mesh.orders. */
bool tb_shell_order_prepare(TbShellOrder *order, TbArena *arena, const TbShell *shell,
                            const TbAirOrder *air);

/* Mass matrices at low frequency: of a head alone, and between the two. */
void tb_shell_order_mass(const TbShellOrder *order, double *own, double *mutual);

/* What a motion at one frequency meets, per unit amplitude. */
typedef struct TbShellLoad {
  double resistance;
  double *inertia; /* [heads][count]: what x adds to (low-frequency mass matrix) * amplitudes */
} TbShellLoad;

/* The load at x, 0 < x <= shell->top, of the outward amplitudes `upper` and `lower` (NULL: a rigid
 * bottom). `load->inertia` is the caller's. `fields` as in tb_air_drum_load(), at the points of
 * tb_shell_prepare(). */
bool tb_shell_load(const TbShellOrder *order, TbArena *scratch, const double *upper,
                   const double *lower, double x, const TbAirPoint *points, uint32_t point_count,
                   TbShellLoad *load, double *fields);

#endif
