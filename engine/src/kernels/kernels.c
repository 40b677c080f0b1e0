/* SPDX-License-Identifier: MIT */
/* Compiled once per instruction set, with TB_KERNELS naming the table it fills. */
#include "kernels/kernels.h"

#include "kernels/bed.h"
#include "kernels/lanes.h"
#include "kernels/lawlanes.h"
#include "kernels/ringlanes.h"
#include "kernels/rowlanes.h"

static void two_step(uint32_t n, double *out, const double *a, const double *x, const double *b,
                     const double *y) {
  for (uint64_t i = 0; i < n; i += 8) {
    store(out + i, subtract(multiply_lanes(load(a + i), load(x + i)),
                            multiply_lanes(load(b + i), load(y + i))));
  }
}

/* Four blocks side by side: enough independent sums to hide the latency of an addition. */
static void multiply_four(uint32_t n, double *out, const double *matrix, const double *x) {
  const uint64_t block = 8u * (uint64_t)n;
  Lanes s0 = zero(), s1 = zero(), s2 = zero(), s3 = zero();
  for (uint32_t i = 0; i < n; i++) {
    const double *m = matrix + 8u * (uint64_t)i;
    s0 = add(s0, scale(load(m), x[i]));
    s1 = add(s1, scale(load(m + block), x[i]));
    s2 = add(s2, scale(load(m + 2 * block), x[i]));
    s3 = add(s3, scale(load(m + 3 * block), x[i]));
  }
  store(out, s0);
  store(out + 8, s1);
  store(out + 16, s2);
  store(out + 24, s3);
}

static void multiply_two(uint32_t n, double *out, const double *matrix, const double *x) {
  const uint64_t block = 8u * (uint64_t)n;
  Lanes s0 = zero(), s1 = zero();
  for (uint32_t i = 0; i < n; i++) {
    const double *m = matrix + 8u * (uint64_t)i;
    s0 = add(s0, scale(load(m), x[i]));
    s1 = add(s1, scale(load(m + block), x[i]));
  }
  store_unaligned(out, s0);
  store_unaligned(out + 8, s1);
}

static void multiply(uint32_t blocks, uint32_t n, double *out, const double *matrix,
                     const double *x) {
  const uint64_t block = 8u * (uint64_t)n;
  uint32_t b = 0;
  for (; b + 4 <= blocks; b += 4) multiply_four(n, out + 8 * b, matrix + b * block, x);
  for (; b + 2 <= blocks; b += 2) multiply_two(n, out + 8 * b, matrix + b * block, x);
  for (; b < blocks; b++) {
    Lanes sum = zero();
    for (uint32_t i = 0; i < n; i++) {
      sum = add(sum, scale(load(matrix + b * block + 8u * (uint64_t)i), x[i]));
    }
    store(out + 8 * b, sum);
  }
}

/* `count` blocks side by side, a constant where it is called. */
static INLINE void single_blocks(uint32_t count, uint32_t n, double *out, const float *matrix,
                                 const double *x) {
  const uint64_t block = 8u * (uint64_t)n;
  Lanes sum[6];
  for (uint32_t b = 0; b < count; b++) sum[b] = zero();
  for (uint32_t i = 0; i < n; i++) {
    const float *m = matrix + 8u * (uint64_t)i;
#pragma GCC unroll 6 /* or the sums would live in memory */
    for (uint32_t b = 0; b < count; b++) {
      sum[b] = add(sum[b], scale(load_single(m + b * block), x[i]));
    }
  }
  for (uint32_t b = 0; b < count; b++) store(out + 8 * b, sum[b]);
}

/* How many of `left` blocks to take at once: enough to hide the latency of an addition. */
static INLINE uint32_t blocks_at_once(uint32_t left) {
  if (left == 7) return 4;
  return left < 6 ? left : 6;
}

static void multiply_single(uint32_t blocks, uint32_t n, double *out, const float *matrix,
                            const double *x) {
  for (uint32_t b = 0, take; b < blocks; b += take) {
    const float *m = matrix + 8u * (uint64_t)n * b;
    take = blocks_at_once(blocks - b);
    switch (take) { /* one copy of the code for each */
    case 1: single_blocks(1, n, out + 8 * b, m, x); break;
    case 2: single_blocks(2, n, out + 8 * b, m, x); break;
    case 3: single_blocks(3, n, out + 8 * b, m, x); break;
    case 4: single_blocks(4, n, out + 8 * b, m, x); break;
    case 5: single_blocks(5, n, out + 8 * b, m, x); break;
    default: single_blocks(6, n, out + 8 * b, m, x); break;
    }
  }
}

