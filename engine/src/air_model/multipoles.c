/* SPDX-License-Identifier: MIT */
#include "air_model/multipoles.h"

#include <math.h>
#include <string.h>

#include "math/bessel.h"
#include "math/portable_math.h"
#include "math/quadrature.h"

static const double PI = 3.14159265358979323846;

/* Rounding in c_n comes back times h_n(x s), s >= 2, which stays below 1e4 for the degrees that so
 * many digits take from here on: x = 22 for 10.5 digits, x = 3.2 for four. */
bool tb_multipoles_project(const TbAirPlan *plan) {
  const double digits = plan->precision.digits;
  return plan->x > 0.2 * digits * digits;
}

/* ---- Legendre functions L_n of order m, Int_{-1}^1 L_n^2 = 2, without (-1)^m ----------------- */

/* g_n^2, with u L_n = g_{n+1} L_{n+1} + g_n L_{n-1}, g_m = 0 ([DLMF] 14.10.3, normalised). */
static double coupling_square(uint32_t m, uint32_t n) {
  return ((double)n * n - (double)m * m) / (4.0 * n * n - 1.0);
}

/* L_m(0); L_m(u) is s^m times that, s = sqrt(1 - u^2). */
static double first_of(uint32_t m) {
  double square = 1.0;
  for (uint32_t k = 1; k <= m; k++) square *= 1.0 + 0.5 / (double)k;
  return sqrt(square);
}

/* on_disc[n] = L_n(0) for even n - m, L_n'(0) for odd ones. */
static void legendre_on_disc(uint32_t m, uint32_t degrees, double *on_disc) {
  double g = 0.0;
  on_disc[m] = first_of(m);
  for (uint32_t n = m + 1; n <= degrees; n++) {
    const double slope = (n - m) % 2 ? on_disc[n - 1] : 0.0, before = g;
    g = sqrt(coupling_square(m, n));
    on_disc[n] = (slope - (n > m + 1 ? before * on_disc[n - 2] : 0.0)) / g;
  }
}

/* ---- by integrals over the disc -------------------------------------------------------------- */

/* Nodes r = sin t with weights dt, and the integrands over sqrt(r): j_n takes that from J_{n+1/2}.
 */
typedef struct Disc {
  uint32_t count;
  double *r;
  double *shape;             /* w r cos t dt */
  double *jump_re, *jump_im; /* p cos t dt */
} Disc;

static bool disc_shape(const TbAirPlan *plan, TbArena *scratch, const TbAirSource *source,
                       const double *weights, Disc *disc) {
  const TbAirOrder *order = plan->order;
  double *j = tb_arena_doubles(scratch, disc->count);
  if (!j) return false;
  for (uint32_t i = 0; i < order->count; i++) {
    if (source->v[i] == 0.0) continue;
    tb_bessel_table_values(order->table, order->m, disc->count, order->zeros[i], disc->r, j);
    for (uint32_t q = 0; q < disc->count; q++) disc->shape[q] += source->v[i] * j[q];
  }
  for (uint32_t q = 0; q < disc->count; q++) {
    disc->shape[q] *= disc->r[q] * weights[q];
  }
  return true;
}

/* p(r) = Sum_n a_n p_n(r), p_n the inverse of kappa^{-3/2} J_{mu_n} ([DLMF] 10.22.56):
 * p_n = r^m (1 - r^2)^{1/2} n!/(sqrt(2) Gamma(n + 3/2)) P_n^{(m,1/2)}(1 - 2 r^2), Jacobi's
 * polynomial. */
