/* SPDX-License-Identifier: MIT */
#include "acoustics/closed_drum_modes.h"

#include <math.h>

#include "acoustics/cavity_pressure.h"
#include "definition/definition.h"

static const double PI = 3.14159265358979323846;

/* Cavity modes are kept as coordinates up to this many times the frequency of the slower head's first mode
 * in vacuo: those of its modes that feel the cavity are then right to 0.2 %. */
static const double COORDINATES = 24.0;
/* ... and between two heads at least to this many times the highest frequency of all modes: air that rings
 * up to somewhere below would end there with an edge that is seen and heard. A kettle is a bowl, not the
 * cylinder that stands for it here, and its higher modes are not those of one. */
static const double MARGIN = 1.1;
/* Bessel functions of the cavity beyond this many times the heads' last one carry no mass. */
static const double CAVITY_BASIS = 2.0;
/* A mode of which less than this part of the energy moves a head is not heard or felt. */
static const double LEAST_HEAD = 1e-4;
/* One head's mode: the other has less than this part of the heads' energy. */
static const double ONE_HEAD = 0.1;

/* Sound from all directions that hard wood absorbs, 250 Hz to 4 kHz: 0.04 to 0.07 in tables of rooms
 * [Kuttruff, Kinsler]. */
static const double WOOD = 0.05;

typedef struct Enclosed {
  const TaborDrumDef *def;
  TbCavityEigen drum;
  const TbAirOrder *air;
  TbCavityOrder cavity;
  TbCavityMics inside;
  double azimuth; /* a_m */
} Enclosed;

/* A shell between two heads is taken for wood, a kettle for metal, which absorbs next to nothing. */
static double side_admittance(const TaborDrumDef *def) {
  return tb_is_two_headed(def) ? WOOD / 8.0 : 0.0;
}

TbCavity tb_closed_drum_cavity(const TaborDrumDef *def) {
  const bool two = tb_is_two_headed(def);
  return (TbCavity){
    .radius = def->shell.radius,
    .depth = def->shell.depth,
    .density = def->air.density,
    .sound_speed = def->air.sound_speed,
    .heads = two ? 2 : 1,
    .admittance = side_admittance(def),
    .head_density = {def->batter.surface_density, two ? def->resonant.surface_density : 0.0}};
}

static TbCavityEigen coupled_of(const TaborDrumDef *def) {
  const bool two = tb_is_two_headed(def);
  return (TbCavityEigen){.cavity = tb_closed_drum_cavity(def),
                         .heads = {&def->batter, two ? &def->resonant : NULL},
                         .outside = def->air.density};
}

static double first_frequency(const TbCavityEigen *drum) {
  const double wavenumber = 2.4048 / drum->cavity.radius;
  double slowest = INFINITY;
  for (uint32_t h = 0; h < drum->cavity.heads; h++) {
    const double square =
      tb_head_stiffness(drum->heads[h], wavenumber) / drum->heads[h]->surface_density;
    slowest = fmin(slowest, sqrt(square));
  }
  return slowest;
}

static double highest_coordinate(const TbCavityEigen *drum, double limit) {
  const double near = COORDINATES * first_frequency(drum);
  return drum->cavity.heads == 2 ? fmax(near, MARGIN * limit) : near;
}

/* ---- how many modes there are ---------------------------------------------------------------- */

/* Of a head by itself with the air's mass rho0/K on each side: about z^2/4 - z/2 lie below the zero z. */
static double head_modes_below(const TbCavityEigen *drum, const TaborHeadDef *head, double omega) {
  double lo = 0.0, hi = 1000.0;
  for (int i = 0; i < 50; i++) {
    const double z = 0.5 * (lo + hi), wavenumber = z / drum->cavity.radius;
    const double mass = head->surface_density + 2.0 * drum->outside / wavenumber;
    if (tb_head_stiffness(head, wavenumber) < omega * omega * mass) {
      lo = z;
    } else {
      hi = z;
    }
  }
  return fmax(0.0, 0.25 * lo * lo - 0.5 * lo);
}

/* Weyl's count for rigid walls, V k^3/(6 pi^2) + S k^2/(16 pi) [Kuttruff]. */
static double cavity_modes_below(const TbCavity *cavity, double omega) {
  const double k = omega / cavity->sound_speed, area = PI * cavity->radius * cavity->radius;
  const double surface = 2.0 * area + 2.0 * PI * cavity->radius * cavity->depth;
  return k * k * (area * cavity->depth * k / (6.0 * PI * PI) + surface / (16.0 * PI));
}

/* The numbers are right to 1 %: so many fit. */
static const double FITTING = 0.99 * TB_MAX_MODES;

static double modes_below(const TbCavityEigen *drum, double omega) {
  return head_modes_below(drum, drum->heads[0], omega) +
         head_modes_below(drum, drum->heads[1], omega) + cavity_modes_below(&drum->cavity, omega);
}

