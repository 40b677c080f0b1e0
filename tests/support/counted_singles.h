/* SPDX-License-Identifier: MIT */
/* Wrappers that count the work of the kernels (kernels_tmpl.h) of one precision. test_system_work.c
 * defines the counters and includes this file once per precision (both.h). */

/* A kernel that returns nothing, with its parameters and its arguments in parentheses. */
#undef COUNTED
#undef COUNTED_RESULT
#undef COUNT
#undef TABLE
#if TB_REAL_IS_FLOAT
#  define COUNT(name) count_##name##_f
#  define TABLE tb_kernels_baselinef
#else
#  define COUNT(name) count_##name
#  define TABLE tb_kernels_baseline
#endif
#define COUNTED(name, elements, parameters, arguments)                                             \
  static void COUNT(name) parameters {                                                             \
    work += (elements);                                                                            \
    TABLE.name arguments;                                                                          \
  }
#define COUNTED_RESULT(type, name, elements, parameters, arguments)                                \
  static type COUNT(name) parameters {                                                             \
    work += (elements);                                                                            \
    return TABLE.name arguments;                                                                   \
  }
typedef TB_REAL *TB_TYPE(Out);
typedef const TB_REAL *TB_TYPE(In);
typedef const TB_TYPE(TbWireGrid) * TB_TYPE(Bed);

COUNTED_RESULT(TB_REAL, dot, n, (uint32_t n, TB_TYPE(In) x, TB_TYPE(In) y), (n, x, y))
COUNTED_RESULT(TbPair, two_dots, n, (uint32_t n, TB_TYPE(In) u, TB_TYPE(In) v, TB_TYPE(In) x),
               (n, u, v, x))
COUNTED(axpy, n, (uint32_t n, TB_TYPE(Out) out, TB_REAL f, TB_TYPE(In) x), (n, out, f, x))
COUNTED(add_product, n, (uint32_t n, TB_TYPE(Out) out, TB_TYPE(In) x, TB_TYPE(In) y),
        (n, out, x, y))
COUNTED(product, n, (uint32_t n, TB_TYPE(Out) out, TB_TYPE(In) x, TB_TYPE(In) y), (n, out, x, y))
COUNTED_RESULT(TB_REAL, difference, n, (uint32_t n, TB_TYPE(In) x, TB_TYPE(In) y), (n, x, y))
COUNTED(extrapolate, n,
        (uint32_t n, TB_REAL t, TB_TYPE(In) x, TB_TYPE(In) before, TB_TYPE(In) base,
         TB_TYPE(Out) out),
        (n, t, x, before, base, out))
COUNTED(gemv, 8ull * blocks * n,
        (uint32_t blocks, uint32_t n, TB_TYPE(Out) out, TB_TYPE(In) m, TB_TYPE(In) x),
        (blocks, n, out, m, x))
COUNTED(gemm, (8ull * g->blocks + g->rest) * g->vectors * g->part, (const TB_TYPE(TbGather) * g),
        (g))
COUNTED(mix, terms_of(mixing),
        (const TbMixing *mixing, const TbParts *moving, const double *q, double *const out[2]),
        (mixing, moving, q, out))
COUNTED_RESULT(TbPair, resonate, r->parts.part[r->parts.count - 1].end, (const TB_TYPE(TbRing) * r),
               (r))
COUNTED(turn_phases, 8, (const TB_TYPE(TbScattering) * s), (s))
COUNTED(rows_to_grid,
        (uint64_t)wire_grid->lines * wire_grid->lanes * wire_grid->wires +
          (uint64_t)wire_grid->lines * wire_grid->half *
            (wire_grid->padded[0] + wire_grid->padded[1]),
        (TB_TYPE(Bed) wire_grid, TB_TYPE(In) x, TB_TYPE(Out) scratch, TB_TYPE(Out) grid),
        (wire_grid, x, scratch, grid))
