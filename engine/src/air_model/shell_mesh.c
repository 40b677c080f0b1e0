/* SPDX-License-Identifier: MIT */
#include "air_model/shell_mesh.h"

#include <math.h>
#include <string.h>

#include "math/combine.h"
#include "math/portable_math.h"
#include "math/quadrature.h"

static const double PI = 3.14159265358979323846;

/* A panel is as long as the distance to the target times this at most; nearer than this to the axis
 * a point counts as that far off. */
static const double LONGEST_PANEL = 3.0, LEAST_RADIUS = 1e-4;
enum { MOST_SPLITS = 7 };

double tb_shell_grade(double t) {
  const double s = t * t;
  return t * (15.0 + s * (3.0 * s - 10.0)) / 8.0;
}

double tb_shell_grade_slope(double t) {
  const double fall = 1.0 - t * t;
  return 1.875 * fall * fall;
}

/* t with g(t) = value, 0 <= value <= 1. */
static double grade_inverse(double value) {
  double lo = 0.0, hi = 1.0;
  for (int i = 0; i < 50; i++) {
    const double middle = 0.5 * (lo + hi);
    if (tb_shell_grade(middle) < value) {
      lo = middle;
    } else {
      hi = middle;
    }
  }
  return 0.5 * (lo + hi);
}

void tb_shell_basis(const double *parameters, uint32_t count, bool odd, double t, double *basis) {
  for (uint32_t j = 0; j < count; j++) {
    const double own = parameters[j];
    double above = odd ? t : 1.0, below = odd ? own : 1.0; /* even: a polynomial in t^2 */
    for (uint32_t k = 0; k < count; k++) {
      if (k == j) continue;
      const double other = parameters[k];
      above *= (t - other) * (t + other);
      below *= (own - other) * (own + other);
    }
    basis[j] = above / below;
  }
}

/* ---- one part of the surface as seen from a target ------------------------------------------- */

/* The upper cap or the upper half of the side, or its mirror image. */
typedef struct Part {
  const TbShellMesh *mesh;
  bool side, mirrored;
  TbCircle target;
} Part;

static TbCircle circle_at(const Part *part, double t) {
  const double along = tb_shell_grade(t), half = part->mesh->half;
  const TbCircle ring =
    part->side ? (TbCircle){1.0, half * along} : (TbCircle){fmax(along, LEAST_RADIUS), half};
  return part->mirrored ? (TbCircle){ring.r, -ring.z} : ring;
}

static double distance(TbCircle a, TbCircle b) { return tb_hypot(a.r - b.r, a.z - b.z); }

/* The parameter of the point that is nearest to the target. */
static double nearest_parameter(const Part *part) {
  const double height = part->mirrored ? -part->target.z : part->target.z;
  const double along = part->side ? height / part->mesh->half : part->target.r;
  if (along <= 0.0) return 0.0;
  return along >= 1.0 ? 1.0 : grade_inverse(along);
}

/* The contribution of a part to a target: [orders][2: even, odd basis][nodes of the part]. */
typedef TbRingTerms Terms;

static void add_terms(Terms *sum, const Terms *term, double single, double dipole) {
  sum->single += single * term->single;
  sum->single_slow += single * term->single_slow;
  sum->dipole += dipole * term->dipole;
  sum->dipole_slow += dipole * term->dipole_slow;
}

static uint32_t nodes_of(const Part *part) {
  return part->side ? part->mesh->side : part->mesh->cap;
}

static uint32_t first_node(const Part *part) { return part->side ? part->mesh->cap : 0; }

/* The lower cap's normal points down. */
static double normal_sign(bool side, bool mirrored) { return mirrored && !side ? -1.0 : 1.0; }

