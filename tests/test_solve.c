/* SPDX-License-Identifier: MIT */
/* The contact solve against fully converged independent solutions, and its remedies at small caps. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "reference.h"
#include "solve.h"

enum { MOST = 16, ROWS = MOST + TB_SLOTS };

/* A contact problem of up to 16 points, each with a law of its own, and the solver's memory. */
typedef struct Problem {
  uint32_t n;
  _Alignas(64) double compliance[MOST * MOST];
  double coupling[TB_SLOTS * ROWS], own[ROWS];
  double b[ROWS], y[ROWS], s[ROWS], force[ROWS], product[ROWS], scratch[10][ROWS];
  uint32_t active[ROWS];
  uint8_t row_wire[MOST];
  TbLaw laws[MOST], slot_laws[TB_SLOTS];
} Problem;

/* Rows that stand for nothing never touch. */
static void clear(Problem *p) {
  memset(p, 0, sizeof *p);
  for (int i = 0; i < ROWS; i++) p->y[i] = -1.0;
}

static TbSolve solver(Problem *p, uint32_t cap) {
  return (TbSolve){.kernels = &tb_kernels_baseline,
                   .wire_rows = p->n,
                   .stride = MOST,
                   .cap = cap,
                   .inner_cap = 64,
                   .compliance = p->compliance,
                   .coupling = p->coupling,
                   .own = p->own,
                   .row_wire = p->row_wire,
                   .wire_laws = p->laws,
                   .slot_laws = p->slot_laws,
                   .b = p->b,
                   .y = p->y,
                   .s = p->s,
                   .force = p->force,
                   .product = p->product,
                   .previous = p->scratch[0],
                   .slope = p->scratch[1],
                   .residual = p->scratch[2],
                   .scaled = p->scratch[3],
                   .work = p->scratch[4],
                   .direction = p->scratch[5],
                   .turned = p->scratch[6],
                   .weight = p->scratch[7],
                   .right = p->scratch[8],
                   .solution = p->scratch[9],
                   .active = p->active};
}

static void load_problem(Problem *p, const json_t *entry) {
  clear(p);
  double stiffness[MOST], exponent[MOST];
  p->n = (uint32_t)reference_vector(json_object_get(entry, "b"), p->b, MOST);
  reference_vector(json_object_get(entry, "eta_previous"), p->y, MOST);
  reference_vector(json_object_get(entry, "stiffness"), stiffness, MOST);
  reference_vector(json_object_get(entry, "exponent"), exponent, MOST);
  for (uint32_t i = 0; i < p->n; i++) {
    p->row_wire[i] = (uint8_t)i;
    tb_law_prepare(&p->laws[i], stiffness[i], exponent[i], 0.0, 1.0 / 48000.0, INFINITY);
    reference_vector(json_array_get(json_object_get(entry, "M"), i), p->compliance + i * MOST,
                     MOST);
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
    TbSolve solve = solver(&p, 16);
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
      worst = fmax(worst, fabs(p.s[i] - s[i]) / s_scale);
      worst = fmax(worst, fabs(p.force[i] - force[i]) / f_scale);
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
        p.compliance[i * MOST + j] = 1e-5 * sum;
      }
      largest = fmax(largest, p.compliance[i * MOST + i]);
    }
    for (uint32_t i = 0; i < p.n; i++) {
      p.row_wire[i] = (uint8_t)i;
      p.y[i] = uniform(-1e-4, 1e-4);
      p.b[i] = uniform(-3e-4, 3e-4);
      p.force[i] = rand() % 2 ? uniform(0.0, 10.0) : 0.0;
      const double loss = rand() % 2 ? uniform(0.0, 1.0) : 0.0;
      tb_law_prepare(&p.laws[i], pow(10.0, uniform(4.0, 13.0)), uniform(1.0, 3.0), loss,
                     1.0 / 48000.0, 10.0 / largest);
    }
    TbSolve solve = solver(&p, 1 + (uint32_t)(trial % 4));
    tb_solve_product(&solve, p.force, p.product);
    const TbSolveOutcome outcome = tb_solve(&solve);
    capped += outcome.capped;
    corrected += outcome.corrected;
    fallbacks += outcome.fallback;
    excesses += outcome.excess > 0.0;
    double work = 0.0, scale = 0.0;
    for (uint32_t i = 0; i < p.n; i++) {
      const double grown = tb_law_work(&p.laws[i], p.y[i], p.s[i]);
      work += p.force[i] * p.s[i] - grown;
      scale += fabs(p.force[i] * p.s[i]) + fabs(grown);
      /* s really is what these forces lead to */
      double s = p.b[i];
      for (uint32_t j = 0; j < p.n; j++) s -= p.compliance[i * MOST + j] * p.force[j];
      assert_true(fabs(s - p.s[i]) <= 1e-9 * (fabs(p.b[i]) + 1e-4));
    }
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
    p.row_wire[i] = (uint8_t)i;
    p.y[i] = -1e-3;
    p.b[i] = 5e-4;
    tb_law_prepare(&p.laws[i], 1e7, 1.5, 0.0, 1.0 / 48000.0, INFINITY);
  }
  TbSolve solve = solver(&p, 4);
  const TbSolveOutcome outcome = tb_solve(&solve);
  assert_false(outcome.contact);
  assert_true(p.s[0] == 5e-4 && p.force[1] == 0.0);
}

int main(void) {
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(converged_steps_agree_with_independent_ones),
    cmocka_unit_test(no_cap_creates_energy),
    cmocka_unit_test(without_contact_nothing_is_solved),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
