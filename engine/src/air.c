/* SPDX-License-Identifier: MIT */
#include "air.h"

#include <math.h>

#include "bessel.h"
#include "linear.h"
#include "quadrature.h"

static const double PI = 3.14159265358979323846;

/* Nodes in kappa with everything that depends on them alone. Below x: kappa = x sin t, so that
 * `weights` carry dkappa/cos t = x dt; above: kappa = sqrt(x^2 + t^2), weights carry dt. */
typedef struct Nodes {
  uint32_t count, below; /* the first `below` lie below x */
  double *kappa, *root;  /* root = sqrt|kappa^2 - x^2| */
  double *weights;
} Nodes;

/* A 16-point panel resolves about two wavelengths. */
static uint32_t panels_for(double phase) { return 1u + (uint32_t)(phase / (4.0 * PI)); }

/* `stretch` is the number of radians that the integrand turns per unit of kappa. */
static bool nodes_prepare(Nodes *nodes, TbArena *scratch, double x, double top, double stretch) {
  const uint32_t low = x > 0.0 ? panels_for(x * stretch) + 1u : 0u;
  const uint32_t high = panels_for(top * stretch) + 3u;
  nodes->below = low * TB_PANEL;
  nodes->count = (low + high) * TB_PANEL;
  nodes->kappa = tb_arena_doubles(scratch, nodes->count);
  nodes->root = tb_arena_doubles(scratch, nodes->count);
  nodes->weights = tb_arena_doubles(scratch, nodes->count);
  if (scratch->failed) return false;

  if (low) tb_quadrature(0.0, 0.5 * PI, low, nodes->kappa, nodes->weights);
  for (uint32_t q = 0; q < nodes->below; q++) {
    const double t = nodes->kappa[q];
    nodes->kappa[q] = x * sin(t);
    nodes->root[q] = x * cos(t);
    nodes->weights[q] *= x;
  }
  tb_quadrature(0.0, top, high, nodes->kappa + nodes->below, nodes->weights + nodes->below);
  for (uint32_t q = nodes->below; q < nodes->count; q++) {
    const double t = nodes->kappa[q];
    nodes->root[q] = t;
    nodes->kappa[q] = sqrt(x * x + t * t);
  }
  return true;
}

static void bessel_at(uint32_t m, uint32_t count, const double *kappa, double scale, double *j) {
  const uint32_t orders[8] = {m, m, m, m, m, m, m, m};
  for (uint32_t q = 0; q < count; q += 8) {
    double argument[8];
    for (uint32_t i = 0; i < 8; i++) argument[i] = scale * kappa[q + i];
    tb_bessel_j8(orders, argument, j + q);
  }
}

bool tb_air_order_prepare(TbAirOrder *order, TbArena *arena, uint32_t m, const double *zeros,
                          uint32_t count) {
  *order = (TbAirOrder){.m = m, .count = count, .zeros = zeros};
  const double top = zeros[count - 1];
  order->terms = (uint32_t)fmax(0.0, 0.5 * (top - (double)m)) + 13u;
  order->slopes = tb_arena_doubles(arena, count);
  order->expansion = tb_arena_doubles(arena, (size_t)count * order->terms);
  const uint32_t orders = m + 2u * order->terms;
  double *half = tb_arena_doubles(arena, 8 * (size_t)orders);
  if (arena->failed) return false;
  for (uint32_t i = 0; i < count; i += 8) {
    double x[8];
    for (uint32_t l = 0; l < 8; l++) x[l] = zeros[i + l < count ? i + l : i];
    tb_bessel_half8(x, orders, half);
    for (uint32_t l = 0; l < 8 && i + l < count; l++) {
      order->slopes[i + l] = tb_bessel_j(m + 1, x[l]);
      for (uint32_t n = 0; n < order->terms; n++) {
        order->expansion[(i + l) * order->terms + n] =
          half[8 * (m + 2 * n + 1) + l] / (x[l] * sqrt(x[l]));
      }
    }
  }
  return true;
}

/* W(kappa) from J_m(kappa); at kappa = z the limit J_{m+1}(z)^2/2. */
static double hankel(double z, double slope, double kappa, double j) {
  const double difference = z * z - kappa * kappa;
  if (fabs(difference) < 1e-9 * z * z) return 0.5 * slope * slope;
  return z * slope * j / difference;
}

/* Int_0^inf W_i W_j dkappa. W falls like kappa^-5/2; beyond the last node J_m^2 counts as its mean
 * 1/(pi kappa), which leaves an error below 1e-8 of the diagonal. */
