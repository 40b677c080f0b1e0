/* SPDX-License-Identifier: MIT */
/* The air outside a finite rigid shell: a solution that is known everywhere, power, reciprocity,
 * limits. */
#include <complex.h>

#include "air_model/shell_radiation.h"
#include "math/bessel.h"
#include "math/least_squares.h"
#include "math/quadrature.h"
#include "physics.h"
#include "reference.h"

static const double PI = 3.14159265358979323846;

static TbArena scratch_arena(void) {
  const TaborAllocator system = tb_allocator_resolve(NULL);
  TbArena arena;
  tb_arena_prepare(&arena, &system);
  return arena;
}

/* ---- a ring of sources inside ---------------------------------------------------------------- */

typedef struct Field {
  double complex value, along_r, along_z;
} Field;

/* Of a ring of sources cos(m t) at (r, z), at a point that is not near to it. */
static Field ring_field(TbCircle ring, uint32_t m, double x, TbCircle at) {
  enum { ANGLES = 512 };
  Field field = {0.0, 0.0, 0.0};
  for (int i = 0; i < ANGLES; i++) {
    const double t = 2.0 * PI * i / ANGLES, height = at.z - ring.z;
    const double across = at.r - ring.r * cos(t), side = ring.r * sin(t);
    const double d = sqrt(across * across + side * side + height * height);
    const double complex wave = cos(m * t) * cexp(-I * x * d) / d * 2.0 * PI / ANGLES;
    const double complex slope = -wave * (1.0 / d + I * x) / d;
    field.value += wave;
    field.along_r += slope * across;
    field.along_z += slope * height;
  }
  return field;
}

/* The ring and its mirror image, the latter with this sign. */
static Field both_fields(TbCircle ring, double sign, uint32_t m, double x, TbCircle at) {
  const Field own = ring_field(ring, m, x, at);
  const Field image = ring_field((TbCircle){ring.r, -ring.z}, m, x, at);
  return (Field){own.value + sign * image.value, own.along_r + sign * image.along_r,
                 own.along_z + sign * image.along_z};
}

static double complex sum_rows(const TbShellRow *row, uint32_t n, const double *pressure,
                               const double complex *w) {
  double complex sum = 0.0;
  for (uint32_t j = 0; j < n; j++) {
    sum += (row[j].single[0] + I * row[j].single[1]) * w[j];
    if (pressure) {
      sum +=
        (row[j].dipole[0] + I * row[j].dipole[1]) * (pressure[2 * j] + I * pressure[2 * j + 1]);
    }
  }
  return sum;
}

/* The equations of all nodes and points inside, as real ones, for these velocities. */
static void ring_equations(const TbShellMesh *mesh, const TbShellRow *rows, uint32_t odd,
                           const double complex *w, double *matrix, double *sides) {
  const uint32_t n = mesh->nodes;
  for (uint32_t t = 0; t < mesh->solved; t++) {
    const TbShellRow *row = rows + (2 * (size_t)t + odd) * n;
    double *re = matrix + 4 * (size_t)t * n, *im = re + 2 * n;
    for (uint32_t j = 0; j < n; j++) {
      re[2 * j] = im[2 * j + 1] = (t == j ? 0.5 : 0.0) - row[j].dipole[0];
      re[2 * j + 1] = row[j].dipole[1];
      im[2 * j] = -row[j].dipole[1];
    }
    const double complex side = sum_rows(row, n, NULL, w);
    sides[2 * t] = creal(side);
    sides[2 * t + 1] = cimag(side);
  }
}

/* Solves for the pressure on the shell from its velocity, which is that of the ring's field all
 * over the surface, side and edge included; returns the worst difference from the ring's pressure
 * at the nodes, and from its field at points outside, in parts of the largest. */