COUNTED(apply_compliance, (uint64_t)c->first[c->classes] * c->first[c->classes] / c->classes,
        (const TB_TYPE(TbCompliance) * c, TB_TYPE(In) grid, TB_TYPE(Out) out), (c, grid, out))
COUNTED(start, n, (uint32_t n, TB_TYPE(TbStart) * start), (n, start))
COUNTED(finish, n, (uint32_t n, TB_TYPE(TbEnd) * end), (n, end))
COUNTED_RESULT(TB_REAL, change, n, (uint32_t n, TB_TYPE(In) b, TB_TYPE(In) p, TB_TYPE(Out) s),
               (n, b, p, s))
COUNTED_RESULT(TB_REAL, cg_apply, n,
               (uint32_t n, TB_TYPE(Out) out, TB_TYPE(In) d, TB_TYPE(In) w, TB_TYPE(In) m),
               (n, out, d, w, m))
COUNTED_RESULT(TB_REAL, cg_advance, n,
               (uint32_t n, TB_REAL t, TB_TYPE(Out) p, TB_TYPE(In) d, TB_TYPE(Out) r,
                TB_TYPE(In) m),
               (n, t, p, d, r, m))
COUNTED(xpby, n, (uint32_t n, TB_REAL t, TB_TYPE(Out) d, TB_TYPE(In) r), (n, t, d, r))
COUNTED_RESULT(TB_REAL, newton_finish, n,
               (uint32_t n, TB_TYPE(In) law, TB_TYPE(In) weight, TB_TYPE(In) x, TB_TYPE(In) b,
                TB_TYPE(In) p, TB_TYPE(Out) f, TB_TYPE(Out) s),
               (n, law, weight, x, b, p, f, s))
COUNTED_RESULT(TB_TYPE(TbBalance), balance, n,
               (uint32_t n, TB_REAL t, TB_TYPE(In) yield, TB_TYPE(In) s, TB_TYPE(In) law,
                TB_TYPE(In) slope, TB_TYPE(In) f, TB_TYPE(In) f_last, TB_TYPE(In) p,
                TB_TYPE(In) p_last),
               (n, t, yield, s, law, slope, f, f_last, p, p_last))

static void COUNT(grid_to_rows)(TB_TYPE(Bed) wire_grid, TB_TYPE(In) grid, TB_TYPE(Out) scratch,
                                TB_TYPE(Out) x) {
  products++;
  work +=
    (uint64_t)wire_grid->lines * wire_grid->lanes * wire_grid->wires +
    (uint64_t)wire_grid->lines * wire_grid->half * (wire_grid->columns[0] + wire_grid->columns[1]);
  TABLE.grid_to_rows(wire_grid, grid, scratch, x);
}

static void COUNT(laws)(uint32_t wires, uint32_t lanes, const TbContactLaw *laws_of, TB_TYPE(In) y,
                        TB_TYPE(In) root, TB_TYPE(In) s, TB_TYPE(Out) force, TB_TYPE(Out) slope,
                        TB_TYPE(Out) mean) {
  laws += (uint64_t)wires * lanes;
  work += (uint64_t)wires * lanes;
  TABLE.laws(wires, lanes, laws_of, y, root, s, force, slope, mean);
}

#if TB_REAL_IS_FLOAT
static float COUNT(start_newton_diagonal)(uint32_t wires, uint32_t lanes,
                                          const TbContactLaw *laws_of, TbStartF *start, OutF f) {
  laws += (uint64_t)wires * lanes;
  work += 2ull * wires * lanes;
  return TABLE.start_newton_diagonal(wires, lanes, laws_of, start, f);
}

static void COUNT(trial_at_forces)(TbTrial *trial) {
  laws += (uint64_t)trial->wires * trial->lanes;
  work += 2ull * trial->wires * trial->lanes;
  TABLE.trial_at_forces(trial);
}

static void COUNT(trial_moved)(TbTrial *trial) {
  laws += (uint64_t)trial->wires * trial->lanes;
  work += 2ull * trial->wires * trial->lanes;
  TABLE.trial_moved(trial);
}

