/* SPDX-License-Identifier: MIT */
/* The surface of a closed rigid cylinder as points, and the boundary integral between them.
 *
 * Lengths are in units of the radius; the middle of the axis is the origin, the caps lie at z = h
 * and z = -h. Fields are even or odd in z, and go like cos(m theta). So the upper cap and the upper
 * half of the side stand for everything. On each of the two a parameter t runs from 0 (the axis, the
 * middle plane) to 1 (the edge), with
 *   r = g(t) on the cap, z = h g(t) on the side, g(t) = (15 t - 10 t^3 + 3 t^5)/8.
 * The pressure at the edge goes like d^{2/3}, d the distance along the surface (a wedge of 270 degrees
 * of air), which is smooth in t, since d falls like (1 - t)^3. As a function of t the pressure is
 * even or odd, so that a Gauss rule on (-1, 1), of which half the nodes stay, and the polynomial
 * through its nodes are accurate with few nodes.
 *
 * For a target point s the rows hold the double layer of the pressure I_j at the nodes,
 *   Int I dG/dn' dS' = Sum_j (still_j + x^2 slow_j + x^3 rest_j) I_j,
 * `still` and `slow` from ring_kernel.h by product integration with panels that get shorter towards
 * the target, so that a target may lie on the surface or near to it, and the heads near to one
 * another; `rest`, which is smooth, with the nodes' weights and even steps in the angle.
 * Set-up only. */
#ifndef TB_SHELL_MESH_H
#define TB_SHELL_MESH_H

#include "acoustics/ring_kernel.h"
#include "math/arena.h"

enum { TB_SHELL_ANGLES = 21, TB_SHELL_NODES = 96 };

typedef struct TbShellMesh {
  double half;          /* h */
  uint32_t cap, side;   /* nodes on the cap, which come first, and on half the side */
  uint32_t nodes;       /* cap + side */
  uint32_t targets;     /* the nodes, then points off the surface */
  uint32_t orders;      /* m < orders */
  TbCircle *rings;      /* [targets] */
  double *parameters;   /* [nodes] t */
  double *weights;      /* [nodes] of the generating curve's length */
  double *still, *slow; /* [orders][targets][2: even, odd][nodes] */
  double *distances;    /* [targets][2: node, its mirror image][nodes][TB_SHELL_ANGLES] */
  double *cosines;      /* [orders][TB_SHELL_ANGLES], with the weights of the angles */
  double *cosine;       /* [TB_SHELL_ANGLES] cos t itself */
} TbShellMesh;

/* Chooses `cap` and `side` nodes and computes the rows of the nodes and of `point_count` points off
 * the surface. Returns false if memory ran out. */
bool tb_shell_mesh_prepare(TbShellMesh *mesh, TbArena *arena, double half, uint32_t cap,
                           uint32_t side, uint32_t orders, const TbCircle *points,
                           uint32_t point_count);

/* Values at t of the polynomials that are 1 at one node of a part and 0 at the others, even or odd
 * in t: basis[count]. */
void tb_shell_basis(const double *parameters, uint32_t count, bool odd, double t, double *basis);

/* g(t) and g'(t). */
double tb_shell_grade(double t);
double tb_shell_grade_slope(double t);

/* Index of the row of one target. */
static inline size_t tb_shell_row(const TbShellMesh *mesh, uint32_t m, uint32_t target,
                                  uint32_t odd) {
  return (((size_t)m * mesh->targets + target) * 2 + odd) * mesh->nodes;
}

#endif
