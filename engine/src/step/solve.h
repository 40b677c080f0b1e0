/* SPDX-License-Identifier: MIT */
/* One sample's contacts: s + M f(s) = b over all points at once, by capped Newton steps.
 *
 * s is the change of penetration over two steps, b what it would be without contact forces (with the
 * rest load M f_rest added), M the compliance over one step [m/N]: diagonal for what wires and
 * strikers yield themselves, plus the head's, which couples every point to every other through the
 * grid of wire_grid.h. M is symmetric positive definite and f grows with s, so there is one solution.
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
 * 2. where no t does, a majorant takes the step (majorant.h), which creates none, or reports what it does: the drum
 *    shortens the step then (energy_guard.h).
 *
 * Contacts are solved in single precision first where the input says so (contact_solve.h); what does not settle
 * there is left to double. Audio-safe. */
#ifndef TB_SOLVE_H
#define TB_SOLVE_H

#include "kernels/kernels.h"
#include "kernels/precision.h"
#include "model/contact_rows.h"
#include "tabor/tabor.h"

/* What there is to solve.
 *
 * Rows 0 .. stride-1 are wire points, the TB_SLOTS rows after them are strikers, hands and mufflers, of
 * which `slot_mask` tells the ones in play. Rows that stand for nothing have y far below 0 and no force:
 * loops may run over them. */
typedef struct TbContacts {
  const TbKernels *kernels;
  const TbWireGrid *wire_grid;
  const TbCompliance *compliance; /* the head's, between points of the grid */
  TbPrecision precision;          /* TB_IN_FLOAT needs the following, too: */
  const TbKernelsF *kernelsf;
  const TbWireGridF *wire_gridf;
  const TbComplianceF *compliancef;
  const float *yield; /* [stride] of the head at a point, to a force there alone [m/N], */
  bool near;          /* ... and whether some wire point may touch */
  uint32_t stride, slot_mask;
  bool lifted; /* no wire point can be touched: s and M x are 0 there */
  uint32_t cap, inner_cap;
  double tolerance, inner_tolerance;
  const double *coupling;      /* [TB_SLOTS][bed size]: the head's at the grid, of each slot */
  const double *slot_coupling; /* [TB_SLOTS][TB_SLOTS] */
  const double *own;           /* [stride + TB_SLOTS]: the wires' and strikers' */
  const TbContactLaw *wire_laws, *slot_laws;
  /* Heads whose stretching makes M smaller, M - r^T W r (stretch.h); r on the grid and at the slots. */
  uint32_t stretch_count;
  double *stretch_grid[2], stretch_weight[2][2];
  _Alignas(64) double stretch_slots[2][TB_SLOTS];
  const double *b, *y; /* [stride + TB_SLOTS] */
} TbContacts;

/* Where the last sample ended, which this one starts from and replaces. */
typedef struct TbWarmStart {
  double *force, *product; /* [stride + TB_SLOTS]: f and M f */
  double *grid;            /* [bed size]: f on the grid */
} TbWarmStart;

#define TB_TEMPLATE "step/solve_tmpl.h"
#include "kernels/both.h"

typedef struct TbSolve {
  TbContacts in;
  TbWarmStart warm;
  double *s; /* [stride + TB_SLOTS], out */
  TbSolveWork work;
  TbSolveWorkF workf; /* for TB_IN_FLOAT alone */
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

/* out = M x in the precision that contacts are solved in; the rest load is computed by this too, so that it cancels to
 * the bit. `grid` receives x on the grid. */
void tb_solve_product(TbSolve *solve, const double *x, double *grid, double *out);

#endif
