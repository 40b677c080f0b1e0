/* SPDX-License-Identifier: MIT */
#include "bodies/drum/drum_modes.h"

#include <math.h>

#include "bodies/drum/closed_drum_modes.h"
#include "bodies/drum/drum_cost.h"
#include "bodies/drum/single_head.h"
#include "bodies/drum/tuning.h"
#include "bodies/sheet_waves.h"

static const double PI = 3.14159265358979323846;

/* Estimate with the air's mass rho0/K on each side: enough to choose the basis. */
static double frequency_at(const TaborDrumDef *def, const TaborHeadDef *head, double zero) {
  const double wavenumber = zero / def->shell.radius;
  const double mass = head->surface_density + 2.0 * def->air.density / wavenumber;
  return sqrt(tb_sheet_stiffness(head, wavenumber) / mass) / (2.0 * PI);
}

static double zero_at_frequency(const TaborDrumDef *def, const TaborHeadDef *head, double frequency,
                                double top) {
  double lo = 0.5, hi = top;
  if (frequency_at(def, head, hi) <= frequency) return hi;
  for (int i = 0; i < 60; i++) {
    const double middle = 0.5 * (lo + hi);
    if (frequency_at(def, head, middle) < frequency) {
      lo = middle;
    } else {
      hi = middle;
    }
  }
  return hi;
}

double tb_drum_basis(const TaborDrumDef *def, double bandwidth, TbBodyLimits limits,
                     double *reached) {
  const uint32_t count = tb_is_two_headed(def) ? 2 : 1;
  const TaborHeadDef *const heads[TB_HEADS] = {&def->batter, &def->resonant};
  double top = 0.0;
  *reached = bandwidth;
  for (uint32_t h = 0; h < count; h++) {
    const double own = zero_at_frequency(def, heads[h], 1.03 * bandwidth, limits.zero);
    top = fmax(top, own);
    *reached = fmin(*reached, frequency_at(def, heads[h], own));
  }
  if (count == 2) *reached = tb_closed_drum_bandwidth(def, *reached, limits.modes);
  return top + (def->air.density > 0.0 ? 2.0 * PI : 0.0);
}

/* Data that the orders of a drum share. */
typedef struct Shared {
  const TaborDrumDef *def;
  const TbShellMesh *shell; /* NULL: no air outside a shell */
  TbModeLimits limit;
} Shared;

static TaborStatus build_order(const void *context, TbArena *arena, TbArena *scratch,
                               const TbAirOrder *air, TbBodyOrder *order, TbBodyMode *modes,
                               uint32_t room) {
  const Shared *s = context;
  TbRim rim;
  tb_rim_prepare(&rim, s->def, order->m);
  if (!tb_has_cavity(s->def)) {
    return tb_single_head_order(s->def, arena, scratch, air, &rim, s->limit, order, modes, room);
  }
  return tb_closed_drum_order(s->def, arena, scratch, air, &rim, s->shell, s->limit, order, modes,
                              room);
}

static void sheets(const TaborDrumDef *def, TaborHeadDef sheet[TB_HEADS]) {
  sheet[0] = def->batter;
  sheet[1] = def->resonant;
}

static TaborStatus prepare(TbBody *body, TbArena *arena, const TaborDrumDef *def, double bandwidth,
                           TbBodyLimits limits) {
  *body = (TbBody){.surfaces = tb_is_two_headed(def) ? 2 : 1,
                   .most_modes = limits.modes,
                   .radius = def->shell.radius};
  sheets(def, body->sheet);
  const double basis_top = tb_drum_basis(def, bandwidth, limits, &body->bandwidth);
  const bool outside = tb_has_cavity(def) && def->air.density > 0.0;
  TbArena scratch;
  TbShellMesh shell;
  Shared shared = {
    .def = def,
    .shell = outside ? &shell : NULL,
    .limit = {2.0 * PI * body->bandwidth, 2.0 * PI * fmax(body->bandwidth, limits.rim)}};
  tb_arena_beside(&scratch, arena);
  TaborStatus status = TABOR_ERROR_MEMORY;
  if (!outside || tb_closed_drum_shell(def, &scratch, &shell)) {
    status =
      tb_body_build_orders(body, arena, basis_top, (uint32_t)basis_top + 1u, build_order, &shared);
  }
  tb_arena_release(&scratch);
  return status;
}

const TbBodyKind tb_body_drum = {.resolve = tb_tune,
                                 .resolve_roughly = tb_tune_roughly,
                                 .sheets = sheets,
                                 .cost = tb_drum_cost,
                                 .basis = tb_drum_basis,
                                 .prepare = prepare};