static void jump_at(const TbAirPlan *plan, const double *a, double r, double jump[2]) {
  const double alpha = (double)plan->order->m, beta = 0.5, y = 1.0 - 2.0 * r * r;
  double last = 0.0, here = 1.0, scale = sqrt(2.0 / PI);
  jump[0] = jump[1] = 0.0;
  for (uint32_t n = 0; n < plan->terms; n++) {
    jump[0] += a[2 * n] * scale * here;
    jump[1] += a[2 * n + 1] * scale * here;
    const double k = (double)n + 1.0, c = 2.0 * k + alpha + beta; /* [DLMF] 18.9.2 */
    const double next = n == 0
                          ? 0.5 * (alpha - beta + (alpha + beta + 2.0) * y)
                          : ((c - 1.0) * (c * (c - 2.0) * y + alpha * alpha - beta * beta) * here -
                             2.0 * (k + alpha - 1.0) * (k + beta - 1.0) * c * last) /
                              (2.0 * k * (k + alpha + beta) * (c - 2.0));
    last = here;
    here = next;
    scale *= k / (k + 0.5);
  }
  const double edge = tb_whole_power(r, plan->order->m) * sqrt(1.0 - r * r);
  jump[0] *= edge;
  jump[1] *= edge;
}

static bool disc_prepare(const TbAirPlan *plan, TbArena *scratch, const TbAirSource *source,
                         Disc *disc) {
  const double shape = fmax(plan->zero, (double)plan->order->m + 2.0 * plan->terms);
  const double turns = 0.5 * PI * (shape + (double)plan->degrees);
  const uint32_t panels = 1u + (uint32_t)(turns / plan->precision.panel);
  disc->count = panels * TB_PANEL;
  disc->r = tb_arena_doubles(scratch, disc->count);
  disc->shape = tb_arena_doubles(scratch, disc->count);
  disc->jump_re = tb_arena_doubles(scratch, disc->count);
  disc->jump_im = tb_arena_doubles(scratch, disc->count);
  double *weights = tb_arena_doubles(scratch, disc->count);
  if (scratch->failed) return false;
  tb_quadrature(0.0, 0.5 * PI, panels, disc->r, weights);
  for (uint32_t q = 0; q < disc->count; q++) {
    double cosine;
    tb_sin_cos(disc->r[q], &disc->r[q], &cosine);
    weights[q] *= cosine / sqrt(disc->r[q]);
  }
  if (source->baffled != 0.0 && !disc_shape(plan, scratch, source, weights, disc)) return false;
  for (uint32_t q = 0; q < disc->count && source->open != 0.0; q++) {
    double jump[2];
    jump_at(plan, source->a, disc->r[q], jump);
    disc->jump_re[q] = weights[q] * jump[0];
    disc->jump_im[q] = weights[q] * jump[1];
  }
  return true;
}

/* c_n += eight nodes' integrands times J_{n+1/2}. */
static void add_eight(const TbMultipoles *waves, const Disc *disc, uint32_t from,
                      const double *half) {
  const double *shape = disc->shape + from, *re = disc->jump_re + from, *im = disc->jump_im + from;
  for (uint32_t n = waves->m; n <= waves->degrees; n++) {
    const double *j = half + 8 * n;
    double *c = waves->c + 2 * n;
    const bool odd = (n - waves->m) % 2;
    for (uint32_t l = 0; l < 8; l++) c[0] += j[l] * (odd ? re[l] : shape[l]);
    for (uint32_t l = 0; l < 8 && odd; l++) c[1] += j[l] * im[l];
  }
}

static bool by_disc(TbMultipoles *waves, const TbAirPlan *plan, TbArena *scratch,
                    const TbAirSource *source) {
  Disc disc;
  double *half = tb_arena_doubles(scratch, 8 * ((size_t)waves->degrees + 1));
  double *on_disc = tb_arena_doubles(scratch, (size_t)waves->degrees + 2);
  if (scratch->failed || !disc_prepare(plan, scratch, source, &disc)) return false;
  for (uint32_t q = 0; q < disc.count; q += 8) {
    double argument[8];
    for (uint32_t l = 0; l < 8; l++) argument[l] = waves->x * disc.r[q + l];
    tb_bessel_half8(argument, waves->degrees + 1, half);
    add_eight(waves, &disc, q, half);
  }
  legendre_on_disc(waves->m, waves->degrees, on_disc);
  const double unit = sqrt(0.5 * PI / waves->x); /* j_n(x r) = sqrt(pi/(2 x r)) J_{n+1/2}(x r) */
  for (uint32_t n = waves->m; n <= waves->degrees; n++) {
    const double part = (n - waves->m) % 2 ? source->open : source->baffled;
    waves->c[2 * n] *= part * unit * on_disc[n];
    waves->c[2 * n + 1] *= part * unit * on_disc[n];
  }
  return true;
}

