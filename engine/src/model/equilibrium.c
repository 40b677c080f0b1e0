/* SPDX-License-Identifier: MIT */
/* The static equilibrium of head and wires under gravity, strainer and contact.
 *
 * Let y be the contact forces, C the static compliance of head and wires at the contact points, and
 * eta0 the penetration without contact; then eta = eta0 - C y. The potential y^T C y/2 + Sum
 * V(eta0 - C y) is convex. Newton's step on this potential solves (I + D C) delta = f(eta) - y,
 * D = V''. The solution is
 *   delta = rho - D^(1/2) w, (I + D^(1/2) C D^(1/2)) w = D^(1/2) C rho, rho = f - y.
 *
 * C is a block per wire plus the head's part, which goes through the grid of wire_grid.h. The
 * wires' part alone is solved directly and preconditions conjugate gradients for the whole system.
 * The head is about as stiff as the bed of wires, so a few steps suffice.
 *
 * The shape of a bent wire (wire_shape.h) is a part of eta0, and so of the datum of the
 * penetration. Heights of wires, in rest.v and in the state, are counted from that shape. */
#include <math.h>
#include <string.h>

#include "math/bessel.h"
#include "math/cholesky.h"
#include "model/model.h"

static const double PI = 3.14159265358979323846;

/* Vectors by rows; those that stand for nothing stay 0. */
typedef struct Statics {
  uint32_t n;                             /* rows */
  TbCompliance head;                      /* under constant forces */
  double *wires[TABOR_MAX_WIRES];         /* compliance of each wire, [row_count][row_count] */
  double *factors[TABOR_MAX_WIRES];       /* of I + D^(1/2) C D^(1/2) with the wire alone */
  double *responses[TABOR_MAX_WIRES];     /* see wire_responses() */
  double *eta0;                           /* [n] */
  double *weight;                         /* [padded]: gravity and rod on each mode [N] */
  double *grid, *answer, *fold, *yielded; /* scratch */
} Statics;

/* Weight of the heads on each mode: -Sum rho g Int phi dA, which only m = 0 has. */
static void weigh_head(const TaborModel *model, double *weight) {
  const TbBodyOrder *order = &model->body.orders[0];
  const double radius = model->body.radius;
  const TaborHeadDef *const sheet = model->body.sheet;
  for (uint32_t i = 0; i < model->modes.padded; i++) {
    if (model->modes.row[i] == TB_NO_MODE) continue;
    const TbBodyMode *mode = &model->body.modes[model->modes.row[i]];
    if (mode->m != 0) continue;
    for (uint32_t h = 0; h < model->body.surfaces; h++) {
      const double load = -sheet[h].surface_density * model->def.air.gravity;
      const double *v = order->vectors[h] + (size_t)mode->place * order->zero_count;
      double area = 0.0;
      for (uint32_t z = 0; z < order->zero_count; z++) {
        area += v[z] * tb_bessel_j(1, order->zeros[z]) / order->zeros[z];
      }
      if (model->body.free_edge) area += 0.5 * order->edge[h][mode->place];
      weight[i] += load * 2.0 * PI * radius * radius * area;
    }
  }
}

/* The rod of a hi-hat. */
static void push_rod(const TaborModel *model, double *weight) {
  const TbModeForce *rod = &model->rod;
  for (uint32_t i = 0; i < rod->count; i++) {
    weight[rod->mode[i]] += rod->along[rod->mode[i]] * model->def.hihat.opening;
  }
}

/* Stiffness of the inner nodes of one wire: -(T/h) D2 + (EI/h^3) D2^2, hinged. */
static void wire_stiffness(const TbWire *wire, uint32_t n, double *matrix) {
  const double h = wire->spacing;
  const double stretch = wire->tension / h, bend = wire->bending_stiffness / (h * h * h);
  for (uint32_t i = 0; i < n; i++) {
    const double end = (i == 0 ? 1.0 : 0.0) + (i == n - 1 ? 1.0 : 0.0);
    matrix[i * n + i] = 2.0 * stretch + (6.0 - end) * bend;
    if (i + 1 < n) matrix[i * n + i + 1] = matrix[(i + 1) * n + i] = -stretch - 4.0 * bend;
    if (i + 2 < n) matrix[i * n + i + 2] = matrix[(i + 2) * n + i] = bend;
  }
}

