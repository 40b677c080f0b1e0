/* SPDX-License-Identifier: MIT */
#include "acoustics/shell_radiation.h"

#include <math.h>

#include "acoustics/radiated_field.h"
#include "acoustics/wavenumber_quadrature.h"
#include "math/least_squares.h"
#include "math/portable_math.h"
#include "math/quadrature.h"

static const double PI = 3.14159265358979323846;

/* Wavenumbers that the cap's nodes resolve. */
static const double SMOOTH_TOP = 40.0;
static const TbAirPrecision PRECISION = {.digits = 4.5, .panel = 17.5};

/* Nodes on the cap, and orders. */
enum { CAP = 10, ORDERS = 16 };

/* ---- the shell --------------------------------------------------------------------------------- */

/* Points inside, as parts of radius and half depth: on no surface where many resonances vanish. */
enum { INNER = 5 };
static const TbCircle INSIDE[INNER] = {
  {0.32, 0.27}, {0.53, 0.61}, {0.71, 0.16}, {0.79, 0.47}, {0.88, 0.73}};

bool tb_shell_prepare(TbShell *shell, TbArena *arena, double depth, const TbAirPoint *points,
                      uint32_t point_count) {
  TbCircle rings[INNER + TABOR_MAX_MICS];
  const double half = 0.5 * depth;
  for (uint32_t p = 0; p < INNER; p++) rings[p] = (TbCircle){INSIDE[p].r, half * INSIDE[p].z};
  for (uint32_t p = 0; p < point_count; p++) {
    rings[INNER + p] = (TbCircle){points[p].radius, points[p].height + half};
  }
  shell->inner = INNER;
  shell->top = 6.0;
  const uint32_t side = 6 + (uint32_t)(half * shell->top / 2.0);
  return tb_shell_mesh_prepare(&shell->mesh, arena, half, CAP, side, ORDERS, rings,
                               INNER + point_count);
}

/* ---- baffled fields at the targets ------------------------------------------------------------- */

/* Fields of a head's baffled motion at the targets on and in the shell. */
typedef struct Baffled {
  const TbShell *shell;
  const TbAirOrder *air;
  const TbWavenumberNodes *nodes;
  uint32_t used;      /* nodes up to here are resolved */
  double *bessel;     /* [targets][nodes] J_m(kappa r) */
  double *near, *far; /* [targets][nodes](re, im): e^{-gamma |z - h|}, e^{-gamma (z + h)} */
} Baffled;

static uint32_t solved_targets(const TbShell *shell) { return shell->mesh.nodes + shell->inner; }

/* e^{-gamma height} at every node. */
static void decays(const Baffled *b, double height, double *out) {
  const TbWavenumberNodes *nodes = b->nodes;
  for (uint32_t q = 0; q < b->used; q++) {
    const double turn = nodes->root[q] * height;
    if (q < nodes->below) {
      double sine, cosine;
      tb_sin_cos(turn, &sine, &cosine);
      out[2 * q] = cosine;
      out[2 * q + 1] = -sine;
    } else {
      out[2 * q] = tb_exp(-turn);
      out[2 * q + 1] = 0.0;
    }
  }
}

static bool baffled_prepare(Baffled *b, TbArena *scratch) {
  const TbShellMesh *mesh = &b->shell->mesh;
  const uint32_t targets = solved_targets(b->shell), count = b->nodes->count;
  b->bessel = tb_arena_doubles(scratch, (size_t)targets * count);
  b->near = tb_arena_doubles(scratch, 2 * (size_t)targets * count);
  b->far = tb_arena_doubles(scratch, 2 * (size_t)targets * count);
  if (scratch->failed) return false;
  for (uint32_t t = 0; t < targets; t++) {
    tb_bessel_table_values(b->air->table, b->air->m, count, mesh->rings[t].r, b->nodes->kappa,
                           b->bessel + (size_t)t * count);
    decays(b, fabs(mesh->rings[t].z - mesh->half), b->near + 2 * (size_t)t * count);
    decays(b, mesh->rings[t].z + mesh->half, b->far + 2 * (size_t)t * count);
  }
  return true;
}