/* ---- by projection of the far field ---------------------------------------------------------- */

/* Far fields at the nodes below x with the weight sin t dt, and Legendre functions of two degrees.
 */
typedef struct Sphere {
  uint32_t count;
  double *u_square, *first, *shape, *jump_re, *jump_im, *here, *last;
} Sphere;

static bool sphere_prepare(Sphere *sphere, const TbWavenumberNodes *nodes, TbArena *scratch,
                           const TbAirSource *source, uint32_t m) {
  const double x = nodes->x, first = first_of(m);
  sphere->count = nodes->below;
  double **arrays[] = {&sphere->u_square, &sphere->first, &sphere->shape, &sphere->jump_re,
                       &sphere->jump_im,  &sphere->here,  &sphere->last};
  for (int i = 0; i < 7; i++) *arrays[i] = tb_arena_doubles(scratch, sphere->count);
  if (scratch->failed) return false;
  for (uint32_t q = 0; q < sphere->count; q++) {
    const double sine = nodes->kappa[q] / x, u = nodes->root[q] / x;
    const double weight = nodes->weights[q] * sine / x;
    sphere->u_square[q] = u * u;
    sphere->first[q] = first * tb_whole_power(sine, m);
    if (source->baffled != 0.0) sphere->shape[q] = source->baffled * weight * source->w[q];
    if (source->open == 0.0) continue;
    sphere->jump_re[q] = source->open * weight * nodes->root[q] * source->p[2 * q];
    sphere->jump_im[q] = source->open * weight * nodes->root[q] * source->p[2 * q + 1];
  }
  return true;
}

static double dot(uint32_t count, const double *a, const double *b) {
  double sum[4] = {0.0};
  for (uint32_t q = 0; q < count; q += 4) { /* nodes come in panels of 16 */
    for (uint32_t l = 0; l < 4; l++) sum[l] += a[q + l] * b[q + l];
  }
  return sum[0] + sum[1] + (sum[2] + sum[3]);
}

/* here, last := L_{n+2}, L_n. */
static void next_but_one(Sphere *sphere, uint32_t m, uint32_t n) {
  const double above = sqrt(coupling_square(m, n + 1) * coupling_square(m, n + 2));
  const double below = n < m + 2 ? 0.0 : sqrt(coupling_square(m, n) * coupling_square(m, n - 1));
  const double middle = coupling_square(m, n + 1) + coupling_square(m, n);
  const double a = 1.0 / above, b = middle / above, c = below / above;
  double *restrict last = sphere->last;
  const double *restrict here = sphere->here, *restrict u_square = sphere->u_square;
  for (uint32_t q = 0; q < sphere->count; q++) {
    last[q] = (a * u_square[q] - b) * here[q] - c * last[q];
  }
  double *swap = sphere->here;
  sphere->here = sphere->last;
  sphere->last = swap;
}

/* c_n for even n - m, which the shape gives. */
static void project_shape(TbMultipoles *waves, Sphere *sphere) {
  for (uint32_t q = 0; q < sphere->count; q++) {
    sphere->here[q] = sphere->first[q];
    sphere->last[q] = 0.0;
  }
  double sign = 1.0;
  for (uint32_t n = waves->m; n <= waves->degrees; n += 2, sign = -sign) {
    waves->c[2 * n] = sign * dot(sphere->count, sphere->shape, sphere->here);
    next_but_one(sphere, waves->m, n);
  }
}