/* Responses of one wire: row_count unit forces, then gravity; responses[column][inner node]. */
static bool wire_responses(const TbWires *wires, const TbWire *wire, TbArena *scratch,
                           double *responses) {
  const uint32_t n = wire->cells - 1, columns = wire->row_count + 1;
  double *matrix = tb_arena_doubles(scratch, (size_t)n * n);
  if (!matrix) return false;
  wire_stiffness(wire, n, matrix);
  for (uint32_t c = 0; c < wire->row_count; c++) responses[c * n + wire->row_node + c - 1] = 1.0;
  for (uint32_t i = 0; i < n; i++) {
    responses[wire->row_count * n + i] = wire->mass_per_length * wire->spacing * wires->gravity;
  }
  return tb_solve_positive(n, matrix, columns, responses);
}

/* The head's part of C, and of eta0 under its own weight. */
static TaborStatus head_statics(const TaborModel *model, TbArena *scratch, Statics *s) {
  const TbModes *modes = &model->modes;
  const TbWireGrid *wire_grid = &model->projection.wire_grid;
  double *gain = tb_arena_doubles(scratch, modes->padded);
  double *sag = tb_arena_doubles(scratch, modes->padded);
  if (scratch->failed) return TABOR_ERROR_MEMORY;
  for (uint32_t i = 0; i < modes->padded; i++) {
    gain[i] = modes->row[i] == TB_NO_MODE ? 0.0 : 1.0 / modes->stiffness[i];
    sag[i] = gain[i] * s->weight[i];
  }
  tb_project(&model->projection, model->kernels, sag, s->grid);
  model->kernels->grid_to_rows(wire_grid, s->grid, s->fold, s->eta0);
  for (uint32_t a = 0; a < s->n; a++) s->eta0[a] *= model->wires.real[a] * model->wires.side;
  return tb_compliance_prepare(&s->head, scratch, &model->projection, gain);
}

/* out = C y */
static void yield(const TaborModel *model, const Statics *s, const double *y, double *out) {
  const TbWireGrid *wire_grid = &model->projection.wire_grid;
  model->kernels->rows_to_grid(wire_grid, y, s->fold, s->grid);
  model->kernels->apply_compliance(&s->head, s->grid, s->answer);
  model->kernels->grid_to_rows(wire_grid, s->answer, s->fold, out);
  for (uint32_t a = 0; a < s->n; a++) out[a] *= model->wires.real[a];
  for (uint32_t w = 0; w < model->wires.count; w++) {
    const TbWire *wire = &model->wires.wires[w];
    for (uint32_t a = 0; a < wire->row_count; a++) {
      const double *row = s->wires[w] + (size_t)a * wire->row_count;
      double sum = 0.0;
      for (uint32_t b = 0; b < wire->row_count; b++) sum += row[b] * y[wire->first_row + b];
      out[wire->first_row + a] += sum;
    }
  }
}

static double total_potential(const TaborModel *model, const Statics *s, const double *y,
                              double *eta) {
  double sum = 0.0;
  yield(model, s, y, s->yielded);
  for (uint32_t a = 0; a < s->n; a++) {
    if (model->wires.real[a] == 0.0) continue;
    eta[a] = s->eta0[a] - s->yielded[a];
    sum += 0.5 * y[a] * s->yielded[a] +
           tb_contact_law_potential(&model->wires.laws[model->wires.row_wire[a]], eta[a]);
  }
  return sum;
}

/* rho = f(eta) - y and D^(1/2); returns the largest |rho|. */
static double imbalance(const TaborModel *model, const Statics *s, const double *y,
                        const double *eta, double *rho, double *root) {
  double largest = 0.0;
  for (uint32_t a = 0; a < s->n; a++) {
    if (model->wires.real[a] == 0.0) continue;
    const TbContactLaw *law = &model->wires.laws[model->wires.row_wire[a]];
    rho[a] = tb_contact_law_static_force(law, eta[a]) - y[a];
    root[a] = sqrt(tb_contact_law_curvature(law, eta[a]));
    largest = fmax(largest, fabs(rho[a]));
  }
  return largest;
}