static void add_point(const Part *part, Terms *rows, double t, double weight) {
  const TbShellMesh *mesh = part->mesh;
  const uint32_t count = nodes_of(part), orders = mesh->orders;
  double basis[2][TB_SHELL_NODES];
  Terms terms[TB_RING_ORDERS];
  const double *parameters = mesh->parameters + first_node(part);
  tb_shell_basis(parameters, count, false, t, basis[0]);
  for (uint32_t j = 0; j < count; j++) basis[1][j] = basis[0][j] * t / parameters[j];
  tb_ring_terms(part->target, circle_at(part, t), part->side, orders, terms);
  const double length = weight * tb_shell_grade_slope(t) * (part->side ? mesh->half : 1.0);
  const double normal = normal_sign(part->side, part->mirrored);
  for (uint32_t m = 0; m < orders; m++) {
    for (uint32_t odd = 0; odd < 2; odd++) {
      if (!part->side && odd != m % 2) continue; /* on the cap t goes with r */
      Terms *row = rows + (size_t)(2 * m + odd) * count;
      for (uint32_t j = 0; j < count; j++) {
        const double size = length * basis[odd][j];
        add_terms(&row[j], &terms[m], size, normal * size);
      }
    }
  }
}

static void add_panel(const Part *part, Terms *rows, double from, double to) {
  double t[TB_PANEL], weights[TB_PANEL];
  tb_quadrature(fmin(from, to), fmax(from, to), 1, t, weights);
  for (uint32_t q = 0; q < TB_PANEL; q++) add_point(part, rows, t[q], weights[q]);
}

/* Integrates from `near`, which is the nearest point to the target, to `far`. */
static void add_towards(const Part *part, Terms *rows, double near, double far) {
  if (near == far) return;
  const TbCircle nearest = circle_at(part, near);
  const double gap = distance(part->target, nearest);
  for (int split = 0; split < MOST_SPLITS; split++) {
    if (distance(nearest, circle_at(part, far)) <= LONGEST_PANEL * gap) break;
    const double middle = near + 0.25 * (far - near);
    add_panel(part, rows, middle, far);
    far = middle;
  }
  add_panel(part, rows, near, far);
}

static void add_part(const Part *part, Terms *rows) {
  const double near = nearest_parameter(part);
  add_towards(part, rows, near, 0.0);
  add_towards(part, rows, near, 1.0);
}

/* ---- the singular terms of one target -------------------------------------------------------- */

static Terms *terms_of(const TbShellMesh *mesh, uint32_t m, uint32_t target, uint32_t odd) {
  return mesh->terms + (((size_t)m * mesh->targets + target) * 2 + odd) * mesh->nodes;
}

/* Adds what a part gives to the rows of both symmetries; a mirror image is the same or the
 * negative. */
static void gather(const Part *part, const Terms *rows, uint32_t target) {
  const TbShellMesh *mesh = part->mesh;
  const uint32_t count = nodes_of(part);
  for (uint32_t m = 0; m < mesh->orders; m++) {
    for (uint32_t odd = 0; odd < 2; odd++) {
      const double sign = part->mirrored && odd ? -1.0 : 1.0;
      const Terms *from = rows + (size_t)(2 * m + (part->side ? odd : m % 2)) * count;
      Terms *to = terms_of(mesh, m, target, odd) + first_node(part);
      for (uint32_t j = 0; j < count; j++) add_terms(&to[j], &from[j], sign, sign);
    }
  }
}

static bool add_target(const TbShellMesh *mesh, TbArena *scratch, uint32_t target) {
  const uint32_t most = mesh->cap > mesh->side ? mesh->cap : mesh->side;
  const size_t size = (size_t)mesh->orders * 2 * most;
  Terms *rows = tb_arena_take(scratch, size, sizeof *rows);
  if (!rows) return false;
  for (int which = 0; which < 4; which++) {
    const Part part = {mesh, which % 2, which / 2, mesh->circles[target]};
    for (size_t i = 0; i < size; i++) rows[i] = (Terms){0.0, 0.0, 0.0, 0.0};
    add_part(&part, rows);
    gather(&part, rows, target);
  }
  return true;
}

/* ---- the smooth rest ------------------------------------------------------------------------- */

/* Sums over the angles between a target and a circle of the surface: s, f and f cos t, with cos(m
 * t). */
typedef struct Sums {
  double single[2], dipole[2], turned[2];
} Sums;