bool tb_air_mass_baffled(const TbAirOrder *order, TbArena *scratch, double *mass) {
  const uint32_t n = order->count;
  const double top = fmax(200.0, 6.0 * order->zeros[n - 1]);
  Nodes nodes;
  if (!nodes_prepare(&nodes, scratch, 0.0, top, 2.0)) return false;
  double *j = tb_arena_doubles(scratch, nodes.count);
  double *w = tb_arena_doubles(scratch, (size_t)n * nodes.count);
  if (scratch->failed) return false;
  bessel_at(order->m, nodes.count, nodes.kappa, 1.0, j);
  for (uint32_t i = 0; i < n; i++) {
    for (uint32_t q = 0; q < nodes.count; q++) {
      w[i * nodes.count + q] = hankel(order->zeros[i], order->slopes[i], nodes.kappa[q], j[q]);
    }
  }
  for (uint32_t a = 0; a < n; a++) {
    for (uint32_t b = a; b < n; b++) {
      const double *wa = w + (size_t)a * nodes.count, *wb = w + (size_t)b * nodes.count;
      double sum = order->zeros[a] * order->slopes[a] * order->zeros[b] * order->slopes[b] /
                   (4.0 * PI * top * top * top * top);
      for (uint32_t q = 0; q < nodes.count; q++) sum += nodes.weights[q] * wa[q] * wb[q];
      mass[a * n + b] = mass[b * n + a] = sum;
    }
  }
  return true;
}

void tb_air_mass_open(const TbAirOrder *order, double *mass) {
  const uint32_t n = order->count;
  for (uint32_t a = 0; a < n; a++) {
    for (uint32_t b = a; b < n; b++) {
      const double *ea = order->expansion + a * order->terms;
      const double *eb = order->expansion + b * order->terms;
      double sum = 0.0;
      for (uint32_t t = 0; t < order->terms; t++) {
        sum += 4.0 * ((double)order->m + 2.0 * t + 1.5) * ea[t] * eb[t];
      }
      mass[a * n + b] = mass[b * n + a] = sum;
    }
  }
}

bool tb_air_resistance_baffled(const TbAirOrder *order, TbArena *scratch, double x,
                               double *resistance) {
  const uint32_t n = order->count;
  Nodes nodes;
  if (!nodes_prepare(&nodes, scratch, x, 0.0, 2.0)) return false;
  double *j = tb_arena_doubles(scratch, nodes.count);
  if (!j) return false;
  bessel_at(order->m, nodes.count, nodes.kappa, 1.0, j);
  for (uint32_t a = 0; a < n; a++) {
    for (uint32_t b = a; b < n; b++) {
      double sum = 0.0;
      for (uint32_t q = 0; q < nodes.below; q++) {
        const double kappa = nodes.kappa[q];
        sum += nodes.weights[q] * kappa * hankel(order->zeros[a], order->slopes[a], kappa, j[q]) *
               hankel(order->zeros[b], order->slopes[b], kappa, j[q]);
      }
      resistance[a * n + b] = resistance[b * n + a] = sum;
    }
  }
  return true;
}

/* f(kappa) = Sum_i v_i W_i(kappa) at every node. */
static bool transform_baffled(const TbAirOrder *order, TbArena *scratch, const Nodes *nodes,
                              const double *v, double *f) {
  double *j = tb_arena_doubles(scratch, nodes->count);
  if (!j) return false;
  bessel_at(order->m, nodes->count, nodes->kappa, 1.0, j);
  for (uint32_t q = 0; q < nodes->count; q++) {
    double sum = 0.0;
    for (uint32_t i = 0; i < order->count; i++) {
      sum += v[i] * hankel(order->zeros[i], order->slopes[i], nodes->kappa[q], j[q]);
    }
    f[q] = sum;
  }
  return true;
}

static bool load_baffled(const TbAirOrder *order, TbArena *scratch, const double *v, double x,
                         TbAirLoad *load) {
  const double top = fmax(60.0, 4.0 * order->zeros[order->count - 1]);
  Nodes nodes;
  if (!nodes_prepare(&nodes, scratch, x, top, 2.0)) return false;
  double *f = tb_arena_doubles(scratch, nodes.count);
  if (!f || !transform_baffled(order, scratch, &nodes, v, f)) return false;
  double radiated = 0.0, stored = 0.0;
  for (uint32_t q = 0; q < nodes.below; q++) {
    radiated += nodes.weights[q] * nodes.kappa[q] * f[q] * f[q];
  }
  for (uint32_t q = nodes.below; q < nodes.count; q++) stored += nodes.weights[q] * f[q] * f[q];
  *load = (TbAirLoad){.mass = 2.0 * stored, .resistance = 2.0 * radiated};
  return true;
}

/* How much of the expansion one shape needs. Its terms n beyond (z - m)/2 vanish fast, z the highest
 * zero that takes part; 1e-3 of the largest part changes the load by 1e-6. */
typedef struct Reach {
  double zero;
  uint32_t terms, orders; /* terms, and the spherical orders that hold them */
} Reach;

