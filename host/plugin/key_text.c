/* SPDX-License-Identifier: MIT */
#include "plugin/key_text.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "drums/pitch_text.h"

/* A unit that is worth `factor` of the table's. */
typedef struct Unit {
  const char *name, *of;
  double factor;
} Unit;

static const Unit UNITS[] = {{"mm", "m", 1e-3},  {"g", "kg", 1e-3}, {"m", "m", 1},
                             {"kg", "kg", 1},    {"cm", "m", 1e-2}, {"in", "m", 0.0254},
                             {"\"", "m", 0.0254}};
static const char BY_TENSION[] = "by tension"; /* a pitch of 0 */
enum { UNIT_COUNT = sizeof UNITS / sizeof *UNITS, SMALL_UNITS = 2 };

static bool is_pitch(const TaborParameter *parameter) {
  return strcmp(parameter->key, "pitch") == 0;
}

/* The small unit in which a number is shown, or NULL. */
static const Unit *small_unit(const TaborParameter *parameter, double number) {
  if (fabs(number) >= 1 || number == 0) return NULL;
  for (int i = 0; i < SMALL_UNITS; i++)
    if (strcmp(UNITS[i].of, parameter->unit) == 0) return &UNITS[i];
  return NULL;
}

int key_text(const TaborParameter *parameter, const char *value, char *text, size_t size) {
  char *end = NULL;
  const double number = strtod(value, &end);
  const bool is_number = parameter->type == TABOR_TYPE_NUMBER && end != value && *end == '\0';
  if (!is_number) return snprintf(text, size, "%s", value);
  if (is_pitch(parameter) && number == 0) return snprintf(text, size, "%s", BY_TENSION);
  if (is_pitch(parameter)) return pitch_text(number, text, size);
  const Unit *const unit = small_unit(parameter, number);
  if (unit) return snprintf(text, size, "%.6g %s", number / unit->factor, unit->name);
  return snprintf(text, size, "%.6g%s%s", number, *parameter->unit ? " " : "", parameter->unit);
}

/* Of the unit that is typed; NULL: the parameter cannot have it. */
static const Unit *find_unit(const TaborParameter *parameter, const char *name) {
  for (int i = 0; i < UNIT_COUNT; i++)
    if (strcmp(UNITS[i].name, name) == 0 && strcmp(UNITS[i].of, parameter->unit) == 0)
      return &UNITS[i];
  return NULL;
}

/* To 12 digits, so that 139.7 mm is 0.1397. */
static bool write_number(double number, char *text, size_t size) {
  (void)snprintf(text, size, "%.12g", number);
  return true;
}

bool key_text_read(const TaborParameter *parameter, const char *value, const char *typed,
                   char *text, size_t size) {
  char *end = NULL;
  double number = strtod(typed, &end), frequency;
  (void)snprintf(text, size, "%s", typed);
  if (parameter->type != TABOR_TYPE_NUMBER) return true;
  if (is_pitch(parameter) && strcmp(typed, BY_TENSION) == 0) return write_number(0, text, size);
  if (is_pitch(parameter) && pitch_read(typed, &frequency))
    return write_number(frequency, text, size);
  if (end == typed) return true;
  end += strspn(end, " ");
  if (*end != '\0' && strcmp(end, parameter->unit) == 0) return write_number(number, text, size);
  const Unit *const unit =
    *end == '\0' ? small_unit(parameter, strtod(value, NULL)) : find_unit(parameter, end);
  if (*end != '\0' && !unit) return false;
  return write_number(unit ? number * unit->factor : number, text, size);
}
