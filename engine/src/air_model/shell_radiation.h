/* SPDX-License-Identifier: MIT */
/* The air outside a closed rigid shell whose caps are heads: mass, radiation resistance, pressure
 * at a point. Units as in air.h, h half the depth.
 *
 * The pressure is -omega^2 rho0 R I cos(m theta) per unit amplitude. I satisfies Helmholtz'
 * equation outside, and dI/dn = -w on the surface, w the outward displacement: a head's on a cap, 0
 * on the side. On the surface, outside it and inside the shell, in this order,
 *   {1/2, 1, 0} I(s) = Int I dG/dn' dS' + Int G w dS'.
 * shell_mesh.h turns both integrals into rows. The equations on the surface alone fail at the
 * resonances of a soft cylinder filled with air; those of a few points inside join them, and all
 * are solved by least squares [Schenck1968]. Motions that are even and odd in z are solved apart.
 *
 * w is replaced by its projection on the polynomials of the nodes,
 *   w_j = Int (polynomial of j) w r dr/(weight of j),
 * which leaves out what oscillates more quickly than the nodes resolve. That does not reach round
 * the edge, and does not radiate. The low-frequency mass of a head has it: it is the full one of a
 * head in an infinite baffle, plus what the finite shell and the other head change. Pressures
 * outside have it as well: they are half the baffled fields of both heads (radiated_field.h), plus
 * the integral of I.
 *
 * Loads: with p = I on the caps and w_i the Bessel functions of both heads, Re Int p w_i r dr is
 * the mass times the amplitudes, and -x Im Int p w r dr the resistance of w. Set-up only. */
#ifndef TB_SHELL_RADIATION_H
#define TB_SHELL_RADIATION_H

#include "air_model/far_field.h"
#include "air_model/shell_mesh.h"

/* Most points outside: microphones, and places far away. */
enum { TB_SHELL_POINTS = TABOR_MAX_MICS + TB_FAR_NODES };

/* One angular order. */
typedef struct TbShellOrder {
  const TbShellMesh *mesh;
  const TbAirOrder *air;
  double *moments;  /* [count][cap] Int (polynomial of j) J_m(z_i r) r dr */
  double *baffled;  /* [count][count] low-frequency mass of a head's outer side in a baffle */
  double *still[2]; /* even, odd: [cap][cap] I at the nodes at low frequency, per w at a node */
} TbShellOrder;

/* A motion of both heads at one x, and what it meets. */
typedef struct TbShellMotion {
  const TbShellOrder *order;
  double x;
  const double *upper, *lower; /* outward amplitudes; lower NULL: a rigid bottom */
  double *w[2], *pressure[2];  /* even, odd: [cap], and I, [nodes](re, im) */
  double *inertia; /* [heads][count]: what x adds to (low-frequency mass matrix) * amplitudes */
  double resistance;
} TbShellMotion;

/* Prepares the shell of this depth, and the points outside where fields are wanted. Returns false
 * if memory ran out. */
bool tb_shell_prepare(TbShellMesh *mesh, TbArena *arena, double depth, const TbAirPoint *points,
                      uint32_t point_count);

/* Prepares an order below mesh->orders. */
bool tb_shell_order_prepare(TbShellOrder *order, TbArena *arena, const TbShellMesh *mesh,
                            const TbAirOrder *air);

/* Mass matrices at low frequency, [count][count]: of a head, and between the two. */
bool tb_shell_order_mass(const TbShellOrder *order, TbArena *scratch, double *own, double *mutual);

/* Solves for the motion of `upper` and `lower` at x, 0 < x <= mesh->top. */
bool tb_shell_solve(TbShellMotion *motion, TbArena *scratch, const TbShellOrder *order,
                    const double *upper, const double *lower, double x);

/* Fields at the points of tb_shell_prepare(), as tb_air_drum_load() gives them. */
bool tb_shell_fields(const TbShellMotion *motion, TbArena *scratch, const TbAirPoint *points,
                     uint32_t point_count, double *fields);

#endif
