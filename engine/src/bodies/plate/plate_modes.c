/* SPDX-License-Identifier: MIT */
#include "bodies/plate/plate_modes.h"

#include <math.h>

#include "bodies/felt_ring.h"
#include "bodies/loaded_mode.h"
#include "bodies/plate/disc_modes.h"
#include "bodies/plate/plate_forms.h"
#include "bodies/plate/plate_profile.h"
#include "bodies/plate/plate_stress.h"
#include "math/draw.h"
#include "math/eigen.h"
#include "math/portable_math.h"

static const double PI = 3.14159265358979323846;

/* Zeros of the basis, with which modes' masses are right to 0.4 % (edge modes of high order; others
 * to 0.1 %), as long as TB_TOP_ZERO does not end it. */
static const double BASIS_PER_LAMBDA = 2.0, BASIS_MORE = 40.0;
/* The highest lambda, in units of the highest zero: a bronze disc of 40 cm and 0.15 mm would reach
 * it above 17 kHz, but TbBodyLimits.modes ends thin plates earlier at draft and live. */
static const double MOST_OF_BASIS = 0.8;
/* Modes of the flat disc up to here, in units of the highest lambda, make up those of the plate in
 * air. */
static const double MARGIN = 1.15;

double tb_plate_stiffness(const TaborPlateDef *plate, double thickness) {
  return plate->youngs_modulus * thickness * thickness * thickness /
         (12.0 * (1.0 - plate->poisson_ratio * plate->poisson_ratio));
}

/* lambda^2 over omega of a flat disc [s]: R^2 sqrt(rho h/D). */
static double square_per_omega(const TaborDrumDef *def, double thickness) {
  return def->shell.radius * def->shell.radius *
         sqrt(def->plate.density * thickness / tb_plate_stiffness(&def->plate, thickness));
}

/* The mean over the area. */
static double mean_thickness(const TaborPlateDef *plate) {
  return plate->thickness * (1.0 + (plate->taper - 1.0) * 2.0 / 3.0);
}

/* Waves are shortest there. */
static double least_thickness(const TaborPlateDef *plate) {
  return plate->thickness * fmin(1.0, plate->taper);
}

static TaborStatus resolve(TaborDrumDef *def, const TbArena *beside, TaborError *error) {
  (void)def, (void)beside, (void)error;
  return TABOR_OK;
}

static void resolve_roughly(TaborDrumDef *def) { (void)def; }

/* Plates of a body: a hi-hat has two. */
static uint32_t plates_of(const TaborDrumDef *def) {
  return def->body.kind == TABOR_BODY_HIHAT ? 2u : 1u;
}

/* The definition of one plate by itself. */
static TaborDrumDef definition_of(const TaborDrumDef *def, uint32_t surface) {
  TaborDrumDef own = *def;
  if (surface == 0) return own;
  own.plate = def->bottom;
  own.batter = def->resonant; /* has the damper and the ring that lie on the plate: none */
  return own;
}

static void sheets(const TaborDrumDef *body, TaborHeadDef sheet[TB_HEADS]) {
  for (uint32_t h = 0; h < TB_HEADS; h++) {
    const TaborDrumDef own = definition_of(body, h), *def = &own;
    sheet[h] = def->batter; /* has the damper and the ring that lie on the plate */
    sheet[h].tension = sheet[h].damping_k = sheet[h].damping_1 = 0.0;
    sheet[h].stretch_stiffness = sheet[h].unevenness = sheet[h].lug_spread = 0.0;
    for (uint32_t j = 0; j < TABOR_MAX_LUGS; j++) sheet[h].lug[j] = NAN;
    sheet[h].surface_density = def->plate.density * mean_thickness(&def->plate);
    sheet[h].bending_stiffness = tb_plate_stiffness(&def->plate, mean_thickness(&def->plate));
    sheet[h].damping_0 = def->plate.damping_0;
  }
}