/* density[q]: the integrand of I without J_m(kappa r) e^{-gamma height}; below x times -i. */
static void densities(const Baffled *b, const double *w, double *density) {
  const TbWavenumberNodes *nodes = b->nodes;
  for (uint32_t q = 0; q < b->used; q++) {
    density[q] = nodes->weights[q] * w[q] * (q < nodes->below ? nodes->kappa[q] / nodes->x : 1.0);
  }
}

/* Adds I at one target, the sum over nodes of density, Bessel function and decay. */
static void add_field(const Baffled *b, const double *density, const double *bessel,
                      const double *decay, double sign, double field[2]) {
  double below_re = 0.0, below_im = 0.0, above = 0.0;
  for (uint32_t q = 0; q < b->nodes->below; q++) {
    below_re += density[q] * bessel[q] * decay[2 * q];
    below_im += density[q] * bessel[q] * decay[2 * q + 1];
  }
  for (uint32_t q = b->nodes->below; q < b->used; q++)
    above += density[q] * bessel[q] * decay[2 * q];
  field[0] += sign * (above + below_im);
  field[1] -= sign * below_re;
}

/* I_upper and, by symmetry, I_lower at every target; own: I_upper at the cap's nodes. */
static void fields_at_targets(const Baffled *b, const double *density, uint32_t odd, double *both,
                              double *own) {
  const uint32_t targets = solved_targets(b->shell), count = b->nodes->count;
  for (uint32_t t = 0; t < targets; t++) {
    const double *bessel = b->bessel + (size_t)t * count;
    double field[2] = {0.0, 0.0};
    add_field(b, density, bessel, b->near + 2 * (size_t)t * count, 1.0, field);
    if (t < b->shell->mesh.cap) {
      own[2 * t] = field[0];
      own[2 * t + 1] = field[1];
    }
    add_field(b, density, bessel, b->far + 2 * (size_t)t * count, odd ? -1.0 : 1.0, field);
    both[2 * t] = field[0];
    both[2 * t + 1] = field[1];
  }
}

/* ---- low frequency ----------------------------------------------------------------------------- */

/* Int (polynomial of node j) J_m(z_i r) r dr, r = g(t). */
static bool prepare_moments(TbShellOrder *order, TbArena *scratch) {
  enum { PANELS = 6, POINTS = PANELS * TB_PANEL };
  const TbShellMesh *mesh = &order->shell->mesh;
  const TbAirOrder *air = order->air;
  double t[POINTS], weights[POINTS], r[POINTS];
  double *basis = tb_arena_doubles(scratch, (size_t)POINTS * mesh->cap);
  double *j = tb_arena_doubles(scratch, POINTS);
  if (scratch->failed) return false;
  tb_quadrature(0.0, 1.0, PANELS, t, weights);
  for (uint32_t q = 0; q < POINTS; q++) {
    r[q] = tb_shell_grade(t[q]);
    weights[q] *= tb_shell_grade_slope(t[q]) * r[q];
    tb_shell_basis(mesh->parameters, mesh->cap, air->m % 2, t[q], basis + (size_t)q * mesh->cap);
  }
  for (uint32_t i = 0; i < air->count; i++) {
    double *row = order->moments + (size_t)i * mesh->cap;
    tb_bessel_table_values(air->table, air->m, POINTS, air->zeros[i], r, j);
    for (uint32_t q = 0; q < POINTS; q++) {
      const double *values = basis + (size_t)q * mesh->cap;
      for (uint32_t n = 0; n < mesh->cap; n++) row[n] += weights[q] * j[q] * values[n];
    }
  }
  return true;
}