static double difference_from_the_ring(const TbShellMesh *mesh, uint32_t m, uint32_t odd,
                                       double x) {
  const TbCircle ring = {0.25, 0.25 * mesh->half};
  const uint32_t n = mesh->nodes;
  TbArena arena = scratch_arena();
  TbShellRow *rows = tb_arena_take(&arena, (size_t)mesh->solved * 2 * n, sizeof *rows);
  double *matrix = tb_arena_doubles(&arena, 4 * (size_t)mesh->solved * n);
  double *sides = tb_arena_doubles(&arena, 2 * (size_t)mesh->solved);
  double *pressure = tb_arena_doubles(&arena, 2 * (size_t)n);
  double complex w[TB_SHELL_NODES];
  const double sign = odd ? -1.0 : 1.0;
  double largest = 0.0, worst = 0.0;
  for (uint32_t j = 0; j < n; j++) {
    const Field field = both_fields(ring, sign, m, x, mesh->circles[j]);
    w[j] = j < mesh->cap ? -field.along_z : -field.along_r;
    largest = fmax(largest, cabs(field.value));
  }
  tb_shell_rows(mesh, m, x, rows);
  ring_equations(mesh, rows, odd, w, matrix, sides);
  assert_true(tb_least_squares(&arena, 2 * mesh->solved, 2 * n, matrix, 1, sides, pressure));
  for (uint32_t target = 0; target < mesh->targets; target++) {
    if (target >= n && target < mesh->solved) continue;
    const Field field = both_fields(ring, sign, m, x, mesh->circles[target]);
    double complex found = target < n ? pressure[2 * target] + I * pressure[2 * target + 1] : 0.0;
    if (target >= n) {
      tb_shell_target_rows(mesh, m, target, x, rows);
      found = sum_rows(rows + odd * n, n, pressure, w);
    }
    worst = fmax(worst, cabs(found - field.value) / largest);
  }
  tb_arena_release(&arena);
  return worst;
}

static double worst_difference(const TbShellMesh *mesh, uint32_t orders) {
  double worst = 0.0;
  for (uint32_t m = 0; m < orders; m++) {
    for (uint32_t odd = 0; odd < 2; odd++) {
      for (double x = 0.05; x < 6.0; x *= 1.9) {
        worst = fmax(worst, difference_from_the_ring(mesh, m, odd, x));
      }
    }
  }
  return worst;
}

/* The nodes of a drum are enough for heads, which are smoother at these x than the field of a near
 * ring; more of them resolve it too. */
static void a_ring_inside_gives_back_its_own_field(void **state) {
  (void)state;
  static const double DEPTHS[] = {1.2, 2.0, 3.0};
  static const TbAirPoint POINTS[] = {{0.3, 0.4}, {2.0, 1.0}};
  for (int i = 0; i < 3; i++) {
    TbArena arena = scratch_arena();
    TbShellMesh mesh;
    assert_true(tb_shell_prepare(&mesh, &arena, DEPTHS[i], POINTS, 2));
    const double worst = worst_difference(&mesh, 2);
    print_message("depth %.1f, %u nodes: within %.1e\n", DEPTHS[i], mesh.nodes, worst);
    const TbShellSize size = {
      .half = mesh.half, .top = mesh.top, .cap = 24, .side = 18, .orders = 6};
    const TbCircle outside[] = {{0.3, mesh.half + 0.4}, {2.0, 1.0}};
    const TbCircle inside[] = {
      {0.3, 0.3 * size.half}, {0.6, 0.6 * size.half}, {0.8, 0.2 * size.half}};
    assert_true(tb_shell_mesh_prepare(&mesh, &arena, size, inside, 3, outside, 2));
    const double fine = worst_difference(&mesh, 4);
    print_message("  %u nodes: within %.1e\n", mesh.nodes, fine);
    assert_true(worst < 2e-3 && fine < 1e-3);
    tb_arena_release(&arena);
  }
}

/* Of a constant, the static double layer is -1/2 on the surface, -1 inside and 0 outside. */
static void a_constant_has_the_solid_angle_of_the_shell(void **state) {
  (void)state;
  static const double DEPTHS[] = {0.02, 0.3, 1.2, 8.0};
  static const TbAirPoint POINTS[] = {{0.0, 0.01}, {0.5, 0.2}, {1.02, -0.1}};
  for (int i = 0; i < 4; i++) {
    TbArena arena = scratch_arena();
    TbShellMesh mesh;
    assert_true(tb_shell_prepare(&mesh, &arena, DEPTHS[i], POINTS, 3));
    for (uint32_t t = 0; t < mesh.targets; t++) {
      const TbRingTerms *terms = mesh.terms + 2 * (size_t)t * mesh.nodes;
      double sum = t < mesh.nodes ? 0.5 : (t < mesh.solved ? 1.0 : 0.0);
      for (uint32_t j = 0; j < mesh.nodes; j++) sum += terms[j].dipole;
      assert_true(fabs(sum) < 1e-4);
    }
    tb_arena_release(&arena);
  }
}