/* s and f at every angle. */
static void angle_values(const TbShellMesh *mesh, TbCircle a, TbCircle b, double x,
                         TbRingRests *values) {
  double arguments[TB_SHELL_ANGLES];
  const double height = a.z - b.z;
  const double squares = a.r * a.r + b.r * b.r + height * height;
  for (uint32_t l = 0; l < TB_SHELL_ANGLES; l++) {
    const double square = squares - 2.0 * a.r * b.r * mesh->cosine[l];
    arguments[l] = x * sqrt(square > 0.0 ? square : 0.0);
  }
  tb_ring_rests(TB_SHELL_ANGLES, arguments, values);
}

static Sums angle_sums(const TbShellMesh *mesh, const TbRingRests *values, uint32_t m) {
  const double *cosines = mesh->cosines + (size_t)m * TB_SHELL_ANGLES;
  Sums sums = {{0.0, 0.0}, {0.0, 0.0}, {0.0, 0.0}};
  for (uint32_t l = 0; l < TB_SHELL_ANGLES; l++) {
    const double turned = cosines[l] * mesh->cosine[l];
    sums.single[0] += cosines[l] * values->single_re[l];
    sums.single[1] += cosines[l] * values->single_im[l];
    sums.dipole[0] += cosines[l] * values->dipole_re[l];
    sums.dipole[1] += cosines[l] * values->dipole_im[l];
    sums.turned[0] += turned * values->dipole_re[l];
    sums.turned[1] += turned * values->dipole_im[l];
  }
  return sums;
}

static TbCircle circle_of(const TbShellMesh *mesh, uint32_t node, uint32_t mirrored) {
  const TbCircle circle = mesh->circles[node];
  return mirrored ? (TbCircle){circle.r, -circle.z} : circle;
}

/* Adds the rest of both layers on a node, or its mirror image, to a target's rows: of the single
 * layer divided by x, of the double layer by x^3. */
static void add_rest(const TbShellMesh *mesh, uint32_t target, uint32_t node, uint32_t mirrored,
                     const Sums *sums, TbShellRow *even, TbShellRow *odd) {
  const TbCircle s = mesh->circles[target], circle = circle_of(mesh, node, mirrored);
  const bool side = node >= mesh->cap;
  const double weight = circle.r * mesh->weights[node] / (4.0 * PI), sign = mirrored ? -1.0 : 1.0;
  const double up = normal_sign(side, mirrored) * (circle.z - s.z);
  for (int part = 0; part < 2; part++) {
    const double turn =
      side ? circle.r * sums->dipole[part] - s.r * sums->turned[part] : up * sums->dipole[part];
    even->single[part] += weight * sums->single[part];
    odd->single[part] += sign * weight * sums->single[part];
    even->dipole[part] -= weight * turn;
    odd->dipole[part] -= sign * weight * turn;
  }
}

static TbShellRow *rests_of(const TbShellMesh *mesh, uint32_t m, uint32_t step) {
  return mesh->rests + ((size_t)m * mesh->steps + step) * mesh->solved * 2 * mesh->nodes;
}

/* Both directions between a target and a node have the same distances. */
static void add_pair(const TbShellMesh *mesh, uint32_t step, uint32_t target, uint32_t node,
                     uint32_t mirrored) {
  const uint32_t n = mesh->nodes;
  TbRingRests values;
  angle_values(mesh, mesh->circles[target], circle_of(mesh, node, mirrored), mesh->x[step],
               &values);
  for (uint32_t m = 0; m < mesh->orders; m++) {
    const Sums sums = angle_sums(mesh, &values, m);
    TbShellRow *rows = rests_of(mesh, m, step), *row = rows + (size_t)target * 2 * n + node;
    add_rest(mesh, target, node, mirrored, &sums, row, row + n);
    if (target >= n || target == node) continue;
    row = rows + (size_t)node * 2 * n + target;
    add_rest(mesh, node, target, mirrored, &sums, row, row + n);
  }
}