/* About lambda^2/4 modes lie below lambda, copies counted. */
static double highest_lambda(const TaborDrumDef *def, double bandwidth, TbBodyLimits limits) {
  const double shortest = square_per_omega(def, least_thickness(&def->plate));
  const double wanted = sqrt(2.0 * PI * bandwidth * shortest);
  const double modes = (double)limits.modes / plates_of(def);
  const double room = sqrt(4.0 * modes) - 6.0; /* edge modes are some 3 lambda/2 more */
  const double most = fmin(room, MOST_OF_BASIS * TB_TOP_ZERO);
  return fmin(wanted, most);
}

static double basis(const TaborDrumDef *body, double bandwidth, TbBodyLimits limits,
                    double *reached) {
  double most = 0.0;
  *reached = bandwidth;
  for (uint32_t s = 0; s < plates_of(body); s++) {
    const TaborDrumDef def = definition_of(body, s);
    const double lambda = highest_lambda(&def, bandwidth, limits);
    const double shortest = square_per_omega(&def, least_thickness(&def.plate));
    *reached = fmin(*reached, lambda * lambda / (2.0 * PI * shortest));
    most = fmax(most, lambda);
  }
  return fmin(BASIS_PER_LAMBDA * most + BASIS_MORE, TB_TOP_ZERO);
}

/* Data that the orders of a plate share. */
typedef struct Shared {
  TaborDrumDef def; /* of this plate by itself */
  uint32_t surface;
  TbPlatePoints points;
  double limit;         /* [rad/s] */
  double top;           /* lambda of the disc's modes that are used */
  double coupled;       /* lambda of the modes that large deflections couple */
  TbMembrane *membrane; /* of the body */
} Shared;

/* The plates of a body. */
typedef struct Plates {
  uint32_t count;
  Shared plate[TB_HEADS];
} Plates;

/* The flat disc's modes of one order, what a plate in vacuo is in them, and room for one in air. */
typedef struct Work {
  const Shared *shared;
  const TbAirOrder *air;
  uint32_t count; /* of the disc's modes */
  TbPlateForms forms;
  /* [1/(kg s2), 1/(kg s)]: of the momentum in the rigid motion. */
  double mount_stiffness, mount_loss;
  double foot; /* [1/s2]: force per momentum when the foot of the mount rises */
  double *y;   /* [count][air->count], with the edge's motion */
  const double *ring;
} Work;

static void find_series(const Work *w, uint32_t k) {
  for (uint32_t i = 0; i < w->air->count; i++) {
    w->y[k * w->air->count + i] =
      tb_disc_amplitude(&w->forms.modes[k], w->air->zeros[i], w->air->slopes[i]) +
      w->forms.modes[k].edge * tb_body_lift(w->air, i);
  }
}

/* The mount acts on the rigid motion, the first mode of m < 2: by the momentum in it, in which bent
 * modes have no part. */
static void hold_middle(Work *w) {
  const TaborPlateDef *plate = &w->shared->def.plate;
  if (w->air->m >= 2 || w->count == 0) return;
  const double omega = 2.0 * PI * (w->air->m ? plate->tilt_frequency : plate->heave_frequency);
  w->mount_stiffness = omega * omega / w->forms.mass[0];
  w->foot = w->air->m == 0 && w->shared->surface == 0 ? omega * omega : 0.0;
  w->mount_loss = (2.0 * plate->mount_damping * omega - plate->damping_0) / w->forms.mass[0];
}

