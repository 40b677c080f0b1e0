/* SPDX-License-Identifier: MIT */
#include "bodies/plate/plate_modes.h"

#include <math.h>

#include "bodies/felt_ring.h"
#include "bodies/loaded_mode.h"
#include "bodies/plate/free_plate.h"
#include "math/eigen.h"
#include "math/portable_math.h"

static const double PI = 3.14159265358979323846;

/* Zeros of the basis, with which modes' masses are right to 0.4 % (edge modes of high order; others
 * to 0.1 %), as long as TB_TOP_ZERO does not end it. */
static const double BASIS_PER_LAMBDA = 2.0, BASIS_MORE = 40.0;
/* The highest lambda, in units of the highest zero: a bronze disc of 40 cm and 0.15 mm would reach
 * it above 17 kHz, but TbBodyLimits.modes ends thin plates earlier at draft and live. */
static const double MOST_OF_BASIS = 0.8;
/* Modes in vacuo up to here, in units of the highest lambda, make up those in air. */
static const double MARGIN = 1.15;

double tb_plate_stiffness(const TaborPlateDef *plate) {
  const double h = plate->thickness;
  return plate->youngs_modulus * h * h * h /
         (12.0 * (1.0 - plate->poisson_ratio * plate->poisson_ratio));
}

static double surface_density(const TaborPlateDef *plate) {
  return plate->density * plate->thickness;
}

/* lambda^2 over omega [s]: R^2 sqrt(rho h/D). */
static double square_per_omega(const TaborDrumDef *def) {
  return def->shell.radius * def->shell.radius *
         sqrt(surface_density(&def->plate) / tb_plate_stiffness(&def->plate));
}

static TaborStatus resolve(TaborDrumDef *def, const TbArena *beside, TaborError *error) {
  (void)def, (void)beside, (void)error;
  return TABOR_OK;
}

static void resolve_roughly(TaborDrumDef *def) { (void)def; }

static void sheets(const TaborDrumDef *def, TaborHeadDef sheet[TB_HEADS]) {
  for (uint32_t h = 0; h < TB_HEADS; h++) {
    sheet[h] = def->batter; /* has the damper and the ring that lie on the plate */
    sheet[h].tension = sheet[h].damping_k = sheet[h].damping_1 = 0.0;
    sheet[h].stretch_stiffness = sheet[h].unevenness = sheet[h].lug_spread = 0.0;
    for (uint32_t j = 0; j < TABOR_MAX_LUGS; j++) sheet[h].lug[j] = NAN;
    sheet[h].surface_density = surface_density(&def->plate);
    sheet[h].bending_stiffness = tb_plate_stiffness(&def->plate);
    sheet[h].damping_0 = def->plate.damping_0;
  }
}

/* About lambda^2/4 modes lie below lambda, copies counted. */
static double highest_lambda(const TaborDrumDef *def, double bandwidth, TbBodyLimits limits) {
  const double wanted = sqrt(2.0 * PI * bandwidth * square_per_omega(def));
  const double room = sqrt(4.0 * limits.modes) - 6.0; /* edge modes are some 3 lambda/2 more */
  const double most = fmin(room, MOST_OF_BASIS * TB_TOP_ZERO);
  return fmin(wanted, most);
}

static double basis(const TaborDrumDef *def, double bandwidth, TbBodyLimits limits,
                    double *reached) {
  const double lambda = highest_lambda(def, bandwidth, limits);
  *reached = fmin(bandwidth, lambda * lambda / (2.0 * PI * square_per_omega(def)));
  return fmin(BASIS_PER_LAMBDA * lambda + BASIS_MORE, TB_TOP_ZERO);
}

/* Data that the orders of a plate share. */
typedef struct Shared {
  const TaborDrumDef *def;
  double omega_per_square; /* of lambda [rad/s] */
  double limit;            /* [rad/s] */
  double top;              /* lambda of the modes in vacuo that are used */
} Shared;

/* The modes in vacuo of one order, and room for one in air. */
typedef struct Work {
  const Shared *shared;
  const TbAirOrder *air;
  uint32_t count;
  TbFreePlateMode *modes;
  double *mass, *stiffness, *loss; /* [count] M_k, K, and C/M without the loss factor */
  double *y;                       /* [count][air->count], with the edge's motion */
  const double *ring;
} Work;

static void find_own(const Work *w, uint32_t k) {
  const TaborDrumDef *def = w->shared->def;
  const TbFreePlateMode *mode = &w->modes[k];
  const double azimuth = w->air->m ? PI : 2.0 * PI, radius = def->shell.radius;
  const double mount = w->air->m ? def->plate.tilt_frequency : def->plate.heave_frequency;
  const bool rigid = mode->lambda == 0.0;
  const double omega =
    rigid ? 2.0 * PI * mount : w->shared->omega_per_square * mode->lambda * mode->lambda;
  w->mass[k] = azimuth * radius * radius * surface_density(&def->plate) * mode->square;
  w->stiffness[k] = w->mass[k] * omega * omega;
  w->loss[k] = rigid ? 2.0 * def->plate.mount_damping * omega : def->plate.damping_0;
  for (uint32_t i = 0; i < w->air->count; i++) {
    w->y[k * w->air->count + i] =
      tb_free_plate_amplitude(mode, w->air->zeros[i], w->air->slopes[i]) +
      mode->edge * tb_body_lift(w->air, i);
  }
}

