/* SPDX-License-Identifier: MIT */
/* One sample's contacts: s + M f(s) = b over all points at once, by capped Newton steps.
 *
 * s is the change of penetration over two steps, b what it would be without contact forces (with the
 * rest load M f_rest added), M the compliance over one step [m/N]: diagonal for what wires and
 * strikers yield themselves, plus the head's, which couples every point to every other. M is
 * symmetric positive definite and f grows with s, so there is one solution.
 *
 * Newton: delta = -r - M D^(1/2) p with (I + D^(1/2) M D^(1/2)) p = -D^(1/2) r over the points of
 * slope D > 0, by conjugate gradients; check: (I + M D) delta = -r.
 *
 * A cap may never create energy. Where Newton has not converged,
 * 1. the forces are scaled by the gamma nearest 1 for which the contacts' potential grows by no more
 *    than the work done on them: h(gamma) = DV(b - gamma M f) - gamma f.(b - gamma M f) <= 0, convex
 *    in gamma;
 * 2. where no gamma does, one linear step over parabolas that lie above the potential ("majorant"),
 *    f = V'(y) + C s/2;
 * 3. `excess`, the energy that the outcome would still create, is reported, and the drum shortens the
 *    step (guard.h).
 * Audio-safe. */
#ifndef TB_SOLVE_H
#define TB_SOLVE_H

#include "kernels.h"
#include "law.h"
#include "tabor/tabor.h"

/* Strikers and hands, then a muffler for each head; a multiple of 8. */
#define TB_SLOTS 16u

/* Rows 0 .. stride-1 are wire points (those from `wire_rows` on are padding), the TB_SLOTS rows after
 * them are strikers, hands and mufflers, of which `slot_mask` tells the ones in play. Rows that stand for nothing
 * have b = 0, y < 0 and no force, and their compliances are 0: loops may run over them. */
typedef struct TbSolve {
  const TbKernels *kernels;
  uint32_t wire_rows, stride, slot_mask;
  uint32_t cap, inner_cap;
  const double *compliance; /* [wire_rows][stride]: the head's, between wire points */
  const double *coupling;   /* [TB_SLOTS][stride + TB_SLOTS]: the head's, of each slot */
  const double *own;        /* [stride + TB_SLOTS]: the wires' and strikers' */
  const uint8_t *row_wire;  /* [stride]: which wire's law a point has */
  const TbLaw *wire_laws, *slot_laws;
  uint32_t stretch_count;  /* heads whose stretching makes M smaller: M - r^T W r, see stretch.h */
  double *stretch_rows[2]; /* r, [stride + TB_SLOTS] each */
  double stretch_weight[2][2]; /* W */
  const double *b, *y;         /* [stride + TB_SLOTS] */
  double *s;                   /* out */
  double *force, *product;     /* f and M f: the last sample's on entry, this one's on return */
  /* Scratch, the same length. */
  double *previous, *slope, *residual, *scaled, *work;
  double *direction, *turned, *weight, *right, *solution; /* of the touching rows alone */
  uint32_t *active;
} TbSolve;

typedef struct TbSolveOutcome {
  uint32_t iterations, touching;
  bool contact; /* false: nothing could touch and all forces are zero */
  bool capped, corrected, fallback;
  double excess; /* energy that these forces would create [J], 0 unless both remedies failed */
} TbSolveOutcome;

TbSolveOutcome tb_solve(TbSolve *solve);

/* out = M x; the rest load is computed by this too, so that it cancels to the bit. */
void tb_solve_product(const TbSolve *solve, const double *x, double *out);

/* out -= r^T W r x, what the stretching of the heads takes from M x. */
void tb_solve_stretch(const TbSolve *solve, const double *x, double *out);

/* The law of a row. */
static inline const TbLaw *tb_solve_law(const TbSolve *solve, uint32_t row) {
  return row < solve->stride ? &solve->wire_laws[solve->row_wire[row]]
                             : &solve->slot_laws[row - solve->stride];
}

#endif
