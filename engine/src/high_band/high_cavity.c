/* SPDX-License-Identifier: MIT */
#include "high_band/high_cavity.h"

#include <math.h>

#include "bodies/drum/closed_drum_modes.h"
#include "bodies/sheet_waves.h"
#include "definition/definition.h"
#include "math/bessel.h"
#include "math/portable_math.h"

static const double PI = 3.14159265358979323846;

static const TaborHeadDef *head_of(const TbHighCavity *cavity, uint32_t head) {
  return head ? &cavity->def->resonant : &cavity->def->batter;
}

/* The air, with walls that lose: what goes through the heads is radiated instead. */
static TbCavity air_at(const TbHighCavity *cavity, double omega) {
  TbCavity air = tb_closed_drum_cavity(cavity->def, cavity->functions.m, omega);
  air.head_density[0] = air.head_density[1] = 0.0;
  return air;
}

static uint32_t heads_of(const TbHighCavity *cavity) { return cavity->def->two_headed ? 2 : 1; }

/* ---- the heads' functions -------------------------------------------------------------------- */

static bool prepare_waves(TbHighCavity *cavity, TbArena *arena, uint32_t head) {
  const TbAirOrder *functions = &cavity->functions;
  const TaborHeadDef *film = head_of(cavity, head);
  TbHeadWaves *waves = &cavity->waves[head];
  const double radius = cavity->def->shell.radius;
  const double area = tb_cavity_azimuth(functions->m) * radius * radius;
  double **arrays[] = {&waves->omega, &waves->amplitude, &waves->decay_rate, &waves->taken,
                       &waves->taken_rate};
  for (uint32_t i = 0; i < 5; i++) *arrays[i] = tb_arena_doubles(arena, functions->count);
  if (arena->failed) return false;
  for (uint32_t i = 0; i < functions->count; i++) {
    const double wavenumber = functions->zeros[i] / radius, slope = functions->slopes[i];
    double mass;
    waves->omega[i] = tb_sheet_wave_frequency(film, &cavity->def->air, wavenumber, &mass);
    waves->amplitude[i] = 1.0 / sqrt(mass * area * 0.5 * slope * slope);
    waves->decay_rate[i] =
      tb_sheet_wave_decay_rate(film, radius, functions->m, functions->zeros[i], slope, mass);
  }
  return true;
}

bool tb_high_cavity_prepare(TbHighCavity *cavity, TbArena *arena, const TaborDrumDef *def,
                            const TbAirOrder *functions, const TbCavityOrder *order,
                            const TbCavityMics *inside) {
  *cavity = (TbHighCavity){.def = def, .functions = *functions, .order = order, .inside = inside};
  for (uint32_t h = 0; h < heads_of(cavity); h++) {
    if (!prepare_waves(cavity, arena, h)) return false;
  }
  return true;
}

/* ---- a mode ---------------------------------------------------------------------------------- */

double tb_high_cavity_omega(const TbHighCavity *cavity, uint32_t radial, uint32_t axial) {
  const double across = cavity->order->zeros[radial] / cavity->def->shell.radius;
  const double along = (double)axial * PI / cavity->def->shell.depth;
  return cavity->def->air.sound_speed * tb_hypot(across, along);
}

/* t_i = -tan(theta_i); `distance` = d_i. */
static double share_of(double coupling, double distance) {
  const double whole = fabs(distance) + tb_hypot(distance, 2.0 * coupling);
  if (whole == 0.0) return 0.0;
  return (distance < 0.0 ? 2.0 : -2.0) * coupling / whole;
}

/* K_ci/(W_i q_i) on the lower head. */
static double unit_coupling(const TbHighCavity *cavity, const TbCavity *air, const TbAirMode *mode,
                            double omega) {
  const double area = tb_cavity_azimuth(cavity->order->m) * air->radius * air->radius;
  const double norm = tb_cavity_mode_norm(cavity->order, air, mode->radial, mode->axial);
  return -area * omega * air->sound_speed * sqrt(air->density / norm);
}

/* Sets outward[] to t_i. Returns Sum t_i^2, and adds their part of omega^2 - omega_c^2 to *square.
 */