/* I_c of every Bessel function: corrections[count][cap]. */
static bool still_corrections(const TbShellOrder *order, const Baffled *b, TbArena *scratch,
                              uint32_t odd, double *corrections) {
  const TbShellMesh *mesh = &order->shell->mesh;
  const uint32_t n = mesh->nodes, count = order->air->count;
  double *matrix = tb_arena_doubles(scratch, (size_t)n * n);
  double *sides = tb_arena_doubles(scratch, (size_t)count * n);
  double *solution = tb_arena_doubles(scratch, (size_t)count * n);
  double *both = tb_arena_doubles(scratch, 2 * (size_t)solved_targets(order->shell));
  double *own = tb_arena_doubles(scratch, 2 * (size_t)count * mesh->cap);
  double *w = tb_arena_doubles(scratch, b->nodes->count);
  if (scratch->failed) return false;
  for (uint32_t t = 0; t < n; t++) {
    const double *row = mesh->still + tb_shell_row(mesh, order->air->m, t, odd);
    for (uint32_t j = 0; j < n; j++) matrix[t * n + j] = (t == j ? 0.5 : 0.0) - row[j];
  }
  for (uint32_t i = 0; i < count; i++) {
    for (uint32_t q = 0; q < b->used; q++) {
      w[q] = tb_air_hankel(order->air->m, order->air->zeros[i], order->air->slopes[i],
                           b->nodes->kappa[q], b->nodes->j[q]);
    }
    densities(b, w, w);
    fields_at_targets(b, w, odd, both, own + 2 * (size_t)i * mesh->cap);
    for (uint32_t t = 0; t < n; t++) sides[i * n + t] = 0.5 * both[2 * t];
  }
  if (!tb_least_squares(scratch, n, n, matrix, count, sides, solution)) return false;
  for (uint32_t i = 0; i < count; i++) {
    for (uint32_t j = 0; j < mesh->cap; j++) {
      corrections[i * mesh->cap + j] = solution[i * n + j] - own[2 * (i * mesh->cap + j)];
    }
  }
  return true;
}

static bool prepare_still(TbShellOrder *order, TbArena *scratch) {
  const TbShellMesh *mesh = &order->shell->mesh;
  const uint32_t count = order->air->count;
  TbWavenumberNodes nodes;
  const TbAirTurns turns = {.high = 2.0, .top = SMOOTH_TOP, .panel = PRECISION.panel};
  if (!tb_wavenumber_nodes_prepare(&nodes, scratch, order->air, 0.0, turns)) return false;
  Baffled b = {.shell = order->shell, .air = order->air, .nodes = &nodes, .used = nodes.count};
  double *corrections = tb_arena_doubles(scratch, (size_t)count * mesh->cap);
  if (scratch->failed || !baffled_prepare(&b, scratch)) return false;
  for (uint32_t odd = 0; odd < 2; odd++) {
    if (!still_corrections(order, &b, scratch, odd, corrections)) return false;
    for (uint32_t i = 0; i < count; i++) {
      for (uint32_t k = 0; k < count; k++) {
        double sum = 0.0;
        for (uint32_t j = 0; j < mesh->cap; j++) {
          sum += corrections[i * mesh->cap + j] * order->moments[k * mesh->cap + j];
        }
        order->still[odd][i * count + k] += 0.5 * sum;
        order->still[odd][k * count + i] += 0.5 * sum;
      }
    }
  }
  return true;
}

bool tb_shell_order_prepare(TbShellOrder *order, TbArena *arena, const TbShell *shell,
                            const TbAirOrder *air) {
  const size_t count = air->count;
  *order = (TbShellOrder){.shell = shell, .air = air};
  order->moments = tb_arena_doubles(arena, count * shell->mesh.cap);
  order->baffled = tb_arena_doubles(arena, count * count);
  for (int odd = 0; odd < 2; odd++) order->still[odd] = tb_arena_doubles(arena, count * count);
  if (arena->failed) return false;
  TbArena scratch;
  tb_arena_prepare(&scratch, &arena->allocator);
  const bool done = tb_air_mass_baffled(air, &scratch, order->baffled) &&
                    prepare_moments(order, &scratch) && prepare_still(order, &scratch);
  tb_arena_release(&scratch);
  return done;
}

void tb_shell_order_mass(const TbShellOrder *order, double *own, double *mutual) {
  const uint32_t size = order->air->count * order->air->count;
  for (uint32_t i = 0; i < size; i++) {
    const double even = order->still[0][i], odd = order->still[1][i];
    own[i] = order->baffled[i] + 0.5 * (even + odd);
    mutual[i] = 0.5 * (even - odd);
  }
}

/* ---- one motion at its frequency --------------------------------------------------------------- */

/* Sums over the angle for one target and a ring of the surface: f(x D) and f(x D) cos t, with cos(m t). */
typedef struct RestSums {
  double f[2], g[2];
} RestSums;

