/* SPDX-License-Identifier: MIT */
#include "high_band/high_air_choice.h"

#include <math.h>
#include <string.h>

#include "bodies/drum/closed_drum_modes.h"

void tb_high_air_plan(TbHighAirPlan *plan, const TaborDrumDef *def, double from, double to) {
  *plan = (TbHighAirPlan){.from = from, .to = to};
  for (uint32_t sixth = 0; sixth < TB_SIXTHS; sixth++) {
    const double modes = 0.5 * (tb_closed_drum_air_modes(def, tb_sixth_from(sixth + 1)) -
                                tb_closed_drum_air_modes(def, tb_sixth_from(sixth)));
    plan->met_every[sixth] = (uint32_t)fmax(1.0, floor(modes / TB_AIR_MET));
    plan->kept_every[sixth] = fmax(1.0, modes / plan->met_every[sixth] / TB_AIR_KEPT);
  }
}

/* The largest shift of a mode by the coupling of air and heads, across the lower border. */
static const double NEAR_BORDER = 0.8;

/* Lists the modes to look at. Returns their number; `list` may be NULL. */
static uint32_t list_modes(const TbHighAirPlan *plan, const TbHighCavity *cavity, uint32_t *met,
                           TbAirChoice *list) {
  uint32_t count = 0;
  for (uint32_t p = 0; p < cavity->order->radial_count; p++) {
    double omega;
    for (uint32_t l = 0; (omega = tb_high_cavity_omega(cavity, p, l)) < plan->to; l++) {
      if (omega < NEAR_BORDER * plan->from) continue;
      const uint32_t sixth = tb_sixth_of(omega);
      if (met[sixth]++ % plan->met_every[sixth] != 0) continue;
      if (list) list[count] = (TbAirChoice){.radial = p, .axial = l, .sixth = sixth};
      count++;
    }
  }
  return count;
}

/* The part of each mode that strokes find; the modes take their part of the heads. */
static void look_at(const TbHighAirPlan *plan, TbHighCavity *cavity, TbAirMode *mode,
                    const TbAirChoices *all) {
  for (uint32_t i = 0; i < all->count; i++) {
    TbAirChoice *choice = &all->choices[i];
    mode->radial = choice->radial;
    mode->axial = choice->axial;
    tb_high_cavity_mode(cavity, mode);
    tb_high_cavity_take(cavity, mode, plan->met_every[choice->sixth]);
    choice->in_head = mode->in_head[TABOR_HEAD_BATTER];
  }
}

/* Keeps some, in place. */
static void keep_some(TbHighAirPlan *plan, TbAirChoices *all) {
  double sum[TB_SIXTHS] = {0.0}, modes[TB_SIXTHS] = {0.0};
  for (uint32_t i = 0; i < all->count; i++) {
    sum[all->choices[i].sixth] += all->choices[i].in_head;
    modes[all->choices[i].sixth] += 1.0;
  }
  uint32_t kept = 0;
  for (uint32_t i = 0; i < all->count; i++) {
    TbAirChoice choice = all->choices[i];
    const uint32_t sixth = choice.sixth;
    if (!(choice.in_head > 0.0)) continue;
    const double mean = sum[sixth] / modes[sixth];
    const double part = fmin(1.0, choice.in_head / (mean * plan->kept_every[sixth]));
    plan->due[sixth] += part;
    if (plan->due[sixth] < 1.0) continue;
    plan->due[sixth] -= 1.0;
    choice.count = plan->met_every[sixth] / part;
    all->choices[kept++] = choice;
  }
  all->count = kept;
}

bool tb_air_choose(TbHighAirPlan *plan, TbArena *arena, TbHighCavity *cavity, TbAirMode *mode,
                   TbAirChoices *chosen) {
  uint32_t met[TB_SIXTHS];
  memcpy(met, plan->met, sizeof met);
  chosen->count = list_modes(plan, cavity, met, NULL);
  chosen->choices = tb_arena_take(arena, chosen->count, sizeof *chosen->choices);
  if (arena->failed) return false;
  list_modes(plan, cavity, plan->met, chosen->choices);
  look_at(plan, cavity, mode, chosen);
  keep_some(plan, chosen);
  return true;
}
