/* SPDX-License-Identifier: MIT */
#include "solve.h"

#include <math.h>
#include <string.h>

/* Newton has converged when the residual is rounding noise of what it is a difference of. */
static const double RELATIVE_TOLERANCE = 1e-14;
static const double PENETRATION_TOLERANCE = 4e-15;
/* A balance is exact to this part of the work that makes it up. */
static const double BALANCE_TOLERANCE = 3e-13;
static const uint32_t MOST_BALANCE_STEPS = 8;

static uint32_t total_rows(const TbSolve *solve) { return solve->stride + TB_SLOTS; }

static bool in_play(const TbSolve *solve, uint32_t slot) { return solve->slot_mask >> slot & 1u; }

/* ---- M x ------------------------------------------------------------------------------------ */

void tb_solve_stretch(const TbSolve *solve, const double *pushed, const double *slots,
                      double *answer, double *out) {
  const uint32_t size = solve->bed->size;
  double along[2] = {0.0, 0.0};
  for (uint32_t h = 0; h < solve->stretch_count; h++) {
    along[h] = solve->kernels->dot(size, solve->stretch_grid[h], pushed) +
               solve->kernels->dot(TB_SLOTS, solve->stretch_slots[h], slots);
  }
  for (uint32_t h = 0; h < solve->stretch_count; h++) {
    const double *w = solve->stretch_weight[h];
    const double pull = -(w[0] * along[0] + w[1] * along[1]);
    solve->kernels->add_scaled(size, answer, pull, solve->stretch_grid[h]);
    solve->kernels->add_scaled(TB_SLOTS, out, pull, solve->stretch_slots[h]);
  }
}

/* What forces on the grid (`pushed`) and at the slots do to the head: `answer` on the grid, out[] at
 * the slots. */
static void push_head(const TbSolve *solve, const double *pushed, const double *slots,
                      double *answer, double *out) {
  const uint32_t size = solve->bed->size;
  tb_compliance_apply(solve->compliance, solve->kernels, pushed, answer);
  for (uint32_t slot = 0; slot < TB_SLOTS; slot++) {
    out[slot] = 0.0;
    if (!in_play(solve, slot)) continue;
    const double *coupling = solve->coupling + (uint64_t)slot * size;
    out[slot] = solve->kernels->dot(size, coupling, pushed);
    for (uint32_t other = 0; other < TB_SLOTS; other++) {
      out[slot] += solve->slot_coupling[slot * TB_SLOTS + other] * slots[other];
    }
    if (slots[slot] != 0.0) solve->kernels->add_scaled(size, answer, slots[slot], coupling);
  }
  tb_solve_stretch(solve, pushed, slots, answer, out);
}

/* Over all rows: product = own f + (the head's motion `response`, and at the slots `slots`). */
static void expand_response(const TbSolve *solve, const double *f, const double *response,
                            const double *slots, double *product) {
  tb_bed_expand(solve->bed, solve->kernels, &solve->bed->all, response, solve->scratch, product);
  memcpy(product + solve->stride, slots, TB_SLOTS * sizeof *slots);
  solve->kernels->add_product(total_rows(solve), product, solve->own, f);
}

void tb_solve_product(const TbSolve *solve, const double *x, double *grid, double *out) {
  _Alignas(64) double slots[TB_SLOTS];
  tb_bed_contract(solve->bed, solve->kernels, &solve->bed->all, x, solve->scratch, grid);
  push_head(solve, grid, x + solve->stride, solve->answer, slots);
  expand_response(solve, x, solve->answer, slots, out);
}

/* out = M x over the n listed blocks and the slots behind them; leaves the head's part in `answer`
 * and slots[]. */
static void listed_product(TbSolve *solve, uint32_t n, const double *x, double *slots,
                           double *out) {
  tb_bed_contract(solve->bed, solve->kernels, &solve->blocks, x, solve->scratch, solve->pushed);
  push_head(solve, solve->pushed, x + 8 * n, solve->answer, slots);
  tb_bed_expand(solve->bed, solve->kernels, &solve->blocks, solve->answer, solve->scratch, out);
  memcpy(out + 8 * n, slots, TB_SLOTS * sizeof *slots);
  solve->kernels->add_own(n + TB_SLOT_BLOCKS, solve->row, solve->own, x, out);
}