static TaborStatus prepare_work(Work *w, TbArena *scratch) {
  const Shared *shared = w->shared;
  const TaborDrumDef *def = &shared->def;
  const uint32_t m = w->air->m, room = w->air->count + 2u;
  const double stressed =
    tb_plate_is_flat(&def->plate) ? tb_plate_stress_top(shared->coupled) : shared->top;
  const TaborStatus status = tb_plate_forms(def, &shared->points, w->air->table, m, shared->top,
                                            stressed, room, scratch, &w->forms);
  if (status != TABOR_OK) return status;
  w->count = w->forms.count;
  w->y = tb_arena_doubles(scratch, (size_t)(w->count + 1u) * w->air->count);
  if (!w->y) return TABOR_ERROR_MEMORY;
  hold_middle(w);
  for (uint32_t k = 0; k < w->count; k++) find_series(w, k);
  const bool found =
    tb_felt_ring_matrix(&def->batter, def->shell.radius, scratch, w->air, &w->ring);
  return found ? TABOR_OK : TABOR_ERROR_MEMORY;
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
  if (scratch->failed || !tb_load_matrix(&w->shared->def, scratch, w->air, n, matrix)) return false;
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
  for (size_t i = 0; i < (size_t)n * n; i++) {
    mass[i] = w->forms.mass[i];
    stiffness[i] = w->forms.stiffness[i];
  }
  for (uint32_t k = 0; k < n; k++) {
    for (uint32_t l = 0; l < n; l++) {
      stiffness[k * n + l] += w->mount_stiffness * w->forms.mass[k] * w->forms.mass[l];
    }
  }
  if (w->shared->def.air.density > 0.0 && !add_air(w, scratch, mass)) return TABOR_ERROR_MEMORY;
  if (tb_eigen_symmetric(scratch, n, stiffness, mass, squares, vectors)) return TABOR_OK;
  return scratch->failed ? TABOR_ERROR_MEMORY : TABOR_ERROR_NUMERICS;
}

static double form(uint32_t n, const double *matrix, const double *u) {
  double sum = 0.0;
  for (uint32_t k = 0; k < n; k++) {
    for (uint32_t l = 0; l < n; l++) sum += u[k] * matrix[(size_t)k * n + l] * u[l];
  }
  return sum;
}

/* The momentum in the rigid motion. */
static double momentum(const Work *w, const double *u) {
  double sum = 0.0;
  for (uint32_t k = 0; k < w->count; k++) sum += w->forms.mass[k] * u[k];
  return sum;
}

/* A mode's share of the plate itself, and of the loss without the part that the loss factor gives,
 * which depends on the frequency. */
static TbOwnParts own_parts(const Work *w, double stiffness, const double *u) {
  double rigid = momentum(w, u);
  rigid *= rigid;
  const double mass = form(w->count, w->forms.mass, u);
  return (TbOwnParts){.mass = mass,
                      .stiffness = stiffness + rigid * w->mount_stiffness,
                      .loss = w->shared->def.plate.damping_0 * mass + rigid * w->mount_loss};
}

/* The disc's mode that moves most. */
static uint32_t strongest(const Work *w, const double *u) {
  uint32_t most = 0;
  double weight = 0.0;
  for (uint32_t k = 0; k < w->count; k++) {
    const double own = u[k] * u[k] * w->forms.mass[(size_t)k * w->count + k];
    if (own > weight) most = k;
    weight = fmax(weight, own);
  }
  return most;
}

/* The Bessel amplitudes of a mode without its edge's motion, and that. */
static double keep_vector(const Work *w, const double *u, double *kept) {
  double edge = 0.0;
  for (uint32_t k = 0; k < w->count; k++) edge += u[k] * w->forms.modes[k].edge;
  for (uint32_t i = 0; i < w->air->count; i++) {
    kept[i] = -edge * tb_body_lift(w->air, i);
    for (uint32_t k = 0; k < w->count; k++) kept[i] += u[k] * w->y[k * w->air->count + i];
  }
  return edge;
}

static bool finish_mode(const Work *w, TbArena *scratch, double square, double *u, double *kept,
                        double *edge, TbBodyMode *mode) {
  const TaborDrumDef *def = &w->shared->def;
  double *y = tb_arena_doubles(scratch, w->air->count);
  if (!y) return false;
  *edge = keep_vector(w, u, kept);
  for (uint32_t i = 0; i < w->air->count; i++) y[i] = kept[i] + *edge * tb_body_lift(w->air, i);
  const double stiffness = form(w->count, w->forms.stiffness, u);
  const TbOwnParts own = own_parts(w, stiffness, u);
  TbAirParts load;
  mode->omega = sqrt(square);
  if (!tb_load_mode(def, scratch, w->air, &own, y, mode, &load)) return false;
  const double total = own.mass + load.mass, unit = 1.0 / sqrt(total);
  for (uint32_t i = 0; i < w->air->count; i++) kept[i] *= unit;
  for (uint32_t i = 0; i < 2 * TABOR_MAX_MICS; i++) mode->fields[i] *= unit;
  for (uint32_t k = 0; k < w->count; k++) u[k] *= unit;
  *edge *= unit;
  mode->rod = w->foot * momentum(w, u);
  if (!def->quality.losses) return true;
  const double loss = own.loss + tb_felt_ring_loss(w->ring, w->air->count, y) +
                      def->plate.loss * stiffness / mode->omega;
  mode->radiation_rate = 0.5 * fmax(0.0, load.resistance) / total;
  mode->decay_rate = 0.5 * loss / total + mode->radiation_rate;
  return true;
}

