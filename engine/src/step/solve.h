/* SPDX-License-Identifier: MIT */
/* One sample's contacts: s + M f(s) = b over all points at once, by capped Newton steps.
 *
 * s is the change of penetration over two steps, b what it would be without contact forces (with the
 * rest load M f_rest added), M the compliance over one step [m/N]: diagonal for what wires and
 * strikers yield themselves, plus the head's, which couples every point to every other through the
 * grid of bed.h. M is symmetric positive definite and f grows with s, so there is one solution.
 *
 * Newton from a pair s, f~ with s = b - M f~ (at first f~ are the last sample's forces): with f = f(s),
 * r = M (f - f~) and slopes D, solve (I + D^(1/2) M D^(1/2)) p = -D^(1/2) r by conjugate gradients;
 * then f~ = f + D^(1/2) p, s = b - M f~. Wire points take part from when one of them touches.
 *
 * With `tolerance` 0 this goes on until r is rounding noise, and the forces are the laws' own. Else
 * it ends when f(s) - f~ has fallen to that part of what it was at first, and f~ is moved along its
 * change since the last sample, f~ + t g, to where the contacts take exactly the work that their laws
 * say at s: Sum s (f(s) - f~) = 0 ("balance"). So energy is exact however early the iteration ends.
 *
 * A cap may never create energy. Where Newton has not converged,
 * 1. the forces are balanced in the same way;
 * 2. where no t does, one linear step over parabolas that lie above the potential ("majorant"),
 *    f = V'(y) + C s/2, first between y and where the point would go, then, where it went further, with the
 *    largest curvature that the potential has anywhere;
 * 3. `excess`, the energy that the outcome would still create, is reported, and the drum shortens the
 *    step (guard.h).
 * Audio-safe. */
#ifndef TB_SOLVE_H
#define TB_SOLVE_H

#include "kernels/law.h"
#include "kernels/singlekernels.h"
#include "model/contact_rows.h"
#include "model/singlebed.h"
#include "tabor/tabor.h"

/* What the solve in single precision works in (singlesolve.h); without kernels there is none. */
typedef struct TbSingle {
  const TbSingleKernels *kernels;
  const TbSingleBed *bed;
  /* [stride + TB_SLOTS] */
  float *y, *root, *b, *own, *s, *force, *product, *force_last, *product_last, *law, *slope, *mean,
    *weight, *residual, *direction, *turned, *moved, *solution, *work;
  float *grid, *grid_last, *pushed, *answer, *stretch[2]; /* [bed size] */
  float *modal[2];                                        /* [modes padded] */
  const float *yield;                                     /* [stride], as in the model */
  float *scratch;                                         /* [tb_single_bed_scratch] */
} TbSingle;

/* Rows 0 .. stride-1 are wire points, the TB_SLOTS rows after them are strikers, hands and mufflers, of
 * which `slot_mask` tells the ones in play. Rows that stand for nothing have y far below 0 and no force:
 * loops may run over them. */
typedef struct TbSolve {
  const TbKernels *kernels;
  const TbBed *bed;
  const TbCompliance *compliance; /* the head's, between points of the grid */
  uint32_t stride, slot_mask;
  bool lifted; /* no wire point can be touched: s and M x are 0 there */
  bool near;   /* where contacts are solved in single precision: some point may touch */
  uint32_t cap, inner_cap;
  double tolerance, inner_tolerance;
  const double *coupling;      /* [TB_SLOTS][bed size]: the head's at the grid, of each slot */
  const double *slot_coupling; /* [TB_SLOTS][TB_SLOTS] */
  const double *own;           /* [stride + TB_SLOTS]: the wires' and strikers' */
  const TbLaw *wire_laws, *slot_laws;
  /* Heads whose stretching makes M smaller, M - r^T W r (stretch.h); r on the grid and at the slots. */
  uint32_t stretch_count;
  double *stretch_grid[2], stretch_weight[2][2];
  _Alignas(64) double stretch_slots[2][TB_SLOTS];
  const double *b, *y;     /* [stride + TB_SLOTS] */
  double *s;               /* out */
  double *force, *product; /* f and M f: the last sample's on entry, this one's on return */
  double *grid;            /* [bed size]: f on the grid, likewise */
  /* Scratch */
  bool wires;                                          /* wire points take part */
  double *previous, *previous_product, *previous_grid; /* the last sample's, as above */
  double *law_force, *slope, *mean;                    /* [stride + TB_SLOTS], as are these: */
  double *residual, *direction, *turned, *moved, *weight, *solution, *work;
  double *pushed, *answer; /* [bed size] */
  double *scratch;         /* [tb_bed_scratch] */
  TbSingle single;
} TbSolve;

typedef struct TbSolveOutcome {
  uint32_t iterations, touching;
  bool contact; /* false: nothing could touch and all forces are zero */
  bool capped, corrected, fallback;
  double contact_loss, damper_loss; /* of the laws, per step [J] */
  double excess; /* energy that these forces would create [J], 0 unless both remedies failed */
} TbSolveOutcome;

TbSolveOutcome tb_solve(TbSolve *solve);

/* Starts the next sample from no forces: where these led nowhere, they would again. */
void tb_solve_forget(TbSolve *solve);

/* out = M x; the rest load is computed by this too, so that it cancels to the bit. `grid` receives x
 * on the grid. */
void tb_solve_product(const TbSolve *solve, const double *x, double *grid, double *out);

/* What forces at the slots do to the head: added to `answer` on the grid, out[] at the slots, which also
 * yield to forces on the grid (`pushed`). */
void tb_solve_slots(const TbSolve *solve, const double *pushed, const double *slots, double *answer,
                    double *out);

/* What the stretching of the heads takes from their answer to forces on the grid and at the slots. */
void tb_solve_stretch(const TbSolve *solve, const double *pushed, const double *slots,
                      double *answer, double *out);

#endif