/* The angles' sums for all targets: sums[target][image][node]. Between nodes they are symmetric. */
static void rest_sums(const TbShellMesh *mesh, uint32_t m, double x, RestSums *sums) {
  const double *cosines = mesh->cosines + (size_t)m * TB_SHELL_ANGLES;
  const uint32_t n = mesh->nodes;
  for (uint32_t t = 0; t < mesh->targets; t++) {
    for (uint32_t row = 0; row < 2 * n; row++) {
      RestSums *sum = sums + (size_t)t * 2 * n + row;
      const uint32_t image = row / n, j = row % n;
      if (t < n && j < t) {
        *sum = sums[((size_t)j * 2 + image) * n + t];
        continue;
      }
      const double *d = mesh->distances + ((size_t)t * 2 * n + row) * TB_SHELL_ANGLES;
      *sum = (RestSums){{0.0, 0.0}, {0.0, 0.0}};
      for (uint32_t l = 0; l < TB_SHELL_ANGLES; l++) {
        double re, im;
        tb_ring_rest(x * d[l], &re, &im);
        re *= cosines[l];
        im *= cosines[l];
        sum->f[0] += re;
        sum->f[1] += im;
        sum->g[0] += re * mesh->cosine[l];
        sum->g[1] += im * mesh->cosine[l];
      }
    }
  }
}

/* n'.d/(4 pi) integrated with the rest over a ring: of a node or of its mirror image. */
static void rest_of(const TbShellMesh *mesh, uint32_t target, uint32_t j, uint32_t image,
                    const RestSums *sum, double rest[2]) {
  const TbCircle s = mesh->rings[target], ring = mesh->rings[j];
  for (int part = 0; part < 2; part++) {
    if (j < mesh->cap) { /* normals up on the upper cap, down on the lower */
      rest[part] = (image ? s.z + ring.z : ring.z - s.z) * sum->f[part];
    } else {
      rest[part] = ring.r * sum->f[part] - s.r * sum->g[part];
    }
    rest[part] *= -ring.r * mesh->weights[j] / (4.0 * PI);
  }
}

/* The double layer's row of one target at x, (re, im) pairs. */
static void double_layer(const TbShellMesh *mesh, uint32_t m, uint32_t target, uint32_t odd,
                         double x, const RestSums *sums, double *row) {
  const size_t first = tb_shell_row(mesh, m, target, odd);
  const double cube = x * x * x;
  for (uint32_t j = 0; j < mesh->nodes; j++) {
    double own[2], image[2];
    rest_of(mesh, target, j, 0, sums + ((size_t)target * 2) * mesh->nodes + j, own);
    rest_of(mesh, target, j, 1, sums + ((size_t)target * 2 + 1) * mesh->nodes + j, image);
    const double sign = odd ? -1.0 : 1.0;
    row[2 * j] =
      mesh->still[first + j] + x * x * mesh->slow[first + j] + cube * (own[0] + sign * image[0]);
    row[2 * j + 1] = cube * (own[1] + sign * image[1]);
  }
}

/* The complex equations of all targets as real ones for (re, im) of I at the nodes. */
static void equations(const TbShell *shell, uint32_t m, uint32_t odd, double x,
                      const RestSums *sums, double *matrix) {
  const TbShellMesh *mesh = &shell->mesh;
  const uint32_t n = mesh->nodes;
  double row[2 * TB_SHELL_NODES];
  for (uint32_t t = 0; t < solved_targets(shell); t++) {
    double *re = matrix + (size_t)(2 * t) * 2 * n, *im = re + 2 * n;
    double_layer(mesh, m, t, odd, x, sums, row);
    for (uint32_t j = 0; j < n; j++) {
      re[2 * j] = im[2 * j + 1] = (t == j ? 0.5 : 0.0) - row[2 * j];
      re[2 * j + 1] = row[2 * j + 1];
      im[2 * j] = -row[2 * j + 1];
    }
  }
}

/* A motion of both heads at x, in its two symmetries. */
typedef struct Motion {
  const TbShellOrder *order;
  double x;
  const Baffled *baffled;
  RestSums *sums;
  double *v[2]; /* even, odd: amplitudes of the upper head */
  double *w[2]; /* their transforms */
} Motion;

