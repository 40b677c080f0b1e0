/* SPDX-License-Identifier: MIT */
#include "kit/kit_place.h"

#include <math.h>
#include <string.h>

#include "definition/definition.h"
#include "definition/error.h"
#include "kit/kit_def.h"
#include "math/portable_math.h"

TbPoint tb_kit_drum_place(const TaborKitDrumDef *drum) {
  return (TbPoint){drum->x, drum->y, drum->height};
}

double tb_kit_distance(TbPoint a, TbPoint b) {
  return tb_hypot(tb_hypot(a.x - b.x, a.y - b.y), a.z - b.z);
}

TbPoint tb_kit_overhead(const TaborKitDef *def, int side) {
  const double aside = 0.5 * def->overhead_spacing * (side == 0 ? -1.0 : 1.0);
  return (TbPoint){def->overhead_x + aside, def->overhead_y, def->overhead_height};
}

/* A direction of the kit's frame in the drum's own: Rodrigues' rotation by -tilt about the axis k =
 * (-sin f, cos f, 0), across which the batter head, at first looking up, tilts towards f = facing.
 */
static TbPoint to_drum(const TaborKitDrumDef *drum, TbPoint v) {
  double sine, cosine, along, across;
  tb_sin_cos_degrees(drum->tilt, &sine, &cosine);
  tb_sin_cos_degrees(drum->facing, &across, &along);
  const double kx = -across, ky = along;
  const double dot = kx * v.x + ky * v.y;
  const TbPoint cross = {ky * v.z, -kx * v.z, kx * v.y - ky * v.x};
  return (TbPoint){v.x * cosine - cross.x * sine + kx * dot * (1.0 - cosine),
                   v.y * cosine - cross.y * sine + ky * dot * (1.0 - cosine),
                   v.z * cosine - cross.z * sine};
}

/* ---- microphones ----------------------------------------------------------------------------- */

static bool is_kits(const char *name) {
  static const char *const NAMES[] = {TABOR_KIT_LEFT, TABOR_KIT_RIGHT, TABOR_KIT_AIR, "far"};
  for (size_t i = 0; i < sizeof NAMES / sizeof *NAMES; i++) {
    if (strcmp(name, NAMES[i]) == 0) return true;
  }
  return false;
}

static void keep_own(TaborDrumDef *placed) {
  uint32_t kept = 0;
  for (uint32_t i = 0; i < placed->mic_count; i++) {
    if (!is_kits(placed->mic[i].name)) placed->mic[kept++] = placed->mic[i];
  }
  placed->mic_count = kept;
}

/* A microphone at `place`, seen from the drum. Its height keeps off the plane of a head. */
static void add_mic(TaborDrumDef *placed, const char *name, TbPoint place) {
  static const double OFF = 0.01; /* [m], as microphones' heights ask for */
  TaborMicDef *const mic = &placed->mic[placed->mic_count++];
  memset(mic, 0, sizeof *mic);
  memcpy(mic->name, name, strlen(name));
  mic->radius = tb_hypot(place.x, place.y);
  mic->angle = tb_arc_degrees(place.y, place.x);
  mic->height = fabs(place.z) >= OFF ? place.z : (place.z < 0.0 ? -OFF : OFF);
  mic->gain = 1.0;
  const double below = mic->height + placed->shell.depth;
  if (placed->two_headed && fabs(below) < OFF) {
    mic->height = -placed->shell.depth + (below < 0.0 ? -OFF : OFF);
  }
}

/* The direction in which the others stand, of length 1; to the player if there are none. */
static TbPoint towards_others(const TaborKitDef *def, uint32_t drum) {
  const TbPoint here = tb_kit_drum_place(&def->drum[drum]);
  TbPoint sum = {0.0, 0.0, 0.0};
  for (uint32_t i = 0; i < def->drum_count; i++) {
    const TbPoint there = tb_kit_drum_place(&def->drum[i]);
    const double distance = tb_kit_distance(here, there);
    if (i == drum || distance == 0.0) continue;
    sum.x += (there.x - here.x) / distance;
    sum.y += (there.y - here.y) / distance;
    sum.z += (there.z - here.z) / distance;
  }
  const double length = tb_hypot(tb_hypot(sum.x, sum.y), sum.z);
  if (length < 1e-9) return (TbPoint){0.0, -1.0, 0.0};
  return (TbPoint){sum.x / length, sum.y / length, sum.z / length};
}