static bool factor_wires(TbArena *watched, const TaborModel *model, Statics *s,
                         const double *root) {
  for (uint32_t w = 0; w < model->wires.count; w++) {
    if (!tb_arena_go_on(watched)) return false;
    const TbWire *wire = &model->wires.wires[w];
    const uint32_t n = wire->row_count;
    const double *part = root + wire->first_row;
    for (uint32_t a = 0; a < n; a++) {
      for (uint32_t b = 0; b < n; b++) {
        s->factors[w][a * n + b] =
          part[a] * s->wires[w][a * n + b] * part[b] + (a == b ? 1.0 : 0.0);
      }
    }
    if (!tb_factor_positive(n, s->factors[w])) return false;
  }
  return true;
}

static void precondition(const TaborModel *model, const Statics *s, const double *r, double *z) {
  for (uint32_t a = 0; a < s->n; a++) z[a] = r[a];
  for (uint32_t w = 0; w < model->wires.count; w++) {
    const TbWire *wire = &model->wires.wires[w];
    tb_solve_with_factor(wire->row_count, s->factors[w], z + wire->first_row);
  }
}

static double dot(uint32_t n, const double *x, const double *y) {
  double sum = 0.0;
  for (uint32_t i = 0; i < n; i++) sum += x[i] * y[i];
  return sum;
}

/* Scratch of one linear solve, [n] each. */
typedef struct Inner {
  double *r, *z, *d, *md, *turned;
} Inner;

/* Solves (I + R C R) w = r, R = diag(root); r is used up. */
static bool solve_direction(TbArena *watched, const TaborModel *model, Statics *s,
                            const double *root, Inner *in, double *w) {
  const uint32_t n = s->n;
  for (uint32_t a = 0; a < n; a++) w[a] = 0.0;
  if (!factor_wires(watched, model, s, root)) return false;
  precondition(model, s, in->r, in->z);
  memcpy(in->d, in->z, n * sizeof *in->d);
  double square = dot(n, in->r, in->z);
  const double enough = 1e-24 * square;
  for (uint32_t i = 0; i < 500 && square > enough; i++) {
    if (!tb_arena_go_on(watched)) return false;
    for (uint32_t a = 0; a < n; a++) in->turned[a] = root[a] * in->d[a];
    yield(model, s, in->turned, in->md);
    for (uint32_t a = 0; a < n; a++) in->md[a] = in->d[a] + root[a] * in->md[a];
    const double step = square / dot(n, in->d, in->md);
    for (uint32_t a = 0; a < n; a++) {
      w[a] += step * in->d[a];
      in->r[a] -= step * in->md[a];
    }
    precondition(model, s, in->r, in->z);
    const double next = dot(n, in->r, in->z);
    for (uint32_t a = 0; a < n; a++) in->d[a] = in->z[a] + next / square * in->d[a];
    square = next;
  }
  return true;
}

static bool newton_direction(TbArena *watched, const TaborModel *model, Statics *s,
                             const double *rho, const double *root, Inner *in, double *delta) {
  yield(model, s, rho, s->yielded);
  for (uint32_t a = 0; a < s->n; a++) in->r[a] = root[a] * s->yielded[a];
  if (!solve_direction(watched, model, s, root, in, delta)) return false;
  for (uint32_t a = 0; a < s->n; a++) delta[a] = rho[a] - root[a] * delta[a];
  return true;
}

