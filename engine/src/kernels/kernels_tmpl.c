/* SPDX-License-Identifier: MIT */
/* The kernels, compiled once per instruction set and per precision (real.h), with TB_TABLE the name
 * of the table. */
#include "kernels/kernels.h"

#include "kernels/simd_contact_law.h"
#include "kernels/simd_contact_rows.h"
#include "kernels/simd_resonators.h"
#include "kernels/simd_rows.h"
#include "kernels/simd_tables.h"
#include "kernels/simd_wire_grid.h"
#ifdef TB_FLOAT
#  include "kernels/simd_contact_trial.h"
#  include "kernels/simd_narrow.h"
#  include "kernels/simd_von_karman.h"
#else
#  include "kernels/simd_state.h"
#endif

const TYPE_OF(TbKernels) TB_TABLE = {
  .dot = dot,
  .two_dots = two_dots,
  .axpy = axpy,
  .add_product = add_product,
  .product = product,
  .difference = difference,
  .extrapolate = extrapolate,
  .gemv = gemv,
  .gemm = gemm,
  .mix = mix,
  .resonate = resonate,
  .turn_phases = turn_phases,
  .rows_to_grid = rows_to_grid,
  .grid_to_rows = grid_to_rows,
  .apply_compliance = apply_compliance,
  .start = start,
  .finish = finish,
  .laws = laws,
  .change = change,
  .cg_apply = cg_apply,
  .cg_advance = cg_advance,
  .xpby = xpby,
  .newton_finish = newton_finish,
  .balance = balance,
#ifdef TB_FLOAT
  .narrow = narrow,
  .narrow_change = narrow_change,
  .widen = widen,
  .add_widened = add_widened,
  .penetrate = penetrate,
  .start_newton_diagonal = start_newton_diagonal,
  .trial_at_forces = trial_at_forces,
  .trial_moved = trial_moved,
  .finish_forces = finish_forces,
  .newton_diagonal = newton_diagonal,
  .newton_residual = newton_residual,
  .sum_scaled = sum_scaled,
  .von_karman = von_karman,
#else
  .newton_rhs = newton_rhs,
  .gemv_rounded = gemv_rounded,
  .gemm_rounded = gemm_rounded,
  .two_step = two_step,
  .stretch = stretch,
  .step_and_stretch = step_and_stretch,
  .stretch_dots = stretch_dots,
  .end_modes = end_modes,
  .push_by_sound = push_by_sound,
  .two_dots_of_parts = two_dots_of_parts,
  .weighted_size = weighted_size,
  .losses = losses,
  .subtract = subtract_arrays,
  .wire_step = wire_step,
  .radiated_power = radiated_power,
  .wire_losses = wire_losses,
  .gather_wires = gather_wires,
  .touches = touches,
  .penetrate = penetrate,
  .move_wires = move_wires,
#endif
};
