/* SPDX-License-Identifier: MIT */
/* The contact solve against fully converged independent solutions, and its remedies at small caps.
 */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "contact/solve.h"
#include "reference.h"

enum { MOST = 16, LANES = 8, STRIDE = MOST * LANES, ROWS = STRIDE + TB_SLOTS };

/* A contact problem of up to 16 points with a law of its own each: every point is lane 0 of a wire
 * of 8, and the grid is the points themselves. */
typedef struct Problem {
  uint32_t n;
  _Alignas(64) double matrix[STRIDE * STRIDE], across[MOST * MOST], fold[3 * MOST * LANES];
  double coupling[TB_SLOTS * STRIDE], slot_coupling[TB_SLOTS * TB_SLOTS];
  double own[ROWS], b[ROWS], y[ROWS], s[ROWS], force[ROWS], product[ROWS], scratch[15][ROWS];
  TbContactLaw laws[MOST], slot_laws[TB_SLOTS];
  uint32_t place[MOST * LANES];
  TbWireGrid wire_grid;
  TbCompliance compliance;
} Problem;

static double *compliance_at(Problem *p, uint32_t i, uint32_t j) {
  const uint32_t a = i * LANES, b = j * LANES;
  return &p->matrix[((size_t)(a / 8) * STRIDE + b) * 8 + a % 8];
}

/* Rows that stand for nothing never touch. */
static void clear(Problem *p) {
  memset(p, 0, sizeof *p);
  for (int i = 0; i < ROWS; i++) p->y[i] = -1.0;
  for (uint32_t i = 0; i < MOST; i++) p->across[i * MOST + i] = 1.0;
  for (uint32_t i = 0; i < MOST * LANES; i++) p->place[i] = i;
  p->wire_grid = (TbWireGrid){.wires = MOST,
                              .lanes = LANES,
                              .halves = 1,
                              .quarters = 1,
                              .half = LANES,
                              .lines = MOST,
                              .first_line = {0, MOST, MOST},
                              .columns = {LANES, LANES},
                              .across = p->across,
                              .place = {p->place},
                              .first = {0, STRIDE},
                              .size = STRIDE};
  p->compliance = (TbCompliance){.classes = 1, .first = {0, STRIDE}, .matrix = {p->matrix}};
}

/* Converged as far as doubles go with tolerance 0. */
static TbContacts contacts(Problem *p, uint32_t cap, double tolerance) {
  return (TbContacts){.kernels = &tb_kernels_baseline,
                      .wire_grid = &p->wire_grid,
                      .compliance = &p->compliance,
                      .rows = tb_rows(STRIDE),
                      .cap = cap,
                      .inner_cap = 64,
                      .tolerance = tolerance,
                      .inner_tolerance = tolerance > 0.0 ? 0.3 * tolerance : 1e-7,
                      .coupling = p->coupling,
                      .slot_coupling = p->slot_coupling,
                      .contact_compliance = p->own,
                      .wire_laws = p->laws,
                      .slot_laws = p->slot_laws,
                      .b = p->b,
                      .y = p->y};
}

static TbSolveWork workspace(Problem *p) {
  return (TbSolveWork){.s = p->s,
                       .force = p->force,
                       .product = p->product,
                       .grid = p->scratch[0],
                       .force_last = p->scratch[1],
                       .product_last = p->scratch[2],
                       .grid_last = p->scratch[3],
                       .law = p->scratch[4],
                       .slope = p->scratch[5],
                       .mean = p->scratch[6],
                       .residual = p->scratch[7],
                       .direction = p->scratch[8],
                       .turned = p->scratch[9],
                       .moved = p->scratch[10],
                       .weight = p->scratch[11],
                       .solution = p->scratch[12],
                       .pushed = p->scratch[13],
                       .answer = p->scratch[14],
                       .scratch = p->fold};
}

static TbSolve solver(Problem *p, uint32_t cap, double tolerance) {
  return (TbSolve){.in = contacts(p, cap, tolerance),
                   .warm = {p->force, p->product, p->scratch[0]},
                   .s = p->s,
                   .work = workspace(p)};
}

static void load_problem(Problem *p, const json_t *entry) {
  clear(p);
  double stiffness[MOST], exponent[MOST], b[MOST], y[MOST], compliance[MOST];
  p->n = (uint32_t)reference_vector(json_object_get(entry, "b"), b, MOST);
  reference_vector(json_object_get(entry, "eta_previous"), y, MOST);
  reference_vector(json_object_get(entry, "stiffness"), stiffness, MOST);
  reference_vector(json_object_get(entry, "exponent"), exponent, MOST);
  for (uint32_t i = 0; i < p->n; i++) {
    p->b[i * LANES] = b[i];
    p->y[i * LANES] = y[i];
    tb_contact_law_prepare(&p->laws[i], stiffness[i], exponent[i], 0.0, 1.0 / 48000.0, INFINITY);
    reference_vector(json_array_get(json_object_get(entry, "M"), i), compliance, MOST);
    for (uint32_t j = 0; j < p->n; j++) *compliance_at(p, i, j) = compliance[j];
  }
}

