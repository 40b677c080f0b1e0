/* SPDX-License-Identifier: MIT */
#include "model/build_estimate.h"

#include <math.h>
#include <string.h>

#include "bodies/drum/closed_drum_modes.h"
#include "bodies/sheet_waves.h"
#include "definition/definition.h"
#include "math/portable_math.h"
#include "model/body_kind.h"
#include "model/quality_level.h"
#include "model/rims.h"

static const double PI = 3.14159265358979323846;

/* ---- sizes ---------------------------------------------------------------------------------- */

typedef struct Sizes {
  double modes;          /* sine copies counted */
  double classes;        /* of symmetry: 1, 2 or 4 */
  double wires, points;  /* of contact: `points` of all wires together */
  double half;           /* points of a wire that are not images of others */
  double lines;          /* across, of all classes */
  double used;           /* points of the grid of one class */
  double waves;          /* one-way Bessel functions that the wires feel */
  double top_zero;       /* of the one-way band */
  double top_wavenumber; /* of sound at its top [1/m] */
} Sizes;

static double wave_zero(const TaborDrumDef *def, const TaborHeadDef *sheet, double frequency) {
  return tb_body_wave_zero(sheet, &def->air, def->shell.radius, frequency);
}

static double largest_row(const TbWires *wires, const double *place) {
  double most = 0.0;
  for (uint32_t row = 0; row < wires->stride; row++) {
    if (wires->real[row] != 0.0) most = fmax(most, fabs(place[row]));
  }
  return most;
}

/* Shapes that a tolerance tells apart, beyond the half waves of the finest mode. */
static const double MARGIN = 4.0;

/* k: wavenumber of the finest mode [1/m]; `exact`: nothing is thinned. */
static void grid_sizes(const TbWires *wires, double k, bool exact, Sizes *s) {
  const double along = wires->mirrored ? 2.0 : 1.0, across = wires->balanced ? 2.0 : 1.0;
  const double along_most = 2.0 * largest_row(wires, wires->row_x) * k / PI + 2.0 * MARGIN;
  const double across_most = 2.0 * largest_row(wires, wires->row_y) * k / PI + 2.0 * MARGIN;
  const bool thinned = wires->aligned && !exact;
  s->classes = along * across;
  s->wires = wires->count;
  s->points = wires->stride;
  s->half = wires->lanes / along;
  s->lines = thinned ? fmin(wires->count, across_most) : wires->count;
  s->used = s->lines / across * (thinned ? fmin(s->half, along_most / along) : s->half);
}

static TaborStatus measure(const TaborDrumDef *asked, uint32_t quality, double sample_rate,
                           const TaborAllocator *allocator, Sizes *s, TbBodyCost *body,
                           TaborError *error) {
  TaborDrumDef resolved = *asked;
  const TaborDrumDef *const def = &resolved;
  tb_body_kind(asked)->resolve_roughly(&resolved);
  const TbLevel level = tb_level(def, quality, sample_rate);
  const double step_rate = tb_level_steps(quality, sample_rate) * sample_rate;
  const TbBodyLimits limits =
    tb_level_limits(quality, def->wires.count * level.wire_cells, step_rate);
  const TbBodyKind *const kind = tb_body_kind(def);
  TaborHeadDef sheet[TB_HEADS];
  TbArena scratch;
  TbWires wires;
  double bandwidth;
  tb_arena_prepare(&scratch, allocator);
  const double basis_top = kind->basis(def, level.bandwidth, limits, &bandwidth);
  kind->sheets(def, sheet);
  const TaborStatus status =
    tb_rims_or_wires_prepare(&wires, &scratch, def, 1.0 / step_rate, level.wire_cells, error);
  *body = kind->cost(asked, def, basis_top, bandwidth, limits.modes);
  *s = (Sizes){.modes = body->modes, .classes = 1.0};
  s->top_zero = wave_zero(def, &sheet[0], level.top);
  s->top_wavenumber = 2.0 * PI * level.top / def->air.sound_speed;
  if (status == TABOR_OK && wires.count > 0) {
    const TaborHeadDef *under = &sheet[wires.head];
    const double from = wave_zero(def, under, bandwidth), to = wave_zero(def, under, level.top);
    const double k = tb_sheet_wave_number(under, &def->air, 2.0 * PI * bandwidth);
    const bool exact = level.grid_tolerance == 0.0 && s->modes <= TB_FEW_MODES;
    grid_sizes(&wires, k, exact, s);
    s->waves = fmax(0.0, 0.25 * (to * to - from * from));
  }
  tb_arena_release(&scratch);
  return status;
}

/* ---- time and memory ------------------------------------------------------------------------ */

/* Shapes of modes and their principal components; twice if one-way modes stand beside them. */
static double grid_seconds(const Sizes *s) {
  const double passes = s->waves > 0.0 ? 2.0 : 1.0;
  const double shapes =
    s->modes * s->half * (s->wires * s->wires + s->lines * s->half + 3.0 * s->used);
  const double square = s->used * s->used;
  return passes * 2.4e-9 * shapes + 6e-10 * s->waves * square +
         (s->waves > 0.0 ? 3e-9 * s->classes * square * s->used : 0.0);
}