/* The motion's parts of one symmetry, and its load: Re Int (p(x) - p(0)) J_m(z_i r) r dr for every
 * Bessel function of the upper head, and r. */
typedef struct SymmetryLoad {
  double *inertia, resistance;
} SymmetryLoad;

/* What I_c adds, from I and I_own at the cap's nodes. */
static void add_correction(const Motion *motion, uint32_t odd, const double *solution,
                           const double *own, SymmetryLoad *load) {
  const TbShellOrder *order = motion->order;
  const uint32_t cap = order->shell->mesh.cap, count = order->air->count;
  const double *v = motion->v[odd];
  for (uint32_t i = 0; i < count; i++) {
    const double *moments = order->moments + (size_t)i * cap;
    const double *still = order->still[odd] + (size_t)i * count;
    double re = 0.0, im = 0.0;
    for (uint32_t j = 0; j < cap; j++) {
      re += moments[j] * (solution[2 * j] - own[2 * j]);
      im += moments[j] * (solution[2 * j + 1] - own[2 * j + 1]);
    }
    for (uint32_t k = 0; k < count; k++) re -= still[k] * v[k];
    load->inertia[i] += re;
    load->resistance -= motion->x * v[i] * im;
  }
}

/* What the head's own baffled field adds. The inertia is Int W_i W g dkappa, where
 * g = kappa/sqrt(kappa^2 - x^2) - 1 above x and -1 below. */
static void add_own(const Motion *motion, uint32_t odd, SymmetryLoad *load) {
  const TbWavenumberNodes *nodes = motion->baffled->nodes;
  const TbAirOrder *air = motion->order->air;
  const double *w = motion->w[odd];
  for (uint32_t q = 0; q < nodes->below; q++) {
    load->resistance += nodes->weights[q] * nodes->kappa[q] * w[q] * w[q];
  }
  for (uint32_t q = 0; q < motion->baffled->used; q++) {
    const double kappa = nodes->kappa[q], root = nodes->root[q];
    const double g = q < nodes->below ? -root / nodes->x : 1.0 - root / kappa;
    const double size = nodes->weights[q] * w[q] * g;
    for (uint32_t i = 0; i < air->count; i++) {
      load->inertia[i] +=
        size * tb_air_hankel(air->m, air->zeros[i], air->slopes[i], kappa, nodes->j[q]);
    }
  }
}

static void add_points(const Motion *motion, uint32_t odd, const double *solution,
                       uint32_t point_count, double *fields) {
  const TbShell *shell = motion->order->shell;
  double row[2 * TB_SHELL_NODES];
  for (uint32_t p = 0; p < point_count; p++) {
    const uint32_t target = solved_targets(shell) + p;
    double_layer(&shell->mesh, motion->order->air->m, target, odd, motion->x, motion->sums, row);
    for (uint32_t j = 0; j < shell->mesh.nodes; j++) {
      const double *i = solution + 2 * j, *d = row + 2 * j;
      fields[2 * p] += d[0] * i[0] - d[1] * i[1];
      fields[2 * p + 1] += d[0] * i[1] + d[1] * i[0];
    }
  }
}

/* Solves for one symmetry; adds to the points' fields. */
static bool solve_symmetry(const Motion *motion, TbArena *scratch, uint32_t odd, SymmetryLoad *load,
                           uint32_t point_count, double *fields) {
  const TbShellOrder *order = motion->order;
  const TbShell *shell = order->shell;
  const uint32_t n = shell->mesh.nodes, targets = solved_targets(shell);
  double *matrix = tb_arena_doubles(scratch, 4 * (size_t)targets * n);
  double *both = tb_arena_doubles(scratch, 2 * (size_t)targets);
  double *own = tb_arena_doubles(scratch, 2 * (size_t)shell->mesh.cap);
  double *density = tb_arena_doubles(scratch, motion->baffled->nodes->count);
  double *solution = tb_arena_doubles(scratch, 2 * (size_t)n);
  *load = (SymmetryLoad){.inertia = tb_arena_doubles(scratch, order->air->count)};
  if (scratch->failed) return false;
  densities(motion->baffled, motion->w[odd], density);
  fields_at_targets(motion->baffled, density, odd, both, own);
  for (uint32_t i = 0; i < 2 * targets; i++) both[i] *= 0.5;
  equations(shell, order->air->m, odd, motion->x, motion->sums, matrix);
  if (!tb_least_squares(scratch, 2 * targets, 2 * n, matrix, 1, both, solution)) return false;
  add_own(motion, odd, load);
  add_correction(motion, odd, solution, own, load);
  add_points(motion, odd, solution, point_count, fields);
  return true;
}