/* Appends the modes of one plate to those of the order. */
static TaborStatus finish_modes(const Work *w, TbArena *arena, const double *squares,
                                double *vectors, TbBodyOrder *order, TbBodyMode *modes,
                                uint32_t room) {
  const uint32_t surface = w->shared->surface;
  for (uint32_t k = 0; k < w->count && order->mode_count < room; k++) {
    if (!(squares[k] <= w->shared->limit * w->shared->limit)) break;
    const uint32_t place = order->mode_count;
    TbBodyMode *mode = &modes[place];
    double *u = vectors + (size_t)k * w->count;
    *mode = (TbBodyMode){.m = order->m,
                         .n = strongest(w, u),
                         .split = w->shared->def.plate.splitting * tb_draw(order->m, k),
                         .index = place,
                         .place = place,
                         .part = surface ? TABOR_PART_BOTTOM : TABOR_PART_PLATE};
    TbArena one;
    tb_arena_beside(&one, arena);
    const bool finished =
      finish_mode(w, &one, squares[k], u, order->vectors[surface] + (size_t)place * w->air->count,
                  &order->edge[surface][place], mode);
    tb_arena_release(&one);
    if (!finished) return TABOR_ERROR_MEMORY;
    order->mode_count++;
  }
  return TABOR_OK;
}

/* The first modes of an order, which large deflections couple. */
static uint32_t coupled_modes(const Work *w, const TbBodyMode *modes, uint32_t count) {
  uint32_t coupled = 0;
  while (coupled < count && modes[coupled].omega < w->shared->membrane->top) coupled++;
  return coupled;
}

/* Modes of one plate of order `air->m`; the order has room for those of all. */
static TaborStatus build_plate(Work *w, TbArena *arena, TbArena *scratch, TbBodyOrder *order,
                               TbBodyMode *modes, uint32_t room) {
  if (w->count == 0) return TABOR_OK;
  const uint32_t first = order->mode_count;
  double *squares = tb_arena_doubles(scratch, w->count);
  double *vectors = tb_arena_doubles(scratch, (size_t)w->count * w->count);
  if (scratch->failed) return TABOR_ERROR_MEMORY;
  TaborStatus status = solve(w, scratch, squares, vectors);
  if (status == TABOR_OK) status = finish_modes(w, arena, squares, vectors, order, modes, room);
  const bool couples = w->shared->coupled > 0.0 && w->air->m < w->shared->membrane->order_count;
  if (status != TABOR_OK || !couples) return status;
  return tb_plate_stress_order(&w->shared->def, w->air->table, w->shared->coupled, w->air->m,
                               &w->forms,
                               coupled_modes(w, modes + first, order->mode_count - first), vectors,
                               arena, scratch, w->shared->membrane);
}

static TaborStatus build_order(const void *context, TbArena *arena, TbArena *scratch,
                               const TbAirOrder *air, TbBodyOrder *order, TbBodyMode *modes,
                               uint32_t room) {
  const Plates *plates = context;
  Work work[TB_HEADS];
  uint32_t most = 0;
  for (uint32_t s = 0; s < plates->count; s++) {
    work[s] = (Work){.shared = &plates->plate[s], .air = air};
    const TaborStatus status = prepare_work(&work[s], scratch);
    if (status != TABOR_OK) return status;
    most += work[s].count;
  }
  if (most == 0) return TABOR_OK;
  for (uint32_t s = 0; s < plates->count; s++) {
    order->vectors[s] = tb_arena_doubles(arena, (size_t)most * air->count);
    order->edge[s] = tb_arena_doubles(arena, most);
  }
  if (arena->failed) return TABOR_ERROR_MEMORY;
  TaborStatus status = TABOR_OK;
  for (uint32_t s = 0; s < plates->count && status == TABOR_OK; s++) {
    status = build_plate(&work[s], arena, scratch, order, modes, room);
  }
  return status;
}