/* ---- heads ----------------------------------------------------------------------------------- */

enum { ZEROS = 6, MOST_POINTS = TABOR_MAX_MICS };

/* One order of a shell with its Bessel functions. */
typedef struct Drum {
  TbArena arena;
  TbShellMesh mesh;
  TbAirOrder air;
  TbShellOrder order;
  double zeros[ZEROS], depth;
} Drum;

static void prepare_drum(Drum *drum, double depth, uint32_t m, const TbAirPoint *points,
                         uint32_t count) {
  drum->arena = scratch_arena();
  drum->depth = depth;
  double zeros[2 * ZEROS];
  assert_true(tb_bessel_zeros(m, PI * (ZEROS + 0.5 * m + 1.0), zeros, 2 * ZEROS) >= ZEROS);
  memcpy(drum->zeros, zeros, sizeof drum->zeros);
  assert_true(tb_air_order_prepare(&drum->air, &drum->arena, m, drum->zeros, ZEROS));
  assert_true(tb_shell_prepare(&drum->mesh, &drum->arena, depth, points, count));
  assert_true(tb_shell_order_prepare(&drum->order, &drum->arena, &drum->mesh, &drum->air));
}

static TbShellMotion solve(Drum *drum, const double *upper, const double *lower, double x) {
  TbShellMotion motion;
  assert_true(tb_shell_solve(&motion, &drum->arena, &drum->order, upper, lower, x));
  return motion;
}

static double resistance_of(Drum *drum, const double *upper, const double *lower, double x) {
  return solve(drum, upper, lower, x).resistance;
}

static const double UPPER[ZEROS] = {0.7, 1.0, 0.1, -0.2}, LOWER[ZEROS] = {0.5, -0.3, 0.4, 0.1};

/* What the surface gives, x Im Int I w, against what leaves through a sphere: per a_m, x^2 Int
 * |I|^2 s^2 sin t dt. */
static void power_on_the_heads_is_power_far_away(void **state) {
  (void)state;
  const double distance = 300.0;
  enum { PANELS = 2, COUNT = PANELS * TB_PANEL };
  double angles[COUNT], weights[COUNT];
  tb_quadrature(0.0, PI, PANELS, angles, weights);
  double worst = 0.0;
  for (uint32_t m = 0; m < 4; m++) {
    double sums[4] = {0.0}, booked[4] = {0.0};
    static const double XS[4] = {0.3, 1.1, 2.9, 5.6};
    for (int batch = 0; batch < COUNT / MOST_POINTS; batch++) {
      TbAirPoint points[MOST_POINTS];
      for (int p = 0; p < MOST_POINTS; p++) {
        const double t = angles[batch * MOST_POINTS + p];
        points[p] = (TbAirPoint){distance * sin(t), distance * cos(t) - 0.5 * 0.9};
      }
      Drum drum;
      prepare_drum(&drum, 0.9, m, points, MOST_POINTS);
      for (int i = 0; i < 4; i++) {
        double fields[2 * MOST_POINTS];
        const TbShellMotion motion = solve(&drum, UPPER, LOWER, XS[i]);
        booked[i] = motion.resistance;
        assert_true(tb_shell_fields(&motion, &drum.arena, points, MOST_POINTS, fields));
        for (int p = 0; p < MOST_POINTS; p++) {
          const int k = batch * MOST_POINTS + p;
          const double square =
            fields[2 * p] * fields[2 * p] + fields[2 * p + 1] * fields[2 * p + 1];
          sums[i] += weights[k] * sin(angles[k]) * square * distance * distance;
        }
      }
      tb_arena_release(&drum.arena);
    }
    for (int i = 0; i < 4; i++) {
      const double ratio = XS[i] * XS[i] * sums[i] / booked[i];
      print_message("m %u, x %.1f: power in the field %.5f of the resistance's\n", m, XS[i], ratio);
      if (booked[i] > 1e-6) worst = fmax(worst, fabs(ratio - 1.0));
    }
  }
  assert_true(worst < 3e-3);
}