static void add_step(const TbShellMesh *mesh, uint32_t step) {
  for (uint32_t target = 0; target < mesh->solved; target++) {
    for (uint32_t node = 0; node < mesh->nodes; node++) {
      if (target < mesh->nodes && node > target) break;
      add_pair(mesh, step, target, node, 0);
      add_pair(mesh, step, target, node, 1);
    }
  }
}

/* ---- rows at any x --------------------------------------------------------------------------- */

/* From the rests, which come in without their powers of x, to whole rows. */
static void finish_rows(const TbShellMesh *mesh, uint32_t m, uint32_t target, double x,
                        TbShellRow *rows) {
  const Terms *terms = terms_of(mesh, m, target, 0);
  const double square = x * x, cube = x * square;
  for (uint32_t i = 0; i < 2 * mesh->nodes; i++) {
    rows[i].single[0] = terms[i].single + square * terms[i].single_slow + x * rows[i].single[0];
    rows[i].single[1] *= x;
    rows[i].dipole[0] = terms[i].dipole + square * terms[i].dipole_slow + cube * rows[i].dipole[0];
    rows[i].dipole[1] *= cube;
  }
}

/* Lagrange's factors of the steps at x. */
static void step_factors(const TbShellMesh *mesh, double x, double *factors) {
  for (uint32_t i = 0; i < mesh->steps; i++) {
    factors[i] = 1.0;
    for (uint32_t k = 0; k < mesh->steps; k++) {
      if (k != i) factors[i] *= (x - mesh->x[k]) / (mesh->x[i] - mesh->x[k]);
    }
  }
}

void tb_shell_rows(const TbShellMesh *mesh, uint32_t m, double x, TbShellRow *rows) {
  const uint32_t size = mesh->solved * 2 * mesh->nodes;
  double factors[TB_SHELL_STEPS];
  memset(rows, 0, size * sizeof *rows);
  if (x > 0.0) {
    const uint32_t length = size * (uint32_t)(sizeof *rows / sizeof(double));
    step_factors(mesh, x, factors);
    tb_combine_rows(length, mesh->steps, factors, rests_of(mesh, m, 0)->single, length, 1.0,
                    rows->single);
  }
  for (uint32_t t = 0; t < mesh->solved; t++) {
    finish_rows(mesh, m, t, x, rows + (size_t)t * 2 * mesh->nodes);
  }
}

void tb_shell_target_rows(const TbShellMesh *mesh, uint32_t m, uint32_t target, double x,
                          TbShellRow *rows) {
  const uint32_t n = mesh->nodes;
  memset(rows, 0, 2 * n * sizeof *rows);
  for (uint32_t node = 0; node < n; node++) {
    for (uint32_t mirrored = 0; mirrored < 2; mirrored++) {
      TbRingRests values;
      angle_values(mesh, mesh->circles[target], circle_of(mesh, node, mirrored), x, &values);
      const Sums sums = angle_sums(mesh, &values, m);
      add_rest(mesh, target, node, mirrored, &sums, rows + node, rows + n + node);
    }
  }
  finish_rows(mesh, m, target, x, rows);
}

/* ---- all of it ------------------------------------------------------------------------------- */

/* Along the cap the integrand r dr is odd in t, so the rule is one in t^2. */
static void place_cap(TbShellMesh *mesh) {
  tb_gauss_rule(mesh->cap, mesh->parameters, mesh->weights);
  for (uint32_t j = 0; j < mesh->cap; j++) {
    const double t = sqrt(0.5 + 0.5 * mesh->parameters[j]);
    mesh->parameters[j] = t;
    mesh->circles[j] = (TbCircle){tb_shell_grade(t), mesh->half};
    mesh->weights[j] *= 0.25 / t * tb_shell_grade_slope(t); /* dt = d(t^2)/(2 t) */
  }
}

