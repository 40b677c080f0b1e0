/* SPDX-License-Identifier: MIT */
/* The eigensolver beside LAPACK's dsygv: on random, graded and clustered matrices, and on every
 * matrix that the models of the presets solve. The linker gives the engine's calls to
 * __wrap_tb_eigen_symmetric() here. */
#include <float.h>
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>
#include <lapacke.h>

#include "math/eigen.h"

/* Of the largest eigenvalue: both solvers round at each of some hundred steps. */
static const double VALUE_ERROR = 64.0 * DBL_EPSILON;
/* Frequencies are square roots of eigenvalues of problems with a mass: half of VALUE_ERROR, where
 * the largest eigenvalue is some 1e5 times the lowest, as on the marching drum with all coordinates
 * of its air. */
static const double FREQUENCY_ERROR = 1e-9;
static const double SHAPE_ERROR = 1e-8;
/* Rounding turns vectors of eigenvalues closer than this by more than SHAPE_ERROR: only their span
 * is theirs. */
static const double CLOSE = 64.0 * DBL_EPSILON / 1e-8; /* of the largest eigenvalue */

typedef struct Problem {
  uint32_t n;
  bool standard; /* M is the unit matrix, and the solver is told so */
  double *stiffness, *mass;
} Problem;

typedef struct Solution {
  double *values, *vectors; /* by rows */
} Solution;

static double *doubles(size_t count) {
  double *const memory = calloc(count ? count : 1, sizeof *memory);
  assert_non_null(memory);
  return memory;
}

static double *copy(const double *from, size_t count) {
  return memcpy(doubles(count), from, count * sizeof *from);
}

static Problem problem_create(uint32_t n) {
  Problem p = {.n = n, .stiffness = doubles((size_t)n * n), .mass = doubles((size_t)n * n)};
  for (uint32_t i = 0; i < n; i++) p.mass[(size_t)i * n + i] = 1.0;
  return p;
}

static void problem_free(Problem *p) {
  free(p->stiffness);
  free(p->mass);
}

static Solution solution_create(uint32_t n) {
  return (Solution){doubles(n), doubles((size_t)n * n)};
}

static void solution_free(Solution *s) {
  free(s->values);
  free(s->vectors);
}

static void solve_by_lapack(const Problem *p, Solution *s) {
  const size_t square = (size_t)p->n * p->n;
  double *const mass = copy(p->mass, square);
  memcpy(s->vectors, p->stiffness, square * sizeof *s->vectors);
  assert_int_equal(LAPACKE_dsygv(LAPACK_COL_MAJOR, 1, 'V', 'U', (lapack_int)p->n, s->vectors,
                                 (lapack_int)p->n, mass, (lapack_int)p->n, s->values),
                   0);
  free(mass);
}

bool __real_tb_eigen_symmetric(TbArena *scratch, uint32_t n, double *stiffness, double *mass,
                               double *eigenvalues, double *vectors);

static bool solve(const Problem *p, Solution *s) {
  const TaborAllocator system = tb_allocator_resolve(NULL);
  TbArena arena;
  tb_arena_prepare(&arena, &system);
  const size_t square = (size_t)p->n * p->n;
  double *const stiffness = copy(p->stiffness, square), *const mass = copy(p->mass, square);
  const bool solved = __real_tb_eigen_symmetric(&arena, p->n, stiffness, p->standard ? NULL : mass,
                                                s->values, s->vectors);
  free(stiffness);
  free(mass);
  tb_arena_release(&arena);
  return solved;
}

/* out = M x */
static void multiply(uint32_t n, const double *matrix, const double *x, double *out) {
  for (uint32_t i = 0; i < n; i++) {
    out[i] = 0.0;
    for (uint32_t k = 0; k < n; k++) out[i] += matrix[(size_t)i * n + k] * x[k];
  }
}

static double dot(uint32_t n, const double *x, const double *y) {
  double sum = 0.0;
  for (uint32_t i = 0; i < n; i++) sum += x[i] * y[i];
  return sum;
}

static double largest_of(uint32_t n, const double *values) {
  return fmax(fabs(values[0]), fabs(values[n - 1]));
}

