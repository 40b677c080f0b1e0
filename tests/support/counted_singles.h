/* SPDX-License-Identifier: MIT */
/* The kernels of single precision, counted: the second half of test_system_work.c, which has the counters. */
#ifndef TEST_COUNTED_SINGLES_H
#define TEST_COUNTED_SINGLES_H

#include "kernels/singlekernels.h"

static const TbSingleKernels *single_counted = &tb_single_kernels_baseline;

#define COUNTED_SINGLE(name, elements, parameters, arguments)                                      \
  static void count_single_##name parameters {                                                     \
    work += (elements);                                                                            \
    single_counted->name arguments;                                                                \
  }
#define COUNTED_SINGLE_RESULT(type, name, elements, parameters, arguments)                         \
  static type count_single_##name parameters {                                                     \
    work += (elements);                                                                            \
    return single_counted->name arguments;                                                         \
  }
typedef float *Out1;
typedef const float *In1;
typedef const TbSingleBed *Bed1;

COUNTED_SINGLE(narrow, n, (uint32_t n, In x, Out1 out), (n, x, out))
COUNTED_SINGLE(narrow_change, n, (uint32_t n, In x, In y, Out1 out), (n, x, y, out))
COUNTED_SINGLE(widen, n, (uint32_t n, In1 x, Out out), (n, x, out))
COUNTED_SINGLE(add_widened, n, (uint32_t n, In1 x, Out out), (n, x, out))
COUNTED_SINGLE(start, n, (uint32_t n, TbSingleStart *start), (n, start))
COUNTED_SINGLE(end, n, (uint32_t n, TbSingleEnd *end), (n, end))
COUNTED_SINGLE(gather, (8ull * g->blocks + g->rest) * g->vectors * g->part,
               (const TbSingleGather *g), (g))
COUNTED_SINGLE(combine, (uint64_t)n *count,
               (uint32_t n, uint32_t count, In1 f, In1 const *x, In1 base, Out1 out),
               (n, count, f, x, base, out))
COUNTED_SINGLE_RESULT(TbPair, ring, r->parts.part[r->parts.count - 1].end, (const TbSingleRing *r),
                      (r))
COUNTED_SINGLE_RESULT(TbPair, two_dots, n, (uint32_t n, In1 u, In1 v, In1 x), (n, u, v, x))
COUNTED_SINGLE_RESULT(bool, penetrate, n,
                      (uint32_t n, float side, In1 w, In v, In v_last, In load, In y, Out b),
                      (n, side, w, v, v_last, load, y, b))
COUNTED_SINGLE(contract, (uint64_t)bed->lines * bed->lanes * (bed->wires + bed->padded),
               (Bed1 bed, In1 x, Out1 scratch, Out1 grid), (bed, x, scratch, grid))
COUNTED_SINGLE(comply, (uint64_t)bed->size * bed->size / bed->classes,
               (Bed1 bed, In1 grid, Out1 out), (bed, grid, out))
COUNTED_SINGLE_RESULT(float, difference, n, (uint32_t n, In1 x, In1 y), (n, x, y))
COUNTED_SINGLE(relax, n, (uint32_t n, In1 law, In1 slope, In1 own, In1 head, In1 f_last, Out1 f),
               (n, law, slope, own, head, f_last, f))
COUNTED_SINGLE_RESULT(float, change, n, (uint32_t n, In1 b, In1 p, Out1 s), (n, b, p, s))
COUNTED_SINGLE_RESULT(float, follow, n,
                      (uint32_t n, In1 law, In1 weight, In1 x, In1 b, In1 p, Out1 f, Out1 s),
                      (n, law, weight, x, b, p, f, s))
COUNTED_SINGLE_RESULT(float, dot, n, (uint32_t n, In1 x, In1 y), (n, x, y))
COUNTED_SINGLE(add_scaled, n, (uint32_t n, Out1 out, float f, In1 x), (n, out, f, x))
COUNTED_SINGLE(add_product, n, (uint32_t n, Out1 out, In1 x, In1 y), (n, out, x, y))
COUNTED_SINGLE(product, n, (uint32_t n, Out1 out, In1 x, In1 y), (n, out, x, y))
COUNTED_SINGLE_RESULT(float, weigh, n,
                      (uint32_t n, In1 slope, In1 p, In1 p_last, Out1 weight, Out1 d),
                      (n, slope, p, p_last, weight, d))
COUNTED_SINGLE_RESULT(float, turn, n, (uint32_t n, Out1 out, In1 d, In1 w, In1 m),
                      (n, out, d, w, m))
COUNTED_SINGLE_RESULT(float, advance, n, (uint32_t n, float t, Out1 p, In1 d, Out1 r, In1 m),
                      (n, t, p, d, r, m))
COUNTED_SINGLE(redirect, n, (uint32_t n, float t, Out1 d, In1 r), (n, t, d, r))
COUNTED_SINGLE_RESULT(TbSingleSums, balance, n,
                      (uint32_t n, float t, In1 s, In1 law, In1 slope, In1 f, In1 f_last, In1 p,
                       In1 p_last),
                      (n, t, s, law, slope, f, f_last, p, p_last))
COUNTED_SINGLE(extrapolate, n, (uint32_t n, float t, In1 x, In1 before, In1 base, Out1 out),
               (n, t, x, before, base, out))

static void count_single_expand(Bed1 bed, In1 grid, Out1 scratch, Out1 x) {
  products++;
  work += (uint64_t)bed->lines * bed->lanes * (bed->wires + bed->columns);
  single_counted->expand(bed, grid, scratch, x);
}

static void count_single_laws(uint32_t wires, uint32_t lanes, const TbLaw *laws_of, In1 y, In1 root,
                              In1 s, Out1 force, Out1 slope, Out1 mean) {
  laws += (uint64_t)wires * lanes;
  work += (uint64_t)wires * lanes;
  single_counted->laws(wires, lanes, laws_of, y, root, s, force, slope, mean);
}

static const TbSingleKernels counting_singles = {.narrow = count_single_narrow,
                                                 .narrow_change = count_single_narrow_change,
                                                 .widen = count_single_widen,
                                                 .add_widened = count_single_add_widened,
                                                 .start = count_single_start,
                                                 .end = count_single_end,
                                                 .gather = count_single_gather,
                                                 .combine = count_single_combine,
                                                 .ring = count_single_ring,
                                                 .two_dots = count_single_two_dots,
                                                 .penetrate = count_single_penetrate,
                                                 .contract = count_single_contract,
                                                 .expand = count_single_expand,
                                                 .comply = count_single_comply,
                                                 .laws = count_single_laws,
                                                 .difference = count_single_difference,
                                                 .relax = count_single_relax,
                                                 .change = count_single_change,
                                                 .follow = count_single_follow,
                                                 .dot = count_single_dot,
                                                 .add_scaled = count_single_add_scaled,
                                                 .add_product = count_single_add_product,
                                                 .product = count_single_product,
                                                 .weigh = count_single_weigh,
                                                 .turn = count_single_turn,
                                                 .advance = count_single_advance,
                                                 .redirect = count_single_redirect,
                                                 .balance = count_single_balance,
                                                 .extrapolate = count_single_extrapolate};

#endif
