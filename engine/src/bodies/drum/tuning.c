/* SPDX-License-Identifier: MIT */
#include "bodies/drum/tuning.h"

#include <math.h>

#include "bodies/drum/closed_drum_modes.h"
#include "bodies/drum/head_pitch.h"
#include "bodies/sheet_waves.h"
#include "definition/def_text.h"
#include "definition/definition.h"
#include "definition/error.h"
#include "definition/params.h"

/* Tensions are rounded to this [N/m]: at 100 N/m it is 0.04 cents. */
static const double GRAIN = 0.01;

static TaborHeadDef *head_of(TaborDrumDef *def, TaborHead which) {
  return which == TABOR_HEAD_RESONANT ? &def->resonant : &def->batter;
}

static TaborStatus refuse_computation(TaborStatus status, TaborError *error) {
  return tb_error_set(error, status, NULL, NULL, NAN, NAN, "%s",
                      status == TABOR_ERROR_MEMORY ? "out of memory while tuning a head"
                                                   : "the pitch of a head could not be computed");
}

static TaborStatus refuse_pitch(const TbPitchAir *air, const TaborDrumDef *def, TaborHead which,
                                double pitch, TaborError *error) {
  const TaborParameter *const tension = &tb_param_by_id(TB_PARAM_BATTER + TB_HEAD_TENSION)->info;
  const char *const key = which == TABOR_HEAD_RESONANT ? "resonant.pitch" : "batter.pitch";
  double low, high;
  TaborStatus status = tb_head_pitch(air, def, which, tension->minimum, &low);
  if (status == TABOR_OK) status = tb_head_pitch(air, def, which, tension->maximum, &high);
  if (status != TABOR_OK) return refuse_computation(status, error);
  low = ceil(10 * low) / 10;
  high = floor(10 * high) / 10;
  char value[TB_NUMBER_SIZE];
  tb_number_print(floor(100 * pitch + 0.5) / 100, value);
  return tb_error_set(error, TABOR_ERROR_RANGE, key, value, low, high,
                      "%s = %s is outside %g to %g Hz, the pitches of this head at %g to %g N/m",
                      key, value, low, high, tension->minimum, tension->maximum);
}

static TaborStatus tune_head(const TbPitchAir *air, TaborDrumDef *def, TaborHead which,
                             TaborError *error) {
  const TaborParameter *const range = &tb_param_by_id(TB_PARAM_BATTER + TB_HEAD_TENSION)->info;
  TaborHeadDef *const head = head_of(def, which);
  if (head->pitch == 0) return TABOR_OK;
  double tension;
  const TaborStatus status =
    tb_head_tension(air, def, which, head->pitch, range->minimum, range->maximum, &tension);
  if (status == TABOR_ERROR_RANGE) return refuse_pitch(air, def, which, head->pitch, error);
  if (status != TABOR_OK) return refuse_computation(status, error);
  head->tension = floor(tension / GRAIN + 0.5) / (1 / GRAIN);
  head->pitch = 0;
  return TABOR_OK;
}

TaborStatus tb_tune(TaborDrumDef *def, const TbArena *beside, TaborError *error) {
  const bool two = tb_is_two_headed(def);
  if (def->batter.pitch == 0 && !(two && def->resonant.pitch != 0)) return TABOR_OK;
  TaborDrumDef tuned = *def;
  TbPitchAir air;
  TaborStatus status = TABOR_OK;
  if (!tb_pitch_air_prepare(&air, def, beside)) {
    status = refuse_computation(TABOR_ERROR_MEMORY, error);
  }
  if (status == TABOR_OK) status = tune_head(&air, &tuned, TABOR_HEAD_BATTER, error);
  if (status == TABOR_OK && two) status = tune_head(&air, &tuned, TABOR_HEAD_RESONANT, error);
  tb_pitch_air_release(&air);
  if (status == TABOR_OK) *def = tuned;
  return status;
}

/* The mode (1,1) of a head with the air's mass rho0/K on each side (drum_modes.h). */
static void tune_roughly(const TaborDrumDef *def, TaborHeadDef *head) {
  static const double ZERO = 3.8317059702075125, PI = 3.14159265358979323846; /* of J_1 */
  const TaborParameter *const range = &tb_param_by_id(TB_PARAM_BATTER + TB_HEAD_TENSION)->info;
  if (head->pitch == 0) return;
  const double k = ZERO / def->shell.radius, omega = 2.0 * PI * head->pitch;
  const double mass = head->surface_density + 2.0 * def->air.density / k;
  head->tension = 1.0;
  const double unit = tb_sheet_stiffness(head, k);
  head->tension = 1.0 + (omega * omega * mass - unit) / (k * k);
  head->tension = fmin(range->maximum, fmax(range->minimum, head->tension));
  head->pitch = 0;
}

void tb_tune_roughly(TaborDrumDef *def) {
  tune_roughly(def, &def->batter);
  if (tb_is_two_headed(def)) tune_roughly(def, &def->resonant);
}

/* Without a watch, in the C library's memory. */
static TbArena plain_arena(void) {
  TbArena arena;
  const TaborAllocator allocator = tb_allocator_resolve(&(TaborAllocator){.context = NULL});
  tb_arena_prepare(&arena, &allocator);
  return arena;
}

static bool has_heads(const TaborDrumDef *def) { return def->body.kind == TABOR_BODY_DRUM; }

TaborStatus tabor_drum_def_tune(TaborDrumDef *def, TaborError *error) {
  const TbArena arena = plain_arena();
  TaborStatus status = tabor_drum_def_validate(def, error);
  if (status == TABOR_OK && has_heads(def)) status = tb_tune(def, &arena, error);
  return status == TABOR_OK ? tb_error_clear(error) : status;
}

static TaborStatus check_head(const TaborDrumDef *def, uint32_t head, TaborError *error) {
  const bool has_it =
    head == TABOR_HEAD_BATTER || (head == TABOR_HEAD_RESONANT && tb_is_two_headed(def));
  if (has_it && has_heads(def)) return TABOR_OK;
  return tb_error_set(error, TABOR_ERROR_NAME, NULL, NULL, NAN, NAN, "the drum has no %s",
                      head == TABOR_HEAD_RESONANT ? "resonant head" : "such head");
}

static TaborStatus pitch_at_tension(const TaborDrumDef *def, TaborHead which, double *pitch,
                                    TaborError *error) {
  const TbArena arena = plain_arena();
  const double tension = which == TABOR_HEAD_RESONANT ? def->resonant.tension : def->batter.tension;
  TbPitchAir air;
  TaborStatus status = TABOR_ERROR_MEMORY;
  if (tb_pitch_air_prepare(&air, def, &arena)) {
    status = tb_head_pitch(&air, def, which, tension, pitch);
  }
  tb_pitch_air_release(&air);
  return status == TABOR_OK ? TABOR_OK : refuse_computation(status, error);
}

TaborStatus tabor_drum_def_pitch(const TaborDrumDef *def, uint32_t head, double *pitch,
                                 TaborError *error) {
  if (!pitch) return tb_error_null(error, "place for the pitch");
  TaborStatus status = tabor_drum_def_validate(def, error);
  if (status == TABOR_OK) status = check_head(def, head, error);
  if (status != TABOR_OK) return status;
  const double set = head == TABOR_HEAD_RESONANT ? def->resonant.pitch : def->batter.pitch;
  if (set != 0) {
    *pitch = set;
  } else {
    status = pitch_at_tension(def, (TaborHead)head, pitch, error);
  }
  return status == TABOR_OK ? tb_error_clear(error) : status;
}