double tb_closed_drum_bandwidth(const TaborDrumDef *def, double bandwidth) {
  const TbCavityEigen drum = coupled_of(def);
  if (modes_below(&drum, 2.0 * PI * bandwidth) <= FITTING) return bandwidth;
  double lo = 0.0, hi = bandwidth;
  for (int i = 0; i < 50; i++) {
    const double middle = 0.5 * (lo + hi);
    if (modes_below(&drum, 2.0 * PI * middle) <= FITTING) {
      lo = middle;
    } else {
      hi = middle;
    }
  }
  return lo;
}

/* ---- one mode -------------------------------------------------------------------------------- */

/* What a mode's parts carry: masses of the heads themselves, and their loss, v^T C v. */
typedef struct Parts {
  double head_mass[TB_HEADS], cavity_mass;
  double head_loss;
  uint32_t strongest;       /* Bessel function that moves most, of either head */
  double largest[TB_HEADS]; /* upward amplitude of each head's strongest function, mass-weighted */
} Parts;

static void add_head_parts(const Enclosed *e, uint32_t h, const double *v, Parts *parts) {
  const TaborHeadDef *head = e->drum.heads[h];
  const double radius = e->drum.cavity.radius;
  for (uint32_t i = 0; i < e->air->count; i++) {
    const double wavenumber = e->air->zeros[i] / radius;
    const double norm = e->azimuth * radius * radius * 0.5 * e->air->slopes[i] * e->air->slopes[i];
    const double mass = norm * head->surface_density * v[i] * v[i];
    parts->head_mass[h] += mass;
    parts->head_loss += mass * (head->damping_0 + head->damping_1 * wavenumber * wavenumber);
    const double size = sqrt(mass);
    if (size <= fabs(parts->largest[h])) continue;
    parts->largest[h] = v[i] < 0.0 ? -size : size;
    if (size >= fmax(fabs(parts->largest[0]), fabs(parts->largest[1]))) parts->strongest = i;
  }
}

/* v: upward amplitudes of the heads, then cavity coordinates. */
static Parts parts_of(const Enclosed *e, const double *v) {
  Parts parts = {.strongest = 0};
  const uint32_t heads = e->drum.cavity.heads, n = e->air->count;
  for (uint32_t h = 0; h < heads; h++) add_head_parts(e, h, v + h * n, &parts);
  for (uint32_t c = 0; c < e->cavity.mode_count; c++) {
    const double u = v[heads * n + c];
    parts.cavity_mass += u * u;
  }
  return parts;
}

static uint32_t part_name(const Parts *parts) {
  const double heads = parts->head_mass[0] + parts->head_mass[1];
  if (parts->cavity_mass > 0.5) return TABOR_PART_CAVITY;
  if (parts->head_mass[1] < ONE_HEAD * heads) return TABOR_PART_BATTER;
  if (parts->head_mass[0] < ONE_HEAD * heads) return TABOR_PART_RESONANT;
  return TABOR_PART_BOTH;
}

/* Resistance and sound outside; `outward` holds the outward amplitudes of both heads. */
static bool radiate(const Enclosed *e, TbArena *scratch, const double *outward, TbHeadMode *mode) {
  const TaborDrumDef *def = e->def;
  const double radius = def->shell.radius, density = def->air.density;
  if (density == 0.0) return true;
  TbAirPoint points[TABOR_MAX_MICS];
  uint32_t mics[TABOR_MAX_MICS];
  const uint32_t mic_count = tb_mics_outside(def, mics);
  for (uint32_t p = 0; p < mic_count; p++) {
    const TaborMicDef *mic = &def->mic[mics[p]];
    points[p] = (TbAirPoint){mic->radius / radius, mic->height / radius};
  }
  double resistance, fields[2 * TABOR_MAX_MICS];
  const uint32_t heads = e->drum.cavity.heads;
  if (!tb_air_drum_load(e->air, scratch, outward, heads > 1 ? outward + e->air->count : NULL,
                        def->shell.depth / radius, mode->omega * radius / def->air.sound_speed,
                        points, mic_count, &resistance, fields)) {
    return false;
  }
  for (uint32_t p = 0; p < mic_count; p++) {
    mode->fields[2 * mics[p]] = fields[2 * p];
    mode->fields[2 * mics[p] + 1] = fields[2 * p + 1];
  }
  mode->radiation_rate =
    0.5 * fmax(0.0, resistance) * e->azimuth * density * def->air.sound_speed * radius * radius;
  return true;
}

