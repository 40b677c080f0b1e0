/* SPDX-License-Identifier: MIT */
/* One sample's contacts: s + M f(s) = b over all points at once, by capped Newton steps.
 *
 * s is the change of penetration over two steps. b is s without contact forces, with the rest load
 * M f_rest added. M is the compliance over one step [m/N]: a diagonal for the wires' and strikers'
 * own compliance, plus the head's, which couples every point to every other through the grid of
 * wire_grid.h. M is symmetric positive definite and f grows with s, so there is one solution.
 *
 * Newton from a pair s, f~ with s = b - M f~ (at first f~ are the last sample's forces): with
 * f = f(s), r = M (f - f~) and slopes D, solve (I + D^(1/2) M D^(1/2)) p = -D^(1/2) r by conjugate
 * gradients; then f~ = f + D^(1/2) p, s = b - M f~. Wire points take part once one of them touches.
 *
 * With `tolerance` 0 the iteration continues until r is rounding noise, and the forces are the
 * laws' own. Otherwise it ends when f(s) - f~ has fallen to the fraction `tolerance` of its first
 * value (contact_solve.h says how it is measured). f~ is then moved along its change since the last
 * sample, f~ + t g, until the contacts take exactly the work that their laws give at s: Sum s (f(s)
 * - f~) = 0 ("balance"). So energy is exact however early the iteration ends.
 *
 * A cap may never create energy. If Newton has not converged,
 * 1. the forces are balanced in the same way;
 * 2. if no t balances them, a majorant takes the step (majorant.h). It creates no energy, or
 *    reports the energy that it creates; the drum then shortens the step (energy_guard.h).
 *
 * Contacts are solved in single precision first if the input asks for it (contact_solve.h). A solve
 * that does not settle there is repeated in double. Audio-safe. */
#ifndef TB_SOLVE_H
#define TB_SOLVE_H

#include "kernels/kernels.h"
#include "kernels/precision.h"
#include "model/contact_rows.h"
#include "tabor/tabor.h"

/* The input of a solve.
 *
 * A row is one contact. Rows 0 .. stride-1 are wire points. The next TB_SLOTS rows are slots,
 * places of the striker pool, which hold strikers, hands and mufflers; `slot_mask` has a bit for
 * each slot in play. Unused rows have y far below 0 and no force, so loops may run over them. */
typedef struct TbContacts {
  const TbKernels *kernels;
  const TbWireGrid *wire_grid;
  const TbCompliance *compliance; /* of the head between points of the grid */
  TbPrecision precision;          /* TB_IN_FLOAT also needs the next five */
  const TbKernelsF *kernelsf;
  const TbWireGridF *wire_gridf;
  const TbComplianceF *compliancef;
  const float *yield; /* [rows]: the head's compliance at a point, to a force there
                       * [m/N]; 0 at the slots */
  bool near;          /* some wire point may touch */
  /* Edges of a hi-hat, whose laws lose so much that Newton's steps may circle. Drums keep the bits
   * that they have without looking for that. */
  bool lossy;
  TbRows rows;
  uint32_t slot_mask;
  bool lifted; /* no wire point can be touched: s and M x are 0 there */
  uint32_t cap, inner_cap;
  double tolerance, inner_tolerance;
  const double *coupling;           /* [TB_SLOTS][grid size]: head's compliance, grid to slot */
  const double *slot_coupling;      /* [TB_SLOTS][TB_SLOTS] */
  const double *contact_compliance; /* [rows]: compliance of wires and strikers */
  const TbContactLaw *wire_laws, *slot_laws;
  /* Stretching heads reduce M to M - r^T W r (stretch.h). r on the grid and at the slots. */
  uint32_t stretch_count;
  double *stretch_grid[TB_COUPLINGS], stretch_weight[TB_COUPLINGS][TB_COUPLINGS];
  _Alignas(64) double stretch_slots[TB_COUPLINGS][TB_SLOTS];
  const double *b, *y; /* [rows] */
} TbContacts;

/* The last sample's result: the solve starts from it and replaces it. */
typedef struct TbWarmStart {
  double *force, *product; /* [rows]: f and M f */
  double *grid;            /* [grid size]: f on the grid */
} TbWarmStart;

#define TB_TEMPLATE "contact/solve_tmpl.h"
#include "kernels/both.h"

typedef struct TbSolve {
  TbContacts in;
  TbWarmStart warm;
  double *s; /* [rows], out */
  TbSolveWork work;
  TbSolveWorkF workf; /* for TB_IN_FLOAT alone */
} TbSolve;

typedef struct TbSolveOutcome {
  uint32_t iterations, touching;
  bool contact; /* false: nothing could touch and all forces are zero */
  bool capped, corrected, fallback;
  double contact_loss, damper_loss; /* of the contact laws, per step [J] */
  double excess; /* energy that these forces would create [J], 0 unless both remedies failed */
} TbSolveOutcome;

TbSolveOutcome tb_solve(TbSolve *solve);

/* Makes the next sample start from zero forces. Used after a failed solve, since its forces would
 * mislead the next one too. */
void tb_solve_forget(TbSolve *solve);

/* out = M x in the precision of the contact solve. The rest load is computed by this function too,
 * so that it cancels to the bit. `grid` receives x on the grid. */
void tb_solve_product(TbSolve *solve, const double *x, double *grid, double *out);

#endif