static void add_overhead(const TaborKitDef *def, uint32_t drum, int side, TaborDrumDef *placed) {
  const TbPoint mic = tb_kit_overhead(def, side), here = tb_kit_drum_place(&def->drum[drum]);
  const TbPoint way = {mic.x - here.x, mic.y - here.y, mic.z - here.z};
  add_mic(placed, side == 0 ? TABOR_KIT_LEFT : TABOR_KIT_RIGHT, to_drum(&def->drum[drum], way));
}

/* "top, bottom" */
static void list_mics(const TaborDrumDef *def, char names[TABOR_TEXT_SIZE]) {
  size_t at = 0;
  names[0] = '\0';
  for (uint32_t i = 0; i < def->mic_count; i++) {
    const size_t length = strlen(def->mic[i].name), gap = i > 0 ? 2 : 0;
    if (at + gap + length >= TABOR_TEXT_SIZE) return;
    memcpy(names + at, ", ", gap);
    memcpy(names + at + gap, def->mic[i].name, length + 1);
    at += gap + length;
  }
}

static TaborStatus check_mics(const TaborKitDrumDef *drum, const TaborDrumDef *placed,
                              TaborError *error) {
  if (placed->mic_count > TABOR_KIT_OWN_MICS) {
    return tb_error_set(error, TABOR_ERROR_FULL, "mic", NULL, 0.0, TABOR_KIT_OWN_MICS,
                        "%s: %u microphones; in a kit a drum has %d of its own at most", drum->name,
                        (unsigned)placed->mic_count, TABOR_KIT_OWN_MICS);
  }
  if (!*drum->mic || tabor_drum_def_find_mic(placed, drum->mic) >= 0) return TABOR_OK;
  char names[TABOR_TEXT_SIZE];
  list_mics(placed, names);
  return tb_error_set(error, TABOR_ERROR_NAME, "mic", drum->mic, NAN, NAN,
                      "%s: it has no microphone '%s'; there are: %s", drum->name, drum->mic, names);
}

static TaborStatus check_overheads(const TaborKitDrumDef *drum, const TaborDrumDef *placed,
                                   TaborError *error) {
  for (uint32_t i = placed->mic_count - 3; i < placed->mic_count; i++) {
    if (!tb_mic_is_inside(placed, &placed->mic[i])) continue;
    return tb_error_set(error, TABOR_ERROR_RANGE, "overhead_height", NULL, NAN, NAN,
                        "%s: the drum stands around an overhead microphone", drum->name);
  }
  return TABOR_OK;
}

TaborStatus tabor_kit_def_place(const TaborKitDef *def, uint32_t index, TaborDrumDef *placed,
                                TaborError *error) {
  TaborStatus status = tb_kit_check_struct(def, error);
  if (status != TABOR_OK) return status;
  if (!placed || index >= def->drum_count || index >= TABOR_KIT_DRUMS) {
    return tb_error_set(error, TABOR_ERROR_ARGUMENT, NULL, NULL, NAN, NAN,
                        "the kit has no drum %u, or there is no place for its definition",
                        (unsigned)index);
  }
  const TaborKitDrumDef *const drum = &def->drum[index];
  TaborDrumDef result = drum->def;
  if (result.mic_count > TABOR_MAX_MICS) result.mic_count = TABOR_MAX_MICS;
  keep_own(&result);
  status = check_mics(drum, &result, error);
  if (status != TABOR_OK) return status;
  const TbPoint others = to_drum(drum, towards_others(def, index));
  const TbPoint away = {TB_KIT_FAR * others.x, TB_KIT_FAR * others.y, TB_KIT_FAR * others.z};
  add_overhead(def, index, 0, &result);
  add_overhead(def, index, 1, &result);
  add_mic(&result, TABOR_KIT_AIR, away);
  memset(&result.room, 0, sizeof result.room);
  result.room.level = 1.0;
  status = check_overheads(drum, &result, error);
  if (status != TABOR_OK) return status;
  *placed = result;
  return tb_error_clear(error);
}