static double couple(const TbHighCavity *cavity, uint32_t head, double coupling, const double *w,
                     double omega, TbAirMode *mode, double *square) {
  const TbHeadWaves *waves = &cavity->waves[head];
  double sum = 0.0;
  for (uint32_t i = 0; i < cavity->functions.count; i++) {
    const double k = coupling * w[i] * waves->amplitude[i];
    const double gap = waves->omega[i] * waves->omega[i] - omega * omega;
    const double width = 2.0 * omega * (waves->decay_rate[i] + mode->air_rate);
    const double distance = tb_hypot(gap, width), share = share_of(k, copysign(distance, gap));
    mode->outward[head][i] = share;
    if (gap != 0.0) *square += k * share * fabs(gap) / distance;
    sum += share * share;
  }
  return sum;
}

/* From t_i to a_i q_i. */
static void scale_to_unit_mass(const TbHighCavity *cavity, uint32_t head, TbAirMode *mode) {
  const TbHeadWaves *waves = &cavity->waves[head];
  mode->in_head[head] = 0.0;
  for (uint32_t i = 0; i < cavity->functions.count; i++) {
    const double amount = mode->outward[head][i] * mode->in_air;
    mode->outward[head][i] = amount * waves->amplitude[i];
    mode->in_head[head] += amount * amount;
    mode->decay_rate += amount * amount * waves->decay_rate[i];
  }
}

/* A mode that strong coupling would pull below this part of omega_c^2 stays there. */
static const double LEAST_SQUARE = 0.25;

void tb_high_cavity_mode(const TbHighCavity *cavity, TbAirMode *mode) {
  const double omega = tb_high_cavity_omega(cavity, mode->radial, mode->axial);
  const TbCavity air = air_at(cavity, omega);
  double w[TB_CAVITY_OPENINGS], square = omega * omega, whole = 1.0;
  tb_cavity_openings(cavity->order, &cavity->functions, mode->radial, w);
  mode->air_rate = tb_cavity_mode_decay_rate(cavity->order, &air, mode->radial, mode->axial);
  const double lower = unit_coupling(cavity, &air, mode, omega);
  const double upper = mode->axial % 2 ? -lower : lower;
  for (uint32_t h = 0; h < heads_of(cavity); h++) {
    whole += couple(cavity, h, h ? lower : upper, w, omega, mode, &square);
  }
  mode->omega = sqrt(fmax(square, LEAST_SQUARE * omega * omega));
  mode->in_air = 1.0 / sqrt(whole);
  mode->decay_rate = mode->air_rate / whole;
  for (uint32_t h = 0; h < heads_of(cavity); h++) scale_to_unit_mass(cavity, h, mode);
}

void tb_high_cavity_take(TbHighCavity *cavity, const TbAirMode *mode, uint32_t count) {
  for (uint32_t h = 0; h < heads_of(cavity); h++) {
    TbHeadWaves *waves = &cavity->waves[h];
    for (uint32_t i = 0; i < cavity->functions.count; i++) {
      const double amount = mode->outward[h][i] / waves->amplitude[i];
      waves->taken[i] += count * amount * amount;
      waves->taken_rate[i] += count * amount * amount * mode->air_rate;
    }
  }
}

/* On either side. */
enum { NEIGHBOURS = 2 };

double tb_high_cavity_taken(const TbHighCavity *cavity, uint32_t head, uint32_t function,
                            double *air_rate) {
  const uint32_t last = cavity->functions.count - 1u;
  const uint32_t from = function > NEIGHBOURS ? function - NEIGHBOURS : 0;
  const uint32_t to = function + NEIGHBOURS < last ? function + NEIGHBOURS : last;
  double sum = 0.0, lost = 0.0;
  for (uint32_t i = from; i <= to; i++) {
    sum += cavity->waves[head].taken[i];
    lost += cavity->waves[head].taken_rate[i];
  }
  *air_rate = sum > 0.0 ? lost / sum : 0.0;
  return sum / (to - from + 1u);
}

/* ---- what is heard of it --------------------------------------------------------------------- */

/* The microphones outside that face a head. */
typedef struct Listeners {
  uint32_t count, mics[TABOR_MAX_MICS];
  TbAirPoint points[TABOR_MAX_MICS]; /* heights outward */
} Listeners;

