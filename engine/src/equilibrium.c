/* SPDX-License-Identifier: MIT */
/* The static equilibrium of head and wires under gravity, strainer and contact.
 *
 * With y the contact forces, eta = eta0 - C y, C the static compliance of head and wires at the contact
 * points and eta0 the penetration without contact. The potential y^T C y/2 + Sum V(eta0 - C y) is
 * convex; Newton's step on it solves (I + D C) delta = f(eta) - y, D = V'', which is
 * delta = rho - D^(1/2) w, (I + D^(1/2) C D^(1/2)) w = D^(1/2) C rho, rho = f - y. */
#include <math.h>

#include "bessel.h"
#include "linear.h"
#include "model.h"

static const double PI = 3.14159265358979323846;

typedef struct Statics {
  uint32_t n;         /* contact points */
  double *compliance; /* C, [n][n] */
  double *eta0;       /* [n] */
  double *weight;     /* [padded]: gravity on each mode [N] */
} Statics;

/* Weight of the heads on each mode: -Sum rho g Int phi dA, which only m = 0 has. */
static void weigh_head(const TaborModel *model, double *weight) {
  const TbHeadOrder *order = &model->head.orders[0];
  const double radius = model->head.radius;
  const TaborHeadDef *const heads[TB_HEADS] = {&model->def.batter, &model->def.resonant};
  for (uint32_t i = 0; i < model->modes.padded; i++) {
    if (model->modes.row[i] == TB_NO_MODE) continue;
    const TbHeadMode *mode = &model->head.modes[model->modes.row[i]];
    if (mode->m != 0) continue;
    for (uint32_t h = 0; h < model->head.heads; h++) {
      const double load = -heads[h]->surface_density * model->def.air.gravity;
      const double *v = order->vectors[h] + (size_t)mode->place * order->zero_count;
      double area = 0.0;
      for (uint32_t z = 0; z < order->zero_count; z++) {
        area += v[z] * tb_bessel_j(1, order->zeros[z]) / order->zeros[z];
      }
      weight[i] += load * 2.0 * PI * radius * radius * area;
    }
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

/* Displacement of every contact point under modal forces F: phi F/K'. `modal` is used up. */
static void head_response(const TaborModel *model, double *modal, double *fold, double *rows) {
  for (uint32_t i = 0; i < model->modes.group[model->modes.groups]; i++) {
    modal[i] = model->modes.row[i] == TB_NO_MODE ? 0.0 : modal[i] / model->modes.stiffness[i];
  }
  tb_project(&model->projection, model->kernels, modal, fold, rows);
}

/* The head's part of C and, under its own weight, of eta0. */
static bool head_statics(const TaborModel *model, TbArena *scratch, Statics *s) {
  double *force = tb_arena_doubles(scratch, model->wires.stride);
  double *rows = tb_arena_doubles(scratch, model->wires.stride);
  double *modal = tb_arena_doubles(scratch, model->modes.padded);
  double *fold = tb_arena_doubles(scratch, tb_projection_scratch(&model->projection));
  if (scratch->failed) return false;
  for (uint32_t i = 0; i < model->modes.padded; i++) modal[i] = s->weight[i];
  head_response(model, modal, fold, rows);
  for (uint32_t a = 0; a < s->n; a++) s->eta0[a] = model->wires.side * rows[a];
  for (uint32_t a = 0; a < s->n; a++) {
    force[a] = 1.0;
    tb_project_forces(&model->projection, model->kernels, force, fold, modal);
    force[a] = 0.0;
    head_response(model, modal, fold, rows);
    for (uint32_t b = 0; b < s->n; b++) s->compliance[a * s->n + b] = rows[b];
  }
  return true;
}

static double total_potential(const TaborModel *model, const Statics *s, const double *y,
                              double *eta) {
  double sum = 0.0;
  for (uint32_t a = 0; a < s->n; a++) {
    double yielded = 0.0;
    for (uint32_t b = 0; b < s->n; b++) yielded += s->compliance[a * s->n + b] * y[b];
    eta[a] = s->eta0[a] - yielded;
    sum +=
      0.5 * y[a] * yielded + tb_law_potential(&model->wires.laws[model->wires.row_wire[a]], eta[a]);
  }
  return sum;
}

/* rho = f(eta) - y and D^(1/2); returns the largest |rho|. */
static double imbalance(const TaborModel *model, const Statics *s, const double *y,
                        const double *eta, double *rho, double *root) {
  double largest = 0.0;
  for (uint32_t a = 0; a < s->n; a++) {
    const TbLaw *law = &model->wires.laws[model->wires.row_wire[a]];
    rho[a] = tb_law_static_force(law, eta[a]) - y[a];
    root[a] = sqrt(tb_law_curvature(law, eta[a]));
    largest = fmax(largest, fabs(rho[a]));
  }
  return largest;
}

static bool newton_direction(const Statics *s, const double *rho, const double *root,
                             double *matrix, double *delta) {
  const uint32_t n = s->n;
  for (uint32_t a = 0; a < n; a++) {
    double sum = 0.0;
    for (uint32_t b = 0; b < n; b++) {
      const double c = s->compliance[a * n + b];
      sum += c * rho[b];
      matrix[a * n + b] = root[a] * c * root[b] + (a == b ? 1.0 : 0.0);
    }
    delta[a] = root[a] * sum;
  }
  if (!tb_solve_positive(n, matrix, 1, delta)) return false;
  for (uint32_t a = 0; a < n; a++) delta[a] = rho[a] - root[a] * delta[a];
  return true;
}

/* Contact forces at rest into y, penetrations into eta. */
static TaborStatus balance(const TaborModel *model, TbArena *scratch, const Statics *s, double *y,
                           double *eta) {
  const uint32_t n = s->n;
  double *rho = tb_arena_doubles(scratch, n), *root = tb_arena_doubles(scratch, n);
  double *delta = tb_arena_doubles(scratch, n), *trial = tb_arena_doubles(scratch, n);
  double *matrix = tb_arena_doubles(scratch, (size_t)n * n);
  if (scratch->failed) return TABOR_ERROR_MEMORY;
  double potential = total_potential(model, s, y, eta);
  for (int i = 0; i < 200; i++) {
    double scale = 1e-12;
    for (uint32_t a = 0; a < n; a++) scale = fmax(scale, fabs(y[a]));
    if (imbalance(model, s, y, eta, rho, root) <= 1e-13 * scale) return TABOR_OK;
    if (!newton_direction(s, rho, root, matrix, delta)) return TABOR_ERROR_NUMERICS;
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

/* Wires one after the other: their part of C and eta0, and afterwards their shape at rest. */
static TaborStatus wires_statics(const TaborModel *model, TbArena *scratch, Statics *s,
                                 double **responses) {
  for (uint32_t w = 0; w < model->wires.count; w++) {
    const TbWire *wire = &model->wires.wires[w];
    const uint32_t n = wire->cells - 1;
    responses[w] = tb_arena_doubles(scratch, (size_t)(wire->row_count + 1) * n);
    if (!responses[w]) return TABOR_ERROR_MEMORY;
    if (!wire_responses(&model->wires, wire, scratch, responses[w])) {
      return scratch->failed ? TABOR_ERROR_MEMORY : TABOR_ERROR_NUMERICS;
    }
    for (uint32_t a = 0; a < wire->row_count; a++) {
      const uint32_t row = wire->first_row + a, node = wire->row_node + a - 1;
      s->eta0[row] -= responses[w][wire->row_count * n + node] + model->rest.offset[w];
      for (uint32_t b = 0; b < wire->row_count; b++) {
        s->compliance[row * s->n + wire->first_row + b] += responses[w][b * n + node];
      }
    }
  }
  return TABOR_OK;
}

static void rest_head(TaborModel *model, const Statics *s, double *modal, double *fold) {
  const TbModes *modes = &model->modes;
  TbRest *rest = &model->rest;
  tb_project_forces(&model->projection, model->kernels, rest->force, fold, modal);
  for (uint32_t i = 0; i < modes->padded; i++) {
    if (modes->row[i] == TB_NO_MODE) continue;
    const double contact = i < modes->group[modes->groups] ? model->wires.side * modal[i] : 0.0;
    rest->q[i] = (s->weight[i] - contact) / modes->stiffness[i];
    rest->head += model->center[i] * rest->q[i];
  }
}

static void rest_wires(TaborModel *model, double **responses) {
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

TaborStatus tb_rest_prepare(TaborModel *model, TbArena *scratch) {
  const TbWires *wires = &model->wires;
  TbRest *rest = &model->rest;
  for (uint32_t w = 0; w < wires->count; w++) {
    rest->offset[w] =
      wires->wires[w].rest_offset + (1.0 - model->def.wires.strainer) * wires->strainer_travel;
  }
  Statics s = {.n = wires->row_count};
  s.compliance = tb_arena_doubles(scratch, (size_t)s.n * s.n);
  s.eta0 = tb_arena_doubles(scratch, s.n);
  s.weight = tb_arena_doubles(scratch, model->modes.padded);
  double **responses = tb_arena_take(scratch, wires->count, sizeof *responses);
  double *y = tb_arena_doubles(scratch, s.n);
  double *modal = tb_arena_doubles(scratch, model->modes.padded);
  double *fold = tb_arena_doubles(scratch, tb_projection_scratch(&model->projection));
  if (scratch->failed) return TABOR_ERROR_MEMORY;

  weigh_head(model, s.weight);
  if (!head_statics(model, scratch, &s)) return TABOR_ERROR_MEMORY;
  TaborStatus status = wires_statics(model, scratch, &s, responses);
  if (status == TABOR_OK) status = balance(model, scratch, &s, y, rest->eta);
  if (status != TABOR_OK) return status;
  /* The force as the step will compute it, so that it cancels to the bit. */
  for (uint32_t a = 0; a < s.n; a++) {
    rest->force[a] = tb_law_force(&wires->laws[wires->row_wire[a]], rest->eta[a], 0.0).force;
  }
  rest_head(model, &s, modal, fold);
  rest_wires(model, responses);
  return TABOR_OK;
}