static bool prepare_work(Work *w, TbArena *scratch) {
  const TaborDrumDef *def = w->shared->def;
  const uint32_t room = w->air->count + 2u;
  w->modes = tb_arena_take(scratch, room, sizeof *w->modes);
  if (!w->modes) return false;
  w->count =
    tb_free_plate_modes(w->air->m, def->plate.poisson_ratio, w->shared->top, w->modes, room);
  w->mass = tb_arena_doubles(scratch, w->count + 1u);
  w->stiffness = tb_arena_doubles(scratch, w->count + 1u);
  w->loss = tb_arena_doubles(scratch, w->count + 1u);
  w->y = tb_arena_doubles(scratch, (size_t)(w->count + 1u) * w->air->count);
  if (scratch->failed) return false;
  for (uint32_t k = 0; k < w->count; k++) find_own(w, k);
  return tb_felt_ring_matrix(&def->batter, def->shell.radius, scratch, w->air, &w->ring);
}

/* y_k^T A y_l, with A y_l in `loaded`. */
static double project(const Work *w, const double *loaded, uint32_t k) {
  double sum = 0.0;
  for (uint32_t i = 0; i < w->air->count; i++) sum += w->y[k * w->air->count + i] * loaded[i];
  return sum;
}

static bool add_air(const Work *w, TbArena *scratch, double *mass) {
  const uint32_t n = w->air->count;
  double *matrix = tb_arena_doubles(scratch, (size_t)n * n);
  double *loaded = tb_arena_doubles(scratch, n);
  if (scratch->failed || !tb_load_matrix(w->shared->def, scratch, w->air, n, matrix)) return false;
  for (uint32_t l = 0; l < w->count; l++) {
    for (uint32_t i = 0; i < n; i++) {
      loaded[i] = 0.0;
      for (uint32_t j = 0; j < n; j++) loaded[i] += matrix[(size_t)i * n + j] * w->y[l * n + j];
    }
    for (uint32_t k = 0; k < w->count; k++) mass[k * w->count + l] += project(w, loaded, k);
  }
  return true;
}

/* Modes at low frequency: amplitudes u of the modes in vacuo by rows, and omega^2. */
static TaborStatus solve(const Work *w, TbArena *scratch, double *squares, double *vectors) {
  const uint32_t n = w->count;
  double *mass = tb_arena_doubles(scratch, (size_t)n * n);
  double *stiffness = tb_arena_doubles(scratch, (size_t)n * n);
  if (scratch->failed) return TABOR_ERROR_MEMORY;
  for (uint32_t k = 0; k < n; k++) {
    mass[k * n + k] = w->mass[k];
    stiffness[k * n + k] = w->stiffness[k];
  }
  if (w->shared->def->air.density > 0.0 && !add_air(w, scratch, mass)) return TABOR_ERROR_MEMORY;
  if (tb_eigen_symmetric(scratch, n, stiffness, mass, squares, vectors)) return TABOR_OK;
  return scratch->failed ? TABOR_ERROR_MEMORY : TABOR_ERROR_NUMERICS;
}

/* The loss without its part that the loss factor gives, which depends on the frequency. */
static TbOwnParts own_parts(const Work *w, const double *u) {
  TbOwnParts own = {0.0, 0.0, 0.0};
  for (uint32_t k = 0; k < w->count; k++) {
    own.mass += u[k] * u[k] * w->mass[k];
    own.stiffness += u[k] * u[k] * w->stiffness[k];
    own.loss += u[k] * u[k] * w->mass[k] * w->loss[k];
  }
  return own;
}

/* The stiffness that bending has of a mode's. */
static double bending_part(const Work *w, const double *u) {
  double sum = 0.0;
  for (uint32_t k = 0; k < w->count; k++) {
    if (w->modes[k].lambda > 0.0) sum += u[k] * u[k] * w->stiffness[k];
  }
  return sum;
}

/* The mode in vacuo that moves most. */
static uint32_t strongest(const Work *w, const double *u) {
  uint32_t most = 0;
  for (uint32_t k = 1; k < w->count; k++) {
    if (u[k] * u[k] * w->mass[k] > u[most] * u[most] * w->mass[most]) most = k;
  }
  return most;
}

/* The Bessel amplitudes of a mode without its edge's motion, and that. */
static double keep_vector(const Work *w, const double *u, double *kept) {
  double edge = 0.0;
  for (uint32_t k = 0; k < w->count; k++) edge += u[k] * w->modes[k].edge;
  for (uint32_t i = 0; i < w->air->count; i++) {
    kept[i] = -edge * tb_body_lift(w->air, i);
    for (uint32_t k = 0; k < w->count; k++) kept[i] += u[k] * w->y[k * w->air->count + i];
  }
  return edge;
}