/* `count` blocks side by side of each of the vectors; all constants where it is called. */
static INLINE void gather_blocks(bool single, uint32_t vectors, uint32_t count, const TbGather *g,
                                 uint32_t block) {
  const uint64_t stride = 8u * (uint64_t)g->n, from = stride * block;
  Lanes sum[2][2] = {{zero(), zero()}, {zero(), zero()}};
  for (uint32_t i = 0; i < g->part; i++) {
#pragma GCC unroll 2 /* or the sums would live in memory */
    for (uint32_t b = 0; b < count; b++) {
      const uint64_t at = from + b * stride + 8u * (uint64_t)i;
      const Lanes m = single ? load_single(g->single + at) : load(g->matrix + at);
#pragma GCC unroll 2
      for (uint32_t v = 0; v < vectors; v++) sum[v][b] = add(sum[v][b], scale(m, g->x[v][i]));
    }
  }
  for (uint32_t v = 0; v < vectors; v++) {
    for (uint32_t b = 0; b < count; b++) store(g->out[v] + 8 * (block + b), sum[v][b]);
  }
}

static INLINE void gather_all(bool single, uint32_t vectors, const TbGather *g) {
  uint32_t b = 0;
  for (; b + 2 <= g->blocks; b += 2) gather_blocks(single, vectors, 2, g, b);
  for (; b < g->blocks; b++) gather_blocks(single, vectors, 1, g, b);
}

static void gather(const TbGather *g) {
  switch (g->vectors + (g->single ? 2u : 0u)) { /* one copy of the code for each */
  case 1: gather_all(false, 1, g); break;
  case 2: gather_all(false, 2, g); break;
  case 3: gather_all(true, 1, g); break;
  default: gather_all(true, 2, g); break;
  }
}

/* From a copy of `out`, which what is stored might else change, for all that the compiler knows. */
static INLINE void stretch_heads(uint32_t heads, const TbParts *parts, TbStretching *out) {
  const TbStretching s = *out;
  Lanes along[2] = {zero(), zero()}, own[2][2] = {{zero(), zero()}, {zero(), zero()}};
  for (uint32_t part = 0; part < parts->count; part++) {
    const uint32_t end = parts->from[part] + parts->size[part];
    for (uint64_t i = parts->from[part]; i < end; i += 8) {
      const Lanes q = load(s.q + i), g = load(s.g + i);
      const Lanes moved = add(load(s.next + i), load(s.last + i));
      Lanes y[2], pull[2];
#pragma GCC unroll 2 /* or the sums would live in memory */
      for (uint32_t h = 0; h < heads; h++) {
        y[h] = multiply_lanes(load(s.gain[h] + i), q);
        pull[h] = multiply_lanes(g, y[h]);
        store(s.pull[h] + i, pull[h]);
        along[h] = add(along[h], multiply_lanes(y[h], moved));
        for (uint32_t l = 0; l <= h; l++) {
          own[h][l] = add(own[h][l], multiply_lanes(y[h], pull[l]));
        }
      }
    }
  }
  for (uint32_t h = 0; h < heads; h++) {
    out->along[h] = join(along[h]);
    for (uint32_t l = 0; l <= h; l++) out->own[h][l] = out->own[l][h] = join(own[h][l]);
  }
}

static void stretch(const TbParts *parts, TbStretching *s) {
  if (s->heads == 2) {
    stretch_heads(2, parts, s);
  } else {
    stretch_heads(1, parts, s);
  }
}

static INLINE void unstretch_heads(uint32_t heads, const TbParts *parts, const double f[2],
                                   const double *const pull[2], double *next) {
  const double first = f[0], second = f[heads - 1];
  const double *const first_pull = pull[0], *const second_pull = pull[heads - 1];
  for (uint32_t part = 0; part < parts->count; part++) {
    const uint32_t end = parts->from[part] + parts->size[part];
    for (uint64_t i = parts->from[part]; i < end; i += 8) {
      Lanes sum = add(load(next + i), scale(load(first_pull + i), first));
      if (heads == 2) sum = add(sum, scale(load(second_pull + i), second));
      store(next + i, sum);
    }
  }
}

