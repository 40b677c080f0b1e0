/* SPDX-License-Identifier: MIT */
#include "math/eigen.h"

#include <float.h>
#include <math.h>
#include <string.h>

#include "math/cholesky.h"
#include "math/combine.h"
#include "math/portable_math.h"

enum {
  SWEEP_LIMIT = 60, /* QL sweeps for one eigenvalue; two or three are usual */
  COLUMNS = 8       /* of the vectors, rotated at a time: they stay in the first cache */
};

/* Copies one triangle to the other. */
static void mirror_lower(uint32_t n, double *a) {
  for (uint32_t i = 0; i < n; i++) {
    for (uint32_t j = 0; j < i; j++) a[(size_t)j * n + i] = a[(size_t)i * n + j];
  }
}

static void transpose(uint32_t n, double *a) {
  for (uint32_t i = 0; i < n; i++) {
    for (uint32_t j = 0; j < i; j++) {
      const double kept = a[(size_t)i * n + j];
      a[(size_t)i * n + j] = a[(size_t)j * n + i];
      a[(size_t)j * n + i] = kept;
    }
  }
}

/* K becomes U^-T K U^-1; factor[] as of tb_factor_positive(). */
static void reduce_to_standard(TbArena *watched, uint32_t n, const double *factor, double *k) {
  for (uint32_t i = 0; i < n && tb_arena_go_on(watched); i++) { /* Y = U^-T K, row by row */
    const double *column = factor + (size_t)i * n;
    double *row = k + (size_t)i * n;
    tb_combine_rows(n, i, column, k, n, -1.0, row);
    for (uint32_t j = 0; j < n; j++) row[j] /= column[i];
  }
  for (uint32_t i = 0; i < n && tb_arena_go_on(watched);
       i++) { /* each row of A U = Y, as far as the diagonal */
    double *row = k + (size_t)i * n;
    for (uint32_t j = 0; j <= i; j++) {
      const double *from = factor + (size_t)j * n;
      row[j] /= from[j];
      for (uint32_t l = j + 1; l <= i; l++) row[l] -= row[j] * from[l];
    }
  }
  mirror_lower(n, k);
}

static double dot(uint32_t n, const double *x, const double *y) {
  double sum = 0.0;
  for (uint32_t i = 0; i < n; i++) sum += x[i] * y[i];
  return sum;
}

/* The reflection 1 - u u^T / h that turns u, length n, into (0, .., 0, *end). Returns h; 0 if there
 * is nothing to turn. */
static double reflection(uint32_t n, double *u, double *end) {
  double scale = 0.0;
  for (uint32_t i = 0; i < n; i++) scale += fabs(u[i]);
  *end = u[n - 1];
  if (n == 1 || !(scale > 0.0)) return 0.0;
  for (uint32_t i = 0; i < n; i++) u[i] /= scale;
  const double square = dot(n, u, u), length = copysign(sqrt(square), -u[n - 1]);
  const double h = square - u[n - 1] * length;
  *end = scale * length;
  u[n - 1] -= length;
  return h;
}

/* A, n x n in rows of `stride`, becomes H A H for H = 1 - u u^T / h; p[n] is scratch. */
static void reflect_both_sides(uint32_t n, uint32_t stride, const double *u, double h, double *a,
                               double *p) {
  memset(p, 0, n * sizeof *p);
  tb_combine_rows(n, n, u, a, stride, 1.0 / h, p);
  const double half = 0.5 * dot(n, u, p) / h;
  for (uint32_t i = 0; i < n; i++) p[i] -= half * u[i];
  for (uint32_t i = 0; i < n; i++) {
    double *restrict row = a + (size_t)i * stride;
    const double u_i = u[i], p_i = p[i];
    for (uint32_t j = 0; j < n; j++) row[j] -= u_i * p[j] + p_i * u[j];
  }
}

/* From the last row upwards; the reflection of row i stays in a[i][0 .. i-1] and h[i]. */
static void make_tridiagonal(TbArena *watched, uint32_t n, double *a, double *diagonal,
                             double *beside, double *h, double *p) {
  for (uint32_t i = n; i-- > 1 && tb_arena_go_on(watched);) {
    double *u = a + (size_t)i * n;
    diagonal[i] = u[i];
    h[i] = reflection(i, u, &beside[i - 1]);
    if (h[i] > 0.0) reflect_both_sides(i, n, u, h[i], a, p);
  }
  diagonal[0] = a[0];
  beside[n - 1] = 0.0;
}

/* The product of these reflections, transposed: its rows are the basis in which A is tridiagonal.
 */
static void gather_basis(TbArena *watched, uint32_t n, const double *a, const double *h, double *p,
                         double *basis) {
  memset(basis, 0, (size_t)n * n * sizeof *basis);
  for (uint32_t i = 0; i < n; i++) basis[(size_t)i * n + i] = 1.0;
  for (uint32_t i = 1; i < n && tb_arena_go_on(watched); i++) {
    const double *u = a + (size_t)i * n;
    if (!(h[i] > 0.0)) continue;
    memset(p, 0, i * sizeof *p);
    tb_combine_rows(i, i, u, basis, n, -1.0 / h[i], p);
    for (uint32_t j = 0; j < i; j++) {
      double *restrict row = basis + (size_t)j * n;
      for (uint32_t k = 0; k < i; k++) row[k] += u[j] * p[k];
    }
  }
  transpose(n, basis);
}