/* Compliances, contact laws, and the wires at rest. */
static double contact_seconds(const Sizes *s) {
  const double square = s->used * s->used, cells = s->wires > 0.0 ? s->points / s->wires : 0.0;
  return 1.6e-10 * square * s->modes + 6e-10 * s->points * s->classes * square +
         2e-9 * s->wires * cells * cells * cells;
}

/* Microphones, and the one-way modes that they hear. An open head's fields are integrals over the
 * wavenumber, the longer the farther away the microphone is. */
static double high_band_seconds(const TaborDrumDef *def, const Sizes *s) {
  const double each = 2e-5 * s->modes, zero = s->top_zero;
  if (def->air.density == 0.0) return (tb_is_two_headed(def) ? 0.5 : 0.15) * each;
  if (tb_is_two_headed(def)) return 0.025 + 2.0 * each + 1.4e-6 * zero * zero;
  if (tb_has_cavity(def)) return each + 6e-7 * zero * zero;
  double far = 0.0;
  for (uint32_t i = 0; i < def->mic_count; i++) {
    far = fmax(far, tb_hypot(def->mic[i].radius, def->mic[i].height));
  }
  const double baffle = def->shell.boundary == TABOR_BOUNDARY_BAFFLED ? 1.5 : 1.0;
  return baffle * zero *
         (1.2e-6 * zero + s->top_wavenumber * (2e-6 * def->shell.radius + 8e-9 * far));
}

double tb_build_seconds(const TbBuildCost *cost) {
  return cost->tuning + cost->heads + cost->grid + cost->contacts + cost->high_band;
}

TaborStatus tb_build_cost(const TaborDrumDef *def, uint32_t quality, double sample_rate,
                          const TaborAllocator *allocator, TbBuildCost *cost, TaborError *error) {
  Sizes s;
  TbBodyCost body;
  const TaborStatus status = measure(def, quality, sample_rate, allocator, &s, &body, error);
  const double cells = s.wires > 0.0 ? s.points / s.wires : 0.0;
  *cost = (TbBuildCost){
    .tuning = body.resolve,
    .heads = body.prepare,
    .grid = grid_seconds(&s),
    .contacts = contact_seconds(&s),
    .high_band = high_band_seconds(def, &s),
    /* Tables between modes and points in both precisions; shapes at all points, four times; squares
     * of classes; each wire's answers */
    .bytes = 4e6 + 2e3 * s.modes + 24.0 * s.modes * s.used + 32.0 * s.modes * s.wires * s.half +
             64.0 * s.classes * s.used * s.used + 24.0 * s.wires * cells * cells};
  return status;
}

/* ---- the parameter to lower ----------------------------------------------------------------- */

typedef struct Lever {
  const char *key;
  void (*halve)(TaborDrumDef *def, const TbLevel *level);
} Lever;

static void halve_points(TaborDrumDef *def, const TbLevel *level) {
  def->quality.wire_points = level->wire_cells / 2u > 8u ? level->wire_cells / 2u : 8u;
}
static void halve_wires(TaborDrumDef *def, const TbLevel *level) {
  (void)level;
  def->wires.count = (def->wires.count + 1u) / 2u;
}
static void halve_two_way(TaborDrumDef *def, const TbLevel *level) {
  def->quality.two_way_bandwidth = 0.5 * level->bandwidth;
}
static void halve_bandwidth(TaborDrumDef *def, const TbLevel *level) {
  def->quality.bandwidth = 0.5 * level->top;
}

static const Lever LEVERS[] = {{"quality.wire_points", halve_points},
                               {"wires.count", halve_wires},
                               {"quality.two_way_bandwidth", halve_two_way},
                               {"quality.bandwidth", halve_bandwidth}};

/* The key of the lever that saves most of so many seconds; of the quality if none saves a twentieth
 * of them. */
static const char *find_lever(const TaborDrumDef *def, uint32_t quality, double sample_rate,
                              const TaborAllocator *allocator, double seconds) {
  const TbLevel level = tb_level(def, quality, sample_rate);
  const char *key = "quality.level";
  double least = seconds;
  for (size_t i = 0; i < sizeof LEVERS / sizeof *LEVERS; i++) {
    TaborDrumDef lower = *def;
    TbBuildCost cost;
    LEVERS[i].halve(&lower, &level);
    if (tb_build_cost(&lower, quality, sample_rate, allocator, &cost, NULL) != TABOR_OK) continue;
    if (tb_build_seconds(&cost) >= 0.95 * least) continue; /* of equals the first */
    least = tb_build_seconds(&cost);
    key = LEVERS[i].key;
  }
  return key;
}

TaborStatus tb_build_estimate(const TaborDrumDef *def, uint32_t quality, double sample_rate,
                              const TaborAllocator *allocator, TaborModelEstimate *estimate,
                              TaborError *error) {
  TbBuildCost cost;
  const TaborStatus status = tb_build_cost(def, quality, sample_rate, allocator, &cost, error);
  *estimate = (TaborModelEstimate){.seconds = tb_build_seconds(&cost), .bytes = (size_t)cost.bytes};
  if (status == TABOR_OK) {
    const char *key = find_lever(def, quality, sample_rate, allocator, estimate->seconds);
    memcpy(estimate->key, key, strlen(key) + 1u);
  }
  return status;
}