/* The end of the run of close eigenvalues that begins at `first`. */
static uint32_t cluster_end(uint32_t n, const double *values, uint32_t first) {
  const double gap = CLOSE * largest_of(n, values);
  uint32_t end = first + 1;
  while (end < n && values[end] - values[end - 1] <= gap) end++;
  return end;
}

/* How far, in the norm of M, `shape` lies from the span of LAPACK's vectors first .. end. */
static double distance(const Problem *p, const double *shape, const Solution *reference,
                       uint32_t first, uint32_t end) {
  const uint32_t n = p->n;
  double *const rest = copy(shape, n), *const weighted = doubles(n);
  for (uint32_t i = first; i < end; i++) {
    const double *const other = reference->vectors + (size_t)i * n;
    multiply(n, p->mass, other, weighted);
    const double share = dot(n, shape, weighted);
    for (uint32_t k = 0; k < n; k++) rest[k] -= share * other[k];
  }
  multiply(n, p->mass, rest, weighted);
  const double square = dot(n, rest, weighted);
  free(rest);
  free(weighted);
  return sqrt(fmax(0.0, square));
}

/* What comparisons found at most. */
typedef struct Worst {
  double frequency, value, shape;
  uint32_t problems, largest;
} Worst;

static void compare_values(const Problem *p, const Solution *mine, const Solution *reference,
                           Worst *worst) {
  const double most = largest_of(p->n, reference->values);
  for (uint32_t i = 0; i < p->n; i++) {
    const double off = fabs(mine->values[i] - reference->values[i]);
    assert_true(isfinite(mine->values[i]) && (!i || mine->values[i - 1] <= mine->values[i]));
    if (off > 0.0) worst->value = fmax(worst->value, off / most);
    if (!p->standard) worst->frequency = fmax(worst->frequency, 0.5 * off / reference->values[i]);
  }
}

static void compare_shapes(const Problem *p, const Solution *mine, const Solution *reference,
                           Worst *worst) {
  for (uint32_t first = 0, end; first < p->n; first = end) {
    end = cluster_end(p->n, reference->values, first);
    for (uint32_t i = first; i < end; i++) {
      worst->shape =
        fmax(worst->shape, distance(p, mine->vectors + (size_t)i * p->n, reference, first, end));
    }
  }
}

/* v_i^T M v_k is one or zero; a vector of another length would be off a span by nothing. */
static void check_lengths(const Problem *p, const Solution *s) {
  double *const weighted = doubles(p->n);
  for (uint32_t i = 0; i < p->n; i++) {
    multiply(p->n, p->mass, s->vectors + (size_t)i * p->n, weighted);
    for (uint32_t k = 0; k <= i; k++) {
      const double product = dot(p->n, s->vectors + (size_t)k * p->n, weighted);
      assert_true(fabs(product - (i == k ? 1.0 : 0.0)) <= SHAPE_ERROR);
    }
  }
  free(weighted);
}

static void compare(const Problem *p, const Solution *mine, Worst *worst) {
  Solution reference = solution_create(p->n);
  solve_by_lapack(p, &reference);
  compare_values(p, mine, &reference, worst);
  compare_shapes(p, mine, &reference, worst);
  check_lengths(p, mine);
  worst->problems++;
  if (p->n > worst->largest) worst->largest = p->n;
  solution_free(&reference);
}

static void check(const char *name, const Worst *worst) {
  print_message("%s: %u problems of up to %u rows; off at most: frequencies %.1e, "
                "eigenvalues %.1e of the largest, shapes %.1e\n",
                name, worst->problems, worst->largest, worst->frequency, worst->value,
                worst->shape);
  assert_true(worst->problems > 0);
  assert_true(worst->frequency <= FREQUENCY_ERROR);
  assert_true(worst->value <= VALUE_ERROR);
  assert_true(worst->shape <= SHAPE_ERROR);
}

static void solve_and_compare(const Problem *p, Worst *worst) {
  Solution mine = solution_create(p->n);
  assert_true(solve(p, &mine));
  compare(p, &mine, worst);
  solution_free(&mine);
}

/* ---- made-up matrices ------------------------------------------------------------------------ */

static double draw(uint64_t *seed) {
  *seed = *seed * 6364136223846793005u + 1442695040888963407u;
  return (double)(*seed >> 11) / 9007199254740992.0 - 0.5;
}