static Reach reach_of(const TbAirOrder *order, const double *v, double x) {
  double largest = 0.0;
  for (uint32_t i = 0; i < order->count; i++) largest = fmax(largest, fabs(v[i]));
  uint32_t last = 0;
  for (uint32_t i = 0; i < order->count; i++) {
    if (fabs(v[i]) > 1e-3 * largest) last = i;
  }
  const double zero = order->zeros[last];
  uint32_t terms = (uint32_t)fmax(0.0, 0.5 * (fmax(zero, x) - (double)order->m)) + 13u;
  if (terms > order->terms) terms = order->terms;
  return (Reach){.zero = zero, .terms = terms, .orders = order->m + 2u * terms};
}

/* out[a][b] += factor row[a] row[b], b <= a. */
static void add_outer(uint32_t n, double *restrict out, double factor, const double *restrict row) {
  for (uint32_t a = 0; a < n; a++) {
    const double scaled = factor * row[a];
    double *restrict line = out + (size_t)a * n;
    for (uint32_t b = 0; b <= a; b++) line[b] += scaled * row[b];
  }
}

/* Lower triangles of the real and imaginary parts of C(x). Beyond the last node the integrand is
 * -x^2/(2 k^3) times the mean (-1)^(n-n')/(pi k) of the Bessel product. */
static bool open_matrix(const TbAirOrder *order, TbArena *scratch, Reach reach, double x,
                        double *re, double *im) {
  const double top = fmax(40.0, 1.5 * fmax(x, reach.zero) + 10.0);
  Nodes nodes;
  if (!nodes_prepare(&nodes, scratch, x, top, 2.0)) return false;
  double *half = tb_arena_doubles(scratch, 8 * (size_t)reach.orders);
  double *row = tb_arena_doubles(scratch, reach.terms);
  if (scratch->failed) return false;

  const double end = sqrt(x * x + top * top);
  const double tail = -x * x / (6.0 * PI * end * end * end);
  for (uint32_t a = 0; a < reach.terms; a++) {
    for (uint32_t b = 0; b <= a; b++) re[a * reach.terms + b] = (a + b) % 2 ? -tail : tail;
    re[a * reach.terms + a] += 0.5 / ((double)order->m + 2.0 * a + 1.5);
  }
  for (uint32_t q = 0; q < nodes.count; q++) {
    const double kappa = nodes.kappa[q], root = nodes.root[q];
    const bool below = q < nodes.below;
    const double measure = below ? root / x : root / kappa; /* dkappa = cos t x dt, (t/kappa) dt */
    const double factor = nodes.weights[q] * measure / (kappa * kappa);
    if (q % 8 == 0) tb_bessel_half8(nodes.kappa + q, reach.orders, half);
    for (uint32_t n = 0; n < reach.terms; n++) row[n] = half[8 * (order->m + 2 * n + 1) + q % 8];
    add_outer(reach.terms, re, factor * (below ? -kappa : root - kappa), row);
    if (below) add_outer(reach.terms, im, factor * root, row);
  }
  return true;
}

/* The load, and the expansion a = C^-1 b of the pressure jump as (re, im) pairs. */
static bool load_open(const TbAirOrder *order, TbArena *scratch, Reach reach, const double *v,
                      double x, TbAirLoad *load, double *a) {
  const uint32_t terms = reach.terms;
  double *re = tb_arena_doubles(scratch, (size_t)terms * terms);
  double *im = tb_arena_doubles(scratch, (size_t)terms * terms);
  double *matrix = tb_arena_doubles(scratch, 2 * (size_t)terms * terms);
  double *b = tb_arena_doubles(scratch, terms);
  if (scratch->failed || !open_matrix(order, scratch, reach, x, re, im)) return false;
  for (uint32_t n = 0; n < terms; n++) {
    for (uint32_t i = 0; i < order->count; i++)
      b[n] += v[i] * order->expansion[i * order->terms + n];
    a[2 * n] = b[n];
    a[2 * n + 1] = 0.0;
    for (uint32_t l = 0; l <= n; l++) {
      const uint32_t here = 2 * (n * terms + l), mirror = 2 * (l * terms + n);
      matrix[here] = matrix[mirror] = re[n * terms + l];
      matrix[here + 1] = matrix[mirror + 1] = im[n * terms + l];
    }
  }
  if (!tb_solve_complex(scratch, terms, matrix, 1, a)) return false;
  double mass = 0.0, lost = 0.0;
  for (uint32_t n = 0; n < terms; n++) {
    mass += b[n] * a[2 * n];
    lost += b[n] * a[2 * n + 1];
  }
  *load = (TbAirLoad){.mass = 2.0 * mass, .resistance = -2.0 * x * lost};
  return true;
}

