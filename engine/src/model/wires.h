/* SPDX-License-Identifier: MIT */
/* The wires: stiff strings across one face of the head, [Torin2014] eq. (3)-(4).
 *
 *   mu v_tt = T v_xx - EI v_xxxx - sigma0 mu v_t + sigma1 mu v_txx + contact -+ mu g,
 * v [m] counted from the ends outward, away from the head; ends hinged: v = v_xx = 0. (Gravity
 * pulls a wire above the head towards the head, and a wire below away from it.)
 *
 * The scheme is explicit differences on N cells of width h, sigma1's term by a backward difference
 * [NSS]. It is stable for
 *   h^2 >= (A + sqrt(A^2 + 16 kappa^2 k^2))/2, A = T k^2/mu + 2 sigma1 k, kappa^2 = EI/mu,
 * at the largest tension and loss that live play may reach. The contact points are the grid nodes,
 * so a wire's own compliance over one step is k^2/(mu h (1 + sigma0 k/2)) at every node, and 0
 * between nodes. Stored energy:
 *   kinetic + T/2 Sum dv+ dv/h + EI/2 Sum ddv+ ddv/h^3 - sigma1 mu k/4 Sum (d(v+ - v)/k)^2/h;
 * loss per step:
 *   k mu (sigma0 h Sum V^2 + sigma1 Sum (dV)^2/h), V = (v+ - v-)/2k.
 * Audio-safe but for tb_wires_prepare(). */
#ifndef TB_WIRES_H
#define TB_WIRES_H

#include "kernels/contact_law.h"
#include "kernels/kernels.h"
#include "math/arena.h"

/* Live values reach this many times the definition's before the grid must be rebuilt. */
#define TB_WIRE_TENSION_HEADROOM 2.0

/* One wire as defined. */
typedef struct TbWire {
  uint32_t cells;                /* N, even */
  uint32_t first_node;           /* of its N + 1 nodes (with the ends) among all nodes */
  uint32_t first_row;            /* first contact row; rows are consecutive nodes over the head */
  uint32_t row_count, row_node;  /* row_node: first node over the head, counted on the wire */
  double length, spacing;        /* [m]; spacing = h */
  double mass_per_length;        /* mu */
  double tension, tension_limit; /* T as defined, and the largest stable T [N] */
  double bending_stiffness;      /* EI */
  double damping_0, damping_1;   /* sigma0, sigma1 as defined */
  double damping_1_limit;
  double rest_offset; /* of the ends with the strainer on [m] */
  double contact_stiffness, contact_exponent, contact_loss; /* per length; see contact_law.h */
  double x, y, dx, dy; /* middle, and the step from node to node, +x along the bed [m] */
  bool still;          /* its nodes do not move: see rims.h */
  bool own_tension, own_damping_0, own_damping_1; /* true: not from [wires] */
} TbWire;

/* A row is one contact; a lane is the row of the same number along each wire. Each wire has `lanes`
 * rows, one per inner node, with the middle node of every wire in the same lane. At least one lane
 * is left over, so that a zero end lies between neighbouring wires. Row r is node
 * r + TB_WIRE_FRONT. Rows without a node over the head are unused. */
#define TB_WIRE_FRONT 8u

typedef struct TbWires {
  bool rims;               /* the edges of a hi-hat stand in for wires: see rims.h */
  uint32_t head;           /* a TaborHead */
  uint32_t count, lanes;   /* lanes: a multiple of 8 */
  uint32_t stride;         /* rows: count * lanes */
  uint32_t node_count;     /* with the zeros before the first and after the last row */
  uint32_t contact_points; /* rows with a node over the head */
  uint32_t middle;         /* lane of every wire's middle node */
  bool mirrored;           /* every wire is its own mirror image under x -> -x */
  bool aligned;            /* mirrored, and equal lanes have equal x */
  bool balanced;           /* aligned, and wire w is the image of wire count-1-w under y -> -y */
  TbWire *wires;
  TbContactLaw *laws;     /* [count] */
  uint8_t *row_wire;      /* [stride] */
  double *inner, *real;   /* [stride]: 1 for inner nodes, 1 for nodes over the head, else 0 */
  double *row_x, *row_y;  /* [stride]: place, +x along wires.angle [m] */
  double *shape;          /* [stride]: own shape of a bent wire, away from the head [m] */
  double side;            /* +1 above the head, -1 below */
  double gravity;         /* outward acceleration [m/s2]: -g above, +g below */
  double strainer_travel; /* [m]: until the lowest point is as far off as if wires were even */
} TbWires;

/* Prepares grids, contact points and laws. The laws get their slope limits later, from the
 * compliances. */
TaborStatus tb_wires_prepare(TbWires *wires, TbArena *arena, const TaborDrumDef *def,
                             double time_step, uint32_t most_cells, TaborError *error);

/* Takes the arrays of count * lanes rows. Returns TABOR_ERROR_MEMORY on failure. */
TaborStatus tb_wire_rows_prepare(TbWires *wires, TbArena *arena);

void tb_wire_coefficients(const TbWire *wire, double time_step, double tension, double damping_0,
                          double damping_1, TbWireCoefficients *coefficients);

/* Energy [J] stored between two successive states of one wire. */
double tb_wire_energy(const TbWire *wire, const TbWireCoefficients *c, double time_step,
                      const double *next, const double *now);

#endif