/* matrix += w x x^T for a random x */
static void add_square(uint64_t *seed, uint32_t n, double weight, double *matrix) {
  double *const x = doubles(n);
  for (uint32_t i = 0; i < n; i++) x[i] = draw(seed);
  for (uint32_t i = 0; i < n; i++) {
    for (uint32_t k = 0; k < n; k++) matrix[(size_t)i * n + k] += weight * x[i] * x[k];
  }
  free(x);
}

/* K a sum of squares on a diagonal, and M, too. */
static Problem random_problem(uint64_t *seed, uint32_t n) {
  Problem p = problem_create(n);
  for (uint32_t i = 0; i < n; i++) {
    add_square(seed, n, 1.0, p.stiffness);
    add_square(seed, n, 4.0 / (double)n, p.mass);
    p.stiffness[(size_t)i * n + i] += 0.1;
  }
  return p;
}

static void random_ones(void **state) {
  (void)state;
  static const uint32_t sizes[] = {1, 2, 3, 5, 8, 15, 16, 17, 40, 97, 160};
  uint64_t seed = 1;
  Worst worst = {.problems = 0};
  for (size_t i = 0; i < sizeof sizes / sizeof *sizes; i++) {
    Problem p = random_problem(&seed, sizes[i]);
    solve_and_compare(&p, &worst);
    problem_free(&p);
  }
  check("random", &worst);
}

/* Rows and columns that grow, or fall, by six decades: so do the modes of a head with their order.
 */
static void graded_ones(void **state) {
  (void)state;
  enum { N = 60 };
  uint64_t seed = 2;
  for (int falling = 0; falling < 2; falling++) {
    Problem p = random_problem(&seed, N);
    p.standard = falling == 1; /* then small eigenvalues drown in rounding */
    for (uint32_t i = 0; i < N; i++) {
      for (uint32_t k = 0; k < N; k++) {
        const double decades = 6.0 * (double)(i + k) / (2.0 * (N - 1));
        p.stiffness[i * N + k] *= pow(10.0, falling ? -decades : decades);
        if (p.standard) p.mass[i * N + k] = i == k;
      }
    }
    Worst worst = {.problems = 0};
    solve_and_compare(&p, &worst);
    check(falling ? "falling" : "growing", &worst);
    problem_free(&p);
  }
}

/* Few different eigenvalues, each of them many times: apart by `spread`, or not at all. */
static void clustered_ones(void **state) {
  (void)state;
  enum { N = 60, CLUSTERS = 4 };
  uint64_t seed = 3;
  for (double spread = 0.0; spread < 1e-3; spread = spread == 0.0 ? 1e-14 : 1e3 * spread) {
    Problem basis = random_problem(&seed, N), p = problem_create(N);
    Solution s = solution_create(N);
    assert_true(solve(&basis, &s));
    /* With V^T M V = 1 the stiffness M V D V^T M has the eigenvalues D. */
    memcpy(p.mass, basis.mass, sizeof(double) * N * N);
    for (uint32_t v = 0; v < N; v++) {
      double weighted[N];
      multiply(N, p.mass, s.vectors + v * N, weighted);
      const double value = 1.0 + v % CLUSTERS + spread * draw(&seed);
      for (uint32_t i = 0; i < N; i++) {
        for (uint32_t k = 0; k <= i; k++)
          p.stiffness[i * N + k] += value * weighted[i] * weighted[k];
      }
    }
    for (uint32_t i = 0; i < N; i++) {
      for (uint32_t k = 0; k < i; k++) p.stiffness[k * N + i] = p.stiffness[i * N + k];
    }
    Worst worst = {.problems = 0};
    solve_and_compare(&p, &worst);
    check("clustered", &worst);
    solution_free(&s);
    problem_free(&p);
    problem_free(&basis);
  }
}

/* Nothing to turn, everything alike, and one row that is all. */
static void special_ones(void **state) {
  (void)state;
  enum { N = 20 };
  Worst worst = {.problems = 0};
  for (int kind = 0; kind < 4; kind++) {
    Problem p = problem_create(N);
    p.standard = true;
    for (uint32_t i = 0; i < N; i++) {
      for (uint32_t k = 0; k < N; k++) {
        const bool beside = i + 1 == k || k + 1 == i;
        const double kinds[] = {0.0, i == k ? N - i : 0.0, 1.0, i == k ? 2.0 : -(double)beside};
        p.stiffness[i * N + k] = kinds[kind];
      }
    }
    solve_and_compare(&p, &worst);
    problem_free(&p);
  }
  check("special", &worst);
}