COUNTED(narrow, n, (uint32_t n, In x, OutF out), (n, x, out))
COUNTED(narrow_change, n, (uint32_t n, In x, In y, OutF out), (n, x, y, out))
COUNTED(widen, n, (uint32_t n, InF x, Out out), (n, x, out))
COUNTED(add_widened, n, (uint32_t n, InF x, Out out), (n, x, out))
COUNTED_RESULT(bool, penetrate, n,
               (uint32_t n, float side, InF w, In v, In v_last, In load, In y, Out b),
               (n, side, w, v, v_last, load, y, b))
COUNTED(finish_forces, n, (uint32_t n, const TbEndF *end), (n, end))
COUNTED_RESULT(float, newton_diagonal, n,
               (uint32_t n, InF law, InF slope, InF yield, OutF f, OutF weight, OutF x),
               (n, law, slope, yield, f, weight, x))
COUNTED_RESULT(TbResidualF, newton_residual, n,
               (uint32_t n, InF slope, InF yield, InF weight, InF x, InF p, InF before, OutF r,
                OutF d),
               (n, slope, yield, weight, x, p, before, r, d))
COUNTED(sum_scaled, (uint64_t)n *count, (uint32_t n, uint32_t count, InF f, InF const *x, OutF out),
        (n, count, f, x, out))
COUNTED_RESULT(double, von_karman, (uint64_t)tb_von_karman_scratch(plate),
               (const TbVonKarman *plate, InF q, OutF gradient, OutF scratch),
               (plate, q, gradient, scratch))
#else
COUNTED_RESULT(TbResidual, newton_rhs, n,
               (uint32_t n, In slope, In s, In b, In p, Out weight, Out d),
               (n, slope, s, b, p, weight, d))
COUNTED(gemv_rounded, 8ull * blocks * n,
        (uint32_t blocks, uint32_t n, Out out, const float *m, In x), (blocks, n, out, m, x))
COUNTED(gemm_rounded, 8ull * g->blocks * g->vectors * g->part, (const TbGather *g), (g))
COUNTED(two_step, n, (uint32_t n, Out out, In a, In x, In b, In y), (n, out, a, x, b, y))
COUNTED(stretch, modes_of(parts), (const TbParts *parts, TbStretching *s), (parts, s))
COUNTED_RESULT(TbPair, stretch_dots, modes_of(parts),
               (const TbParts *parts, const double *const pull[2], In x), (parts, pull, x))
COUNTED(step_and_stretch, 2 * modes_of(parts), (const TbParts *parts, TbStretching *s), (parts, s))
COUNTED(end_modes, 3ull * modes_of(parts), (const TbParts *parts, TbModesEnd *end), (parts, end))
COUNTED(push_by_sound, modes_of(parts),
        (const TbParts *parts, TbPair sound, In now, In before, In g, Out next),
        (parts, sound, now, before, g, next))
COUNTED_RESULT(TbPair, two_dots_of_parts, modes_of(parts), (const TbParts *parts, In u, In v, In q),
               (parts, u, v, q))
COUNTED_RESULT(double, weighted_size, n, (uint32_t n, In c, In x), (n, c, x))
COUNTED(losses, n,
        (uint32_t n, uint32_t count, const double *const w[3], In next, In last, double sums[3]),
        (n, count, w, next, last, sums))
COUNTED(subtract, n, (uint32_t n, In x, In y, Out out), (n, x, y, out))
COUNTED(wire_step, (uint64_t)wires *lanes,
        (uint32_t wires, uint32_t lanes, const TbWireCoefficients *c, In inner, In now, In last,
         Out bend, Out next),
        (wires, lanes, c, inner, now, last, bend, next))
COUNTED_RESULT(double, radiated_power, 8u * count,
               (uint32_t count, const uint32_t *mode, In ahead, In behind, In next, In now,
                In last),
               (count, mode, ahead, behind, next, now, last))
