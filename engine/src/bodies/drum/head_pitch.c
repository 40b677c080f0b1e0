/* SPDX-License-Identifier: MIT */
#include "bodies/drum/head_pitch.h"

#include <math.h>

#include "bodies/drum/closed_drum_modes.h"
#include "bodies/drum/single_head.h"
#include "math/bessel.h"

static const double PI = 3.14159265358979323846;

/* A pitch this near to the wanted one, relatively, ends the search: 0.002 cents. */
static const double NEAR = 1e-6;
/* So does a bracket this narrow, relatively. */
static const double NARROW = 1e-9;

static bool meets_shell(const TaborDrumDef *def) {
  return tb_has_cavity(def) && def->air.density > 0.0;
}

bool tb_pitch_air_prepare(TbPitchAir *air, const TaborDrumDef *def, const TbArena *beside) {
  const uint32_t count = tb_bessel_zeros(1, TB_PITCH_TOP, air->zeros, TB_PITCH_ZEROS);
  tb_arena_beside(&air->arena, beside);
  return tb_air_order_prepare(&air->order, &air->arena, 1, air->zeros, count) &&
         (!meets_shell(def) || tb_shell_prepare(&air->shell, &air->arena,
                                                def->shell.depth / def->shell.radius, NULL, 0));
}

void tb_pitch_air_release(TbPitchAir *air) { tb_arena_release(&air->arena); }

/* The head alone: what was the other head is a rigid bottom. */
static TaborDrumDef held_drum(const TaborDrumDef *def, TaborHead which, double tension) {
  TaborDrumDef held = *def;
  if (which == TABOR_HEAD_RESONANT) held.batter = def->resonant; /* upside down */
  held.batter.tension = tension;
  if (tb_is_two_headed(def)) held.shell.boundary = TABOR_BOUNDARY_CLOSED;
  held.two_headed = 0;
  held.mic_count = 0;
  return held;
}

double tb_head_pitch_size(const TaborDrumDef *def, TaborHead which, double tension) {
  const TaborDrumDef held = held_drum(def, which, tension);
  return tb_closed_drum_order_size(&held, 1.0, TB_PITCH_TOP, INFINITY);
}

TaborStatus tb_head_pitch(const TbPitchAir *air, const TaborDrumDef *def, TaborHead which,
                          double tension, double *pitch) {
  const TaborDrumDef held = held_drum(def, which, tension);
  const TbShellMesh *const shell = meets_shell(def) ? &air->shell : NULL;
  const TbRim rim = {.count = 0}; /* at rest: the lowest mode on a stand is the drum that rocks */
  const TbModeLimits limit = {INFINITY, INFINITY};
  TbBodyOrder order = {.m = air->order.m};
  TbBodyMode mode;
  TbArena scratch;
  tb_arena_beside(&scratch, &air->arena);
  const TaborStatus status =
    tb_has_cavity(&held)
      ? tb_closed_drum_order(&held, &scratch, &scratch, &air->order, &rim, shell, limit, &order,
                             &mode, 1)
      : tb_single_head_order(&held, &scratch, &scratch, &air->order, &rim, limit, &order, &mode, 1);
  tb_arena_release(&scratch);
  if (status != TABOR_OK) return status;
  if (order.mode_count == 0) return TABOR_ERROR_NUMERICS;
  *pitch = mode.omega / (2.0 * PI);
  return TABOR_OK;
}

/* A tension and the square of its pitch. */
typedef struct Trial {
  double tension, square;
} Trial;

/* The tension at which the line through two trials has the wanted square. */
static double secant(Trial a, Trial b, double wanted) {
  return b.tension + (wanted - b.square) * (b.tension - a.tension) / (b.square - a.square);
}

TaborStatus tb_head_tension(const TbPitchAir *air, const TaborDrumDef *def, TaborHead which,
                            double pitch, double least, double most, double *tension) {
  const double wanted = pitch * pitch;
  double low = least, high = most;
  bool low_is_tried = false, high_is_tried = false;
  Trial before = {0.0, 0.0}; /* without tension a thin head has no pitch */
  double next = sqrt(least * most);
  while (high / low - 1.0 > NARROW) {
    double reached;
    const TaborStatus status = tb_head_pitch(air, def, which, next, &reached);
    if (status != TABOR_OK) return status;
    const Trial now = {next, reached * reached};
    *tension = next;
    if (fabs(reached / pitch - 1.0) < NEAR) return TABOR_OK;
    if (now.square < wanted) {
      if (next == most) return TABOR_ERROR_RANGE;
      low = next;
      low_is_tried = true;
    } else {
      if (next == least) return TABOR_ERROR_RANGE;
      high = next;
      high_is_tried = true;
    }
    next = secant(before, now, wanted);
    if (!(next > low)) next = low_is_tried ? sqrt(low * high) : least;
    if (!(next < high)) next = high_is_tried ? sqrt(low * high) : most;
    before = now;
  }
  return TABOR_OK;
}