static double product(const double *a, const double *b, uint32_t count) {
  double sum = 0.0;
  for (uint32_t i = 0; i < count; i++) sum += a[i] * b[i];
  return sum;
}

/* What one motion's pressure does to another's displacement is symmetric. */
static void loads_are_reciprocal(void **state) {
  (void)state;
  double worst = 0.0;
  for (uint32_t m = 0; m < 3; m++) {
    Drum drum;
    prepare_drum(&drum, 0.8, m, NULL, 0);
    for (double x = 0.4; x < 6.0; x *= 1.9) {
      const TbShellMotion one = solve(&drum, UPPER, LOWER, x),
                          other = solve(&drum, LOWER, UPPER, x);
      static const double THIRD[2 * ZEROS] = {0.0, 0.0, 0.9, 0.0, 0.0, 0.0, 0.3};
      const TbShellMotion third = solve(&drum, THIRD, THIRD + ZEROS, x);
      double first[2 * ZEROS];
      memcpy(first, UPPER, sizeof UPPER);
      memcpy(first + ZEROS, LOWER, sizeof LOWER);
      assert_true(fabs(one.resistance / other.resistance - 1.0) < 1e-9); /* upside down */
      const double there = product(first, third.inertia, 2 * ZEROS);
      const double back = product(THIRD, one.inertia, 2 * ZEROS);
      const double size = sqrt(
        fabs(product(first, one.inertia, 2 * ZEROS) * product(THIRD, third.inertia, 2 * ZEROS)));
      worst = fmax(worst, fabs(there - back) / fmax(size, fabs(there)));
    }
    tb_arena_release(&drum.arena);
  }
  print_message("loads are symmetric within %.1e\n", worst);
  assert_true(worst < 1e-2);
}

/* Far below the first wavelength a head over a rigid bottom is a monopole of the volume 2 pi R^2 q
 * that it displaces, q = Int w r dr: r = x^2 q^2/2. Two heads outwards give four times that, and
 * two that move the same way a dipole, next to nothing. */
static void a_slow_drum_is_a_monopole(void **state) {
  (void)state;
  const double one[ZEROS] = {1.0}, minus[ZEROS] = {-1.0}, x = 0.02;
  for (double depth = 0.1; depth < 5.0; depth *= 4.0) {
    Drum drum;
    prepare_drum(&drum, depth, 0, NULL, 0);
    const double swept = tb_bessel_j(1, drum.zeros[0]) / drum.zeros[0];
    const double monopole = 0.5 * x * x * swept * swept;
    assert_true(fabs(resistance_of(&drum, one, NULL, x) / monopole - 1.0) < 2e-3);
    assert_true(fabs(resistance_of(&drum, one, one, x) / (4.0 * monopole) - 1.0) < 2e-3);
    const double dipole = resistance_of(&drum, one, minus, x);
    assert_true(dipole > 0.0 && dipole < 2e-3 * monopole);
    tb_arena_release(&drum.arena);
  }
}

/* A dipole's resistance goes like x^4, a quadrupole's (order 1, heads against each other) like x^6.
 */
static void slow_motions_radiate_as_their_multipoles(void **state) {
  (void)state;
  const double one[ZEROS] = {1.0}, minus[ZEROS] = {-1.0};
  for (uint32_t m = 0; m < 2; m++) {
    Drum drum;
    prepare_drum(&drum, 0.8, m, NULL, 0);
    const double ratio =
      resistance_of(&drum, one, minus, 0.2) / resistance_of(&drum, one, minus, 0.1);
    print_message("order %u: resistance doubles %.2f times with x\n", m, log2(ratio));
    assert_true(fabs(log2(ratio) - (m ? 6.0 : 4.0)) < 0.05);
    tb_arena_release(&drum.arena);
  }
}