static Listeners listeners_of(const TaborDrumDef *def, uint32_t head) {
  Listeners listeners = {.count = 0};
  uint32_t mics[TABOR_MAX_MICS];
  const uint32_t count = tb_mics_outside(def, mics);
  const double radius = def->shell.radius, middle = -0.5 * def->shell.depth;
  for (uint32_t p = 0; p < count; p++) {
    const TaborMicDef *mic = &def->mic[mics[p]];
    if (def->two_headed && (mic->height < middle) != (head == 1)) continue;
    const double height = head ? -(mic->height + def->shell.depth) : mic->height;
    listeners.mics[listeners.count] = mics[p];
    listeners.points[listeners.count++] = (TbAirPoint){mic->radius / radius, height / radius};
  }
  return listeners;
}

static bool radiate_head(const TbHighCavity *cavity, TbArena *scratch, uint32_t head,
                         TbAirMode *mode, double *fields) {
  const TaborDrumDef *def = cavity->def;
  const Listeners listeners = listeners_of(def, head);
  const double radius = def->shell.radius, x = mode->omega * radius / def->air.sound_speed;
  double resistance, heard[2 * TABOR_MAX_MICS];
  if (!tb_air_baffled(&cavity->functions, scratch, false, mode->outward[head], x, listeners.points,
                      listeners.count, &resistance, heard)) {
    return false;
  }
  for (uint32_t p = 0; p < listeners.count; p++) {
    fields[2 * listeners.mics[p]] = heard[2 * p];
    fields[2 * listeners.mics[p] + 1] = heard[2 * p + 1];
  }
  const double area = tb_cavity_azimuth(cavity->order->m) * radius * radius;
  mode->decay_rate += 0.5 * area * def->air.density * def->air.sound_speed * resistance;
  return true;
}

/* R I of the air itself. */
static void hear_inside(const TbHighCavity *cavity, const TbAirMode *mode, double *fields) {
  const TbCavityMics *inside = cavity->inside;
  const TbCavity air = air_at(cavity, mode->omega);
  const double norm = tb_cavity_mode_norm(cavity->order, &air, mode->radial, mode->axial);
  const double omega = tb_high_cavity_omega(cavity, mode->radial, mode->axial);
  const double size = -air.sound_speed / (omega * sqrt(air.density * norm)) * mode->in_air;
  for (uint32_t i = 0; i < inside->count; i++) {
    const double along = tb_cos((double)mode->axial * PI * inside->height[i] / air.depth);
    fields[2 * inside->index[i]] = size / air.radius * inside->shapes[i][mode->radial] * along;
  }
}

bool tb_high_cavity_radiate(const TbHighCavity *cavity, TbArena *scratch, TbAirMode *mode,
                            double *fields) {
  for (uint32_t i = 0; i < 2 * TABOR_MAX_MICS; i++) fields[i] = 0.0;
  for (uint32_t h = 0; h < heads_of(cavity); h++) {
    if (!radiate_head(cavity, scratch, h, mode, fields)) return false;
  }
  hear_inside(cavity, mode, fields);
  return true;
}

void tb_high_cavity_wave(const TbHighCavity *cavity, const TbAirMode *mode, uint32_t head,
                         double *zero, double *amplitude) {
  const TbHeadWaves *waves = &cavity->waves[head];
  const TbAirOrder *functions = &cavity->functions;
  uint32_t i = 0;
  while (i + 1 < functions->count && waves->omega[i + 1] < mode->omega) i++;
  *zero = functions->zeros[i];
  *amplitude = sqrt(mode->in_head[head]) * waves->amplitude[i];
  if (mode->omega < waves->omega[i] || i + 1 == functions->count) return;
  const double along = (mode->omega - waves->omega[i]) / (waves->omega[i + 1] - waves->omega[i]);
  *zero += along * (functions->zeros[i + 1] - functions->zeros[i]);
  /* Int_0^1 J_m(z r)^2 r dr = (J_m'(z)^2 + (1 - m^2/z^2) J_m(z)^2)/2 [DLMF] 10.22.5, at a zero
   * J_{m+1}(z)^2/2 */
  double j[2];
  tb_bessel_pair(functions->m, *zero, j);
  const double order = (double)functions->m / *zero, slope = order * j[0] - j[1];
  const double square = slope * slope + (1.0 - order * order) * j[0] * j[0];
  *amplitude *= fabs(functions->slopes[i]) / sqrt(square);
}