static bool finish_mode(const Work *w, TbArena *scratch, double square, double *u, double *kept,
                        double *edge, TbBodyMode *mode) {
  const TaborDrumDef *def = w->shared->def;
  double *y = tb_arena_doubles(scratch, w->air->count);
  if (!y) return false;
  *edge = keep_vector(w, u, kept);
  for (uint32_t i = 0; i < w->air->count; i++) y[i] = kept[i] + *edge * tb_body_lift(w->air, i);
  const TbOwnParts own = own_parts(w, u);
  TbAirParts load;
  mode->omega = sqrt(square);
  if (!tb_load_mode(def, scratch, w->air, &own, y, mode, &load)) return false;
  const double total = own.mass + load.mass, unit = 1.0 / sqrt(total);
  for (uint32_t i = 0; i < w->air->count; i++) kept[i] *= unit;
  for (uint32_t i = 0; i < 2 * TABOR_MAX_MICS; i++) mode->fields[i] *= unit;
  *edge *= unit;
  if (!def->quality.losses) return true;
  const double loss = own.loss + tb_felt_ring_loss(w->ring, w->air->count, y) +
                      def->plate.loss * bending_part(w, u) / mode->omega;
  mode->radiation_rate = 0.5 * fmax(0.0, load.resistance) / total;
  mode->decay_rate = 0.5 * loss / total + mode->radiation_rate;
  return true;
}

static TaborStatus finish_modes(const Work *w, TbArena *arena, const double *squares,
                                double *vectors, TbBodyOrder *order, TbBodyMode *modes,
                                uint32_t room) {
  for (uint32_t k = 0; k < w->count && order->mode_count < room; k++) {
    if (!(squares[k] <= w->shared->limit * w->shared->limit)) break;
    const uint32_t place = order->mode_count;
    TbBodyMode *mode = &modes[place];
    double *u = vectors + (size_t)k * w->count;
    *mode = (TbBodyMode){
      .m = order->m, .n = strongest(w, u), .index = k, .place = place, .part = TABOR_PART_PLATE};
    TbArena one;
    tb_arena_beside(&one, arena);
    const bool finished =
      finish_mode(w, &one, squares[k], u, order->vectors[0] + (size_t)place * w->air->count,
                  &order->edge[place], mode);
    tb_arena_release(&one);
    if (!finished) return TABOR_ERROR_MEMORY;
    order->mode_count++;
  }
  return TABOR_OK;
}

static TaborStatus build_order(const void *context, TbArena *arena, TbArena *scratch,
                               const TbAirOrder *air, TbBodyOrder *order, TbBodyMode *modes,
                               uint32_t room) {
  Work w = {.shared = context, .air = air};
  if (!prepare_work(&w, scratch)) return TABOR_ERROR_MEMORY;
  if (w.count == 0) return TABOR_OK;
  double *squares = tb_arena_doubles(scratch, w.count);
  double *vectors = tb_arena_doubles(scratch, (size_t)w.count * w.count);
  order->vectors[0] = tb_arena_doubles(arena, (size_t)w.count * air->count);
  order->edge = tb_arena_doubles(arena, w.count);
  if (arena->failed || scratch->failed) return TABOR_ERROR_MEMORY;
  const TaborStatus status = solve(&w, scratch, squares, vectors);
  if (status != TABOR_OK) return status;
  return finish_modes(&w, arena, squares, vectors, order, modes, room);
}

static TaborStatus prepare(TbBody *body, TbArena *arena, const TaborDrumDef *def, double bandwidth,
                           TbBodyLimits limits) {
  *body = (TbBody){
    .surfaces = 1, .most_modes = limits.modes, .radius = def->shell.radius, .free_edge = true};
  sheets(def, body->sheet);
  const double basis_top = basis(def, bandwidth, limits, &body->bandwidth);
  const Shared shared = {.def = def,
                         .omega_per_square = 1.0 / square_per_omega(def),
                         .limit = 2.0 * PI * body->bandwidth,
                         .top = MARGIN * highest_lambda(def, bandwidth, limits)};
  return tb_body_build_orders(body, arena, basis_top, (uint32_t)shared.top + 3u, build_order,
                              &shared);
}

/* Modes in air take sums over their Bessel functions, as those of an open head: see
 * bodies/drum/drum_cost.c. */
static TbBodyCost cost(const TaborDrumDef *def, const TaborDrumDef *resolved, double basis_top,
                       double bandwidth, uint32_t most_modes) {
  (void)def;
  const double square = 2.0 * PI * bandwidth * square_per_omega(resolved);
  const double modes = fmin(most_modes, 0.25 * square + 1.5 * sqrt(square) + 3.0);
  const bool air = resolved->air.density > 0.0;
  return (TbBodyCost){.modes = modes, .prepare = 1e-3 + (air ? 1e-6 : 1e-7) * modes * basis_top};
}

const TbBodyKind tb_body_plate = {.resolve = resolve,
                                  .resolve_roughly = resolve_roughly,
                                  .sheets = sheets,
                                  .cost = cost,
                                  .basis = basis,
                                  .prepare = prepare,
                                  .all_two_way = true};