/* Without a shell, two heads that move outwards alike are both sides of a baffled one, and two that
 * move the same way are the two sides of an open one: resistance and mass, as the depth goes to 0.
 */
static void a_thin_drum_is_a_baffled_or_an_open_head(void **state) {
  (void)state;
  static const double MINUS[ZEROS] = {-0.7, -1.0, -0.1, 0.2};
  double worst[3] = {0.0};
  for (int i = 0; i < 3; i++) {
    const double depth = 0.04 / (1 << i);
    Drum drum;
    prepare_drum(&drum, depth, 0, NULL, 0);
    double own[ZEROS * ZEROS], mutual[ZEROS * ZEROS];
    assert_true(tb_shell_order_mass(&drum.order, &drum.arena, own, mutual));
    for (double x = 0.5; x < 4.0; x *= 1.9) {
      for (int boundary = 0; boundary < 2; boundary++) {
        TbAirLoad load;
        assert_true(tb_air_load(&drum.air, &drum.arena, (TaborBoundary)boundary, true, UPPER, x,
                                NULL, 0, &load, NULL));
        const bool open = boundary == TABOR_BOUNDARY_OPEN;
        const double *lower = open ? MINUS : UPPER;
        const TbShellMotion motion = solve(&drum, UPPER, lower, x);
        double mass = 0.0;
        for (uint32_t a = 0; a < ZEROS; a++) {
          mass += UPPER[a] * motion.inertia[a] + lower[a] * motion.inertia[ZEROS + a];
          for (uint32_t b = 0; b < ZEROS; b++) {
            mass += (UPPER[a] * UPPER[b] + lower[a] * lower[b]) * own[a * ZEROS + b] +
                    2.0 * UPPER[a] * lower[b] * mutual[a * ZEROS + b];
          }
        }
        worst[i] = fmax(worst[i], fabs(motion.resistance / load.resistance - 1.0));
        worst[i] = fmax(worst[i], fabs(mass / load.mass - 1.0));
      }
    }
    print_message("depth %.3f: within %.2g\n", depth, worst[i]);
    tb_arena_release(&drum.arena);
  }
  assert_true(worst[2] < 0.05 && worst[1] < 0.7 * worst[0] && worst[2] < 0.7 * worst[1]);
}

/* A head that is far from the other one does not know how deep the shell is. */
static void the_heads_of_a_long_shell_are_alone(void **state) {
  (void)state;
  double own[2][ZEROS * ZEROS], mutual[ZEROS * ZEROS];
  for (int i = 0; i < 2; i++) {
    Drum drum;
    prepare_drum(&drum, i ? 10.0 : 5.0, 1, NULL, 0);
    assert_true(tb_shell_order_mass(&drum.order, &drum.arena, own[i], mutual));
    tb_arena_release(&drum.arena);
    assert_true(fabs(mutual[0]) < 2e-3 * own[i][0]);
  }
  assert_true(fabs(own[1][0] / own[0][0] - 1.0) < 1e-3);
}

/* Where the wavelength is short against the head, every point meets rho0 c0: r = Int w^2 r dr,
 * without mass. */
static void a_fast_head_meets_plane_waves(void **state) {
  (void)state;
  Drum drum;
  prepare_drum(&drum, 0.8, 0, NULL, 0);
  const double one[ZEROS] = {1.0}, slope = tb_bessel_j(1, drum.zeros[0]);
  const double plane = 0.5 * slope * slope;
  const TbShellMotion motion = solve(&drum, one, NULL, 6.0);
  double own[ZEROS * ZEROS], mutual[ZEROS * ZEROS];
  assert_true(tb_shell_order_mass(&drum.order, &drum.arena, own, mutual));
  assert_true(fabs(motion.resistance / plane - 1.0) < 0.12);
  assert_true(fabs(own[0] + motion.inertia[0]) < 0.1 * own[0]);
  tb_arena_release(&drum.arena);
}

/* The equations on the surface fail where a soft cylinder of air would ring; the points inside hold
 * the solution there: it lies on the line through its neighbours. */