static bool split_motion(Motion *motion, TbArena *scratch, const double *upper,
                         const double *lower) {
  const uint32_t count = motion->order->air->count;
  for (uint32_t odd = 0; odd < 2; odd++) {
    motion->v[odd] = tb_arena_doubles(scratch, count);
    motion->w[odd] = tb_arena_doubles(scratch, motion->baffled->nodes->count);
    if (scratch->failed) return false;
    for (uint32_t i = 0; i < count; i++) {
      const double other = lower ? lower[i] : 0.0;
      motion->v[odd][i] = 0.5 * (upper[i] + (odd ? -other : other));
    }
    tb_air_transform(motion->order->air, motion->baffled->nodes, motion->v[odd], motion->w[odd]);
  }
  return true;
}

static uint32_t resolved(const TbWavenumberNodes *nodes) {
  uint32_t count = nodes->count;
  while (count > nodes->below && nodes->root[count - 1] > SMOOTH_TOP) count--;
  return count;
}

bool tb_shell_load(const TbShellOrder *order, TbArena *scratch, const double *upper,
                   const double *lower, double x, const TbAirPoint *points, uint32_t point_count,
                   TbShellLoad *load, double *fields) {
  const TbShell *shell = order->shell;
  const TbShellMesh *mesh = &shell->mesh;
  TbAirPlan plan = {.order = order->air,
                    .points = points,
                    .point_count = point_count,
                    .x = x,
                    .precision = PRECISION};
  TbAirSource sources[2] = {{.v = upper, .up = 1.0, .baffled = 0.5},
                            {.v = lower, .plane = -2.0 * mesh->half, .up = -1.0, .baffled = 0.5}};
  const uint32_t heads = lower ? 2 : 1;
  plan.zero = order->air->zeros[order->air->count - 1];
  tb_air_plan_fields(&plan, sources, heads);
  const TbAirTurns turns = {.low = fmax(tb_air_plan_turns(&plan), x * (2.0 + 2.0 * mesh->half)),
                            .high = fmax(2.0, plan.stretch),
                            .top = fmax(SMOOTH_TOP, plan.top),
                            .panel = PRECISION.panel};
  TbWavenumberNodes nodes;
  if (!tb_wavenumber_nodes_prepare(&nodes, scratch, order->air, x, turns)) return false;
  Baffled b = {.shell = shell, .air = order->air, .nodes = &nodes, .used = resolved(&nodes)};
  Motion motion = {.order = order, .x = x, .baffled = &b};
  motion.sums = tb_arena_take(scratch, (size_t)mesh->targets * 2 * mesh->nodes, sizeof(RestSums));
  if (scratch->failed || !baffled_prepare(&b, scratch) ||
      !split_motion(&motion, scratch, upper, lower)) {
    return false;
  }
  for (uint32_t h = 0; h < heads; h++) {
    sources[h].w = tb_arena_doubles(scratch, nodes.count);
    if (scratch->failed) return false;
    for (uint32_t q = 0; q < nodes.count; q++) {
      sources[h].w[q] = motion.w[0][q] + (h ? -motion.w[1][q] : motion.w[1][q]);
    }
  }
  if (point_count && !tb_air_fields(&plan, scratch, &nodes, sources, heads, fields)) return false;
  rest_sums(mesh, order->air->m, x, motion.sums);
  SymmetryLoad even, odd;
  if (!solve_symmetry(&motion, scratch, 0, &even, point_count, fields) ||
      !solve_symmetry(&motion, scratch, 1, &odd, point_count, fields)) {
    return false;
  }
  for (uint32_t i = 0; i < order->air->count; i++) {
    load->inertia[i] = even.inertia[i] + odd.inertia[i];
    if (lower) load->inertia[order->air->count + i] = even.inertia[i] - odd.inertia[i];
  }
  load->resistance = 2.0 * (even.resistance + odd.resistance);
  return true;
}