/* Contact forces at rest into y, penetrations into eta. */
static TaborStatus balance(const TaborModel *model, TbArena *scratch, Statics *s, double *y,
                           double *eta) {
  const uint32_t n = s->n;
  Inner in = {.r = tb_arena_doubles(scratch, n),
              .z = tb_arena_doubles(scratch, n),
              .d = tb_arena_doubles(scratch, n),
              .md = tb_arena_doubles(scratch, n),
              .turned = tb_arena_doubles(scratch, n)};
  double *rho = tb_arena_doubles(scratch, n), *root = tb_arena_doubles(scratch, n);
  double *delta = tb_arena_doubles(scratch, n), *trial = tb_arena_doubles(scratch, n);
  if (scratch->failed) return TABOR_ERROR_MEMORY;
  double potential = total_potential(model, s, y, eta);
  for (int i = 0; i < 200; i++) {
    double scale = 1e-12;
    for (uint32_t a = 0; a < n; a++) scale = fmax(scale, fabs(y[a]));
    if (imbalance(model, s, y, eta, rho, root) <= 1e-13 * scale) return TABOR_OK;
    if (!newton_direction(scratch, model, s, rho, root, &in, delta))
      return scratch->failed ? TABOR_ERROR_MEMORY : TABOR_ERROR_NUMERICS;
    double step = 1.0, next = potential;
    for (; step > 1e-9; step *= 0.5) {
      for (uint32_t a = 0; a < n; a++) trial[a] = y[a] + step * delta[a];
      next = total_potential(model, s, trial, eta);
      if (next < potential) break;
    }
    if (!(next < potential)) { /* nothing left to gain: the rounding floor */
      total_potential(model, s, y, eta);
      return TABOR_OK;
    }
    for (uint32_t a = 0; a < n; a++) y[a] = trial[a];
    potential = next;
  }
  return TABOR_OK; /* a rest state off by rounding only shifts the datum: see model.h */
}

/* One wire's part of C and eta0. */
static TaborStatus wire_statics(const TaborModel *model, TbArena *scratch, Statics *s, uint32_t w) {
  const TbWire *wire = &model->wires.wires[w];
  const uint32_t n = wire->cells - 1, rows = wire->row_count;
  s->responses[w] = tb_arena_doubles(scratch, (size_t)(rows + 1) * n);
  s->wires[w] = tb_arena_doubles(scratch, (size_t)rows * rows);
  s->factors[w] = tb_arena_doubles(scratch, (size_t)rows * rows);
  if (scratch->failed) return TABOR_ERROR_MEMORY;
  if (!wire->still && !wire_responses(&model->wires, wire, scratch, s->responses[w])) {
    return scratch->failed ? TABOR_ERROR_MEMORY : TABOR_ERROR_NUMERICS;
  }
  for (uint32_t a = 0; a < rows; a++) {
    const uint32_t node = wire->row_node + a - 1, row = wire->first_row + a;
    s->eta0[row] -=
      s->responses[w][rows * n + node] + model->rest.offset[w] + model->wires.shape[row];
    for (uint32_t b = 0; b < rows; b++) s->wires[w][a * rows + b] = s->responses[w][b * n + node];
  }
  return TABOR_OK;
}

static void rest_head(TaborModel *model, const Statics *s, double *modal) {
  const TbModes *modes = &model->modes;
  TbRest *rest = &model->rest;
  tb_project_forces(&model->projection, model->kernels, rest->grid, modal);
  for (uint32_t i = 0; i < modes->padded; i++) {
    if (modes->row[i] == TB_NO_MODE) continue;
    const double contact = i < modes->group[modes->groups] ? model->wires.side * modal[i] : 0.0;
    rest->q[i] = (s->weight[i] - contact) / modes->stiffness[i];
    rest->head += model->center[i] * rest->q[i];
  }
}

static void rest_wires(TaborModel *model, double *const *responses) {
  TbRest *rest = &model->rest;
  const TbWires *wires = &model->wires;
  for (uint32_t w = 0; w < wires->count; w++) {
    const TbWire *wire = &wires->wires[w];
    const uint32_t n = wire->cells - 1;
    double *v = rest->v + wire->first_node, *bend = rest->bend + wire->first_node;
    for (uint32_t i = 0; i < n; i++) {
      v[i + 1] = responses[w][wire->row_count * n + i];
      for (uint32_t a = 0; a < wire->row_count; a++) {
        v[i + 1] += responses[w][a * n + i] * rest->force[wire->first_row + a];
      }
    }
    for (uint32_t i = 1; i <= n; i++) bend[i] = (v[i - 1] - v[i]) + (v[i + 1] - v[i]);
  }
}