static void unstretch(const TbParts *parts, uint32_t heads, const double f[2],
                      const double *const pull[2], double *next) {
  if (heads == 2) {
    unstretch_heads(2, parts, f, pull, next);
  } else {
    unstretch_heads(1, parts, f, pull, next);
  }
}

static double reach(uint32_t n, const double *c, const double *x) {
  Lanes sum = zero();
  for (uint64_t i = 0; i < n; i += 8) {
    sum = add(sum, multiply_lanes(load(c + i), size_of(load(x + i))));
  }
  return join(sum);
}

static INLINE void losses_of(uint32_t count, uint32_t n, const double *const w[3],
                             const double *next, const double *last, double sums[3]) {
  Lanes sum[3] = {zero(), zero(), zero()};
  for (uint64_t i = 0; i < n; i += 8) {
    const Lanes step = subtract(load(next + i), load(last + i));
    const Lanes square = multiply_lanes(step, step);
    for (uint32_t j = 0; j < count; j++) {
      sum[j] = add(sum[j], multiply_lanes(load(w[j] + i), square));
    }
  }
  for (uint32_t j = 0; j < count; j++) sums[j] = join(sum[j]);
}

static void losses(uint32_t n, uint32_t count, const double *const w[3], const double *next,
                   const double *last, double sums[3]) {
  if (count == 3) {
    losses_of(3, n, w, next, last, sums);
  } else {
    losses_of(2, n, w, next, last, sums);
  }
}

/* ---- the bed -------------------------------------------------------------------------------- */

/* Where the mirror image of a wire stands. */
static INLINE uint32_t image_of(const TbBed *bed, uint32_t wire) {
  return bed->quarters == 2 ? bed->wires - 1u - wire : wire;
}

/* One of each pair. */
static INLINE uint32_t pairs_of(const TbBed *bed) {
  return bed->quarters == 2 ? (bed->wires + 1u) / 2u : bed->wires;
}

/* Up to four lines at once, `n` of them known when compiled. */
static INLINE void gather_some(uint32_t n, bool odd, const TbBed *bed, uint32_t line,
                               const double *x, double *to) {
  Lanes sum[4] = {zero(), zero(), zero(), zero()};
  for (uint32_t w = 0; w < pairs_of(bed); w++) {
    const uint32_t image = image_of(bed, w);
    const double *c = bed->across + (uint64_t)w * bed->lines + line;
    Lanes v = load(x + (uint64_t)w * bed->lanes);
    if (image != w) {
      const Lanes other = load(x + (uint64_t)image * bed->lanes);
      v = odd ? subtract(v, other) : add(v, other);
    }
    for (uint32_t l = 0; l < n; l++) sum[l] = add(sum[l], scale(v, c[l]));
  }
  for (uint32_t l = 0; l < n; l++) store(to + (uint64_t)(line + l) * bed->lanes, sum[l]);
}

static INLINE void gather_parity(bool odd, const TbBed *bed, const double *x, double *to) {
  const uint32_t end = odd ? bed->lines : bed->first_line[1];
  for (uint32_t l = odd ? bed->first_line[1] : 0; l < end; l += 4) {
    switch (end - l) {
    case 1: gather_some(1, odd, bed, l, x, to); break;
    case 2: gather_some(2, odd, bed, l, x, to); break;
    case 3: gather_some(3, odd, bed, l, x, to); break;
    default: gather_some(4, odd, bed, l, x, to); break;
    }
  }
}

static void gather_lines(const TbBed *bed, const double *x, double *lines) {
  for (uint32_t at = 0; at < bed->lanes; at += 8) {
    gather_parity(false, bed, x + at, lines + at);
    gather_parity(true, bed, x + at, lines + at);
  }
}

static INLINE Lanes spread_some(const TbBed *bed, uint32_t from, uint32_t end, const double *across,
                                const double *lines) {
  Lanes sum = zero();
  for (uint32_t l = from; l < end; l++) {
    sum = add(sum, scale(load(lines + (uint64_t)l * bed->lanes), across[l]));
  }
  return sum;
}