static void converged_steps_agree_with_independent_ones(void **state) {
  (void)state;
  json_t *root = reference_load("contact_steps.json");
  size_t index;
  json_t *entry;
  json_array_foreach(json_object_get(root, "problems"), index, entry) {
    Problem p;
    load_problem(&p, entry);
    TbSolve solve = solver(&p, 16, 0.0);
    const TbSolveOutcome outcome = tb_solve(&solve);
    assert_false(outcome.capped);
    double s[MOST], force[MOST], s_scale = 0.0, f_scale = 0.0, worst = 0.0;
    reference_vector(json_object_get(entry, "s"), s, MOST);
    reference_vector(json_object_get(entry, "force"), force, MOST);
    for (uint32_t i = 0; i < p.n; i++) {
      s_scale = fmax(s_scale, fabs(s[i]));
      f_scale = fmax(f_scale, fabs(force[i]));
    }
    for (uint32_t i = 0; i < p.n; i++) {
      worst = fmax(worst, fabs(p.s[i * LANES] - s[i]) / s_scale);
      worst = fmax(worst, fabs(p.force[i * LANES] - force[i]) / f_scale);
    }
    print_message("%u contacts: %u iterations, worst %.1e\n", p.n, outcome.iterations, worst);
    assert_true(worst < 1e-10);
  }
  json_decref(root);
}

static double uniform(double lo, double hi) { return lo + (hi - lo) * (rand() / (RAND_MAX + 1.0)); }

/* Work done on the contacts minus growth of their potential must not be negative at any cap. */
static void no_cap_creates_energy(void **state) {
  (void)state;
  const unsigned seed = 20261121;
  print_message("seed %u\n", seed);
  srand(seed);
  uint32_t capped = 0, corrected = 0, fallbacks = 0, excesses = 0;
  for (int trial = 0; trial < 20000; trial++) {
    Problem p;
    clear(&p);
    p.n = 1 + (uint32_t)(rand() % 8);
    double root[MOST][MOST];
    for (uint32_t i = 0; i < p.n; i++) {
      for (uint32_t j = 0; j < p.n; j++) root[i][j] = uniform(-1.0, 1.0);
    }
    double largest = 0.0;
    for (uint32_t i = 0; i < p.n; i++) {
      for (uint32_t j = 0; j < p.n; j++) {
        double sum = i == j ? 0.3 : 0.0;
        for (uint32_t l = 0; l < p.n; l++) sum += root[i][l] * root[j][l] / p.n;
        *compliance_at(&p, i, j) = 1e-5 * sum;
      }
      largest = fmax(largest, *compliance_at(&p, i, i));
    }
    for (uint32_t i = 0; i < p.n; i++) {
      p.y[i * LANES] = uniform(-1e-4, 1e-4);
      p.b[i * LANES] = uniform(-3e-4, 3e-4);
      p.force[i * LANES] = rand() % 2 ? uniform(0.0, 10.0) : 0.0;
      const double loss = rand() % 2 ? uniform(0.0, 1.0) : 0.0;
      tb_contact_law_prepare(&p.laws[i], pow(10.0, uniform(4.0, 13.0)), uniform(1.0, 3.0), loss,
                             1.0 / 48000.0, 10.0 / largest);
    }
    TbSolve solve = solver(&p, 1 + (uint32_t)(trial % 4), trial % 3 ? 1e-2 : 0.0);
    tb_solve_product(&solve, p.force, solve.warm.grid, p.product);
    const TbSolveOutcome outcome = tb_solve(&solve);
    capped += outcome.capped;
    corrected += outcome.corrected;
    fallbacks += outcome.fallback;
    excesses += outcome.excess > 0.0;
    double work = 0.0, scale = 0.0;
    for (uint32_t i = 0; i < p.n; i++) {
      const uint32_t row = i * LANES;
      const double grown = tb_contact_law_work(&p.laws[i], p.y[row], p.s[row]);
      work += p.force[row] * p.s[row] - grown;
      scale += fabs(p.force[row] * p.s[row]) + fabs(grown);
      /* s really is what these forces lead to */
      double s = p.b[row];
      for (uint32_t j = 0; j < p.n; j++) s -= *compliance_at(&p, i, j) * p.force[j * LANES];
      assert_true(fabs(s - p.s[row]) <= 1e-9 * (fabs(p.b[row]) + 1e-4));
    }
    /* What the laws lost is booked, and no more than was taken. */
    assert_true(2.0 * outcome.contact_loss <= work + outcome.excess + 1e-11 * scale + 1e-300);
    /* What remains is reported, for the guard to take. */
    assert_true(work + outcome.excess >= -1e-11 * scale - 1e-300);
  }
  print_message("20000 trials: %u capped, %u corrected, %u fallbacks, %u left to the guard\n",
                capped, corrected, fallbacks, excesses);
  assert_true(capped > 100 && corrected > 10 && fallbacks > 10);
}

static void without_contact_nothing_is_solved(void **state) {
  (void)state;
  Problem p;
  clear(&p);
  p.n = 2;
  for (uint32_t i = 0; i < 2; i++) {
    p.y[i * LANES] = -1e-3;
    p.b[i * LANES] = 5e-4;
    tb_contact_law_prepare(&p.laws[i], 1e7, 1.5, 0.0, 1.0 / 48000.0, INFINITY);
  }
  TbSolve solve = solver(&p, 4, 0.0);
  const TbSolveOutcome outcome = tb_solve(&solve);
  assert_false(outcome.contact);
  assert_true(p.s[0] == 5e-4 && p.force[LANES] == 0.0);
}

int main(void) {
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(converged_steps_agree_with_independent_ones),
    cmocka_unit_test(no_cap_creates_energy),
    cmocka_unit_test(without_contact_nothing_is_solved),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