static double largest_of(const double *eight) {
  double largest = 0.0;
  for (uint32_t l = 0; l < 8; l++) largest = eight[l] > largest ? eight[l] : largest;
  return largest;
}

/* ---- rows that matter ----------------------------------------------------------------------- */

static uint32_t touched_blocks(TbSolve *solve) {
  return solve->kernels->mark(solve->stride / 8, solve->y, solve->s, solve->force, solve->touch);
}

/* Lists the blocks that touched so far, touch at s, or carry a force, by their lanes; the slots come
 * last. Returns the number of blocks without them. */
static uint32_t list_blocks(TbSolve *solve) {
  const TbBed *bed = solve->bed;
  const uint32_t blocks = bed->lanes / 8, listed = tb_bed_listed(bed);
  TbBlocks *list = &solve->blocks;
  const uint8_t *touch = solve->touch;
  touched_blocks(solve);
  uint32_t n = 0, count = 0;
  for (uint32_t b = 0; b < blocks; b++) {
    list->begin[b] = count;
    for (uint32_t w = 0; w < listed; w++) {
      const uint32_t image = bed->quarters == 2 ? bed->wires - 1 - w : w;
      if (!(touch[w * blocks + b] | touch[image * blocks + b])) continue;
      list->wire[count] = w;
      list->at[count] = list->image[count] = 8 * n;
      solve->wire[n] = w;
      solve->row[n++] = w * bed->lanes + 8 * b;
      if (image != w) {
        list->image[count] = 8 * n;
        solve->wire[n] = image;
        solve->row[n++] = image * bed->lanes + 8 * b;
      }
      count++;
    }
  }
  list->begin[blocks] = count;
  for (uint32_t k = 0; k < TB_SLOT_BLOCKS; k++) solve->row[n + k] = solve->stride + 8 * k;
  return n;
}

static void slot_laws(TbSolve *solve, uint32_t at) {
  for (uint32_t slot = 0; slot < TB_SLOTS; slot++) {
    TbLawResult law = {0.0, 0.0, 0.0};
    if (in_play(solve, slot)) {
      law = tb_law_force(&solve->slot_laws[slot], solve->row_y[at + slot], solve->row_s[at + slot]);
    }
    solve->law_force[at + slot] = law.force;
    solve->slope[at + slot] = law.slope;
    solve->mean[at + slot] = law.mean;
  }
}

/* Forces, slopes and means of the laws at row_y and row_s. */
static void apply_laws(TbSolve *solve, uint32_t n) {
  for (uint32_t k = 0; k < n; k++) {
    const uint32_t at = 8 * k;
    tb_law_forces(&solve->wire_laws[solve->wire[k]], solve->kernels, solve->row_y + at,
                  solve->row_s + at, solve->law_force + at, solve->slope + at, solve->mean + at);
  }
  slot_laws(solve, 8 * n);
}

static void gather(const TbSolve *solve, uint32_t n, const double *rows, double *listed) {
  solve->kernels->gather(n + TB_SLOT_BLOCKS, solve->row, rows, listed);
}

/* The laws at s; returns the largest difference from the forces that led there. */
static double evaluate(TbSolve *solve, uint32_t *n) {
  *n = list_blocks(solve);
  gather(solve, *n, solve->y, solve->row_y);
  gather(solve, *n, solve->s, solve->row_s);
  apply_laws(solve, *n);
  _Alignas(TB_ALIGNMENT) double most[8] = {0.0};
  for (uint32_t k = 0; k < *n + TB_SLOT_BLOCKS; k++) {
    solve->kernels->miss(solve->law_force + 8 * k, solve->force + solve->row[k], most);
  }
  return largest_of(most);
}

static uint32_t count_touching(const TbSolve *solve, uint32_t n) {
  uint32_t count = 0;
  for (uint32_t i = 0; i < 8 * n + TB_SLOTS; i++) count += solve->slope[i] > 0.0;
  return count;
}