/* P(kappa) = kappa^{-3/2} Sum_n a_n J_{mu_n}(kappa) at every node, as (re, im) pairs. */
static bool transform_open(const TbAirOrder *order, TbArena *scratch, Reach reach, const double *a,
                           const Nodes *nodes, double *p) {
  double *half = tb_arena_doubles(scratch, 8 * (size_t)reach.orders);
  if (!half) return false;
  for (uint32_t q = 0; q < nodes->count; q++) {
    if (q % 8 == 0) tb_bessel_half8(nodes->kappa + q, reach.orders, half);
    const double factor = 1.0 / (nodes->kappa[q] * sqrt(nodes->kappa[q]));
    double re = 0.0, im = 0.0;
    for (uint32_t n = 0; n < reach.terms; n++) {
      const double j = half[8 * (order->m + 2 * n + 1) + q % 8];
      re += a[2 * n] * j;
      im += a[2 * n + 1] * j;
    }
    p[2 * q] = factor * re;
    p[2 * q + 1] = factor * im;
  }
  return true;
}

/* I = Int P(k) J_m(k r) e^{-gamma |h|} k dk            open, times the sign of h,
 * I = Int f(k) J_m(k r) e^{-gamma |h|} (k/gamma) dk    baffled; gamma = i sqrt(x^2 - k^2) below x. */
static bool field(const TbAirOrder *order, TbArena *scratch, TaborBoundary boundary, Reach reach,
                  const double *v, const double *a, double x, TbAirPoint point, double *result) {
  const double height = fabs(point.height);
  const double smooth = fmax(60.0, 4.0 * fmax(x, reach.zero));
  const double top = fmin(smooth, 24.0 / height); /* e^-24 is nothing */
  Nodes nodes;
  if (!nodes_prepare(&nodes, scratch, x, top, 1.0 + point.radius + height)) return false;
  double *j = tb_arena_doubles(scratch, nodes.count);
  double *f = tb_arena_doubles(scratch, 2 * (size_t)nodes.count);
  if (scratch->failed) return false;
  const bool open = boundary == TABOR_BOUNDARY_OPEN;
  bessel_at(order->m, nodes.count, nodes.kappa, point.radius, j);
  const bool transformed = open ? transform_open(order, scratch, reach, a, &nodes, f)
                                : transform_baffled(order, scratch, &nodes, v, f);
  if (!transformed) return false;

  double re = 0.0, im = 0.0;
  for (uint32_t q = 0; q < nodes.count; q++) {
    const double kappa = nodes.kappa[q], root = nodes.root[q];
    const bool below = q < nodes.below;
    const double size = nodes.weights[q] * j[q] * (below ? 1.0 : exp(-root * height));
    const double phase = below ? -root * height : 0.0;
    double fr = 0.0, fi = 0.0;
    if (open) { /* k dk = k cos t x dt below, t dt above */
      const double measure = below ? kappa * root / x : root;
      fr = measure * f[2 * q];
      fi = measure * f[2 * q + 1];
    } else if (below) { /* k dk/gamma = -i k dt below, dt above; weights hold x dt */
      fi = -f[q] * kappa / x;
    } else {
      fr = f[q];
    }
    re += size * (fr * cos(phase) - fi * sin(phase));
    im += size * (fr * sin(phase) + fi * cos(phase));
  }
  const double sign = point.height < 0.0 ? -1.0 : 1.0;
  result[0] = sign * re;
  result[1] = sign * im;
  return true;
}

bool tb_air_load(const TbAirOrder *order, TbArena *scratch, TaborBoundary boundary, const double *v,
                 double x, const TbAirPoint *points, uint32_t point_count, TbAirLoad *load,
                 double *fields) {
  const Reach reach = reach_of(order, v, x);
  double *a = tb_arena_doubles(scratch, 2 * (size_t)reach.terms);
  if (!a) return false;
  const bool loaded = boundary == TABOR_BOUNDARY_OPEN
                        ? load_open(order, scratch, reach, v, x, load, a)
                        : load_baffled(order, scratch, v, x, load);
  if (!loaded) return false;
  for (uint32_t p = 0; p < point_count; p++) {
    if (!field(order, scratch, boundary, reach, v, a, x, points[p], fields + 2 * p)) return false;
  }
  return true;
}

bool tb_air_slow(const TbAirOrder *order, TbArena *scratch, double x, const TbAirPoint *points,
                 uint32_t point_count, double *resistance, double *fields) {
  const double one = 1.0;
  const Reach reach = {.zero = order->zeros[0]};
  if (!tb_air_resistance_baffled(order, scratch, x, resistance)) return false;
  *resistance *= 2.0;
  for (uint32_t p = 0; p < point_count; p++) {
    if (!field(order, scratch, TABOR_BOUNDARY_BAFFLED, reach, &one, NULL, x, points[p],
               fields + 2 * p)) {
      return false;
    }
  }
  return true;
}
