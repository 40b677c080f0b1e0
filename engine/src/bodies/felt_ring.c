/* SPDX-License-Identifier: MIT */
#include "bodies/felt_ring.h"

#include <math.h>

#include "math/bessel.h"

static const double PI = 3.14159265358979323846;

/* Edges in units of R, and C [N s/m3]. A ring that is wider than its middle's distance allows is a
 * disc. */
typedef struct Ring {
  double edge[2]; /* inner, outer */
  double per_area;
} Ring;

static Ring ring_of(const TaborHeadDef *head, double radius) {
  const double inner = fmax(0.0, head->ring_radius - 0.5 * head->ring_width);
  const double outer = head->ring_radius + 0.5 * head->ring_width;
  const double area = PI * (outer * outer - inner * inner);
  return (Ring){{inner / radius, outer / radius}, head->ring_strength / area};
}

/* A Bessel function at both edges: J_m(z x), J_{m+1}(z x). */
typedef struct Edges {
  double zero, at[2][2];
} Edges;

static Edges edges_of(const Ring *ring, uint32_t m, double zero) {
  Edges edges = {.zero = zero};
  for (int i = 0; i < 2; i++) {
    if (ring->edge[i] > 0.0) tb_bessel_pair(m, zero * ring->edge[i], edges.at[i]);
  }
  return edges;
}

/* Int J_m(a x)^2 x dx. */
static double square(const Ring *ring, uint32_t m, const Edges *a) {
  double part[2] = {0.0};
  for (int i = 0; i < 2; i++) {
    const double x = ring->edge[i], *j = a->at[i];
    if (x == 0.0) continue;
    part[i] = 0.5 * x * x * (j[0] * j[0] - 2.0 * m / (a->zero * x) * j[0] * j[1] + j[1] * j[1]);
  }
  return part[1] - part[0];
}

/* Int J_m(a x) J_m(b x) x dx, a != b. */
static double product(const Ring *ring, const Edges *a, const Edges *b) {
  double part[2];
  for (int i = 0; i < 2; i++) {
    const double *ja = a->at[i], *jb = b->at[i];
    part[i] = ring->edge[i] * (a->zero * ja[1] * jb[0] - b->zero * ja[0] * jb[1]) /
              (a->zero * a->zero - b->zero * b->zero);
  }
  return part[1] - part[0];
}

bool tb_felt_ring_matrix(const TaborHeadDef *head, double radius, TbArena *arena,
                         const TbAirOrder *order, const double **matrix) {
  *matrix = NULL;
  if (head->ring_strength == 0.0) return true;
  const uint32_t n = order->count;
  const Ring ring = ring_of(head, radius);
  const double unit = ring.per_area * (order->m ? PI : 2.0 * PI) * radius * radius;
  Edges *edges = tb_arena_take(arena, n, sizeof *edges);
  double *out = tb_arena_doubles(arena, (size_t)n * n);
  if (arena->failed) return false;
  for (uint32_t i = 0; i < n; i++) {
    edges[i] = edges_of(&ring, order->m, order->zeros[i]);
    out[(size_t)i * n + i] = unit * square(&ring, order->m, &edges[i]);
    for (uint32_t k = 0; k < i; k++) {
      out[(size_t)i * n + k] = out[(size_t)k * n + i] = unit * product(&ring, &edges[i], &edges[k]);
    }
  }
  *matrix = out;
  return true;
}

double tb_felt_ring_loss(const double *matrix, uint32_t count, const double *v) {
  double loss = 0.0;
  for (uint32_t i = 0; matrix && i < count; i++) {
    double row = 0.0;
    for (uint32_t k = 0; k < count; k++) row += matrix[(size_t)i * count + k] * v[k];
    loss += v[i] * row;
  }
  return fmax(0.0, loss); /* rounding */
}

double tb_felt_ring_sigma(const TaborHeadDef *head, double radius, uint32_t m, double zero,
                          double slope) {
  if (head->ring_strength == 0.0) return 0.0;
  const Ring ring = ring_of(head, radius);
  const Edges edges = edges_of(&ring, m, zero);
  return ring.per_area / head->surface_density * square(&ring, m, &edges) / (0.5 * slope * slope);
}