/* ---- one Newton step ------------------------------------------------------------------------ */

/* r = s + M f - b with the laws' forces, whose response is left in `response` and slots[]; returns
 * max |r|. */
static double find_residual(TbSolve *solve, uint32_t n, double *slots) {
  listed_product(solve, n, solve->law_force, slots, solve->residual);
  memcpy(solve->response, solve->answer, solve->bed->size * sizeof *solve->response);
  _Alignas(TB_ALIGNMENT) double most[8] = {0.0};
  for (uint32_t k = 0; k < n + TB_SLOT_BLOCKS; k++) {
    const uint32_t row = solve->row[k];
    solve->kernels->residual(solve->s + row, solve->b + row, solve->residual + 8 * k, most);
  }
  return largest_of(most);
}

/* Solves (I + W M W) p = right, given in `residual`, over the listed rows by conjugate gradients from
 * p = 0, W = diag(weight), into `solution`; adds the head's motion under W p to `response` and slots[].
 */
static void solve_inner(TbSolve *solve, uint32_t n, double *slots) {
  const TbKernels *kernels = solve->kernels;
  const uint32_t length = 8 * n + TB_SLOTS;
  double *right = solve->residual, *d = solve->direction;
  _Alignas(64) double step_slots[TB_SLOTS];
  memset(solve->solution, 0, length * sizeof(double));
  memcpy(d, right, length * sizeof(double));
  double square = kernels->dot(length, right, right);
  const double enough = square * solve->inner_tolerance * solve->inner_tolerance;
  for (uint32_t i = 0; i < solve->inner_cap && square > enough; i++) {
    kernels->product(length, solve->work, solve->weight, d);
    listed_product(solve, n, solve->work, step_slots, solve->turned);
    const double bend = kernels->turn(length, solve->turned, d, solve->weight, solve->turned);
    const double step = square / bend;
    const double next = kernels->advance(length, step, solve->solution, d, right, solve->turned);
    kernels->add_scaled(solve->bed->size, solve->response, step, solve->answer);
    for (uint32_t slot = 0; slot < TB_SLOTS; slot++) slots[slot] += step * step_slots[slot];
    kernels->redirect(length, next / square, d, right);
    square = next;
  }
}

/* s = b - M f from `response` and slots[], over all rows. */
static void follow(TbSolve *solve, const double *slots) {
  expand_response(solve, solve->force, solve->response, slots, solve->product);
  for (uint32_t i = 0; i < total_rows(solve); i++) solve->s[i] = solve->b[i] - solve->product[i];
}

/* force = law_force + weight solution, and s with it. */
static void take_forces(TbSolve *solve, uint32_t n, bool solved, const double *slots) {
  if (solved) {
    solve->kernels->add_product(8 * n + TB_SLOTS, solve->law_force, solve->weight, solve->solution);
  }
  for (uint32_t k = 0; k < n + TB_SLOT_BLOCKS; k++) {
    memcpy(solve->force + solve->row[k], solve->law_force + 8 * k, 8 * sizeof(double));
  }
  follow(solve, slots);
}

static void newton_step(TbSolve *solve, uint32_t n, double *slots) {
  solve->kernels->weigh(8 * n + TB_SLOTS, solve->slope, solve->weight, solve->residual);
  solve_inner(solve, n, slots);
  take_forces(solve, n, true, slots);
}

/* ---- the balance ---------------------------------------------------------------------------- */

/* Sum s (f(s) - f~), its derivative in t, and Sum |s f~|, at f~ + t g and s - t M g. */
typedef struct Balance {
  double value, derivative, scale;
} Balance;

static double sum_of(const double *eight) {
  return ((eight[0] + eight[4]) + (eight[2] + eight[6])) +
         ((eight[1] + eight[5]) + (eight[3] + eight[7]));
}