COUNTED_RESULT(double, wire_losses, (uint64_t)wires *lanes,
               (uint32_t wires, uint32_t lanes, const TbWireCoefficients *c, In next, In last),
               (wires, lanes, c, next, last))
COUNTED_RESULT(TbWireContacts, gather_wires, (uint64_t)wires *lanes,
               (uint32_t wires, uint32_t lanes, In f, In s, Out out), (wires, lanes, f, s, out))
COUNTED_RESULT(bool, touches, n, (uint32_t n, In y, In s, In f), (n, y, s, f))
COUNTED(penetrate, (uint64_t)wires *lanes,
        (uint32_t wires, uint32_t lanes, double side, In shift, In w, In v, In rest, In last,
         In load, Out b),
        (wires, lanes, side, shift, w, v, rest, last, load, b))
COUNTED(move_wires, n, (uint32_t n, In own, In f, In rest, In last, In s, Out v, Out eta),
        (n, own, f, rest, last, s, v, eta))
#endif

#if TB_REAL_IS_FLOAT
static const TbKernelsF counting_floats = {
#else
static const TbKernels counting = {
#endif
  .dot = COUNT(dot),
  .two_dots = COUNT(two_dots),
  .axpy = COUNT(axpy),
  .add_product = COUNT(add_product),
  .product = COUNT(product),
  .difference = COUNT(difference),
  .extrapolate = COUNT(extrapolate),
  .gemv = COUNT(gemv),
  .gemm = COUNT(gemm),
  .mix = COUNT(mix),
  .resonate = COUNT(resonate),
  .turn_phases = COUNT(turn_phases),
  .rows_to_grid = COUNT(rows_to_grid),
  .grid_to_rows = COUNT(grid_to_rows),
  .apply_compliance = COUNT(apply_compliance),
  .start = COUNT(start),
  .finish = COUNT(finish),
  .laws = COUNT(laws),
  .change = COUNT(change),
  .cg_apply = COUNT(cg_apply),
  .cg_advance = COUNT(cg_advance),
  .xpby = COUNT(xpby),
  .newton_finish = COUNT(newton_finish),
  .balance = COUNT(balance),
#if TB_REAL_IS_FLOAT
  .narrow = COUNT(narrow),
  .narrow_change = COUNT(narrow_change),
  .widen = COUNT(widen),
  .add_widened = COUNT(add_widened),
  .penetrate = COUNT(penetrate),
  .start_newton_diagonal = COUNT(start_newton_diagonal),
  .trial_at_forces = COUNT(trial_at_forces),
  .trial_moved = COUNT(trial_moved),
  .finish_forces = COUNT(finish_forces),
  .newton_diagonal = COUNT(newton_diagonal),
  .newton_residual = COUNT(newton_residual),
  .sum_scaled = COUNT(sum_scaled),
  .von_karman = COUNT(von_karman),
#else
  .newton_rhs = COUNT(newton_rhs),
  .gemv_rounded = COUNT(gemv_rounded),
  .gemm_rounded = COUNT(gemm_rounded),
  .two_step = COUNT(two_step),
  .stretch = COUNT(stretch),
  .step_and_stretch = COUNT(step_and_stretch),
  .stretch_dots = COUNT(stretch_dots),
  .end_modes = COUNT(end_modes),
  .push_by_sound = COUNT(push_by_sound),
  .two_dots_of_parts = COUNT(two_dots_of_parts),
  .weighted_size = COUNT(weighted_size),
  .losses = COUNT(losses),
  .subtract = COUNT(subtract),
  .wire_step = COUNT(wire_step),
  .radiated_power = COUNT(radiated_power),
  .wire_losses = COUNT(wire_losses),
  .gather_wires = COUNT(gather_wires),
  .touches = COUNT(touches),
  .penetrate = COUNT(penetrate),
  .move_wires = COUNT(move_wires),
#endif
};