/* Losses of a mode whose radiation is known. */
static void add_losses(const Enclosed *e, const Parts *parts, const double *outward,
                       const double *coordinates, TbHeadMode *mode) {
  if (e->def->quality.losses == 0) {
    mode->radiation_rate = 0.0;
    return;
  }
  mode->shell_rate =
    tb_cavity_wall_power(&e->cavity, &e->drum.cavity, e->air, outward, coordinates, mode->omega) /
    (mode->omega * mode->omega); /* P/(2E), E = omega^2/2 */
  mode->decay_rate = 0.5 * parts->head_loss + mode->shell_rate + mode->radiation_rate;
}

static bool finish_mode(const Enclosed *e, const Parts *parts, TbArena *scratch,
                        const double *outward, const double *coordinates, TbHeadMode *mode) {
  mode->n = parts->strongest + 1;
  mode->part = part_name(parts);
  const double both = parts->largest[0] * parts->largest[1];
  mode->phase = both > 0.0 ? 1 : (both < 0.0 ? -1 : 0);
  if (!radiate(e, scratch, outward, mode)) return false;
  add_losses(e, parts, outward, coordinates, mode);
  if (e->inside.count > 0) {
    tb_cavity_fields(&e->inside, &e->cavity, &e->drum.cavity, e->air, outward, coordinates,
                     mode->omega, mode->decay_rate, mode->fields);
  }
  return true;
}

/* Keeps what moves a head, up to `limit`; `vectors` are outward, the order's upward. */
static TaborStatus keep_modes(const Enclosed *e, TbArena *arena, const double *eigenvalues,
                              double *vectors, double limit, TbHeadOrder *order, TbHeadMode *modes,
                              uint32_t room) {
  const uint32_t n = e->air->count, heads = e->drum.cavity.heads;
  const uint32_t size = tb_cavity_eigen_size(&e->cavity, &e->drum, e->air);
  double outward[2 * TB_MAX_ZEROS];
  for (uint32_t k = 0; k < size && order->mode_count < room; k++) {
    if (!(eigenvalues[k] <= limit * limit)) break;
    double *v = vectors + (size_t)k * size;
    for (uint32_t i = 0; i < heads * n; i++) outward[i] = v[i];
    for (uint32_t i = n; i < heads * n; i++) v[i] = -v[i]; /* the lower head's upward */
    const Parts parts = parts_of(e, v);
    if (parts.head_mass[0] + parts.head_mass[1] < LEAST_HEAD) continue;
    TbHeadMode *mode = &modes[order->mode_count];
    *mode = (TbHeadMode){.m = order->m, .index = k, .omega = sqrt(eigenvalues[k])};
    mode->place = order->mode_count;
    TbArena one;
    tb_arena_prepare(&one, &arena->allocator);
    const bool finished = finish_mode(e, &parts, &one, outward, v + heads * n, mode);
    tb_arena_release(&one);
    if (!finished) return TABOR_ERROR_MEMORY;
    for (uint32_t h = 0; h < heads; h++) {
      double *kept = order->vectors[h] + (size_t)order->mode_count * n;
      for (uint32_t i = 0; i < n; i++) kept[i] = v[h * n + i];
    }
    order->mode_count++;
  }
  return TABOR_OK;
}

TaborStatus tb_closed_drum_order(const TaborDrumDef *def, TbArena *arena, TbArena *scratch,
                                 const TbAirOrder *air, double limit, TbHeadOrder *order,
                                 TbHeadMode *modes, uint32_t room) {
  Enclosed e = {.def = def, .drum = coupled_of(def), .air = air};
  e.azimuth = air->m ? PI : 2.0 * PI;
  const double top_zero = CAVITY_BASIS * air->zeros[air->count - 1];
  if (!tb_cavity_order_prepare(&e.cavity, scratch, &e.drum.cavity, air->m, top_zero,
                               highest_coordinate(&e.drum, limit)) ||
      (def->air.density > 0.0 && !tb_cavity_mics_prepare(&e.inside, scratch, def, &e.cavity))) {
    return TABOR_ERROR_MEMORY;
  }
  const uint32_t size = tb_cavity_eigen_size(&e.cavity, &e.drum, air);
  double *eigenvalues = tb_arena_doubles(scratch, size);
  double *vectors = tb_arena_doubles(scratch, (size_t)size * size);
  if (scratch->failed) return TABOR_ERROR_MEMORY;
  const TaborStatus status =
    tb_cavity_eigen_solve(&e.drum, scratch, air, &e.cavity, eigenvalues, vectors);
  if (status != TABOR_OK) return status;
  uint32_t below = 0;
  while (below < size && eigenvalues[below] <= limit * limit) below++;
  for (uint32_t h = 0; h < e.drum.cavity.heads; h++) {
    order->vectors[h] = tb_arena_doubles(arena, (size_t)below * air->count);
  }
  if (arena->failed) return TABOR_ERROR_MEMORY;
  return keep_modes(&e, arena, eigenvalues, vectors, limit, order, modes, room);
}