static Balance balance_at(TbSolve *solve, uint32_t n, double t) {
  _Alignas(TB_ALIGNMENT) double sum[24] = {0.0};
  for (uint32_t k = 0; k < n + TB_SLOT_BLOCKS; k++) {
    const uint32_t row = solve->row[k], i = 8 * k;
    solve->kernels->balance(t, solve->row_s + i, solve->law_force + i, solve->slope + i,
                            solve->force + row, solve->previous + row, solve->product + row,
                            solve->previous_product + row, sum);
  }
  return (Balance){sum_of(sum), sum_of(sum + 8), sum_of(sum + 16)};
}

static void laws_at(TbSolve *solve, uint32_t n, double t) {
  for (uint32_t k = 0; k < n + TB_SLOT_BLOCKS; k++) {
    for (uint32_t l = 0; l < 8; l++) {
      const uint32_t row = solve->row[k] + l;
      solve->row_s[8 * k + l] =
        solve->s[row] - t * (solve->product[row] - solve->previous_product[row]);
    }
  }
  apply_laws(solve, n);
}

/* force += t g, and what follows from it, over all rows. */
static void move_forces(TbSolve *solve, double t) {
  for (uint32_t i = 0; i < total_rows(solve); i++) {
    solve->force[i] += t * (solve->force[i] - solve->previous[i]);
    solve->product[i] += t * (solve->product[i] - solve->previous_product[i]);
    solve->s[i] = solve->b[i] - solve->product[i];
  }
}

/* Moves the forces to where their work is what the laws say; false if that is further than `reach`
 * away. The laws have just been evaluated at s. */
static bool balance(TbSolve *solve, uint32_t n, double reach) {
  double t = 0.0;
  Balance h = balance_at(solve, n, t);
  for (uint32_t i = 0; fabs(h.value) > BALANCE_TOLERANCE * h.scale; i++) {
    if (i == MOST_BALANCE_STEPS) return false;
    t -= h.value / h.derivative;
    if (!(fabs(t) <= reach)) return false;
    laws_at(solve, n, t);
    h = balance_at(solve, n, t);
  }
  if (t == 0.0) return true;
  const uint32_t touched = touched_blocks(solve);
  move_forces(solve, t);
  return touched_blocks(solve) == touched; /* else something else touches now, and was left out */
}

/* What the laws lose in a step, with the values of the last evaluation. */
static void book_losses(const TbSolve *solve, uint32_t n, TbSolveOutcome *outcome) {
  double sum[8] = {0.0};
  for (uint32_t i = 0; i < 8 * n; i += 8) {
    for (uint32_t l = 0; l < 8; l++) {
      sum[l] += solve->row_s[i + l] * (solve->law_force[i + l] - solve->mean[i + l]);
    }
  }
  double contact = 0.0, damper = 0.0;
  for (uint32_t l = 0; l < 8; l++) contact += sum[l];
  for (uint32_t slot = 0; slot < TB_SLOTS; slot++) {
    if (!in_play(solve, slot)) continue;
    const uint32_t i = 8 * n + slot;
    const bool hand = solve->slot_laws[slot].kind == TB_LAW_DAMPER;
    *(hand ? &damper : &contact) += solve->row_s[i] * (solve->law_force[i] - solve->mean[i]);
  }
  outcome->contact_loss = 0.5 * contact;
  outcome->damper_loss = 0.5 * damper;
}

/* ---- the majorant --------------------------------------------------------------------------- */

/* Curvature of the parabola through V(y) with slope V'(y) that lies above V between y and y + sp. */
static double majorant_curvature(const TbLaw *law, double y, double b, double free) {
  double sp = free > 0.0 ? free : 0.0;
  if (b > sp) sp = 0.5 * (sp + b);
  const double size = fabs(y) > sp ? fabs(y) : sp;
  if (sp <= 1e-9 * size) return tb_law_curvature(law, y);
  const double bend = tb_law_work(law, y, sp) - tb_law_static_force(law, y) * sp;
  return bend > 0.0 ? 2.0 * bend / (sp * sp) : 0.0;
}

static const TbLaw *law_of(const TbSolve *solve, uint32_t k, uint32_t lane) {
  if (solve->row[k] >= solve->stride) {
    return &solve->slot_laws[solve->row[k] - solve->stride + lane];
  }
  return &solve->wire_laws[solve->wire[k]];
}