/* Along the side it is even: the rule is the positive half of one. */
static void place_side(TbShellMesh *mesh) {
  double t[2 * TB_SHELL_NODES], weights[2 * TB_SHELL_NODES];
  tb_gauss_rule(2 * mesh->side, t, weights);
  for (uint32_t j = 0; j < mesh->side; j++) {
    const uint32_t node = mesh->cap + j, from = mesh->side + j;
    mesh->parameters[node] = t[from];
    mesh->circles[node] = (TbCircle){1.0, mesh->half * tb_shell_grade(t[from])};
    mesh->weights[node] = weights[from] * mesh->half * tb_shell_grade_slope(t[from]);
  }
}

static void place_angles(TbShellMesh *mesh) {
  const uint32_t last = TB_SHELL_ANGLES - 1;
  for (uint32_t l = 0; l <= last; l++) {
    mesh->cosine[l] = tb_cos(PI * l / last);
    const double weight = (l % last ? 2.0 : 1.0) * PI / last;
    for (uint32_t m = 0; m < mesh->orders; m++) {
      mesh->cosines[m * TB_SHELL_ANGLES + l] = weight * tb_cos(PI * m * l / last);
    }
  }
}

/* As many as e^{-i x D} needs, D up to the diagonal. */
static void place_steps(TbShellMesh *mesh) {
  const double turn = 0.5 * mesh->top * tb_hypot(2.0, 2.0 * mesh->half);
  mesh->steps = (uint32_t)fmin(TB_SHELL_STEPS, 7.0 + turn + 1.5 * tb_cbrt(turn));
  for (uint32_t i = 0; i < mesh->steps; i++) {
    mesh->x[i] = 0.5 * mesh->top * (1.0 - tb_cos(PI * (i + 0.5) / mesh->steps));
  }
}

static bool take_memory(TbShellMesh *mesh, TbArena *arena) {
  const size_t orders = mesh->orders, nodes = mesh->nodes;
  mesh->circles = tb_arena_take(arena, mesh->targets, sizeof *mesh->circles);
  mesh->parameters = tb_arena_doubles(arena, nodes);
  mesh->weights = tb_arena_doubles(arena, nodes);
  mesh->terms = tb_arena_take(arena, orders * mesh->targets * 2 * nodes, sizeof *mesh->terms);
  mesh->cosines = tb_arena_doubles(arena, orders * TB_SHELL_ANGLES);
  mesh->cosine = tb_arena_doubles(arena, TB_SHELL_ANGLES);
  mesh->x = tb_arena_doubles(arena, TB_SHELL_STEPS);
  if (arena->failed) return false;
  place_steps(mesh);
  mesh->rests =
    tb_arena_take(arena, orders * mesh->steps * mesh->solved * 2 * nodes, sizeof *mesh->rests);
  return mesh->rests != NULL;
}

static void place_points(TbShellMesh *mesh, uint32_t first, const TbCircle *points,
                         uint32_t count) {
  for (uint32_t p = 0; p < count; p++) {
    mesh->circles[first + p] = (TbCircle){fmax(points[p].r, LEAST_RADIUS), points[p].z};
  }
}

bool tb_shell_mesh_prepare(TbShellMesh *mesh, TbArena *arena, TbShellSize size,
                           const TbCircle *inner, uint32_t inner_count, const TbCircle *outer,
                           uint32_t outer_count) {
  *mesh = (TbShellMesh){.half = size.half,
                        .top = size.top,
                        .cap = size.cap,
                        .side = size.side,
                        .nodes = size.cap + size.side,
                        .orders = size.orders};
  mesh->solved = mesh->nodes + inner_count;
  mesh->targets = mesh->solved + outer_count;
  if (!take_memory(mesh, arena)) return false;
  place_cap(mesh);
  place_side(mesh);
  place_points(mesh, mesh->nodes, inner, inner_count);
  place_points(mesh, mesh->solved, outer, outer_count);
  place_angles(mesh);
  TbArena scratch;
  tb_arena_beside(&scratch, arena);
  bool done = true;
  for (uint32_t target = 0; target < mesh->targets && done; target++) {
    done = add_target(mesh, &scratch, target);
  }
  tb_arena_release(&scratch);
  for (uint32_t step = 0; step < mesh->steps; step++) add_step(mesh, step);
  return done;
}