/* Eigenvalues of the matrix (2 on the diagonal, -1 beside it) are 4 sin^2(k pi / (2 (n + 1))). */
static void known_ones(void **state) {
  (void)state;
  enum { N = 31 };
  Problem p = problem_create(N);
  Solution s = solution_create(N);
  for (uint32_t i = 0; i < N; i++) {
    p.stiffness[i * N + i] = 2.0;
    if (i) p.stiffness[i * N + i - 1] = p.stiffness[(i - 1) * N + i] = -1.0;
  }
  assert_true(solve(&p, &s));
  for (uint32_t k = 1; k <= N; k++) {
    const double root = 2.0 * sin(k * acos(-1.0) / (2.0 * (N + 1)));
    assert_true(fabs(s.values[k - 1] - root * root) <= 1e-14);
  }
  solution_free(&s);
  problem_free(&p);
}

static void refused(void **state) {
  (void)state;
  enum { N = 6 };
  static const double bad[] = {NAN, INFINITY, -INFINITY};
  uint64_t seed = 4;
  Solution s = solution_create(N);
  for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
    for (int of_mass = 0; of_mass < 2; of_mass++) {
      Problem p = random_problem(&seed, N);
      double *const matrix = of_mass ? p.mass : p.stiffness;
      matrix[2 * N + 3] = matrix[3 * N + 2] = bad[i];
      assert_false(solve(&p, &s));
      problem_free(&p);
    }
  }
  Problem p = random_problem(&seed, N);
  p.mass[2 * N + 2] = -1.0; /* not positive definite */
  assert_false(solve(&p, &s));
  problem_free(&p);
  solution_free(&s);
}

/* ---- the models of the presets --------------------------------------------------------------- */

static Worst *watching; /* NULL while nothing is compared */

bool __wrap_tb_eigen_symmetric(TbArena *scratch, uint32_t n, double *stiffness, double *mass,
                               double *eigenvalues, double *vectors);
bool __wrap_tb_eigen_symmetric(TbArena *scratch, uint32_t n, double *stiffness, double *mass,
                               double *eigenvalues, double *vectors) {
  Problem p = problem_create(n);
  p.standard = mass == NULL;
  memcpy(p.stiffness, stiffness, (size_t)n * n * sizeof *stiffness);
  if (mass) memcpy(p.mass, mass, (size_t)n * n * sizeof *mass);
  const bool solved = __real_tb_eigen_symmetric(scratch, n, stiffness, mass, eigenvalues, vectors);
  assert_true(solved);
  const Solution mine = {eigenvalues, vectors};
  if (watching) compare(&p, &mine, watching);
  problem_free(&p);
  return solved;
}

static void build(const char *preset, uint32_t quality, Worst *worst) {
  TaborDrumDef def;
  TaborModelOptions options;
  TaborModel *model;
  TaborError error;
  tabor_model_options_default(&options);
  options.quality = quality;
  watching = worst;
  assert_int_equal(tabor_drum_def_preset(&def, preset, &error), TABOR_OK);
  assert_int_equal(tabor_model_create(&def, &options, &model, &error), TABOR_OK);
  watching = NULL;
  tabor_model_release(model);
}

static void presets(void **state) {
  (void)state;
  for (uint32_t i = 0; i < tabor_preset_count() && !tabor_preset(i)->base; i++) {
    Worst worst = {.problems = 0};
    const char *const name = tabor_preset(i)->name;
    build(name, TABOR_QUALITY_LIVE, &worst);
    if (i == 0) build(name, TABOR_QUALITY_REFERENCE, &worst);
    check(name, &worst);
  }
}

int main(void) {
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(random_ones),  cmocka_unit_test(graded_ones), cmocka_unit_test(clustered_ones),
    cmocka_unit_test(special_ones), cmocka_unit_test(known_ones),  cmocka_unit_test(refused),
    cmocka_unit_test(presets),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