/* Force at s = 0 and half the curvature of every listed row's majorant. */
static void prepare_majorants(TbSolve *solve, uint32_t n) {
  for (uint32_t i = 0; i < 8 * n + TB_SLOTS; i++) {
    const uint32_t row = solve->row[i / 8] + i % 8;
    solve->law_force[i] = solve->slope[i] = 0.0;
    if (i >= 8 * n && !in_play(solve, i - 8 * n)) continue;
    const TbLaw *law = law_of(solve, i / 8, i % 8);
    const double y = solve->y[row], b = solve->b[row];
    solve->law_force[i] = tb_law_static_force(law, y);
    solve->slope[i] = law->kind == TB_LAW_DAMPER
                        ? law->loss
                        : 0.5 * majorant_curvature(law, y, b, b - solve->previous_product[row]);
  }
}

/* Work still to be found for the growth of the potential: > 0 means energy was created; and what the
 * laws lose at s. */
static Balance majorant_work(TbSolve *solve, uint32_t n, double *contact, double *damper) {
  Balance h = {0.0, 0.0, 0.0};
  for (uint32_t i = 0; i < 8 * n + TB_SLOTS; i++) {
    if (i >= 8 * n && !in_play(solve, i - 8 * n)) continue;
    const TbLaw *law = law_of(solve, i / 8, i % 8);
    const uint32_t row = solve->row[i / 8] + i % 8;
    const double work = solve->force[row] * solve->s[row];
    h.value += tb_law_work(law, solve->y[row], solve->s[row]) - work;
    h.scale += fabs(work);
    *(law->kind == TB_LAW_DAMPER ? damper : contact) +=
      tb_law_loss(law, solve->y[row], solve->s[row]);
  }
  return h;
}

/* Lists what could touch without forces, or with the last ones. */
static uint32_t list_candidates(TbSolve *solve) {
  for (uint32_t i = 0; i < total_rows(solve); i++) {
    const double with = solve->b[i] - solve->previous_product[i];
    solve->s[i] = with > solve->b[i] ? with : solve->b[i];
  }
  return list_blocks(solve);
}

/* Lists rows anew, and says in *count how many blocks there are then. */
static void majorant_step(TbSolve *solve, uint32_t *count, TbSolveOutcome *outcome) {
  _Alignas(64) double slots[TB_SLOTS];
  const uint32_t n = list_candidates(solve);
  prepare_majorants(solve, n);
  memset(solve->force, 0, total_rows(solve) * sizeof(double));
  memset(solve->s, 0, total_rows(solve) * sizeof(double));
  find_residual(solve, n, slots);
  newton_step(solve, n, slots);
  /* f = V'(y) + C s/2 at the s of that solution; all rows that touch there must be listed. */
  for (uint32_t k = 0; k < n + TB_SLOT_BLOCKS; k++) {
    for (uint32_t l = 0; l < 8; l++) {
      const uint32_t row = solve->row[k] + l;
      if (k >= n && !in_play(solve, row - solve->stride)) continue;
      const TbLaw *law = law_of(solve, k, l);
      solve->force[row] =
        tb_law_static_force(law, solve->y[row]) + solve->slope[8 * k + l] * solve->s[row];
    }
  }
  tb_solve_product(solve, solve->force, solve->grid, solve->product);
  for (uint32_t i = 0; i < total_rows(solve); i++) solve->s[i] = solve->b[i] - solve->product[i];
  *count = list_blocks(solve);
  double contact = 0.0, damper = 0.0;
  const Balance h = majorant_work(solve, *count, &contact, &damper);
  if (h.value > BALANCE_TOLERANCE * h.scale) outcome->excess = h.value;
  /* The laws' losses count as far as the work done covers them. */
  const double lost = contact + damper, covered = h.value < 0.0 ? -0.5 * h.value : 0.0;
  const double part = lost > covered ? covered / lost : 1.0;
  outcome->contact_loss = part * contact;
  outcome->damper_loss = part * damper;
}

/* ---- the solve ------------------------------------------------------------------------------ */