static void spread_lines(const TbBed *bed, const double *lines, double *x) {
  const uint32_t even = bed->first_line[1];
  for (uint32_t w = 0; w < pairs_of(bed); w++) {
    const double *across = bed->across + (uint64_t)w * bed->lines;
    double *own = x + (uint64_t)w * bed->lanes,
           *image = x + (uint64_t)image_of(bed, w) * bed->lanes;
    for (uint32_t at = 0; at < bed->lanes; at += 8) {
      const Lanes s = spread_some(bed, 0, even, across, lines + at);
      const Lanes d = spread_some(bed, even, bed->lines, across, lines + at);
      store(image + at, subtract(s, d));
      store(own + at, add(s, d));
    }
  }
}

/* ---- wires ---------------------------------------------------------------------------------- */

static INLINE Lanes second_difference(const double *v) {
  const Lanes middle = load(v);
  return add(subtract(load_unaligned(v - 1), middle), subtract(load_unaligned(v + 1), middle));
}

static void bend_wires(uint32_t n, const double *inner, const double *v, double *bend) {
  for (uint64_t i = 0; i < n; i += 8) {
    store(bend + i, multiply_lanes(load(inner + i), second_difference(v + i)));
  }
}

static void wire_step(uint32_t wires, uint32_t lanes, const TbWireCoefficients *coefficients,
                      const double *inner, const double *now, const double *last, double *bend,
                      double *next) {
  bend_wires(wires * lanes, inner, now, bend);
  for (uint32_t w = 0; w < wires; w++) {
    const TbWireCoefficients c = coefficients[w];
    for (uint64_t i = w * lanes; i < (w + 1u) * lanes; i += 8) {
      const Lanes curve = load(bend + i);
      Lanes push = scale(curve, c.stretch);
      push = subtract(push, scale(second_difference(bend + i), c.bend));
      push = add(push, scale(subtract(curve, second_difference(last + i)), c.diffuse));
      /* As a change: a wire that hangs far away may not lose or gain by rounding where it is. */
      const Lanes at = load(now + i), coast = scale(subtract(at, load(last + i)), c.keep);
      store(next + i, multiply_lanes(load(inner + i), add(at, scale(add(coast, push), c.gain))));
    }
  }
}

static double wire_losses(uint32_t wires, uint32_t lanes, const TbWireCoefficients *c,
                          const double *next, const double *last) {
  Lanes sum = zero();
  for (uint32_t w = 0; w < wires; w++) {
    for (uint64_t i = w * lanes; i < (w + 1u) * lanes; i += 8) {
      const Lanes step = subtract(load(next + i), load(last + i));
      const Lanes slope =
        subtract(step, subtract(load_unaligned(next + i - 1), load_unaligned(last + i - 1)));
      sum = add(sum, add(scale(multiply_lanes(step, step), c[w].loss_0),
                         scale(multiply_lanes(slope, slope), c[w].loss_1)));
    }
  }
  return join(sum);
}

static double gather_wires(uint32_t wires, uint32_t lanes, const double *f, const double *loss,
                           double *out) {
  Lanes lost = zero();
  for (uint32_t i = 0; i < lanes; i += 8) {
    Lanes sum = zero();
    for (uint32_t w = 0; w < wires; w++) {
      const uint32_t at = w * lanes + i;
      const Lanes force = load(f + at);
      sum = add(sum, force);
      lost = add(lost, multiply_lanes(load(loss + at), force));
    }
    store(out + i, sum);
  }
  return join(lost);
}

/* ---- contacts ------------------------------------------------------------------------------- */

static void law_of(const TbLaw *law, uint32_t power, uint32_t n, const double *y, const double *s,
                   double *force, double *slope, double *mean) {
  law_of_power(law, power, n, (LawArrays){y, NULL, s, force, slope, mean});
}

static bool touches(uint32_t n, const double *y, const double *s, const double *f) {
  for (uint64_t i = 0; i < n; i += 8) {
    const Lanes before = load(y + i), after = add(before, load(s + i));
    const Lanes most = larger(larger(before, after), size_of(load(f + i)));
    if (any(greater(most, zero()))) return true;
  }
  return false;
}

static TbPair sizes(uint32_t n, const double *b, const double *y) {
  Lanes most = zero(), deepest = zero();
  for (uint64_t i = 0; i < n; i += 8) {
    most = larger(size_of(load(b + i)), most);
    deepest = larger(load(y + i), deepest);
  }
  return (TbPair){largest_of(most), largest_of(deepest)};
}