static void resonances_inside_are_not_heard(void **state) {
  (void)state;
  const double depth = 1.6;
  for (uint32_t m = 0; m < 3; m++) {
    Drum drum;
    prepare_drum(&drum, depth, m, NULL, 0);
    for (int axial = 1; axial < 4; axial++) {
      const double x = hypot(drum.zeros[0], axial * PI / depth);
      if (x > 5.8) continue;
      const double here = resistance_of(&drum, UPPER, LOWER, x);
      const double before = resistance_of(&drum, UPPER, LOWER, x - 0.02);
      const double after = resistance_of(&drum, UPPER, LOWER, x + 0.02);
      assert_true(fabs(2.0 * here / (before + after) - 1.0) < 2e-3);
    }
    tb_arena_release(&drum.arena);
  }
}

/* ---- an independent method ------------------------------------------------------------------- */

/* tests/reference/shell_radiation.json: fundamental solutions, tools/radiation_reference.py.
 * Differences of masses of motions i and j are in parts of sqrt(own_ii own_jj), those of fields in
 * parts of the largest. */
typedef struct Agreement {
  double mass, resistance, field;
} Agreement;

static uint32_t integer(const json_t *entry, const char *name) {
  return (uint32_t)json_integer_value(json_object_get(entry, name));
}

static double real(const json_t *entry, const char *name) {
  return json_number_value(json_object_get(entry, name));
}

/* Row i, column j of an upper triangle that is stored by rows. */
static double element(const json_t *entry, const char *name, uint32_t size, uint32_t i,
                      uint32_t j) {
  const uint32_t row = i < j ? i : j, column = i < j ? j : i;
  return reference_number(json_object_get(entry, name), row * size - row * (row + 1) / 2 + column);
}

/* The upper head alone moves in motion j. */
static void compare_motion(Drum *drum, const json_t *entry, uint32_t size, uint32_t j,
                           const double *own, const double *mutual, Agreement *worst) {
  double moving[ZEROS] = {0.0};
  const double still[ZEROS] = {0.0};
  moving[j] = 1.0;
  const double x = real(entry, "k");
  const TbShellMotion alone = solve(drum, moving, still, x), both = solve(drum, moving, moving, x);
  for (uint32_t i = 0; i < size; i++) {
    const double unit =
      sqrt(fabs(element(entry, "own_mass", size, i, i) * element(entry, "own_mass", size, j, j)));
    const double here = own[i * ZEROS + j] + alone.inertia[i];
    const double there = mutual[i * ZEROS + j] + alone.inertia[ZEROS + i];
    worst->mass = fmax(worst->mass, fabs(here - element(entry, "own_mass", size, i, j)) / unit);
    worst->mass = fmax(worst->mass, fabs(there - element(entry, "mutual_mass", size, i, j)) / unit);
  }
  const double single = element(entry, "own_resistance", size, j, j);
  const double across = element(entry, "mutual_resistance", size, j, j);
  /* less than 1e-4 of the reactance is no resistance that would be heard */
  const double heard = fmax(single, 1e-4 * x * element(entry, "own_mass", size, j, j));
  worst->resistance = fmax(worst->resistance, fabs(alone.resistance - single) / heard);
  worst->resistance =
    fmax(worst->resistance, fabs(0.5 * both.resistance - alone.resistance - across) / heard);
}

/* The lowest two motions of each order, which radiate most. */
enum { COMPARED = 2 };

static void loads_are_those_of_fundamental_solutions(void **state) {
  (void)state;
  json_t *root = reference_load("shell_radiation.json");
  const json_t *list = json_object_get(root, "impedances");
  Agreement worst = {0.0, 0.0, 0.0};
  uint32_t compared = 0;
  for (size_t e = 0; e < json_array_size(list); e++) {
    const json_t *entry = json_array_get(list, e);
    const uint32_t m = integer(entry, "m"), size = m < 4 ? 4 : 2;
    Drum drum;
    prepare_drum(&drum, real(entry, "depth"), m, NULL, 0);
    double own[ZEROS * ZEROS], mutual[ZEROS * ZEROS];
    assert_true(tb_shell_order_mass(&drum.order, &drum.arena, own, mutual));
    if (real(entry, "k") < drum.mesh.top) {
      for (uint32_t j = 0; j < COMPARED; j++) {
        compare_motion(&drum, entry, size, j, own, mutual, &worst);
      }
      compared++;
    }
    tb_arena_release(&drum.arena);
  }
  print_message("%u loads: masses within %.1e, resistances within %.1e\n", compared, worst.mass,
                worst.resistance);
  assert_true(compared > 100);
  assert_true(worst.mass < 5e-3 && worst.resistance < 1e-3);
  json_decref(root);
}

