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
#else
#  include "kernels/simd_state.h"
#endif

const TYPE_OF(TbKernels) TB_TABLE = {
  .dot = dot,
  .two_dots = two_dots,
  .add_scaled = add_scaled,
  .add_product = add_product,
  .product = product,
  .difference = difference,
  .extrapolate = extrapolate,
  .multiply = multiply,
  .gather = gather,
  .mix = mix,
  .ring = ring,
  .scatter = scatter,
  .contract = contract,
  .expand = expand,
  .comply = comply,
  .start = start,
  .end = end,
  .laws = laws,
  .change = change,
  .turn = turn,
  .advance = advance,
  .redirect = redirect,
  .follow = follow,
  .balance = balance,
#ifdef TB_FLOAT
  .narrow = narrow,
  .narrow_change = narrow_change,
  .widen = widen,
  .add_widened = add_widened,
  .penetrate = penetrate,
  .begin = begin,
  .try_forces = try_forces,
  .try_moved = try_moved,
  .give = give,
  .aim = aim,
  .left_over = left_over,
  .combine = combine,
#else
  .weigh = weigh,
  .multiply_rounded = multiply_rounded,
  .gather_rounded = gather_rounded,
  .two_step = two_step,
  .stretch = stretch,
  .step_and_stretch = step_and_stretch,
  .stretch_dots = stretch_dots,
  .end_modes = end_modes,
  .push = push,
  .heard = heard,
  .reach = reach,
  .losses = losses,
  .subtract = subtract_arrays,
  .wire_step = wire_step,
  .radiate = radiate,
  .wire_losses = wire_losses,
  .gather_wires = gather_wires,
  .touches = touches,
  .penetrate = penetrate,
  .move = move,
#endif
};