/* c_n for odd n - m, which the jump gives. */
static void project_jump(TbMultipoles *waves, Sphere *sphere) {
  const double second = 1.0 / sqrt(coupling_square(waves->m, waves->m + 1));
  for (uint32_t q = 0; q < sphere->count; q++) {
    sphere->here[q] = second * sqrt(sphere->u_square[q]) * sphere->first[q];
    sphere->last[q] = 0.0;
  }
  double sign = 1.0;
  for (uint32_t n = waves->m + 1; n <= waves->degrees; n += 2, sign = -sign) {
    waves->c[2 * n] = sign * dot(sphere->count, sphere->jump_re, sphere->here);
    waves->c[2 * n + 1] = sign * dot(sphere->count, sphere->jump_im, sphere->here);
    next_but_one(sphere, waves->m, n);
  }
}

static bool by_projection(TbMultipoles *waves, TbArena *scratch, const TbWavenumberNodes *nodes,
                          const TbAirSource *source) {
  Sphere sphere;
  if (!sphere_prepare(&sphere, nodes, scratch, source, waves->m)) return false;
  if (source->baffled != 0.0) project_shape(waves, &sphere);
  if (source->open != 0.0) project_jump(waves, &sphere);
  return true;
}

bool tb_multipoles_prepare(TbMultipoles *waves, const TbAirPlan *plan, TbArena *scratch,
                           const TbWavenumberNodes *nodes, const TbAirSource *source) {
  *waves = (TbMultipoles){.m = plan->order->m, .degrees = plan->degrees, .x = plan->x};
  waves->c = tb_arena_doubles(scratch, 2 * ((size_t)plan->degrees + 1));
  waves->couplings = tb_arena_doubles(scratch, (size_t)plan->degrees + 2);
  if (scratch->failed) return false;
  for (uint32_t n = waves->m + 1; n <= waves->degrees + 1; n++) {
    waves->couplings[n] = sqrt(coupling_square(waves->m, n));
  }
  return tb_multipoles_project(plan) ? by_projection(waves, scratch, nodes, source)
                                     : by_disc(waves, plan, scratch, source);
}

/* ---- the field ------------------------------------------------------------------------------- */

/* If h_n leaves the range of numbers, c_n h_n is below s^-n: nothing. */
static const double LARGEST = 1e250;

void tb_multipoles_at(const TbMultipoles *waves, double radius, double height, double field[2]) {
  const uint32_t m = waves->m;
  const double s = tb_hypot(radius, height), u = height / s, rho = waves->x * s;
  double sine, cosine;
  tb_sin_cos(rho, &sine, &cosine);
  const double c = cosine / rho, d = sine / rho;
  double h[2] = {d, c};                         /* h_0 = i e^{-i rho}/rho */
  double above[2] = {d / rho - c, c / rho + d}; /* h_1 = (1/rho + i) h_0 */
  double sum[2] = {0.0}, last = 0.0;
  double here = first_of(m) * tb_whole_power(radius / s, m);
  const double *g = waves->couplings, inverse = 1.0 / rho;
  for (uint32_t n = 0; n <= waves->degrees && fabs(h[1]) < LARGEST; n++) {
    if (n >= m) {
      const double re = waves->c[2 * n], im = waves->c[2 * n + 1];
      sum[0] += here * (re * h[0] - im * h[1]);
      sum[1] += here * (re * h[1] + im * h[0]);
      const double next = (u * here - g[n] * last) / g[n + 1];
      last = here;
      here = next;
    }
    for (int i = 0; i < 2; i++) {
      const double next = (2.0 * n + 3.0) * inverse * above[i] - h[i];
      h[i] = above[i];
      above[i] = next;
    }
  }
  field[0] = waves->x * sum[1]; /* -i x sum */
  field[1] = -waves->x * sum[0];
}