/* Heights are numbers, or "-d/2" and "-d-0.5". */
static uint32_t reference_points(const json_t *root, double depth, TbAirPoint *points) {
  const json_t *list = json_object_get(root, "points");
  const uint32_t count = (uint32_t)json_array_size(list);
  for (uint32_t p = 0; p < count; p++) {
    const json_t *height = json_array_get(json_array_get(list, p), 1);
    const char *text = json_string_value(height);
    points[p].radius = reference_number(json_array_get(list, p), 0);
    points[p].height =
      !text ? json_number_value(height) : (strcmp(text, "-d/2") == 0 ? -0.5 * depth : -depth - 0.5);
  }
  return count;
}

static void compare_fields(Drum *drum, const json_t *entry, const TbAirPoint *points,
                           uint32_t count, uint32_t n, Agreement *worst) {
  double moving[ZEROS] = {0.0}, fields[2 * MOST_POINTS], largest = 0.0, difference = 0.0;
  const double still[ZEROS] = {0.0};
  moving[n] = 1.0;
  const TbShellMotion motion = solve(drum, moving, still, real(entry, "k"));
  assert_true(tb_shell_fields(&motion, &drum->arena, points, count, fields));
  const json_t *re = json_array_get(json_object_get(entry, "re"), n);
  const json_t *im = json_array_get(json_object_get(entry, "im"), n);
  for (uint32_t p = 0; p < count; p++) {
    const double there[2] = {reference_number(re, p), reference_number(im, p)};
    largest = fmax(largest, hypot(there[0], there[1]));
    difference = fmax(difference, hypot(fields[2 * p] - there[0], fields[2 * p + 1] - there[1]));
  }
  worst->field = fmax(worst->field, difference / largest);
}

static void fields_are_those_of_fundamental_solutions(void **state) {
  (void)state;
  json_t *root = reference_load("shell_radiation.json");
  const json_t *list = json_object_get(root, "fields");
  Agreement worst = {0.0, 0.0, 0.0};
  uint32_t compared = 0;
  for (size_t e = 0; e < json_array_size(list); e++) {
    const json_t *entry = json_array_get(list, e);
    const double depth = real(entry, "depth");
    TbAirPoint points[MOST_POINTS];
    const uint32_t count = reference_points(root, depth, points);
    Drum drum;
    prepare_drum(&drum, depth, integer(entry, "m"), points, count);
    if (real(entry, "k") < drum.mesh.top) {
      for (uint32_t n = 0; n < 2; n++) compare_fields(&drum, entry, points, count, n, &worst);
      compared++;
    }
    tb_arena_release(&drum.arena);
  }
  print_message("%u fields: within %.1e\n", compared, worst.field);
  assert_true(compared > 10);
  assert_true(worst.field < 2e-3);
  json_decref(root);
}

int main(void) {
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(a_ring_inside_gives_back_its_own_field),
    cmocka_unit_test(a_constant_has_the_solid_angle_of_the_shell),
    cmocka_unit_test(loads_are_those_of_fundamental_solutions),
    cmocka_unit_test(fields_are_those_of_fundamental_solutions),
    cmocka_unit_test(power_on_the_heads_is_power_far_away),
    cmocka_unit_test(loads_are_reciprocal),
    cmocka_unit_test(a_slow_drum_is_a_monopole),
    cmocka_unit_test(slow_motions_radiate_as_their_multipoles),
    cmocka_unit_test(a_thin_drum_is_a_baffled_or_an_open_head),
    cmocka_unit_test(the_heads_of_a_long_shell_are_alone),
    cmocka_unit_test(a_fast_head_meets_plane_waves),
    cmocka_unit_test(resonances_inside_are_not_heard),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