/* Rotations of neighbouring rows: (x_i, x_i+1) becomes (c x_i - s x_i+1, s x_i + c x_i+1). */
typedef struct Rotations {
  double *cosine, *sine; /* at the index i */
} Rotations;

/* The last row of the undivided part of T that begins with row `first`. */
static uint32_t last_coupled(uint32_t n, const double *d, const double *e, uint32_t first) {
  uint32_t i = first;
  while (i + 1 < n && !(fabs(e[i]) <= DBL_EPSILON * (fabs(d[i]) + fabs(d[i + 1])))) i++;
  return i;
}

/* One sweep over the rows first .. last of T, d beside e. Returns the lowest row that was rotated;
 * higher than `first` only if T fell into two there. */
static uint32_t sweep(double *d, double *e, uint32_t first, uint32_t last, Rotations r) {
  const double slope = (d[first + 1] - d[first]) / (2.0 * e[first]);
  double g = d[last] - d[first] + e[first] / (slope + copysign(tb_hypot(slope, 1.0), slope));
  double sine = 1.0, cosine = 1.0, shift = 0.0;
  for (uint32_t i = last; i-- > first;) {
    const double f = sine * e[i], b = cosine * e[i], length = tb_hypot(f, g);
    e[i + 1] = length;
    if (length == 0.0) {
      d[i + 1] -= shift;
      e[last] = 0.0;
      return i + 1;
    }
    r.sine[i] = sine = f / length;
    r.cosine[i] = cosine = g / length;
    g = d[i + 1] - shift;
    const double step = (d[i] - g) * sine + 2.0 * cosine * b;
    shift = sine * step;
    d[i + 1] = g + shift;
    g = cosine * step - b;
  }
  d[first] -= shift;
  e[first] = g;
  e[last] = 0.0;
  return first;
}

/* Rotates rows last .. first in `width` columns that begin at x. A row is met twice and is carried
 * over. */
static inline void rotate_columns(uint32_t width, uint32_t stride, uint32_t first, uint32_t last,
                                  Rotations r, double *x) {
  double upper[COLUMNS];
  for (uint32_t k = 0; k < width; k++) upper[k] = x[(size_t)last * stride + k];
  for (uint32_t i = last; i-- > first;) {
    const double c = r.cosine[i], s = r.sine[i];
    double *row = x + (size_t)i * stride;
    for (uint32_t k = 0; k < width; k++) {
      const double lower = row[k], above = upper[k];
      row[stride + k] = s * lower + c * above;
      upper[k] = c * lower - s * above;
    }
  }
  for (uint32_t k = 0; k < width; k++) x[(size_t)first * stride + k] = upper[k];
}

static void rotate_rows(uint32_t n, uint32_t first, uint32_t last, Rotations r, double *x) {
  uint32_t k = 0;
  for (; k + COLUMNS <= n; k += COLUMNS) rotate_columns(COLUMNS, n, first, last, r, x + k);
  rotate_columns(n - k, n, first, last, r, x + k);
}

/* T becomes diagonal, and its basis turns with it. */
static bool make_diagonal(TbArena *watched, uint32_t n, double *d, double *e, Rotations r,
                          double *basis) {
  for (uint32_t first = 0; first < n; first++) {
    if (!tb_arena_go_on(watched)) return false;
    for (uint32_t sweeps = 0;; sweeps++) {
      const uint32_t last = last_coupled(n, d, e, first);
      if (last == first) break;
      if (sweeps == SWEEP_LIMIT) return false;
      rotate_rows(n, sweep(d, e, first, last, r), last, r, basis);
    }
  }
  return true;
}

static void swap_rows(uint32_t n, double *a, double *b) {
  for (uint32_t i = 0; i < n; i++) {
    const double kept = a[i];
    a[i] = b[i];
    b[i] = kept;
  }
}

static void sort_ascending(uint32_t n, double *values, double *vectors) {
  for (uint32_t i = 0; i + 1 < n; i++) {
    uint32_t least = i;
    for (uint32_t j = i + 1; j < n; j++) {
      if (values[j] < values[least]) least = j;
    }
    if (least == i) continue;
    swap_rows(1, values + i, values + least);
    swap_rows(n, vectors + (size_t)i * n, vectors + (size_t)least * n);
  }
}

bool tb_eigen_symmetric(TbArena *scratch, uint32_t n, double *stiffness, double *mass,
                        double *eigenvalues, double *vectors) {
  if (n == 0) return true;
  double *beside = tb_arena_doubles(scratch, n), *h = tb_arena_doubles(scratch, n);
  double *p = tb_arena_doubles(scratch, n);
  if (scratch->failed) return false;
  if (mass) {
    for (uint32_t i = 0; i < n; i++) {
      if (!tb_arena_go_on(scratch) || !tb_factor_row(n, i, mass)) return false;
    }
    reduce_to_standard(scratch, n, mass, stiffness);
  }
  make_tridiagonal(scratch, n, stiffness, eigenvalues, beside, h, p);
  gather_basis(scratch, n, stiffness, h, p, vectors);
  /* The reflections have done their work: their memory holds a sweep. */
  if (!make_diagonal(scratch, n, eigenvalues, beside, (Rotations){h, p}, vectors)) return false;
  sort_ascending(n, eigenvalues, vectors);
  for (uint32_t i = 0; mass && i < n && tb_arena_go_on(scratch); i++)
    tb_solve_upper(n, mass, vectors + (size_t)i * n);
  return !scratch->failed;
}
