/* SPDX-License-Identifier: MIT */
/* The surface of a closed rigid cylinder as points, and the boundary integral between them.
 *
 * Lengths are in units of the radius; the middle of the axis is the origin, the caps lie at z = h
 * and z = -h. Fields are even or odd in z, and go like cos(m theta). So the upper cap and the upper
 * half of the side stand for everything. On each of the two a parameter t runs from 0 (the axis,
 * the middle plane) to 1 (the edge), with
 *   r = g(t) on the cap, z = h g(t) on the side, g(t) = (15 t - 10 t^3 + 3 t^5)/8.
 * The pressure at the edge goes like d^{2/3}, d the distance along the surface (a wedge of 270
 * degrees of air), which is smooth in t, since d falls like (1 - t)^3. As a function of t the
 * pressure is even or odd, so that a Gauss rule on (-1, 1), of which half the nodes stay, and the
 * polynomial through its nodes are accurate with few nodes.
 *
 * For a target point the rows hold the single layer of the sources w_j at the nodes and the double
 * layer of the pressures I_j,
 *   Int G w dS' = Sum_j single_j w_j, Int I dG/dn' dS' = Sum_j double_j I_j.
 * Their singular part (ring_kernel.h) is integrated with the polynomial through the nodes and
 * with panels that get shorter towards the target, so that a target may lie on the surface or near
 * to it, and the heads near to one another. The rest is smooth: it takes the nodes' own weights and
 * even steps in the angle, and as a function of x it is the polynomial through a few values of x
 * (nodes of Chebyshev), for the nodes and the points inside. Set-up only. */
#ifndef TB_SHELL_MESH_H
#define TB_SHELL_MESH_H

#include "air_model/ring_kernel.h"
#include "math/arena.h"

enum { TB_SHELL_ANGLES = 21, TB_SHELL_NODES = 96, TB_SHELL_STEPS = 64 };

/* A node's single_j and double_j, or what is left of them, as (re, im). */
typedef struct TbShellRow {
  double single[2], dipole[2];
} TbShellRow;

typedef struct TbShellMesh {
  double half;        /* h */
  double top;         /* the largest x */
  uint32_t cap, side; /* nodes on the cap, which come first, and on half the side */
  uint32_t nodes;     /* cap + side */
  uint32_t solved;    /* targets with equations: the nodes, then the points inside */
  uint32_t targets;   /* those, then the points outside */
  uint32_t orders;    /* m < orders */
  TbCircle *circles;  /* [targets] */
  double *parameters; /* [nodes] t */
  double *weights;    /* [nodes] of the generating curve's length */
  TbRingTerms *terms; /* [orders][targets][2: even, odd][nodes] */
  uint32_t steps;     /* values of x */
  double *x;          /* [steps] */
  TbShellRow *rests;  /* [orders][steps][solved][2: even, odd][nodes] */
  double *cosines;    /* [orders][TB_SHELL_ANGLES] cos(m t), with the weights of the angles */
  double *cosine;     /* [TB_SHELL_ANGLES] cos t itself */
} TbShellMesh;

/* How fine a mesh is to be. */
typedef struct TbShellSize {
  double half, top;
  uint32_t cap, side, orders;
} TbShellSize;

/* Computes the rows of the nodes, of `inner_count` points inside and of `outer_count` points
 * outside. Returns false if memory ran out. */
bool tb_shell_mesh_prepare(TbShellMesh *mesh, TbArena *arena, TbShellSize size,
                           const TbCircle *inner, uint32_t inner_count, const TbCircle *outer,
                           uint32_t outer_count);

/* The rows of all nodes and points inside at x <= mesh->top, of order m: rows[solved][2: even,
 * odd][nodes]. */
void tb_shell_rows(const TbShellMesh *mesh, uint32_t m, double x, TbShellRow *rows);

/* The rows of one target, anywhere: rows[2: even, odd][nodes]. */
void tb_shell_target_rows(const TbShellMesh *mesh, uint32_t m, uint32_t target, double x,
                          TbShellRow *rows);

/* Values at t of the polynomials that are 1 at one node of a part and 0 at the others, even or odd
 * in t: basis[count]. */
void tb_shell_basis(const double *parameters, uint32_t count, bool odd, double t, double *basis);

/* g(t) and g'(t). */
double tb_shell_grade(double t);
double tb_shell_grade_slope(double t);

#endif