static void subtract_arrays(uint32_t n, const double *x, const double *y, double *out) {
  for (uint64_t i = 0; i < n; i += 8) store(out + i, subtract(load(x + i), load(y + i)));
}

static double residual(uint32_t n, const double *s, const double *b, const double *p, double *r) {
  Lanes most = zero();
  for (uint64_t i = 0; i < n; i += 8) {
    const Lanes left = add(load(p + i), subtract(load(s + i), load(b + i)));
    store(r + i, left);
    most = larger(size_of(left), most);
  }
  return largest_of(most);
}

static void weigh(uint32_t n, const double *slope, double *weight, double *r) {
  for (uint64_t i = 0; i < n; i += 8) {
    const Lanes w = root(load(slope + i));
    store(weight + i, w);
    store(r + i, subtract(zero(), multiply_lanes(w, load(r + i))));
  }
}

static void balance(uint32_t n, double t, const double *s_at, const double *law,
                    const double *slope, const double *f_at, const double *f_last, const double *p,
                    const double *p_last, double sums[3]) {
  Lanes value = zero(), derivative = zero(), size = zero();
  for (uint64_t i = 0; i < n; i += 8) {
    const Lanes s = load(s_at + i), f = load(f_at + i), g = subtract(f, load(f_last + i));
    const Lanes m = subtract(load(p + i), load(p_last + i)), moved = add(f, scale(g, t));
    const Lanes left = subtract(load(law + i), moved);
    const Lanes bend = multiply_lanes(s, add(multiply_lanes(load(slope + i), m), g));
    value = add(value, multiply_lanes(s, left));
    derivative = subtract(derivative, add(multiply_lanes(m, left), bend));
    size = add(size, size_of(multiply_lanes(s, moved)));
  }
  sums[0] = join(value);
  sums[1] = join(derivative);
  sums[2] = join(size);
}

static double lost(uint32_t n, const double *s, const double *f, const double *mean) {
  Lanes sum = zero();
  for (uint64_t i = 0; i < n; i += 8) {
    sum = add(sum, multiply_lanes(load(s + i), subtract(load(f + i), load(mean + i))));
  }
  return join(sum);
}

static void penetrate(uint32_t wires, uint32_t lanes, double side, const double *shift,
                      const double *w, const double *v, const double *rest, const double *last,
                      const double *load_at, double *b) {
  for (uint32_t wire = 0; wire < wires; wire++) {
    const Lanes shifted = all(shift[wire]);
    for (uint64_t i = wire * lanes; i < (wire + 1u) * lanes; i += 8) {
      const Lanes deviation = subtract(scale(load(w + i), side), load(v + i));
      const Lanes eta = add(add(deviation, load(rest + i)), shifted);
      store(b + i, add(subtract(eta, load(last + i)), load(load_at + i)));
    }
  }
}

static void move(uint32_t n, const double *own, const double *f, const double *rest,
                 const double *last, const double *s, double *v, double *eta) {
  for (uint64_t i = 0; i < n; i += 8) {
    const Lanes change = subtract(load(f + i), load(rest + i));
    store(v + i, add(load(v + i), multiply_lanes(load(own + i), change)));
    store(eta + i, add(load(last + i), load(s + i)));
  }
}

const TbKernels TB_KERNELS = {
  .two_step = two_step,
  .multiply = multiply,
  .multiply_single = multiply_single,
  .gather = gather,
  .stretch = stretch,
  .unstretch = unstretch,
  .reach = reach,
  .dot = dot,
  .add_scaled = add_scaled,
  .ring = ring,
  .add_product = add_product,
  .two_dots = two_dots,
  .losses = losses,
  .gather_lines = gather_lines,
  .spread_lines = spread_lines,
  .wire_step = wire_step,
  .wire_losses = wire_losses,
  .gather_wires = gather_wires,
  .law = law_of,
  .touches = touches,
  .sizes = sizes,
  .difference = difference,
  .subtract = subtract_arrays,
  .extrapolate = extrapolate,
  .residual = residual,
  .weigh = weigh,
  .balance = balance,
  .lost = lost,
  .penetrate = penetrate,
  .move = move,
  .product = product,
  .turn = turn,
  .advance = advance,
  .redirect = redirect,
};