static double largest_magnitude(uint32_t n, const double *x) {
  double most[8] = {0.0};
  for (uint32_t i = 0; i < n; i += 8) {
    for (uint32_t l = 0; l < 8; l++) {
      const double size = fabs(x[i + l]);
      most[l] = size > most[l] ? size : most[l];
    }
  }
  return largest_of(most);
}

static double noise(const TbSolve *solve, uint32_t n) {
  double depth = 0.0;
  for (uint32_t i = 0; i < 8 * n + TB_SLOTS; i++) {
    depth = solve->row_y[i] > depth ? solve->row_y[i] : depth;
  }
  return RELATIVE_TOLERANCE * largest_magnitude(total_rows(solve), solve->b) +
         PENETRATION_TOLERANCE * depth;
}

static bool anything_acts(const TbSolve *solve) {
  if (solve->slot_mask) {
    for (uint32_t slot = 0; slot < TB_SLOTS; slot++) {
      const uint32_t row = solve->stride + slot;
      if (in_play(solve, slot) && solve->slot_laws[slot].kind == TB_LAW_DAMPER) return true;
      if (solve->y[row] > 0.0 || solve->y[row] + solve->b[row] > 0.0) return true;
      if (solve->force[row] != 0.0) return true;
    }
  }
  return solve->kernels->mark(solve->stride / 8, solve->y, solve->b, solve->force, solve->touch) >
         0;
}

static void come_to_rest(TbSolve *solve) {
  const size_t bytes = total_rows(solve) * sizeof(double);
  memset(solve->force, 0, bytes);
  memset(solve->product, 0, bytes);
  memset(solve->grid, 0, solve->bed->size * sizeof(double));
  memcpy(solve->s, solve->b, bytes);
}

/* Newton's iteration; true if it came to its end, with forces, product and s set. */
static bool iterate(TbSolve *solve, TbSolveOutcome *outcome, uint32_t *n) {
  _Alignas(64) double slots[TB_SLOTS];
  double first = 0.0;
  for (;;) {
    const double miss = evaluate(solve, n);
    if (miss == 0.0) return true;
    if (outcome->iterations == 0) first = miss;
    const bool near = outcome->iterations > 0 && miss <= solve->tolerance * first;
    if (near && balance(solve, *n, 0.1)) return true;
    if (solve->tolerance > 0.0 && outcome->iterations == solve->cap) return false;
    const double error = find_residual(solve, *n, slots);
    if (error <= noise(solve, *n)) {
      take_forces(solve, *n, false, slots);
      return true;
    }
    if (outcome->iterations == solve->cap) return false;
    newton_step(solve, *n, slots);
    outcome->iterations++;
  }
}

/* A balance that failed in the last iteration may have moved the forces to where more rows touch than were
 * listed: what touches is listed anew. */
static void remedy(TbSolve *solve, uint32_t *n, TbSolveOutcome *outcome) {
  outcome->capped = true;
  evaluate(solve, n);
  if (balance(solve, *n, 0.5)) {
    outcome->corrected = true;
    book_losses(solve, *n, outcome);
    return;
  }
  outcome->fallback = true;
  majorant_step(solve, n, outcome);
}

TbSolveOutcome tb_solve(TbSolve *solve) {
  TbSolveOutcome outcome = {0};
  const size_t bytes = total_rows(solve) * sizeof(double);
  memset(solve->touch, 0, solve->stride / 8);
  if (!anything_acts(solve)) {
    come_to_rest(solve);
    return outcome;
  }
  outcome.contact = true;
  memcpy(solve->previous, solve->force, bytes);
  memcpy(solve->previous_product, solve->product, bytes);
  for (uint32_t i = 0; i < total_rows(solve); i++) solve->s[i] = solve->b[i] - solve->product[i];
  uint32_t n = 0;
  if (iterate(solve, &outcome, &n)) {
    book_losses(solve, n, &outcome);
  } else {
    remedy(solve, &n, &outcome);
  }
  outcome.touching = count_touching(solve, n);
  gather(solve, n, solve->force, solve->work);
  tb_bed_contract(solve->bed, solve->kernels, &solve->blocks, solve->work, solve->scratch,
                  solve->grid);
  return outcome;
}