static bool allocate(const TaborModel *model, TbArena *scratch, Statics *s) {
  const TbWireGrid *wire_grid = &model->projection.wire_grid;
  *s = (Statics){.n = model->wires.stride};
  s->eta0 = tb_arena_doubles(scratch, s->n);
  s->yielded = tb_arena_doubles(scratch, s->n);
  s->weight = tb_arena_doubles(scratch, model->modes.padded);
  s->grid = tb_arena_doubles(scratch, wire_grid->size);
  s->answer = tb_arena_doubles(scratch, wire_grid->size);
  s->fold = tb_arena_doubles(scratch, tb_wire_grid_scratch(wire_grid));
  return !scratch->failed;
}

/* The forces as the step will compute them in each precision, so that they cancel to the bit. */
static bool settle_in_double(TaborModel *model, TbArena *scratch) {
  const TbKernels *kernels = model->kernels;
  const TbWires *wires = &model->wires;
  TbRest *rest = &model->rest;
  double *zero = tb_arena_doubles(scratch, wires->stride);
  double *ignored = tb_arena_doubles(scratch, wires->stride);
  double *fold = tb_arena_doubles(scratch, tb_wire_grid_scratch(&model->projection.wire_grid));
  if (scratch->failed) return false;
  kernels->laws(wires->count, wires->lanes, wires->laws, rest->eta, NULL, zero, rest->force,
                ignored, ignored);
  kernels->rows_to_grid(&model->projection.wire_grid, rest->force, fold, rest->grid);
  return true;
}

static bool settle_in_float(TaborModel *model, TbArena *scratch) {
  const TbKernelsF *kernels = model->kernelsf;
  const uint32_t n = model->wires.stride;
  float *row[6], *grid = tb_arena_take(scratch, model->wire_gridf.size, sizeof *grid);
  float *fold = tb_arena_take(scratch, tb_wire_grid_scratchf(&model->wire_gridf), sizeof *fold);
  for (int i = 0; i < 6; i++) row[i] = tb_arena_take(scratch, n, sizeof *row[i]);
  if (scratch->failed) return false;
  kernels->narrow(n, model->rest.eta, row[0]);
  for (uint32_t i = 0; i < n; i++) row[5][i] = row[0][i] > 0.0f ? sqrtf(row[0][i]) : 0.0f;
  kernels->laws(model->wires.count, model->wires.lanes, model->wires.laws, row[0], row[5], row[1],
                row[2], row[3], row[4]);
  kernels->widen(n, row[2], model->rest.force);
  kernels->rows_to_grid(&model->wire_gridf, row[2], fold, grid);
  kernels->widen(model->wire_gridf.size, grid, model->rest.grid);
  return true;
}

static bool settle(TaborModel *model, TbArena *scratch) {
  static bool (*const SETTLE[])(TaborModel *, TbArena *) = {
    [TB_IN_DOUBLE] = settle_in_double, [TB_IN_FLOAT] = settle_in_float};
  for (uint32_t row = 0; row < model->wires.stride; row++) {
    if (model->wires.real[row] == 0.0) model->rest.eta[row] = TB_NOTHING;
  }
  return SETTLE[model->contacts](model, scratch);
}

TaborStatus tb_rest_prepare(TaborModel *model, TbArena *scratch) {
  const TbWires *wires = &model->wires;
  TbRest *rest = &model->rest;
  for (uint32_t w = 0; w < wires->count; w++) {
    rest->offset[w] =
      wires->wires[w].rest_offset + (1.0 - model->def.wires.strainer) * wires->strainer_travel;
  }
  Statics s;
  if (!allocate(model, scratch, &s)) return TABOR_ERROR_MEMORY;
  double *y = tb_arena_doubles(scratch, s.n);
  double *modal = tb_arena_doubles(scratch, model->modes.padded);
  if (scratch->failed) return TABOR_ERROR_MEMORY;

  weigh_head(model, s.weight);
  push_rod(model, s.weight);
  TaborStatus status = head_statics(model, scratch, &s);
  for (uint32_t w = 0; w < wires->count && status == TABOR_OK; w++) {
    status = wire_statics(model, scratch, &s, w);
  }
  if (status == TABOR_OK) status = balance(model, scratch, &s, y, rest->eta);
  if (status != TABOR_OK) return status;
  if (!settle(model, scratch)) return TABOR_ERROR_MEMORY;
  rest_head(model, &s, modal);
  rest_wires(model, s.responses);
  return TABOR_OK;
}