/* The lower plate of a hi-hat is linear. */
static bool bends_far(const TaborDrumDef *def, uint32_t surface) {
  return surface == 0 && def->plate.large_deflections > 0.0;
}

static void prepare_shared(Shared *shared, const TaborDrumDef *def, uint32_t surface,
                           TbBodyLimits limits, TbBody *body) {
  *shared = (Shared){.def = definition_of(def, surface),
                     .surface = surface,
                     .limit = 2.0 * PI * body->bandwidth,
                     .coupled = bends_far(def, surface) ? limits.coupled : 0.0,
                     .membrane = &body->membrane};
  shared->top = MARGIN * highest_lambda(&shared->def, body->bandwidth, limits);
}

static bool prepare_membrane(TbBody *body, TbArena *arena, const Shared *shared) {
  if (shared->coupled == 0.0) return true;
  const TaborDrumDef *def = &shared->def;
  body->membrane.top =
    shared->coupled * shared->coupled / square_per_omega(def, mean_thickness(&def->plate));
  const uint32_t orders = (uint32_t)shared->coupled + 1u;
  return tb_plate_stress_begin(def, shared->coupled, orders, arena, &body->membrane);
}

static TaborStatus prepare(TbBody *body, TbArena *arena, const TaborDrumDef *def, double bandwidth,
                           TbBodyLimits limits) {
  Plates plates = {.count = plates_of(def)};
  *body = (TbBody){.surfaces = plates.count,
                   .most_modes = limits.modes,
                   .radius = def->shell.radius,
                   .free_edge = true};
  sheets(def, body->sheet);
  const double basis_top = basis(def, bandwidth, limits, &body->bandwidth);
  TbArena scratch;
  tb_arena_beside(&scratch, arena);
  double top = 0.0;
  bool done = true;
  for (uint32_t s = 0; s < plates.count; s++) {
    Shared *shared = &plates.plate[s];
    prepare_shared(shared, def, s, limits, body);
    top = fmax(top, shared->top);
    done = done && prepare_membrane(body, arena, shared) &&
           tb_plate_points(&shared->def, shared->top, &scratch, &shared->points);
  }
  const TaborStatus status =
    done ? tb_body_build_orders(body, arena, basis_top, (uint32_t)top + 3u, build_order, &plates)
         : TABOR_ERROR_MEMORY;
  tb_arena_release(&scratch);
  return status;
}

/* Modes in air take sums over their Bessel functions, as those of an open head: see
 * bodies/drum/drum_cost.c. */
static TbBodyCost cost(const TaborDrumDef *asked, const TaborDrumDef *resolved, double basis_top,
                       double bandwidth, uint32_t most_modes) {
  (void)asked;
  const bool air = resolved->air.density > 0.0;
  double modes = 0.0;
  for (uint32_t s = 0; s < plates_of(resolved); s++) {
    const TaborDrumDef def = definition_of(resolved, s);
    const double square = 2.0 * PI * bandwidth * square_per_omega(&def, mean_thickness(&def.plate));
    modes += 0.25 * square + 1.5 * sqrt(square) + 3.0;
  }
  modes = fmin(most_modes, modes);
  return (TbBodyCost){.modes = modes, .prepare = 1e-3 + (air ? 1e-6 : 1e-7) * modes * basis_top};
}

const TbBodyKind tb_body_plate = {.resolve = resolve,
                                  .resolve_roughly = resolve_roughly,
                                  .sheets = sheets,
                                  .cost = cost,
                                  .basis = basis,
                                  .prepare = prepare,
                                  .all_two_way = true};
