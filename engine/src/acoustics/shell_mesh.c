/* SPDX-License-Identifier: MIT */
#include "acoustics/shell_mesh.h"

#include <math.h>

#include "math/portable_math.h"
#include "math/quadrature.h"

static const double PI = 3.14159265358979323846;

/* A panel is as long as the distance to the target times this at most; nearer than this to the axis a
 * point counts as that far off. */
static const double LONGEST_PANEL = 2.0, LEAST_RADIUS = 1e-4;
enum { MOST_SPLITS = 14 };

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
    double product = odd ? t / own : 1.0; /* even: a polynomial in t^2 */
    for (uint32_t k = 0; k < count; k++) {
      if (k == j) continue;
      const double other = parameters[k];
      product *= (t - other) * (t + other) / ((own - other) * (own + other));
    }
    basis[j] = product;
  }
}

/* ---- one part of the surface as seen from a target --------------------------------------------- */

/* The upper cap or the upper half of the side, or its mirror image. */
typedef struct Part {
  const TbShellMesh *mesh;
  bool side, mirrored;
  TbCircle target;
} Part;

static TbCircle ring_at(const Part *part, double t) {
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

/* What a target's rows of all orders grow by. */
typedef struct Rows {
  double *still, *slow; /* [orders][2: even, odd basis][nodes of the part] */
} Rows;

static void add_point(const Part *part, const Rows *rows, double t, double weight) {
  const TbShellMesh *mesh = part->mesh;
  const uint32_t count = part->side ? mesh->side : mesh->cap, orders = mesh->orders;
  const double *parameters = mesh->parameters + (part->side ? mesh->cap : 0);
  double basis[2][TB_SHELL_NODES], still[TB_RING_ORDERS], slow[TB_RING_ORDERS];
  tb_shell_basis(parameters, count, false, t, basis[0]);
  tb_shell_basis(parameters, count, true, t, basis[1]);
  tb_ring_still(part->target, ring_at(part, t), part->side, orders, still, slow);
  const double down = part->mirrored && !part->side ? -1.0 : 1.0; /* the lower cap's normal */
  const double length = down * weight * tb_shell_grade_slope(t) * (part->side ? mesh->half : 1.0);
  for (uint32_t m = 0; m < orders; m++) {
    for (uint32_t odd = 0; odd < 2; odd++) {
      if (!part->side && odd != m % 2) continue; /* on the cap t goes with r */
      double *still_row = rows->still + (size_t)(2 * m + odd) * count;
      double *slow_row = rows->slow + (size_t)(2 * m + odd) * count;
      const double still_size = length * still[m], slow_size = length * slow[m];
      for (uint32_t j = 0; j < count; j++) {
        still_row[j] += still_size * basis[odd][j];
        slow_row[j] += slow_size * basis[odd][j];
      }
    }
  }
}

static void add_panel(const Part *part, const Rows *rows, double from, double to) {
  double t[TB_PANEL], weights[TB_PANEL];
  tb_quadrature(fmin(from, to), fmax(from, to), 1, t, weights);
  for (uint32_t q = 0; q < TB_PANEL; q++) add_point(part, rows, t[q], weights[q]);
}

/* Integrates from `near`, which is the nearest point to the target, to `far`. */
static void add_towards(const Part *part, const Rows *rows, double near, double far) {
  if (near == far) return;
  const TbCircle nearest = ring_at(part, near);
  const double gap = distance(part->target, nearest);
  for (int split = 0; split < MOST_SPLITS; split++) {
    if (distance(nearest, ring_at(part, far)) <= LONGEST_PANEL * gap) break;
    const double middle = near + 0.25 * (far - near);
    add_panel(part, rows, middle, far);
    far = middle;
  }
  add_panel(part, rows, near, far);
}

static void add_part(const Part *part, const Rows *rows) {
  const double near = nearest_parameter(part);
  add_towards(part, rows, near, 0.0);
  add_towards(part, rows, near, 1.0);
}

/* ---- rows of one target ------------------------------------------------------------------------ */

/* Adds what a part gives to the rows of both symmetries; a mirror image is the same or the negative. */
static void gather(const TbShellMesh *mesh, uint32_t target, const Part *part, const Rows *rows) {
  const uint32_t count = part->side ? mesh->side : mesh->cap, first = part->side ? mesh->cap : 0;
  for (uint32_t m = 0; m < mesh->orders; m++) {
    for (uint32_t odd = 0; odd < 2; odd++) {
      const uint32_t basis = part->side ? odd : m % 2;
      const double sign = part->mirrored && odd ? -1.0 : 1.0;
      const size_t from = (size_t)(2 * m + basis) * count;
      const size_t to = tb_shell_row(mesh, m, target, odd) + first;
      for (uint32_t j = 0; j < count; j++) {
        mesh->still[to + j] += sign * rows->still[from + j];
        mesh->slow[to + j] += sign * rows->slow[from + j];
      }
    }
  }
}

static bool add_target(const TbShellMesh *mesh, TbArena *scratch, uint32_t target) {
  const size_t size = (size_t)mesh->orders * 2 * (mesh->cap > mesh->side ? mesh->cap : mesh->side);
  const Rows rows = {tb_arena_doubles(scratch, size), tb_arena_doubles(scratch, size)};
  if (scratch->failed) return false;
  for (int which = 0; which < 4; which++) {
    const Part part = {mesh, which % 2, which / 2, mesh->rings[target]};
    const bool same_plane = !part.side && !part.mirrored && part.target.z == mesh->half;
    if (same_plane) continue; /* n'.d = 0 */
    for (size_t i = 0; i < size; i++) rows.still[i] = rows.slow[i] = 0.0;
    add_part(&part, &rows);
    gather(mesh, target, &part, &rows);
  }
  return true;
}

static void add_distances(const TbShellMesh *mesh, uint32_t target) {
  const TbCircle a = mesh->rings[target];
  double *out = mesh->distances + (size_t)target * 2 * mesh->nodes * TB_SHELL_ANGLES;
  for (uint32_t image = 0; image < 2; image++) {
    for (uint32_t j = 0; j < mesh->nodes; j++) {
      const TbCircle b = mesh->rings[j];
      const double height = a.z - (image ? -b.z : b.z);
      const double squares = a.r * a.r + b.r * b.r + height * height;
      for (uint32_t l = 0; l < TB_SHELL_ANGLES; l++) {
        *out++ = sqrt(fmax(0.0, squares - 2.0 * a.r * b.r * mesh->cosine[l]));
      }
    }
  }
}

/* ---- all of it --------------------------------------------------------------------------------- */

/* Along the cap the integrand r dr is odd in t, so the rule is one in t^2. */
static void place_cap(TbShellMesh *mesh) {
  tb_gauss_rule(mesh->cap, mesh->parameters, mesh->weights);
  for (uint32_t j = 0; j < mesh->cap; j++) {
    const double t = sqrt(0.5 + 0.5 * mesh->parameters[j]);
    mesh->parameters[j] = t;
    mesh->rings[j] = (TbCircle){tb_shell_grade(t), mesh->half};
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
    mesh->rings[node] = (TbCircle){1.0, mesh->half * tb_shell_grade(t[from])};
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

static bool take_memory(TbShellMesh *mesh, TbArena *arena) {
  const size_t rows = (size_t)mesh->orders * mesh->targets * 2 * mesh->nodes;
  mesh->rings = tb_arena_take(arena, mesh->targets, sizeof *mesh->rings);
  mesh->parameters = tb_arena_doubles(arena, mesh->nodes);
  mesh->weights = tb_arena_doubles(arena, mesh->nodes);
  mesh->still = tb_arena_doubles(arena, rows);
  mesh->slow = tb_arena_doubles(arena, rows);
  mesh->distances =
    tb_arena_doubles(arena, (size_t)mesh->targets * 2 * mesh->nodes * TB_SHELL_ANGLES);
  mesh->cosines = tb_arena_doubles(arena, (size_t)mesh->orders * TB_SHELL_ANGLES);
  mesh->cosine = tb_arena_doubles(arena, TB_SHELL_ANGLES);
  return !arena->failed;
}

bool tb_shell_mesh_prepare(TbShellMesh *mesh, TbArena *arena, double half, uint32_t cap,
                           uint32_t side, uint32_t orders, const TbCircle *points,
                           uint32_t point_count) {
  *mesh = (TbShellMesh){.half = half,
                        .cap = cap,
                        .side = side,
                        .nodes = cap + side,
                        .targets = cap + side + point_count,
                        .orders = orders};
  if (!take_memory(mesh, arena)) return false;
  place_cap(mesh);
  place_side(mesh);
  for (uint32_t p = 0; p < point_count; p++) {
    mesh->rings[mesh->nodes + p] = (TbCircle){fmax(points[p].r, LEAST_RADIUS), points[p].z};
  }
  place_angles(mesh);
  TbArena scratch;
  tb_arena_prepare(&scratch, &arena->allocator);
  bool done = true;
  for (uint32_t target = 0; target < mesh->targets && done; target++) {
    done = add_target(mesh, &scratch, target);
    add_distances(mesh, target);
  }
  tb_arena_release(&scratch);
  return done;
}
